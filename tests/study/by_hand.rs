//! Truth and workloads are right on what hands can check.

use sightline::study::{
    exact::{Exact, Exact3, angle},
    methods::{
        boxes::{BoxCase, RayBox},
        clipping::ClipCase,
        normals::{NormalCase, Tilted},
        object_space::{Placed, PlacedCase},
        planes::{PlaneCase, RayPlane},
        rays::PixelCase,
        spheres::{RaySphere, SphereCase},
        triangles::{RayTriangle, TriangleCase},
    },
    random::Random,
    real::{M3, Real, V3},
    step::Case,
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
    let triangle = |x: f64, y: f64| {
        let ray = RayTriangle {
            origin: v(x, y, 0.0),
            direction: v(0.0, 0.0, 2.0),
            corners,
        };
        truth::triangles::truth(&ray)
    };
    assert_eq!(triangle(0.25, 0.25).t, Some(2.5));
    assert_eq!(triangle(0.5, 0.5).t, Some(2.5), "an edge belongs to it");
    assert_eq!(triangle(0.0, 0.0).t, Some(2.5), "a corner, too");
    let outside = triangle(0.25, -1e-12);
    assert_eq!(outside.t, None);
    assert!(
        (outside.edge_angle / 2e-13 - 1.0).abs() < 1e-9,
        "{outside:?}"
    );

    let sphere = |y: f64| {
        let ray = RaySphere {
            origin: v(0.0, y, -4.0),
            direction: v(0.0, 0.0, 1.0),
            center: v(0.0, 0.0, 0.0),
            radius: 1.0,
        };
        truth::spheres::truth(&ray)
    };
    assert_eq!(sphere(0.0).t, Some(3.0));
    assert_eq!(sphere(1.0).t, Some(4.0), "a touch is a hit");
    assert_eq!(sphere(1.0_f64.next_up()).t, None);

    let cube = |origin: V3<f64>, direction: V3<f64>| {
        let ray = RayBox {
            origin,
            direction,
            min: v(-1.0, -1.0, -1.0),
            max: v(1.0, 1.0, 1.0),
        };
        truth::boxes::truth(&ray).t
    };
    assert_eq!(cube(v(-3.0, 0.0, 0.0), v(2.0, 0.0, 0.0)), Some(1.0));
    assert_eq!(
        cube(v(0.0, 0.0, 0.0), v(2.0, 0.0, 0.0)),
        Some(0.5),
        "from inside: the exit"
    );
    assert_eq!(
        cube(v(1.0, -3.0, 0.0), v(0.0, 1.0, 0.0)),
        Some(2.0),
        "within a face"
    );
    assert_eq!(
        cube(v(1.0_f64.next_up(), -3.0, 0.0), v(0.0, 1.0, 0.0)),
        None
    );
    assert_eq!(
        cube(v(-3.0, -1.0, 0.0), v(1.0, 1.0, 0.0)),
        Some(2.0),
        "from below onto a face"
    );
    assert_eq!(cube(v(-3.0, 1.0, 0.0), v(1.0, 1.0, 0.0)), None);

    let plane = RayPlane {
        origin: v(0.0, 0.0, 0.0),
        direction: v(0.0, 1.0, 1.0),
        point: v(7.0, 3.0, 0.0),
        normal: v(0.0, 2.0, 0.0),
        distance: 6.0,
    };
    assert_eq!(truth::planes::truth(&plane), 3.0);

    let clip = |depth: f64| {
        let case = ClipCase::new(0.5, 0.8, 8.0, [300.5, 200.5], depth).expect("a camera");
        truth::clipping::truth(&case).inside
    };
    assert_eq!(
        [0.8, 0.8_f64.next_down(), 8.0, 8.0_f64.next_down()].map(clip),
        [true, false, false, true]
    );

    // An object moved by (0, 0, 5) and doubled: its ray comes back onto the world's, or one unit of space beside it.
    let twice = M3([v(2.0, 0.0, 0.0), v(0.0, 2.0, 0.0), v(0.0, 0.0, 2.0)]);
    let placed = Placed {
        linear: twice,
        translation: v(0.0, 0.0, 5.0),
        origin: v(0.0, 0.0, 0.0),
        direction: v(0.0, 0.0, 1.0),
    };
    let aside = |x: f64| truth::object_space::aside(&placed, &[v(x, 0.0, -2.5), v(0.0, 0.0, 0.5)]);
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
                    assert_eq!(narrow, wide, "{} {} {value}", C::ABOUT.key, family.name);
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
    fn sphere<T: Real>(c: &RaySphere<T>) -> Vec<V3<f64>> {
        let radius = V3::new(c.radius, c.radius, c.radius);
        of([c.origin, c.direction, c.center, radius])
    }
    fn cuboid<T: Real>(c: &RayBox<T>) -> Vec<V3<f64>> {
        of([c.origin, c.direction, c.min, c.max])
    }
    fn plane<T: Real>(c: &RayPlane<T>) -> Vec<V3<f64>> {
        of([c.origin, c.direction, c.point, c.normal])
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
    check::<SphereCase>(|c| [sphere(&c.narrow), sphere(&c.wide)]);
    check::<BoxCase>(|c| [cuboid(&c.narrow), cuboid(&c.wide)]);
    check::<PlaneCase>(|c| [plane(&c.narrow), plane(&c.wide)]);
    check::<PlacedCase>(|c| [placed(&c.narrow), placed(&c.wide)]);
    check::<NormalCase>(|c| [tilted(&c.narrow), tilted(&c.wide)]);
    check::<PixelCase>(|c| [of([c.narrow.eye]), of([c.wide.eye])]);
}

#[test]
fn random_numbers_are_the_same_everywhere() {
    // Known by heart: a change of the generator changes every workload.
    let mut random = Random::named(1, &["triangle", "ordinary"]);
    let numbers: [i32; 4] = std::array::from_fn(|_| random.integer(0, 999));
    assert_eq!(numbers, [51, 621, 584, 805]);
}
