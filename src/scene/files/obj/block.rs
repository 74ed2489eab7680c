//! Has `tobj` parse a piece of a file into a [`Block`] of vertices and faces.

use super::{
    pieces::{Counts, Piece},
    survey::Survey,
    wash::{Washed, starts_coloured},
};
use std::path::Path;

/// The vertices and faces of a piece. Indices count from 0, over the whole file.
pub(super) struct Block {
    pub vertices: Vertices,
    pub faces: Faces,
    /// What the file has before this piece, and before the next one.
    pub counts: [Counts; 2],
}

/// The vertices and normals of a piece.
pub(super) struct Vertices {
    pub positions: Vec<[f64; 3]>,
    /// The colour of every vertex; empty if no vertex has one.
    pub colours: Vec<[f64; 3]>,
    pub normals: Vec<[f64; 3]>,
}

/// The faces of a piece.
pub(super) struct Faces {
    /// The vertex index of each corner, face after face.
    pub corners: Vec<u32>,
    /// The normal index of each corner; empty if no face has normals.
    pub normals: Vec<u32>,
    /// The number of corners of each face; empty if all faces are triangles.
    pub arities: Vec<u32>,
    /// For each face, whether every corner names a normal. If not, its entries in `normals` have no meaning.
    pub with_normals: Vec<bool>,
}

impl Faces {
    /// The number of faces.
    pub fn count(&self) -> usize {
        self.with_normals.len()
    }
}

impl Block {
    /// Has `tobj` parse a piece. `known` is the number of vertices in the file, if it is known. Then faces that name a
    /// higher vertex are left out. Normals and colours are left out unless `is_shaded`.
    pub fn read(
        piece: Piece,
        known: Option<usize>,
        is_shaded: bool,
    ) -> Result<(Self, Survey), tobj::LoadError> {
        let options = tobj::LoadOptions::default();
        let parse = |coloured| {
            let mut washed = Washed::new(&piece, known, is_shaded, coloured);
            let parsed = tobj::load_obj_buf(&mut washed, &options, no_materials);
            (parsed, washed)
        };
        let (mut parsed, mut washed) = parse(is_shaded && starts_coloured(&piece));
        if washed.lacks_colours() {
            (parsed, washed) = parse(true);
        }
        let washed = washed.into_washer();
        let counts = [piece.before, piece.after];
        drop(piece);
        let (models, _) = parsed?;
        let mesh = models.into_iter().next().map(|model| model.mesh);
        let mesh = mesh.unwrap_or_default();
        let own = |values: &[f64], places: std::ops::Range<usize>| {
            let (all, _) = values.as_chunks::<3>();
            all.get(places.start - 1..places.end - 1)
                .unwrap_or_default()
                .to_vec()
        };
        let [vertices, normals] = [&washed.vertices, &washed.normals];
        let naming = washed.naming_corners();
        let past_naming = |indices: Vec<u32>| indices.into_iter().skip(naming);
        let mut arities = mesh.face_arities;
        if arities.iter().skip(1).all(|&arity| arity == 3) {
            arities.clear();
        } else {
            arities.remove(0);
        }
        let corner_normals = if washed.with_normals.contains(&true) {
            mesh.normal_indices
        } else {
            Vec::new()
        };
        let block = Self {
            vertices: Vertices {
                positions: own(&mesh.positions, vertices.of_own()),
                colours: own(&mesh.vertex_color, vertices.of_own()),
                normals: own(&mesh.normals, normals.of_own()),
            },
            faces: Faces {
                corners: vertices.indices(past_naming(mesh.indices)),
                normals: normals.indices(past_naming(corner_normals)),
                arities,
                with_normals: washed.with_normals,
            },
            counts,
        };
        Ok((block, washed.survey))
    }
}

/// `tobj` never sees an `mtllib` line.
fn no_materials(_: &Path) -> tobj::MTLLoadResult {
    Err(tobj::LoadError::GenericFailure)
}
