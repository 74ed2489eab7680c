//! What the program says: every call that asks it for an answer is in this file.

use glam::{DVec2, DVec3};
use sightline::{
    camera::View,
    geometry::Ray,
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
    /// View depth.
    pub t: f64,
    /// Outward, in object space, of any length.
    pub normal_object: DVec3,
    pub barycentric: Option<[f64; 3]>,
}

/// The nearest surface at a position.
pub fn closest(scene: &Scene, view: &View, px: DVec2) -> Option<Answer> {
    let ray = view.ray(px);
    let hit = pick::closest(scene, &ray, view.sides)?;
    Some(answer(scene, view, &ray, &hit))
}

/// Every surface at a position, in order.
pub fn all(scene: &Scene, view: &View, px: DVec2) -> Vec<Answer> {
    let ray = view.ray(px);
    let hits = pick::all(scene, &ray, view.sides);
    let answers = hits.iter().map(|hit| answer(scene, view, &ray, hit));
    answers.collect()
}

/// The record of the nearest surface at a position.
pub fn record(scene: &Scene, view: &View, px: DVec2) -> Option<Pick> {
    pick::pick(scene, view, px).map(|record| by_depth(view, px, record))
}

/// The records of every surface at a position, in order.
pub fn records(scene: &Scene, view: &View, px: DVec2) -> Vec<Pick> {
    let records = pick::pick_all(scene, view, px).into_iter();
    records.map(|record| by_depth(view, px, record)).collect()
}

/// Where the triangles of a record's object begin among those of its mesh.
pub fn first_triangle(shape: &Shape) -> u32 {
    shape.first_triangle()
}

fn answer(scene: &Scene, view: &View, ray: &Ray, SceneHit { object, hit }: &SceneHit) -> Answer {
    let placement = &scene.objects()[*object].placement;
    let local = placement.ray_to_object(ray);
    Answer {
        object: *object,
        triangle: hit.on_triangle.map(|at| at.triangle),
        front: hit.is_front(local.direction),
        t: hit.t * depth_per_t(view, ray),
        normal_object: hit.normal,
        barycentric: hit.on_triangle.map(|at| at.barycentric),
    }
}

/// While a ray's direction is a unit vector, `t` is the distance from where the ray starts.
fn depth_per_t(view: &View, ray: &Ray) -> f64 {
    ray.direction.dot(view.camera.forward())
}

fn by_depth(view: &View, px: DVec2, record: Pick) -> Pick {
    let scale = depth_per_t(view, &view.ray(px));
    Pick {
        t: record.t * scale,
        gap: record.gap.map(|gap| gap * scale),
        ..record
    }
}
