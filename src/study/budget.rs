//! No more than a scene needs: which precision each step needs to stay within so many pixels.
//!
//! Each way to do a step has a term: what it adds to the error in pixels, from what the scene and its camera are. A
//! term is a *bound* where it is derived (`truth` has the derivations), which is so for what this program does;
//! otherwise it is an *estimate*: a formula whose factor is the largest that workloads showed.
//!
//! With u = 2^-24 a rounding in `f32` and `pix` the width of a pixel in radians, q = u / pix is a rounding in pixels.

use super::{
    methods::triangles::{SIGHTLINES_PRECISION, TriangleCase},
    run::{Report, Row, SCENE},
    step::Precision,
    table::{number, short},
};
use crate::{
    camera::{Projection, View},
    scene::{Scene, Shape},
};
use std::fmt::Write;

/// A rounding in `f32`.
const UNIT_F32: f64 = 0.5 * f32::EPSILON as f64;

/// What a way to do a step adds to the error.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// Key of the step.
    pub step: &'static str,
    /// The method, in `f32`.
    pub method: &'static str,
    /// The formula in words.
    pub formula: &'static str,
    /// Its value here, in pixels; infinite where the method fails.
    pub px: f64,
}

/// What the formulas know of a scene and its camera.
#[derive(Clone, Copy, Debug)]
struct Sizes {
    /// A rounding in pixels.
    q: f64,
    /// From the world's origin to the eye, over what the eye is from its target.
    eye_over_length: f64,
    /// The same over the near plane.
    eye_over_near: f64,
    far_over_near: f64,
    /// Largest distance of an object's own origin from the world's, over what the eye is from it.
    translation: f64,
    /// Largest ratio of an object's longest and shortest scale.
    anisotropy: f64,
    /// Largest distance of a sphere over its radius; none without spheres.
    sphere: Option<f64>,
    /// Whether there are triangles.
    meshes: bool,
    /// Least sine of the angle between a sampled ray and the triangle that it hits; 1 without triangles.
    graze: f64,
}

impl Sizes {
    fn new(scene: &Scene, view: &View, triangles: &[TriangleCase]) -> Self {
        let lens = view.camera.lens();
        let eye = view.camera.eye();
        let length = view.camera.target().distance(eye);
        let rows = f64::from(view.viewport.height());
        let half = lens.half_extent(1.0).y;
        let px = match lens.projection {
            Projection::Perspective { .. } => 2.0 * half / rows,
            Projection::Orthographic { .. } => 2.0 * half / rows / length,
        };
        let mut sizes = Self {
            q: UNIT_F32 / px,
            eye_over_length: eye.length() / length,
            eye_over_near: eye.length() / lens.near.abs(),
            far_over_near: lens.far / lens.near.abs(),
            translation: 0.0,
            anisotropy: 1.0,
            sphere: None,
            meshes: false,
            graze: 1.0,
        };
        let visible = scene
            .objects()
            .iter()
            .enumerate()
            .filter(|(_, object)| object.visible);
        for (index, object) in visible {
            let bounds = scene.bounds_of(index);
            let nearest = eye
                .clamp(bounds.min, bounds.max)
                .distance(eye)
                .max(lens.near.abs());
            let model = object.placement.model();
            sizes.translation = sizes.translation.max(model.translation.length() / nearest);
            let longest = |m: glam::DMat3| {
                [m.x_axis, m.y_axis, m.z_axis]
                    .map(glam::DVec3::length)
                    .into_iter()
                    .fold(0.0, f64::max)
            };
            let stretch = longest(model.matrix3) * longest(object.placement.inverse_linear());
            sizes.anisotropy = sizes.anisotropy.max(stretch);
            match object.shape {
                Shape::Sphere => {
                    let far = bounds.center().distance(eye) / (0.5 * longest(model.matrix3));
                    sizes.sphere = Some(sizes.sphere.unwrap_or(0.0).max(far));
                }
                Shape::Mesh { .. } => sizes.meshes = true,
                Shape::Cube | Shape::Square => {}
            }
        }
        for case in triangles
            .iter()
            .filter(|case| super::step::Case::truth(*case).t.is_some())
        {
            let [a, b, c] = case.wide.corners;
            let normal = (b - a).cross(c - a);
            let sine = normal.dot(case.wide.direction).abs()
                / (normal.length() * case.wide.direction.length());
            sizes.graze = sizes.graze.min(sine);
        }
        sizes
    }

    /// Every estimate that this scene has a use for.
    fn terms(&self) -> Vec<Term> {
        /// Where a clip-space w in f32 is 0 at the far plane.
        const SINGULAR: f64 = 8_388_608.0;
        let q = self.q;
        let term = |step, method, formula, px| Term {
            step,
            method,
            formula,
            px,
        };
        let unproject = 6.0 * q * self.eye_over_near.max(1.0);
        let fails = self.far_over_near > SINGULAR;
        let mut terms = vec![
            term("ray", "eye basis", "5 q", 5.0 * q),
            term(
                "ray",
                "target + sx H + sy V - eye",
                "5 q + 2 q |eye| / length",
                5.0 * q + 2.0 * q * self.eye_over_length,
            ),
            term(
                "ray",
                "inverse(P V), far - near",
                "6 q |eye| / near, fails where far / near > 2^23",
                if fails { f64::INFINITY } else { unproject },
            ),
            term(
                "object-space",
                "inverse(A) (o - T)",
                "2 q anisotropy",
                2.0 * q * self.anisotropy,
            ),
            term(
                "object-space",
                "inverse(M)",
                "2 q anisotropy + 2 q |T| / t",
                2.0 * q * (self.anisotropy + self.translation),
            ),
        ];
        if self.meshes {
            let steep = self.graze > 3e-3;
            terms.extend([
                term("triangle", "Woop watertight", "q", q),
                term(
                    "triangle",
                    "Moeller-Trumbore",
                    "8 q, without limit where rays graze below 3e-3",
                    if steep { 8.0 * q } else { f64::INFINITY },
                ),
                term(
                    "triangle",
                    "areas, sum == 1",
                    "the whole triangle",
                    f64::INFINITY,
                ),
            ]);
        }
        if let Some(distance) = self.sphere {
            terms.extend([
                term("sphere", "Hearn & Baker", "1.6 q", 1.6 * q),
                term(
                    "sphere",
                    "plain quadratic",
                    "1.6 q distance / radius",
                    1.6 * q * distance,
                ),
            ]);
        }
        terms
    }
}

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
        lesser(&mut text, report, &rows);
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
    let (Some(bound), unit) = (row.bound, row.step) else {
        return;
    };
    let exact = row.step.key == "triangle" && SIGHTLINES_PRECISION == Precision::Exact;
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
    if !unit.error_unit.is_empty() {
        say(
            bound.error,
            row.worst_error,
            unit.error_unit,
            "largest error of a value",
        );
    }
    if !unit.wrong_unit.is_empty() {
        let most = if exact { 0.0 } else { bound.wrong };
        say(
            most,
            row.worst_wrong,
            unit.wrong_unit,
            "largest distance of a wrong decision",
        );
    }
}

/// What other methods got wrong on the scene's own rays, and what they would save.
fn lesser(text: &mut String, report: &Report, rows: &[&Row]) {
    let ns = |row: &Row| {
        let mut times = report.times.iter();
        let time = times.find(|time| {
            (time.step, time.method, time.precision) == (row.step, row.method, row.precision)
        });
        time.map(|time| time.ns)
    };
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
        let wrong = row.missed + row.phantoms + row.others;
        row.precision == Precision::F32 && wrong == 0 && within
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
