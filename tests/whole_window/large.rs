//! While a large file is added or read again, the window answers, and the old picture stays until the new one is whole.

use super::*;
use egui::vec2;
use sightline::pick;

/// Cells along each side of a ground of 1,280,000 triangles. Its load takes longer than a few frames.
const SIDE: u32 = 800;
/// A point of the picture that shows no object.
const NOTHING: Pos2 = pos2(480.0, 80.0);

/// The middle of the scene's picture on screen.
fn middle(window: &Window) -> Vec<[u8; 3]> {
    let picture = window.drawn().expect("a picture");
    let inner = (200..520).flat_map(|y| (450..730).map(move |x| (x, y)));
    inner.map(|(x, y)| picture.at(x, y)).collect()
}

/// Draws frames with a moving mouse until a new scene is loaded and drawn, at one blow. Until then the old picture must
/// show. Returns how many frames showed it.
fn watch(window: &mut Window, old: &[[u8; 3]]) -> usize {
    let revision = window.state().scene_revision();
    let mut cursor = None;
    for i in 0..100_000_u32 {
        let at = NOTHING + vec2(f32::from((i % 2) as u8), 0.0);
        let anew = window.draw([Event::PointerMoved(at)]).expect("a frame");
        let moved = window.state().cursor().map(|cursor| cursor.px);
        assert!(moved.is_some() && moved != cursor, "the mouse is followed");
        cursor = moved;
        if window.state().scene_revision() != revision {
            assert!(anew);
            let new = middle(window);
            window.picture().expect("a picture");
            assert_eq!(
                changed(&new, old),
                changed(&middle(window), old),
                "it is whole"
            );
            return i as usize;
        }
        assert!(!anew);
        if i % 64 == 0 {
            assert!(middle(window) == old, "the old picture stays");
        }
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    panic!("it comes to an end");
}

/// Whether most pixels have changed.
fn changed(new: &[[u8; 3]], old: &[[u8; 3]]) -> bool {
    let changed = new.iter().zip(old).filter(|(a, b)| a != b);
    2 * changed.count() > old.len()
}

/// Fails unless the window went on while a load lasted.
fn check(window: &Window, frames: usize, objects: usize) {
    assert!(frames > 1, "{frames}");
    assert_eq!(window.state().scene().objects().len(), objects);
    assert_eq!(window.messages().count(), 0);
}

#[test]
fn what_is_large_is_added_beside_the_window() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = stalls::ground(folder.path(), SIDE);
    let (mut window, _row) = row(1.0);
    window.picture().expect("a picture");
    let old = middle(&window);
    window.send([Event::ModifiersChanged(Modifiers::SHIFT)]);
    window.begin_to_drop(path);
    let released = Event::ModifiersChanged(Modifiers::NONE);
    window.draw([released]).expect("a frame");
    let frames = watch(&mut window, &old);
    check(&window, frames, 4);
}

#[test]
fn what_is_large_is_read_again_beside_the_window() {
    let (mut window, _folder, path) = stalls::opened(SIDE);
    let old = middle(&window);
    // One more triangle, since an object that has not changed stays as it is.
    let text = std::fs::read_to_string(&path).expect("a file");
    std::fs::write(&path, text + &format!("f 1 2 {}\n", SIDE + 2)).expect("writable");
    window.draw([press(Key::R)]).expect("a frame");
    let frames = watch(&mut window, &old);
    check(&window, frames, 1);
}

#[test]
fn a_large_stage_is_shown() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = open(vec![stalls::many(folder.path(), stalls::MANY)], 1.0);
    press_key(&mut window, Modifiers::NONE, Key::P);
    window.picture().expect("a picture");
    for stage in ["view", "NDC", "picture"] {
        let before = window.drawn().expect("a picture");
        click_on(&mut window, &format!("show {stage}"));
        window.picture().expect("a picture");
        let picture = egui::Rect::from_center_size(MIDDLE, vec2(300.0, 300.0));
        let differ = differing_in(&before, &window.drawn().expect("a picture"), picture);
        assert!(differ > 3000, "{stage}: {differ}");
    }
}

/// What is seen is what is picked: until the new scene is drawn, a click on its place in the old picture picks nothing.
#[test]
fn what_is_not_drawn_yet_is_not_picked() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = stalls::ground(folder.path(), SIDE);
    let (mut window, _row) = row(1.0);
    window.picture().expect("a picture");
    window.begin_to_drop(path);
    for _ in 0..100_000 {
        if window.state().scene().objects().len() == 1 {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(2));
        window.send_undrawn([Event::PointerMoved(NOTHING)]);
    }
    let down_up = [true, false].map(|is| button(MIDDLE, PointerButton::Primary, is));
    window.send_undrawn(
        [Event::PointerMoved(MIDDLE)]
            .into_iter()
            .chain(down_up.clone()),
    );
    let state = window.state();
    assert_eq!(state.scene().objects().len(), 1, "it is there");
    assert_eq!(state.selection(), None);
    let cursor = state.cursor().expect("over the picture");
    let under_it = pick::pick(state.scene(), state.view(), cursor.px);
    assert!(under_it.is_some(), "the new scene has something there");
    window.picture().expect("a picture");
    window.send_undrawn(down_up);
    assert_eq!(window.state().selected(), Some(0));
}
