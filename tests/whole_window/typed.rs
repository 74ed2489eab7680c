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
