//! What the lines of a file, or of a piece of it, say that `tobj` does not see.

use super::{BadLine, names::Said};

/// What lines say beside vertices and faces. Faces are numbered from 0, as `tobj` sees them.
#[derive(Default)]
pub(super) struct Outline {
    /// How many vertices there are.
    pub vertices: usize,
    /// How many faces there are.
    pub faces: usize,
    /// The largest vertex number that a face names, from 1.
    pub highest_vertex: usize,
    /// What is said of the faces that follow, by the face that comes next.
    pub said: Vec<(usize, Said)>,
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
    /// Takes down a line that breaks the format.
    pub fn note(&mut self, line: usize, what: BadLine) {
        let count = 1;
        self.add(Fault { what, line, count });
    }

    fn add(&mut self, fault: Fault) {
        let kind = std::mem::discriminant(&fault.what);
        let mut faults = self.faults.iter_mut();
        match faults.find(|known| std::mem::discriminant(&known.what) == kind) {
            Some(known) => known.count += fault.count,
            None => self.faults.push(fault),
        }
    }

    /// Adds what the lines say that come next.
    pub fn append(&mut self, next: Self) {
        let before = self.faces;
        let said = next.said.into_iter();
        self.said
            .extend(said.map(|(face, said)| (before + face, said)));
        self.vertices += next.vertices;
        self.faces += next.faces;
        self.highest_vertex = self.highest_vertex.max(next.highest_vertex);
        self.points_and_lines += next.points_and_lines;
        self.free_form += next.free_form;
        self.oversized += next.oversized;
        self.bad_normals += next.bad_normals;
        next.faults.into_iter().for_each(|fault| self.add(fault));
    }
}
