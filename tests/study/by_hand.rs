//! The study's truth and workloads are right on cases that can be checked by hand.

use glam::dvec2;
use sightline::study::{
    exact::{Exact, Exact3, angle},
    methods::{
        ObjectRay, ShapeCase,
        boxes::BoxCase,
        clipping::ClipCase,
        normals::{NormalCase, Tilted},
        object_space::{self, Placed, PlacedCase},
        rays::PixelCase,
        spheres::{SphereCase, outline_angle},
        squares::{RaySquare, SquareCase},
        triangles::{RayTriangle, TriangleCase},
    },
    random::Random,
    real::{M3, Real, V3},
    step::{AT_EDGES, Case},
    truth,
};
use std::cmp::Ordering;

const fn v(x: f64, y: f64, z: f64) -> V3<f64> {
    V3::new(x, y, z)
}

#[test]
fn exact_numbers_keep_every_bit() {
    let [large, small] = [1e300, 1e-300].map(Exact::new);
    assert_eq!((&(&large + &small) - &large), small, "600 decimals apart");
    let third = &Exact::int(1) / &Exact::int(3);
    let off = (&(&third * &Exact::int(3)) - &Exact::int(1)).abs();
    assert!(
        off.to_f64() < 1e-90 && !off.is_zero(),
        "320 bits, not more: {off:?}"
    );
    let two = Exact::int(2).sqrt();
    assert!((&(&two * &two) - &Exact::int(2)).abs().to_f64() < 1e-90);
    assert_eq!((-Exact::new(0.1)).sign(), Ordering::Less);
    assert_eq!(Exact::new(0.1).to_f64(), 0.1);
    let x = Exact3::new(v(1.0, 0.0, 0.0));
    assert_eq!(angle(&x, [1.0, 1e-20, 0.0]), 1e-20, "where f64 would say 0");
    assert_eq!(angle(&x, [-1.0, 0.0, 0.0]), std::f64::consts::PI);
    assert_eq!(angle(&x, [f64::NAN, 0.0, 0.0]), f64::INFINITY);
}

#[test]
fn truth_agrees_with_hand_cases() {
    let corners = [v(0.0, 0.0, 5.0), v(1.0, 0.0, 5.0), v(0.0, 1.0, 5.0)];
    let triangle = |x: f64, y: f64| RayTriangle {
        origin: v(x, y, 0.0),
        direction: v(0.0, 0.0, 2.0),
        corners,
    };
    let t = |x: f64, y: f64| triangle(x, y).truth();
    assert_eq!(t(0.25, 0.25), Some(2.5));
    assert_eq!(t(0.5, 0.5), Some(2.5), "an edge belongs to it");
    assert_eq!(t(0.0, 0.0), Some(2.5), "a corner, too");
    assert_eq!(t(0.25, -1e-12), None);
    let outside = triangle(0.25, -1e-12).edge_angle();
    assert!((outside / 2e-13 - 1.0).abs() < 1e-9, "{outside:?}");

    let sphere = |y: f64| SphereCase::new(v(0.0, y, -2.0), v(0.0, 0.0, 0.5), 1.0).truth();
    assert_eq!(sphere(0.0), Some(3.0));
    assert_eq!(sphere(0.5), Some(4.0), "a touch is a hit");
    assert_eq!(sphere(0.5_f64.next_up()), None);
    let beside = outline_angle(&ObjectRay {
        origin: v(0.0, 0.5 + 1e-9, -2.0),
        direction: v(0.0, 0.0, 0.5),
    });
    assert!((beside / 5e-10 - 1.0).abs() < 1e-6, "{beside}");

    let cube = |origin: V3<f64>, direction: V3<f64>| BoxCase::new(origin, direction, 1.0).truth();
    assert_eq!(cube(v(-1.5, 0.0, 0.0), v(1.0, 0.0, 0.0)), Some(1.0));
    assert_eq!(
        cube(v(0.0, 0.0, 0.0), v(1.0, 0.0, 0.0)),
        Some(0.5),
        "from inside: the exit"
    );
    assert_eq!(
        cube(v(0.5, -1.5, 0.0), v(0.0, 0.5, 0.0)),
        Some(2.0),
        "within a face"
    );
    let beside = v(0.5_f64.next_up(), -1.5, 0.0);
    assert_eq!(cube(beside, v(0.0, 0.5, 0.0)), None);
    assert_eq!(
        cube(v(-1.5, -0.5, 0.0), v(0.5, 0.5, 0.0)),
        Some(2.0),
        "from below onto a face"
    );
    assert_eq!(cube(v(-1.5, 0.5, 0.0), v(0.5, 0.5, 0.0)), None);

    // 4 wide and 2 high, facing -x and 6 away.
    let axes = M3([v(0.0, 0.0, 4.0), v(0.0, 2.0, 0.0), v(-8.0, 0.0, 0.0)]);
    let square = |y: f64, z: f64| {
        let ray = [v(1.0, y, z), v(2.0, 0.0, 0.0)];
        SquareCase::new(ray, axes, v(7.0, 3.0, 1.0), 1.0).expect("a square")
    };
    let t = |y: f64, z: f64| square(y, z).truth();
    assert_eq!(t(3.5, 2.0), Some(3.0));
    assert_eq!(t(4.0, 3.0), Some(3.0), "its rim belongs to it");
    assert_eq!([t(4.0_f64.next_up(), 2.0), t(3.5, 3.5)], [None; 2]);
    let RaySquare {
        origin, direction, ..
    } = square(4.0 + 6e-9, 2.0).wide;
    let beside = truth::edge_angle(origin, direction, &square(4.0, 2.0).wide.rim());
    assert!((beside / 1e-9 - 1.0).abs() < 1e-6, "{beside}");

    let clip = |depth: f64| {
        let case = ClipCase::new(0.5, 0.8, 8.0, dvec2(300.5, 200.5), depth).expect("a camera");
        case.truth()
    };
    assert_eq!(
        [0.8, 0.8_f64.next_down(), 8.0, 8.0_f64.next_down()].map(clip),
        [true, false, false, true]
    );

    // An object moved by (0, 0, 5) and doubled. Its ray, taken back to the world, is the world's ray or one unit beside
    // it.
    let twice = M3([v(2.0, 0.0, 0.0), v(0.0, 2.0, 0.0), v(0.0, 0.0, 2.0)]);
    let ray = [v(0.0, 0.0, 0.0), v(0.0, 0.0, 1.0)];
    let placed = PlacedCase::new(ray, twice, v(0.0, 0.0, 5.0), 1.0).expect("a case");
    let aside = |x: f64| object_space::aside(&placed.wide, &[v(x, 0.0, -2.5), v(0.0, 0.0, 0.5)]);
    assert_eq!([aside(0.0), aside(0.5)], [0.0, 0.2]);
}

#[test]
fn cases_are_the_same_numbers_for_both_precisions() {
    /// `fields` are those of `narrow` and of `wide`.
    fn check<C: Case>(fields: impl Fn(&C) -> [Vec<V3<f64>>; 2]) {
        for family in C::FAMILIES {
            for &value in family.values {
                let mut random = Random::named(3, &[family.name]);
                for _ in 0..20 {
                    let [narrow, wide] = fields(&(family.make)(&mut random, value));
                    let same = narrow == wide;
                    // These rays keep digits that `f32` has no room for, and some of the mixed ones do.
                    let has_more = family.name.starts_with("f64 rays")
                        || family.name == AT_EDGES && value == 1.0;
                    assert!(
                        family.name == AT_EDGES && !has_more || same != has_more,
                        "{} {} {value}",
                        C::ABOUT.key,
                        family.name
                    );
                }
            }
        }
    }
    fn of<const N: usize, T: Real>(vectors: [V3<T>; N]) -> Vec<V3<f64>> {
        vectors.map(V3::wide).to_vec()
    }
    fn triangle<T: Real>(c: &RayTriangle<T>) -> Vec<V3<f64>> {
        let [p, q, r] = c.corners;
        of([c.origin, c.direction, p, q, r])
    }
    fn shape<S>(c: &ShapeCase<S>) -> [Vec<V3<f64>>; 2] {
        let (narrow, wide) = (c.narrow, c.wide);
        [
            of([narrow.origin, narrow.direction]),
            of([wide.origin, wide.direction]),
        ]
    }
    fn square<T: Real>(c: &RaySquare<T>) -> Vec<V3<f64>> {
        let [u, v] = c.sides;
        of([c.origin, c.direction, c.middle, u, v])
    }
    fn placed<T: Real>(c: &Placed<T>) -> Vec<V3<f64>> {
        let [u, v, w] = c.linear.0;
        of([c.origin, c.direction, c.translation, u, v, w])
    }
    fn tilted<T: Real>(c: &Tilted<T>) -> Vec<V3<f64>> {
        let [u, v, w] = c.linear.0;
        of([c.normal, u, v, w])
    }
    check::<TriangleCase>(|c| [triangle(&c.narrow), triangle(&c.wide)]);
    check::<SphereCase>(shape);
    check::<BoxCase>(shape);
    check::<SquareCase>(|c| [square(&c.narrow), square(&c.wide)]);
    check::<PlacedCase>(|c| [placed(&c.narrow), placed(&c.wide)]);
    check::<NormalCase>(|c| [tilted(&c.narrow), tilted(&c.wide)]);
    check::<PixelCase>(|c| [of([c.narrow.picture.eye]), of([c.wide.picture.eye])]);
}

#[test]
fn random_numbers_are_the_same_everywhere() {
    // Fixed here because a change of the generator changes every workload.
    let mut random = Random::named(1, &["triangle", "ordinary"]);
    let numbers: [i32; 4] = std::array::from_fn(|_| random.integer(0, 999));
    assert_eq!(numbers, [51, 621, 584, 805]);
}
