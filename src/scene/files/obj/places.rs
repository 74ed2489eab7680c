//! Where in the text that `tobj` gets, and in what it makes of that, the vertices or normals of a file are.

use std::ops::Range;

/// Those of which it is remembered that they have a stand-in. The others get another.
const REMEMBERED: usize = 1 << 14;

/// The places of vertices, or of normals, in the text made of a piece: first one that nobody names, where there is one;
/// then those of the piece; then stand-ins for others that its faces name. Places and numbers count from 1.
pub(super) struct Places {
    /// How many places there are before those of the piece.
    unnamed: usize,
    /// The numbers of those of the piece.
    own: Range<usize>,
    /// What stands in for which number.
    elsewhere: Vec<usize>,
    /// Of some of those their number and place, by the last bits of the number.
    recent: Vec<(usize, usize)>,
}

impl Places {
    /// For a piece with as many as there are between two counts of those before a line.
    pub fn new(unnamed: usize, before: usize, after: usize) -> Self {
        Self {
            unnamed,
            own: before + 1..after + 1,
            elsewhere: Vec::new(),
            recent: Vec::new(),
        }
    }

    /// How many the piece has.
    pub fn own(&self) -> usize {
        self.own.len()
    }

    /// The places of those that the piece has.
    pub fn of_own(&self) -> Range<usize> {
        self.unnamed + 1..self.unnamed + 1 + self.own()
    }

    /// How many stand-ins there are.
    pub fn stand_ins(&self) -> usize {
        self.elsewhere.len()
    }

    /// The place of the one that has a number in the file.
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

    /// The index in the file, from 0, of the one that has an index in what `tobj` made of the text. `tobj` keeps the
    /// order of first use, which is that of the places.
    pub fn index(&self, made: u32) -> u32 {
        let at = (made as usize).saturating_sub(self.unnamed);
        let index = match at.checked_sub(self.own.len()) {
            None => self.own.start - 1 + at,
            Some(stand_in) => self.elsewhere[stand_in] - 1,
        };
        // More than that are never in a mesh; faces that name them are left out.
        u32::try_from(index).unwrap_or(u32::MAX)
    }
}
