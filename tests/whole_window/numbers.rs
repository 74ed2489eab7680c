//! The window names the file's own lines, faces and vertices for a pick.

use super::*;

/// A quad before the camera, and a triangle behind it.
const WALLS: &str = "\
v -1 -1 2
v 1.1 -1 2
v 1.1 1 2
v -1 1 2
o Front
f 1 2 3 4
o Back
v -5 -5 0
v 5.5 -1 0
v 0 8 0
f 5 6 7
";

const SCENE: &str = "
[camera]
eye = [0, 0, 10]
target = [0, 0, 0]

[[object]]
shape = \"mesh\"
file = \"walls.obj\"
";

fn walls() -> (Window, TempDir) {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("walls.obj"), WALLS).expect("a writable folder");
    let path = folder.path().join("walls.toml");
    std::fs::write(&path, SCENE).expect("a writable folder");
    (open(vec![path], 1.0), folder)
}

/// Whether some text in the window contains this one.
fn reads(window: &Window, text: &str) -> bool {
    window
        .controls()
        .iter()
        .any(|control| control.name.contains(text))
}

#[test]
fn a_click_names_line_face_and_corners() {
    let (mut window, _folder) = walls();
    click_on(&mut window, "Details");
    click(&mut window, MIDDLE);
    assert_eq!(selected(&window), Some("Front"));
    assert!(reads(&window, "walls.obj") && reads(&window, "1, a quad"));
    assert!(
        reads(&window, "v 2: 1.1 -1 2"),
        "the corner as it is written"
    );
    assert!(reads(&window, "stored 1.100000023841858 -1 2"));
    press_key(&mut window, Modifiers::NONE, Key::J);
    let copied: serde_json::Value =
        serde_json::from_str(window.copied().expect("JSON")).expect("JSON");
    assert_eq!(copied["hit"]["line"], 6);
    assert_eq!(copied["hit"]["vertices"][1]["written"], "1.1 -1 2");
    // The surface behind is another face.
    press_key(&mut window, Modifiers::NONE, Key::N);
    assert_eq!(selected(&window), Some("Back"));
    assert!(reads(&window, "2, a triangle") && !reads(&window, "1, a quad"));
}

/// The file is removed, not changed: a changed file may be loaded again before the click.
#[test]
fn a_file_that_is_gone_is_said_to_be() {
    let (mut window, folder) = walls();
    std::fs::remove_file(folder.path().join("walls.obj")).expect("a file");
    click_on(&mut window, "Details");
    click(&mut window, MIDDLE);
    assert_eq!(selected(&window), Some("Front"));
    assert!(reads(&window, "walls.obj: cannot be read again"));
    assert!(!reads(&window, "1, a quad"));
}
