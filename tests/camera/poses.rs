//! Any eye, direction and up vector give orthonormal axes. What is no camera or no lens is refused.

use super::common::{Random, assert_close, assert_near, orthographic, perspective};
use glam::{DVec3, dvec3};
use sightline::{
    camera::{Camera, CameraError, Viewport},
    geometry::range,
};

#[test]
fn a_direction_will_do_in_place_of_a_target() {
    let lens = perspective(45.0, 0.1, 10.0);
    let eye = dvec3(1.0, 2.0, 3.0);
    let along = dvec3(-2.0, 0.5, 1.0);
    let looking = Camera::looking(eye, along, DVec3::Y, lens).unwrap();
    assert_eq!(
        looking,
        Camera::new(eye, eye + along, DVec3::Y, lens).unwrap()
    );
    for size in [1e-32, 1e32] {
        let camera = Camera::looking(DVec3::ZERO, size * along, size * DVec3::Y, lens).unwrap();
        assert_near(camera.forward(), along.normalize(), 1e-15);
    }
}

#[test]
fn axes_are_orthonormal_however_near_up_is_to_the_line_of_sight() {
    let mut random = Random::new(4);
    let lens = perspective(45.0, 0.1, 10.0);
    for exponent in 0..=13 {
        for _ in 0..100 {
            let along = random.direction();
            let up = along + 10_f64.powi(-exponent) * random.direction();
            let Ok(camera) = Camera::looking(DVec3::ZERO, along, up, lens) else {
                panic!("1e-{exponent} from the line of sight is a direction");
            };
            let axes = [camera.right(), camera.up(), camera.forward()];
            for i in 0..3 {
                assert_close(axes[i].length(), 1.0, 1e-15);
                let leaning = axes[i].dot(axes[(i + 1) % 3]).abs();
                assert!(
                    leaning <= 3e-16,
                    "{leaning} from a right angle at 1e-{exponent}"
                );
            }
        }
    }
}

#[test]
fn what_is_no_camera_is_refused() {
    let lens = perspective(45.0, 0.1, 10.0);
    let camera = |eye, target, up| Camera::new(eye, target, up, lens).map(|_| ());
    let (origin, x, y) = (DVec3::ZERO, DVec3::X, DVec3::Y);
    assert_eq!(camera(origin, origin, y), Err(CameraError::NoDirection));
    assert_eq!(camera(origin, y, y), Err(CameraError::UpAlongForward));
    assert_eq!(
        camera(origin, -3.0 * y, y),
        Err(CameraError::UpAlongForward)
    );
    assert_eq!(
        camera(origin, x, DVec3::ZERO),
        Err(CameraError::UpAlongForward)
    );
    let slanted = dvec3(0.1, 0.7, -0.3);
    assert_eq!(
        camera(origin, 7.0 * slanted, slanted),
        Err(CameraError::UpAlongForward)
    );
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.3e33] {
        let bad = dvec3(0.0, bad, 1.0);
        assert_eq!(camera(bad, x, y), Err(CameraError::OutOfRange("eye")));
        assert_eq!(
            camera(origin, bad, y),
            Err(CameraError::OutOfRange("target"))
        );
        assert_eq!(
            camera(origin, x, bad),
            Err(CameraError::OutOfRange("up vector"))
        );
        let looking = Camera::looking(origin, bad, y, lens);
        assert_eq!(looking, Err(CameraError::OutOfRange("direction")));
    }
    assert_eq!(Viewport::new(0, 5), Err(CameraError::EmptyViewport(0, 5)));
    assert_eq!(Viewport::new(5, 0), Err(CameraError::EmptyViewport(5, 0)));
}

#[test]
fn what_is_no_lens_is_refused() {
    for fov in [0.0, -1.0, 5e-32, 180.0, 360.0, f64::NAN, f64::INFINITY] {
        let check = perspective(fov, 0.1, 10.0).stored();
        assert!(
            matches!(check, Err(CameraError::FieldOfView(_))),
            "{fov}: {check:?}"
        );
    }
    for height in [0.0, -1.0, 1e-33, 1.3e33, f64::NAN, f64::INFINITY] {
        let check = orthographic(height, 0.1, 10.0).stored();
        assert!(
            matches!(check, Err(CameraError::Height(_))),
            "{height}: {check:?}"
        );
    }
    for near in [0.0, -1.0, 7e-34] {
        let check = perspective(45.0, near, 10.0).stored();
        assert!(
            matches!(check, Err(CameraError::NearTooSmall(_))),
            "{near}: {check:?}"
        );
    }
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1.3e33] {
        for lens in [
            perspective(45.0, bad, 10.0),
            perspective(45.0, 1.0, bad),
            orthographic(2.0, bad, 10.0),
            orthographic(2.0, 1.0, bad),
        ] {
            let check = lens.stored();
            assert!(
                matches!(check, Err(CameraError::PlaneOutOfRange(_))),
                "{bad}: {check:?}"
            );
        }
    }
    for (near, far) in [(1.0, 1.0), (2.0, 1.0)] {
        for lens in [perspective(45.0, near, far), orthographic(2.0, near, far)] {
            let check = lens.stored();
            assert!(
                matches!(check, Err(CameraError::NearNotBeforeFar { .. })),
                "{near} {far}: {check:?}"
            );
        }
    }
    for far in [-1.0, 0.0, 7e-34, range::LEAST] {
        let check = perspective(45.0, far - 0.1, far).stored();
        assert_eq!(check, Err(CameraError::FarTooSmall(far)));
    }
    // Numbers are compared as they are stored, the smallest as 0.
    for (near, far) in [(-1e-40, 1e-40), (0.0, 1e-40), (-7e-34, 7e-34)] {
        let check = orthographic(2.0, near, far).stored();
        let [near, far] = [0.0; 2];
        assert_eq!(check, Err(CameraError::NearNotBeforeFar { near, far }));
    }
    let behind = orthographic(2.0, -5.0, -1.0);
    assert_eq!(behind.stored(), Ok(behind));
    let begins_at_the_eye = orthographic(2.0, 1e-40, 1.0);
    assert_eq!(begins_at_the_eye.stored().map(|lens| lens.near), Ok(0.0));
}
