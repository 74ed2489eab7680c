//! The window remembers recent scenes and panels from run to run, reads changed files again, and shows names in any
//! script.

use super::*;
use sightline::{colour::Srgb, scene::Shape};
use std::{fs, thread, time::Duration};

fn remembering(memory: &Path, paths: Vec<PathBuf>) -> Window {
    let options = Options {
        paths,
        memory: Some(memory.to_owned()),
        ..Options::default()
    };
    Window::open(options, px(SIZE, 1.0), 1.0)
}

#[test]
fn what_was_opened_and_how_panels_stood_is_remembered() {
    let folder = tempfile::tempdir().expect("a folder");
    let memory = folder.path().join("not there yet/window.toml");
    let [row, other] = ["row.toml", "other.toml"].map(|name| folder.path().join(name));
    for path in [&row, &other] {
        fs::write(path, ROW).expect("writable");
    }
    let mut window = remembering(&memory, vec![row.clone()]);
    window.drop_file(other.clone());
    click_on(&mut window, "Camera");
    click_on(&mut window, "left side");
    window.close();
    assert!(window.has_quit());

    let mut window = remembering(&memory, Vec::new());
    assert!(!has_control(&window, "fov") && !control(&window, "left side").is_on);
    click_on(&mut window, "File");
    let above = control(&window, "other.toml").rect.top();
    assert!(
        above < control(&window, "row.toml").rect.top(),
        "the last first"
    );
    click_on(&mut window, "row.toml");
    assert_eq!(window.state().name(), "row.toml");
    // A missing file is reported, and leaves the list.
    fs::remove_file(&other).expect("it was there");
    click_on(&mut window, "File");
    click_on(&mut window, "other.toml");
    assert!(window.messages().any(|text| text.contains("other.toml")));
    click_on(&mut window, "File");
    assert!(!has_control(&window, "other.toml"));
}

/// The memory is a device that never ends, a pipe that nobody writes into, or a file that is too large.
#[test]
fn a_memory_without_end_is_not_read() {
    let folder = tempfile::tempdir().expect("a folder");
    let memory = folder.path().join("window.toml");
    let large = folder.path().join("large.toml");
    fs::write(&large, "#".repeat(2 << 20) + "\nlook = \"light\"\n").expect("writable");
    let pipe = folder.path().join("pipe");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status();
    assert!(made.expect("mkfifo").success());
    for endless in [Path::new("/dev/zero"), &pipe, &large] {
        std::os::unix::fs::symlink(endless, &memory).expect("a link");
        let mut window = remembering(&memory, Vec::new());
        click_on(&mut window, "View");
        let look = control(&window, "Theme").description.clone();
        assert!(look.ends_with("as on the desktop"), "{endless:?}: {look}");
        drop(window);
        fs::remove_file(&memory).expect("a link");
    }
}

#[test]
fn a_broken_memory_is_no_obstacle() {
    let folder = tempfile::tempdir().expect("a folder");
    let memory = folder.path().join("window.toml");
    for broken in ["recent = 5", "[panels", "[panels]\nfolded = []", "\u{0}"] {
        fs::write(&memory, broken).expect("writable");
        let mut window = remembering(&memory, Vec::new());
        assert!(has_control(&window, "fov"), "{broken}");
        assert_eq!(window.messages().count(), 0);
        window.close();
        assert!(fs::read_to_string(&memory).is_ok_and(|text| text.contains("recent = []")));
    }
}

/// Runs passes of a window until it meets a condition.
#[track_caller]
pub(super) fn wait_until(window: &mut Window, is_so: impl Fn(&Window) -> bool) {
    for _ in 0..200 {
        window.send([]);
        if is_so(window) {
            return;
        }
        thread::sleep(Duration::from_millis(50));
    }
    panic!("it never was, in 10 s");
}

#[test]
fn a_file_that_changes_is_read_again() {
    let (mut window, folder) = row(1.0);
    let path = folder.path().join("row.toml");
    press_key(&mut window, Modifiers::NONE, Key::Num7);
    let view = *window.state().view();
    let more = format!("{ROW}\n[[object]]\nname = \"new\"\nshape = \"sphere\"\n");
    fs::write(&path, &more).expect("writable");
    wait_until(&mut window, |window| {
        window.state().scene().objects().len() == 4
    });
    assert_eq!(*window.state().view(), view, "the view stays");
    assert!(
        window
            .messages()
            .any(|text| text.contains("was read again"))
    );
    // A file that was written beside and renamed counts as changed, too.
    let beside = folder.path().join("beside");
    fs::write(&beside, ROW).expect("writable");
    fs::rename(&beside, &path).expect("writable");
    wait_until(&mut window, |window| {
        window.state().scene().objects().len() == 3
    });

    // Edits are kept.
    click(&mut window, MIDDLE);
    click_on(&mut window, "Placement");
    type_into(&mut window, "position x", "0.25");
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    let edited = window.state().scene().objects()[1].placement;
    fs::write(&path, &more).expect("writable");
    wait_until(&mut window, |window| {
        window
            .messages()
            .any(|text| text.contains("has changed on the disk"))
    });
    assert_eq!(window.state().scene().objects().len(), 3);
    assert_eq!(window.state().scene().objects()[1].placement, edited);
    press_key(&mut window, Modifiers::NONE, Key::R);
    click_on(&mut window, "Reload, drop the edits");
    assert_eq!(window.state().scene().objects().len(), 4);

    // A file that Sightline writes does not count as changed.
    window.save_as(path);
    window.wait_s(5.0);
    thread::sleep(Duration::from_millis(800));
    window.send([]);
    assert_eq!(window.messages().count(), 0);
}

#[test]
fn a_material_that_changes_is_read_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let write =
        |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("written");
    write(
        "triangle.obj",
        "mtllib later.mtl\nmtllib here.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n",
    );
    write("here.mtl", "newmtl a\nKd 1 0 0\n");
    let mut window = open(vec![folder.path().join("triangle.obj")], 1.0);
    let colour = |window: &Window| {
        let Shape::Mesh { mesh, .. } = &window.state().scene().objects()[0].shape else {
            panic!("a mesh");
        };
        mesh.triangle_colour(0)
    };
    assert_eq!(colour(&window), Some(Srgb([255, 0, 0])));
    write("here.mtl", "newmtl a\nKd 0 1 0\n");
    wait_until(&mut window, |window| {
        colour(window) == Some(Srgb([0, 255, 0]))
    });
    // This material file was missing before. The first of two counts.
    write("later.mtl", "newmtl a\nKd 0 0 1\n");
    wait_until(&mut window, |window| {
        colour(window) == Some(Srgb([0, 0, 255]))
    });
}

/// Debian's and Ubuntu's `fonts-dejavu-core` has Armenian, Hebrew and Arabic; egui's own typefaces have none of them.
#[test]
fn names_are_readable_in_scripts_that_only_the_system_has() {
    let name = "\u{540}\u{561}\u{575} \u{5e9}\u{5dc}\u{5d5}\u{5dd} \u{633}\u{644}\u{627}\u{645}";
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("row.toml");
    fs::write(&path, ROW.replace("back", name)).expect("writable");
    let plain = open(Vec::new(), 1.0);
    assert!(
        plain.can_write("plain") && !plain.can_write(name),
        "not needed, not loaded"
    );
    let window = open(vec![path], 1.0);
    assert!(has_control(&window, name));
    assert!(window.can_write(name));
}

/// The list of recent scenes has the last ten, each once, also one that was only saved.
#[test]
fn the_last_ten_scenes_are_remembered_once_each() {
    let folder = tempfile::tempdir().expect("a folder");
    let memory = folder.path().join("window.toml");
    let path = |name: &str| folder.path().join(name).with_extension("toml");
    let names: Vec<_> = (0..11).map(|i| format!("scene{i:02}")).collect();
    for name in &names {
        fs::write(path(name), ROW).expect("writable");
    }
    let mut window = remembering(&memory, vec![path(&names[0])]);
    for name in names[1..].iter().chain(&names[9..]) {
        window.drop_file(path(name));
    }
    window.save_as(path("saved"));
    click_on(&mut window, "File");
    let is_file = |name: &str| Path::new(name).extension() == Some("toml".as_ref());
    let listed: Vec<_> = (window.controls().iter())
        .filter(|control| control.role != Role::Label && is_file(&control.name))
        .map(|control| control.name.as_str())
        .collect();
    let scenes = names[2..].iter().rev().map(|name| format!("{name}.toml"));
    let expected: Vec<_> = ["saved.toml".to_owned()]
        .into_iter()
        .chain(scenes)
        .collect();
    assert_eq!(listed, expected);
}
