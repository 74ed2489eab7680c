//! Edits outlive the display: they are saved beside their file, and a line says where.

use super::{Screen, Viewer, scene};
use std::{
    path::Path,
    process::{Command, ExitStatus},
    thread,
    time::Duration,
};

fn title(screen: &Screen) -> String {
    let output = Command::new("xdotool")
        .args([
            "search",
            "--onlyvisible",
            "--name",
            "Sightline",
            "getwindowname",
        ])
        .env("DISPLAY", &screen.display)
        .output()
        .expect("xdotool runs");
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// Ends the screen of a window in which an object is hidden if `edits`. Returns what the window says last, and how it
/// ends.
fn outlived(folder: &Path, edits: bool) -> (String, ExitStatus) {
    let path = scene(folder).display().to_string();
    let screen = Screen::new(1280, 720);
    let mut viewer = Viewer::open(&screen, "1", folder, &[&path]);
    screen.xdotool("search --sync --onlyvisible --name Sightline windowfocus --sync");
    if edits {
        screen.xdotool("mousemove 640 360 click 1");
        viewer.picked();
        screen.xdotool("key shift+h");
        let is_marked = (0..600).any(|_| {
            thread::sleep(Duration::from_millis(100));
            title(&screen).contains('\u{2022}')
        });
        assert!(is_marked, "the dot of unsaved edits");
    }
    drop(screen);
    let ended = viewer.process.wait().expect("an end");
    (viewer.log.iter().last().unwrap_or_default(), ended)
}

#[test]
fn edits_are_saved_when_the_display_is_gone() {
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["three things.rescued.toml", "three things.rescued-2.toml"] {
        let (said, ended) = outlived(folder.path(), true);
        assert_eq!(ended.code(), Some(5));
        let file = folder.path().join(name);
        let line = format!(
            "sightline: the display is gone; the edits of three things.toml are saved as {}",
            file.display()
        );
        assert_eq!(said, line);
        let text = std::fs::read_to_string(file).expect("saved");
        assert_eq!(text.matches("visible = false").count(), 1, "{text}");
    }
}

#[test]
fn a_display_that_goes_is_told_where_nothing_was_edited() {
    let folder = tempfile::tempdir().expect("a folder");
    let (said, ended) = outlived(folder.path(), false);
    assert_eq!(
        (ended.code(), &*said),
        (Some(5), "sightline: the display is gone")
    );
    let files = std::fs::read_dir(folder.path()).expect("a folder");
    let rescued = files.filter(|file| {
        let name = file.as_ref().expect("a file").file_name();
        name.to_string_lossy().contains("rescued")
    });
    assert_eq!(rescued.count(), 0);
}
