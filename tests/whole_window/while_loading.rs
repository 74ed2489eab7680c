//! What is edited while a load runs is asked about before the loaded scene takes its place.
#![expect(clippy::float_cmp, reason = "numbers as they were typed")]

use super::{
    nothing_lost::{edit, is_asked, is_marked, shown},
    *,
};
use glam::DVec3;
use sightline::scene::{self, Progress};
use std::{fs, io::Write as _, thread, time::Duration};

/// Cells along each side of a ground whose load takes longer than a few frames of a small window.
const SIDE: u32 = 700;
/// The size of a window whose frames take far less time than that load.
const SMALL: [u32; 2] = [320, 200];

fn redo() -> Event {
    key_event(CTRL, Key::Y, true)
}

/// A window that asks about a row of objects: while a large file was loading, the front one was hidden.
fn edited_while_another_loads() -> (Window, TempDir) {
    let (mut window, folder) = row(1.0);
    let path = stalls::ground(folder.path(), SIDE);
    edit(&mut window);
    press_key(&mut window, CTRL, Key::Z);
    window.picture().expect("a picture");
    assert!(!is_marked(&window));
    window.begin_to_drop(path);
    assert!(!is_asked(&window), "nothing is edited yet");
    window.draw([redo()]).expect("a frame");
    assert_eq!(window.state().name(), "row.toml", "the other still loads");
    assert_eq!(shown(&window), [false, true, true]);
    window.send([]);
    assert!(is_asked(&window));
    assert_eq!(window.state().name(), "row.toml");
    (window, folder)
}

#[test]
fn edits_during_a_load_stay_if_the_user_says_so() {
    let (mut window, _folder) = edited_while_another_loads();
    click_on(&mut window, "Cancel");
    window.send([]);
    assert!(!is_asked(&window) && is_marked(&window));
    assert_eq!(window.state().name(), "row.toml");
    press_key(&mut window, CTRL, Key::Z);
    assert_eq!(shown(&window), [true; 3]);
}

#[test]
fn edits_during_a_load_go_only_if_the_user_says_so() {
    let (mut window, _folder) = edited_while_another_loads();
    click_on(&mut window, "Open, drop the edits");
    assert_eq!(window.state().name(), "ground.obj");
    assert!(!is_asked(&window) && !is_marked(&window));
}

#[test]
fn what_was_loaded_meanwhile_can_be_added() {
    let (mut window, _folder) = edited_while_another_loads();
    click_on(&mut window, "Add to the scene");
    assert_eq!(window.state().name(), "row.toml");
    assert_eq!(shown(&window), [false, true, true, true]);
}

#[test]
fn edits_during_a_load_can_be_saved_first() {
    let (mut window, folder) = edited_while_another_loads();
    click_on(&mut window, "Save first\u{2026}");
    assert_eq!(window.state().name(), "row.toml", "it is not saved yet");
    let kept = folder.path().join("kept.toml");
    window.save_as(kept.clone());
    assert_eq!(window.state().name(), "ground.obj");
    let kept = scene::load(&[kept], &Progress::default()).expect("a scene");
    assert!(!kept.scene.objects()[0].visible);
}

fn place(window: &Window) -> DVec3 {
    let object = &window.state().scene().objects()[0];
    object.placement.model().translation
}

/// Redoes the move, in a frame that shows that a load is under way.
#[track_caller]
fn redo_during_load(window: &mut Window) {
    window.draw([redo()]).expect("a frame");
    assert!(has_control(window, "Cancel"), "it is still read");
    assert_eq!(place(window).x, 1.5);
}

/// A small window that shows a large file. Redo moves its object to x = 1.5.
fn large_with_a_move() -> (Window, TempDir) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = stalls::ground(folder.path(), SIDE);
    let mut window = open(vec![path], 1.0);
    click(&mut window, MIDDLE);
    click_on(&mut window, "Placement");
    type_into(&mut window, "position x", "1.5");
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    assert_eq!(place(&window).x, 1.5);
    press_key(&mut window, CTRL, Key::Z);
    assert!(!is_marked(&window));
    window.resize(px(SMALL, 1.0));
    window.picture().expect("a picture");
    (window, folder)
}

#[test]
fn moves_while_the_files_are_read_again_are_asked_about() {
    let (mut window, _folder) = large_with_a_move();
    window.draw([press(Key::R)]).expect("a frame");
    assert!(!is_asked(&window));
    redo_during_load(&mut window);
    window.send([]);
    assert!(is_asked(&window));
    click_on(&mut window, "Cancel");
    assert_eq!(place(&window).x, 1.5);
    press_key(&mut window, Modifiers::NONE, Key::R);
    click_on(&mut window, "Reload, drop the edits");
    assert_eq!(place(&window).x, 0.0);
}

/// Draws frames until a changed file is being read again.
fn wait_for_load(window: &mut Window) {
    for _ in 0..500 {
        window.draw([Event::PointerGone]).expect("a frame");
        if has_control(window, "Cancel") {
            return;
        }
        thread::sleep(Duration::from_millis(10));
    }
    panic!("it is read again");
}

/// What was read before the change is not shown: its last line may be cut inside a number. Once the file is complete,
/// it is read. No error is shown meanwhile.
#[test]
fn a_file_that_changes_while_it_is_read_again_is_read_once_more() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = stalls::ground(folder.path(), SIDE);
    let mut window = open(vec![path.clone()], 1.0);
    window.picture().expect("a picture");
    let triangles = |window: &Window| window.state().scene().triangle_count();
    let before = triangles(&window);
    let append = |text: &[u8]| {
        let mut options = fs::OpenOptions::new();
        let mut file = options.append(true).open(&path).expect("a file");
        file.write_all(text).expect("writable");
    };
    append(b"# changed\n");
    wait_for_load(&mut window);
    append(b"f 1 2 45");
    for _ in 0..3000 {
        window.draw([Event::PointerGone]).expect("a frame");
        let told: Vec<_> = window.messages().collect();
        let expected = "ground.obj has changed and was read again";
        assert!(told.iter().all(|told| *told == expected), "{told:?}");
        if triangles(&window) != before {
            break;
        }
        thread::sleep(Duration::from_millis(20));
    }
    assert_eq!(triangles(&window), before + 1);
}

#[test]
fn moves_while_a_changed_file_is_read_are_kept() {
    let (mut window, folder) = large_with_a_move();
    let path = folder.path().join("ground.obj");
    let text = fs::read_to_string(&path).expect("a file");
    fs::write(&path, text + "# changed\n").expect("writable");
    wait_for_load(&mut window);
    redo_during_load(&mut window);
    window.send([]);
    assert_eq!(place(&window).x, 1.5);
    assert!(!is_asked(&window) && is_marked(&window));
    let told = |text: &str| text.contains("has changed on the disk");
    assert!(window.messages().any(told));
}
