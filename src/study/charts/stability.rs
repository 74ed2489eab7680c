//! Draws a line for each method: its worst error against the parameter that makes it worse.

use super::prelude::*;

/// The families that are shown, by step and name.
const SHOWN: [(&str, &str); 6] = [
    ("ray", "eye far from the origin"),
    ("ray", "far plane"),
    ("object-space", "far from the origin"),
    ("triangle", "slivers"),
    ("sphere", "far away"),
    ("square", "far from the origin"),
];
/// Below this nobody sees an error, in pixels.
const SEEN_PX: f64 = 1e-3;
/// Width of the labels at the lines' ends.
const LABELS: i32 = 400;
/// A wrong decision below this distance is a tie, because the truth itself rounds by as much.
const LEAST_PX: f64 = 1e-30;

/// Draws the chart.
pub fn draw<B: DrawingBackend>(page: &Page<B>, report: &Report) -> Drawn<B> {
    let panels = SHOWN.map(|(step, family)| {
        let is_shown = |row: &&Row| row.info.step.key == step && row.family == family;
        report.rows.iter().filter(is_shown).collect::<Vec<&Row>>()
    });
    let lines = [
        "Each panel makes one thing worse from left to right. Dashed: f32; solid: f64 or exact; grey: other known methods. Green: less than 1e-3 px, \
         which nobody sees."
            .to_owned(),
        format!("Spheres: in per cent of the sphere's size in the picture. {}", about(report, "triangle", true)),
    ];
    let rest = head(page, &message(&panels), &lines)?;
    for (rows, part) in panels.iter().zip(rest.split_evenly((2, 3))) {
        lines_of(page, &part, rows, None)?;
    }
    Ok(())
}

/// From where on a ray is a pixel off by the usual way, with the eye far from the origin; and Sightline's worst there.
fn message(panels: &[Vec<&Row>]) -> String {
    let rows = || panels.first().into_iter().flatten();
    let usual = ("inverse(P V), far - near", F32);
    let is_off = |row: &&&Row| row.info.key() == usual && error(row) > 1.0;
    let ours = rows().filter(|row| row.info.ours);
    let worst = ours.map(|row| error(row)).reduce(f64::max);
    match rows().find(is_off).zip(worst) {
        Some((row, worst)) => format!(
            "A ray by inverse(P V) in f32 is a pixel off from {} target distances on, Sightline's {worst:.0e} px",
            row.value
        ),
        None => "Where each method breaks".to_owned(),
    }
}

/// A row's error; 0 for ties.
fn error(row: &Row) -> f64 {
    let decides = !row.info.step.wrong_unit.is_empty();
    match row.off_by() {
        ..LEAST_PX if decides => 0.0,
        off => off,
    }
}

/// A far sphere's error in per cent of its size: nothing of it is off by more than that. `value` radii away, a radius
/// is 1 / `value` radians.
fn of_size(row: &Row) -> f64 {
    100.0 * error(row) * PX * row.value
}

/// The chart of one family, for a narrow page: the line of the method `wide` is wider. `rows` has the family's rows and
/// a scene's own ([`SCENE`]), which are marked at `here`. Without rows of the family, nothing is drawn.
///
/// # Errors
/// When the backend refuses.
pub fn family<B: DrawingBackend>(
    on: B,
    rows: &[Row],
    here: f64,
    wide: Option<(&str, Precision)>,
) -> Drawn<B> {
    let page: Page<B> = on.into_drawing_area();
    page.fill(&WHITE)?;
    let rows: Vec<&Row> = rows.iter().collect();
    lines_of(
        &page,
        &page.margin(20, 10, 10, 20),
        &rows,
        Some((here, wide)),
    )
}

/// Draws the panel of one family, and marks a scene's own rows where they are.
fn lines_of<B: DrawingBackend>(
    page: &Page<B>,
    part: &Page<B>,
    rows: &[&Row],
    scene: Option<(f64, Option<(&str, Precision)>)>,
) -> Drawn<B> {
    let (own, rows): (Vec<&Row>, Vec<&Row>) = rows.iter().partition(|row| row.family == SCENE);
    let Some(first) = rows.first() else {
        return Ok(());
    };
    let step = first.info.step;
    // Beside a scene, errors are in its own pixels.
    let is_of_size = scene.is_none() && (step.key, first.family) == ("sphere", "far away");
    let error = if is_of_size { of_size } else { error };
    let unit = match (is_of_size, step.wrong_unit, step.error_unit) {
        (true, ..) => "worst wrong answer (% of size)".to_owned(),
        (_, "", "") => "wrong".to_owned(),
        (_, "", unit) => format!("worst error ({unit})"),
        (_, unit, _) => format!("worst wrong answer ({unit})"),
    };
    let values = || rows.iter().map(|row| row.value);
    let x = if values().any(|value| value == 0.0) {
        Axis::linear(first.parameter, 1.0, 0.25)
    } else {
        let here = scene.map(|(here, _)| here);
        Axis::powers_of_ten(first.parameter, values().chain(here))
    };
    let is_down = rows.first().map(|row| row.value) > rows.last().map(|row| row.value);
    let errors = || rows.iter().chain(&own).map(|row| error(row));
    let is_in_px = !is_of_size && [step.wrong_unit, step.error_unit].contains(&"px");
    let marks = if is_in_px {
        [SEEN_PX, 2.0]
    } else {
        [SEEN_PX; 2]
    };
    let mut y = Axis::powers_of_ten(unit, errors().chain(marks));
    if errors().any(|error| error == 0.0) {
        y = y.with_none(0.1, "0");
    }
    if errors().any(|error| error == f64::INFINITY) {
        y = y.with_all(0.1, "fails");
    }
    let title = format!("{}: {}", step.name, first.family);
    let panel = panel(page, part, &title, [x.turned(is_down), y], LABELS)?;
    if is_in_px {
        panel.band([0.0, SEEN_PX], NOBODY_SEES)?;
        panel.level(1.0, "one pixel", Side::Left)?;
    }
    let (here, wide) = scene.unwrap_or_default();
    let ends = panel.curves(&rows, |row| Some(error(row)), wide, (&own, here))?;
    if scene.is_some() {
        mark_scene(&panel, here)?;
    }
    panel.end_labels(ends)
}

/// A line at the scene's value of the parameter.
fn mark_scene<B: DrawingBackend>(panel: &Panel<'_, B>, here: f64) -> Drawn<B> {
    let (x, _) = panel.at(here, 1.0);
    let [left, top, right, bottom] = panel.frame();
    let line = PathElement::new([(x, top), (x, bottom)], INK.stroke_width(2));
    panel.page.draw(&line)?;
    let (side, away) = if 2 * x > left + right {
        (Side::Left, -12)
    } else {
        (Side::Right, 12)
    };
    words(panel.page, SCENE, (x + away, top + 24), INK, side)
}
