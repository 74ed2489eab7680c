//! Every word in the panels has a tooltip, a row of the list acts along its whole length, and copying and saving are
//! confirmed.

use super::*;

#[test]
fn a_row_is_one_from_end_to_end() {
    let (mut window, _folder) = row(1.0);
    let edge = control(&window, "edge of the left side").rect.left();
    let rect = control(&window, "middle").rect;
    assert!(rect.left() < 40.0 && rect.right() > edge - 12.0, "{rect}");
    let end = pos2(edge - 14.0, rect.center().y);
    window.send([Event::PointerMoved(end)]);
    assert_eq!(window.state().hover(), Some(1), "its object is lit");
    click(&mut window, end);
    assert_eq!(selected(&window), Some("middle"));
    assert!(control(&window, "middle").is_on);
    // Its check box lights the object too, and does not select it.
    let tick = control(&window, "show back").rect.center();
    window.send([Event::PointerMoved(tick)]);
    assert_eq!(window.state().hover(), Some(2));
    click(&mut window, tick);
    assert_eq!(selected(&window), Some("middle"));
    assert!(!window.state().scene().objects()[2].visible);
    window.send([Event::PointerGone]);
    assert_eq!(window.state().hover(), None);
}

#[test]
fn the_arrows_walk_through_the_list() {
    let (mut window, _folder) = row(1.0);
    let mut seen = Vec::new();
    for key in [Key::ArrowDown; 4].into_iter().chain([Key::ArrowUp; 2]) {
        press_key(&mut window, Modifiers::NONE, key);
        seen.push(selected(&window).expect("a row").to_owned());
    }
    assert_eq!(seen, ["front", "middle", "back", "back", "middle", "front"]);
    // Arrow keys visit only the rows that match the search.
    type_into(&mut window, "search", "A");
    press_key(&mut window, Modifiers::NONE, Key::Enter);
    press_key(&mut window, Modifiers::NONE, Key::ArrowDown);
    assert_eq!(selected(&window), Some("back"));
    assert!(has_control(&window, "1 of 3 objects"));
    type_into(&mut window, "search", "xyz");
    assert!(has_control(&window, "0 of 3 objects"));
    assert!(has_control(
        &window,
        "No name contains \u{201c}xyz\u{201d}."
    ));
    // Esc clears the search first, then leaves its field.
    click(&mut window, MIDDLE);
    let picked = selected(&window).expect("a pick").to_owned();
    type_into(&mut window, "search", "back");
    assert!(has_control(&window, "1 of 3 objects") && !has_control(&window, "show front"));
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(control(&window, "search").value, "");
    control(&window, "show front");
    window.send([Event::Text("mid".into())]);
    assert_eq!(control(&window, "search").value, "mid");
    for _ in 0..2 {
        assert_eq!(selected(&window), Some(&*picked));
        press_key(&mut window, Modifiers::NONE, Key::Escape);
    }
    assert_eq!(selected(&window), Some(&*picked));
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(selected(&window), None);
}

#[test]
fn the_name_leads_the_pick() {
    let (mut window, _folder) = row(1.0);
    click(&mut window, MIDDLE);
    let all = window.controls();
    let below = |control: &&Control| control.rect.top() > 25.0 && control.rect.left() > 970.0;
    let first = all.iter().filter(below).min_by(|a, b| {
        let at = |control: &Control| (control.rect.center().y, control.rect.left());
        at(a).partial_cmp(&at(b)).expect("numbers")
    });
    assert_eq!(first.expect("a text").name, "front");
}

/// Whether a text needs no tooltip, because it is numbers or a sentence.
fn is_value(text: &str) -> bool {
    if text.ends_with(['.', ':', '\u{2026}']) && text.contains(' ') {
        return true;
    }
    let is_number = |word: &str| word.parse::<f64>().is_ok();
    !text.trim().is_empty() && text.split_whitespace().all(is_number)
}

#[test]
fn every_word_is_explained() {
    let (mut window, folder) = row(1.0);
    let (mut count, mut silent) = (0, Vec::new());
    let mut check = |window: &Window| {
        for control in window.controls() {
            let is_ours = !matches!(control.role, Role::ScrollBar | Role::Unknown | Role::Window);
            if is_ours && !is_value(&control.name) && !control.name.trim().is_empty() {
                count += 1;
                if control.description.is_empty() && !silent.contains(&control.name) {
                    silent.push(control.name.clone());
                }
            }
        }
    };
    check(&window);
    click(&mut window, MIDDLE);
    press_key(&mut window, Modifiers::NONE, Key::P);
    for heading in ["Pose", "Placement", "Details", "Depth buffer"] {
        click_on(&mut window, heading);
        check(&window);
    }
    press_key(&mut window, Modifiers::NONE, Key::V);
    check(&window);
    press_key(&mut window, Modifiers::NONE, Key::V);
    press_key(&mut window, Modifiers::NONE, Key::P);
    let (mut window, _folder) = row(1.0);
    click(&mut window, MIDDLE);
    for heading in ["Section", "cut", "Measure"] {
        click_on(&mut window, heading);
        check(&window);
    }
    // A section is an edit, which would be asked about below.
    press_key(&mut window, Modifiers::NONE, Key::Z);
    for menu in ["File", "Edit", "View", "Tools", "Learn"] {
        click_on(&mut window, menu);
        check(&window);
        press_key(&mut window, Modifiers::NONE, Key::Escape);
    }
    let corner = MIDDLE + egui::vec2(-200.0, -280.0);
    for at in [MIDDLE, corner, control(&window, "back").rect.center()] {
        menus::open_menu(&mut window, at);
        check(&window);
        press_key(&mut window, Modifiers::NONE, Key::Escape);
    }
    press_key(&mut window, Modifiers::NONE, Key::Num4);
    check(&window);
    for stage in ["object", "world", "view", "NDC"] {
        click_on(&mut window, &format!("enlarge {stage}"));
        check(&window);
        click_on(&mut window, &format!("four views beside {stage}"));
    }
    press_key(&mut window, Modifiers::NONE, Key::Num4);
    // More messages than show at once.
    for i in 0..7 {
        window.drop_file(folder.path().join(format!("absent {i}.obj")));
    }
    assert!(has_control(&window, "Dismiss all (2 earlier)"));
    check(&window);
    click_on(&mut window, "Dismiss all (2 earlier)");
    // Help explains keys and mouse: it needs no tooltips itself.
    press_key(&mut window, Modifiers::NONE, Key::H);
    click_on(&mut window, "Take the tour");
    check(&window);
    click_on(&mut window, "end the tour");
    press_key(&mut window, Modifiers::NONE, Key::E);
    check(&window);
    press_key(&mut window, Modifiers::NONE, Key::M);
    click(&mut window, MIDDLE);
    check(&window);
    assert!(silent.is_empty(), "{silent:#?}");
    assert!(count > 1000, "{count}");
}

#[test]
fn what_is_copied_or_saved_is_said_for_a_while() {
    let (mut window, folder) = row(1.0);
    click(&mut window, MIDDLE);
    for (modifiers, key, word) in [
        (Modifiers::NONE, Key::C, "command"),
        (Modifiers::NONE, Key::J, "JSON"),
        (Modifiers::SHIFT, Key::C, "camera"),
    ] {
        press_key(&mut window, modifiers, key);
        assert!(window.messages().any(|text| text.contains(word)), "{word}");
        window.wait_s(5.0);
        assert_eq!(window.messages().count(), 0, "{word} has gone");
    }
    window.save_as(folder.path().join("kept.toml"));
    assert!(window.messages().any(|text| text.contains("kept.toml")));
    window.wait_s(5.0);
    assert_eq!(window.messages().count(), 0);
    // "Nothing to copy" is reported too.
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    press_key(&mut window, Modifiers::NONE, Key::J);
    assert!(window.messages().any(|text| text.contains("no pick")));
}

/// How far from grey a message's text is: 0 for grey, 255 for a pure colour.
fn colourfulness(window: &mut Window) -> u8 {
    window.send([Event::PointerGone]);
    let text = window.messages().next().expect("a message").to_owned();
    let rect = control(window, &text).rect;
    let [left, top] = whole(rect.min);
    let [right, bottom] = whole(rect.max);
    let picture = window.picture().expect("a picture");
    let pixels = (top..bottom).flat_map(|y| (left..right).map(move |x| (x, y)));
    let spread = |[r, g, b]: [u8; 3]| r.max(g).max(b) - r.min(g).min(b);
    let spreads = pixels.map(|(x, y)| spread(picture.at(x, y)));
    spreads.max().expect("a text")
}

/// A message that something was saved has the colour of plain text. A warning has another colour.
#[test]
fn what_is_done_is_no_warning() {
    let (mut window, folder) = row(1.0);
    window.save_as(folder.path().join("kept.toml"));
    let done = colourfulness(&mut window);
    let odd = folder.path().join("odd.obj");
    let text = "mtllib absent.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n";
    std::fs::write(&odd, text).expect("writable");
    window.drop_file(odd);
    assert_eq!(window.state().name(), "odd.obj");
    let warns = colourfulness(&mut window);
    assert!(done < 40 && warns > 90, "{done} {warns}");
}

#[test]
fn f11_fills_the_screen_and_comes_back() {
    let (mut window, _folder) = row(1.0);
    for full in [true, false] {
        press_key(&mut window, Modifiers::NONE, Key::F11);
        assert_eq!(window.is_full_screen(), full);
    }
}

/// Height is along the axis that points up.
#[test]
fn the_size_is_width_height_and_depth() {
    let (mut window, _folder) = row(1.0);
    assert!(has_control(&window, "3 x 3 x 4.5"));
    click_on(&mut window, "z points up");
    assert!(has_control(&window, "3 x 4.5 x 3"));
}
