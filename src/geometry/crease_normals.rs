//! Computes shading normals for meshes that have none.

use super::{SmoothingRun, shares::in_pieces};
use glam::{DVec3, Vec3};
use std::{iter::repeat_n, ops::Range};

/// One normal for each corner of each triangle: what shading interpolates. Picking never reads it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CornerNormals {
    /// Unit normals in object space.
    pub normals: Vec<[f32; 3]>,
    /// For each triangle, the index into `normals` of each of its corners. Empty where each vertex has one normal, at
    /// its own index, and where there are no normals.
    pub corners: Vec<[u32; 3]>,
}

impl CornerNormals {
    /// Stands for the indices of a triangle that has no normals.
    pub const NONE: [u32; 3] = [u32::MAX; 3];

    /// The indices into `normals` of the corners of these triangles, the mesh's own; empty where there are no normals.
    pub fn corners_of<'a>(&'a self, triangles: &'a [[u32; 3]]) -> &'a [[u32; 3]] {
        if self.is_by_vertex() {
            triangles
        } else {
            &self.corners
        }
    }

    /// Whether each vertex has one normal, at its own index.
    pub(crate) fn is_by_vertex(&self) -> bool {
        self.corners.is_empty() && !self.normals.is_empty()
    }

    /// These normals for the triangles that have any, those of `all` for the rest.
    pub(super) fn completed_by(&self, mut all: Self, triangles: &[[u32; 3]]) -> Self {
        if self.corners.is_empty() {
            return all;
        }
        if all.corners.is_empty() {
            all.corners = triangles.to_vec();
        }
        let offset = u32::try_from(all.normals.len()).unwrap_or(u32::MAX);
        for (corners, given) in all.corners.iter_mut().zip(&self.corners) {
            if *given != Self::NONE {
                *corners = given.map(|i| offset + i);
            }
        }
        all.normals.extend(&self.normals);
        all
    }
}

/// The outward unit normal of a counter-clockwise triangle; zero when it has no area.
pub fn face_normal(corners: [[f32; 3]; 3]) -> Vec3 {
    let [a, b, c] = corners.map(|p| DVec3::from_array(p.map(f64::from)));
    (b - a).cross(c - a).normalize_or_zero().as_vec3()
}

/// The crease angle within a smoothing group, in radians: 85 degrees. Exporters of buildings put walls and roof into
/// one group.
const OF_A_GROUP: f32 = 85.0 * std::f32::consts::PI / 180.0;

/// Normals that are smooth within a surface and break where two faces that share an edge meet at more than `crease`
/// radians. Within a smoothing group edges are smooth up to 85 degrees, and between two all break. A corner's normal is
/// a weighted mean of the faces around its vertex that are reached without crossing such an edge. A face's weight is
/// the sine of its angle there over the product of the lengths of the two sides there. Max found these weights best
/// ("Weights for Computing Vertex Normals from Facet Normals", JGT 4(2), 1999): they are exact on a sphere and need no
/// trigonometry.
///
/// Triangles without area take the mean of their neighbours, or +z when alone. Works on all cores.
///
/// # Panics
/// When a triangle names a position that is not there.
pub fn crease_normals(
    positions: &[[f32; 3]],
    triangles: &[[u32; 3]],
    crease: f32,
    smoothing: &[SmoothingRun],
) -> CornerNormals {
    let face = |corners: &[u32; 3]| face_normal(corners.map(|i| positions[i as usize]));
    let of_faces = in_pieces(triangles.len(), |piece| {
        triangles[piece].iter().map(face).collect::<Vec<_>>()
    });
    let mut faces = Vec::with_capacity(triangles.len());
    // Each piece is freed as soon as it is copied.
    for piece in of_faces {
        faces.extend(piece);
    }
    let groups = smoothing.iter();
    let groups = groups.flat_map(|run| repeat_n(run.group, run.triangles.len()));
    let groups: Vec<u32> = groups.collect();
    let around = corners_by_vertex(positions.len(), triangles);
    let fans = Fans {
        positions,
        triangles,
        faces: &faces,
        around: &around,
        groups: &groups,
        cos_crease: libm::cosf(crease),
    };
    let shares = in_pieces(positions.len(), |vertices| fans.normals(vertices));
    drop(faces);
    let is_by_vertex = shares.iter().all(|share| share.of_corners.is_none());
    let mut result = CornerNormals {
        normals: Vec::with_capacity(positions.len()),
        corners: vec![[0; 3]; if is_by_vertex { 0 } else { triangles.len() }],
    };
    for share in shares {
        let corners = around.of(share.vertices.clone());
        if !is_by_vertex {
            let offset = u32::try_from(result.normals.len()).unwrap_or(u32::MAX);
            let of_vertices = || {
                let vertices = (0..).zip(share.vertices.clone());
                let count = |vertex| around.of(vertex..vertex + 1).len();
                vertices.flat_map(move |(index, vertex)| repeat_n(index, count(vertex)))
            };
            let indices = share.of_corners.unwrap_or_else(|| of_vertices().collect());
            for (index, &corner) in indices.iter().zip(corners) {
                let (face, at) = split(corner);
                result.corners[face][at] = offset + index;
            }
        }
        result.normals.extend(share.normals);
    }
    result
}

/// What normals about vertices are computed from.
struct Fans<'a> {
    positions: &'a [[f32; 3]],
    triangles: &'a [[u32; 3]],
    faces: &'a [Vec3],
    around: &'a CornersByVertex,
    /// The smoothing group of each face; empty where there is none.
    groups: &'a [u32],
    cos_crease: f32,
}

/// The normals about a run of vertices, and which of them each corner there takes.
struct Share {
    vertices: Range<usize>,
    normals: Vec<[f32; 3]>,
    /// `None` if each vertex has one normal.
    of_corners: Option<Vec<u32>>,
}

impl Fans<'_> {
    fn normals(&self, vertices: Range<usize>) -> Share {
        let mut normals = Vec::with_capacity(vertices.len());
        let mut of_corners = Vec::with_capacity(self.around.of(vertices.clone()).len());
        let mut is_by_vertex = true;
        let mut fan = Fan::default();
        for vertex in vertices.clone() {
            let corners = self.around.of(vertex..vertex + 1);
            fan.group(corners, self);
            let first = u32::try_from(normals.len()).unwrap_or(u32::MAX);
            for (place, &corner) in corners.iter().enumerate() {
                let (face, at) = split(corner);
                let group = fan.group_of(place, self.faces[face]);
                fan.groups[group as usize].sum +=
                    self.faces[face].as_dvec3() * self.weight(face, at);
                of_corners.push(first + group);
            }
            is_by_vertex &= fan.groups.len() == 1;
            normals.extend(fan.groups.iter().map(Group::normal));
        }
        Share {
            vertices,
            normals,
            of_corners: (!is_by_vertex).then_some(of_corners),
        }
    }

    /// Whether the edge between two faces is smooth.
    fn is_smooth(&self, a: usize, b: usize) -> bool {
        let [a_normal, b_normal] = [self.faces[a], self.faces[b]];
        if a_normal == Vec3::ZERO || b_normal == Vec3::ZERO {
            return true;
        }
        match (self.groups.get(a), self.groups.get(b)) {
            (Some(a), Some(b)) if a != b => false,
            (Some(1..), _) => a_normal.dot(b_normal) >= libm::cosf(OF_A_GROUP),
            _ => a_normal.dot(b_normal) >= self.cos_crease,
        }
    }

    /// The sine of a corner's angle over the product of its sides' lengths; 0 where a side has no length.
    fn weight(&self, face: usize, at: usize) -> f64 {
        let p = |i: usize| {
            let position = self.positions[self.triangles[face][i % 3] as usize];
            DVec3::from_array(position.map(f64::from))
        };
        let (a, b) = (p(at + 1) - p(at), p(at + 2) - p(at));
        let squares = a.length_squared() * b.length_squared();
        if squares > 0.0 {
            a.cross(b).length() / squares
        } else {
            0.0
        }
    }
}

/// For each vertex, the corners (3 * triangle + place) that use it, as one array and where each run starts.
pub(crate) struct CornersByVertex {
    starts: Vec<u32>,
    corners: Vec<u32>,
}

impl CornersByVertex {
    /// The corners of a run of vertices.
    pub fn of(&self, vertices: Range<usize>) -> &[u32] {
        let [start, end] = [vertices.start, vertices.end].map(|vertex| self.starts[vertex]);
        &self.corners[start as usize..end as usize]
    }
}

/// The corners of all triangles by vertex; those of one vertex are in order.
pub(crate) fn corners_by_vertex(vertices: usize, triangles: &[[u32; 3]]) -> CornersByVertex {
    let mut starts = vec![0_u32; vertices + 1];
    for &vertex in triangles.as_flattened() {
        starts[vertex as usize + 1] += 1;
    }
    for i in 0..vertices {
        starts[i + 1] += starts[i];
    }
    let mut next = starts.clone();
    let mut corners = vec![0_u32; triangles.len() * 3];
    for (&vertex, corner) in triangles.as_flattened().iter().zip(0..) {
        corners[next[vertex as usize] as usize] = corner;
        next[vertex as usize] += 1;
    }
    CornersByVertex { starts, corners }
}

fn split(corner: u32) -> (usize, usize) {
    (corner as usize / 3, corner as usize % 3)
}

/// The corners about one vertex, grouped by union-find; a group's root is its first member.
#[derive(Default)]
struct Fan {
    members: Vec<Member>,
    /// Edges at the vertex, as other end * 2^32 + place.
    spokes: Vec<u64>,
    groups: Vec<Group>,
}

/// A corner in its group.
#[derive(Clone, Copy)]
struct Member {
    /// An earlier member, or itself.
    parent: u32,
    /// The group, at its root.
    group: u32,
}

/// Corners that share a normal.
struct Group {
    /// The weighted sum of the faces' normals.
    sum: DVec3,
    /// The normal of the first face, for where the sum is 0.
    first: Vec3,
}

impl Group {
    fn normal(&self) -> [f32; 3] {
        let normal = self.sum.try_normalize().map(DVec3::as_vec3);
        let normal = normal.or(self.first.try_normalize());
        normal.unwrap_or(Vec3::Z).to_array()
    }
}

impl Fan {
    /// Joins the corners whose faces share a smooth edge at the vertex.
    fn group(&mut self, corners: &[u32], fans: &Fans) {
        self.members.clear();
        self.spokes.clear();
        self.groups.clear();
        for (place, &corner) in (0_u32..).zip(corners) {
            self.members.push(Member {
                parent: place,
                group: 0,
            });
            let (face, at) = split(corner);
            let triangle = fans.triangles[face];
            for other in [triangle[(at + 1) % 3], triangle[(at + 2) % 3]] {
                self.spokes.push(u64::from(other) << 32 | u64::from(place));
            }
        }
        self.spokes.sort_unstable();
        for i in 1..self.spokes.len() {
            let place = |spoke| usize::try_from(spoke & 0xffff_ffff).unwrap_or_default();
            let [(edge_a, a), (edge_b, b)] =
                [self.spokes[i - 1], self.spokes[i]].map(|spoke| (spoke >> 32, place(spoke)));
            if edge_a != edge_b {
                continue;
            }
            let face = |place: usize| split(corners[place]).0;
            if fans.is_smooth(face(a), face(b)) {
                let (root_a, root_b) = (self.root(a), self.root(b));
                let (first, second) = (root_a.min(root_b), root_a.max(root_b));
                self.members[second].parent = self.members[first].parent;
            }
        }
    }

    /// The root of a member's group. Halves the path that it walks, so that a fan of any size takes hardly more than
    /// linear time.
    fn root(&mut self, mut place: usize) -> usize {
        loop {
            let parent = self.members[place].parent;
            let above = self.members[parent as usize].parent;
            if parent == above {
                return parent as usize;
            }
            self.members[place].parent = above;
            place = above as usize;
        }
    }

    /// The number of a corner's group. The first member makes the group, so calls must come in order of `place`.
    fn group_of(&mut self, place: usize, face: Vec3) -> u32 {
        let root = self.root(place);
        if root == place {
            self.members[root].group = u32::try_from(self.groups.len()).unwrap_or(u32::MAX);
            self.groups.push(Group {
                sum: DVec3::ZERO,
                first: face,
            });
        }
        self.members[root].group
    }
}
