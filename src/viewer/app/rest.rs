//! When the picture rests: its edges are smooth then.

use crate::viewer::model::OnScreen;

/// A picture in which nothing has moved for so many seconds is at rest.
pub(in crate::viewer) const REST_S: f64 = 0.15;

/// Since when nothing has moved.
#[derive(Default)]
pub(in crate::viewer) struct Rest {
    /// What is to be shown, and since when, by egui's clock in seconds.
    since_s: Option<(OnScreen, f64)>,
    /// The last frame left nothing to be done but smooth edges.
    pub is_settled: bool,
}

impl Rest {
    /// Whether what is to be shown has been the same for a while.
    pub fn is_reached(&mut self, to_show: OnScreen, now_s: f64) -> bool {
        let same = self.since_s.filter(|(shown, _)| *shown == to_show);
        let since_s = same.map_or(now_s, |(_, since_s)| since_s);
        self.since_s = Some((to_show, since_s));
        now_s - since_s >= REST_S
    }
}
