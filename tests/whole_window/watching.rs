//! What is open is watched, wherever the user was in the meantime and whatever loads.

use super::{remembering::wait_until, *};
use std::{fs, thread, time::Duration};

/// Four objects, one more than [`ROW`] has.
fn more() -> String {
    format!("{ROW}\n[[object]]\nname = \"new\"\nshape = \"sphere\"\n")
}

fn count(window: &Offscreen) -> usize {
    window.state().scene().objects().len()
}

fn leave_the_gallery(window: &mut Offscreen) {
    click_on(window, "Gallery");
    click_on(window, "leave the gallery");
    assert_eq!(window.state().name(), "row.toml");
}

#[test]
fn what_was_left_for_the_gallery_is_watched() {
    let (mut window, folder) = row(1.0);
    let path = folder.path().join("row.toml");
    press_key(&mut window, Modifiers::NONE, Key::E);
    leave_the_gallery(&mut window);
    fs::write(&path, more()).expect("writable");
    wait_until(&mut window, |window| count(window) == 4);
    // It changes while an exhibit is on show.
    press_key(&mut window, Modifiers::NONE, Key::E);
    let objects = count(&window);
    fs::write(&path, ROW).expect("writable");
    thread::sleep(Duration::from_millis(800));
    window.send([]);
    assert_eq!(count(&window), objects, "the exhibit stays");
    leave_the_gallery(&mut window);
    wait_until(&mut window, |window| count(window) == 3);
}

#[test]
fn a_change_during_a_load_is_read_after_it() {
    let (mut window, folder) = row(1.0);
    let ground = stalls::ground(folder.path(), 450);
    window.send([Event::ModifiersChanged(Modifiers::SHIFT)]);
    window.begin_to_drop(ground);
    fs::write(folder.path().join("row.toml"), more()).expect("writable");
    window.send([Event::ModifiersChanged(Modifiers::NONE)]);
    wait_until(&mut window, |window| count(window) == 5);
}

/// A load that the user cancels does not take the change with it. A change that is being read is cancelled for good.
#[test]
fn a_change_outlasts_a_load_that_is_cancelled() {
    let (mut window, folder) = row(1.0);
    let ground = stalls::ground(folder.path(), 450);
    window.send([Event::ModifiersChanged(Modifiers::SHIFT)]);
    window.begin_to_drop(ground);
    fs::write(folder.path().join("row.toml"), more()).expect("writable");
    window.send([Event::ModifiersChanged(Modifiers::NONE), press(Key::Escape)]);
    wait_until(&mut window, |window| count(window) == 4);
}
