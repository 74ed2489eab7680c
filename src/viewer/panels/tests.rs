//! The panels without a window: what they say, and what keys ask for.

use super::{Filter, Floating, Shown, Statistics, show};
use crate::{
    camera::{CameraChoice, Viewport},
    geometry::Sides,
    scene::{self, Progress},
    study::gallery::BREAKS,
    viewer::{Command, Notices, action::Action, check::Checking, keys::BINDINGS, state::State},
};
use egui::{Event, Key, Modifiers, RawInput, Rect, Shape, pos2, vec2};

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
                loading: None,
                floating: Floating::default(),
                chart: None,
                checking: &Checking::Off,
                statistics: &Statistics::default(),
                filter: &mut Filter::default(),
                reveal_selection: false,
            };
            commands.extend(show(ui, &mut shown, &mut None).1);
        });
        // egui minds when nobody takes its textures.
        output.textures_delta.clear();
        output.shapes
    };
    // The first pass only finds out how large things are.
    run(Vec::new());
    let shapes = run(events);
    let mut texts = Vec::new();
    for clipped in &shapes {
        collect(&clipped.shape, &mut texts);
    }
    (texts.join("\n"), commands)
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
    for binding in BINDINGS {
        let expected = (binding.command)(&state);
        for (modifiers, key) in binding.shortcuts {
            let modifiers = Modifiers {
                ctrl: modifiers.command,
                ..*modifiers
            };
            let (_, asked) = pass(&state, vec![press(*key, modifiers)]);
            let asked: Vec<_> = asked.into_iter().filter(idle).collect();
            assert_eq!(
                asked,
                std::slice::from_ref(&expected),
                "{key:?} with {modifiers:?}"
            );
        }
    }
}
