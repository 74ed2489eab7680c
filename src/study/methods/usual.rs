//! Picks as most viewers and tutorials do, in `f32`. The inverse of Projection * View unprojects the pixel onto the
//! near and the far plane (gluUnProject, OpenGL Utility Library). The ray from one point to the other is tested against
//! triangles by Moeller & Trumbore, "Fast, Minimum Storage Ray-Triangle Intersection", JGT 2(1), 1997.
//!
//! Near and far are far apart in the world and close together in clip space. The inverse is therefore nearly singular,
//! and `f32` rounds the ray itself.

use crate::{
    camera::View,
    geometry::Ray,
    pick::{self, SceneHit},
    scene::Scene,
    study::chains::moeller_trumbore,
};
use glam::DVec2;

/// The hit that the usual way finds at a pixel position. Spheres, cubes and squares are tested in `f64`: for them only
/// the ray differs from Sightline's.
pub fn closest(scene: &Scene, view: &View, px: DVec2) -> Option<SceneHit> {
    let test = moeller_trumbore::<f32>;
    pick::closest_by(scene, ray(view, px)?, view.sides, test, None)
}

/// The world-space ray from the near to the far plane; `None` where the inverse has no finite answer.
fn ray(view: &View, px: DVec2) -> Option<Ray> {
    let camera = &view.camera;
    let projection_view = camera.projection(view.viewport).as_mat4() * camera.view().as_mat4();
    let inverse = projection_view.inverse();
    let ndc = view.viewport.px_to_ndc(px);
    let lens = camera.lens();
    let on_plane = |depth: f64| inverse.project_point3(ndc.extend(lens.ndc_depth(depth)).as_vec3());
    let [near, far] = [lens.near, lens.far].map(on_plane);
    let along = far - near;
    let ray = Ray {
        origin: near.as_dvec3(),
        direction: along.normalize().as_dvec3(),
        t_min: 0.0,
        t_max: f64::from(along.length()),
    };
    (ray.origin.is_finite() && ray.direction.is_finite()).then_some(ray)
}
