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

/// Else freezing would change the very P that is to be looked at, and depth would lose its digits.
#[test]
fn freezing_the_camera_and_a_look_about_leave_near_where_it_was() {
    let [mut state, mut unfrozen] = [front_view(), front_view()];
    let lens = *state.view().camera.lens();
    state.apply(Action::ToggleFreeze);
    let frozen = *state.view().camera.lens();
    assert_eq!(frozen.near.to_bits(), lens.near.to_bits());
    assert!(frozen.far >= lens.far && frozen.far < 1.02 * lens.far);
    for _ in 0..20 {
        let [with, without] = [&mut state, &mut unfrozen].map(|state| {
            state.apply(Action::Turn(DVec2::new(5.0, 1.0)));
            state.view().camera.lens().near
        });
        assert!(with <= without && with > 0.1 * without, "{with}, {without}");
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
