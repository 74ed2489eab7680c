//! A number that is typed and not entered yet counts when the scene is saved, closed or replaced.
#![expect(clippy::float_cmp, reason = "numbers as they were typed")]

use super::{nothing_lost::is_asked, *};
use sightline::scene::{self, Progress};

type Does = fn(&mut Window, &Path);

/// A window in which a position is typed, but not entered.
fn typing(text: &str) -> (Window, TempDir) {
    let (mut window, folder) = row(1.0);
    std::fs::write(folder.path().join("other.toml"), ROW).expect("writable");
    click(&mut window, MIDDLE);
    click_on(&mut window, "Placement");
    type_into(&mut window, "position x", text);
    assert_eq!(x(&window), 0.0);
    (window, folder)
}

fn x(window: &Window) -> f64 {
    let object = &window.state().scene().objects()[0];
    object.placement.model().translation.x
}

#[test]
fn a_typed_number_is_saved() {
    let ways: [(&str, Does); 2] = [
        ("button", |window, _| click_on(window, "Save\u{2026}")),
        ("key", |window, _| press_key(window, CTRL, Key::S)),
    ];
    for (way, save) in ways {
        let (mut window, folder) = typing("0.25");
        let kept = folder.path().join("kept.toml");
        save(&mut window, folder.path());
        assert_eq!(x(&window), 0.25, "{way}");
        window.save_as(kept.clone());
        let kept = scene::load(&[kept], &Progress::default()).expect("a scene");
        let at = kept.scene.objects()[0].placement.model().translation;
        assert_eq!(at.x, 0.25, "{way}");
    }
}

#[test]
fn a_typed_number_is_asked_about_before_it_goes() {
    let ways: [(&str, Does); 7] = [
        ("frame", |window, _| window.close()),
        ("Ctrl+Q", |window, _| press_key(window, CTRL, Key::Q)),
        ("dialog", |window, folder| {
            window.open_files(vec![folder.join("other.toml")]);
        }),
        ("drop", |window, folder| {
            window.drop_file(folder.join("other.toml"));
        }),
        ("reload", |window, _| click_on(window, "Reload")),
        ("Ctrl+S, frame", |window, _| {
            press_key(window, CTRL, Key::S);
            window.close();
        }),
        ("recent", |window, _| {
            click_on(window, "File");
            click_on(window, "row.toml");
        }),
    ];
    for (way, goes) in ways {
        let (mut window, folder) = typing("0.25");
        goes(&mut window, folder.path());
        assert!(is_asked(&window) && !window.has_quit(), "{way}");
        click_on(&mut window, "Cancel");
        assert_eq!(x(&window), 0.25, "{way}");
        assert_eq!(window.state().name(), "row.toml", "{way}");
    }
}

/// Files that are added change no object that is there: the number counts before they come.
#[test]
fn a_typed_number_counts_before_files_are_added() {
    let (mut window, folder) = typing("0.25");
    window.send([Event::ModifiersChanged(Modifiers::SHIFT)]);
    window.drop_file(folder.path().join("other.toml"));
    assert_eq!(window.state().scene().objects().len(), 6);
    assert_eq!(x(&window), 0.25);
    // Each is a step of its own.
    press_key(&mut window, CTRL, Key::Z);
    assert_eq!(window.state().scene().objects().len(), 3);
    assert_eq!(x(&window), 0.25);
    press_key(&mut window, CTRL, Key::Z);
    assert_eq!(x(&window), 0.0);
}

/// A text that is no number is left as Enter leaves it: red, and the number before stays in force.
#[test]
fn a_text_that_is_no_number_counts_for_nothing() {
    let (mut window, folder) = typing("abc");
    press_key(&mut window, CTRL, Key::S);
    let kept = folder.path().join("kept.toml");
    window.save_as(kept.clone());
    assert_eq!(control(&window, "position x").value, "abc");
    let kept = scene::load(&[kept], &Progress::default()).expect("a scene");
    let at = kept.scene.objects()[0].placement.model().translation;
    assert_eq!(at.x, 0.0);
    window.close();
    assert!(window.has_quit(), "nothing is edited");
}

/// Other keys belong to the text.
#[test]
fn letters_are_typed() {
    let (mut window, _folder) = typing("0.25");
    for key in [Key::R, Key::Num7, Key::B] {
        let view = *window.state().view();
        press_key(&mut window, Modifiers::NONE, key);
        assert_eq!(*window.state().view(), view);
    }
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(x(&window), 0.0);
}

/// What is typed after Tab, or after a double click, replaces the number.
#[test]
fn tab_and_a_double_click_select_the_whole_number() {
    let (mut window, _folder) = typing("0.25");
    let enter = |window: &mut Window, text: &str| {
        window.send([Event::Text(text.into())]);
        press_key(window, Modifiers::NONE, Key::Enter);
        let object = &window.state().scene().objects()[0];
        object.placement.model().translation.to_array()
    };
    press_key(&mut window, Modifiers::NONE, Key::Tab);
    press_key(&mut window, Modifiers::NONE, Key::Tab);
    assert_eq!(enter(&mut window, "5"), [0.25, 0.0, 5.0]);
    let field = control(&window, "position x").rect.center();
    double_click(&mut window, field);
    assert_eq!(enter(&mut window, "-1.5"), [-1.5, 0.0, 5.0]);
}

/// A drag over a field changes its number as it goes, leads back where it came from, and is one step of undo. Esc ends it
/// where it began.
#[test]
fn fields_are_dragged() {
    for (field, part) in [("position x", 0), ("scale x", 1)] {
        let (mut window, _folder) = row(1.0);
        click(&mut window, MIDDLE);
        click_on(&mut window, "Placement");
        let model = |window: &Window| window.state().scene().objects()[0].placement.model();
        let at_part =
            |window: &Window| [model(window).translation.x, model(window).matrix3.x_axis.x][part];
        let before = at_part(&window);
        let at = control(&window, field).rect.center();
        let move_to = |x: f32| Event::PointerMoved(at + egui::vec2(x, 0.0));
        let press =
            |pressed, x: f32| button(at + egui::vec2(x, 0.0), PointerButton::Primary, pressed);
        window.send([move_to(0.0), press(true, 0.0), move_to(30.0), move_to(70.0)]);
        let dragged = at_part(&window);
        assert!(dragged > before + 0.3, "{field}: {dragged}");
        // Far beyond what is possible or wanted, and back.
        window.send([move_to(-500.0), move_to(70.0)]);
        assert!((at_part(&window) - dragged).abs() < 1e-9, "{field}");
        window.send([press(false, 70.0)]);
        press_key(&mut window, CTRL, Key::Z);
        assert_eq!(at_part(&window), before, "{field}: one step");
        window.send([move_to(0.0), press(true, 0.0), move_to(30.0)]);
        press_key(&mut window, Modifiers::NONE, Key::Escape);
        assert_eq!(
            (at_part(&window), selected(&window)),
            (before, Some("front")),
            "{field}"
        );
        window.send([move_to(60.0), press(false, 60.0)]);
        assert_eq!(at_part(&window), before, "{field}: it stays so");
    }
}

/// A field that is left as it was entered changes nothing, even where it shows fewer digits by then.
#[test]
fn a_field_that_is_left_untouched_keeps_its_digits() {
    let (mut window, _folder) = typing("-12.345678");
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    assert_eq!(x(&window), -12.345_678);
    click_on(&mut window, "position x");
    window.resize(px([640, 400], 1.0));
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    assert_eq!(x(&window), -12.345_678);
}

/// The field shows a few digits. To enter it and to leave it changes none of the others.
#[test]
fn a_number_that_is_only_looked_at_keeps_all_digits() {
    let (mut window, _folder) = typing("0.123456789012");
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    assert_eq!(x(&window), 0.123_456_789_012);
    click_on(&mut window, "position x");
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    assert_eq!(x(&window), 0.123_456_789_012);
}

/// With Shift, a drag over a field changes its number ten times as much.
#[test]
fn a_drag_with_shift_goes_ten_times_as_far() {
    let [plain, shifted] = [Modifiers::NONE, Modifiers::SHIFT].map(|held| {
        let (mut window, _folder) = typing("0");
        press_key(&mut window, Modifiers::NONE, Key::Enter);
        let at = control(&window, "position x").rect.center();
        window.send([Event::ModifiersChanged(held)]);
        drag(
            &mut window,
            PointerButton::Primary,
            at,
            at + egui::vec2(20.0, 0.0),
        );
        x(&window)
    });
    assert!(
        plain > 0.0 && (shifted / plain - 10.0).abs() < 0.1,
        "{plain} {shifted}"
    );
}
