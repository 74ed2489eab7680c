//! Nothing is lost: edits can be undone, unsaved edits are marked and asked about, and what is saved loads again.

use super::*;
use glam::DVec3;
use sightline::scene::{self, Object, Progress, Shape};

/// Hides the cube: an edit by keys.
pub(super) fn edit(window: &mut Window) {
    click(window, MIDDLE);
    assert_eq!(selected(window), Some("front"));
    press_key(window, Modifiers::SHIFT, Key::H);
}

pub(super) fn shown(window: &Window) -> Vec<bool> {
    let objects = window.state().scene().objects().iter();
    objects.map(|object| object.visible).collect()
}

fn eye(window: &Window) -> DVec3 {
    window.state().view().camera.eye()
}

pub(super) fn is_asked(window: &Window) -> bool {
    has_control(window, "Unsaved edits")
}

pub(super) fn is_marked(window: &Window) -> bool {
    window.title().starts_with('\u{2022}')
}

#[test]
fn keys_and_buttons_undo_and_redo() {
    let (mut window, _folder) = row(1.0);
    assert!(!control(&window, "Undo").is_enabled);
    edit(&mut window);
    assert_eq!(shown(&window), [false, true, true]);
    for redo in [(CTRL | Modifiers::SHIFT, Key::Z), (CTRL, Key::Y)] {
        press_key(&mut window, CTRL, Key::Z);
        assert_eq!(shown(&window), [true; 3]);
        assert_eq!(selected(&window), Some("front"), "as before");
        press_key(&mut window, redo.0, redo.1);
        assert_eq!(shown(&window), [false, true, true], "{redo:?}");
    }
    click_on(&mut window, "Undo");
    assert_eq!(shown(&window), [true; 3]);
    assert!(!control(&window, "Undo").is_enabled);
    click_on(&mut window, "Redo");
    assert_eq!(shown(&window), [false, true, true]);
    assert!(!control(&window, "Redo").is_enabled);
}

/// Enter resets the view; undo brings it back.
#[test]
fn a_view_that_was_thrown_away_comes_back() {
    let (mut window, _folder) = row(1.0);
    let to = MIDDLE + egui::vec2(90.0, -40.0);
    drag(&mut window, PointerButton::Primary, MIDDLE, to);
    let before = *window.state().view();
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    assert_eq!(eye(&window), DVec3::new(0.0, 0.0, 10.0));
    press_key(&mut window, CTRL, Key::Z);
    assert_eq!(*window.state().view(), before);
    assert!(!is_marked(&window), "a view is no edit");
}

#[test]
fn the_gallery_and_back_keeps_everything() {
    let (mut window, _folder) = row(1.0);
    edit(&mut window);
    press_key(&mut window, Modifiers::NONE, Key::Num9);
    click(&mut window, MIDDLE);
    let before = (*window.state().view(), window.state().selection().cloned());
    for by_escape in [true, false] {
        press_key(&mut window, Modifiers::NONE, Key::E);
        assert!(window.state().showing().is_some() && !is_asked(&window));
        assert!(is_marked(&window), "what was left has edits");
        press_key(&mut window, Modifiers::NONE, Key::Num7);
        // Its history is its own, and does not lead out.
        press_key(&mut window, CTRL, Key::Z);
        press_key(&mut window, CTRL, Key::Z);
        assert!(window.state().showing().is_some());
        press_key(&mut window, Modifiers::NONE, Key::E);
        if by_escape {
            press_key(&mut window, Modifiers::NONE, Key::Escape);
        } else {
            click_on(&mut window, "Learn");
            click_on(&mut window, "leave the gallery");
        }
        assert_eq!(window.state().name(), "row.toml");
        assert_eq!(
            (*window.state().view(), window.state().selection().cloned()),
            before
        );
        assert_eq!(shown(&window), [false, true, true]);
        assert!(window.state().scene().trees_are_built());
    }
    press_key(&mut window, CTRL, Key::Z);
    press_key(&mut window, CTRL, Key::Z);
    assert_eq!(shown(&window), [true; 3], "its history is as it was");
}

#[test]
fn edits_are_marked_and_asked_about_before_they_go() {
    let (mut window, folder) = row(1.0);
    let other = folder.path().join("other.toml");
    std::fs::write(&other, ROW).expect("writable");
    edit(&mut window);
    assert!(is_marked(&window), "{}", window.title());
    press_key(&mut window, CTRL, Key::Z);
    assert!(!is_marked(&window), "{}", window.title());
    press_key(&mut window, CTRL, Key::Y);

    // Each way to lose the edits asks first. Esc and Cancel lose nothing.
    window.close();
    assert!(is_asked(&window) && !window.has_quit());
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    assert!(!is_asked(&window) && !window.has_quit());
    press_key(&mut window, CTRL, Key::Q);
    assert!(is_asked(&window) && !window.has_quit());
    click_on(&mut window, "Cancel");
    window.drop_file(other.clone());
    assert!(is_asked(&window));
    // While the question is open, other keys do nothing.
    let view = *window.state().view();
    press_key(&mut window, Modifiers::NONE, Key::Num7);
    assert_eq!(*window.state().view(), view);
    click_on(&mut window, "Cancel");
    assert_eq!(window.state().name(), "row.toml");
    assert_eq!(shown(&window), [false, true, true]);

    // A reload keeps hidden objects hidden, so there is nothing to ask.
    press_key(&mut window, Modifiers::NONE, Key::R);
    assert!(!is_asked(&window));
    assert_eq!(shown(&window), [false, true, true]);
    assert!(is_marked(&window));

    window.drop_file(other);
    click_on(&mut window, "Open, drop the edits");
    assert_eq!(window.state().name(), "other.toml");
    assert!(!is_marked(&window));
    window.close();
    assert!(window.has_quit(), "nothing to ask");
}

/// Opening by the Open dialog or by Recent asks before edits are dropped.
#[test]
fn what_is_chosen_to_open_asks_before_edits_go() {
    type Way = fn(&mut Window, &Path);
    let (mut window, folder) = row(1.0);
    let other = folder.path().join("other.toml");
    std::fs::write(&other, ROW).expect("writable");
    let ways: [(&str, Way); 2] = [
        ("dialog", |window, folder| {
            window.open_files(vec![folder.join("row.toml")]);
        }),
        ("recent", |window, _| {
            click_on(window, "File");
            click_on(window, "row.toml");
        }),
    ];
    for (way, opens) in ways {
        // Nothing was edited, so nothing is asked.
        window.drop_file(other.clone());
        assert_eq!(window.state().name(), "other.toml", "{way}");
        edit(&mut window);
        opens(&mut window, folder.path());
        assert!(is_asked(&window), "{way}");
        click_on(&mut window, "Cancel");
        assert_eq!(window.state().name(), "other.toml", "{way}");
        assert_eq!(shown(&window), [false, true, true], "{way}");
        assert!(is_marked(&window), "{way}");
        opens(&mut window, folder.path());
        click_on(&mut window, "Open, drop the edits");
        assert_eq!(window.state().name(), "row.toml", "{way}");
        assert_eq!(shown(&window), [true; 3], "{way}");
    }
}

#[test]
fn what_is_saved_first_is_closed_then() {
    let (mut window, folder) = row(1.0);
    edit(&mut window);
    window.close();
    click_on(&mut window, "Save first\u{2026}");
    assert!(!window.has_quit(), "it is not saved yet");
    window.save_as(folder.path().join("kept.toml"));
    assert!(window.has_quit());
    let kept = scene::load(&[folder.path().join("kept.toml")], &Progress::default());
    let visible: Vec<bool> = (kept.expect("a scene").scene.objects().iter())
        .map(|object| object.visible)
        .collect();
    assert_eq!(visible, [false, true, true]);
}

/// After a failed save nothing is closed.
#[test]
fn what_could_not_be_saved_is_not_closed() {
    let (mut window, folder) = row(1.0);
    edit(&mut window);
    window.close();
    click_on(&mut window, "Save first\u{2026}");
    window.save_as(folder.path().join("no such folder/kept.toml"));
    assert!(!window.has_quit() && is_marked(&window));
    assert!(window.messages().any(|text| text.contains("kept.toml")));
}

#[test]
fn dropped_files_can_be_added() {
    let (mut window, folder) = row(1.0);
    let other = folder.path().join("other.toml");
    std::fs::write(&other, ROW).expect("writable");
    edit(&mut window);
    let before = eye(&window);
    window.drop_file(other.clone());
    click_on(&mut window, "Add to the scene");
    assert_eq!(shown(&window), [false, true, true, true, true, true]);
    assert_eq!(eye(&window), before);
    // The command names both files, in the order of the ids.
    press_key(&mut window, Modifiers::NONE, Key::C);
    let command = window.copied().expect("a command").to_owned();
    let (first, second) = (command.find("row.toml"), command.find("other.toml"));
    assert!(first.is_some() && first < second, "{command}");
    press_key(&mut window, CTRL, Key::Z);
    assert_eq!(shown(&window), [false, true, true]);
    press_key(&mut window, CTRL, Key::Y);
    assert_eq!(shown(&window).len(), 6);
    // With Shift, a dropped file is added without a question.
    window.send([Event::ModifiersChanged(Modifiers::SHIFT)]);
    window.drop_file(other);
    assert!(!is_asked(&window));
    assert_eq!(shown(&window).len(), 9);
}

/// What is saved is what is on show when the dialog is answered. Nothing else opens meanwhile.
#[test]
fn what_is_on_show_is_saved() {
    let (mut window, folder) = row(1.0);
    edit(&mut window);
    press_key(&mut window, CTRL, Key::S);
    press_key(&mut window, Modifiers::NONE, Key::E);
    assert!(window.state().showing().is_none());
    let told = |window: &Window| window.messages().any(|text| text.contains("open already"));
    assert!(told(&window));
    window.drop_file(folder.path().join("row.toml"));
    assert_eq!(shown(&window), [false, true, true]);
    // While the dialog is open, the user goes on.
    press_key(&mut window, Modifiers::NONE, Key::Num7);
    press_key(&mut window, Modifiers::NONE, Key::P);
    click_on(&mut window, "show NDC");
    let eye = eye(&window);
    window.save_as(folder.path().join("kept.toml"));
    assert_eq!(
        window.state().views(),
        Views::One(Stage::Ndc),
        "saving changes nothing on screen"
    );
    let kept = scene::load(&[folder.path().join("kept.toml")], &Progress::default());
    let kept = kept.expect("a scene");
    assert!(!kept.scene.objects()[0].visible);
    assert_eq!(kept.camera.eye, Some(eye));
    assert_eq!(window.state().name(), "kept.toml");
    assert!(!is_marked(&window));
    click_on(&mut window, "show picture");
    press_key(&mut window, CTRL, Key::Z);
    press_key(&mut window, CTRL, Key::Z);
    assert_eq!(shown(&window), [true; 3]);
    assert!(is_marked(&window), "the file hides one");
    press_key(&mut window, CTRL, Key::Y);
    assert!(!is_marked(&window), "back at what the file has");
}

/// Everything about a mesh that is drawn and picked.
pub(super) fn corners(object: &Object) -> Vec<[[u64; 3]; 3]> {
    let Shape::Mesh { mesh, .. } = &object.shape else {
        return Vec::new();
    };
    let bits = |corner: DVec3| corner.to_array().map(f64::to_bits);
    let triangles = object.shape.triangles().expect("a mesh");
    triangles
        .map(|triangle| mesh.corners(triangle).map(bits))
        .collect()
}

#[test]
fn the_demo_and_the_gallery_are_saved_with_their_meshes() {
    for paths in [Vec::new(), vec![PathBuf::from("gallery:needles")]] {
        let folder = tempfile::tempdir().expect("a folder");
        let mut window = open(paths, 1.0);
        let before = window.state().scene().objects().to_vec();
        window.save_as(folder.path().join("mine.toml"));
        let told: Vec<_> = window.messages().collect();
        assert!(
            told.iter().all(|text| text.starts_with("saved ")),
            "{told:?}"
        );
        assert_eq!(window.state().name(), "mine.toml");
        // The folder is moved: the scene still loads whole.
        let elsewhere = folder.path().with_extension("moved");
        std::fs::rename(folder.path(), &elsewhere).expect("ours");
        let again = scene::load(&[elsewhere.join("mine.toml")], &Progress::default());
        let again = again.unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(again.warnings.len(), 0, "{:?}", again.warnings);
        let mut triangles = 0;
        for (a, b) in before.iter().zip(again.scene.objects().iter()) {
            assert_eq!((&a.name, a.colour), (&b.name, b.colour));
            assert_eq!(a.placement, b.placement);
            assert!(corners(a) == corners(b), "{}", a.name);
            triangles += corners(a).len();
        }
        assert_eq!(before.len(), again.scene.objects().len());
        assert!(triangles > 5, "{triangles}");
        std::fs::remove_dir_all(elsewhere).expect("ours");
    }
}

/// The mesh is written beside the scene, under a name that file systems take.
#[test]
fn a_mesh_with_a_long_name_is_saved_when_its_file_is_gone() {
    let folder = tempfile::tempdir().expect("a folder");
    let mesh = folder.path().join(format!("{}.obj", "n".repeat(250)));
    std::fs::write(&mesh, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").expect("writable");
    let mut window = open(vec![mesh.clone()], 1.0);
    std::fs::remove_file(&mesh).expect("removable");
    press_key(&mut window, CTRL, Key::S);
    let path = folder.path().join("kept.toml");
    window.save_as(path.clone());
    let kept = scene::load(&[path], &Progress::default()).expect("a scene");
    assert_eq!(kept.scene.triangle_count(), 1);
}
