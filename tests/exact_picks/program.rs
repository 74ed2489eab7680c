//! The program's answers. Every call that asks the program for one is in this file.

use glam::{DVec2, DVec3};
use sightline::{
    camera::View,
    geometry::{Ray, Sides},
    look::Background,
    pick::{self, Pick, SceneHit},
    scene::{Scene, Shape},
};

/// A hit as `closest` and `all` give it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    pub object: usize,
    /// Index among the triangles of the mesh.
    pub triangle: Option<u32>,
    pub front: bool,
    /// View depth, or the parameter of a given ray.
    pub t: f64,
    /// Outward, in object space, of any length.
    pub normal_object: DVec3,
    pub barycentric: Option<[f64; 3]>,
}

/// The nearest surface at a position.
pub fn closest(scene: &Scene, view: &View, px: DVec2) -> Option<Answer> {
    pick::closest(scene, view.ray(px), view.sides)
        .as_ref()
        .map(answer)
}

/// Every surface at a position, in order.
pub fn all(scene: &Scene, view: &View, px: DVec2) -> Vec<Answer> {
    let hits = pick::all(scene, view.ray(px), view.sides);
    hits.iter().map(answer).collect()
}

/// The record of the nearest surface at a position.
pub fn record(scene: &Scene, view: &View, px: DVec2) -> Option<Pick> {
    pick::pick(scene, view, px)
}

/// The records of every surface at a position, in order.
pub fn records(scene: &Scene, view: &View, px: DVec2) -> Vec<Pick> {
    pick::pick_all(scene, view, px)
}

/// The scene narrowed to one position, without trees; `None` where it cannot be narrowed.
pub fn narrowed(scene: &Scene, view: &View, px: DVec2) -> Option<Scene> {
    pick::narrowed(scene, view, px)
}

/// Object and triangle, both from 1, of each pixel, row by row, as both kinds of whole pictures have them.
pub fn pictures(scene: &Scene, view: &View) -> [Vec<(u32, u32)>; 2] {
    let (cast, _) = pick::raycast(scene, view, Background::DARK);
    [pick::ids(scene, view), cast].map(|ids| {
        let pixels = ids.pixels().iter();
        pixels.map(|id| (id.object, id.triangle)).collect()
    })
}

/// Every surface along a ray that is given by its numbers, in order, and the nearest.
pub fn along(scene: &Scene, ray: &Ray, sides: Sides) -> (Vec<Answer>, Option<Answer>) {
    let all = pick::all(scene, ray, sides);
    let closest = pick::closest(scene, ray, sides);
    (
        all.iter().map(answer).collect(),
        closest.as_ref().map(answer),
    )
}

/// Where the triangles of a record's object begin among those of its mesh.
pub fn first_triangle(shape: &Shape) -> u32 {
    shape.first_triangle()
}

fn answer(SceneHit { object, hit }: &SceneHit) -> Answer {
    Answer {
        object: *object,
        triangle: hit.on_triangle.map(|at| at.triangle),
        front: hit.front,
        t: hit.t,
        normal_object: hit.normal,
        barycentric: hit.on_triangle.map(|at| at.barycentric),
    }
}
