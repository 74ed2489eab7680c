//! A scene's own camera and rays as workloads: which method does *this* scene need?

use crate::{
    camera::View,
    geometry::{Placement, Ray},
    pick::{self, SceneHit},
    render,
    scene::{Object, Scene, Shape},
    study::{
        methods::{
            ShapeCase,
            boxes::BoxCase,
            clipping::ClipCase,
            depth::DepthCase,
            normals::NormalCase,
            object_space::PlacedCase,
            picks::{PickCase, PickWorld},
            rays::PixelCase,
            spheres::SphereCase,
            squares::SquareCase,
            triangles::TriangleCase,
        },
        random::Random,
    },
};
use glam::DVec2;
use std::sync::Arc;

/// Rays through random pixels of a scene's view, and what they hit.
#[derive(Debug)]
pub struct SceneRays {
    world: Arc<PickWorld>,
    /// Pixel centres.
    at: Vec<DVec2>,
    /// Rays through them with what each hits first.
    hits: Vec<(Ray, SceneHit)>,
    seed: u64,
}

impl SceneRays {
    /// So many random pixels of a scene's view, and what a graphics adapter draws of it where there is one.
    #[must_use]
    pub fn new(scene: &Scene, view: View, count: usize, seed: u64) -> Self {
        let ids = super::picks::gpu().and_then(|gpu| render::render(gpu, scene, &view, None).ok());
        let world = Arc::new(PickWorld::new(scene, view, ids.map(|(ids, _)| ids)));
        let mut random = Random::named(seed, &["scene"]);
        let size = view.viewport;
        let mut inside = |side: u32| (random.unit() * f64::from(side)).floor() + 0.5;
        let at: Vec<DVec2> = (0..count)
            .map(|_| DVec2::new(inside(size.width()), inside(size.height())))
            .collect();
        let hit = |px: &DVec2| {
            let ray = *view.ray(*px);
            Some((ray, pick::closest(&world.scene, ray, view.sides)?))
        };
        let hits = at.iter().filter_map(hit).collect();
        Self {
            world,
            at,
            hits,
            seed,
        }
    }

    /// Width of a pixel in radians, seen from the eye at a distance.
    pub(in crate::study) fn px(&self, distance: f64) -> f64 {
        super::px_angle(&self.world.view, distance)
    }

    /// Every ray with the object that it hits.
    pub(in crate::study) fn objects(&self) -> impl Iterator<Item = (&Ray, &Object, &SceneHit)> {
        let objects = self.world.scene.objects();
        self.hits
            .iter()
            .map(|(ray, hit)| (ray, &objects[hit.object], hit))
    }

    /// Rays in the world with an object of a kind each, hit or not, and the width of a pixel there.
    pub(in crate::study) fn rays_at(
        &self,
        wanted: fn(&Shape) -> bool,
    ) -> Vec<(&Placement, Ray, f64)> {
        let objects = self.world.scene.objects().iter();
        let objects: Vec<_> = objects.filter(|o| o.visible && wanted(&o.shape)).collect();
        let mut random = Random::named(self.seed, &["objects"]);
        let rays = self.at.iter().filter(|_| !objects.is_empty());
        rays.map(|px| {
            let object = objects[random.below(objects.len())];
            let ray = self.world.view.ray(*px);
            let distance = object.placement.model().translation.distance(ray.origin);
            (&object.placement, *ray, self.px(distance))
        })
        .collect()
    }

    /// The same in the objects' own space.
    fn local<S>(&self, wanted: fn(&Shape) -> bool) -> Vec<ShapeCase<S>> {
        let rays = self.rays_at(wanted).into_iter();
        rays.map(|(placement, ray, px)| ShapeCase::of_object(&placement.ray_to_object(&ray), px))
            .collect()
    }

    pub(in crate::study) fn pixels(&self) -> Vec<PixelCase> {
        let case = |px: &DVec2| PixelCase::of_view(&self.world.view, *px);
        self.at.iter().map(case).collect()
    }

    pub(in crate::study) fn placed(&self) -> Vec<PlacedCase> {
        let case = |(ray, object, hit): (&Ray, &Object, &SceneHit)| {
            PlacedCase::of_object(&object.placement, ray, self.px(hit.hit.t))
        };
        self.objects().map(case).collect()
    }

    /// The triangle that is hit, those beside it in the file, and any other.
    #[must_use]
    pub fn triangles(&self) -> Vec<TriangleCase> {
        let mut random = Random::named(self.seed, &["triangles"]);
        let mut cases = Vec::new();
        for (ray, object, hit) in self.objects() {
            let (Shape::Mesh { mesh, .. }, Some(at)) = (&object.shape, hit.hit.on_triangle) else {
                continue;
            };
            let count = mesh.data().triangles.len();
            let hit_triangle = at.triangle as usize;
            let local = object.placement.ray_to_object(ray);
            let others = [
                hit_triangle,
                (hit_triangle + 1) % count,
                hit_triangle.checked_sub(1).unwrap_or(count - 1),
                random.below(count),
            ];
            let others = others.into_iter().filter_map(|i| u32::try_from(i).ok());
            let px = self.px(hit.hit.t);
            cases.extend(others.map(|other| TriangleCase::of_mesh(mesh, other, &local, px)));
        }
        cases
    }

    pub(in crate::study) fn spheres(&self) -> Vec<SphereCase> {
        self.local(|shape| matches!(shape, Shape::Sphere))
    }

    pub(in crate::study) fn boxes(&self) -> Vec<BoxCase> {
        self.local(|shape| matches!(shape, Shape::Cube))
    }

    pub(in crate::study) fn squares(&self) -> Vec<SquareCase> {
        let squares = self.rays_at(|shape| matches!(shape, Shape::Square));
        let case = |(placement, ray, px): (&Placement, Ray, f64)| {
            SquareCase::of_object(placement, &ray, px)
        };
        squares.into_iter().map(case).collect()
    }

    pub(in crate::study) fn clips(&self) -> Vec<ClipCase> {
        let camera = &self.world.view.camera;
        let case = |(ray, hit): &(Ray, SceneHit)| ClipCase::of_camera(camera, *ray, hit.hit.t);
        self.hits.iter().map(case).collect()
    }

    pub(in crate::study) fn normals(&self) -> Vec<NormalCase> {
        let cases = self.objects().filter_map(|(_, object, hit)| {
            let linear = object.placement.model().matrix3.into();
            NormalCase::new(linear, hit.hit.normal.into())
        });
        cases.collect()
    }

    pub(in crate::study) fn depths(&self) -> Vec<DepthCase> {
        let camera = &self.world.view.camera;
        let case = |(ray, hit): &(Ray, SceneHit)| DepthCase::of_hit(camera, ray, hit.hit.t);
        self.hits.iter().map(case).collect()
    }

    pub(in crate::study) fn picks(&self) -> Vec<PickCase> {
        // The methods without a tree are slow, and so is truth.
        const MOST: usize = 256;
        let case = |px: &DVec2| PickCase::new(&self.world, *px);
        self.at.iter().take(MOST).map(case).collect()
    }
}
