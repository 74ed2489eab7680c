//! The list of objects shows what it is about: the top of a new list, or the selection.

use super::*;
use egui::{MouseWheelUnit, vec2};

/// A scene file of 300 balls in a row, whose names begin with a word.
fn balls(folder: &Path, word: &str) -> PathBuf {
    let ball = |i: u32| {
        format!("[[object]]\nname = \"{word}{i:03}\"\nshape = \"sphere\"\nposition = [{i}, 0, 0]\n")
    };
    let path = folder.join(word).with_extension("toml");
    std::fs::write(&path, (0..300).map(ball).collect::<String>()).expect("writable");
    path
}

#[test]
fn a_new_list_begins_at_its_top_and_the_selection_stays_in_view() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = open(vec![balls(folder.path(), "ball")], 1.0);
    let scroll = |window: &mut Window| {
        let list = pos2(100.0, 400.0);
        window.send([
            Event::PointerMoved(list),
            Event::MouseWheel {
                unit: MouseWheelUnit::Point,
                source: egui::MouseWheelSource::Unknown,
                delta: vec2(0.0, -3000.0),
                phase: egui::TouchPhase::Move,
                modifiers: Modifiers::NONE,
            },
        ]);
        window.wait_s(1.0);
    };
    assert!(has_control(&window, "ball000"));
    scroll(&mut window);
    assert!(!has_control(&window, "ball000"), "it scrolls");
    // What is found begins at the top.
    type_into(&mut window, "search", "ball1");
    assert!(has_control(&window, "ball100"));
    scroll(&mut window);
    assert!(!has_control(&window, "ball100"));
    click_on(&mut window, "ball180");
    // Without a search, the selection is where one sees it.
    click_on(&mut window, "search");
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(control(&window, "search").value, "");
    assert!(has_control(&window, "ball180"));
    // Another scene begins at the top.
    window.drop_file(balls(folder.path(), "other"));
    assert!(has_control(&window, "other000"));
}

/// What is searched for is about one scene: objects that are added are found, and another scene is listed whole.
#[test]
fn a_search_is_for_the_objects_on_show() {
    let (mut window, folder) = row(1.0);
    let other = balls(folder.path(), "ball");
    type_into(&mut window, "search", "ball00");
    assert!(!has_control(&window, "ball000"));
    window.send([Event::ModifiersChanged(Modifiers::SHIFT)]);
    window.drop_file(other.clone());
    window.send([Event::ModifiersChanged(Modifiers::NONE)]);
    assert!(has_control(&window, "ball000") && !has_control(&window, "ball010"));
    window.drop_file(other);
    click_on(&mut window, "Open, drop the edits");
    assert_eq!(control(&window, "search").value, "");
    assert!(has_control(&window, "ball010"));
}
