//! A pixel's ray leads back to the pixel, and begins and ends on the planes, through any lens.

use super::{
    MAPPINGS,
    common::{Random, assert_close, assert_near, orthographic, perspective, view},
    views, with_depth,
};
use glam::{DMat4, DVec2, dvec2, dvec3};
use sightline::camera::{DepthMapping, Lens, Projection};

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
            (1e32, 1e33),
            (1e-33, 1e-32),
            (1.0, 1.0 + 1e-15),
        ] {
            for lens in [
                perspective(45.0, near, far),
                orthographic(1.0, near, far),
                orthographic(1e-30, -far, far),
            ] {
                let lens = with_depth(lens, depth);
                assert_eq!(lens.stored(), Ok(lens));
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
