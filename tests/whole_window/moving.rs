//! Arrows in the picture move and turn what is selected; numbers turn it about its own centre.

use super::*;
use egui::Vec2;
use glam::{DAffine3, DVec3};

const NAMES: [&str; 3] = ["move along x", "move along y", "move along z"];

fn model(window: &Window) -> DAffine3 {
    let object = window.state().selected().expect("a selection");
    window.state().scene().objects()[object].placement.model()
}

/// A window that shows a wedge away from the origin, from its front, with its arrows.
fn wedge() -> (Window, TempDir) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("wedge.obj");
    let text = "v 5 1 0\nv 7 1 0\nv 5 2 0\nv 5 1 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    std::fs::write(&path, text).expect("a writable folder");
    let mut window = open(vec![path], 1.0);
    press_key(&mut window, Modifiers::NONE, Key::Num1);
    press_key(&mut window, Modifiers::NONE, Key::ArrowDown);
    press_key(&mut window, Modifiers::NONE, Key::O);
    (window, folder)
}

/// The middle of the wedge's box, in its own space.
const MIDDLE_OF_WEDGE: DVec3 = DVec3::new(6.0, 1.5, 0.5);

/// Which way an axis runs in the picture, from the middle of what is selected.
fn along(window: &Window, axis: DVec3) -> Vec2 {
    let (view, from) = (window.state().view(), model(window).translation);
    let [from, to] = [from, from + 0.1 * axis].map(|at| view.project(at).expect("in view").px);
    let along = (to - from).normalize().as_vec2();
    egui::vec2(along.x, along.y)
}

/// An arrow moves the object along its axis alone, and its head stays under the cursor. That is one step of undo, and
/// does not turn the view.
#[test]
fn an_arrow_moves_the_object_along_its_axis() {
    let (mut window, _folder) = row(1.0);
    press_key(&mut window, Modifiers::NONE, Key::Num9);
    click(&mut window, MIDDLE);
    assert!(NAMES.iter().all(|name| !has_control(&window, name)));
    press_key(&mut window, Modifiers::NONE, Key::O);
    for (name, axis) in NAMES.into_iter().zip(DVec3::AXES) {
        let (before, camera) = (model(&window), window.state().view().camera.eye());
        // Away from the cursor, an arrow is grabbed by its head.
        window.send([Event::PointerGone]);
        let at = control(&window, name).rect.center();
        let to = at + 40.0 * along(&window, axis);
        drag(&mut window, PointerButton::Primary, at, to);
        let by = model(&window).translation - before.translation;
        assert!(by.dot(axis) > 0.1, "{name}: {by}");
        assert_eq!(by - by.dot(axis) * axis, DVec3::ZERO, "{name}");
        assert_eq!(model(&window).matrix3, before.matrix3, "{name}");
        window.send([Event::PointerGone]);
        let head = control(&window, name).rect.center();
        assert!(head.distance(to) < 4.0, "{name}: {head}, not {to}");
        assert_eq!(
            window.state().view().camera.eye(),
            camera,
            "it does not turn"
        );
        press_key(&mut window, CTRL, Key::Z);
        assert_eq!(model(&window), before, "{name}: one step");
    }
    press_key(&mut window, Modifiers::NONE, Key::O);
    assert!(NAMES.iter().all(|name| !has_control(&window, name)));
}

/// With Shift an arrow turns the object about its own centre, wherever its origin is. What is in front follows the
/// cursor.
#[test]
fn with_shift_an_arrow_turns_the_object() {
    let (mut window, _folder) = wedge();
    let before = model(&window);
    let at = control(&window, "move along y").rect.center();
    window.send([Event::ModifiersChanged(Modifiers::SHIFT)]);
    drag(
        &mut window,
        PointerButton::Primary,
        at,
        at + egui::vec2(36.0, 0.0),
    );
    window.send([Event::ModifiersChanged(Modifiers::NONE)]);
    let turned = model(&window);
    let front = turned.matrix3 * DVec3::Z;
    // Half of the arrow's length: half a radian.
    assert!(
        (front.x - 0.5_f64.sin()).abs() < 0.03 && front.y.abs() < 1e-12,
        "{front}"
    );
    let middle = turned.transform_point3(MIDDLE_OF_WEDGE);
    assert!(middle.distance(MIDDLE_OF_WEDGE) < 1e-12, "{middle}");
    press_key(&mut window, CTRL, Key::Z);
    assert_eq!(model(&window), before, "one step");
}

/// A rotation and a scale that are typed leave the object's centre where it is.
#[test]
fn numbers_turn_it_about_its_own_centre() {
    let (mut window, _folder) = wedge();
    for (field, number) in [("rotation y", "90"), ("scale x", "3")] {
        type_into(&mut window, field, number);
        press_key(&mut window, Modifiers::NONE, Key::Enter);
        let middle = model(&window).transform_point3(MIDDLE_OF_WEDGE);
        assert!(
            middle.distance(MIDDLE_OF_WEDGE) < 1e-12,
            "{field}: {middle}"
        );
    }
    let long = model(&window).matrix3 * DVec3::X;
    assert!(long.distance(3.0 * DVec3::NEG_Z) < 1e-12, "{long}");
}
