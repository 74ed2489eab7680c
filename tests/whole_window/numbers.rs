//! The file's own numbers in the window.

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

fn walls() -> (Offscreen, TempDir) {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("walls.obj"), WALLS).expect("a writable folder");
    let path = folder.path().join("walls.toml");
    std::fs::write(&path, SCENE).expect("a writable folder");
    (open(vec![path], 1.0), folder)
}

/// All that can be read.
fn reads(window: &Offscreen, text: &str) -> bool {
    window
        .controls()
        .iter()
        .any(|control| control.name.contains(text))
}

#[test]
fn a_click_names_line_face_and_corners() {
    let (mut window, _folder) = walls();
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

/// One that is changed may be loaded again before anybody clicks.
#[test]
fn a_file_that_is_gone_is_said_to_be() {
    let (mut window, folder) = walls();
    std::fs::remove_file(folder.path().join("walls.obj")).expect("a file");
    click(&mut window, MIDDLE);
    assert_eq!(selected(&window), Some("Front"));
    assert!(reads(&window, "walls.obj: cannot be read again"));
    assert!(!reads(&window, "1, a quad"));
}

#[test]
fn what_has_a_number_can_be_gone_to() {
    let (mut window, _folder) = walls();
    let go = |window: &mut Offscreen, field: &str, number: &str| {
        type_into(window, field, number);
        press_key(window, Modifiers::NONE, Key::Enter);
    };
    let before = *window.state().view();
    go(&mut window, "go to face", "2");
    assert_eq!(selected(&window), Some("Back"));
    assert!(
        reads(&window, "face 2, line 11: hidden by Front"),
        "what hides it"
    );
    assert_eq!(*window.state().view(), before, "it is in the picture");
    let hits = window.state().hits().expect("a ray");
    assert_eq!(hits.picks[hits.at].id, 2);
    go(&mut window, "go to vertex", "3");
    assert_eq!(selected(&window), Some("Front"));
    assert!(reads(&window, "v 3: 1.1 1 2, line 3: seen at"));
    // What is out of the picture comes into its middle, and the way back is a step.
    go(&mut window, "go to vertex", "5");
    let turned = *window.state().view();
    assert_ne!(turned, before);
    let at = turned
        .project(glam::dvec3(-5.0, -5.0, 0.0))
        .expect("in front")
        .px;
    assert!(at.distance(turned.viewport.size_px() / 2.0) < 1e-6, "{at}");
    press_key(&mut window, CTRL, Key::Z);
    assert_eq!(*window.state().view(), before);
    go(&mut window, "go to object", "2");
    assert_eq!(selected(&window), Some("Back"));
    for (field, number, text) in [
        ("go to object", "3", "there is no object 3"),
        (
            "go to face",
            "3",
            "there is no face 3: they run from 1 to 2",
        ),
        ("go to vertex", "99", "there is no vertex 99"),
    ] {
        go(&mut window, field, number);
        assert!(reads(&window, text), "{text}");
    }
}
