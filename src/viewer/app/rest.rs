//! Tells whether the picture moves or rests. While it moves it may be coarse; at rest its edges get smooth.

use crate::{camera::View, viewer::model::OnScreen};

/// A picture is at rest once nothing has moved in it for this many seconds.
pub const REST_S: f64 = 0.15;

/// Tells since when nothing has moved.
#[derive(Default)]
pub(in crate::viewer) struct Rest {
    /// What is to be shown, and since when, in seconds of egui's clock.
    since_s: Option<((OnScreen, Vec<View>), f64)>,
    /// Whether the picture gets better at rest.
    pub is_rough: bool,
    /// Whether the last frame left nothing to do but that.
    pub is_settled: bool,
}

impl Rest {
    /// Whether what is to be shown has changed within [`REST_S`].
    pub fn moves(&mut self, to_show: (OnScreen, Vec<View>), now_s: f64) -> bool {
        match &self.since_s {
            Some((shown, since_s)) if *shown == to_show => now_s - since_s < REST_S,
            _ => {
                self.since_s = Some((to_show, now_s));
                true
            }
        }
    }
}
