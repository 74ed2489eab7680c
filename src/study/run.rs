//! Runs the study: every method of every step over every workload, compared with the truth and timed.

use super::{
    methods::{Visitor, each_step, registry},
    prelude::*,
    statistics::{interval, quantile, rate},
    timing::{self, Time},
};
use crate::geometry::shares::on_all_cores;
use std::iter;

/// What a method did at one value of one family's parameter.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Row {
    /// The method.
    pub info: MethodInfo,
    /// The family.
    pub family: &'static str,
    /// Its parameter.
    pub parameter: &'static str,
    /// The parameter's value.
    pub value: f64,
    /// How many cases.
    pub cases: usize,
    /// Hits that it missed.
    pub missed: usize,
    /// Misses that it called hits.
    pub phantoms: usize,
    /// Hits on something else than the nearest.
    pub others: usize,
    /// How many of the missed and the phantoms are ties: the ray passes exactly through an edge or an outline.
    pub ties: usize,
    /// How far the worst wrong decision was off, in the step's unit.
    pub worst_wrong: f64,
    /// The values' median error, where the decision was right.
    pub median_error: f64,
    /// The error that one value of a thousand exceeds.
    pub p999_error: f64,
    /// The values' worst error, where the decision was right.
    pub worst_error: f64,
    /// For Sightline's method: the largest ratio of an error to its bound; at most 1 when the bound holds.
    pub of_bound: Option<f64>,
    /// The largest of these bounds.
    pub bound: Option<f64>,
    /// Its time for one of these cases, where it was timed.
    pub time: Option<Time>,
}

impl Row {
    /// How many decisions were wrong.
    pub fn wrong(&self) -> usize {
        self.missed + self.phantoms + self.others
    }

    /// How far off its worst answer is, in the step's unit: a wrong decision, of which ties are 0 off, where the step
    /// decides; else a value.
    pub fn off_by(&self) -> f64 {
        if self.info.step.wrong_unit.is_empty() {
            self.worst_error
        } else {
            self.worst_wrong
        }
    }

    /// The share of wrong decisions in per cent.
    pub fn wrong_percent(&self) -> f64 {
        100.0 * rate(self.wrong(), self.cases)
    }

    /// The ends of that share's 95 % interval, in per cent.
    pub fn wrong_percent_within(&self) -> [f64; 2] {
        interval(self.wrong(), self.cases).map(|share| 100.0 * share)
    }
}

/// Everything that was found.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// In the order of step, family, value and method.
    pub rows: Vec<Row>,
}

/// The name of the family that a scene's own rays form.
pub const SCENE: &str = "this scene";

/// Runs the study. `progress` gets the share that is done, from 0 to 1, and the name of the current step.
pub fn run(effort: Effort, progress: &(dyn Fn(f64, &str) + Sync)) -> Report {
    let mut run = Run {
        effort,
        progress,
        steps: registry().chunk_by(|a, b| a.step == b.step).count(),
        done: 0,
        report: Report::default(),
    };
    each_step(&mut run);
    run.report
}

struct Run<'a> {
    effort: Effort,
    progress: &'a (dyn Fn(f64, &str) + Sync),
    /// How many steps there are, and how many are done: for the progress.
    steps: usize,
    done: usize,
    report: Report,
}

/// Cases at one value of a parameter.
struct Workload<'a, C> {
    family: &'static str,
    parameter: &'static str,
    value: f64,
    /// Makes at most the given number of its cases, always the same ones first.
    make: Box<dyn Fn(usize) -> Vec<C> + Sync + 'a>,
}

impl Visitor for Run<'_> {
    fn visit<C: Case>(&mut self) {
        let workloads = all_workloads::<C>(self.effort);
        let mut rows = self.judged(&workloads);
        if self.effort.rounds > 0 {
            for (work, rows) in workloads.iter().zip(&mut rows) {
                self.timed(work, rows);
            }
        }
        self.report.rows.extend(rows.into_iter().flatten());
        self.done += 1;
    }
}

impl Run<'_> {
    /// Every method's answers to every workload of a step, on all cores.
    fn judged<C: Case>(&self, workloads: &[Workload<'_, C>]) -> Vec<Vec<Row>> {
        on_all_cores(0..workloads.len(), |index| {
            let done = rate(self.done, 1) + rate(index, workloads.len());
            (self.progress)(done / rate(self.steps, 1), C::ABOUT.name);
            judge(&workloads[index])
        })
    }

    /// Times the methods on the first [`TIMED`](Case::TIMED) of a workload's cases, and sets its rows' times.
    fn timed<C: Case>(&self, work: &Workload<'_, C>, rows: &mut [Row]) {
        let rounds = self.effort.rounds.min(C::MOST_ROUNDS);
        let cases = (work.make)(C::TIMED);
        let mut random = Random::named(self.effort.seed, &[C::ABOUT.key, work.family, "timing"]);
        let times = timing::time(cases, rounds, &mut random);
        for (method, time) in C::methods().zip(times) {
            let mut own = rows.iter_mut();
            if let Some(row) = own.find(|row| row.info == method.info) {
                row.time = time;
            }
        }
    }
}

/// Every family's workloads.
fn all_workloads<'a, C: Case>(effort: Effort) -> Vec<Workload<'a, C>> {
    let at = |family: &'static Family<C>, value: f64| Workload {
        family: family.name,
        parameter: family.parameter,
        value,
        make: Box::new(move |most| {
            let names = [C::ABOUT.key, family.name, &value.to_string()];
            let mut random = Random::named(effort.seed, &names);
            let cases = 0..C::count(effort).min(most);
            cases.map(|_| (family.make)(&mut random, value)).collect()
        }),
    };
    let families = C::FAMILIES.iter();
    let all = families.flat_map(|family| family.values.iter().map(|value| at(family, *value)));
    all.collect()
}

/// The rows that [`run`] has for one family of a step, untimed, and those of a scene's own rays as the family
/// [`SCENE`]. `go_on` is asked before each workload; `None` once it says no.
pub fn family<C: Case>(
    name: &str,
    effort: Effort,
    scene: Option<&SceneRays>,
    go_on: &dyn Fn() -> bool,
) -> Option<Vec<Row>> {
    let own = scene.map(|scene| Workload {
        family: SCENE,
        parameter: "-",
        value: 1.0,
        make: Box::new(move |_| C::of_scene(scene)),
    });
    let general = all_workloads::<C>(effort).into_iter();
    let general = general.filter(|work| work.family == name);
    let rows = (general.chain(own)).map(|work| go_on().then(|| judge(&work)));
    Some(rows.collect::<Option<Vec<_>>>()?.concat())
}

/// A row for each method's answers to the cases of one workload.
fn judge<C: Case>(work: &Workload<'_, C>) -> Vec<Row> {
    let cases = (work.make)(usize::MAX);
    let truths: Vec<C::Truth> = cases.iter().map(C::truth).collect();
    let can_run = |method: &&Method<C>| cases.first().is_some_and(|case| case.can_run(method));
    let methods = C::methods().filter(can_run);
    let rows = methods.map(|method| {
        let bound = method.info.ours.then_some(0.0);
        let mut row = Row {
            info: method.info,
            family: work.family,
            parameter: work.parameter,
            value: work.value,
            cases: cases.len(),
            of_bound: bound,
            bound,
            ..Row::default()
        };
        let mut errors = Vec::with_capacity(cases.len());
        for (case, truth) in iter::zip(&cases, &truths) {
            let verdict = case.judge(truth, &(method.run)(case));
            let bound = case.bound(truth);
            let share = match verdict {
                Verdict::Agreed => 0.0,
                Verdict::Right(error) => {
                    errors.push(error);
                    share(error, bound)
                }
                Verdict::Missed(wrong) | Verdict::Phantom(wrong) => {
                    let is_missed = matches!(verdict, Verdict::Missed(_));
                    row.missed += usize::from(is_missed);
                    row.phantoms += usize::from(!is_missed);
                    let is_tie = wrong == 0.0 && !row.info.step.wrong_unit.is_empty();
                    row.ties += usize::from(is_tie);
                    row.worst_wrong = row.worst_wrong.max(wrong);
                    share(wrong, 0.0)
                }
                Verdict::Other => {
                    row.others += 1;
                    0.0
                }
            };
            row.of_bound = row.of_bound.map(|most| most.max(share));
            row.bound = row.bound.map(|most| most.max(bound));
        }
        errors.sort_by(f64::total_cmp);
        [row.median_error, row.p999_error, row.worst_error] =
            [0.5, 0.999, 1.0].map(|share| quantile(&errors, share));
        row
    });
    rows.collect()
}

/// The ratio of an error to its bound. Infinite where both are infinite, because an infinite bound bounds nothing.
fn share(found: f64, bound: f64) -> f64 {
    let share = if found == 0.0 { 0.0 } else { found / bound };
    if share.is_nan() { f64::INFINITY } else { share }
}
