//! Rays against the cube of side 1 about the origin. The answer is the least t >= 0 on it (the entry; from inside, the
//! exit), or none. Methods differ for a ray that runs along a slab's plane, where `0 * inf` is NaN.

use super::{ObjectRay, ShapeCase, first_ahead};
use crate::{geometry::Cuboid, scene::Shape, study::prelude::*};

/// One ray and the cube.
pub type BoxCase = ShapeCase<Cuboid>;

const BRANCH: &str = "textbooks and courses: slabs, with a branch where the ray runs along one";
const KAY: &str = "Kay & Kajiya, Ray Tracing Complex Scenes, SIGGRAPH 1986";
const BARNES: &str = "Barnes, Fast, branchless ray/bounding box intersections, part 2, 2015";
const MAJERCIK: &str =
    "Majercik, Crassin, Shirley & McGuire, A Ray-Box Intersection Algorithm, JCGT 7(3), 2018";
const OURS: &str = "geometry::cuboid: slabs as a filter with error bounds, else exactly";

impl Case for BoxCase {
    type Answer = Option<f64>;
    type Truth = Option<f64>;
    const ABOUT: About = about!(
        "Ray against box" "box", off by "of t", wrong by "px";
        "a ray in the cube's space: t of the first hit"
    );

    const METHODS: Methods<Self> = &[
        &both!("slabs with a branch": BRANCH, branch),
        &both!("slabs by min and max": KAY, min_max),
        &both!("slabs, NaN never wins": BARNES, nan_safe),
        &both!("Majercik's": MAJERCIK, majercik),
        &[Method::ours(Precision::Exact, OURS, |c: &Self| {
            let [near, far] = Cuboid::hits(&c.ray);
            near.or(far).map(|hit| hit.t)
        })],
    ];
    const FAMILIES: &'static [Family<Self>] = &[
        Family::ordinary(|random, _| ordinary(random)),
        Family::HIT_RATE,
        family!("aimed at edges", "distance / size" [2.0, 1e1, 1e2, 1e3, 1e4, 1e5] => at_edge),
        family!("f64 rays", "distance / size" [2.0, 1e2, 1e4] => |random, distance| {
            let target = on_edge(random);
            let origin = target + random.direction() * distance;
            // Scaled, so that few rays pass exactly through an edge.
            case(origin, (target - origin) * random.within(0.5, 1.0))
        }),
        family!("starts on a slab", "axes that it runs along" [1.0, 2.0] => on_slab),
        family!("thin", "thickness / width" [1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6] => thin),
        family!("exactly through edges", "bits a coordinate" [4.0, 8.0, 12.0, 16.0, 20.0] =>
            on_a_lattice),
    ];

    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        Self::of_shapes(scene, |shape| matches!(shape, Shape::Cube))
    }

    fn truth(&self) -> Option<f64> {
        let ObjectRay { origin, direction } = self.wide;
        let half = Exact::new(Cuboid::HALF_SIDE);
        truth::first_ahead(Line::new(origin, direction).cube(&half))
    }

    /// The error is relative to the truth. Where the truth is 0, the error is the answer itself.
    fn judge(&self, truth: &Option<f64>, answer: &Option<f64>) -> Verdict {
        let error = |truth: f64, answer: f64| match truth {
            0.0 => answer.abs(),
            _ => truth::relative(truth, answer),
        };
        let off = || edge_angle(&self.wide, *truth) / self.px;
        truth::decide(*truth, *answer, error, off)
    }

    /// The distance to a plane, the direction's reciprocal and their product round once each.
    fn bound(&self, _: &Option<f64>) -> f64 {
        4.0 * UNIT
    }
}

/// The entry, or the exit where the start is inside.
fn first<T: Real>(enter: T, leave: T) -> Option<f64> {
    (enter <= leave)
        .then(|| first_ahead(enter, leave))
        .flatten()
}

/// The two planes of a slab.
fn planes<T: Real>() -> [T; 2] {
    [-Cuboid::HALF_SIDE, Cuboid::HALF_SIDE].map(T::of)
}

/// The values of t between which a ray is inside one slab, by its start and its direction along the slab's axis. A ray
/// along the slab is inside at any t, or at none: then the first is above the second.
pub fn slab<T: Real>(origin: T, direction: T) -> [T; 2] {
    let [min, max] = planes();
    if direction == T::zero() {
        let always = [T::neg_infinity(), T::infinity()];
        let is_outside = origin < min || origin > max;
        return if is_outside {
            [always[1], always[0]]
        } else {
            always
        };
    }
    let (near, far) = ((min - origin) / direction, (max - origin) / direction);
    if near > far { [far, near] } else { [near, far] }
}

/// Divides nothing for a ray along a slab: such a ray is inside the slab or misses.
pub fn branch<T: Real>(case: &ObjectRay<T>) -> Option<f64> {
    let (mut enter, mut leave) = (T::neg_infinity(), T::infinity());
    for axis in 0..3 {
        let [near, far] = slab(case.origin[axis], case.direction[axis]);
        enter = enter.max(near);
        leave = leave.min(far);
    }
    first(enter, leave)
}

/// Uses no branch, but Rust's `min` and `max`. These ignore a NaN and take the slab's other plane alone.
pub fn min_max<T: Real>(case: &ObjectRay<T>) -> Option<f64> {
    let (mut enter, mut leave) = (T::neg_infinity(), T::infinity());
    for axis in 0..3 {
        let inverse = T::one() / case.direction[axis];
        let [min, max] = planes::<T>();
        let a = (min - case.origin[axis]) * inverse;
        let b = (max - case.origin[axis]) * inverse;
        enter = enter.max(a.min(b));
        leave = leave.min(a.max(b));
    }
    first(enter, leave)
}

/// Compares in an order in which NaN never wins, so a ray within a slab's plane is inside that slab.
pub fn nan_safe<T: Real>(case: &ObjectRay<T>) -> Option<f64> {
    let (mut enter, mut leave) = (T::neg_infinity(), T::infinity());
    for axis in 0..3 {
        let inverse = T::one() / case.direction[axis];
        let [min, max] = planes::<T>().map(|plane| plane - case.origin[axis]);
        let (near, far) = if inverse.is_sign_negative() {
            (max, min)
        } else {
            (min, max)
        };
        let (near, far) = (near * inverse, far * inverse);
        if near > enter {
            enter = near;
        }
        if far < leave {
            leave = far;
        }
    }
    first(enter, leave)
}

/// Tests three planes in turn and returns the first hit within a face's rim. The planes are those that face the ray or,
/// from inside, the other three.
pub fn majercik<T: Real>(case: &ObjectRay<T>) -> Option<f64> {
    let (o, d, half) = (case.origin, case.direction, T::of(Cuboid::HALF_SIDE));
    let size = o.abs();
    let is_inside = size.x.max(size.y).max(size.z) < half;
    let plane = if is_inside { half } else { -half };
    let test = |axis: usize| {
        let t = (plane * d[axis].signum() - o[axis]) / d[axis];
        let is_within = |other: usize| (o[other] + d[other] * t).abs() < half;
        (t >= T::zero() && is_within((axis + 1) % 3) && is_within((axis + 2) % 3)).then_some(t)
    };
    let t = test(0).or_else(|| test(1)).or_else(|| test(2))?;
    Some(t.wide())
}

/// The least change of the ray that makes `hit` wrong, in radians seen from its origin: to the nearest edge, or out of
/// the face that the ray runs along.
fn edge_angle(case: &ObjectRay<f64>, hit: Option<f64>) -> f64 {
    let half = Cuboid::HALF_SIDE;
    let corner = |i: usize| {
        let side = |bit: usize| if i & bit == 0 { -half } else { half };
        V3::new(side(1), side(2), side(4))
    };
    let edges = (0..8).flat_map(|i| [1, 2, 4].map(|bit| (i, i | bit)));
    let edges = edges.filter(|(from, to)| from != to);
    let angles = edges.map(|(from, to)| {
        truth::segment_angle(case.origin, case.direction, corner(from), corner(to))
    });
    let nearest = angles.fold(f64::INFINITY, f64::min);
    let along = (0..3).filter(|&axis| hit.is_some() && case.direction[axis] == 0.0);
    along
        .map(|axis| (case.origin[axis].abs() - half).abs() / case.origin.length())
        .fold(nearest, f64::min)
}

fn ordinary(random: &mut Random) -> BoxCase {
    let target = random.point(0.8);
    let towards = random.direction();
    aim(target, towards * 3.5)
}

fn at_edge(random: &mut Random, distance: f64) -> BoxCase {
    let target = on_edge(random);
    aim(target, random.direction() * distance)
}

/// A thin box in the world is a cube in its own space, where rays are steep.
fn thin(random: &mut Random, thickness: f64) -> BoxCase {
    let size = random.decades(-8, 0);
    let target = on_edge(random) + random.point(size);
    let mut back = random.direction() * 5.0;
    back.y /= thickness;
    aim(target, back)
}

fn on_edge(random: &mut Random) -> V3<f64> {
    let along = random.below(3);
    let mut coordinate = |axis: usize| {
        let (inner, end) = (2.0 * random.unit() - 1.0, random.sign());
        0.5 * if axis == along { inner } else { end }
    };
    V3::new(coordinate(0), coordinate(1), coordinate(2))
}

fn aim(target: V3<f64>, back: V3<f64>) -> BoxCase {
    let origin = through_f32_each(target + back);
    case(origin, through_f32_each(target - origin))
}

fn case(origin: V3<f64>, direction: V3<f64>) -> BoxCase {
    BoxCase::new(origin, direction, PX)
}

/// A ray that starts on the plane of a slab and runs within it, along one axis or in two.
fn on_slab(random: &mut Random, along: f64) -> BoxCase {
    let target = random.point(0.8);
    let axis = random.below(3);
    let plane = 0.5 * random.sign();
    let zero = if random.sign() < 0.0 { -0.0 } else { 0.0 };
    let towards = random.direction();
    let set = |v: V3<f64>, at: usize, value: f64| {
        let mut coordinates = v.array();
        coordinates[at] = value;
        V3::from(coordinates)
    };
    let mut direction = set(through_f32_each(towards), axis, zero);
    if along > 1.5 {
        direction = set(direction, (axis + 1) % 3, zero);
    }
    let start = set(through_f32_each(target - direction * 3.5), axis, plane);
    case(start, direction)
}

/// A ray of whole numbers over a power of two, exactly through an edge or a corner.
fn on_a_lattice(random: &mut Random, bits: f64) -> BoxCase {
    let limit = two_to(bits);
    let half = f64::from(limit);
    let along = f64::from(random.integer(-2, 2)) * 0.5 * half;
    let mut target = [half * random.sign(), half * random.sign(), along];
    target.rotate_left(random.below(3));
    let mut step = random.lattice_point(limit);
    if step == V3::new(0.0, 0.0, 0.0) {
        step.x = 1.0;
    }
    case((V3::from(target) - step) * (0.5 / half), step)
}
