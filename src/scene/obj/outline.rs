//! What the lines of a file say that `tobj` does not see.

use super::BadLine;

/// What a file says beside its vertices and faces. Faces are numbered from 0, as `tobj` sees them.
#[derive(Default)]
pub(super) struct Outline {
    /// How many vertices there are.
    pub vertices: usize,
    /// For each face, whether every corner names a normal.
    pub with_normals: Vec<bool>,
    /// The largest vertex number that a face names, from 1.
    pub highest_vertex: usize,
    /// The objects, by the face that each begins with.
    pub objects: Vec<(usize, Name)>,
    /// The `usemtl` lines: the face that comes next, and an index into `material_names`.
    pub materials: Vec<(usize, usize)>,
    /// The materials that `usemtl` names, each once, and the line where it first does.
    pub material_names: Vec<(String, usize)>,
    /// What `mtllib` lines say, each once, and the line of the first.
    pub libraries: Vec<(String, usize)>,
    /// Points, lines, and faces of less than three corners.
    pub points_and_lines: usize,
    /// Free-form curves and surfaces.
    pub free_form: usize,
    /// Faces with too many corners.
    pub oversized: usize,
    /// Faces that name a normal that does not exist.
    pub bad_normals: usize,
    /// Lines that break the format, one of each kind.
    pub faults: Vec<Fault>,
}

/// Lines that break the format in one way.
pub(super) struct Fault {
    /// What is wrong with the first.
    pub what: BadLine,
    /// Its number, from 1.
    pub line: usize,
    /// How many there are.
    pub count: usize,
}

impl Outline {
    /// How many faces there are.
    pub fn faces(&self) -> usize {
        self.with_normals.len()
    }

    /// Takes down a line that breaks the format.
    pub fn note(&mut self, line: usize, what: BadLine) {
        let kind = std::mem::discriminant(&what);
        let mut faults = self.faults.iter_mut();
        match faults.find(|fault| std::mem::discriminant(&fault.what) == kind) {
            Some(known) => known.count += 1,
            None => self.faults.push(Fault {
                what,
                line,
                count: 1,
            }),
        }
    }
}

/// What the `o` and `g` lines in force say. Equal names are one object.
#[derive(Clone, Default, PartialEq)]
pub(super) struct Name {
    /// Which `o` line of the file it is under, from 1; 0 before the first.
    pub object_number: usize,
    /// What that says.
    pub object: String,
    /// What the last `g` line since says.
    pub group: String,
}
