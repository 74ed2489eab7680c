//! Screenshots: of the picture or the whole window, on any background, of any size, to a file or the clipboard.

use super::*;
use motion::corner;
use sightline::image::Rgba;
use std::fs;

/// A window that saves screenshots in a folder, and the folder.
fn open_row() -> (Window, TempDir) {
    let (mut window, folder) = row(1.0);
    window.save_screenshots_in(folder.path().to_owned());
    window.send([Event::PointerGone]);
    (window, folder)
}

/// The screenshots in a folder, oldest first.
fn saved(folder: &TempDir) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder.path()).expect("a folder");
    let mut files: Vec<_> = entries
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "png"))
        .collect();
    files.sort();
    files
}

/// F12, Enter.
#[test]
fn two_keys_save_the_picture_as_it_is_seen() {
    let (mut window, folder) = open_row();
    press_key(&mut window, Modifiers::NONE, Key::F12);
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    let whole = window.picture().expect("a picture");
    let alone = images::read(&folder.path().join("sightline-1.png"));
    let viewport = window.state().view().viewport;
    assert_eq!(alone.size(), viewport);
    let [left, top] = corner(&window);
    // Nothing lies over the picture's middle.
    let mut same = 0;
    for (x, y) in (300..460).flat_map(|x| (200..400).map(move |y| (x, y))) {
        same += usize::from(alone.at(x, y) == whole.at(left + x, top + y));
    }
    assert_eq!(same, 160 * 200);
}

#[test]
fn the_whole_window_is_saved_without_the_card_and_never_over_a_file() {
    let (mut window, folder) = open_row();
    let shown = window.picture().expect("a picture");
    shoot(&mut window, &["whole window"]);
    window.picture().expect("a picture");
    let files = saved(&folder);
    assert_eq!(files, [folder.path().join("sightline-1.png")]);
    let differ = images::differing(&images::read(&files[0]), &shown);
    // The menu's button that the cursor has left, at most.
    assert!(differ < 2000, "{differ}");
    assert!(
        window
            .messages()
            .any(|text| text.contains("sightline-1.png"))
    );
    let before = fs::read(&files[0]).expect("a file");
    shoot(&mut window, &[]);
    window.picture().expect("a picture");
    assert_eq!(saved(&folder).len(), 2);
    assert_eq!(fs::read(&files[0]).expect("a file"), before);

    window.save_screenshots_in(folder.path().join("not there"));
    shoot(&mut window, &[]);
    window.picture().expect("a picture");
    assert!(window.messages().any(|text| text.contains("not there")));
}

/// Twice as large, and nothing behind the scene: what is there is opaque, and in the same place. The window shows its own
/// picture after that.
#[test]
fn a_screenshot_may_be_larger_and_transparent() {
    let (mut window, folder) = open_row();
    press_key(&mut window, Modifiers::NONE, Key::G);
    let shown = window.picture().expect("a picture");
    let view = *window.state().view();
    shoot(&mut window, &["transparent", "\u{d7} 2"]);
    assert_eq!(*window.state().view(), view, "Enter does nothing else");
    window.send([Event::PointerGone]);
    let after = window.picture().expect("a picture");
    let larger: Image<Rgba> = images::read_channels(&saved(&folder)[0]);
    let (pixels, width) = (larger.pixels(), larger.size().width());
    let viewport = window.state().view().viewport;
    assert_eq!(width, 2 * viewport.width());
    assert_eq!(
        pixels.len() as u64,
        4 * u64::from(viewport.width()) * u64::from(viewport.height())
    );
    let count = |alpha: u8| pixels.iter().filter(|pixel| pixel[3] == alpha).count();
    let [none, all] = [count(0), count(255)];
    assert!(none > 100_000 && all > 20_000, "{none}, {all}");
    assert!(none + all < pixels.len() && none + all > pixels.len() * 9 / 10);
    // Where the larger one is opaque, the window shows an object of this colour.
    let [left, top] = corner(&window);
    let [mut opaque, mut alike] = [0, 0];
    for (x, y) in (100..600).flat_map(|x| (150..600).map(move |y| (x, y))) {
        let pixel = |i: u32, j: u32| pixels[((2 * y + j) * width + 2 * x + i) as usize];
        let four = [pixel(0, 0), pixel(1, 0), pixel(0, 1), pixel(1, 1)];
        if four.iter().all(|pixel| pixel[3] == 255) {
            let [r, g, b, _] = four[0];
            opaque += 1;
            let near = !images::apart(after.at(left + x, top + y), [r, g, b], 24);
            alike += usize::from(near);
        }
    }
    assert!(
        alike * 10 > opaque * 9 && opaque > 4000,
        "{alike} of {opaque}"
    );
    let place = Rect::from_min_max(pos2(400.0, 200.0), pos2(800.0, 600.0));
    assert_eq!(differing_in(&shown, &after, place), 0);
}

#[test]
fn a_screenshot_is_copied_on_any_background() {
    let (mut window, folder) = open_row();
    let corners = ["dark", "light", "white", "transparent"].map(|name| {
        press_key(&mut window, Modifiers::NONE, Key::F12);
        click_on(&mut window, name);
        click_on(&mut window, "copy the screenshot");
        window.picture().expect("a picture");
        window.send([]);
        let copied = window.copied_picture().expect("a picture");
        let viewport = window.state().view().viewport;
        assert_eq!(
            copied.size,
            [viewport.width() as usize, viewport.height() as usize]
        );
        copied.pixels[0].to_srgba_unmultiplied()
    });
    assert!(saved(&folder).is_empty());
    let [dark, light, white, transparent] = corners;
    assert!(
        dark[0] < 60 && light[0] > 200 && dark[3] == 255,
        "{corners:?}"
    );
    assert_eq!(white, [255; 4]);
    assert_eq!(transparent, [0; 4]);
}

/// A size as a multiple of the window's goes with the window. One that is none stays in the field, and the one before it
/// in force.
#[test]
fn the_size_follows_the_window_or_is_refused() {
    let (mut window, folder) = open_row();
    shoot(&mut window, &["\u{d7} 2"]);
    let sizes = |window: &mut Window, folder: &TempDir| {
        window.picture().expect("a picture");
        let last = saved(folder).pop().expect("a file");
        let now = window.state().view().viewport;
        let [size, now] =
            [images::read(&last).size(), now].map(|size| [size.width(), size.height()]);
        (size, now)
    };
    let (size, before) = sizes(&mut window, &folder);
    assert_eq!(size, before.map(|side| 2 * side));
    window.resize(px([900, 500], 1.0));
    shoot(&mut window, &[]);
    let (size, now) = sizes(&mut window, &folder);
    assert_ne!(now, before);
    assert_eq!(size, now.map(|side| 2 * side));

    press_key(&mut window, Modifiers::NONE, Key::F12);
    for text in ["0", "16385", "many"] {
        type_into(&mut window, "width", text);
        press_key(&mut window, Modifiers::NONE, Key::Enter);
        let refused = control(&window, "width");
        assert_eq!(refused.value, text);
        assert!(!refused.description.is_empty());
    }
    type_into(&mut window, "height", "300");
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    let (size, now) = sizes(&mut window, &folder);
    assert_eq!(size, [2 * now[0], 300]);
    assert_eq!(saved(&folder).len(), 3);
}

/// The key of a card closes the menu that would lie over it.
#[test]
fn a_key_closes_an_open_menu() {
    let (mut window, _folder) = open_row();
    click_on(&mut window, "Overlays");
    assert!(has_control(&window, "Wireframe"));
    press_key(&mut window, Modifiers::NONE, Key::F12);
    assert!(has_control(&window, "save the screenshot") && !has_control(&window, "Wireframe"));
}

/// F12, Ctrl+C.
#[test]
fn two_keys_copy_the_picture() {
    let (mut window, folder) = open_row();
    press_key(&mut window, Modifiers::NONE, Key::F12);
    window.send([Event::Copy]);
    window.picture().expect("a picture");
    window.send([]);
    assert!(window.copied_picture().is_some());
    assert!(!has_control(&window, "save the screenshot") && saved(&folder).is_empty());
}

#[test]
fn the_card_of_screenshots_closes_and_takes_none() {
    let (mut window, folder) = open_row();
    for key in [Key::F12, Key::Escape] {
        press_key(&mut window, Modifiers::NONE, Key::F12);
        assert!(has_control(&window, "save the screenshot"));
        press_key(&mut window, Modifiers::NONE, key);
        assert!(!has_control(&window, "save the screenshot"), "{key:?}");
    }
    window.picture().expect("a picture");
    assert!(saved(&folder).is_empty());
    // The key that ends a typed number does nothing else. Esc closes the card before it ends measuring.
    press_key(&mut window, Modifiers::NONE, Key::Q);
    for key in [Key::Enter, Key::Escape] {
        press_key(&mut window, Modifiers::NONE, Key::F12);
        type_into(&mut window, "width", "300");
        press_key(&mut window, Modifiers::NONE, key);
        assert!(has_control(&window, "save the screenshot"), "{key:?}");
        press_key(&mut window, Modifiers::NONE, Key::Escape);
        assert!(!has_control(&window, "save the screenshot"), "{key:?}");
        assert!(window.state().measuring().is_on);
    }
    assert!(saved(&folder).is_empty());
}

/// The picture's background goes with the panels.
#[test]
fn beside_light_panels_the_background_is_light() {
    let (mut window, _folder) = open_row();
    let middle = |window: &mut Window| {
        let picture = window.picture().expect("a picture");
        let [x, y] = whole(MIDDLE);
        picture.at(x - 250, y - 250)[0]
    };
    let dark = middle(&mut window);
    for name in ["View", "Theme"] {
        click_on(&mut window, name);
    }
    window.send([Event::PointerGone]);
    let light = middle(&mut window);
    assert!(dark < 60 && light > 180, "{dark}, {light}");
}
