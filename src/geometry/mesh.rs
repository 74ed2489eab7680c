//! Triangle meshes: what one file holds.

use super::{
    Aabb, Bvh, Candidate, CornerNormals, Hit, OnTriangle, Ray, Sides, TriangleHit, TriangleTest,
    VertexRay, guarded_volume,
    triangle::{compare_t, is_in_doubt, settled_volume},
};
use crate::colour::Srgb;
use glam::DVec3;
use std::{
    cmp::Ordering,
    ops::Range,
    sync::{OnceLock, atomic::AtomicBool},
};

/// Below this many triangles trying them all takes less than a microsecond. From here on a tree has paid for itself after
/// a dozen rays, whatever the size of the mesh, and a click asks up to 200 (measured: 0.2 us a triangle to build, 17 ns a
/// triangle to try).
const WORTH_A_TREE: usize = 32;

/// What a mesh is made of. Vertices are `f32` about one `f64` origin, so that parts which share a wall keep
/// sharing it to the bit wherever in the world they stand; object space is `origin + position`.
#[derive(Clone, Debug, Default)]
pub struct MeshData {
    /// Where the positions' (0, 0, 0) lies in object space.
    pub origin: DVec3,
    /// Vertices relative to `origin`.
    pub positions: Vec<[f32; 3]>,
    /// Corners as indices into `positions`, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// The objects of the file, in order; together they hold each triangle once.
    pub parts: Vec<Part>,
    /// Colours by runs of triangles, in order; together they hold each triangle once.
    pub colours: Vec<ColourRun>,
    /// A colour for each vertex, or none at all. Multiplies the triangle's colour.
    pub vertex_colours: Vec<Srgb>,
    /// Normals for shading, or none at all.
    pub normals: CornerNormals,
}

/// One object of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// As the file calls it.
    pub name: String,
    /// Its triangles.
    pub triangles: Range<u32>,
}

/// Triangles of one colour.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ColourRun {
    /// Which triangles.
    pub triangles: Range<u32>,
    /// Their colour; `None` where the file gives none.
    pub colour: Option<Srgb>,
}

/// Why data is no mesh.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MeshError {
    /// A coordinate is NaN or infinite.
    #[error("vertex {0} has a coordinate that is not a finite number")]
    NotFinite(usize),
    /// A triangle names a vertex that is not there.
    #[error("triangle {0} uses a vertex that does not exist")]
    NoSuchVertex(usize),
    /// Ranges overlap, leave a gap or run past the end; or a per-vertex or per-corner list has another length.
    #[error("the mesh's {0} do not cover its triangles")]
    Uncovered(&'static str),
}

/// A valid mesh: finite vertices, indices in range, each triangle in one part and of one colour.
pub struct Mesh {
    data: MeshData,
    bounds: Vec<Aabb>,
    tree: OnceLock<Bvh>,
}

impl Mesh {
    /// Checks `data` and takes it.
    ///
    /// # Errors
    /// When it is not a mesh; see [`MeshError`].
    pub fn new(data: MeshData) -> Result<Self, MeshError> {
        check(&data)?;
        let bounds = data
            .parts
            .iter()
            .map(|part| {
                let triangles =
                    &data.triangles[part.triangles.start as usize..part.triangles.end as usize];
                let used = triangles.as_flattened().iter();
                Aabb::around(used.map(|&i| data.origin + wide(data.positions[i as usize])))
            })
            .collect();
        Ok(Self {
            data,
            bounds,
            tree: OnceLock::new(),
        })
    }

    /// What it is made of.
    #[must_use]
    pub fn data(&self) -> &MeshData {
        &self.data
    }

    /// The box about the triangles of a part, in object space; empty for a part without triangles.
    #[must_use]
    pub fn part_bounds(&self, part: usize) -> Aabb {
        self.bounds[part]
    }

    /// The part that holds a triangle.
    #[inline]
    #[must_use]
    pub fn part_of(&self, triangle: u32) -> usize {
        self.data
            .parts
            .partition_point(|part| part.triangles.end <= triangle)
    }

    /// The corners of a triangle, in object space.
    #[must_use]
    pub fn corners(&self, triangle: u32) -> [DVec3; 3] {
        self.vertex_corners(triangle)
            .map(|corner| self.data.origin + corner)
    }

    /// The interpolated shading normal at a point of a triangle, in object space and of any length; `None` where
    /// the mesh has none or they cancel.
    #[must_use]
    pub fn shading_normal(&self, at: &OnTriangle) -> Option<DVec3> {
        let CornerNormals { normals, corners } = &self.data.normals;
        let corners = corners
            .get(at.triangle as usize)?
            .iter()
            .zip(at.barycentric);
        let normal: DVec3 = corners.map(|(&i, s)| s * wide(normals[i as usize])).sum();
        (normal != DVec3::ZERO).then_some(normal)
    }

    /// The colour of a triangle, as the file gives it.
    #[must_use]
    pub fn triangle_colour(&self, triangle: u32) -> Option<Srgb> {
        let runs = &self.data.colours;
        runs[runs.partition_point(|run| run.triangles.end <= triangle)].colour
    }

    /// The linear colour at a point of a triangle: its own (neutral where the file gives none, white where
    /// vertices bring theirs) times its vertices'.
    #[must_use]
    pub fn albedo(&self, at: &OnTriangle) -> [f32; 3] {
        let colours = &self.data.vertex_colours;
        let own = self.triangle_colour(at.triangle);
        if colours.is_empty() {
            return own.unwrap_or(Srgb::NEUTRAL).to_linear();
        }
        let mut sum = [0.0_f32; 3];
        for (&vertex, s) in self.data.triangles[at.triangle as usize]
            .iter()
            .zip(at.barycentric)
        {
            let corner = colours[vertex as usize].to_linear();
            #[expect(clippy::cast_possible_truncation, reason = "a colour")]
            let s = s as f32;
            sum = std::array::from_fn(|i| sum[i] + s * corner[i]);
        }
        let own = own.unwrap_or(Srgb::WHITE).to_linear();
        std::array::from_fn(|i| own[i] * sum[i])
    }

    /// Builds the tree, if the mesh is large enough to be worth one and has none yet. Until then picks try
    /// every triangle: the answer is the same.
    pub fn build_tree(&self) {
        self.build_tree_unless(&AtomicBool::new(false));
    }

    /// [`Mesh::build_tree`], given up soon after `stop` is set.
    pub fn build_tree_unless(&self, stop: &AtomicBool) {
        let MeshData {
            positions,
            triangles,
            ..
        } = &self.data;
        if triangles.len() < WORTH_A_TREE || self.tree.get().is_some() {
            return;
        }
        if let Some(tree) = Bvh::build(positions, triangles, stop) {
            debug_assert_eq!(tree.validate(positions, triangles), Ok(()));
            // Whoever else may have built one meanwhile has built the same.
            let _ = self.tree.set(tree);
        }
    }

    /// The object-space boxes of its tree at a level, 0 being the box about everything: at most `most` of them. None
    /// where there is no tree.
    #[must_use]
    pub fn tree_boxes(&self, level: u32, most: usize) -> Vec<Aabb> {
        let boxes = self.tree.get().map(|tree| tree.boxes(level, most));
        let placed = boxes.into_iter().flatten().map(|bounds| Aabb {
            min: bounds.min + self.data.origin,
            max: bounds.max + self.data.origin,
        });
        placed.collect()
    }

    /// Whether rays are as fast as they will be: there is a tree, or no need of one.
    #[must_use]
    pub fn is_ready(&self) -> bool {
        self.data.triangles.len() < WORTH_A_TREE || self.tree.get().is_some()
    }

    /// The nearest hit of an object-space ray on the parts that `accept` names, of equally near ones that with
    /// the lowest triangle. By [`guarded_volume`]: the choice is that of exact arithmetic.
    #[must_use]
    pub fn closest(&self, ray: &Ray, sides: Sides, accept: impl Fn(usize) -> bool) -> Option<Hit> {
        // What the tree has sifted need not be filtered again.
        #[expect(
            clippy::redundant_closure,
            reason = "a closure is inlined into the walk, its function is not"
        )]
        if self.tree.get().is_some() {
            self.nearest::<true>(
                ray,
                sides,
                |ray, corners| settled_volume(ray, corners),
                accept,
            )
        } else {
            self.nearest::<true>(ray, sides, guarded_volume, accept)
        }
    }

    /// [`Mesh::closest`] by another triangle test, which is asked about every triangle whose box the ray may meet.
    #[must_use]
    pub fn closest_by(
        &self,
        ray: &Ray,
        sides: Sides,
        test: TriangleTest,
        accept: impl Fn(usize) -> bool,
    ) -> Option<Hit> {
        self.nearest::<false>(ray, sides, test, accept)
    }

    #[inline]
    fn nearest<const SIFT: bool>(
        &self,
        ray: &Ray,
        sides: Sides,
        test: impl Fn(&VertexRay, [DVec3; 3]) -> Option<TriangleHit>,
        accept: impl Fn(usize) -> bool,
    ) -> Option<Hit> {
        // Most rays meet nothing and need none.
        let mut local = None;
        let mut best: Option<Hit> = None;
        let mut end = ray.t_max;
        self.visit::<SIFT>(ray, |triangle, corners| {
            let local = &*local.get_or_insert_with(|| VertexRay::new(ray, self.data.origin));
            if let Some(hit) = test(local, corners)
                && (sides == Sides::Both || hit.front)
                && accept(self.part_of(triangle))
            {
                let is_first = best.is_none_or(|best| {
                    let hit = hit.on(triangle, corners);
                    self.order(&hit, &best, local).is_lt()
                });
                if is_first {
                    // The exact parameter may be this much further, and nearer or equal ones may lie before it.
                    end = hit.t + hit.t_error;
                    best = Some(hit.on(triangle, corners));
                }
            }
            end
        });
        best
    }

    /// All hits of an object-space ray on the parts that `accept` names, in the order of [`Mesh::closest`].
    #[must_use]
    pub fn all(&self, ray: &Ray, sides: Sides, accept: impl Fn(usize) -> bool) -> Vec<Hit> {
        let local = VertexRay::new(ray, self.data.origin);
        let mut all = Vec::new();
        self.visit::<true>(ray, |triangle, corners| {
            if let Some(hit) = guarded_volume(&local, corners)
                && (sides == Sides::Both || hit.front)
                && accept(self.part_of(triangle))
            {
                all.push(hit.on(triangle, corners));
            }
            ray.t_max
        });
        all.sort_by(|a, b| self.order(a, b, &local));
        all
    }

    /// Whether `f64` alone leaves open if an object-space ray hits one of the triangles that lie in its interval and
    /// whose parts `accept` names. The same with and without a tree.
    pub fn is_in_doubt(&self, ray: &Ray, accept: impl Fn(usize) -> bool) -> bool {
        let local = VertexRay::new(ray, self.data.origin);
        let inverse = ray.direction.recip();
        let mut found = false;
        let mut visit = |triangle, corners| {
            found = found
                || is_in_doubt(&local, corners)
                    && Aabb::around(corners).may_hit(&local, inverse)
                    && accept(self.part_of(triangle));
            // Once is enough: nothing lies before this.
            if found { f64::NEG_INFINITY } else { ray.t_max }
        };
        if local.is_bounded() {
            self.visit::<false>(ray, visit);
        } else {
            self.every_triangle(&mut visit);
        }
        found
    }

    /// The order along a ray of two of its hits.
    fn order(&self, a: &Hit, b: &Hit, local: &VertexRay) -> Ordering {
        let (Some(on_a), Some(on_b)) = (a.on_triangle, b.on_triangle) else {
            return a.t.total_cmp(&b.t);
        };
        let triangles = [on_a.triangle, on_b.triangle];
        let corners = || triangles.map(|triangle| self.vertex_corners(triangle));
        compare_t(local, (a.t, on_a.t_error), (b.t, on_b.t_error), corners)
            .then(triangles[0].cmp(&triangles[1]))
    }

    /// Every triangle that the ray may hit, with its corners: through the tree, or all of them in order. Where `SIFT` is
    /// false, a tree leaves out none whose box the ray may meet.
    #[inline]
    fn visit<const SIFT: bool>(&self, ray: &Ray, mut visit: impl FnMut(u32, [DVec3; 3]) -> f64) {
        let Some(tree) = self.tree.get() else {
            return self.every_triangle(&mut visit);
        };
        let center = &self.data.origin;
        let mut visit = |found: Candidate| visit(found.triangle(), found.corners());
        if SIFT {
            tree.visit(ray, center, &mut visit);
        } else {
            tree.visit_boxes(ray, center, &mut visit);
        }
    }

    fn every_triangle(&self, visit: &mut impl FnMut(u32, [DVec3; 3]) -> f64) {
        for triangle in (0..).take(self.data.triangles.len()) {
            visit(triangle, self.vertex_corners(triangle));
        }
    }

    fn vertex_corners(&self, triangle: u32) -> [DVec3; 3] {
        self.data.triangles[triangle as usize].map(|i| wide(self.data.positions[i as usize]))
    }
}

impl std::fmt::Debug for Mesh {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Mesh({} triangles)", self.data.triangles.len())
    }
}

fn wide(v: [f32; 3]) -> DVec3 {
    DVec3::from_array(v.map(f64::from))
}

fn check(data: &MeshData) -> Result<(), MeshError> {
    if !data.origin.is_finite() {
        return Err(MeshError::NotFinite(0));
    }
    if let Some(bad) = data
        .positions
        .iter()
        .position(|p| !p.iter().all(|c| c.is_finite()))
    {
        return Err(MeshError::NotFinite(bad));
    }
    let vertices = data.positions.len();
    let in_range = |corners: &[u32; 3], limit: usize| corners.iter().all(|&i| (i as usize) < limit);
    if let Some(bad) = data
        .triangles
        .iter()
        .position(|corners| !in_range(corners, vertices))
    {
        return Err(MeshError::NoSuchVertex(bad));
    }
    let triangles = data.triangles.len();
    if !covers(data.parts.iter().map(|part| &part.triangles), triangles) {
        return Err(MeshError::Uncovered("objects"));
    }
    if !covers(data.colours.iter().map(|run| &run.triangles), triangles) {
        return Err(MeshError::Uncovered("colours"));
    }
    if !(data.vertex_colours.is_empty() || data.vertex_colours.len() == vertices) {
        return Err(MeshError::Uncovered("vertex colours"));
    }
    let CornerNormals { normals, corners } = &data.normals;
    let usable = corners.iter().all(|c| in_range(c, normals.len()))
        && normals.iter().flatten().all(|c| c.is_finite());
    if !(usable && (corners.is_empty() || corners.len() == triangles)) {
        return Err(MeshError::Uncovered("normals"));
    }
    Ok(())
}

/// Whether the ranges follow each other without a gap from 0 to `end`.
fn covers<'a>(mut ranges: impl Iterator<Item = &'a Range<u32>>, end: usize) -> bool {
    ranges.try_fold(0, |at, range| {
        (range.start == at && range.end >= at).then_some(range.end)
    }) == u32::try_from(end).ok()
}
