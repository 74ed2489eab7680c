//! Axes: linear or of powers of ten, with room for 0.

use crate::study::statistics::rate;
use plotters::coord::{
    ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter},
    types::RangedCoordf64,
};
use std::ops::Range;

/// An axis, as a coordinate of `plotters`.
#[derive(Clone, Debug)]
pub struct Axis {
    /// What its values are, with their unit.
    pub name: String,
    is_log: bool,
    /// Scaled.
    ends: [f64; 2],
    /// Values, each with its words.
    ticks: Vec<(f64, String)>,
    /// Where 0 and infinity stand, scaled.
    none: Option<f64>,
    all: Option<f64>,
}

impl Axis {
    /// A logarithmic axis over all values above 0 that are finite.
    pub fn powers_of_ten(name: impl Into<String>, values: impl IntoIterator<Item = f64>) -> Self {
        let is_on = |value: &f64| value.is_finite() && *value > 0.0;
        let values = values.into_iter().filter(is_on).map(libm::log10);
        let values: Vec<f64> = values.collect();
        let low = values.iter().copied().reduce(f64::min).unwrap_or(0.0);
        let high = values.iter().copied().reduce(f64::max).unwrap_or(1.0);
        Self::between(name, [low, high.max(low + 0.3)])
    }

    /// A logarithmic axis between two powers of ten.
    pub fn between(name: impl Into<String>, ends: [f64; 2]) -> Self {
        let decades = (ends[1] - ends[0]).max(1.0);
        #[expect(clippy::cast_possible_truncation, reason = "exponents of f64")]
        let (first, last) = (ends[0].floor() as i32, ends[1].ceil() as i32);
        // A tick at every power, every second or third, or at 1, 2 and 5 of each.
        let every = match decades {
            ..5.0 => 1,
            ..9.0 => 2,
            _ => 3,
        };
        let within: &[f64] = if decades < 2.0 {
            &[1.0, 2.0, 5.0]
        } else {
            &[1.0]
        };
        let powers = (first..=last).filter(|power| power.rem_euclid(every) == 0);
        let values = powers.flat_map(|power| within.iter().map(move |by| by * 10_f64.powi(power)));
        let ticks = values.map(|value| (value, number(value)));
        let span = ends[0] - 1e-9..=ends[1] + 1e-9;
        let is_within = |(value, _): &(f64, String)| span.contains(&libm::log10(*value));
        Self {
            name: name.into(),
            is_log: true,
            ends,
            ticks: ticks.filter(is_within).collect(),
            none: None,
            all: None,
        }
    }

    /// A linear axis from 0 to `most`, with a tick at each `step`.
    pub fn linear(name: impl Into<String>, most: f64, step: f64) -> Self {
        let ticks = (0..=20_u8).map(|i| f64::from(i) * step);
        let ticks = ticks.filter(|value| *value <= most * (1.0 + 1e-9));
        Self {
            name: name.into(),
            is_log: false,
            ends: [0.0, most],
            ticks: ticks.map(|value| (value, number(value))).collect(),
            none: None,
            all: None,
        }
    }

    /// With room before the first end, as a share of the axis and after a gap: 0 stands there, under these words.
    pub fn with_none(mut self, share: f64, words: &str) -> Self {
        const GAP: f64 = 0.03;
        let length = (self.ends[1] - self.ends[0]) / (1.0 - share - GAP);
        self.ends[0] -= (share + GAP) * length;
        let none = self.ends[0] + 0.5 * share * length;
        self.ticks.push((0.0, words.to_owned()));
        self.none = Some(none);
        self
    }

    /// With room after the last end: infinity stands there, under these words.
    pub fn with_all(mut self, share: f64, words: &str) -> Self {
        let room = (self.ends[1] - self.ends[0]) * share / (1.0 - share);
        self.all = Some(self.ends[1] + 0.5 * room);
        self.ends[1] += room;
        self.ticks.push((f64::INFINITY, words.to_owned()));
        self
    }

    /// With room at both ends, in powers of ten.
    pub fn wider(self, by: [f64; 2]) -> Self {
        Self::between(self.name, [self.ends[0] - by[0], self.ends[1] + by[1]])
    }

    /// The axis of so many rows of 0, beside whatever else it has.
    pub fn with_rows(self, rows: usize, words: &str) -> Self {
        self.with_none((0.045 * rate(rows, 1)).clamp(0.03, 0.6), words)
    }

    /// The harmless end first, where values go down.
    pub fn turned(mut self, is_turned: bool) -> Self {
        if is_turned {
            self.ends.reverse();
        }
        self
    }

    fn scaled(&self, value: f64) -> f64 {
        match (value, self.none, self.all) {
            (0.0, Some(none), _) => none,
            (f64::INFINITY, _, Some(all)) => all,
            _ if self.is_log => libm::log10(value),
            _ => value,
        }
    }
}

/// A value beyond an end stands at that end.
impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        let [a, b] = self.ends;
        let scaled = self.scaled(*value).clamp(a.min(b), a.max(b));
        RangedCoordf64::from(a..b).map(&scaled, limit)
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        let ticks = self.ticks.iter().map(|(value, _)| *value);
        let ticks = ticks.filter(|_| !hint.weight().allow_light_points());
        ticks.collect()
    }

    fn range(&self) -> Range<f64> {
        f64::NEG_INFINITY..f64::INFINITY
    }
}

impl ValueFormatter<f64> for Axis {
    fn format_ext(&self, value: &f64) -> String {
        let is_at = |(tick, _): &&(f64, String)| tick.total_cmp(value).is_eq();
        let tick = self.ticks.iter().find(is_at);
        tick.map_or_else(String::new, |(_, words)| words.clone())
    }
}

/// A tick's words.
fn number(value: f64) -> String {
    if value == 0.0 || (0.0099..1001.0).contains(&value) {
        format!("{}", (value * 1e6).round() / 1e6)
    } else {
        format!("{value:.0e}")
    }
}
