//! The window names the file's own lines, faces and vertices for a pick, and goes to them by number.

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
    file_of(WALLS)
}

fn file_of(text: &str) -> (Offscreen, TempDir) {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("walls.obj"), text).expect("a writable folder");
    let path = folder.path().join("walls.toml");
    std::fs::write(&path, SCENE).expect("a writable folder");
    (open(vec![path], 1.0), folder)
}

/// Whether some text in the window contains this one.
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

/// The file is removed, not changed: a changed file may be loaded again before the click.
#[test]
fn a_file_that_is_gone_is_said_to_be() {
    let (mut window, folder) = walls();
    std::fs::remove_file(folder.path().join("walls.obj")).expect("a file");
    click(&mut window, MIDDLE);
    assert_eq!(selected(&window), Some("Front"));
    assert!(reads(&window, "walls.obj: cannot be read again"));
    assert!(!reads(&window, "1, a quad"));
}

fn go(window: &mut Offscreen, field: &str, number: &str) {
    type_into(window, field, number);
    press_key(window, Modifiers::NONE, Key::Enter);
}

/// An OBJ file of a quad and a triangle. The quad hides vertex 5 of the triangle, and vertex 7 lies above the quad.
const BEHIND: &str = "\
v -1 -1 2
v 1 -1 2
v 1 1 2
v -1 1 2
o Front
f 1 2 3 4
o Back
v 0.6 0.5 0
v 5 -1 0
v 0.1 4 0
f 5 6 7
";

/// The count of white pixels at the left and right sides of a square around the place where a point shows.
fn rim_of_mark(window: &mut Offscreen, point: glam::DVec3) -> usize {
    window.send([Event::PointerMoved(MIDDLE)]);
    let middle = window.state().cursor().expect("the picture's middle").px;
    window.send([Event::PointerGone]);
    let by = window.state().view().project(point).expect("in front").px - middle;
    let picture = window.picture().expect("a picture");
    let at = |x: f64, y: f64| {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "within the window"
        )]
        picture.at(
            (f64::from(MIDDLE.x) + by.x + x).round() as u32,
            (f64::from(MIDDLE.y) + by.y + y).round() as u32,
        )
    };
    let along = (-9..=9).map(f64::from);
    let is_white = |across: f64, along: f64| {
        let near = [-1.0, 0.0, 1.0];
        let lit = |rgb: [u8; 3]| rgb.iter().all(|value| *value > 235);
        near.into_iter().any(|by| lit(at(across + by, along)))
    };
    along
        .map(|along| usize::from(is_white(-9.0, along)) + usize::from(is_white(9.0, along)))
        .sum()
}

#[test]
fn what_is_gone_to_is_marked_seen_or_hidden() {
    let (mut window, _folder) = file_of(BEHIND);
    for key in [Key::G, Key::Y] {
        press_key(&mut window, Modifiers::NONE, key);
    }
    click(&mut window, MIDDLE);
    let (hidden, seen) = (glam::dvec3(0.6, 0.5, 0.0), glam::dvec3(0.1, 4.0, 0.0));
    let [at_hidden, at_seen] = [hidden, seen].map(|at| rim_of_mark(&mut window, at));
    assert_eq!([at_hidden, at_seen], [0, 0], "nothing is marked yet");
    go(&mut window, "go to vertex", "5");
    assert!(reads(&window, "v 5: 0.6 0.5 0, line 8: hidden by Front"));
    assert_eq!(selected(&window), Some("Back"));
    let hit = |window: &Offscreen| {
        let selection = window.state().selection()?;
        selection.pick.as_ref()?.hit.clone()
    };
    let picked = hit(&window).expect("a triangle that has it is picked");
    assert!((picked.point_world - hidden).length() < 1e-3);
    let dashed = rim_of_mark(&mut window, hidden);
    // From behind the vertex is visible, and the mark and the panel say so.
    press_key(&mut window, CTRL, Key::Num1);
    assert!(reads(&window, "v 5: 0.6 0.5 0, line 8: seen at"));
    let whole = rim_of_mark(&mut window, hidden);
    assert!(
        (8..=28).contains(&dashed) && whole >= 34,
        "{dashed} {whole}"
    );
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    go(&mut window, "go to vertex", "7");
    assert!(reads(&window, "v 7: 0.1 4 0, line 10: seen at"));
    assert!(rim_of_mark(&mut window, seen) >= 34);
    assert_eq!(rim_of_mark(&mut window, hidden), 0, "one at a time");
    // In the four views the vertex's name stands beside it.
    press_key(&mut window, Modifiers::NONE, Key::Num4);
    assert!(reads(&window, "v 7, seen"));
    press_key(&mut window, Modifiers::NONE, Key::Num4);
    // A number that does not exist leaves no mark. Esc removes the mark, and so does the next pick.
    go(&mut window, "go to vertex", "99");
    assert_eq!(rim_of_mark(&mut window, seen), 0);
    for away in [
        (|window| press_key(window, Modifiers::NONE, Key::Escape)) as fn(&mut Offscreen),
        |window| click(window, MIDDLE),
        |window| click(window, pos2(300.0, 60.0)),
    ] {
        go(&mut window, "go to vertex", "7");
        assert!(rim_of_mark(&mut window, seen) >= 34);
        away(&mut window);
        assert_eq!(rim_of_mark(&mut window, seen), 0);
        assert!(!reads(&window, "seen at"));
        window.wait_s(1.0);
    }
}

#[test]
fn what_has_a_number_can_be_gone_to() {
    let (mut window, _folder) = walls();
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
    // A vertex outside the picture is moved to its middle. Undo takes that back.
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

/// The result of "go to" disappears with its mark. For a number that does not exist, the panel says why.
#[test]
fn what_is_said_below_go_to_is_so() {
    let (mut window, _folder) = file_of(BEHIND);
    go(&mut window, "go to vertex", "7");
    assert!(reads(&window, "v 7: 0.1 4 0, line 10"));
    go(&mut window, "go to face", "0");
    assert!(reads(&window, "face 0: type a whole number from 1"));
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    click(&mut window, MIDDLE);
    assert!(!reads(&window, "v 7: 0.1 4 0"), "another pick");
}

#[test]
fn of_what_is_not_shown_the_reason_is_said() {
    let (mut window, _folder) = file_of(BEHIND);
    go(&mut window, "go to vertex", "7");
    assert!(reads(&window, "seen at"));
    type_into(&mut window, "far", "5");
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    assert!(reads(&window, "beyond the far plane"));
    click_on(&mut window, "fit far");
    click_on(&mut window, "section across y");
    click_on(&mut window, "flip the section");
    assert!(reads(&window, "cut away by the section"));
}
