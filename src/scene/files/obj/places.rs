//! Converts between the numbers of vertices or normals in a file and their places in the small file that `tobj` gets
//! for one piece.

use std::ops::Range;

/// How many stand-ins are remembered. A vertex or normal whose stand-in was forgotten gets another one.
const REMEMBERED: usize = 1 << 14;

/// The places of vertices, or of normals, in the text that is made from a piece. First comes one that no face of the
/// file names (for vertices only), then the piece's own, then stand-ins for those of other pieces that its faces name.
/// Places and numbers count from 1.
pub(super) struct Places {
    /// How many places come before the piece's own.
    unnamed: usize,
    /// The numbers, in the file, of the piece's own.
    own: Range<usize>,
    /// For each stand-in, the number in the file that it stands for.
    elsewhere: Vec<usize>,
    /// The number and the place of recent stand-ins, indexed by the last bits of the number.
    recent: Vec<(usize, usize)>,
}

impl Places {
    /// The places for a piece. `before` and `after` count the vertices (or normals) before the piece and before the
    /// next one.
    pub fn new(unnamed: usize, before: usize, after: usize) -> Self {
        Self {
            unnamed,
            own: before + 1..after + 1,
            elsewhere: Vec::new(),
            recent: Vec::new(),
        }
    }

    /// How many vertices (or normals) the piece has.
    pub fn own(&self) -> usize {
        self.own.len()
    }

    /// The places of the piece's own.
    pub fn of_own(&self) -> Range<usize> {
        self.unnamed + 1..self.unnamed + 1 + self.own()
    }

    /// How many stand-ins there are.
    pub fn stand_ins(&self) -> usize {
        self.elsewhere.len()
    }

    /// The place of the vertex (or normal) with this number in the file. Adds a stand-in where it is needed.
    pub fn of(&mut self, number: usize) -> usize {
        if self.own.contains(&number) {
            return self.unnamed + 1 + (number - self.own.start);
        }
        if self.recent.is_empty() {
            self.recent = vec![(0, 0); REMEMBERED];
        }
        let (remembered, place) = &mut self.recent[number % REMEMBERED];
        if *remembered != number {
            self.elsewhere.push(number);
            *remembered = number;
            *place = self.unnamed + self.own.len() + self.elsewhere.len();
        }
        *place
    }

    /// Converts an index in the output of `tobj` to an index in the file, from 0. `tobj` sorts by first use, which is
    /// the order of the places.
    pub fn index(&self, made: u32) -> u32 {
        let at = (made as usize).saturating_sub(self.unnamed);
        let index = match at.checked_sub(self.own.len()) {
            None => self.own.start - 1 + at,
            Some(stand_in) => self.elsewhere[stand_in] - 1,
        };
        // A mesh never has a larger index: faces that name one are left out.
        u32::try_from(index).unwrap_or(u32::MAX)
    }
}
