//! Whole picks as programs make them, from a position in the picture to an object and its triangle.
//!
//! All chains walk the same trees by the same code ([`pick::closest_by`]) and test one triangle at a time. They differ
//! in the numbers that hold the scene, and in the test of a shape; other viewers' also in how they make the ray. What a
//! program prepares once for a scene or a picture is prepared in [`Held::new`].

use super::{
    fma::fused,
    methods::{
        ObjectRay, boxes,
        rays::{Pixel, PixelRay, as_bevy, as_three, on_planes},
        spheres, squares,
        triangles::{self, RayTriangle},
    },
    prelude::*,
    swap::{analytic, cube_normal, first},
};
use crate::{
    camera::View,
    geometry::{
        Hit, Mesh, MeshData, Placement, Ray, TriangleHit, TriangleTest, VertexRay, hit_guarded,
    },
    pick::{self, ShapeTest},
    scene::{Object, Scene, Shape},
};
use glam::{DAffine3, DMat3, DVec2, DVec3};
use std::sync::Arc;

/// A way to pick, from the plainest numbers to exact decisions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Chain {
    /// Everything in `f32`, in the world's coordinates.
    World,
    /// Vertices in `f32` about the origin of their file. The ray is moved there in `f64`, then rounded to `f32`.
    Mesh,
    /// Everything in `f32` about the eye, from which vertices were subtracted in `f64`.
    Eye,
    /// Everything in `f64`, by Moeller & Trumbore.
    Double,
    /// Sightline's: `f64` with bounds, and exact arithmetic where these leave a decision open.
    Sightline,
    /// three.js's: vertices in `f32` in the world, all else in `f64`.
    Three,
    /// Bevy's: everything in `f32` in the world.
    Bevy,
    /// VTK's: vertices in `f32` in the world, all else in `f64`.
    Vtk,
}

impl Chain {
    /// The ways that differ in their numbers alone, the simplest first.
    pub const ALL: [Self; 5] = [
        Self::World,
        Self::Mesh,
        Self::Eye,
        Self::Double,
        Self::Sightline,
    ];
    /// How many there are, with those of other viewers.
    pub const COUNT: usize = Self::Vtk as usize + 1;

    /// What it is called in tables and charts.
    pub const fn name(self) -> &'static str {
        match self {
            Self::World => "f32 in the world",
            Self::Mesh => "f32 about each file's origin",
            Self::Eye => "f32 about the eye",
            Self::Double => "f64 throughout",
            Self::Three => "three.js's way",
            Self::Bevy => "Bevy's way",
            Self::Vtk => "VTK's way",
            Self::Sightline => "Sightline's",
        }
    }

    /// The arithmetic that finds its hits.
    pub const fn precision(self) -> Precision {
        match self {
            Self::World | Self::Mesh | Self::Eye | Self::Bevy => F32,
            Self::Double | Self::Three | Self::Vtk => F64,
            Self::Sightline => Precision::Exact,
        }
    }

    /// Where its ray and its test of a triangle are from.
    pub const fn source(self) -> &'static str {
        match self {
            Self::World | Self::Mesh | Self::Eye => {
                "a sum of directions, then Embree's robust test, over Sightline's trees"
            }
            Self::Double => {
                "a sum of directions, then Moeller & Trumbore's test, over Sightline's trees"
            }
            Self::Three => {
                "three.js, Raycaster.setFromCamera and Ray.intersectTriangle, over Sightline's trees"
            }
            Self::Bevy => {
                "Bevy, Camera::viewport_to_world and bevy_picking's ray_triangle_intersection, over Sightline's trees"
            }
            Self::Vtk => {
                "VTK, vtkPicker::Pick and vtkTriangle::IntersectWithLine with no tolerance, over Sightline's trees"
            }
            Self::Sightline => "pick::closest, over trees",
        }
    }
}

/// A scene as a chain holds it, for one view.
#[derive(Debug)]
pub struct Held {
    chain: Chain,
    scene: Scene,
    view: View,
    /// The picture, with the eye where the chain has it.
    pixel: PixelCase,
    /// What the ray's start still lacks.
    start: DVec3,
    /// Where the chain's (0, 0, 0) is in the world.
    origin: DVec3,
}

/// What a chain picks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Picked {
    /// Object and triangle. `t` is the view depth.
    pub hit: SceneHit,
    /// The point in the world.
    pub point_world: DVec3,
}

impl Held {
    /// Prepares a scene for a view, whose section is ignored. The trees of what it makes are built.
    pub fn new(chain: Chain, scene: &Scene, view: &View) -> Self {
        let view = view.uncut();
        let eye = view.camera.eye();
        let (scene, origin) = match chain {
            Chain::World | Chain::Three | Chain::Bevy | Chain::Vtk => {
                (narrowed(scene, DVec3::ZERO), DVec3::ZERO)
            }
            Chain::Eye => (narrowed(scene, eye), eye),
            Chain::Mesh | Chain::Double | Chain::Sightline => (scene.clone(), DVec3::ZERO),
        };
        scene.build_trees();
        let (about, start) = match chain {
            Chain::Mesh => (DVec3::ZERO, eye),
            _ => (eye - origin, DVec3::ZERO),
        };
        Self {
            chain,
            scene,
            view,
            pixel: PixelCase::about(&view, about, 0.5 * view.viewport.size_px()),
            start,
            origin,
        }
    }

    /// The pick at a position in pixels; `None` for the background.
    pub fn pick(&self, px: DVec2) -> Option<Picked> {
        let Self { scene, view, .. } = self;
        let by = |ray: Ray, triangle: TriangleTest, shape: ShapeTest| {
            pick::closest_by(scene, ray, view.sides, triangle, Some(shape))
        };
        let (ray, hit) = match self.chain {
            Chain::World | Chain::Eye => {
                let ray = self.ray(&self.pixel.narrow, px);
                let hit = by(ray, robust::<f32>, in_world::<f32>);
                (ray, hit)
            }
            Chain::Mesh => {
                let ray = self.ray(&self.pixel.narrow, px);
                (ray, by(ray, robust::<f32>, in_object::<f32>))
            }
            Chain::Double => {
                let ray = self.ray(&self.pixel.wide, px);
                (ray, by(ray, moeller_trumbore::<f64>, in_object::<f64>))
            }
            Chain::Three => {
                let ray = unbounded(as_three(&self.pixel.wide.moved_to(px)));
                (ray, by(ray, three, in_world::<f64>))
            }
            Chain::Bevy => {
                let ray = unbounded(as_bevy(&self.pixel.narrow.moved_to(px)));
                (ray, by(ray, bevy, in_world::<f32>))
            }
            Chain::Vtk => {
                let [near, far] = on_planes(&self.pixel.wide.moved_to(px)).map(DVec3::from);
                let ray = Ray {
                    origin: near,
                    direction: far - near,
                    t_min: 0.0,
                    t_max: 1.0,
                };
                (ray, by(ray, vtk, in_world::<f64>))
            }
            Chain::Sightline => {
                let ray = view.ray(px);
                (*ray, pick::closest(scene, ray, view.sides))
            }
        };
        let hit = hit?;
        Some(Picked {
            hit,
            point_world: self.origin + ray.at(hit.hit.t),
        })
    }

    /// Which chain it is held for.
    pub fn chain(&self) -> Chain {
        self.chain
    }

    /// Sightline's pick by the walk of the other chains, one triangle at a time: what its decisions alone cost.
    pub fn pick_one_by_one(&self, px: DVec2) -> Option<SceneHit> {
        let ray = self.view.ray(px);
        pick::closest_by(&self.scene, ray, self.view.sides, hit_guarded, None)
    }

    /// Whether two picks are the same: both of nothing, of one object that is no mesh, or of triangles of one object
    /// that share a corner.
    pub(super) fn is_same_place(&self, a: Option<&Picked>, b: Option<&Picked>) -> bool {
        let (Some(a), Some(b)) = (a, b) else {
            return a.is_none() && b.is_none();
        };
        let shape = &self.scene.objects()[a.hit.object].shape;
        let triangles = [a, b].map(|picked| picked.hit.hit.on_triangle);
        a.hit.object == b.hit.object
            && match (shape, triangles) {
                (Shape::Mesh { mesh, .. }, [Some(a), Some(b)]) => {
                    let others = mesh.corners(b.triangle);
                    (mesh.corners(a.triangle).iter()).any(|corner| others.contains(corner))
                }
                _ => true,
            }
    }

    /// The ray between near and far, by a sum of directions.
    fn ray<T: Real>(&self, pixel: &Pixel<T>, px: DVec2) -> Ray {
        let ray = pixel.eye_basis_at(px.to_array().map(T::of));
        let lens = self.view.camera.lens();
        Ray {
            origin: self.start + DVec3::from(ray.from),
            direction: ray.along.into(),
            t_min: lens.near,
            t_max: lens.far,
        }
    }
}

/// A scene whose numbers are `f32` about a point of the world: vertices there, and the model matrices of other shapes.
fn narrowed(scene: &Scene, origin: DVec3) -> Scene {
    let mut known: Vec<(Arc<Mesh>, DAffine3, Arc<Mesh>)> = Vec::new();
    let mut moved = |mesh: &Arc<Mesh>, placement: &Placement| {
        let model = placement.model();
        let is_it =
            |of: &&(Arc<Mesh>, DAffine3, Arc<Mesh>)| Arc::ptr_eq(&of.0, mesh) && of.1 == model;
        if let Some((.., own)) = known.iter().find(is_it) {
            return Arc::clone(own);
        }
        let data = mesh.data();
        let position = |p: &[f32; 3]| {
            let point = data.origin + DVec3::from(p.map(f64::from));
            (placement.point_to_world(point) - origin)
                .as_vec3()
                .to_array()
        };
        let positions = data.positions.iter().map(position).collect();
        // Seen from outside, a mirrored triangle runs the other way.
        let corners = |[a, b, c]: [u32; 3]| {
            if placement.mirrors() {
                [a, c, b]
            } else {
                [a, b, c]
            }
        };
        let triangles = data.triangles.iter().copied().map(corners).collect();
        let own = Mesh::new(MeshData {
            parts: data.parts.clone(),
            ..MeshData::of_triangles("", positions, triangles)
        });
        let own = own.map_or_else(|_| Arc::clone(mesh), Arc::new);
        known.push((Arc::clone(mesh), model, Arc::clone(&own)));
        own
    };
    let objects = scene.objects().iter().map(|object| {
        let mut object = object.clone();
        if let Shape::Mesh { mesh, .. } = &mut object.shape {
            *mesh = moved(mesh, &object.placement);
            object.placement = Placement::IDENTITY;
            return object;
        }
        let DAffine3 {
            matrix3,
            translation,
        } = object.placement.model();
        let translation = (translation - origin).as_vec3().as_dvec3();
        let linear: DMat3 = matrix3.as_mat3().as_dmat3();
        match Placement::new(DAffine3::from_mat3_translation(linear, translation)) {
            Ok(placement) => object.placement = placement,
            // `f32` has flattened it.
            Err(_) => object.visible = false,
        }
        object
    });
    Scene::new(objects.collect())
}

/// Moeller & Trumbore's test of the study, as a tree asks it.
pub fn moeller_trumbore<T: Real>(ray: &VertexRay, corners: [DVec3; 3]) -> Option<TriangleHit> {
    triangle::<T>(ray, corners, |case| triangles::moeller_trumbore(case, 0.0))
}

/// Embree's robust test of the study, as a tree asks it. In `f32` the other leaks at edges.
fn robust<T: Real>(ray: &VertexRay, corners: [DVec3; 3]) -> Option<TriangleHit> {
    triangle::<T>(ray, corners, fused::<triangles::EmbreeRobust, _>)
}

/// three.js's test.
fn three(ray: &VertexRay, corners: [DVec3; 3]) -> Option<TriangleHit> {
    triangle::<f64>(ray, corners, triangles::three)
}

/// Bevy's test: Moeller & Trumbore's, where a determinant below `f32::EPSILON` is a miss.
fn bevy(ray: &VertexRay, corners: [DVec3; 3]) -> Option<TriangleHit> {
    let least = f64::from(f32::EPSILON);
    triangle::<f32>(ray, corners, |case| {
        triangles::moeller_trumbore(case, least)
    })
}

/// VTK's test.
fn vtk(ray: &VertexRay, corners: [DVec3; 3]) -> Option<TriangleHit> {
    triangle::<f64>(ray, corners, |case| triangles::vtk(case, 0.0))
}

/// A ray that ends nowhere: other viewers do not clip it at the camera's planes.
fn unbounded(ray: PixelRay) -> Ray {
    Ray {
        origin: ray.from.into(),
        direction: ray.along.into(),
        t_min: 0.0,
        t_max: f64::INFINITY,
    }
}

#[expect(clippy::inline_always, reason = "each test becomes one function")]
#[inline(always)]
fn triangle<T: Real>(
    ray: &VertexRay,
    corners: [DVec3; 3],
    test: impl Fn(&RayTriangle<T>) -> Option<f64>,
) -> Option<TriangleHit> {
    let of = |v: DVec3| V3::<T>::of(v.into());
    let (ray, [a, b, c]) = (&ray.ray, corners.map(of));
    let direction = of(ray.direction);
    // The tests look from the ray's start on, which parallel rays may have in their middle.
    let before = ray.t_min.min(0.0);
    let origin = if before < 0.0 {
        ray.at(before)
    } else {
        ray.origin
    };
    let t = before + test(&RayTriangle::new(of(origin), direction, [a, b, c]))?;
    ray.contains(t).then(|| TriangleHit {
        t,
        t_error: 0.0,
        front: direction.dot((b - a).cross(c - a)) < T::zero(),
        // Nobody asks for them.
        barycentric: [0.0; 3],
    })
}

/// The study's tests of a sphere, a cube or a square. The ray is moved into object space in the world's numbers.
fn in_world<T: Real>(object: &Object, ray: &Ray) -> Option<Hit> {
    let placement = &object.placement;
    if let Shape::Square = object.shape {
        return square::<T>(placement, ray);
    }
    let linear = M3::<T>::of(&M3::from(placement.inverse_linear()));
    let of = |v: DVec3| V3::<T>::of(v.into());
    let translation = of(placement.model().translation);
    let local = Ray {
        origin: linear.apply(of(ray.origin) - translation).wide().into(),
        direction: linear.apply(of(ray.direction)).wide().into(),
        ..*ray
    };
    solid::<T>(&object.shape, &local)
}

/// The same, but the ray is moved into object space in `f64`.
fn in_object<T: Real>(object: &Object, ray: &Ray) -> Option<Hit> {
    let local = object.placement.ray_to_object(ray);
    match object.shape {
        Shape::Square => square::<T>(&Placement::IDENTITY, &local),
        _ => solid::<T>(&object.shape, &local),
    }
}

fn square<T: Real>(placement: &Placement, ray: &Ray) -> Option<Hit> {
    let test = |ray: &Ray| squares::point(&squares::RaySquare::<T>::from((placement, ray)));
    let t = first(ray, test)?;
    let local = placement.ray_to_object(ray);
    ray.contains(t).then(|| analytic(&local, t, DVec3::Z))
}

fn solid<T: Real>(shape: &Shape, local: &Ray) -> Option<Hit> {
    let test = |ray: &Ray| {
        let ray = ObjectRay::<T> {
            origin: V3::of(ray.origin.into()),
            direction: V3::of(ray.direction.into()),
        };
        match shape {
            Shape::Sphere => spheres::hearn_baker(&ray),
            _ => boxes::branch(&ray),
        }
    };
    let t = first(local, test)?;
    let point = local.at(t);
    let normal = match shape {
        Shape::Sphere => point,
        _ => cube_normal(point)?,
    };
    local.contains(t).then(|| analytic(local, t, normal))
}
