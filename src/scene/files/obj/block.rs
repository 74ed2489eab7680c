//! What `tobj` makes of a piece of a file.

use super::{
    outline::Outline,
    pieces::{Counts, Piece},
    wash::wash,
};
use std::path::Path;

/// Vertices and faces of a piece. Indices are those of the file, from 0.
pub(super) struct Block {
    pub vertices: Vertices,
    pub faces: Faces,
    /// What stands before it in the file, and before what comes next.
    pub counts: [Counts; 2],
}

/// The numbers of a piece.
pub(super) struct Vertices {
    pub positions: Vec<[f64; 3]>,
    /// Of every vertex, or none at all.
    pub colours: Vec<[f64; 3]>,
    pub normals: Vec<[f64; 3]>,
}

/// The faces of a piece.
pub(super) struct Faces {
    /// The vertices of their corners.
    pub corners: Vec<u32>,
    /// The normals of their corners; none at all where no face has any.
    pub normals: Vec<u32>,
    /// How many corners each has; none at all where all have three.
    pub arities: Vec<u32>,
    /// Whether every corner names a normal. Else what `normals` says there means nothing.
    pub with_normals: Vec<bool>,
}

impl Faces {
    /// How many there are.
    pub fn count(&self) -> usize {
        self.with_normals.len()
    }
}

impl Block {
    /// Lets `tobj` read a piece. `known` is how many vertices the file has, where that is known: faces that name others are
    /// left out.
    pub fn read(piece: Piece, known: Option<usize>) -> Result<(Self, Outline), tobj::LoadError> {
        let washed = wash(&piece, known);
        let counts = [piece.before, piece.after];
        drop(piece);
        let options = tobj::LoadOptions::default();
        let (models, _) = tobj::load_obj_buf(&mut &*washed.text, &options, no_materials)?;
        let mesh = models.into_iter().next().map(|model| model.mesh);
        let mesh = mesh.unwrap_or_default();
        let own = |values: &[f64], places: std::ops::Range<usize>| {
            let (all, _) = values.as_chunks::<3>();
            all.get(places.start - 1..places.end - 1)
                .unwrap_or_default()
                .to_vec()
        };
        let [vertices, normals] = [&washed.vertices, &washed.normals];
        let past_naming = |indices: Vec<u32>| indices.into_iter().skip(washed.naming_corners);
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
                corners: past_naming(mesh.indices)
                    .map(|i| vertices.index(i))
                    .collect(),
                normals: past_naming(corner_normals)
                    .map(|i| normals.index(i))
                    .collect(),
                arities,
                with_normals: washed.with_normals,
            },
            counts,
        };
        Ok((block, washed.outline))
    }
}

/// `tobj` never sees an `mtllib` line.
fn no_materials(_: &Path) -> tobj::MTLLoadResult {
    Err(tobj::LoadError::GenericFailure)
}
