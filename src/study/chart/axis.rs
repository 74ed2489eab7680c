//! Scales, with places beside them for none, for ties and for what fails; and the frame that two of them make.

use super::{
    measure::Measure,
    picture::{Anchor, Colour, FAINT, INK, Picture, QUIET},
};
use plotters::coord::{ranged1d::Ranged, types::RangedCoordf64};

/// A scale from values to pixels.
#[derive(Clone, Copy, Debug)]
pub struct Axis {
    /// Of a value: its logarithm, or itself.
    scale: fn(f64) -> f64,
    /// What that is at both ends of the scale proper.
    range: [f64; 2],
    /// Pixels at both ends of the scale proper.
    ends: [f64; 2],
    /// Where 0 is drawn, beyond the first end.
    none: Option<f64>,
    /// Where ties are, between 0 and the first end.
    ties: Option<f64>,
    /// Where what fails is drawn, beyond the last end.
    fails: Option<f64>,
}

/// How far beyond the scale such places lie, in pixels.
const BEYOND: f64 = 22.0;

impl Axis {
    /// A logarithmic scale that holds all values, between two pixel positions, in whole powers of ten. Places for 0, for
    /// [ties](Measure::TIE) and for what is infinite are kept where there are such values.
    pub fn new(values: &[f64], ends: [f64; 2]) -> Self {
        let finite = || {
            let scaled = |v: &&f64| v.is_finite() && **v > Measure::TIE;
            values.iter().filter(scaled).map(|v| v.log10())
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
        let ties = values.contains(&Measure::TIE).then(|| {
            from += direction * BEYOND;
            from - direction * 0.8 * BEYOND
        });
        let fails = values.iter().any(|v| v.is_infinite()).then(|| {
            to -= direction * 1.6 * BEYOND;
            to + direction * BEYOND
        });
        Self {
            none,
            ties,
            fails,
            ..Self::between(f64::log10, [low, high], [from, to])
        }
    }

    /// A scale of its own: `range` is what `scale` makes of the values at both ends.
    pub fn between(scale: fn(f64) -> f64, range: [f64; 2], ends: [f64; 2]) -> Self {
        Self {
            scale,
            range,
            ends,
            none: None,
            ties: None,
            fails: None,
        }
    }

    /// From 0 to a value in equal steps.
    pub fn linear(most: f64, ends: [f64; 2]) -> Self {
        Self::between(|value| value, [0.0, most], ends)
    }

    /// The same scale from the other end.
    pub fn reversed(self) -> Self {
        let [a, b] = self.ends;
        Self {
            ends: [b, a],
            ..self
        }
    }

    /// The pixel positions between which the scale proper lies.
    pub fn ends(&self) -> [f64; 2] {
        self.ends
    }

    /// The pixel position of a value.
    pub fn at(&self, value: f64) -> f64 {
        let [low, high] = self.range;
        let share = ((self.scale)(value) - low) / (high - low);
        let on_scale = self.ends[0] + share.clamp(0.0, 1.0) * (self.ends[1] - self.ends[0]);
        let beside = match value {
            0.0 => self.none,
            Measure::TIE => self.ties,
            f64::INFINITY => self.fails,
            _ => None,
        };
        beside.unwrap_or(on_scale)
    }

    /// Values and words at which the axis is marked, at most about so many: powers of ten; where there are few of them, twos
    /// and fives too.
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
            ticks.extend(between.filter(|v| (low..=high).contains(&v.log10())));
        }
        ticks.into_iter().map(|v| (v, word(v))).collect()
    }
}

/// A tick's.
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

/// Behind what is never wrong.
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

    /// Where a pair of values is drawn.
    pub fn at(&self, x: f64, y: f64) -> [f64; 2] {
        [self.x.at(x), self.y.at(y)]
    }

    /// Grid, ticks, frame and words: a title above, the axes' names with their units, and the word for 0. An axis without a name
    /// has no numbers either.
    pub fn draw(
        &self,
        picture: &mut Picture,
        title: &str,
        [x_name, y_name]: [&str; 2],
        none: &str,
    ) {
        let [left, top] = self.from;
        let [right, bottom] = self.to;
        if let Some(y) = self.y.none {
            picture.rectangle([left, y - 0.5 * BEYOND], self.to, NEVER);
        }
        if let Some(y) = self.y.fails {
            picture.rectangle([left, top], [right, y + 0.5 * BEYOND], [0xfb, 0xeb, 0xe2]);
        }
        for (value, _) in self.y.ticks(5) {
            let y = self.y.at(value);
            picture.line(vec![[left, y], [right, y]], FAINT, 1, false);
        }
        if !y_name.is_empty() {
            let beside = [
                (self.y.none, none),
                (self.y.ties, "ties"),
                (self.y.fails, "fails"),
            ];
            let beside = beside.map(|(y, word)| y.map(|y| (y, word.to_owned())));
            let ticks = self.y.ticks(5).into_iter();
            let ticks = ticks.map(|(value, word)| (self.y.at(value), word));
            for (y, word) in ticks.chain(beside.into_iter().flatten()) {
                picture.text([left - 6.0, y], Anchor::Right, TICK, QUIET, word);
            }
        }
        let ticks = (!x_name.is_empty()).then(|| self.x.ticks(6));
        for (value, word) in ticks.into_iter().flatten() {
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
