//! Finds pictures by rays, for software adapters. These transform vertices on one core, while a ray costs little more in
//! a large scene than in a small one.

use crate::{
    camera::View,
    image::{Image, Pixel},
    pick::raycast_until,
    scene::Scene,
};
use std::{
    panic::resume_unwind,
    thread,
    time::{Duration, Instant},
};

/// With more work than this, a moving picture's triangles take longer than its rays.
pub(super) const MUCH: u64 = 20_000;
/// How long the rays of a frame's pictures may take together.
const LONGEST: Duration = Duration::from_millis(80);
/// After late rays, the first number of pictures is drawn before rays are tried again; then twice as many each time
/// that rays are late again, up to the second number.
const DRAWN_AFTER: [u32; 2] = [2, 64];

/// Whether rays can be cast in a frame that began at `began`: the scene has its trees, and half of the time is left.
pub(super) fn can_cast(scene: &Scene, began: Instant) -> bool {
    scene.trees_are_built() && began.elapsed() < LONGEST / 2
}

/// The pixels of a frame that began at `began`; `None` where rays are late.
pub(super) fn cast(scene: &Scene, view: &View, began: Instant) -> Option<Image<Pixel>> {
    let cast = || raycast_until(scene, view, began + LONGEST);
    // Rays run on other threads only. The window's thread, whose processor time is bounded, waits as for an adapter.
    let pixels = thread::scope(|scope| scope.spawn(cast).join());
    pixels.unwrap_or_else(|panic| resume_unwind(panic))
}

/// Decides when a moving picture's rays are tried.
#[derive(Debug, Default)]
pub(super) struct Patience {
    /// How many pictures are drawn before rays are tried again, unless the picture rests meanwhile; 0 if the last rays
    /// were in time.
    wait: u32,
    /// Pictures still to be drawn before rays are tried again.
    to_draw: u32,
}

impl Patience {
    /// Whether the next picture's rays are tried.
    pub fn tries(&mut self) -> bool {
        let tries = self.to_draw == 0;
        self.to_draw = self.to_draw.saturating_sub(1);
        tries
    }

    /// The picture rests: the next moving picture tries rays.
    pub fn rest(&mut self) {
        self.to_draw = 0;
    }

    /// Learns whether rays were in time.
    pub fn came(&mut self, in_time: bool) {
        let [first, most] = DRAWN_AFTER;
        self.wait = if in_time {
            0
        } else {
            (2 * self.wait).clamp(first, most)
        };
        self.to_draw = self.wait;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rays_that_are_late_are_tried_again_ever_more_seldom() {
        let mut rays = Patience::default();
        let drawn = [false, false, false, true, false].map(|in_time| {
            rays.came(in_time);
            rays.to_draw
        });
        assert_eq!(drawn, [2, 4, 8, 0, 2]);
        for _ in 0..10 {
            rays.came(false);
        }
        assert_eq!(rays.to_draw, 64);
        assert_eq!((0..65).filter(|_| rays.tries()).count(), 1);
        rays.came(false);
        rays.rest();
        assert!(rays.tries(), "a drag after a rest");
        rays.came(false);
        assert_eq!(rays.to_draw, 64, "still as late as before");
    }
}
