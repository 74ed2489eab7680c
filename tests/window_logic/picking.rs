//! A click selects what its pixel shows, the same pixel again selects the surface behind, and hidden objects are not
//! picked.

use super::*;

#[test]
fn a_click_selects_and_a_click_beside_selects_nothing() {
    let mut state = front_view();
    let line = state
        .apply(Action::Click(MIDDLE, 0.0))
        .expect("a click answers");
    assert_eq!(line.px, MIDDLE + 0.5, "the pixel's centre is picked");
    assert_eq!(line.hit.as_ref().expect("a hit").object, "front");
    assert_eq!(selected(&state), Some("front"));
    let line = state
        .apply(Action::Click(DVec2::new(3.0, 3.0), 1.0))
        .expect("a click answers");
    assert_eq!((line.hit, selected(&state)), (None, None));
}

fn side(state: &State) -> (String, bool) {
    let hit = state.picked().expect("a hit");
    (hit.object.clone(), hit.front)
}

#[test]
fn the_same_pixel_again_goes_behind_but_a_double_click_does_not() {
    let mut state = front_view();
    let mut time = 0.0;
    let mut seen = Vec::new();
    for _ in 0..6 {
        state.apply(Action::Click(MIDDLE, time));
        seen.push(side(&state));
        time += 10.0;
    }
    // The ray goes in and out of the cube, in and out of the sphere, through the square, and starts again.
    let expected = [
        ("front", true),
        ("front", false),
        ("middle", true),
        ("middle", false),
        ("back", true),
        ("front", true),
    ];
    assert_eq!(seen, expected.map(|(name, front)| (name.to_owned(), front)));
    for led_to in [("front", false), ("front", false)] {
        state.apply(Action::Click(MIDDLE, time));
        assert_eq!(side(&state), (led_to.0.to_owned(), led_to.1));
        state.apply(Action::Click(MIDDLE + 0.25, time + 0.5 * DOUBLE_CLICK_S));
        assert_eq!(side(&state), ("front".to_owned(), true), "the front again");
        time += 10.0;
    }
    state.apply(Action::Click(MIDDLE + DVec2::X, time));
    assert_eq!(selected(&state), Some("front"), "another pixel starts anew");
}

#[test]
fn the_same_pixel_of_another_picture_starts_anew() {
    let looks = front_view().controls();
    for between in [
        Action::Zoom(MIDDLE, 1.1),
        Action::Turn(DVec2::new(5.0, 3.0)),
        Action::Pan(DVec2::new(4.0, 0.0)),
        Action::LookFrom(DVec3::NEG_Z),
        Action::FrameSelection,
        Action::Lens(LensControls {
            orthographic: true,
            ..looks
        }),
        Action::Camera(CameraChoice {
            eye: Some(DVec3::new(0.0, 0.0, 9.0)),
            target: Some(DVec3::ZERO),
            ..CameraChoice::default()
        }),
        Action::ToggleSides,
        Action::Resize(Viewport::new(802, 602).expect("a viewport")),
        Action::HideSelection,
        Action::SetVisible(1, false),
    ] {
        let mut state = front_view();
        state.apply(Action::Click(MIDDLE, 0.0));
        state.apply(between);
        let seen = pick::pick(state.scene(), state.view(), MIDDLE + 0.5);
        let line = state.apply(Action::Click(MIDDLE, 9.0)).expect("an answer");
        assert_eq!(line.hit, seen, "{between:?}");
    }
}

#[test]
fn hidden_is_not_picked_and_shown_is_again() {
    let mut state = front_view();
    state.apply(Action::Click(MIDDLE, 0.0));
    state.apply(Action::HideSelection);
    assert_eq!(state.selection(), None);
    let line = state.apply(Action::Click(MIDDLE, 1.0)).expect("an answer");
    let hit = line.hit.expect("what stood behind");
    assert_eq!((hit.object.as_str(), hit.front), ("middle", true));
    state.apply(Action::Isolate);
    state.apply(Action::Hover(Some(MIDDLE)));
    assert_eq!(state.hover(), Some(1));
    let visible: Vec<bool> = state
        .scene()
        .objects()
        .iter()
        .map(|object| object.visible)
        .collect();
    assert_eq!(visible, [false, true, false]);
    state.apply(Action::ShowAll);
    state.apply(Action::Click(MIDDLE, 20.0));
    state.apply(Action::Click(MIDDLE + DVec2::X, 21.0));
    assert_eq!(selected(&state), Some("front"));
    state.apply(Action::SetVisible(0, false));
    state.apply(Action::Hover(Some(MIDDLE)));
    assert_eq!(state.hover(), Some(1));
    state.apply(Action::Hover(None));
    assert_eq!(state.hover(), None);
}

#[test]
fn a_resize_keeps_what_is_in_the_middle() {
    let mut state = front_view();
    for (width, height) in [(1, 1), (3, 2000), (2560, 1440)] {
        let viewport = Viewport::new(width, height).expect("a viewport");
        state.apply(Action::Resize(viewport));
        let middle = DVec2::new(f64::from(width), f64::from(height)) / 2.0;
        assert_near(
            state.view().project(DVec3::ZERO).expect("in front").px,
            middle,
            1e-9,
        );
        state.apply(Action::Click(middle.floor(), 0.0));
        assert_eq!(selected(&state), Some("front"), "{width}x{height}");
    }
}

#[test]
fn the_pipeline_follows_a_pick_to_its_own_pixel() {
    for orthographic in [false, true] {
        let mut state = front_view();
        state.apply(Action::Lens(LensControls {
            orthographic,
            ..state.controls()
        }));
        state.apply(Action::Turn(DVec2::new(31.0, -17.0)));
        let px = DVec2::new(404.5, 310.5);
        let pick = pick::pick(state.scene(), state.view(), px).expect("something there");
        let object = &state.scene().objects()[pick.id - 1];
        let steps = Steps::follow(state.view(), object, pick.point_object).expect("in front");
        assert!(steps.world.distance(pick.point_world) < 1e-12);
        assert!((steps.view.z - pick.depth).abs() < 1e-12);
        assert!(
            steps.ndc.distance(pick.ndc) < 1e-12,
            "{} and {}",
            steps.ndc,
            pick.ndc
        );
        assert_near(steps.px, px, 1e-9);
        let ray = state.view().ray(px);
        assert!(steps.ray.direction.distance(ray.direction) < 1e-12);
        // The product of the matrices gives the same in one step.
        let clip =
            Matrices::of(state.view(), Some(object)).product() * pick.point_object.extend(1.0);
        assert!((clip.truncate() / clip.w).distance(pick.ndc) < 1e-12);
        assert!((clip - steps.clip).length() < 1e-11);
    }
}

#[test]
fn the_cursor_knows_the_point_that_a_pick_there_reports() {
    let mut state = front_view();
    state.apply(Action::Turn(DVec2::new(31.0, -17.0)));
    state.apply(Action::Hover(Some(DVec2::new(404.2, 310.9))));
    let cursor = state.cursor().expect("over the scene");
    assert_eq!(cursor.px, DVec2::new(404.5, 310.5));
    let pick = pick::pick(state.scene(), state.view(), cursor.px).expect("something there");
    let (object, point_object) = cursor.hit.expect("something there");
    assert_eq!(object, pick.id - 1);
    assert!(point_object.distance(pick.point_object) <= 1e-14);
    state.apply(Action::Hover(Some(DVec2::new(2.0, 3.0))));
    let cursor = state.cursor().expect("over the scene");
    assert_eq!(
        (cursor.px, cursor.hit),
        (DVec2::new(2.5, 3.5), None),
        "the background has a pixel too"
    );
}

/// The mesh has many triangles and no tree yet, so a ray would have to test each of them.
#[test]
fn what_follows_the_mouse_waits_for_no_tree() {
    let side = 150_u16;
    let at = |i: u16| f32::from(i) / f32::from(side) - 0.5;
    let rows = (0..=side).flat_map(|j| (0..=side).map(move |i| [at(i), at(j), 0.0]));
    let width = u32::from(side) + 1;
    let cells = (0..u32::from(side)).flat_map(|j| (0..u32::from(side)).map(move |i| j * width + i));
    let halves = cells.flat_map(|a| [[a, a + 1, a + width], [a + 1, a + width + 1, a + width]]);
    let mesh = common::mesh(rows.collect(), halves.collect(), DVec3::ZERO);
    let shape = Shape::Mesh { mesh, part: 0 };
    let loaded = Loaded {
        scene: Scene::new(vec![Object::new("many", shape, Placement::IDENTITY)]),
        ..Loaded::default()
    };
    let mut state = open(loaded, CameraChoice::default());
    assert!(!state.rays_are_quick());
    let eye = state.view().camera.eye();
    state.apply(Action::Hover(Some(MIDDLE)));
    assert_eq!(state.hover(), None);
    state.apply(Action::BeginTurn(MIDDLE));
    state.apply(Action::Turn(DVec2::new(5.0, 0.0)));
    assert_ne!(state.view().camera.eye(), eye, "it turns all the same");
    // A click waits for no tree either: it tries every triangle, and picks the same.
    let picked = state.apply(Action::Click(MIDDLE, 0.0));
    assert!(picked.as_ref().is_some_and(|line| line.hit.is_some()));
    assert!(!state.rays_are_quick());
    state.scene().build_trees();
    assert!(state.rays_are_quick());
    assert_eq!(state.apply(Action::Click(MIDDLE, 0.1)), picked);
    state.apply(Action::Hover(Some(MIDDLE)));
    assert_eq!(state.hover(), Some(0));
}

/// A row of the list lights its object, whatever lies under the cursor, and selects nothing.
#[test]
fn a_row_lights_its_object() {
    let mut state = front_view();
    state.apply(Action::Hover(Some(MIDDLE)));
    assert_eq!(state.hover(), Some(0));
    state.apply(Action::Light(Some(2)));
    assert_eq!(state.hover(), Some(2));
    assert_eq!(selected(&state), None);
    assert_eq!(
        state
            .cursor()
            .and_then(|cursor| cursor.hit)
            .map(|hit| hit.0),
        Some(0)
    );
    state.apply(Action::Light(None));
    assert_eq!(state.hover(), Some(0));
}

#[test]
fn what_was_selected_first_is_taken_out_and_the_others_stay() {
    let mut state = front_view();
    state.apply(Action::Select(Some(2)));
    for object in [1, 0, 2] {
        state.apply(Action::ToggleSelected(object));
    }
    assert_eq!(state.all_selected().collect::<Vec<_>>(), [0, 1]);
}
