//! The panels without a window: what they say, and what keys ask for.

use super::{
    arrangement::Arrangement,
    field::{short, short_in},
    inspector::Sums,
    layout::show,
    objects::Filter,
    shown::Shown,
    status::{self, Statistics},
};
use crate::{
    camera::{CameraChoice, Viewport},
    geometry::Sides,
    scene::{self, Progress},
    study::breaks::BREAKS,
    viewer::{
        jobs::Checking,
        model::{Action, Overlay, State},
        ui::{
            command::Command,
            menus::{SHORTCUTS, items},
            notice::Notices,
            theme::{self, Look},
        },
    },
};
use egui::{Event, Key, Modifiers, RawInput, Rect, Shape, epaint::ClippedShape, pos2, vec2};
use glam::{DVec2, dvec2};
use std::{collections::BTreeSet, time::Duration};

fn opened(path: &str) -> State {
    let loaded = scene::load(&[path.into()], &Progress::default()).expect("a scene");
    let viewport = Viewport::new(549, 670).expect("a viewport");
    State::new(loaded, CameraChoice::default(), viewport, Sides::Both).expect("a camera")
}

/// One pass over the panels: every text that they show, and what they ask for.
fn pass(state: &State, events: Vec<Event>) -> (String, Vec<Command>) {
    let context = egui::Context::default();
    let screen_rect = Some(Rect::from_min_size(pos2(0.0, 0.0), vec2(1280.0, 720.0)));
    let mut commands = Vec::new();
    let mut run = |events| {
        let input = RawInput {
            screen_rect,
            events,
            ..RawInput::default()
        };
        let mut output = context.run_ui(input, |ui| {
            let mut shown = Shown {
                state,
                notices: &mut Notices::new(),
                underway: None,
                shot: None,
                tour: None,
                offers_tour: false,
                helps: false,
                question: None,
                chart: None,
                checking: &Checking::Off,
                marks: None,
                statistics: &Statistics::default(),
                arrangement: &mut Arrangement::default(),
                recent: &[],
                look: Look::default(),
                sums: &mut Sums::default(),
                filter: &mut Filter::default(),
                is_bare: false,
                reveal_selection: false,
            };
            commands.extend(show(ui, &mut shown, &mut None).commands);
        });
        // egui complains if its textures are not taken.
        output.textures_delta.clear();
        output.shapes
    };
    // The first pass only finds out how large things are.
    run(Vec::new());
    let shapes = run(events);
    (texts(&shapes).join("\n"), commands)
}

/// egui as the viewer wants it.
fn dressed() -> egui::Context {
    let context = egui::Context::default();
    theme::dress(&context);
    context
}

/// What the status line shows in a first pass.
fn status_line(state: &State, statistics: &Statistics, input: RawInput) -> Vec<ClippedShape> {
    let context = dressed();
    let mut output = context.run_ui(input, |ui| status::show(ui, state, statistics));
    output.textures_delta.clear();
    output.shapes
}

fn texts(shapes: &[ClippedShape]) -> Vec<String> {
    let mut texts = Vec::new();
    for clipped in shapes {
        collect(&clipped.shape, &mut texts);
    }
    texts
}

fn collect(shape: &Shape, texts: &mut Vec<String>) {
    match shape {
        Shape::Text(text) => texts.push(text.galley.text().to_owned()),
        Shape::Vec(shapes) => shapes.iter().for_each(|shape| collect(shape, texts)),
        _ => {}
    }
}

fn press(key: Key, modifiers: Modifiers) -> Event {
    Event::Key {
        key,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers,
    }
}

#[test]
fn another_method_is_under_a_banner_and_the_default_is_not() {
    const BANNER: &str = "Not the default: another method picks";
    for broken in &BREAKS {
        let mut state = opened(&format!("gallery:{}", broken.exhibit));
        assert!(!pass(&state, Vec::new()).0.contains(BANNER));
        state.apply(Action::PickBy(broken.swap()));
        let (texts, _) = pass(&state, Vec::new());
        let method = format!(
            "{}: {}, {}",
            broken.step.about.name, broken.method, broken.precision
        );
        assert!(texts.contains(BANNER), "{texts}");
        assert!(texts.matches(&method).count() >= 2, "{method} in\n{texts}");
        assert!(texts.contains("back (Esc)"), "{texts}");
        state.apply(Action::PickBy(None));
        assert!(!pass(&state, Vec::new()).0.contains(BANNER));
    }
}

#[test]
fn each_key_asks_for_what_its_line_says() {
    let state = opened("gallery:needles");
    let idle =
        |command: &Command| !matches!(command, Command::Act(Action::Resize(_) | Action::Hover(_)));
    for ((modifiers, key), command) in SHORTCUTS.iter() {
        let modifiers = Modifiers {
            ctrl: modifiers.command,
            ..*modifiers
        };
        let (_, asked) = pass(&state, vec![press(*key, modifiers)]);
        let asked: Vec<_> = asked.into_iter().filter(idle).collect();
        let expected = std::slice::from_ref(*command);
        assert_eq!(asked, expected, "{key:?} with {modifiers:?}");
    }
}

#[test]
fn a_key_that_was_pressed_twice_within_a_frame_is_done_twice() {
    for key in [Key::B, Key::Num5, Key::G] {
        let mut state = opened("gallery:needles");
        let shows = |state: &State| (state.view().sides, state.controls(), state.overlays());
        let before = shows(&state);
        let twice = vec![press(key, Modifiers::NONE); 2];
        for command in pass(&state, twice).1 {
            if let Command::Act(action) = command {
                state.apply(action);
            }
        }
        assert_eq!(shows(&state), before, "{key:?}");
    }
}

#[test]
fn what_a_click_was_compared_with_is_marked_only_in_its_own_picture() {
    let mut state = opened("gallery:small_and_far");
    state.apply(Action::NextMethod { forward: true });
    state.apply(Action::Click(DVec2::new(30.0, 300.0), 0.0));
    let is_marked = |state: &State| pass(state, Vec::new()).0.contains("picked: ");
    assert!(is_marked(&state));
    state.apply(Action::Turn(DVec2::new(40.0, 0.0)));
    assert!(!is_marked(&state));
    state.apply(Action::Click(DVec2::new(30.0, 300.0), 9.0));
    assert!(is_marked(&state));
}

/// The corners of the picked triangle have names where the picture shows them, and nowhere else.
#[test]
fn corners_outside_the_picture_have_no_names() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("one.obj");
    let text = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";
    std::fs::write(&path, text).expect("writable");
    let mut state = opened(&path.display().to_string());
    let middle = state.view().viewport.size_px() / 2.0;
    state.apply(Action::Click(middle, 0.0));
    if !state.overlays().shows(Overlay::Triangle) {
        state.apply(Action::Toggle(Overlay::Triangle));
    }
    let names = |state: &State| {
        let text = pass(state, Vec::new()).0;
        ["v1 0.", "v2 0.", "v3 0."].map(|name| text.contains(name))
    };
    assert_eq!(names(&state), [true; 3]);
    state.apply(Action::Zoom(middle, 6.0));
    assert_eq!(names(&state), [false; 3]);
}

/// Where both are of one object, the labels of a wrong pick name the triangles.
#[test]
fn a_wrong_triangle_is_named() {
    let mut state = opened("gallery:far_facets");
    let mut text = None;
    while text.is_none() {
        state.apply(Action::NextMethod { forward: true });
        assert!(state.method().is_some(), "a method picks a wrong triangle");
        let view = *state.view();
        let step = view.viewport.size_px() / 60.0;
        let places = (0..3600).map(|i| {
            let at = DVec2::new(f64::from(i % 60), f64::from(i / 60));
            (at + 0.5) * step
        });
        for px in places {
            state.apply(Action::Click(px, 0.0));
            let compared = state.showing().and_then(|showing| showing.compared);
            let of = compared.map(|compared| {
                [compared.theirs, compared.ours].map(|found| {
                    let found = found?;
                    Some((found.hit.object, found.hit.hit.on_triangle?.triangle))
                })
            });
            if let Some([Some((object, picked)), Some((other, drawn))]) = of
                && object == other
                && picked != drawn
            {
                let name = &state.scene().objects()[object].name;
                let lines = [("picked", picked), ("drawn", drawn)];
                let lines =
                    lines.map(|(what, triangle)| format!("{what}: triangle {triangle} of {name}"));
                text = Some((pass(&state, Vec::new()).0, lines));
                break;
            }
        }
    }
    let (text, lines) = text.expect("found");
    for line in lines {
        assert!(text.contains(&line), "{line}: {text}");
    }
}

/// Drawing on the processor is nothing to warn about.
#[test]
fn software_is_said_in_the_colour_of_text() {
    let state = opened("gallery:needles");
    let statistics = Statistics {
        software: true,
        ..Statistics::default()
    };
    let shapes = status_line(&state, &statistics, RawInput::default());
    let warns = dressed().global_style().visuals.warn_fg_color;
    let colour = |shape: &Shape| match shape {
        Shape::Text(text) if text.galley.text() == "software" => {
            let own = text.galley.job.sections[0].format.color;
            Some([Some(own), text.override_text_color])
        }
        _ => None,
    };
    let colours = shapes.iter().find_map(|clipped| colour(&clipped.shape));
    let colours = colours.expect("the word");
    assert!(!colours.contains(&Some(warns)), "{colours:?}");
}

/// In the smallest window the status line is cut, but not the name of what is under the cursor.
#[test]
fn what_is_under_the_cursor_is_named_in_the_smallest_window() {
    let mut state = opened("gallery:needles");
    state.apply(Action::Hover(Some(dvec2(274.5, 335.5))));
    let hovered = state.hover().expect("a hit in the middle");
    let statistics = Statistics {
        adapter: "an adapter with a long name of its own, and its driver's".into(),
        pick: Some(Duration::from_millis(1)),
        software: true,
        ..Statistics::default()
    };
    let window = Rect::from_min_size(pos2(0.0, 0.0), vec2(640.0, 400.0));
    let input = RawInput {
        screen_rect: Some(window),
        ..RawInput::default()
    };
    let shapes = status_line(&state, &statistics, input);
    let name = &state.scene().objects()[hovered].name;
    let is_named = |clipped: &ClippedShape| match &clipped.shape {
        Shape::Text(text) if text.galley.text() == name => {
            let place = text.visual_bounding_rect();
            clipped.clip_rect.contains_rect(place) && window.contains_rect(place)
        }
        _ => false,
    };
    assert!(shapes.iter().any(is_named), "{name}");
}

/// How long a picture took is said for a while, and no longer once nothing moves.
#[test]
fn an_old_frame_time_does_not_stay() {
    let state = opened("gallery:needles");
    let statistics = Statistics {
        frame: Some((Duration::from_millis(4818), 10.0)),
        ..Statistics::default()
    };
    for (now_s, is_said) in [(10.0, true), (12.0, true), (14.0, false), (1e5, false)] {
        let input = RawInput {
            time: Some(now_s),
            ..RawInput::default()
        };
        let texts = texts(&status_line(&state, &statistics, input));
        let last = texts.last().expect("a text");
        // Nothing stands after it, so nothing moves as it goes.
        assert_eq!(last.starts_with("frame 4818"), is_said, "{now_s}: {last}");
        assert!(texts.len() > 1, "{texts:?}");
    }
}

#[test]
fn short_numbers_read_as_the_number() {
    let numbers = [
        (0.0, "0"),
        (-0.5, "-0.5"),
        (1_234.567_89, "1234.57"),
        (1e-7, "1e-7"),
        (-2.5e12, "-2.5e12"),
        (f64::INFINITY, "inf"),
        (f64::NEG_INFINITY, "-inf"),
        (f64::NAN, "NaN"),
    ];
    for (number, text) in numbers {
        assert_eq!(short(number), text);
    }
}

/// Numbers in columns never need more room than their column has.
#[test]
fn a_number_has_room_in_its_column() {
    let mantissas = [1.0, 1.234_567_89, 5.5, 9.999_999_9];
    for most in 6..=9 {
        for exponent in -320..=308 {
            for mantissa in mantissas.into_iter().flat_map(|m| [m, -m]) {
                let value: f64 = format!("{mantissa}e{exponent}").parse().expect("a number");
                let text = short_in(value, most);
                assert!(text.len() <= most, "{value:e} in {most}: {text}");
                let read: f64 = text.parse().expect("a number");
                let is_near = (read - value).abs() <= 0.5 * value.abs();
                let is_nothing = text == "0" && value.abs() < 1e-99;
                let is_right = is_near || is_nothing || !value.is_finite();
                assert!(is_right, "{value:e} in {most}: {text}");
            }
        }
    }
    for (value, most, text) in [
        (-0.001_234, 6, "-0.001"),
        (0.001_234, 7, "0.00123"),
        (-0.000_952_597, 8, "-0.00095"),
        (-1_234_567.0, 8, "-1234567"),
        (-1_234_567.0, 7, "-1.23e6"),
        (1e-300, 6, "1e-300"),
        (-1e-300, 6, "0"),
        (f64::NEG_INFINITY, 6, "-inf"),
    ] {
        assert_eq!(short_in(value, most), text);
    }
}

/// No key asks for two things, and no two items have one name.
#[test]
fn keys_and_names_are_each_about_one_thing() {
    let keys: BTreeSet<_> = SHORTCUTS
        .iter()
        .map(|(shortcut, _)| format!("{shortcut:?}"))
        .collect();
    assert_eq!(keys.len(), SHORTCUTS.len());
    let names: BTreeSet<_> = items().map(|item| item.name).collect();
    assert_eq!(names.len(), items().count());
    assert!(names.len() > 40, "{}", names.len());
}
