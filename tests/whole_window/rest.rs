//! At rest a picture has smooth edges, in software too.

use super::{images::differing, *};
use sightline::{
    image::{Image, Rgb},
    look::Background,
    render,
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
    let (_, headless) = render::render(&gpu, state.scene(), state.view(), None, Background::DARK)
        .expect("a picture");
    let size = state.view().viewport;
    let at_rest = pictures.last().expect("one");
    // The picture is centred in the window's room for it.
    let [left, top] = [590 - size.width() / 2, 360 - size.height() / 2];
    for (x, y) in (100..400).flat_map(|y| (100..400).map(move |x| (x, y))) {
        assert_eq!(headless.at(x, y), at_rest.at(left + x, top + y), "{x}, {y}");
    }
}

/// On screens with any number of pixels to a point, a pixel of the picture is a pixel of the window.
#[test]
fn the_picture_is_shown_pixel_by_pixel() {
    for scale in [1.0, 1.25, 1.5, 1.75] {
        let (mut window, _folder) = row(scale);
        press_key(&mut window, Modifiers::NONE, Key::G);
        let shown = window.picture().expect("a picture");
        let state = window.state();
        let gpu = render::Gpu::headless().unwrap_or_else(|error| panic!("{error}"));
        let (_, headless) =
            render::render(&gpu, state.scene(), state.view(), None, Background::DARK)
                .expect("a picture");
        let size = state.view().viewport;
        let edge = control(&window, "edge of the left side").rect;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "within the window"
        )]
        let [left, top] = [edge.right(), edge.top()].map(|at| (at * scale).round() as u32);
        let [width, height] = [size.width(), size.height()];
        // The axes' cross lies over the lower left corner, and the panels' borders over the outermost pixels.
        let inner = (1..height / 2).flat_map(|y| (1..width - 1).map(move |x| (x, y)));
        let differ = inner.filter(|&(x, y)| headless.at(x, y) != shown.at(left + x, top + y));
        assert_eq!(differ.count(), 0, "{scale}");
    }
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
    click_on(&mut window, "fov");
    let before = window.passes();
    window.wait_s(1.0);
    let laid = window.passes() - before;
    assert!((3..10).contains(&laid), "{laid}");
}
