//! Transforms a world-space ray into an object's space. The answer is origin and direction there. To judge it, it is
//! transformed back to the world exactly and compared with the given ray.

use super::WorldCase;
use crate::{
    geometry::{LocalRay, Placement, Ray},
    study::prelude::*,
};
use std::hint::black_box;

/// A ray and a model matrix.
#[derive(Clone, Copy, Debug)]
pub struct Placed<T> {
    /// The model matrix's linear part A, by columns.
    pub linear: M3<T>,
    /// Its translation.
    pub translation: V3<T>,
    /// Where the ray starts, in the world.
    pub origin: V3<T>,
    /// Where it goes, in the world.
    pub direction: V3<T>,
    /// The inverse of A, which programs store for each object.
    pub inverse: M3<T>,
    /// The translation of M's inverse: `-inverse(A) T`.
    pub back: V3<T>,
    /// The ray parameter at which an answer is judged: where the ray passes the object's origin, or where it hits.
    pub judged_at: T,
}

impl<T: Real> From<(&Placement, &Ray)> for Placed<T> {
    /// A ray and a model matrix, with its inverse in the same precision.
    fn from((placement, ray): (&Placement, &Ray)) -> Self {
        let model = placement.model();
        let linear = M3::<T>::of(&model.matrix3.into());
        let [translation, origin, direction] =
            [model.translation, ray.origin, ray.direction].map(|v| V3::<T>::of(v.into()));
        let inverse = linear.inverse();
        let to_object = model.translation - ray.origin;
        let passes = to_object.dot(ray.direction) / ray.direction.length_squared();
        Self {
            linear,
            translation,
            origin,
            direction,
            inverse,
            back: -inverse.apply(translation),
            judged_at: T::of(passes),
        }
    }
}

/// One ray and one model matrix.
pub type PlacedCase = WorldCase<Placed<f32>, Placed<f64>>;

const COURSE: &str = "courses: the inverse of the model matrix, direction normalised";
const KEPT: &str = "ray tracing texts: the inverse of the model matrix, direction kept";
const RELATIVE: &str = "the translation first: inverse(A) (o - T)";
const OURS: &str = "geometry::Placement::local_ray: inverse(A) (o - T), with bounds on its errors";

/// Origin and direction in object space.
type ObjectSpaceRay = [V3<f64>; 2];

impl Case for PlacedCase {
    type Answer = ObjectSpaceRay;
    type Truth = ();
    const ABOUT: About = about!(
        "Ray into object space" "object-space", off by "px", wrong by "";
        "a ray in the world and a model matrix with its inverse: origin and direction in object space"
    );

    const METHODS: Methods<Self> = &[
        &both!("inverse(M), normalised": COURSE, by_inverse, true),
        &both!("inverse(M)": KEPT, by_inverse, false),
        &both!("inverse(A) (o - T)": RELATIVE, relative),
        &[
            Method::new("inverse(A) (o - T), then f32", F64, RELATIVE, |c| {
                relative(&c.wide).map(|v| V3::<f32>::of(v).wide())
            }),
            // As a pick makes it: with the bounds of its errors, which later decisions need.
            Method::ours(F64, OURS, |c| {
                let placed = black_box(c.placement.local_ray(&c.ray));
                of(LocalRay::from(&placed).ray)
            }),
        ],
    ];
    const FAMILIES: &'static [Family<Self>] = &[
        Family::ordinary(|random, _| {
            let scale = [(); 3].map(|()| random.within(0.5, 2.0));
            aim(random, scale, 3.0)
        }),
        family!("far from the origin", "translation / distance"
            [1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6] =>
            |random, ratio| aim(random, [1.0; 3], 5.0 * ratio)),
        family!("flattened", "least / largest scale" [1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6] =>
            flattened),
        family!("tiny and huge", "scale"
            [1.0, 1e-2, 1e2, 1e-4, 1e4, 1e-6, 1e6, 1e-8, 1e8, 1e-12, 1e12] =>
            |random, scale| aim(random, [scale; 3], 3.0)),
    ];

    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        let cases = scene.objects().map(|(ray, object, hit)| {
            let t = hit.hit.t;
            let mut case = Self::of_object(&object.placement, ray, scene.px(t));
            case.wide.judged_at = t;
            case
        });
        cases.collect()
    }

    fn truth(&self) {}

    fn judge(&self, (): &(), answer: &ObjectSpaceRay) -> Verdict {
        Verdict::Right(aside(&self.wide, answer) / self.px)
    }

    /// Bound of `inverse(A) (o - T)` with the inverse by cofactors in `f64`, with u = 2^-53.
    ///
    /// Columns are scaled to 1 (2u), a cofactor errs by 3u of its terms' magnitudes, scaling back and the product with
    /// a vector that carries u add 8u. Together that is below 16u of P times the vector, where P is the sum of each
    /// cofactor's |terms| over the determinant. The determinant errs relatively by less than 16u of the sum of its
    /// |terms| over itself, which scales origin and direction alike. |A| takes an error in object space back to the world.
    fn bound(&self, (): &()) -> f64 {
        let case = &self.wide;
        let M3([a, b, c]) = case.linear;
        let rows = [cross_sizes(b, c), cross_sizes(c, a), cross_sizes(a, b)];
        let det = case.linear.determinant().abs();
        let spread = rows[0].dot(a.abs()) / det;
        let back = |v: V3<f64>| {
            let local = rows.map(|row| row.dot(v.abs()) / det);
            let world = a.abs() * local[0] + b.abs() * local[1] + c.abs() * local[2];
            world.length()
        };
        let from = case.origin - case.translation;
        let (d, t) = (case.direction, case.judged_at.abs());
        let error = 16.0 * UNIT * (back(from) + t * back(d) + spread * from.length());
        error / (t * d.length()) / self.px
    }
}

fn of(ray: &Ray) -> ObjectSpaceRay {
    [ray.origin.into(), ray.direction.into()]
}

/// Through the inverse of the whole matrix, whose translation is `-inverse(A) T`.
pub fn by_inverse<T: Real>(case: &Placed<T>, normalise: bool) -> ObjectSpaceRay {
    let mut direction = case.inverse.apply(case.direction);
    if normalise {
        direction = direction.normalize();
    }
    let origin = case.inverse.apply(case.origin) + case.back;
    [origin.wide(), direction.wide()]
}

/// The translation is subtracted first.
pub fn relative<T: Real>(case: &Placed<T>) -> ObjectSpaceRay {
    let origin = case.inverse.apply(case.origin - case.translation);
    [origin.wide(), case.inverse.apply(case.direction).wide()]
}

/// The angle in radians, seen from the world ray's origin, between the world ray and the object-space ray that is
/// transformed back exactly, at the depth of [`Placed::judged_at`]. Infinite where the answer is not finite or has no
/// point at that depth.
pub fn aside(case: &Placed<f64>, local: &[V3<f64>; 2]) -> f64 {
    if !local.iter().all(|v| v.is_finite()) {
        return f64::INFINITY;
    }
    let [x, y, z] = case.linear.0.map(Exact3::new);
    let to_world = |v: V3<f64>| {
        let [a, b, c] = Exact3::new(v).0;
        x.times(&a) + y.times(&b) + z.times(&c)
    };
    let d = Exact3::new(case.direction);
    let to_object = Exact3::new(case.translation) - Exact3::new(case.origin);
    let (start, step) = (to_world(local[0]) + to_object, to_world(local[1]));
    // The transformed ray's point at that depth: `start + s step`, whose product with d is that of the ray's point.
    let fall = step.dot(&d);
    if fall.is_zero() {
        return f64::INFINITY;
    }
    let s = (d.times(&Exact::new(case.judged_at)) - &start).dot(&d) / fall;
    let point = start + step.times(&s);
    let off = point.cross(&d).length();
    let along = point.dot(&d).abs();
    if along.is_zero() {
        return f64::INFINITY;
    }
    (off / along).to_f64()
}

/// Three vectors of about length 1 at right angles: a rotation, half of the time mirrored.
pub(super) fn turned(random: &mut Random) -> [V3<f64>; 3] {
    let [u, v] = random.directions();
    [u, v, u.cross(v) * random.sign()]
}

fn flattened(random: &mut Random, least: f64) -> PlacedCase {
    let mut scale = [1.0, 1.0, least];
    scale.rotate_left(random.below(3));
    aim(random, scale, 3.0)
}

/// An object about as large as its largest scale, at a distance from the world's origin, and a ray past it from 5 units
/// away. If the object is larger than 1, both distances are multiplied by its size.
fn aim(random: &mut Random, scale: [f64; 3], offset: f64) -> PlacedCase {
    loop {
        // Scaled along axes that are special in neither space.
        let [u, v, w] = turned(random);
        let scaled = M3([u * scale[0], v * scale[1], w * scale[2]]);
        let own = turned(random);
        let linear = M3(own.map(|axis| through_f32_each(scaled.apply(axis))));
        let size = scale.into_iter().fold(0.0, f64::max);
        let translation = through_f32_each(random.direction() * (offset * size.max(1.0)));
        let origin = through_f32_each(translation + random.direction() * (5.0 * size.max(1.0)));
        let target = translation + linear.apply(random.point(0.7));
        let direction = through_f32_each((target - origin).normalize());
        if let Some(case) = PlacedCase::new([origin, direction], linear, translation, PX) {
            return case;
        }
    }
}
