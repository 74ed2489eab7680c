//! A camera that one window copies to the system's clipboard can be pasted into another window.

use super::{APART, Screen, Viewer, images, scene, value};
use std::{
    collections::BTreeSet,
    fs,
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

/// F12 and Ctrl+C put on the clipboard, for any program, what F12 and Enter write to a file.
#[test]
fn a_copied_screenshot_is_the_saved_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let screen = Screen::new(1280, 720);
    let viewer = open(&screen, folder.path(), &FROM);
    screen.xdotool("mousemove 640 700");
    for (keys, done) in [
        (["key F12", "key Return"], "saved"),
        (["key F12", "key ctrl+c"], "the screenshot is copied"),
    ] {
        for key in keys {
            screen.xdotool(key);
        }
        viewer.wait_for(done);
    }
    let copied = Command::new("xclip")
        .args(["-selection", "clipboard", "-t", "image/png", "-o"])
        .env("DISPLAY", &screen.display)
        .output()
        .expect("xclip runs (Debian, Ubuntu: apt-get install xclip)");
    let copy = folder.path().join("copied.png");
    fs::write(&copy, copied.stdout).expect("written");
    let saved = images::read(&folder.path().join("sightline-1.png"));
    let copied = images::read_channels::<4>(&copy);
    let kinds: BTreeSet<_> = saved.pixels().iter().collect();
    assert!(kinds.len() > 100, "{} colours", kinds.len());
    assert_eq!(saved.size(), copied.size());
    let opaque = saved.pixels().iter().map(|[r, g, b]| [*r, *g, *b, 255]);
    assert!(opaque.eq(copied.pixels().iter().copied()));
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
