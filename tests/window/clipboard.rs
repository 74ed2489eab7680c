//! A camera that one window copies to the system's clipboard can be pasted into another window.

use super::{APART, Screen, Viewer, scene, value};
use std::thread;

#[test]
fn a_camera_that_one_window_copies_another_pastes() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = scene(folder.path()).display().to_string();
    let screen = Screen::new(1280, 720);
    let open = |flags: &[&str]| {
        let words = [&[&*path], flags].concat();
        let viewer = Viewer::open(&screen, "1", folder.path(), &words);
        let id = viewer.process.id();
        screen.xdotool(&format!(
            "search --sync --onlyvisible --all --pid {id} --name Sightline windowfocus --sync"
        ));
        viewer
    };
    let from = open(&["--eye", "5,4,3", "--target", "0,1,0"]);
    screen.xdotool("key shift+c");
    from.wait_for("the camera is copied");
    // The second window lies over the first.
    let to = open(&[]);
    screen.xdotool("key ctrl+v");
    // Until the pasted view is drawn, clicks pick in the one before.
    let mut clicks = (0..50).map(|aside| {
        thread::sleep(APART);
        screen.xdotool(&format!("mousemove {} 360 click 1", 640 + aside));
        to.picked().1
    });
    let is_pasted = |command: &String| value(command, "--eye") == "5,4,3";
    assert!(clicks.any(|command| is_pasted(&command)));
}
