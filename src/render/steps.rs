//! What a pass draws, in order and in limited steps: surfaces, then edges of triangles, then lines.

use super::{
    slices::{Cursor, Piece, Slice},
    view_rows::Draw,
};
use std::ops::Range;

/// The work of a line, in triangles.
pub(super) const LINE: u64 = 2;

/// What there is to draw.
pub(super) struct Parts<'a> {
    pub surfaces: &'a [Draw],
    /// The draws whose edges are drawn.
    pub edged: &'a [Draw],
    /// How many lines.
    pub lines: usize,
}

/// A position in a pass.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Steps {
    surfaces: Cursor,
    edges: Cursor,
    line: usize,
}

/// The next step.
#[derive(Debug, Default)]
pub(super) struct Step {
    pub surfaces: Vec<Slice>,
    pub edges: Vec<Slice>,
    pub lines: Range<usize>,
    /// Whether it is the last.
    pub ends: bool,
}

impl Step {
    /// Its work.
    pub fn work(&self) -> u64 {
        let slices = self.surfaces.iter().chain(&self.edges);
        slices.map(Slice::work).sum::<u64>() + LINE * self.lines.len() as u64
    }
}

impl Steps {
    /// The next step. It fits into the piece, but is not empty if anything is left.
    pub fn take(&mut self, of: &Parts<'_>, mut left: Piece) -> Step {
        let mut step = Step {
            surfaces: self.surfaces.take(of.surfaces, &mut left, true),
            ..Step::default()
        };
        if !self.surfaces.is_at_end(of.surfaces) {
            return step;
        }
        let is_first = step.surfaces.is_empty();
        step.edges = self.edges.take(of.edged, &mut left, is_first);
        if self.edges.is_at_end(of.edged) {
            let is_first = is_first && step.edges.is_empty();
            let most = (left.work / LINE).max(u64::from(is_first));
            let most = usize::try_from(most).unwrap_or(usize::MAX);
            let end = self.line.saturating_add(most).min(of.lines);
            step.lines = self.line..end;
            self.line = end;
            step.ends = end == of.lines;
        }
        step
    }
}
