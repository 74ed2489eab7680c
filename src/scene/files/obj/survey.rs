//! Collects what a file, or a piece of it, holds besides vertices and faces: names, materials, counts and bad lines.

use super::{BadLine, names::Said};

/// What the lines say besides vertices and faces. Faces are numbered from 0 and counted without those that are left
/// out.
#[derive(Default)]
pub(super) struct Survey {
    /// The number of faces.
    pub faces: usize,
    /// The lines that name objects, groups, materials and libraries, each with the number of the face that comes next.
    pub said: Vec<(usize, Said)>,
    /// The number of points, lines, and faces with fewer than three corners.
    pub points_and_lines: usize,
    /// The number of free-form curves and surfaces.
    pub free_form: usize,
    /// The number of faces with too many corners.
    pub oversized: usize,
    /// The number of faces that name a normal that does not exist.
    pub bad_normals: usize,
    /// The lines that break the format, one entry for each kind of fault.
    pub faults: Vec<Fault>,
}

/// The lines with one kind of fault.
pub(super) struct Fault {
    /// What is wrong with the first such line.
    pub what: BadLine,
    /// The number of the first such line, from 1.
    pub line: usize,
    /// How many such lines there are.
    pub count: usize,
}

impl Survey {
    /// Records a line that breaks the format.
    pub fn note(&mut self, line: usize, what: BadLine) {
        let count = 1;
        self.add(Fault { what, line, count });
    }

    fn add(&mut self, fault: Fault) {
        let kind = std::mem::discriminant(&fault.what);
        let mut faults = self.faults.iter_mut();
        match faults.find(|known| std::mem::discriminant(&known.what) == kind) {
            Some(known) => {
                let count = known.count + fault.count;
                if fault.line < known.line {
                    *known = fault;
                }
                known.count = count;
            }
            None => self.faults.push(fault),
        }
    }

    /// Completes the messages that say how many vertices there are.
    pub fn know_vertices(&mut self, count: usize) {
        for fault in &mut self.faults {
            if let BadLine::NoSuchVertex { vertices, .. } = &mut fault.what {
                *vertices = count;
            }
        }
    }

    /// Appends the survey of a piece that so many lines come before.
    pub fn append(&mut self, next: Self, lines: usize) {
        let before = self.faces;
        let said = next.said.into_iter();
        self.said
            .extend(said.map(|(face, said)| (before + face, said.after(lines))));
        self.faces += next.faces;
        self.points_and_lines += next.points_and_lines;
        self.free_form += next.free_form;
        self.oversized += next.oversized;
        self.bad_normals += next.bad_normals;
        for mut fault in next.faults {
            fault.line += lines;
            self.add(fault);
        }
    }
}
