//! One camera for picture and pick: matrices and rays agree with each other and with the textbook.
#![cfg(feature = "window")]

mod common;

use common::{Random, assert_close, assert_near, orthographic, perspective, view};
use glam::{DMat4, DVec2, DVec3, DVec4, Vec4Swizzles, dcamera::rh, dvec2, dvec3};
use sightline::camera::{Camera, CameraError, DepthMapping, Lens, Projection, View, Viewport};

const MAPPINGS: [DepthMapping; 2] = [DepthMapping::Reversed, DepthMapping::Standard];

fn with_depth(lens: Lens, depth: DepthMapping) -> Lens {
    Lens { depth, ..lens }
}

/// Views through both lenses and mappings, over fields of view and distances from the origin.
fn views() -> Vec<View> {
    let mut random = Random::new(1);
    let mut views = Vec::new();
    for far_out in [0.0, 1e3, 1e6] {
        for fov in [0.5, 30.0, 90.0, 178.0] {
            for depth in MAPPINGS {
                for lens in [perspective(fov, 0.1, 100.0), orthographic(fov, -3.0, 100.0)] {
                    let eye = far_out * random.direction() + random.point(2.0);
                    let target = eye + random.within(0.5, 20.0) * random.direction();
                    let lens = with_depth(lens, depth);
                    views.push(view(eye.into(), target.into(), lens, [640, 360]));
                }
            }
        }
    }
    views
}

/// A point's NDC by the matrix that the GPU gets, not by `Camera::project`.
fn through_matrix(view: &View, point_world: DVec3) -> DVec3 {
    let clip: DVec4 =
        view.camera.projection(view.viewport) * view.camera.view() * point_world.extend(1.0);
    clip.xyz() / clip.w
}

#[test]
fn a_segment_is_shown_from_the_near_plane_on() {
    let seen = view(
        [0.0; 3],
        [0.0, 0.0, -1.0],
        perspective(90.0, 1.0, 10.0),
        [100, 100],
    );
    let px = |point: DVec3| seen.project(point).unwrap().px;
    // From depth 5 to depth -1: the near plane, at depth 1, cuts it after two thirds of the way.
    let (shown, behind) = (dvec3(4.0, 2.0, -5.0), dvec3(0.0, -2.0, 1.0));
    let cut = px(dvec3(4.0 / 3.0, -2.0 / 3.0, -1.0));
    let [first, last] = seen.project_segment(shown, behind).unwrap();
    assert_near(first.extend(0.0), px(shown).extend(0.0), 1e-9);
    assert_near(last.extend(0.0), cut.extend(0.0), 1e-9);
    let [first, last] = seen.project_segment(behind, shown).unwrap();
    assert_near(first.extend(0.0), cut.extend(0.0), 1e-9);
    assert_near(last.extend(0.0), px(shown).extend(0.0), 1e-9);
    let beside = shown + DVec3::X;
    let whole = seen.project_segment(shown, beside).unwrap();
    assert_eq!(whole, [px(shown), px(beside)]);
    assert!(seen.project_segment(behind, DVec3::ZERO).is_none());
}

#[test]
fn worked_values_of_the_course() {
    let standard = |lens| with_depth(lens, DepthMapping::Standard);
    let square = [100, 100];
    // Eye at the origin, R = +x, U = +y, F = -z.
    let perspective = standard(perspective(90.0, 1.0, 10.0));
    let seen = view([0.0; 3], [0.0, 0.0, -1.0], perspective, square);
    let expected = dvec3(-0.5, 0.75, 5.0 / 9.0);
    let point = dvec3(-1.0, 1.5, -2.0);
    assert_near(seen.project(point).unwrap().ndc, expected, 1e-12);
    assert_near(through_matrix(&seen, point), expected, 1e-12);

    let orthographic = standard(orthographic(20.0, 1.0, 10.0));
    let seen = view([0.0; 3], [0.0, 0.0, -1.0], orthographic, square);
    let expected = dvec3(-0.2, 0.5, -1.0 / 18.0);
    let point = dvec3(-2.0, 5.0, -0.5);
    assert_near(seen.project(point).unwrap().ndc, expected, 1e-12);
    assert_near(through_matrix(&seen, point), expected, 1e-12);
}

#[test]
fn projection_times_view_is_glams() {
    for view in views() {
        let lens = view.camera.lens();
        let Lens { near, far, .. } = *lens;
        let aspect = view.viewport.aspect();
        let of_planes = |near, far| match lens.projection {
            Projection::Perspective { fov_y } => {
                rh::proj::directx::perspective(fov_y, aspect, near, far)
            }
            Projection::Orthographic { height } => {
                let (top, right) = (0.5 * height, 0.5 * height * aspect);
                rh::proj::directx::orthographic(-right, right, -top, top, near, far)
            }
        };
        // Reversed depth is 1 - z: the same projection with near and far exchanged.
        let theirs = match lens.depth {
            DepthMapping::Standard => of_planes(near, far),
            DepthMapping::Reversed => of_planes(far, near),
        };
        let camera = &view.camera;
        let theirs = theirs * rh::view::look_to_mat4(camera.eye(), camera.forward(), camera.up());
        let ours = camera.projection(view.viewport) * camera.view();
        // Entries are sums of products. Their rounding error scales with the row's largest entry.
        for row in 0..4 {
            let (ours, theirs) = (ours.row(row), theirs.row(row));
            let error = (ours - theirs).abs().max_element();
            assert!(
                error <= 1e-12 * theirs.abs().max_element(),
                "{ours} is not {theirs}"
            );
        }
        assert_close(camera.view().determinant(), -1.0, 1e-12);
    }
}

#[test]
fn corners_of_the_frustum_are_corners_of_ndc() {
    for depth in MAPPINGS {
        for lens in [perspective(60.0, 0.5, 50.0), orthographic(7.0, -2.0, 50.0)] {
            let lens = with_depth(lens, depth);
            let view = view([3.0, -2.0, 5.0], [0.5, 1.0, -4.0], lens, [320, 200]);
            let camera = &view.camera;
            for (z, ndc_z) in match depth {
                DepthMapping::Standard => [(lens.near, 0.0), (lens.far, 1.0)],
                DepthMapping::Reversed => [(lens.near, 1.0), (lens.far, 0.0)],
            } {
                for (sx, sy) in [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)] {
                    let top = match lens.projection {
                        Projection::Perspective { fov_y } => z * (0.5 * fov_y).tan(),
                        Projection::Orthographic { height } => 0.5 * height,
                    };
                    let aside = sx * top * 1.6 * camera.right() + sy * top * camera.up();
                    let corner = camera.eye() + z * camera.forward() + aside;
                    let expected = dvec3(sx, sy, ndc_z);
                    assert_near(through_matrix(&view, corner), expected, 1e-12);
                    assert_near(view.project(corner).unwrap().ndc, expected, 1e-12);
                }
            }
        }
    }
}

#[test]
fn a_pixels_ray_leads_to_points_that_project_to_the_pixel() {
    let mut random = Random::new(2);
    for view in views() {
        let far_out = view.camera.eye().length().max(1.0);
        for _ in 0..50 {
            let px = dvec2(random.within(0.0, 640.0), random.within(0.0, 360.0));
            let ray = view.ray(px);
            let t = random.within(ray.t_min, ray.t_max);
            let shown = view.project(ray.at(t)).unwrap();
            // A world point is rounded to 1e-16 of its coordinates. On an oblique ray an error in depth moves it
            // further aside.
            let half = view.camera.lens().half_extent(1.0).y;
            let distance = t.abs() * ray.direction.length();
            let (world_per_px, oblique) = match view.camera.lens().projection {
                Projection::Perspective { .. } => {
                    (shown.depth * 2.0 * half / 360.0, distance / shown.depth)
                }
                Projection::Orthographic { .. } => (2.0 * half / 360.0, 1.0),
            };
            let bound = 1e-10 + 1e-15 * oblique * (far_out + distance) / world_per_px;
            assert!(
                shown.px.distance(px) <= bound,
                "{px} came back as {} ({bound})",
                shown.px
            );
            let near_enough = 1e-12 * t.abs() + 1e-15 * far_out;
            assert!((shown.depth - t).abs() <= near_enough);
        }
    }
}

#[test]
fn the_courses_ray_is_the_eye_basis() {
    let mut random = Random::new(3);
    for fov in [0.5, 45.0, 120.0, 178.0] {
        for _ in 0..100 {
            let (eye, target) = (random.point(5.0), random.point(5.0));
            let view = view(
                eye.into(),
                target.into(),
                perspective(fov, 0.1, 10.0),
                [300, 200],
            );
            let px = dvec2(random.within(0.0, 300.0), random.within(0.0, 200.0));
            // p = target + sx H + sy V on the plane through the target, as the course has it.
            let len = eye.distance(target);
            let tan = (0.5 * fov.to_radians()).tan();
            let h = view.camera.right() * len * 1.5 * tan;
            let v = view.camera.up() * len * tan;
            let (sx, sy) = (2.0 * px.x / 300.0 - 1.0, 1.0 - 2.0 * px.y / 200.0);
            let direction = (target + sx * h + sy * v - eye).normalize();
            assert_near(view.ray(px).direction.normalize(), direction, 1e-13);
        }
    }
}

#[test]
fn rays_begin_and_end_on_the_planes() {
    for view in views() {
        let Lens { near, far, .. } = *view.camera.lens();
        let (eye, forward) = (view.camera.eye(), view.camera.forward());
        for px in [
            DVec2::ZERO,
            dvec2(320.0, 180.0),
            dvec2(640.0, 0.0),
            dvec2(639.5, 359.5),
        ] {
            let ray = view.ray(px);
            for (t, depth) in [(ray.t_min, near), (ray.t_max, far)] {
                // Relative to the eye, which need not be near the origin.
                let from_eye = (ray.origin - eye) + t * ray.direction;
                let error = (from_eye.dot(forward) - depth).abs();
                let size = from_eye.length() + 1e-3 * eye.length();
                assert!(error <= 1e-13 * size, "{error} off the plane at {depth}");
            }
            // The parameter is view depth.
            assert_close(ray.direction.dot(forward), 1.0, 1e-12);
        }
    }
}

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
    // Squares of these lengths overflow or vanish.
    for size in [1e-200, 1e200] {
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
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let bad = dvec3(0.0, bad, 1.0);
        assert_eq!(camera(bad, x, y), Err(CameraError::NotFinite("eye")));
        assert_eq!(
            camera(origin, bad, y),
            Err(CameraError::NotFinite("target"))
        );
        assert_eq!(
            camera(origin, x, bad),
            Err(CameraError::NotFinite("up vector"))
        );
        let looking = Camera::looking(origin, bad, y, lens);
        assert_eq!(looking, Err(CameraError::NotFinite("direction")));
    }
    assert_eq!(Viewport::new(0, 5), Err(CameraError::EmptyViewport(0, 5)));
    assert_eq!(Viewport::new(5, 0), Err(CameraError::EmptyViewport(5, 0)));
}

#[test]
fn what_is_no_lens_is_refused() {
    for fov in [0.0, -1.0, 180.0, 360.0, f64::NAN, f64::INFINITY] {
        let check = perspective(fov, 0.1, 10.0).check();
        assert!(
            matches!(check, Err(CameraError::FieldOfView(_))),
            "{fov}: {check:?}"
        );
    }
    for height in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let check = orthographic(height, 0.1, 10.0).check();
        assert!(
            matches!(check, Err(CameraError::Height(_))),
            "{height}: {check:?}"
        );
    }
    for near in [0.0, -1.0, f64::NAN, f64::NEG_INFINITY] {
        let check = perspective(45.0, near, 10.0).check();
        assert!(
            matches!(check, Err(CameraError::NearNotPositive(_))),
            "{near}: {check:?}"
        );
    }
    let unordered = [
        (1.0, 1.0),
        (2.0, 1.0),
        (1.0, f64::NAN),
        (1.0, f64::INFINITY),
    ];
    for (near, far) in unordered {
        for lens in [perspective(45.0, near, far), orthographic(2.0, near, far)] {
            let check = lens.check();
            assert!(
                matches!(check, Err(CameraError::NearNotBeforeFar { .. })),
                "{near} {far}: {check:?}"
            );
        }
    }
    assert!(orthographic(2.0, f64::NAN, 1.0).check().is_err());
    assert!(orthographic(2.0, f64::NEG_INFINITY, 1.0).check().is_err());
    assert_eq!(orthographic(2.0, -5.0, -1.0).check(), Ok(()));
}

#[test]
fn orthographic_planes_may_lie_behind_the_eye() {
    for (near, far) in [(-5.0, 5.0), (-5.0, 20.0), (-5.0, -1.0)] {
        let view = view(
            [1.0, 2.0, 3.0],
            [0.0; 3],
            orthographic(4.0, near, far),
            [200, 100],
        );
        let (eye, forward) = (view.camera.eye(), view.camera.forward());
        for (depth, ndc_z) in [(near, 1.0), (far, 0.0), (0.5 * (near + far), 0.5)] {
            let shown = view.project(eye + depth * forward).unwrap();
            assert!((shown.ndc - dvec3(0.0, 0.0, ndc_z)).length() <= 1e-14);
            assert!(shown.px.distance(dvec2(100.0, 50.0)) <= 1e-12);
        }
        let ray = view.ray(dvec2(3.5, 7.5));
        assert_close(ray.t_min, near, 1e-15);
        assert_close(ray.t_max, far, 1e-15);
        assert!(
            (ray.origin - eye).dot(forward).abs() <= 1e-15,
            "it starts on the eye's plane"
        );
    }
}

#[test]
fn extreme_lenses_never_give_nan() {
    let finite = |m: DMat4| m.to_cols_array().iter().all(|entry| entry.is_finite());
    for depth in MAPPINGS {
        for (near, far) in [
            (1e-30, 1e30),
            (1e-5, 1e8),
            (1e199, 1e200),
            (1e-200, 1e-199),
            (1.0, 1.0 + 1e-15),
        ] {
            for lens in [
                perspective(45.0, near, far),
                orthographic(1.0, near, far),
                orthographic(1e-30, -far, far),
            ] {
                let lens = with_depth(lens, depth);
                assert_eq!(lens.check(), Ok(()));
                let view = view([0.0; 3], [0.0, 0.0, -1.0], lens, [64, 64]);
                assert!(finite(view.camera.projection(view.viewport)), "{lens:?}");
                let ray = view.ray(dvec2(0.0, 0.0));
                assert!(
                    ray.direction.is_finite() && ray.t_min.is_finite() && ray.t_max.is_finite()
                );
                for (z, ndc) in [
                    (lens.near, depth == DepthMapping::Reversed),
                    (lens.far, depth == DepthMapping::Standard),
                ] {
                    let error = (lens.ndc_depth(z) - f64::from(u8::from(ndc))).abs();
                    // Where near and far agree to 15 digits, depth cannot tell them apart.
                    assert!(
                        error <= if far < 1.1 * near { 1.0 } else { 1e-10 },
                        "{lens:?} {z}: {error}"
                    );
                }
            }
        }
    }
}
