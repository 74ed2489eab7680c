//! All that is known about a pick, and its JSON.

use super::{InOnePlace, NamedSurface, SceneHit, edge, order};
use crate::{
    camera::View,
    colour::Srgb,
    geometry::{OnTriangle, Placement},
    scene::{InFile, Scene, Shape},
};
use glam::{DVec2, DVec3};
use serde::Serialize;

/// The full record of a pick. Lengths in world units; the field names are the JSON's.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Pick {
    /// The object's name.
    pub object: String,
    /// The object's id: its number for people, from 1. Its index is one less.
    pub id: usize,
    /// Triangle of the object, from 0; `None` for analytic shapes.
    pub triangle: Option<u32>,
    /// What the triangle is made of, as its file calls it; `None` where it names nothing.
    pub material: Option<String>,
    /// Its colour at the point, in light alone: the object's, else the triangle's times the vertices'.
    pub colour: Srgb,
    /// Whether the surface is seen from outside.
    pub front: bool,
    /// Parameter of the ray, whose direction is not normalised: view depth.
    pub t: f64,
    /// From the eye to the point.
    pub distance: f64,
    /// View depth of the point, along F: `t`.
    pub depth: f64,
    /// The point in normalised device coordinates, z by the depth mapping in use.
    pub ndc: DVec3,
    /// The point in the world (the file's own coordinates, unless a model matrix moves it), within three roundings.
    pub point_world: DVec3,
    /// Outward unit normal of the surface (of the triangle, not of the shading).
    pub normal_world: DVec3,
    /// The point in object space.
    pub point_object: DVec3,
    /// Outward unit normal in object space.
    pub normal_object: DVec3,
    /// Weights of the triangle's corners; `None` for analytic shapes.
    pub barycentric: Option<[f64; 3]>,
    /// How far the pixel position is from the nearest edge of the triangle or face (of a sphere: from its outline), in
    /// pixels, to within 1e-6 or a relative 1e-9. `None` where no edge lies at or behind the near plane and is kept by
    /// the section.
    pub edge_px: Option<f64>,
    /// How far behind the point the next surface lies, in `t`: the exact difference, rounded once. `None` when there is
    /// none.
    pub gap: Option<f64>,
    /// Whether exact arithmetic had to decide: `f64` left open whether a surface up to here is hit, or whether this one
    /// or another is nearer.
    pub exact: bool,
    /// What the mesh's file says about the triangle, once it was read again.
    #[serde(flatten)]
    pub in_file: InFile,
}

/// One pick as a line of JSON.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PickLine {
    /// Where: pixels from the top left corner.
    pub px: DVec2,
    /// What is there; `None` for the background.
    pub hit: Option<Pick>,
    /// The surfaces that drawing cannot tell from the nearest one there; `None` where there are none.
    pub in_one_place: Option<InOnePlace>,
}

/// All surfaces at a position as a line of JSON.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PickLines {
    /// Where: pixels from the top left corner.
    pub px: DVec2,
    /// What is there, from front to back.
    pub hits: Vec<Pick>,
    /// The surfaces that drawing cannot tell from the first; `None` where there are none.
    pub in_one_place: Option<InOnePlace>,
}

/// Where a pick is made.
pub(super) struct At<'a> {
    pub scene: &'a Scene,
    pub view: &'a View,
    pub px: DVec2,
}

impl Pick {
    /// Whether this may be one of the surfaces in one place; also true if not all of them are named.
    pub fn may_be_of(&self, all: &InOnePlace) -> bool {
        let is_it = |of: &NamedSurface| {
            (of.id, of.triangle, of.front) == (self.id, self.triangle, self.front)
        };
        all.count > all.named.len() || all.named.iter().any(is_it)
    }

    /// The record of a hit on the ray through a position; `next` is the hit behind it.
    pub(super) fn of(at: &At, found: &SceneHit, next: Option<&SceneHit>, exact: bool) -> Self {
        let At { scene, view, px } = *at;
        let SceneHit { object: index, hit } = *found;
        let object = &scene.objects()[index];
        let placement = &object.placement;
        let ray = view.ray(px);
        let at = order::parameter(scene, &ray, found);
        // Rounded once, and kept within the interval.
        let t = ray.kept_within(at.to_f64().unwrap_or(hit.t));
        let point_object = at.point_object(placement);
        let point_object = point_object.unwrap_or_else(|| placement.ray_to_object(&ray).at(t));
        let barycentric = |on: OnTriangle| at.weights().unwrap_or(on.barycentric);
        let normal = match object.shape {
            Shape::Sphere => point_object,
            _ => hit.normal,
        };
        let triangle = found.triangle_of_object(scene);
        let material = triangle.and_then(|triangle| object.material_name(triangle));
        let ndc_xy = view.viewport.px_to_ndc(px);
        Self {
            object: object.name.clone(),
            id: index + 1,
            triangle,
            material: material.map(str::to_owned),
            colour: Srgb::from_linear(object.albedo(&hit)),
            front: hit.front,
            t,
            distance: view.offset_from_eye(px, t).length(),
            depth: t,
            ndc: ndc_xy.extend(view.camera.lens().ndc_depth(t)),
            point_world: (at.point_object(&Placement::IDENTITY)).unwrap_or_else(|| ray.at(t)),
            normal_world: placement.normal_to_world(normal) + DVec3::ZERO,
            point_object,
            // Adding 0 turns -0 into 0.
            normal_object: normal.normalize_or_zero() + DVec3::ZERO,
            barycentric: hit.on_triangle.map(barycentric),
            edge_px: edge::edge_px(object, view, px, &hit),
            gap: next.map(|next| order::gap(scene, &ray, (found, &at), next)),
            exact,
            in_file: InFile::default(),
        }
    }
}
