//! A bounding volume hierarchy over a mesh's triangles.
//!
//! Built by `obvhs`, walked here: its boxes are `f32` about `f32` vertices and therefore exact, and
//! [`Aabb::may_hit`] allows for all rounding of the walk in `f64`, so that no hit is lost between them.

use super::{Aabb, VertexRay};
use glam::DVec3;
use obvhs::{BvhBuildParams, bvh2::Bvh2};
use std::time::Duration;

/// A tree over triangles, in the vertices' own space.
pub struct Bvh {
    tree: Bvh2,
}

/// A triangle's box, as the builder wants it.
struct Bounds([f32; 3], [f32; 3]);

impl obvhs::Boundable for Bounds {
    fn aabb(&self) -> obvhs::aabb::Aabb {
        obvhs::aabb::Aabb::new(self.0.into(), self.1.into())
    }
}

impl Bvh {
    /// Builds the tree over `triangles`, index triples into `positions`. All coordinates must be finite.
    #[must_use]
    pub fn new(positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> Self {
        let bounds: Vec<Bounds> = triangles
            .iter()
            .map(|corners| {
                let [a, b, c] = corners.map(|i| positions[i as usize]);
                let pick = |f: fn(f32, f32) -> f32| std::array::from_fn(|i| f(f(a[i], b[i]), c[i]));
                Bounds(pick(f32::min), pick(f32::max))
            })
            .collect();
        let params = BvhBuildParams::very_fast_build();
        let tree = obvhs::bvh2::builder::build_bvh2(&bounds, params, &mut Duration::default());
        Self { tree }
    }

    /// Calls `visit` with every triangle whose box `ray` may hit, nearer boxes first. `visit` returns the new
    /// end of the ray's interval, which must not be before the exact parameter of the best hit so far; boxes that
    /// begin beyond it are passed over, one that begins *at* it is not, so that equal hits are all seen.
    pub fn visit(&self, ray: &VertexRay, mut visit: impl FnMut(u32) -> f64) {
        let nodes = &self.tree.nodes;
        if nodes.is_empty() {
            return;
        }
        let mut ray = *ray;
        let inverse = ray.ray.direction.recip();
        let mut stack = Vec::with_capacity(64);
        if self.bounds(0).may_hit(&ray, inverse) {
            stack.push(0);
        }
        while let Some(index) = stack.pop() {
            // Again: the interval may have shrunk since it was pushed.
            if !self.bounds(index).may_hit(&ray, inverse) {
                continue;
            }
            let node = &nodes[index];
            let first = node.first_index as usize;
            if node.is_leaf() {
                for &triangle in
                    &self.tree.primitive_indices[first..first + node.prim_count as usize]
                {
                    ray.ray.t_max = visit(triangle);
                }
                continue;
            }
            let (near, far) = if self.begins_before(&ray, first, first + 1) {
                (first, first + 1)
            } else {
                (first + 1, first)
            };
            stack.extend([far, near]);
        }
    }

    /// The boxes so many steps below the root, and leaves that are nearer to it: at most `most` of them.
    #[must_use]
    pub fn boxes(&self, level: u32, most: usize) -> Vec<Aabb> {
        let mut open: Vec<usize> = (0..self.tree.nodes.len().min(1)).collect();
        for _ in 0..level {
            let children = open.iter().flat_map(|&index| {
                let node = &self.tree.nodes[index];
                let first = node.first_index as usize;
                if node.is_leaf() {
                    index..index + 1
                } else {
                    first..first + 2
                }
            });
            open = children.take(most).collect();
        }
        open.into_iter().map(|node| self.bounds(node)).collect()
    }

    /// Whether box `a` lies before box `b` along the ray, by their centres.
    fn begins_before(&self, ray: &VertexRay, a: usize, b: usize) -> bool {
        let apart = self.bounds(b).center() - self.bounds(a).center();
        ray.ray.direction.dot(apart) >= 0.0
    }

    fn bounds(&self, node: usize) -> Aabb {
        let aabb = self.tree.nodes[node].aabb();
        let wide = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
        Aabb {
            min: wide(aabb.min.to_array()),
            max: wide(aabb.max.to_array()),
        }
    }
}
