//! What is studied: the steps of a pick, and for each the methods, workloads, truth and verdict.

use super::{random::Random, run::Effort, scene_rays::SceneRays};

/// What a method's arithmetic is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Precision {
    /// 24 bits.
    F32,
    /// 53 bits.
    F64,
    /// `f64`, with exact arithmetic where that is not certain.
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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MethodInfo {
    /// The step that it does.
    pub step: About,
    /// Author, paper or what courses and engines call it; with the precision unique within its step.
    pub name: &'static str,
    /// What it computes with.
    pub precision: Precision,
    /// Where it is from.
    pub source: &'static str,
    /// Whether it is what the rest of this program does.
    pub ours: bool,
    /// Where something else is faster and no more often wrong: what the difference buys.
    pub reason: Option<&'static str>,
}

impl MethodInfo {
    /// What tells methods of a step apart.
    #[must_use]
    pub fn key(&self) -> (&'static str, Precision) {
        (self.name, self.precision)
    }
}

/// One way to do a step. Adding one to the study is one of these in its step's list.
#[derive(Clone, Copy)]
pub struct Method<C: Case> {
    /// What is known about it.
    pub info: MethodInfo,
    /// Does it. Whatever a program would have at hand by then is part of the case.
    pub run: fn(&C) -> C::Answer,
}

impl<C: Case> Method<C> {
    /// A method of others.
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
            reason: None,
        };
        Self { info, run }
    }

    /// The method that the rest of this program uses.
    pub(super) const fn ours(
        precision: Precision,
        source: &'static str,
        run: fn(&C) -> C::Answer,
    ) -> Self {
        let mut method = Self::new("Sightline's", precision, source, run);
        method.info.ours = true;
        method
    }

    /// The same by a longer name.
    pub(super) const fn named(mut self, name: &'static str) -> Self {
        self.info.name = name;
        self
    }

    /// The same, with what it buys.
    pub(super) const fn because(mut self, reason: &'static str) -> Self {
        self.info.reason = Some(reason);
        self
    }
}

/// A step's methods: each in both precisions, or alone.
pub type Methods<C> = &'static [&'static [Method<C>]];

/// A formula in both precisions: its answer from a case's `narrow`, and from its `wide`.
macro_rules! both {
    ($name:expr, $source:expr, $formula:expr $(, $more:expr)*) => {
        [
            Method::new($name, F32, $source, |case: &Self| $formula(&case.narrow $(, $more)*)),
            Method::new($name, F64, $source, |case: &Self| $formula(&case.wide $(, $more)*)),
        ]
    };
}
pub(super) use both;

/// A family as a line of a table: name, parameter, its values, and what makes a case.
macro_rules! family {
    ($name:literal, $parameter:literal $values:tt => $make:expr) => {
        Family::new($name, $parameter, &$values, $make)
    };
}
pub(super) use family;

/// A workload with one parameter that stresses something, from harmless to absurd.
#[derive(Clone, Copy)]
pub struct Family<C> {
    /// What is stressed.
    pub name: &'static str,
    /// The parameter, with its unit where it has one.
    pub parameter: &'static str,
    /// Its values, harmless first.
    pub values: &'static [f64],
    /// A case at a value of the parameter. Its numbers are `f32`s, but for a camera's axes and what they make, so that
    /// methods of both precisions get the same.
    pub make: fn(&mut Random, f64) -> C,
}

impl<C> Family<C> {
    /// A family.
    pub(super) const fn new(
        name: &'static str,
        parameter: &'static str,
        values: &'static [f64],
        make: fn(&mut Random, f64) -> C,
    ) -> Self {
        Self {
            name,
            parameter,
            values,
            make,
        }
    }

    /// What is there mostly: a step's first family, by which it is timed.
    pub(super) const fn ordinary(make: fn(&mut Random, f64) -> C) -> Self {
        Self::new("ordinary", "-", &[1.0], make)
    }
}

impl<C: Case<Truth = Option<f64>>> Family<C> {
    /// The ordinary one's cases, of which such a share hits: speed is swept over it.
    pub(super) const HIT_RATE: Self = Self::new(
        "hit rate",
        "share of hits",
        &[0.0, 0.25, 0.5, 0.75, 1.0],
        |random, rate| {
            let hits = random.unit() < rate;
            loop {
                let case = (C::FAMILIES[0].make)(random, 1.0);
                if case.truth().is_some() == hits {
                    return case;
                }
            }
        },
    );
}

/// What was found about one answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// The decision is right, and this is the value's error, in the step's unit.
    Right(f64),
    /// The decision is right, and there is no value.
    Agreed,
    /// Nothing was hit where something is, this far from where that would be right.
    Missed(f64),
    /// Something was hit where nothing is, this far from where that would be right.
    Phantom(f64),
    /// Another thing was hit than the nearest.
    Other,
}

/// Names and units of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct About {
    /// What the step does.
    pub name: &'static str,
    /// One word for file names and CSV.
    pub key: &'static str,
    /// The job that every method does: what it is given, and what it answers.
    pub job: &'static str,
    /// What a value's error is measured in.
    pub error_unit: &'static str,
    /// What the distance of a wrong decision is measured in; empty for steps that decide nothing.
    pub wrong_unit: &'static str,
}

/// A step's names, the units of its values' errors and of wrong decisions, and its job.
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
    /// What methods answer.
    type Answer;
    /// What is so.
    type Truth;
    /// Names and units.
    const ABOUT: About;
    /// Whether an answer takes so long that fewer cases have to do.
    const SLOW: bool = false;
    /// How many cases of a workload are timed; 0 for steps that only act out what hardware does.
    const TIMED: usize = if Self::SLOW { 24 } else { 512 };
    /// How many cases of a workload are judged.
    #[must_use]
    fn count(effort: Effort) -> usize {
        effort.cases
    }
    /// Every method, the reference that times are relative to first.
    const METHODS: Methods<Self>;
    /// Every workload, the ordinary one first.
    const FAMILIES: &'static [Family<Self>];

    /// Every method, in order.
    #[must_use]
    fn methods() -> impl Iterator<Item = &'static Method<Self>> {
        Self::METHODS.iter().copied().flatten()
    }
    /// The cases that a scene's own rays make; none where it has nothing for this step.
    #[must_use]
    fn of_scene(_: &SceneRays) -> Vec<Self> {
        Vec::new()
    }
    /// Whether a method can be run here at all.
    fn can_run(&self, _: &Method<Self>) -> bool {
        true
    }
    /// How long a method takes that answers for a whole picture at a time, in nanoseconds.
    #[must_use]
    fn whole_picture(_: &[Self], _: &Method<Self>) -> Option<f64> {
        None
    }
    /// What is so, by exact arithmetic.
    fn truth(&self) -> Self::Truth;
    /// Holds an answer against the truth.
    fn judge(&self, truth: &Self::Truth, answer: &Self::Answer) -> Verdict;
    /// An upper bound of the error of this program's own method, with its derivation; 0 where nothing rounds. Its decisions
    /// are always right.
    fn bound(&self, _: &Self::Truth) -> f64 {
        0.0
    }
}
