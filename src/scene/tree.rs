//! A tree over the batches of a scene, so that a ray asks a few of thousands for hits.

use super::Object;
use crate::geometry::{Aabb, Placement, Ray, VertexRay};
use glam::{DMat3, DVec3};
use std::ops::Range;

/// Fewer batches are quicker asked one after the other.
const WORTH_A_TREE: usize = 8;
/// As many batches at most share a leaf.
const LEAF: usize = 2;

/// A binary tree of boxes; nothing for few batches.
#[derive(Clone, Debug, Default)]
pub(super) struct BatchTree {
    /// The root first; an inner node's left child comes right behind it.
    nodes: Vec<Node>,
    /// Indices of batches, a leaf's next to each other.
    order: Vec<usize>,
}

#[derive(Clone, Debug)]
struct Node {
    bounds: Aabb,
    slack: Slack,
    content: Content,
}

#[derive(Clone, Debug)]
enum Content {
    /// Places in the order.
    Leaf(Range<usize>),
    /// The right child.
    Inner(usize),
}

impl BatchTree {
    /// The tree over `batches` of `objects`, each of which lies within its box of `bounds`.
    pub fn new(objects: &[Object], batches: &[Range<usize>], bounds: &[Aabb]) -> Self {
        if batches.len() <= WORTH_A_TREE {
            return Self::default();
        }
        let mut leaves: Vec<(usize, Aabb, Slack)> = batches
            .iter()
            .map(|batch| {
                bounds[batch.clone()]
                    .iter()
                    .fold(Aabb::EMPTY, |all, one| all.union(*one))
            })
            .enumerate()
            .filter(|(_, bounds)| !bounds.is_empty())
            .map(|(index, bounds)| {
                let placement = &objects[batches[index].start].placement;
                (index, bounds, Slack::of(placement, &bounds))
            })
            .collect();
        let mut tree = Self::default();
        tree.split(&mut leaves);
        tree
    }

    /// Adds a node over `leaves` and all below it.
    fn split(&mut self, leaves: &mut [(usize, Aabb, Slack)]) {
        let both = |all: (Aabb, Slack), leaf: &(usize, Aabb, Slack)| {
            (all.0.union(leaf.1), all.1.max(leaf.2))
        };
        let (bounds, slack) = leaves.iter().fold((Aabb::EMPTY, Slack::default()), both);
        let node = self.nodes.len();
        if leaves.len() <= LEAF {
            let start = self.order.len();
            self.order.extend(leaves.iter().map(|leaf| leaf.0));
            let content = Content::Leaf(start..self.order.len());
            return self.nodes.push(Node {
                bounds,
                slack,
                content,
            });
        }
        let centers = Aabb::around(leaves.iter().map(|leaf| leaf.1.center()));
        let axis = (centers.max - centers.min).max_position();
        let middle = leaves.len() / 2;
        // Halves of equal size, whatever lies where: the tree is as deep as the logarithm of its leaves.
        leaves.select_nth_unstable_by(middle, |a, b| {
            let [a, b] = [a, b].map(|leaf| (leaf.1.center()[axis], leaf.0));
            a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))
        });
        let (left, right) = leaves.split_at_mut(middle);
        self.nodes.push(Node {
            bounds,
            slack,
            content: Content::Inner(0),
        });
        self.split(left);
        self.nodes[node].content = Content::Inner(self.nodes.len());
        self.split(right);
    }

    /// Calls `visit` with the index of every batch of `batches` that `ray` may hit. `visit` returns the new end of the
    /// ray's interval, as [`Scene::visit_batches`](super::Scene::visit_batches) says.
    pub fn visit(&self, ray: &Ray, batches: usize, mut visit: impl FnMut(usize) -> f64) {
        if self.nodes.is_empty() {
            for batch in 0..batches {
                visit(batch);
            }
            return;
        }
        let inverse = ray.direction.recip();
        let mut line = VertexRay::new(&widened(ray), DVec3::ZERO);
        let distance = ray.origin.abs().max_element();
        // Halved fewer than 64 times, the batches are used up.
        let mut open = [0; 64];
        let mut waiting = 1;
        while waiting > 0 {
            waiting -= 1;
            let index = open[waiting];
            let Node {
                bounds,
                slack,
                content,
            } = &self.nodes[index];
            let slack = slack.world(distance);
            let bounds = Aabb {
                min: bounds.min - slack,
                max: bounds.max + slack,
            };
            if !bounds.may_hit(&line, inverse) {
                continue;
            }
            match content {
                Content::Leaf(places) => {
                    for &batch in &self.order[places.clone()] {
                        line.ray.t_max = widened(&ray.until(visit(batch))).t_max;
                    }
                }
                Content::Inner(right) => {
                    let along = |node: usize| self.nodes[node].bounds.center().dot(ray.direction);
                    let (left, right) = (index + 1, *right);
                    // The nearer is taken first.
                    let left_first = along(left) <= along(right);
                    [open[waiting], open[waiting + 1]] = if left_first {
                        [right, left]
                    } else {
                        [left, right]
                    };
                    waiting += 2;
                }
            }
        }
    }
}

/// The ray with an interval that is wider by as much as a hit's parameter may be off: the roots of a sphere that it
/// grazes have half of their digits.
fn widened(ray: &Ray) -> Ray {
    let off = |t: f64| 2.0 * f64::EPSILON.sqrt() * t.abs();
    Ray {
        t_min: ray.t_min - off(ray.t_min),
        t_max: ray.t_max + off(ray.t_max),
        ..*ray
    }
}

/// How far from its box, in the world, a batch may be hit because a ray goes into its space by rounding.
///
/// A hit is found at `o' + t d'`, with `o' = Minv (o - T)` and `d' = Minv d` rounded. Its place in the world, by the
/// exact `M` and `T`, is off the world's `o + t d` by two things: what `M Minv` differs from the identity, times the way
/// from `T` to the hit; and a few roundings, which `|M| |Minv|` takes back to the world, of the ways from the eye to `T`
/// and to the hit. The shapes' own roundings and that of the box are of the same kind. Both ways are at most the sum of
/// the largest coordinates of `o`, `T` and the box, of which 64 roundings leave plenty.
#[derive(Clone, Copy, Debug, Default)]
struct Slack {
    /// For each unit of the eye's largest coordinate.
    per_distance: f64,
    /// Whatever the eye.
    fixed: f64,
}

impl Slack {
    fn of(placement: &Placement, bounds: &Aabb) -> Self {
        let (model, inverse) = (placement.model(), placement.inverse_linear());
        let condition = norm(model.matrix3.abs() * inverse.abs());
        let residual = norm((model.matrix3 * inverse - DMat3::IDENTITY).abs());
        let per_distance = 64.0 * f64::EPSILON * condition + 2.0 * residual;
        let reach = bounds.min.abs().max(bounds.max.abs());
        let reach = model.translation.abs().max_element() + reach.max_element();
        Self {
            per_distance,
            fixed: per_distance * reach,
        }
    }

    fn max(self, other: Self) -> Self {
        Self {
            per_distance: self.per_distance.max(other.per_distance),
            fixed: self.fixed.max(other.fixed),
        }
    }

    /// In world units, for rays that start with a coordinate this large.
    fn world(self, distance: f64) -> f64 {
        self.per_distance * distance + self.fixed
    }
}

/// The largest sum of a row.
fn norm(m: DMat3) -> f64 {
    (m.x_axis + m.y_axis + m.z_axis).max_element()
}
