//! Which tiles of the window have panels. Only these tiles are drawn over the picture.

use super::place::SceneRect;
use egui::{ClippedPrimitive, Color32, Rect, epaint::Primitive};
use egui_wgpu::ScreenDescriptor;

/// Pixels of a tile's side.
const SIDE: u32 = 32;

/// Which tiles of a window have anything painted in them.
#[derive(Default)]
pub(super) struct PanelTiles {
    /// Width and height of the window.
    size_px: [u32; 2],
    columns: usize,
    /// Row by row.
    painted: Vec<bool>,
}

impl PanelTiles {
    /// The tiles under a frame's triangles.
    pub fn under(primitives: &[ClippedPrimitive], screen: &ScreenDescriptor) -> Self {
        let [columns, rows] = screen.size_in_pixels.map(|px| px.div_ceil(SIDE) as usize);
        let mut tiles = Self {
            size_px: screen.size_in_pixels,
            columns,
            painted: vec![false; columns * rows],
        };
        for painted in primitives {
            let clip_rect = painted.clip_rect;
            match &painted.primitive {
                Primitive::Mesh(mesh) => {
                    for corners in mesh.indices.chunks_exact(3) {
                        let corners = [0, 1, 2].map(|i| mesh.vertices[corners[i] as usize]);
                        if corners.iter().any(|at| at.color != Color32::TRANSPARENT) {
                            let rect = Rect::from_points(&corners.map(|corner| corner.pos));
                            tiles.mark(rect.intersect(clip_rect), screen.pixels_per_point);
                        }
                    }
                }
                Primitive::Callback(_) => tiles.mark(clip_rect, screen.pixels_per_point),
            }
        }
        tiles
    }

    /// Marks the tiles of a rectangle in points.
    fn mark(&mut self, rect: Rect, pixels_per_point: f32) {
        if rect.is_negative() || self.painted.is_empty() {
            return;
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "such conversions saturate, and the window bounds them"
        )]
        let tile = |points: f32, last: usize| {
            (((points * pixels_per_point) as u32 / SIDE) as usize).min(last)
        };
        let (right, bottom) = (self.columns - 1, self.painted.len() / self.columns - 1);
        let columns = tile(rect.left(), right)..=tile(rect.right(), right);
        for row in tile(rect.top(), bottom)..=tile(rect.bottom(), bottom) {
            for column in columns.clone() {
                self.painted[row * self.columns + column] = true;
            }
        }
    }

    /// The painted tiles of a place in horizontal runs: left, top, width and height in pixels. While a window changes
    /// its size, a place may reach beyond it: runs do not.
    pub fn runs(&self, place: SceneRect) -> Vec<[u32; 4]> {
        let [left, top] = place.origin_px;
        let right = (left + place.viewport.width()).min(self.size_px[0]);
        let bottom = (top + place.viewport.height()).min(self.size_px[1]);
        let mut runs = Vec::new();
        for row in top / SIDE..bottom.div_ceil(SIDE) {
            let (y0, y1) = ((row * SIDE).max(top), ((row + 1) * SIDE).min(bottom));
            let mut column = left / SIDE;
            while column * SIDE < right {
                let first = column;
                while column * SIDE < right && self.is_painted(column, row) {
                    column += 1;
                }
                if column > first {
                    let (x0, x1) = ((first * SIDE).max(left), (column * SIDE).min(right));
                    runs.push([x0, y0, x1 - x0, y1 - y0]);
                }
                column += 1;
            }
        }
        runs
    }

    fn is_painted(&self, column: u32, row: u32) -> bool {
        let (column, row) = (column as usize, row as usize);
        column < self.columns && *(self.painted.get(row * self.columns + column)).unwrap_or(&false)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::Viewport;
    use egui::{Mesh, pos2};

    fn frame(rects: &[(Rect, Color32)]) -> Vec<ClippedPrimitive> {
        let mut mesh = Mesh::default();
        for &(rect, colour) in rects {
            mesh.add_colored_rect(rect, colour);
        }
        vec![ClippedPrimitive {
            clip_rect: Rect::from_min_max(pos2(0.0, 0.0), pos2(300.0, 100.0)),
            primitive: Primitive::Mesh(mesh),
        }]
    }

    fn rect([left, top, right, bottom]: [f32; 4]) -> Rect {
        Rect::from_min_max(pos2(left, top), pos2(right, bottom))
    }

    #[test]
    fn runs_cover_what_is_painted_and_end_where_the_place_does() {
        let screen = ScreenDescriptor {
            size_in_pixels: [600, 200],
            pixels_per_point: 2.0,
        };
        let painted = frame(&[
            (rect([10.0, 5.0, 40.0, 6.0]), Color32::RED),
            (rect([100.0, 50.0, 900.0, 51.0]), Color32::BLUE),
            (rect([0.0, 80.0, 300.0, 100.0]), Color32::TRANSPARENT),
        ]);
        let tiles = PanelTiles::under(&painted, &screen);
        let place = SceneRect {
            origin_px: [30, 3],
            viewport: Viewport::new(500, 190).expect("a viewport"),
            pixels_per_point: 2.0,
        };
        let runs = [[30, 3, 66, 29], [192, 96, 338, 32]];
        assert_eq!(tiles.runs(place), runs, "in pixels");
        let beyond = SceneRect {
            origin_px: [580, 40],
            ..place
        };
        assert_eq!(tiles.runs(beyond), [[580, 96, 20, 32]], "within the window");
        assert!(PanelTiles::default().runs(place).is_empty());
    }
}
