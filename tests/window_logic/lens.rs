//! Near and far follow the scene until they are set, an invalid lens or pose is refused, and a change of projection
//! keeps the target's size.

use super::*;

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
        "the cube is in front of the near plane"
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
        let target = state.view().camera.target();
        let [a, b] = [DVec3::NEG_X, DVec3::X]
            .map(|side| state.view().project(target + side).expect("in front").px.x);
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
    let back = span(&state) / larger;
    assert!((back - 1.0).abs() < 1e-12, "{back} times as large");
}

/// The picture is as high as typed, and one step of undo leads back, however long the height was dragged.
#[test]
fn the_height_of_an_orthographic_picture_is_set() {
    let height = |state: &State| match state.view().camera.lens().projection {
        Projection::Orthographic { height } => Some(height),
        Projection::Perspective { .. } => None,
    };
    let mut state = front_view();
    let before = *state.view();
    state.apply(Action::PictureHeight(20.0));
    assert_eq!(*state.view(), before, "perspective has none");
    state.apply(Action::ToggleProjection);
    let first = height(&state);
    assert!(first.is_some());
    for typed in [18.0, 19.0, 20.0] {
        state.apply(Action::PictureHeight(typed));
        assert_eq!(height(&state), Some(typed));
    }
    for refused in [0.0, -1.0, f64::NAN] {
        assert!(state.check(&Action::PictureHeight(refused)).is_err());
        state.apply(Action::PictureHeight(refused));
        assert_eq!(height(&state), Some(20.0));
    }
    state.apply(Action::Zoom(MIDDLE, 2.0));
    assert_eq!(height(&state), Some(10.0));
    state.apply(Action::Undo);
    assert_eq!(height(&state), first);
}

/// An orthographic camera that is pasted says nothing of a field of view: the way back to perspective has the old one.
#[test]
fn a_pasted_orthographic_camera_keeps_the_field_of_view() {
    let mut state = front_view();
    let controls = LensControls {
        fov_deg: 30.0,
        ..state.controls()
    };
    state.apply(Action::Lens(controls));
    state.apply(Action::Camera(CameraChoice {
        ortho: Some(5.0),
        ..CameraChoice::default()
    }));
    let expected = LensControls {
        orthographic: true,
        ..controls
    };
    assert_eq!(state.controls(), expected);
}

#[test]
fn another_scene_keeps_the_depth_mapping() {
    let mut state = front_view();
    let standard = DepthMapping::Standard;
    let controls = LensControls {
        depth: standard,
        ..state.controls()
    };
    state.apply(Action::Lens(controls));
    state.open(row(), Vec::new()).expect("a scene");
    assert_eq!(state.controls().depth, standard);
    assert_eq!(state.view().camera.lens().depth, standard);
}
