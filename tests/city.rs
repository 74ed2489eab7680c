//! A city in map coordinates is drawn like the same city at the origin, and is picked to the millimetre.
#![cfg(feature = "window")]

mod common;
#[path = "common/scenes.rs"]
mod scenes;

use common::{perspective, view};
use glam::{DVec3, dvec3};
use sightline::{
    camera::View,
    image::{Id, Image, Rgb},
    look::Background,
    pick, render,
    scene::{Progress, Scene, load},
};
use std::fmt::Write;

/// Buildings along each side of the city.
const SIDE: u32 = 40;
/// UTM easting, northing and height of the city's corner.
const CITY: DVec3 = dvec3(447_000.0, 5_350_000.0, 250.0);

/// The middle of a building's roof, relative to the city's corner, in whole millimetres.
fn roof(i: u32, j: u32) -> DVec3 {
    let height = 3.0 + f64::from((i * 7 + j * 13) % 29) + 0.125;
    dvec3(
        25.037 * f64::from(i) + 6.011,
        25.041 * f64::from(j) + 7.003,
        height,
    )
}

fn blocks() -> impl Iterator<Item = (u32, u32)> {
    (0..SIDE).flat_map(|i| (0..SIDE).map(move |j| (i, j)))
}

/// The city with its corner at `at`, through a file whose coordinates have three decimals.
fn city(at: DVec3) -> Scene {
    let mut text = String::new();
    for (i, j) in blocks() {
        writeln!(text, "o block {i} {j}").expect("text");
        let roof = at + roof(i, j);
        for z in [at.z, roof.z] {
            for (x, y) in [(-6.0, -7.0), (6.0, -7.0), (6.0, 7.0), (-6.0, 7.0)] {
                writeln!(text, "v {:.3} {:.3} {z:.3}", roof.x + x, roof.y + y).expect("text");
            }
        }
        text += "f -4 -3 -2 -1\nf -8 -7 -3 -4\nf -7 -6 -2 -3\nf -6 -5 -1 -2\nf -5 -8 -4 -1\n";
    }
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("city.obj");
    std::fs::write(&file, text).expect("a file");
    let scene = load(&[file], &Progress::default()).expect("it loads").scene;
    assert_eq!((scene.objects().len(), scene.batches().len()), (1600, 1));
    scene.build_trees();
    scene
}

/// Views from a flight over the city at `at`. Steps are from a millimetre to hundreds of metres.
fn views(at: DVec3) -> impl Iterator<Item = View> {
    [0.0, 0.001, 0.002, 0.05, 1.0, 1.001, 300.0]
        .into_iter()
        .flat_map(move |step| {
            let eye = at + dvec3(-120.0 + step, -80.0 + 0.3 * step, 90.0 + 0.1 * step);
            let close = at + dvec3(-4.0 + step, 0.5, 12.0);
            [
                (eye, at + dvec3(400.0, 400.0, 0.0)),
                (close, close + dvec3(1.0, 0.9, -0.2)),
            ]
            .map(|(eye, target)| {
                let lens = perspective(45.0, 0.5, 3000.0);
                view(eye.to_array(), target.to_array(), lens, [320, 200])
            })
        })
}

#[test]
fn a_far_city_is_drawn_as_a_near_one() {
    let gpu = scenes::gpu();
    let (far, near) = (city(CITY), city(DVec3::ZERO));
    let (mut all, mut differing) = (0, 0);
    for (far_view, near_view) in views(CITY).zip(views(DVec3::ZERO)) {
        let draw =
            |city, view| render::render(&gpu, city, &view, None, Background::DARK).expect("drawn");
        let (far, near) = (draw(&far, far_view), draw(&near, near_view));
        let pixels = |(ids, colours): &(Image<Id>, Image<Rgb>)| {
            let pixels = ids
                .pixels()
                .iter()
                .copied()
                .zip(colours.pixels().iter().copied());
            pixels.collect::<Vec<_>>()
        };
        let (far, near) = (pixels(&far), pixels(&near));
        assert!(
            far.iter().any(|(id, _)| id.object > 0),
            "something is there"
        );
        all += far.len();
        differing += far
            .iter()
            .zip(&near)
            .filter(|(far, near)| far != near)
            .count();
    }
    // The two cities' vertices are `f32` relative to different origins: rounding moves each by up to 0.03 mm.
    assert!(100_000 * differing <= all, "{differing} of {all} pixels");
}

#[test]
fn walls_and_roofs_are_picked_to_the_millimetre_in_the_files_coordinates() {
    let scene = city(CITY);
    for (side, normal) in [
        (dvec3(-6.0, 1.234, -1.5), DVec3::NEG_X),
        (dvec3(2.345, -7.0, -1.5), DVec3::NEG_Y),
        (dvec3(2.345, -1.234, 0.0), DVec3::Z),
    ] {
        let (mut picked, mut worst) = (0, 0.0_f64);
        for (view, (i, j)) in views(CITY).flat_map(|view| blocks().map(move |block| (view, block)))
        {
            let point = CITY + roof(i, j) + side;
            let at = view.project(point);
            let Some(at) = at.filter(|at| view.viewport.contains(at.px)) else {
                continue;
            };
            let pick = pick::pick(&scene, &view, at.px).expect("this block, or one before it");
            if pick.object == format!("block {i} {j}") && pick.normal_world.dot(normal) > 0.9 {
                picked += 1;
                worst = worst.max(pick.point_world.distance(point));
            }
        }
        assert!(
            picked > 300 && worst < 1e-3,
            "{picked} points, {worst} m off"
        );
    }
}
