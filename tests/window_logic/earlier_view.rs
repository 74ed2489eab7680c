//! A pick belongs to the view that it was made in, and the view that a scene opened with comes back to the bit.

use super::*;
use crate::inspect::STILL;
use sightline::{
    geometry::Trs,
    viewer::model::{PickView, RayHits},
};

/// After any action, the pick is what its own view finds in the scene as it is now.
#[test]
fn a_pick_is_always_what_its_own_view_finds() {
    let lens = |change: fn(&mut LensControls)| {
        let mut controls = front_view().controls();
        change(&mut controls);
        Action::Lens(controls)
    };
    let moved = Trs {
        translation: DVec3::new(0.1, 0.2, 2.5),
        ..STILL
    };
    let actions = [
        Action::Click(MIDDLE, 0.0),
        Action::Step { forward: true },
        Action::Place(0, moved.to_model()),
        Action::Turn(DVec2::new(31.0, -17.0)),
        Action::SetVisible(2, false),
        Action::Undo,
        Action::ToggleProjection,
        Action::SetVisible(1, false),
        Action::ToggleSides,
        Action::ResetView,
        Action::ToggleSides,
        Action::Click(MIDDLE, 5.0),
        Action::Step { forward: true },
        lens(|controls| controls.near = Some(8.25)),
        Action::SetVisible(1, true),
        Action::SetVisible(2, true),
        Action::Resize(Viewport::new(640, 480).expect("a viewport")),
        Action::StepTo(0),
        Action::ResetView,
        Action::ToggleFreeze,
        Action::Undo,
        Action::Undo,
        Action::Redo,
        Action::Click(MIDDLE, 9.0),
        Action::UpAxis(UpAxis::Z),
    ];
    let (mut state, mut own, mut earlier) = (front_view(), 0, 0);
    for action in actions {
        state.apply(action);
        // A click on nothing keeps its ray too, but picks nothing.
        let ray = state.pick_ray().filter(|ray| !ray.picks.is_empty());
        assert_eq!(ray.and_then(RayHits::pick), state.picked(), "{action:?}");
        let object = state.picked().map(|pick| pick.id - 1);
        assert!(object.is_none() || object == state.selected(), "{action:?}");
        let Some(ray) = ray else { continue };
        let found = pick::pick_all(state.scene(), &ray.view, ray.px);
        assert_eq!(ray.picks, found, "{action:?}");
        let is_own = state.pick_view() == Some(PickView::Own);
        assert_eq!(is_own, ray.view == *state.view(), "{action:?}");
        (own, earlier) = (own + u32::from(is_own), earlier + u32::from(!is_own));
    }
    assert!(own >= 6 && earlier >= 6, "{own} own, {earlier} earlier");
}

#[test]
fn what_a_view_leaves_out_is_not_in_it() {
    use PickView::{Earlier, LeftOut, Own, Resized};
    let view_of = |at: usize, change: &dyn Fn(&mut State)| {
        let mut state = front_view();
        state.apply(Action::Click(MIDDLE, 0.0));
        state.apply(Action::StepTo(at));
        change(&mut state);
        state.pick_view().expect("a pick")
    };
    let planes = |near, far| {
        move |state: &mut State| {
            let controls = state.controls();
            state.apply(Action::Lens(LensControls {
                near,
                far,
                ..controls
            }));
        }
    };
    let cull = |state: &mut State| drop(state.apply(Action::ToggleSides));
    let ortho = |state: &mut State| drop(state.apply(Action::ToggleProjection));
    let turn = |state: &mut State| drop(state.apply(Action::LookFrom(DVec3::NEG_Z)));
    // The cube's front is at depth 7.5, its back at 8.5.
    assert_eq!(view_of(0, &|_| ()), Own);
    assert_eq!(view_of(0, &planes(Some(7.4), None)), Earlier);
    assert_eq!(view_of(0, &planes(Some(7.5), None)), Earlier, "near counts");
    assert_eq!(view_of(0, &planes(Some(7.6), None)), LeftOut);
    assert_eq!(view_of(1, &planes(None, Some(8.6))), Earlier);
    assert_eq!(
        view_of(1, &planes(None, Some(8.5))),
        LeftOut,
        "far does not"
    );
    let resize = |state: &mut State| {
        let size = Viewport::new(300, 700).expect("a size");
        state.apply(Action::Resize(size));
    };
    assert_eq!(view_of(0, &resize), Resized);
    let and_turn = |state: &mut State| (resize(state), turn(state)).1;
    assert_eq!(view_of(0, &and_turn), Earlier);
    assert_eq!(view_of(0, &cull), Earlier);
    assert_eq!(view_of(1, &cull), LeftOut);
    let both = |state: &mut State| (ortho(state), cull(state)).1;
    assert_eq!((view_of(0, &both), view_of(1, &both)), (Earlier, LeftOut));
    // From behind it is the other way round.
    let both = |state: &mut State| (turn(state), cull(state)).1;
    assert_eq!((view_of(0, &both), view_of(1, &both)), (LeftOut, Earlier));
}

fn opened_with() -> [CameraChoice; 5] {
    let eye = Some(DVec3::new(3.7, 2.9, 5.3));
    let own = CameraChoice {
        eye,
        target: Some(DVec3::new(0.1, 0.7, -0.3)),
        ..CameraChoice::default()
    };
    [
        CameraChoice::default(),
        own,
        CameraChoice {
            up: Some(DVec3::new(0.3, 1.0, 0.1)),
            fov: Some(33.3),
            near: Some(1.7),
            ..own
        },
        CameraChoice {
            ortho: Some(5.7),
            ..own
        },
        CameraChoice {
            look: Some(DVec3::new(-0.7, -0.4, -0.9)),
            depth: Some(DepthMapping::Standard),
            ..CameraChoice::default()
        },
    ]
}

#[test]
fn the_view_that_the_scene_opened_with_comes_back_to_the_bit() {
    for choice in opened_with() {
        let mut state = open(row(), choice);
        let (view, controls) = (*state.view(), state.controls());
        let other = LensControls {
            fov_deg: 20.0,
            near: Some(0.3),
            ..controls
        };
        for change in [
            Action::Turn(DVec2::new(31.0, -17.0)),
            Action::Zoom(MIDDLE, 1.3),
            Action::ToggleProjection,
            Action::Lens(other),
            Action::FrameAll,
        ] {
            state.apply(change);
            state.apply(Action::Turn(DVec2::new(3.0, -7.0)));
            assert_ne!(*state.view(), view);
            state.apply(Action::ResetView);
            assert_eq!(
                (*state.view(), state.controls()),
                (view, controls),
                "{change:?}"
            );
        }
        // Hiding and showing an object moves nothing either.
        state.apply(Action::SetVisible(2, false));
        state.apply(Action::SetVisible(2, true));
        assert_eq!(*state.view(), view, "{choice:?}");
    }
}

#[test]
fn another_up_axis_leaves_the_lens() {
    let mut state = front_view();
    let controls = LensControls {
        fov_deg: 33.0,
        far: Some(200.0),
        ..state.controls()
    };
    state.apply(Action::Lens(controls));
    state.apply(Action::UpAxis(UpAxis::Z));
    assert_eq!(state.controls(), controls);
    state.apply(Action::ResetView);
    assert_eq!(state.controls(), front_view().controls());
}

#[test]
fn a_camera_is_frozen_with_its_own_pick_or_none() {
    let frozen_px = |turned: bool| {
        let mut state = front_view();
        state.apply(Action::Click(MIDDLE + 9.0, 0.0));
        if turned {
            state.apply(Action::Turn(DVec2::new(31.0, -17.0)));
        }
        state.apply(Action::ToggleFreeze);
        state.frozen().expect("it stands").px
    };
    assert_eq!(frozen_px(false), MIDDLE + 9.5);
    assert_eq!(frozen_px(true), MIDDLE, "another ray than the pick's");
}
