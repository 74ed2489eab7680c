//! How much of a picture is drawn in a pass: what takes a tenth of a second at the most, by what pieces took before.

use crate::render::{Gpu, Piece};
use std::{
    sync::{Arc, Mutex},
    time::Instant,
};

/// What drawing may take of a pass, in seconds, with room for what comes after it.
const LONGEST_S: f64 = 0.08;
/// Work that is within that on slow adapters of the two kinds, at first.
const SOFTWARE_WORK: u64 = 100_000;
const HARDWARE_WORK: u64 = 4_000_000;
/// The least that pieces come down to.
const LEAST_WORK: u64 = 10_000;
/// Rows of tables that are composed in a few milliseconds.
const INSTANCES: u32 = 16_384;

/// What pieces took, and what they may be.
#[derive(Debug)]
pub(super) struct Pace {
    work: u64,
    /// The work of the piece that is being drawn.
    under_way: Option<u64>,
    /// Seconds that it took, once it is done.
    took: Arc<Mutex<Option<f64>>>,
}

impl Pace {
    pub fn new(gpu: &Gpu) -> Self {
        Self {
            work: if gpu.is_software() {
                SOFTWARE_WORK
            } else {
                HARDWARE_WORK
            },
            under_way: None,
            took: Arc::default(),
        }
    }

    /// How much there may be in a piece.
    pub fn most(&self) -> Piece {
        Piece {
            work: self.work,
            instances: INSTANCES,
        }
    }

    /// Whether the adapter has drawn all pieces: more would only wait, and what is shown after them too.
    pub fn is_free(&mut self) -> bool {
        let took = self.took.lock().map_or(None, |mut took| took.take());
        if let (Some(work), Some(took_s)) = (self.under_way, took) {
            self.under_way = None;
            self.learn(work, took_s);
        }
        self.under_way.is_none()
    }

    /// A piece was submitted.
    pub fn began(&mut self, gpu: &Gpu, work: u64) {
        let (start, took) = (Instant::now(), Arc::clone(&self.took));
        self.under_way = Some(work);
        gpu.queue.on_submitted_work_done(move || {
            if let Ok(mut took) = took.lock() {
                *took = Some(start.elapsed().as_secs_f64());
            }
        });
    }

    /// Less where a piece took too long; more where one that was nearly as large as may be was done in no time.
    fn learn(&mut self, work: u64, took_s: f64) {
        if took_s > LONGEST_S {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                clippy::cast_precision_loss,
                reason = "an estimate"
            )]
            let fits = (work as f64 * LONGEST_S / took_s) as u64;
            self.work = self.work.min(fits.max(LEAST_WORK));
        } else if took_s < 0.5 * LONGEST_S && work > self.work / 2 {
            self.work = self.work.saturating_mul(2);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_shrink_to_what_fits_and_grow_again() {
        let mut pace = Pace {
            work: 100_000,
            under_way: None,
            took: Arc::default(),
        };
        pace.learn(100_000, 0.4);
        assert_eq!(pace.most().work, 20_000);
        pace.learn(20_000, 10.0);
        assert_eq!(pace.most().work, LEAST_WORK);
        pace.learn(LEAST_WORK, 0.01);
        assert_eq!(pace.most().work, 2 * LEAST_WORK);
        // Little that is done soon says nothing of much.
        pace.learn(LEAST_WORK / 2, 0.001);
        assert_eq!(pace.most().work, 2 * LEAST_WORK);
    }
}
