//! Tells whether the picture moves or rests. At rest its edges get smooth.

use crate::{
    camera::View,
    viewer::{model::OnScreen, screen::Motion},
};

/// A picture is at rest once nothing has moved in it for this many seconds.
pub(in crate::viewer) const REST_S: f64 = 0.15;

/// Tells since when nothing has moved.
#[derive(Default)]
pub(in crate::viewer) struct Rest {
    /// What is to be shown, and since when, in seconds of egui's clock.
    since_s: Option<((OnScreen, Vec<View>), f64)>,
    /// Whether the last change was part of a movement, not one jump.
    moves: bool,
    /// Whether the last frame left nothing to do but smooth edges.
    pub is_settled: bool,
}

impl Rest {
    /// How the picture moves. A change is a move while a button `is_held`, or if the last change was less than
    /// [`REST_S`] ago; else it is a jump.
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
