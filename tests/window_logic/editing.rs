//! When a model matrix is edited, picks follow, invalid matrices are refused, and the saved scene is the one shown.

use super::*;
use crate::inspect::STILL;
use glam::{DMat3, DQuat};
use sightline::{
    geometry::Trs,
    viewer::model::{MeasureAction, What},
};

fn place(state: &mut State, object: usize, trs: Trs) {
    state.apply(Action::Place(object, trs.to_model()));
}

#[test]
fn a_moved_object_s_pick_follows() {
    let mut state = front_view();
    state.apply(Action::Click(MIDDLE, 0.0));
    let before = state.picked().expect("a cube").clone();
    let revision = state.visibility_revision();
    let aside = Trs {
        translation: DVec3::new(0.2, 0.0, 2.0),
        ..STILL
    };
    place(&mut state, 0, aside);
    let after = state.picked().expect("still under the pixel");
    assert!((after.point_object.x - (before.point_object.x - 0.2)).abs() < 1e-12);
    assert!(after.point_world.distance(before.point_world) < 1e-12);
    assert_ne!(state.visibility_revision(), revision, "it is drawn anew");
    assert_eq!(
        Some(after),
        pick::pick(state.scene(), state.view(), MIDDLE + 0.5).as_ref()
    );
    assert!(state.edited());

    place(
        &mut state,
        0,
        Trs {
            scale: DVec3::splat(2.0),
            ..STILL
        },
    );
    let grown = state.picked().expect("twice as large");
    assert!((grown.distance - 7.0).abs() < 1e-4, "{}", grown.distance);
    place(
        &mut state,
        0,
        Trs {
            rotation_deg: DVec3::new(0.0, 45.0, 0.0),
            ..STILL
        },
    );
    let turned = state.picked().expect("its edge").distance;
    // The pick is half a pixel beside the edge.
    assert!((turned - (8.0 - 0.5_f64.sqrt())).abs() < 1e-2, "{turned}");

    // An object moved away from the pixel stays selected, without a point. Moved back, it has a point again.
    place(
        &mut state,
        0,
        Trs {
            translation: DVec3::new(3.0, 0.0, 2.0),
            ..STILL
        },
    );
    assert_eq!((selected(&state), state.picked()), (Some("front"), None));
    place(&mut state, 0, STILL);
    assert_eq!(state.picked(), Some(&before));
    assert_eq!(state.hits().map(|hits| hits.picks.len()), Some(5));
}

/// A selected object's pick stays on its own surface, whatever is in front of it.
#[test]
fn an_object_behind_another_keeps_its_own_pick() {
    let mut state = front_view();
    state.apply(Action::Click(MIDDLE, 0.0));
    state.apply(Action::StepTo(3));
    assert_eq!(selected(&state), Some("middle"));
    place(
        &mut state,
        1,
        Trs {
            translation: DVec3::new(0.1, 0.0, 0.0),
            ..STILL
        },
    );
    let pick = state.picked().expect("its back, still");
    assert_eq!((pick.object.as_str(), pick.front), ("middle", false));
    assert_eq!(state.hits().and_then(|hits| hits.at), Some(3));
}

#[test]
fn a_singular_matrix_is_refused_with_the_reason() {
    let mut state = front_view();
    state.apply(Action::Click(MIDDLE, 0.0));
    let (before, revision) = (state.picked().cloned(), state.visibility_revision());
    let flat = Action::Place(
        0,
        Trs {
            scale: DVec3::new(1.0, 0.0, 1.0),
            ..STILL
        }
        .to_model(),
    );
    let reason = state.check(&flat).expect_err("no inverse").to_string();
    assert_eq!(
        reason,
        "the model matrix has no inverse with numbers up to 1.29e33 (is a scale zero?)"
    );
    let endless = Action::Place(
        0,
        Trs {
            scale: DVec3::splat(f64::INFINITY),
            ..STILL
        }
        .to_model(),
    );
    state.check(&endless).expect_err("not finite");
    for action in [flat, endless] {
        state.apply(action);
        assert_eq!(state.picked().cloned(), before);
        assert_eq!(
            (state.visibility_revision(), state.edited()),
            (revision, false)
        );
    }
}

#[test]
fn an_edited_scene_saves_as_it_is_and_reads_again_as_it_was() {
    let mut state = front_view();
    let trs = Trs {
        translation: DVec3::new(0.1, 0.2, 0.3),
        rotation_deg: DVec3::new(10.0, 20.0, 30.0),
        scale: DVec3::new(1.0, -2.0, 3.0),
    };
    place(&mut state, 0, trs);
    let text = description::to_toml(state.scene(), &state.camera_choice(), &[]).expect("saved");
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("edited.toml");
    std::fs::write(&path, text).expect("written");
    let loaded = scene::load(&[path], &Progress::default()).expect("it loads");
    let model = loaded.scene.objects()[0].placement.model();
    assert_eq!(model, trs.to_model(), "to the bit");
    // If position, rotation and scale give a matrix to the bit, they are written in its place.
    let plain = description::to_toml(&row().scene, &state.camera_choice(), &[]).expect("saved");
    assert!(!plain.contains("matrix"), "{plain}");
    state.reload(row());
    assert!(!state.edited());
    assert_eq!(
        state.scene().objects()[0].placement.model(),
        STILL.to_model()
    );
}

#[test]
fn a_matrix_in_parts_is_the_matrix() {
    let angles = [
        -180.0,
        -90.0,
        -37.5,
        0.0,
        1e-7,
        45.0,
        89.999_999_9,
        90.0,
        171.0,
    ];
    let scales = [
        DVec3::ONE,
        DVec3::new(-1.0, 2.0, 0.5),
        DVec3::new(3.0, -1e-6, 1e4),
    ];
    for (x, y) in angles.into_iter().flat_map(|x| angles.map(|y| (x, y))) {
        for (z, scale) in angles
            .into_iter()
            .flat_map(|z| scales.map(|scale| (z, scale)))
        {
            let rotation_deg = DVec3::new(x, y, z);
            let given = Trs {
                translation: DVec3::new(7.0, -8.0, 9.0),
                rotation_deg,
                scale,
            };
            let parts = Trs::of(given.to_model()).expect("no shear");
            let (a, b) = (given.to_model().matrix3, parts.to_model().matrix3);
            // Columns are compared relative to their lengths.
            for axis in 0..3 {
                let apart = a.col(axis).distance(b.col(axis)) / a.col(axis).length();
                assert!(apart < 1e-14, "{given:?} and {parts:?}: {apart}");
            }
            assert_eq!(parts.translation, given.translation);
        }
    }
    // The rotations apply in the documented order, checked against glam's quaternions.
    let given = Trs {
        rotation_deg: DVec3::new(10.0, 20.0, 30.0),
        ..STILL
    };
    let [x, y, z] = given.rotation_deg.to_array().map(f64::to_radians);
    let turned = DMat3::from_quat(
        DQuat::from_rotation_z(z) * DQuat::from_rotation_y(y) * DQuat::from_rotation_x(x),
    );
    assert!((given.to_model().matrix3 - turned).abs_diff_eq(DMat3::ZERO, 1e-15));
    let parts = Trs::of(given.to_model()).expect("no shear");
    assert!(parts.rotation_deg.distance(given.rotation_deg) < 1e-12);
    // A sheared matrix has no such parts.
    let mut leaning = DAffine3::IDENTITY;
    leaning.matrix3.x_axis.y = 1e-6;
    assert_eq!(Trs::of(leaning), None);
}

/// A saved scene opens again: what is too large or small for views is refused when it is typed.
#[test]
fn sizes_that_no_view_holds_are_refused() {
    let mut state = front_view();
    for scale in [1e31, 1e300] {
        let scale = DVec3::new(scale, 1.0, 1.0);
        let action = Action::Place(0, Trs { scale, ..STILL }.to_model());
        assert!(state.check(&action).is_err(), "{scale}");
        state.apply(action);
        assert!(!state.edited(), "{scale}");
    }
    let scale = DVec3::new(1e29, 1.0, 1.0);
    let action = Action::Place(0, Trs { scale, ..STILL }.to_model());
    assert_eq!(state.check(&action), Ok(()));
    state.apply(action);
    assert!(state.edited());
}

/// What is hidden and shown again is no edit, in whichever way it was. What the file hides is an edit once it is shown.
#[test]
fn what_shows_as_in_the_file_is_no_edit() {
    let mut state = front_view();
    let count = state.scene().objects().len();
    assert!(count > 1 && !state.unsaved());
    state.apply(Action::Select(Some(0)));
    state.apply(Action::Isolate);
    assert!(state.unsaved());
    state.apply(Action::ShowAll);
    assert!(!state.unsaved(), "isolated, and shown again");
    for visible in [false, true] {
        for object in 0..count {
            assert_eq!(state.unsaved(), object > 0 || visible, "{object}");
            state.apply(Action::SetVisible(object, visible));
        }
    }
    assert!(!state.unsaved(), "one by one");
    // Undo leads through the same edits.
    for step in 0..2 * count {
        state.apply(Action::Undo);
        assert_eq!(state.unsaved(), step + 1 < 2 * count, "{step}");
    }
    // A matrix is an edit, whatever shows.
    let aside = Trs {
        translation: DVec3::new(0.2, 0.0, 2.0),
        ..STILL
    };
    place(&mut state, 0, aside);
    state.apply(Action::Isolate);
    state.apply(Action::ShowAll);
    assert!(state.unsaved() && state.edited());
}

/// Points may have moved with the object that they were clicked on, and what was measured of them is of the past.
#[test]
fn a_move_marks_the_measures_before_it_and_forgets_the_points() {
    let mut state = front_view();
    state.apply(Action::Click(MIDDLE, 0.0));
    state.apply(Action::Step { forward: true });
    state.apply(Action::Measure(MeasureAction::Add(What::Distance)));
    let outdated = |state: &State| {
        let list = state.measuring().list.iter();
        list.map(|entry| entry.outdated).collect::<Vec<_>>()
    };
    assert_eq!(outdated(&state), [false]);
    let aside = Trs {
        translation: DVec3::new(0.2, 0.0, 2.0),
        ..STILL
    };
    place(&mut state, 0, aside);
    assert_eq!(outdated(&state), [true]);
    assert!(state.measuring().points.is_empty());
}
