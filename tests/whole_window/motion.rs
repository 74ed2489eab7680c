//! While something moves, a large scene may be coarse in software. At rest the picture is exact, and picks always are.

use super::*;
use egui::vec2;
use sightline::{
    camera::View,
    look::{self, Background},
    pick, render,
};

/// The top left corner of the scene's rectangle, which is centred in the window's room for it.
pub(super) fn corner(window: &Window) -> [u32; 2] {
    let size = window.state().view().viewport;
    [590 - size.width() / 2, 360 - size.height() / 2]
}

/// Pixels well within the scene's picture, where nothing lies over it.
fn inner() -> impl Iterator<Item = (u32, u32)> {
    (100..400).flat_map(|y| (100..400).map(move |x| (x, y)))
}

/// Whether each pixel of the scene's picture covers a square of 3 pixels of the frame along each side.
fn is_coarse(window: &Window) -> bool {
    let (picture, [left, top]) = (window.drawn().expect("a picture"), corner(window));
    let at = |x: u32, y: u32| picture.at(left + x, top + y);
    inner().all(|(x, y)| at(x, y) == at(x / 3 * 3, y / 3 * 3))
}

/// A picture that moves shows each pixel, by one sample where the adapter is software. At rest its edges get smooth.
#[test]
fn what_moves_is_exact_where_it_is_little() {
    let (mut window, _folder) = row(1.0);
    window.picture().expect("a picture");
    window.send([
        Event::PointerMoved(MIDDLE),
        button(MIDDLE, PointerButton::Primary, true),
    ]);
    for x in [10.0, 20.0, 30.0] {
        let at = MIDDLE + vec2(x, 0.0);
        let anew = window.draw([Event::PointerMoved(at)]).expect("a frame");
        assert!(anew && !is_coarse(&window), "{x}");
    }
    let last = MIDDLE + vec2(30.0, 0.0);
    window
        .draw([button(last, PointerButton::Primary, false)])
        .expect("a frame");
    // A click is marked on the picture at hand.
    let bare = window.drawn().expect("a picture");
    window.send_undrawn([true, false].map(|is| button(MIDDLE, PointerButton::Primary, is)));
    let anew = window.draw([]).expect("a frame");
    assert!(!anew);
    let clicked = window.drawn().expect("a picture");
    let marked = (bare.pixels().iter().zip(clicked.pixels())).filter(|(a, b)| a != b);
    assert!(marked.count() > 100);
    let picked = window.state().selection().map(|selection| selection.object);
    assert!(picked.is_some());
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    window.send([Event::PointerGone]);
    press_key(&mut window, Modifiers::NONE, Key::G);
    let at_rest = window.picture().expect("a picture");
    let (state, [left, top]) = (window.state(), corner(&window));
    let gpu = render::Gpu::headless().unwrap_or_else(|error| panic!("{error}"));
    let (ids, colours) = render::render(&gpu, state.scene(), state.view(), None, Background::DARK)
        .expect("a picture");
    for (x, y) in inner() {
        assert_eq!(colours.at(x, y), at_rest.at(left + x, top + y), "{x}, {y}");
    }
    let [x, y] = [590 - left, 361 - top];
    let drawn = ids.at(x, y).object;
    let picked = picked.and_then(|object| u32::try_from(object + 1).ok());
    assert_eq!(picked, Some(drawn));
}

#[test]
fn a_drag_lays_the_panels_out_once_and_they_show_what_it_did() {
    let (mut window, _folder) = row(1.0);
    click_on(&mut window, "Pose");
    window.picture().expect("a picture");
    // In the four views, the world's camera is dragged, which the panels tell nothing about.
    for (views, at) in [
        (None, MIDDLE),
        (Some(Key::Num4), MIDDLE + vec2(150.0, -150.0)),
    ] {
        if let Some(key) = views {
            press_key(&mut window, Modifiers::NONE, key);
            window.picture().expect("a picture");
        }
        for modifiers in [Modifiers::NONE, Modifiers::SHIFT, Modifiers::COMMAND] {
            let button = |at, pressed| Event::PointerButton {
                pos: at,
                button: PointerButton::Primary,
                pressed,
                modifiers,
            };
            window.send([Event::PointerMoved(at), button(at, true)]);
            let to = |x: f32| at + vec2(x, 0.5 * x);
            window.send([Event::PointerMoved(to(10.0))]);
            for x in [20.0, 30.0] {
                let drawn = window.drawn().expect("a picture");
                let (view, passes) = (*window.state().view(), window.passes());
                window.draw([Event::PointerMoved(to(x))]).expect("a frame");
                assert_eq!(window.passes(), passes + 1, "{views:?} {modifiers:?} {x}");
                assert_ne!(window.drawn().expect("a picture"), drawn);
                let camera = &window.state().view().camera;
                assert_eq!(views.is_none(), *camera != view.camera);
                let shown = control(&window, "eye x").value.parse::<f64>();
                let difference = shown.expect("a number") - camera.eye().x;
                assert!(difference.abs() <= 1e-3 * camera.eye().length());
            }
            window.send([button(to(30.0), false)]);
        }
    }
}

/// A window that shows a ground of so many cells along each side, with its trees built, and the folder of its file.
fn large_ground(side: u32) -> (Window, TempDir) {
    let (mut window, folder, _) = stalls::opened(side);
    while !window.state().scene().trees_are_built() {
        window.draw([]).expect("a frame");
    }
    (window, folder)
}

/// Drags the left button to and fro, a frame for each step, until `is_so`. Returns whether it ever was.
fn drag_until(window: &mut Window, steps: u16, is_so: impl Fn(&Window) -> bool) -> bool {
    window.send([button(MIDDLE, PointerButton::Primary, true)]);
    (1..=steps).any(|step| {
        let at = MIDDLE + vec2(f32::from(step % 40) * 3.0, 0.0);
        window.draw([Event::PointerMoved(at)]).expect("a frame");
        is_so(window)
    })
}

/// A software rasteriser's time grows with the count of triangles. So where there are more of them than pixels, rays
/// make the picture: one for nine pixels while it moves, one for each at rest. Its colours are exactly those of the
/// rays' hits. Other adapters draw it, and exactly.
#[test]
fn a_large_scene_is_seen_by_rays() {
    // A million triangles.
    let (mut window, _folder) = large_ground(707);
    press_key(&mut window, Modifiers::NONE, Key::G);
    click(&mut window, MIDDLE);
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    if !window.is_software() {
        let coarse = drag_until(&mut window, 40, is_coarse);
        assert!(!coarse, "each picture is exact");
        return;
    }
    // On a busy machine rays may be late. The window then tries them again some pictures later.
    let coarse = drag_until(&mut window, 400, |window| {
        is_coarse(window) && is_by_rays(window, 3)
    });
    assert!(coarse, "all 400 pictures were drawn");
    let is_fine = (0..5).any(|_| {
        window.wait_s(1.0);
        window.picture().expect("a picture");
        is_by_rays(&window, 1)
    });
    assert!(is_fine, "at rest");
}

/// Where each ray meets thousands of objects, rays are late, and the picture is drawn.
#[test]
fn where_rays_take_long_the_picture_is_drawn() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("one_place.toml");
    // Cubes in one place: each ray meets all of them. One of them is drawn.
    let cube = "[[object]]\nshape = \"cube\"\n";
    std::fs::write(&path, cube.repeat(20_000)).expect("writable");
    let mut window = open(vec![path], 1.0);
    window.picture().expect("a picture");
    let begun = std::time::Instant::now();
    let drawn = drag_until(&mut window, 8, |window| !is_coarse(window));
    assert!(drawn, "it is drawn");
    assert!(begun.elapsed().as_secs() < 60, "{:?}", begun.elapsed());
}

/// An outline needs no drawing of the scene, however large that is.
#[test]
fn a_click_on_a_large_object_outlines_it_at_once() {
    let (mut window, _folder) = large_ground(707);
    window.picture().expect("a picture");
    click(&mut window, MIDDLE);
    assert!(window.state().selection().is_some());
    assert!(!window.draw([]).expect("a frame"), "nothing is drawn");
    let outline = look::SELECTION.0;
    let clicked = window.drawn().expect("a picture");
    assert!(
        clicked
            .pixels()
            .iter()
            .filter(|pixel| **pixel == outline)
            .count()
            > 300
    );
}

/// Whether the colours of a large ground's picture are exactly those of rays, one for so many pixels along each side.
fn is_by_rays(window: &Window, side: u32) -> bool {
    let ([left, top], view) = (corner(window), window.state().view());
    let frame = window.drawn().expect("a picture");
    let of = |length: u32| length.div_ceil(side);
    let size = Viewport::new(of(view.viewport.width()), of(view.viewport.height()));
    let coarse = View {
        viewport: size.expect("a viewport"),
        ..*view
    };
    let (ids, colours) = pick::raycast(window.state().scene(), &coarse, Background::DARK);
    // Nothing lies over the picture there.
    let within = 120 / side..390 / side;
    let each = || (within.clone()).flat_map(|y| within.clone().map(move |x| (x, y)));
    let of_ground = each().filter(|&(x, y)| ids.at(x, y).object == 1);
    assert!(of_ground.count() > 3000);
    each().all(|(x, y)| frame.at(left + x * side, top + y * side) == colours.at(x, y))
}

#[test]
fn panels_report_a_click_in_the_very_frame_that_shows_it() {
    let (mut window, _folder) = row(1.0);
    window.picture().expect("a picture");
    window.draw([Event::PointerMoved(MIDDLE)]).expect("a frame");
    let before = window.drawn().expect("a picture");
    window.send([button(MIDDLE, PointerButton::Primary, true)]);
    window
        .draw([button(MIDDLE, PointerButton::Primary, false)])
        .expect("a frame");
    let clicked = window.drawn().expect("a picture");
    let panel = (100..600).flat_map(|y| (980..1270).map(move |x| (x, y)));
    let differ = panel.filter(|&(x, y)| before.at(x, y) != clicked.at(x, y));
    assert!(differ.count() > 500);
}
