//! When the picture moves, and when it rests: its edges are smooth then.

use crate::{
    camera::View,
    viewer::{model::OnScreen, screen::Motion},
};

/// A picture in which nothing has moved for so many seconds is at rest.
pub(in crate::viewer) const REST_S: f64 = 0.15;

/// Since when nothing has moved.
#[derive(Default)]
pub(in crate::viewer) struct Rest {
    /// What is to be shown, and since when, by egui's clock in seconds.
    since_s: Option<((OnScreen, Vec<View>), f64)>,
    /// It did not only leap there.
    moves: bool,
    /// The last frame left nothing to be done but smooth edges.
    pub is_settled: bool,
}

impl Rest {
    /// How what is to be shown moves. What changes while a button `is_held` moves, and so does what has changed a moment
    /// before.
    pub fn motion(&mut self, to_show: (OnScreen, Vec<View>), now_s: f64, is_held: bool) -> Motion {
        let before = self.since_s.as_ref();
        let before_s = before.map_or(f64::NEG_INFINITY, |(_, since_s)| *since_s);
        if before.is_none_or(|(shown, _)| *shown != to_show) {
            self.since_s = Some((to_show, now_s));
            self.moves = is_held || now_s - before_s < REST_S;
        } else if now_s - before_s >= REST_S {
            self.moves = false;
            return Motion::Rests;
        }
        if self.moves {
            Motion::Goes
        } else {
            Motion::Leapt
        }
    }
}
