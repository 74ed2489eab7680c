//! Edits wait while a load runs, unless it only follows a file that has changed.
#![expect(clippy::float_cmp, reason = "numbers as they were typed")]

use super::{
    nothing_lost::{edit, is_asked, is_marked, shown},
    *,
};
use glam::DVec3;
use std::{fs, io::Write as _, thread, time::Duration};

/// Cells along each side of a ground whose load takes longer than a few frames of a small window.
const SIDE: u32 = 700;
/// The size of a window whose frames take far less time than that load.
const SMALL: [u32; 2] = [320, 200];

fn redo() -> Event {
    key_event(CTRL, Key::Y, true)
}

fn is_told_to_wait(window: &Window) -> bool {
    let mut messages = window.messages();
    messages.any(|text| text == "files are being loaded: Esc cancels that")
}

/// What is on show may be replaced, so its edits wait. Camera, picks and panels go on.
#[test]
fn edits_wait_while_files_load() {
    let (mut window, folder) = row(1.0);
    let path = stalls::ground(folder.path(), SIDE);
    edit(&mut window);
    press_key(&mut window, CTRL, Key::Z);
    window.picture().expect("a picture");
    window.begin_to_drop(path);
    let eye = window.state().view().camera.eye();
    window.draw([redo(), press(Key::Num7)]).expect("a frame");
    assert_eq!(window.state().name(), "row.toml", "the other still loads");
    assert_eq!(shown(&window), [true; 3]);
    assert!(is_told_to_wait(&window) && !is_marked(&window));
    assert_ne!(window.state().view().camera.eye(), eye, "the camera lives");
    window.send([]);
    assert_eq!(window.state().name(), "ground.obj", "nothing is asked");
}

/// Files that are added replace nothing, and other files that are opened end the load.
#[test]
fn the_files_that_were_opened_last_are_shown() {
    let (mut window, folder) = row(1.0);
    let path = stalls::ground(folder.path(), SIDE);
    window.picture().expect("a picture");
    window.begin_to_drop(path);
    assert_eq!(window.state().name(), "row.toml");
    let other = folder.path().join("other.toml");
    fs::write(&other, ROW).expect("writable");
    window.drop_file(other);
    assert_eq!(window.state().name(), "other.toml");
    window.send([]);
    assert_eq!(window.state().name(), "other.toml");
}

fn place(window: &Window) -> DVec3 {
    let object = &window.state().scene().objects()[0];
    object.placement.model().translation
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
fn moves_wait_while_the_files_are_read_again() {
    let (mut window, _folder) = large_with_a_move();
    window.draw([press(Key::R)]).expect("a frame");
    window.draw([redo()]).expect("a frame");
    assert!(has_control(&window, "Cancel"), "it is still read");
    assert!(is_told_to_wait(&window));
    assert_eq!(place(&window).x, 0.0);
    window.send([]);
    assert_eq!(place(&window).x, 0.0);
    // A move that is there before is asked about.
    press_key(&mut window, CTRL, Key::Y);
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
    let (mut window, _folder, path) = stalls::opened(SIDE);
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
    window.draw([redo()]).expect("a frame");
    assert!(has_control(&window, "Cancel"), "it is still read");
    window.send([]);
    assert_eq!(place(&window).x, 1.5);
    assert!(!is_asked(&window) && is_marked(&window));
    let told = |text: &str| text.contains("has changed on the disk");
    assert!(window.messages().any(told));
}

/// Undo of added files while the first one is read again leads to other files than are being read.
#[test]
fn files_that_are_taken_back_while_another_is_read_stay_away() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = stalls::ground(folder.path(), SIDE);
    let other = folder.path().join("other.toml");
    fs::write(&other, ROW).expect("writable");
    let mut window = open(vec![path.clone()], 1.0);
    window.picture().expect("a picture");
    window.send([Event::ModifiersChanged(Modifiers::SHIFT)]);
    window.drop_file(other);
    window.send([Event::ModifiersChanged(Modifiers::NONE)]);
    assert_eq!(shown(&window).len(), 4);
    let text = fs::read_to_string(&path).expect("a file");
    fs::write(&path, text + "# changed\n").expect("writable");
    wait_for_load(&mut window);
    window
        .draw([key_event(CTRL, Key::Z, true)])
        .expect("a frame");
    assert!(has_control(&window, "Cancel"), "it is still read");
    assert_eq!(shown(&window).len(), 1);
    window.send([]);
    assert_eq!(shown(&window).len(), 1);
}

/// A section that is pasted is an edit: the scene that it is for may be replaced.
#[test]
fn a_pasted_section_waits_while_files_load() {
    let (mut window, folder) = row(1.0);
    let path = stalls::ground(folder.path(), SIDE);
    press_key(&mut window, Modifiers::NONE, Key::Z);
    press_key(&mut window, Modifiers::SHIFT, Key::C);
    let camera = window.copied().expect("a camera").to_owned();
    press_key(&mut window, Modifiers::NONE, Key::Z);
    window.picture().expect("a picture");
    window.begin_to_drop(path);
    window.draw([Event::Paste(camera)]).expect("a frame");
    assert_eq!(window.state().name(), "row.toml", "the other still loads");
    assert_eq!(window.state().view().section, None);
    assert!(is_told_to_wait(&window));
}

#[test]
fn a_change_is_not_read_again_once_that_was_cancelled() {
    let (mut window, _folder, path) = stalls::opened(SIDE);
    let before = window.state().scene().triangle_count();
    let text = fs::read_to_string(&path).expect("a file");
    fs::write(&path, text + "f 1 2 45\n").expect("writable");
    wait_for_load(&mut window);
    window.draw([press(Key::Escape)]).expect("a frame");
    window.send([]);
    assert_eq!(window.state().scene().triangle_count(), before);
}
