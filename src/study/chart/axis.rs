//! Axes, with places beside the scale for 0, for ties and for infinite values. Also panels: frames with two axes.

use super::{picture::FAINT, prelude::*};
use plotters::coord::{ranged1d::Ranged, types::RangedCoordf64};

/// A map from values to pixels.
#[derive(Clone, Copy, Debug)]
pub struct Axis {
    /// The logarithm, or the identity.
    scale: fn(f64) -> f64,
    /// The scaled values at both ends.
    range: [f64; 2],
    /// The pixel positions of both ends of the scale.
    pub ends: [f64; 2],
    /// The pixel positions beside the scale: of 0, before the first end; of ties, between 0 and the first end; of
    /// infinite values, beyond the last end.
    beside: [Option<f64>; 3],
}

/// The approximate distance between the scale and the places beside it, in pixels.
const BEYOND: f64 = 22.0;

impl Axis {
    /// A logarithmic axis between two pixel positions that holds all values, with whole powers of ten at its ends. It
    /// has places for 0, for [ties](Figure::TIE) and for infinity where such values occur.
    pub fn new(values: &[f64], ends: [f64; 2]) -> Self {
        let finite = || {
            let scaled = |v: &&f64| v.is_finite() && **v > Figure::TIE;
            values.iter().filter(scaled).map(|v| libm::log10(*v))
        };
        let low = finite().map(|e| (e + 1e-6).floor()).reduce(f64::min);
        let low = low.unwrap_or(0.0);
        let high = finite().map(|e| (e - 1e-6).ceil()).reduce(f64::max);
        let high = high.unwrap_or(low + 1.0).max(low + 1.0);
        let direction = (ends[1] - ends[0]).signum();
        let [mut from, mut to] = ends;
        let none = values.contains(&0.0).then(|| {
            from += direction * 1.6 * BEYOND;
            from - direction * BEYOND
        });
        let ties = values.contains(&Figure::TIE).then(|| {
            from += direction * BEYOND;
            from - direction * 0.8 * BEYOND
        });
        let fails = values.iter().any(|v| v.is_infinite()).then(|| {
            to -= direction * 1.6 * BEYOND;
            to + direction * BEYOND
        });
        let scale = Self::between(libm::log10, [low, high], [from, to]);
        let beside = [none, ties, fails];
        Self { beside, ..scale }
    }

    /// An axis with a scale; `range` are the scaled values at both ends.
    pub fn between(scale: fn(f64) -> f64, range: [f64; 2], ends: [f64; 2]) -> Self {
        Self {
            scale,
            range,
            ends,
            beside: [None; 3],
        }
    }

    /// A linear axis from 0 to `most`.
    pub fn linear(most: f64, ends: [f64; 2]) -> Self {
        Self::between(|value| value, [0.0, most], ends)
    }

    /// The pixel position of a value.
    pub fn at(&self, value: f64) -> f64 {
        let [low, high] = self.range;
        let share = ((self.scale)(value) - low) / (high - low);
        let on_scale = self.ends[0] + share.clamp(0.0, 1.0) * (self.ends[1] - self.ends[0]);
        let [none, ties, fails] = self.beside;
        let beside = match value {
            0.0 => none,
            Figure::TIE => ties,
            f64::INFINITY => fails,
            _ => None,
        };
        beside.unwrap_or(on_scale)
    }

    /// The ticks, at most about `most`, each with its label: powers of ten; where these are few, twos and fives as
    /// well.
    fn ticks(&self, most: usize) -> Vec<(f64, String)> {
        let [low, high] = self.range;
        if (self.scale)(1.0) != 0.0 {
            let steps = RangedCoordf64::from(low..high).key_points(most);
            return steps.into_iter().map(|v| (v, word(v))).collect();
        }
        #[expect(clippy::cast_possible_truncation, reason = "exponents of f64")]
        let (first, last) = ((low - 1e-9).ceil() as i32, (high + 1e-9).floor() as i32);
        let step = usize::try_from(last - first).unwrap_or(0) / most + 1;
        let decades = (first..=last).step_by(step).map(|e| 10_f64.powi(e));
        let mut ticks: Vec<f64> = decades.collect();
        if high - low <= 2.0 {
            let between = (first - 1..=last).flat_map(|e| [2.0, 5.0].map(|f| f * 10_f64.powi(e)));
            ticks.extend(between.filter(|v| (low..=high).contains(&libm::log10(*v))));
        }
        ticks.into_iter().map(|v| (v, word(v))).collect()
    }
}

/// A tick's label.
fn word(value: f64) -> String {
    if value == 0.0 || (0.000_999..20_000.0).contains(&value) {
        format!("{}", (value * 1e6).round() / 1e6)
    } else {
        format!("{value:.0e}")
    }
}

/// A frame with two axes.
#[derive(Clone, Copy, Debug)]
pub struct Panel {
    /// From the left.
    pub x: Axis,
    /// From below.
    pub y: Axis,
    /// Top left corner of the frame.
    pub from: [f64; 2],
    /// Bottom right corner of the frame.
    pub to: [f64; 2],
}

/// The background of methods that are never wrong.
pub const NEVER: Colour = [0xe8, 0xf5, 0xee];
/// Size of tick labels.
const TICK: f64 = 14.0;

impl Panel {
    /// A panel in a frame that holds all values.
    pub fn new(from: [f64; 2], to: [f64; 2], xs: &[f64], ys: &[f64]) -> Self {
        let x = Axis::new(xs, [from[0] + 10.0, to[0] - 10.0]);
        let y = Axis::new(ys, [to[1] - 6.0, from[1] + 8.0]);
        Self { x, y, from, to }
    }

    /// The pixel position of a pair of values.
    pub fn at(&self, x: f64, y: f64) -> [f64; 2] {
        [self.x.at(x), self.y.at(y)]
    }

    /// Draws grid, ticks and frame, a title above, the axes' names with their units, and `none` at 0. If y has no name,
    /// it has no numbers.
    pub fn draw(
        &self,
        picture: &mut Picture,
        title: &str,
        [x_name, y_name]: [&str; 2],
        none: &str,
    ) {
        let [left, top] = self.from;
        let [right, bottom] = self.to;
        let [at_none, at_ties, at_fails] = self.y.beside;
        if let Some(y) = at_none {
            picture.rectangle([left, y - 0.5 * BEYOND], self.to, NEVER);
        }
        if let Some(y) = at_fails {
            picture.rectangle([left, top], [right, y + 0.5 * BEYOND], [0xfb, 0xeb, 0xe2]);
        }
        for (value, _) in self.y.ticks(5) {
            let y = self.y.at(value);
            picture.line(vec![[left, y], [right, y]], FAINT, 1, false);
        }
        if !y_name.is_empty() {
            let ticks = self.y.ticks(5).into_iter();
            let ticks = ticks.map(|(value, word)| (Some(self.y.at(value)), word));
            let beside = [(at_none, none), (at_ties, "ties"), (at_fails, "fails")];
            for (y, word) in ticks.chain(beside.map(|(y, word)| (y, word.to_owned()))) {
                let Some(y) = y else { continue };
                picture.text([left - 6.0, y], Anchor::Right, TICK, QUIET, word);
            }
        }
        for (value, word) in self.x.ticks(6) {
            let x = self.x.at(value);
            picture.line(vec![[x, top], [x, bottom]], FAINT, 1, false);
            picture.text([x, bottom + 12.0], Anchor::Middle, TICK, QUIET, word);
        }
        let frame = vec![[left, top], [left, bottom], [right, bottom]];
        picture.line(frame, INK, 1, false);
        let middle = [0.5 * (left + right), 0.5 * (top + bottom)];
        picture.text([left - 40.0, top - 20.0], Anchor::Left, 18.0, INK, title);
        let below = [middle[0], bottom + 31.0];
        picture.text(below, Anchor::Middle, 15.0, INK, x_name);
        picture.text_upwards([left - 58.0, middle[1]], 15.0, INK, y_name);
    }
}
