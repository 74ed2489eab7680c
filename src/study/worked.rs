//! One pick worked out as courses teach it, with every number on the way. The numbers are those of the study's own
//! course methods in `f64`, the very functions that it times and judges.

use super::{
    methods::{
        ObjectRay,
        boxes::slab,
        from_start,
        normals::{Tilted, by_inverse_transpose},
        object_space::{Placed, by_inverse},
        rays::{PlanePoint, course},
        squares::RaySquare,
    },
    prelude::*,
    swap::cube_normal,
};
use crate::{
    camera::View,
    geometry::Placement,
    pick::Pick,
    scene::{Scene, Shape},
};
use glam::{DVec2, DVec3};

pub use super::methods::{spheres::Quadratic, squares::OnPlane, triangles::Areas};

/// A pick as courses work it out.
#[derive(Clone, Copy, Debug)]
pub struct WorkedPick {
    /// The pixel's point on the picture's plane in the world.
    pub plane: PlanePoint<f64>,
    /// Where its ray starts: at the eye, or, where rays are parallel, at the pixel's point.
    pub origin_world: DVec3,
    /// The ray's direction in the world, 1 long.
    pub direction_world: DVec3,
    /// Where the ray starts in object space: the inverse of M times its start.
    pub origin_object: DVec3,
    /// Its direction there: the inverse of M times its direction, made 1 long again. So t is another in each space.
    pub direction_object: DVec3,
    /// What is computed for the shape, in object space.
    pub shape: WorkedShape,
    /// The hit; `None` where the course's formula has none, which a pick has.
    pub hit: Option<WorkedHit>,
}

/// What is computed for a shape in its own space.
#[derive(Clone, Copy, Debug)]
pub enum WorkedShape {
    /// The quadratic.
    Sphere(Quadratic<f64>),
    /// For x, y and z the values of t between which the ray is inside the slab.
    Cube([[f64; 2]; 3]),
    /// The plane's t, and two coordinates.
    Square(OnPlane<f64>),
    /// The plane's t, and three areas.
    Triangle(Areas<f64>),
}

/// The hit, in object space and back in the world.
#[derive(Clone, Copy, Debug)]
pub struct WorkedHit {
    /// The parameter of the ray in object space.
    pub t_object: f64,
    /// The point there.
    pub point_object: DVec3,
    /// The outward unit normal there.
    pub normal_object: DVec3,
    /// M times the point.
    pub point_world: DVec3,
    /// The inverse transpose of M times the normal, made 1 long again.
    pub normal_world: DVec3,
    /// The parameter of the ray in the world: the distance from its start, since its direction is 1 long.
    pub t_world: f64,
}

impl WorkedPick {
    /// Works out what a click at a position of a view has picked; `None` where the scene has no such surface.
    pub fn of(scene: &Scene, view: &View, px: DVec2, pick: &Pick) -> Option<Self> {
        let object = scene.objects().get(pick.id.checked_sub(1)?)?;
        let pixel = PixelCase::of_view(view, px).wide;
        let along = course(&pixel);
        let origin_world = DVec3::from(along.from);
        let direction_world = DVec3::from(along.along.normalize());
        let world = from_start(along.from, direction_world.into());
        let placed = Placed::<f64>::from((&object.placement, &world));
        let [origin, direction] = by_inverse(&placed, true);
        let local = ObjectRay { origin, direction };
        let (shape, normal) = match &object.shape {
            Shape::Sphere => (WorkedShape::Sphere(Quadratic::of(&local)), None),
            Shape::Cube => {
                let slab = |axis| slab(local.origin[axis], local.direction[axis]);
                (WorkedShape::Cube([0, 1, 2].map(slab)), None)
            }
            Shape::Square => {
                let ray = from_start(local.origin, local.direction);
                let case = RaySquare::<f64>::from((&Placement::IDENTITY, &ray));
                (
                    WorkedShape::Square(OnPlane::by_point(&case)),
                    Some(DVec3::Z),
                )
            }
            Shape::Mesh { mesh, .. } => {
                let triangle = object.shape.triangles()?.start + pick.triangle?;
                let ray = from_start(local.origin, local.direction);
                let areas = Areas::of(&TriangleCase::of_mesh(mesh, triangle, &ray, PX).wide);
                let normal = DVec3::from(areas.normal.normalize());
                (WorkedShape::Triangle(areas), Some(normal))
            }
        };
        let hit = shape.t(pick.front).and_then(|t_object| {
            let point = origin + direction * t_object;
            let point_object = DVec3::from(point);
            let normal_object = match (&shape, normal) {
                (_, Some(normal)) => normal,
                (WorkedShape::Cube(_), None) => cube_normal(point_object)?,
                _ => point_object.normalize(),
            };
            let tilted = Tilted::new(placed.linear, normal_object.into());
            let point_world = DVec3::from(placed.linear.apply(point) + placed.translation);
            Some(WorkedHit {
                t_object,
                point_object,
                normal_object,
                point_world,
                normal_world: by_inverse_transpose(&tilted).into(),
                t_world: (point_world - origin_world).dot(direction_world),
            })
        });
        Some(Self {
            plane: PlanePoint::of(&pixel),
            origin_world,
            direction_world,
            origin_object: origin.into(),
            direction_object: direction.into(),
            shape,
            hit,
        })
    }
}

impl WorkedShape {
    /// The parameter of the hit where the ray comes in, or of the one where it leaves; `None` where there is none.
    fn t(&self, comes_in: bool) -> Option<f64> {
        let [enter, leave] = match self {
            Self::Sphere(quadratic) => quadratic.roots?,
            Self::Cube(slabs) => through_all(slabs),
            Self::Square(OnPlane { t, .. }) | Self::Triangle(Areas { t, .. }) => [*t; 2],
        };
        let t = if comes_in { enter } else { leave };
        (enter <= leave && t.is_finite()).then_some(t)
    }
}

/// Between which values of t a ray is inside all slabs: the last entry and the first exit. It misses where the first is
/// above the second.
pub fn through_all(slabs: &[[f64; 2]; 3]) -> [f64; 2] {
    let enter = slabs
        .iter()
        .fold(f64::NEG_INFINITY, |most, [near, _]| most.max(*near));
    let leave = slabs
        .iter()
        .fold(f64::INFINITY, |least, [_, far]| least.min(*far));
    [enter, leave]
}
