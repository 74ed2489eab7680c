//! The window's logic, by replaying its own actions: no window, no GPU.

mod common;

use glam::{DAffine3, DVec2, DVec3};
use sightline::{
    camera::{CameraChoice, Projection, UpAxis, Viewport},
    geometry::{Placement, Sides},
    pick,
    scene::{self, Loaded, Object, Progress, Scene, Shape, description},
    viewer::{
        action::{Action, LensControls},
        pipeline::{Matrices, Steps},
        state::{DOUBLE_CLICK_S, State},
    },
};

const MIDDLE: DVec2 = DVec2::new(400.0, 300.0);

fn at(shape: Shape, name: &str, position: [f64; 3]) -> Object {
    let model = DAffine3::from_translation(position.into());
    Object::new(name, shape, Placement::new(model).expect("invertible"))
}

/// Three things in a row along z, seen from the front.
fn row() -> Loaded {
    Loaded {
        scene: Scene::new(vec![
            at(Shape::Cube, "front", [0.0, 0.0, 2.0]),
            at(Shape::Sphere, "middle", [0.0, 0.0, 0.0]),
            at(Shape::Square, "back", [0.0, 0.0, -2.0]),
        ]),
        title: "row".into(),
        ..Loaded::default()
    }
}

fn open(loaded: Loaded, camera: CameraChoice) -> State {
    let viewport = Viewport::new(800, 600).expect("a viewport");
    State::new(loaded, camera, viewport, Sides::Both).expect("a camera")
}

fn front_view() -> State {
    let camera = CameraChoice {
        eye: Some(DVec3::new(0.0, 0.0, 10.0)),
        target: Some(DVec3::ZERO),
        ..CameraChoice::default()
    };
    open(row(), camera)
}

fn selected(state: &State) -> Option<&str> {
    let selection = state.selection()?;
    Some(&state.scene().objects()[selection.object].name)
}

#[track_caller]
fn assert_near(a: DVec2, b: DVec2, px: f64) {
    assert!(
        a.distance(b) < px,
        "{a} and {b} are {} px apart",
        a.distance(b)
    );
}

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

#[test]
fn the_same_pixel_again_goes_behind_but_a_double_click_does_not() {
    let mut state = front_view();
    let mut time = 0.0;
    let mut seen = Vec::new();
    for _ in 0..6 {
        state.apply(Action::Click(MIDDLE, time));
        state.apply(Action::Click(MIDDLE + 0.25, time + 0.5 * DOUBLE_CLICK_S));
        let hit = state
            .selection()
            .and_then(|s| s.pick.as_ref()?.hit.clone())
            .expect("a hit");
        seen.push((hit.object, hit.front));
        time += 10.0;
    }
    // In and out of the cube, in and out of the sphere, the square, and round again.
    let expected = [
        ("front", true),
        ("front", false),
        ("middle", true),
        ("middle", false),
        ("back", true),
        ("front", true),
    ];
    assert_eq!(seen, expected.map(|(name, front)| (name.to_owned(), front)));
    state.apply(Action::Click(MIDDLE + DVec2::X, time));
    assert_eq!(selected(&state), Some("front"), "another pixel starts anew");
}

#[test]
fn orbit_keeps_the_point_under_the_cursor_where_it_is() {
    let mut state = front_view();
    let px = DVec2::new(430.5, 280.5);
    let pivot = pick::pick(state.scene(), state.view(), px)
        .expect("the cube")
        .point_world;
    let eye = state.view().camera.eye();
    state.apply(Action::BeginTurn(px));
    for _ in 0..40 {
        state.apply(Action::Turn(DVec2::new(7.0, -3.0)));
    }
    assert!(state.view().camera.eye().distance(eye) > 1.0, "it turned");
    assert_near(state.view().project(pivot).expect("in front").px, px, 1e-9);
}

#[test]
fn orbit_stops_at_the_poles_and_stays_a_camera() {
    let mut state = front_view();
    for direction in [1.0, -1.0] {
        for _ in 0..200 {
            state.apply(Action::Turn(DVec2::new(13.0, 40.0 * direction)));
        }
        let forward = state.view().camera.forward();
        assert!(
            (forward.y + direction).abs() < 1e-12,
            "straight up or down, not {forward}"
        );
        assert!(state.view().camera.view().is_finite());
    }
}

#[test]
fn pan_takes_the_surface_along_with_the_cursor() {
    for ortho in [None, Some(6.0)] {
        let mut state = open(
            row(),
            CameraChoice {
                ortho,
                ..CameraChoice::default()
            },
        );
        let px = MIDDLE;
        let point = pick::pick(state.scene(), state.view(), px)
            .expect("something there")
            .point_world;
        state.apply(Action::BeginPan(px));
        for _ in 0..10 {
            state.apply(Action::Pan(DVec2::new(12.0, -7.0)));
        }
        assert_near(
            state.view().project(point).expect("in front").px,
            px + DVec2::new(120.0, -70.0),
            1e-8,
        );
    }
}

#[test]
fn zoom_keeps_the_point_under_the_cursor_and_never_sticks() {
    for ortho in [None, Some(6.0)] {
        let mut state = open(
            row(),
            CameraChoice {
                ortho,
                ..CameraChoice::default()
            },
        );
        let px = DVec2::new(410.0, 310.0);
        let point = pick::pick(state.scene(), state.view(), px)
            .expect("something there")
            .point_world;
        let size = |state: &State| {
            let a = state.view().project(point).expect("in front").px;
            let b = state
                .view()
                .project(point + 1e-3 * state.view().camera.right())
                .expect("in front")
                .px;
            a.distance(b)
        };
        let before = size(&state);
        for _ in 0..20 {
            state.apply(Action::Zoom(px, 1.15));
        }
        assert_near(state.view().project(point).expect("in front").px, px, 1e-6);
        let grown = size(&state) / before;
        let expected = 1.15_f64.powi(20);
        assert!(
            (grown / expected - 1.0).abs() < 1e-3,
            "{grown} times as large, not {expected}"
        );
    }
}

#[test]
fn zooming_on_and_on_towards_a_surface_comes_ever_nearer() {
    let mut state = front_view();
    let mut depth = f64::INFINITY;
    for _ in 0..60 {
        state.apply(Action::Zoom(MIDDLE, 1.3));
        let pick = pick::pick(state.scene(), state.view(), MIDDLE + 0.5).expect("still there");
        assert!(pick.depth < 0.9 * depth, "{} after {depth}", pick.depth);
        depth = pick.depth;
    }
    assert!(depth < 1e-5, "{depth}");
}

#[test]
fn hidden_is_not_picked_and_shown_is_again() {
    let mut state = front_view();
    state.apply(Action::Click(MIDDLE, 0.0));
    state.apply(Action::HideSelection);
    assert_eq!(state.selection(), None);
    state.apply(Action::Click(MIDDLE, 1.0));
    assert_eq!(selected(&state), Some("middle"));
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
fn near_and_far_follow_the_scene_until_they_are_set() {
    let mut state = front_view();
    let lens = *state.view().camera.lens();
    assert!((lens.near - 0.99 * 7.5).abs() < 1e-12, "{}", lens.near);
    assert!((lens.far - 1.01 * 12.0).abs() < 1e-12, "{}", lens.far);
    let mut controls = state.controls();
    controls.near = Some(9.0);
    state.apply(Action::Lens(controls));
    state.apply(Action::Click(MIDDLE, 0.0));
    assert_eq!(
        selected(&state),
        Some("middle"),
        "the cube lies before the near plane"
    );
    state.apply(Action::Zoom(MIDDLE, 1.0));
    assert!(
        (state.view().camera.lens().near - 9.0).abs() < f64::EPSILON,
        "a plane that is set stays"
    );
    controls.near = None;
    state.apply(Action::Lens(controls));
    assert_eq!(*state.view().camera.lens(), lens);
}

#[test]
fn what_cannot_be_is_refused_with_a_reason_and_changes_nothing() {
    let mut state = front_view();
    let before = *state.view();
    let eye = before.camera.eye();
    let lens = |change: fn(&mut LensControls)| {
        let mut controls = front_view().controls();
        change(&mut controls);
        Action::Lens(controls)
    };
    let refused = [
        lens(|c| c.fov_deg = 0.0),
        lens(|c| c.fov_deg = 180.0),
        lens(|c| c.fov_deg = f64::NAN),
        lens(|c| c.near = Some(0.0)),
        lens(|c| c.near = Some(-1.0)),
        lens(|c| (c.near, c.far) = (Some(5.0), Some(5.0))),
        lens(|c| c.far = Some(f64::INFINITY)),
        Action::Pose([eye, eye, DVec3::Y]),
        Action::Pose([eye, DVec3::ZERO, DVec3::Z]),
        Action::Pose([eye, DVec3::ZERO, DVec3::ZERO]),
        Action::Pose([DVec3::NAN, DVec3::ZERO, DVec3::Y]),
    ];
    for action in refused {
        let error = state.check(&action).expect_err("it cannot be");
        assert!(!error.to_string().is_empty());
        state.apply(action);
        assert_eq!(*state.view(), before);
    }
}

#[test]
fn orthographic_and_back_shows_the_target_as_large() {
    let mut state = front_view();
    let span = |state: &State| {
        let [a, b] =
            [DVec3::NEG_X, DVec3::X].map(|p| state.view().project(p).expect("in front").px.x);
        b - a
    };
    let before = span(&state);
    let mut controls = state.controls();
    controls.orthographic = true;
    state.apply(Action::Lens(controls));
    assert!(matches!(
        state.view().camera.lens().projection,
        Projection::Orthographic { .. }
    ));
    assert!((span(&state) / before - 1.0).abs() < 1e-12);
    state.apply(Action::Zoom(MIDDLE, 2.0));
    let larger = span(&state);
    controls.orthographic = false;
    state.apply(Action::Lens(controls));
    let target = state.view().camera.target();
    assert!(
        target.length() < 3.0,
        "the target is among the objects: {target}"
    );
    assert!(larger > 1.9 * before);
}

#[test]
fn axis_views_look_along_the_axes_of_the_up_axis() {
    for (up_axis, to_eye, world) in [
        (UpAxis::Y, DVec3::Z, DVec3::Z),
        (UpAxis::Y, DVec3::Y, DVec3::Y),
        (UpAxis::Z, DVec3::Y, DVec3::Z),
        (UpAxis::Z, DVec3::Z, DVec3::NEG_Y),
        (UpAxis::Z, DVec3::NEG_X, DVec3::NEG_X),
    ] {
        let mut state = front_view();
        state.apply(Action::UpAxis(up_axis));
        state.apply(Action::LookFrom(to_eye));
        let forward = state.view().camera.forward();
        assert!(
            (forward + world).length() < 1e-12,
            "{up_axis:?} from {to_eye}: {forward}"
        );
    }
}

#[test]
fn framing_shows_the_selection_or_all() {
    let mut state = front_view();
    state.apply(Action::Select(Some(1)));
    state.apply(Action::FrameSelection);
    assert_eq!(state.view().camera.target(), DVec3::ZERO);
    let seen = state.scene().bounds_of(1).corners().map(|corner| {
        let ndc = state.view().project(corner).expect("in front").ndc;
        ndc.x.abs().max(ndc.y.abs())
    });
    let widest = seen.into_iter().fold(0.0, f64::max);
    assert!(
        (0.9..1.0).contains(&widest),
        "it reaches {widest} of the way to the rim"
    );
    state.apply(Action::FrameAll);
    for corner in state.scene().visible_bounds().corners() {
        let px = state.view().project(corner).expect("in front").px;
        assert!(state.view().viewport.contains(px), "{corner} at {px}");
    }
}

#[test]
fn a_double_click_centres_the_point_and_on_nothing_frames_all() {
    let mut state = front_view();
    let px = DVec2::new(425.5, 280.5);
    let point = pick::pick(state.scene(), state.view(), px)
        .expect("the cube")
        .point_world;
    state.apply(Action::Recentre(px));
    assert_near(
        state.view().project(point).expect("in front").px,
        MIDDLE,
        1e-9,
    );
    state.apply(Action::Recentre(DVec2::new(1.0, 1.0)));
    assert_eq!(
        state.view().camera.target(),
        state.scene().visible_bounds().center()
    );
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
fn the_next_scene_replaces_the_first_only_when_it_is_whole() {
    let mut state = front_view();
    state.apply(Action::Click(MIDDLE, 0.0));
    let before = *state.view();
    let mut broken = row();
    broken.camera.fov = Some(-3.0);
    state.open(broken).expect_err("no camera");
    assert_eq!(
        (*state.view(), selected(&state), state.name()),
        (before, Some("front"), "row")
    );
    let revision = state.scene_revision();
    let next = Loaded {
        scene: Scene::new(vec![at(Shape::Sphere, "far away", [1e6, 0.0, 0.0])]),
        title: "next".into(),
        ..Loaded::default()
    };
    state.open(next).expect("a scene");
    assert_ne!(state.scene_revision(), revision);
    assert_eq!((state.selection(), state.name()), (None, "next"));
    state.apply(Action::Click(MIDDLE, 0.0));
    assert_eq!(selected(&state), Some("far away"), "it is framed");
}

#[test]
fn a_reload_keeps_view_selection_and_visibility() {
    let mut state = front_view();
    state.apply(Action::Turn(DVec2::new(30.0, 12.0)));
    state.apply(Action::SetVisible(2, false));
    state.apply(Action::Select(Some(1)));
    let (eye, revision) = (state.view().camera.eye(), state.scene_revision());
    let mut objects = row().scene.objects().to_vec();
    objects.insert(0, at(Shape::Cube, "new", [5.0, 0.0, 0.0]));
    state.reload(Loaded {
        scene: Scene::new(objects),
        ..Loaded::default()
    });
    assert_eq!(state.view().camera.eye(), eye);
    assert_eq!(selected(&state), Some("middle"));
    let visible = state
        .scene()
        .objects()
        .iter()
        .map(|object| (object.name.as_str(), object.visible));
    let expected = [
        ("new", true),
        ("front", true),
        ("middle", true),
        ("back", false),
    ];
    assert_eq!(visible.collect::<Vec<_>>(), expected);
    assert_ne!(state.scene_revision(), revision, "it is drawn anew");
}

#[test]
fn what_is_saved_opens_as_the_same_view() {
    for orthographic in [false, true] {
        let mut state = front_view();
        state.apply(Action::Turn(DVec2::new(31.0, -17.0)));
        state.apply(Action::Zoom(MIDDLE, 1.3));
        state.apply(Action::SetVisible(0, false));
        let controls = LensControls {
            fov_deg: 37.3,
            orthographic,
            far: Some(123.4),
            ..state.controls()
        };
        state.apply(Action::Lens(controls));
        let text = description::to_toml(state.scene(), &state.camera_choice(), &[])
            .expect("it can be saved");
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("saved.toml");
        std::fs::write(&path, text).expect("written");
        let loaded = scene::load(&[path], &Progress::default()).expect("it loads");
        let again = open(loaded, CameraChoice::default());
        assert_eq!(again.view(), state.view());
        let visible = |state: &State| {
            state
                .scene()
                .objects()
                .iter()
                .map(|o| o.visible)
                .collect::<Vec<_>>()
        };
        assert_eq!(visible(&again), visible(&state));
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
        // The product of the matrices says the same in one step.
        let clip =
            Matrices::of(state.view(), Some(object)).product() * pick.point_object.extend(1.0);
        assert!((clip.truncate() / clip.w).distance(pick.ndc) < 1e-12);
        assert!((clip - steps.clip).length() < 1e-11);
    }
}

#[test]
fn a_frozen_camera_stays_and_its_frustum_is_not_clipped() {
    let mut state = front_view();
    state.apply(Action::Click(MIDDLE, 0.0));
    let view = *state.view();
    state.apply(Action::ToggleFreeze);
    state.apply(Action::Turn(DVec2::new(250.0, 60.0)));
    state.apply(Action::FrameAll);
    let frozen = *state.frozen().expect("frozen");
    assert_eq!((frozen.view, frozen.px), (view, MIDDLE + 0.5));
    let lens = state.view().camera.lens();
    for corner in frozen
        .view
        .frustum_corners()
        .into_iter()
        .chain([view.camera.eye()])
    {
        let seen = state.view().project(corner).expect("in front");
        assert!(
            lens.near < seen.depth && seen.depth < lens.far,
            "{corner} is clipped"
        );
        assert!(
            state.view().viewport.contains(seen.px),
            "{corner} is out of the picture"
        );
    }
    state.apply(Action::ToggleFreeze);
    assert_eq!(state.frozen(), None);
}

#[test]
fn an_empty_scene_answers_everything() {
    let mut state = open(Loaded::default(), CameraChoice::default());
    for action in [
        Action::BeginTurn(MIDDLE),
        Action::Turn(DVec2::ONE),
        Action::BeginPan(MIDDLE),
        Action::Pan(DVec2::ONE),
        Action::Zoom(MIDDLE, 2.0),
        Action::Click(MIDDLE, 0.0),
        Action::Recentre(MIDDLE),
        Action::FrameSelection,
        Action::HideSelection,
        Action::Isolate,
        Action::ShowAll,
    ] {
        state.apply(action);
        assert!(state.view().camera.view().is_finite());
        assert!(
            state
                .view()
                .camera
                .projection(state.view().viewport)
                .is_finite()
        );
    }
}
