//! The inspector tells the truth about surfaces behind each other, distances, triangles, depth steps and levels of
//! trees.

use super::*;
use sightline::{
    camera::Lens,
    geometry::{ColourRun, Mesh, MeshData, Part, Trs},
    viewer::model::triangle,
};
use std::sync::Arc;

pub const STILL: Trs = Trs {
    translation: DVec3::new(0.0, 0.0, 2.0),
    rotation_deg: DVec3::ZERO,
    scale: DVec3::ONE,
};

#[test]
fn every_surface_on_the_ray_is_listed_and_stepped_through() {
    let mut state = front_view();
    state.apply(Action::Step { forward: true });
    assert_eq!(state.hits(), None, "nothing was clicked");
    state.apply(Action::Click(MIDDLE, 0.0));
    let hits = state.hits().expect("a click").clone();
    let distances: Vec<f64> = hits.picks.iter().map(|pick| pick.distance).collect();
    for (distance, expected) in distances.iter().zip([7.5, 8.5, 9.5, 10.5, 12.0]) {
        assert!((distance - expected).abs() < 2e-4, "{distances:?}");
    }
    assert_eq!(hits.picks.len(), 5);
    for at in [1, 2, 3, 4, 0] {
        let line = state.apply(Action::Step { forward: true });
        assert_eq!(line.expect("a pick").hit.as_ref(), Some(&hits.picks[at]));
        assert_eq!(state.picked(), Some(&hits.picks[at]));
        assert_eq!(state.hits().and_then(|hits| hits.at), Some(at));
    }
    for at in [4, 3] {
        state.apply(Action::Step { forward: false });
        assert_eq!(state.picked(), Some(&hits.picks[at]));
    }
    assert!(state.apply(Action::StepTo(2)).is_some());
    assert_eq!(
        (selected(&state), state.picked()),
        (Some("middle"), Some(&hits.picks[2]))
    );
    assert_eq!(state.apply(Action::StepTo(5)), None);
    assert_eq!(state.picked(), Some(&hits.picks[2]), "there is no sixth");
    // A click goes on from the current surface.
    state.apply(Action::Click(MIDDLE, 10.0));
    assert_eq!(state.picked(), Some(&hits.picks[3]));
    // A hidden object is on no ray.
    state.apply(Action::HideSelection);
    let left: Vec<_> = state
        .hits()
        .expect("the ray")
        .picks
        .iter()
        .map(|pick| &pick.object)
        .collect();
    assert_eq!(left, ["front", "front", "back"]);
    state.apply(Action::Select(Some(0)));
    assert_eq!(state.hits(), None, "chosen from the list, not by a ray");
}

#[test]
fn the_last_two_picks_are_so_far_apart() {
    let mut state = front_view();
    state.apply(Action::Click(MIDDLE, 0.0));
    assert_eq!(state.measuring().points.len(), 1);
    state.apply(Action::Click(MIDDLE, 0.1));
    assert_eq!(
        state.measuring().points.len(),
        1,
        "the same point twice is one"
    );
    state.apply(Action::Step { forward: true });
    let by = |state: &State| {
        let [from, to] = state.measuring().last_two().expect("two");
        to.point_world - from.point_world
    };
    assert!(
        (by(&state).z + 1.0).abs() < 1e-12,
        "through the cube: {}",
        by(&state)
    );
    assert!((by(&state).length() - 1.0).abs() < 1e-5);
    state.apply(Action::StepTo(4));
    assert!(
        (by(&state).z + 3.5).abs() < 1e-12,
        "from its back to the square"
    );
    let names: Vec<_> = state
        .measuring()
        .points
        .iter()
        .map(|mark| mark.object.as_str())
        .collect();
    assert_eq!(names, ["front", "front", "back"]);
    state.apply(Action::Click(DVec2::new(3.0, 3.0), 9.0));
    assert!(
        (by(&state).z + 3.5).abs() < 1e-12,
        "nothing was picked beside them"
    );
    state.open(row(), Vec::new()).expect("a scene");
    assert!(state.measuring().points.is_empty());
}

#[test]
fn the_triangle_s_corners_weigh_up_to_the_point() {
    let mesh = Mesh::new(MeshData {
        origin: DVec3::new(100.0, 0.0, 0.0),
        positions: vec![
            [9.0, 9.0, 9.0],
            [-1.0, -1.0, 0.0],
            [1.0, -1.0, 0.0],
            [0.0, 2.0, 0.5],
        ],
        triangles: vec![[0, 1, 2], [1, 2, 3]],
        parts: vec![
            Part {
                name: "beside".into(),
                triangles: 0..1,
            },
            Part {
                name: "leaf".into(),
                triangles: 1..2,
            },
        ],
        colours: vec![ColourRun {
            triangles: 0..2,
            colour: None,
            material: None,
        }],
        ..MeshData::default()
    })
    .expect("a mesh");
    let trs = Trs {
        translation: DVec3::new(-150.0, 0.0, 0.0),
        rotation_deg: DVec3::new(10.0, 20.0, 30.0),
        scale: DVec3::new(1.5, 1.5, -1.5),
    };
    let shape = Shape::Mesh {
        mesh: Arc::new(mesh),
        part: 1,
    };
    let placement = Placement::new(trs.to_model()).expect("invertible");
    let mut state = open(
        Loaded {
            scene: Scene::new(vec![Object::new("leaf", shape, placement)]),
            ..Loaded::default()
        },
        CameraChoice::default(),
    );
    state.apply(Action::Click(MIDDLE, 0.0));
    let pick = state.picked().expect("framed");
    assert_eq!(pick.triangle, Some(0));
    let corners = triangle(state.scene(), pick).expect("a mesh");
    let weights = pick.barycentric.expect("a mesh");
    let sum: DVec3 = corners
        .into_iter()
        .zip(weights)
        .map(|(corner, weight)| weight * corner)
        .sum();
    assert!(
        sum.distance(pick.point_world) < 1e-12,
        "{sum} and {}",
        pick.point_world
    );
    let expected = trs.to_model().transform_point3(DVec3::new(99.0, -1.0, 0.0));
    assert!(corners[0].distance(expected) < 1e-12);
    let mut state = front_view();
    state.apply(Action::Click(MIDDLE, 0.0));
    let pick = state.picked().expect("a cube");
    assert_eq!(triangle(state.scene(), pick), None, "a cube has none");
}

#[test]
fn surfaces_closer_than_a_depth_step_are_known() {
    let camera = CameraChoice {
        eye: Some(DVec3::ZERO),
        target: Some(DVec3::NEG_Z),
        near: Some(0.01),
        far: Some(1e5),
        ..CameraChoice::default()
    };
    // A wall at 100 with a poster a millimetre in front of it.
    let wall = |z| Trs {
        translation: DVec3::new(0.0, 0.0, z),
        scale: DVec3::splat(50.0),
        ..STILL
    };
    let square = |name, z| {
        Object::new(
            name,
            Shape::Square,
            Placement::new(wall(z).to_model()).expect("invertible"),
        )
    };
    let scene = Scene::new(vec![square("wall", -100.0), square("poster", -99.999)]);
    let mut state = open(
        Loaded {
            scene,
            ..Loaded::default()
        },
        camera,
    );
    state.apply(Action::Click(MIDDLE, 0.0));
    let pick = state.picked().expect("the poster");
    assert_eq!(pick.object, "poster");
    let steps = state.depth_steps().expect("a pick");
    let [(reversed, fine), (standard, coarse)] = steps.steps;
    assert_eq!(
        (reversed, standard),
        (DepthMapping::Reversed, DepthMapping::Standard)
    );
    // Half an ulp of 1 is 2^-24; a step of NDC is z^2 / near in depth.
    let expected = 100.0 * 100.0 / 0.01 * 2.0_f64.powi(-24);
    assert!(
        (coarse / expected - 1.0).abs() < 1e-3,
        "{coarse} and {expected}"
    );
    assert!(
        fine < 1.3e-5 && fine > 3e-6,
        "{fine}: about a ten-millionth of the depth"
    );
    let next = steps.next_surface.expect("the wall");
    assert!((next - 1e-3).abs() < 1e-9, "{next}");
    assert!(steps.confuses(DepthMapping::Standard) && !steps.confuses(DepthMapping::Reversed));
    assert_eq!(steps.in_use, DepthMapping::Reversed);
    // They are those of the picture on screen: of another lens, and from elsewhere, where another surface is the next.
    let lens = LensControls {
        near: Some(0.02),
        depth: DepthMapping::Standard,
        ..state.controls()
    };
    state.apply(Action::Lens(lens));
    let other = state.depth_steps().expect("it is in view");
    assert_eq!(other.in_use, DepthMapping::Standard);
    assert_eq!(other.next_surface, steps.next_surface);
    assert!((other.steps[1].1 / (0.5 * expected) - 1.0).abs() < 1e-2);
    state.apply(Action::Zoom(MIDDLE, 0.5));
    let nearer = state.depth_steps().expect("it is in view");
    assert_eq!(nearer.next_surface, None);
    assert!(nearer.steps[1].1 > 3.0 * other.steps[1].1, "{nearer:?}");
    let beyond = LensControls {
        far: Some(50.0),
        ..state.controls()
    };
    state.apply(Action::Lens(beyond));
    assert_eq!(state.depth_steps(), None, "left out");
}

/// Through every lens, depths a step apart are stored as different numbers. Depths well within a step are stored as the
/// same number or as neighbours.
#[test]
fn a_depth_step_is_what_the_buffer_tells_apart() {
    let projections = [
        Projection::Perspective { fov_y: 0.8 },
        Projection::Orthographic { height: 3.0 },
    ];
    for projection in projections {
        for depth in [DepthMapping::Reversed, DepthMapping::Standard] {
            let lens = Lens {
                projection,
                near: 0.1,
                far: 1000.0,
                depth,
            };
            for z in [0.2, 1.0, 37.0, 900.0] {
                let step = lens.depth_step(z);
                #[expect(clippy::cast_possible_truncation, reason = "what the buffer stores")]
                let stored = |z| (lens.ndc_depth(z) as f32).to_bits();
                let apart = |steps: f64| stored(z).abs_diff(stored(z + steps * step));
                assert!(
                    step > 0.0 && (1..=2).contains(&apart(1.01)),
                    "{lens:?} {z}: {step}"
                );
                assert!(apart(0.3) <= 1, "{lens:?} {z}: {step}");
                assert!(
                    apart(10.0).abs_diff(10) <= 1,
                    "{lens:?} {z}: {}",
                    apart(10.0)
                );
            }
        }
    }
}

#[test]
fn a_copied_camera_is_the_camera_to_the_bit() {
    for orthographic in [false, true] {
        let mut state = front_view();
        state.apply(Action::Turn(DVec2::new(31.0, -17.0)));
        state.apply(Action::Zoom(MIDDLE, 1.3));
        let controls = LensControls {
            fov_deg: 37.3,
            orthographic,
            far: Some(123.4),
            ..state.controls()
        };
        state.apply(Action::Lens(controls));
        let mut other = front_view();
        assert_ne!(other.view(), state.view());
        other.apply(Action::Camera(state.camera_choice()));
        assert_eq!(other.view(), state.view());
        if !orthographic {
            assert_eq!(other.controls(), state.controls());
        }
    }
    let mut state = front_view();
    let before = *state.view();
    let none = CameraChoice {
        fov: Some(-1.0),
        ..CameraChoice::default()
    };
    state.check(&Action::Camera(none)).expect_err("no camera");
    state.apply(Action::Camera(none));
    assert_eq!(*state.view(), before);
}

#[test]
fn levels_of_trees_are_stepped_through() {
    let mut state = front_view();
    let mut step = |deeper| {
        state.apply(Action::TreeLevel { deeper });
        state.overlays().tree_level
    };
    for level in 0..=8 {
        assert_eq!(step(true), Some(level));
    }
    assert_eq!(step(true), None);
    assert_eq!([step(false), step(false)], [Some(8), Some(7)]);
}
