//! The line at the bottom: times, the adapter, the projection, and what is under the cursor.

use super::prelude::*;
use crate::geometry::Sides;
use std::time::Duration;

/// For so long after a picture the line says how long it took, in seconds.
const FRESH_S: f64 = 3.0;

/// Room in points for how long a picture took.
const WIDTH: f32 = 120.0;

/// What the status line knows of the machine.
#[derive(Clone, Debug, Default)]
pub(in crate::viewer) struct Statistics {
    /// How long the last frame took that showed a new picture of the scene, and when that was in egui's seconds. The
    /// adapter's own time counts only if the adapter is software.
    pub frame: Option<(Duration, f64)>,
    /// How long the last click took to pick.
    pub pick: Option<Duration>,
    /// The graphics adapter.
    pub adapter: String,
    /// Whether the adapter is the processor itself.
    pub software: bool,
}

/// The object under the cursor is named at the right end. It has its room first: in a narrow window, the rest is cut.
pub(super) fn show(ui: &mut Ui, state: &State, statistics: &Statistics) {
    let height = ui.spacing().interact_size.y;
    let whole = vec2(ui.available_width(), height);
    let from_right = Layout::right_to_left(Align::Center);
    ui.allocate_ui_with_layout(whole, from_right, |ui| {
        if let Some(object) = state.hover() {
            let name = &state.scene().objects()[object].name;
            ui.scope(|ui| {
                ui.set_max_width(0.5 * ui.available_width());
                let name = Label::new(name).truncate();
                ui.add(name).hint("what is under the cursor");
            });
            ui.separator();
        }
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            ui.set_clip_rect(ui.max_rect().intersect(ui.clip_rect()));
            pick(ui, statistics);
            drawing(ui, state, statistics);
            frame(ui, statistics);
        });
    });
}

/// How long the last pick took.
fn pick(ui: &mut Ui, statistics: &Statistics) {
    if let Some(pick) = statistics.pick {
        let pick_us = 1e6 * pick.as_secs_f64();
        ui.weak(format!("pick {pick_us:6.0} \u{b5}s"))
            .hint("how long the last click's ray took, in millionths of a second");
        ui.separator();
    }
}

/// How long the last picture took, for a while. It stands last: as it goes, nothing moves.
fn frame(ui: &mut Ui, statistics: &Statistics) {
    let Some((took, drawn_s)) = statistics.frame else {
        return;
    };
    let left_s = drawn_s + FRESH_S - ui.input(|input| input.time);
    // In a narrow window there is no room for it.
    if left_s > 0.0 && ui.available_width() > WIDTH {
        (ui.ctx()).request_repaint_after(Duration::from_secs_f64(left_s));
        ui.separator();
        ui.weak(format!("frame {:6.1} ms", 1e3 * took.as_secs_f64()))
            .hint("how long the picture of the scene took that was just drawn, in thousandths of a second");
    }
}

/// What draws, and how.
fn drawing(ui: &mut Ui, state: &State, statistics: &Statistics) {
    let adapter = RichText::new(&statistics.adapter).weak();
    ui.add(Label::new(adapter).truncate())
        .hint("what draws: the graphics card, or the processor in its place");
    if statistics.software {
        ui.add(Label::new("software").truncate())
            .hint("no graphics card is used: the processor draws");
    }
    ui.separator();
    let lens = state.view().camera.lens();
    let projection = if lens.is_orthographic() {
        "orthographic"
    } else {
        "perspective"
    };
    let culls = match state.view().sides {
        Sides::Front => ", back faces culled",
        Sides::Both => "",
    };
    let drawn = RichText::new(format!("{projection}, {} depth{culls}", lens.depth)).weak();
    ui.add(Label::new(drawn).truncate())
        .hint("how the view is flattened, and how the depth buffer stores depth; the Camera panel changes both");
}
