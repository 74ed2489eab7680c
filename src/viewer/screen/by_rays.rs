//! Pictures and masks by rays, where software draws: it transforms vertices on one core, and a ray costs little more in a
//! large scene than in a small one.

use crate::{scene::Scene, viewer::model::Subject};
use std::{
    panic::resume_unwind,
    thread,
    time::{Duration, Instant},
};

/// With more work than this, a moving picture's triangles take longer than its rays.
pub(super) const MUCH: u64 = 20_000;
/// How long the pictures of a frame may take together.
const LONGEST: Duration = Duration::from_millis(80);
/// So many pictures are drawn after one that took rays too long, and twice as many after the next one, up to the most.
const DRAWN_AFTER: [u32; 2] = [2, 64];

/// Decides when rays are quicker.
#[derive(Debug, Default)]
pub(super) struct ByRays {
    /// How many pictures were drawn in place of the last that took rays too long; 0 if the last was in time.
    patience: u32,
    /// Pictures still to be drawn before rays are tried again.
    to_draw: u32,
}

impl ByRays {
    /// What `cast` finds by a deadline, for a picture of a frame that began at `began`; `None` if rays are late, or were.
    pub fn cast<T: Send>(
        &mut self,
        subject: &Subject,
        began: Instant,
        cast: impl FnOnce(&Scene, Instant) -> Option<T> + Send,
    ) -> Option<T> {
        if !subject.scene.trees_are_built() {
            return None;
        }
        if self.to_draw > 0 {
            self.to_draw -= 1;
            return None;
        }
        let deadline = began + LONGEST;
        // On other threads alone: the window's own, whose processor time is bounded, waits as for an adapter.
        let cast = thread::scope(|scope| scope.spawn(|| cast(subject.scene, deadline)).join());
        let found = cast.unwrap_or_else(|panic| resume_unwind(panic));
        self.came(found.is_some());
        found
    }

    /// Learns whether rays were in time.
    fn came(&mut self, in_time: bool) {
        let [first, most] = DRAWN_AFTER;
        self.patience = if in_time {
            0
        } else {
            (2 * self.patience).clamp(first, most)
        };
        self.to_draw = self.patience;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rays_that_are_late_are_tried_again_ever_more_seldom() {
        let mut rays = ByRays::default();
        let drawn = [false, false, false, true, false].map(|in_time| {
            rays.came(in_time);
            rays.to_draw
        });
        assert_eq!(drawn, [2, 4, 8, 0, 2]);
        for _ in 0..10 {
            rays.came(false);
        }
        assert_eq!(rays.to_draw, 64);
    }
}
