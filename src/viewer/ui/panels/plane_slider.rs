//! Sliders of near and far: over decades of the scene's size, and finely with Shift.

use super::prelude::*;
use egui::Slider;

/// With Shift, a plane's depth changes by this share for each point that the cursor moves.
const FINE: f64 = 0.005;

/// Adds a hint, but not while the slider is dragged: the tooltip would cover the numbers that change.
pub(super) fn hint_at_rest(slider: Response, hint: impl AsRef<str>) -> Response {
    if slider.dragged() {
        slider
    } else {
        slider.hint(hint)
    }
}

/// How large the visible scene is. The sliders cover ten decades around that.
pub(super) fn size(state: &State) -> f64 {
    let radius = state.scene().visible_bounds().radius();
    // Of nothing it is infinite, of a point 0.
    if radius > 0.0 && radius.is_finite() {
        radius
    } else {
        1.0
    }
}

/// A slider, and where it was slid to, if it was.
pub(super) fn show(
    ui: &mut Ui,
    state: &State,
    name: &str,
    hint: &str,
    depth: f64,
) -> (Response, Option<f64>) {
    let (least, most) = (1e-6 * size(state), 1e4 * size(state));
    let mut slid = depth;
    let slider = Slider::new(&mut slid, least..=most).logarithmic(true);
    let slider = ui.add(slider.smart_aim(false).show_value(false));
    let (has_shift, by) = ui.input(|input| (input.modifiers.shift, input.pointer.delta().x));
    // A drag that was fine once stays fine until its end. Else the plane would jump to the cursor.
    let is_fine = ui.data_mut(|data| {
        let is_fine: &mut bool = data.get_temp_mut_or_default(slider.id);
        *is_fine = has_shift || (*is_fine && !slider.drag_started());
        *is_fine
    });
    let mut is_slid = slider.changed();
    if is_fine && (slider.dragged() || slider.drag_stopped()) {
        slid = (depth * libm::exp(FINE * f64::from(by))).clamp(least, most);
        is_slid = by != 0.0;
    }
    let hint = format!("{hint}. With Shift it slides finely, by half a percent per point");
    let slider = hint_at_rest(slider.named(name), hint);
    (slider, is_slid.then_some(slid))
}
