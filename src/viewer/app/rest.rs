//! Tells whether the picture moves or rests, and whether it is late. At rest its edges get smooth.

use crate::{
    camera::View,
    viewer::{
        model::OnScreen,
        screen::{Motion, PictureProgress},
    },
};

/// A picture is at rest once nothing has moved in it for this many seconds.
pub const REST_S: f64 = 0.15;

/// A picture that is awaited for this many seconds is late: the user is told that it is being drawn.
const LATE_S: f64 = 0.5;

/// Tells since when nothing has moved, and since when a picture is awaited.
#[derive(Default)]
pub(in crate::viewer) struct Rest {
    /// What is to be shown, and since when, in seconds of egui's clock.
    since_s: Option<((OnScreen, Vec<View>), f64)>,
    /// Whether the last change was part of a movement, not one jump.
    moves: bool,
    /// Since when the picture on screen is not the wanted one, and no new one has come.
    awaited_since_s: Option<f64>,
    /// Whether the last frame left nothing to do but smooth edges.
    pub is_settled: bool,
}

impl Rest {
    /// Takes what a frame has drawn.
    pub fn drew(&mut self, progress: &PictureProgress, now_s: f64) {
        let since_s = self.awaited_since_s.filter(|_| !progress.anew);
        self.awaited_since_s = progress.behind.map(|_| since_s.unwrap_or(now_s));
    }

    /// Whether the picture is late.
    pub fn is_late(&self, now_s: f64) -> bool {
        (self.awaited_since_s).is_some_and(|since_s| now_s - since_s >= LATE_S)
    }

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
