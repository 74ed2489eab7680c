//! Where in the window the scene is. Converts between points of the window and pixels of the picture.

use crate::camera::Viewport;
use egui::{Pos2, Rect};
use glam::DVec2;

/// The rectangle of the window that shows the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::viewer) struct SceneRect {
    /// Top left corner in physical pixels of the window.
    pub origin_px: [u32; 2],
    /// Its size in physical pixels.
    pub viewport: Viewport,
    /// Physical pixels for a point.
    pub pixels_per_point: f32,
}

impl SceneRect {
    /// The pixels that a rectangle in points covers; `None` when that is not even one.
    pub fn new(rect: Rect, pixels_per_point: f32) -> Option<Self> {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "clamped by the cast"
        )]
        let px = |points: f32| (points * pixels_per_point).round() as u32;
        let (left, top) = (px(rect.left()), px(rect.top()));
        let size = [
            px(rect.right()).saturating_sub(left),
            px(rect.bottom()).saturating_sub(top),
        ];
        Some(Self {
            origin_px: [left, top],
            viewport: Viewport::new(size[0], size[1]).ok()?,
            pixels_per_point,
        })
    }

    /// The pixels as a rectangle in points.
    pub fn to_points(self) -> Rect {
        #[expect(clippy::cast_precision_loss, reason = "windows are not that large")]
        let points = |px: [u32; 2]| px.map(|px| px as f32 / self.pixels_per_point);
        let size = points([self.viewport.width(), self.viewport.height()]);
        Rect::from_min_size(points(self.origin_px).into(), size.into())
    }

    /// A position within the rectangle in pixels as a position in points.
    #[expect(clippy::cast_possible_truncation, reason = "points are f32")]
    pub fn to_position(self, px: DVec2) -> Pos2 {
        let scale = f64::from(self.pixels_per_point);
        let origin = DVec2::from(self.origin_px.map(f64::from));
        let points = (px + origin) / scale;
        Pos2::new(points.x as f32, points.y as f32)
    }

    /// A position in points as a position within the rectangle in pixels. The pointer's pixels came through `f32`
    /// points; rounding to 1/64 pixel removes that error.
    pub fn to_px(self, position: Pos2) -> DVec2 {
        const STEPS: f64 = 64.0;
        let scale = f64::from(self.pixels_per_point);
        let px = DVec2::new(f64::from(position.x), f64::from(position.y)) * scale;
        let origin = DVec2::new(f64::from(self.origin_px[0]), f64::from(self.origin_px[1]));
        (px * STEPS).round() / STEPS - origin
    }
}
