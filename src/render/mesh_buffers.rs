//! Vertex and index buffers of one mesh.

use super::{
    abilities::Numbers,
    gpu::{Gpu, GpuError},
    shader_structs::Vertex,
};
use crate::{
    colour::Srgb,
    geometry::{Cuboid, Mesh, Sphere, Square, face_normal, sin_cos_quarters},
};
use glam::{DVec3, Vec3};
use std::{borrow::Cow, f64::consts::PI, ops::Range, sync::Arc};
use wgpu::BufferUsages;

/// The most triangles that a software adapter draws by one call. It keeps them, transformed, until they are drawn: half
/// a gigabyte for ten million.
pub(super) const SOFTWARE_CALL: usize = 1 << 18;

/// A mesh in graphics memory. Its triangles are the mesh's, in order.
#[derive(Clone, Debug)]
pub(super) struct MeshBuffers {
    pub triangles: u32,
    chunks: Arc<[Chunk]>,
}

/// Triangles of a mesh that one call can draw.
#[derive(Debug)]
struct Chunk {
    triangles: Range<u32>,
    /// The first triangle that is in its buffers.
    first: u32,
    vertices: wgpu::Buffer,
    /// `None` where each triangle has three vertices to itself.
    indices: Option<wgpu::Buffer>,
}

impl MeshBuffers {
    /// Uploads a mesh.
    pub fn upload(gpu: &Gpu, mesh: &Mesh) -> Result<Self, GpuError> {
        let buffers = Self::new(gpu, Indexed::of(mesh))?;
        gpu.note_triangles(mesh.data().triangles.len());
        Ok(buffers)
    }

    fn new(gpu: &Gpu, indexed: Indexed) -> Result<Self, GpuError> {
        let Indexed {
            vertices,
            spacings,
            triangles,
        } = indexed;
        let vertex = |i: usize| {
            let mut vertex = vertices(i);
            vertex.colour[3] = spacings[i];
            vertex
        };
        let count = triangles.len();
        let most = gpu.device.limits().max_buffer_size;
        let largest = (spacings.len() * size_of::<Vertex>()).max(size_of_val(&*triangles)) as u64;
        let is_indexed = gpu.numbers == Numbers::Primitives && largest <= most;
        let called = if gpu.is_software() {
            SOFTWARE_CALL
        } else {
            usize::MAX
        };
        let (name, usage) = ("vertices", BufferUsages::VERTEX);
        let chunks: Result<_, GpuError> = if is_indexed {
            let indices = gpu.buffer("triangles", BufferUsages::INDEX, &triangles)?;
            drop(triangles);
            let vertices = gpu.buffer_of(name, usage, (0..spacings.len()).map(vertex))?;
            let chunk = |triangles| Chunk {
                triangles,
                first: 0,
                vertices: vertices.clone(),
                indices: Some(indices.clone()),
            };
            Ok(in_calls(count, called).map(chunk).collect())
        } else {
            let held = most / (3 * size_of::<Vertex>()) as u64;
            let held = usize::try_from(held).unwrap_or(usize::MAX).max(1);
            let chunk = |of: Range<u32>| {
                let corners = triangles[of.start as usize..of.end as usize].as_flattened();
                let vertices = corners.iter().map(|&i| vertex(i as usize));
                Ok(Chunk {
                    first: of.start,
                    triangles: of,
                    vertices: gpu.buffer_of(name, usage, vertices)?,
                    indices: None,
                })
            };
            in_calls(count, called.min(held)).map(chunk).collect()
        };
        Ok(Self {
            triangles: index(count),
            chunks: chunks?,
        })
    }

    /// Triangles as those of one call after another.
    pub fn calls(&self, triangles: &Range<u32>) -> impl Iterator<Item = Range<u32>> {
        let within = |chunk: &Chunk| {
            let start = chunk.triangles.start.max(triangles.start);
            start..chunk.triangles.end.min(triangles.end)
        };
        let calls = self.chunks.iter().map(within);
        calls.filter(|triangles| !triangles.is_empty())
    }

    /// Draws triangles by one call, for some instances. The call numbers them from 0.
    pub fn draw(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        triangles: &Range<u32>,
        instances: Range<u32>,
    ) {
        let mut chunks = self.chunks.iter();
        let Some(chunk) = chunks.find(|chunk| chunk.triangles.contains(&triangles.start)) else {
            return;
        };
        let [first, end] = [triangles.start, triangles.end].map(|i| 3 * (i - chunk.first));
        if let Some(indices) = &chunk.indices {
            pass.set_vertex_buffer(0, chunk.vertices.slice(..));
            pass.set_index_buffer(indices.slice(..), wgpu::IndexFormat::Uint32);
            pass.draw_indexed(first..end, 0, instances);
        } else {
            let byte = u64::from(first) * size_of::<Vertex>() as u64;
            pass.set_vertex_buffer(0, chunk.vertices.slice(byte..));
            pass.draw(0..end - first, instances);
        }
    }

    /// The unit cube as twelve triangles.
    pub fn cube(gpu: &Gpu) -> Result<Self, GpuError> {
        Self::quads(gpu, &Cuboid::NORMALS.map(Cuboid::face))
    }

    /// The unit square as two triangles.
    pub fn square(gpu: &Gpu) -> Result<Self, GpuError> {
        Self::quads(gpu, &[Square::corners()])
    }

    /// The sphere by parallels and meridians: `rings` quadrilaterals from pole to pole, twice as many around.
    pub fn ball(gpu: &Gpu, rings: u32) -> Result<Self, GpuError> {
        let spokes = 2 * rings;
        let places = (0..=rings).flat_map(|ring| (0..spokes).map(move |spoke| (ring, spoke)));
        let vertices = places.map(|(ring, spoke)| {
            let (sin, cos) = libm::sincos(PI * f64::from(ring) / f64::from(rings));
            let (side, front) = sin_cos_quarters(4.0 * f64::from(spoke) / f64::from(spokes));
            let normal = DVec3::new(sin * side, cos, sin * front);
            Vertex {
                position: (Sphere::RADIUS * normal).as_vec3().to_array(),
                normal: normal.as_vec3().to_array(),
                part: 0,
                colour: [0; 4],
            }
        });
        let cells = (0..rings).flat_map(|ring| (0..spokes).map(move |spoke| (ring, spoke)));
        let triangles = cells.flat_map(|(ring, spoke)| {
            let at = |ring, spoke| ring * spokes + spoke % spokes;
            let [a, b] = [at(ring, spoke), at(ring + 1, spoke)];
            let [c, d] = [at(ring + 1, spoke + 1), at(ring, spoke + 1)];
            [[a, b, c], [a, c, d]]
        });
        let indexed = Indexed::stored(vertices.collect(), triangles.collect());
        Self::new(gpu, indexed)
    }

    /// Flat quadrilaterals, counter-clockwise seen from outside.
    fn quads(gpu: &Gpu, quads: &[[DVec3; 4]]) -> Result<Self, GpuError> {
        let mut vertices = Vec::new();
        let mut triangles = Vec::new();
        for (first, quad) in (0..).step_by(4).zip(quads) {
            let quad = quad.map(|corner| corner.as_vec3().to_array());
            let normal = face_normal([quad[0], quad[1], quad[2]]).to_array();
            vertices.extend(quad.map(|position| Vertex {
                position,
                normal,
                part: 0,
                colour: [0; 4],
            }));
            triangles.extend([[0, 1, 2], [0, 2, 3]].map(|corners| corners.map(|i| first + i)));
        }
        Self::new(gpu, Indexed::stored(vertices, triangles))
    }
}

/// Triangles by the calls that draw them, each of at most so many.
fn in_calls(triangles: usize, most: usize) -> impl Iterator<Item = Range<u32>> {
    let call = move |start: usize| index(start)..index(start.saturating_add(most).min(triangles));
    (0..triangles).step_by(most).map(call)
}

/// An index as the adapter has it. More do not fit into its memory.
fn index(i: usize) -> u32 {
    u32::try_from(i).unwrap_or(u32::MAX)
}

/// What is copied to the adapter.
struct Indexed<'a> {
    /// Makes a vertex but for its spacing, when it is copied: vertices never stand in memory twice.
    vertices: Box<dyn Fn(usize) -> Vertex + 'a>,
    /// For each vertex, how far apart the edges about it are.
    spacings: Vec<u16>,
    triangles: Cow<'a, [[u32; 3]]>,
}

impl<'a> Indexed<'a> {
    /// Vertices that stand in memory.
    fn stored(vertices: Vec<Vertex>, triangles: Vec<[u32; 3]>) -> Self {
        let corners = |triangle: usize| triangles[triangle].map(|i| vertices[i as usize].position);
        Self {
            spacings: spacings(vertices.len(), &triangles, corners),
            vertices: Box::new(move |i| vertices[i]),
            triangles: Cow::Owned(triangles),
        }
    }

    /// The vertices of a mesh.
    fn of(mesh: &'a Mesh) -> Self {
        let (data, shading) = (mesh.data(), mesh.normals());
        let corners =
            |triangle: usize| data.triangles[triangle].map(|i| data.positions[i as usize]);
        // In a smooth surface of one part and colour, such as a scan, each position is one vertex already.
        if let ([_], [run, others @ ..]) = (&*data.parts, &*data.colours)
            && others.iter().all(|other| other.colour == run.colour)
            && data.vertex_colours.is_empty()
            && shading.is_by_vertex()
        {
            let colour = colour(run.colour, None);
            return Self {
                vertices: Box::new(move |i| Vertex {
                    position: data.positions[i],
                    normal: shading.normals[i],
                    part: 0,
                    colour,
                }),
                spacings: spacings(data.positions.len(), &data.triangles, corners),
                triangles: Cow::Borrowed(&data.triangles),
            };
        }
        let of_corners = shading.corners_of(&data.triangles);
        let normal = move |triangle: usize, place: usize| match of_corners.get(triangle) {
            Some(corners) => shading.normals[corners[place] as usize],
            None => face_normal(corners(triangle)).to_array(),
        };
        let (first_corners, triangles) = unify(mesh, normal);
        Self {
            spacings: spacings(first_corners.len(), &triangles, corners),
            vertices: Box::new(move |i| {
                let (triangle, place) = split(first_corners[i]);
                let position = data.triangles[triangle][place] as usize;
                let own = mesh.triangle_colour(index(triangle));
                Vertex {
                    position: data.positions[position],
                    normal: normal(triangle, place),
                    part: index(mesh.part_of(index(triangle))),
                    colour: colour(own, data.vertex_colours.get(position).copied()),
                }
            }),
            triangles: Cow::Owned(triangles),
        }
    }
}

/// One vertex for each distinct (position, normal, part, colour) that a corner has, as the first corner that has it,
/// and triangles of these vertices. A corner is 3 * triangle + place.
fn unify(mesh: &Mesh, normal: impl Fn(usize, usize) -> [f32; 3]) -> (Vec<u32>, Vec<[u32; 3]>) {
    const NONE: u32 = u32::MAX;
    let data = mesh.data();
    let mut vertices: Vec<u32> = Vec::with_capacity(data.positions.len());
    // The vertices at each position as a linked list: the latest, and for each vertex the one before.
    let mut latest = vec![NONE; data.positions.len()];
    let mut before: Vec<u32> = Vec::with_capacity(data.positions.len());
    let mut triangles = Vec::with_capacity(data.triangles.len());
    let (mut part, mut run) = (0, 0);
    for (triangle, corners) in data.triangles.iter().enumerate() {
        while data.parts[part].triangles.end <= index(triangle) {
            part += 1;
        }
        while data.colours[run].triangles.end <= index(triangle) {
            run += 1;
        }
        let (part, run) = (&data.parts[part], &data.colours[run]);
        triangles.push(std::array::from_fn(|place| {
            let own_normal = Vec3::from(normal(triangle, place));
            let is_same = |vertex: u32| {
                let (other, other_place) = split(vertices[vertex as usize]);
                Vec3::from(normal(other, other_place)) == own_normal
                    && part.triangles.contains(&index(other))
                    && (run.triangles.contains(&index(other))
                        || run.colour == mesh.triangle_colour(index(other)))
            };
            let latest = &mut latest[corners[place] as usize];
            let mut found = *latest;
            while found != NONE && !is_same(found) {
                found = before[found as usize];
            }
            if found == NONE {
                found = index(vertices.len());
                vertices.push(index(3 * triangle + place));
                before.push(*latest);
                *latest = found;
            }
            found
        }));
    }
    (vertices, triangles)
}

/// A corner's triangle and place.
fn split(corner: u32) -> (usize, usize) {
    (corner as usize / 3, corner as usize % 3)
}

/// How far apart the edges about each vertex are: the height of its widest triangle over that triangle's longest side,
/// as the upper half of the bits of an `f32`. Of positive numbers, the larger has the larger bits.
fn spacings(
    vertices: usize,
    triangles: &[[u32; 3]],
    corners: impl Fn(usize) -> [[f32; 3]; 3],
) -> Vec<u16> {
    let mut spacings = vec![0; vertices];
    for (number, triangle) in triangles.iter().enumerate() {
        let [a, b, c] = corners(number).map(|corner| Vec3::from(corner).as_dvec3());
        let [ab, bc, ca] = [b - a, c - b, a - c];
        let longest = (ab.length_squared())
            .max(bc.length_squared())
            .max(ca.length_squared());
        let height = (ab.cross(ca).length_squared() / longest).sqrt();
        #[expect(clippy::cast_possible_truncation, reason = "opacities need no more")]
        let upper_half = ((height.max(0.0) as f32).to_bits() >> 16) as u16;
        for i in triangle {
            let noted = &mut spacings[*i as usize];
            *noted = upper_half.max(*noted);
        }
    }
    spacings
}

/// A triangle's colour times a vertex's, as in [`Mesh::albedo`]: linear, in 65535ths, which are finer than the steps of
/// 8-bit sRGB everywhere.
fn colour(own: Option<Srgb>, vertex: Option<Srgb>) -> [u16; 4] {
    let missing = if vertex.is_some() {
        Srgb::WHITE
    } else {
        Srgb::NEUTRAL
    };
    let own = own.unwrap_or(missing).to_linear();
    let vertex = vertex.unwrap_or(Srgb::WHITE).to_linear();
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "within [0, 1]"
    )]
    let [r, g, b] = std::array::from_fn(|i| (own[i] * vertex[i] * 65535.0).round() as u16);
    [r, g, b, 0]
}
