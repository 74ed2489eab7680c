//! Walks a ray through a tree.

use super::{
    Bvh, Visit,
    node::{CacheLine, Leaf, Node, Place, WIDTH},
    simd::{Eight, Lanes, Stack, StackRoom, Work},
    tree_ray::{ShearedRay, TreeRay, Unplaced},
};
use crate::geometry::LocalRay;
use glam::DVec3;

/// Calls `visit` with the triangles that a ray may hit, nearer boxes first; `visit` returns the new end of the ray's
/// interval.
///
/// Without `FILTER`, triangles are judged by their boxes alone.
pub(super) struct Walk<'a, V, const FILTER: bool> {
    pub tree: &'a Bvh,
    /// The root, or a node in its place.
    pub from: &'a Node,
    pub ray: &'a LocalRay<'a>,
    /// Where the vertices' (0, 0, 0) lies in the ray's space.
    pub center: &'a DVec3,
    pub visit: &'a mut V,
}

impl<V: Visit, const FILTER: bool> Work for Walk<'_, V, FILTER> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) {
        let Self {
            tree,
            from,
            ray,
            center,
            visit,
        } = self;
        let t_max = ray.limit;
        let ray = match TreeRay::prepare(ray, center, &tree.frame) {
            Ok(ray) => ray,
            Err(Unplaced::Misses) => return,
            Err(Unplaced::BeyondF32) => return visit_all(lanes, tree, visit),
        };
        let mut end = ray.end(t_max);
        let lines = &*tree.lines;
        let ray = &ray;
        let boxes = Boxes::new(lanes, ray);
        let mut filter = None;
        let mut room = StackRoom::new();
        let mut stack = Stack::new(&mut room);
        let mut place = Place::ROOT;
        loop {
            if place.is_leaf() {
                let leaf = Leaf::at(lines, place);
                let mut hit = if FILTER {
                    let filter = match &filter {
                        Some(filter) => filter,
                        None => filter.insert(TriangleFilter::new(ray)),
                    };
                    filter.may_hit(lanes, leaf, end)
                } else {
                    present(lanes, leaf)
                };
                while hit != 0 {
                    let lane = hit.trailing_zeros() as usize % WIDTH;
                    hit &= hit - 1;
                    let found = Found {
                        tree,
                        leaf,
                        lane,
                        visit,
                    };
                    end = ray.end(lanes.apart(found));
                }
            } else {
                let node = if place == Place::ROOT {
                    from
                } else {
                    Node::at(lines, place)
                };
                let (hit, enter) = boxes.may_hit(lanes, node, end);
                if hit != 0 {
                    let open = Open {
                        node,
                        place,
                        enter: lanes.store(enter),
                        hit,
                    };
                    place = open.nearest(lanes, lines, &mut stack);
                    continue;
                }
            }
            loop {
                let Some(item) = stack.pop() else { return };
                if item.cast_signed() <= last(end) {
                    place = place_of(item);
                    break;
                }
            }
        }
    }
}

/// A triangle that the ray may hit, to be handed to `visit`.
struct Found<'a, V> {
    tree: &'a Bvh,
    leaf: &'a Leaf,
    lane: usize,
    visit: &'a mut V,
}

impl<V: Visit> Work for Found<'_, V> {
    type Output = f64;

    #[inline(always)]
    fn run<L: Lanes>(self, _: L) -> f64 {
        let lane = self.lane % WIDTH;
        let unscale = self.tree.frame.unscale;
        let wide = |[x, y, z]: [f32; 3]| unscale * DVec3::new(x.into(), y.into(), z.into());
        let corners = self.leaf.corners_of(lane).map(wide);
        self.visit.visit(self.leaf.triangles[lane], corners)
    }
}

/// Visits every triangle.
#[cold]
fn visit_all(lanes: impl Lanes, tree: &Bvh, visit: &mut impl Visit) {
    for leaf in tree.leaves(|_, _| true) {
        for lane in leaf.lanes() {
            lanes.apart(Found {
                tree,
                leaf,
                lane,
                visit,
            });
        }
    }
}

/// The children of a node that a ray may enter.
struct Open<'a> {
    node: &'a Node,
    place: Place,
    /// Where the ray enters each.
    enter: Eight,
    /// Those not yet taken.
    hit: u32,
}

impl Open<'_> {
    /// Returns the nearest; the others go onto the stack, farthest first.
    #[inline(always)]
    fn nearest<L: Lanes>(mut self, lanes: L, lines: &[CacheLine], stack: &mut Stack) -> Place {
        let first = self.next();
        if self.hit == 0 {
            return place_of(first);
        }
        let second = self.next();
        let (mut near, far) = if first <= second {
            (first, second)
        } else {
            (second, first)
        };
        prefetch(lanes, lines, near);
        prefetch(lanes, lines, far);
        let start = stack.len();
        stack.push(far);
        while self.hit != 0 {
            let mut other = self.next();
            prefetch(lanes, lines, other);
            if other < near {
                (near, other) = (other, near);
            }
            stack.push(other);
            // Insert it in order among those above `start`.
            let items = stack.above(start);
            let mut at = items.len() - 1;
            while at > 0 && items[at - 1] < other {
                items[at] = items[at - 1];
                at -= 1;
            }
            items[at] = other;
        }
        place_of(near)
    }

    /// The first one left.
    #[inline(always)]
    fn next(&mut self) -> u64 {
        let lane = self.hit.trailing_zeros() as usize % WIDTH;
        self.hit &= self.hit - 1;
        item(self.enter.0[lane], self.place.of(self.node.children[lane]))
    }
}

/// Prefetches a whole leaf, one line longer than a node.
#[inline(always)]
fn prefetch<L: Lanes>(lanes: L, lines: &[CacheLine], item: u64) {
    let line = place_of(item).line();
    for line in line..line + Leaf::LINES {
        lanes.prefetch(lines, line);
    }
}

/// A place and the `t` at which its box begins, packed so that a nearer box is a smaller number: floats from 0 on are
/// ordered like their bits. (Boxes that begin before 0 are merely visited in another order.)
#[inline(always)]
fn item(begins: f32, place: Place) -> u64 {
    u64::from(begins.to_bits()) << 32 | u64::from(place.0)
}

#[inline(always)]
#[expect(clippy::cast_possible_truncation, reason = "the lower half")]
fn place_of(item: u64) -> Place {
    Place(item as u32)
}

/// The greatest item whose box begins no later than `end`, which is 0 or more. Items compare to it as signed
/// numbers, so that boxes that begin before 0 are less.
#[inline(always)]
fn last(end: f32) -> i64 {
    (u64::from(end.to_bits()) << 32 | u64::from(u32::MAX)).cast_signed()
}

/// Which lanes hold a triangle.
#[inline(always)]
fn present<L: Lanes>(lanes: L, leaf: &Leaf) -> u32 {
    let x = lanes.load(&leaf.corners[0][0]);
    lanes.le(x, x)
}

/// A ray against the eight boxes of a node.
struct Boxes<L: Lanes> {
    backwards: [usize; 3],
    inverse: [L::F; 3],
    entry_offset: [L::F; 3],
    exit_offset: [L::F; 3],
    start: L::F,
}

impl<L: Lanes> Boxes<L> {
    #[inline(always)]
    fn new(lanes: L, ray: &TreeRay) -> Self {
        Self {
            backwards: ray.backwards,
            inverse: splat3(lanes, ray.inverse.to_array()),
            entry_offset: splat3(lanes, ray.entry_offset.to_array()),
            exit_offset: splat3(lanes, ray.exit_offset.to_array()),
            start: lanes.splat(ray.start),
        }
    }

    /// Which boxes the ray may enter before `end`, and where.
    #[inline(always)]
    fn may_hit(&self, lanes: L, node: &Node, end: f32) -> (u32, L::F) {
        let begin = lanes.max(
            lanes.max(self.enter(lanes, node, 0), self.enter(lanes, node, 1)),
            lanes.max(self.enter(lanes, node, 2), self.start),
        );
        let end = lanes.min(
            lanes.min(self.leave(lanes, node, 0), self.leave(lanes, node, 1)),
            lanes.min(self.leave(lanes, node, 2), lanes.splat(end)),
        );
        (lanes.le(begin, end), begin)
    }

    #[inline(always)]
    fn enter(&self, lanes: L, node: &Node, axis: usize) -> L::F {
        let plane = lanes.load(&node.corners[self.backwards[axis]][axis]);
        lanes.mul_add(plane, self.inverse[axis], self.entry_offset[axis])
    }

    #[inline(always)]
    fn leave(&self, lanes: L, node: &Node, axis: usize) -> L::F {
        let plane = lanes.load(&node.corners[1 - self.backwards[axis]][axis]);
        lanes.mul_add(plane, self.inverse[axis], self.exit_offset[axis])
    }
}

#[inline(always)]
fn splat3<L: Lanes>(lanes: L, [x, y, z]: [f32; 3]) -> [L::F; 3] {
    [lanes.splat(x), lanes.splat(y), lanes.splat(z)]
}

/// Tests a ray against the eight triangles of a leaf, in `f32`.
struct TriangleFilter {
    ray: ShearedRay,
    /// The start of the interval as a length, less the ray's `reach`.
    start: f32,
    /// Five times the ray's `reach`.
    five_reach: f32,
}

/// Eight corners as the ray sees them: distance along it, and offsets beside it.
#[derive(Clone, Copy)]
struct Seen<L: Lanes> {
    t: L::F,
    x: L::F,
    y: L::F,
}

impl TriangleFilter {
    #[inline(always)]
    fn new(ray: &TreeRay) -> Self {
        let start = ray.start;
        let ray = ray.sheared();
        Self {
            start: start * ray.size - ray.reach,
            five_reach: 5.0 * ray.reach,
            ray,
        }
    }

    #[inline(always)]
    fn see<L: Lanes>(&self, lanes: L, corner: &[[f32; WIDTH]; 3]) -> Seen<L> {
        let ShearedRay {
            axes,
            origin,
            slope,
            ..
        } = &self.ray;
        let x = lanes.load(&corner[axes[0]]);
        let y = lanes.load(&corner[axes[1]]);
        let along = lanes.load(&corner[axes[2]]);
        let [origin_x, origin_y, origin_t] = splat3(lanes, *origin);
        let [slope_x, slope_y, sign] = splat3(lanes, *slope);
        let t = lanes.mul_add(along, sign, origin_t);
        Seen {
            t,
            x: lanes.sub_mul(lanes.sub(x, origin_x), slope_x, t),
            y: lanes.sub_mul(lanes.sub(y, origin_y), slope_y, t),
        }
    }

    /// Which triangles the ray may hit before `end`; see [`super::tree_ray`] for the bounds.
    #[inline(always)]
    fn may_hit<L: Lanes>(&self, lanes: L, leaf: &Leaf, end: f32) -> u32 {
        let [a, b, c] = &leaf.corners;
        let a = self.see(lanes, a);
        let b = self.see(lanes, b);
        let c = self.see(lanes, c);
        let (u, v, w) = (edge(lanes, b, c), edge(lanes, c, a), edge(lanes, a, b));
        let least = lanes.min(lanes.min(u, v), w);
        let greatest = lanes.max(lanes.max(u, v), w);
        let m = lanes.largest_size([a.x, a.y, b.x, b.y, c.x, c.y]);
        let ShearedRay { size, reach, .. } = self.ray;
        let slack = lanes.mul_add(
            m,
            lanes.splat(5.0 * f32::EPSILON),
            lanes.splat(self.five_reach),
        );
        let e = lanes.mul(lanes.add(m, lanes.splat(reach)), slack);
        let minus_e = lanes.sub(lanes.splat(0.0), e);
        let one_sign = lanes.le(minus_e, least) | lanes.le(greatest, e);
        // Most leaves end here.
        if one_sign == 0 {
            return 0;
        }
        let nearest = lanes.min(lanes.min(a.t, b.t), c.t);
        let farthest = lanes.max(lanes.max(a.t, b.t), c.t);
        let end = lanes.splat(end * size + reach);
        one_sign & lanes.le(nearest, end) & lanes.le(lanes.splat(self.start), farthest)
    }
}

/// The edge function of two corners: twice the signed area that they span with the ray.
#[inline(always)]
fn edge<L: Lanes>(lanes: L, a: Seen<L>, b: Seen<L>) -> L::F {
    lanes.sub_mul(lanes.mul(a.x, b.y), a.y, b.x)
}
