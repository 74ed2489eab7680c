//! Converts between the numbers of vertices or normals in a file and their places in the small file that `tobj` gets
//! for one piece.

use std::ops::Range;

/// The most stand-ins. Numbers with the same remainder by this share one, which stands for another of them from some
/// corner on.
const MOST: usize = 1 << 9;

/// The places of vertices, or of normals, in the text that is made from a piece. First comes one that no face of the
/// file names (for vertices only), then the piece's own, then stand-ins for those of other pieces that its faces name.
/// Places and numbers count from 1.
///
/// A few stand-ins are enough, because a corner is found again by its position among the corners: it is known from
/// which corner on a stand-in stands for which number.
pub(super) struct Places {
    /// How many places come before the piece's own.
    unnamed: usize,
    /// The numbers, in the file, of the piece's own.
    own: Range<usize>,
    /// For each remainder of a number by [`MOST`], its stand-in from 0, and the number that it stands for now. Empty
    /// until there is one.
    by_remainder: Vec<Option<(usize, usize)>>,
    stand_ins: usize,
    /// Each corner from which on its stand-in stands for another number, and that number.
    changes: Vec<(usize, usize)>,
}

impl Places {
    /// The places for a piece. `before` and `after` count the vertices (or normals) before the piece and before the
    /// next one.
    pub fn new(unnamed: usize, before: usize, after: usize) -> Self {
        Self {
            unnamed,
            own: before + 1..after + 1,
            by_remainder: Vec::new(),
            stand_ins: 0,
            changes: Vec::new(),
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
        self.stand_ins
    }

    /// The place that a corner names for the vertex (or normal) with this number in the file. Corners are counted over
    /// all faces of the piece, from 0, and are asked for in order.
    pub fn of(&mut self, number: usize, corner: usize) -> usize {
        if self.own.contains(&number) {
            return self.unnamed + 1 + (number - self.own.start);
        }
        if self.by_remainder.is_empty() {
            self.by_remainder = vec![None; MOST];
        }
        let remembered = &mut self.by_remainder[number % MOST];
        let (stand_in, stands_for) = remembered.get_or_insert_with(|| {
            self.stand_ins += 1;
            (self.stand_ins - 1, 0)
        });
        if *stands_for != number {
            *stands_for = number;
            self.changes.push((corner, number));
        }
        self.unnamed + self.own.len() + 1 + *stand_in
    }

    /// Converts the indices that `tobj` gives for all corners to indices in the file, from 0. `tobj` sorts by first
    /// use, which is the order of the places.
    pub fn indices(&self, made: impl Iterator<Item = u32>) -> Vec<u32> {
        // A mesh never has a larger index: faces that name one are left out.
        let index = |number: usize| u32::try_from(number - 1).unwrap_or(u32::MAX);
        let first = self.own.start - 1;
        let mut changes = self.changes.iter().peekable();
        let mut stand_for = vec![0; self.stand_ins];
        let indices = made.enumerate().map(|(corner, made)| {
            let at = (made as usize).saturating_sub(self.unnamed);
            let Some(stand_in) = at.checked_sub(self.own.len()) else {
                return index(first + at + 1);
            };
            let stands_for = &mut stand_for[stand_in];
            if let Some((_, number)) = changes.next_if(|(from, _)| *from == corner) {
                *stands_for = index(*number);
            }
            *stands_for
        });
        indices.collect()
    }
}
