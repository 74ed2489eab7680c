//! Triangle meshes: what one file holds.

mod rays;
mod validity;

use super::{
    Aabb, Bvh, CornerNormals, OnTriangle,
    crease_normals::crease_normals,
    shares::{in_pieces, in_shares},
};
use crate::colour::Srgb;
use glam::{DVec3, Vec3};
use std::{
    ops::Range,
    sync::{Arc, OnceLock},
};
use validity::{check, store_small};

/// Triangles in a block. Each block has a box, to tell where an object reaches.
pub(crate) const BLOCK: usize = 256;

/// What a mesh is made of. Vertices are `f32` about one `f64` origin: parts that share a wall share it to the bit,
/// wherever in the world they stand. Object space is `origin + position`.
#[derive(Clone, Debug, Default, PartialEq)]
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
    /// The names of materials.
    pub materials: Vec<String>,
    /// A colour for each vertex, or none at all. Multiplies the triangle's colour.
    pub vertex_colours: Vec<Srgb>,
    /// Normals for shading, or none at all; see [`Mesh::normals`].
    pub normals: CornerNormals,
    /// The crease angle, in radians, for computing normals where `normals` is empty or has [`CornerNormals::NONE`];
    /// `None` if none are to be computed.
    pub crease: Option<f32>,
    /// Smoothing groups by runs of triangles, in order; together they hold each triangle once, or there is none. They
    /// count where normals are computed.
    pub smoothing: Vec<SmoothingRun>,
}

impl MeshData {
    /// Triangles of one part, without colours of their own and with one normal per face. `positions` are in object
    /// space, `triangles` index them, counter-clockwise seen from outside. [`Mesh::new`] checks all of it.
    pub fn of_triangles(
        name: impl Into<String>,
        positions: Vec<[f32; 3]>,
        triangles: Vec<[u32; 3]>,
    ) -> Self {
        // [`Mesh::new`] refuses a count above 32 bits: the part does not cover it.
        let all = 0..u32::try_from(triangles.len()).unwrap_or(u32::MAX);
        Self {
            positions,
            parts: vec![Part {
                name: name.into(),
                triangles: all.clone(),
            }],
            colours: vec![ColourRun {
                triangles: all,
                colour: None,
                material: None,
            }],
            triangles,
            ..Self::default()
        }
    }
}

/// One object of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// As the file calls it.
    pub name: String,
    /// Its triangles.
    pub triangles: Range<u32>,
}

/// Triangles of one colour and one material.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ColourRun {
    /// Which triangles.
    pub triangles: Range<u32>,
    /// Their colour; `None` where the file gives none.
    pub colour: Option<Srgb>,
    /// An index into [`MeshData::materials`]; `None`, or one that is not there, where the file names none.
    pub material: Option<u32>,
}

/// Triangles of one smoothing group.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SmoothingRun {
    /// Which triangles.
    pub triangles: Range<u32>,
    /// Edges within a group are smooth up to 85 degrees, those between two are sharp. 0 is no group: there the crease
    /// angle decides.
    pub group: u32,
}

/// Why data is not a valid mesh.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MeshError {
    /// A coordinate, or the origin's (then the vertex is 0), is beyond the range of numbers; see
    /// [`range`](crate::geometry::range).
    #[error("vertex {0} has a coordinate that is not a number up to 1.29e33")]
    OutOfRange(usize),
    /// A triangle names a vertex that is not there.
    #[error("triangle {0} uses a vertex that does not exist")]
    NoSuchVertex(usize),
    /// Ranges overlap, leave a gap or run past the end; or a per-vertex or per-corner list has another length.
    #[error("the mesh's {0} do not cover its triangles")]
    Uncovered(&'static str),
}

/// A valid mesh: vertices and indices in range, each triangle in one part and of one colour.
///
/// # Memory
/// `data.positions` take 12 bytes a vertex, `data.vertex_colours` 3 where the file has colours, and `data.triangles` 12
/// bytes a triangle. Lists and single picks need no more. A part takes 80 bytes and its name, a run of one material 20,
/// one of a smoothing group 12.
/// Normals take 12 bytes each. Unless each vertex has one, as on a smooth surface, their indices take 12 bytes a
/// triangle. Normals are kept, since saving and shading by rays need them again; where the file gives only some, those
/// are kept twice. A tree for many rays takes at most 64 bytes a triangle of a surface, and `blocks`, for objects that
/// may be moved, 48 bytes for 256 triangles. Neither the file's text nor its numbers in `f64` are kept. The lines
/// of the faces in the file take 4 bytes a triangle, and 40 for 256 KiB of it (`scene::obj::Contents`).
pub struct Mesh {
    data: Arc<MeshData>,
    bounds: Arc<[Aabb]>,
    tree: OnceLock<Bvh>,
    normals: OnceLock<CornerNormals>,
    /// Boxes about [`BLOCK`] triangles each.
    blocks: OnceLock<Vec<Aabb>>,
    /// The only triangles that rays are tested against, in order; `None` for all.
    few: Option<Vec<u32>>,
}

/// Meshes are equal where their data are, whatever was computed from them.
impl PartialEq for Mesh {
    fn eq(&self, other: &Self) -> bool {
        let is_one = Arc::ptr_eq(&self.data, &other.data);
        (is_one || self.data == other.data) && self.few == other.few
    }
}

impl Mesh {
    /// Checks `data` and takes it. Coordinates are [`stored`](crate::geometry::range::stored).
    ///
    /// ```
    /// use sightline::geometry::{Mesh, MeshData, MeshError};
    ///
    /// let corners = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    /// let of = |triangle| MeshData::of_triangles("flag", corners.clone(), vec![triangle]);
    /// assert_eq!(Mesh::new(of([0, 1, 2]))?.data().parts[0].name, "flag");
    /// assert_eq!(Mesh::new(of([0, 1, 3])).unwrap_err(), MeshError::NoSuchVertex(0));
    /// # Ok::<(), MeshError>(())
    /// ```
    ///
    /// # Errors
    /// When it is not a mesh; see [`MeshError`].
    pub fn new(mut data: MeshData) -> Result<Self, MeshError> {
        check(&data)?;
        store_small(&mut data);
        let bounds = bounds_of_parts(&data).into();
        Ok(Self::of(Arc::new(data), bounds, None))
    }

    /// With nothing computed from its data yet but the boxes about its parts.
    fn of(data: Arc<MeshData>, bounds: Arc<[Aabb]>, few: Option<Vec<u32>>) -> Self {
        Self {
            data,
            bounds,
            tree: OnceLock::new(),
            normals: OnceLock::new(),
            blocks: OnceLock::new(),
            few,
        }
    }

    /// What it is made of.
    pub fn data(&self) -> &MeshData {
        &self.data
    }

    /// The triangles of a part; none of one that does not exist.
    pub fn part_triangles(&self, part: usize) -> Range<u32> {
        let part = self.data.parts.get(part);
        part.map_or(0..0, |part| part.triangles.clone())
    }

    /// The box about the triangles of a part, in object space; empty for a part that has no triangles or does not
    /// exist.
    pub fn part_bounds(&self, part: usize) -> Aabb {
        self.bounds.get(part).copied().unwrap_or(Aabb::EMPTY)
    }

    /// The part that holds a triangle.
    #[inline]
    pub fn part_of(&self, triangle: u32) -> usize {
        let parts = &self.data.parts;
        parts.partition_point(|part| part.triangles.end <= triangle)
    }

    /// The boxes of the blocks, in object space; made when first asked for.
    pub(crate) fn blocks(&self) -> &[Aabb] {
        self.blocks.get_or_init(|| {
            let count = self.data.triangles.len().div_ceil(BLOCK);
            let boxes = in_shares(count, |share| {
                let blocks = self.data.triangles.chunks(BLOCK);
                let blocks = blocks.skip(share.start).take(share.len());
                let boxes = blocks.map(|block| around(&self.data, block));
                boxes.collect::<Vec<_>>()
            });
            boxes.concat()
        })
    }

    /// Whether the boxes are made.
    #[cfg(test)]
    pub(crate) fn has_blocks(&self) -> bool {
        self.blocks.get().is_some()
    }

    /// The corners of a triangle, in object space.
    ///
    /// # Panics
    /// When there is no such triangle.
    pub fn corners(&self, triangle: u32) -> [DVec3; 3] {
        self.vertex_corners(triangle)
            .map(|corner| self.data.origin + corner)
    }

    /// The normals for shading. Those that the data lacks are computed on all cores when first asked for; lists and
    /// picks never ask.
    pub fn normals(&self) -> &CornerNormals {
        let (triangles, given) = (&self.data.triangles, &self.data.normals);
        let Some(crease) = self.data.crease.filter(|_| !given.is_by_vertex()) else {
            return given;
        };
        self.normals.get_or_init(|| {
            let computed = crease_normals(
                &self.data.positions,
                triangles,
                crease,
                &self.data.smoothing,
            );
            given.completed_by(computed, triangles)
        })
    }

    /// The interpolated shading normal at a point of a triangle, in object space and of any length; `None` where
    /// the mesh has none or they cancel.
    pub fn shading_normal(&self, at: &OnTriangle) -> Option<DVec3> {
        let shading = self.normals();
        let corners = shading.corners_of(&self.data.triangles);
        let corners = corners.get(at.triangle as usize)?.iter();
        let corners = corners.zip(at.barycentric);
        let normal = |(&i, s): (&u32, f64)| s * wide(shading.normals[i as usize]);
        let normal: DVec3 = corners.map(normal).sum();
        (normal != DVec3::ZERO).then_some(normal)
    }

    /// The colour of a triangle, as the file gives it.
    ///
    /// # Panics
    /// When there is no such triangle.
    pub fn triangle_colour(&self, triangle: u32) -> Option<Srgb> {
        self.run_of(triangle).colour
    }

    /// The name of a triangle's material, as the file calls it.
    ///
    /// # Panics
    /// When there is no such triangle.
    pub fn triangle_material(&self, triangle: u32) -> Option<&str> {
        let material = self.run_of(triangle).material?;
        Some(self.data.materials.get(material as usize)?)
    }

    fn run_of(&self, triangle: u32) -> &ColourRun {
        let runs = &self.data.colours;
        &runs[runs.partition_point(|run| run.triangles.end <= triangle)]
    }

    /// The linear colour at a point of a triangle: the triangle's own times its vertices'. Where the file gives the
    /// triangle none, it is white if vertices have colours, else neutral.
    ///
    /// # Panics
    /// When there is no such triangle.
    pub fn albedo(&self, at: &OnTriangle) -> [f32; 3] {
        let colours = &self.data.vertex_colours;
        let own = self.triangle_colour(at.triangle);
        if colours.is_empty() {
            return own.unwrap_or(Srgb::NEUTRAL).to_linear();
        }
        let mut sum = [0.0_f32; 3];
        let corners = self.data.triangles[at.triangle as usize];
        for (vertex, s) in corners.into_iter().zip(at.barycentric) {
            let corner = colours[vertex as usize].to_linear();
            #[expect(clippy::cast_possible_truncation, reason = "a colour")]
            let s = s as f32;
            sum = std::array::from_fn(|i| sum[i] + s * corner[i]);
        }
        let own = own.unwrap_or(Srgb::WHITE).to_linear();
        std::array::from_fn(|i| own[i] * sum[i])
    }

    /// The corners of a triangle, about the mesh's origin.
    pub(crate) fn vertex_corners(&self, triangle: u32) -> [DVec3; 3] {
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

/// The box about triangles, in object space. Adding the origin keeps coordinates in order.
fn around(data: &MeshData, triangles: &[[u32; 3]]) -> Aabb {
    let (mut min, mut max) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    for vertex in triangles.as_flattened() {
        let position = Vec3::from(data.positions[*vertex as usize]);
        (min, max) = (min.min(position), max.max(position));
    }
    let [min, max] = [min, max].map(|corner| data.origin + corner.as_dvec3());
    Aabb { min, max }
}

/// The box about the triangles of each part.
fn bounds_of_parts(data: &MeshData) -> Vec<Aabb> {
    let of_pieces = in_pieces(data.triangles.len(), |piece| {
        let ends = |part: &Part| [part.triangles.start, part.triangles.end].map(|i| i as usize);
        let first = (data.parts).partition_point(|part| ends(part)[1] <= piece.start);
        let parts = data.parts[first..].iter().map(ends);
        let parts = parts.take_while(|[start, _]| *start < piece.end);
        let bounds = parts.map(|[start, end]| {
            let part = piece.start.max(start)..piece.end.min(end);
            around(data, &data.triangles[part])
        });
        (first, bounds.collect::<Vec<_>>())
    });
    let mut all = vec![Aabb::EMPTY; data.parts.len()];
    for (first, bounds) in of_pieces {
        for (part, bounds) in all[first..].iter_mut().zip(bounds) {
            *part = part.union(bounds);
        }
    }
    all
}
