//! Each colour has one meaning, light leaves nothing black, and a selected surface stays recognisable.

use super::*;
use sightline::{
    camera::{CameraChoice, Viewport},
    colour::Srgb,
    look,
    scene::Progress,
};
use std::fs;

/// Oklab: lightness and two opponent colours, with perceptual distances (Ottosson, A perceptual color space for image
/// processing, 2020).
fn oklab(colour: Srgb) -> [f32; 3] {
    let [r, g, b] = colour.to_linear();
    let [l, m, s] = [
        0.412_221_46 * r + 0.536_332_55 * g + 0.051_445_995 * b,
        0.211_903_5 * r + 0.680_699_5 * g + 0.107_396_96 * b,
        0.088_302_46 * r + 0.281_718_85 * g + 0.629_978_7 * b,
    ]
    .map(f32::cbrt);
    [
        0.210_454_26 * l + 0.793_617_8 * m - 0.004_072_047 * s,
        1.977_998_5 * l - 2.428_592_2 * m + 0.450_593_7 * s,
        0.025_904_037 * l + 0.782_771_77 * m - 0.808_675_77 * s,
    ]
}

/// The colours that have a meaning. What is under the cursor is lit instead.
const MEANINGS: [Srgb; 19] = [
    look::SELECTION,
    look::HIT,
    look::AXES[0],
    look::AXES[1],
    look::AXES[2],
    look::CAMERA,
    look::NORMALS,
    look::BOXES,
    look::TREE,
    look::EDGE,
    look::DEPTH,
    look::AT_SECTION,
    look::F32_LIMIT,
    look::BEYOND_F32,
    look::IN_ONE_PLACE,
    look::WRONG,
    look::INSIDE,
    look::WARNING[0],
    look::WARNING[1],
];

/// Colours of `look` without a meaning of their own: the grid, and the pixels of a camera.
const OTHERS: usize = 2;

#[test]
fn no_two_meanings_have_colours_that_look_alike() {
    let look = include_str!("../../src/look.rs").lines();
    let is_colour = |line: &&str| line.starts_with("pub const ") && line.contains("Srgb");
    // `AXES` holds three colours and `WARNING` two, so there are three colours more than names.
    let colours = look.filter(is_colour).count() - OTHERS + 3;
    assert_eq!(colours, MEANINGS.len(), "each colour is listed");
    for (i, a) in MEANINGS.into_iter().enumerate() {
        for b in &MEANINGS[..i] {
            let pairs = oklab(a).into_iter().zip(oklab(*b));
            let apart = pairs.map(|(a, b)| (a - b).powi(2)).sum::<f32>().sqrt();
            assert!(apart > 0.1, "{a:?} and {b:?} are {apart} apart");
        }
    }
}

/// What lines and outlines mean can be seen on each background: the contrast ratio of WCAG 2 is at least 1.8.
#[test]
fn lines_show_on_each_background() {
    let lines: Vec<_> = (MEANINGS[..9].iter().copied())
        .filter(|colour| *colour != look::HIT)
        .collect();
    assert_eq!((lines.len(), lines[7]), (8, look::TREE));
    for background in [Background::DARK, Background::LIGHT, Background::WHITE] {
        for (colour, down) in lines.iter().flat_map(|line| [(*line, 0.0), (*line, 1.0)]) {
            let [line, behind] =
                [background.over(colour), background.at(down)].map(|c| look::luminance(c) + 0.05);
            let contrast = (line / behind).max(behind / line);
            assert!(contrast > 1.8, "{colour:?} on {background:?}: {contrast}");
        }
    }
    let [black, grey] = [Background::BLACK, Background::GREY].map(|on| on.over(look::CAMERA));
    assert_eq!(black.map(f32::to_bits), grey.map(f32::to_bits));
}

/// Files that colour pictures use named colours of `look`.
#[test]
fn colours_of_pictures_stand_in_one_place() {
    let folders = ["render", "verify", "viewer/screen"].map(|name| format!("src/{name}"));
    let files = folders
        .iter()
        .flat_map(|folder| fs::read_dir(folder).expect("a folder"));
    let files = files.map(|entry| entry.expect("a file").path());
    let panels = ["marks", "axis_cross", "exhibit"]
        .map(|name| format!("src/viewer/ui/panels/{name}.rs").into());
    let mut seen = 0;
    for path in files.chain(panels) {
        let Ok(text) = fs::read_to_string(&path) else {
            continue;
        };
        seen += 1;
        let own = text.split("#[cfg(test)]").next().unwrap_or_default();
        for literal in ["Srgb([", "from_rgb("] {
            let is_ours = path.ends_with("exhibit.rs") && own.matches(literal).count() == 1;
            assert!(is_ours || !own.contains(literal), "{}", path.display());
        }
    }
    assert!(seen > 30, "{seen} files");
}

/// From anywhere around the demo, no pixel of an object has a luminance below this; white has 1.
const NEAR_BLACK: f32 = 0.025;

#[test]
fn no_face_of_the_demo_is_near_black() {
    let demo = sightline::scene::load(&[], &Progress::default()).expect("the demo");
    let viewport = Viewport::new(120, 90).expect("a viewport");
    let (mut seen, mut darkest) = (0, f32::INFINITY);
    for i in 0..24_u8 {
        let (sin, cos) = (f64::from(i) * 0.7).sin_cos();
        let eye = DVec3::new(9.0 * cos, f64::from(i % 6) * 2.0 - 3.0, 9.0 * sin);
        let choice = CameraChoice {
            eye: Some(eye),
            target: Some(DVec3::new(0.0, 0.7, 0.0)),
            ..CameraChoice::default()
        };
        let camera = choice.resolve(&demo.scene.visible_bounds(), viewport);
        let view = View {
            camera: camera.expect("a camera"),
            viewport,
            sides: Sides::Both,
            section: None,
        };
        let (ids, colours) = pick::raycast(&demo.scene, &view, Background::DARK);
        for (id, colour) in ids.pixels().iter().zip(colours.pixels()) {
            if id.object > 0 {
                seen += 1;
                darkest = darkest.min(look::luminance(Srgb(*colour).to_linear()));
            }
        }
    }
    assert!(seen > 24 * 1000, "{seen} pixels");
    assert!(darkest > NEAR_BLACK, "{darkest}");
}

/// A selected surface is as bright as before and near its own colour, so that form, shading and colour can still be
/// seen. The adapter draws what `look` computes.
#[test]
fn a_selected_surface_keeps_its_colour() {
    let gpu = gpu();
    let scene = shapes(DVec3::ZERO);
    let view = overview([320, 200]);
    for object in [2, 6, 9] {
        let marks = Marks {
            selection: vec![object],
            hover: None,
        };
        let (ids, plain, picture) = draw(&gpu, &scene, &view, &[], &marks, 1);
        let id = u32::try_from(object + 1).expect("small");
        let within = |&(x, y): &(u32, u32)| {
            let mut around = (0..9).flat_map(|i| (0..9).map(move |j| (i, j)));
            around.all(|(i, j)| {
                let at = (x + i).checked_sub(4).zip((y + j).checked_sub(4));
                at.is_some_and(|(x, y)| x < 320 && y < 200 && ids.at(x, y).object == id)
            })
        };
        let mut seen = 0;
        for (x, y) in ids.positions().filter(within) {
            let (before, after) = (Srgb(plain.at(x, y)), Srgb(picture.at(x, y)));
            let expected = Srgb::from_linear(look::tinted(before.to_linear()));
            assert!(!apart(expected.0, after.0, 1), "{before:?}, {after:?}");
            assert_ne!(before, after, "it is tinted");
            let [was, is] = [before, after].map(oklab);
            assert!((was[0] - is[0]).abs() < 0.03, "{before:?}, {after:?}");
            let shift = (was[1] - is[1]).hypot(was[2] - is[2]);
            assert!(shift < 0.06, "{before:?}, {after:?}: {shift}");
            seen += 1;
        }
        assert!(seen > 100, "{seen} pixels of {object}");
    }
}
