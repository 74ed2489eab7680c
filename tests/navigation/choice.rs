//! Fitted near and far planes hold what is in front of the eye. Flags beat the scene file, and the scene file beats
//! framing.

use crate::{
    UP_AXES,
    common::{Random, assert_near, orthographic, perspective},
    unit_box, viewport,
};
use glam::{DVec3, dvec3};
use sightline::{
    camera::{
        Camera, CameraChoice, CameraError, DepthMapping, Framing, Lens, Projection, SectionChoice,
        UpAxis, Viewport, fit_near_far,
    },
    geometry::Aabb,
};

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
            let fitted = Lens { near, far, ..lens };
            assert_eq!(fitted.stored(), Ok(fitted));
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
        // The lens refuses impossible planes; they never make the fit fail.
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
        section: Some(SectionChoice::Uncut),
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
        section: Some(SectionChoice::Face { id: 1, face: None }),
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
        section: two.section,
        ..none
    };
    let expected = CameraChoice {
        up: two.up,
        far: two.far,
        depth: two.depth,
        up_axis: two.up_axis,
        section: two.section,
        ..one
    };
    assert_eq!(rest.or(one), expected);
}

/// The box fills what a picture is to fill, as far from the left as from the right, or from the top as from the bottom.
#[track_caller]
fn assert_framed(camera: &Camera, bounds: &Aabb, size: Viewport) {
    let corners = bounds.corners().into_iter();
    let seen = corners.map(|corner| camera.project(size, corner).unwrap().ndc.with_z(0.0));
    let seen = Aabb::around(seen);
    let largest = seen.max.max(-seen.min).max_element();
    assert!((largest - Framing::FILLED).abs() < 1e-12, "{seen:?}");
    assert!(seen.center().abs().min_element() < 1e-12, "{seen:?}");
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
    assert_framed(&framed, &bounds, size);
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

    // A target alone is seen from the direction that framing takes.
    let at = resolve(CameraChoice {
        target: Some(eye),
        ..none
    });
    assert_eq!(at.target(), eye);
    assert_near(at.forward(), framed.forward(), 1e-14);

    for look in [
        dvec3(0.0, -0.2, -4.0),
        dvec3(1e-30, 0.0, 1e-30),
        dvec3(1e30, 1e30, 0.0),
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
        // Without an eye, the scene is framed as it is seen from there.
        let around = resolve(CameraChoice {
            look: Some(look),
            ..none
        });
        assert_framed(&around, &bounds, size);
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
        let size = viewport(64, 48);
        let camera = choice.resolve(&Aabb::EMPTY, size).unwrap();
        if ortho.is_none() {
            assert_framed(&camera, &unit_box(), size);
        } else {
            // Its height is given. The box from -1 to 1 is in the middle.
            assert!(camera.target().length() < 1e-12, "{camera:?}");
        }
        assert!(camera.eye().is_finite());
    }
}

/// The target of a tiny scene's camera may round to its eye. Near and far are positive nevertheless.
#[test]
fn a_tiny_scene_may_lie_behind_an_eye_that_is_far_from_it() {
    for size in [1e-16, 1e-17, 1e-25] {
        let half = DVec3::splat(0.5 * size);
        let bounds = Aabb {
            min: -half,
            max: half,
        };
        for look in [DVec3::Z, DVec3::NEG_Z, DVec3::X] {
            let choice = CameraChoice {
                eye: Some(DVec3::Z),
                look: Some(look),
                ..CameraChoice::default()
            };
            let camera = choice.resolve(&bounds, viewport(640, 360));
            let lens = *camera.expect("a camera").lens();
            assert!(
                0.0 < lens.near && lens.near < lens.far,
                "{size} {look} {lens:?}"
            );
        }
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
            // The view is as if the camera had orbited there: what is to the right stays to the right.
            assert_near(camera.right(), frame.x_axis, 1e-15);
            assert_near(camera.up(), -side * frame.z_axis, 1e-15);
            // An up that was chosen is not replaced.
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
        CameraError::OutOfRange("direction")
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
        CameraError::OutOfRange("eye")
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
