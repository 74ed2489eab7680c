//! Finds the precision that each step needs so that picks on a scene stay within an error in pixels.

use super::{
    estimates::{Estimate, estimates},
    prelude::*,
    table::{number, short},
};
use crate::{
    camera::{Projection, View},
    geometry::Ray,
};

/// How many times as large as what is seen coordinates may be. Beyond that, a program has choices that the estimates do
/// not know, such as one `f64` origin for each file.
const FAR: f64 = 1000.0;

/// Why there is no budget for a scene.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NoBudget {
    /// No ray hits.
    #[error(
        "--budget: none of {0} rays hits anything: turn to the scene, come nearer, or hide less of it"
    )]
    NothingHit(usize),
    /// Coordinates are this many times as large as what is seen.
    #[error(
        "--budget: coordinates are {0:.0} times as large as what is seen (the distance from eye to hit; with parallel \
         rays, the picture's height), and the estimates hold up to {FAR}: see more of the scene, or move it to the \
         world's origin, by `position` in a scene file"
    )]
    FarFromOrigin(f64),
}

/// Whether a scene's hits are such that its budget can be told.
///
/// # Errors
/// Where nothing is hit, or a hit or its ray's start lies far from the world's origin.
pub fn has_budget(rays: &SceneRays) -> Result<(), NoBudget> {
    let each = rays.objects().map(|(ray, _, hit)| {
        let point = ray.at(hit.hit.t);
        point.length().max(ray.origin.length()) / reach_of(rays, ray, hit.hit.t)
    });
    match each.reduce(f64::max) {
        None => Err(NoBudget::NothingHit(rays.at.len())),
        Some(times) if times > FAR => Err(NoBudget::FarFromOrigin(times.ceil())),
        Some(_) => Ok(()),
    }
}

/// The size of what is seen around a hit: its distance from the eye, or with parallel rays the picture's height.
fn reach_of(rays: &SceneRays, ray: &Ray, t: f64) -> f64 {
    match rays.world.view.camera.lens().projection {
        Projection::Perspective { .. } => t * ray.direction.length(),
        Projection::Orthographic { height } => height,
    }
}

/// The five lines that `--budget` prints. `report` is a timed run over the scene's own rays, which
/// [have a budget](has_budget).
pub fn budget(rays: &SceneRays, view: &View, report: &Report, budget_px: f64) -> String {
    let [narrow, wide] = [F32, F64].map(|precision| estimates(rays, view, report, precision));
    let chain = chain(&narrow, &wide, budget_px);
    let lines = [
        methods(&chain, budget_px),
        largest(&chain, &narrow, &wide),
        reach(&chain, rays, view, budget_px),
        savings(report, &narrow),
        sample(report, narrow.iter().chain(&wide)),
    ];
    lines.join("\n") + "\n"
}

/// The error of a pick: the sum of the errors of its ray, of the transform to object space, and of the worst shape's
/// test.
fn total(chain: &[Estimate], of: fn(&Estimate) -> f64) -> f64 {
    let (shapes, steps): (Vec<&Estimate>, Vec<&Estimate>) =
        chain.iter().partition(|step| step.is_of_shape());
    let steps: f64 = steps.into_iter().map(of).sum();
    steps + shapes.into_iter().map(of).fold(0.0, f64::max)
}

/// Starts with every step in `f32` and moves the one with the largest error to `f64` until the total is within the
/// budget.
fn chain(narrow: &[Estimate], wide: &[Estimate], budget_px: f64) -> Vec<Estimate> {
    let mut chain = narrow.to_vec();
    while total(&chain, |step| step.px) > budget_px {
        let steps = chain.iter_mut().zip(wide);
        let steps = steps.filter(|(step, _)| step.precision == F32);
        let Some((step, wide)) = steps.max_by(|a, b| a.0.px.total_cmp(&b.0.px)) else {
            break;
        };
        *step = *wide;
    }
    chain
}

/// A number of pixels, rounded to a few digits. It is 5 % larger, so that rounding does not make it smaller.
fn pixels(px: f64) -> String {
    if px.is_finite() {
        format!("{} px", number(px * 1.05))
    } else {
        "without limit".to_owned()
    }
}

fn methods(chain: &[Estimate], budget_px: f64) -> String {
    let px = total(chain, |step| step.px);
    let words = |precision: Precision| {
        let steps = chain.iter().filter(|step| step.precision == precision);
        let steps = steps.map(|step| format!("{} by {}", step.step, step.method));
        let steps: Vec<String> = steps.collect();
        (!steps.is_empty()).then(|| format!("in {precision} {}", steps.join(", ")))
    };
    let chain: Vec<String> = [F32, F64].into_iter().filter_map(words).collect();
    let verdict = if px <= budget_px { "within" } else { "over" };
    let (chain, px, budget_px) = (chain.join("; "), pixels(px), short(budget_px));
    format!("{chain}: at most {px}, {verdict} the budget of {budget_px} px.")
}

fn largest(chain: &[Estimate], narrow: &[Estimate], wide: &[Estimate]) -> String {
    let most = chain.iter().max_by(|a, b| a.px.total_cmp(&b.px));
    let most = most.map_or_else(String::new, |step| {
        let (name, precision, px) = (step.step, step.precision, pixels(step.px));
        format!("Most of it is {name} in {precision}, {px}. ")
    });
    let [narrow, wide] = [narrow, wide].map(|chain| pixels(total(chain, |step| step.px)));
    format!("{most}All in f32: {narrow}; all in f64: {wide}; Sightline decides exactly.")
}

/// How far the whole scene can move from the world's origin before the chain exceeds the budget.
fn reach(chain: &[Estimate], rays: &SceneRays, view: &View, budget_px: f64) -> String {
    let now = view.camera.eye().length();
    let px = total(chain, |step| step.px);
    let unmoved = total(chain, |step| step.px - step.px_by_origin[0]);
    let per_unit = total(chain, |step| step.px_by_origin[1]);
    let here = format!("the eye is {} units from it now", number(now));
    if px > budget_px {
        return format!(
            "No distance from the world's origin is near enough: the picture needs more digits than f64 has, or its eye touches a surface; {here}."
        );
    }
    let reaches = rays
        .objects()
        .map(|(ray, _, hit)| reach_of(rays, ray, hit.hit.t));
    let told = FAR * reaches.fold(f64::INFINITY, f64::min);
    let most = 0.95 * ((budget_px - unmoved) / per_unit);
    let most = number(most.min(told).max(now));
    format!("That holds until eye and objects are {most} units from the world's origin; {here}.")
}

/// How much time `f32` saves in these steps, compared with the time of a whole pick.
fn savings(report: &Report, steps: &[Estimate]) -> String {
    /// The least share of a pick's time that counts.
    const WORTH: f64 = 0.05;
    let ns = |step: &Estimate, precision| Some(row(report, step, precision)?.time?.ns);
    let saved = |step| Some(ns(step, F64)? - ns(step, F32)?);
    let saved: f64 = steps.iter().filter_map(saved).sum();
    let pick = report.of_scene("pick").find(|row| row.info.ours);
    let Some(pick) = pick.and_then(|row| row.time) else {
        return "Nothing is picked here, so nothing was timed.".to_owned();
    };
    let not = if saved > WORTH * pick.ns { "" } else { "not " };
    let amount = if saved > 0.0 {
        format!("saves {} ns", number(saved))
    } else {
        "saves nothing".to_owned()
    };
    format!(
        "With each step done once, f32 in place of f64 {amount} of the {} ns that a pick takes here: {not}worth having.",
        number(pick.ns)
    )
}

/// The size of the sample, and how near the measured errors come to the estimates.
fn sample<'a>(report: &Report, estimates: impl Iterator<Item = &'a Estimate>) -> String {
    let cases = |step| report.of_scene(step).next().map_or(0, |row| row.cases);
    let share = estimates.filter_map(|step| Some(measured(report, step)? / step.px));
    let share = share.fold(0.0, f64::max);
    format!(
        "Sample: {} pixels, of which {} hit, and {} whole picks. The measured errors are at most {} % of these bounds.",
        cases("ray"),
        cases("object-space"),
        cases("pick"),
        number(100.0 * share),
    )
}

/// The measured error of an estimate's method on the scene's own rays, in pixels.
pub fn measured(report: &Report, step: &Estimate) -> Option<f64> {
    let row = row(report, step, step.precision)?;
    let errors = [row.worst_error, row.worst_wrong];
    Some(errors[usize::from(step.is_of_shape())])
}

/// The row of an estimate's method on the scene's own rays, in a precision.
fn row<'a>(report: &'a Report, step: &Estimate, precision: Precision) -> Option<&'a Row> {
    let mut rows = report.of_scene(step.step);
    rows.find(|row| row.info.key() == (step.method, precision))
}
