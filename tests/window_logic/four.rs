//! Each of the four views shows its own stage, the mouse moves each alone, and a point is the same point in all.

use super::*;
use sightline::viewer::model::projected;

const STAGES: [Stage; 4] = [Stage::Object, Stage::World, Stage::View, Stage::Ndc];

/// The demo with four views over it.
fn four(camera: CameraChoice) -> State {
    let loaded = scene::load(&[], &Progress::default()).expect("the demo");
    let mut state = open(loaded, camera);
    state.apply(Action::Views(Views::Four));
    state
}

/// Applies an action in one of the views.
fn within(state: &mut State, stage: Stage, action: Action) {
    state.apply(Action::Enter(Some(stage)));
    state.apply(action);
    state.apply(Action::Enter(None));
}

/// Where a view shows a point of an object.
fn px_in(state: &State, stage: Stage, object: usize, point_world: DVec3) -> Option<DVec2> {
    let at = match stage {
        Stage::Object => state.scene().objects()[object]
            .placement
            .point_to_object(point_world),
        Stage::World | Stage::View => point_world,
        Stage::Ndc => state.ndc_drawn(point_world)?,
    };
    Some(state.pane_view(stage)?.project(at)?.px)
}

fn eyes(state: &State) -> [DVec3; 4] {
    STAGES.map(|stage| state.pane_view(stage).expect("a view").camera.eye())
}

#[test]
fn a_point_clicked_in_any_view_is_the_point_that_the_picture_gives() {
    let ortho = CameraChoice {
        ortho: Some(6.0),
        ..CameraChoice::default()
    };
    let standard = CameraChoice {
        depth: Some(DepthMapping::Standard),
        ..CameraChoice::default()
    };
    for camera in [CameraChoice::default(), ortho, standard] {
        let mut state = four(camera);
        // The views are so large that their pixels are smaller than the picture's.
        let large = Viewport::new(16_000, 12_000).expect("a viewport");
        for stage in STAGES {
            within(&mut state, stage, Action::Resize(large));
        }
        let mut same = [0; 4];
        for (x, y) in (0..20).flat_map(|i| (0..15).map(move |j| (i, j))) {
            let px = DVec2::new(20.5 + 40.0 * f64::from(x), 20.5 + 40.0 * f64::from(y));
            let Some(expected) = pick::pick(state.scene(), state.view(), px) else {
                continue;
            };
            // The object view shows the space of the picked object.
            state.apply(Action::Select(Some(expected.id - 1)));
            for (i, stage) in STAGES.into_iter().enumerate() {
                let at = px_in(&state, stage, expected.id - 1, expected.point_world);
                within(&mut state, stage, Action::Click(at.expect("in front"), 0.0));
                // In a view, other objects may be in front of the point.
                same[i] += u32::from(state.picked() == Some(&expected));
            }
        }
        assert!(same.iter().all(|same| *same > 40), "{camera:?}: {same:?}");
    }
}

#[test]
fn a_point_that_the_camera_does_not_see_is_followed_all_the_same() {
    let mut state = four(CameraChoice {
        near: Some(1.0),
        far: Some(6.0),
        ..CameraChoice::default()
    });
    let behind = state
        .scene()
        .objects()
        .iter()
        .position(|object| object.name == "Ball");
    let ball = behind.expect("the demo's");
    let centre = state.scene().bounds_of(ball).center();
    assert!(state.view().camera.to_view(centre).z > 6.0);
    let px = px_in(&state, Stage::World, ball, centre).expect("in front");
    within(&mut state, Stage::World, Action::Click(px, 0.0));
    assert_eq!(selected(&state), Some("Ball"));
    assert_eq!(state.picked(), None, "no pixel shows it");
    let followed = state.followed().expect("a point");
    assert!(followed.is_picked && followed.object == ball);
    assert!(
        (followed.point_object.length() - 0.5).abs() < 1e-9,
        "on the ball"
    );
    state.apply(Action::Select(None));
    assert_eq!(state.followed(), None);
}

#[test]
fn what_the_mouse_does_in_a_view_moves_that_view_alone() {
    for (i, stage) in STAGES.into_iter().enumerate() {
        let mut state = four(CameraChoice::default());
        let camera = state.view().camera;
        for action in [
            Action::BeginTurn(MIDDLE),
            Action::Turn(DVec2::new(40.0, 9.0)),
            Action::BeginPan(MIDDLE),
            Action::Pan(DVec2::new(-30.0, 9.0)),
            Action::Zoom(MIDDLE, 1.3),
            Action::LookFrom(DVec3::X),
            Action::ResetView,
        ] {
            let before = eyes(&state);
            within(&mut state, stage, action);
            for (j, (was, is)) in before.into_iter().zip(eyes(&state)).enumerate() {
                let moves = i == j && !matches!(action, Action::BeginTurn(_) | Action::BeginPan(_));
                assert_eq!(was != is, moves, "{action:?} in {stage:?}");
            }
            assert_eq!(state.view().camera, camera, "the scene's camera stands");
        }
        assert_eq!(state.next_step(true), None, "none of that is a step");
    }
}

#[test]
fn the_view_stage_stands_still_while_the_camera_turns() {
    let mut state = four(CameraChoice::default());
    let seen = |state: &State| {
        let (camera, observer) = (state.view().camera, state.pane_view(Stage::View));
        let observer = observer.expect("a view");
        [camera.right(), camera.up(), camera.forward()]
            .map(|axis| observer.project(camera.eye() + axis).expect("in front").px)
    };
    let (before, world) = (seen(&state), eyes(&state)[1]);
    state.apply(Action::Steer(DVec2::new(90.0, 30.0)));
    for (was, is) in before.into_iter().zip(seen(&state)) {
        assert!(was.distance(is) < 1e-6, "{was} and {is}");
    }
    assert_eq!(eyes(&state)[1], world, "and in the world the camera moves");
    // Nothing is mirrored: right is right, up is up, and forward leads away from somebody who looks from behind.
    let [right, up, _] = before;
    let eye = state.view().camera.eye();
    let eye = state
        .pane_view(Stage::View)
        .expect("a view")
        .project(eye)
        .expect("in front")
        .px;
    assert!(right.x > eye.x && up.y < eye.y, "{right} {up} {eye}");
}

#[test]
fn planes_are_the_camera_s_and_no_view_cuts_them() {
    for (near, far) in [
        (None, None),
        (Some(0.01), Some(400.0)),
        (Some(5.0), Some(6.0)),
    ] {
        let mut state = four(CameraChoice {
            near,
            far,
            ..CameraChoice::default()
        });
        let lens = *state.view().camera.lens();
        assert!(near.is_none_or(|near| near.to_bits() == lens.near.to_bits()));
        for _ in 0..3 {
            state.apply(Action::Views(Views::Picture));
            state.apply(Action::Views(Views::Four));
            state.apply(Action::Lens(state.controls()));
        }
        assert_eq!(
            *state.view().camera.lens(),
            lens,
            "its frustum is nothing that planes are fitted to"
        );
        for stage in [Stage::World, Stage::View] {
            let seen = state.pane_view(stage).expect("a view");
            let own = seen.camera.lens();
            for corner in state.view().frustum_corners() {
                let at = seen.project(corner).expect("in front");
                assert!(own.near < at.depth && at.depth < own.far, "{stage:?}");
                assert!(seen.viewport.contains(at.px), "{stage:?}: {}", at.px);
            }
        }
    }
}

#[test]
fn ndc_is_what_the_camera_projects_and_is_cut_at_its_near_plane() {
    let mut state = front_view();
    state.apply(Action::SetVisible(2, false));
    state.apply(Action::Lens(LensControls {
        depth: DepthMapping::Standard,
        ..state.controls()
    }));
    let corners = state.scene().bounds_of(0).corners();
    let made = projected(state.scene(), state.view());
    let ndc = corners.map(|corner| {
        let ndc = state.view().project(corner).expect("in front").ndc;
        DVec3::new(ndc.x, ndc.y, -ndc.z)
    });
    let expected = Aabb::around(ndc);
    let bounds = made.bounds_of(0);
    let apart = (bounds.min - expected.min).length() + (bounds.max - expected.max).length();
    assert!(apart < 1e-6, "{bounds:?}, not {expected:?}");
    assert!(!made.objects()[2].visible, "what is hidden stays hidden");
    // NDC is drawn in the same place with either depth mapping.
    let reversed = LensControls {
        depth: DepthMapping::Reversed,
        ..state.controls()
    };
    state.apply(Action::Lens(reversed));
    assert_eq!(projected(state.scene(), state.view()).bounds_of(0), bounds);
    // Front faces stay front faces, even if M mirrors.
    let mirrored = DAffine3::from_scale(DVec3::new(-1.0, 1.0, 1.0));
    state.apply(Action::Place(1, mirrored));
    let made = projected(state.scene(), state.view());
    for object in [0, 1] {
        let middle = made.bounds_of(object).center();
        let from = middle.with_z(2.0);
        let target = Some(middle);
        let seen = CameraChoice {
            eye: Some(from),
            target,
            ..CameraChoice::default()
        };
        let alone = Loaded {
            scene: Scene::new(vec![made.objects()[object].clone()]),
            ..Loaded::default()
        };
        let seen = open(alone, seen);
        let hit = pick::pick(seen.scene(), seen.view(), MIDDLE + 0.25).expect("before it");
        assert!(hit.front, "object {object}");
    }
    state.apply(Action::Lens(LensControls {
        near: Some(8.0),
        ..state.controls()
    }));
    let bounds = projected(state.scene(), state.view()).bounds_of(0);
    assert!(
        bounds.max.z.abs() < 1e-6,
        "it begins on the near plane, not at {}",
        bounds.max.z
    );
    assert!(
        bounds.min.z < -0.05 && bounds.min.z > -1.0,
        "{}",
        bounds.min.z
    );
}

/// NDC shows what the section leaves of each object, up to the plane and no further.
#[test]
fn ndc_ends_at_the_section() {
    let mut state = front_view();
    let whole = projected(state.scene(), state.view());
    let positions = |scene: &Scene, object: usize| {
        let Shape::Mesh { mesh, part } = &scene.objects()[object].shape else {
            panic!("a mesh");
        };
        let data = mesh.data();
        let triangles = &data.triangles[data.parts[*part].triangles.start as usize..];
        let count = data.parts[*part].triangles.len();
        let corners = triangles[..count].iter().flatten();
        let positions = corners.map(|place| data.positions[*place as usize]);
        positions.collect::<Vec<_>>()
    };
    for normal in [DVec3::X, DVec3::new(0.3, -0.2, 0.1), DVec3::NEG_Y] {
        let section = Section::through(DVec3::new(0.1, 0.05, 0.0), normal).expect("a section");
        state.apply(Action::Section(Some(section)));
        let view = *state.view();
        let cut = projected(state.scene(), &view);
        let lens = Lens {
            depth: DepthMapping::Standard,
            ..*view.camera.lens()
        };
        let (a, b) = lens.depth_row();
        let side = |at: &[f32; 3]| {
            let [x, y, z] = at.map(f64::from);
            let px = DVec2::new(x + 1.0, 1.0 - y) * 0.5 * view.viewport.size_px();
            section.side(view.uncut().ray(px).at(b / (-z - a)))
        };
        for object in 0..3 {
            let (before, after) = (positions(&whole, object), positions(&cut, object));
            // An upper bound of the rounding in f32, and a distance far beyond it.
            let (rounding, off) = (1e-4, 1e-2);
            assert!(after.iter().all(|at| side(at) > -rounding), "{object}");
            let on_plane = after.iter().filter(|at| side(at).abs() < rounding).count();
            // The plane cuts the square's border in two places, and a solid in more.
            assert!(on_plane >= [4, 4, 2][object], "{object}: {on_plane}");
            let (kept, gone): (Vec<_>, Vec<_>) = before.iter().partition(|at| side(at) > -rounding);
            assert!(!gone.is_empty() && !kept.is_empty(), "{object}");
            let kept = kept.into_iter().filter(|at| side(at) > off);
            for at in kept {
                assert!(after.contains(&at), "{object}: {at:?}");
            }
        }
    }
}

#[test]
fn views_follow_edits_undo_and_another_scene() {
    let mut state = front_view();
    state.apply(Action::Views(Views::Four));
    assert_eq!(
        state.pane_object(),
        Some(0),
        "what the camera has in its middle"
    );
    state.apply(Action::Select(Some(1)));
    assert_eq!(state.pane_object(), Some(1));
    state.apply(Action::Select(None));
    assert_eq!(state.pane_object(), Some(1), "until another is selected");
    assert_eq!(
        state.object_bounds(1).max,
        DVec3::splat(0.5),
        "no matrix moves it"
    );
    let centre = |state: &State| state.followed_world();
    state.apply(Action::Click(MIDDLE, 0.0));
    let before = centre(&state).expect("the cube");
    state.apply(Action::Place(
        0,
        DAffine3::from_translation(DVec3::new(0.0, 0.1, 2.5)),
    ));
    assert_ne!(centre(&state), Some(before));
    state.apply(Action::Undo);
    assert_eq!(centre(&state), Some(before));
    assert_eq!(state.views(), Views::Four, "views are no step");
    state.open(row(), Vec::new()).expect("a scene");
    assert_eq!(state.views(), Views::Four);
    for corner in state.view().frustum_corners() {
        let seen = state.pane_view(Stage::World).expect("a view");
        assert!(
            seen.viewport
                .contains(seen.project(corner).expect("in front").px)
        );
    }
    // The four views show the camera themselves, so it cannot be frozen.
    state.apply(Action::ToggleFreeze);
    assert_eq!(state.frozen(), None);
}

/// The world view shows the camera itself. Back in the picture, the frozen one stands where it stood.
#[test]
fn a_frozen_camera_outlasts_the_four_views() {
    let mut state = front_view();
    state.apply(Action::ToggleFreeze);
    let frozen = state.frozen().copied();
    assert!(frozen.is_some());
    state.apply(Action::LookFrom(DVec3::ONE));
    let view = *state.view();
    state.apply(Action::Views(Views::Four));
    assert_eq!(state.frozen(), None);
    state.apply(Action::Views(Views::One(Stage::Ndc)));
    state.apply(Action::Views(Views::Picture));
    assert_eq!(state.frozen().copied(), frozen);
    assert_eq!(*state.view(), view, "near and far hold it as before");
    // Another scene has no frozen camera, and the way back leads to it again.
    state.apply(Action::Views(Views::Four));
    let path = std::path::PathBuf::from("gallery:needles");
    let loaded = scene::load(std::slice::from_ref(&path), &Progress::default()).expect("it loads");
    state.open(loaded, vec![path]).expect("a scene");
    state.apply(Action::Views(Views::Picture));
    assert_eq!(state.frozen(), None);
    state.leave_gallery();
    assert_eq!(state.frozen().copied(), frozen);
}
