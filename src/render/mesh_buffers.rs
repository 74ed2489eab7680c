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
use std::{borrow::Cow, collections::HashMap, f64::consts::PI, ops::Range, sync::Arc};
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
        let (vertices, triangles) = unify(mesh);
        let buffers = Self::new(gpu, vertices, &triangles)?;
        gpu.note_triangles(triangles.len());
        Ok(buffers)
    }

    fn new(gpu: &Gpu, mut vertices: Vec<Vertex>, triangles: &[[u32; 3]]) -> Result<Self, GpuError> {
        note_spacing(&mut vertices, triangles);
        let vertices = &*vertices;
        let count = |triangles: usize| u32::try_from(triangles).unwrap_or(u32::MAX);
        let most = gpu.device.limits().max_buffer_size;
        let largest = size_of_val(vertices).max(size_of_val(triangles)) as u64;
        let is_indexed = gpu.numbers == Numbers::Primitives && largest <= most;
        let held = most / (3 * size_of::<Vertex>()) as u64;
        let held = usize::try_from(held).unwrap_or(usize::MAX).max(1);
        let called = if gpu.is_software() {
            SOFTWARE_CALL
        } else {
            usize::MAX
        };
        let buffer = |vertices: &[Vertex]| gpu.buffer("vertices", BufferUsages::VERTEX, vertices);
        // All of them share their buffers, or each has its own.
        let shared = if is_indexed {
            let indices = gpu.buffer("triangles", BufferUsages::INDEX, triangles)?;
            Some((buffer(vertices)?, indices))
        } else {
            None
        };
        let size = if is_indexed { called } else { called.min(held) };
        let chunk = |(at, some): (usize, &[[u32; 3]])| {
            let triangles = count(at * size)..count(at * size + some.len());
            Ok(match &shared {
                Some((vertices, indices)) => Chunk {
                    triangles,
                    first: 0,
                    vertices: vertices.clone(),
                    indices: Some(indices.clone()),
                },
                None => Chunk {
                    first: triangles.start,
                    triangles,
                    vertices: {
                        let corners = some.as_flattened().iter();
                        buffer(&corners.map(|&i| vertices[i as usize]).collect::<Vec<_>>())?
                    },
                    indices: None,
                },
            })
        };
        let chunks: Result<_, GpuError> = triangles.chunks(size).enumerate().map(chunk).collect();
        Ok(Self {
            triangles: count(triangles.len()),
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
        Self::new(gpu, vertices.collect(), &triangles.collect::<Vec<_>>())
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
        Self::new(gpu, vertices, &triangles)
    }
}

/// Notes with each vertex how far apart the edges about it are: the height of its widest triangle over that triangle's
/// longest side. Of positive numbers, the larger has the larger bits.
fn note_spacing(vertices: &mut [Vertex], triangles: &[[u32; 3]]) {
    for triangle in triangles {
        let [a, b, c] = triangle.map(|i| Vec3::from(vertices[i as usize].position).as_dvec3());
        let [ab, bc, ca] = [b - a, c - b, a - c];
        let longest = (ab.length_squared())
            .max(bc.length_squared())
            .max(ca.length_squared());
        let height = (ab.cross(ca).length_squared() / longest).sqrt();
        #[expect(clippy::cast_possible_truncation, reason = "opacities need no more")]
        let upper_half = ((height.max(0.0) as f32).to_bits() >> 16) as u16;
        for i in triangle {
            let noted = &mut vertices[*i as usize].colour[3];
            *noted = (*noted).max(upper_half);
        }
    }
}

/// Vertices, and triangles as indices into them.
type Indexed<'a> = (Vec<Vertex>, Cow<'a, [[u32; 3]]>);

/// One vertex for each distinct (position, normal, part, colour) that a corner has, and the corners as indices into
/// them.
fn unify(mesh: &Mesh) -> Indexed<'_> {
    const NONE: u32 = u32::MAX;
    let (data, shading) = (mesh.data(), mesh.normals());
    // In a smooth surface of one part and colour, such as a scan, each position is one vertex already.
    if let ([_], [run, others @ ..]) = (&*data.parts, &*data.colours)
        && others.iter().all(|other| other.colour == run.colour)
        && data.vertex_colours.is_empty()
        && shading.is_by_vertex()
    {
        let colour = colour((run.colour, None));
        let each = data.positions.iter().zip(&shading.normals);
        let vertices = each.map(|(&position, &normal)| Vertex {
            position,
            normal,
            part: 0,
            colour,
        });
        return (vertices.collect(), Cow::Borrowed(&data.triangles));
    }
    let shading_corners = shading.corners_of(&data.triangles);
    let mut linear = HashMap::new();
    // Most corners have the colour of the one before.
    let mut latest_colour = (None, [0; 4]);
    let mut vertices: Vec<Vertex> = Vec::with_capacity(data.positions.len());
    // The vertices at each position as a linked list: the latest, and for each vertex the one before.
    let mut latest = vec![NONE; data.positions.len()];
    let mut before: Vec<u32> = Vec::with_capacity(data.positions.len());
    let mut triangles = Vec::with_capacity(data.triangles.len());
    let (mut part, mut run) = (0, 0);
    for (index, corners) in (0..).zip(&data.triangles) {
        while data.parts[part].triangles.end <= index {
            part += 1;
        }
        while data.colours[run].triangles.end <= index {
            run += 1;
        }
        let own = data.colours[run].colour;
        let normals: [[f32; 3]; 3] = match shading_corners.get(index as usize) {
            Some(normals) => normals.map(|i| shading.normals[i as usize]),
            None => [face_normal(corners.map(|i| data.positions[i as usize])).to_array(); 3],
        };
        triangles.push(std::array::from_fn(|place| {
            let position = corners[place] as usize;
            let key = (own, data.vertex_colours.get(position).copied());
            if latest_colour.0 != Some(key) {
                let found = *linear.entry(key).or_insert_with(|| colour(key));
                latest_colour = (Some(key), found);
            }
            let vertex = Vertex {
                position: data.positions[position],
                normal: normals[place],
                part: u32::try_from(part).unwrap_or(u32::MAX),
                colour: latest_colour.1,
            };
            let mut found = latest[position];
            while found != NONE && vertices[found as usize] != vertex {
                found = before[found as usize];
            }
            if found == NONE {
                found = u32::try_from(vertices.len()).unwrap_or(NONE);
                vertices.push(vertex);
                before.push(latest[position]);
                latest[position] = found;
            }
            found
        }));
    }
    (vertices, Cow::Owned(triangles))
}

/// A triangle's colour times a vertex's, as in [`Mesh::albedo`]: linear, in 65535ths, which are finer than the steps of
/// 8-bit sRGB everywhere.
fn colour((own, vertex): (Option<Srgb>, Option<Srgb>)) -> [u16; 4] {
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
