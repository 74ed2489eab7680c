//! Scenes open only when they are whole, keep the view when read again, and save what is shown.

use super::*;

#[test]
fn the_next_scene_replaces_the_first_only_when_it_is_whole() {
    let mut state = front_view();
    state.apply(Action::Click(MIDDLE, 0.0));
    let before = *state.view();
    let mut broken = row();
    broken.camera.fov = Some(-3.0);
    state.open(broken, Vec::new()).expect_err("no camera");
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
    state.open(next, Vec::new()).expect("a scene");
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

#[test]
fn a_scene_is_saved_to_its_own_file_unless_another_is_named() {
    let mut state = front_view();
    for (paths, file) in [
        (vec![], "scene.toml"),
        (vec!["somewhere/row.toml"], "somewhere/row.toml"),
        (vec!["model.obj"], "scene.toml"),
        (vec!["row.toml", "model.obj"], "scene.toml"),
    ] {
        let paths = paths.into_iter().map(Into::into).collect();
        state.open(row(), paths).expect("a scene");
        assert_eq!(state.file_to_save(), std::path::Path::new(file));
    }
}
