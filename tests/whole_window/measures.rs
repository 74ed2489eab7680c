//! Clicks snap to the vertices, edges and faces of a file, and measures of them are listed, copied and undone.

use super::{
    nothing_lost::{is_asked, is_marked},
    *,
};
use sightline::pick::snap::SnapTo;

/// An OBJ file of a wall: one quad, 4 wide and 2 high.
const WALL: &str = "v -2 -1 0\nv 2 -1 0\nv 2 1 0\nv -2 1.0 0\nf 1 2 3 4\n";

const SCENE: &str = "
[camera]
eye = [0, 0, 10]
target = [0, 0, 0]
ortho = 6.95

[[object]]
name = \"Wall\"
shape = \"mesh\"
file = \"wall.obj\"
";

fn wall() -> (Window, TempDir) {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("wall.obj"), WALL).expect("a writable folder");
    let path = folder.path().join("wall.toml");
    std::fs::write(&path, SCENE).expect("a writable folder");
    let mut window = open(vec![path], 1.0);
    // Folded, the camera leaves room for the list of measures.
    click_on(&mut window, "Camera");
    click_on(&mut window, "Measure");
    (window, folder)
}

/// Clicks at this offset in pixels from where a world point shows.
fn click_near(window: &mut Window, point: [f64; 3], aside: [f32; 2]) {
    let at = near(window, point, aside);
    click(window, at);
}

/// The position at this offset in pixels from where a world point shows.
fn near(window: &Window, point: [f64; 3], aside: [f32; 2]) -> Pos2 {
    let view = window.state().view();
    let px = view
        .project(glam::DVec3::from_array(point))
        .expect("in front")
        .px;
    let from_middle = px - view.viewport.size_px() / 2.0;
    #[expect(clippy::cast_possible_truncation, reason = "points of a window")]
    let [x, y, width] =
        [from_middle.x, from_middle.y, view.viewport.size_px().x].map(|px| px as f32);
    // The right panels are as wide as usual, and the left panels wider.
    let middle = pos2(970.0 - 0.5 * width, MIDDLE.y);
    middle + egui::vec2(x, y) + egui::Vec2::from(aside)
}

/// While measuring, what a click would snap to is marked under the cursor. The click then takes just that.
#[test]
fn what_a_click_would_take_is_marked_before_it() {
    let (mut window, _folder) = wall();
    let [corner, side] = [
        ([2.0, 1.0, 0.0], [-5.0, 4.0]),
        ([0.0, 1.0, 0.0], [3.0, 4.0]),
    ];
    let ahead = |window: &mut Window, (point, aside)| {
        let at = near(window, point, aside);
        window.send([Event::PointerMoved(at)]);
        window.wait_s(0.1);
        let snap = window.state().measuring().ahead.as_ref();
        snap.map(|snap| (snap.to, snap.point_world))
    };
    assert_eq!(ahead(&mut window, corner), None, "nothing is measured yet");
    let bare = window.picture().expect("a picture");
    press_key(&mut window, Modifiers::NONE, Key::Q);
    let at_corner = ahead(&mut window, corner).expect("a corner");
    assert_eq!(at_corner, (SnapTo::Vertex, glam::dvec3(2.0, 1.0, 0.0)));
    let at = near(&window, corner.0, [0.0; 2]);
    let around = egui::Rect::from_center_size(at, egui::Vec2::splat(24.0));
    let marked = window.picture().expect("a picture");
    assert!(differing_in(&bare, &marked, around) > 20);
    let (to, on_side) = ahead(&mut window, side).expect("a side");
    assert_eq!((to, on_side.y), (SnapTo::Edge, 1.0));
    click_near(&mut window, side.0, side.1);
    let taken = &window.state().measuring().points;
    assert_eq!(taken.len(), 1);
    assert_eq!(taken[0].point_world, on_side);
    window.send([Event::PointerGone]);
    assert_eq!(window.state().measuring().ahead, None);
}

fn is_enabled(window: &Window, name: &str) -> bool {
    control(window, name).is_enabled
}

fn values(window: &Window) -> Vec<f64> {
    let list = &window.state().measuring().list;
    list.iter().map(|entry| entry.value).collect()
}

#[test]
fn clicks_are_led_to_vertices_and_edges_and_measured() {
    let (mut window, _folder) = wall();
    // Without snapping, a click measures from the surface that it hits.
    click_near(&mut window, [2.0, 1.0, 0.0], [-4.0, 3.0]);
    let points = &window.state().measuring().points;
    assert!(points.len() == 1 && points[0].snap.is_none());
    assert!(!is_enabled(&window, "distance") && !is_enabled(&window, "object area"));
    click_on(&mut window, "snap clicks");
    click_near(&mut window, [2.0, 1.0, 0.0], [-4.0, 3.0]);
    let label = |window: &Window| {
        let last = window.state().measuring().points.last();
        last.map(sightline::viewer::model::MeasuredPoint::label)
    };
    assert_eq!(label(&window).as_deref(), Some("v 3 of Wall"));
    assert!(!is_enabled(&window, "distance") && !is_enabled(&window, "edge length"));
    click_near(&mut window, [-2.0, -1.0, 0.0], [3.0, -4.0]);
    assert_eq!(label(&window).as_deref(), Some("v 1 of Wall"));
    click_on(&mut window, "distance");
    assert_eq!(values(&window), [20.0_f64.sqrt()]);
    // The quad's diagonal is not an edge of the file. Its lower side is.
    click_near(&mut window, [0.0, 0.0, 0.0], [0.0, 0.0]);
    assert_eq!(label(&window).as_deref(), Some("face 1 of Wall"));
    click_on(&mut window, "face area");
    click_near(&mut window, [0.5, -1.0, 0.0], [0.0, -5.0]);
    assert_eq!(label(&window).as_deref(), Some("edge 1-2 of Wall"));
    click_on(&mut window, "edge length");
    click_on(&mut window, "object area");
    assert_eq!(values(&window), [20.0_f64.sqrt(), 8.0, 4.0, 8.0]);

    click_on(&mut window, "list as JSON");
    let copied: serde_json::Value =
        serde_json::from_str(window.copied().expect("JSON")).expect("JSON");
    assert_eq!(copied[2]["what"], "edge length");
    assert_eq!(copied[2]["of"], "edge 1-2 of Wall");
    assert_eq!(copied[0]["value"], 20.0_f64.sqrt());
    assert_eq!(copied[0]["along"], serde_json::json!([-4.0, -2.0, 0.0]));
    click_on(&mut window, "copy list");
    assert_eq!(window.copied().map(|text| text.lines().count()), Some(4));

    // Undo takes back changes of the list.
    click_on(&mut window, "remove measure 2");
    assert_eq!(values(&window), [20.0_f64.sqrt(), 4.0, 8.0]);
    click_on(&mut window, "clear list");
    assert!(values(&window).is_empty());
    press_key(&mut window, CTRL, Key::Z);
    press_key(&mut window, CTRL, Key::Z);
    assert_eq!(values(&window).len(), 4);
    press_key(&mut window, CTRL, Key::Z);
    assert_eq!(values(&window).len(), 3);
    press_key(&mut window, CTRL, Key::Y);
    assert_eq!(values(&window).len(), 4);
}

#[test]
fn points_of_another_scene_are_forgotten_and_the_list_is_kept() {
    let (mut window, folder) = wall();
    click_on(&mut window, "snap clicks");
    click_near(&mut window, [2.0, 1.0, 0.0], [-4.0, 3.0]);
    click_near(&mut window, [0.0, 0.0, 0.0], [0.0, 0.0]);
    click_on(&mut window, "object area");
    // The same file read again leaves points and measures as they are.
    press_key(&mut window, Modifiers::NONE, Key::R);
    assert_eq!(window.state().measuring().points.len(), 2);
    assert!(!window.state().measuring().list[0].outdated);
    let other = WALL.replace("v 2 -1 0", "v 2.5 -1 0");
    std::fs::write(folder.path().join("wall.obj"), other).expect("a writable folder");
    press_key(&mut window, Modifiers::NONE, Key::R);
    assert!(window.state().measuring().points.is_empty());
    assert_eq!(values(&window), [8.0]);
    assert!(window.state().measuring().is_on);
    // The list is kept.
    click_on(&mut window, "copy list");
    let copied = window.copied().expect("text");
    assert!(copied.ends_with("\tbefore the scene changed\n"), "{copied}");
    click_near(&mut window, [0.0, 0.0, 0.0], [0.0, 0.0]);
    click_on(&mut window, "object area");
    let outdated = window
        .state()
        .measuring()
        .list
        .iter()
        .map(|entry| entry.outdated);
    assert_eq!(outdated.collect::<Vec<_>>(), [true, false]);
}

/// Measures are in no file. They are no edit of the scene, but a question comes before they are lost.
#[test]
fn measures_are_not_lost_without_a_question() {
    let (mut window, folder) = wall();
    click_on(&mut window, "snap clicks");
    click_near(&mut window, [0.0, 0.0, 0.0], [0.0, 0.0]);
    click_on(&mut window, "object area");
    assert!(!is_marked(&window));
    let other = folder.path().join("row.toml");
    std::fs::write(&other, ROW).expect("a writable folder");
    let is_asked =
        |window: &Window| !is_asked(window) && has_control(window, "Measures would be lost");

    window.drop_file(other.clone());
    assert!(is_asked(&window));
    let told = |window: &Window, words: &str| {
        let mut all = window.controls().iter();
        all.any(|control| control.name.contains(words))
    };
    assert!(told(&window, "No file holds measures"));
    assert!(!has_control(&window, "Save first\u{2026}"), "it saves none");
    click_on(&mut window, "Copy the measures");
    let copied = window.copied().expect("text");
    assert!(copied.starts_with("object area\t8\t"), "{copied}");
    assert!(is_asked(&window));
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(
        (window.state().name(), values(&window)),
        ("wall.toml", vec![8.0])
    );

    // The gallery keeps the measures.
    press_key(&mut window, Modifiers::NONE, Key::E);
    assert!(!is_asked(&window) && window.state().showing().is_some());
    window.close();
    assert!(is_asked(&window) && !window.has_quit());
    click_on(&mut window, "Cancel");
    assert!(
        window.state().showing().is_none(),
        "what is asked about shows"
    );
    assert_eq!(values(&window), [8.0]);

    // One question is about edits and measures.
    press_key(&mut window, Modifiers::SHIFT, Key::H);
    window.drop_file(other.clone());
    assert!(has_control(&window, "Unsaved edits") && told(&window, "No file holds measures"));
    click_on(&mut window, "Save first\u{2026}");
    window.save_as(folder.path().join("kept.toml"));
    assert!(is_asked(&window), "the measures are left");
    click_on(&mut window, "Open, drop the measures");
    assert_eq!(
        (window.state().name(), values(&window)),
        ("row.toml", vec![])
    );
    window.close();
    assert!(window.has_quit());
}

/// The panel's buttons, without its list.
const NAMES: [&str; 10] = [
    "snap clicks",
    "distance",
    "angle",
    "radius",
    "edge length",
    "face area",
    "object area",
    "copy list",
    "list as JSON",
    "clear list",
];

/// No button moves as points come and go. A disabled one says what to do first.
#[test]
fn the_panel_stays_as_it_is_laid_out() {
    let (mut window, _folder) = wall();
    let places = |window: &Window| NAMES.map(|name| control(window, name).rect);
    let said = |window: &Window, name: &str, words: &str| {
        let control = control(window, name);
        assert!(!control.is_enabled, "{name}");
        let told = format!("{control:?}");
        assert!(told.contains(words), "{name}: {told}");
    };
    let first = places(&window);
    said(&window, "distance", "click two points");
    said(&window, "angle", "click three points");
    for name in &NAMES[4..7] {
        said(&window, name, "tick \u{201c}snap clicks\u{201d} first");
    }
    said(&window, "copy list", "nothing was measured yet");
    control(&window, "Click a point in the picture.");
    click_on(&mut window, "snap clicks");
    assert_eq!(places(&window), first);
    control(&window, "Click a vertex, an edge or a face.");
    said(&window, "distance", "click two points");
    said(&window, "face area", "click what is to be measured");
    click_near(&mut window, [2.0, 1.0, 0.0], [-4.0, 3.0]);
    assert_eq!(places(&window), first);
    said(&window, "distance", "click a second point");
    said(&window, "edge length", "did not snap to an edge");
    assert!(is_enabled(&window, "face area") && is_enabled(&window, "object area"));
    click_near(&mut window, [-2.0, -1.0, 0.0], [3.0, -4.0]);
    assert_eq!(places(&window), first);
    for name in ["distance", "object area"] {
        click_on(&mut window, name);
        assert_eq!(places(&window), first);
    }
}

/// Three long numbers are shown to their last digit.
#[test]
fn long_coordinates_are_not_cut_off() {
    let long = "2.0000000000000000 1.0000000000000000 0.0000000000000001";
    let (mut window, folder) = wall();
    let text = WALL.replace("2 1 0", long);
    std::fs::write(folder.path().join("wall.obj"), text).expect("a writable folder");
    press_key(&mut window, Modifiers::NONE, Key::R);
    click_on(&mut window, "snap clicks");
    click_near(&mut window, [2.0, 1.0, 0.0], [-4.0, 3.0]);
    let at = control(&window, long).rect;
    assert!(at.height() > 20.0, "it has two lines: {at}");
}

/// What the right button's menu picks is measured like what a click picks, and is the nearest surface each time.
#[test]
fn the_menu_s_picks_are_measured() {
    let (mut window, _folder) = row(1.0);
    for at in [MIDDLE, MIDDLE + egui::vec2(0.0, 70.0)] {
        menus::open_menu(&mut window, at);
        click_on(&mut window, "Pick this point");
        window.wait_s(1.0);
    }
    assert_eq!(window.state().measuring().points.len(), 2);
    menus::open_menu(&mut window, MIDDLE);
    click_on(&mut window, "Pick this point");
    window.wait_s(1.0);
    menus::open_menu(&mut window, MIDDLE);
    click_on(&mut window, "Pick this point");
    assert_eq!(selected(&window), Some("front"));
    let hits = window.state().hits().and_then(|hits| hits.at);
    assert_eq!(hits, Some(0), "the nearest again");
}
