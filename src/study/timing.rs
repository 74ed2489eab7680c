//! How long methods take, side by side.
//!
//! All methods answer the cases of one workload. In each round the cases are put into a new order, so that the processor
//! cannot learn their branches, and the methods too, so that whatever else the machine does falls on all of them alike. They
//! take turns over so few cases at a time that the first-level cache holds them: memory is not what is timed. The time of a
//! call that does nothing is taken off. What is reported is the median over the rounds, with the quartiles.
//!
//! Beside that the same few cases are answered over and over in one order, which the processor does learn: the difference is
//! what wrongly predicted branches cost.

use super::{random::Random, step::Case};
use std::{env::consts::ARCH, fs, hint::black_box, sync::OnceLock, time::Instant};

/// What the processor is called, where the system says so; times mean nothing without.
pub fn processor() -> &'static str {
    static NAME: OnceLock<String> = OnceLock::new();
    NAME.get_or_init(|| {
        let known = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
        let line = known.lines().find(|line| line.starts_with("model name"));
        let name = line.and_then(|line| Some(line.split_once(':')?.1.trim().to_owned()));
        name.unwrap_or_else(|| format!("a processor of {ARCH}"))
    })
}

/// How long a method takes for one case of a workload, in nanoseconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Time {
    /// The median over the rounds, in an order that cannot be learnt.
    pub ns: f64,
    /// The first and the third quartile.
    pub quartiles: [f64; 2],
    /// The median where the processor has learnt the branches.
    pub learnt: f64,
}

/// Cases that the processor learns.
const FEW: usize = 32;
/// What the first-level cache holds twice, as a copy of the cases brings them there.
const CACHED_BYTES: usize = 16 << 10;
/// Less than this hides behind what the loop does.
const LEAST_NS: f64 = 0.1;

/// Times each method of a step over the same cases, in the registry's order; `None` for what cannot be run. What answers for
/// a whole picture at a time is timed by that.
pub fn time<C: Case>(mut cases: Vec<C>, rounds: usize, random: &mut Random) -> Vec<Option<Time>> {
    let methods: Vec<_> = C::methods().collect();
    let mut times = vec![None; methods.len()];
    let Some(first) = cases.first() else {
        return times;
    };
    let mut order = Vec::new();
    for (index, method) in methods.iter().enumerate() {
        if let Some(ns) = C::whole_picture(&cases, method) {
            times[index] = Some(Time {
                ns,
                quartiles: [ns; 2],
                learnt: ns,
            });
        } else if first.can_run(method) {
            order.push(index);
        }
    }
    let mut few = cases.clone();
    few.truncate(FEW);
    let turns = cases.len() / few.len();
    let at_once = (CACHED_BYTES / size_of::<C>()).max(1);
    let mut samples = vec![[const { Vec::new() }; 2]; methods.len()];
    // One round more, whose times do not count: caches and clocks warm up.
    for round in 0..=rounds {
        random.shuffle(&mut cases);
        random.shuffle(&mut order);
        let mut taken = vec![[0.0; 2]; methods.len()];
        for cases in cases.chunks(at_once) {
            seconds(cases, 1, C::clone);
            let nothing = seconds(cases, 1, nothing);
            for &index in &order {
                taken[index][0] += seconds(cases, 1, methods[index].run) - nothing;
            }
        }
        let nothing = seconds(&few, turns, nothing);
        for &index in &order {
            taken[index][1] = seconds(&few, turns, methods[index].run) - nothing;
        }
        if round > 0 {
            for &index in &order {
                samples[index][0].push(ns_each(taken[index][0], cases.len()));
                samples[index][1].push(ns_each(taken[index][1], turns * few.len()));
            }
        }
    }
    for index in order {
        let [new, learnt] = &mut samples[index];
        times[index] = Some(Time {
            ns: quantile(new, 0.5),
            quartiles: [quantile(new, 0.25), quantile(new, 0.75)],
            learnt: quantile(learnt, 0.5),
        });
    }
    times
}

fn nothing<C>(_: &C) {}

/// How long it takes to answer all cases so many times, one after the other.
#[inline(never)]
fn seconds<C, A>(cases: &[C], turns: usize, run: fn(&C) -> A) -> f64 {
    let run = black_box(run);
    let start = Instant::now();
    for _ in 0..turns {
        for case in cases {
            black_box(run(black_box(case)));
        }
    }
    start.elapsed().as_secs_f64()
}

fn ns_each(seconds: f64, count: usize) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "few cases")]
    let count = count as f64;
    1e9 * seconds / count
}

fn quantile(values: &mut [f64], share: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    super::summary::quantile(values, share).max(LEAST_NS)
}
