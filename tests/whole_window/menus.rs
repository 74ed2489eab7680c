//! The menu of the right mouse button offers what applies to the object, the row or the view under the cursor.

use super::*;

pub(super) fn open_menu(window: &mut Window, at: Pos2) {
    window.send([Event::PointerMoved(at)]);
    let press = |pressed| button(at, PointerButton::Secondary, pressed);
    window.send([press(true), press(false)]);
}

#[test]
fn on_an_object_it_does_what_applies_to_it() {
    let (mut window, _folder) = row(1.0);
    open_menu(&mut window, MIDDLE);
    assert_eq!(selected(&window), None, "opening it picks nothing");
    assert!(!has_control(&window, "Copy its pick"), "nothing is picked");
    click_on(&mut window, "Hide it");
    assert!(!window.state().scene().objects()[0].visible);
    // The entries that show now.
    open_menu(&mut window, MIDDLE);
    click_on(&mut window, "Isolate it");
    let visible = |window: &Window| -> Vec<_> {
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
    click_on(&mut window, "Copy its pick");
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

/// The arrows walk through an open menu, not through the objects, and Enter on a line closes it.
#[test]
fn keys_are_an_open_menu_s() {
    let (mut window, _folder) = row(1.0);
    let key = |window: &mut Window, key| press_key(window, Modifiers::NONE, key);
    click(&mut window, MIDDLE);
    let (view, pick) = (*window.state().view(), picked_px(&window));
    click_on(&mut window, "View");
    key(&mut window, Key::ArrowDown);
    assert_eq!(selected(&window), Some("front"));
    assert_eq!(picked_px(&window), pick);
    assert!(has_control(&window, "Full screen"));
    key(&mut window, Key::Enter);
    assert!(!has_control(&window, "Full screen"), "it is closed");
    assert_eq!(selected(&window), Some("front"));
    assert_ne!(*window.state().view(), view, "its first line was done");
    // So does a line of the menu of the right button.
    open_menu(&mut window, MIDDLE);
    key(&mut window, Key::ArrowDown);
    key(&mut window, Key::Enter);
    assert!(!has_control(&window, "Pick this point"), "it is closed");
    // Without a menu the arrows walk through the objects.
    key(&mut window, Key::ArrowDown);
    assert_eq!(selected(&window), Some("middle"));
}

/// Once the menu is closed, Esc does what it does without one.
#[test]
fn esc_closes_a_menu_and_nothing_else() {
    let esc = |window: &mut Window| press_key(window, Modifiers::NONE, Key::Escape);
    let (mut window, _folder) = row(1.0);
    click(&mut window, MIDDLE);
    window.wait_s(1.0);
    open_menu(&mut window, MIDDLE);
    assert!(has_control(&window, "Hide it"));
    esc(&mut window);
    assert!(!has_control(&window, "Hide it"), "it is closed");
    assert_eq!(selected(&window), Some("front"));
    esc(&mut window);
    assert_eq!(selected(&window), None);
    // A menu of the bar, over the four views and in the gallery.
    press_key(&mut window, Modifiers::NONE, Key::Num4);
    click_on(&mut window, "View");
    click_on(&mut window, "Overlays");
    assert!(has_control(&window, "Wireframe"));
    esc(&mut window);
    assert!(!has_control(&window, "Wireframe"));
    assert_eq!(window.state().views(), Views::Four);
    esc(&mut window);
    assert_eq!(window.state().views(), Views::Picture);
    press_key(&mut window, Modifiers::NONE, Key::E);
    click_on(&mut window, "View");
    assert!(has_control(&window, "Full screen"));
    esc(&mut window);
    assert!(!has_control(&window, "Full screen"));
    assert!(window.state().showing().is_some(), "still in the gallery");
    esc(&mut window);
    assert!(window.state().showing().is_none());
}

/// A point of one of the four views over an object, or over none.
fn point_of(window: &mut Window, stage: &str, is_over: Option<usize>) -> Pos2 {
    let rect = control(window, &format!("stage {stage}")).rect;
    let inside = rect.with_min_y(rect.top() + 40.0).shrink(12.0);
    for i in 0..400_u16 {
        let [x, y] = [i % 20, i / 20].map(|at| f32::from(at) / 19.0);
        let at = inside.lerp_inside(egui::vec2(x, y));
        window.send([Event::PointerMoved(at)]);
        if window.state().hover() == is_over {
            return at;
        }
    }
    panic!("{is_over:?} is nowhere in {stage}")
}

#[test]
fn in_the_four_views_it_is_about_the_view_under_the_cursor() {
    let (mut window, _folder) = row(1.0);
    press_key(&mut window, Modifiers::NONE, Key::Num4);
    let hidden = |window: &Window| -> Vec<_> {
        let objects = window.state().scene().objects().iter();
        objects.map(|object| !object.visible).collect()
    };
    for stage in ["world", "view", "NDC"] {
        let at = point_of(&mut window, stage, Some(0));
        open_menu(&mut window, at);
        click_on(&mut window, "Hide it");
        assert_eq!(hidden(&window), [true, false, false], "{stage}");
        open_menu(&mut window, at);
        click_on(&mut window, "Show all");
        assert_eq!(hidden(&window), [false; 3], "{stage}");
        assert_eq!(window.state().views(), Views::Four);
        // It picks in the view in which it was opened.
        let at = point_of(&mut window, stage, Some(0));
        open_menu(&mut window, at);
        click_on(&mut window, "Pick this point");
        assert_eq!(selected(&window), Some("front"), "{stage}");
        press_key(&mut window, Modifiers::NONE, Key::Escape);
        // On nothing, a view can be framed alone.
        let at = point_of(&mut window, stage, None);
        let before = *window.state().view();
        open_menu(&mut window, at);
        assert!(!has_control(&window, "Hide it"));
        click_on(&mut window, "Frame this view");
        assert_eq!(*window.state().view(), before, "{stage}: the camera stays");
    }
}

/// A long name makes the menu neither wide nor high.
#[test]
fn a_long_name_leaves_the_menu_small() {
    let name = "a_very_long_name_".repeat(12);
    let text = ROW.replace("\"front\"", &format!("\"{name}\""));
    let (mut window, _folder) = row_as(&text, 1.0);
    open_menu(&mut window, MIDDLE);
    let mut headings = window.controls().iter();
    // The status line has the name too.
    let below = egui::Rect::from_min_size(MIDDLE, egui::vec2(600.0, 250.0));
    let is_heading = |control: &&Control| control.name == name && below.contains(control.rect.min);
    let heading = headings.find(is_heading).expect("a heading").rect;
    for rect in [heading, control(&window, "Hide it").rect] {
        assert!(rect.width() < 250.0 && rect.height() < 30.0, "{rect}");
    }
}
