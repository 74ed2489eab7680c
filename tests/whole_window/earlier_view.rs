//! A pick belongs to the view that it was made in. After the view changes, the panel says so, and the copied command
//! repeats that pick.

use super::*;
use egui::vec2;
use std::process::Command;

const NONE: Modifiers = Modifiers::NONE;

/// A change of the view.
type Does = fn(&mut Window);

/// A point beside the middle, on the front of the cube.
fn aside() -> Pos2 {
    MIDDLE + vec2(13.0, 7.0)
}

fn copied(window: &mut Window, key: Key) -> String {
    press_key(window, NONE, key);
    window.copied().expect("something copied").to_owned()
}

/// What the copied command prints.
fn answer(command: &str) -> String {
    let mut words = command.split_whitespace();
    assert_eq!(words.next(), Some("sightline"));
    let said = Command::new(env!("CARGO_BIN_EXE_sightline"))
        .args(words)
        .output()
        .expect("it runs");
    assert!(said.status.success(), "{command}: {said:?}");
    let text = String::from_utf8(said.stdout).expect("JSON");
    text.trim_end().to_owned()
}

fn says(window: &Window, words: &str) -> bool {
    let mut all = window.controls().iter();
    all.any(|control| control.name.contains(words))
}

fn typed(window: &mut Window, field: &str, number: &str) {
    type_into(window, field, number);
    press_key(window, NONE, Key::Enter);
}

#[test]
fn what_is_copied_repeats_the_pick_after_any_change_of_view() {
    let changes: [(&str, Does); 9] = [
        ("orbit", |window| {
            drag(
                window,
                PointerButton::Primary,
                MIDDLE,
                MIDDLE + vec2(70.0, 20.0),
            );
        }),
        ("pan", |window| {
            drag(
                window,
                PointerButton::Secondary,
                MIDDLE,
                MIDDLE + vec2(70.0, 20.0),
            );
        }),
        ("frame", |window| press_key(window, NONE, Key::F)),
        ("projection", |window| press_key(window, NONE, Key::Num5)),
        ("fov", |window| typed(window, "fov", "37.3")),
        ("near", |window| typed(window, "near", "7.6")),
        ("depth", |window| {
            click_under(window, "Depth buffer", "standard");
        }),
        ("cull", |window| press_key(window, NONE, Key::B)),
        ("size", |window| window.resize(px([1180, 700], 1.0))),
    ];
    for (name, change) in changes {
        let (mut window, _folder) = row(1.0);
        // A field of view that degrees and radians do not hold alike.
        typed(&mut window, "fov", "44.4");
        click(&mut window, aside());
        let (json, at) = (copied(&mut window, Key::J), picked_px(&window));
        assert!(json.contains("\"front\",\"id\":1"), "{json}");
        assert!(!says(&window, "earlier view"), "{name}");
        change(&mut window);
        assert_eq!(selected(&window), Some("front"), "{name}");
        assert_eq!(picked_px(&window), at, "{name}");
        let words = match name {
            "size" => "Picked at an earlier size",
            "near" => "Picked earlier; this view does not show it.",
            _ => "Picked in an earlier view",
        };
        assert!(says(&window, words), "{name}");
        assert_eq!(says(&window, "does not show it"), name == "near", "{name}");
        assert_eq!(copied(&mut window, Key::J), json, "{name}");
        let command = copied(&mut window, Key::C);
        assert_eq!(answer(&command), json, "{name}: {command}");
        // A click there belongs to the view on screen again.
        window.wait_s(1.0);
        click(&mut window, aside());
        assert!(!says(&window, "Picked "), "{name}");
        let (json, command) = (copied(&mut window, Key::J), copied(&mut window, Key::C));
        assert_eq!(answer(&command), json, "{name}: {command}");
    }
}

#[test]
fn a_view_that_comes_back_is_the_pick_s_own_again() {
    let (mut window, _folder) = row(1.0);
    click(&mut window, aside());
    press_key(&mut window, NONE, Key::Num3);
    assert!(says(&window, "earlier view"));
    press_key(&mut window, CTRL, Key::Z);
    assert!(!says(&window, "earlier view"));
    // Hiding or showing objects changes the fitted planes; the pick is made again in the new view.
    let json = copied(&mut window, Key::J);
    click_on(&mut window, "show back");
    assert!(!says(&window, "earlier view"));
    let again = copied(&mut window, Key::J);
    assert_ne!(json, again, "NDC is by other planes");
    assert_eq!(answer(&copied(&mut window, Key::C)), again);
    // In another view the pick still belongs to its first view.
    press_key(&mut window, NONE, Key::Num3);
    click_on(&mut window, "show middle");
    assert!(says(&window, "earlier view"));
    let again = copied(&mut window, Key::J);
    assert_eq!(answer(&copied(&mut window, Key::C)), again);
}

#[test]
fn a_click_picks_from_the_picture_on_screen_whatever_key_came_before_it() {
    for key in [Key::Num9, Key::Num3, Key::A, Key::F, Key::Num5] {
        let (mut window, _folder) = row(1.0);
        window.picture().expect("a picture");
        let on_screen = *window.state().view();
        let [down, up] = [true, false].map(down_up);
        let key = press(key);
        window.send_undrawn([Event::PointerMoved(aside()), key.clone(), down, up]);
        assert_ne!(*window.state().view(), on_screen, "{key:?}");
        assert_eq!(selected(&window), Some("front"), "{key:?}");
        let ray = window.state().pick_ray().expect("a pick");
        assert_eq!(ray.view, on_screen, "{key:?}");
        assert!(says(&window, "Picked in an earlier view"), "{key:?}");
        // The next one is in the new view.
        window.picture().expect("a picture");
        window.wait_s(1.0);
        let new = *window.state().view();
        window.send_undrawn([true, false].map(down_up));
        assert_eq!(window.state().pick_ray().map(|ray| ray.view), Some(new));
    }
}

/// The command shows what the scene file hides and the window shows, and hides what the window hides.
#[test]
fn a_copied_command_shows_what_the_window_shows() {
    let hidden = ROW.replace("name = \"front\"", "name = \"front\"\nvisible = false");
    let (mut window, _folder) = row_as(&hidden, 1.0);
    click(&mut window, aside());
    assert_eq!(selected(&window), Some("middle"));
    let command = copied(&mut window, Key::C);
    assert!(!command.contains("--show"), "{command}");
    click_on(&mut window, "show front");
    click_on(&mut window, "show middle");
    window.wait_s(1.0);
    click(&mut window, aside());
    assert_eq!(selected(&window), Some("front"));
    let (json, command) = (copied(&mut window, Key::J), copied(&mut window, Key::C));
    assert!(command.contains("--hide 2 --show 1"), "{command}");
    assert_eq!(answer(&command), json, "{command}");
}

fn down_up(down: bool) -> Event {
    button(aside(), PointerButton::Primary, down)
}

#[test]
fn a_surface_behind_is_among_those_that_the_command_lists() {
    let (mut window, _folder) = row(1.0);
    click(&mut window, aside());
    press_key(&mut window, NONE, Key::N);
    let json = copied(&mut window, Key::J);
    assert!(json.contains("\"front\":false"), "{json}");
    // Seen from the front, the back of the cube is culled.
    press_key(&mut window, NONE, Key::B);
    assert!(says(&window, "does not show it"));
    let command = copied(&mut window, Key::C);
    let all: serde_json::Value = serde_json::from_str(&answer(&command)).expect("JSON");
    let one: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(all["hits"][1], one["hit"], "{command}");
    assert_eq!(all["hits"].as_array().map(Vec::len), Some(5));
}

#[test]
fn a_click_on_nothing_is_repeated_while_its_view_lasts() {
    let (mut window, _folder) = row(1.0);
    let nothing = pos2(MIDDLE.x - 250.0, MIDDLE.y - 200.0);
    click(&mut window, nothing);
    assert_eq!(selected(&window), None);
    let json = copied(&mut window, Key::J);
    assert!(json.contains("\"hit\":null"), "{json}");
    let command = copied(&mut window, Key::C);
    assert_eq!(answer(&command), json, "{command}");
    press_key(&mut window, NONE, Key::Num3);
    let size = window.state().view().viewport;
    let middle = DVec2::new(size.width().into(), size.height().into()) / 2.0;
    let command = copied(&mut window, Key::C);
    assert!(
        command.contains(&format!("--at {},{}", middle.x, middle.y)),
        "{command}"
    );
    // The clipboard keeps what it has, and a message says why.
    assert_eq!(copied(&mut window, Key::J), command);
    assert!(window.messages().any(|text| text.contains("no pick")));
}
