//! A key goes into a field while the field is edited, else to its shortcut. Every control has a name.

use super::*;
use egui::vec2;
use glam::DVec3;
use sightline::scene::{self, Progress};
use std::collections::{HashMap, HashSet};

const NONE: Modifiers = Modifiers::NONE;

fn eye(window: &Window) -> DVec3 {
    window.state().view().camera.eye()
}

fn focused(window: &Window) -> Option<&str> {
    let mut all = window.controls().iter();
    all.find(|control| control.has_focus)
        .map(|control| control.name.as_str())
}

/// A view that Enter would reset.
fn turned() -> (Window, TempDir) {
    let (mut window, folder) = row(1.0);
    drag(
        &mut window,
        PointerButton::Primary,
        MIDDLE,
        MIDDLE + vec2(90.0, -40.0),
    );
    (window, folder)
}

#[test]
fn enter_commits_a_number_and_leaves_the_view() {
    let (mut window, _folder) = turned();
    let before = eye(&window);
    type_into(&mut window, "fov", "20");
    press_key(&mut window, NONE, Key::Enter);
    assert!((window.state().controls().fov_deg - 20.0).abs() < f64::EPSILON);
    assert_eq!(eye(&window), before, "the view is not reset");
    assert_eq!(control(&window, "fov").value, "20");
    // Leaving the search field by Enter does not move the view either.
    click_on(&mut window, "search");
    press_key(&mut window, NONE, Key::Enter);
    assert_eq!(eye(&window), before);
    // Afterwards the key is a shortcut again.
    press_key(&mut window, NONE, Key::Enter);
    assert_eq!(eye(&window), DVec3::new(0.0, 0.0, 10.0));
    // Each number is one step of undo.
    press_key(&mut window, CTRL, Key::Z);
    press_key(&mut window, CTRL, Key::Z);
    assert!((window.state().controls().fov_deg - 45.0).abs() < f64::EPSILON);
}

/// All keys of a slow frame arrive at once: the field gets the whole number, and no other field gets a part of it.
#[test]
fn a_number_that_is_typed_within_one_frame_is_whole() {
    for end in [Key::Enter, Key::Tab] {
        let (mut window, _folder) = row(1.0);
        let near = control(&window, "near").value.clone();
        click_on(&mut window, "fov");
        press_key(&mut window, CTRL, Key::A);
        let mut events: Vec<Event> = ["6", "5", ".", "2", "5"]
            .map(|c| Event::Text(c.into()))
            .into();
        events.extend([key_event(NONE, end, true), key_event(NONE, end, false)]);
        window.send_at_once(events);
        assert!(
            (window.state().controls().fov_deg - 65.25).abs() < f64::EPSILON,
            "{end:?}"
        );
        assert_eq!(control(&window, "near").value, near);
    }
}

#[test]
fn esc_gives_a_number_up_and_nothing_else() {
    let (mut window, _folder) = row(1.0);
    click(&mut window, MIDDLE);
    type_into(&mut window, "fov", "20");
    press_key(&mut window, NONE, Key::Escape);
    assert_eq!(selected(&window), Some("front"), "the selection stays");
    assert_eq!(control(&window, "fov").value, "45");
    assert!((window.state().controls().fov_deg - 45.0).abs() < f64::EPSILON);
    press_key(&mut window, NONE, Key::Escape);
    assert_eq!(selected(&window), None, "the next one is the shortcut");
}

#[test]
fn arrows_step_a_number() {
    let (mut window, _folder) = row(1.0);
    click_on(&mut window, "fov");
    let shift = Modifiers::SHIFT;
    for (modifiers, key, expected) in [
        (NONE, Key::ArrowUp, 46.0),
        (NONE, Key::ArrowUp, 47.0),
        (NONE, Key::ArrowDown, 46.0),
        (shift, Key::ArrowUp, 56.0),
        (shift, Key::ArrowDown, 46.0),
    ] {
        press_key(&mut window, modifiers, key);
        assert!(
            (window.state().controls().fov_deg - expected).abs() < 1e-9,
            "{expected}"
        );
        assert_eq!(focused(&window), Some("fov"), "the field keeps the focus");
    }
    // An arrow steps from the number that is typed, and never to an invalid one.
    type_into(&mut window, "fov", "179.5");
    press_key(&mut window, NONE, Key::ArrowUp);
    assert!((window.state().controls().fov_deg - 179.5).abs() < 1e-9);
    press_key(&mut window, NONE, Key::ArrowDown);
    assert!((window.state().controls().fov_deg - 178.5).abs() < 1e-9);
    // Arrows step the pose too.
    click_on(&mut window, "Pose");
    click_on(&mut window, "eye z");
    let before = eye(&window);
    press_key(&mut window, NONE, Key::ArrowUp);
    assert!((eye(&window) - before - 0.01 * before.length() * DVec3::Z).length() < 1e-9);
}

#[test]
fn shortcuts_work_from_wherever_tab_leads() {
    let (mut window, _folder) = row(1.0);
    let mut seen = Vec::new();
    for _ in 0..6 {
        press_key(&mut window, NONE, Key::Tab);
        seen.extend(focused(&window).map(str::to_owned));
        let before = window.state().overlays();
        press_key(&mut window, NONE, Key::G);
        assert_ne!(window.state().overlays(), before, "at {seen:?}");
    }
    assert_eq!(seen.len(), 6, "{seen:?}");
    // Enter and Space press the button that has the focus; Esc takes the focus away.
    let view = *window.state().view();
    tab_to(&mut window, "Screenshot\u{2026}");
    press_key(&mut window, NONE, Key::Enter);
    assert!(
        has_control(&window, "save the screenshot"),
        "the button was pressed"
    );
    press_key(&mut window, NONE, Key::Escape);
    assert!(!has_control(&window, "save the screenshot"));
    assert_eq!(*window.state().view(), view, "and the view was not reset");
    click(&mut window, MIDDLE);
    press_key(&mut window, NONE, Key::Tab);
    press_key(&mut window, NONE, Key::Escape);
    assert_eq!((focused(&window), selected(&window)), (None, Some("front")));
}

/// Presses Tab until this control has the focus.
fn tab_to(window: &mut Window, name: &str) {
    for _ in 0..100 {
        if focused(window) == Some(name) {
            return;
        }
        press_key(window, NONE, Key::Tab);
    }
    panic!("Tab does not reach {name}");
}

/// Ctrl+S works while a button has the focus.
#[test]
fn ctrl_s_saves_while_a_button_has_the_focus() {
    let (mut window, folder) = row(1.0);
    click(&mut window, MIDDLE);
    press_key(&mut window, Modifiers::SHIFT, Key::H);
    tab_to(&mut window, "Frame all");
    press_key(&mut window, CTRL, Key::S);
    assert!(window.has_dialog());
    let path = folder.path().join("kept.toml");
    window.save_as(path.clone());
    let kept = scene::load(&[path], &Progress::default()).expect("a scene");
    let visible = |object: &scene::Object| object.visible;
    let visible: Vec<bool> = kept.scene.objects().iter().map(visible).collect();
    assert_eq!(visible, [false, true, true]);
}

#[test]
fn tab_walks_in_reading_order() {
    let (mut window, _folder) = row(1.0);
    click(&mut window, MIDDLE);
    for heading in ["Pose", "Placement"] {
        click_on(&mut window, heading);
    }
    let mut names: Vec<String> = Vec::new();
    loop {
        press_key(&mut window, NONE, Key::Tab);
        let name = focused(&window).expect("something").to_owned();
        if names.contains(&name) {
            break;
        }
        names.push(name);
    }
    let at = |name: &str| {
        let at = names.iter().position(|known| known == name);
        at.unwrap_or_else(|| panic!("no {name} in {names:?}"))
    };
    let order = [
        "Open\u{2026}",
        "Save\u{2026}",
        "Reload",
        "Frame all",
        "Overlays",
        "search",
        "show front",
        "front",
        "show back",
        "Copy the pick",
        "perspective",
        "fov",
        "near",
        "fit near",
        "far",
        "y points up",
        "eye x",
        "eye y",
        "target x",
        "up z",
        "Placement",
        "position x",
        "position y",
        "rotation x",
        "scale z",
    ];
    for pair in order.windows(2) {
        assert!(at(pair[0]) < at(pair[1]), "{pair:?} in {names:?}");
    }
}

#[test]
fn every_control_has_a_name() {
    let (mut window, folder) = row(1.0);
    click(&mut window, MIDDLE);
    window.drop_file(folder.path().join("absent.obj"));
    for key in [Key::P, Key::T] {
        press_key(&mut window, NONE, key);
    }
    for heading in [
        "Pose",
        "Placement",
        "Details",
        "Measure",
        "Section",
        "Depth buffer",
    ] {
        click_on(&mut window, heading);
    }
    click_on(&mut window, "File");
    let mut count = 0;
    let mut check = |window: &Window| {
        // Scroll bars and the title bars of windows are egui's own.
        let is_ours = |role| !matches!(role, Role::Label | Role::ScrollBar | Role::Unknown);
        let mut known = HashMap::new();
        for control in window
            .controls()
            .iter()
            .filter(|control| is_ours(control.role))
        {
            assert!(!control.name.is_empty(), "{control:?}");
            // A tool of the bar is called as in its menu, and as its topic of the inspector.
            let is_tool = control.rect.bottom() < 25.0;
            let is_beside = control.rect.left() > 970.0;
            let role = format!("{:?}", control.role);
            let key = (&control.name, role, is_tool, is_beside);
            let twin = known.insert(key, control.rect);
            assert!(
                twin.is_none_or(|at| at == control.rect),
                "{control:?} is called as another"
            );
            count += 1;
        }
    };
    check(&window);
    press_key(&mut window, NONE, Key::Escape);
    check(&window);
    // Each of two windows has its own close button.
    for key in [Key::Escape, Key::P, Key::H] {
        press_key(&mut window, NONE, key);
    }
    check(&window);
    press_key(&mut window, NONE, Key::H);
    press_key(&mut window, NONE, Key::E);
    press_key(&mut window, NONE, Key::M);
    check(&window);
    click_on(&mut window, "Learn");
    check(&window);
    assert!(count > 100, "{count}");
}

/// A typed eye keeps the horizon level, as orbiting does.
#[test]
fn a_typed_eye_leaves_the_horizon_level() {
    let (mut window, _folder) = turned();
    click_on(&mut window, "Pose");
    type_into(&mut window, "eye x", "65");
    press_key(&mut window, NONE, Key::Enter);
    let camera = window.state().view().camera;
    assert_eq!(camera.eye().x.to_bits(), 65_f64.to_bits());
    assert!(
        camera.right().y.abs() < 1e-15 && camera.up().y > 0.5,
        "{camera:?}"
    );
    // An up that is typed is taken as it is.
    type_into(&mut window, "up z", "0.5");
    press_key(&mut window, NONE, Key::Enter);
    let tilted = window.state().view().camera;
    assert!(tilted.right().y.abs() > 0.1, "{tilted:?}");
    type_into(&mut window, "eye x", "60");
    press_key(&mut window, NONE, Key::Enter);
    assert!(
        window.state().view().camera.right().y.abs() > 0.1,
        "it stays tilted"
    );
}

/// An up vector is typed number by number. What was typed stays, also numbers that are refused until the others are
/// there.
#[test]
fn an_up_vector_is_what_was_typed() {
    let texts =
        |window: &Window| ["up x", "up y", "up z"].map(|name| control(window, name).value.clone());
    let type_up = |window: &mut Window, numbers: [&str; 3]| {
        click_on(window, "up x");
        for (at, number) in numbers.into_iter().enumerate() {
            press_key(window, CTRL, Key::A);
            window.send([Event::Text(number.into())]);
            press_key(window, NONE, if at == 2 { Key::Enter } else { Key::Tab });
        }
    };
    let (mut window, _folder) = turned();
    click_on(&mut window, "Pose");
    for numbers in [["1", "0", "0"], ["0", "0", "1"], ["0", "2", "0"]] {
        type_up(&mut window, numbers);
        assert_eq!(texts(&window), numbers);
        let typed = DVec3::from_array(numbers.map(|number| number.parse().expect("a number")));
        let camera = window.state().view().camera;
        assert_eq!(camera.up_hint(), typed);
        assert!(camera.right().dot(typed).abs() < 1e-12 && camera.up().dot(typed) > 0.0);
    }
    // The number that would make the vector zero is refused.
    type_up(&mut window, ["0", "0", "0"]);
    let said = control(&window, "up y").description.clone();
    assert!(
        said.contains("up vector is zero") && said.contains("2 stays in force"),
        "{said}"
    );
    press_key(&mut window, NONE, Key::Escape);
    assert_eq!(texts(&window), ["0", "2", "0"]);
    // Another eye keeps it; a turn does not.
    type_up(&mut window, ["1", "1", "0"]);
    type_into(&mut window, "eye x", "3");
    press_key(&mut window, NONE, Key::Enter);
    assert_eq!(texts(&window), ["1", "1", "0"]);
    drag(
        &mut window,
        PointerButton::Primary,
        MIDDLE,
        MIDDLE + vec2(90.0, -40.0),
    );
    assert_ne!(texts(&window), ["1", "1", "0"]);
    press_key(&mut window, NONE, Key::Num1);
    assert_eq!(texts(&window), ["0", "1", "0"]);
}

/// README names a key as `<kbd>F</kbd>`.
#[test]
fn readme_names_keys_that_the_help_has() {
    let (mut window, _folder) = row(1.0);
    press_key(&mut window, NONE, Key::H);
    let texts = window.controls().iter();
    let texts = texts.filter(|control| control.role == Role::Label);
    let keys: HashSet<&str> = texts.flat_map(|text| text.name.split(", ")).collect();
    let named = include_str!("../../README.md").split("<kbd>").skip(1);
    let mut count = 0;
    for rest in named {
        let (key, _) = rest.split_once("</kbd>").expect("an end");
        assert!(keys.contains(key), "{key}");
        count += 1;
    }
    assert!(count > 10, "{count}");
}

/// The help shows what has the words that are typed, and each row says what a key does.
#[test]
fn the_help_is_searched() {
    let (mut window, _folder) = row(1.0);
    press_key(&mut window, NONE, Key::H);
    let undo = "Undo: take the last change back";
    let rows = |window: &Window| {
        let rows = [
            undo,
            "Redo: make it again",
            "orbit about the point under the cursor",
        ];
        rows.map(|row| has_control(window, row))
    };
    assert_eq!(rows(&window), [true; 3]);
    let field = control(&window, "search the help").rect;
    type_into(&mut window, "search the help", "LAST change");
    assert_eq!(rows(&window), [true, false, false]);
    assert_eq!(control(&window, "search the help").rect, field, "it stays");
    let keys = control(&window, "Ctrl+Z").rect;
    assert!((keys.center().y - control(&window, undo).rect.center().y).abs() < 2.0);
    type_into(&mut window, "search the help", "no such words");
    assert!(has_control(&window, "nothing has these words"));
    assert_eq!(control(&window, "search the help").rect, field, "it stays");
    press_key(&mut window, NONE, Key::Escape);
    assert!(!has_control(&window, "nothing has these words"));
    // The words are forgotten. What is typed at once goes into the field, and does nothing else.
    press_key(&mut window, NONE, Key::H);
    assert_eq!(rows(&window), [true; 3]);
    let grid = window.state().overlays();
    window.send_at_once(vec![press(Key::G), Event::Text("grid".into())]);
    assert_eq!(window.state().overlays(), grid);
    assert!(
        rows(&window) == [false; 3]
            && has_control(
                &window,
                "Grid: on the ground, with axes: x red, y green, z blue"
            )
    );
}
