//! Rasterises glyphs before text needs them. egui rasterises each glyph when it is first laid out, and a panel that
//! opens may bring more new glyphs than a pass has time for.

use egui::{
    Color32, Context, FontId,
    text::{LayoutJob, TextFormat},
};

/// How many are rasterised in a step, which takes about a millisecond.
const STEP: usize = 24;
/// egui rasterises a glyph anew for each quarter of a pixel that it may begin at.
const QUARTERS: [f32; 4] = [0.0, 0.25, 0.5, 0.75];
/// The panels' fonts: size in points, and whether it is monospace.
const FONTS: [(f32, bool); 7] = [
    (13.0, false),
    (13.0, true),
    (11.0, true),
    (12.0, false),
    (11.0, false),
    (14.0, false),
    (18.0, false),
];

/// How many are rasterised.
#[derive(Default)]
pub(in crate::viewer) struct Letters {
    done: usize,
    /// The scale that they are rasterised for. At another scale, all are rasterised anew.
    pixels_per_point: f32,
}

impl Letters {
    /// Rasterises some more; only after egui's first pass. Returns whether any are left.
    pub fn draw_some(&mut self, context: &Context) -> bool {
        let pixels_per_point = context.pixels_per_point();
        #[expect(clippy::float_cmp, reason = "the very same")]
        if self.pixels_per_point != pixels_per_point {
            (self.done, self.pixels_per_point) = (0, pixels_per_point);
        }
        let all = FONTS.iter().flat_map(|(size, is_monospace)| {
            let font = if *is_monospace {
                FontId::monospace(*size)
            } else {
                FontId::proportional(*size)
            };
            let letters = ('!'..='~').flat_map(|letter| QUARTERS.map(|quarter| (letter, quarter)));
            letters.map(move |(letter, quarter)| (font.clone(), letter, quarter))
        });
        let mut drawn = 0;
        context.fonts_mut(|fonts| {
            for (font, letter, quarter) in all.skip(self.done).take(STEP) {
                let mut text = LayoutJob::default();
                let format = TextFormat::simple(font, Color32::WHITE);
                text.append(&letter.to_string(), quarter / pixels_per_point, format);
                fonts.layout_job(text);
                drawn += 1;
            }
        });
        self.done += drawn;
        drawn == STEP
    }
}
