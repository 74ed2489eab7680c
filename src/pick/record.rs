//! All that is known about a pick, and its JSON.

use super::{SceneHit, certainty, edge};
use crate::{camera::View, scene::Scene};
use glam::{DVec2, DVec3};
use serde::Serialize;

/// The full record of a pick. Lengths in world units; the field names are the JSON's.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Pick {
    /// The object's name.
    pub object: String,
    /// The object's number, from 1.
    pub id: usize,
    /// Triangle of the object, from 0; `None` for analytic shapes.
    pub triangle: Option<u32>,
    /// Whether the surface is seen from outside.
    pub front: bool,
    /// Parameter of the ray, whose direction has length 1.
    pub t: f64,
    /// From the eye to the point.
    pub distance: f64,
    /// View depth of the point: distance along F.
    pub depth: f64,
    /// The point in normalised device coordinates, z by the depth mapping in use.
    pub ndc: DVec3,
    /// The point in the world (the file's own coordinates, unless a model matrix moves it).
    pub point_world: DVec3,
    /// Outward unit normal of the surface (of the triangle, not of the shading).
    pub normal_world: DVec3,
    /// The point in object space.
    pub point_object: DVec3,
    /// Outward unit normal in object space.
    pub normal_object: DVec3,
    /// Weights of the triangle's corners; `None` for analytic shapes.
    pub barycentric: Option<[f64; 3]>,
    /// How far the pixel position is from the nearest edge of the triangle or face (of a sphere: from its outline),
    /// in pixels, to within 1e-6 or 1e-9 of it. `None` where none of it lies at or behind the near plane.
    pub edge_px: Option<f64>,
    /// How far behind the point the next surface lies along the ray; `None` when there is none.
    pub gap: Option<f64>,
    /// Whether exact arithmetic had to decide: because the ray passes an edge of a triangle, this one's or one's in
    /// front of it, within the rounding of `f64`, or because another triangle's hit lies as near to this one.
    pub exact: bool,
    /// How far the nearest pixel lies, in pixels from centre to centre and up to 8, in which the picture shows another
    /// object, another triangle or the background; `None` when there is none, or while trees are still being built. One
    /// number for all surfaces at a position.
    pub differs_px: Option<f64>,
}

/// One pick as a line of JSON.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PickLine {
    /// Where: pixels from the top left corner.
    pub px: DVec2,
    /// What is there; `None` for the background.
    pub hit: Option<Pick>,
}

/// All surfaces at a position as a line of JSON.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PickLines {
    /// Where: pixels from the top left corner.
    pub px: DVec2,
    /// What is there, from front to back.
    pub hits: Vec<Pick>,
}

impl Pick {
    /// The record of hit `i` of those on the ray through `px`, all of which `hits` holds from front to back.
    pub(super) fn of(
        scene: &Scene,
        view: &View,
        px: DVec2,
        hits: &[SceneHit],
        i: usize,
        differs_px: Option<f64>,
    ) -> Self {
        let next = hits.get(i + 1);
        let SceneHit { object: index, hit } = hits[i];
        let object = &scene.objects()[index];
        let placement = &object.placement;
        let ray = view.ray(px);
        let local = placement.ray_to_object(&ray);
        let point_world = ray.at(hit.t);
        let depth = hit.t * ray.direction.dot(view.camera.forward());
        let ndc_xy = view.viewport.px_to_ndc(px);
        let first_triangle = object.shape.first_triangle();
        Self {
            object: object.name.clone(),
            id: index + 1,
            triangle: hit.on_triangle.map(|at| at.triangle - first_triangle),
            front: hit.is_front(local.direction),
            t: hit.t,
            distance: point_world.distance(view.camera.eye()),
            depth,
            ndc: ndc_xy.extend(view.camera.lens().ndc_depth(depth)),
            point_world,
            normal_world: placement.normal_to_world(hit.normal),
            point_object: local.at(hit.t),
            normal_object: (hit.normal / hit.normal.abs().max_element()).normalize(),
            barycentric: hit.on_triangle.map(|at| at.barycentric),
            edge_px: edge::edge_px(object, view, px, &hit),
            // Of hits whose order is exact, the rounded parameters may be out of it.
            gap: next.map(|next| (next.hit.t - hit.t).max(0.0)),
            exact: certainty::needs_exact(scene, &ray, hits, i),
            differs_px,
        }
    }
}
