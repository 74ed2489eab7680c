//! Logarithmic axes, with a place below for 0 and one above for what fails.

use super::picture::{Anchor, FAINT, INK, Mark, Picture, QUIET};

/// A logarithmic scale from pixels to values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// Powers of ten at both ends of the scale proper.
    decades: [i32; 2],
    /// Pixels at both ends of the scale proper.
    ends: [f64; 2],
    /// Where 0 is drawn, beyond the first end.
    zero: Option<f64>,
    /// Where what fails is drawn, beyond the last end.
    fails: Option<f64>,
}

/// How far beyond the scale 0 and failures are drawn, in pixels.
const BEYOND: f64 = 22.0;

impl Axis {
    /// A scale that holds all values, between two pixel positions. Places for 0 and for what is infinite are kept
    /// where there are such values. `least` is the least power of ten that is told apart: what is less counts as that.
    #[must_use]
    pub fn new(values: &[f64], ends: [f64; 2], least: i32) -> Self {
        let finite = || values.iter().copied().filter(|v| v.is_finite() && *v > 0.0);
        #[expect(clippy::cast_possible_truncation, reason = "exponents of f64")]
        let decade = |v: f64, to: fn(f64) -> f64| to(v.log10()) as i32;
        let low = finite()
            .map(|v| decade(v * 1.000_001, f64::floor))
            .min()
            .unwrap_or(0)
            .max(least);
        let high = finite()
            .map(|v| decade(v * 0.999_999, f64::ceil))
            .max()
            .unwrap_or(1)
            .max(low + 1);
        let direction = (ends[1] - ends[0]).signum();
        let [mut from, mut to] = ends;
        let zero = values.contains(&0.0).then(|| {
            from += direction * 1.6 * BEYOND;
            from - direction * BEYOND
        });
        let fails = values.iter().any(|v| v.is_infinite()).then(|| {
            to -= direction * 1.6 * BEYOND;
            to + direction * BEYOND
        });
        Self {
            decades: [low, high],
            ends: [from, to],
            zero,
            fails,
        }
    }

    /// The same scale from the other end.
    #[must_use]
    pub fn reversed(self) -> Self {
        let [a, b] = self.ends;
        Self {
            ends: [b, a],
            ..self
        }
    }

    /// The power of ten at its lower end.
    fn least(&self) -> f64 {
        10_f64.powi(self.decades[0])
    }

    /// The pixel position of a value.
    #[must_use]
    pub fn at(&self, value: f64) -> f64 {
        if value == 0.0 {
            return self.zero.unwrap_or(self.ends[0]);
        }
        if value.is_infinite() {
            return self.fails.unwrap_or(self.ends[1]);
        }
        let [low, high] = self.decades.map(f64::from);
        let share = ((value.log10() - low) / (high - low)).clamp(0.0, 1.0);
        self.ends[0] + share * (self.ends[1] - self.ends[0])
    }

    /// Values and words at which the axis is marked: powers of ten, at most about so many; where there are few
    /// decades, twos and fives too.
    fn ticks(&self, most: i32) -> Vec<(f64, String)> {
        let [low, high] = self.decades;
        let step = ((high - low + most - 1) / most).max(1);
        let power = |exponent: i32| 10_f64.powi(exponent);
        let decades = (low..=high).filter(|exponent| (exponent - low) % step == 0);
        let mut ticks: Vec<f64> = decades.map(power).collect();
        if high - low <= 2 {
            ticks.extend((low..high).flat_map(|e| [2.0 * power(e), 5.0 * power(e)]));
        }
        let word = |value: f64| {
            let plain = (-2..=3).contains(&exponent_of(value));
            if plain {
                format!("{}", (value * 1e3).round() / 1e3)
            } else {
                format!("{value:.0e}")
            }
        };
        ticks
            .into_iter()
            .map(|value| (value, word(value)))
            .collect()
    }
}

fn exponent_of(value: f64) -> i32 {
    #[expect(clippy::cast_possible_truncation, reason = "exponents of f64")]
    let exponent = (value * 1.000_001).log10().floor() as i32;
    exponent
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

/// What is written about a panel.
#[derive(Clone, Copy, Debug)]
pub struct Labels<'a> {
    /// Above it.
    pub title: &'a str,
    /// Under the horizontal axis, with its unit.
    pub x: &'a str,
    /// Whether that is marked with numbers.
    pub has_x_ticks: bool,
    /// Beside the vertical axis, with its unit.
    pub y: &'a str,
    /// At the place of 0.
    pub zero: &'a str,
    /// At the least value that is told apart, where that stands for something else.
    pub least: Option<&'a str>,
}

/// Size of tick labels.
const TICK: f64 = 14.0;

impl Panel {
    /// A panel in a frame that holds all values.
    #[must_use]
    pub fn new(from: [f64; 2], to: [f64; 2], xs: &[f64], ys: &[f64], least_y: i32) -> Self {
        let x = Axis::new(xs, [from[0] + 10.0, to[0] - 10.0], -30);
        let y = Axis::new(ys, [to[1] - 6.0, from[1] + 8.0], least_y);
        Self { x, y, from, to }
    }

    /// Where a pair of values is drawn.
    #[must_use]
    pub fn at(&self, x: f64, y: f64) -> [f64; 2] {
        [self.x.at(x), self.y.at(y)]
    }

    /// Grid, ticks, frame and words.
    pub fn draw(&self, picture: &mut Picture, labels: &Labels<'_>) {
        let [left, top] = self.from;
        let [right, bottom] = self.to;
        for (value, word) in self.y.ticks(5) {
            let y = self.y.at(value);
            picture.line(vec![[left, y], [right, y]], FAINT, 1, false);
            let least = labels.least.filter(|_| value <= 1.000_001 * self.y.least());
            let word = least.map_or(word, str::to_owned);
            picture.text([left - 6.0, y], Anchor::Right, TICK, QUIET, word);
        }
        if let Some(y) = self.y.zero {
            picture.rectangle(
                [left, y - 0.5 * BEYOND],
                [right, bottom],
                [0xe8, 0xf5, 0xee],
            );
            picture.text([left - 6.0, y], Anchor::Right, TICK, QUIET, labels.zero);
        }
        if let Some(y) = self.y.fails {
            picture.rectangle([left, top], [right, y + 0.5 * BEYOND], [0xfb, 0xeb, 0xe2]);
            picture.text([left - 6.0, y], Anchor::Right, TICK, QUIET, "fails");
        }
        let ticks = if labels.has_x_ticks {
            self.x.ticks(6)
        } else {
            Vec::new()
        };
        for (value, word) in ticks {
            let x = self.x.at(value);
            picture.line(vec![[x, top], [x, bottom]], FAINT, 1, false);
            picture.text([x, bottom + 12.0], Anchor::Middle, TICK, QUIET, word);
        }
        let frame = vec![[left, top], [left, bottom], [right, bottom]];
        picture.line(frame, INK, 1, false);
        let middle = 0.5 * (left + right);
        picture.text(
            [left - 40.0, top - 20.0],
            Anchor::Left,
            18.0,
            INK,
            labels.title,
        );
        picture.text([middle, bottom + 31.0], Anchor::Middle, 15.0, INK, labels.x);
        picture.marks.push(Mark::Text {
            at: [left - 58.0, 0.5 * (top + bottom)],
            anchor: Anchor::Middle,
            size: 15.0,
            colour: INK,
            upwards: true,
            text: labels.y.to_owned(),
        });
    }
}
