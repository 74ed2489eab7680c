//! A scene file names the meshes beside it by their names alone, the dialog suggests where to save, and what waits for a
//! save goes on once it is done.

use super::{
    nothing_lost::{edit, is_asked},
    *,
};
use std::fs;

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

/// The question is about edits. Once a dialog that was open already has saved them, what was asked for goes on.
#[test]
fn a_question_goes_on_once_there_is_nothing_to_ask() {
    let (mut window, folder) = row(1.0);
    edit(&mut window);
    press_key(&mut window, CTRL, Key::S);
    window.close();
    assert!(is_asked(&window) && !window.has_quit());
    window.save_as(folder.path().join("kept.toml"));
    assert!(!is_asked(&window) && window.has_quit());
}

/// A second one would answer for the first.
#[test]
fn one_save_dialog_is_open_at_a_time() {
    let (mut window, folder) = row(1.0);
    press_key(&mut window, CTRL, Key::S);
    edit(&mut window);
    press_key(&mut window, CTRL, Key::S);
    assert_eq!(window.save_dialogs(), 1);
    let told = |window: &Offscreen| window.messages().any(|text| text.contains("open already"));
    assert!(told(&window));
    // The answer saves what the second key was about.
    let kept = folder.path().join("kept.toml");
    window.save_as(kept.clone());
    assert!(!window.title().starts_with('\u{2022}'));
    let kept = open(vec![kept], 1.0);
    assert!(!kept.state().scene().objects()[0].visible);
    // After a dialog that was cancelled, the next one opens.
    press_key(&mut window, CTRL, Key::S);
    window.save_nowhere();
    press_key(&mut window, CTRL, Key::S);
    assert_eq!(window.save_dialogs(), 3);
    // A dialog that is open already also serves what waits for the save.
    press_key(&mut window, CTRL, Key::Z);
    window.close();
    click_on(&mut window, "Save first\u{2026}");
    assert_eq!(window.save_dialogs(), 3);
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
