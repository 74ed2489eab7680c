//! Choosing a view: orbit, framing, automatic planes, and which word about the camera counts.

mod common;

use common::{Random, assert_close, assert_near, orthographic, perspective};
use glam::{DVec2, DVec3, dvec2, dvec3};
use sightline::{
    camera::{
        Camera, CameraChoice, CameraError, DepthMapping, Lens, Orbit, Projection, UpAxis, Viewport,
        fit_near_far,
    },
    geometry::Aabb,
};
use std::f64::consts::PI;

const UP_AXES: [UpAxis; 2] = [UpAxis::Y, UpAxis::Z];

fn viewport(width: u32, height: u32) -> Viewport {
    Viewport::new(width, height).unwrap()
}

fn unit_box() -> Aabb {
    Aabb {
        min: DVec3::splat(-1.0),
        max: DVec3::splat(1.0),
    }
}

/// An orbit as the window has it after some turning about.
fn orbits() -> Vec<Orbit> {
    let mut random = Random::new(7);
    let mut orbits = Vec::new();
    for up_axis in UP_AXES {
        for offset in [0.0, 1e4] {
            for _ in 0..20 {
                let center = offset * random.direction();
                let bounds = Aabb::around([center, center + random.point(3.0)]);
                let mut orbit = Orbit::framing(&bounds, up_axis, 0.8, 1.5);
                let center = orbit.target();
                orbit.turn(center, random.within(-7.0, 7.0), random.within(-2.0, 2.0));
                orbits.push(orbit);
            }
        }
    }
    orbits
}

/// How much a perspective picture shows, from top to bottom, at an orbit's target.
fn height_at_target(orbit: &Orbit, fov_y: f64) -> f64 {
    2.0 * orbit.distance() * (0.5 * fov_y).tan()
}

#[test]
fn straight_up_and_down_are_ordinary_views() {
    let lens = perspective(45.0, 0.1, 100.0);
    for up_axis in UP_AXES {
        let frame = up_axis.frame();
        for (turn, up) in [(100.0, -frame.z_axis), (-100.0, frame.z_axis)] {
            let mut orbit = Orbit::framing(&unit_box(), up_axis, 0.8, 1.0);
            orbit.look_from(up_axis, DVec3::Z);
            // Far past the pole: it stops there.
            orbit.turn(DVec3::ZERO, 0.0, turn);
            let camera = orbit.camera(lens).unwrap();
            assert_near(camera.forward(), -turn.signum() * up_axis.up(), 1e-15);
            assert_near(camera.up(), up, 1e-15);
            assert_near(camera.right(), frame.x_axis, 1e-15);
            // At the pole the first angle turns the picture, and the second comes back at once.
            orbit.turn(DVec3::ZERO, 0.5 * PI, -0.1 * turn.signum());
            let camera = orbit.camera(lens).unwrap();
            assert_near(camera.right(), -frame.z_axis, 1e-15);
            assert_close(
                camera.forward().dot(up_axis.up()).abs(),
                0.1_f64.cos(),
                1e-15,
            );
        }
    }
}

#[test]
fn named_views_look_along_the_axes() {
    let lens = perspective(45.0, 0.1, 100.0);
    for up_axis in UP_AXES {
        let frame = up_axis.frame();
        let mut orbit = Orbit::framing(&unit_box(), up_axis, 0.8, 1.0);
        let views = [
            (DVec3::Z, frame.x_axis, frame.y_axis),
            (DVec3::X, -frame.z_axis, frame.y_axis),
            (DVec3::NEG_X, frame.z_axis, frame.y_axis),
            (DVec3::Y, frame.x_axis, -frame.z_axis),
        ];
        for (to_eye, right, up) in views {
            orbit.look_from(up_axis, to_eye);
            let camera = orbit.camera(lens).unwrap();
            assert_near(camera.forward(), -(frame * to_eye), 1e-15);
            assert_near(camera.right(), right, 1e-15);
            assert_near(camera.up(), up, 1e-15);
        }
    }
    // +z is up: the front view has x to the right and looks along +y.
    assert_eq!(UpAxis::Z.frame() * DVec3::Z, DVec3::NEG_Y);
}

#[test]
fn an_orbit_is_its_cameras_orbit() {
    let lens = perspective(45.0, 0.1, 100.0);
    let mut random = Random::new(8);
    let mut cameras: Vec<_> = orbits()
        .iter()
        .map(|orbit| orbit.camera(lens).unwrap())
        .collect();
    // And cameras that nobody orbited: leaning, upside down, straight down.
    for _ in 0..20 {
        let (eye, up) = (random.point(9.0), random.direction());
        cameras.push(Camera::new(eye, random.point(1.0), up, lens).unwrap());
    }
    cameras.push(Camera::new(DVec3::ZERO, DVec3::Z, DVec3::NEG_Y, lens).unwrap());
    cameras.push(Camera::new(5.0 * DVec3::Y, DVec3::ZERO, dvec3(1.0, 0.0, 1.0), lens).unwrap());
    for up_axis in UP_AXES {
        for camera in &cameras {
            let again = Orbit::of_camera(camera, up_axis).camera(lens).unwrap();
            // Not to the bit, but to a few units in the last place of the eye's coordinates.
            assert_eq!(again.target(), camera.target());
            let size = camera.eye().length() + camera.target().length();
            assert!(again.eye().distance(camera.eye()) <= 4.0 * f64::EPSILON * size);
            let skew = 8.0 * f64::EPSILON * size / camera.eye().distance(camera.target());
            assert_near(again.right(), camera.right(), skew);
            assert_near(again.up(), camera.up(), skew);
            assert_near(again.forward(), camera.forward(), skew);
        }
    }
}

#[test]
fn a_turn_leaves_its_pivot_where_it_is() {
    let mut random = Random::new(9);
    for mut orbit in orbits() {
        for lens in [perspective(45.0, 0.01, 1e4), orthographic(3.0, -1e4, 1e4)] {
            let size = viewport(800, 600);
            let distance = orbit.distance();
            let pivot = orbit.target() + random.point(0.3 * distance);
            let before = orbit.camera(lens).unwrap().project(size, pivot).unwrap();
            orbit.turn(pivot, random.within(-3.0, 3.0), random.within(-0.5, 0.5));
            let after = orbit.camera(lens).unwrap().project(size, pivot).unwrap();
            let bound = 1e-9 + 1e-11 * orbit.target().length() / distance;
            assert!(before.px.distance(after.px) <= bound);
            assert_close(before.depth, after.depth, 1e-10);
            assert_close(orbit.distance(), distance, 1e-15);
        }
    }
}

#[test]
fn a_zoom_leaves_its_point_where_it_is_and_comes_back() {
    let mut random = Random::new(10);
    let size = viewport(800, 600);
    for mut orbit in orbits() {
        let lens = |orbit: &Orbit, parallel: bool| {
            let near_far = (1e-3 * orbit.distance(), 1e3 * orbit.distance());
            if parallel {
                orthographic(height_at_target(orbit, 0.8), near_far.0, near_far.1)
            } else {
                perspective(45.0, near_far.0, near_far.1)
            }
        };
        for parallel in [false, true] {
            let point = orbit.target() + random.point(0.3 * orbit.distance());
            let px = |orbit: &Orbit| {
                let camera = orbit.camera(lens(orbit, parallel)).unwrap();
                camera.project(size, point).unwrap().px
            };
            let (before, distance, target) = (px(&orbit), orbit.distance(), orbit.target());
            for factor in [1.25, 0.4, 10.0] {
                orbit.zoom(point, factor);
                assert_close(orbit.distance(), distance / factor, 1e-14);
                let bound = 1e-9 + 1e-10 * orbit.target().length() / orbit.distance();
                assert!(before.distance(px(&orbit)) <= bound, "zoomed by {factor}");
                orbit.zoom(point, 1.0 / factor);
                assert_close(orbit.distance(), distance, 1e-14);
                assert!(orbit.target().distance(target) <= 1e-13 * (target.length() + distance));
            }
        }
        orbit.zoom(orbit.target(), f64::INFINITY);
        assert!(
            orbit.distance() > 0.0 && orbit.eye().is_finite(),
            "zooming never sticks"
        );
        orbit.zoom(orbit.target(), 1e-300);
        assert!(orbit.distance().is_finite() && orbit.eye().is_finite());
    }
}

#[test]
fn a_pan_follows_the_cursor() {
    let mut random = Random::new(11);
    let size = viewport(800, 600);
    for mut orbit in orbits() {
        for lens in [perspective(45.0, 1e-3, 1e5), orthographic(3.0, -1e5, 1e5)] {
            let grabbed = orbit.target() + random.point(0.3 * orbit.distance());
            let before = orbit.camera(lens).unwrap().project(size, grabbed).unwrap();
            let by_px = dvec2(random.within(-300.0, 300.0), random.within(-300.0, 300.0));
            orbit.pan(by_px, before.depth, &lens, size);
            let after = orbit.camera(lens).unwrap().project(size, grabbed).unwrap();
            let bound = 1e-9 + 1e-9 * orbit.target().length() / orbit.distance();
            assert!(after.px.distance(before.px + by_px) <= bound);
        }
    }
}

#[test]
fn framing_shows_everything_within_the_planes() {
    let mut random = Random::new(12);
    for fov in [0.5, 20.0, 45.0, 120.0, 178.0] {
        for (width, height) in [(1280, 720), (300, 900), (64, 64), (3000, 30), (1, 1)] {
            for (offset, extent) in [(0.0, 1.0), (1e6, 1.0), (0.0, 1e-6), (10.0, 1e6), (5.0, 0.0)] {
                let center = offset * random.direction();
                let bounds = Aabb::around([center, center + random.point(extent)]);
                for (up_axis, parallel) in [(UpAxis::Y, false), (UpAxis::Z, true)] {
                    let fov_y = f64::to_radians(fov);
                    let size = viewport(width, height);
                    let orbit = Orbit::framing(&bounds, up_axis, fov_y, size.aspect());
                    let lens = if parallel {
                        orthographic(height_at_target(&orbit, fov_y), 1.0, 2.0)
                    } else {
                        perspective(fov, 1.0, 2.0)
                    };
                    let camera = orbit.camera(lens).unwrap();
                    let (near, far) = fit_near_far(&camera, &bounds, None, None);
                    let camera = camera.with_lens(Lens { near, far, ..lens }).unwrap();
                    let mut largest: f64 = 0.0;
                    for corner in bounds.corners() {
                        let ndc = camera.project(size, corner).unwrap().ndc;
                        assert!(ndc.abs().max_element() <= 1.0, "{fov} {size:?}: {ndc}");
                        assert!(ndc.z >= 0.0, "{ndc} is beyond the far plane");
                        largest = largest.max(ndc.x.abs()).max(ndc.y.abs());
                    }
                    // And as large as may be, unless the lens is so wide that the sphere about it is all that counts.
                    let wide = fov > 90.0;
                    assert!(
                        extent == 0.0 || wide || largest > 0.1,
                        "only {largest} of the picture"
                    );
                    let direction = up_axis.frame().transpose() * -camera.forward();
                    let skew = 1e-14 + 1e-15 * offset / orbit.distance();
                    assert_near(direction, dvec3(1.0, 0.8, 1.6).normalize(), skew);
                }
            }
        }
    }
}

#[test]
fn planes_hold_what_is_in_front_of_the_eye() {
    let mut random = Random::new(13);
    for lens in [perspective(45.0, 1.0, 2.0), orthographic(2.0, 1.0, 2.0)] {
        let parallel = matches!(lens.projection, Projection::Orthographic { .. });
        for _ in 0..500 {
            // The eye may be inside the box, or have it behind.
            let bounds = Aabb::around([random.point(3.0), random.point(3.0)]);
            let (eye, target) = (random.point(8.0), random.point(8.0));
            let camera = Camera::new(eye, target, DVec3::Y, lens).unwrap();
            let (near, far) = fit_near_far(&camera, &bounds, None, None);
            assert_eq!(Lens { near, far, ..lens }.check(), Ok(()));
            for corner in bounds.corners() {
                let depth = camera.to_view(corner).z;
                let shown = (near..far).contains(&depth);
                assert!(
                    shown || !parallel && depth < 1.001e-5 * far,
                    "{depth} in {near} to {far}"
                );
            }
        }
    }
}

#[test]
fn a_given_plane_stays_and_the_other_keeps_to_its_side() {
    let bounds = unit_box();
    for lens in [perspective(45.0, 1.0, 2.0), orthographic(2.0, 1.0, 2.0)] {
        let camera = Camera::new(5.0 * DVec3::Z, DVec3::ZERO, DVec3::Y, lens).unwrap();
        for given in [0.001, 0.5, 4.5, 5.0, 100.0, 1e8] {
            let (near, far) = fit_near_far(&camera, &bounds, Some(given), None);
            assert_eq!(near.to_bits(), given.to_bits());
            assert!(far > near, "near {near}, far {far}");
            let (near, far) = fit_near_far(&camera, &bounds, None, Some(given));
            assert_eq!(far.to_bits(), given.to_bits());
            assert!(near < far, "near {near}, far {far}");
        }
        // What cannot be is for the lens to refuse: no plane makes the fit fail.
        for given in [-1.0, 0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for (near, far) in [
                (Some(given), None),
                (None, Some(given)),
                (Some(given), Some(given)),
            ] {
                let _ = fit_near_far(&camera, &bounds, near, far);
            }
        }
    }
    let size = viewport(64, 48);
    for (near, far) in [
        (None, Some(-1.0)),
        (Some(-1.0), None),
        (Some(3.0), Some(2.0)),
        (None, Some(f64::NAN)),
    ] {
        let choice = CameraChoice {
            near,
            far,
            ..CameraChoice::default()
        };
        assert!(choice.resolve(&bounds, size).is_err(), "{near:?} {far:?}");
    }
}

#[test]
fn flags_beat_the_scene_and_the_scene_beats_framing() {
    let one = CameraChoice {
        eye: Some(DVec3::X),
        target: Some(DVec3::Y),
        look: None,
        up: Some(DVec3::Z),
        fov: Some(10.0),
        ortho: None,
        near: Some(1.0),
        far: Some(2.0),
        depth: Some(DepthMapping::Standard),
        up_axis: Some(UpAxis::Z),
    };
    let two = CameraChoice {
        eye: Some(DVec3::NEG_X),
        target: None,
        look: Some(DVec3::NEG_Y),
        up: Some(DVec3::NEG_Z),
        fov: None,
        ortho: Some(20.0),
        near: Some(3.0),
        far: Some(4.0),
        depth: Some(DepthMapping::Reversed),
        up_axis: Some(UpAxis::Y),
    };
    let none = CameraChoice::default();
    assert_eq!(one.or(two), one);
    assert_eq!(two.or(one), two);
    assert_eq!(none.or(one), one);
    assert_eq!(one.or(none), one);
    // Each field alone over a full choice changes that field, and its rival only.
    let only = |eye, near| CameraChoice { eye, near, ..none };
    assert_eq!(
        only(two.eye, None).or(one),
        CameraChoice {
            eye: two.eye,
            ..one
        }
    );
    assert_eq!(
        only(None, two.near).or(one),
        CameraChoice {
            near: two.near,
            ..one
        }
    );
    let look = CameraChoice {
        look: two.look,
        ..none
    };
    assert_eq!(
        look.or(one),
        CameraChoice {
            look: two.look,
            target: None,
            ..one
        }
    );
    let ortho = CameraChoice {
        ortho: two.ortho,
        ..none
    };
    assert_eq!(
        ortho.or(one),
        CameraChoice {
            ortho: two.ortho,
            fov: None,
            ..one
        }
    );
    let rest = CameraChoice {
        up: two.up,
        far: two.far,
        depth: two.depth,
        up_axis: two.up_axis,
        ..none
    };
    let expected = CameraChoice {
        up: two.up,
        far: two.far,
        depth: two.depth,
        up_axis: two.up_axis,
        ..one
    };
    assert_eq!(rest.or(one), expected);
}

#[test]
fn what_is_chosen_is_what_the_camera_has() {
    let size = viewport(1280, 720);
    let bounds = Aabb {
        min: dvec3(10.0, 0.0, 0.0),
        max: dvec3(12.0, 1.0, 3.0),
    };
    let resolve = |choice: CameraChoice| choice.resolve(&bounds, size).unwrap();
    let none = CameraChoice::default();

    let framed = resolve(none);
    assert_eq!(framed.target(), bounds.center());
    assert_eq!(
        framed.lens().projection,
        Projection::Perspective {
            fov_y: 45_f64.to_radians()
        }
    );
    assert_eq!(framed.lens().depth, DepthMapping::Reversed);

    let eye = dvec3(-3.0, 2.0, 1.0);
    let from = resolve(CameraChoice {
        eye: Some(eye),
        ..none
    });
    assert_eq!((from.eye(), from.target()), (eye, bounds.center()));

    // A target alone is seen from where framing would see it.
    let at = resolve(CameraChoice {
        target: Some(eye),
        ..none
    });
    assert_eq!(at.target(), eye);
    assert_near(at.forward(), framed.forward(), 1e-14);

    for look in [
        dvec3(0.0, -0.2, -4.0),
        dvec3(1e-200, 0.0, 1e-200),
        dvec3(1e200, 1e200, 0.0),
    ] {
        let along = resolve(CameraChoice {
            eye: Some(eye),
            look: Some(look),
            ..none
        });
        assert_eq!(along.eye(), eye);
        assert_near(
            along.forward(),
            (look / look.abs().max_element()).normalize(),
            1e-14,
        );
        // Without an eye it is one that has everything in the picture.
        let around = resolve(CameraChoice {
            look: Some(look),
            ..none
        });
        let middle = around.project(size, bounds.center()).unwrap();
        assert!(middle.px.distance(DVec2::new(640.0, 360.0)) <= 1e-9);
    }

    let planes = resolve(CameraChoice {
        near: Some(0.25),
        far: Some(99.0),
        ..none
    });
    assert_eq!((planes.lens().near, planes.lens().far), (0.25, 99.0));
    let parallel = resolve(CameraChoice {
        ortho: Some(7.0),
        depth: Some(DepthMapping::Standard),
        ..none
    });
    assert_eq!(
        parallel.lens().projection,
        Projection::Orthographic { height: 7.0 }
    );
    assert_eq!(parallel.lens().depth, DepthMapping::Standard);
    let z_up = resolve(CameraChoice {
        up_axis: Some(UpAxis::Z),
        ..none
    });
    assert!(z_up.up().z > 0.5 && z_up.right().z.abs() < 1e-15);
}

#[test]
fn an_empty_scene_has_a_camera_too() {
    for ortho in [None, Some(2.0)] {
        let choice = CameraChoice {
            ortho,
            ..CameraChoice::default()
        };
        let camera = choice.resolve(&Aabb::EMPTY, viewport(64, 48)).unwrap();
        assert_eq!(camera.target(), DVec3::ZERO);
        assert!(camera.eye().is_finite());
    }
}

#[test]
fn looking_along_the_up_axis_needs_no_up() {
    let size = viewport(64, 48);
    for up_axis in UP_AXES {
        let frame = up_axis.frame();
        for side in [1.0, -1.0] {
            let choice = CameraChoice {
                eye: Some(side * 5.0 * up_axis.up()),
                target: Some(DVec3::ZERO),
                up_axis: Some(up_axis),
                ..CameraChoice::default()
            };
            let camera = choice.resolve(&unit_box(), size).unwrap();
            // As orbiting there would end: what is to the right stays there.
            assert_near(camera.right(), frame.x_axis, 1e-15);
            assert_near(camera.up(), -side * frame.z_axis, 1e-15);
            // An up that was asked for is not replaced.
            let asked = CameraChoice {
                up: Some(up_axis.up()),
                ..choice
            };
            assert_eq!(
                asked.resolve(&unit_box(), size),
                Err(CameraError::UpAlongForward)
            );
        }
    }
}

#[test]
fn choices_that_cannot_be_say_why() {
    let resolve = |choice: CameraChoice| choice.resolve(&unit_box(), viewport(64, 48)).unwrap_err();
    let none = CameraChoice::default();
    let nan = DVec3::splat(f64::NAN);
    assert_eq!(
        resolve(CameraChoice {
            look: Some(nan),
            ..none
        }),
        CameraError::NotFinite("direction")
    );
    assert_eq!(
        resolve(CameraChoice {
            look: Some(DVec3::ZERO),
            ..none
        }),
        CameraError::NoDirection
    );
    assert_eq!(
        resolve(CameraChoice {
            eye: Some(nan),
            ..none
        }),
        CameraError::NotFinite("eye")
    );
    let eye = Some(DVec3::ONE);
    assert_eq!(
        resolve(CameraChoice {
            eye,
            target: eye,
            ..none
        }),
        CameraError::NoDirection
    );
    assert_eq!(
        resolve(CameraChoice {
            fov: Some(180.0),
            ..none
        }),
        CameraError::FieldOfView(180.0)
    );
    assert_eq!(
        resolve(CameraChoice {
            ortho: Some(0.0),
            ..none
        }),
        CameraError::Height(0.0)
    );
}
