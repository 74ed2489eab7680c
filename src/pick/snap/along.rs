//! Finds points along an edge: where the picture shows it nearest to the position, what near, far and section leave of
//! it, and where it emerges from behind a surface.

use super::{Candidate, Facet, Search};
use crate::{
    geometry::dyadic::{self, Dyadic, DyadicVector},
    pick::{
        SceneHit,
        edge::{Shown, determinant},
        sight::hides,
    },
};
use num_bigint::BigInt;

impl Search<'_> {
    /// The foot of the perpendicular in the picture, as a share [part, whole] of the side. It may lie beyond the ends.
    /// `None` for a side that shows as a point.
    fn foot(shown: &[Shown<BigInt>; 2]) -> Option<[Dyadic; 2]> {
        let [a, b] = shown;
        // As in `edge`: the line through both ends, and their places along it.
        let line_u = determinant([&a.v, &a.w], [&b.v, &b.w]);
        let line_v = determinant([&a.w, &a.u], [&b.w, &b.u]);
        let along = |p: &Shown<BigInt>| determinant([&p.u, &p.v], [&line_u, &line_v]);
        let (from, to) = (along(a), along(b));
        let whole = to.minus(&from);
        (!whole.is_zero()).then(|| [from.negated(), whole])
    }

    /// Both ends of a side in the world, and as the picture shows them.
    fn ends(&self, facet: &Facet, corner: usize) -> ([DyadicVector; 2], [Shown<BigInt>; 2]) {
        let at = |share: f64| dyadic::placed(&facet.point(self.scene, corner, share));
        let ends = [at(0.0), at(1.0)];
        let shown = [&ends[0], &ends[1]].map(|end| self.space.point(end));
        (ends, shown)
    }

    /// The exact share of a point of an edge as [part, whole] with a positive whole; `None` unless the point is the
    /// foot.
    fn is_foot(point: &Candidate, shown: &[Shown<BigInt>; 2]) -> Option<[Dyadic; 2]> {
        let [part, whole] = Self::foot(shown)?;
        let share = point.share.to_bits();
        (share != 0 && part.ratio(&whole).to_bits() == share).then(|| {
            let sign = Dyadic::new(if whole.is_negative() { -1.0 } else { 1.0 });
            [part.times(&sign), whole.times(&sign)]
        })
    }

    /// The candidate as the picture shows it, times a positive weight; and that weight.
    pub(super) fn shown(&self, candidate: &Candidate) -> (Shown<BigInt>, Dyadic) {
        let (_, ends) = self.ends(&candidate.facet, candidate.corner);
        let Some([part, whole]) = Self::is_foot(candidate, &ends) else {
            return (candidate.shown(self.scene, &self.space), Dyadic::new(1.0));
        };
        let rest = whole.minus(&part);
        let [a, b] = &ends;
        let both = |a: &Dyadic, b: &Dyadic| a.times(&rest).plus(&b.times(&part));
        let shown = Shown {
            u: both(&a.u, &b.u),
            v: both(&a.v, &b.v),
            w: both(&a.w, &b.w),
            depth: both(&a.depth, &b.depth),
        };
        (shown, whole)
    }

    /// Three shares of a side: where the picture shows it nearest to the position (at the perpendicular's foot or an
    /// end), and the first and the last that near, far and section leave. `None` where they leave nothing, or the side
    /// shows as a point.
    pub(super) fn nearest_and_ends(&self, facet: &Facet, corner: usize) -> Option<[f64; 3]> {
        let at = |share: f64| dyadic::placed(&facet.point(self.scene, corner, share));
        let (ends, shown) = self.ends(facet, corner);
        let [part, whole] = Self::foot(&shown)?;
        let share = part.ratio(&whole);
        let [first, last] = self.left(&ends, &shown)?;
        if (first..=last).contains(&share) {
            return Some([share, first, last]);
        }
        let away_px = |share: f64| self.space.point(&at(share)).distance_px().ok();
        let is_first = away_px(first)? <= away_px(last)?;
        Some([if is_first { first } else { last }, first, last])
    }

    /// Where a side emerges from behind the surface that hides a point of it. The search goes away from the side's
    /// nearest point; if that is the hidden point, it goes both ways. A convex surface hides one interval of a side,
    /// which is skipped whole.
    pub(super) fn beside(&self, hidden: &Candidate, by: &SceneHit) -> Vec<Candidate> {
        let (facet, corner, share) = (&hidden.facet, hidden.corner, hidden.share);
        let Some([nearest, first, last]) = self.nearest_and_ends(facet, corner) else {
            return Vec::new();
        };
        let is_hidden = |share: f64| {
            let point = facet.point(self.scene, corner, share);
            hides(self.scene, self.view, by, &point)
        };
        let ways = [(first, share <= nearest), (last, share >= nearest)];
        let out = ways.into_iter().filter_map(|(end, is_further)| {
            let end = self.reach(facet, corner, [share, end]);
            let comes_out = is_further && !is_hidden(end);
            comes_out.then(|| first_without(share, end, is_hidden))
        });
        out.filter_map(|share| self.candidate(facet, corner, share))
            .collect()
    }

    /// The share at which a side leaves the radius, between two shares, or a little beyond; by bisection in `f64`.
    fn reach(&self, facet: &Facet, corner: usize, [mut within, mut beyond]: [f64; 2]) -> f64 {
        let [from, to] = facet.side(corner).map(|end| facet.origin + end);
        let placement = &self.scene.objects()[facet.object].placement;
        let is_beyond = |share: f64| {
            let world = placement.point_to_world(from.lerp(to, share));
            let shown = self.view.project(world);
            shown.is_some_and(|at| at.px.distance(self.px) > self.radius_px + 1.0)
        };
        if is_beyond(beyond) {
            for _ in 0..32 {
                let middle = within.midpoint(beyond);
                *if is_beyond(middle) {
                    &mut beyond
                } else {
                    &mut within
                } = middle;
            }
        }
        beyond
    }

    /// The interval of shares that near, far and section leave of a side, rounded inwards; `None` where they leave
    /// nothing.
    fn left(&self, ends: &[DyadicVector; 2], shown: &[Shown<BigInt>; 2]) -> Option<[f64; 2]> {
        let near = shown.each_ref().map(|end| self.space.behind_near(end));
        let far = shown.each_ref().map(|end| self.space.before_far(end));
        let [a, b] = ends.each_ref().map(|end| self.space.kept(end));
        let section = a.zip(b).map(|(a, b)| ([a, b], true));
        let mut left = [0.0_f64, 1.0];
        // A point on the far plane is not shown; on the other planes it is.
        for ([a, b], with_zero) in [(near, true), (far, false)].into_iter().chain(section) {
            let is_left = |side: &Dyadic| side.sign().is_gt() || (with_zero && side.is_zero());
            let slope = b.minus(&a);
            let is_left_at = |share: f64| is_left(&a.plus(&slope.times(&Dyadic::new(share))));
            let mut cut = a.negated().ratio(&slope);
            match (is_left(&a), is_left(&b)) {
                (true, true) => {}
                (false, false) => return None,
                (true, false) => {
                    while !is_left_at(cut) {
                        cut = cut.next_down();
                    }
                    left[1] = left[1].min(cut);
                }
                (false, true) => {
                    while !is_left_at(cut) {
                        cut = cut.next_up();
                    }
                    left[0] = left[0].max(cut);
                }
            }
        }
        (left[0] <= left[1]).then_some(left)
    }
}

/// The first share that is not hidden, between one that is and one that is not. Shares lie in [0, 1].
fn first_without(hidden: f64, shown: f64, is_hidden: impl Fn(f64) -> bool) -> f64 {
    // Non-negative floats are ordered as their bits are.
    let [mut hidden, mut shown] = [hidden, shown].map(|share| share.abs().to_bits());
    while hidden.abs_diff(shown) > 1 {
        let middle = hidden.midpoint(shown);
        *if is_hidden(f64::from_bits(middle)) {
            &mut hidden
        } else {
            &mut shown
        } = middle;
    }
    f64::from_bits(shown)
}
