//! Finds the triangles of a mesh that share an edge with another one.

use crate::geometry::{CornersByVertex, MeshData, corners_by_vertex};
use std::collections::HashMap;

/// A mesh's triangles by corner position. Corners at equal positions count as one, however often the mesh lists them:
/// the vertex shader maps them alike.
pub(super) struct Adjoining {
    /// For each vertex, the first one at the same position.
    places: Vec<u32>,
    /// By the positions that `places` names.
    corners: CornersByVertex,
}

impl Adjoining {
    /// Indexes all triangles of a mesh.
    pub fn new(mesh: &MeshData) -> Self {
        let mut first = HashMap::with_capacity(mesh.positions.len());
        let places = (0..).zip(&mesh.positions).map(|(i, position)| {
            // Adding 0 turns -0 into 0.
            *(first.entry(position.map(|c| (c + 0.0).to_bits()))).or_insert(i)
        });
        let places: Vec<u32> = places.collect();
        let triangles = mesh.triangles.iter();
        let triangles = triangles.map(|corners| corners.map(|i| places[i as usize]));
        let triangles: Vec<[u32; 3]> = triangles.collect();
        let corners = corners_by_vertex(places.len(), &triangles);
        Self { places, corners }
    }

    /// The triangles with an edge between the positions of two vertices, in either direction.
    pub fn across<'a>(
        &'a self,
        mesh: &'a MeshData,
        edge: [u32; 2],
    ) -> impl Iterator<Item = Neighbour> + 'a {
        let place = |i: u32| self.places[i as usize];
        let [from, to] = edge.map(place);
        let about = self.corners.of(from as usize..from as usize + 1).iter();
        about.filter_map(move |corner| {
            let triangle = corner / 3;
            let [i, j, k] = mesh.triangles[triangle as usize];
            let mut sides = [[i, j, k], [j, k, i], [k, i, j]].into_iter();
            sides.find_map(|[start, end, apex]| {
                let ends = [start, end].map(place);
                (ends == [to, from] || ends == [from, to]).then_some(Neighbour {
                    triangle,
                    apex,
                    faces_alike: ends == [to, from],
                })
            })
        })
    }
}

/// A triangle that shares an edge with another.
pub(super) struct Neighbour {
    pub triangle: u32,
    /// Its vertex off the edge.
    pub apex: u32,
    /// Whether it runs along the edge in the opposite direction, as triangles that face the same way do.
    pub faces_alike: bool,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two triangles along an edge, whose vertices are listed twice, once with a negative 0.
    #[test]
    fn vertices_in_one_place_are_one_whatever_the_sign_of_zero() {
        let corners = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [-0.0, -0.0, 0.0],
            [1.0, -0.0, -0.0],
            [0.0, -1.0, 0.0],
        ];
        let mesh = MeshData::of_triangles("", corners.to_vec(), vec![[0, 1, 2], [4, 3, 5]]);
        let adjoining = Adjoining::new(&mesh);
        let across = |edge| -> Vec<_> {
            let all = adjoining.across(&mesh, edge);
            all.map(|other| (other.triangle, other.faces_alike))
                .collect()
        };
        assert_eq!(across([0, 1]), [(0, false), (1, true)]);
        assert_eq!(across([4, 3]), [(0, true), (1, false)]);
        assert_eq!(across([1, 2]), [(0, false)]);
    }
}
