//! What a step of a pick consists of: its cases, methods, workloads, truth and verdicts.

use super::{effort::Effort, random::Random, scene_rays::SceneRays};

/// The arithmetic that a method uses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Precision {
    /// 24 bits.
    #[default]
    F32,
    /// 53 bits.
    F64,
    /// `f64`, with exact arithmetic where `f64` is not certain.
    Exact,
}

impl std::fmt::Display for Precision {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
            Self::Exact => "exact",
        })
    }
}

/// What is known about a method without running it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MethodInfo {
    /// Its step.
    pub step: About,
    /// Author, paper, or the name in courses and engines; unique within the step together with the precision.
    pub name: &'static str,
    /// Its arithmetic.
    pub precision: Precision,
    /// Paper, program or course.
    pub source: &'static str,
    /// Whether Sightline picks by this method.
    pub ours: bool,
}

impl MethodInfo {
    /// Name and precision: unique within a step.
    pub fn key(&self) -> (&'static str, Precision) {
        (self.name, self.precision)
    }
}

/// One way to do a step: an entry of the step's list.
#[derive(Clone, Copy)]
pub struct Method<C: Case> {
    /// What is known about it.
    pub info: MethodInfo,
    /// Answers a case. What a program has computed beforehand is part of the case.
    pub run: fn(&C) -> C::Answer,
}

impl<C: Case> Method<C> {
    /// A method that Sightline does not use.
    pub(super) const fn new(
        name: &'static str,
        precision: Precision,
        source: &'static str,
        run: fn(&C) -> C::Answer,
    ) -> Self {
        let info = MethodInfo {
            step: C::ABOUT,
            name,
            precision,
            source,
            ours: false,
        };
        Self { info, run }
    }

    /// The method that Sightline picks by.
    pub(super) const fn ours(
        precision: Precision,
        source: &'static str,
        run: fn(&C) -> C::Answer,
    ) -> Self {
        let mut method = Self::new("Sightline's", precision, source, run);
        method.info.ours = true;
        method
    }

    /// The same under another name.
    pub(super) const fn named(mut self, name: &'static str) -> Self {
        self.info.name = name;
        self
    }
}

/// A step's methods, in groups: a formula in both precisions, or single methods.
pub type Methods<C> = &'static [&'static [Method<C>]];

/// A formula in both precisions, by name and source: applied to a case's `narrow`, and to its `wide`.
macro_rules! both {
    ($name:literal: $source:expr, $formula:expr $(, $more:expr)*) => {
        [
            Method::new($name, F32, $source, |case: &Self| $formula(&case.narrow $(, $more)*)),
            Method::new($name, F64, $source, |case: &Self| $formula(&case.wide $(, $more)*)),
        ]
    };
}
pub(super) use both;

/// A family as one line: name, parameter, its values, and the function that makes a case.
macro_rules! family {
    ($name:expr, $parameter:literal $values:tt => $make:expr) => {
        Family {
            name: $name,
            parameter: $parameter,
            values: &$values,
            make: $make,
        }
    };
}
pub(super) use family;

/// The name of the families that show how speed depends on the share of hits, and of rays at edges.
pub const HIT_RATE: &str = "hit rate";
/// See [`HIT_RATE`].
pub const AT_EDGES: &str = "rays at edges";

/// Workloads that differ in one parameter, from harmless to absurd.
#[derive(Clone, Copy)]
pub struct Family<C> {
    /// What the parameter stresses.
    pub name: &'static str,
    /// The parameter, with its unit if it has one.
    pub parameter: &'static str,
    /// Its values, harmless first.
    pub values: &'static [f64],
    /// Makes a case at a value of the parameter. Its numbers fit in `f32`, so that methods of both precisions get the
    /// same; only a camera's axes, what is computed from them, and rays that are named so do not.
    pub make: fn(&mut Random, f64) -> C,
}

impl<C> Family<C> {
    /// Ordinary cases: a step's first family. Methods are compared by their times on it.
    pub(super) const fn ordinary(make: fn(&mut Random, f64) -> C) -> Self {
        family!("ordinary", "-" [1.0] => make)
    }

    /// Cases of which a given share are *f64 rays* at edges or outlines: they show what a decision costs that `f64`
    /// can't make.
    pub(super) const fn at_edges(make: fn(&mut Random, f64) -> C) -> Self {
        family!(AT_EDGES, "share of rays at edges" [0.0, 0.01, 0.1, 0.25, 0.5, 0.75, 1.0] => make)
    }
}

impl<C: Case<Truth = Option<f64>>> Family<C> {
    /// Ordinary cases of which a given share hits. They show how speed depends on the share of hits.
    pub(super) const HIT_RATE: Self = family!(HIT_RATE, "share of hits" [0.0, 0.25, 0.5, 0.75, 1.0] => |random, rate| {
        let hits = random.unit() < rate;
        loop {
            let case = (C::FAMILIES[0].make)(random, 1.0);
            if case.truth().is_some() == hits {
                return case;
            }
        }
    });
}

/// How an answer compares with the truth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// The decision is right; the value has this error, in the step's unit.
    Right(f64),
    /// The decision is right, and there is no value.
    Agreed,
    /// A hit was missed. A ray that passes this far aside really misses.
    Missed(f64),
    /// A miss was called a hit. A ray that passes this far aside really hits.
    Phantom(f64),
    /// Something else than the nearest was hit.
    Other,
}

/// Names and units of a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct About {
    /// What the step does.
    pub name: &'static str,
    /// One word for file names and CSV.
    pub key: &'static str,
    /// What every method is given, and what it answers.
    pub job: &'static str,
    /// The unit of a value's error.
    pub error_unit: &'static str,
    /// The unit of how far off a wrong decision is; empty for steps that decide nothing.
    pub wrong_unit: &'static str,
}

/// A step's name and key, the units of its values' errors and of its wrong decisions, and its job.
macro_rules! about {
    ($name:literal $key:literal, off by $error:literal, wrong by $wrong:literal; $job:literal) => {
        About {
            name: $name,
            key: $key,
            job: $job,
            error_unit: $error,
            wrong_unit: $wrong,
        }
    };
}
pub(super) use about;

/// One question to the methods of a step, with all that they need to answer it.
pub trait Case: Sized + Clone + Sync + Send + 'static {
    /// A method's answer.
    type Answer;
    /// The right answer.
    type Truth;
    /// Names and units.
    const ABOUT: About;
    /// How many cases of a workload are timed; 0 for steps that simulate hardware.
    const TIMED: usize = 512;
    /// The most rounds that are timed.
    const MOST_ROUNDS: usize = usize::MAX;
    /// How many cases of a workload are judged.
    fn count(effort: Effort) -> usize {
        effort.cases
    }
    /// Every method; times are relative to the first one's.
    const METHODS: Methods<Self>;
    /// Every workload, the ordinary one first.
    const FAMILIES: &'static [Family<Self>];

    /// Every method, in order.
    fn methods() -> impl Iterator<Item = &'static Method<Self>> {
        Self::METHODS.iter().copied().flatten()
    }
    /// The cases from a scene's own rays; none where the scene has nothing for this step.
    fn of_scene(_: &SceneRays) -> Vec<Self> {
        Vec::new()
    }
    /// Whether a method can run on this machine.
    fn can_run(&self, _: &Method<Self>) -> bool {
        true
    }
    /// The time of a method that answers for a whole picture at once, in nanoseconds; `None` for all other methods.
    fn whole_picture(_: &[Self], _: &Method<Self>) -> Option<f64> {
        None
    }
    /// The right answer, by exact arithmetic.
    fn truth(&self) -> Self::Truth;
    /// Compares an answer with the truth.
    fn judge(&self, truth: &Self::Truth, answer: &Self::Answer) -> Verdict;
    /// An upper bound of the error of Sightline's method; 0 where nothing rounds. Each step derives its own. The
    /// method's decisions are always right.
    fn bound(&self, _: &Self::Truth) -> f64 {
        0.0
    }
}
