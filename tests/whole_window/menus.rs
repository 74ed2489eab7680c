//! The menu of the right mouse button offers what applies to the object, the row or the view under the cursor.

use super::*;

fn open_menu(window: &mut Offscreen, at: Pos2) {
    window.send([Event::PointerMoved(at)]);
    let press = |pressed| button(at, PointerButton::Secondary, pressed);
    window.send([press(true), press(false)]);
}

#[test]
fn on_an_object_it_does_what_applies_to_it() {
    let (mut window, _folder) = row(1.0);
    open_menu(&mut window, MIDDLE);
    assert_eq!(selected(&window), None, "opening it picks nothing");
    assert!(!has_control(&window, "Copy the pick"), "nothing is picked");
    click_on(&mut window, "Hide it");
    assert!(!window.state().scene().objects()[0].visible);
    // The entries that show now.
    open_menu(&mut window, MIDDLE);
    click_on(&mut window, "Hide all others");
    let visible = |window: &Offscreen| -> Vec<_> {
        let objects = window.state().scene().objects().iter();
        objects.map(|object| object.visible).collect()
    };
    assert_eq!(visible(&window), [false, true, false]);
    open_menu(&mut window, MIDDLE);
    click_on(&mut window, "Show all");
    assert_eq!(visible(&window), [true; 3]);
    open_menu(&mut window, MIDDLE);
    click_on(&mut window, "Pick this point");
    assert_eq!(selected(&window), Some("front"));
    assert!(picked_px(&window).is_some());
    open_menu(&mut window, MIDDLE);
    click_on(&mut window, "Copy the pick");
    assert!(
        window
            .copied()
            .is_some_and(|text| text.contains("\"front\""))
    );
    // In the list, the menu is about the row's object.
    let at = control(&window, "back").rect.center();
    open_menu(&mut window, at);
    click_on(&mut window, "Copy its name");
    assert_eq!(window.copied(), Some("back"));
    open_menu(&mut window, at);
    click_on(&mut window, "Frame it");
    assert_eq!(selected(&window), Some("back"));
}

#[test]
fn on_nothing_it_is_about_the_view() {
    let (mut window, _folder) = row(1.0);
    let corner = MIDDLE + egui::vec2(-300.0, -280.0);
    press_key(&mut window, Modifiers::NONE, Key::Num7);
    let turned = *window.state().view();
    open_menu(&mut window, corner);
    assert!(!has_control(&window, "Hide it"));
    click_on(&mut window, "Copy the view as a command");
    assert!(
        window
            .copied()
            .is_some_and(|text| text.starts_with("sightline pick"))
    );
    open_menu(&mut window, corner);
    click_on(&mut window, "Reset the view");
    assert_ne!(*window.state().view(), turned);
    // A drag with the right button is not a click.
    drag(
        &mut window,
        PointerButton::Secondary,
        MIDDLE,
        MIDDLE + egui::vec2(40.0, 0.0),
    );
    assert!(!has_control(&window, "Pick this point"));
}
