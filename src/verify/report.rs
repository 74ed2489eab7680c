//! What a comparison found.

use super::Class;
use crate::image::Id;

/// A pixel that is drawn as one thing and picked as another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disagreement {
    /// Column and row.
    pub pixel: [u32; 2],
    /// What the GPU drew.
    pub drawn: Id,
    /// What the ray hit.
    pub picked: Id,
    /// Why they differ.
    pub class: Class,
    /// The error that the explanation needs over the error that is allowed: at most 1. Infinite where nothing explains
    /// the pixel.
    pub strain: f64,
    /// Distance in pixels from the centre to the outline that explains it, or comes nearest to doing so; infinite where
    /// depth explains it, or where there is no outline.
    pub outline_px: f64,
    /// How far drawing may move that outline, in pixels.
    pub outline_error_px: f64,
    /// View depth at the centre of what was drawn and what was picked; NaN where there is none.
    pub depth: [f64; 2],
}

/// What a comparison of two pictures found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// Pixels compared.
    pub pixels: usize,
    /// Pixels on which something was drawn.
    pub drawn: usize,
    /// Pixels on which something was picked.
    pub picked: usize,
    /// Pixels on outlines, where differences can be expected: a neighbour above, below, left or right was drawn or
    /// picked as something else.
    pub outline: usize,
    /// Pixels on outlines that differ.
    pub outline_differ: usize,
    /// Every pixel that differs, row by row from the top.
    pub disagreements: Vec<Disagreement>,
}

/// The most pixels that something no wider than a pixel may touch.
const SPECK_PX: usize = 4;

/// The verdict on a comparison. All but the first are failures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Geometry explains every difference.
    Agrees,
    /// This many pixels differ by more than `f32` can draw. The rest is explained.
    BeyondF32(usize),
    /// This many pixels are picked and none is drawn, whatever explains each of them. There are two exceptions: at most
    /// four pixels, all *edge* (something smaller than a pixel may be missed); and pixels that are *section* or *edge*,
    /// at least half of them *section*.
    NothingDrawn(usize),
    /// This many pixels are drawn and none is picked, with the same exceptions.
    NothingPicked(usize),
    /// This many pixels are defects.
    Unexplained(usize),
}

impl Report {
    /// Pixels of one class.
    pub fn count(&self, class: Class) -> usize {
        let of_class = |at: &&Disagreement| at.class == class;
        self.disagreements.iter().filter(of_class).count()
    }

    /// Pixels on which both agree.
    pub fn same(&self) -> usize {
        self.pixels - self.disagreements.len()
    }

    /// The share of outline pixels that differ, in [0, 1]; 0 where there are none.
    pub fn share_of_outline(&self) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "pixels are counted in millions")]
        let share = self.outline_differ as f64 / self.outline.max(1) as f64;
        share
    }

    /// Pixels that differ away from all outlines.
    pub fn differ_off_outlines(&self) -> usize {
        self.disagreements.len() - self.outline_differ
    }

    /// The verdict on all of it.
    pub fn verdict(&self) -> Verdict {
        let [beyond, unexplained] = [Class::BeyondF32, Class::Unexplained].map(|c| self.count(c));
        match (self.drawn, self.picked) {
            _ if unexplained > 0 => Verdict::Unexplained(unexplained),
            (0, 1..) if !self.may_be_empty() => Verdict::NothingDrawn(self.picked),
            (1.., 0) if !self.may_be_empty() => Verdict::NothingPicked(self.drawn),
            _ if beyond > 0 => Verdict::BeyondF32(beyond),
            _ => Verdict::Agrees,
        }
    }

    /// Whether one picture may be empty: the other has only a speck, or only a face in the section's plane, which
    /// drawing may keep or not.
    fn may_be_empty(&self) -> bool {
        let [edge, section] = [Class::Edge, Class::Section].map(|class| self.count(class));
        // At the outline of such a face the class is edge, the more harmless one.
        let all = self.disagreements.len();
        let is_cut = edge <= section && edge + section == all;
        // It is smaller than a pixel, with the pixel centres on its edge.
        let is_a_speck = all <= SPECK_PX && edge == all;
        is_a_speck || is_cut
    }

    /// The pixel hardest to explain: that of the gravest class with the most strain.
    pub fn worst(&self) -> Option<&Disagreement> {
        let gravity = |a: &&Disagreement, b: &&Disagreement| {
            (a.class.cmp(&b.class)).then(a.strain.total_cmp(&b.strain))
        };
        self.disagreements.iter().max_by(gravity)
    }
}
