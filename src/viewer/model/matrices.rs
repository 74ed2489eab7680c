//! A point's way through the matrices, in the numbers that a pick reports: object, world, view, clip, NDC, pixel, and
//! back again as a ray.

use crate::{camera::View, geometry::Ray, scene::Object};
use glam::{DMat4, DVec2, DVec3, DVec4};

/// The matrices between an object and the picture, for column vectors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Matrices {
    /// M: object to world.
    pub model: DMat4,
    /// V: world to view.
    pub view: DMat4,
    /// P: view to clip, by the depth mapping in use.
    pub projection: DMat4,
}

/// One of the three matrices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Matrix {
    /// M.
    Model,
    /// V.
    View,
    /// P.
    Projection,
}

/// A row of a matrix, counted from 0. It makes one coordinate of the result.
pub type Row = (Matrix, usize);

/// A point in every space that it passes through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steps {
    /// In the object's own space.
    pub object: DVec3,
    /// M * object.
    pub world: DVec3,
    /// V * world: x right, y up, z forward.
    pub view: DVec3,
    /// P * view.
    pub clip: DVec4,
    /// Clip over its w.
    pub ndc: DVec3,
    /// NDC as a position in the picture, y down.
    pub px: DVec2,
    /// The way back: the ray through that position.
    pub ray: Ray,
}

impl Matrices {
    /// The matrices in use for an object; without one, M is the identity.
    pub fn of(view: &View, object: Option<&Object>) -> Self {
        Self {
            model: object.map_or(DMat4::IDENTITY, |object| object.placement.model().into()),
            view: view.camera.view(),
            projection: view.camera.projection(view.viewport),
        }
    }

    /// P * V * M.
    pub fn product(&self) -> DMat4 {
        self.projection * self.view * self.model
    }
}

impl Steps {
    /// Follows an object-space point; `None` where it lies at or behind the eye. The view-space point is computed
    /// relative to the eye, which keeps the digits that `V * world` loses far from the origin.
    pub fn follow(view: &View, object: &Object, point_object: DVec3) -> Option<Self> {
        let world = object.placement.point_to_world(point_object);
        let in_view = view.camera.to_view(world);
        let projected = view.project(world)?;
        Some(Self {
            object: point_object,
            world,
            view: in_view,
            clip: view.camera.projection(view.viewport) * in_view.extend(1.0),
            ndc: projected.ndc,
            px: projected.px,
            ray: *view.ray(projected.px),
        })
    }
}
