//! Counts what a file has.

/// How much a piece has, or all pieces before one have.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Counts {
    /// Bytes of text; a byte order mark does not count.
    pub bytes: usize,
    pub lines: usize,
    pub vertices: usize,
    pub normals: usize,
    /// `f` lines, valid or not.
    pub faces: usize,
}

impl Counts {
    /// Both together.
    pub fn and(self, next: Self) -> Self {
        Self {
            bytes: self.bytes + next.bytes,
            lines: self.lines + next.lines,
            vertices: self.vertices + next.vertices,
            normals: self.normals + next.normals,
            faces: self.faces + next.faces,
        }
    }
}
