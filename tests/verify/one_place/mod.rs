//! Surfaces in one place are named wherever drawing may show another surface than the picked one, and nowhere else.

mod bounds;
mod surfaces;

use crate::{
    blocks::one_mesh,
    common::{box_triangles, icosphere, orthographic, perspective, view},
    compare, drawn_once, places,
};
use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3, dvec2, dvec3};
use sightline::{
    camera::{Camera, DepthMapping, Lens, View},
    geometry::Placement,
    image::Id,
    pick::{self, InOnePlace, MOST_NAMED, SceneHit},
    scene::{Object, Scene, Shape},
    verify::{Class, Disagreement, Places, in_one_place},
};

fn object(name: &str, shape: Shape, model: DAffine3) -> Object {
    Object::new(name, shape, Placement::new(model).expect("invertible"))
}

fn moved(z: f64) -> DAffine3 {
    DAffine3::from_translation(dvec3(0.0, 0.0, z))
}

fn turned(degrees: f64, side: f64) -> DAffine3 {
    DAffine3::from_scale_rotation_translation(
        dvec3(side, side, 1.0),
        DQuat::from_rotation_z(degrees.to_radians()),
        DVec3::ZERO,
    )
}

/// A square mesh of side 2 about the origin in the plane z = 0, with these triangles.
fn quad(triangles: Vec<[u32; 3]>) -> Shape {
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let corners = corners.map(|[x, y]| [x, y, 0.0_f32]);
    one_mesh(corners.to_vec(), triangles, DVec3::ZERO)
}

fn halves() -> Shape {
    quad(vec![[0, 1, 2], [0, 2, 3]])
}

/// Three squares in one plane.
fn coplanar() -> Scene {
    Scene::new(vec![
        object("A", Shape::Square, DAffine3::IDENTITY),
        object("B", Shape::Square, turned(30.0, 1.0)),
        object("C", Shape::Square, turned(60.0, 0.7)),
    ])
}

fn centres(view: &View) -> impl Iterator<Item = DVec2> {
    let size = view.viewport;
    let row = move |y: u32| (0..size.width()).map(move |x| dvec2(x.into(), y.into()) + 0.5);
    (0..size.height()).flat_map(row)
}

/// Whether the surfaces in one place at a pixel include the id's triangle or one that shares a corner with it.
/// Neighbours count too, because triangles that meet count once and drawing may show the one across a shared edge.
pub fn name(scene: &Scene, places: &Places, pixel: [u32; 2], id: Id) -> bool {
    let px = DVec2::from(pixel.map(f64::from)) + 0.5;
    let Some(object) = scene.objects().get((id.object as usize).wrapping_sub(1)) else {
        return false;
    };
    let is_it = |hit: &SceneHit| match (&object.shape, hit.hit.on_triangle) {
        _ if hit.object + 1 != id.object as usize => false,
        (Shape::Mesh { mesh, .. }, Some(at)) => {
            let drawn = object.shape.first_triangle() + id.triangle - 1;
            let corners = |triangle: u32| mesh.data().triangles[triangle as usize];
            let is_shared = |corner| corners(at.triangle).contains(&corner);
            corners(drawn).into_iter().any(is_shared)
        }
        _ => true,
    };
    places.at(px).iter().any(is_it)
}

/// Whether a pixel is of the class *depth* because of two surfaces, and not because of the empty buffer or because
/// drawing cannot tell one of them from the near or far plane.
pub fn is_of_two_surfaces(view: &View, at: &Disagreement) -> bool {
    let lens = view.camera.lens();
    let off = 1e-5 * (lens.far - lens.near).min(lens.near.abs().max(lens.far.abs()));
    let is_on_plane =
        |depth: f64| (depth - lens.near).abs() <= off || (depth - lens.far).abs() <= off;
    at.class == Class::Depth
        && [at.drawn, at.picked].iter().all(|id| id.object > 0)
        && !at.depth.into_iter().any(is_on_plane)
}

/// Draws and compares. Counts the pixels of the class *depth*, those in one place, and the unexplained ones. Asserts
/// that at each pixel of the class *depth*, both the drawn and the picked surface are named.
#[track_caller]
fn counts(scene: &Scene, view: &View) -> [usize; 3] {
    scene.build_trees();
    let report = compare(
        scene,
        view,
        &drawn_once(scene, view),
        &pick::ids(scene, view),
    );
    let places = places(scene, view);
    for at in &report.disagreements {
        if at.class == Class::Depth {
            for id in [at.drawn, at.picked] {
                assert!(name(scene, &places, at.pixel, id), "{id:?} at {at:?}");
            }
        }
    }
    let marked = places.pixels(|| false);
    let alone = centres(view).filter(|px| !places.at(*px).is_empty());
    assert!(
        alone.eq(marked
            .iter()
            .map(|pixel| DVec2::from(pixel.map(f64::from)) + 0.5))
    );
    [
        report.count(Class::Depth),
        marked.len(),
        report.count(Class::Unexplained),
    ]
}
