//! Tests a ray against a square or parallelogram in the world. The answer is the ray parameter t of the hit, or none.

use super::{WorldCase, ahead};
use crate::{
    geometry::{Placement, Ray, Square, binary::power_of_two_below},
    scene::Shape,
    study::prelude::*,
};

/// A ray and a square.
#[derive(Clone, Copy, Debug)]
pub struct RaySquare<T> {
    /// Where the ray starts.
    pub origin: V3<T>,
    /// Where it goes; any length.
    pub direction: V3<T>,
    /// The square's middle.
    pub middle: V3<T>,
    /// Its sides.
    pub sides: [V3<T>; 2],
    /// What textbooks precompute for it: the normal at right angles to both sides, and D of the plane's equation:
    /// `normal . middle`, rounded.
    plane: (V3<T>, T),
    /// Precomputed as well: vectors in the plane; a point's scalar products with them are its coordinates along the
    /// sides.
    duals: [V3<T>; 2],
}

impl<T: Real> From<(&Placement, &Ray)> for RaySquare<T> {
    /// A ray, and the square that a model matrix makes of the unit square.
    fn from((placement, ray): (&Placement, &Ray)) -> Self {
        let model = placement.model();
        let [origin, direction, middle, u, v] = [
            ray.origin,
            ray.direction,
            model.translation,
            model.matrix3.x_axis,
            model.matrix3.y_axis,
        ]
        .map(|v| V3::<T>::of(v.into()));
        let normal = u.cross(v);
        let scale = T::one() / normal.dot(normal);
        Self {
            origin,
            direction,
            middle,
            sides: [u, v],
            plane: (normal, normal.dot(middle)),
            duals: [v.cross(normal) * scale, normal.cross(u) * scale],
        }
    }
}

impl<T: Real> RaySquare<T> {
    /// The square's corners, one after the other.
    pub fn rim(&self) -> [V3<T>; 4] {
        let (middle, [u, v]) = (self.middle, self.sides.map(|side| side * T::of(0.5)));
        let [left, right] = [middle - u, middle + u];
        [left - v, right - v, right + v, left + v]
    }
}

/// One ray and one square, whose third axis is the vector product of its sides.
pub type SquareCase = WorldCase<RaySquare<f32>, RaySquare<f64>>;

const POINT: &str = "textbooks and courses: t = N . (S - o) / N . d, then along the sides";
const CONSTANT: &str = "Shirley, Ray Tracing: The Next Week: t = (D - N . o) / N . d with D = N . S, then along the sides";

const OURS: &str = "geometry::square, under a model matrix: undivided, as a filter with an error bound, else exactly";

impl Case for SquareCase {
    type Answer = Option<f64>;
    type Truth = Option<f64>;
    const ABOUT: About = about!(
        "Ray against square" "square", off by "of t", wrong by "px";
        "a ray in the world and a square there: t of the hit"
    );

    const METHODS: Methods<Self> = &[
        &both!("N . (S - o)": POINT, point),
        &both!("D - N . o": CONSTANT, constant),
        &[Method::ours(Precision::Exact, OURS, |c| {
            Square::hit(&c.placement.local_ray(&c.ray)).map(|hit| hit.t)
        })],
    ];
    const FAMILIES: &'static [Family<Self>] = &[
        Family::ordinary(|random, _| aim(random, 1.0, 1.0)),
        Family::HIT_RATE,
        family!("grazing", "angle to the plane (rad)" [1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6] =>
            |random, angle| aim(random, angle, 1.0)),
        family!("far from the origin", "offset / size" [1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7] =>
            |random, offset| aim(random, 1.0, offset)),
        family!("f64 rays", "offset / size" [1.0, 1e3, 1e6] => with_all_digits),
        Family::at_edges(|random, share| {
            if random.unit() < share {
                with_all_digits(random, 1.0)
            } else {
                aim(random, 1.0, 1.0)
            }
        }),
        family!("exactly through the rim", "bits a coordinate" [4.0, 8.0, 12.0, 16.0] =>
            through_the_rim),
    ];

    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        let squares = scene.rays_at(|shape| matches!(shape, Shape::Square));
        let cases = squares.iter();
        let cases = cases.map(|(placement, ray, px)| Self::of_object(placement, ray, *px));
        cases.collect()
    }

    fn truth(&self) -> Option<f64> {
        let case = &self.wide;
        let [middle, u, v] = [case.middle, case.sides[0], case.sides[1]].map(Exact3::new);
        let line = Line::new(case.origin, case.direction);
        truth::first_ahead(line.parallelogram(&middle, [&u, &v]))
    }

    fn judge(&self, truth: &Option<f64>, answer: &Option<f64>) -> Verdict {
        let case = &self.wide;
        let off = || truth::edge_angle(case.origin, case.direction, &case.rim()) / self.px;
        truth::decide(*truth, *answer, truth::relative, off)
    }

    /// Bound of a hit's `t` under a model matrix; whether there is a hit is decided exactly. The inverse's third row is
    /// the normal over the determinant.
    ///
    /// With u = 2^-53: that row is a vector product (3u of its terms' magnitudes) times two scales (3u). The difference
    /// to the plane's point adds u, product and sum 4u, the given normal's own rounding 3u. Numerator and denominator
    /// each err by at most 15u times the sum of all magnitudes, the quotient by u. The determinant is in both and
    /// cancels.
    fn bound(&self, _: &Option<f64>) -> f64 {
        let case = &self.wide;
        let [u, v] = case.sides;
        let (sizes, normal) = (truth::cross_sizes(u, v), u.cross(v));
        let share = |w: V3<f64>| 15.0 * UNIT * sizes.dot(w.abs()) / normal.dot(w).abs();
        let (above, below) = (share(case.middle - case.origin), share(case.direction));
        if !(below < 0.5) {
            return truth::CERTAIN;
        }
        ((above + below + UNIT) / (1.0 - below)).min(truth::CERTAIN)
    }
}

/// Where a ray meets a square's plane.
#[derive(Clone, Copy, Debug)]
pub struct OnPlane<T> {
    /// The ray parameter.
    pub t: T,
    /// The point's coordinates along the sides, from the middle: within 1/2 in the square.
    pub along: [T; 2],
}

impl<T: Real> OnPlane<T> {
    fn at(case: &RaySquare<T>, t: T) -> Self {
        let point = case.origin + case.direction * t - case.middle;
        let along = case.duals.map(|dual| dual.dot(point));
        Self { t, along }
    }

    /// By `N . (S - o) / N . d`.
    pub fn by_point(case: &RaySquare<T>) -> Self {
        let (normal, _) = case.plane;
        let way = normal.dot(case.middle - case.origin);
        Self::at(case, way / normal.dot(case.direction))
    }

    /// Its t, where it is in the square and not behind the ray's start.
    fn hit(&self) -> Option<f64> {
        let half = T::of(Square::HALF_SIDE);
        let [x, y] = self.along.map(T::abs);
        (x <= half && y <= half).then(|| ahead(self.t)).flatten()
    }
}

/// Subtracts the ray's origin first.
pub fn point<T: Real>(case: &RaySquare<T>) -> Option<f64> {
    OnPlane::by_point(case).hit()
}

/// Uses the plane's distance from the world's origin.
pub fn constant<T: Real>(case: &RaySquare<T>) -> Option<f64> {
    let (normal, distance) = case.plane;
    let way = distance - normal.dot(case.origin);
    OnPlane::at(case, way / normal.dot(case.direction)).hit()
}

/// Whole vectors at right angles, each over the power of two that makes it about 1 long.
fn sides(random: &mut Random) -> [V3<f64>; 2] {
    loop {
        let [a, b] = [(); 2].map(|()| random.lattice_point(15));
        let across = a.cross(b);
        if across.dot(across) > 0.0 {
            return [a, across].map(|side| side * (1.0 / power_of_two_below(side.length())));
        }
    }
}

/// The axes of a square with these sides.
fn square(u: V3<f64>, v: V3<f64>) -> M3<f64> {
    M3([u, v, u.cross(v)])
}

/// A square about 1 wide at an offset from the world's origin, and a ray. The ray meets the square's plane in the
/// square or beside it, at about `t = 5` and at about this angle.
fn aim(random: &mut Random, angle: f64, offset: f64) -> SquareCase {
    loop {
        let [u, v] = sides(random);
        let middle = through_f32_each(random.direction() * offset);
        let [x, y] = [(); 2].map(|()| random.within(-0.75, 0.75));
        let target = middle + u * x + v * y;
        let [along, aside] = [(); 2].map(|()| random.within(-1.0, 1.0));
        let within = (u.normalize() * along + v.normalize() * aside).normalize();
        let tilt = angle * random.sign() * random.within(0.5, 1.0);
        let direction = through_f32_each(within + u.cross(v).normalize() * tilt);
        let origin = through_f32_each(target - direction * random.within(4.0, 6.0));
        if let Some(case) = SquareCase::new([origin, direction], square(u, v), middle, PX) {
            return case;
        }
    }
}

/// A ray as a viewer has it, with all of its digits, through a side of a square at an offset from the world's origin, up
/// to rounding.
fn with_all_digits(random: &mut Random, offset: f64) -> SquareCase {
    loop {
        let [u, v] = sides(random);
        let middle = through_f32_each(random.direction() * offset);
        let target = middle + u * (0.5 * random.sign()) + v * random.within(-0.4, 0.4);
        let origin = target + random.direction() * 5.0;
        let ray = [origin, target - origin];
        if let Some(case) = SquareCase::new(ray, square(u, v), middle, PX) {
            return case;
        }
    }
}

/// A ray of whole numbers over a power of two, exactly through a side or a corner.
fn through_the_rim(random: &mut Random, bits: f64) -> SquareCase {
    let limit = two_to(bits);
    loop {
        let [u, v] = sides(random);
        let [middle, step] = [(); 2].map(|()| random.lattice_point(limit));
        let along = f64::from(random.integer(-2, 2)) * 0.25;
        let (x, y) = (0.5 * random.sign(), along);
        let target = middle + u * x + v * y;
        let origin = target - step;
        if through_f32_each(origin) == origin
            && let Some(case) = SquareCase::new([origin, step], square(u, v), middle, PX)
        {
            return case;
        }
    }
}
