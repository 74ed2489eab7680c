//! A scene file names the meshes beside it by their names alone, the dialog suggests where to save, and what waits for
//! a save goes on once it is done.

use super::{
    nothing_lost::{corners, edit, is_asked, is_marked, shown},
    remembering::wait_until,
    *,
};
use sightline::{
    colour::Srgb,
    geometry::Placement,
    scene::{self, Progress, Shape},
};
use std::fs;

/// One triangle, as an OBJ file.
const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// Moves the first object: an edit that reading its file again would drop.
fn move_first(window: &mut Window) {
    press_key(window, Modifiers::NONE, Key::ArrowDown);
    click_on(window, "Placement");
    type_into(window, "position x", "0.25");
    press_key(window, Modifiers::NONE, Key::Enter);
    assert!(is_marked(window));
}

/// Where the triangles of the first object are, its placement, and the colour of its first triangle.
fn first(scene: &scene::Scene) -> (Vec<[[u64; 3]; 3]>, Placement, Option<Srgb>) {
    let object = &scene.objects()[0];
    let Shape::Mesh { mesh, .. } = &object.shape else {
        panic!("a mesh");
    };
    (corners(object), object.placement, mesh.triangle_colour(0))
}

/// What is saved is what is on screen, whatever another program made of the mesh's file or of its colours.
#[test]
fn a_mesh_whose_file_has_changed_is_saved_beside() {
    let coloured = format!("mtllib tri.mtl\nusemtl a\n{TRIANGLE}");
    let other = "o other\nv 5 5 5\nv 9 9 0\nv 0 9 9\nv 1 0 0\nf 1 2 3\nf 2 3 4\n";
    for (changed, text) in [
        ("tri.obj", other),
        ("tri.obj", "not a mesh any more"),
        ("tri.mtl", "newmtl a\nKd 0 1 0\n"),
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        let file = |name: &str| folder.path().join(name);
        fs::write(file("tri.obj"), &coloured).expect("writable");
        fs::write(file("tri.mtl"), "newmtl a\nKd 1 0 0\n").expect("writable");
        let mut window = open(vec![file("tri.obj")], 1.0);
        move_first(&mut window);
        let on_screen = first(window.state().scene());
        fs::write(file(changed), text).expect("writable");
        wait_until(&mut window, |window| {
            let mut all = window.messages();
            all.any(|text| text.contains("Your edits are kept"))
        });
        press_key(&mut window, CTRL, Key::S);
        window.save_as(file("kept.toml"));
        assert!(!is_marked(&window));
        assert_eq!(fs::read_to_string(file(changed)).expect("a file"), text);
        let kept = scene::load(&[file("kept.toml")], &Progress::default());
        let kept = kept.unwrap_or_else(|error| panic!("{changed}: {error}"));
        assert_eq!(first(&kept.scene), on_screen, "{changed}");
    }
}

/// A file that was written again as it was is named as before: no second file appears.
#[test]
fn a_mesh_whose_file_was_only_touched_is_saved_by_its_name() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name);
    fs::write(file("tri.obj"), TRIANGLE).expect("writable");
    let mut window = open(vec![file("tri.obj")], 1.0);
    move_first(&mut window);
    fs::write(file("beside"), TRIANGLE).expect("writable");
    fs::rename(file("beside"), file("tri.obj")).expect("writable");
    window.save_as(file("kept.toml"));
    let text = fs::read_to_string(file("kept.toml")).expect("a file");
    assert!(text.contains("file = \"tri.obj\""), "{text}");
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 2);
}

/// Zeros keep their signs.
#[test]
fn a_mesh_whose_file_is_gone_is_saved_beside() {
    let text = "v -0 0 0\nv 1 0 -0.0\nv 0 1 0\nf 1 2 3\n";
    let folder = tempfile::tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name);
    fs::write(file("zeros.obj"), text).expect("writable");
    let mut window = open(vec![file("zeros.obj")], 1.0);
    move_first(&mut window);
    let on_screen = first(window.state().scene());
    fs::remove_file(file("zeros.obj")).expect("it was there");
    press_key(&mut window, CTRL, Key::S);
    window.save_as(file("kept.toml"));
    let messages: Vec<_> = window.messages().collect();
    assert!(!is_marked(&window), "{messages:?}");
    let kept = scene::load(&[file("kept.toml")], &Progress::default());
    let kept = kept.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(first(&kept.scene), on_screen);
}

#[test]
fn nothing_is_saved_before_anything_is_open() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = open(vec![folder.path().join("missing.obj")], 1.0);
    press_key(&mut window, CTRL, Key::S);
    assert!(!window.has_dialog());
    let mut all = window.messages();
    assert!(all.any(|text| text.contains("nothing is open yet")));
}

/// To write then would undo what another program has written.
#[test]
fn files_that_change_while_the_dialog_is_open_are_not_overwritten() {
    let (mut window, folder) = row(1.0);
    let path = folder.path().join("row.toml");
    edit(&mut window);
    press_key(&mut window, CTRL, Key::S);
    let longer = format!("{ROW}\n[[object]]\nname = \"new\"\nshape = \"cube\"\n");
    fs::write(&path, &longer).expect("writable");
    std::thread::sleep(std::time::Duration::from_millis(1300));
    window.send([]);
    assert_eq!(
        window.state().scene().objects().len(),
        3,
        "the dialog comes first"
    );
    window.save_as(path.clone());
    assert_eq!(fs::read_to_string(&path).expect("a file"), longer);
    let told = |words: &str| window.messages().any(|text| text.contains(words));
    assert!(told("nothing was saved, save again") && is_marked(&window));
    wait_until(&mut window, |window| {
        window.state().scene().objects().len() == 4
    });
    // The next one saves what is on screen.
    press_key(&mut window, CTRL, Key::S);
    window.save_as(path.clone());
    assert!(!is_marked(&window));
    let kept = open(vec![path], 1.0);
    assert_eq!(shown(&kept), [false, true, true, true]);
}

#[test]
fn a_mesh_beside_the_scene_is_named_by_its_name_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    let [models, sub, link] = ["models", "sub", "link"].map(|name| folder.path().join(name));
    for new in [&models, &sub] {
        fs::create_dir(new).expect("writable");
    }
    fs::write(
        models.join("tri.obj"),
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    )
    .expect("writable");
    let mut ways = vec![sub.join("../models/tri.obj")];
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(&models, &link).expect("a link");
        ways.push(link.join("tri.obj"));
    }
    for opened in ways {
        let mut window = open(vec![opened.clone()], 1.0);
        let kept = models.join("kept.toml");
        window.save_as(kept.clone());
        let text = fs::read_to_string(&kept).expect("a file");
        assert!(text.contains("file = \"tri.obj\""), "{opened:?}: {text}");
        let kept = open(vec![kept], 1.0);
        assert_eq!(kept.state().scene().triangle_count(), 1);
    }
    // What lies elsewhere is named in full.
    let mut window = open(vec![models.join("tri.obj")], 1.0);
    let kept = sub.join("kept.toml");
    window.save_as(kept.clone());
    let text = fs::read_to_string(&kept).expect("a file");
    assert!(
        text.contains("models/tri.obj") && !text.contains(".."),
        "{text}"
    );
}

/// Esc gives a dialog up, and so does closing the window. What is chosen in it later is not written.
#[test]
fn a_dialog_that_is_given_up_saves_nothing() {
    let (mut window, folder) = row(1.0);
    edit(&mut window);
    press_key(&mut window, CTRL, Key::S);
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    assert!(!window.has_dialog());
    press_key(&mut window, CTRL, Key::S);
    assert!(window.has_dialog());
    window.close();
    assert!(!window.has_dialog() && is_asked(&window) && !window.has_quit());
    let kept = folder.path().join("kept.toml");
    window.save_as(kept.clone());
    assert!(is_asked(&window) && !window.has_quit() && !kept.exists());
    let mut told = window.messages();
    assert!(told.any(|text| text.contains("no longer waited for")));
}

/// A second dialog's answer would be taken for the first one's.
#[test]
fn one_dialog_is_open_at_a_time() {
    let (mut window, folder) = row(1.0);
    press_key(&mut window, CTRL, Key::S);
    assert!(window.has_dialog());
    edit(&mut window);
    press_key(&mut window, CTRL, Key::S);
    let told = |window: &Window| window.messages().any(|text| text.contains("open already"));
    assert!(told(&window));
    // The answer saves what is on show.
    let kept = folder.path().join("kept.toml");
    window.save_as(kept.clone());
    assert!(!window.has_dialog() && !is_marked(&window));
    let kept = open(vec![kept], 1.0);
    assert!(!kept.state().scene().objects()[0].visible);
    // After a dialog that was cancelled, the next one opens, and serves what waits for the save.
    press_key(&mut window, CTRL, Key::S);
    window.save_nowhere();
    assert!(!window.has_dialog());
    press_key(&mut window, CTRL, Key::Z);
    window.close();
    click_on(&mut window, "Save first\u{2026}");
    assert!(window.has_dialog());
    window.save_as(folder.path().join("again.toml"));
    assert!(window.has_quit());
}

#[test]
fn the_dialog_suggests_the_folder_of_the_scene() {
    for (opened, suggested) in [
        (
            "assets/gallery/wide_lens.toml",
            "assets/gallery/wide_lens.toml",
        ),
        ("assets/gallery/needles.obj", "assets/gallery/scene.toml"),
    ] {
        let window = open(vec![opened.into()], 1.0);
        assert_eq!(window.state().name(), opened.rsplit_once('/').expect("/").1);
        assert_eq!(window.state().file_to_save(), Path::new(suggested));
    }
}

fn told(window: &Window) -> Vec<&str> {
    window.messages().collect()
}

/// Where the desktop shows no dialog, a scene is saved to its own scene file, or else to one with a free name. A
/// message says which.
#[test]
fn without_a_dialog_nothing_is_lost() {
    let folder = tempfile::tempdir().expect("a folder");
    let named = |name: &str| folder.path().join(name);
    let read = |name: &str| fs::read_to_string(named(name)).expect("a file");
    let save = |window: &mut Window| {
        press_key(window, CTRL, Key::S);
        window.save_without_dialog();
    };
    // Names that are taken, also the one that the dialog suggests.
    for taken in ["sightline-1.toml", "scene.toml"] {
        fs::write(named(taken), "taken").expect("writable");
    }
    let wall = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    fs::write(named("wall.obj"), wall).expect("writable");
    let mut window = open(vec![named("wall.obj")], 1.0);
    window.save_screenshots_in(folder.path().to_owned());
    press_key(&mut window, Modifiers::NONE, Key::Z);
    save(&mut window);
    assert!(!is_marked(&window));
    assert_eq!(window.state().name(), "sightline-2.toml");
    let free = named("sightline-2.toml").display().to_string();
    let says = ["no file dialog", "portal", "zenity", &free];
    let is_told = |text: &str| says.iter().all(|word| text.contains(word));
    assert!(window.messages().any(is_told), "{:?}", told(&window));
    // From now on that is its own file.
    let before = read("sightline-2.toml");
    press_key(&mut window, Modifiers::NONE, Key::Z);
    save(&mut window);
    assert!(!is_marked(&window) && read("sightline-2.toml") != before);
    assert!(!named("sightline-3.toml").exists());
    assert_eq!(["sightline-1.toml", "scene.toml"].map(read), ["taken"; 2]);
    // The question before the window closes is answered by that save, too.
    press_key(&mut window, Modifiers::NONE, Key::Z);
    window.close();
    click_on(&mut window, "Save first\u{2026}");
    window.save_without_dialog();
    assert!(window.has_quit() && read("sightline-2.toml") == before);
}

#[test]
fn without_a_dialog_to_open_it_says_what_works() {
    let (mut window, _folder) = row(1.0);
    press_key(&mut window, CTRL, Key::O);
    window.open_without_dialog();
    let told = told(&window);
    assert_eq!(told.len(), 1, "{told:?}");
    assert!(told[0].contains("drop files") && told[0].contains("sightline FILE"));
}

/// A save that reads changed files first has not been made, so what waits for it is asked about again.
#[test]
fn what_waits_for_a_save_that_is_not_made_is_asked_about_again() {
    let (mut window, folder) = row(1.0);
    let path = folder.path().join("row.toml");
    edit(&mut window);
    window.close();
    click_on(&mut window, "Save first\u{2026}");
    fs::write(&path, format!("{ROW}\n# changed\n")).expect("writable");
    std::thread::sleep(std::time::Duration::from_millis(1300));
    window.save_as(path);
    assert!(nothing_lost::is_asked(&window) && !window.has_quit());
}
