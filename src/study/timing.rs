//! Times methods side by side.
//!
//! All methods answer the cases of one workload. Each round shuffles the cases, so that the processor cannot learn
//! their branches, and the methods, so that other work on the machine slows all of them alike. Methods take turns over
//! so few cases that the first-level cache holds them: memory is not timed. The time of an empty call is subtracted.
//! The result is the median over the rounds, with the quartiles.
//!
//! The methods also answer the same few cases over and over in one order, which the processor does learn. The
//! difference between both times is the cost of mispredicted branches.

use super::{fma::has_fma, random::Random, step::Case};
use std::{env::consts::ARCH, fs, hint::black_box, sync::OnceLock, time::Instant};

/// The processor's name, or its architecture where the system names none; and whether it has fused multiply-adds.
pub fn processor() -> &'static str {
    static NAME: OnceLock<String> = OnceLock::new();
    NAME.get_or_init(|| {
        let known = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
        let line = known.lines().find(|line| line.starts_with("model name"));
        let name = line.and_then(|line| Some(line.split_once(':')?.1.trim().to_owned()));
        let name = name.unwrap_or_else(|| format!("a processor of {ARCH}"));
        format!("{name} {} FMA", if has_fma() { "with" } else { "without" })
    })
}

/// How long a method takes for one case of a workload, in nanoseconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Time {
    /// The median over the rounds, where the processor cannot learn the branches.
    pub ns: f64,
    /// The first and the third quartile.
    pub quartiles: [f64; 2],
    /// The median over the rounds, where the processor has learnt the branches.
    pub learnt: f64,
}

/// The number of cases that are repeated: so few that the processor learns their branches.
const FEW: usize = 32;
/// The size of the cases that methods take turns over. The first-level cache must hold twice as much: the cases, and
/// the clones that are made to bring them there.
const CACHED_BYTES: usize = 16 << 10;
/// Shorter times are lost in the time of the loop itself.
const LEAST_NS: f64 = 0.1;

/// Times each method of a step over the same cases, in the registry's order; `None` for a method that cannot run here.
/// A method that answers for a whole picture at once is timed by [`Case::whole_picture`].
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
    // The first round warms up caches and clocks; its times do not count.
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

/// The time to answer all cases, one after the other, `turns` times.
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
    super::statistics::quantile(values, share).max(LEAST_NS)
}
