//! What pictures are drawn with.

use super::finish::Finish;
use crate::render::{Gpu, Renderer};
use std::time::Instant;

/// What every picture is drawn with.
pub(super) struct Brush<'a> {
    pub gpu: &'a Gpu,
    pub renderer: &'a mut Renderer,
    /// Pixels of the window for one of its points.
    pub scale_factor: f32,
    /// When the frame began: all rays of its pictures share one deadline.
    pub began: Instant,
}

impl Brush<'_> {
    /// Sets the scale for a finish, so that marks are equally wide on the window with any finish.
    pub fn scale_for(&mut self, finish: Finish) {
        #[expect(clippy::cast_precision_loss, reason = "a few pixels")]
        let coarseness = finish.coarseness() as f32;
        self.renderer.scale_factor = self.scale_factor / coarseness;
    }
}
