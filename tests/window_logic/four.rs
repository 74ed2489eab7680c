//! Each of the four views shows its own stage, the mouse moves each alone, and a point is the same point in all.

use super::*;

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
        Stage::Ndc => state.ndc().drawn(point_world)?,
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

/// With back faces hidden, the camera does not see the far side of a ball, which an observer behind it clicks. The near
/// side is another point, and is not picked in its place.
#[test]
fn a_back_that_the_camera_hides_is_followed_all_the_same() {
    let mut state = four(CameraChoice::default());
    let ball = (state.scene().objects().iter()).position(|object| object.name == "Ball");
    let ball = ball.expect("the demo's");
    let (centre, camera) = (state.scene().bounds_of(ball).center(), state.view().camera);
    within(&mut state, Stage::World, Action::LookFrom(camera.forward()));
    for (is_hidden, found) in [(false, Some(false)), (true, None)] {
        let px = px_in(&state, Stage::World, ball, centre).expect("in front");
        within(&mut state, Stage::World, Action::Click(px, 0.0));
        assert_eq!(state.picked().map(|pick| pick.front), found, "{is_hidden}");
        let followed = state.followed().expect("a point");
        assert!(followed.is_picked && followed.object == ball);
        let world = state.followed_world().expect("a point");
        assert!((world - centre).dot(camera.forward()) > 0.0, "its far side");
        state.apply(Action::Select(None));
        state.apply(Action::ToggleSides);
    }
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
fn ndc_is_what_the_camera_projects() {
    let mut state = front_view();
    let corners = state.scene().bounds_of(0).corners();
    let drawn = |state: &State| corners.map(|corner| state.ndc().drawn(corner));
    let reversed = drawn(&state);
    state.apply(Action::Lens(LensControls {
        depth: DepthMapping::Standard,
        ..state.controls()
    }));
    for (corner, drawn) in corners.into_iter().zip(drawn(&state)) {
        let ndc = state.view().project(corner).expect("in front").ndc;
        let expected = DVec3::new(ndc.x, ndc.y, -ndc.z);
        assert!(drawn.expect("behind near").distance(expected) < 1e-12);
    }
    // It is drawn in the same place with either depth mapping.
    assert_eq!(drawn(&state), reversed);
    state.apply(Action::Lens(LensControls {
        near: Some(8.0),
        ..state.controls()
    }));
    let is_there = |state: &State| drawn(state).map(|at| at.is_some());
    let far_half = corners.map(|corner| corner.z < 2.0);
    assert_eq!(is_there(&state), far_half, "it begins at the near plane");
}

/// Whatever is clicked in NDC is drawn at that pixel, behind the near plane, and kept by the section. Of a solid that
/// neither cuts, the front is clicked, even if its matrix mirrors.
#[test]
fn a_click_in_ndc_is_on_what_is_left_of_the_world() {
    let plane = |normal| Section::through(DVec3::new(0.1, 0.05, 0.0), normal).expect("a section");
    let sections = [DVec3::X, DVec3::new(0.3, -0.2, 0.1), DVec3::NEG_Y].map(plane);
    let sections = [None].into_iter().chain(sections.map(Some));
    let kinds = sections.flat_map(|section| [None, Some(8.0)].map(|near| (section, near)));
    for ((section, near), ortho) in kinds.flat_map(|kind| [(kind, None), (kind, Some(6.0))]) {
        let mut state = front_view();
        let mirrored = DAffine3::from_scale(DVec3::new(-1.0, 1.0, 1.0));
        state.apply(Action::Place(1, mirrored));
        state.apply(Action::Lens(LensControls {
            near,
            orthographic: ortho.is_some(),
            ..state.controls()
        }));
        state.apply(Action::Section(section));
        state.apply(Action::Views(Views::Four));
        let seen = state.pane_view(Stage::Ndc).expect("a view");
        let (mut of_object, mut at_border) = ([0; 3], 0);
        for (x, y) in (0..160).flat_map(|x| (0..120).map(move |y| (x, y))) {
            let px = DVec2::new(f64::from(x), f64::from(y)) * 5.0 + 0.5;
            within(&mut state, Stage::Ndc, Action::Hover(Some(px)));
            let Some((object, point)) = state.cursor().and_then(|cursor| cursor.hit) else {
                continue;
            };
            let placement = &state.scene().objects()[object].placement;
            let world = placement.point_to_world(point);
            let drawn = state.ndc().drawn(world).expect("behind near");
            assert_near(seen.project(drawn).expect("in front").px, px, 1e-6);
            let side = section.map_or(1.0, |section| section.side(world));
            assert!(side > -1e-9, "{side}");
            of_object[object] += 1;
            let depth = state.view().camera.to_view(world).z;
            if near.is_none() && section.is_none() && object < 2 {
                let outward = if object == 0 {
                    DVec3::AXES[point.abs().max_position()] * point[point.abs().max_position()]
                } else {
                    point
                };
                let along = [outward, outward.any_orthogonal_vector()];
                let along = [along[0], along[1], along[0].cross(along[1])];
                let [out, right, up] = along.map(|step| {
                    let beside = placement.point_to_world(point + 1e-6 * step);
                    state.ndc().drawn(beside).expect("behind near") - drawn
                });
                let normal = right.cross(up);
                let normal = normal * normal.dot(out).signum();
                let is_front = normal.dot(seen.camera.eye() - drawn) > 0.0;
                assert!(is_front, "{object} at {point}");
            }
            at_border += u32::from(near.is_some_and(|near| depth < near + 0.2));
        }
        let kind = (section, near, ortho);
        assert!(
            of_object[..2].iter().all(|count| *count > 5),
            "{kind:?}: {of_object:?}"
        );
        assert!(near.is_none() || at_border > 5, "{kind:?}: {at_border}");
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

/// The views are framed anew for another scene, wherever it lies.
#[test]
fn another_scene_is_in_all_four_views() {
    let mut state = front_view();
    state.apply(Action::Views(Views::Four));
    for stage in STAGES {
        within(&mut state, stage, Action::Turn(DVec2::new(20.0, 0.0)));
    }
    let next = Loaded {
        scene: Scene::new(vec![at(Shape::Sphere, "far away", [1e6, 0.0, 0.0])]),
        ..Loaded::default()
    };
    state.open(next, Vec::new()).expect("a scene");
    for stage in [Stage::World, Stage::View] {
        let seen = state.pane_view(stage).expect("a view");
        let point = state.scene().bounds_of(0).center();
        let at = seen.project(point).expect("in front");
        assert!(seen.viewport.contains(at.px), "{stage:?}: {}", at.px);
    }
}

/// A view that was moved stays where it is as the window gets another size.
#[test]
fn a_view_that_was_panned_is_not_framed_again() {
    let mut state = front_view();
    state.apply(Action::Views(Views::Four));
    let size = |width| Viewport::new(width, 300).expect("a viewport");
    for stage in STAGES {
        within(&mut state, stage, Action::Resize(size(400)));
        within(&mut state, stage, Action::Pan(DVec2::new(30.0, 20.0)));
    }
    let before = eyes(&state);
    for stage in STAGES {
        within(&mut state, stage, Action::Resize(size(200)));
    }
    assert_eq!(eyes(&state), before);
}
