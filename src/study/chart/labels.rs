//! Places labels where they cover nothing, as near as possible.

use super::prelude::*;

/// The parts of a frame that are taken.
#[derive(Clone, Debug)]
pub struct LabelPlaces {
    /// The frame: left, top, right, bottom.
    frame: [f64; 4],
    /// Areas of labels and points, which nothing may cover.
    taken: Vec<[f64; 4]>,
    /// Lines, which labels avoid where possible.
    lines: Vec<[f64; 4]>,
}

/// Font size of the labels.
const SIZE: f64 = 16.0;

impl LabelPlaces {
    /// A frame in which nothing is taken.
    pub fn new([left, top]: [f64; 2], [right, bottom]: [f64; 2]) -> Self {
        Self {
            frame: [left, top, right, bottom],
            taken: Vec::new(),
            lines: Vec::new(),
        }
    }

    /// Marks a point's place as taken.
    pub fn take_point(&mut self, at: [f64; 2], radius: f64) {
        self.taken.push(about(at, radius));
    }

    /// Marks a vertical or horizontal line as taken.
    pub fn take_line(&mut self, [a, b]: [[f64; 2]; 2]) {
        let [low, high] = [f64::min, f64::max].map(|of| [of(a[0], b[0]), of(a[1], b[1])]);
        self.lines.push([low[0], low[1], high[0], high[1]]);
    }

    fn holds(&self, area: &[f64; 4]) -> bool {
        let [left, top, right, bottom] = self.frame;
        area[0] >= left && area[1] >= top && area[2] <= right && area[3] <= bottom
    }

    /// Writes words beside a point, with a thin line to words that are not next to it.
    pub fn label(&mut self, picture: &mut Picture, at: [f64; 2], words: &str, line: Colour) {
        let width = text_width(words, SIZE);
        let half = 0.42 * SIZE;
        let place = |(distance, turn): (f64, f64)| {
            let (sin, cos) = libm::sincos(turn * std::f64::consts::TAU);
            let [x, y] = [at[0] + distance * cos, at[1] + 0.9 * distance * sin];
            let left = x - (0.5 - 0.5 * cos.signum() * f64::from(cos.abs() > 0.1)) * width;
            [left, y - half, left + width, y + half]
        };
        let steps = (0..26_u32).map(|i| 13.0 + 9.0 * f64::from(i));
        // Places to the right and to the left come first.
        let turns = [
            0.0, 0.5, 0.04, 0.96, 0.46, 0.54, 0.09, 0.91, 0.41, 0.59, 0.25, 0.75,
        ];
        let all: Vec<[f64; 4]> = steps
            .flat_map(|distance| turns.map(|turn| (distance, turn)))
            .map(place)
            .collect();
        let is_free = |area: &&[f64; 4]| {
            self.holds(area) && !self.taken.iter().any(|other| meet(area, other, 2.0))
        };
        let is_off_lines = |area: &&[f64; 4]| {
            is_free(area) && !self.lines.iter().any(|line| meet(area, line, 1.0))
        };
        // Prefers a near place off all lines, then the nearest free place.
        let free = all.iter().take(7 * turns.len()).find(is_off_lines);
        let free = free.or_else(|| all.iter().find(is_free));
        // If the frame is full, the first place must do.
        let area = *free.unwrap_or(&all[0]);
        let nearest = [at[0].clamp(area[0], area[2]), at[1].clamp(area[1], area[3])];
        if libm::hypot(nearest[0] - at[0], nearest[1] - at[1]) > 16.0 {
            picture.line(vec![at, nearest], line, 1, false);
        }
        // White, to hide lines behind the words.
        picture.rectangle([area[0], area[1]], [area[2], area[3]], [0xff; 3]);
        let from = [area[0], area[1] + half];
        picture.text(from, Anchor::Left, SIZE, INK, words);
        self.taken.push(area);
    }
}

fn about([x, y]: [f64; 2], radius: f64) -> [f64; 4] {
    [x - radius, y - radius, x + radius, y + radius]
}

/// Whether the gap between two areas is below `gap`.
fn meet(a: &[f64; 4], b: &[f64; 4], gap: f64) -> bool {
    a[0] < b[2] + gap && b[0] < a[2] + gap && a[1] < b[3] + gap && b[1] < a[3] + gap
}
