//! Sliders of the lens: of the field of view, and of near and far over the depths at which the scene lies.

use super::{prelude::*, slide::Slide};
use egui::Slider;
use std::ops::RangeInclusive;

/// Degrees.
const FOV: RangeInclusive<f64> = 1.0..=170.0;
/// Depths farther apart than by this factor are slid over by factors, not by differences.
const DECADES: f64 = 100.0;

/// A slider for a field of view in degrees; where it was slid to, if it was.
pub(super) fn fov(
    ui: &mut Ui,
    name: &str,
    hint: &str,
    fov_deg: f64,
    slide: &mut Slide,
) -> Option<f64> {
    let mut slid = fov_deg;
    let slider = Slider::new(&mut slid, FOV).show_value(false);
    let is_slid = note(&ui.add(slider), name, hint, slide);
    is_slid.then_some(slid)
}

/// The same for the depth of near or far.
pub(super) fn plane(
    ui: &mut Ui,
    state: &State,
    name: &str,
    hint: &str,
    depth: f64,
    slide: &mut Slide,
) -> Option<f64> {
    let (least, most) = state.depth_range();
    let mut slid = depth;
    let slider = Slider::new(&mut slid, least..=most).logarithmic(by_factors(least, most));
    let slider = ui.add(slider.smart_aim(false).show_value(false));
    let hint = format!("{hint}. It slides over the depths of the scene");
    let is_slid = note(&slider, name, &hint, slide);
    is_slid.then_some(slid)
}

/// Whether depths between these are slid and dragged by factors.
pub(super) fn by_factors(least: f64, most: f64) -> bool {
    least > 0.0 && most / least > DECADES
}

/// Names a slider and adds a hint, but not while it is dragged: the tooltip would cover the numbers that change.
fn note(slider: &Response, name: &str, hint: &str, slide: &mut Slide) -> bool {
    let slider = slider.clone().named(name);
    slide.note(&slider);
    let is_slid = slider.changed();
    if !slider.dragged() {
        slider.hint(hint);
    }
    is_slid
}
