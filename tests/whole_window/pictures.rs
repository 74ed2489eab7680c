//! Panels look as in the pictures that were last approved (`goldens/*.png`), and README's pictures show the window as
//! it is. After a wanted change, run with `SIGHTLINE_GOLDENS=write` and look at each picture.

use super::{
    MIDDLE, ROW, Window, click, click_on, control, has_control, here,
    images::{apart, differing_where, read},
    open, press_key, px, row_as, whole,
};
use egui::{Event, Key, Modifiers, pos2, vec2};
use glam::DVec2;
use sightline::{
    image::{Image, Picture, Rgb},
    look::Backdrop,
    scene::{self, Progress},
    viewer::{Options, model::Views, picture_of_views},
};
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// A part of the window: left, top, width, height in points.
type Part = [u32; 4];

/// The window in the state of the picture, after some keys, the part shown, and the folder of its file: while that is
/// there, no message says that the file is gone.
fn shown(name: &str, keys: &[Key]) -> (Window, Part, TempDir) {
    let (mut window, folder) = row_as(ROW, 1.0);
    click(&mut window, MIDDLE);
    for key in keys {
        press_key(&mut window, Modifiers::NONE, *key);
    }
    // The cursor leaves the window, so that nothing is hovered.
    window.send([Event::PointerGone]);
    let part = match name {
        "panels" => [960, 0, 320, 720],
        "light" => {
            window.set_theme(egui::Theme::Light);
            [960, 0, 320, 720]
        }
        // A menu that is higher than the smallest window is open over it.
        "small" => {
            window.resize(px([640, 400], 1.0));
            click_on(&mut window, "Learn");
            window.send([Event::PointerGone]);
            [0, 0, 640, 400]
        }
        "gallery" => {
            window = open(vec!["gallery:stretched".into()], 1.0);
            press_key(&mut window, Modifiers::NONE, Key::M);
            click(&mut window, pos2(681.0, 330.0));
            window.send([Event::PointerGone]);
            [0, 0, 970, 690]
        }
        "section" => {
            press_key(&mut window, Modifiers::NONE, Key::Num9);
            press_key(&mut window, Modifiers::NONE, Key::Z);
            [260, 0, 1020, 720]
        }
        "pipeline" => {
            press_key(&mut window, Modifiers::NONE, Key::P);
            [960, 25, 320, 670]
        }
        "topics" => {
            window.resize(px([1280, 1500], 1.0));
            for topic in [
                "Pose",
                "Placement",
                "Details",
                "Measure",
                "Section",
                "Depth buffer",
            ] {
                click_on(&mut window, topic);
            }
            // Three points beside the arrows, for all measures.
            for at in [MIDDLE, MIDDLE + vec2(30.0, 30.0), MIDDLE + vec2(5.0, 40.0)] {
                click(&mut window, at + vec2(0.0, 390.0));
            }
            window.send([Event::PointerGone]);
            [960, 0, 320, 1500]
        }
        _ => {
            press_key(&mut window, Modifiers::NONE, Key::H);
            [150, 0, 980, 720]
        }
    };
    (window, part, folder)
}

/// The parts of panels that lie over the scene, opaque and the same with every driver. Counts of pixels are left out,
/// because they differ between drivers.
fn over_the_scene(name: &str) -> &'static [Part] {
    match name {
        // The bar, and the names beside the counts of pixels.
        "gallery" => &[[276, 25, 686, 50], [778, 470, 121, 208]],
        "help" => &[[150, 60, 980, 600]],
        // The menu.
        "small" => &[[196, 30, 150, 340]],
        _ => &[],
    }
}

/// Where the scene is.
fn scene_part(window: &Window, window_height: u32) -> Part {
    /// The height of the status line, below the scene.
    const STATUS: u32 = 25;
    let size = window.state().view().viewport;
    let edge = "edge of the left side";
    let left = if has_control(window, edge) {
        whole(control(window, edge).rect.right_center())[0]
    } else {
        0
    };
    let top = window_height - STATUS - size.height();
    [left, top, size.width(), size.height()]
}

fn holds([left, top, width, height]: Part, [x, y]: [u32; 2]) -> bool {
    (left..left + width).contains(&x) && (top..top + height).contains(&y)
}

/// A picture for a golden, after some keys, and which of its pixels belong to panels. The scene's pixels
/// do not count, because another driver draws them otherwise.
fn pictured(name: &str, keys: &[Key]) -> (Image<Rgb>, Vec<bool>) {
    let (mut window, [left, top, width, height], _folder) = shown(name, keys);
    let whole = window.picture().expect("a picture");
    let scene = scene_part(&window, whole.size().height());
    let over = over_the_scene(name);
    let places = (0..width * height).map(|i| [left + i % width, top + i / width]);
    let is_panels = |at: [u32; 2]| !holds(scene, at) || over.iter().any(|part| holds(*part, at));
    let pixels = places.clone().map(|[x, y]| whole.at(x, y)).collect();
    let picture = Image::new(px([width, height], 1.0), pixels);
    (picture, places.map(is_panels).collect())
}

/// How many of the pixels that count differ. A difference of a few levels is ignored, because drivers blend a level
/// apart. A changed digit is dozens of pixels.
fn differing_visibly(a: &Image<Rgb>, b: &Image<Rgb>, counts: &[bool]) -> usize {
    let width = a.size().width();
    differing_where(a, b, |a, b, [x, y]| {
        counts[(y * width + x) as usize] && apart(a, b, 8)
    })
}

/// Fails if a picture differs from the file at `path` in more than `most` of the pixels that count.
fn compare(picture: &Image<Rgb>, path: &Path, most: usize, counts: &[bool]) {
    if std::env::var_os("SIGHTLINE_GOLDENS").is_some_and(|what| what == "write") {
        return picture.write_png(path).expect("a writable folder");
    }
    let golden = read(path);
    assert_eq!(picture.size(), golden.size(), "{}", path.display());
    let differ = differing_visibly(picture, &golden, counts);
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

fn golden(name: &str) -> PathBuf {
    here("goldens").join(name).with_extension("png")
}

#[test]
fn panels_look_as_they_did() {
    for name in [
        "panels", "topics", "light", "small", "section", "pipeline", "help", "gallery",
    ] {
        let (picture, is_panels) = pictured(name, &[]);
        compare(&picture, &golden(name), 0, &is_panels);
    }
}

/// A scene that is drawn otherwise, as by another driver, does not count as a change of the panels.
#[test]
fn goldens_leave_the_scene_out() {
    for (name, least) in [("small", 100), ("section", 100)] {
        // Wireframe, normals, boxes and the grid are in the scene alone.
        let (picture, is_panels) = pictured(name, &[Key::W, Key::L, Key::X, Key::G]);
        let golden = read(&golden(name));
        assert_eq!(
            differing_visibly(&picture, &golden, &is_panels),
            0,
            "{name}"
        );
        let whole = vec![true; is_panels.len()];
        assert!(
            differing_visibly(&picture, &golden, &whole) > least,
            "{name}"
        );
    }
}

fn compare_whole(picture: &Image<Rgb>, path: &Path, most: usize) {
    compare(picture, path, most, &vec![true; picture.pixels().len()]);
}

/// Compares a picture in README with its window. On the driver that made the picture, a few pixels may differ. Other
/// drivers may draw edges and lines differently.
fn compare_asset(name: &str, mut window: Window) {
    /// Where the edge of a line passes through a sample, processors decide by their own rounding.
    const TIES: usize = 4;
    window.send([Event::PointerGone]);
    let picture = window.picture().expect("a picture");
    let most = if window.adapter_name().contains("llvmpipe") {
        TIES
    } else {
        picture.pixels().len() / 20
    };
    let path = here("../../assets").join(name).with_extension("png");
    compare_whole(&picture, &path, most);
}

/// The demo, in which the cube behind the ring is picked.
#[test]
fn readme_shows_this_window() {
    let mut window = open(Vec::new(), 1.0);
    click(&mut window, pos2(470.0, 255.0));
    compare_asset("window", window);
}

/// The demo's camera, frozen and seen from the side.
#[test]
fn readme_shows_this_frozen_camera() {
    let mut window = open(Vec::new(), 1.0);
    click(&mut window, pos2(590.0, 390.0));
    press_key(&mut window, Modifiers::NONE, Key::T);
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
    let clicked = Some(DVec2::new(820.5, 540.5));
    let picture = picture_of_views(demo, options, size, clicked, Backdrop::Dark);
    let path = here("../../assets/four.png");
    let Ok(Picture::Opaque(picture)) = picture else {
        panic!("{picture:?}");
    };
    compare_whole(&picture, &path, picture.pixels().len() / 20);
}

/// The file is read once: the views show what was loaded, even if the file has changed since.
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
    let of = |loaded| picture_of_views(loaded, options.clone(), size, None, Backdrop::Dark);
    let loaded = load();
    let before = of(load());
    std::fs::remove_file(path).expect("a file");
    assert_eq!(of(loaded).expect("a picture"), before.expect("a picture"));
}
