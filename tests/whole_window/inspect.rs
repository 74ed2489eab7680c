//! Keys save pictures, copy and paste cameras, and step through the hits on a ray. The panels say what is so.

use super::*;
use sightline::viewer::model::Overlay;

#[test]
fn a_camera_is_copied_and_pasted_by_keys() {
    let (mut window, _folder) = row(1.0);
    drag(
        &mut window,
        PointerButton::Primary,
        MIDDLE,
        MIDDLE + egui::vec2(90.0, -40.0),
    );
    let turned = *window.state().view();
    press_key(&mut window, Modifiers::SHIFT, Key::C);
    let text = window.copied().expect("a camera").to_owned();
    assert!(text.starts_with("[camera]"), "{text}");
    press_key(&mut window, Modifiers::NONE, Key::Num1);
    assert_ne!(*window.state().view(), turned);
    window.send([Event::Paste(text.clone())]);
    assert_eq!(*window.state().view(), turned, "to the bit");
    window.wait_s(5.0);
    assert_eq!(window.messages().count(), 0);

    for (bad, word) in [
        ("not a camera", "holds no camera"),
        ("[camera]\nfov = 200", "field of view"),
        ("[camera]\nfav = 20", "holds no camera"),
    ] {
        window.send([Event::Paste(bad.to_owned())]);
        assert!(window.messages().any(|text| text.contains(word)), "{bad}");
        assert_eq!(*window.state().view(), turned, "{bad}");
    }
    // While a field is edited, pasted text goes into the field.
    click_on(&mut window, "search");
    press_key(&mut window, Modifiers::NONE, Key::Num1);
    let before = *window.state().view();
    window.send([Event::Paste(text)]);
    assert_eq!(*window.state().view(), before);
}

#[test]
fn keys_step_through_the_ray() {
    let (mut window, _folder) = row(1.0);
    click(&mut window, MIDDLE);
    let mut seen = Vec::new();
    let says = |window: &Window, text: &str| {
        let mut all = window.controls().iter();
        all.any(|control| control.name.contains(text))
    };
    assert!(!says(&window, "Surface"));
    for number in 2..6 {
        press_key(&mut window, Modifiers::NONE, Key::N);
        seen.push(selected(&window).expect("picked").to_owned());
        let before = if number < 4 { "front" } else { "middle" };
        let hidden = format!("Surface {number} of 5, behind {before}.");
        assert!(says(&window, &hidden), "{hidden}");
    }
    press_key(&mut window, Modifiers::SHIFT, Key::N);
    seen.push(selected(&window).expect("picked").to_owned());
    assert_eq!(seen, ["front", "middle", "middle", "back", "middle"]);
    let keys = [Key::G, Key::Y, Key::D, Key::W, Key::L, Key::X];
    for (overlay, key) in Overlay::ALL.into_iter().zip(keys) {
        let shows = window.state().overlays().shows(overlay);
        press_key(&mut window, Modifiers::NONE, key);
        assert_ne!(window.state().overlays().shows(overlay), shows, "{key:?}");
    }
}

/// Squares before a camera that looks straight along z, the nearest first.
fn squares(z: &[&str]) -> (Window, TempDir) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("squares.toml");
    let square = |z: &&str| format!("[[object]]\nshape = \"square\"\nposition = [0, 0, {z}]\n");
    let objects: String = z.iter().map(square).collect();
    let text = format!("[camera]\neye = [0, 0, 10]\ntarget = [0, 0, 0]\n{objects}");
    std::fs::write(&path, text).expect("a writable folder");
    (open(vec![path], 1.0), folder)
}

#[test]
fn a_gap_however_small_is_not_shown_as_none() {
    for (behind, said) in [
        ("-1e-17", "1.0e-17 deeper"),
        ("-0.00000004", "4.0e-8 deeper"),
        ("-0.25", "0.2500000 deeper"),
        ("0", "in the same place"),
    ] {
        let (mut window, _folder) = squares(&["0", behind]);
        click(&mut window, MIDDLE);
        assert!(selected(&window).is_some(), "{behind}");
        click_on(&mut window, "Details");
        control(&window, said);
    }
}

#[test]
fn esc_takes_the_measured_distance_away() {
    let (mut window, _folder) = row(1.0);
    let key = |window: &mut Window, key| press_key(window, Modifiers::NONE, key);
    click(&mut window, MIDDLE);
    key(&mut window, Key::N);
    key(&mut window, Key::D);
    assert_eq!(window.state().measuring().points.len(), 2);
    key(&mut window, Key::Escape);
    assert_eq!(window.state().measuring().points.len(), 0);
    // The next pick has no earlier point to be measured from.
    click(&mut window, MIDDLE);
    assert_eq!(window.state().measuring().points.len(), 1);
}

#[test]
fn the_panels_say_what_is_so() {
    let (mut window, _folder) = row(1.0);
    click(&mut window, MIDDLE);
    click_on(&mut window, "Placement");
    control(&window, "nearest edge");
    for (scale, said) in [
        ("0.5", "determinant 0.5: volumes times 0.5"),
        ("-2", "determinant -2: volumes times 2, mirrored"),
    ] {
        type_into(&mut window, "scale x", scale);
        press_key(&mut window, Modifiers::NONE, Key::Enter);
        control(&window, said);
    }
    // A square has no volume.
    click_on(&mut window, "back");
    type_into(&mut window, "scale x", "-2");
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    control(&window, "determinant -6, mirrored");
    press_key(&mut window, Modifiers::NONE, Key::P);
    control(&window, "det -6, mirrored");
    click_on(&mut window, "middle");
    control(&window, "No point of it is picked: click its surface.");
}
