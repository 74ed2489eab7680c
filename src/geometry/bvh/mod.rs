//! A bounding volume hierarchy over a mesh's triangles. It only rejects: it visits every triangle that a ray may hit.
//!
//! A node has eight boxes and a leaf eight triangles, so that one instruction handles eight numbers (Wald, Benthin &
//! Boulos, "Getting rid of packets", RT 2008; Embree's layout). Boxes and triangles are tested in `f32`, with a proven
//! bound on the rounding errors ([`tree_ray`]): the ray certainly misses whatever is rejected. The caller decides the
//! rest in `f64`, so the answer is the same to the bit, whichever instructions there are.

#![allow(
    clippy::inline_always,
    reason = "what is not inlined into the walk is not compiled for its instructions"
)]

mod binning;
mod build;
mod build_primitive;
mod collapse;
mod node;
mod simd;
mod split;
mod tree_ray;
mod validate;
mod walk;

pub use simd::Simd;

use super::{Aabb, LocalRay, Pyramid};
use glam::{DVec3, Vec3};
use node::{CacheLine, Child, Leaf, Node, Place, WIDTH};
use simd::Instructions;
use std::{ops::ControlFlow, sync::atomic::AtomicBool};
use tree_ray::Frame;
use walk::Walk;

/// Receives the triangles that a ray may hit. A closure works, too, but is not sure to be compiled for a walk's
/// instructions: that needs `#[inline(always)]`, which closures cannot have.
pub trait Visit {
    /// Takes a triangle of the mesh and its exact corners. Returns the new end of the ray's interval.
    fn visit(&mut self, triangle: u32, corners: [DVec3; 3]) -> f64;
}

impl<F: FnMut(u32, [DVec3; 3]) -> f64> Visit for F {
    #[inline]
    fn visit(&mut self, triangle: u32, corners: [DVec3; 3]) -> f64 {
        self(triangle, corners)
    }
}

/// The entry point of coherent rays: a node that replaces the root and holds all that any of them may meet (after
/// Reshetov, Soupikov & Hurley, "Multi-Level Ray Tracing Algorithm", SIGGRAPH 2005).
#[derive(Debug)]
pub(crate) struct Entry(Node);

/// A tree over triangles, in the vertices' own space.
#[derive(Debug)]
pub struct Bvh {
    /// Nodes and leaves; the first is the root, and each comes before its children.
    lines: Vec<CacheLine>,
    frame: Frame,
    instructions: Instructions,
}

impl Bvh {
    /// The bytes that it takes.
    #[cfg(test)]
    pub(crate) fn bytes(&self) -> usize {
        size_of_val(&*self.lines)
    }

    /// Builds the tree over `triangles`, index triples into `positions`, on all processors. All coordinates must be
    /// finite. `simd` names the instructions that build the tree and walk it: one of [`Simd::available`].
    ///
    /// `None` when `stop` was set meanwhile, when this processor lacks the instructions, and for meshes that a tree
    /// cannot hold: without triangles, with more than `2^27`, or with coordinates of such different magnitude that
    /// scaling would change them.
    ///
    /// # Panics
    /// When a triangle names a position that is not there.
    pub fn build(
        positions: &[[f32; 3]],
        triangles: &[[u32; 3]],
        simd: Simd,
        stop: &AtomicBool,
    ) -> Option<Self> {
        build::build(positions, triangles, Instructions::of(simd)?, stop)
    }

    /// Calls `visit` with every triangle that `ray` may hit, nearer boxes first. In the ray's space, the vertices'
    /// origin lies at `center`. `visit` returns the new end of the ray's interval. Boxes that begin beyond it are
    /// skipped; boxes that begin *at* it are not, so that all ties are seen.
    ///
    /// Which other triangles are visited may differ between processors.
    #[inline]
    pub fn visit(&self, ray: &LocalRay, center: &DVec3, visit: &mut impl Visit) {
        self.visit_from::<true>(None, ray, center, visit);
    }

    /// [`Bvh::visit`] for a ray whose entry point may be known. Without `FILTER`, only boxes reject: other triangle
    /// tests under study may hit a triangle that the ray misses.
    #[inline]
    pub(crate) fn visit_from<const FILTER: bool>(
        &self,
        entry: Option<&Entry>,
        ray: &LocalRay,
        center: &DVec3,
        visit: &mut impl Visit,
    ) {
        self.instructions.run(Walk::<_, FILTER> {
            tree: self,
            from: entry.map_or_else(|| self.root(), |Entry(node)| node),
            ray,
            center,
            visit,
        });
    }

    /// The boxes `level` steps below the root, and those of leaves above that level: at most `most` of them.
    pub fn boxes(&self, level: u32, most: usize) -> Vec<Aabb> {
        let mut boxes = vec![(Place::ROOT, self.whole())];
        for _ in 0..level {
            let below = boxes.iter().flat_map(|&(place, bounds)| {
                let node = (!place.is_leaf()).then(|| Node::at(&self.lines, place));
                let children = node.into_iter().flat_map(move |node| {
                    let children = node.children();
                    children.map(move |(lane, child)| (place.of(child), self.bounds(node, lane)))
                });
                children.chain(place.is_leaf().then_some((place, bounds)))
            });
            boxes = below.take(most).collect();
        }
        boxes.into_iter().map(|(_, bounds)| bounds).collect()
    }

    /// The entry point of all rays within a pyramid; `None` where they meet nothing. The pyramid is given about the
    /// vertices' origin.
    pub(crate) fn entry(&self, pyramid: &Pyramid) -> Option<Entry> {
        let children_met = |place: Place| {
            let node = Node::at(&self.lines, place);
            node.children().filter_map(move |(lane, child)| {
                let is_met = pyramid.may_meet(&self.bounds(node, lane));
                is_met.then(|| (place.of(child), node.bounds(lane)))
            })
        };
        // Descends as far as the children met still fit into one node.
        let mut met: Vec<_> = children_met(Place::ROOT).collect();
        let mut next = 0;
        while let Some(&(place, _)) = met.get(next) {
            let room = WIDTH + 1 - met.len();
            let below: Vec<_> = if place.is_leaf() {
                Vec::new()
            } else {
                children_met(place).take(room + 1).collect()
            };
            if place.is_leaf() || below.len() > room {
                next += 1;
            } else {
                met.swap_remove(next);
                met.extend(below);
            }
        }
        let mut node = Node::about(met.iter().map(|&(_, bounds)| bounds));
        for (child, &(place, _)) in node.children.iter_mut().zip(&met) {
            *child = Child::between(Place::ROOT, place);
        }
        (!met.is_empty()).then_some(Entry(node))
    }

    fn root(&self) -> &Node {
        Node::at(&self.lines, Place::ROOT)
    }

    /// Calls `visit` with every triangle that may be inside a pyramid, and its corners, until `visit` breaks. The
    /// pyramid is given about the vertices' origin.
    pub(crate) fn visit_pyramid(
        &self,
        pyramid: &Pyramid,
        mut visit: impl FnMut(u32, [DVec3; 3]) -> ControlFlow<()>,
    ) {
        let may_hold = |bounds: Aabb| pyramid.may_hold(&bounds.corners());
        if !may_hold(self.whole()) {
            return;
        }
        for leaf in self.leaves(|node, lane| may_hold(self.bounds(node, lane))) {
            for lane in leaf.lanes() {
                let corners = (leaf.corners_of(lane)).map(|corner| self.corner(corner));
                if pyramid.may_hold(&corners) && visit(leaf.triangles[lane], corners).is_break() {
                    return;
                }
            }
        }
    }

    /// All leaves, but those below a child that is not wanted, given by its node and lane.
    fn leaves(&self, is_wanted: impl Fn(&Node, usize) -> bool) -> impl Iterator<Item = &Leaf> {
        let mut open = vec![Place::ROOT];
        std::iter::from_fn(move || {
            loop {
                let place = open.pop()?;
                if place.is_leaf() {
                    return Some(Leaf::at(&self.lines, place));
                }
                let node = Node::at(&self.lines, place);
                let wanted = node.children().filter(|(lane, _)| is_wanted(node, *lane));
                open.extend(wanted.map(|(_, child)| place.of(child)));
            }
        })
    }

    /// The box about everything.
    fn whole(&self) -> Aabb {
        let Frame {
            bounds, unscale, ..
        } = self.frame;
        let [min, max] = [bounds.min, bounds.max].map(|corner| corner * unscale);
        Aabb { min, max }
    }

    /// The box of a node's child.
    fn bounds(&self, node: &Node, lane: usize) -> Aabb {
        let [min, max] = node.bounds(lane).map(|corner| self.corner(corner));
        Aabb { min, max }
    }

    /// A corner of a box or a triangle, in the caller's unit.
    fn corner(&self, scaled: [f32; 3]) -> DVec3 {
        Vec3::from(scaled).as_dvec3() * self.frame.unscale
    }
}
