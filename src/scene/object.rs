//! An object of a scene: its shape, placement and colour.

use crate::{
    colour::Srgb,
    geometry::{Aabb, Cuboid, Hit, Mesh, Placement, Sphere, Square},
};
use glam::DVec3;
use std::{ops::Range, sync::Arc};

/// A shape in its object space.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// Radius 0.5 about the origin.
    Sphere,
    /// Side 1 about the origin.
    Cube,
    /// Side 1 about the origin in the xy plane, facing +z.
    Square,
    /// One part of a mesh: an object of its file.
    Mesh {
        /// The mesh of the whole file.
        mesh: Arc<Mesh>,
        /// The index of the part, from 0. A part that does not exist has no triangles.
        part: usize,
    },
}

impl Shape {
    /// The name of the shape in lists and scene files.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Sphere => "sphere",
            Self::Cube => "cube",
            Self::Square => "square",
            Self::Mesh { .. } => "mesh",
        }
    }

    /// The mesh that it is a part of; `None` for analytic shapes.
    pub fn mesh(&self) -> Option<&Arc<Mesh>> {
        match self {
            Self::Mesh { mesh, .. } => Some(mesh),
            _ => None,
        }
    }

    /// The triangles of its part of the mesh; `None` for analytic shapes.
    pub fn triangles(&self) -> Option<Range<u32>> {
        match self {
            Self::Mesh { mesh, part } => Some(mesh.part_triangles(*part)),
            _ => None,
        }
    }

    /// Where its triangles begin among those of its mesh; 0 for analytic shapes.
    pub fn first_triangle(&self) -> u32 {
        self.triangles().map_or(0, |triangles| triangles.start)
    }
}

/// An object of the scene, as lists name it and picks return it.
#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    /// For people; need not be unique.
    pub name: String,
    /// What it is, in object space.
    pub shape: Shape,
    /// Where it stands.
    pub placement: Placement,
    /// Its colour; `None` for the mesh's own colours, or neutral.
    pub colour: Option<Srgb>,
    /// Hidden objects are neither drawn nor picked.
    pub visible: bool,
}

impl Object {
    /// A visible object without a colour of its own.
    pub fn new(name: impl Into<String>, shape: Shape, placement: Placement) -> Self {
        Self {
            name: name.into(),
            shape,
            placement,
            colour: None,
            visible: true,
        }
    }

    /// Its linear colour at a hit.
    ///
    /// # Panics
    /// When the hit is on a triangle that its mesh lacks.
    pub fn albedo(&self, hit: &Hit) -> [f32; 3] {
        let (Shape::Mesh { mesh, .. }, Some(at), None) =
            (&self.shape, &hit.on_triangle, self.colour)
        else {
            return self.colour.unwrap_or(Srgb::NEUTRAL).to_linear();
        };
        mesh.albedo(at)
    }

    /// The name of the material of one of its triangles, counted from 0 within the object, as its file calls it.
    ///
    /// # Panics
    /// When its mesh lacks the triangle.
    pub fn material_name(&self, triangle: u32) -> Option<&str> {
        let Shape::Mesh { mesh, .. } = &self.shape else {
            return None;
        };
        mesh.triangle_material(self.shape.first_triangle() + triangle)
    }

    /// The name, where its file gives one, and the colour of all of it; `None` where it has several materials, or
    /// colours that vary between vertices.
    pub fn one_material(&self) -> Option<(Option<&str>, Srgb)> {
        let Shape::Mesh { mesh, .. } = &self.shape else {
            return Some((None, self.colour.unwrap_or(Srgb::NEUTRAL)));
        };
        let triangles = self.shape.triangles()?;
        let runs = &mesh.data().colours;
        let run = runs.get(runs.partition_point(|run| run.triangles.end <= triangles.start))?;
        let varies = self.colour.is_none() && !mesh.data().vertex_colours.is_empty();
        if run.triangles.end < triangles.end || varies {
            return None;
        }
        let colour = self.colour.or(run.colour).unwrap_or(Srgb::NEUTRAL);
        Some((mesh.triangle_material(triangles.start), colour))
    }

    /// The shading normal at a hit, in object space: interpolated over the triangle, or the surface's own.
    pub fn shading_normal(&self, hit: &Hit) -> DVec3 {
        match (&self.shape, &hit.on_triangle) {
            (Shape::Mesh { mesh, .. }, Some(at)) => mesh.shading_normal(at).unwrap_or(hit.normal),
            _ => hit.normal,
        }
    }

    /// The smallest world-space box about it; empty for a mesh without triangles.
    pub fn bounds_world(&self) -> Aabb {
        self.shape.bounds_at(&self.placement)
    }
}

impl Shape {
    /// The box about all of it where a placement puts it.
    pub(super) fn bounds_at(&self, placement: &Placement) -> Aabb {
        let to_world = |point| placement.point_to_world(point);
        match self {
            Self::Sphere => {
                let rows = placement.model().matrix3.transpose();
                let lengths = [rows.x_axis, rows.y_axis, rows.z_axis].map(DVec3::length);
                let half = Sphere::RADIUS * DVec3::from_array(lengths);
                let center = to_world(DVec3::ZERO);
                Aabb {
                    min: center - half,
                    max: center + half,
                }
            }
            Self::Cube => Aabb::around(Cuboid::bounds().corners().map(to_world)),
            Self::Square => Aabb::around(Square::bounds().corners().map(to_world)),
            Self::Mesh { mesh, part } if *placement == Placement::IDENTITY => {
                mesh.part_bounds(*part)
            }
            Self::Mesh { mesh, .. } => Aabb::around(
                (self.triangles().into_iter().flatten())
                    .flat_map(|triangle| mesh.corners(triangle).map(to_world)),
            ),
        }
    }
}
