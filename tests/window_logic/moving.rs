//! Orbit, pan, zoom, framing, and a camera that stays.

use super::*;

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
fn at_stages_that_have_their_own_axes_views_look_along_those() {
    for stage in [Stage::View, Stage::Ndc] {
        let mut state = front_view();
        state.apply(Action::UpAxis(UpAxis::Z));
        state.apply(Action::Stage(stage));
        for (to_eye, forward) in [(DVec3::Y, DVec3::NEG_Y), (DVec3::Z, DVec3::NEG_Z)] {
            state.apply(Action::LookFrom(to_eye));
            assert_near_vectors(state.view().camera.forward(), forward);
        }
        // A typed pose turns about the same axis.
        state.apply(Action::Pose([
            DVec3::new(0.0, 0.0, 9.0),
            DVec3::ZERO,
            DVec3::Y,
        ]));
        state.apply(Action::Turn(DVec2::new(40.0, 0.0)));
        let forward = state.view().camera.forward();
        assert!(
            forward.y.abs() < 1e-12 && forward.x.abs() > 0.1,
            "{forward}"
        );
        state.apply(Action::Stage(Stage::World));
        state.apply(Action::LookFrom(DVec3::Y));
        assert_near_vectors(state.view().camera.forward(), DVec3::NEG_Z);
    }
}

#[track_caller]
fn assert_near_vectors(a: DVec3, b: DVec3) {
    assert!(a.distance(b) < 1e-12, "{a}, not {b}");
}

#[test]
fn the_opening_view_of_a_stage_is_the_stage_s_own() {
    for stage in [Stage::Object, Stage::View, Stage::Ndc] {
        let mut state = front_view();
        state.apply(Action::Stage(stage));
        for change in [Action::ResetView, Action::UpAxis(UpAxis::Z)] {
            state.apply(Action::Turn(DVec2::new(300.0, 0.0)));
            state.apply(change);
            for corner in state.scene().visible_bounds().corners() {
                let seen = state.view().project(corner).expect("in front").px;
                assert!(state.view().viewport.contains(seen), "{stage:?}: {seen}");
            }
        }
    }
}

#[test]
fn each_stage_has_a_lens_of_its_own() {
    for orthographic in [false, true] {
        let mut state = front_view();
        state.apply(Action::Camera(CameraChoice {
            ortho: orthographic.then_some(7.0),
            near: Some(8.0),
            far: Some(50.0),
            ..state.camera_choice()
        }));
        let before = (*state.view(), state.controls());
        for stage in [Stage::Object, Stage::View, Stage::Ndc] {
            state.apply(Action::Stage(stage));
            let lens = *state.view().camera.lens();
            for corner in state.scene().visible_bounds().corners() {
                let depth = state.view().project(corner).expect("in front").depth;
                assert!(lens.near < depth && depth < lens.far, "{stage:?}: {depth}");
            }
            state.apply(Action::Lens(LensControls {
                fov_deg: 20.0,
                orthographic: !orthographic,
                near: Some(0.1),
                ..state.controls()
            }));
            state.apply(Action::FrameAll);
            state.apply(Action::Stage(Stage::World));
            assert_eq!((*state.view(), state.controls()), before, "{stage:?}");
        }
    }
}

#[test]
fn another_stage_freezes_no_camera() {
    let mut state = front_view();
    state.apply(Action::Stage(Stage::View));
    state.apply(Action::ToggleFreeze);
    state.apply(Action::Stage(Stage::World));
    assert_eq!(state.frozen(), None, "it would stand where no camera was");
    state.apply(Action::ToggleFreeze);
    let frozen = state.frozen().copied();
    assert!(frozen.is_some());
    state.apply(Action::Stage(Stage::Ndc));
    state.apply(Action::ToggleFreeze);
    state.apply(Action::Stage(Stage::World));
    assert_eq!(state.frozen().copied(), frozen, "nor takes one away");
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
fn stages_show_what_each_matrix_leaves_and_the_world_comes_back() {
    let mut state = front_view();
    state.apply(Action::SetVisible(2, false));
    let (before, corners) = (*state.view(), state.scene().bounds_of(0).corners());
    let near = |bounds: Aabb, points: Vec<DVec3>, what: &str| {
        let expected = Aabb::around(points);
        let apart = (bounds.min - expected.min).length() + (bounds.max - expected.max).length();
        assert!(apart < 1e-6, "{what}: {bounds:?}, not {expected:?}");
    };
    state.apply(Action::Stage(Stage::Object));
    near(
        state.scene().bounds_of(0),
        vec![DVec3::splat(-0.5), DVec3::splat(0.5)],
        "no matrix",
    );
    state.apply(Action::Stage(Stage::View));
    let seen = corners.map(|corner| before.camera.to_view(corner));
    near(state.scene().bounds_of(0), seen.to_vec(), "V M");
    state.apply(Action::Stage(Stage::Ndc));
    let standard = LensControls {
        depth: DepthMapping::Standard,
        ..state.controls()
    };
    let mut through = front_view();
    through.apply(Action::SetVisible(2, false));
    through.apply(Action::Lens(standard));
    let ndc = corners.map(|corner| through.view().project(corner).expect("in front").ndc);
    near(state.scene().bounds_of(0), ndc.to_vec(), "P V M");
    assert!(
        !state.scene().objects()[2].visible,
        "what is hidden stays hidden"
    );
    let px = state
        .view()
        .project(state.scene().bounds_of(0).center())
        .expect("in front")
        .px;
    assert_eq!(
        state.apply(Action::Click(px, 0.0)),
        None,
        "points of a stage are not the scene's"
    );
    assert!(state.selection().is_some());
    state.apply(Action::Stage(Stage::World));
    assert_eq!(state.view().camera, before.camera);
    assert_eq!(state.scene().bounds_of(0).corners(), corners);
}

#[test]
fn what_lies_before_the_near_plane_is_cut_off_in_ndc() {
    let mut state = front_view();
    state.apply(Action::Lens(LensControls {
        near: Some(8.0),
        ..state.controls()
    }));
    state.apply(Action::Stage(Stage::Ndc));
    let bounds = state.scene().bounds_of(0);
    assert!(
        bounds.min.z.abs() < 1e-6,
        "the cube begins on the near plane, not at {}",
        bounds.min.z
    );
    assert!(
        bounds.max.z > 0.05 && bounds.max.z < 1.0,
        "{}",
        bounds.max.z
    );
}
