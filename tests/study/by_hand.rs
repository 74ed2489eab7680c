//! Truth and workloads are right on what hands can check.

use glam::DVec3;
use sightline::study::{
    exact::{Exact, Exact3, angle},
    methods::{
        boxes::RayBox,
        clipping::Clip,
        object_space::Placed,
        planes::RayPlane,
        rays::PixelCase,
        spheres::RaySphere,
        triangles::{RayTriangle, TriangleCase},
    },
    random::Random,
    real::{M3, V3},
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

    let clip = |t: f64| {
        let hit = Clip {
            t,
            direction: v(0.6, 0.0, 0.8),
            forward: v(0.0, 0.0, 1.0),
            near: 0.8,
            far: 8.0,
        };
        truth::clipping::truth(&hit).inside
    };
    assert_eq!(
        [1.0, 1.0_f64.next_down(), 10.0, 10.0_f64.next_down()].map(clip),
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
    fn check<C: Case>(narrow: impl Fn(&C) -> V3<f64>, wide: impl Fn(&C) -> V3<f64>) {
        for family in C::families() {
            for &value in family.values {
                let mut random = Random::named(3, &[family.name]);
                let case = (family.make)(&mut random, value);
                assert_eq!(
                    DVec3::from(narrow(&case)),
                    DVec3::from(wide(&case)),
                    "{} {value}",
                    family.name
                );
            }
        }
    }
    check::<TriangleCase>(|c| c.narrow.corners[0].wide(), |c| c.wide.corners[0]);
    check::<TriangleCase>(|c| c.narrow.direction.wide(), |c| c.wide.direction);
    check::<PixelCase>(|c| c.narrow.eye.wide(), |c| c.wide.eye);
}

#[test]
fn random_numbers_are_the_same_everywhere() {
    // Known by heart: a change of the generator changes every workload.
    let mut random = Random::named(1, &["triangle", "ordinary"]);
    let numbers: [i32; 4] = std::array::from_fn(|_| random.integer(0, 999));
    assert_eq!(numbers, [51, 621, 584, 805]);
}
