//! The point nearest to the origin of a conic that is kept by half-planes.

use glam::DVec2;
use std::f64::consts::TAU;

/// Directions in which the conic is looked for, before the nearest ones are refined.
const DIRECTIONS: u32 = 256;
/// Each step of a golden section keeps 0.618 of a range: as many steps as turn one direction's share of a turn into
/// less than 1e-9. Distances near the least one differ by the square of that.
const STEPS: u32 = 40;

/// Where `constant + linear . p + p . (square p)` is 0. The origin lies inside: `constant` is not negative, and each ray
/// from there meets the conic's own branch once or not at all, before any other branch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Conic {
    pub constant: f64,
    pub linear: DVec2,
    /// The factors of x^2, x y and y^2.
    pub square: [f64; 3],
}

/// Where `constant + linear . p` is not negative.
#[derive(Clone, Copy, Debug)]
pub(super) struct HalfPlane {
    pub constant: f64,
    pub linear: DVec2,
}

impl HalfPlane {
    fn keeps(&self, p: DVec2) -> bool {
        self.constant + self.linear.dot(p) >= 0.0
    }
}

impl Conic {
    /// The distance from the origin to the nearest point that all half-planes keep; `None` where they keep none.
    ///
    /// That point is one of those where the distance is least among all about it, or one where the conic crosses the
    /// border of a half-plane. As `r(angle)` has few and wide minima, a search along the circle of directions finds
    /// them: 1 / r is a linear form of the direction plus the root of a quadratic one.
    pub fn distance(&self, half_planes: &[HalfPlane]) -> Option<f64> {
        let are_kept = |p: &DVec2| half_planes.iter().all(|half_plane| half_plane.keeps(*p));
        let nearest = self.nearest_about().into_iter().filter(are_kept);
        let ends = half_planes.iter().enumerate().flat_map(|(at, border)| {
            let others = move |p: &DVec2| {
                let mut others = half_planes.iter().enumerate().filter(|(i, _)| *i != at);
                others.all(|(_, half_plane)| half_plane.keeps(*p))
            };
            self.crossings(border).into_iter().flatten().filter(others)
        });
        let distances = nearest.chain(ends).map(DVec2::length);
        distances.filter(|px| px.is_finite()).reduce(f64::min)
    }

    /// The points that are nearer than those about them.
    fn nearest_about(&self) -> Vec<DVec2> {
        let step = TAU / f64::from(DIRECTIONS);
        let nearness = |angle: f64| self.nearness(direction(angle));
        let all: Vec<f64> = (0..DIRECTIONS)
            .map(|i| nearness(f64::from(i) * step))
            .collect();
        let before = all.iter().cycle().skip(all.len() - 1);
        let after = all.iter().cycle().skip(1);
        let mut found = Vec::new();
        for ((i, here), (before, after)) in (0..DIRECTIONS).zip(&all).zip(before.zip(after)) {
            if *here > 0.0 && here >= before && here >= after {
                let angle = greatest(nearness, f64::from(i) * step, step);
                found.push(direction(angle) / nearness(angle));
            }
        }
        found
    }

    /// 1 / r, where r is the distance to the conic in a direction; 0 where it does not lie there.
    fn nearness(&self, direction: DVec2) -> f64 {
        let [constant, linear, square] = self.along(DVec2::ZERO, direction);
        let root = (linear * linear - 4.0 * square * constant).sqrt();
        // Of two forms of the same number, the one in which nothing cancels. A root that is none is NaN, and `max` drops
        // it.
        let twice = if linear > 0.0 {
            -4.0 * square / (linear + root)
        } else {
            (root - linear) / constant
        };
        (0.5 * twice).max(0.0)
    }

    /// Where the conic crosses the border of a half-plane.
    fn crossings(&self, border: &HalfPlane) -> [Option<DVec2>; 2] {
        let length = border.linear.length();
        if length == 0.0 {
            return [None; 2];
        }
        let across = border.linear / length;
        let (foot, along) = (-border.constant / length * across, across.perp());
        let [constant, linear, square] = self.along(foot, along);
        let root = (linear * linear - 4.0 * square * constant).sqrt();
        let sum = -0.5 * (linear + root.copysign(linear));
        let at = |s: f64| s.is_finite().then(|| foot + s * along);
        [at(sum / square), at(constant / sum)]
    }

    /// The factors of 1, s and s^2 of the conic's form at `from + s direction`.
    fn along(&self, from: DVec2, direction: DVec2) -> [f64; 3] {
        let [xx, xy, yy] = self.square;
        let times = |p: DVec2| DVec2::new(xx * p.x + 0.5 * xy * p.y, 0.5 * xy * p.x + yy * p.y);
        [
            self.constant + from.dot(self.linear + times(from)),
            direction.dot(self.linear + 2.0 * times(from)),
            direction.dot(times(direction)),
        ]
    }
}

fn direction(angle: f64) -> DVec2 {
    DVec2::new(libm::cos(angle), libm::sin(angle))
}

/// Where a function that has one maximum within `middle +- reach` is greatest, by golden sections.
fn greatest(of: impl Fn(f64) -> f64, middle: f64, reach: f64) -> f64 {
    const KEPT: f64 = 0.618_033_988_749_894_8;
    let (mut from, mut to) = (middle - reach, middle + reach);
    let inner = |from: f64, to: f64| [to - KEPT * (to - from), from + KEPT * (to - from)];
    let mut at = inner(from, to);
    let mut values = at.map(&of);
    for _ in 0..STEPS {
        if values[0] > values[1] {
            to = at[1];
            let next = inner(from, to)[0];
            (at, values) = ([next, at[0]], [of(next), values[0]]);
        } else {
            from = at[0];
            let next = inner(from, to)[1];
            (at, values) = ([at[1], next], [values[1], of(next)]);
        }
    }
    0.5 * (from + to)
}
