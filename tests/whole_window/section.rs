//! A section can be placed, typed, dragged, undone and saved. What it cuts away is neither seen nor picked.

use super::{
    nothing_lost::{is_asked, is_marked},
    *,
};
use glam::DVec3;
use sightline::{camera::SectionChoice, geometry::Section, look};

fn section(window: &Window) -> Option<Section> {
    window.state().view().section
}

/// The front cube is cut through its middle. A click there picks its back face from within, which has a colour of its
/// own.
#[test]
fn a_cut_solid_shows_and_picks_its_inside() {
    let (mut window, _folder) = row(1.0);
    press_key(&mut window, Modifiers::NONE, Key::G);
    let whole = window.picture().expect("a picture");
    type_section(&mut window, [0.0, 0.0, -1.0], 2.0);
    let cut = window.picture().expect("a picture");
    let [x, y] = [590, 385];
    assert_ne!(whole.at(x, y), cut.at(x, y));
    let inside = look::shade(look::INSIDE.to_linear(), glam::Vec3::NEG_Z);
    let inside = sightline::colour::Srgb::from_linear(inside).0;
    let apart = |a: u8, b: u8| a.abs_diff(b);
    let seen = cut.at(x, y);
    assert!(
        seen.iter().zip(inside).all(|(a, b)| apart(*a, b) < 3),
        "{seen:?} for {inside:?}"
    );
    click(&mut window, pos2(590.5, 385.5));
    let hit = window.state().picked().expect("a hit");
    assert_eq!((hit.object.as_str(), hit.front), ("front", false));
    assert!(
        (hit.point_world.z - 1.5).abs() < 1e-12,
        "{}",
        hit.point_world
    );
}

/// Types a section as a user does.
fn type_section(window: &mut Window, normal: [f64; 3], offset: f64) {
    if !has_control(window, "cut") {
        click_on(window, "Section");
    }
    if section(window).is_none() {
        click_on(window, "cut");
    }
    let names = ["section n x", "section n y", "section n z"];
    // z is typed first, so that n never becomes 0 in between.
    for i in [2, 1, 0] {
        type_into(window, names[i], &normal[i].to_string());
        press_key(window, Modifiers::NONE, Key::Enter);
    }
    type_into(window, "section c", &offset.to_string());
    press_key(window, Modifiers::NONE, Key::Enter);
    let wanted = Section::new(normal.into(), offset).expect("a section");
    assert_eq!(section(window), Some(wanted));
}

#[test]
fn it_is_laid_flipped_and_taken_back_step_by_step() {
    let (mut window, _folder) = row(1.0);
    click_on(&mut window, "Section");
    assert!(!has_control(&window, "flip the section"));
    let mut stood = vec![None];
    click_on(&mut window, "section across x");
    stood.push(section(&window));
    // The eye looks along -z, so the far side is kept.
    click_under(&mut window, "Section", "section across z");
    stood.push(section(&window));
    let across = section(&window).expect("a section");
    assert_eq!(across.normal(), DVec3::NEG_Z);
    click_on(&mut window, "flip the section");
    stood.push(section(&window));
    assert_eq!(section(&window), Some(across.flipped()));
    press_key(&mut window, Modifiers::NONE, Key::Z);
    stood.push(section(&window));
    assert_eq!(section(&window), None);
    press_key(&mut window, Modifiers::NONE, Key::Z);
    assert_eq!(section(&window), Some(across.flipped()), "where it was");
    stood.push(section(&window));
    for was in stood.iter().rev().skip(1) {
        press_key(&mut window, CTRL, Key::Z);
        assert_eq!(section(&window), *was);
    }
    for will in &stood[1..] {
        press_key(&mut window, CTRL, Key::Y);
        assert_eq!(section(&window), *will);
    }
}

#[test]
fn what_makes_no_section_is_refused_in_red() {
    let (mut window, _folder) = row(1.0);
    click_under(&mut window, "Section", "section across z");
    let before = section(&window);
    type_into(&mut window, "section n z", "0");
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    assert_eq!(section(&window), before);
    let field = control(&window, "section n z");
    let description = format!("{field:?}");
    assert!(description.contains("must not be 0,0,0"), "{description}");
}

/// A drag of the arrow, by its head or by its shaft, moves the plane by as much as the cursor moves along the arrow. It
/// is one step of undo, and does not turn the view.
#[test]
fn the_arrow_in_the_picture_drags_it() {
    let (mut window, _folder) = row(1.0);
    press_key(&mut window, Modifiers::NONE, Key::Num3);
    click_under(&mut window, "Section", "section across z");
    let (before, view) = (section(&window).expect("a section"), *window.state().view());
    let head = control(&window, "drag the section").rect.center();
    // The arrow points to the right.
    for behind in [0.0, 14.0] {
        let at = head - egui::vec2(behind, 0.0);
        let to = at + egui::vec2(40.0, 3.0);
        drag(&mut window, PointerButton::Primary, at, to);
        let after = section(&window).expect("a section");
        let now = window.state().view().camera;
        assert_eq!(now, view.camera, "it does not turn");
        assert_eq!(after.normal(), before.normal());
        let shown = |section: &Section| {
            let on_plane = -section.offset() * section.normal();
            view.project(on_plane).expect("before the eye").px
        };
        let moved_px = shown(&after) - shown(&before);
        assert!(
            (moved_px.x - 40.0).abs() < 2.0 && moved_px.y.abs() < 1.0,
            "{behind}: {moved_px}"
        );
        press_key(&mut window, CTRL, Key::Z);
        assert_eq!(section(&window), Some(before), "one step");
    }
}

#[test]
fn along_the_picked_face() {
    let (mut window, _folder) = row(1.0);
    click_on(&mut window, "Section");
    assert!(!control(&window, "section along the face").is_enabled);
    click(&mut window, pos2(590.5, 385.5));
    assert_eq!(selected(&window), Some("front"));
    click_under(&mut window, "Section", "section along the face");
    let along = Section::new(DVec3::NEG_Z, 2.5).expect("a section");
    assert_eq!(section(&window), Some(along));
}

#[test]
fn it_is_saved_and_opened_again_and_no_gallery_scene_has_it() {
    let (mut window, folder) = row(1.0);
    type_section(&mut window, [0.1, 0.25, -1.0], 0.3);
    let laid = section(&window);
    press_key(&mut window, Modifiers::SHIFT, Key::C);
    let copied = window.copied().expect("a camera");
    assert!(copied.contains("section = \"0.1,0.25,-1,0.3\""), "{copied}");
    press_key(&mut window, Modifiers::NONE, Key::C);
    let command = window.copied().expect("a command");
    assert!(command.contains(" --section 0.1,0.25,-1,0.3"), "{command}");
    let file = folder.path().join("cut.toml");
    window.save_as(file.clone());
    let window = open(vec![file], 1.0);
    assert_eq!(section(&window), laid);
    let word: SectionChoice = "0.1,0.25,-1,0.3".parse().expect("a section");
    assert_eq!(laid.map(SectionChoice::Plane), Some(word));
    let (mut window, _folder) = row(1.0);
    press_key(&mut window, Modifiers::NONE, Key::Z);
    assert!(section(&window).is_some());
    press_key(&mut window, Modifiers::NONE, Key::E);
    assert_eq!(section(&window), None);
    press_key(&mut window, Modifiers::NONE, Key::Z);
    assert_eq!(section(&window), None);
    let is_heading = |control: &Control| control.name == "Section" && is_below_the_bar(control);
    assert!(!window.controls().iter().any(is_heading));
    let tool = window
        .controls()
        .iter()
        .find(|control| control.name == "Section");
    assert!(!tool.expect("a tool").is_enabled);
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    assert!(section(&window).is_some(), "back");
}

/// A scene file holds the section, so a section that differs from the file's is an unsaved edit.
#[test]
fn a_section_is_an_edit_until_it_is_saved() {
    let (mut window, folder) = row(1.0);
    press_key(&mut window, Modifiers::NONE, Key::Z);
    assert!(is_marked(&window));
    press_key(&mut window, Modifiers::NONE, Key::Z);
    assert!(!is_marked(&window), "as the file has it");
    press_key(&mut window, Modifiers::NONE, Key::Z);
    // Reading the file again keeps it, so there is nothing to ask.
    press_key(&mut window, Modifiers::NONE, Key::R);
    assert!(section(&window).is_some() && is_marked(&window) && !is_asked(&window));
    press_key(&mut window, CTRL, Key::Q);
    assert!(is_asked(&window) && !window.has_quit());
    click_on(&mut window, "Save first\u{2026}");
    let cut = folder.path().join("cut.toml");
    window.save_as(cut.clone());
    assert!(window.has_quit());

    // A file's own section is no edit; to turn it off is one.
    let mut window = open(vec![cut], 1.0);
    assert!(section(&window).is_some() && !is_marked(&window));
    press_key(&mut window, Modifiers::NONE, Key::Z);
    assert!(is_marked(&window));
    press_key(&mut window, CTRL, Key::Z);
    assert!(!is_marked(&window));
    press_key(&mut window, CTRL, Key::Y);
    // What was left for the gallery counts, too.
    press_key(&mut window, Modifiers::NONE, Key::E);
    window.drop_file(folder.path().join("row.toml"));
    assert!(is_asked(&window));
    click_on(&mut window, "Open, drop the edits");
    assert!(!is_marked(&window));
}

/// Esc ends measuring before it selects nothing.
#[test]
fn esc_ends_measuring_first() {
    let (mut window, _folder) = row(1.0);
    click(&mut window, pos2(590.5, 385.5));
    click_on(&mut window, "Measure");
    click_on(&mut window, "snap clicks");
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    assert!(!window.state().measuring().is_on);
    assert_eq!(selected(&window), Some("front"));
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(selected(&window), None);
}

/// If a scene file or a flag gives an invalid section, the window shows the scene without it and says so.
#[test]
fn one_that_names_no_face_is_said_in_the_window() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("cut.toml");
    let text = ROW.replace("[camera]", "[camera]\nsection = \"face:9,0\"");
    std::fs::write(&path, text).expect("a writable folder");
    let window = open(vec![path], 1.0);
    let says = |window: &Window, words: &str| {
        let said = window.messages().filter(|text| text.contains(words));
        assert_eq!(said.count(), 1, "{words}");
        assert_eq!(section(window), None);
    };
    says(&window, "the section is left out: ");
    let path = folder.path().join("row.toml");
    std::fs::write(&path, ROW).expect("a writable folder");
    let mut options = Options {
        paths: vec![path],
        ..Options::default()
    };
    options.camera.section = Some("face:2,7".parse().expect("a section"));
    let window = Window::open(options, px(SIZE, 1.0), 1.0);
    says(&window, "the section is left out: ");
}

/// Two typed numbers are two steps, also in the same field.
#[test]
fn each_typed_number_is_a_step() {
    let (mut window, _folder) = row(1.0);
    type_section(&mut window, [0.0, 0.0, -1.0], 0.5);
    let before = section(&window);
    type_into(&mut window, "section c", "0.75");
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    assert_ne!(section(&window), before);
    press_key(&mut window, CTRL, Key::Z);
    assert_eq!(section(&window), before);
}

/// A plane is the same with a normal of another length: its arrow stands where it stood and drags it as far.
#[test]
fn the_arrow_is_the_same_for_a_longer_normal() {
    let dragged = [1.0, 2.0].map(|length| {
        let (mut window, _folder) = row(1.0);
        press_key(&mut window, Modifiers::NONE, Key::Num3);
        type_section(&mut window, [0.0, 0.0, length], length);
        let at = control(&window, "drag the section").rect.center();
        let to = at + egui::vec2(40.0, 0.0);
        drag(&mut window, PointerButton::Primary, at, to);
        let after = section(&window).expect("a section");
        (at, after.offset() / length)
    });
    let [(at, offset), (longer_at, longer_offset)] = dragged;
    assert!(at.distance(longer_at) < 0.1, "{at} {longer_at}");
    assert!((offset - 1.0).abs() > 0.05, "it moved: {offset}");
    assert!((offset - longer_offset).abs() < 1e-6, "{longer_offset}");
}

/// The slider leads from a section that cuts away all to one that cuts away nothing.
#[test]
fn it_slides_from_one_end_of_the_scene_to_the_other() {
    let (mut window, _folder) = row(1.0);
    type_section(&mut window, [0.0, 0.0, -1.0], 0.5);
    scroll_to(&mut window, "section c, slid");
    let slider = control(&window, "section c, slid").rect;
    for (at, offset) in [
        (slider.left_center() + egui::vec2(1.0, 0.0), -2.0),
        (slider.right_center() - egui::vec2(1.0, 0.0), 2.5),
    ] {
        click(&mut window, at);
        let now = section(&window).expect("a section").offset();
        assert!((now - offset).abs() < 0.1, "{now}, not {offset}");
    }
}
