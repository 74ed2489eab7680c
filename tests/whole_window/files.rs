//! After files are opened, flags given or a scene saved, the window shows the right scene under the right name.

use super::*;
use glam::DVec3;
use sightline::{
    camera::{CameraChoice, UpAxis},
    viewer::model::HideAndShow,
};

fn opened(options: Options) -> Window {
    Window::open(options, px(SIZE, 1.0), 1.0)
}

fn row_file() -> (PathBuf, TempDir) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("row.toml");
    std::fs::write(&path, ROW).expect("a writable folder");
    (path, folder)
}

fn key(window: &mut Window, key: Key) {
    press_key(window, Modifiers::NONE, key);
}

#[test]
fn a_first_file_that_could_not_be_read_is_read_again() {
    let (path, folder) = row_file();
    std::fs::remove_file(&path).expect("it was there");
    let mut window = open(vec![path.clone()], 1.0);
    assert_eq!(window.messages().count(), 1);
    std::fs::write(&path, ROW).expect("a writable folder");
    key(&mut window, Key::R);
    assert_eq!(window.state().name(), "row.toml");
    let eye = window.state().view().camera.eye();
    assert_eq!(eye, DVec3::new(0.0, 0.0, 10.0), "its own camera");
    assert_eq!(window.messages().count(), 0);
    drop(folder);
}

#[test]
fn a_flag_that_cannot_be_is_said_and_not_used() {
    let (path, folder) = row_file();
    let camera = CameraChoice {
        near: Some(10.0),
        far: Some(5.0),
        ..CameraChoice::default()
    };
    let mut window = opened(Options {
        paths: vec![path.clone()],
        camera,
        visibility: HideAndShow {
            hide: vec![9],
            ..HideAndShow::default()
        },
        ..Options::default()
    });
    let has = |window: &Window, word: &str| window.messages().any(|text| text.contains(word));
    assert_eq!(window.state().name(), "row.toml");
    assert!(has(&window, "--hide") && has(&window, "near"));
    assert_eq!(window.messages().count(), 2);
    // The flags apply only to the first scene.
    let next = folder.path().join("next.toml");
    std::fs::copy(&path, &next).expect("a writable folder");
    window.drop_file(next);
    assert_eq!(window.state().name(), "next.toml");
    assert_eq!(window.messages().count(), 0);
    // If the file's camera is impossible, the message names the file.
    let bad = folder.path().join("bad.toml");
    std::fs::write(&bad, ROW.replace("[camera]", "[camera]\nfov = 200")).expect("writable");
    window.drop_file(bad);
    assert_eq!(window.state().name(), "next.toml");
    assert!(has(&window, "bad.toml") && has(&window, "field of view"));
}

/// Each file opens with the up axis that it names, or else y.
#[test]
fn the_up_axis_of_one_file_is_not_the_next_one_s() {
    let (path, folder) = row_file();
    let mut window = open(vec![path], 1.0);
    click_on(&mut window, "z points up");
    assert_eq!(window.state().up_axis(), UpAxis::Z);
    let next = folder.path().join("next.toml");
    std::fs::write(&next, ROW).expect("a writable folder");
    window.drop_file(next);
    assert_eq!(window.state().name(), "next.toml");
    assert_eq!(window.state().up_axis(), UpAxis::Y);
}

#[test]
fn the_command_is_about_the_camera_whatever_shows() {
    let (path, _folder) = row_file();
    let mut window = opened(Options {
        paths: vec![path],
        camera: CameraChoice {
            up_axis: Some(UpAxis::Z),
            ..CameraChoice::default()
        },
        ..Options::default()
    });
    let command = |window: &mut Window| {
        key(window, Key::C);
        window.copied().expect("a command").to_owned()
    };
    key(&mut window, Key::P);
    let in_world = command(&mut window);
    for stage in Stage::ALL {
        click_on(&mut window, &format!("show {}", stage.1));
        assert_eq!(window.state().views(), Views::One(stage.0));
        assert_eq!(command(&mut window), in_world);
        // A drag in this view turns this view alone.
        drag(
            &mut window,
            PointerButton::Primary,
            MIDDLE,
            MIDDLE + egui::vec2(80.0, 9.0),
        );
        assert_eq!(command(&mut window), in_world);
    }
}

#[test]
fn what_is_saved_is_what_is_open_from_then_on() {
    let (mut window, folder) = row(1.0);
    press_key(&mut window, Modifiers::SHIFT, Key::H);
    window.save_as(folder.path().join("kept"));
    let kept = folder.path().join("kept.toml");
    assert!(kept.exists() && !folder.path().join("kept").exists());
    assert_eq!(window.state().name(), "kept.toml");
    key(&mut window, Key::R);
    assert_eq!(window.state().name(), "kept.toml");
    assert_eq!(window.messages().count(), 0, "it was read");
    // Leaving the gallery comes back to it.
    std::fs::remove_file(folder.path().join("row.toml")).expect("it was there");
    key(&mut window, Key::E);
    assert!(window.state().showing().is_some());
    click_on(&mut window, "Learn");
    click_on(&mut window, "leave the gallery");
    assert_eq!(window.state().name(), "kept.toml");
    // A name that Sightline completed is not the user's choice, so a file of that name is not overwritten.
    let before = std::fs::read(&kept).expect("a file");
    key(&mut window, Key::Num7);
    window.save_as(folder.path().join("kept"));
    assert!(window.messages().any(|text| text.contains("kept.toml")));
    assert_eq!(std::fs::read(&kept).expect("a file"), before);
    window.save_as(kept.clone());
    assert_ne!(std::fs::read(&kept).expect("a file"), before);
}

fn told(window: &Window) -> Vec<&str> {
    window.messages().collect()
}

/// An error stays until Esc or the cross closes it, the latest first, or until the same is done with success.
#[test]
fn a_red_message_goes_by_esc_or_by_the_next_success() {
    let (mut window, folder) = row(1.0);
    let gone = folder.path().join("gone.obj");
    window.drop_file(gone.clone());
    key(&mut window, Key::J);
    assert_eq!(told(&window).len(), 2);
    assert!(told(&window)[1].contains("no pick to copy"));
    click(&mut window, MIDDLE);
    key(&mut window, Key::Escape);
    assert_eq!(told(&window).len(), 1, "the latest one");
    assert!(told(&window)[0].contains("gone.obj"));
    assert_eq!(selected(&window), Some("front"), "one thing at a time");
    key(&mut window, Key::Escape);
    assert!(told(&window).is_empty() && selected(&window).is_some());
    key(&mut window, Key::Escape);
    assert_eq!(selected(&window), None);

    // A copy that works takes the message about the copy that failed with it, and no other.
    window.drop_file(gone.clone());
    key(&mut window, Key::J);
    click(&mut window, MIDDLE);
    key(&mut window, Key::J);
    let now = told(&window);
    assert!(
        now.len() == 2 && now[0].contains("gone.obj") && now[1].contains("copied"),
        "{now:?}"
    );
    // A report of what was done goes by itself, so Esc is not for it.
    key(&mut window, Key::Escape);
    assert!(told(&window)[0].contains("copied"));
    // Adding a file counts as opening one: it takes the message about the file that did not open with it.
    window.drop_file(gone);
    window.send([Event::ModifiersChanged(Modifiers::SHIFT)]);
    window.drop_file(folder.path().join("row.toml"));
    window.send([Event::ModifiersChanged(Modifiers::NONE)]);
    assert_eq!(window.state().scene().objects().len(), 6);
    assert!(told(&window).iter().all(|text| !text.contains("gone.obj")));
    // A save that works takes the message about the save that failed with it.
    window.save_as(folder.path().join("no such folder/kept.toml"));
    assert!(
        told(&window)
            .iter()
            .any(|text| text.contains("no such folder"))
    );
    window.save_as(folder.path().join("kept.toml"));
    assert!(
        told(&window)
            .iter()
            .all(|text| !text.contains("no such folder"))
    );
}

/// The command line's camera counts before the file's own.
#[test]
fn a_camera_by_flags_counts_before_the_file_s() {
    let (path, _folder) = row_file();
    let eye = DVec3::new(3.0, 4.0, 12.0);
    let camera = CameraChoice {
        eye: Some(eye),
        ..CameraChoice::default()
    };
    let window = opened(Options {
        paths: vec![path],
        camera,
        ..Options::default()
    });
    assert_eq!(window.state().view().camera.eye(), eye);
}

/// Page Down opens the next file of the folder, and Page Up the one before. One that cannot be read is passed by.
#[test]
fn page_down_turns_to_the_next_file_of_the_folder() {
    let (path, folder) = row_file();
    std::fs::write(folder.path().join("row2.obj"), "v 0 0 0\nf 1 1 9\n")
        .expect("a writable folder");
    std::fs::write(folder.path().join("row10.toml"), ROW).expect("a writable folder");
    let mut window = open(vec![path], 1.0);
    key(&mut window, Key::PageUp);
    assert_eq!(window.state().name(), "row10.toml");
    key(&mut window, Key::PageUp);
    assert_eq!(window.state().name(), "row10.toml");
    assert!(told(&window)[0].contains("row2.obj"), "{:?}", told(&window));
    key(&mut window, Key::PageUp);
    assert_eq!(window.state().name(), "row.toml");
    assert!(told(&window).is_empty(), "{:?}", told(&window));
    key(&mut window, Key::PageDown);
    key(&mut window, Key::PageDown);
    assert_eq!(window.state().name(), "row10.toml");

    // In the gallery the next file is its next scene.
    key(&mut window, Key::E);
    let first = window.state().name().to_owned();
    key(&mut window, Key::PageDown);
    assert_ne!(window.state().name(), first);
    assert!(window.state().is_in_gallery());
    key(&mut window, Key::PageUp);
    assert_eq!(window.state().name(), first);
}

/// Edits are asked about first. Where nothing is open, or nothing else, a message says so.
#[test]
fn no_file_is_turned_to_over_edits_or_where_there_is_none() {
    let (path, folder) = row_file();
    let mut window = open(vec![path], 1.0);
    key(&mut window, Key::PageDown);
    assert!(told(&window)[0].contains("no other"), "{:?}", told(&window));
    std::fs::write(folder.path().join("row2.toml"), ROW).expect("a writable folder");
    click(&mut window, MIDDLE);
    press_key(&mut window, Modifiers::SHIFT, Key::H);
    key(&mut window, Key::PageDown);
    assert_eq!(window.state().name(), "row.toml");
    key(&mut window, Key::Escape);
    press_key(&mut window, Modifiers::COMMAND, Key::Z);
    key(&mut window, Key::PageDown);
    assert_eq!(window.state().name(), "row2.toml");
}
