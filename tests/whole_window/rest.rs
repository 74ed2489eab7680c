//! At rest a picture has smooth edges, in software too, and no action has to wait for them.

use super::{images::differing, *};
use sightline::{
    image::{Image, Rgb},
    look, render,
};

/// Draws a frame, and returns what is then on screen.
fn next(window: &mut Window) -> Image<Rgb> {
    window.draw([]).expect("a frame");
    window.drawn().expect("a picture")
}

#[test]
fn edges_get_smooth_at_rest_at_one_blow() {
    let (mut window, _folder) = row(1.0);
    press_key(&mut window, Modifiers::NONE, Key::G);
    window.picture().expect("a picture");
    press_key(&mut window, Modifiers::NONE, Key::Num9);
    let rough = next(&mut window);
    assert!(window.is_at_rest());
    // Something may move the picture again soon, so its edges wait.
    for _ in 0..5 {
        assert_eq!(differing(&next(&mut window), &rough), 0);
    }
    window.wait_s(1.0);
    let mut pictures = vec![rough];
    for _ in 0..20 {
        let now = next(&mut window);
        if pictures.last() != Some(&now) {
            pictures.push(now);
        }
    }
    assert_eq!(pictures.len(), if window.is_software() { 2 } else { 1 });
    assert!(
        pictures[0] == *pictures.last().expect("one")
            || differing(&pictures[0], &pictures[1]) > 200
    );
    // It equals the picture of `sightline render`.
    let state = window.state();
    let gpu = render::Gpu::headless().unwrap_or_else(|error| panic!("{error}"));
    let (_, headless) = render::render(&gpu, state.scene(), state.view(), None).expect("a picture");
    let size = state.view().viewport;
    let at_rest = pictures.last().expect("one");
    // The picture is centred in the window's room for it.
    let [left, top] = [590 - size.width() / 2, 360 - size.height() / 2];
    for (x, y) in (100..400).flat_map(|y| (100..400).map(move |x| (x, y))) {
        assert_eq!(headless.at(x, y), at_rest.at(left + x, top + y), "{x}, {y}");
    }
}

/// The picture is large and takes several frames to get smooth.
#[test]
fn what_happens_meanwhile_is_shown_at_once() {
    let (mut window, _folder) = row(2.0);
    window.picture().expect("a picture");
    press_key(&mut window, Modifiers::NONE, Key::Num9);
    let rough = next(&mut window);
    window.wait_s(1.0);
    for _ in 0..2 {
        assert!(!window.is_software() || differing(&next(&mut window), &rough) == 0);
    }
    // A click is exact, and the next frame shows it.
    click(&mut window, MIDDLE);
    assert_eq!(selected(&window), Some("middle"));
    let clicked = next(&mut window);
    let outline = clicked
        .pixels()
        .iter()
        .filter(|pixel| **pixel == look::SELECTION.0);
    assert!(outline.count() > 500);
    for _ in 0..2 {
        next(&mut window);
    }
    // The next frame shows a turn, too, and nothing of the old picture stays.
    press_key(&mut window, Modifiers::NONE, Key::Num1);
    let turned = next(&mut window);
    assert!(differing(&turned, &clicked) > 1000);
    let at_rest = window.picture().expect("a picture");
    let (mut fresh, _folder) = row(2.0);
    click(&mut fresh, MIDDLE);
    press_key(&mut fresh, Modifiers::NONE, Key::Num9);
    click(&mut fresh, MIDDLE);
    press_key(&mut fresh, Modifiers::NONE, Key::Num1);
    assert_eq!(differing(&at_rest, &fresh.picture().expect("a picture")), 0);
}

/// What a key changes is laid out in the frame that shows it, and so is what appears with it: the next frame looks the
/// same.
#[test]
fn the_frame_after_a_key_is_laid_out_already() {
    let (mut window, _folder) = row(1.0);
    window.picture().expect("a picture");
    let panel = Rect::from_min_max(pos2(980.0, 40.0), pos2(1280.0, 690.0));
    for (key, changes) in [
        (Key::ArrowDown, 2000),
        (Key::P, 0),
        (Key::Num4, 0),
        (Key::Num9, 100),
    ] {
        let before = window.drawn().expect("a picture");
        window.draw([press(key)]).expect("a frame");
        let shown = window.drawn().expect("a picture");
        let changed = differing_in(&before, &shown, panel);
        assert!(changed >= changes, "{key:?}: {changed}");
        assert_eq!(
            differing_in(&next(&mut window), &shown, panel),
            0,
            "{key:?}"
        );
    }
}

/// A cursor in a field blinks twice a second. Between two blinks nothing is laid out.
#[test]
fn a_blinking_cursor_lays_out_what_it_must() {
    let (mut window, _folder) = row(1.0);
    click_on(&mut window, "eye x");
    let before = window.passes();
    window.wait_s(1.0);
    let laid = window.passes() - before;
    assert!((3..10).contains(&laid), "{laid}");
}
