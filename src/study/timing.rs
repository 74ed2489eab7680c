//! How long methods take, side by side.
//!
//! All methods answer the same cases, in one order that is too long and too random for the processor to learn. They
//! take turns, round by round, so that whatever else the machine does falls on all of them alike; what is reported is
//! the median over the rounds, and the median over the rounds of the ratio to the step's first method.

use super::step::{About, Case, Method, Precision};
use std::{hint::black_box, time::Instant};

/// How long a method takes for one case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Time {
    /// The step.
    pub step: About,
    /// The method.
    pub method: &'static str,
    /// Its precision.
    pub precision: Precision,
    /// Nanoseconds.
    pub ns: f64,
    /// Relative to the step's first method.
    pub ratio: f64,
}

/// Times every method of a step over the same cases. What answers for a whole picture at a time is timed
/// by that.
#[must_use]
pub fn time<C: Case>(cases: &[C], rounds: usize) -> Vec<Time> {
    let Some(first) = cases.first() else {
        return Vec::new();
    };
    let (pictures, methods): (Vec<_>, Vec<_>) = C::METHODS
        .iter()
        .filter(|method| first.can_run(method))
        .map(|method| (C::whole_picture(cases, method), method))
        .partition(|(whole, _)| whole.is_some());
    let methods: Vec<_> = methods.into_iter().map(|(_, method)| method).collect();
    if methods.is_empty() {
        return Vec::new();
    }
    #[expect(clippy::cast_precision_loss, reason = "few cases")]
    let per_case = 1e9 / cases.len() as f64;
    let mut samples = vec![Vec::with_capacity(rounds); methods.len()];
    // One round more, whose times do not count: caches and clocks warm up.
    for round in 0..=rounds {
        for turn in 0..methods.len() {
            let index = (turn + round) % methods.len();
            let run = methods[index].run;
            let start = Instant::now();
            for case in cases {
                black_box(run(black_box(case)));
            }
            let ns = start.elapsed().as_secs_f64() * per_case;
            if round > 0 {
                samples[index].push(ns);
            }
        }
    }
    let reference = samples[0].clone();
    let time = |method: &Method<C>, ns: f64, ratio: f64| Time {
        step: C::ABOUT,
        method: method.name,
        precision: method.precision,
        ns,
        ratio,
    };
    let pictures = pictures.into_iter().filter_map(|(whole, method)| {
        let ns = whole?;
        Some(time(method, ns, ns / median(reference.clone())))
    });
    let times = methods.iter().zip(&samples).map(|(method, samples)| {
        let ratios = samples.iter().zip(&reference).map(|(ns, first)| ns / first);
        time(method, median(samples.clone()), median(ratios.collect()))
    });
    times.chain(pictures).collect()
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}
