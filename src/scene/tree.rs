//! A bounding volume hierarchy (BVH) over the batches of a scene, so that a ray is tested only against the few batches
//! that it may hit.
//!
//! Its boxes only reject, and they are grown by a slack. Intersecting the batches that it returns gives the same hits,
//! to the bit, as intersecting every batch.
//!
//! # The slack
//!
//! Hits are found in object space. Let `U = 2^-53`. Let `k` be the product of the Frobenius norms of the model matrix
//! and of its inverse, which is at least 3. Let `D` be the sum of the largest coordinates of eye, box and model
//! translation. The computed inverse has a relative error of about `8 k U`. So the ray's line in object space, mapped
//! back to world space, is within `16 k^2 U D` of the given line wherever it may hit. A hit on a curved or flat shape
//! lies on that line and within some `U` of the shape, even where the ray grazes the shape and `t` is inaccurate. The
//! box's own corners round by `4 k U D`. Boxes are grown by `2^-40 k^2 D`: 300 times the sum of these errors, and still
//! negligible in practice.
//!
//! An inexact ray differs from the true one by the error of its origin, plus the error of its direction times the
//! distance to the box. Boxes grow by twice that when they are tested.

use super::{Object, Scene};
use crate::geometry::{Aabb, Pyramid, RayError, WorldRay, binary::power_of_two, entry};
use glam::{DMat3, DVec3};
use std::ops::ControlFlow;

/// Scenes of fewer batches have no tree: each batch is tested.
const WORTH_A_TREE: usize = 8;
/// The most nodes that a box query visits before it gives up.
const MOST_ASKED: usize = 512;
/// The size of the traversal stack: one node per level, and halving by count makes at most 64 levels.
const DEEPEST: usize = 64;

/// The slack of the boxes, as a factor of `k^2 D`.
const ROOM: f64 = power_of_two(-40);

/// A binary tree over the boxes of batches. A move copies its nodes, where the scene before is held: with nodes that
/// trees share, every ray took 1.3 to 1.5 times as long.
#[derive(Clone, Debug, Default)]
pub(super) struct SceneTree {
    /// In depth-first order: the root first, and each node's first child directly after the node.
    nodes: Vec<Node>,
    /// The parent of each node; the root is its own parent.
    above: Vec<usize>,
    /// The node of each batch.
    places: Vec<Option<usize>>,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    bounds: Aabb,
    /// The largest `ROOM * k^2` below this node. `bounds` already includes the slack for all of `D` except the eye's
    /// coordinates.
    room: f64,
    /// The batch of a leaf, or the second child of an inner node.
    content: Content,
}

#[derive(Clone, Copy, Debug)]
enum Content {
    Batch(usize),
    Second(usize),
}

impl SceneTree {
    /// A tree over the batches of a scene; empty when there are few.
    pub fn new(scene: &Scene) -> Self {
        let batches = scene.batches().iter().enumerate();
        let mut leaves: Vec<Node> = batches
            .filter_map(|(index, batch)| {
                let bounds = scene.bounds_of_batch(batch);
                leaf(index, &scene.objects[batch.start], bounds)
            })
            .collect();
        let mut tree = Self::default();
        let count = leaves.len();
        if count >= WORTH_A_TREE {
            tree.nodes.reserve_exact(2 * count - 1);
            tree.above.reserve_exact(2 * count - 1);
            tree.places = vec![None; scene.batches().len()];
            tree.grow(0, &mut leaves);
        }
        tree
    }

    /// Whether the scene has too few batches to be worth a tree.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// Updates the leaf of a batch with a new box, and all nodes above the leaf. `object` is the batch's first.
    pub fn renew(&mut self, batch: usize, object: &Object, bounds: Aabb) {
        let place = self.places.get(batch).copied().flatten();
        let (Some(mut place), Some(leaf)) = (place, leaf(batch, object, bounds)) else {
            return;
        };
        self.nodes[place] = leaf;
        while place > 0 {
            place = self.above[place];
            if let Content::Second(second) = self.nodes[place].content {
                let [a, b] = [place + 1, second].map(|child| self.nodes[child]);
                self.nodes[place].bounds = a.bounds.union(b.bounds);
                self.nodes[place].room = a.room.max(b.room);
            }
        }
    }

    /// Makes the tree over some leaves.
    fn grow(&mut self, above: usize, leaves: &mut [Node]) {
        if let [leaf] = leaves {
            if let Content::Batch(batch) = leaf.content {
                self.places[batch] = Some(self.nodes.len());
            }
            self.above.push(above);
            self.nodes.push(*leaf);
            return;
        }
        let (place, first, second) = self.split(above, leaves);
        self.grow(place, first);
        self.nodes[place].content = Content::Second(self.nodes.len());
        self.grow(place, second);
    }

    /// Adds the node over two leaves or more. Returns its place, and the leaves below each of its children.
    fn split<'a>(
        &mut self,
        above: usize,
        leaves: &'a mut [Node],
    ) -> (usize, &'a mut [Node], &'a mut [Node]) {
        self.above.push(above);
        let empty = (Aabb::EMPTY, Aabb::EMPTY, 0.0_f64);
        let (bounds, centers, room) = leaves.iter().fold(empty, |(bounds, centers, room), leaf| {
            let centers = centers.including(leaf.bounds.center());
            (bounds.union(leaf.bounds), centers, room.max(leaf.room))
        });
        let size = centers.max - centers.min;
        let axis = size.max_position();
        let middle = leaves.len() / 2;
        leaves.select_nth_unstable_by(middle, |a, b| {
            let [a, b] = [a, b].map(|leaf| leaf.bounds.center()[axis]);
            a.total_cmp(&b)
        });
        let place = self.nodes.len();
        self.nodes.push(Node {
            bounds,
            room,
            content: Content::Second(0),
        });
        let (first, second) = leaves.split_at_mut(middle);
        (place, first, second)
    }

    /// Calls `visit` with every batch that may be inside a world-space pyramid, until `visit` breaks.
    pub fn visit_within(&self, pyramid: &Pyramid, mut visit: impl FnMut(usize) -> ControlFlow<()>) {
        let mut open = vec![0];
        while let Some(place) = open.pop() {
            let node: &Node = &self.nodes[place];
            if !pyramid.may_hold(&node.bounds.corners()) {
                continue;
            }
            match node.content {
                Content::Batch(batch) => {
                    if visit(batch).is_break() {
                        return;
                    }
                }
                Content::Second(second) => open.extend([second, place + 1]),
            }
        }
    }

    /// Whether `is_it` holds for some batch whose box meets `bounds`. Also true after more than [`MOST_ASKED`] nodes.
    pub fn meets(&self, bounds: &Aabb, mut is_it: impl FnMut(usize) -> bool) -> bool {
        let mut open = vec![0];
        let mut asked = 0;
        while let Some(place) = open.pop() {
            let node: &Node = &self.nodes[place];
            // NaN compares false, so it counts as meeting.
            let beside = node.bounds.max.cmplt(bounds.min) | bounds.max.cmplt(node.bounds.min);
            if beside.any() {
                continue;
            }
            asked += 1;
            match node.content {
                _ if asked > MOST_ASKED => return true,
                Content::Batch(batch) if is_it(batch) => return true,
                Content::Batch(_) => {}
                Content::Second(second) => open.extend([second, place + 1]),
            }
        }
        false
    }

    /// Calls `visit` with every batch that a world-space ray may hit, nearer boxes first. `visit` returns the new end
    /// of the ray's interval.
    pub fn visit(&self, ray: &WorldRay, mut visit: impl FnMut(usize) -> f64) {
        let seen = Seen::new(ray);
        let mut end = ray.t_max;
        let enter = |place: usize, end: f64| self.nodes[place].enter(&seen, end);
        let mut waiting = [(0_usize, 0.0); DEEPEST];
        let mut count = 0_usize;
        let mut next = enter(0, end).map(|begin| (0, begin));
        loop {
            let Some((place, begin)) = next else {
                let Some(last) = count.checked_sub(1) else {
                    return;
                };
                count = last;
                next = Some(waiting[last]);
                continue;
            };
            next = None;
            if begin > end {
                continue;
            }
            match self.nodes[place].content {
                Content::Batch(batch) => end = visit(batch),
                Content::Second(second) => {
                    let [first, second] =
                        [place + 1, second].map(|child| Some((child, enter(child, end)?)));
                    next = first.or(second);
                    if let (Some(a), Some(b)) = (first, second) {
                        let (near, far) = if a.1 <= b.1 { (a, b) } else { (b, a) };
                        next = Some(near);
                        waiting[count] = far;
                        count += 1;
                    }
                }
            }
        }
    }
}

/// A ray with the values that every box test needs.
pub(super) struct Seen<'a> {
    ray: &'a WorldRay<'a>,
    /// `1 / direction`.
    inverse: DVec3,
    /// The largest absolute coordinate of the ray's origin.
    away: f64,
    /// Twice the error bound of the origin, and twice that of the direction per unit of distance.
    errors: [f64; 2],
}

impl<'a> Seen<'a> {
    pub fn new(ray: &'a WorldRay<'a>) -> Self {
        let RayError { origin, direction } = ray.error();
        let per_way = direction.max_element() / ray.direction.abs().max_element();
        Self {
            ray,
            inverse: ray.direction.recip(),
            away: ray.origin.abs().max_element(),
            errors: [2.0 * origin.max_element(), 2.0 * per_way],
        }
    }
}

impl Node {
    /// A lower bound on the `t` at which the ray enters the box; `None` where it misses the box before `end`.
    fn enter(&self, seen: &Seen, end: f64) -> Option<f64> {
        let Seen { ray, away, .. } = *seen;
        let Aabb { min, max } = self.bounds;
        let [of_origin, per_way] = seen.errors;
        let way = away + min.abs().max(max.abs()).max_element();
        let room = self.room * away + of_origin + per_way * way;
        let ways = [min - room, max + room].map(|corner| corner - ray.origin);
        entry(ways, seen.inverse, [ray.t_min, end], 0.0)
    }
}

/// Whether a ray may hit a batch at a `t` up to `end`, as a tree asks it of the batch's leaf. `object` is the batch's
/// first.
pub(super) fn may_hit(seen: &Seen, object: &Object, bounds: Aabb, end: f64) -> bool {
    leaf(0, object, bounds).is_some_and(|leaf| leaf.enter(seen, end).is_some())
}

/// The leaf of a batch, its box grown by the slack; `None` for an empty box.
fn leaf(batch: usize, object: &Object, bounds: Aabb) -> Option<Node> {
    if bounds.is_empty() {
        return None;
    }
    let model = object.placement.model();
    let norm = |m: DMat3| m.to_cols_array().iter().map(|x| x * x).sum::<f64>().sqrt();
    let k = norm(model.matrix3) * norm(object.placement.inverse_linear());
    let room = ROOM * k * k;
    let largest = [bounds.min, bounds.max, model.translation].map(|v| v.abs().max_element());
    let grown = room * (largest[0].max(largest[1]) + largest[2]);
    Some(Node {
        bounds: bounds.grown(DVec3::splat(grown)),
        room,
        content: Content::Batch(batch),
    })
}
