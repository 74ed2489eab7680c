//! Lines over the scene, such as boxes, normals and the grid, appear where they should and disappear again.

use super::*;
use egui::vec2;
use glam::DVec3;
use sightline::{
    image::{Image, Rgb},
    look,
};

/// The colours of a window's picture around a world-space point.
fn about(window: &Window, picture: &Image<Rgb>, point_world: DVec3) -> Vec<Rgb> {
    let view = window.state().view();
    let size = DVec2::new(view.viewport.width().into(), view.viewport.height().into());
    let origin = DVec2::new(MIDDLE.x.into(), MIDDLE.y.into()) - 0.5 * size;
    let at = view.project(point_world).expect("before the eye").px + origin;
    about_pixel(picture, at)
}

/// The colours of a picture around a position.
fn about_pixel(picture: &Image<Rgb>, at: DVec2) -> Vec<Rgb> {
    let at = at.floor();
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

/// Whether some pixel has come more than halfway to a colour. A line has smooth edges, which mix its colour with what
/// lies beside it.
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
    // The points are a corner of the sphere's box, the end of the normal at its top, and an edge of the cube.
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

/// With a selection, an overlay is drawn for the selected object alone.
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

/// In NDC, overlays are where the camera's matrices bring them: a box is none there.
#[test]
fn a_box_in_ndc_has_its_corners_where_the_camera_projects_them() {
    let (mut window, _folder) = four::four();
    let bare = four::away(&mut window);
    press_key(&mut window, Modifiers::NONE, Key::X);
    let boxed = four::away(&mut window);
    let state = window.state();
    let seen = state.pane_view(Stage::Ndc).expect("a view");
    let origin = four::rects(&window)[3].min;
    let origin = DVec2::new(origin.x.into(), origin.y.into());
    let objects = 0..state.scene().objects().len();
    let boxes = objects.map(|object| state.scene().bounds_of(object));
    let shown = boxes.flat_map(|bounds| bounds.corners()).filter(|corner| {
        let drawn = state.ndc().drawn(*corner).expect("behind near");
        let at = seen.project(drawn).expect("in front").px + origin;
        let [before, now] = [&bare, &boxed].map(|picture| about_pixel(picture, at));
        turned(&before, &now, look::BOXES.0)
    });
    // The others are behind objects and names.
    let shown = shown.count();
    assert!(shown >= 12, "{shown} of 24");
}

/// Where an object shows in the window, with room for its outline.
fn place_of(window: &Window, object: usize) -> Rect {
    let view = window.state().view();
    let size = DVec2::new(view.viewport.width().into(), view.viewport.height().into());
    let corners = window.state().scene().bounds_of(object).corners();
    let shown = corners.map(|corner| {
        let px = view.project(corner).expect("before the eye").px - 0.5 * size;
        #[expect(clippy::cast_possible_truncation, reason = "a place in the window")]
        let from_middle = vec2(px.x as f32, px.y as f32);
        MIDDLE + from_middle
    });
    Rect::from_points(&shown).expand(10.0)
}

/// How many pixels around the middle of the picture differ visibly outside of `objects`.
fn differing_beside(a: &Image<Rgb>, b: &Image<Rgb>, objects: &[Rect]) -> usize {
    let around = Rect::from_min_max(pos2(240.0, 60.0), pos2(939.5, 579.5));
    #[expect(clippy::cast_precision_loss, reason = "windows are small")]
    let counts = |[x, y]: [u32; 2]| {
        let at = pos2(x as f32, y as f32);
        around.contains(at) && !objects.iter().any(|object| object.contains(at))
    };
    images::differing_where(a, b, |a, b, at| images::apart(a, b, 12) && counts(at))
}

/// The grid keeps its place and size when an object is hidden or moved, even an object that lies far apart and makes up
/// most of the scene's size.
#[test]
fn the_grid_stays_when_an_object_is_hidden_or_moved() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("apart.toml");
    let distant = "name = \"distant\"\nshape = \"cube\"\nposition = [60, 0, 0]\n";
    std::fs::write(&path, format!("{ROW}\n[[object]]\n{distant}")).expect("writable");
    let mut window = open(vec![path], 1.0);
    let seen = |window: &mut Window| {
        window.send([Event::PointerGone]);
        window.picture().expect("a picture")
    };
    press_key(&mut window, Modifiers::NONE, Key::Num9);
    press_key(&mut window, Modifiers::NONE, Key::A);
    let before = seen(&mut window);
    let mut objects: Vec<_> = (0..4).map(|object| place_of(&window, object)).collect();
    press_key(&mut window, Modifiers::NONE, Key::G);
    let of_grid = differing_beside(&before, &seen(&mut window), &objects);
    press_key(&mut window, Modifiers::NONE, Key::G);
    assert!(of_grid > 1500, "{of_grid}");

    click_on(&mut window, "distant");
    press_key(&mut window, Modifiers::SHIFT, Key::H);
    assert!(!window.state().scene().objects()[3].visible);
    let hidden = differing_beside(&before, &seen(&mut window), &objects);
    assert!(20 * hidden < of_grid, "hidden: {hidden} of {of_grid}");

    press_key(&mut window, Modifiers::NONE, Key::U);
    click_on(&mut window, "distant");
    click_on(&mut window, "Placement");
    type_into(&mut window, "position x", "61");
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    // The arrows that move the object go with its numbers.
    click_on(&mut window, "Placement");
    objects.push(place_of(&window, 3));
    let moved = differing_beside(&before, &seen(&mut window), &objects);
    assert!(20 * moved < of_grid, "moved: {moved} of {of_grid}");
    assert!(window.state().scene().objects()[3].visible);
}

/// The row from the right, after a click on a control: the picture without boxes, and with them.
fn without_and_with_boxes(clicked: &str) -> (Window, TempDir, [Image<Rgb>; 2]) {
    let (mut window, folder) = row(1.0);
    press_key(&mut window, Modifiers::NONE, Key::Num3);
    click_on(&mut window, clicked);
    window.send([Event::PointerGone]);
    let bare = window.picture().expect("a picture");
    press_key(&mut window, Modifiers::NONE, Key::X);
    let boxed = window.picture().expect("a picture");
    (window, folder, [bare, boxed])
}

/// The box is about the object that is selected, whichever it is in the list.
#[test]
fn a_box_is_about_the_selected_object() {
    let (window, _folder, pictures) = without_and_with_boxes("middle");
    let corner = DVec3::new(0.5, 0.5, 0.5);
    let [bare, boxed] = pictures.map(|picture| about(&window, &picture, corner));
    assert!(turned(&bare, &boxed, look::BOXES.0), "{boxed:?}");
}

/// The view steps back, and the ray and its hits show at once; then it is as it was.
#[test]
fn a_frozen_camera_shows_at_once() {
    let (mut window, _folder) = row(1.0);
    click(&mut window, MIDDLE);
    window.send([Event::PointerGone]);
    let before = window.picture().expect("a picture");
    press_key(&mut window, Modifiers::NONE, Key::T);
    let frozen = window.picture().expect("a picture");
    let around = Rect::from_center_size(MIDDLE, vec2(400.0, 400.0));
    assert!(differing_in(&before, &frozen, around) > 50);
    press_key(&mut window, Modifiers::NONE, Key::T);
    let after = window.picture().expect("a picture");
    assert_eq!(differing_in(&before, &after, around), 0);
}

#[test]
fn no_box_is_about_a_hidden_object() {
    let (window, _folder, [bare, boxed]) = without_and_with_boxes("show middle");
    for (point, shows) in [([0.5, 0.5, 1.5], true), ([0.5, 0.5, 0.5], false)] {
        let [before, now] = [&bare, &boxed].map(|picture| about(&window, picture, point.into()));
        assert_eq!(turned(&before, &now, look::BOXES.0), shows, "{point:?}");
    }
}

/// The grid is for the whole scene, hidden objects included, and so is the step that is named beside it.
#[test]
fn the_grid_s_step_stays_when_objects_are_hidden() {
    let (mut window, _folder) = row(1.0);
    press_key(&mut window, Modifiers::NONE, Key::Num9);
    let before = control(&window, "grid step 1 unit").rect;
    for name in ["front", "middle", "back"] {
        click_on(&mut window, &format!("show {name}"));
    }
    assert_eq!(control(&window, "grid step 1 unit").rect, before);
}

/// A key whose lines cannot be seen yet says why, and one whose lines can be seen says nothing.
#[test]
fn an_overlay_without_lines_says_why() {
    let (mut window, _folder) = row(1.0);
    let mut said = |key: Key, held: Modifiers| {
        let before: Vec<_> = window.messages().map(str::to_owned).collect();
        press_key(&mut window, held, key);
        let mut new = window
            .messages()
            .filter(|text| !before.iter().any(|old| old == text));
        new.next().map(str::to_owned)
    };
    let none = Modifiers::NONE;
    let distance = said(Key::D, none).expect("a message");
    assert!(distance.contains("two points are picked"), "{distance}");
    let trees = said(Key::K, none).expect("a message");
    assert!(trees.contains("search tree"), "{trees}");
    assert_eq!(said(Key::K, Modifiers::SHIFT), None, "they are off again");
    assert_eq!(said(Key::D, none), None, "it is off again");
    for at in [MIDDLE, MIDDLE + vec2(10.0, 5.0)] {
        click(&mut window, at);
        window.wait_s(1.0);
    }
    window.wait_s(5.0);
    assert_eq!(window.messages().count(), 0);
    press_key(&mut window, none, Key::D);
    assert_eq!(window.messages().count(), 0);
}

/// Edges that are dense in the picture fade. Then the window says so, lest the wireframe look broken.
#[test]
fn it_is_said_that_dense_edges_fade() {
    for (side, is_dense) in [(10, false), (250, true)] {
        let (mut window, _folder, _) = stalls::opened(side);
        let says = |window: &Window| has_control(window, DENSE);
        press_key(&mut window, Modifiers::NONE, Key::W);
        assert_eq!(says(&window), is_dense, "{side}");
        press_key(&mut window, Modifiers::NONE, Key::W);
    }
}
const DENSE: &str = "most edges are closer together than pixels, and fade: come nearer";
