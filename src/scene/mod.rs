//! The scene: objects in the world, each a shape with a model matrix.

mod extent;
#[cfg(feature = "files")]
mod files;
mod in_file;
mod narrowed;
mod object;
mod object_list;
mod section;
mod tree;

pub use extent::Among;
#[cfg(feature = "files")]
pub use files::{
    Cancelled, DescriptionError, Detail, FileError, FilesAgain, LoadError, Loaded, MeshFile,
    MeshFiles, ObjError, ObjFile, Problem, Progress, SaveError, Warning, description, gallery,
    load, load_with, obj, save,
};
#[cfg(feature = "window")]
pub(crate) use files::{Stamp, absolute, is_scene_file, matrix_rows, title};
pub use in_file::{FaceInFile, InFile, VertexInFile};
pub use object::{Object, Shape};
pub use object_list::ObjectList;
pub use section::{FlatFaces, NoSection};

use crate::geometry::{Aabb, Mesh, Placement, Pyramid, WorldRay};
use glam::DVec3;
use object_list::ListKey;
use std::{
    collections::{BTreeSet, HashSet},
    ops::{ControlFlow, Range},
    sync::{Arc, atomic::AtomicBool},
};
use tree::SceneTree;

/// An id that a person wrote names no object.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no object {id}: ids run from 1 to {objects}")]
pub struct NoSuchObject {
    /// The id as it was written: a number from 1, no index.
    pub id: usize,
    /// How many objects there are.
    pub objects: usize,
}

/// Identifies a scene and its clones until they are changed. Holds only a weak reference.
#[doc(hidden)] // public for tests
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SceneKey(ListKey);

impl SceneKey {
    /// Whether this key identifies `scene` in its present state.
    pub fn is_of(&self, scene: &Scene) -> bool {
        *self == scene.key()
    }

    /// Whether a scene with this key still exists.
    pub fn is_in_use(&self) -> bool {
        self.0.is_in_use()
    }
}

/// Objects in order. Functions count them from 0: an `object` is an index. What people read and write (an `id`) counts
/// them from 1; [`Scene::index_of`] takes it to an index. A clone shares its data until one of the two is changed.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    objects: ObjectList,
    batches: Arc<Vec<Range<usize>>>,
    meshes: Arc<Vec<Arc<Mesh>>>,
    tree: Arc<SceneTree>,
}

impl Scene {
    /// A scene of these objects, in this order.
    pub fn new(objects: Vec<Object>) -> Self {
        let objects = ObjectList::new(objects);
        let mut scene = Self {
            batches: Arc::new(batches(&objects)),
            meshes: Arc::new(meshes(&objects)),
            tree: Arc::default(),
            objects,
        };
        scene.tree = Arc::new(SceneTree::new(&scene));
        scene
    }

    /// The key that identifies this scene until it is changed.
    #[doc(hidden)] // public for tests
    pub fn key(&self) -> SceneKey {
        SceneKey(self.objects.key())
    }

    /// All objects, hidden ones too.
    pub fn objects(&self) -> &ObjectList {
        &self.objects
    }

    /// Each mesh of the objects once, in order of first use.
    pub fn meshes(&self) -> &[Arc<Mesh>] {
        &self.meshes
    }

    /// The world-space box about an object; see [`Object::bounds_world`].
    ///
    /// # Panics
    /// When there is no object of this index.
    pub fn bounds_of(&self, object: usize) -> Aabb {
        self.objects.bounds_of(object)
    }

    /// The centre of the box about an object, along the object's own axes and in its own space: a point that stays the
    /// same wherever the object stands.
    ///
    /// # Panics
    /// When there is no object of this index.
    pub fn centre_of(&self, object: usize) -> DVec3 {
        extent::bounds_object(&self.objects()[object]).center()
    }

    /// The world-space box about a run of objects.
    pub(crate) fn bounds_of_batch(&self, batch: &Range<usize>) -> Aabb {
        self.bounds_among(batch.clone())
    }

    /// The world-space box about some objects, hidden ones too.
    ///
    /// # Panics
    /// When there is no object of such an index.
    pub fn bounds_among(&self, objects: impl Iterator<Item = usize>) -> Aabb {
        let boxes = objects.map(|object| self.bounds_of(object));
        boxes.fold(Aabb::EMPTY, Aabb::union)
    }

    /// The world-space box about all objects, hidden ones too; empty when there are none.
    pub fn bounds(&self) -> Aabb {
        self.objects.sums().bounds
    }

    /// The world-space box about all visible objects; empty when there are none.
    pub fn visible_bounds(&self) -> Aabb {
        self.objects.sums().visible_bounds
    }

    /// Whether a condition holds for the box about some visible object. It must hold for a box if it holds for one
    /// inside that box.
    pub(crate) fn any_visible(&self, holds: impl Fn(&Aabb) -> bool) -> bool {
        self.objects.any_visible(holds)
    }

    /// How many objects are hidden.
    pub fn hidden_count(&self) -> usize {
        self.objects.sums().hidden
    }

    /// Triangles of all meshes, hidden ones too.
    pub fn triangle_count(&self) -> usize {
        self.objects.sums().triangles
    }

    /// Shows or hides an object.
    ///
    /// # Panics
    /// When there is no object of this index.
    pub fn set_visible(&mut self, object: usize, visible: bool) {
        (self.objects).change(&[object], |object| object.visible = visible);
    }

    /// Toggles the visibility of these objects.
    ///
    /// # Panics
    /// When an index names no object.
    pub fn toggle(&mut self, objects: &[usize]) {
        self.objects
            .change(objects, |object| object.visible ^= true);
    }

    /// Gives an object a new placement.
    ///
    /// # Panics
    /// When there is no object of this index.
    pub fn place(&mut self, object: usize, placement: Placement) {
        let before = self.joins(object);
        (self.objects).change_bounds(object, |object| object.placement = placement);
        if self.joins(object) == before {
            let batch = self.batch_number(object);
            let bounds = self.bounds_of_batch(&self.batches[batch]);
            let first = &self.objects[self.batches[batch].start];
            Arc::make_mut(&mut self.tree).renew(batch, first, bounds);
        } else {
            self.batches = Arc::new(batches(&self.objects));
            self.tree = Arc::new(SceneTree::new(self));
        }
    }

    /// Whether an object shares a batch with the object before it, and with the object after it.
    fn joins(&self, object: usize) -> [bool; 2] {
        let is_joined = |first: usize| {
            let after = self.objects.get(first + 1);
            after.is_some_and(|after| continues(&self.objects[first], after))
        };
        [
            object.checked_sub(1).is_some_and(is_joined),
            is_joined(object),
        ]
    }

    /// The index of the object that people call `id`: ids run from 1.
    ///
    /// # Errors
    /// When the id names no object.
    pub fn index_of(&self, id: usize) -> Result<usize, NoSuchObject> {
        let objects = self.objects.len();
        let index = id.checked_sub(1).filter(|index| *index < objects);
        index.ok_or(NoSuchObject { id, objects })
    }

    /// Shows these objects if `visible`, else hides them. An index may occur more than once.
    ///
    /// # Panics
    /// When an index names no object. No object is then changed.
    pub fn show(&mut self, objects: &[usize], visible: bool) {
        let differs = |object: &usize| self.objects[*object].visible != visible;
        let changed: BTreeSet<usize> = objects.iter().copied().filter(differs).collect();
        self.toggle(&Vec::from_iter(changed));
    }

    /// Runs of objects that are drawn and intersected as one: either a single object, or consecutive parts of one mesh
    /// under one model matrix.
    #[doc(hidden)] // public for tests
    pub fn batches(&self) -> &[Range<usize>] {
        &self.batches
    }

    /// The batch that an object belongs to.
    pub(crate) fn batch_of(&self, object: usize) -> &Range<usize> {
        &self.batches[self.batch_number(object)]
    }

    fn batch_number(&self, object: usize) -> usize {
        self.batches.partition_point(|batch| batch.end <= object)
    }

    /// Calls `visit` with every batch that a world-space ray may hit, nearer boxes first where there is a tree. `visit`
    /// returns the new end of the ray's interval. The skipped batches have no hit in that interval.
    #[doc(hidden)] // public for tests
    pub fn visit_batches(&self, ray: &WorldRay, mut visit: impl FnMut(&Range<usize>) -> f64) {
        if self.tree.is_empty() || !ray.has_bounds() {
            for batch in self.batches.iter() {
                visit(batch);
            }
        } else {
            self.tree.visit(ray, |batch| visit(&self.batches[batch]));
        }
    }

    /// A test whether a world-space ray may hit a batch at a `t` up to some end. A tree visits each batch for which it
    /// holds, and perhaps more.
    pub(crate) fn box_test<'a>(
        &'a self,
        ray: &'a WorldRay,
    ) -> impl Fn(&Range<usize>, f64) -> bool + 'a {
        let seen = ray.has_bounds().then(|| tree::Seen::new(ray));
        move |batch, end| {
            let (first, bounds) = (&self.objects[batch.start], self.bounds_of_batch(batch));
            (seen.as_ref()).is_none_or(|seen| tree::may_hit(seen, first, bounds, end))
        }
    }

    /// Calls `visit` with every batch that may be inside a world-space pyramid, until `visit` breaks.
    pub(crate) fn visit_batches_within<'a>(
        &'a self,
        pyramid: &Pyramid,
        mut visit: impl FnMut(&'a Range<usize>) -> ControlFlow<()>,
    ) {
        if self.tree.is_empty() {
            let _ = self.batches.iter().try_for_each(visit);
        } else {
            self.tree
                .visit_within(pyramid, |batch| visit(&self.batches[batch]));
        }
    }

    /// Whether `is_it` holds for the index of some batch whose world-space box meets `bounds`. Also true when the
    /// search would take too long. Without a tree, every batch is asked, whatever its box.
    pub(crate) fn meets_batch(&self, bounds: &Aabb, mut is_it: impl FnMut(usize) -> bool) -> bool {
        if self.tree.is_empty() {
            (0..self.batches.len()).any(is_it)
        } else {
            self.tree.meets(bounds, &mut is_it)
        }
    }

    /// Whether each mesh that needs a tree has one.
    pub fn trees_are_built(&self) -> bool {
        self.meshes.iter().all(|mesh| mesh.is_ready())
    }

    /// Builds the tree of each mesh that has none. Takes about 0.15 s for a million triangles. Until then picks are
    /// right, only slower.
    pub fn build_trees(&self) {
        self.build_trees_unless(&AtomicBool::new(false));
    }

    /// [`Scene::build_trees`], but stops soon after `stop` is set.
    pub fn build_trees_unless(&self, stop: &AtomicBool) {
        for mesh in self.meshes.iter() {
            mesh.build_tree_unless(stop);
        }
    }

    /// Builds the blocks of each mesh, which the first move of one of its objects needs.
    pub fn prepare_moves(&self) {
        for mesh in self.meshes.iter() {
            mesh.blocks();
        }
    }
}

/// A scene of these objects, in this order.
impl FromIterator<Object> for Scene {
    fn from_iter<T: IntoIterator<Item = Object>>(objects: T) -> Self {
        Self::new(objects.into_iter().collect())
    }
}

/// Each mesh of the objects once.
fn meshes(objects: &ObjectList) -> Vec<Arc<Mesh>> {
    let mut seen = HashSet::new();
    let meshes = objects.iter().filter_map(|object| object.shape.mesh());
    let first = meshes.filter(|mesh| seen.insert(Arc::as_ptr(mesh)));
    first.cloned().collect()
}

fn batches(objects: &ObjectList) -> Vec<Range<usize>> {
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
    let (Shape::Mesh { mesh: a, part: i }, Shape::Mesh { mesh: b, part: j }) =
        (&before.shape, &object.shape)
    else {
        return false;
    };
    Arc::ptr_eq(a, b) && i.checked_add(1) == Some(*j) && before.placement == object.placement
}
