//! The pick worked out: each number lights up what it is in the picture and in the four views, and each thing there its
//! number.

use super::*;
use glam::DVec3;
use sightline::viewer::model::{WorkedMark, WorkedNumber};

const NONE: Modifiers = Modifiers::NONE;

/// The demo's egg, picked in the four views.
fn one_pick() -> Window {
    let mut window = open(Vec::new(), 1.0);
    click_on(&mut window, "Learn");
    click_on(&mut window, "One pick in four spaces");
    window
}

/// The point of the window where the picture, or one of the four views, shows a point of the world.
fn shown(window: &Window, stage: Option<Stage>, world: DVec3) -> Pos2 {
    let state = window.state();
    let (view, corner) = match stage {
        None => {
            let view = *state.view();
            let half = (view.viewport.size_px() / 2.0).as_vec2();
            (view, MIDDLE - egui::vec2(half.x, half.y))
        }
        Some(stage) => (
            state.pane_view(stage).expect("a view"),
            control(window, &format!("stage {}", stage.name())).rect.min,
        ),
    };
    let at = match stage {
        Some(Stage::Object) => {
            let egg = state.selected().expect("a pick");
            state.scene().objects()[egg]
                .placement
                .point_to_object(world)
        }
        Some(Stage::Ndc) => state.ndc().drawn(world).expect("behind near"),
        _ => world,
    };
    let px = view.project(at).expect("in front").px.as_vec2();
    corner + egui::vec2(px.x, px.y)
}

/// The dot that is a number's only mark.
#[track_caller]
fn dot(window: &Window, number: WorkedNumber) -> DVec3 {
    let steps = window.state().worked_steps();
    let mut rows = steps.into_iter().flat_map(|step| step.rows);
    let row = rows.find(|row| row.number == number).expect("its row");
    match row.marks[..] {
        [WorkedMark::Dot(at)] => at,
        ref marks => panic!("{number:?}: {marks:?}"),
    }
}

/// Points at a row of the inspector.
fn point_at(window: &mut Window, formula: &str) {
    scroll_to(window, formula);
    let at = control(window, formula).rect.center();
    window.send([Event::PointerMoved(at)]);
}

/// The command picks the egg of the demo, shows the four views, and brings its numbers into view.
#[test]
fn one_pick_in_four_spaces_is_one_command() {
    let (mut window, _folder) = row(1.0);
    click_on(&mut window, "Learn");
    click_on(&mut window, "One pick in four spaces");
    let state = window.state();
    assert!(state.is_demo());
    assert_eq!(state.views(), Views::Four);
    let pick = state.picked().expect("a pick");
    assert_eq!(pick.object, "Egg");
    let hits = state.hits().expect("a click");
    assert_eq!(hits.view, *state.view(), "as the views show it");
    let first = control(&window, "(X, Y)").rect;
    assert!(first.top() > 25.0 && first.bottom() < 700.0, "{first:?}");
    // From outside, then through the camera again.
    press_key(&mut window, NONE, Key::T);
    let frozen = window.state().frozen().expect("it stands");
    assert_eq!(frozen.view.camera, hits_camera(&window));
    press_key(&mut window, NONE, Key::T);
    assert_eq!(window.state().view().camera, hits_camera(&window));
}

fn hits_camera(window: &Window) -> sightline::camera::Camera {
    window.state().hits().expect("a click").view.camera
}

/// Each number that is something in the scene changes the views while the cursor rests on its row.
#[test]
fn each_number_lights_up_in_the_views() {
    let mut window = one_pick();
    let rows: Vec<_> = window
        .state()
        .worked_steps()
        .into_iter()
        .flat_map(|step| step.rows)
        .map(|row| (row.number, row.formula, !row.marks.is_empty()))
        .collect();
    assert_eq!(rows.len(), 22, "{rows:?}");
    window.send([Event::PointerGone]);
    let views = Rect::from_min_max(pos2(215.0, 30.0), pos2(960.0, 690.0));
    let before = window.picture().expect("a picture");
    let mut lit = 0;
    for (number, formula, is_something) in rows {
        point_at(&mut window, formula);
        assert_eq!(window.state().worked_number(), Some(number), "{formula}");
        let now = window.picture().expect("a picture");
        let differs = differing_in(&before, &now, views) > 20;
        assert_eq!(differs, is_something, "{formula}");
        lit += usize::from(is_something);
    }
    assert_eq!(lit, 22, "each is something");
    window.send([Event::PointerGone]);
    assert_eq!(window.state().worked_number(), None);
}

/// In all four views, and in the picture while the camera is frozen.
#[test]
fn each_thing_lights_up_its_number() {
    let mut window = one_pick();
    let root = WorkedNumber::Root(1);
    for stage in [Stage::Object, Stage::World, Stage::View, Stage::Ndc] {
        let at = shown(&window, Some(stage), dot(&window, root));
        window.send([Event::PointerMoved(at)]);
        assert_eq!(window.state().worked_number(), Some(root), "{stage:?}");
    }
    press_key(&mut window, NONE, Key::T);
    for number in [root, WorkedNumber::PlanePoint, WorkedNumber::Middle] {
        let at = shown(&window, None, dot(&window, number));
        window.send([Event::PointerMoved(at)]);
        assert_eq!(window.state().worked_number(), Some(number));
    }
    window.send([Event::PointerMoved(pos2(300.0, 60.0))]);
    assert_eq!(window.state().worked_number(), None, "nothing is there");
}

/// Where the click was made, the marks would lie over each other and over the pick: only the lit one shows.
#[test]
fn in_its_own_view_a_pick_is_not_written_over() {
    let (mut window, _folder) = row(1.0);
    click(&mut window, MIDDLE);
    window.send([Event::PointerGone]);
    let before = window.picture().expect("a picture");
    click_under(&mut window, "Worked out", "t0: the last entry, into z");
    window.send([Event::PointerGone]);
    let around = Rect::from_center_size(MIDDLE, egui::vec2(500.0, 500.0));
    let after = window.picture().expect("a picture");
    assert_eq!(differing_in(&before, &after, around), 0);
    point_at(&mut window, "t0: the last entry, into z");
    let lit = window.picture().expect("a picture");
    assert!(differing_in(&before, &lit, around) > 20);
}

/// Without a pick it says what to do, and a panel of the least width holds all rows.
#[test]
fn a_narrow_panel_holds_it() {
    let mut window = open(Vec::new(), 1.0);
    window.resize(px([640, 1400], 1.0));
    if !has_control(&window, "Worked out") {
        click_on(&mut window, "right side");
    }
    click_on(&mut window, "Worked out");
    assert!(has_control(&window, "Nothing is picked: click a surface."));
    let middle = window.state().view().viewport.size_px() / 2.0;
    let middle = middle.as_vec2();
    let at = pos2(100.0, 30.0) + egui::vec2(middle.x, middle.y);
    click(&mut window, at);
    let formulas: Vec<_> = window
        .state()
        .worked_steps()
        .into_iter()
        .flat_map(|step| step.rows)
        .map(|row| row.formula)
        .collect();
    assert!(!formulas.is_empty(), "something is picked");
    for formula in formulas {
        let rect = control(&window, formula).rect;
        assert!(
            rect.right() <= 640.0 && rect.height() > 8.0,
            "{formula}: {rect:?}"
        );
    }
}
