//! Shading normals for meshes that bring none.

use glam::{DVec3, Vec3};

/// One normal for each corner of each triangle: what shading interpolates. Picking never reads it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CornerNormals {
    /// Unit normals in object space.
    pub normals: Vec<[f32; 3]>,
    /// For each triangle, the index into `normals` of each of its corners.
    pub corners: Vec<[u32; 3]>,
}

/// The outward unit normal of a counter-clockwise triangle; zero when it has no area.
#[must_use]
pub fn face_normal(corners: [[f32; 3]; 3]) -> Vec3 {
    let [a, b, c] = corners.map(|p| DVec3::from_array(p.map(f64::from)));
    let normal = (b - a).cross(c - a);
    // Scaled first: the square of a very small area would vanish.
    (normal / normal.abs().max_element())
        .normalize_or_zero()
        .as_vec3()
}

/// Normals that are smooth within a surface and break where two faces that share an edge meet at more than
/// `crease` radians. A corner's normal is the mean of the faces around its vertex that are reached without
/// crossing such an edge, each weighted by its angle there (Thuermer & Wuethrich, "Computing Vertex Normals from
/// Polygonal Facets", JGT 3(1), 1998).
///
/// Triangles without area take the mean of their neighbours, or +z when alone.
#[must_use]
pub fn crease_normals(
    positions: &[[f32; 3]],
    triangles: &[[u32; 3]],
    crease: f32,
) -> CornerNormals {
    let faces: Vec<Vec3> = triangles
        .iter()
        .map(|corners| face_normal(corners.map(|i| positions[i as usize])))
        .collect();
    let around = corners_by_vertex(positions.len(), triangles);
    let cos_crease = crease.cos();
    let mut result = CornerNormals {
        normals: Vec::with_capacity(positions.len()),
        corners: vec![[0; 3]; triangles.len()],
    };
    let mut fan = Fan::default();
    for vertex in 0..positions.len() {
        let corners =
            &around.corners[around.starts[vertex] as usize..around.starts[vertex + 1] as usize];
        fan.group(corners, triangles, &faces, cos_crease);
        for (place, &corner) in corners.iter().enumerate() {
            if fan.root(place) != place {
                continue;
            }
            let members = (place..corners.len()).filter(|&other| fan.root(other) == place);
            let mut sum = Vec3::ZERO;
            for member in members.clone() {
                let (face, at) = split(corners[member]);
                sum += faces[face] * angle_at(positions, triangles[face], at);
            }
            let fallback = faces[split(corner).0];
            let normal = sum
                .try_normalize()
                .or(fallback.try_normalize())
                .unwrap_or(Vec3::Z);
            let index = u32::try_from(result.normals.len()).unwrap_or(u32::MAX);
            result.normals.push(normal.to_array());
            for member in members {
                let (face, at) = split(corners[member]);
                result.corners[face][at] = index;
            }
        }
    }
    result
}

/// For each vertex, the corners (3 * triangle + place) that use it, as one array and where each run starts.
struct CornersByVertex {
    starts: Vec<u32>,
    corners: Vec<u32>,
}

fn corners_by_vertex(vertices: usize, triangles: &[[u32; 3]]) -> CornersByVertex {
    let mut starts = vec![0_u32; vertices + 1];
    for &vertex in triangles.as_flattened() {
        starts[vertex as usize + 1] += 1;
    }
    for i in 0..vertices {
        starts[i + 1] += starts[i];
    }
    let mut next = starts.clone();
    let mut corners = vec![0_u32; triangles.len() * 3];
    for (corner, &vertex) in (0..).zip(triangles.as_flattened()) {
        corners[next[vertex as usize] as usize] = corner;
        next[vertex as usize] += 1;
    }
    CornersByVertex { starts, corners }
}

fn split(corner: u32) -> (usize, usize) {
    (corner as usize / 3, corner as usize % 3)
}

fn angle_at(positions: &[[f32; 3]], triangle: [u32; 3], at: usize) -> f32 {
    let p = |i: usize| Vec3::from_array(positions[triangle[i % 3] as usize]);
    let (a, b) = (p(at + 1) - p(at), p(at + 2) - p(at));
    a.normalize_or_zero()
        .dot(b.normalize_or_zero())
        .clamp(-1.0, 1.0)
        .acos()
}

/// Union-find over the corners about one vertex; a group's root is its first member.
#[derive(Default)]
struct Fan {
    parent: Vec<usize>,
    spokes: Vec<(u32, usize)>,
}

impl Fan {
    /// Joins the corners whose faces share an edge at the vertex and bend there by no more than the crease.
    fn group(&mut self, corners: &[u32], triangles: &[[u32; 3]], faces: &[Vec3], cos_crease: f32) {
        self.parent.clear();
        self.parent.extend(0..corners.len());
        self.spokes.clear();
        for (place, &corner) in corners.iter().enumerate() {
            let (face, at) = split(corner);
            for other in [triangles[face][(at + 1) % 3], triangles[face][(at + 2) % 3]] {
                self.spokes.push((other, place));
            }
        }
        self.spokes.sort_unstable();
        for i in 1..self.spokes.len() {
            let ((edge_a, a), (edge_b, b)) = (self.spokes[i - 1], self.spokes[i]);
            let normal = |place: usize| faces[split(corners[place]).0];
            let smooth = normal(a).dot(normal(b)) >= cos_crease
                || normal(a) == Vec3::ZERO
                || normal(b) == Vec3::ZERO;
            if edge_a == edge_b && smooth {
                let (root_a, root_b) = (self.root(a), self.root(b));
                self.parent[root_a.max(root_b)] = root_a.min(root_b);
            }
        }
    }

    fn root(&self, mut place: usize) -> usize {
        while self.parent[place] != place {
            place = self.parent[place];
        }
        place
    }
}
