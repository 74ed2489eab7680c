//! Doing what the words of a tour's step ask for completes the step, and doing other things does not.

use super::*;
use sightline::{camera::Projection, pick, study::swap::Found};

/// A step's first words, and what they ask for.
type Deed = (&'static str, fn(&mut Window));

const NONE: Modifiers = Modifiers::NONE;

const DEEDS: [Deed; 22] = [
    ("Drag over the picture", turn),
    ("Drag again and watch V", turn),
    ("Under Camera set fov", |window| {
        for (field, value) in [("fov", "90"), ("near", "1"), ("far", "10")] {
            set(window, field, value);
        }
        click_under(window, "Depth buffer", "standard");
    }),
    ("Press 5: orthographic", |window| {
        press_key(window, NONE, Key::Num5);
    }),
    ("Press 5 again", |window| {
        press_key(window, NONE, Key::Num5);
        press_key(window, NONE, Key::Enter);
    }),
    ("In the field near type", |window| {
        set(window, "near", "9.5");
    }),
    ("Check fit beside near", |window| {
        click_on(window, "fit near");
    }),
    ("Click the egg. A ring", |window| {
        click_object(window, "Egg");
    }),
    ("Press T: the view steps back", |window| {
        press_key(window, NONE, Key::T);
        turn(window);
    }),
    ("Click the egg, and then", |window| {
        let at = place_of(window, "Egg");
        click(window, at);
        window.wait_s(1.0);
        click(window, at);
    }),
    ("Click the blue box", |window| {
        click_object(window, "Leaning box");
    }),
    ("Click the ground", |window| click_object(window, "Ground")),
    ("Click the ring", |window| {
        window.wait_s(1.0);
        let at = place_of(window, "Ring");
        click(window, at);
        window.send([Event::MouseWheel {
            unit: egui::MouseWheelUnit::Line,
            source: egui::MouseWheelSource::Unknown,
            delta: egui::vec2(0.0, 3.0),
            phase: egui::TouchPhase::Move,
            modifiers: NONE,
        }]);
    }),
    ("Press 4: object, world", |window| {
        press_key(window, NONE, Key::Num4);
    }),
    ("Double click the heading", |window| {
        let at = control(window, "stage NDC").rect.right_center();
        double_click(window, at - egui::vec2(9.0, 0.0));
    }),
    ("Press 4 again", |window| {
        press_key(window, NONE, Key::Num4);
    }),
    ("Set near to 0.001", |window| {
        set(window, "near", "0.001");
        click_under(window, "Depth buffer", "standard");
        click_object(window, "Tower");
        scroll_to(window, "reversed step");
    }),
    ("Set depth to reversed", |window| {
        click_on(window, "reversed");
    }),
    ("Press E for the failure gallery", |window| {
        press_key(window, NONE, Key::E);
        press_key(window, NONE, Key::M);
        let view = *window.state().view();
        let method = window.state().method().expect("another method picks");
        let scene = window.state().scene().clone();
        let is_wrong = |px: DVec2| {
            let theirs = method.pick(&scene, &view, px);
            let triangle = |found: &Found| found.hit.hit.on_triangle.map(|at| at.triangle);
            let ours = Found::sightlines(&scene, &view, px);
            theirs.as_ref().and_then(triangle) != ours.as_ref().and_then(triangle)
        };
        let at = place_where(window, is_wrong);
        click(window, at);
    }),
    ("Press Escape until", |window| {
        for _ in 0..3 {
            press_key(window, NONE, Key::Escape);
        }
    }),
    ("Press V", |window| {
        press_key(window, NONE, Key::V);
        window.picture().expect("a picture");
    }),
    ("Click anything", |window| {
        click_object(window, "Egg");
        press_key(window, NONE, Key::C);
    }),
];

fn turn(window: &mut Window) {
    let at = place_where(window, |_| true);
    drag(
        window,
        PointerButton::Primary,
        at,
        at + egui::vec2(25.0, 5.0),
    );
}

fn set(window: &mut Window, field: &str, value: &str) {
    scroll_to(window, field);
    type_into(window, field, value);
    press_key(window, NONE, Key::Enter);
}

fn click_object(window: &mut Window, name: &str) {
    window.wait_s(1.0);
    let at = place_of(window, name);
    click(window, at);
}

/// A point of the window where an object is seen.
fn place_of(window: &mut Window, name: &str) -> Pos2 {
    let (scene, view) = (window.state().scene().clone(), *window.state().view());
    place_where(window, |px| {
        // Thousands of places: a whole record of each would take seconds.
        let hit = pick::closest(&scene, view.ray(px), view.sides);
        hit.is_some_and(|hit| scene.objects()[hit.object].name == name)
    })
}

/// The middle one of the places beside the card whose pixel meets a condition.
fn place_where(window: &mut Window, is_it: impl Fn(DVec2) -> bool) -> Pos2 {
    let card = control(window, &task(window).expect("a step")).rect;
    window.send([Event::PointerMoved(MIDDLE)]);
    let px = window.state().cursor().expect("the picture's middle").px;
    let size = window.state().view().viewport.size_px();
    let to_point = |at: DVec2| {
        let by = (at - px).as_vec2();
        MIDDLE + egui::vec2(by.x, by.y)
    };
    let is_beside = |at: Pos2| at.x > card.right() + 40.0 || at.y < card.top() - 50.0;
    let along = |side: f64| {
        (4..)
            .map(|i| 3.0 * f64::from(i) + 0.5)
            .take_while(move |at| *at < side - 12.0)
    };
    let all = along(size.y).flat_map(|y| along(size.x).map(move |x| DVec2::new(x, y)));
    let such: Vec<Pos2> = all
        .filter(|&at| is_beside(to_point(at)) && is_it(at))
        .map(to_point)
        .collect();
    *such
        .get(such.len() / 2)
        .expect("a place for it beside the card")
}

/// The card's text.
fn task(window: &Window) -> Option<String> {
    let asks = |name: &&String| DEEDS.iter().any(|(words, _)| name.starts_with(words));
    let mut names = window.controls().iter().map(|control| &control.name);
    names.find(asks).cloned()
}

fn tour() -> Window {
    let options = Options {
        tour: true,
        ..Options::default()
    };
    Window::open(options, px(SIZE, 1.0), 1.0)
}

#[test]
fn each_step_can_be_done_and_is_noticed_only_then() {
    let mut window = tour();
    for (at, (words, deed)) in DEEDS.into_iter().enumerate() {
        let asked = task(&window).expect("a step");
        assert!(asked.starts_with(words), "{words:?}: {asked:?}");
        let place = format!("step {} of {}", at + 1, DEEDS.len());
        assert!(has_control(&window, &place), "{place}");
        // Other actions do not complete the step.
        press_key(&mut window, NONE, Key::G);
        window.send([Event::PointerMoved(MIDDLE)]);
        assert!(!has_control(&window, "step done"), "{words}");
        assert!(has_control(&window, "skip"), "{words}");
        deed(&mut window);
        assert!(has_control(&window, "step done"), "{words}");
        let next = if at + 1 < DEEDS.len() {
            "next"
        } else {
            "finish"
        };
        click_on(&mut window, next);
    }
    assert_eq!(task(&window), None, "the tour is over");
}

/// This holds in the picture and in the four views, in large and small windows, and after resizing.
#[test]
fn the_step_lies_over_no_view_and_follows_the_window() {
    let (mut window, mut widths) = (tour(), Vec::new());
    for size in [SIZE, [640, 400], [800, 600], [1600, 1000], SIZE] {
        window.resize(px(size, 1.0));
        let [width, height] = size.map(f64::from);
        let picture = *window.state().view();
        let mut first = None;
        for _ in 0..DEEDS.len() {
            // Most steps begin in the picture.
            match window.state().views() {
                Views::Picture => press_key(&mut window, NONE, Key::Num4),
                Views::One(_) => click_on(&mut window, "four views beside NDC"),
                Views::Four => {}
            }
            let words = task(&window).expect("a step");
            let last = DEEDS
                .last()
                .is_some_and(|(last, _)| words.starts_with(last));
            let go = ["skip", "next", if last { "finish" } else { "next" }];
            let go = go.into_iter().find(|name| has_control(&window, name));
            let go = go.expect("a way on");
            let of_step = [words.as_str(), go, "back", "end the tour"];
            let step = of_step.map(|name| control(&window, name).rect);
            let panes = ["object", "world", "view", "NDC"];
            let panes = panes.map(|name| control(&window, &format!("stage {name}")).rect);
            for part in step {
                assert!(
                    panes.iter().all(|pane| !pane.intersects(part)),
                    "{size:?}: {part:?} over {panes:?}"
                );
                let [right, bottom] = [part.right(), part.bottom()].map(f64::from);
                assert!(
                    right <= width && bottom <= height && part.top() > 0.0,
                    "{size:?}"
                );
            }
            let lowest = panes.iter().map(egui::Rect::bottom).fold(0.0, f32::max);
            let highest = step
                .iter()
                .map(egui::Rect::top)
                .fold(f32::INFINITY, f32::min);
            assert!(highest >= lowest, "{size:?}: below all that stands above");
            assert!(panes.iter().all(|pane| pane.height() > 70.0), "{panes:?}");
            // Nothing moves from one step to the next.
            assert_eq!(*first.get_or_insert(panes), panes, "{size:?} {words}");
            click_on(&mut window, go);
            if task(&window).is_none() {
                press_key(&mut window, NONE, Key::H);
                click_on(&mut window, "Take the tour");
                if has_control(&window, "Take the tour") {
                    press_key(&mut window, NONE, Key::H);
                }
            }
        }
        press_key(&mut window, NONE, Key::Num4);
        assert_eq!(window.state().view().viewport, picture.viewport);
        let share = picture.viewport.size_px().element_product() / (width * height);
        assert!(
            share >= 0.38,
            "{size:?}: the picture has {share} of the window"
        );
        widths.push((size, picture.viewport.width()));
    }
    click_on(&mut window, "end the tour");
    assert_eq!(task(&window), None);
    // The sides are as wide as with the tour.
    for (size, width) in widths {
        window.resize(px(size, 1.0));
        assert_eq!(window.state().view().viewport.width(), width, "{size:?}");
    }
}

#[test]
fn steps_are_skipped_and_gone_back_to() {
    let mut window = tour();
    let first = task(&window);
    assert!(!control(&window, "back").is_enabled);
    for _ in 1..DEEDS.len() {
        click_on(&mut window, "skip");
    }
    assert!(task(&window).is_some_and(|last| last.starts_with(DEEDS[DEEDS.len() - 1].0)));
    for _ in 1..DEEDS.len() {
        click_on(&mut window, "back");
    }
    assert_eq!(task(&window), first);
}

/// The expected numbers are computed by hand for n = 1, f = 10 and 90 degrees. The aspect and the orthographic height
/// are the window's.
#[test]
fn the_card_works_out_the_lectures_points() {
    let mut window = tour();
    for _ in 0..2 {
        click_on(&mut window, "skip");
    }
    DEEDS[2].1(&mut window);
    let aspect = window.state().view().viewport.aspect();
    let says = |window: &Window, words: &str| {
        let mut names = window.controls().iter().map(|control| &control.name);
        assert!(names.any(|name| name.starts_with(words)), "{words}");
    };
    let x = -0.5 / aspect;
    says(
        &window,
        &format!("Now: (-1, 1.5, 2) maps to ({x:.4}, 0.7500, 0.5556)"),
    );
    click_on(&mut window, "next");
    press_key(&mut window, NONE, Key::Num5);
    let Projection::Orthographic { height } = window.state().view().camera.lens().projection else {
        panic!("orthographic");
    };
    let (x, y) = (-2.0 / (0.5 * height * aspect), 5.0 / (0.5 * height));
    says(
        &window,
        &format!("Now: (-2, 5, 0.5) maps to ({x:.4}, {y:.4}, -0.0556)"),
    );
    // The height that the text speaks of.
    type_into(&mut window, "height", "20");
    press_key(&mut window, NONE, Key::Enter);
    let x = -0.2 / aspect;
    says(
        &window,
        &format!("Now: (-2, 5, 0.5) maps to ({x:.4}, 0.5000, -0.0556)"),
    );
}

/// The points that the lecture works out are drawn where they are, in the picture and in the views.
#[test]
fn the_lectures_points_are_drawn() {
    let mut window = tour();
    assert!(window.state().example().is_none());
    for _ in 0..2 {
        click_on(&mut window, "skip");
    }
    DEEDS[2].1(&mut window);
    let state = window.state();
    let example = state.example().expect("a point");
    let seen = state.view().project(example.world).expect("in front");
    assert!((seen.depth - 2.0).abs() < 1e-12);
    assert!((seen.ndc - example.ndc).abs().max_element() < 1e-12);
    let half = (state.view().viewport.size_px() / 2.0).as_vec2();
    let by = seen.px.as_vec2() - half;
    let middle = pos2(MIDDLE.x, 25.0 + half.y);
    let around = Rect::from_center_size(middle + egui::vec2(by.x, by.y), egui::Vec2::splat(30.0));
    window.send([Event::PointerGone]);
    let with = window.picture().expect("a picture");
    click_on(&mut window, "end the tour");
    window.send([Event::PointerGone]);
    assert!(window.state().example().is_none());
    let without = window.picture().expect("a picture");
    assert!(differing_in(&with, &without, around) > 50);
}

/// Whatever was done in a step, the next one begins with the view that the scene opened with, and the egg picked.
#[test]
fn a_step_begins_from_a_known_state() {
    let mut window = tour();
    let known = |window: &Window| {
        let state = window.state();
        let picked = state.picked().map(|pick| pick.object.clone());
        (state.views(), state.view().camera, picked)
    };
    click_on(&mut window, "skip");
    let begun = known(&window);
    assert_eq!(begun.2.as_deref(), Some("Egg"));
    let hits = window.state().hits().expect("a pick");
    assert_eq!(hits.view, *window.state().view(), "picked as it is shown");
    // Measuring, a section, a frozen camera, the four views and another lens: all are gone with the next step.
    for key in [Key::Q, Key::Z, Key::T, Key::Num4, Key::Num5, Key::Num1] {
        press_key(&mut window, NONE, key);
    }
    let at = pos2(500.0, 300.0);
    drag(
        &mut window,
        PointerButton::Primary,
        at,
        at + egui::vec2(40.0, 9.0),
    );
    click_on(&mut window, "back");
    click_on(&mut window, "skip");
    assert_eq!(known(&window), begun);
    let state = window.state();
    assert!(state.frozen().is_none() && !state.measuring().is_on);
    assert_eq!(state.view().section, None);
}

/// Over another scene, Help opens the demo and the tour in it.
#[test]
fn help_opens_it_in_the_demo() {
    let (mut window, _folder) = row(1.0);
    press_key(&mut window, NONE, Key::H);
    click_on(&mut window, "Take the tour");
    assert!(task(&window).is_some());
    assert!(window.state().is_demo());
    assert!(!has_control(&window, "open the demo"));
}

#[test]
fn somebody_new_is_offered_it_until_they_answer() {
    let folder = tempfile::tempdir().expect("a folder");
    let open = || {
        let options = Options {
            memory: Some(folder.path().join("window.toml")),
            ..Options::default()
        };
        Window::open(options, px(SIZE, 1.0), 1.0)
    };
    let mut window = open();
    // The offer would lie over the four views.
    press_key(&mut window, NONE, Key::Num4);
    assert!(!has_control(&window, "no tour"));
    press_key(&mut window, NONE, Key::Num4);
    assert!(has_control(&window, "Open a file..."));
    // Having seen a pick, one may want the tour.
    click_on(&mut window, "One pick in four spaces");
    assert_eq!(window.state().views(), Views::Four);
    press_key(&mut window, NONE, Key::Num4);
    assert!(has_control(&window, "Take the tour"));
    click_on(&mut window, "no tour");
    assert!(!has_control(&window, "Take the tour"));
    window.close();
    let window = open();
    assert!(!has_control(&window, "Take the tour"), "it is remembered");
}

/// In the four views a drag does not do what the step asks for in the picture, and the step's card says so.
#[test]
fn in_the_four_views_steps_of_the_picture_say_where_to_go() {
    let mut window = tour();
    let says = |window: &Window| {
        let controls = window.controls().iter();
        controls
            .filter(|control| control.name.contains("press 4 for the picture first"))
            .count()
    };
    assert_eq!(says(&window), 0);
    press_key(&mut window, NONE, Key::Num4);
    assert_eq!(says(&window), 1);
}

/// `cargo run` installs nothing, so the step that says to paste a command also says how to install `sightline`.
#[test]
fn the_step_of_the_command_says_how_to_install_it() {
    let mut window = tour();
    for _ in 1..DEEDS.len() {
        click_on(&mut window, "skip");
    }
    let words = task(&window).expect("the last step");
    assert!(words.contains("paste the command"), "{words}");
    assert!(
        words.contains("cargo install --path . installs sightline"),
        "{words}"
    );
    DEEDS[DEEDS.len() - 1].1(&mut window);
    let command = window.copied().expect("a command");
    assert!(command.starts_with("sightline pick "), "{command}");
}
