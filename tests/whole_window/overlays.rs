//! Lines over the scene are where they should be, in the picture and nowhere else.

use super::*;
use glam::DVec3;
use sightline::{
    image::{Image, Rgb},
    look,
};

/// The colours of a window's picture around a world-space point.
fn about(window: &Offscreen, picture: &Image<Rgb>, point_world: DVec3) -> Vec<Rgb> {
    let view = window.state().view();
    let size = DVec2::new(view.viewport.width().into(), view.viewport.height().into());
    let origin = DVec2::new(MIDDLE.x.into(), MIDDLE.y.into()) - 0.5 * size;
    let at = (view.project(point_world).expect("before the eye").px + origin).floor();
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "pixels"
    )]
    let [x, y] = [at.x as u32, at.y as u32];
    let near = |c: u32| c - 1..=c + 1;
    near(y)
        .flat_map(|y| near(x).map(move |x| picture.at(x, y)))
        .collect()
}

/// Whether a pixel is more than halfway to a colour. A line has smooth edges, so it is mixed with what lies beside it.
fn turned(before: &[Rgb], now: &[Rgb], wanted: Rgb) -> bool {
    let to_wanted = |colour: &Rgb| -> u32 {
        let apart = colour.iter().zip(wanted).map(|(a, b)| a.abs_diff(b));
        apart.map(u32::from).sum()
    };
    let mut pairs = before.iter().zip(now);
    pairs.any(|(before, now)| 2 * to_wanted(now) < to_wanted(before))
}

#[test]
fn each_overlay_is_where_it_belongs_and_gone_again() {
    let (mut window, _folder) = row(1.0);
    press_key(&mut window, Modifiers::NONE, Key::Num9);
    press_key(&mut window, Modifiers::NONE, Key::G);
    let bare = window.picture().expect("a picture");
    // The sphere's box sticks out of it, and so does the normal at its top; the cube's edge is on it.
    let above = DVec3::new(0.0, 0.5 + 0.1 * 0.75_f64.sqrt(), 0.0);
    for (key, point, colour) in [
        (Key::X, DVec3::new(0.5, 0.5, -0.5), look::BOXES.0),
        (Key::L, above, look::NORMALS.0),
        (Key::W, DVec3::new(0.0, 0.5, 2.5), [11, 11, 18]),
    ] {
        press_key(&mut window, Modifiers::NONE, key);
        let picture = window.picture().expect("a picture");
        let [before, seen] = [&bare, &picture].map(|picture| about(&window, picture, point));
        assert!(turned(&before, &seen, colour), "{key:?}: {seen:?}");
        press_key(&mut window, Modifiers::NONE, key);
        assert!(
            window.picture().expect("a picture") == bare,
            "{key:?} after"
        );
    }
}

/// With a selection, the overlay is for that alone.
#[test]
fn overlays_are_about_the_selection() {
    let (mut window, _folder) = row(1.0);
    click(&mut window, MIDDLE);
    assert_eq!(selected(&window), Some("front"));
    press_key(&mut window, Modifiers::NONE, Key::Num9);
    let corner = DVec3::new(0.5, 0.5, -0.5);
    let mut seen = |key: Option<Key>| {
        if let Some(key) = key {
            press_key(&mut window, Modifiers::NONE, key);
        }
        let picture = window.picture().expect("a picture");
        about(&window, &picture, corner)
    };
    let bare = seen(None);
    let of_selection = seen(Some(Key::X));
    assert_eq!(of_selection, bare);
    let of_all = seen(Some(Key::Escape));
    assert!(turned(&bare, &of_all, look::BOXES.0), "{of_all:?}");
}
