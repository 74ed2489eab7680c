//! No more than a scene needs: which precision each step needs to stay within so many pixels.

use super::{
    estimates::{Sizes, Term},
    methods::triangles::TriangleCase,
    run::{Report, Row, SCENE},
    step::Precision,
    table::{number, short},
    truth::UNIT_F32,
};
use crate::{camera::View, scene::Scene};
use std::fmt::Write;

/// The page that `--budget` prints. `report` is of the scene's own rays: what each method does on them is measured.
#[must_use]
pub fn budget(
    scene: &Scene,
    view: &View,
    triangles: &[TriangleCase],
    report: &Report,
    budget_px: f64,
) -> String {
    let sizes = Sizes::new(scene, view, triangles);
    let terms = sizes.terms();
    let mut text = String::new();
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "Budget: {} px. Here a rounding is q = {} px in f32 and {} px in f64. Steps add up, so a step may use a \
         quarter.\n",
        short(budget_px),
        number(sizes.q),
        number(sizes.q * f64::EPSILON / f64::from(f32::EPSILON)),
    );
    let _ = writeln!(text, "{}\n", dominant(&terms));
    for step in report.steps() {
        let rows = report
            .rows
            .iter()
            .filter(|row| row.step == step && row.family == SCENE);
        let rows: Vec<&Row> = rows.collect();
        let own: Vec<&Term> = terms.iter().filter(|term| term.step == step.key).collect();
        let least = own.iter().min_by(|a, b| a.px.total_cmp(&b.px));
        let verdict = match least {
            Some(term) if term.px <= 0.25 * budget_px => {
                format!("f32 would do, by {}", term.method)
            }
            Some(term) => format!(
                "f64: the best in f32, {}, may be off by {}",
                term.method,
                limit(term.px)
            ),
            None => measured_need(&rows, &sizes, budget_px),
        };
        let _ = writeln!(text, "{}: {verdict}", step.name);
        for term in own {
            let over = if term.px > 0.25 * budget_px {
                "too much"
            } else {
                "within"
            };
            let px = limit(term.px);
            let _ = writeln!(
                text,
                "  estimate  f32  {:<28} {px:>11}  {over:<8}  {}",
                term.method, term.formula
            );
        }
        for row in rows.iter().filter(|row| row.ours) {
            ours(&mut text, row);
        }
        lesser(&mut text, &rows);
        text.push('\n');
    }
    text
}

/// Each step's best method in `f32`, the worst step first.
fn dominant(terms: &[Term]) -> String {
    let mut best: Vec<&Term> = Vec::new();
    for term in terms {
        match best.iter_mut().find(|known| known.step == term.step) {
            Some(known) if term.px < known.px => *known = term,
            Some(_) => {}
            None => best.push(term),
        }
    }
    best.sort_by(|a, b| b.px.total_cmp(&a.px));
    let words = best
        .iter()
        .map(|term| format!("{} {}", term.step, limit(term.px)));
    let words: Vec<String> = words.collect();
    format!(
        "With the best methods in f32, the largest first: {}.",
        words.join(", ")
    )
}

/// The derived bound of what this program does, beside what was measured.
fn ours(text: &mut String, row: &Row) {
    let Some(bound) = row.bound else {
        return;
    };
    let step = row.step;
    let mut say = |bound: f64, found: f64, unit: &str, what: &str| {
        let _ = writeln!(
            text,
            "  bound     {:<4} {:<28} {:>11}  {what}; measured {}",
            row.precision.to_string(),
            row.method,
            format!("{} {unit}", number(bound)),
            number(found)
        );
    };
    if !step.error_unit.is_empty() {
        say(
            bound.error,
            row.worst_error,
            step.error_unit,
            "largest error of a value",
        );
    }
    if !step.wrong_unit.is_empty() {
        say(
            bound.wrong,
            row.worst_wrong,
            step.wrong_unit,
            "largest distance of a wrong decision",
        );
    }
}

/// What other methods got wrong on the scene's own rays, and what they would save.
fn lesser(text: &mut String, rows: &[&Row]) {
    let ns = |row: &Row| row.time.map(|time| time.ns);
    let own = rows.iter().find(|row| row.ours).and_then(|row| ns(row));
    for row in rows
        .iter()
        .filter(|row| !row.ours && row.precision == Precision::F32)
    {
        let saves = match own.zip(ns(row)) {
            Some((own, ns)) if ns < own => format!("saves {} ns", number(own - ns)),
            Some((own, ns)) => format!("costs {} ns more", number(ns - own)),
            None => "not timed".to_owned(),
        };
        let wrong = row.wrong_percent();
        let value = if row.step.error_unit.is_empty() {
            String::new()
        } else {
            format!(
                ", worst error {} {}",
                number(row.worst_error),
                row.step.error_unit
            )
        };
        let _ = writeln!(
            text,
            "  measured  f32  {:<28} {wrong:>8.2} % wrong{value}; {saves}",
            row.method
        );
    }
}

/// For steps without a formula: whether some method in `f32` did everything right, values within the budget.
fn measured_need(rows: &[&Row], sizes: &Sizes, budget_px: f64) -> String {
    /// A shading step of 1 / 256.
    const DEGREES: f64 = 0.25;
    let right = |row: &&&Row| {
        // A value along the ray counts as much as if it were seen from the side.
        let within = match row.step.error_unit {
            "" => true,
            "degrees" => row.worst_error <= DEGREES,
            "px" => row.worst_error <= 0.25 * budget_px,
            _ => row.worst_error / UNIT_F32 * sizes.q <= 0.25 * budget_px,
        };
        row.precision == Precision::F32 && row.wrong_percent() == 0.0 && within
    };
    match rows.iter().find(right) {
        Some(row) => format!("f32 did everything right here, by {}", row.method),
        None => "f64: no method in f32 did everything right here".to_owned(),
    }
}

/// An error in pixels.
fn limit(px: f64) -> String {
    if px.is_finite() {
        format!("{} px", number(px))
    } else {
        "no limit".to_owned()
    }
}
