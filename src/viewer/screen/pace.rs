//! Decides how much of a picture is drawn in a pass: at most a tenth of a second of work, judged by earlier pieces.

use crate::{
    camera::Viewport,
    render::{Gpu, Piece},
};
use std::{
    sync::{Arc, Mutex},
    time::Instant,
};

/// How long the drawing of a pass may take, in seconds. It leaves time for what comes after the drawing.
const LONGEST_S: f64 = 0.08;
/// First guess of the work that fits, for slow adapters of each kind.
const SOFTWARE_WORK: u64 = 120_000;
const HARDWARE_WORK: u64 = 4_000_000;
/// No piece is limited to less than this.
const LEAST_WORK: u64 = 10_000;

/// Pixels of a band that is smoothed at once: a few hundredths of a second in software.
const SMOOTH_PIXELS: u64 = 1 << 17;
/// Smooth drawing of the same work takes this many times as long.
const SMOOTH_COSTS: u64 = 4;

/// Learns from the times of pieces how large they may be.
#[derive(Debug)]
pub(super) struct Pace {
    work: u64,
    /// Whether every pass waits for what it draws. If so, the time of completion is exact; if not, it is that of the
    /// next poll.
    is_waited_for: bool,
    under_way: Option<Piecework>,
}

/// A piece that is being drawn.
#[derive(Debug)]
struct Piecework {
    work: u64,
    begun: Instant,
    /// How long after its start it was last seen unfinished, in seconds.
    longer_than_s: f64,
    /// How long after its start it was reported done, in seconds.
    done_s: Arc<Mutex<Option<f64>>>,
}

impl Pace {
    pub fn new(gpu: &Gpu) -> Self {
        let is_software = gpu.is_software();
        Self {
            work: if is_software {
                SOFTWARE_WORK
            } else {
                HARDWARE_WORK
            },
            is_waited_for: is_software,
            under_way: None,
        }
    }

    /// The limit of a piece.
    pub fn most(&self) -> Piece {
        Piece::of_work(self.work)
    }

    /// The limit of a smooth piece.
    pub fn most_smooth(&self) -> Piece {
        Piece::of_work(self.work / SMOOTH_COSTS)
    }

    /// In how many bands a picture is smoothed. Each band draws the whole scene. If the scene alone takes several
    /// pieces, there is one band.
    pub fn bands(&self, viewport: Viewport, scene: Piece) -> u32 {
        let pixels = u64::from(viewport.width()) * u64::from(viewport.height());
        let by_work = self.most_smooth().work / scene.work.max(1);
        let bands = pixels.div_ceil(SMOOTH_PIXELS).min(by_work).max(1);
        u32::try_from(bands).unwrap_or(u32::MAX)
    }

    /// Whether the adapter has drawn all pieces. If not, more pieces would only queue up and delay what is shown after
    /// them.
    pub fn is_free(&mut self, gpu: &Gpu) -> bool {
        let Some(piece) = &mut self.under_way else {
            return true;
        };
        // The next frame reports errors of the device.
        let _ = gpu.device.poll(wgpu::PollType::Poll);
        let Some(done_s) = piece.done_s.lock().map_or(None, |mut done| done.take()) else {
            piece.longer_than_s = piece.begun.elapsed().as_secs_f64();
            return false;
        };
        let (work, longer_than_s) = (piece.work, piece.longer_than_s);
        self.under_way = None;
        let is_exact = self.is_waited_for;
        let at_least_s = if is_exact { done_s } else { longer_than_s };
        self.learn(work, [at_least_s, done_s]);
        true
    }

    /// Notes that a piece was submitted, unless an earlier one is still being timed.
    pub fn began(&mut self, gpu: &Gpu, work: u64) {
        if self.under_way.is_some() {
            return;
        }
        let (begun, done_s) = (Instant::now(), Arc::new(Mutex::new(None)));
        self.under_way = Some(Piecework {
            work,
            begun,
            longer_than_s: 0.0,
            done_s: Arc::clone(&done_s),
        });
        gpu.queue.on_submitted_work_done(move || {
            if let Ok(mut done) = done_s.lock() {
                *done = Some(begun.elapsed().as_secs_f64());
            }
        });
    }

    /// Lowers the limit after a slow piece; doubles it after a fast one of more than half the limit.
    fn learn(&mut self, work: u64, [at_least_s, at_most_s]: [f64; 2]) {
        if at_least_s > LONGEST_S {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                clippy::cast_precision_loss,
                reason = "an estimate"
            )]
            let fits = (work as f64 * LONGEST_S / at_least_s) as u64;
            self.work = self.work.min(fits.max(LEAST_WORK));
        } else if at_most_s < 0.5 * LONGEST_S && work > self.work / 2 {
            self.work = self.work.saturating_mul(2);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pace(is_waited_for: bool) -> Pace {
        Pace {
            work: 100_000,
            is_waited_for,
            under_way: None,
        }
    }

    #[test]
    fn large_pictures_are_smoothed_in_bands_and_large_scenes_in_pieces() {
        let pace = pace(true);
        let bands = |[width, height]: [u32; 2], work| {
            let viewport = Viewport::new(width, height).expect("a viewport");
            pace.bands(viewport, Piece { work, instances: 1 })
        };
        assert_eq!(bands([100, 100], 1000), 1);
        assert_eq!(bands([740, 670], 1000), 4);
        assert_eq!(bands([2048, 1024], 1000), 16);
        assert_eq!(bands([2048, 1024], 5000), 5);
        assert_eq!(bands([2048, 1024], 10_000_000), 1);
        assert_eq!(bands([2048, 1024], 0), 16);
    }

    #[test]
    fn pieces_shrink_to_what_fits_and_grow_again() {
        let mut pace = pace(false);
        pace.learn(100_000, [0.4, 0.5]);
        assert_eq!(pace.most().work, 20_000);
        pace.learn(20_000, [10.0, 10.0]);
        assert_eq!(pace.most().work, LEAST_WORK);
        pace.learn(LEAST_WORK, [0.0, 0.01]);
        assert_eq!(pace.most().work, 2 * LEAST_WORK);
        // A small fast piece says nothing about large ones; nor does one that was polled late.
        pace.learn(LEAST_WORK / 2, [0.0, 0.001]);
        pace.learn(2 * LEAST_WORK, [0.0, 30.0]);
        assert_eq!(pace.most().work, 2 * LEAST_WORK);
    }
}
