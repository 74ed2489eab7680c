//! A chart of the study, drawn by egui: sharp at any scale.

use super::prelude::*;
use crate::study::chart::{
    outlines,
    picture::{Anchor, Colour, DASH, Mark, Picture},
};
use egui::{Painter, Pos2, Shape, epaint::TextShape};
use std::f32::consts::FRAC_PI_2;

/// Draws a chart as wide as there is room.
#[expect(clippy::cast_precision_loss, reason = "a picture's size")]
pub(super) fn show(ui: &mut Ui, picture: &Picture) {
    let scale = ui.available_width() / picture.width as f32;
    let size = vec2(picture.width as f32, picture.height as f32) * scale;
    let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
    let painter = ui.painter().with_clip_rect(rect);
    painter.rect_filled(rect, 4.0, Color32::WHITE);
    let page = Page {
        painter: &painter,
        rect,
        scale,
    };
    picture.marks.iter().for_each(|mark| page.draw(mark));
}

struct Page<'a> {
    painter: &'a Painter,
    rect: Rect,
    scale: f32,
}

impl Page<'_> {
    #[expect(
        clippy::cast_possible_truncation,
        reason = "positions within a picture"
    )]
    fn at(&self, [x, y]: [f64; 2]) -> Pos2 {
        self.rect.min + vec2(x as f32, y as f32) * self.scale
    }

    fn path(&self, points: &[[f64; 2]]) -> Vec<Pos2> {
        points.iter().map(|point| self.at(*point)).collect()
    }

    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_precision_loss,
        reason = "a few pixels"
    )]
    fn draw(&self, mark: &Mark) {
        let colour = |[r, g, b]: Colour| Color32::from_rgb(r, g, b);
        match mark {
            Mark::Line {
                points,
                colour: line,
                width,
                dashed,
            } => {
                let stroke = Stroke::new(*width as f32 * self.scale, colour(*line));
                let path = self.path(points);
                if *dashed {
                    let [on, off] = DASH.map(|px| px as f32 * self.scale);
                    let parts = Shape::dashed_line(&path, stroke, on, off);
                    self.painter.extend(parts);
                } else {
                    self.painter.line(path, stroke);
                }
            }
            Mark::Rectangle {
                from,
                to,
                colour: fill,
            } => {
                let rect = Rect::from_two_pos(self.at(*from), self.at(*to));
                self.painter.rect_filled(rect, 0.0, colour(*fill));
            }
            Mark::Point {
                at,
                shape,
                radius,
                colour: line,
                filled,
            } => {
                let line = colour(*line);
                let fill = if *filled { line } else { Color32::WHITE };
                for outline in outlines(*shape, *at, *radius) {
                    let mut path = self.path(&outline);
                    path.extend(path.first().copied());
                    // egui fills convex outlines only: a star is a fan about its middle. Bars have nothing to fill.
                    for side in path.windows(2).filter(|_| outline.len() > 2) {
                        let corners = vec![self.at(*at), side[0], side[1]];
                        let part = Shape::convex_polygon(corners, fill, Stroke::NONE);
                        self.painter.add(part);
                    }
                    self.painter.line(path, Stroke::new(2.0 * self.scale, line));
                }
            }
            Mark::Text {
                at,
                anchor,
                size,
                colour: ink,
                upwards,
                text,
            } => {
                // The charts have this typeface too, but there a size is the height of a line.
                let font = FontId::proportional(0.86 * *size as f32 * self.scale);
                let align = match anchor {
                    Anchor::Left => Align2::LEFT_CENTER,
                    Anchor::Middle => Align2::CENTER_CENTER,
                    Anchor::Right => Align2::RIGHT_CENTER,
                };
                let galley = (self.painter).layout_no_wrap(text.clone(), font, colour(*ink));
                let at = self.at(*at);
                if *upwards {
                    let corner = pos2(at.x - 0.5 * galley.size().y, at.y + 0.5 * galley.size().x);
                    let shape = TextShape::new(corner, galley, colour(*ink)).with_angle(-FRAC_PI_2);
                    self.painter.add(shape);
                } else {
                    let corner = align.anchor_size(at, galley.size()).min;
                    self.painter.galley(corner, galley, colour(*ink));
                }
            }
        }
    }
}
