//! The mouse, the keys and dropped files do what they should, and nothing where they should do nothing.

use super::{
    CTRL, MIDDLE, Window, button, click, click_on, control, drag, open, picked_px, press_key, px,
    row, selected,
};
use egui::{Event, Key, Modifiers, MouseWheelUnit, PointerButton, pos2, vec2};
use glam::DVec2;
use sightline::{camera::Viewport, pick};

#[test]
fn a_click_picks_the_pixel_under_it_at_every_scale() {
    for scale in [1.0, 1.5, 2.0] {
        let (mut window, _folder) = row(scale);
        click(&mut window, MIDDLE);
        assert_eq!(selected(&window), Some("front"));
        let state = window.state();
        let at = picked_px(&window).expect("a pick");
        let size = state.view().viewport;
        let middle = DVec2::new(f64::from(size.width()), f64::from(size.height())) / 2.0;
        assert!(
            (at - middle).abs().max_element() < 4.0 * f64::from(scale),
            "{at}"
        );
        assert_eq!(
            state.picked().cloned(),
            pick::pick(state.scene(), state.view(), at)
        );
    }
}

#[test]
fn a_drag_turns_and_picks_nothing() {
    let (mut window, _folder) = row(1.0);
    let before = *window.state().view();
    drag(
        &mut window,
        PointerButton::Primary,
        MIDDLE,
        MIDDLE + vec2(60.0, 25.0),
    );
    let turned = *window.state().view();
    assert_eq!(selected(&window), None);
    let angle = before
        .camera
        .forward()
        .angle_between(turned.camera.forward());
    // A drag turns by 0.008 radians a pixel, counted from the press.
    let (yaw, pitch) = (60.0 * 0.008_f64, 25.0 * 0.008_f64);
    let expected = (yaw.cos() * pitch.cos()).acos();
    assert!((angle - expected).abs() < 1e-6, "{angle}");
    // The point under the cursor was the pivot: the front of the cube, 7.5 away.
    let pivot = glam::DVec3::new(0.0, 0.0, 2.5);
    let distance = |view: &sightline::camera::View| view.camera.eye().distance(pivot);
    assert!((distance(&before) - distance(&turned)).abs() < 0.05);
}

#[test]
fn a_press_on_a_panel_never_moves_the_camera() {
    let (mut window, _folder) = row(1.0);
    let before = *window.state().view();
    // A control of the list, one of the inspector, and one of the toolbar.
    for name in ["search", "position", "Views"] {
        let panel = control(&window, name).rect.center();
        drag(&mut window, PointerButton::Primary, panel, MIDDLE);
        drag(&mut window, PointerButton::Secondary, panel, MIDDLE);
        window.send([
            Event::PointerMoved(panel),
            wheel(vec2(0.0, 40.0), Modifiers::NONE),
        ]);
    }
    assert_eq!(*window.state().view(), before);
    assert_eq!(selected(&window), None);
    // The same drag from the scene moves the camera, so the test could fail.
    drag(
        &mut window,
        PointerButton::Primary,
        MIDDLE,
        MIDDLE + vec2(50.0, 0.0),
    );
    assert_ne!(*window.state().view(), before);
}

#[test]
fn a_click_again_goes_behind_and_a_fast_one_recentres() {
    let (mut window, _folder) = row(1.0);
    let mut seen = Vec::new();
    for _ in 0..4 {
        click(&mut window, MIDDLE);
        seen.extend(selected(&window).map(str::to_owned));
        window.wait_s(1.0);
    }
    assert_eq!(seen, ["front", "front", "middle", "middle"]);
    let before = *window.state().view();
    let up_and_down = [true, false, true, false];
    let off_centre = MIDDLE + vec2(30.0, 0.0);
    window.send([Event::PointerMoved(off_centre)]);
    window.send(up_and_down.map(|pressed| button(off_centre, PointerButton::Primary, pressed)));
    assert_ne!(window.state().view().camera.eye(), before.camera.eye());
}

#[test]
fn a_double_click_on_what_is_picked_keeps_it() {
    let (mut window, _folder) = row(1.0);
    click(&mut window, MIDDLE);
    window.wait_s(1.0);
    let twice = [true, false, true, false].map(|down| button(MIDDLE, PointerButton::Primary, down));
    window.send(twice);
    let hit = window.state().picked().expect("the cube");
    assert_eq!((hit.object.as_str(), hit.front), ("front", true));
}

/// The lines around the picture belong to panels. So does the margin that egui gives to the nearest widget.
#[test]
fn a_click_outside_the_picture_never_picks() {
    for scale in [1.0, 1.5] {
        let (mut window, _folder) = row(scale);
        click(&mut window, MIDDLE);
        let viewport = window.state().view().viewport;
        let half = DVec2::new(viewport.width().into(), viewport.height().into()) / 2.0;
        let step = 0.5 / scale;
        let (mut inside, mut outside) = (0, 0);
        // The left border comes last, because a drag can move it.
        for along in [
            vec2(1.0, 0.0),
            vec2(0.0, -1.0),
            vec2(0.0, 1.0),
            vec2(-1.0, 0.0),
        ] {
            #[expect(clippy::cast_possible_truncation, reason = "points are f32")]
            let to_edge = (half.x as f32 * along.x.abs() + half.y as f32 * along.y.abs()) / scale;
            for i in -16..=24_i8 {
                press_key(&mut window, Modifiers::NONE, Key::Escape);
                window.wait_s(1.0);
                let at = MIDDLE + along * (to_edge + f32::from(i) * step);
                click(&mut window, at);
                match window.state().hits() {
                    Some(hits) => {
                        assert!(
                            hits.view.viewport.contains(hits.px),
                            "{at} at {scale}: {}",
                            hits.px
                        );
                        inside += 1;
                    }
                    None => outside += 1,
                }
            }
        }
        assert!(
            inside > 20 && outside > 20,
            "{inside} inside, {outside} outside"
        );
    }
}

pub(super) fn wheel(by: egui::Vec2, modifiers: Modifiers) -> Event {
    Event::MouseWheel {
        unit: MouseWheelUnit::Point,
        source: egui::MouseWheelSource::Unknown,
        delta: by,
        phase: egui::TouchPhase::Move,
        modifiers,
    }
}

/// Distance from the eye to the front of the cube.
fn eye_to_front(window: &Window) -> f64 {
    window.state().view().camera.eye().z - 2.5
}

#[test]
fn a_trackpad_zooms_with_two_fingers_and_by_pinching_and_pans_with_shift() {
    let (mut window, _folder) = row(1.0);
    assert!((eye_to_front(&window) - 7.5).abs() < 1e-12);
    // Trackpads send many small steps. These add up to one line of a wheel.
    window.send([Event::PointerMoved(MIDDLE)]);
    window.send((0..25).map(|_| wheel(vec2(0.0, 2.0), Modifiers::NONE)));
    let near = eye_to_front(&window);
    assert!((near - 7.5 / 1.15).abs() < 1e-3, "{near}");
    window.send([Event::Zoom(1.5)]);
    assert!((eye_to_front(&window) - near / 1.5).abs() < 1e-3);
    // With Shift the surface follows the fingers, pixel for pixel.
    let state = window.state();
    let point = glam::DVec3::new(0.0, 0.0, 2.5);
    let before = state.view().project(point).expect("in front").px;
    window.send((0..10).map(|_| wheel(vec2(3.0, -2.0), Modifiers::SHIFT)));
    let after = window.state().view().project(point).expect("in front").px;
    assert!(
        (after - before - DVec2::new(30.0, -20.0)).length() < 0.1,
        "{before} to {after}"
    );
}

#[test]
fn tiny_windows_and_back() {
    let (mut window, _folder) = row(1.0);
    let before = *window.state().view();
    click(&mut window, MIDDLE);
    for tiny in [[1, 1], [40, 30], [560, 80], [3, 700]] {
        window.resize(Viewport::new(tiny[0], tiny[1]).expect("a viewport"));
        click(&mut window, pos2(1.0, 1.0));
        window.draw([]).expect("a frame");
    }
    window.resize(px(super::SIZE, 1.0));
    assert_eq!(window.state().view().camera, before.camera);
}

#[test]
fn a_bad_file_leaves_the_scene_and_a_message_that_stays() {
    let (mut window, folder) = row(1.0);
    click(&mut window, MIDDLE);
    let bad = folder.path().join("bad.obj");
    std::fs::write(&bad, "v 1 2 3\nf 1 2 9\n").expect("a writable folder");
    let before = *window.state().view();
    window.drop_file(bad.clone());
    window.drop_file(bad);
    window.wait_s(600.0);
    let messages: Vec<_> = window.messages().collect();
    assert_eq!(messages.len(), 1, "{messages:?}");
    assert!(messages[0].contains("bad.obj"), "{messages:?}");
    assert_eq!(window.state().name(), "row.toml");
    assert_eq!(window.state().scene().objects().len(), 3);
    assert_eq!(*window.state().view(), before);
    assert_eq!(selected(&window), Some("front"));
}

#[test]
fn messages_go_one_by_one_or_all_at_once() {
    let (mut window, folder) = row(1.0);
    for i in 0..8 {
        window.drop_file(folder.path().join(format!("absent {i}.obj")));
    }
    assert_eq!(window.messages().count(), 8);
    // This dismisses the first message shown, below the button for all. The three oldest messages are not shown.
    click_on(&mut window, "dismiss");
    let left: Vec<_> = window.messages().map(str::to_owned).collect();
    assert_eq!(left.len(), 7);
    assert!(
        !left.iter().any(|text| text.contains("absent 3")),
        "{left:?}"
    );
    click_on(&mut window, "Dismiss all (2 earlier)");
    assert_eq!(window.messages().count(), 0);
    assert_eq!(selected(&window), None, "the clicks were not the scene's");
}

#[test]
fn keys_act_and_typing_does_not() {
    let (mut window, _folder) = row(1.0);
    let none = Modifiers::NONE;
    press_key(&mut window, none, Key::C);
    let command = window.copied().expect("a command").to_owned();
    assert!(command.starts_with("sightline pick "), "{command}");
    assert!(command.contains("--eye 0,0,10"), "{command}");
    press_key(&mut window, none, Key::Num3);
    assert!(window.state().view().camera.forward().x < -0.999);
    press_key(&mut window, CTRL, Key::Num3);
    assert!(window.state().view().camera.forward().x > 0.999);
    press_key(&mut window, none, Key::T);
    assert!(window.state().frozen().is_some());
    // Keys typed into the search field go there.
    let view = *window.state().view();
    click_on(&mut window, "search");
    press_key(&mut window, none, Key::Num7);
    window.send([Event::Text("7".into())]);
    assert_eq!(*window.state().view(), view);
    press_key(&mut window, Modifiers::SHIFT, Key::H);
    assert!(!window.title().starts_with('\u{2022}'), "nothing is hidden");
    // Ctrl+Q is no text. There are no edits, so nothing is asked.
    press_key(&mut window, CTRL, Key::Q);
    assert!(window.has_quit());
}

/// The panel with the matrices covers nothing of the picture, and does not move while it follows the cursor.
#[test]
fn the_pipeline_follows_the_cursor_and_stays_still() {
    let mut window = open(Vec::new(), 1.0);
    let followed = |window: &mut Window| {
        let mut seen = 0;
        for y in (100..690_u16).step_by(10) {
            window.send([Event::PointerMoved(pos2(640.0, f32::from(y)))]);
            assert!(window.is_at_rest(), "at {y}");
            seen += usize::from(window.state().cursor().is_some());
        }
        seen
    };
    let without = followed(&mut window);
    press_key(&mut window, Modifiers::NONE, Key::P);
    assert_eq!(followed(&mut window), without);
    assert_eq!(without, 59);
}

#[test]
fn without_files_it_is_the_demo() {
    let window = open(Vec::new(), 1.0);
    assert!(window.state().scene().objects().len() > 3);
    assert_eq!(window.messages().count(), 0);
}
