//! The window's state answers every action as a user expects. The tests apply the window's own actions to it, without a
//! window or a GPU.
#![cfg(feature = "window")]

#[path = "../common/mod.rs"]
mod common;
mod earlier_view;
mod editing;
mod four;
mod gallery;
mod inspect;
mod lens;
mod moving;
mod picking;
mod scenes;
mod undo;

use glam::{DAffine3, DVec2, DVec3};
use sightline::{
    camera::{CameraChoice, DepthMapping, Projection, UpAxis, Viewport},
    geometry::{Placement, Section, Sides},
    pick,
    scene::{self, Loaded, Object, Progress, Scene, Shape, description},
    viewer::model::{Action, DOUBLE_CLICK_S, LensControls, Matrices, Stage, State, Steps, Views},
};

const MIDDLE: DVec2 = DVec2::new(400.0, 300.0);

fn at(shape: Shape, name: &str, position: [f64; 3]) -> Object {
    let model = DAffine3::from_translation(position.into());
    Object::new(name, shape, Placement::new(model).expect("invertible"))
}

/// Three objects in a row along z.
fn row() -> Loaded {
    Loaded {
        scene: Scene::new(vec![
            at(Shape::Cube, "front", [0.0, 0.0, 2.0]),
            at(Shape::Sphere, "middle", [0.0, 0.0, 0.0]),
            at(Shape::Square, "back", [0.0, 0.0, -2.0]),
        ]),
        title: "row".into(),
        ..Loaded::default()
    }
}

fn open(loaded: Loaded, camera: CameraChoice) -> State {
    let viewport = Viewport::new(800, 600).expect("a viewport");
    State::new(loaded, camera, viewport, Sides::Both).expect("a camera")
}

fn front_view() -> State {
    let camera = CameraChoice {
        eye: Some(DVec3::new(0.0, 0.0, 10.0)),
        target: Some(DVec3::ZERO),
        ..CameraChoice::default()
    };
    open(row(), camera)
}

fn selected(state: &State) -> Option<&str> {
    let selection = state.selection()?;
    Some(&state.scene().objects()[selection.object].name)
}

#[track_caller]
fn assert_near(a: DVec2, b: DVec2, px: f64) {
    assert!(
        a.distance(b) < px,
        "{a} and {b} are {} px apart",
        a.distance(b)
    );
}
