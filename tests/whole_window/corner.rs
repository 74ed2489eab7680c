//! The picture carries the mark of a hit, a cross of axes that can be clicked, and the grid's step.

use super::*;
use egui::vec2;
use glam::DVec3;
use sightline::{
    image::{Image, Rgb},
    look,
};

/// The pixel of a window's picture at this offset from the middle of the scene's rectangle.
fn beside(picture: &Image<Rgb>, [x, y]: [i32; 2]) -> Rgb {
    let [column, row] =
        [(590, x), (360, y)].map(|(middle, by): (u32, i32)| middle.strict_add_signed(by));
    picture.at(column, row)
}

fn is_mark(pixel: Rgb) -> bool {
    pixel
        .iter()
        .zip(look::HIT.0)
        .all(|(a, b)| a.abs_diff(b) < 40)
}

/// Whether a pixel has a faint mark: grey.
fn is_faint(pixel: Rgb) -> bool {
    let [least, most] = [u8::min, u8::max].map(|end| pixel.into_iter().reduce(end).expect("three"));
    (100..215).contains(&least) && most - least < 40
}

/// A hit is marked on any shape, here a cube and a sphere. A hit on a back face has another mark, which is faint while
/// the front hides it.
#[test]
fn a_hit_has_a_mark_and_a_back_face_another() {
    hits_are_marked(Key::Num1, "front");
    hits_are_marked(Key::Num9, "middle");
}

/// Checks the marks on both sides of an object that is in the middle of a view.
fn hits_are_marked(view: Key, object: &str) {
    let (mut window, _folder) = row(1.0);
    press_key(&mut window, Modifiers::NONE, view);
    let at = pos2(590.5, 360.5);
    let bare = window.picture().expect("a picture");
    click(&mut window, at);
    window.send([Event::PointerGone]);
    let pick = |window: &Window| window.state().picked().cloned();
    assert!(pick(&window).is_some_and(|hit| hit.front));
    assert_eq!(selected(&window), Some(object));
    let front = window.picture().expect("a picture");
    press_key(&mut window, Modifiers::NONE, Key::N);
    assert!(pick(&window).is_some_and(|hit| !hit.front));
    assert_eq!(selected(&window), Some(object));
    let back = window.picture().expect("a picture");
    // The ring is checked right of the middle and above it, then two pixels inside it.
    let ring = [[7, 0], [0, -7]];
    for ring in ring {
        assert!(!is_mark(beside(&bare, ring)));
        assert!(
            is_mark(beside(&front, ring)) && is_faint(beside(&back, ring)),
            "{ring:?}: {:?} {:?}",
            beside(&front, ring),
            beside(&back, ring)
        );
    }
    assert!(is_mark(beside(&front, [0, 0])) && is_faint(beside(&back, [0, 0])));
    assert!(!is_mark(beside(&front, [3, 3])) && is_faint(beside(&back, [3, 3])));
    // Without a selection there is no mark.
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    let without = window.picture().expect("a picture");
    for at in ring.into_iter().chain([[0, 0], [3, 3]]) {
        assert!(!is_mark(beside(&without, at)), "{at:?}");
    }
}

#[test]
fn a_click_on_an_end_of_the_cross_looks_along_its_axis() {
    let (mut window, folder) = row(1.0);
    let ends = [
        ("x", DVec3::X),
        ("-x", DVec3::NEG_X),
        ("y", DVec3::Y),
        ("-y", DVec3::NEG_Y),
        ("z", DVec3::Z),
        ("-z", DVec3::NEG_Z),
    ];
    let z_up = ROW.replace("[camera]", "[camera]\nup_axis = \"z\"");
    let path = folder.path().join("z_up.toml");
    std::fs::write(&path, z_up).expect("writable");
    for file in [None, Some(path)] {
        if let Some(path) = file {
            window.drop_file(path);
        }
        for (name, axis) in ends {
            // A view in which every end shows.
            press_key(&mut window, Modifiers::NONE, Key::Num9);
            let before = *window.state().view();
            click_on(&mut window, &format!("look from {name}"));
            let forward = window.state().view().camera.forward();
            assert!((forward + axis).length() < 1e-12, "{name}: {forward}");
            press_key(&mut window, CTRL, Key::Z);
            assert_eq!(*window.state().view(), before, "{name} is undone");
            assert_eq!(selected(&window), None, "the click was not the picture's");
        }
    }
}

#[test]
fn an_end_of_the_cross_is_lit_under_the_cursor() {
    let (mut window, _folder) = row(1.0);
    press_key(&mut window, Modifiers::NONE, Key::Num9);
    let bare = window.picture().expect("a picture");
    let end = control(&window, "look from y").rect;
    window.send([Event::PointerMoved(end.center())]);
    let lit = window.picture().expect("a picture");
    let white = |picture: &Image<Rgb>| {
        let [x, y] = whole(end.center() - vec2(5.0, 0.0));
        is_mark(picture.at(x, y))
    };
    assert!(white(&lit) && !white(&bare));
}

#[test]
fn the_grid_says_its_step() {
    let mut window = open(Vec::new(), 1.0);
    assert!(has_control(&window, "grid step 1 unit"));
    // Hiding the largest object does not change it.
    click_on(&mut window, "Ground");
    assert_eq!(selected(&window), Some("Ground"));
    press_key(&mut window, Modifiers::SHIFT, Key::H);
    assert!(has_control(&window, "grid step 1 unit"));
    press_key(&mut window, Modifiers::NONE, Key::G);
    assert!(!has_control(&window, "grid step 1 unit"));
}
