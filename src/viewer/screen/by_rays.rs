//! Moving pictures by rays, where software draws: it transforms corners on one core, and a ray costs little more in a
//! large scene than in a small one.

use crate::{
    camera::View,
    image::{Image, Pixel},
    pick::raycast_until,
    render::Piece,
    viewer::model::Subject,
};
use std::{
    panic::resume_unwind,
    thread,
    time::{Duration, Instant},
};

/// With more work than this, triangles take longer than rays.
const MUCH: u64 = 20_000;
/// How long a picture may take.
const LONGEST: Duration = Duration::from_millis(80);

/// Decides when rays are quicker.
#[derive(Debug, Default)]
pub(super) struct ByRays {
    /// Rays took too long since the picture began to move.
    are_late: bool,
}

impl ByRays {
    /// The picture has come to rest.
    pub fn rest(&mut self) {
        self.are_late = false;
    }

    /// A picture by rays of a scene with so much work for a rasteriser; `None` where drawing is quicker.
    pub fn picture(&mut self, subject: &Subject, view: &View, work: Piece) -> Option<Image<Pixel>> {
        if work.work < MUCH || self.are_late || !subject.scene.trees_are_built() {
            return None;
        }
        let deadline = Instant::now() + LONGEST;
        let cast = || raycast_until(subject.scene, view, subject.selection, deadline);
        // On other threads: the window's own waits, as for an adapter.
        let cast = thread::scope(|scope| scope.spawn(cast).join());
        let picture = cast.unwrap_or_else(|panic| resume_unwind(panic));
        self.are_late = picture.is_none();
        picture
    }
}
