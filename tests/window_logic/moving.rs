//! Orbit, pan, zoom and framing keep the right point in place, and a frozen camera stays and is not clipped.

use super::*;

/// The row, seen through a lens of each kind.
fn of_each_lens() -> [State; 2] {
    [None, Some(6.0)].map(|ortho| {
        let camera = CameraChoice {
            ortho,
            ..CameraChoice::default()
        };
        open(row(), camera)
    })
}

/// The point that is picked at a position of the picture.
#[track_caller]
fn picked(state: &State, px: DVec2) -> DVec3 {
    let pick = pick::pick(state.scene(), state.view(), px);
    pick.expect("something there").point_world
}

/// Where the picture shows a point.
#[track_caller]
fn shown(state: &State, point: DVec3) -> DVec2 {
    state.view().project(point).expect("in front").px
}

#[test]
fn orbit_keeps_the_point_under_the_cursor_where_it_is() {
    let mut state = front_view();
    let px = DVec2::new(430.5, 280.5);
    let pivot = picked(&state, px);
    let eye = state.view().camera.eye();
    state.apply(Action::BeginTurn(px));
    for _ in 0..40 {
        state.apply(Action::Turn(DVec2::new(7.0, -3.0)));
    }
    assert!(state.view().camera.eye().distance(eye) > 1.0, "it turned");
    assert_near(shown(&state, pivot), px, 1e-9);
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
    for mut state in of_each_lens() {
        let px = MIDDLE;
        let point = picked(&state, px);
        state.apply(Action::BeginPan(px));
        for _ in 0..10 {
            state.apply(Action::Pan(DVec2::new(12.0, -7.0)));
        }
        let moved = DVec2::new(120.0, -70.0);
        assert_near(shown(&state, point), px + moved, 1e-8);
    }
}

#[test]
fn zoom_keeps_the_point_under_the_cursor_and_never_sticks() {
    for mut state in of_each_lens() {
        // Wherever in a pixel the cursor is, the pixel's centre stays: a click picks there.
        let px = DVec2::new(410.5, 310.5);
        let point = picked(&state, px);
        let size = |state: &State| {
            let beside = point + 1e-3 * state.view().camera.right();
            shown(state, point).distance(shown(state, beside))
        };
        let before = size(&state);
        for _ in 0..20 {
            state.apply(Action::Zoom(px - DVec2::new(0.4, 0.3), 1.15));
        }
        assert_near(shown(&state, point), px, 1e-6);
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
    assert!(state.view().camera.target().length() < 1e-12);
    // What is seen of it alone, not its box, fills 85 % of the smaller side and lies in the middle.
    let mut alone = state.scene().clone();
    let others: Vec<usize> = (0..alone.objects().len()).filter(|of| *of != 1).collect();
    alone.show(&others, false);
    let ids = pick::ids(&alone, state.view());
    let rows = ids.positions().filter(|(x, y)| ids.at(*x, *y).object == 2);
    let rows: Vec<u32> = rows.map(|(_, y)| y).collect();
    let (top, bottom) = (rows[0], rows[rows.len() - 1]);
    let height = state.view().viewport.height();
    assert!(
        top.abs_diff(height - 1 - bottom) <= 1,
        "{top} {bottom} of {height}"
    );
    let filled = f64::from(bottom + 1 - top) / f64::from(height);
    assert!((filled - 0.85).abs() < 0.006, "{filled} of the height");
    state.apply(Action::FrameAll);
    for corner in state.scene().visible_bounds().corners() {
        let px = shown(&state, corner);
        assert!(state.view().viewport.contains(px), "{corner} at {px}");
    }
}

#[test]
fn a_double_click_centres_the_point_and_on_nothing_frames_all() {
    let mut state = front_view();
    let px = DVec2::new(425.5, 280.5);
    let point = picked(&state, px);
    let depth = |state: &State| state.view().camera.to_view(point).z;
    let before = depth(&state);
    state.apply(Action::Recentre(px));
    assert_near(shown(&state, point), MIDDLE, 1e-9);
    // It is as large as it was.
    assert!((depth(&state) - before).abs() < 1e-9, "{before}");
    state.apply(Action::Recentre(DVec2::new(1.0, 1.0)));
    assert_eq!(
        state.view().camera.target(),
        state.scene().visible_bounds().center()
    );
}

/// Eyes about the row. From some, the corners of the eye's own frustum lie exactly on the picture's rim; from others,
/// rounding puts them beside it.
fn eyes() -> impl Iterator<Item = DVec3> {
    let of = |i: i32| {
        let i = f64::from(i);
        DVec3::new(3.1 * (1.7 * i).sin(), 2.3 * (0.9 * i).cos(), 7.0 + 0.31 * i)
    };
    [DVec3::new(0.0, 0.0, 10.0)]
        .into_iter()
        .chain((0..40).map(of))
}

/// The row seen from an eye.
fn from_eye(eye: DVec3, ortho: Option<f64>) -> State {
    let camera = CameraChoice {
        eye: Some(eye),
        target: Some(DVec3::ZERO),
        ortho,
        ..CameraChoice::default()
    };
    open(row(), camera)
}

fn near(state: &State) -> f64 {
    state.view().camera.lens().near
}

/// A frozen camera keeps the P that the user wants to look at, and near stays where depth keeps its digits.
#[test]
fn freezing_the_camera_leaves_its_planes_and_a_look_about_leaves_near_close() {
    for (eye, ortho) in eyes().flat_map(|eye| [(eye, None), (eye, Some(3.0))]) {
        let [mut state, mut unfrozen] = [from_eye(eye, ortho), from_eye(eye, ortho)];
        let lens = *state.view().camera.lens();
        freeze_here(&mut state);
        let frozen = *state.view().camera.lens();
        assert_eq!(frozen, lens, "{eye}, {ortho:?}");
        for _ in 0..20 {
            let [with, without] = [&mut state, &mut unfrozen].map(|state| {
                state.apply(Action::Turn(DVec2::new(5.0, 1.0)));
                near(state)
            });
            let is_close = ortho.is_some() || with > 0.1 * without;
            assert!(with <= without && is_close, "{eye}: {with}, {without}");
        }
    }
}

/// The frozen eye is just in front of the eye, and near stays far enough out for depth to keep its digits.
#[test]
fn a_step_back_from_a_frozen_camera_leaves_near_its_floor() {
    for eye in eyes() {
        for zooms in [[1.000_001_f64.recip(), 1.0], [1.499_999, 1.5_f64.recip()]] {
            let mut state = from_eye(eye, None);
            freeze_here(&mut state);
            for zoom in zooms {
                state.apply(Action::Zoom(MIDDLE, zoom));
            }
            let camera = state.view().camera;
            let to_target = camera.eye().distance(camera.target());
            let least = (1e-5 * camera.lens().far).min(1e-2 * to_target);
            assert!(near(&state) >= least, "{eye}: {} < {least}", near(&state));
        }
    }
}

/// An orthographic near plane may lie behind the eye.
#[test]
fn a_frozen_camera_beside_a_parallel_one_is_not_clipped() {
    let mut state = from_eye(DVec3::new(0.0, 0.0, 10.0), None);
    state.apply(Action::ToggleFreeze);
    let frozen = state.frozen().expect("it stands").view;
    let eye = DVec3::new(9.0, 0.5, 4.0);
    let target = DVec3::new(8.0, 0.5, 4.5);
    state.apply(Action::Pose([eye, target, DVec3::Y]));
    state.apply(Action::Camera(CameraChoice {
        ortho: Some(60.0),
        ..state.camera_choice()
    }));
    state.apply(Action::Turn(DVec2::ZERO));
    let lens = *state.view().camera.lens();
    let points = frozen
        .frustum_corners()
        .into_iter()
        .chain([frozen.camera.eye()]);
    let depths: Vec<_> = points
        .map(|point| state.view().camera.to_view(point).z)
        .collect();
    assert!(depths.iter().any(|depth| *depth < 0.0), "{depths:?}");
    assert!(
        depths
            .iter()
            .all(|depth| lens.near < *depth && *depth < lens.far),
        "{lens:?}, {depths:?}"
    );
}

/// A pan leaves the frozen eye at the depth of the eye.
#[test]
fn a_frozen_eye_beside_a_parallel_camera_is_not_clipped() {
    let eye = DVec3::new(0.0, 0.0, 10.0);
    let mut state = from_eye(eye, Some(8.0));
    freeze_here(&mut state);
    assert!(near(&state) > 1.0);
    state.apply(Action::BeginPan(MIDDLE));
    state.apply(Action::Pan(DVec2::new(30.0, 0.0)));
    let seen = state.view().project(eye).expect("it is parallel");
    assert!(state.view().viewport.contains(seen.px));
    assert!(
        seen.depth.abs() < 1e-9 && near(&state) <= seen.depth,
        "{}",
        near(&state)
    );
}

/// The picture's size decides how much of a frozen camera it shows, and so where near must be.
#[test]
fn planes_follow_the_size_of_the_picture() {
    let mut state = from_eye(DVec3::new(0.0, 0.0, 10.0), None);
    state.apply(Action::ToggleFreeze);
    let eye = DVec3::new(26.0, 0.0, 15.0);
    state.apply(Action::Pose([eye, DVec3::ZERO, DVec3::Y]));
    let [narrow, wide] = [100, 800].map(|width| {
        let size = Viewport::new(width, 400).expect("a size");
        state.apply(Action::Resize(size));
        near(&state)
    });
    let frozen_eye = state.view().camera.to_view(DVec3::new(0.0, 0.0, 10.0)).z;
    assert!(wide < frozen_eye && wide < narrow, "{narrow}, {wide}");
}

#[test]
fn a_frozen_camera_stays_and_its_frustum_is_not_clipped() {
    let mut state = front_view();
    state.apply(Action::Click(MIDDLE, 0.0));
    let view = *state.view();
    state.apply(Action::ToggleFreeze);
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
    assert_eq!((state.frozen(), *state.view()), (None, view));
}

/// Wherever the camera stands, its eye and what it looks at are in view from where the view steps back to.
#[test]
fn the_view_steps_back_from_a_frozen_camera_and_into_it_again() {
    for (eye, ortho) in eyes().flat_map(|eye| [(eye, None), (eye, Some(3.0))]) {
        let mut state = from_eye(eye, ortho);
        let by_hand = LensControls {
            near: Some(0.5 * near(&state)),
            ..state.controls()
        };
        state.apply(Action::Lens(by_hand));
        state.apply(Action::Click(MIDDLE, 0.0));
        let view = *state.view();
        let hit = state.picked().expect("a hit").point_world;
        state.apply(Action::ToggleFreeze);
        let outside = *state.view();
        for point in [view.camera.eye(), hit] {
            let seen = outside.project(point).expect("in front");
            let lens = outside.camera.lens();
            assert!(outside.viewport.contains(seen.px), "{eye}, {ortho:?}");
            assert!(lens.near < seen.depth && seen.depth < lens.far, "{eye}");
        }
        let [from, to] = [view.camera.eye(), hit].map(|point| outside.project(point));
        let [from, to] = [from, to].map(|seen| seen.expect("in front").px);
        assert!(
            from.distance(to) > 40.0,
            "{eye}: the ray is seen from beside"
        );
        // The leap is undone like any other, and the camera stays.
        state.apply(Action::Undo);
        assert_eq!(state.view().camera, view.camera, "{eye}, {ortho:?}");
        assert!(state.frozen().is_some());
        state.apply(Action::Redo);
        assert_eq!(*state.view(), outside, "{eye}, {ortho:?}");
        state.apply(Action::Turn(DVec2::new(30.0, 5.0)));
        state.apply(Action::ToggleFreeze);
        assert_eq!(
            (state.frozen(), *state.view()),
            (None, view),
            "{eye}, {ortho:?}"
        );
        assert_eq!(state.controls().near, by_hand.near);
    }
}

/// Freezes the camera, but does not step back from it.
fn freeze_here(state: &mut State) {
    state.apply(Action::ToggleFreeze);
    state.apply(Action::Undo);
}

#[test]
fn after_a_camera_is_pasted_dragging_turns_about_its_target() {
    let mut state = front_view();
    let target = DVec3::new(30.0, 0.0, 0.0);
    state.apply(Action::Camera(CameraChoice {
        eye: Some(DVec3::new(30.0, 0.0, 10.0)),
        target: Some(target),
        ..CameraChoice::default()
    }));
    // Nothing is there that could be the pivot.
    state.apply(Action::BeginTurn(MIDDLE));
    state.apply(Action::Turn(DVec2::new(40.0, 10.0)));
    assert!(state.view().camera.target().distance(target) < 1e-9);
}

/// However the camera moves in the four views, near and far hold the frozen one again once the picture is back.
#[test]
fn back_from_the_four_views_a_frozen_camera_is_not_clipped() {
    let look = Action::LookFrom(DVec3::ONE);
    let mut state = front_view();
    state.apply(Action::ToggleFreeze);
    state.apply(look);
    let expected = *state.view();
    let mut state = front_view();
    state.apply(Action::ToggleFreeze);
    state.apply(Action::Views(Views::Four));
    state.apply(look);
    assert_ne!(
        *state.view(),
        expected,
        "the four views show no frozen camera"
    );
    state.apply(Action::Views(Views::Picture));
    assert_eq!(*state.view(), expected);
}
