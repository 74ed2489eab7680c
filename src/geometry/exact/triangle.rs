//! A ray and a triangle in integers.

use super::{
    super::{
        Placement, Ray, TriangleHit, WorldRay,
        binary::{power_of_two, power_of_two_below},
        local_ray::Exactly,
        ray::Line,
    },
    integer::{Bits, Formula, Integer, solve},
    number::{Number, Vector},
    root::Root,
    world::{Adjugate, ExactLine, point},
};
use glam::DVec3;
use num_bigint::BigInt;
use std::cmp::Ordering;

/// A triangle by its corners about an origin, in the space of a placement.
#[derive(Clone, Copy)]
#[expect(clippy::struct_field_names, reason = "what they are")]
pub(crate) struct Corners<'a> {
    pub placement: Option<&'a Placement>,
    pub origin: DVec3,
    pub corners: [DVec3; 3],
}

impl Corners<'_> {
    fn is_finite(&self) -> bool {
        self.origin.is_finite() && self.corners.iter().all(|corner| corner.is_finite())
    }
}

/// The volumes that a ray spans with a triangle's edges, and where it meets its plane.
#[expect(clippy::struct_field_names, reason = "what they are")]
struct Volumes<I> {
    /// `d . (p x q)` for each edge, the first opposite to the first corner.
    volumes: [Number<I>; 3],
    /// Their sum.
    sum: Number<I>,
    /// `a . (b x c)`: the plane is met where `t` is this over the sum.
    numerator: Number<I>,
}

impl<I: Integer> Volumes<I> {
    fn new(line: &Line, triangle: &Corners) -> Self {
        let line = ExactLine::new(line);
        let seen = (triangle.corners)
            .map(|corner| line.to(&point(triangle.placement, [triangle.origin, corner])));
        let unit = seen.iter().map(|corner| corner.exponent).min().unwrap_or(0);
        let [a, b, c] = seen.map(|corner: Vector<I>| corner.in_unit(unit));
        let volumes = [(&b, &c), (&c, &a), (&a, &b)].map(|(p, q)| p.cross(q));
        let numerator = a.dot(&volumes[0]);
        let volumes = volumes.map(|normal| line.direction.dot(&normal));
        let sum = volumes[0].plus(&volumes[1]).plus(&volumes[2]);
        Self {
            volumes,
            sum,
            numerator,
        }
    }
}

impl Volumes<Bits> {
    fn most_bits(&self) -> u32 {
        let [u, v, w] = &self.volumes;
        Bits::most([u, v, w, &self.sum, &self.numerator].map(|n| n.integer))
    }
}

/// [`hit`].
struct Hit<'a> {
    line: Line,
    triangle: Corners<'a>,
    interval: &'a Ray,
}

impl Formula for Hit<'_> {
    /// The volumes; and whether object space is mirrored, by the sign.
    type Numbers<I: Integer> = (Volumes<I>, [Number<I>; 2], Option<Number<I>>);
    type Answer = Option<TriangleHit>;

    fn numbers<I: Integer>(&self) -> Self::Numbers<I> {
        let volumes = Volumes::new(&self.line, &self.triangle);
        let beyond = [self.interval.t_min, self.interval.t_max].map(|end| {
            let end = Number::new(if end.is_finite() { end } else { 0.0 });
            volumes.numerator.minus(&volumes.sum.times(&end))
        });
        let placed = self
            .triangle
            .placement
            .filter(|placement| !placement.is_identity());
        let determinant =
            placed.map(|placement| Adjugate::new(placement.model().matrix3).determinant);
        (volumes, beyond, determinant)
    }

    fn most_bits((volumes, [near, far], determinant): &Self::Numbers<Bits>) -> u32 {
        let others = [Some(near), Some(far), determinant.as_ref()];
        let others = Bits::most(others.into_iter().flatten().map(|n| n.integer));
        volumes.most_bits().max(others)
    }

    fn answer<I: Integer>(
        &self,
        (of, [after_near, after_far], determinant): Self::Numbers<I>,
    ) -> Self::Answer {
        let any = |sign| of.volumes.iter().any(|volume| volume.sign() == sign);
        let is_negative = any(Ordering::Less);
        // Both signs: it passes by. Neither: it lies in the plane, or the triangle has no area.
        if is_negative == any(Ordering::Greater) {
            return None;
        }
        let turned = |sign: Ordering| if is_negative { sign.reverse() } else { sign };
        let Ray { t_min, t_max, .. } = *self.interval;
        let is_after = |end: f64, sign| {
            if end.is_finite() {
                turned(sign)
            } else {
                0.0_f64.total_cmp(&end)
            }
        };
        if is_after(t_min, after_near.sign()).is_lt() || is_after(t_max, after_far.sign()).is_ge() {
            return None;
        }
        let mirrors = determinant.is_some_and(|determinant| determinant.sign().is_lt());
        let t = of.numerator.ratio(&of.sum);
        // Rounding may have crossed an end of the interval.
        let t = t.max(t_min).min(t_max.next_down());
        Some(TriangleHit {
            t,
            t_error: super::rounding_of(t),
            front: is_negative != mirrors,
            barycentric: of.volumes.each_ref().map(|volume| volume.ratio(&of.sum)),
        })
    }
}

/// The hit by exact arithmetic; `None` also when a number is not finite. `t` and the weights are
/// within three roundings of the exact values.
pub(in super::super) fn hit(
    exactly: &Exactly,
    interval: &Ray,
    origin: DVec3,
    corners: [DVec3; 3],
) -> Option<TriangleHit> {
    let triangle = Corners {
        placement: exactly.placement,
        origin,
        corners,
    };
    let is_finite =
        super::has_interval(interval) && triangle.is_finite() && super::is_finite(&exactly.line);
    let formula = Hit {
        line: exactly.line,
        triangle,
        interval,
    };
    is_finite.then(|| solve(&formula)).flatten()
}

/// Where a ray's line meets a triangle's plane; `None` when it runs along it, or where a number is not finite.
pub(super) fn plane_parameter(line: &Line, triangle: &Corners) -> Option<Root> {
    struct Plane<'a>(&'a Line, &'a Corners<'a>);
    impl Formula for Plane<'_> {
        type Numbers<I: Integer> = Volumes<I>;
        type Answer = [Number<BigInt>; 2];
        fn numbers<I: Integer>(&self) -> Volumes<I> {
            Volumes::new(self.0, self.1)
        }
        fn most_bits(numbers: &Volumes<Bits>) -> u32 {
            numbers.most_bits()
        }
        fn answer<I: Integer>(&self, of: Volumes<I>) -> Self::Answer {
            [of.numerator.to_big(), of.sum.to_big()]
        }
    }
    if !(triangle.is_finite() && super::is_finite(line)) {
        return None;
    }
    let [numerator, denominator] = solve(&Plane(line, triangle));
    Root::quotient(numerator, denominator)
}

/// The weights of a triangle's corners where a ray's line meets its plane, each within three roundings; `None` when it runs
/// along it.
pub(crate) fn weights(ray: &WorldRay, triangle: &Corners) -> Option<[f64; 3]> {
    struct Weights<'a>(&'a Line, &'a Corners<'a>);
    impl Formula for Weights<'_> {
        type Numbers<I: Integer> = Volumes<I>;
        type Answer = Option<[f64; 3]>;
        fn numbers<I: Integer>(&self) -> Volumes<I> {
            Volumes::new(self.0, self.1)
        }
        fn most_bits(numbers: &Volumes<Bits>) -> u32 {
            numbers.most_bits()
        }
        fn answer<I: Integer>(&self, of: Volumes<I>) -> Self::Answer {
            let weights = || of.volumes.each_ref().map(|volume| volume.ratio(&of.sum));
            of.sum.sign().is_ne().then(weights)
        }
    }
    let line = ray.line();
    let is_finite = triangle.is_finite() && super::is_finite(line);
    is_finite.then(|| solve(&Weights(line, triangle))).flatten()
}

/// Which of two triangles' planes a ray's line meets first; equal when it runs along one.
pub(in super::super) fn compare(line: &Line, a: &Corners, b: &Corners) -> Ordering {
    struct Both<'a>(&'a Line, [&'a Corners<'a>; 2]);
    impl Formula for Both<'_> {
        type Numbers<I: Integer> = ([Number<I>; 2], Number<I>);
        type Answer = Ordering;
        fn numbers<I: Integer>(&self) -> Self::Numbers<I> {
            let [a, b] = self.1.map(|triangle| Volumes::<I>::new(self.0, triangle));
            let difference = (a.numerator.times(&b.sum)).minus(&b.numerator.times(&a.sum));
            ([a.sum, b.sum], difference)
        }
        fn most_bits(([a, b], difference): &Self::Numbers<Bits>) -> u32 {
            Bits::most([a, b, difference].map(|n| n.integer))
        }
        fn answer<I: Integer>(&self, (sums, difference): Self::Numbers<I>) -> Ordering {
            let signs = sums.map(|sum| sum.sign());
            match signs {
                [Ordering::Equal, _] | [_, Ordering::Equal] => Ordering::Equal,
                [a, b] if a == b => difference.sign(),
                _ => difference.sign().reverse(),
            }
        }
    }
    let is_finite = a.is_finite() && b.is_finite() && super::is_finite(line);
    if is_finite {
        solve(&Both(line, [a, b]))
    } else {
        Ordering::Equal
    }
}

/// Whether two triangles of one space lie in one plane, by their `f32` corners about one origin; the first must have an
/// area.
pub(crate) fn are_coplanar(a: [DVec3; 3], b: [DVec3; 3]) -> bool {
    struct Plane([DVec3; 3], [DVec3; 3]);
    impl Formula for Plane {
        type Numbers<I: Integer> = [Number<I>; 3];
        type Answer = bool;
        fn numbers<I: Integer>(&self) -> Self::Numbers<I> {
            let [p, q, r] = self.0.map(Vector::<I>::new);
            let normal = q.minus(&p).cross(&r.minus(&p));
            self.1
                .map(|corner| Vector::new(corner).minus(&p).dot(&normal))
        }
        fn most_bits(numbers: &[Number<Bits>; 3]) -> u32 {
            Bits::most(numbers.each_ref().map(|n| n.integer))
        }
        fn answer<I: Integer>(&self, numbers: [Number<I>; 3]) -> bool {
            numbers.iter().all(|n| n.sign().is_eq())
        }
    }
    if a == b {
        return true;
    }
    match short(a.into_iter().chain(b)) {
        Some(points) => are_coplanar_integers(&points),
        None => solve(&Plane(a, b)),
    }
}

/// Six points as integers of 40 bits in one unit; `None` where they are longer.
fn short(points: impl Iterator<Item = DVec3> + Clone) -> Option<[[i64; 3]; 6]> {
    const MOST: f64 = power_of_two(40);
    let largest = (points.clone()).fold(0.0, |most: f64, p| most.max(p.abs().max_element()));
    let scale = MOST / power_of_two_below(largest) * 0.5;
    let mut integers = [[0; 3]; 6];
    for (integers, point) in integers.iter_mut().zip(points) {
        for (integer, c) in integers.iter_mut().zip((point * scale).to_array()) {
            // Written so that NaN is refused.
            if !(c.abs() <= MOST && c.fract() == 0.0) {
                return None;
            }
            #[expect(clippy::cast_possible_truncation, reason = "a whole number of 40 bits")]
            let whole = c as i64;
            *integer = whole;
        }
    }
    Some(integers)
}

/// Products of three differences have 126 bits.
fn are_coplanar_integers([p, q, r, others @ ..]: &[[i64; 3]; 6]) -> bool {
    let from_p = |c: &[i64; 3]| [0, 1, 2].map(|i| i128::from(c[i] - p[i]));
    let (u, v) = (from_p(q), from_p(r));
    let normal = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| u[i] * v[j] - u[j] * v[i]);
    others.iter().all(|corner| {
        let way = from_p(corner);
        way[0] * normal[0] + way[1] * normal[1] + way[2] * normal[2] == 0
    })
}

/// Whether a ray's line meets a triangle's plane within an interval and no later than `limit`, or runs along it.
pub(in super::super) fn reaches_plane(
    line: &Line,
    triangle: &Corners,
    interval: &Ray,
    limit: f64,
) -> bool {
    plane_parameter(line, triangle).is_none_or(|t| {
        t.compare_to(interval.t_min).is_ge()
            && t.compare_to(interval.t_max).is_lt()
            && t.compare_to(limit).is_le()
    })
}

/// How far volumes that were computed, of a ray that is exact as it stands, are from the exact ones.
#[cfg(test)]
pub(in super::super) fn volume_errors(
    ray: &Ray,
    origin: DVec3,
    corners: [DVec3; 3],
    computed: [f64; 3],
) -> [f64; 3] {
    let line = Line::Given {
        origin: ray.origin,
        direction: ray.direction,
    };
    let triangle = Corners {
        placement: None,
        origin,
        corners,
    };
    let volumes = Volumes::<BigInt>::new(&line, &triangle).volumes;
    [0, 1, 2].map(|i| {
        let error = volumes[i].minus(&Number::new(computed[i]));
        error.ratio(&Number::new(1.0)).abs()
    })
}
