//! A device that is lost takes nothing with it.

use super::{MIDDLE, click, press_key, row, selected};
use egui::{Key, Modifiers};

#[test]
fn a_lost_device_is_replaced_and_everything_is_as_it_was() {
    let (mut window, _folder) = row(1.0);
    click(&mut window, MIDDLE);
    press_key(&mut window, Modifiers::NONE, Key::P);
    let before = window.picture().expect("a picture");
    assert!(!window.draw().expect("a frame"), "nothing had changed");
    window.lose_device();
    assert!(window.draw().expect("a frame"), "all of it anew");
    let after = window.picture().expect("a picture");
    assert!(before.pixels() == after.pixels());
    assert_eq!(selected(&window), Some("front"));
    assert_eq!(window.messages().count(), 0);
}
