//! A backend on which the study's charts are drawn in the window: sharp at any scale.

use super::prelude::*;
use egui::{Painter, Pos2, Shape, StrokeKind, epaint::TextShape};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind,
    FontTransform,
    text_anchor::{HPos, VPos},
};
use std::{
    convert::Infallible,
    f32::consts::{FRAC_PI_2, PI},
};

/// A part of a panel as a backend. Nothing can go wrong on it.
pub(super) struct Plot {
    painter: Painter,
    /// Its top left corner.
    from: Pos2,
    /// Points for a pixel of the chart.
    scale: f32,
    size_px: (u32, u32),
}

type Drawn = Result<(), DrawingErrorKind<Infallible>>;

impl Plot {
    /// A backend of a size in its own pixels, as wide as there is room in a panel.
    #[expect(clippy::cast_precision_loss, reason = "thousands at most")]
    pub(super) fn new(ui: &mut Ui, size_px: (u32, u32)) -> Self {
        let scale = ui.available_width() / size_px.0 as f32;
        let size = vec2(size_px.0 as f32, size_px.1 as f32) * scale;
        let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
        Self {
            painter: ui.painter().with_clip_rect(rect),
            from: rect.min,
            scale,
            size_px,
        }
    }

    #[expect(clippy::cast_precision_loss, reason = "thousands at most")]
    fn at(&self, (x, y): BackendCoord) -> Pos2 {
        self.from + vec2(x as f32, y as f32) * self.scale
    }

    #[expect(clippy::cast_precision_loss, reason = "a few pixels")]
    fn stroke(&self, style: &impl BackendStyle) -> Stroke {
        let width = style.stroke_width() as f32 * self.scale;
        Stroke::new(width, colour(style.color()))
    }

    fn galley(&self, text: &str, style: &impl BackendTextStyle) -> std::sync::Arc<egui::Galley> {
        // The charts have this typeface too, but there a size is the height of a line.
        #[expect(clippy::cast_possible_truncation, reason = "a few pixels")]
        let font = FontId::proportional(0.86 * style.size() as f32 * self.scale);
        let ink = colour(style.color());
        self.painter.layout_no_wrap(text.to_owned(), font, ink)
    }
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "0 to 255"
)]
fn colour(
    BackendColor {
        alpha,
        rgb: (r, g, b),
    }: BackendColor,
) -> Color32 {
    Color32::from_rgba_unmultiplied(r, g, b, (255.0 * alpha).round() as u8)
}

impl DrawingBackend for Plot {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        self.size_px
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        Ok(())
    }

    fn draw_pixel(&mut self, at: BackendCoord, color: BackendColor) -> Drawn {
        self.draw_rect(at, (at.0 + 1, at.1 + 1), &color, true)
    }

    fn draw_line<S: BackendStyle>(&mut self, a: BackendCoord, b: BackendCoord, s: &S) -> Drawn {
        self.draw_path([a, b], s)
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Drawn {
        let path = path.into_iter().map(|at| self.at(at));
        self.painter.line(path.collect(), self.stroke(style));
        Ok(())
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        from: BackendCoord,
        to: BackendCoord,
        style: &S,
        fill: bool,
    ) -> Drawn {
        let rect = Rect::from_two_pos(self.at(from), self.at(to));
        if fill {
            self.painter.rect_filled(rect, 0.0, colour(style.color()));
        } else {
            let stroke = self.stroke(style);
            (self.painter).rect_stroke(rect, 0.0, stroke, StrokeKind::Middle);
        }
        Ok(())
    }

    #[expect(clippy::cast_precision_loss, reason = "a few pixels")]
    fn draw_circle<S: BackendStyle>(
        &mut self,
        middle: BackendCoord,
        radius: u32,
        style: &S,
        fill: bool,
    ) -> Drawn {
        let (at, radius) = (self.at(middle), radius as f32 * self.scale);
        if fill {
            self.painter
                .circle_filled(at, radius, colour(style.color()));
        } else {
            self.painter.circle_stroke(at, radius, self.stroke(style));
        }
        Ok(())
    }

    /// egui fills convex outlines only. A star is a fan about its middle.
    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        corners: I,
        style: &S,
    ) -> Drawn {
        let corners: Vec<Pos2> = corners.into_iter().map(|at| self.at(at)).collect();
        let rect = Rect::from_points(&corners);
        for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            let part = vec![rect.center(), *a, *b];
            let part = Shape::convex_polygon(part, colour(style.color()), Stroke::NONE);
            self.painter.add(part);
        }
        Ok(())
    }

    fn draw_text<S: BackendTextStyle>(&mut self, text: &str, style: &S, at: BackendCoord) -> Drawn {
        let galley = self.galley(text, style);
        let share = vec2(
            match style.anchor().h_pos {
                HPos::Left => 0.0,
                HPos::Center => 0.5,
                HPos::Right => 1.0,
            },
            match style.anchor().v_pos {
                VPos::Top => 0.0,
                VPos::Center => 0.5,
                VPos::Bottom => 1.0,
            },
        );
        let away = share * galley.size();
        let (angle, away) = match style.transform() {
            FontTransform::None => (0.0, away),
            FontTransform::Rotate90 => (FRAC_PI_2, vec2(-away.y, away.x)),
            FontTransform::Rotate180 => (PI, -away),
            FontTransform::Rotate270 => (-FRAC_PI_2, vec2(away.y, -away.x)),
        };
        let shape = TextShape::new(self.at(at) - away, galley, colour(style.color()));
        self.painter.add(shape.with_angle(angle));
        Ok(())
    }

    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "thousands at most"
    )]
    fn estimate_text_size<S: BackendTextStyle>(
        &self,
        text: &str,
        style: &S,
    ) -> Result<(u32, u32), DrawingErrorKind<Infallible>> {
        let size = self.galley(text, style).size() / self.scale;
        Ok((size.x.ceil() as u32, size.y.ceil() as u32))
    }
}
