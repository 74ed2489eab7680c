//! Cuts a list of draws into slices of limited work.

use super::view_rows::Draw;
use std::ops::Range;

/// The work of an instance besides its triangles, in triangles.
const INSTANCE: u64 = 32;

/// How much is drawn at once.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Piece {
    /// Work, in triangles; an instance counts as 32 more.
    pub work: u64,
    /// The most instances.
    pub instances: u32,
}

impl Piece {
    /// All there is.
    pub const WHOLE: Self = Self {
        work: u64::MAX,
        instances: u32::MAX,
    };

    /// So much work, of any number of instances.
    pub const fn of_work(work: u64) -> Self {
        Self {
            work,
            ..Self::WHOLE
        }
    }

    /// Whether `whole` fits into one piece.
    pub fn holds(&self, whole: &Self) -> bool {
        whole.work <= self.work && whole.instances <= self.instances
    }
}

/// Triangles of instances of one draw. Spheres have no triangles.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Slice {
    /// The draw's index.
    pub draw: usize,
    pub triangles: Range<u32>,
    pub instances: Range<u32>,
}

impl Slice {
    /// Its work.
    pub fn work(&self) -> u64 {
        let instances = self.instances.end - self.instances.start;
        work(&self.triangles) * u64::from(instances)
    }
}

/// A position in a list of draws.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Cursor {
    /// The draw that comes next.
    pub draw: usize,
    /// Among the draw's instances.
    instance: u32,
    /// Among the instance's triangles.
    triangle: u32,
}

impl Cursor {
    /// Whether nothing is left.
    pub fn is_at_end(&self, draws: &[Draw]) -> bool {
        self.draw == draws.len()
    }

    /// The next slices, in order, that fit into what is left of a piece. If `is_first`, the piece is empty so far: then
    /// at least one triangle is taken, even if it does not fit.
    pub fn take(&mut self, draws: &[Draw], left: &mut Piece, is_first: bool) -> Vec<Slice> {
        let mut slices = Vec::new();
        while let Some(draw) = draws.get(self.draw)
            && let Some(slice) = self.slice(draw, left, is_first && slices.is_empty())
        {
            slices.push(slice);
        }
        slices
    }

    /// The next slice of a draw; `None` if too little of the piece is left, unless it is the first. A piece has at most
    /// one partial slice of a row, since the row stores the triangle that it begins with.
    fn slice(&mut self, draw: &Draw, left: &mut Piece, is_first: bool) -> Option<Slice> {
        let (index, all) = (self.draw, &draw.kind.triangles);
        let first = draw.instances.start + self.instance;
        let each = work(all);
        let fit = u32::try_from(left.work / each).unwrap_or(u32::MAX);
        let fit = fit.min(left.instances).min(draw.instances.end - first);
        let begin = all.start + self.triangle;
        let end = draw.kind.end_of_call(begin);
        let (triangles, count) = if self.triangle == 0 && fit > 0 && end == all.end {
            (all.clone(), fit)
        } else if is_first || (self.triangle == 0 && fit > 0) {
            let most = left.work.saturating_sub(INSTANCE).max(1);
            let most = u32::try_from(most).unwrap_or(u32::MAX);
            (begin..begin.saturating_add(most).min(end), 1)
        } else {
            return None;
        };
        left.instances = left.instances.saturating_sub(count);
        if triangles.end == all.end {
            self.triangle = 0;
            self.instance += count;
            if draw.instances.start + self.instance == draw.instances.end {
                (self.draw, self.instance) = (self.draw + 1, 0);
            }
        } else {
            self.triangle = triangles.end - all.start;
        }
        let slice = Slice {
            draw: index,
            triangles,
            instances: first..first + count,
        };
        left.work = left.work.saturating_sub(slice.work());
        Some(slice)
    }
}

/// The work of an instance of these triangles.
pub(super) fn work(triangles: &Range<u32>) -> u64 {
    INSTANCE + u64::from(triangles.end - triangles.start)
}
