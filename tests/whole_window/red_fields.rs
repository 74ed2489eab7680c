//! A refused input is red until it is given up, or until its field is about another object.

use super::*;

const NONE: Modifiers = Modifiers::NONE;

type Does = fn(&mut Window);

/// Types a value that is refused, and leaves the field.
fn refused(window: &mut Window, field: &str, text: &str) {
    type_into(window, field, text);
    press_key(window, NONE, Key::Enter);
    assert_eq!(control(window, field).value, text, "it stays to be mended");
}

fn is_red(window: &Window, field: &str) -> bool {
    let said = &control(window, field).description;
    said.contains("stays in force")
}

#[test]
fn a_red_field_says_what_is_wrong_and_what_is_in_force() {
    let (mut window, _folder) = row(1.0);
    click_on(&mut window, "Pose");
    for (field, text, wrong, in_force) in [
        ("fov", "abc", "not a number", "45 stays in force"),
        ("fov", "200", "field of view", "45 stays in force"),
        ("near", "-1", "near", "7.425 stays in force"),
        ("eye x", "", "not a number", "0 stays in force"),
    ] {
        type_into(&mut window, field, text);
        if text.is_empty() {
            press_key(&mut window, NONE, Key::Backspace);
        }
        press_key(&mut window, NONE, Key::Enter);
        assert_eq!(control(&window, field).value, text, "it stays to be mended");
        let said = control(&window, field).description.clone();
        assert!(
            said.contains(wrong) && said.contains(in_force),
            "{field} {text}: {said}"
        );
        click_on(&mut window, field);
        press_key(&mut window, NONE, Key::Escape);
        let said = &control(&window, field).description;
        assert!(!said.contains("stays in force"), "{said}");
    }
}

/// A text typed for one object does not move to another.
#[test]
fn a_red_field_is_of_its_own_object() {
    let (mut window, _folder) = row(1.0);
    click(&mut window, MIDDLE);
    click_on(&mut window, "Placement");
    type_into(&mut window, "position x", "abc");
    press_key(&mut window, NONE, Key::Enter);
    assert_eq!(control(&window, "position x").value, "abc");
    click_on(&mut window, "back");
    assert_eq!(selected(&window), Some("back"));
    assert_eq!(control(&window, "position x").value, "0");
    click_on(&mut window, "front");
    assert_eq!(control(&window, "position x").value, "0", "it is gone");
}

#[test]
fn esc_gives_a_red_text_up_before_anything_else() {
    let (mut window, _folder) = row(1.0);
    click(&mut window, MIDDLE);
    click_on(&mut window, "Placement");
    refused(&mut window, "scale x", "0");
    refused(&mut window, "near", "abc");
    press_key(&mut window, NONE, Key::Escape);
    assert_eq!(selected(&window), Some("front"));
    for (field, value) in [("scale x", "1"), ("near", "7.425")] {
        assert_eq!(control(&window, field).value, value);
        assert!(!is_red(&window, field), "{field}");
    }
    press_key(&mut window, NONE, Key::Escape);
    assert_eq!(selected(&window), None, "the next one is the shortcut");
}

#[test]
fn a_red_text_goes_with_what_it_was_typed_for() {
    let (mut window, _folder) = row(1.0);
    let away: [(&str, Does); 3] = [
        ("list", |window| {
            click_on(window, "back");
            click_on(window, "front");
        }),
        ("nothing", |window| {
            click(window, pos2(MIDDLE.x - 250.0, MIDDLE.y - 200.0));
            click_on(window, "front");
        }),
        ("folded", |window| {
            click_on(window, "Placement");
            window.wait_s(1.0);
            click_on(window, "Placement");
        }),
    ];
    click_on(&mut window, "front");
    click_on(&mut window, "Placement");
    for (name, away) in away {
        refused(&mut window, "scale x", "0");
        away(&mut window);
        assert_eq!(selected(&window), Some("front"), "{name}");
        assert_eq!(control(&window, "scale x").value, "1", "{name}");
        assert!(!is_red(&window, "scale x"), "{name}");
    }
}

/// A refused text that has become valid must not stand there as if it were in force.
#[test]
fn what_has_become_possible_meanwhile_is_not_shown_as_if_in_force() {
    let (mut window, _folder) = row(1.0);
    let set_far = |window: &mut Window, far: &str| {
        type_into(window, "far", far);
        press_key(window, NONE, Key::Enter);
    };
    set_far(&mut window, "12");
    refused(&mut window, "near", "20");
    assert!(is_red(&window, "near"));
    set_far(&mut window, "30");
    assert_eq!(control(&window, "near").value, "7.425");
    let near = window.state().view().camera.lens().near;
    assert!((near - 7.425).abs() < 1e-9, "{near}");
}

/// Neither a number that is refused nor its being mended moves a control: a click after it lands where it was aimed.
#[test]
fn what_is_refused_moves_nothing() {
    let (mut window, _folder) = row(1.0);
    click(&mut window, MIDDLE);
    click_on(&mut window, "Placement");
    window.send([Event::PointerGone]);
    window.wait_s(1.0);
    let places = |window: &Window| {
        let controls = window.controls().iter();
        let all = controls.filter(|control| control.role != Role::Label);
        all.map(|control| (control.name.clone(), control.rect))
            .collect::<Vec<_>>()
    };
    let before = places(&window);
    assert!(before.len() > 50, "{}", before.len());
    for (field, text) in [
        ("scale y", "abc"),
        ("near", "-1"),
        ("fov", "a text that is much longer than the field"),
    ] {
        refused(&mut window, field, text);
        window.send([Event::PointerGone]);
        for (now, before) in places(&window).iter().zip(&before) {
            assert_eq!(now, before, "{field}: {text}");
        }
        assert_eq!(places(&window).len(), before.len());
    }
}
