//! In a narrow window nothing is cut off, and what was out of sight can be seen.

use super::*;

const NONE: Modifiers = Modifiers::NONE;

fn demo(points: [u32; 2]) -> Window {
    Window::open(Options::default(), px(points, 1.0), 1.0)
}

#[track_caller]
fn is_within(window: &Window, name: &str) {
    let rect = control(window, name).rect;
    assert!(
        rect.left() >= 0.0 && rect.right() <= 400.0,
        "{name}: {rect}"
    );
}

#[test]
fn help_is_as_narrow_as_the_window() {
    let mut window = demo([400, 700]);
    press_key(&mut window, NONE, Key::H);
    is_within(&window, "Take the tour");
    is_within(&window, "Undo: take the last change back");
}
