//! A bounding volume hierarchy over a mesh's triangles, which only ever rejects.
//!
//! Nodes of eight boxes and leaves of eight triangles, so that one instruction handles eight numbers (Wald, Benthin
//! & Boulos, "Getting rid of packets", RT 2008; Embree's layout). Boxes and triangles are judged in `f32`, each with
//! a derived bound ([`ray`]) on what rounding may have done: what is rejected is missed for certain. What remains
//! goes to the caller, who decides in `f64`; so whichever instructions there are, the answer is the same to the bit.

#![allow(
    clippy::inline_always,
    reason = "what is not inlined into the walk is not compiled for its instructions"
)]

mod build;
mod node;
mod ray;
mod simd;
mod split;
mod validate;
mod walk;

pub use node::Candidate;
pub use simd::Simd;

use super::{Aabb, Ray};
use glam::DVec3;
use node::{Line, Node, Packet, Place};
use ray::Frame;
use std::sync::atomic::AtomicBool;
use walk::Walk;

/// A tree over triangles, in the vertices' own space.
#[derive(Debug)]
pub struct Bvh {
    /// Nodes and packets; the first is the root, and each comes before its children.
    lines: Vec<Line>,
    frame: Frame,
}

impl Bvh {
    /// Builds the tree over `triangles`, index triples into `positions`, on all processors. All coordinates must be
    /// finite.
    ///
    /// `None` when `stop` was set meanwhile, and for meshes that a tree cannot hold: without triangles, with more than
    /// `2^30` of them, or with coordinates that differ by so many orders of magnitude that scaling would change them.
    #[must_use]
    pub fn build(
        positions: &[[f32; 3]],
        triangles: &[[u32; 3]],
        stop: &AtomicBool,
    ) -> Option<Self> {
        build::build(positions, triangles, stop)
    }

    /// Calls `visit` with every triangle that `ray`, of a space in which the vertices are about `center`, may hit, nearer
    /// boxes first. `visit` returns the new end of the ray's interval; what begins beyond it is
    /// passed over, what begins *at* it is not, so that equal hits are all seen.
    ///
    /// Which triangles are visited beyond those that are hit may differ between processors.
    #[inline]
    pub fn visit(&self, ray: &Ray, center: &DVec3, visit: &mut impl FnMut(Candidate) -> f64) {
        simd::run_fastest(Walk::<_, true> {
            tree: self,
            ray,
            center,
            visit,
        });
    }

    /// [`Bvh::visit`] by chosen instructions.
    #[inline]
    pub fn visit_by(
        &self,
        simd: Simd,
        ray: &Ray,
        center: &DVec3,
        visit: &mut impl FnMut(Candidate) -> f64,
    ) {
        simd.run(Walk::<_, true> {
            tree: self,
            ray,
            center,
            visit,
        });
    }

    /// [`Bvh::visit`] that rejects by boxes alone. For triangle tests that are under study: theirs may hit a triangle
    /// that the ray misses.
    #[inline]
    pub fn visit_boxes(&self, ray: &Ray, center: &DVec3, visit: &mut impl FnMut(Candidate) -> f64) {
        simd::run_fastest(Walk::<_, false> {
            tree: self,
            ray,
            center,
            visit,
        });
    }

    /// Bytes that it takes.
    #[must_use]
    pub fn bytes(&self) -> usize {
        size_of_val(&*self.lines)
    }

    /// The boxes so many steps below the root, and leaves' that are nearer to it: at most `most` of them.
    #[must_use]
    pub fn boxes(&self, level: u32, most: usize) -> Vec<Aabb> {
        // Each with what is in it.
        let mut open = vec![(Place::ROOT, self.frame.bounds)];
        for _ in 0..level {
            let below = open
                .into_iter()
                .flat_map(|(place, bounds)| self.below(place, bounds));
            open = below.take(most).collect();
        }
        let unscale = 1.0 / self.frame.scale;
        let boxes = open.into_iter().map(|(_, Aabb { min, max })| Aabb {
            min: unscale * min,
            max: unscale * max,
        });
        boxes.take(most).collect()
    }

    /// The children of a node with their boxes, or the packet itself.
    fn below(&self, place: Place, bounds: Aabb) -> Vec<(Place, Aabb)> {
        if place.is_packet() {
            return vec![(place, bounds)];
        }
        let node = Node::at(&self.lines, place);
        let children = node.children().map(|(lane, child)| {
            let [min, max] = node
                .bounds(lane)
                .map(|corner| DVec3::from(corner.map(f64::from)));
            (place.of(child), Aabb { min, max })
        });
        children.collect()
    }

    /// All packets with their places.
    fn packets(&self) -> impl Iterator<Item = (Place, &Packet)> {
        let mut open = vec![Place::ROOT];
        std::iter::from_fn(move || {
            loop {
                let place = open.pop()?;
                if place.is_packet() {
                    return Some((place, Packet::at(&self.lines, place)));
                }
                let node = Node::at(&self.lines, place);
                open.extend(node.children().map(|(_, child)| place.of(child)));
            }
        })
    }
}
