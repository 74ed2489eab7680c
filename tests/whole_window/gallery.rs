//! The failure gallery shows a wrong pick, marks it as not the default method's, and takes it away when it is left.

use super::*;
use glam::DVec3;
use sightline::{
    image::{Image, Rgb},
    scene::{self, Progress},
};

/// The banner's yellow.
const BANNER: Rgb = [0xf0, 0xe4, 0x42];
/// A point left of the ball of `small_and_far`, where there is no object.
const BESIDE: Pos2 = pos2(345.0, 480.0);

fn share_of(picture: &Image<Rgb>, colour: Rgb) -> f64 {
    let same = picture.pixels().iter().filter(|pixel| **pixel == colour);
    #[expect(clippy::cast_precision_loss, reason = "pixels of a picture")]
    let share = same.count() as f64 / picture.pixels().len() as f64;
    share
}

fn exhibit(window: &Window) -> Option<&'static str> {
    window.state().showing().map(|showing| showing.exhibit.name)
}

#[test]
fn a_phantom_is_seen_under_a_banner_until_escape() {
    let (mut window, _folder) = row(1.0);
    let key = |window: &mut Window, key| press_key(window, Modifiers::NONE, key);
    for _ in 0..5 {
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
    // Each pixel that the method gets wrong is marked, as V marks pixels.
    let wrong = share_of(&during, [0xd5, 0x5e, 0x00]);
    assert!(wrong > 0.05, "{wrong}");

    key(&mut window, Key::J);
    assert_eq!(window.copied(), None, "a wrong pick is not handed out");
    // The first Esc closes the message that says so.
    assert_eq!(window.messages().count(), 1);
    key(&mut window, Key::Escape);
    assert_eq!(window.messages().count(), 0);
    assert_eq!(window.state().method(), Some(method));
    key(&mut window, Key::Escape);
    assert_eq!((window.state().method(), selected(&window)), (None, None));
    let after = window.picture().expect("a picture");
    assert!(share_of(&after, BANNER) < 1e-3);
}

/// Pixels with the right object but a wrong normal or position are marked as well. With Sightline's own picks no pixel
/// is marked. The panel gives the scene's number and the count of scenes.
#[test]
fn wrong_normals_and_places_are_marked() {
    const WRONG: Rgb = [0xd5, 0x5e, 0x00];
    for (name, place) in [
        ("stretched", "6 of 10"),
        ("mirrored", "7 of 10"),
        ("edge_on", "10 of 10"),
    ] {
        let mut window = open(vec![format!("gallery:{name}").into()], 1.0);
        control(&window, place);
        press_key(&mut window, Modifiers::NONE, Key::V);
        let ours = share_of(&window.picture().expect("a picture"), WRONG);
        press_key(&mut window, Modifiers::NONE, Key::V);
        press_key(&mut window, Modifiers::NONE, Key::M);
        let theirs = share_of(&window.picture().expect("a picture"), WRONG);
        assert!(ours < 1e-3 && theirs > 0.02, "{name}: {ours} {theirs}");
    }
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

/// One scene is about the column of pixels whose rays run along a face. It is the middle column of an odd number.
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

/// A window whose edited scene was left for the gallery. Closing the window asks about that scene.
fn edited_and_left() -> (Window, TempDir) {
    let (mut window, folder) = row(1.0);
    click(&mut window, MIDDLE);
    click_on(&mut window, "Placement");
    type_into(&mut window, "position x", "1.5");
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    press_key(&mut window, Modifiers::NONE, Key::E);
    assert!(window.state().showing().is_some());
    (window, folder)
}

#[track_caller]
fn assert_is_the_edited_row(path: &Path) {
    let kept = scene::load(&[path.to_owned()], &Progress::default()).expect("a scene");
    let objects = kept.scene.objects();
    let names: Vec<_> = objects.iter().map(|object| object.name.as_str()).collect();
    assert_eq!(names, ["front", "middle", "back"]);
    let at = objects[0].placement.model().translation;
    assert_eq!(at, DVec3::new(1.5, 0.0, 2.0));
}

#[test]
fn what_is_saved_first_is_the_scene_whose_edits_would_go() {
    let (mut window, folder) = edited_and_left();
    let kept = folder.path().join("kept.toml");
    press_key(&mut window, CTRL, Key::Q);
    let asked = "This closes the window. Your edits in row.toml are not saved.";
    control(&window, asked);
    click_on(&mut window, "Save first\u{2026}");
    window.save_as(kept.clone());
    assert!(window.has_quit());
    assert_is_the_edited_row(&kept);
    // The same holds when other files are opened.
    let (mut window, folder) = edited_and_left();
    let kept = folder.path().join("kept.toml");
    window.drop_file(folder.path().join("row.toml"));
    click_on(&mut window, "Save first\u{2026}");
    window.save_as(kept.clone());
    assert_eq!(window.state().name(), "row.toml");
    assert!(window.state().showing().is_none());
    assert_is_the_edited_row(&kept);
}

/// First about the one on show. Then the other one comes back, so that one sees what would go.
#[test]
fn each_of_two_edited_scenes_is_asked_about() {
    let (mut window, folder) = edited_and_left();
    let [first, second] = ["first.toml", "second.toml"].map(|name| folder.path().join(name));
    click(&mut window, pos2(675.0, 362.0));
    assert!(selected(&window).is_some());
    press_key(&mut window, Modifiers::SHIFT, Key::H);
    let exhibit = window.state().name().to_owned();
    let count = window.state().scene().objects().len();
    window.close();
    let asked = |of: &str| format!("This closes the window. Your edits in {of} are not saved.");
    control(&window, &asked(&exhibit));
    click_on(&mut window, "Save first\u{2026}");
    window.save_as(first.clone());
    assert!(!window.has_quit());
    let kept = scene::load(&[first], &Progress::default()).expect("a scene");
    assert_eq!(kept.scene.objects().len(), count);
    assert_eq!(kept.scene.hidden_count(), 1);
    control(&window, &asked("row.toml"));
    assert_eq!(window.state().name(), "row.toml");
    click_on(&mut window, "Save first\u{2026}");
    window.save_as(second.clone());
    assert!(window.has_quit());
    assert_is_the_edited_row(&second);
}

#[test]
fn esc_goes_back_step_by_step_and_out() {
    let (mut window, _folder) = row(1.0);
    press_key(&mut window, Modifiers::NONE, Key::E);
    press_key(&mut window, Modifiers::NONE, Key::M);
    assert!(window.state().method().is_some());
    let escape = |window: &mut Window| press_key(window, Modifiers::NONE, Key::Escape);
    escape(&mut window);
    assert!(window.state().method().is_none() && window.state().showing().is_some());
    control(&window, "Esc, with nothing selected, leaves the gallery.");
    click(&mut window, pos2(675.0, 362.0));
    assert!(selected(&window).is_some());
    escape(&mut window);
    assert_eq!(selected(&window), None);
    assert!(window.state().showing().is_some());
    escape(&mut window);
    assert_eq!(window.state().name(), "row.toml");
    escape(&mut window);
    assert_eq!(window.state().name(), "row.toml");
    // If nothing was open before, the way out is named.
    let mut window = open(vec![PathBuf::from("gallery:needles")], 1.0);
    escape(&mut window);
    assert!(window.state().showing().is_some());
    control(&window, "Menu Learn, leave the gallery: opens the demo.");
}

#[test]
fn what_is_edited_in_the_gallery_is_asked_about_before_it_is_left() {
    let edited_inside = || {
        let (mut window, folder) = row(1.0);
        press_key(&mut window, Modifiers::NONE, Key::E);
        click(&mut window, pos2(675.0, 362.0));
        press_key(&mut window, Modifiers::SHIFT, Key::H);
        press_key(&mut window, Modifiers::NONE, Key::Escape);
        assert!(nothing_lost::is_asked(&window));
        (window, folder)
    };
    let (mut window, _folder) = edited_inside();
    let name = window.state().name().to_owned();
    control(
        &window,
        &format!("This leaves the gallery. Your edits in {name} are not saved."),
    );
    click_on(&mut window, "Cancel");
    assert!(window.state().showing().is_some() && nothing_lost::is_marked(&window));
    // The next scene of the gallery would take its place.
    press_key(&mut window, Modifiers::NONE, Key::E);
    assert_eq!(window.state().name(), name);
    click_on(&mut window, "Cancel");
    click_on(&mut window, "Learn");
    click_on(&mut window, "leave the gallery");
    click_on(&mut window, "Leave, drop the edits");
    assert_eq!(window.state().name(), "row.toml");
    assert!(!nothing_lost::is_marked(&window));

    let (mut window, folder) = edited_inside();
    click_on(&mut window, "Save first\u{2026}");
    assert!(window.state().showing().is_some(), "it is not saved yet");
    let kept = folder.path().join("kept.toml");
    window.save_as(kept.clone());
    assert_eq!(window.state().name(), "row.toml");
    let kept = scene::load(&[kept], &Progress::default()).expect("a scene");
    assert_eq!(kept.scene.hidden_count(), 1);
}

/// A scene of the gallery that is saved and read again is an exhibit no more. What was left before is still asked about.
#[test]
fn what_was_left_is_never_forgotten() {
    let (mut window, folder) = edited_and_left();
    let kept = folder.path().join("x.toml");
    window.save_as(kept);
    press_key(&mut window, Modifiers::NONE, Key::R);
    assert!(window.state().showing().is_none());
    assert!(nothing_lost::is_marked(&window), "row.toml has edits");
    press_key(&mut window, Modifiers::NONE, Key::E);
    assert!(window.state().showing().is_some() && nothing_lost::is_marked(&window));
    window.close();
    assert!(nothing_lost::is_asked(&window) && !window.has_quit());
    assert_eq!(window.state().name(), "row.toml");
}

/// A view that was not touched shows all of its scene when it comes back, whatever size the window has by now.
#[test]
fn what_comes_back_is_framed_anew() {
    let (mut window, _folder) = row(1.0);
    press_key(&mut window, Modifiers::NONE, Key::E);
    window.resize(px([900, 700], 1.0));
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(window.state().name(), "row.toml");
    let came_back = window.state().view().camera;
    let (mut opened, _folder) = row(1.0);
    opened.resize(px([900, 700], 1.0));
    assert_eq!(came_back, opened.state().view().camera);
}
