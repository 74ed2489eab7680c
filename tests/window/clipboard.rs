//! A camera that one window copies to the system's clipboard can be pasted into another window.

use super::{Screen, Viewer, scene, value};

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
    screen.xdotool("mousemove 640 360 click 1");
    let (_, command) = to.picked();
    assert_eq!(value(&command, "--eye"), "5,4,3", "{command}");
}
