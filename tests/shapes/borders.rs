//! Rays in borderline cases get the right hits: at the ends of their interval, as tangents, and within faces and
//! planes.

use crate::common::{orthographic, ray_to, scene_of};
use glam::{DAffine3, DQuat, DVec2, DVec3, dvec3};
use sightline::{
    camera::{Camera, View, Viewport},
    geometry::{Cuboid, Ray, Sides, Sphere, Square, VertexRay, hit_guarded},
    pick,
    scene::Shape,
};

#[test]
fn only_what_lies_in_the_interval_counts() {
    let along_x = |t_min, t_max| Ray {
        // Through the centre, where the sphere's t needs no irrational root and `f64` holds it exactly.
        origin: dvec3(-2.0, 0.0, 0.0),
        direction: DVec3::X,
        t_min,
        t_max,
    };
    for shape in [Shape::Sphere, Shape::Cube] {
        let scene = scene_of(shape, DAffine3::IDENTITY);
        let [first, second] = pick::all(&scene, along_x(0.0, 9.0), Sides::Both)[..] else {
            panic!("in and out");
        };
        let (t1, t2) = (first.hit.t, second.hit.t);
        assert!(1.0 < t1 && t1 < 2.0 && 2.0 < t2 && t2 < 3.0);
        // The start belongs to the interval, the end does not.
        for (t_min, t_max, expected) in [
            (t1, t2, vec![t1]),
            (t1.next_up(), t2.next_up(), vec![t2]),
            (t1.next_up(), t2, vec![]),
            (0.0, t1, vec![]),
            (-9.0, 0.0, vec![]),
            (t2.next_up(), 9.0, vec![]),
        ] {
            let hits = pick::all(&scene, along_x(t_min, t_max), Sides::Both);
            let found: Vec<_> = hits.iter().map(|hit| hit.hit.t).collect();
            assert_eq!(found, expected);
            let closest = pick::closest(&scene, along_x(t_min, t_max), Sides::Both);
            assert_eq!(closest.map(|hit| hit.hit.t), expected.first().copied());
        }
    }
    let down = |t_min, t_max| Ray {
        origin: dvec3(0.1, 0.2, 1.0),
        direction: DVec3::NEG_Z,
        t_min,
        t_max,
    };
    assert!(Square::hit(&down(1.0, 1.5)).is_some());
    assert!(Square::hit(&down(0.0, 1.0)).is_none());
    let corners = [
        dvec3(-1.0, -1.0, 0.0),
        dvec3(1.0, -1.0, 0.0),
        dvec3(0.0, 1.0, 0.0),
    ];
    assert!(hit_guarded(&VertexRay::exact(down(1.0, 1.5)), corners).is_some());
    assert!(hit_guarded(&VertexRay::exact(down(0.0, 1.0)), corners).is_none());
    assert!(hit_guarded(&VertexRay::exact(down(-2.0, 0.5)), corners).is_none());
}

#[test]
fn from_inside_the_way_out_is_hit() {
    let ray = ray_to(dvec3(0.1, 0.05, -0.2), dvec3(0.3, 0.4, 5.0));
    for shape in [Shape::Sphere, Shape::Cube] {
        let hits = pick::all(&scene_of(shape, DAffine3::IDENTITY), ray, Sides::Both);
        assert_eq!(hits.len(), 1);
        assert!(!hits[0].hit.front, "seen from inside");
    }
    // From the surface: both the entry and the exit.
    let ray = ray_to(dvec3(-0.5, 0.0, 0.0), DVec3::ZERO);
    for hits in [Sphere::hits(&ray), Cuboid::hits(&ray)] {
        assert_eq!(hits.map(|hit| hit.map(|hit| hit.t)), [Some(0.0), Some(1.0)]);
    }
}

#[test]
fn a_sphere_is_touched_once() {
    let tangent = Ray {
        origin: dvec3(-3.0, 0.5, 0.0),
        direction: DVec3::X,
        t_min: 0.0,
        t_max: 9.0,
    };
    assert_eq!(
        Sphere::hits(&tangent).map(|hit| hit.map(|hit| hit.t)),
        [Some(3.0), None]
    );
    // At the point of contact, t is 0 and not 0 / 0.
    let there = Ray {
        origin: dvec3(0.0, 0.5, 0.0),
        ..tangent
    };
    assert_eq!(
        Sphere::hits(&there).map(|hit| hit.map(|hit| hit.t)),
        [Some(0.0), None]
    );
    let past = Ray {
        origin: dvec3(-3.0, 0.5_f64.next_up(), 0.0),
        ..tangent
    };
    assert_eq!(Sphere::hits(&past), [None, None]);
}

/// All directions with coordinates of -1, 0 and 1, each zero with both signs.
fn lattice_directions() -> Vec<DVec3> {
    let steps = [-1.0, -0.0, 0.0, 1.0];
    let all = (0..64).map(|i| DVec3::new(steps[i % 4], steps[i / 4 % 4], steps[i / 16]));
    all.filter(|direction| *direction != DVec3::ZERO).collect()
}

#[test]
fn axis_parallel_rays_within_a_face_hit_the_cube() {
    let directions = lattice_directions();
    assert_eq!(directions.len(), 64 - 8);
    let places = [-0.75, -0.5, -0.25, 0.0, 0.5];
    let mut hits = 0;
    for direction in directions {
        for x in places {
            for y in places {
                for z in places {
                    let origin = dvec3(x, y, z) - 2.0 * direction;
                    let ray = Ray {
                        origin,
                        direction,
                        t_min: f64::NEG_INFINITY,
                        t_max: f64::INFINITY,
                    };
                    // Exact: all numbers are small multiples of a quarter, and so are the quotients.
                    let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
                    for axis in 0..3 {
                        let (o, d) = (origin[axis], direction[axis]);
                        if d == 0.0 && o.abs() > 0.5 {
                            enter = f64::INFINITY;
                        } else if d != 0.0 {
                            enter = enter.max((-0.5 * d.signum() - o) / d);
                            leave = leave.min((0.5 * d.signum() - o) / d);
                        }
                    }
                    // A ray that only touches has an entry and no exit.
                    let expected = if enter <= leave {
                        [Some(enter), Some(leave).filter(|leave| enter < *leave)]
                    } else {
                        [None, None]
                    };
                    let found = Cuboid::hits(&ray).map(|hit| hit.map(|hit| hit.t));
                    assert_eq!(found, expected, "{ray:?}");
                    hits += usize::from(found[0].is_some());
                }
            }
        }
    }
    assert!(hits > 2000, "only {hits} rays hit");
}

#[test]
fn rays_in_a_squares_plane_miss_and_its_rim_is_hit() {
    for direction in lattice_directions() {
        let through = |x, y| Ray {
            origin: dvec3(x, y, 0.0) - 2.0 * direction,
            direction,
            t_min: f64::NEG_INFINITY,
            t_max: f64::INFINITY,
        };
        for (x, y, inside) in [
            (0.5, -0.5, true),
            (0.25, 0.5, true),
            (0.0, 0.0, true),
            (0.75, 0.0, false),
        ] {
            let hit = Square::hit(&through(x, y));
            assert_eq!(
                hit.map(|hit| hit.t),
                (inside && direction.z != 0.0).then_some(2.0)
            );
        }
    }
}

/// Views along an axis are common in engineering. Their rays are parallel to four faces of each cube, and `f64` decides
/// them without exact arithmetic.
#[test]
fn cubes_seen_along_an_axis_are_decided_by_f64() {
    let models = [
        DAffine3::from_translation(DVec3::new(0.1, 0.2, 0.3)),
        DAffine3::from_scale_rotation_translation(
            DVec3::new(1.3, 0.7, 0.1),
            DQuat::from_rotation_z(std::f64::consts::FRAC_PI_2),
            DVec3::new(-0.3, 1e3, -7.0),
        ),
    ];
    for model in models {
        let scene = scene_of(Shape::Cube, model);
        let target = model.translation;
        for axis in DVec3::AXES {
            let lens = orthographic(1.7, 1.0, 30.0);
            let camera = Camera::looking(
                target + 10.0 * axis,
                -axis,
                DVec3::new(axis.y, axis.z, axis.x),
                lens,
            );
            let view = View {
                camera: camera.expect("a camera"),
                viewport: Viewport::new(40, 40).expect("a viewport"),
                sides: Sides::Both,
                section: None,
            };
            let (mut hits, mut exact) = (0, 0);
            for (x, y) in (0..40).flat_map(|y| (0..40).map(move |x| (x, y))) {
                let px = DVec2::new(f64::from(x), f64::from(y)) + 0.37;
                let pick = pick::pick(&scene, &view, px);
                hits += usize::from(pick.is_some());
                exact += usize::from(pick.is_some_and(|pick| pick.exact));
            }
            assert!(hits > 30, "{axis}: {hits}");
            assert_eq!(exact, 0, "{axis}: of {hits}");
        }
    }
}
