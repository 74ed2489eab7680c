//! Makes workloads of a scene's own camera and rays. They tell which method the scene needs.

use super::random::Random;
use crate::{
    camera::{Projection, View},
    geometry::{Placement, Ray},
    pick::{self, SceneHit},
    scene::{Object, Scene, Shape},
};
use glam::DVec2;

/// Rays through random pixels of a scene's view, and their hits.
#[derive(Debug)]
pub struct SceneRays {
    /// With trees over all meshes that are worth one.
    pub(super) scene: Scene,
    pub(super) view: View,
    /// Pixel centres.
    pub(super) at: Vec<DVec2>,
    /// The rays through these pixels that hit something, each with its nearest hit.
    pub(super) hits: Vec<(Ray, SceneHit)>,
    pub(super) seed: u64,
}

impl SceneRays {
    /// Rays through `count` random pixels of a scene's view.
    pub fn new(scene: &Scene, view: View, count: usize, seed: u64) -> Self {
        scene.build_trees();
        let mut random = Random::named(seed, &["scene"]);
        let pixels = (0..count).map(|_| random.pixel(view.viewport.size_px()));
        let at: Vec<DVec2> = pixels.collect();
        let hit = |px: &DVec2| {
            let ray = *view.ray(*px);
            Some((ray, pick::closest(scene, ray, view.sides)?))
        };
        let hits = at.iter().filter_map(hit).collect();
        Self {
            scene: scene.clone(),
            view,
            at,
            hits,
            seed,
        }
    }

    /// [`px_angle`] in the scene's view. With parallel rays a hit may lie behind the eye.
    pub(super) fn px(&self, distance: f64) -> f64 {
        px_angle(&self.view, distance.abs())
    }

    /// Every ray that hits, with the object and the hit.
    pub(super) fn objects(&self) -> impl Iterator<Item = (&Ray, &Object, &SceneHit)> {
        let (objects, hits) = (self.scene.objects(), self.hits.iter());
        hits.map(|(ray, hit)| (ray, &objects[hit.object], hit))
    }

    /// Every ray in world space with a random visible object of a wanted shape, hit or not, and [`px_angle`] at its
    /// distance.
    pub(super) fn rays_at(&self, wanted: fn(&Shape) -> bool) -> Vec<(&Placement, Ray, f64)> {
        let objects = self.scene.objects().iter();
        let objects: Vec<_> = objects.filter(|o| o.visible && wanted(&o.shape)).collect();
        let mut random = Random::named(self.seed, &["objects"]);
        let rays = self.at.iter().filter(|_| !objects.is_empty());
        rays.map(|px| {
            let object = objects[random.below(objects.len())];
            let ray = self.view.ray(*px);
            let distance = object.placement.model().translation.distance(ray.origin);
            (&object.placement, *ray, self.px(distance))
        })
        .collect()
    }
}

/// The angle of a pixel in a view's middle, seen from the eye, in radians. With parallel rays the angle depends on
/// `distance`, because a pixel is equally wide everywhere. In perspective `distance` does not matter.
pub fn px_angle(view: &View, distance: f64) -> f64 {
    let lens = view.camera.lens();
    let height = 2.0 * lens.half_extent(1.0).y / f64::from(view.viewport.height());
    match lens.projection {
        Projection::Perspective { .. } => height,
        Projection::Orthographic { .. } => height / distance,
    }
}

/// The angle of a pixel in radians in general workloads: 60 degrees over 1080 rows, `2 tan(30 deg) / 1080`.
pub const PX: f64 = 2.0 * TAN_30 / 1080.0;
/// tan(30 degrees).
pub const TAN_30: f64 = 0.577_350_269_189_625_7;
