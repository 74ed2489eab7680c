//! The files of the open scene are watched, also while the user is in the gallery and during a load.

use super::{
    nothing_lost::{edit, is_marked, shown},
    remembering::wait_until,
    *,
};
use std::{fs, io::Write, path::Path, thread, time::Duration};

/// Four objects, one more than [`ROW`] has.
fn more() -> String {
    format!("{ROW}\n[[object]]\nname = \"new\"\nshape = \"sphere\"\n")
}

fn count(window: &Window) -> usize {
    window.state().scene().objects().len()
}

fn leave_the_gallery(window: &mut Window) {
    click_on(window, "Learn");
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
    thread::sleep(Duration::from_millis(1300));
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

/// A file that is written again as it was, read by itself or by R, leaves history, selection and messages alone.
#[test]
fn a_file_that_is_only_touched_changes_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("two.obj");
    let text =
        "o a\nv -1 -1 0\nv 4 -1 0\nv 0 1 0\nf 1 2 3\no b\nv 3 0 0\nv 4 0 0\nv 3 1 0\nf 4 5 6\n";
    fs::write(&path, text).expect("writable");
    let mut window = open(vec![path.clone()], 1.0);
    press_key(&mut window, Modifiers::NONE, Key::Num7);
    press_key(&mut window, Modifiers::NONE, Key::Num1);
    press_key(&mut window, Modifiers::NONE, Key::ArrowDown);
    press_key(&mut window, Modifiers::SHIFT, Key::H);
    press_key(&mut window, Modifiers::NONE, Key::ArrowDown);
    let before = (*window.state().view(), window.state().selection().cloned());
    let revision = window.state().scene_revision();
    for by_itself in [true, false] {
        let beside = folder.path().join("beside");
        fs::write(&beside, text).expect("writable");
        fs::rename(&beside, &path).expect("writable");
        if by_itself {
            thread::sleep(Duration::from_millis(1300));
            window.send([]);
        } else {
            press_key(&mut window, Modifiers::NONE, Key::R);
        }
        assert_eq!(
            window.state().next_step(true),
            Some("hide and show"),
            "{by_itself}"
        );
        assert_eq!(window.messages().count(), 0);
        assert_eq!(
            window.state().scene_revision(),
            revision,
            "it is not drawn anew"
        );
        let now = (*window.state().view(), window.state().selection().cloned());
        assert!(now == before && is_marked(&window));
    }
    // The file's numbers are read from the file as it is now.
    press_key(&mut window, CTRL, Key::Z);
    assert_eq!(shown(&window), [true; 2]);
    click(&mut window, MIDDLE);
    let picked = window.state().picked().expect("a hit");
    assert_eq!(
        (picked.in_file.face, picked.in_file.file_error.as_deref()),
        (Some(1), None)
    );
    for _ in 0..2 {
        press_key(&mut window, CTRL, Key::Z);
    }
    assert_eq!(window.state().next_step(true), None);
    // A change is still seen.
    fs::write(&path, text.replace("o b", "o c")).expect("writable");
    wait_until(&mut window, |window| {
        window.state().scene().objects()[1].name == "c"
    });
}

/// Where the objects differ, what is hidden stays so by its name, and the history ends.
#[test]
fn what_is_hidden_stays_so_while_its_file_changes() {
    let (mut window, folder) = row(1.0);
    let path = folder.path().join("row.toml");
    fs::write(&path, more()).expect("writable");
    press_key(&mut window, Modifiers::NONE, Key::R);
    assert_eq!(count(&window), 4);
    for _ in 0..4 {
        press_key(&mut window, Modifiers::NONE, Key::ArrowDown);
    }
    assert_eq!(selected(&window), Some("new"));
    press_key(&mut window, Modifiers::SHIFT, Key::H);
    assert!(is_marked(&window));
    fs::write(&path, ROW).expect("writable");
    wait_until(&mut window, |window| count(window) == 3);
    assert!(!is_marked(&window), "what was hidden is gone");
    assert_eq!(window.state().next_step(true), None);

    edit(&mut window);
    fs::write(&path, more()).expect("writable");
    wait_until(&mut window, |window| count(window) == 4);
    assert!(is_marked(&window));
    assert_eq!(shown(&window), [false, true, true, true]);
    press_key(&mut window, CTRL, Key::Z);
    assert_eq!(shown(&window), [false, true, true, true]);
    press_key(&mut window, Modifiers::NONE, Key::U);
    assert!(!is_marked(&window), "as the file shows it");
}

/// The message names what has changed. A warning that the user has closed does not come back.
#[test]
fn only_what_changed_is_named_and_closed_warnings_stay_closed() {
    let folder = tempfile::tempdir().expect("a folder");
    let files = ["a.obj", "b.obj"].map(|name| folder.path().join(name));
    let triangle = |x: u8| format!("v 0 0 0\nv {x} 0 0\nv 0 1 0\nf 1 2 3\n");
    let warned = format!("mtllib none.mtl\n{}", triangle(3));
    fs::write(&files[0], triangle(1)).expect("writable");
    fs::write(&files[1], &warned).expect("writable");
    let mut window = open(files.to_vec(), 1.0);
    let says = |window: &Window, words: &str| window.messages().any(|text| text.contains(words));
    assert!(says(&window, "none.mtl"));
    // The warning is still open: reading again neither closes it nor repeats it.
    fs::write(&files[0], triangle(12)).expect("writable");
    let read = "a.obj has changed and was read again";
    wait_until(&mut window, |window| says(window, read));
    let count = window
        .messages()
        .filter(|text| text.contains("none.mtl"))
        .count();
    assert_eq!(count, 1);
    window.wait_s(5.0);
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(window.messages().count(), 0);
    fs::write(&files[0], triangle(123)).expect("writable");
    wait_until(&mut window, |window| says(window, read));
    assert!(!says(&window, "none.mtl"));
    for file in &files {
        fs::write(file, format!("{warned}\n# longer\nv 9 9 9\nf 1 2 4\n")).expect("writable");
    }
    wait_until(&mut window, |window| {
        says(window, "a.obj and 1 more have changed and were read again")
    });
}

/// A file that another program takes away is told of, once. What is on screen stays, and can be saved. A file that is
/// back is read.
#[test]
fn a_file_that_is_gone_is_told_of_and_read_once_it_is_back() {
    let (mut window, folder) = row(1.0);
    let path = folder.path().join("row.toml");
    let gone = "row.toml is gone from the disk. What is on screen stays: Ctrl+S saves it";
    let says = |window: &Window, words: &str| window.messages().any(|text| text == words);
    // Away for a moment, as while a program writes it anew.
    fs::remove_file(&path).expect("it is there");
    thread::sleep(Duration::from_millis(600));
    fs::write(&path, more()).expect("writable");
    wait_until(&mut window, |window| count(window) == 4);
    assert!(!says(&window, gone));
    fs::remove_file(&path).expect("it is there");
    wait_until(&mut window, |window| says(window, gone));
    assert_eq!(count(&window), 4);
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    window.wait_s(1.0);
    assert!(!says(&window, gone), "it is told once");
    press_key(&mut window, CTRL, Key::S);
    window.save_as(path.clone());
    assert!(path.is_file() && !is_marked(&window));
    fs::write(&path, ROW).expect("writable");
    wait_until(&mut window, |window| count(window) == 3);
}

/// Also where the file is as it was, and where edits keep it from being read.
#[test]
fn a_file_that_is_back_is_no_longer_said_to_be_gone() {
    for is_edited in [false, true] {
        let (mut window, folder) = row(1.0);
        let [path, aside] = ["row.toml", "aside"].map(|name| folder.path().join(name));
        if is_edited {
            edit(&mut window);
        }
        let is_said = |window: &Window| {
            let mut messages = window.messages();
            messages.any(|text| text.contains("is gone from the disk"))
        };
        fs::rename(&path, &aside).expect("it is there");
        wait_until(&mut window, is_said);
        fs::rename(&aside, &path).expect("it is there");
        wait_until(&mut window, |window| !is_said(window));
    }
}

/// A scene that is saved belongs to its new file, which others may change too.
#[test]
fn a_file_that_was_saved_is_watched() {
    let (mut window, folder) = row(1.0);
    let kept = folder.path().join("kept.toml");
    window.save_as(kept.clone());
    fs::write(&kept, more()).expect("writable");
    wait_until(&mut window, |window| count(window) == 4);
    assert_eq!(window.state().name(), "kept.toml");
}

/// A window whose file was changed to what is no scene, which is said, and the file.
fn of_a_broken_file() -> (Window, TempDir, PathBuf) {
    let (mut window, folder) = row(1.0);
    let path = folder.path().join("row.toml");
    fs::write(&path, "[[object]").expect("writable");
    wait_until(&mut window, |window| window.messages().count() == 1);
    (window, folder, path)
}

#[test]
fn why_a_change_was_not_read_is_said_until_the_file_is_whole_again() {
    let (mut window, _folder, path) = of_a_broken_file();
    fs::write(&path, ROW).expect("writable");
    wait_until(&mut window, |window| window.messages().count() == 0);
}

/// A save over a file that could not be read makes it whole.
#[test]
fn a_save_mends_a_file_that_could_not_be_read() {
    let (mut window, _folder, path) = of_a_broken_file();
    window.save_as(path.clone());
    let told: Vec<_> = window.messages().collect();
    assert_eq!(told, [format!("saved {}", path.display())]);
}

/// What was said about a scene of the gallery is not about the one that comes back.
#[test]
fn messages_of_the_gallery_stay_there() {
    let (mut window, folder) = row(1.0);
    press_key(&mut window, Modifiers::NONE, Key::E);
    window.drop_file(folder.path().join("missing.toml"));
    assert_eq!(window.messages().count(), 1);
    leave_the_gallery(&mut window);
    assert_eq!(window.messages().count(), 0);
}

/// The demo is in no file, so objects that were added to it are gone once it is read again, and are no edit any more.
#[test]
fn the_demo_that_is_read_again_has_no_edits() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("row.toml");
    fs::write(&path, ROW).expect("writable");
    let mut window = open(Vec::new(), 1.0);
    let demo = count(&window);
    window.send([Event::ModifiersChanged(Modifiers::SHIFT)]);
    window.drop_file(path.clone());
    window.send([Event::ModifiersChanged(Modifiers::NONE)]);
    assert_eq!(count(&window), demo + 3);
    assert!(is_marked(&window));
    press_key(&mut window, Modifiers::NONE, Key::R);
    click_on(&mut window, "Reload, drop the edits");
    assert_eq!(count(&window), demo);
    assert!(!is_marked(&window));
}

/// The window of `work/current/row.toml`, where `current` is `into`: a folder, or a link to one.
fn in_folders(link: bool) -> (Window, TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    let [work, first] = ["work", "work/first"].map(|name| folder.path().join(name));
    let current = work.join("current");
    fs::create_dir_all(if link { &first } else { &current }).expect("writable");
    #[cfg(unix)]
    if link {
        std::os::unix::fs::symlink("first", &current).expect("a link");
    }
    let path = current.join("row.toml");
    fs::write(&path, ROW).expect("writable");
    (open(vec![path.clone()], 1.0), folder, path)
}

/// A folder that is wiped is said to be gone until it is there again, however long that takes. Then its file is
/// followed.
#[test]
fn a_folder_that_goes_and_comes_is_followed() {
    let (mut window, folder, path) = in_folders(false);
    fs::remove_dir_all(folder.path().join("work")).expect("writable");
    let is_told = |window: &Window| {
        window
            .messages()
            .any(|text| text.contains("row.toml is gone from the disk"))
    };
    wait_until(&mut window, is_told);
    thread::sleep(Duration::from_secs(2));
    window.send([Event::PointerMoved(MIDDLE)]);
    assert!(is_told(&window) && count(&window) == 3);
    fs::create_dir_all(path.parent().expect("a folder")).expect("writable");
    fs::write(&path, more()).expect("writable");
    wait_until(&mut window, |window| count(window) == 4);
    assert!(!is_told(&window));
    fs::write(&path, ROW).expect("writable");
    wait_until(&mut window, |window| count(window) == 3);
}

/// A folder above the file is renamed, and another one takes its place.
#[test]
fn a_renamed_folder_is_followed_by_its_name() {
    let (mut window, folder, path) = in_folders(false);
    let [work, old, new] = ["work", "old", "new"].map(|name| folder.path().join(name));
    fs::create_dir_all(new.join("current")).expect("writable");
    fs::write(new.join("current/row.toml"), more()).expect("writable");
    fs::rename(&work, &old).expect("writable");
    fs::rename(&new, &work).expect("writable");
    wait_until(&mut window, |window| count(window) == 4);
    fs::write(&path, ROW).expect("writable");
    wait_until(&mut window, |window| count(window) == 3);
}

#[cfg(unix)]
#[test]
fn what_links_lead_to_is_followed() {
    let (mut window, folder, path) = in_folders(true);
    let work = folder.path().join("work");
    // The file behind the link to its folder.
    fs::write(work.join("first/row.toml"), more()).expect("writable");
    wait_until(&mut window, |window| count(window) == 4);
    // The link leads to another folder.
    let relink = |to: &str, link: &Path| {
        std::os::unix::fs::symlink(to, work.join("next")).expect("a link");
        fs::rename(work.join("next"), link).expect("writable");
    };
    fs::create_dir(work.join("second")).expect("writable");
    fs::write(work.join("second/row.toml"), ROW).expect("writable");
    relink("second", &work.join("current"));
    wait_until(&mut window, |window| count(window) == 3);
    // The file itself becomes a link, and what it leads to is replaced as editors do.
    fs::write(work.join("far.toml"), more()).expect("writable");
    relink("../far.toml", &path);
    wait_until(&mut window, |window| count(window) == 4);
    fs::write(work.join("far.toml~"), ROW).expect("writable");
    fs::rename(work.join("far.toml~"), work.join("far.toml")).expect("writable");
    wait_until(&mut window, |window| count(window) == 3);
}

/// What is shown follows a file that is written for a while, and no half of it stays.
#[test]
fn a_file_that_grows_is_read_once_it_is_whole() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("grows.obj");
    let vertices = "v -1 -1 0\nv 4 -1 0\nv 0 1 0\n";
    fs::write(&path, format!("{vertices}f 1 2 3\n")).expect("writable");
    let mut window = open(vec![path.clone()], 1.0);
    let mut file = fs::File::create(&path).expect("writable");
    let triangles = |window: &Window| window.state().scene().triangle_count();
    writeln!(file, "{vertices}").expect("writable");
    for _ in 0..30 {
        writeln!(file, "f 1 2 3").expect("writable");
        thread::sleep(Duration::from_millis(100));
        window.send([]);
        assert!(triangles(&window) <= 1, "while it grows");
    }
    wait_until(&mut window, |window| triangles(window) == 30);
    let told: Vec<_> = window.messages().collect();
    assert_eq!(told, ["grows.obj has changed and was read again"]);
}
