//! Turning, zooming and panning keep the point under the hand where it belongs, and framing shows everything. `choice`
//! tests planes and flags.
#![cfg(feature = "window")]

mod choice;
#[path = "../common/mod.rs"]
mod common;

use common::{Random, assert_close, assert_near, orthographic, perspective};
use glam::{DVec3, dvec2, dvec3};
use sightline::{
    camera::{Camera, Framing, Lens, Orbit, UpAxis, Viewport, fit_near_far},
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

fn framing(fov_y: f64, aspect: f64) -> Framing {
    Framing {
        fov_y,
        aspect,
        is_parallel: false,
        filled: Framing::FILLED,
    }
}

/// A box as a new scene is framed.
fn framed(bounds: &Aabb, up_axis: UpAxis, framing: &Framing) -> Orbit {
    let mut orbit = Orbit::new(up_axis, Orbit::FROM);
    orbit.frame(bounds, framing);
    orbit
}

/// Orbits as in the window after some turning.
fn orbits() -> Vec<Orbit> {
    let mut random = Random::new(7);
    let mut orbits = Vec::new();
    for up_axis in UP_AXES {
        for offset in [0.0, 1e4] {
            for _ in 0..20 {
                let center = offset * random.direction();
                let bounds = Aabb::around([center, center + random.point(3.0)]);
                let mut orbit = framed(&bounds, up_axis, &framing(0.8, 1.5));
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
            let mut orbit = framed(&unit_box(), up_axis, &framing(0.8, 1.0));
            orbit.look_from(up_axis, DVec3::Z);
            // A turn far past the pole stops at the pole.
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
        let mut orbit = framed(&unit_box(), up_axis, &framing(0.8, 1.0));
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
    // Also cameras that nobody orbited: leaning, upside down, straight down.
    for _ in 0..20 {
        let (eye, up) = (random.point(9.0), random.direction());
        cameras.push(Camera::new(eye, random.point(1.0), up, lens).unwrap());
    }
    cameras.push(Camera::new(DVec3::ZERO, DVec3::Z, DVec3::NEG_Y, lens).unwrap());
    cameras.push(Camera::new(5.0 * DVec3::Y, DVec3::ZERO, dvec3(1.0, 0.0, 1.0), lens).unwrap());
    for up_axis in UP_AXES {
        for camera in &cameras {
            let again = Orbit::of_camera(camera, up_axis).camera(lens).unwrap();
            // The cameras are equal to a few units in the last place of the eye's coordinates, not to the bit.
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

/// Its corners fill 85 % of the width or of the height.
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
                    let frame = Framing {
                        is_parallel: parallel,
                        ..framing(fov_y, size.aspect())
                    };
                    let orbit = framed(&bounds, up_axis, &frame);
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
                    // It fills what it is to fill, unless the lens is so wide that the eye would stand within it.
                    let wide = fov > 90.0 && !parallel;
                    let off = (largest - Framing::FILLED).abs();
                    assert!(
                        extent == 0.0 || wide || off < 1e-6,
                        "{fov} {size:?} {offset}: {largest} of the picture"
                    );
                    let direction = up_axis.frame().transpose() * -camera.forward();
                    let skew = 1e-14 + 1e-15 * offset / orbit.distance();
                    assert_near(direction, dvec3(1.0, 0.8, 1.6).normalize(), skew);
                }
            }
        }
    }
}
