//! The failure gallery, by its keys: a wrong pick is seen, marked as not the default, and gone with the gallery.

use super::*;
use sightline::image::{Image, Rgb};

/// The banner's yellow.
const BANNER: Rgb = [0xf0, 0xe4, 0x42];
/// Left of the ball of `small_and_far`, where nothing is.
const BESIDE: Pos2 = pos2(345.0, 480.0);

fn share_of(picture: &Image<Rgb>, colour: Rgb) -> f64 {
    let same = picture.pixels().iter().filter(|pixel| **pixel == colour);
    #[expect(clippy::cast_precision_loss, reason = "pixels of a picture")]
    let share = same.count() as f64 / picture.pixels().len() as f64;
    share
}

fn exhibit(window: &Offscreen) -> Option<&'static str> {
    window.state().showing().map(|showing| showing.exhibit.name)
}

#[test]
fn a_phantom_is_seen_under_a_banner_until_escape() {
    let (mut window, _folder) = row(1.0);
    let key = |window: &mut Offscreen, key| press_key(window, Modifiers::NONE, key);
    for _ in 0..4 {
        key(&mut window, Key::E);
    }
    assert_eq!(exhibit(&window), Some("small_and_far"));
    press_key(&mut window, Modifiers::SHIFT, Key::E);
    key(&mut window, Key::E);
    assert_eq!(exhibit(&window), Some("small_and_far"), "there and back");

    click(&mut window, BESIDE);
    assert_eq!(selected(&window), None, "nothing is there");
    let before = window.picture().expect("a picture");
    assert!(share_of(&before, BANNER) < 1e-3);

    key(&mut window, Key::M);
    let method = window.state().method().expect("another method");
    assert_eq!(method.info().name, "plain quadratic");
    click(&mut window, BESIDE);
    assert_eq!(selected(&window), Some("Ball"), "which is not there");
    let during = window.picture().expect("a picture");
    assert!(
        share_of(&during, BANNER) > 0.02,
        "{}",
        share_of(&during, BANNER)
    );
    // Each pixel that it gets wrong is marked, as V marks them.
    let wrong = share_of(&during, [0xd5, 0x5e, 0x00]);
    assert!(wrong > 0.05, "{wrong}");

    key(&mut window, Key::J);
    assert_eq!(window.copied(), None, "a wrong pick is not handed out");
    key(&mut window, Key::Escape);
    assert_eq!((window.state().method(), selected(&window)), (None, None));
    let after = window.picture().expect("a picture");
    assert!(share_of(&after, BANNER) < 1e-3);
}

#[test]
fn another_file_ends_the_gallery_and_its_method() {
    let (mut window, folder) = row(1.0);
    press_key(&mut window, Modifiers::NONE, Key::E);
    press_key(&mut window, Modifiers::NONE, Key::M);
    assert!(window.state().method().is_some());
    window.drop_file(folder.path().join("row.toml"));
    assert_eq!((exhibit(&window), window.state().method()), (None, None));
    click(&mut window, MIDDLE);
    assert_eq!(selected(&window), Some("front"));
    press_key(&mut window, Modifiers::NONE, Key::J);
    assert!(window.copied().is_some_and(|text| text.contains("front")));
}

/// One scene is about the column of pixels that looks straight along a face.
#[test]
fn the_picture_is_an_odd_number_of_pixels_wide() {
    for scale in [1.0, 1.25, 1.5, 2.0] {
        for width in [1280, 1281, 1366] {
            let mut window = open(vec!["gallery:along_a_face".into()], scale);
            window.resize(px([width, 720], scale));
            let shown = window.state().view().viewport.width();
            assert_eq!(shown % 2, 1, "{shown} of {width} at {scale}");
        }
    }
}
