//! Four views stand side by side. All of them are live, each turns alone, and a point has one colour in all.

use super::{images::differing, *};
use egui::vec2;

pub(super) const NAMES: [&str; 4] = ["object", "world", "view", "NDC"];

pub(super) fn rects(window: &Window) -> [Rect; 4] {
    NAMES.map(|name| control(window, &format!("stage {name}")).rect)
}

/// The views in which two pictures differ.
fn changed(a: &Image<Rgb>, b: &Image<Rgb>, rects: [Rect; 4]) -> [bool; 4] {
    // Below their headings.
    rects.map(|rect| differing_in(a, b, rect.with_min_y(rect.top() + 36.0).shrink(2.0)) > 60)
}

pub(super) fn four() -> (Window, TempDir) {
    let (mut window, folder) = row(1.0);
    press_key(&mut window, Modifiers::NONE, Key::Num4);
    (window, folder)
}

pub(super) fn away(window: &mut Window) -> Image<Rgb> {
    window.send([Event::PointerGone]);
    window.picture().expect("a picture")
}

#[test]
fn a_key_shows_four_views_with_the_matrices_and_takes_them_away() {
    let (mut window, _folder) = row(1.0);
    let before = window.picture().expect("a picture");
    press_key(&mut window, Modifiers::NONE, Key::Num4);
    assert_eq!(window.state().views(), Views::Four);
    control(&window, "P, row z");
    let [object, world, view, ndc] = rects(&window);
    assert!(object.right() < world.left() && object.bottom() < view.top());
    assert!(view.right() < ndc.left() && world.bottom() < ndc.top());
    assert!((object.area() / ndc.area() - 1.0).abs() < 0.02);
    press_key(&mut window, Modifiers::NONE, Key::Num4);
    assert!(!has_control(&window, "P, row z") && !has_control(&window, "stage world"));
    assert_eq!(differing(&away(&mut window), &before), 0);
    // If the matrices were open before, they stay, whether their own button shows the four views or the key.
    press_key(&mut window, Modifiers::NONE, Key::P);
    click_on(&mut window, "show four");
    assert_eq!(window.state().views(), Views::Four);
    press_key(&mut window, Modifiers::NONE, Key::Num4);
    assert_eq!(window.state().views(), Views::Picture);
    control(&window, "P, row z");
    press_key(&mut window, Modifiers::NONE, Key::Num4);
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(window.state().views(), Views::Picture);
    control(&window, "P, row z");
    press_key(&mut window, Modifiers::NONE, Key::P);
    // What the four views have opened goes with them, however they go.
    for leave in [Key::Num4, Key::V] {
        press_key(&mut window, Modifiers::NONE, Key::Num4);
        control(&window, "P, row z");
        press_key(&mut window, Modifiers::NONE, leave);
        assert_eq!(window.state().views(), Views::Picture);
        assert!(!has_control(&window, "P, row z"), "{leave:?}");
    }
}

#[test]
fn labels_say_what_the_panel_says() {
    let (mut window, _folder) = four();
    window.resize(px([1600, 1000], 1.0));
    let lens = *window.state().view().camera.lens();
    for (name, value) in [("near", lens.near), ("far", lens.far)] {
        let said = window.controls().iter().filter_map(|control| {
            let number = control.name.strip_prefix(name)?.trim();
            number.parse::<f64>().ok()
        });
        let said: Vec<f64> = said.collect();
        assert_eq!(said.len(), 2, "{name} in world and view: {said:?}");
        assert!(
            said.iter().all(|said| (said / value - 1.0).abs() < 1e-5),
            "{said:?} {value}"
        );
    }
    for name in [
        "eye",
        "x right",
        "y up",
        "z forward = depth",
        "F, depth",
        "near: z = 1",
        "far: z = 0",
    ] {
        control(&window, name);
    }
    let corner = |x: i32, y: i32, z: i32| format!("({x}, {y}, {z})");
    for (x, y) in [(-1, -1), (-1, 1), (1, -1), (1, 1)] {
        for z in [0, 1] {
            control(&window, &corner(x, y, z));
        }
    }
    control(&window, "z is depth, near 1, far 0; after P and / w");
    control(
        &window,
        "z is depth, away from the eye; left-handed, after V",
    );
    control(&window, "depth runs along F; right-handed, after M");
    control(&window, "front, before M");
    click_under(&mut window, "Depth buffer", "standard");
    control(&window, "near: z = 0");
    control(&window, "z is depth, near 0, far 1; after P and / w");
}

#[test]
fn all_views_are_live_and_each_turns_alone() {
    let (mut window, _folder) = four();
    let places = rects(&window);
    let first = away(&mut window);
    // The lens changes P's numbers, the frustum and NDC, but not the object's own space.
    let slider = control(&window, "P's fov").rect;
    let p_row = control(&window, "P, row x").rect;
    drag(
        &mut window,
        PointerButton::Primary,
        slider.left_center() + vec2(8.0, 0.0),
        slider.center(),
    );
    let slid = away(&mut window);
    assert_eq!(changed(&first, &slid, places), [false, true, true, true]);
    assert!(differing_in(&first, &slid, p_row) > 20, "P's numbers");
    // The camera moves, so in view space the world moves.
    press_key(&mut window, Modifiers::NONE, Key::Num7);
    let above = away(&mut window);
    assert_eq!(changed(&slid, &above, places), [false, true, true, true]);
    // A drag in a view changes that view alone.
    let (mut before, camera) = (above, *window.state().view());
    for (i, place) in places.into_iter().enumerate() {
        drag(
            &mut window,
            PointerButton::Primary,
            place.center(),
            place.center() + vec2(40.0, 12.0),
        );
        let now = away(&mut window);
        assert_eq!(changed(&before, &now, places), [0, 1, 2, 3].map(|j| i == j));
        before = now;
    }
    assert_eq!(*window.state().view(), camera);
    // With Ctrl the scene's camera turns, from every view.
    let at = places[0].center();
    let pressed = |pressed| Event::PointerButton {
        pos: at,
        button: PointerButton::Primary,
        pressed,
        modifiers: CTRL,
    };
    let moved = Event::PointerMoved(at + vec2(30.0, 5.0));
    let held = Event::ModifiersChanged(CTRL);
    window.send([Event::PointerMoved(at), held, pressed(true), moved]);
    window.send([pressed(false), Event::ModifiersChanged(Modifiers::NONE)]);
    assert_ne!(window.state().view().camera, camera.camera);
}

#[test]
fn a_matrix_that_is_edited_moves_what_it_makes() {
    let (mut window, _folder) = four();
    click_on(&mut window, "middle");
    let places = rects(&window);
    scroll_to(&mut window, "Placement");
    click_on(&mut window, "Placement");
    scroll_to(&mut window, "scale x");
    let first = away(&mut window);
    type_into(&mut window, "scale x", "-2");
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    let second = away(&mut window);
    assert_eq!(changed(&first, &second, places), [false, true, true, true]);
    control(&window, "det -2: volumes times 2, mirrored");
    control(&window, "middle, before M mirrors it");
}

/// The cube and the ball fill the same box, each in its own space.
#[test]
fn the_object_view_shows_the_object_that_is_selected() {
    let (mut window, _folder) = four();
    let [_, cube, ball, again] = ["middle", "front", "middle", "front"].map(|name| {
        click_on(&mut window, name);
        away(&mut window)
    });
    let object = rects(&window)[0];
    let object = object.with_min_y(object.top() + 36.0).shrink(2.0);
    assert!(differing_in(&cube, &ball, object) > 1000);
    assert_eq!(differing_in(&cube, &again, object), 0);
}

#[test]
fn one_made_large_is_the_single_stage_and_comes_back() {
    let (mut window, folder) = four();
    let all = away(&mut window);
    for (stage, name) in Stage::ALL {
        click_on(&mut window, &format!("enlarge {name}"));
        assert_eq!(window.state().views(), Views::One(stage));
        let large = away(&mut window);
        let options = Options {
            paths: vec![folder.path().join("row.toml")],
            views: Views::One(stage),
            ..Options::default()
        };
        let mut single = Window::open(options, px(SIZE, 1.0), 1.0);
        let single = single.picture().expect("a picture");
        assert_eq!(differing(&single, &large), 0, "{name}");
        click_on(&mut window, &format!("four views beside {name}"));
        assert_eq!(differing(&away(&mut window), &all), 0, "{name}");
    }
    // A double click beside the objects does the same, and selects nothing.
    let corner = rects(&window)[3].right_bottom() - vec2(6.0, 6.0);
    double_click(&mut window, corner);
    assert_eq!(window.state().views(), Views::One(Stage::Ndc));
    assert_eq!(selected(&window), None);
    double_click(&mut window, corner);
    assert_eq!(window.state().views(), Views::Four);
}

/// A click on a view's heading is none in the view below it, and a double click makes that view large.
#[test]
fn a_heading_is_not_the_view_below_it() {
    let (mut window, _folder) = four();
    click_on(&mut window, "middle");
    for place in rects(&window) {
        click(&mut window, place.left_top() + vec2(150.0, 12.0));
        assert_eq!(selected(&window), Some("middle"));
    }
    let heading = rects(&window)[3].left_top() + vec2(150.0, 12.0);
    double_click(&mut window, heading);
    assert_eq!(window.state().views(), Views::One(Stage::Ndc));
    assert_eq!(selected(&window), Some("middle"));
}

#[test]
fn a_row_under_the_cursor_lights_what_it_does() {
    let (mut window, _folder) = four();
    click_on(&mut window, "middle");
    let places = rects(&window);
    let dark = away(&mut window);
    let planes = [false, true, true, true];
    let axes = [false, true, true, false];
    let model = [true, true, false, false];
    for (matrix, rows) in [
        ("P", [planes, planes, planes, axes]),
        ("V", [axes; 4]),
        ("M", [model; 4]),
    ] {
        for (row, expected) in ["x", "y", "z", "w"].into_iter().zip(rows) {
            let name = format!("{matrix}, row {row}");
            let at = control(&window, &name).rect.center();
            window.send([Event::PointerMoved(at)]);
            assert!(window.state().row().is_some(), "{name}");
            let lit = window.picture().expect("a picture");
            // The row's hint lies below the cursor and may cover a part of NDC.
            let mut places = places;
            places[3].min.y = places[3].min.y.max(at.y + 100.0);
            let changed = changed(&dark, &lit, places);
            assert_eq!(changed, expected, "{name}");
        }
    }
    assert_eq!(differing(&away(&mut window), &dark), 0);
    assert_eq!(window.state().row(), None);
}

/// A screenshot of the picture is what the window shows in the picture's place: the four views with their labels.
#[test]
fn the_views_are_saved_alone_with_their_labels() {
    let (mut window, folder) = four();
    window.save_screenshots_in(folder.path().to_owned());
    window.send([Event::PointerGone]);
    let shown = window.picture().expect("a picture");
    let [object, .., ndc] = rects(&window);
    let place = object.union(ndc);
    for number in 1..=2 {
        shoot(&mut window, &[]);
        window.picture().expect("a picture");
        let saved = folder.path().join(format!("sightline-{number}.png"));
        let saved = super::images::read(&saved);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "within the window"
        )]
        let [left, top, width, height] =
            [place.left(), place.top(), place.width(), place.height()].map(|at| at as u32);
        assert_eq!(
            [saved.size().width(), saved.size().height()],
            [width, height]
        );
        // The message about the last picture lies over the window. The next picture must not show it.
        let part = shown.part([left, top], saved.size());
        assert_eq!(differing(&saved, &part), 0, "picture {number}");
    }
}

#[test]
fn the_four_views_need_no_frozen_camera() {
    let (mut window, _folder) = row(1.0);
    let view = *window.state().view();
    press_key(&mut window, Modifiers::NONE, Key::Num4);
    assert!(window.state().frozen().is_none());
    // In the picture it is seen from outside, too: one key leads there.
    press_key(&mut window, Modifiers::NONE, Key::T);
    assert_eq!(window.state().views(), Views::Picture);
    let frozen = window.state().frozen().expect("it stands").view.camera;
    assert_eq!(frozen, view.camera);
    // One that stands already shows again.
    press_key(&mut window, Modifiers::NONE, Key::Num4);
    press_key(&mut window, Modifiers::NONE, Key::T);
    assert_eq!(window.state().views(), Views::Picture);
    assert_eq!(
        window.state().frozen().expect("it stands").view.camera,
        frozen
    );
}

/// If there is room for one side only, the key P brings the matrices to the front.
#[test]
fn the_key_of_the_matrices_shows_them_in_a_small_window() {
    let (mut window, _folder) = row(1.0);
    window.resize(px([640, 400], 1.0));
    press_key(&mut window, Modifiers::NONE, Key::P);
    control(&window, "P, row x");
    press_key(&mut window, Modifiers::NONE, Key::P);
    assert!(!has_control(&window, "P, row x"));
}

#[test]
fn a_scene_of_nothing_has_four_views() {
    let (mut window, _folder) = row_as("[camera]\neye = [3, 2, 4]\n", 1.0);
    assert!(window.state().scene().objects().is_empty());
    press_key(&mut window, Modifiers::NONE, Key::Num4);
    assert_eq!(window.state().views(), Views::Four);
    assert_eq!(rects(&window).map(|rect| rect.is_positive()), [true; 4]);
}
