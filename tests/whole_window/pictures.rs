//! Compares panels with the pictures that were last approved (`goldens/*.png`), and README's pictures with the window.
//! After a wanted change, run with `SIGHTLINE_GOLDENS=write` and look at each.

use super::{
    MIDDLE, click, click_on, drag, here,
    images::{apart, read},
    open, press_key, px, row,
};
use egui::{Event, Key, Modifiers, PointerButton, pos2, vec2};
use glam::DVec2;
use sightline::{
    image::{Image, Rgb},
    scene::{self, Progress},
    viewer::{Offscreen, Options, model::Views, picture_of_views},
};
use std::path::Path;

/// The window in the state of the picture, and the part shown: left, top, width, height in points.
fn shown(name: &str) -> (Offscreen, [u32; 4]) {
    let (mut window, _folder) = row(1.0);
    click(&mut window, MIDDLE);
    // Off the picture, so that nothing is hovered.
    window.send([Event::PointerGone]);
    match name {
        "panels" => (window, [960, 0, 320, 720]),
        "light" => {
            window.set_theme(egui::Theme::Light);
            (window, [960, 0, 320, 720])
        }
        // The list over the right panels, in the smallest window.
        "small" => {
            window.resize(px([640, 400], 1.0));
            click_on(&mut window, "more");
            window.send([Event::PointerGone]);
            (window, [0, 0, 640, 400])
        }
        "gallery" => {
            let mut window = open(vec!["gallery:stretched".into()], 1.0);
            press_key(&mut window, Modifiers::NONE, Key::M);
            click(&mut window, pos2(681.0, 330.0));
            window.send([Event::PointerGone]);
            (window, [0, 0, 970, 690])
        }
        "section" => {
            press_key(&mut window, Modifiers::NONE, Key::Num9);
            press_key(&mut window, Modifiers::NONE, Key::Z);
            (window, [260, 0, 1020, 720])
        }
        "pipeline" => {
            press_key(&mut window, Modifiers::NONE, Key::P);
            (window, [0, 25, 280, 670])
        }
        _ => {
            press_key(&mut window, Modifiers::NONE, Key::H);
            (window, [150, 0, 980, 720])
        }
    }
}

fn crop(picture: &Image<Rgb>, [left, top, width, height]: [u32; 4]) -> Image<Rgb> {
    let pixels = (0..width * height).map(|i| picture.at(left + i % width, top + i / width));
    Image::new(px([width, height], 1.0), pixels.collect())
}

/// Fails if a picture differs from the file at `path` in more than `most` pixels. Drivers blend a level apart, which
/// does not count; a changed digit is dozens of pixels.
fn compare(picture: &Image<Rgb>, path: &Path, most: usize) {
    if std::env::var_os("SIGHTLINE_GOLDENS").is_some_and(|what| what == "write") {
        return picture.write_png(path).expect("a writable folder");
    }
    let golden = read(path);
    assert_eq!(picture.size(), golden.size(), "{}", path.display());
    let pairs = picture.pixels().iter().zip(golden.pixels());
    let differ = pairs.filter(|&(&a, &b)| apart(a, b, 8)).count();
    if differ > most {
        let seen = std::env::temp_dir().join(path.file_name().expect("a name"));
        picture.write_png(&seen).expect("a writable folder");
        panic!(
            "{}: {differ} pixels are not as they were; now: {}",
            path.display(),
            seen.display()
        );
    }
}

#[test]
fn panels_look_as_they_did() {
    for name in [
        "panels", "light", "small", "section", "pipeline", "help", "gallery",
    ] {
        let (mut window, at) = shown(name);
        let picture = crop(&window.picture().expect("a picture"), at);
        let most = if ["panels", "light", "pipeline"].contains(&name) {
            0
        } else {
            most_of_scene(&window, &picture)
        };
        let path = here("goldens").join(name).with_extension("png");
        compare(&picture, &path, most);
    }
}

/// How many pixels of a picture with a scene in it may differ: none on the driver that made it; others may draw the
/// scene's edges and lines differently.
fn most_of_scene(window: &Offscreen, picture: &Image<Rgb>) -> usize {
    if window.adapter_name().contains("llvmpipe") {
        0
    } else {
        picture.pixels().len() / 20
    }
}

/// Compares a picture in README with its window.
fn compare_asset(name: &str, mut window: Offscreen) {
    window.send([Event::PointerGone]);
    let picture = window.picture().expect("a picture");
    let most = most_of_scene(&window, &picture);
    let path = here("../../assets").join(name).with_extension("png");
    compare(&picture, &path, most);
}

/// The demo with the cube behind the ring picked: its outline shows through what hides it.
#[test]
fn readme_shows_this_window() {
    let mut window = open(Vec::new(), 1.0);
    click(&mut window, pos2(440.0, 235.0));
    compare_asset("window", window);
}

/// That camera frozen, seen from the side.
#[test]
fn readme_shows_this_frozen_camera() {
    let mut window = open(Vec::new(), 1.0);
    click(&mut window, pos2(590.0, 390.0));
    press_key(&mut window, Modifiers::NONE, Key::T);
    let from = pos2(500.0, 600.0);
    let to = from + vec2(-130.0, 25.0);
    press_key(&mut window, Modifiers::NONE, Key::A);
    drag(&mut window, PointerButton::Primary, from, to);
    press_key(&mut window, Modifiers::NONE, Key::A);
    let zoom = [Event::PointerMoved(pos2(450.0, 345.0)), Event::Zoom(1.12)];
    window.send(zoom);
    compare_asset("freeze", window);
}

/// A scene on which a method breaks, picked by that method.
#[test]
fn readme_shows_this_gallery() {
    let mut window = open(vec!["gallery:small_and_far".into()], 1.0);
    press_key(&mut window, Modifiers::NONE, Key::M);
    click(&mut window, pos2(345.0, 480.0));
    compare_asset("gallery", window);
}

/// The four views, as the command that README names draws them.
#[test]
fn readme_shows_these_four_views() {
    let options = Options {
        views: Views::Four,
        ..Options::default()
    };
    let size = px([1600, 1000], 1.0);
    let demo = scene::load(&[], &Progress::default()).expect("the demo");
    let picture = picture_of_views(demo, options, size, Some(DVec2::new(820.5, 540.5)));
    let path = here("../../assets/four.png");
    let picture = picture.expect("a picture");
    compare(&picture, &path, picture.pixels().len() / 20);
}

/// The views show what was loaded, even if the file has changed since: it is read once.
#[test]
fn the_views_are_of_what_was_loaded() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("row.toml");
    std::fs::write(&path, super::ROW).expect("a writable folder");
    let paths = vec![path.clone()];
    let load = || scene::load(&paths, &Progress::default()).expect("a scene");
    let options = Options {
        paths: paths.clone(),
        views: Views::Four,
        ..Options::default()
    };
    let size = px([640, 400], 1.0);
    let of = |loaded| picture_of_views(loaded, options.clone(), size, None).expect("a picture");
    let loaded = load();
    let before = of(load());
    std::fs::remove_file(path).expect("a file");
    assert_eq!(of(loaded).pixels(), before.pixels());
}
