//! Undo and redo bring back what was there before, to the bit.

use super::*;
use crate::inspect::STILL;
use sightline::{
    geometry::Trs,
    viewer::model::{RayHits, Selection},
};

/// Everything that a user sees of scene and view.
#[derive(Clone, Debug, PartialEq)]
struct Seen {
    models: Vec<[u64; 12]>,
    visible: Vec<bool>,
    view: sightline::camera::View,
    controls: LensControls,
    up_axis: UpAxis,
    selection: Option<Selection>,
    hits: Option<RayHits>,
    name: String,
}

fn seen(state: &State) -> Seen {
    let objects = state.scene().objects();
    let model = |object: &Object| object.placement.model().to_cols_array().map(f64::to_bits);
    Seen {
        models: objects.iter().map(model).collect(),
        visible: objects.iter().map(|object| object.visible).collect(),
        view: *state.view(),
        controls: state.controls(),
        up_axis: state.up_axis(),
        selection: state.selection().cloned(),
        hits: state.hits().cloned(),
        name: state.name().to_owned(),
    }
}

fn moved(x: f64) -> Action {
    let trs = Trs {
        translation: DVec3::new(x, 0.0, 2.0),
        ..STILL
    };
    Action::Place(0, trs.to_model())
}

#[test]
fn every_change_is_undone_and_done_again_to_the_bit() {
    let lens = |change: fn(&mut LensControls)| {
        let mut controls = front_view().controls();
        change(&mut controls);
        Action::Lens(controls)
    };
    let pasted = CameraChoice {
        eye: Some(DVec3::new(3.0, 1.0, 9.0)),
        target: Some(DVec3::ZERO),
        ..CameraChoice::default()
    };
    let changes = [
        moved(0.2),
        moved(9.0),
        Action::SetVisible(1, false),
        Action::HideSelection,
        Action::Isolate,
        Action::FrameSelection,
        Action::LookFrom(DVec3::X),
        Action::Pose([DVec3::new(5.0, 4.0, 3.0), DVec3::ZERO, DVec3::Y]),
        lens(|controls| controls.fov_deg = 20.0),
        lens(|controls| controls.near = Some(8.25)),
        Action::ToggleProjection,
        Action::ToggleSides,
        Action::UpAxis(UpAxis::Z),
        Action::Camera(pasted),
        Action::Recentre(MIDDLE + 20.0),
    ];
    for change in changes {
        let mut state = front_view();
        assert_eq!(state.next_step(true), None);
        state.apply(Action::Turn(DVec2::new(31.0, -17.0)));
        state.apply(Action::Click(MIDDLE, 0.0));
        let before = seen(&state);
        assert!(before.hits.is_some());
        state.apply(change);
        let after = seen(&state);
        assert_ne!(after, before, "{change:?} changes something");
        assert!(state.next_step(true).is_some(), "{change:?}");
        for _ in 0..2 {
            state.apply(Action::Undo);
            assert_eq!(seen(&state), before, "{change:?}");
            assert_eq!((state.next_step(true), state.edited()), (None, false));
            assert!(!state.unsaved());
            state.apply(Action::Redo);
            assert_eq!(seen(&state), after, "{change:?}");
            assert_eq!(state.next_step(false), None);
        }
    }
}

/// A long history of all kinds of changes is undone and done again.
#[test]
fn a_history_is_walked_there_and_back() {
    let mut state = front_view();
    state.apply(Action::Click(MIDDLE, 0.0));
    let mut pictures = vec![seen(&state)];
    let changes = [
        moved(0.1),
        Action::LookFrom(DVec3::ONE),
        Action::SetVisible(2, false),
        Action::ToggleProjection,
        Action::SetVisible(2, true),
        Action::FrameAll,
        moved(0.3),
        Action::ShowAll,
        Action::HideSelection,
        Action::Select(Some(1)),
        Action::Isolate,
    ];
    let mut done = 0;
    for change in changes {
        let steps = state.next_step(true);
        state.apply(change);
        let now = seen(&state);
        let is_step = !matches!(change, Action::Select(_) | Action::ShowAll);
        assert!(
            !is_step || state.next_step(true).is_some(),
            "{change:?} after {steps:?}"
        );
        if is_step {
            pictures.push(now);
            done += 1;
        } else {
            *pictures.last_mut().expect("one") = now;
        }
    }
    for picture in pictures[..done].iter().rev() {
        state.apply(Action::Undo);
        assert_eq!(seen(&state), *picture);
    }
    let before = seen(&state);
    state.apply(Action::Undo);
    assert_eq!(seen(&state), before, "there is nothing before the first");
    for _ in 0..done {
        state.apply(Action::Redo);
    }
    // Selecting is not a step of its own. Undo restores the selection that the step had.
    let last = pictures.last().expect("one");
    assert_eq!(
        (&seen(&state).models, &seen(&state).visible),
        (&last.models, &last.visible)
    );
    assert_eq!(seen(&state).view, last.view);
    state.apply(Action::Undo);
    state.apply(moved(0.7));
    assert_eq!(state.next_step(false), None, "another way was taken");
}

#[test]
fn what_is_dragged_or_slid_is_one_step() {
    let mut state = front_view();
    let before = seen(&state);
    for x in 1..50 {
        state.apply(moved(0.01 * f64::from(x)));
        state.apply(Action::Hover(Some(MIDDLE)));
    }
    state.apply(Action::Release);
    let dragged = seen(&state);
    for fov_deg in 20..40 {
        state.apply(Action::Lens(LensControls {
            fov_deg: fov_deg.into(),
            ..state.controls()
        }));
    }
    state.apply(Action::Release);
    state.apply(Action::Lens(LensControls {
        fov_deg: 50.0,
        ..state.controls()
    }));
    state.apply(Action::Undo);
    state.apply(Action::Undo);
    assert_eq!(seen(&state), dragged);
    state.apply(Action::Undo);
    assert_eq!(seen(&state), before);
    assert_eq!(state.next_step(true), None);
    // The drag of another object is another step.
    state.apply(moved(0.1));
    state.apply(Action::Place(1, DAffine3::from_translation(DVec3::X)));
    state.apply(Action::Undo);
    state.apply(Action::Undo);
    assert_eq!(seen(&state), before);
}

#[test]
fn what_changes_nothing_is_no_step() {
    let mut state = front_view();
    state.apply(Action::FrameAll);
    state.apply(Action::Undo);
    for nothing in [
        Action::Place(0, STILL.to_model()),
        Action::Place(9, STILL.to_model()),
        Action::Place(0, DAffine3::ZERO),
        Action::SetVisible(0, true),
        Action::ShowAll,
        Action::Isolate,
        Action::HideSelection,
        Action::Lens(state.controls()),
        Action::Lens(LensControls {
            fov_deg: 0.0,
            ..state.controls()
        }),
    ] {
        state.apply(nothing);
        assert_eq!(state.next_step(true), None, "{nothing:?}");
        assert!(
            state.next_step(false).is_some(),
            "{nothing:?} takes another way"
        );
    }
}

/// Moving the camera by mouse is not a step, and undoing a change of the scene leaves the camera alone.
#[test]
fn undoing_a_move_leaves_the_view() {
    let mut state = front_view();
    state.apply(moved(0.4));
    state.apply(Action::Turn(DVec2::new(200.0, 30.0)));
    let view = state.view().camera;
    state.apply(Action::Undo);
    assert_eq!(state.view().camera.eye(), view.eye());
    let at = |state: &State| state.scene().objects()[0].placement.model();
    assert_eq!(at(&state), STILL.to_model());
}

/// Undo takes a section away and leaves the camera where it was turned to since; so it is with back faces.
#[test]
fn undoing_a_section_leaves_the_camera() {
    let section = Section::through(DVec3::ZERO, DVec3::X).expect("a section");
    for change in [Action::Section(Some(section)), Action::ToggleSides] {
        let mut state = front_view();
        let uncut = *state.view();
        state.apply(change);
        let cut = *state.view();
        state.apply(Action::Turn(DVec2::new(40.0, 10.0)));
        let turned = state.view().camera.eye();
        assert_ne!(turned, uncut.camera.eye());
        state.apply(Action::Undo);
        let view = state.view();
        assert_eq!((view.section, view.sides), (uncut.section, uncut.sides));
        assert_eq!(view.camera.eye(), turned);
        state.apply(Action::Redo);
        let view = state.view();
        assert_eq!((view.section, view.sides), (cut.section, cut.sides));
        assert_eq!(view.camera.eye(), turned);
    }
}

fn exhibit(name: &str) -> (Loaded, Vec<std::path::PathBuf>) {
    let paths = vec![format!("gallery:{name}").into()];
    (
        scene::load(&paths, &Progress::default()).expect("it loads"),
        paths,
    )
}

#[test]
fn leaving_the_gallery_brings_back_scene_edits_view_and_selection() {
    let mut state = front_view();
    state.apply(moved(0.25));
    state.apply(Action::SetVisible(2, false));
    state.apply(Action::Turn(DVec2::new(31.0, -17.0)));
    state.apply(Action::Click(MIDDLE, 0.0));
    let before = seen(&state);
    assert!(state.unsaved() && state.edited());
    for name in ["needles", "stretched", "mirrored"] {
        let (loaded, paths) = exhibit(name);
        state.open(loaded, paths).expect("a scene");
        assert!(!state.edited(), "the gallery's is not");
        assert!(state.unsaved(), "but what was left is");
        state.apply(Action::LookFrom(DVec3::X));
    }
    let revision = state.scene_revision();
    let inside = seen(&state);
    state.leave_gallery();
    assert_eq!(seen(&state), before);
    assert!(state.edited() && state.showing().is_none());
    assert_ne!(state.scene_revision(), revision, "it is drawn anew");
    assert_ne!(seen(&state), inside);
    state.leave_gallery();
    assert_eq!(seen(&state), before, "there is nothing more to leave");
    // The scene still has its history.
    state.apply(Action::Undo);
    state.apply(Action::Undo);
    assert!(!state.edited() && !state.unsaved());
    assert_eq!(state.next_step(true), None);
}

/// A scene of the gallery has a history of its own, which does not lead out.
#[test]
fn undo_in_the_gallery_stays_there() {
    let mut state = front_view();
    state.apply(moved(0.25));
    let before = seen(&state);
    for name in ["needles", "stretched"] {
        let (loaded, paths) = exhibit(name);
        state.open(loaded, paths).expect("a scene");
        assert_eq!(state.next_step(true), None, "{name}");
        let opened = seen(&state);
        for turn in 0..1000 {
            state.apply(Action::LookFrom(if turn % 2 == 0 {
                DVec3::X
            } else {
                DVec3::Y
            }));
        }
        let mut steps = 0;
        while state.next_step(true).is_some() {
            state.apply(Action::Undo);
            steps += 1;
        }
        assert_eq!(steps, 256, "not without end");
        assert_eq!(seen(&state).name, opened.name);
    }
    state.leave_gallery();
    assert_eq!(seen(&state), before);
    assert_eq!(state.next_step(true), Some("model matrix"));
}

#[test]
fn another_file_begins_another_history() {
    let mut state = front_view();
    state.apply(moved(0.25));
    state.open(row(), Vec::new()).expect("a scene");
    assert_eq!((state.next_step(true), state.unsaved()), (None, false));
    state.apply(moved(0.5));
    state.reload(row());
    assert_eq!((state.next_step(true), state.unsaved()), (None, false));
    // A reload within the gallery keeps the way out.
    state.apply(moved(0.5));
    let before = seen(&state);
    let (loaded, paths) = exhibit("stretched");
    state.open(loaded, paths).expect("a scene");
    state.apply(Action::SetVisible(0, false));
    state.reload(exhibit("stretched").0);
    state.leave_gallery();
    assert_eq!(seen(&state), before);
}

/// What the files hold after a change: another object first, the others in another order, and the last one is gone.
fn changed() -> Loaded {
    Loaded {
        scene: Scene::new(vec![
            at(Shape::Cube, "new", [5.0, 0.0, 0.0]),
            at(Shape::Sphere, "middle", [0.0, 0.0, 0.0]),
            at(Shape::Cube, "front", [0.0, 0.0, 2.0]),
        ]),
        ..row()
    }
}

fn hidden(state: &State) -> Vec<&str> {
    let objects = state.scene().objects().iter();
    let hidden = objects.filter(|object| !object.visible);
    hidden.map(|object| object.name.as_str()).collect()
}

/// What is hidden stays hidden by its name. The history is about objects that may be gone, so it ends.
#[test]
fn a_reload_ends_the_history() {
    let mut state = front_view();
    state.apply(Action::SetVisible(2, false));
    state.apply(Action::SetVisible(1, false));
    let camera = state.view().camera;
    state.apply(Action::Turn(DVec2::new(31.0, -17.0)));
    let turned = state.view().camera.eye();
    assert_ne!(turned, camera.eye());
    state.apply(moved(0.25));
    state.apply(Action::Undo);
    state.reload(changed());
    assert_eq!(hidden(&state), ["middle"]);
    assert_eq!(state.view().camera.eye(), turned);
    assert!(state.unsaved() && !state.edited());
    assert_eq!(
        (state.next_step(true), state.next_step(false)),
        (None, None)
    );
    state.apply(Action::ShowAll);
    assert!(!state.unsaved(), "as the files show it");
    state.apply(Action::Undo);
    assert_eq!(hidden(&state), ["middle"]);
    assert!(state.unsaved());
}

#[test]
fn a_reload_of_the_same_leaves_the_history() {
    let mut state = front_view();
    state.apply(Action::Click(MIDDLE, 0.0));
    state.apply(moved(0.25));
    state.apply(Action::SetVisible(1, false));
    state.apply(Action::Undo);
    state.apply(Action::Undo);
    let (before, revision) = (seen(&state), state.scene_revision());
    state.reload(row());
    assert_eq!((seen(&state), state.scene_revision()), (before, revision));
    state.apply(Action::Redo);
    state.apply(Action::Redo);
    assert_eq!(hidden(&state), ["middle"]);
    assert!(state.edited());
    // The file's matrices are another scene.
    state.reload(row());
    assert_eq!(
        (state.next_step(true), state.next_step(false)),
        (None, None)
    );
    assert_eq!((hidden(&state), state.edited()), (vec!["middle"], false));
    assert!(state.unsaved());
}

/// An edit after a reload is as new as the one that the reload took away.
#[test]
fn an_edit_after_a_reload_is_one() {
    let mut state = front_view();
    state.apply(moved(0.2));
    state.reload(row());
    assert!(!state.has_edits());
    state.apply(moved(0.3));
    assert!(state.edited() && state.has_edits());
}
