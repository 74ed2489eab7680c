//! The line at the bottom: times, the adapter, the projection, and what is under the cursor.

use super::{hints::Hint, visual_order::visual_order};
use crate::viewer::model::State;
use egui::Ui;
use std::time::Duration;

/// For so long after a picture the line says how long it took, in seconds.
const FRESH_S: f64 = 3.0;

/// What the status line knows of the machine.
#[derive(Clone, Debug, Default)]
pub(in crate::viewer) struct Statistics {
    /// How long the last frame took that showed a new picture of the scene, and when that was in egui's seconds. The adapter's
    /// own time counts only if the adapter is software.
    pub frame: Option<(Duration, f64)>,
    /// How long the last click took to pick.
    pub pick: Option<Duration>,
    /// The graphics adapter.
    pub adapter: String,
    /// Whether the adapter is the processor itself.
    pub software: bool,
}

pub(super) fn show(ui: &mut Ui, state: &State, statistics: &Statistics) {
    ui.horizontal(|ui| {
        let now_s = ui.input(|input| input.time);
        let left_s = |drawn_s: f64| drawn_s + FRESH_S - now_s;
        let fresh = statistics.frame.filter(|(_, drawn_s)| left_s(*drawn_s) > 0.0);
        let frame = match fresh {
            Some((took, drawn_s)) => {
                let wait = Duration::from_secs_f64(left_s(drawn_s));
                ui.ctx().request_repaint_after(wait);
                format!("{:6.1}", 1e3 * took.as_secs_f64())
            }
            None => format!("{:>6}", "\u{2013}"),
        };
        ui.weak(format!("frame {frame} ms"))
            .hint("how long the picture of the scene took that was just drawn, in thousandths of a second; a dash at rest");
        if let Some(pick) = statistics.pick {
            let pick_us = 1e6 * pick.as_secs_f64();
            ui.weak(format!("pick {pick_us:6.0} \u{b5}s"))
                .hint("how long the last click's ray took, in millionths of a second");
        }
        ui.separator();
        ui.weak(statistics.adapter.as_str())
            .hint("what draws: the graphics card, or the processor in its place");
        if statistics.software {
            ui.label("software")
                .hint("no graphics card is used: the processor draws");
        }
        ui.separator();
        let lens = state.view().camera.lens();
        let projection = if lens.is_orthographic() {
            "orthographic"
        } else {
            "perspective"
        };
        ui.weak(format!("{projection}, {} depth", lens.depth))
            .hint("how the view is flattened, and how the depth buffer stores depth; the Camera panel changes both");
        if let Some(object) = state.hover() {
            ui.separator();
            ui.label(visual_order(&state.scene().objects()[object].name))
                .hint("what is under the cursor");
        }
    });
}
