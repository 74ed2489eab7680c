//! Verify finds every broken picker, each with a typical bug, on a view where the right picker passes.

use crate::{common, compare, drawn_once, scenes::shapes};
use glam::{DAffine3, DVec2, DVec3, dvec3};
use sightline::{
    camera::{DepthMapping, Lens, View},
    geometry::{Placement, Ray, Sides},
    pick::{self, SceneHit, closest},
    scene::{Object, Scene, Shape},
    study::methods::usual,
    verify::{Class, Verdict},
};

const SIZE: [u32; 2] = [320, 240];

fn overview() -> View {
    let lens = common::perspective(45.0, 1.0, 30.0);
    common::view([3.5, 2.8, 5.6], [0.0, 0.0, 0.0], lens, SIZE)
}

/// Asserts that on a view Sightline's own picker agrees, and that `broken` leaves at least `least` pixels unexplained.
#[track_caller]
fn found_out(
    scene: &Scene,
    view: &View,
    least: usize,
    broken: impl Fn(DVec2) -> Option<SceneHit> + Sync,
) {
    let drawn = drawn_once(scene, view);
    let right = compare(scene, view, &drawn, &pick::ids(scene, view));
    let shown = right.drawn.min(right.picked);
    assert!(shown > 1000, "only {shown} pixels show anything");
    assert_eq!(right.verdict(), Verdict::Agrees, "{:?}", right.worst());
    let wrong = compare(scene, view, &drawn, &pick::ids_by(scene, view, broken));
    let unexplained = wrong.count(Class::Unexplained);
    println!(
        "{unexplained} of {} pixels that differ are unexplained",
        wrong.disagreements.len()
    );
    assert!(
        unexplained >= least,
        "only {unexplained} pixels are found out"
    );
}

#[test]
fn the_pixels_corner_in_place_of_its_centre() {
    let (scene, view) = (shapes(DVec3::ZERO), overview());
    found_out(&scene, &view, 1000, |px| {
        closest(&scene, view.ray(px - 0.5), view.sides)
    });
}

#[test]
fn a_hundredth_of_a_pixel_aside() {
    let (scene, view) = (shapes(DVec3::ZERO), overview());
    found_out(&scene, &view, 30, |px| {
        closest(&scene, view.ray(px + 0.01), view.sides)
    });
}

#[test]
fn near_and_far_by_distance_in_place_of_depth() {
    let scene = shapes(DVec3::ZERO);
    let lens = common::perspective(60.0, 5.0, 8.0);
    let view = common::view([3.5, 2.8, 5.6], [0.0, 0.0, 0.0], lens, SIZE);
    let lens = *view.camera.lens();
    found_out(&scene, &view, 500, |px| {
        let along = view.ray(px).direction;
        let ray = Ray {
            t_min: lens.near / along.length(),
            t_max: lens.far / along.length(),
            ..*view.ray(px)
        };
        closest(&scene, ray, view.sides)
    });
}

#[test]
fn no_near_plane() {
    let scene = shapes(DVec3::ZERO);
    let lens = common::perspective(60.0, 6.0, 30.0);
    let view = common::view([3.5, 2.8, 5.6], [0.0, 0.0, 0.0], lens, SIZE);
    found_out(&scene, &view, 500, |px| {
        let ray = Ray {
            t_min: 0.0,
            ..*view.ray(px)
        };
        closest(&scene, ray, view.sides)
    });
}

#[test]
fn back_faces_where_they_are_culled() {
    let scene = shapes(DVec3::ZERO);
    let view = View {
        sides: Sides::Front,
        camera: overview()
            .camera
            .with_lens(common::perspective(45.0, 6.5, 30.0))
            .expect("a lens"),
        ..overview()
    };
    found_out(&scene, &view, 500, |px| {
        closest(&scene, view.ray(px), Sides::Both)
    });
}

#[test]
fn hidden_objects() {
    let all = shapes(DVec3::ZERO);
    let mut scene = all.clone();
    for index in [1, 2, 6] {
        scene.set_visible(index, false);
    }
    let view = overview();
    found_out(&scene, &view, 1000, |px| {
        closest(&all, view.ray(px), view.sides)
    });
}

/// Each object is twice in the same place, and the first of the two must win everywhere.
#[test]
fn ties_won_by_the_later_object() {
    let once = shapes(DVec3::ZERO).objects().to_vec();
    let count = once.len();
    let scene = Scene::new([once.clone(), once].concat());
    let view = overview();
    found_out(&scene, &view, 10_000, |px| {
        closest(&scene, view.ray(px), view.sides).map(|hit| SceneHit {
            object: hit.object % count + count,
            ..hit
        })
    });
}

#[test]
fn the_surface_behind() {
    let (scene, view) = (shapes(DVec3::ZERO), overview());
    found_out(&scene, &view, 5000, |px| {
        let hits = pick::all(&scene, view.ray(px), view.sides);
        hits.get(1).or(hits.first()).copied()
    });
}

/// The pick is right near the middle, and ever more distorted towards the left and right borders.
#[test]
fn a_wrong_aspect() {
    let (scene, view) = (shapes(DVec3::ZERO), overview());
    found_out(&scene, &view, 500, |px| {
        let middle = DVec2::new(160.0, 120.0);
        closest(
            &scene,
            view.ray(middle + (px - middle) * DVec2::new(1.01, 1.0)),
            view.sides,
        )
    });
}

/// In f32, the inverse of Projection * View contains the eye's large world coordinates.
#[test]
fn rays_in_f32_far_from_the_origin() {
    let center = dvec3(1e6, -2e6, 5e5);
    let scene = shapes(center);
    let lens = common::perspective(45.0, 1.0, 30.0);
    let eye = center + dvec3(3.5, 2.8, 5.6);
    let view = common::view(eye.to_array(), center.to_array(), lens, SIZE);
    found_out(&scene, &view, 5000, |px| usual::closest(&scene, &view, px));
}

#[test]
fn rays_in_f32_through_a_long_lens() {
    let scene = shapes(DVec3::ZERO);
    let lens = common::perspective(0.05, 0.1, 10_000.0);
    let view = common::view([3500.0, 2800.0, 5600.0], [0.0, 0.0, 0.0], lens, SIZE);
    found_out(&scene, &view, 50, |px| usual::closest(&scene, &view, px));
}

#[test]
fn rays_in_f32_between_distant_planes() {
    let scene = shapes(DVec3::ZERO);
    let lens = Lens {
        depth: DepthMapping::Standard,
        ..common::perspective(45.0, 1e-3, 1e3)
    };
    let view = common::view([3.5, 2.8, 5.6], [0.0, 0.0, 0.0], lens, SIZE);
    found_out(&scene, &view, 300, |px| usual::closest(&scene, &view, px));
}

/// Two squares lie 1e-4 apart at depth 10. Reversed depth tells them apart; standard depth with near at 1e-3 does not.
/// The same wrong answer is a defect in the first case and excused in the second.
#[test]
fn an_order_that_the_depth_buffer_can_or_cannot_tell() {
    let square = |z: f64| {
        let model = DAffine3::from_scale_rotation_translation(
            DVec3::splat(4.0),
            glam::DQuat::IDENTITY,
            dvec3(0.0, 0.0, z),
        );
        Object::new(
            "square",
            Shape::Square,
            Placement::new(model).expect("invertible"),
        )
    };
    let scene = Scene::new(vec![square(-1e-4), square(0.0)]);
    for (depth, unexplained) in [
        (DepthMapping::Reversed, true),
        (DepthMapping::Standard, false),
    ] {
        let lens = Lens {
            depth,
            ..common::perspective(45.0, 1e-3, 100.0)
        };
        let view = common::view([0.0, 0.0, 10.0], [0.0, 0.0, 0.0], lens, [160, 120]);
        let right = pick::ids(&scene, &view);
        let swapped = pick::ids_by(&scene, &view, |px| {
            closest(&scene, view.ray(px), view.sides).map(|hit| SceneHit {
                object: 1 - hit.object,
                ..hit
            })
        });
        let report = compare(&scene, &view, &right, &swapped);
        let count = report.count(Class::Unexplained);
        // A few pixels at the rim are excused.
        let expected = if unexplained {
            report.picked * 9 / 10..=report.picked
        } else {
            0..=0
        };
        assert!(report.picked > 3000, "{} picked", report.picked);
        assert!(
            expected.contains(&count),
            "{depth}: {count} of {}",
            report.picked
        );
    }
}

/// A hidden surface's outline explains no difference, even if it passes through pixel centres.
#[test]
fn a_hidden_outline() {
    let square = |z: f64, side: f64| {
        let model = DAffine3::from_scale_rotation_translation(
            DVec3::splat(side),
            glam::DQuat::IDENTITY,
            dvec3(0.0, 0.0, z),
        );
        let placement = Placement::new(model).expect("invertible");
        Object::new("square", Shape::Square, placement)
    };
    let scene = Scene::new(vec![square(0.0, 20.0), square(-1.0, 2.1)]);
    // A pixel is a tenth of a unit: the smaller square's rim runs through pixel centres.
    let lens = common::orthographic(12.0, 1.0, 100.0);
    let view = common::view([0.0, 0.0, 10.0], [0.0, 0.0, 0.0], lens, [160, 120]);
    let drawn = pick::ids(&scene, &view);
    let behind = pick::ids_by(&scene, &view, |px| {
        let hits = pick::all(&scene, view.ray(px), view.sides);
        hits.last().copied()
    });
    let report = compare(&scene, &view, &drawn, &behind);
    assert!(report.disagreements.len() >= 20 * 20, "{report:?}");
    let found = report.count(Class::Unexplained);
    assert_eq!(found, report.disagreements.len(), "{:?}", report.worst());
}
