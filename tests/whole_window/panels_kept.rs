//! Panels are painted again when they change, and the picture still equals one in which they are painted anew.

use crate::{MIDDLE, Window, click, click_on, drag, press_key, row, type_into};
use egui::{Event, Key, Modifiers, PointerButton, pos2, vec2};

/// Fails unless the picture stays the same to the bit when a lost device makes the window paint everything anew.
#[track_caller]
fn is_as_painted_anew(window: &mut Window, after: &str) {
    let kept = window.picture().expect("draws");
    window.lose_device();
    let anew = window.picture().expect("draws");
    let differ = kept
        .pixels()
        .iter()
        .zip(anew.pixels())
        .filter(|(a, b)| a != b);
    assert_eq!(differ.count(), 0, "after {after}");
}

#[test]
fn whatever_changes_is_painted() {
    for scale in [1.0, 1.25] {
        let (mut window, _folder) = row(scale);
        let plain = window.picture().expect("draws");
        click(&mut window, MIDDLE);
        is_as_painted_anew(&mut window, "a click");
        assert_ne!(window.picture().expect("draws").pixels(), plain.pixels());
        drag(
            &mut window,
            PointerButton::Primary,
            MIDDLE,
            MIDDLE + vec2(30.0, 20.0),
        );
        is_as_painted_anew(&mut window, "a turn");
        for y in [60.0, 100.0, 140.0, 180.0] {
            window.send([Event::PointerMoved(pos2(100.0, y))]);
        }
        is_as_painted_anew(&mut window, "hovering rows");
        type_into(&mut window, "near", "0.5");
        is_as_painted_anew(&mut window, "typing");
        click_on(&mut window, "Matrices panel");
        is_as_painted_anew(&mut window, "a panel over the picture");
        press_key(&mut window, Modifiers::NONE, Key::P);
        is_as_painted_anew(&mut window, "that it is gone");
    }
}
