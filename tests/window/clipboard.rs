//! A camera that one window copies to the system's clipboard can be pasted into another window.

use super::{APART, Screen, Viewer, scene, value};
use std::{
    path::Path,
    process::Command,
    thread,
    time::{Duration, Instant},
};

/// Opens a window over those before it, and gives it the focus.
fn open(screen: &Screen, folder: &Path, flags: &[&str]) -> Viewer {
    let path = scene(folder).display().to_string();
    let viewer = Viewer::open(screen, "1", folder, &[&[&*path], flags].concat());
    let id = viewer.process.id();
    screen.xdotool(&format!(
        "search --sync --onlyvisible --all --pid {id} --name Sightline windowfocus --sync"
    ));
    viewer
}

/// Clicks until the window shows the camera that [`FROM`] has: until it is drawn, clicks pick in the one before.
fn shows_the_pasted_camera(screen: &Screen, viewer: &Viewer) -> bool {
    let mut clicks = (0..50).map(|aside| {
        thread::sleep(APART);
        screen.xdotool(&format!("mousemove {} 360 click 1", 640 + aside));
        viewer.picked().1
    });
    clicks.any(|command| value(&command, "--eye") == FROM[1])
}

/// Two windows. The first, whose camera is [`FROM`], has copied it; the second lies over it.
fn one_that_copied_and_another(screen: &Screen, folder: &Path) -> [Viewer; 2] {
    let from = open(screen, folder, &FROM);
    screen.xdotool("key shift+c");
    from.wait_for("the camera is copied");
    [from, open(screen, folder, &[])]
}

const FROM: [&str; 4] = ["--eye", "5,4,3", "--target", "0,1,0"];

#[test]
fn a_camera_that_one_window_copies_another_pastes() {
    let folder = tempfile::tempdir().expect("a folder");
    let screen = Screen::new(1280, 720);
    let [_from, to] = one_that_copied_and_another(&screen, folder.path());
    screen.xdotool("key ctrl+v");
    assert!(shows_the_pasted_camera(&screen, &to));
}

/// The window lives on while the clipboard's owner does not answer, says so, and pastes once it does.
#[test]
#[cfg(unix)]
fn an_owner_that_does_not_answer_stops_no_window() {
    let folder = tempfile::tempdir().expect("a folder");
    let screen = Screen::new(1280, 720);
    let [from, to] = one_that_copied_and_another(&screen, folder.path());
    let tell_owner = |signal: &str| {
        let id = from.process.id().to_string();
        let told = Command::new("kill").args([signal, &id]).status();
        assert!(told.expect("kill runs").success());
    };
    tell_owner("-STOP");
    let start = Instant::now();
    for press in ["key ctrl+v", "mousemove 640 360 click 2", "click 1"] {
        screen.xdotool(press);
    }
    let (_, command) = to.picked();
    assert_ne!(value(&command, "--eye"), FROM[1]);
    screen.xdotool("key ctrl+v");
    to.wait_for("the program that owns the clipboard does not answer");
    let waited = start.elapsed();
    tell_owner("-CONT");
    // A reader that waits for the owner waits for seconds, for each form that text can have.
    assert!(waited < Duration::from_secs(4), "{waited:?}");
    thread::sleep(APART);
    screen.xdotool("key ctrl+v");
    assert!(shows_the_pasted_camera(&screen, &to));
}
