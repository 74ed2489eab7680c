//! One position: the program's answer beside the true one.

use super::{
    program::{self, Answer},
    tally::Tally,
};
use crate::exact::{
    line::Line,
    root::Parameter,
    truth::{Hit, World},
};
use glam::{DVec2, DVec3};
use sightline::{
    camera::View,
    geometry::Ray,
    pick::Pick,
    scene::{Object, Scene},
};
use std::fmt::Write;

/// The relative error allowed for `t`: half of the digits, as in `geometry`. The rounding of the coordinates that it
/// was found with is added.
const T_RELATIVE: f64 = 1.0 / 67_108_864.0;
/// Additional relative error allowed for a number computed from `t` and stored numbers in a few steps.
pub const FEW_ROUNDINGS: f64 = 16.0 * f64::EPSILON;
/// The error allowed for a corner's weight: a quarter of the least step of a colour between corners.
const WEIGHT: f64 = 1.0 / 1024.0;

/// A scene through a view, with the oracle's truth about it.
pub struct Case<'a> {
    pub scene: &'a Scene,
    pub view: &'a View,
    pub world: &'a World,
}

impl Case<'_> {
    pub fn truth(&self, px: DVec2) -> Vec<Hit> {
        self.world.hits(&Line::of(self.view, px), self.view.sides)
    }

    /// Compares `closest` and `all`, and records if asked to.
    pub fn check(&self, px: DVec2, with_records: bool, tally: &mut Tally) -> Vec<Pick> {
        let line = Line::of(self.view, px);
        let truth = self.world.hits(&line, self.view.sides);
        let mut mistakes = Mistakes::default();
        let all = program::all(self.scene, self.view, px);
        let closest = program::closest(self.scene, self.view, px);
        mistakes.of_answers(&line, &all, closest.as_ref(), &truth);
        let mut records = Vec::new();
        if with_records {
            records = program::records(self.scene, self.view, px);
            let first = program::record(self.scene, self.view, px);
            if first.as_ref() != records.first() {
                mistakes.add("pick is not the first of all", format!("{first:?}"));
            }
            if records.len() == truth.len() {
                for (i, record) in records.iter().enumerate() {
                    mistakes.of_record(self, &line, &truth, i, record);
                }
            } else {
                mistakes.add(
                    "records: count",
                    format!("{} of {}", records.len(), truth.len()),
                );
            }
        }
        tally.count(&line, &truth, &self.world.line_hits(&line));
        tally.measure(&line, &all, &truth);
        self.report(&self.place(px), &truth, mistakes, tally);
        records
    }

    /// Compares all answers along a given ray.
    pub fn check_ray(&self, ray: &Ray, tally: &mut Tally) {
        let line = Line::given(ray);
        let truth = self.world.hits(&line, self.view.sides);
        let (all, closest) = program::along(self.scene, ray, self.view.sides);
        let mut mistakes = Mistakes::default();
        mistakes.of_answers(&line, &all, closest.as_ref(), &truth);
        tally.count(&line, &truth, &self.world.line_hits(&line));
        tally.measure(&line, &all, &truth);
        self.report(&format!("along {ray:?}"), &truth, mistakes, tally);
    }

    /// Compares whole pictures, of which these are the pixels.
    pub fn check_pictures(&self, pixels: &[DVec2], tally: &mut Tally) {
        let pictures = program::pictures(self.scene, self.view);
        for (i, &px) in pixels.iter().enumerate() {
            let truth = self.truth(px);
            let expected = truth.first().map_or((0, 0), |hit| {
                let first = program::first_triangle(&self.scene.objects()[hit.object].shape);
                let triangle = hit.triangle.map_or(0, |triangle| triangle - first + 1);
                (u32::try_from(hit.object + 1).expect("few"), triangle)
            });
            let mut mistakes = Mistakes::default();
            for (who, picture) in ["ids", "raycast"].into_iter().zip(&pictures) {
                if picture[i] != expected {
                    mistakes.add("picture", format!("{who} has {:?}", picture[i]));
                }
            }
            let mut again = Tally::default();
            self.report(&self.place(px), &truth, mistakes, &mut again);
            tally.with_trees(again);
        }
    }

    fn place(&self, px: DVec2) -> String {
        format!("at {px:?} of {:?}", self.view)
    }

    /// Compares again with trees, and records against those from `before`: they must be equal.
    pub fn recheck(&self, px: DVec2, before: Option<Vec<Pick>>, tally: &mut Tally) {
        let mut again = Tally::default();
        let records = self.check(px, before.is_some(), &mut again);
        let mut mistakes = Mistakes::default();
        if let Some(before) = before
            && before != records
        {
            let differ = before
                .iter()
                .zip(&records)
                .find(|(before, now)| before != now);
            mistakes.add("another record with a tree", format!("{differ:?}"));
        }
        if again.wrong == 0 {
            self.report(&self.place(px), &self.truth(px), mistakes, &mut again);
        }
        tally.with_trees(again);
    }

    /// How many pairs of neighbouring positions have different answers.
    pub fn steps(&self, positions: &[DVec2]) -> usize {
        let pairs = positions.as_chunks::<2>().0.iter();
        pairs
            .filter(|[a, b]| self.surfaces(*a) != self.surfaces(*b))
            .count()
    }

    fn report(&self, place: &str, truth: &[Hit], mistakes: Mistakes, tally: &mut Tally) {
        if mistakes.0.is_empty() {
            return;
        }
        tally.wrong += 1;
        for (kind, detail) in mistakes.0 {
            let (count, example) = tally.kinds.entry(kind).or_default();
            *count += 1;
            if example.is_empty() {
                *example = format!("{kind}: {detail}\n{}", self.described(place, truth));
            }
        }
    }

    /// Everything needed to look into an answer.
    fn described(&self, place: &str, truth: &[Hit]) -> String {
        let mut text = format!("  {place}\n");
        for hit in truth {
            let (t, at) = (hit.t.rounded(), (hit.object, hit.triangle));
            let _ = writeln!(text, "  true: {at:?} front {} t {t:e}", hit.front);
        }
        let objects = self.scene.objects().iter().enumerate();
        let few = self.scene.objects().len() < 6;
        for (i, object) in objects.filter(|(_, object)| object.visible) {
            if few || truth.iter().any(|hit| hit.object == i) {
                let _ = writeln!(text, "  {i}: {}", described(object));
            }
        }
        text
    }
}

fn described(object: &Object) -> String {
    let kind = object.shape.kind();
    let triangles = object.shape.triangles().map_or(0, |range| range.len());
    format!("{kind} of {triangles} under {:?}", object.placement.model())
}

pub fn same_place(answer: &Answer, hit: &Hit) -> bool {
    (answer.object, answer.triangle) == (hit.object, hit.triangle)
}

#[derive(Default)]
struct Mistakes(Vec<(&'static str, String)>);

impl Mistakes {
    fn add(&mut self, kind: &'static str, detail: String) {
        self.0.push((kind, detail));
    }

    fn of_answers(&mut self, line: &Line, all: &[Answer], closest: Option<&Answer>, truth: &[Hit]) {
        if all.len() == truth.len() {
            for (answer, hit) in all.iter().zip(truth) {
                self.of_answer(line, "all", answer, hit);
            }
        } else {
            self.add("all: count", format!("{} of {}", all.len(), truth.len()));
        }
        match (closest, truth.first()) {
            (Some(answer), Some(hit)) => self.of_answer(line, "closest", answer, hit),
            (None, None) => {}
            (answer, hit) => self.add(
                "closest: hit or miss",
                format!("{} for {}", answer.is_some(), hit.is_some()),
            ),
        }
    }

    fn of_answer(&mut self, line: &Line, who: &'static str, answer: &Answer, hit: &Hit) {
        if !same_place(answer, hit) {
            self.add(
                "surface",
                format!("{who} says {:?}", (answer.object, answer.triangle)),
            );
            return;
        }
        if answer.front != hit.front {
            self.add("front", format!("{who} says {}", answer.front));
        }
        self.near_enough("t", answer.t, &hit.t, line);
        if let Some(face) = hit.face
            && answer.normal_object != DVec3::from(face.map(f64::from))
        {
            self.add("face", format!("{who} says {}", answer.normal_object));
        }
        match (answer.barycentric, hit.barycentric) {
            (None, None) => {}
            (Some(said), Some(exact))
                if said.iter().zip(exact).all(|(a, b)| (a - b).abs() <= WEIGHT) => {}
            (said, exact) => self.add("barycentric", format!("{said:?} for {exact:?}")),
        }
    }

    fn near_enough(&mut self, kind: &'static str, said: f64, exact: &Parameter, line: &Line) {
        let t = exact.rounded();
        let slack = FEW_ROUNDINGS * line.reach(exact);
        if !((said - t).abs() <= T_RELATIVE * t.abs() + slack) {
            self.add(kind, format!("{said:e} for {t:e}"));
        }
    }

    fn of_record(&mut self, case: &Case, line: &Line, truth: &[Hit], i: usize, record: &Pick) {
        let hit = &truth[i];
        let object = &case.scene.objects()[hit.object];
        let first = program::first_triangle(&object.shape);
        let triangle = record.triangle.map(|triangle| triangle + first);
        if (record.id, triangle) != (hit.object + 1, hit.triangle) {
            self.add("record: surface", format!("{:?}", (record.id, triangle)));
            return;
        }
        if record.front != hit.front {
            self.add("record: front", format!("{}", record.front));
        }
        self.near_enough("record: t", record.t, &hit.t, line);
        self.near_enough("record: depth", record.depth, &hit.t, line);
        let gap = truth.get(i + 1).map(|next| next.t.rounded_minus(&hit.t));
        if record.gap.map(f64::to_bits) != gap.map(f64::to_bits) {
            self.add("gap", format!("{:?} for {gap:?}", record.gap));
        }
        // No filter can decide what is exactly on a border.
        let tied = |other: Option<&Hit>| other.is_some_and(|other| other.t.compare(&hit.t).is_eq());
        let on_near = hit.t.compare_to(&line.near).is_eq();
        let undecided =
            hit.on_border || on_near || tied(truth.get(i + 1)) || i > 0 && tied(truth.get(i - 1));
        if undecided && !record.exact {
            self.add("not said to be exact", String::new());
        }
        self.of_places(case, line, hit, record);
    }

    fn of_places(&mut self, case: &Case, line: &Line, hit: &Hit, record: &Pick) {
        let exact = hit.t.rounded();
        let point = line.point(&hit.t);
        let distance = line.distance(case.view.camera.eye(), &hit.t);
        let lost = (record.t - exact).abs() / exact.abs().max(f64::MIN_POSITIVE);
        let slack = (FEW_ROUNDINGS + 2.0 * lost.min(T_RELATIVE)) * distance;
        if !((record.distance - distance).abs() <= slack) {
            self.add(
                "distance",
                format!("{:e} for {distance:e}", record.distance),
            );
        }
        let size = case.view.camera.eye().abs().max_element() + distance;
        let off = (record.point_world - point).abs().max_element();
        if !(off <= slack + FEW_ROUNDINGS * size) {
            self.add("point", format!("{} for {point}", record.point_world));
        }
        if record.depth.to_bits() != record.t.to_bits() {
            self.add(
                "depth is not t",
                format!("{:e} {:e}", record.depth, record.t),
            );
        }
    }
}
