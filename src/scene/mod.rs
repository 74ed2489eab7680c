//! What there is to see: objects in the world, each a shape with a model matrix.

mod demo;
pub mod description;
mod entry;
mod file;
pub mod gallery;
mod load;
pub mod obj;
mod problem;
mod progress;
mod replace;
mod save;
mod tree;
mod warning;

pub(crate) use entry::matrix_rows;
pub use file::FileError;
pub use load::{LoadError, Loaded, MeshFiles, load};
pub(crate) use load::{is_scene_file, title};
pub use obj::{ObjError, ObjFile};
pub use problem::{DescriptionError, Problem, SaveError};
pub use progress::{Cancelled, Progress};
pub use save::save;
pub use warning::Warning;

use crate::{
    colour::Srgb,
    geometry::{Aabb, Cuboid, Hit, Mesh, Placement, Pyramid, Sphere, Square, WorldRay},
};
use glam::DVec3;
use std::{
    collections::HashSet,
    ops::Range,
    sync::{Arc, atomic::AtomicBool},
};
use tree::SceneTree;

/// A shape in its object space.
#[derive(Clone, Debug)]
pub enum Shape {
    /// Radius 0.5 about the origin.
    Sphere,
    /// Side 1 about the origin.
    Cube,
    /// Side 1 about the origin in the xy plane, facing +z.
    Square,
    /// One object of a file.
    Mesh {
        /// The whole file.
        mesh: Arc<Mesh>,
        /// Which of its parts.
        part: usize,
    },
}

impl Shape {
    /// The word for it in lists and scene files.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Sphere => "sphere",
            Self::Cube => "cube",
            Self::Square => "square",
            Self::Mesh { .. } => "mesh",
        }
    }

    /// The triangles of its mesh; `None` for analytic shapes.
    #[must_use]
    pub fn triangles(&self) -> Option<Range<u32>> {
        match self {
            Self::Mesh { mesh, part } => Some(mesh.data().parts[*part].triangles.clone()),
            _ => None,
        }
    }

    /// Where its triangles begin among those of its mesh; 0 for analytic shapes.
    #[must_use]
    pub fn first_triangle(&self) -> u32 {
        self.triangles().map_or(0, |triangles| triangles.start)
    }
}

/// One thing in the scene: what lists name and picks return.
#[derive(Clone, Debug)]
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
    #[must_use]
    pub fn new(name: impl Into<String>, shape: Shape, placement: Placement) -> Self {
        Self {
            name: name.into(),
            shape,
            placement,
            colour: None,
            visible: true,
        }
    }

    /// Its linear colour where it was hit.
    #[must_use]
    pub fn albedo(&self, hit: &Hit) -> [f32; 3] {
        let (Shape::Mesh { mesh, .. }, Some(at), None) =
            (&self.shape, &hit.on_triangle, self.colour)
        else {
            return self.colour.unwrap_or(Srgb::NEUTRAL).to_linear();
        };
        mesh.albedo(at)
    }

    /// The normal that shading takes where it was hit, in object space: interpolated over the triangle, or the
    /// surface's own.
    #[must_use]
    pub fn shading_normal(&self, hit: &Hit) -> DVec3 {
        match (&self.shape, &hit.on_triangle) {
            (Shape::Mesh { mesh, .. }, Some(at)) => mesh.shading_normal(at).unwrap_or(hit.normal),
            _ => hit.normal,
        }
    }

    /// The smallest world-space box about it; empty for a mesh without triangles.
    #[must_use]
    pub fn bounds_world(&self) -> Aabb {
        let to_world = |point| self.placement.point_to_world(point);
        match &self.shape {
            Shape::Sphere => {
                let rows = self.placement.model().matrix3.transpose();
                let half = Sphere::RADIUS
                    * DVec3::new(
                        rows.x_axis.length(),
                        rows.y_axis.length(),
                        rows.z_axis.length(),
                    );
                let center = to_world(DVec3::ZERO);
                Aabb {
                    min: center - half,
                    max: center + half,
                }
            }
            Shape::Cube => Aabb::around(Cuboid::bounds().corners().map(to_world)),
            Shape::Square => Aabb::around(Square::bounds().corners().map(to_world)),
            Shape::Mesh { mesh, part } if self.placement == Placement::IDENTITY => {
                mesh.part_bounds(*part)
            }
            Shape::Mesh { mesh, part } => Aabb::around(
                (mesh.data().parts[*part].triangles.clone())
                    .flat_map(|triangle| mesh.corners(triangle).map(to_world)),
            ),
        }
    }
}

/// Somebody named an object that is not there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no object {id}: ids run from 1 to {objects}; see 'sightline list'")]
pub struct NoSuchObject {
    /// The id that was named.
    pub id: usize,
    /// How many objects there are.
    pub objects: usize,
}

/// Objects in order. Ids for people are index + 1.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    objects: Vec<Object>,
    bounds: Vec<Aabb>,
    batches: Vec<Range<usize>>,
    meshes: Vec<Arc<Mesh>>,
    tree: SceneTree,
}

impl Scene {
    /// The objects in this order.
    #[must_use]
    pub fn new(objects: Vec<Object>) -> Self {
        let bounds: Vec<Aabb> = objects.iter().map(Object::bounds_world).collect();
        let batches = batches(&objects);
        let meshes = meshes(&objects);
        let mut scene = Self {
            objects,
            bounds,
            batches,
            meshes,
            tree: SceneTree::default(),
        };
        scene.tree = SceneTree::new(&scene);
        scene
    }

    /// All objects, hidden ones too.
    #[must_use]
    pub fn objects(&self) -> &[Object] {
        &self.objects
    }

    /// Each mesh of the objects once, in the order in which they first use it.
    #[must_use]
    pub fn meshes(&self) -> &[Arc<Mesh>] {
        &self.meshes
    }

    /// The world-space box about an object; see [`Object::bounds_world`].
    #[must_use]
    pub fn bounds_of(&self, object: usize) -> Aabb {
        self.bounds[object]
    }

    /// The world-space box about all objects, hidden ones too; empty when there are none.
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        (self.bounds.iter()).fold(Aabb::EMPTY, |all, bounds| all.union(*bounds))
    }

    /// The world-space box about all that is visible; empty when nothing is.
    #[must_use]
    pub fn visible_bounds(&self) -> Aabb {
        let visible = self
            .objects
            .iter()
            .zip(&self.bounds)
            .filter(|(object, _)| object.visible);
        visible.fold(Aabb::EMPTY, |all, (_, bounds)| all.union(*bounds))
    }

    /// Shows or hides an object.
    pub fn set_visible(&mut self, object: usize, visible: bool) {
        self.objects[object].visible = visible;
    }

    /// Puts an object somewhere else.
    pub fn place(&mut self, object: usize, placement: Placement) {
        self.objects[object].placement = placement;
        self.bounds[object] = self.objects[object].bounds_world();
        self.batches = batches(&self.objects);
        self.tree = SceneTree::new(self);
    }

    /// Hides the objects with these ids (from 1).
    ///
    /// # Errors
    /// When there is no object of an id.
    pub fn hide(&mut self, ids: &[usize]) -> Result<(), NoSuchObject> {
        let objects = self.objects.len();
        for &id in ids {
            let index = id.checked_sub(1).filter(|index| *index < objects);
            let index = index.ok_or(NoSuchObject { id, objects })?;
            self.set_visible(index, false);
        }
        Ok(())
    }

    /// Runs of objects that are drawn, and asked for hits, as one: either a single object, or consecutive parts of
    /// one mesh under one model matrix.
    #[must_use]
    pub fn batches(&self) -> &[Range<usize>] {
        &self.batches
    }

    /// Calls `visit` with every batch that a world-space ray may meet, nearer ones first where there are many; `visit`
    /// returns the new end of the ray's interval. What is passed over has no hit in it.
    pub fn visit_batches(&self, ray: &WorldRay, mut visit: impl FnMut(&Range<usize>) -> f64) {
        // A ray without bounds may be anywhere.
        let error = ray.error();
        let is_known = (error.origin + error.direction).is_finite();
        if self.tree.is_empty() || !is_known {
            for batch in &self.batches {
                visit(batch);
            }
        } else {
            self.tree.visit(ray, |batch| visit(&self.batches[batch]));
        }
    }

    /// Calls `visit` with every batch that may be inside a world-space pyramid.
    pub(crate) fn visit_batches_within(
        &self,
        pyramid: &Pyramid,
        mut visit: impl FnMut(&Range<usize>),
    ) {
        if self.tree.is_empty() {
            for batch in &self.batches {
                visit(batch);
            }
        } else {
            self.tree
                .visit_within(pyramid, |batch| visit(&self.batches[batch]));
        }
    }

    /// Triangles of all meshes, hidden ones too.
    #[must_use]
    pub fn triangle_count(&self) -> usize {
        let triangles = self
            .objects
            .iter()
            .filter_map(|object| object.shape.triangles());
        triangles.map(|range| range.len()).sum()
    }

    /// Whether each mesh that is worth a tree has one.
    #[must_use]
    pub fn trees_are_built(&self) -> bool {
        self.meshes.iter().all(|mesh| mesh.is_ready())
    }

    /// Builds the tree of each mesh that has none. Takes about 0.15 s for a million triangles; picks are right before
    /// it is done, only slower.
    pub fn build_trees(&self) {
        self.build_trees_unless(&AtomicBool::new(false));
    }

    /// [`Scene::build_trees`], given up soon after `stop` is set.
    pub fn build_trees_unless(&self, stop: &AtomicBool) {
        for mesh in &self.meshes {
            mesh.build_tree_unless(stop);
        }
    }
}

/// Each mesh of the objects once.
fn meshes(objects: &[Object]) -> Vec<Arc<Mesh>> {
    let mut seen = HashSet::new();
    let shapes = objects.iter().map(|object| &object.shape);
    let meshes = shapes.filter_map(|shape| match shape {
        Shape::Mesh { mesh, .. } => Some(mesh),
        _ => None,
    });
    let first = meshes.filter(|mesh| seen.insert(Arc::as_ptr(mesh)));
    first.cloned().collect()
}

fn batches(objects: &[Object]) -> Vec<Range<usize>> {
    let mut batches: Vec<Range<usize>> = Vec::new();
    for (index, object) in objects.iter().enumerate() {
        match batches.last_mut() {
            Some(batch) if continues(&objects[batch.end - 1], object) => batch.end = index + 1,
            _ => batches.push(index..index + 1),
        }
    }
    batches
}

/// Whether `object` is the next part of the mesh that `before` is a part of, in the same place.
fn continues(before: &Object, object: &Object) -> bool {
    let (
        Shape::Mesh { mesh, part },
        Shape::Mesh {
            mesh: next_mesh,
            part: next_part,
        },
    ) = (&before.shape, &object.shape)
    else {
        return false;
    };
    Arc::ptr_eq(mesh, next_mesh) && part + 1 == *next_part && before.placement == object.placement
}
