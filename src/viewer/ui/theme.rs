//! How panels look.

use super::mouse;
use crate::colour::Srgb;
use egui::Color32;

/// A colour as egui has it.
pub(in crate::viewer) const fn color32(Srgb([r, g, b]): Srgb) -> Color32 {
    Color32::from_rgb(r, g, b)
}

/// egui as the viewer wants it: panels as dark as the scene, whatever the desktop's theme, with words that are
/// readable on them.
pub(in crate::viewer) fn context() -> egui::Context {
    let context = egui::Context::default();
    mouse::options(&context);
    context.set_theme(egui::Theme::Dark);
    let mut visuals = egui::Visuals::dark();
    visuals.error_fg_color = Color32::from_rgb(255, 120, 105);
    // For projectors, which swallow dark greys.
    visuals.override_text_color = Some(Color32::from_gray(222));
    visuals.weak_text_color = Some(Color32::from_gray(160));
    context.set_visuals(visuals);
    context
}
