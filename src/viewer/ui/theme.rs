//! How panels look, and which characters their own typefaces lack.

use crate::{
    colour::Srgb,
    look::{self, Background},
    viewer::jobs::Missing,
};
use egui::{
    Color32, FontId, Style, TextStyle, Theme, ThemePreference, epaint::text::FallbackRequest,
};
use serde::{Deserialize, Serialize};
use std::{num::NonZeroUsize, sync::Arc};

/// A colour as egui has it.
pub(in crate::viewer) const fn color32(Srgb([r, g, b]): Srgb) -> Color32 {
    Color32::from_rgb(r, g, b)
}

/// The strokes of a mark with a dark rim, so that it shows on any picture: the colour of each, and how many points
/// wider it is.
pub(super) fn rimmed(colour: Color32) -> [(Color32, f32); 2] {
    [(Color32::from_black_alpha(200), 2.0), (colour, 0.0)]
}

/// What words over a picture stand on: dark under dark panels, light under light ones. 255 hides the picture below.
pub(super) fn backing(context: &egui::Context, opacity: u8) -> Color32 {
    match context.theme() {
        Theme::Dark => Color32::from_black_alpha(opacity),
        Theme::Light => Color32::from_white_alpha(opacity),
    }
}

/// A colour of the picture, as words on a [`backing`] have it: as dark as it must be on a light one.
pub(super) fn of_words(context: &egui::Context, colour: Color32) -> Color32 {
    /// On white, words of this luminance have a contrast of 5.5 (WCAG 2.2, which asks for 4.5).
    const DARK: f32 = 0.14;
    if context.theme() == Theme::Dark {
        return colour;
    }
    let linear = Srgb([colour.r(), colour.g(), colour.b()]).to_linear();
    let share = (DARK / look::luminance(linear)).min(1.0);
    color32(Srgb::from_linear(linear.map(|channel| channel * share)))
}

/// Whether panels are dark or light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(in crate::viewer) enum Look {
    /// As the desktop is; dark if the desktop does not say.
    #[default]
    Desktop,
    Light,
    Dark,
}

impl Look {
    pub fn next(self) -> Self {
        match self {
            Self::Desktop => Self::Light,
            Self::Light => Self::Dark,
            Self::Dark => Self::Desktop,
        }
    }

    /// In words.
    pub fn about(self) -> &'static str {
        match self {
            Self::Desktop => "as on the desktop",
            Self::Light => "light",
            Self::Dark => "dark",
        }
    }

    /// Gives panels this look.
    pub fn apply(self, context: &egui::Context) {
        context.set_theme(match self {
            Self::Desktop => ThemePreference::System,
            Self::Light => ThemePreference::Light,
            Self::Dark => ThemePreference::Dark,
        });
    }
}

/// Makes egui as the viewer wants it: dark or light as the desktop is, with text that is readable on projectors too,
/// which do not show dark greys. Warnings are olive on dark panels and brown on light ones: yellow and orange mean other
/// things.
pub(in crate::viewer) fn dress(context: &egui::Context) {
    egui_extras::install_image_loaders(context);
    // What commands change is laid out at once, and what appears in that pass is measured before it shows.
    context.options_mut(|options| options.max_passes = NonZeroUsize::MIN.saturating_add(2));
    let [dark, light] = look::WARNING;
    for (theme, error, warning, text, weak) in [
        (Theme::Dark, [255, 120, 105], dark, 222, 160),
        (Theme::Light, [176, 20, 0], light, 24, 86),
    ] {
        let mut visuals = theme.default_visuals();
        visuals.error_fg_color = color32(Srgb(error));
        visuals.warn_fg_color = color32(warning);
        // The frame behind the panels has their colour already.
        visuals.panel_fill = Color32::TRANSPARENT;
        visuals.override_text_color = Some(Color32::from_gray(text));
        visuals.weak_text_color = Some(Color32::from_gray(weak));
        let mut style = Style {
            visuals,
            ..Style::default()
        };
        // Numbers of fields.
        let numbers = TextStyle::Name("numbers".into());
        let font = FontId::monospace(11.0);
        style.text_styles.insert(numbers.clone(), font);
        style.drag_value_text_style = numbers;
        // What unfolds is there at once: a frame in software costs too much for an animation.
        style.animation_time = 0.0;
        // As wide as a side: a hint does not cover the picture that it is about.
        style.spacing.tooltip_width = 280.0;
        context.set_style_of(theme, style);
    }
}

/// What the panels are painted on.
pub(in crate::viewer) fn panels_on(context: &egui::Context) -> Color32 {
    context.theme().default_visuals().panel_fill
}

/// What is behind scenes: dark beside dark panels, light beside light ones.
pub(in crate::viewer) fn background(context: &egui::Context) -> Background {
    match context.theme() {
        Theme::Dark => Background::DARK,
        Theme::Light => Background::LIGHT,
    }
}

/// Notes the characters that egui's own typefaces lack.
pub(in crate::viewer) fn note_missing(context: &egui::Context, missing: Missing) {
    context.add_font_provider(Arc::new(move |request: &FallbackRequest<'_>| {
        let characters = request.cluster.chars();
        characters.for_each(|character| missing.add(character));
        None
    }));
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A colour's hue in degrees. Red is at 0, yellow at 60.
    fn hue_deg(colour: Color32) -> f32 {
        let [red, green, blue] = [colour.r(), colour.g(), colour.b()];
        assert!(red >= green && green >= blue && red > blue, "{colour:?}");
        60.0 * f32::from(green - blue) / f32::from(red - blue)
    }

    /// A warning has neither the selection's colour nor that of errors or plain text.
    #[test]
    fn warnings_have_a_colour_of_their_own() {
        let context = egui::Context::default();
        dress(&context);
        for theme in [Theme::Dark, Theme::Light] {
            let style = context.style_of(theme);
            let (visuals, warns) = (&style.visuals, style.visuals.warn_fg_color);
            for other in [color32(look::SELECTION), visuals.error_fg_color] {
                let apart_deg = (hue_deg(warns) - hue_deg(other)).abs();
                assert!(apart_deg > 12.0, "{theme:?}, {other:?}: {apart_deg}");
            }
            let from_grey = warns.r() - warns.b();
            assert!(from_grey > 90, "{theme:?}: {from_grey}");
        }
    }
}
