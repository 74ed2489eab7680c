//! What many positions showed: mistakes, and counts that keep agreement from being vacuous.

use super::{
    compare::{FEW_ROUNDINGS, same_place},
    program::Answer,
};
use crate::exact::{line::Line, number::Dyadic, root::Parameter, truth::Hit};
use std::collections::BTreeMap;

/// Only exact arithmetic tells apart two different parameters closer than this, relatively.
const HAIR: f64 = 1e-15;

/// What a number of positions showed.
#[derive(Debug, Default)]
pub struct Tally {
    pub positions: usize,
    /// Positions where there is something.
    pub hits: usize,
    /// Positions where the first two hits are at one `t`, exactly.
    pub ties: usize,
    /// Positions where the first hit is on an edge, a rim or a silhouette, exactly.
    pub borders: usize,
    /// Positions where something lies exactly on the near or the far plane.
    pub planes: usize,
    /// Positions where a section cuts away what would be hit first.
    pub cut: usize,
    /// Positions where something lies exactly on the section's plane.
    pub on_section: usize,
    /// Positions where two hits, or a hit and near or far, differ by less than [`HAIR`].
    pub hairs: usize,
    /// Pairs of positions, one step of `f64` apart, with two answers.
    pub steps: usize,
    /// Positions with a hit that a tree found, asked by all instructions.
    pub walks: usize,
    /// Positions that were asked from a narrowed scene.
    pub narrowed: usize,
    /// Whole pictures that were cast.
    pub pictures: usize,
    /// Pixels of these that show a triangle.
    pub together: usize,
    /// Positions with a wrong answer.
    pub wrong: usize,
    /// Positions with a wrong answer once trees are built, or narrowed.
    pub wrong_with_trees: usize,
    /// The largest relative error of `t`, less what coordinates round by.
    pub worst_t: f64,
    /// Kinds of mistakes, how often each was made, and where first.
    pub kinds: BTreeMap<&'static str, (usize, String)>,
}

impl Tally {
    /// Each kind of mistake, how often, and the first one.
    pub fn mistakes(&self) -> String {
        let kinds = self.kinds.values();
        let lines = kinds.map(|(count, example)| format!("{count} times {example}"));
        lines.collect::<Vec<_>>().join("\n")
    }

    pub fn row(&self) -> String {
        format!(
            "positions {:7}  hits {:7}  ties {:6}  borders {:6}  planes {:6}  cut {:6}  on section {:6}  hairs {:6}  steps {:6}  walks {:6}  narrowed {:6}  together {:7}  worst t {:8.1e}  wrong {:6}  with trees {:6}",
            self.positions,
            self.hits,
            self.ties,
            self.borders,
            self.planes,
            self.cut,
            self.on_section,
            self.hairs,
            self.steps,
            self.walks,
            self.narrowed,
            self.together,
            self.worst_t,
            self.wrong,
            self.wrong_with_trees
        )
    }

    /// Adds what was found wrong at a position that has been counted already.
    pub fn with_trees(&mut self, again: Self) {
        self.wrong_with_trees += again.wrong;
        for (kind, (count, example)) in again.kinds {
            let entry = self.kinds.entry(kind).or_insert((0, example));
            entry.0 += count;
        }
    }

    /// How far parameters are off.
    pub fn measure(&mut self, line: &Line, all: &[Answer], truth: &[Hit]) {
        for (answer, hit) in all.iter().zip(truth) {
            let t = hit.t.rounded();
            let besides = FEW_ROUNDINGS * line.reach(&hit.t);
            let error = ((answer.t - t).abs() - besides) / t.abs();
            if error.is_finite() && same_place(answer, hit) && answer.front == hit.front {
                self.worst_t = self.worst_t.max(error);
            }
        }
    }

    /// One more position: its hits, and those of the whole line.
    pub fn count(&mut self, line: &Line, truth: &[Hit], everywhere: &[Hit]) {
        self.positions += 1;
        let ends = [&line.near, &line.far].map(|end| Parameter::fraction(end, &Dyadic::whole(1)));
        let is_hair = |a: &Parameter, b: &Parameter| {
            let gap = b.rounded_minus(a).abs();
            gap > 0.0 && gap <= HAIR * b.rounded().abs()
        };
        let at_end = everywhere
            .iter()
            .any(|hit| ends.iter().any(|end| is_hair(end, &hit.t)));
        let apart = |[a, b]: &[Hit; 2]| is_hair(&a.t, &b.t);
        self.hairs += usize::from(at_end || truth.array_windows().any(apart));
        let on_end = |hit: &Hit| ends.iter().any(|end| hit.t.compare(end).is_eq());
        self.planes += usize::from(everywhere.iter().any(on_end));
        if line.section.is_some() {
            let in_range = |hit: &&Hit| {
                hit.t.compare_to(&line.near).is_ge() && hit.t.compare_to(&line.far).is_lt()
            };
            let mut seen = everywhere.iter().filter(in_range);
            let is_before = |hit: &Hit| {
                let first = truth.first();
                first.is_none_or(|first| hit.t.compare(&first.t).is_lt())
            };
            let is_cut = |hit: &Hit| line.side(&hit.t).is_lt() && is_before(hit);
            self.cut += usize::from(seen.any(is_cut));
            let is_on = |hit: &Hit| line.side(&hit.t).is_eq();
            self.on_section += usize::from(everywhere.iter().any(is_on));
        }
        let Some(first) = truth.first() else { return };
        self.hits += 1;
        self.borders += usize::from(first.on_border);
        let second = truth.get(1);
        self.ties += usize::from(second.is_some_and(|hit| hit.t.compare(&first.t).is_eq()));
    }
}
