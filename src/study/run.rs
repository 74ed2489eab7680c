//! Runs the study: every method of every step over every workload, held against truth and timed.

use super::{
    methods::{Visitor, each_step},
    random::Random,
    step::{About, Bound, Case, Family, Precision, Verdict},
    timing::{self, Time},
    workloads::scene::SceneRays,
};
use std::{
    num::NonZero,
    sync::{
        Mutex,
        atomic::{AtomicUsize, Ordering},
    },
    thread,
};

/// How much is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Cases at each value of each family's parameter.
    pub cases: usize,
    /// Whole picks at each value: truth looks at every triangle.
    pub picks: usize,
    /// Rounds of timing; 0 for none.
    pub rounds: usize,
    /// Where random numbers start: the same seed gives the same verdicts on every machine.
    pub seed: u64,
}

impl Effort {
    /// Within seconds.
    pub const QUICK: Self = Self {
        cases: 500,
        picks: 200,
        rounds: 11,
        seed: 1,
    };
    /// A scene's own rays only.
    pub const SCENE_ONLY: Self = Self {
        cases: 0,
        picks: 0,
        rounds: 11,
        seed: 1,
    };
    /// Within minutes.
    pub const FULL: Self = Self {
        cases: 8000,
        picks: 4000,
        rounds: 41,
        seed: 1,
    };
}

/// What a method did at one value of one family's parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// The step.
    pub step: About,
    /// The method.
    pub method: &'static str,
    /// Its precision.
    pub precision: Precision,
    /// Whether it is what this program does.
    pub ours: bool,
    /// The family.
    pub family: &'static str,
    /// Its parameter.
    pub parameter: &'static str,
    /// The parameter's value.
    pub value: f64,
    /// How many cases.
    pub cases: usize,
    /// Hits that it did not find.
    pub missed: usize,
    /// Hits that are none.
    pub phantoms: usize,
    /// Hits on something else than the nearest.
    pub others: usize,
    /// How far the worst wrong decision was off, in the step's unit.
    pub worst_wrong: f64,
    /// The values' middle error, where the decision was right.
    pub median_error: f64,
    /// The values' worst error, where the decision was right.
    pub worst_error: f64,
    /// For this program's method: the largest share of its bound that a case took up; at most 1 when the bound holds.
    pub of_bound: Option<f64>,
    /// The largest of these bounds.
    pub bound: Option<Bound>,
}

impl Row {
    /// How many decisions were wrong, in per cent.
    #[must_use]
    pub fn wrong_percent(&self) -> f64 {
        let wrong = self.missed + self.phantoms + self.others;
        #[expect(clippy::cast_precision_loss, reason = "few cases")]
        let percent = 100.0 * wrong as f64 / self.cases.max(1) as f64;
        percent
    }
}

/// Everything that was found.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// Accuracy: by step, family, value, method.
    pub rows: Vec<Row>,
    /// Speed, by step and method; none where nothing was timed.
    pub times: Vec<Time>,
    /// Whether a scene's own rays, the family [`SCENE`], are among the rows.
    pub has_scene: bool,
}

/// The family that a scene's own rays make.
pub const SCENE: &str = "this scene";

/// Runs it. `progress` is told how much of the whole is done, from 0 to 1, and of which step.
#[must_use]
pub fn run(
    effort: Effort,
    scene: Option<&SceneRays>,
    progress: &(dyn Fn(f64, &str) + Sync),
) -> Report {
    let mut run = Run {
        effort,
        scene,
        progress,
        steps: 0,
        done: 0,
        report: Report {
            has_scene: scene.is_some(),
            ..Report::default()
        },
    };
    let mut count = Count(0);
    each_step(&mut count);
    run.steps = count.0;
    each_step(&mut run);
    run.report
}

/// Counts steps.
struct Count(u32);

impl Visitor for Count {
    fn visit<C: Case>(&mut self) {
        self.0 += 1;
    }
}

struct Run<'a> {
    effort: Effort,
    scene: Option<&'a SceneRays>,
    progress: &'a (dyn Fn(f64, &str) + Sync),
    /// How many steps there are, and how many are done: for the progress.
    steps: u32,
    done: u32,
    report: Report,
}

/// Cases at one value of a parameter.
struct Workload<'a, C> {
    family: &'static str,
    parameter: &'static str,
    value: f64,
    make: Box<dyn Fn() -> Vec<C> + Sync + 'a>,
}

impl Visitor for Run<'_> {
    fn visit<C: Case>(&mut self) {
        let rows = self.judged::<C>();
        self.report.rows.extend(rows);
        if self.effort.rounds > 0 {
            let times = timing::time(&self.timed_cases::<C>(), self.effort.rounds);
            self.report.times.extend(times);
        }
        self.done += 1;
    }
}

impl Run<'_> {
    /// Every method's answers to every workload of a step, on all cores.
    fn judged<C: Case>(&self) -> Vec<Row> {
        let workloads = self.workloads::<C>();
        let next = AtomicUsize::new(0);
        let found = Mutex::new(Vec::new());
        let work = || {
            while let index = next.fetch_add(1, Ordering::Relaxed)
                && let Some(work) = workloads.get(index)
            {
                #[expect(clippy::cast_precision_loss, reason = "few workloads")]
                let share = index as f64 / workloads.len() as f64;
                (self.progress)(
                    (f64::from(self.done) + share) / f64::from(self.steps),
                    C::ABOUT.name,
                );
                let rows = judge(work, &(work.make)());
                // The lock is only ever lost to a panic, which ends the scope anyway.
                if let Ok(mut found) = found.lock() {
                    found.push((index, rows));
                }
            }
        };
        let threads = thread::available_parallelism().map_or(1, NonZero::get);
        thread::scope(|scope| {
            for _ in 0..threads {
                scope.spawn(work);
            }
        });
        let mut found = found.into_inner().unwrap_or_default();
        found.sort_by_key(|(index, _)| *index);
        found.into_iter().flat_map(|(_, rows)| rows).collect()
    }

    fn workloads<C: Case>(&self) -> Vec<Workload<'_, C>> {
        let families = C::FAMILIES.iter();
        let mut all: Vec<Workload<'_, C>> = families
            .flat_map(|family| workloads(family, self.effort))
            .collect();
        all.extend(self.scene.map(|scene| Workload {
            family: SCENE,
            parameter: "-",
            value: 1.0,
            make: Box::new(|| C::of_scene(scene)),
        }));
        all
    }

    /// The scene's own cases where there are some, else the first family's.
    fn timed_cases<C: Case>(&self) -> Vec<C> {
        let mut own = self.scene.map(C::of_scene).unwrap_or_default();
        if !own.is_empty() {
            own.truncate(C::TIMED);
            return own;
        }
        let mut random = Random::named(self.effort.seed, &[C::ABOUT.key, "timing"]);
        let Family { values, make, .. } = &C::FAMILIES[0];
        let cases = (0..C::TIMED).map(|_| make(&mut random, values[0]));
        cases.collect()
    }
}

/// The workloads of a family, one for each value of its parameter.
fn workloads<C: Case>(
    family: &'static Family<C>,
    effort: Effort,
) -> impl Iterator<Item = Workload<'static, C>> {
    let Effort {
        cases, picks, seed, ..
    } = effort;
    let count = if C::SLOW { picks } else { cases };
    family.values.iter().map(move |&value| Workload {
        family: family.name,
        parameter: family.parameter,
        value,
        make: Box::new(move || {
            let names = [C::ABOUT.key, family.name, &value.to_string()];
            let mut random = Random::named(seed, &names);
            (0..count)
                .map(|_| (family.make)(&mut random, value))
                .collect()
        }),
    })
}

/// What every method of a step does in the family of this name: the rows that [`run`] has for it.
#[must_use]
pub fn family<C: Case>(name: &str, effort: Effort) -> Vec<Row> {
    let named = C::FAMILIES.iter().filter(|family| family.name == name);
    named
        .flat_map(|family| workloads(family, effort))
        .flat_map(|work| judge(&work, &(work.make)()))
        .collect()
}

/// Every method's answers to the cases of one workload.
fn judge<C: Case>(work: &Workload<'_, C>, cases: &[C]) -> Vec<Row> {
    let truths: Vec<C::Truth> = cases.iter().map(C::truth).collect();
    let methods = C::METHODS
        .iter()
        .filter(|method| cases.first().is_some_and(|case| case.can_run(method)));
    methods
        .map(|method| {
            let mut row = Row {
                step: C::ABOUT,
                method: method.name,
                precision: method.precision,
                ours: method.ours,
                family: work.family,
                parameter: work.parameter,
                value: work.value,
                cases: cases.len(),
                missed: 0,
                phantoms: 0,
                others: 0,
                worst_wrong: 0.0,
                median_error: 0.0,
                worst_error: 0.0,
                of_bound: method.ours.then_some(0.0),
                bound: method.ours.then_some(Bound::NONE),
            };
            let mut errors = Vec::with_capacity(cases.len());
            for (case, truth) in cases.iter().zip(&truths) {
                let verdict = case.judge(truth, &(method.run)(case));
                let bound = case.bound(truth);
                let share = match verdict {
                    Verdict::Agreed => 0.0,
                    Verdict::Right(error) => {
                        errors.push(error);
                        share(error, bound.error)
                    }
                    Verdict::Missed(wrong) => {
                        row.missed += 1;
                        row.worst_wrong = row.worst_wrong.max(wrong);
                        share(wrong, bound.wrong)
                    }
                    Verdict::Phantom(wrong) => {
                        row.phantoms += 1;
                        row.worst_wrong = row.worst_wrong.max(wrong);
                        share(wrong, bound.wrong)
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
            row.median_error = errors.get(errors.len() / 2).copied().unwrap_or(0.0);
            row.worst_error = errors.last().copied().unwrap_or(0.0);
            row
        })
        .collect()
}

/// Infinite where both are: that is no bound.
fn share(found: f64, bound: f64) -> f64 {
    let share = if found == 0.0 { 0.0 } else { found / bound };
    if share.is_nan() { f64::INFINITY } else { share }
}
