//! Several objects are selected in the list and in the picture, and hidden, isolated and framed together.

use super::*;

/// The names of all that is selected, the first one first.
fn all(window: &Window) -> Vec<&str> {
    let objects = window.state().scene().objects();
    let selected = window.state().all_selected();
    selected.map(|index| &*objects[index].name).collect()
}

/// Clicks while keys are held.
fn click_with(window: &mut Window, held: Modifiers, at: Pos2) {
    let press = |pressed| Event::PointerButton {
        pos: at,
        button: PointerButton::Primary,
        pressed,
        modifiers: held,
    };
    window.send([
        Event::ModifiersChanged(held),
        Event::PointerMoved(at),
        press(true),
        press(false),
        Event::ModifiersChanged(Modifiers::NONE),
    ]);
}

fn row_of(window: &Window, name: &str) -> Pos2 {
    control(window, name).rect.center()
}

fn shown(window: &Window) -> Vec<bool> {
    let objects = window.state().scene().objects().iter();
    objects.map(|object| object.visible).collect()
}

/// Clicks a row of the list, and then another one with Ctrl.
fn select_both(window: &mut Window, [first, second]: [&str; 2]) {
    click_on(window, first);
    let at = row_of(window, second);
    click_with(window, CTRL, at);
}

/// How much of the width or of the height the selected cubes reach across, whichever is more.
fn filled(window: &Window) -> f64 {
    let (state, view) = (window.state(), window.state().view());
    let corners = state
        .all_selected()
        .flat_map(|of| state.scene().bounds_of(of).corners());
    let seen = corners.map(|corner| view.project(corner).expect("in front").ndc.with_z(0.0));
    seen.map(|ndc| ndc.abs().max_element()).fold(0.0, f64::max)
}

#[test]
fn rows_are_added_taken_out_and_selected_in_a_range() {
    let (mut window, _folder) = row(1.0);
    select_both(&mut window, ["middle", "back"]);
    assert_eq!(all(&window), ["middle", "back"]);
    control(&window, "2 objects");
    control(&window, "object 2 first");
    control(&window, "shapes");
    // What was selected first is taken out: the other one takes its place.
    let at = row_of(&window, "middle");
    click_with(&mut window, CTRL, at);
    assert_eq!(all(&window), ["back"]);
    let at = row_of(&window, "front");
    click_with(&mut window, Modifiers::SHIFT, at);
    assert_eq!(all(&window), ["back", "front", "middle"]);
    // A plain click selects that one alone; one more, nothing.
    click_on(&mut window, "middle");
    assert_eq!(all(&window), ["middle"]);
    click_on(&mut window, "middle");
    assert!(all(&window).is_empty());
}

#[test]
fn clicks_in_the_picture_add_and_keep_the_pick() {
    let (mut window, _folder) = row(1.0);
    click(&mut window, MIDDLE);
    let (px, size) = (picked_px(&window), ["3 x 3 x 4.5", "1 x 1 x 1"]);
    control(&window, size[1]);
    // The back shows beside the front.
    let aside = MIDDLE + egui::vec2(0.0, 70.0);
    for held in [CTRL, Modifiers::SHIFT] {
        click_with(&mut window, held, aside);
        assert_eq!(all(&window), ["front", "back"], "{held:?}");
        assert_eq!(picked_px(&window), px);
        control(&window, size[0]);
        click_with(&mut window, held, aside);
        assert_eq!(all(&window), ["front"], "{held:?}");
    }
    // A click on nothing with a key held changes nothing.
    click_with(&mut window, CTRL, MIDDLE + egui::vec2(-300.0, -300.0));
    assert_eq!((all(&window), picked_px(&window)), (vec!["front"], px));
}

/// What is done to a selection is done to all of it, in one step of undo.
#[test]
fn hide_isolate_and_frame_act_on_all() {
    let (mut window, _folder) = row(1.0);
    let both = ["front", "back"];
    select_both(&mut window, both);
    press_key(&mut window, Modifiers::SHIFT, Key::H);
    assert_eq!(shown(&window), [false, true, false]);
    press_key(&mut window, CTRL, Key::Z);
    assert_eq!(
        (shown(&window), all(&window)),
        (vec![true; 3], vec!["front", "back"])
    );
    press_key(&mut window, Modifiers::NONE, Key::I);
    assert_eq!(shown(&window), [true, false, true]);
    press_key(&mut window, Modifiers::NONE, Key::U);
    // What is selected fills 85 % of the picture: first both, then one of them.
    let is_framed = |window: &Window| (filled(window) - 0.85).abs() < 1e-9;
    press_key(&mut window, Modifiers::NONE, Key::F);
    assert!(is_framed(&window), "{}", filled(&window));
    click_on(&mut window, "back");
    assert!(!is_framed(&window), "the farther one alone fills less");
    press_key(&mut window, Modifiers::NONE, Key::F);
    assert!(is_framed(&window), "{}", filled(&window));
    // The menu of the right button, on one of them.
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    select_both(&mut window, both);
    let at = row_of(&window, "back");
    menus::open_menu(&mut window, at);
    click_on(&mut window, "Hide the 2 selected");
    assert_eq!(shown(&window), [false, true, false]);
}

#[test]
fn what_is_found_is_selected() {
    let (mut window, _folder) = row(1.0);
    assert!(!has_control(&window, "select found"));
    type_into(&mut window, "search", "a");
    click_on(&mut window, "select found");
    assert_eq!(all(&window), ["back"]);
    type_into(&mut window, "search", "d");
    click_on(&mut window, "select found");
    assert_eq!(all(&window), ["middle"]);
    type_into(&mut window, "search", "no such name");
    assert!(!control(&window, "select found").is_enabled);
    click_on(&mut window, "search");
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(all(&window), ["middle"]);
}

/// Each selected object is tinted, and all of them have an outline.
#[test]
fn all_that_is_selected_is_outlined() {
    let (mut window, _folder) = row(1.0);
    let seen = |window: &mut Window| {
        window.send([Event::PointerGone]);
        window.picture().expect("a picture")
    };
    let area = Rect::from_center_size(pos2(590.0, 360.0), egui::vec2(700.0, 600.0));
    let none = seen(&mut window);
    click_on(&mut window, "front");
    let one = differing_in(&none, &seen(&mut window), area);
    let at = row_of(&window, "back");
    click_with(&mut window, CTRL, at);
    let both = differing_in(&none, &seen(&mut window), area);
    assert!(one > 5000 && both > one + 20_000, "{one} {both}");
}

/// The name under the cursor stands at the cursor once it rests, and goes as it moves on.
#[test]
fn what_is_under_the_cursor_is_named_there() {
    let (mut window, _folder) = row(1.0);
    let named = |window: &Window| {
        let mut all = window.controls().iter();
        all.any(|control| {
            control.name == "front" && control.rect.left() > 210.0 && control.rect.right() < 970.0
        })
    };
    window.picture().expect("a picture");
    window.send([Event::PointerMoved(MIDDLE)]);
    window.wait_s(1.0);
    assert!(named(&window));
    window.send([Event::PointerMoved(MIDDLE + egui::vec2(-300.0, -300.0))]);
    window.wait_s(1.0);
    assert!(!named(&window));
}

#[test]
fn a_range_takes_the_place_of_what_was_selected_besides() {
    let (mut window, _folder) = row(1.0);
    click_on(&mut window, "front");
    for (name, expected) in [
        ("back", &["front", "middle", "back"][..]),
        ("middle", &["front", "middle"]),
    ] {
        let at = row_of(&window, name);
        click_with(&mut window, Modifiers::SHIFT, at);
        assert_eq!(all(&window), expected);
    }
}

/// As many as before, but not the same.
#[test]
fn the_outline_follows_what_is_selected_besides() {
    let (mut window, _folder) = row(1.0);
    let area = Rect::from_center_size(pos2(590.0, 360.0), egui::vec2(700.0, 600.0));
    let toggle = |window: &mut Window, name: &str| {
        let at = row_of(window, name);
        click_with(window, CTRL, at);
        window.send([Event::PointerGone]);
    };
    click_on(&mut window, "front");
    toggle(&mut window, "back");
    let back = window.picture().expect("a picture");
    toggle(&mut window, "back");
    toggle(&mut window, "middle");
    let middle = window.picture().expect("a picture");
    let differ = differing_in(&back, &middle, area);
    assert!(differ > 5000, "{differ}");
}

/// The numbers of several objects follow the one that is moved.
#[test]
fn the_size_of_all_that_is_selected_follows_a_move() {
    let (mut window, _folder) = row(1.0);
    select_both(&mut window, ["front", "middle"]);
    assert!(has_control(&window, "1 x 1 x 3"));
    click_on(&mut window, "Placement");
    type_into(&mut window, "position x", "4");
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    assert!(has_control(&window, "5 x 1 x 3"));
}

/// What several objects are made of is said if all of them are made of the same.
#[test]
fn a_material_that_all_share_is_told() {
    let (mut window, _folder) = row(1.0);
    let neutral = "#e8e8ec";
    select_both(&mut window, ["front", "middle"]);
    assert!(!has_control(&window, neutral) && !has_control(&window, "#d1495b"));
    select_both(&mut window, ["front", "back"]);
    assert!(has_control(&window, neutral));
    click_on(&mut window, "middle");
    assert!(has_control(&window, "#d1495b"));
}
