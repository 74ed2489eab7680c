//! Intersects a ray with a triangle exactly: in pairs of `f64` where they leave no doubt, else in integers.

use super::{
    super::{
        Placement, Ray, TriangleHit,
        interval::{Approximate, InDoubt},
        line::Line,
    },
    enclosure::Enclosure,
    exact_line::ExactLine,
    integer::{Bits, Decided, Formula, Integer, Ring, solve},
    number::{Difference, Number, Ratio, Vector},
    point::{point, way},
    root::{Root, rounding_of},
};
use glam::DVec3;
use std::cmp::Ordering;

/// A triangle by its corners about an origin, in the space of a placement.
#[derive(Clone, Copy)]
#[expect(clippy::struct_field_names, reason = "what they are")]
pub(crate) struct Corners<'a> {
    pub placement: Option<&'a Placement>,
    pub origin: DVec3,
    pub corners: [DVec3; 3],
}

impl<'a> Corners<'a> {
    pub fn new(placement: Option<&'a Placement>, origin: DVec3, corners: [DVec3; 3]) -> Self {
        Self {
            placement,
            origin,
            corners,
        }
    }

    /// Whether both have their corners about one origin of one object space.
    pub fn shares_space(&self, other: &Self) -> bool {
        self.origin == other.origin && self.placement == other.placement
    }

    pub fn is_finite(&self) -> bool {
        self.origin.is_finite() && self.corners.iter().all(|corner| corner.is_finite())
    }
}

/// The barycentric weights where a ray meets a triangle's plane, not normalised: their sum has the sign of
/// `direction . normal` (Moeller & Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", JGT 2(1), 1997).
struct Weights<I> {
    corners: [Number<I>; 3],
    sum: Number<I>,
}

/// A triangle as a ray sees it.
pub(super) struct Seen<I> {
    pub line: ExactLine<I>,
    /// From the ray's origin to the first corner, times the ray's weight.
    corner: Vector<I>,
    /// From the second corner to the first, and on to the third.
    edges: [Vector<I>; 2],
    /// `t` where the ray meets the plane. The ray runs along the plane if the denominator is 0.
    pub plane: Ratio<I>,
}

impl<I: Ring> Seen<I> {
    pub fn new(line: &Line, triangle: &Corners) -> Self {
        let line = ExactLine::new(line);
        let (placement, [a, b, c]) = (triangle.placement, triangle.corners);
        let corner = line.to(&point(placement, [triangle.origin, a]));
        let edges = [[b, a], [a, c]].map(|[from, to]| way(placement, from, to));
        let normal = edges[1].cross(&edges[0]);
        let plane = Ratio {
            numerator: corner.dot(&normal),
            denominator: line.direction.dot(&normal),
        };
        Self {
            line,
            corner,
            edges,
            plane,
        }
    }

    fn weights(&self) -> Weights<I> {
        let moment = self.corner.cross(&self.line.direction);
        let [c, b] = self.edges.each_ref().map(|edge| edge.dot(&moment));
        let sum = self.plane.denominator.times(&self.line.weight);
        Weights {
            corners: [sum.minus(&b).minus(&c), b, c],
            sum,
        }
    }
}

impl<I: Integer> Ratio<I> {
    fn root(&self) -> Option<Root> {
        Root::quotient(self.numerator.to_big(), self.denominator.to_big())
    }
}

impl<I: Decided> Weights<I> {
    /// The quotients, each within three roundings.
    fn rounded(&self) -> Result<[f64; 3], InDoubt> {
        let [a, b, c] = (self.corners.each_ref()).map(|weight| weight.decided_ratio(&self.sum));
        Ok([a?, b?, c?])
    }
}

impl Ratio<Bits> {
    fn most_bits(&self) -> u32 {
        Bits::most([&self.numerator, &self.denominator].map(|n| n.integer))
    }
}

impl Weights<Bits> {
    fn most_bits(&self) -> u32 {
        Bits::most(self.corners.each_ref().map(|n| n.integer))
    }
}

/// The formula of [`hit`].
struct Hit<'a> {
    line: Line<'a>,
    triangle: Corners<'a>,
    interval: &'a Ray,
}

impl Formula for Hit<'_> {
    type Numbers<I: Ring> = (Ratio<I>, Weights<I>);
    type Answer = Option<TriangleHit>;

    fn numbers<I: Ring>(&self) -> Self::Numbers<I> {
        let seen = Seen::new(&self.line, &self.triangle);
        let weights = seen.weights();
        (seen.plane, weights)
    }

    fn most_bits((plane, weights): &Self::Numbers<Bits>) -> u32 {
        plane.most_bits().max(weights.most_bits())
    }

    fn answer<I: Integer>(&self, (plane, weights): Self::Numbers<I>) -> Self::Answer {
        let counts = || Ok(plane.root().is_some_and(|t| t.is_within(self.interval)));
        let hit = self.decide(&plane, &weights, counts);
        hit.expect("integers are decided")
    }
}

impl Hit<'_> {
    /// What the numbers say. `counts` says whether the exact parameter is within the interval.
    fn decide<I: Decided>(
        &self,
        plane: &Ratio<I>,
        weights: &Weights<I>,
        counts: impl FnOnce() -> Result<bool, InDoubt>,
    ) -> Result<Option<TriangleHit>, InDoubt> {
        let signs = weights.corners.each_ref().map(Number::decided_sign);
        let [is_negative, is_positive] =
            [Ordering::Less, Ordering::Greater].map(|sign| signs.contains(&Ok(sign)));
        // A miss, whatever the third sign.
        if is_negative && is_positive {
            return Ok(None);
        }
        for sign in signs {
            sign?;
        }
        // The ray lies in the plane, or the triangle has no area.
        if !is_negative && !is_positive {
            return Ok(None);
        }
        let t = plane.numerator.decided_ratio(&plane.denominator)?;
        let rounded = Approximate::new(t, rounding_of(t));
        let is_within = rounded.is_within(self.interval);
        if !is_within.or_else(|InDoubt| counts())? {
            return Ok(None);
        }
        let mirrors = self.triangle.placement.is_some_and(Placement::mirrors);
        Ok(Some(TriangleHit {
            t: self.interval.kept_within(t),
            t_error: rounded.error,
            front: is_negative != mirrors,
            barycentric: weights.rounded()?,
        }))
    }

    /// The answer where pairs of `f64` suffice.
    fn enclosed(&self) -> Result<Option<TriangleHit>, InDoubt> {
        let (plane, weights) = self.numbers::<Enclosure>();
        self.decide(&plane, &weights, || Err(InDoubt))
    }
}

/// The hit by exact arithmetic; `None` also when a number is not finite. `t` and the weights are within three roundings
/// of the exact values.
pub(in super::super) fn hit(line: Line, interval: &Ray, triangle: Corners) -> Option<TriangleHit> {
    if !(interval.has_interval() && triangle.is_finite() && line.is_finite()) {
        return None;
    }
    let formula = Hit {
        line,
        triangle,
        interval,
    };
    (formula.enclosed()).unwrap_or_else(|InDoubt| solve(&formula))
}

/// Where a ray's line meets a triangle's plane; `None` if it runs along it, or a number is not finite.
pub(super) fn plane_parameter(line: &Line, triangle: &Corners) -> Option<Root> {
    struct Parameter<'a>(&'a Line<'a>, &'a Corners<'a>);
    impl Formula for Parameter<'_> {
        type Numbers<I: Ring> = Ratio<I>;
        type Answer = Option<Root>;
        fn numbers<I: Ring>(&self) -> Ratio<I> {
            Seen::new(self.0, self.1).plane
        }
        fn most_bits(plane: &Ratio<Bits>) -> u32 {
            plane.most_bits()
        }
        fn answer<I: Integer>(&self, plane: Ratio<I>) -> Self::Answer {
            plane.root()
        }
    }
    if triangle.is_finite() && line.is_finite() {
        solve(&Parameter(line, triangle))
    } else {
        None
    }
}

/// The barycentric weights where a ray's line meets a triangle's plane, each within three roundings; `None` if the line
/// runs along the plane.
pub(super) fn weights(line: &Line, triangle: &Corners) -> Option<[f64; 3]> {
    struct Rounded<'a>(&'a Line<'a>, &'a Corners<'a>);
    impl Formula for Rounded<'_> {
        type Numbers<I: Ring> = Weights<I>;
        type Answer = Option<[f64; 3]>;
        fn numbers<I: Ring>(&self) -> Weights<I> {
            Seen::new(self.0, self.1).weights()
        }
        fn most_bits(weights: &Weights<Bits>) -> u32 {
            weights.most_bits()
        }
        fn answer<I: Integer>(&self, weights: Weights<I>) -> Self::Answer {
            let has_sum = weights.sum.sign().is_ne();
            has_sum.then(|| weights.rounded().expect("integers are decided"))
        }
    }
    if !(triangle.is_finite() && line.is_finite()) {
        return None;
    }
    let enclosed = Seen::<Enclosure>::new(line, triangle).weights().rounded();
    enclosed.map_or_else(|InDoubt| solve(&Rounded(line, triangle)), Some)
}

/// The formula of [`compare`].
struct Both<'a>(&'a Line<'a>, [&'a Corners<'a>; 2]);

impl Formula for Both<'_> {
    type Numbers<I: Ring> = Difference<I>;
    type Answer = Ordering;

    fn numbers<I: Ring>(&self) -> Difference<I> {
        let planes = (self.1).map(|triangle| Seen::<I>::new(self.0, triangle).plane);
        Difference::new(planes.each_ref())
    }

    fn most_bits(difference: &Difference<Bits>) -> u32 {
        Bits::most([difference.product.integer])
    }

    fn answer<I: Integer>(&self, difference: Difference<I>) -> Ordering {
        Self::decide(&difference).expect("integers are decided")
    }
}

impl Both<'_> {
    fn decide<I: Decided>(difference: &Difference<I>) -> Result<Ordering, InDoubt> {
        Ok(difference.decided_order()?.unwrap_or(Ordering::Equal))
    }

    /// The answer where pairs of `f64` suffice.
    fn enclosed(&self) -> Result<Ordering, InDoubt> {
        Self::decide(&self.numbers::<Enclosure>())
    }
}

/// Which of two triangles' planes a ray's line meets first; equal if it runs along one, or a number is not finite.
pub(in super::super) fn compare(line: &Line, a: &Corners, b: &Corners) -> Ordering {
    let is_finite = a.is_finite() && b.is_finite() && line.is_finite();
    if !is_finite {
        return Ordering::Equal;
    }
    let both = Both(line, [a, b]);
    both.enclosed().unwrap_or_else(|InDoubt| solve(&both))
}

/// Whether a ray's line meets a triangle's plane within an interval and no later than `limit`. Also true if it runs
/// along the plane, or a number is not finite.
pub(in super::super) fn reaches_plane(
    line: &Line,
    triangle: &Corners,
    interval: &Ray,
    limit: f64,
) -> bool {
    plane_parameter(line, triangle)
        .is_none_or(|t| t.is_within(interval) && t.compare_to(limit).is_le())
}

#[cfg(test)]
mod tests;
