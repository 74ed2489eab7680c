//! The time of a test against the share of rays that hit, and of rays at an edge or an outline, which `f64` can't
//! decide: the chart that is least kind to Sightline.

use super::prelude::*;

/// The steps that are shown.
const STEPS: [&str; 3] = ["triangle", "sphere", "square"];

/// Draws the chart.
pub fn draw<B: DrawingBackend>(page: &Page<B>, report: &Report) -> Drawn<B> {
    let timed = |row: &&Row| row.time.is_some() && STEPS.contains(&row.info.step.key);
    let timed = || report.rows.iter().filter(timed);
    let lines = [
        "Above: against the share of rays that hit. Below: against the share of rays aimed at an edge or an outline, which f64 can't decide. \
         Dashed: f32; solid: f64 or exact."
            .to_owned(),
        about(report, "triangle", true),
    ];
    let rest = head(page, &message(&timed().collect::<Vec<_>>()), &lines)?;
    let parts = rest.split_evenly((2, 3));
    for (family, parts) in [HIT_RATE, AT_EDGES].iter().zip(parts.chunks(3)) {
        let of_family = || timed().filter(|row| row.family == *family);
        let ends = Axis::powers_of_ten(
            "time (ns)",
            of_family().filter_map(|row| Some(row.time?.ns)),
        );
        let ends = ends.wider([0.1, 0.1]);
        for (step, part) in STEPS.iter().zip(parts) {
            let rows = of_family().filter(|row| row.info.step.key == *step);
            step_panel(page, part, &rows.collect::<Vec<_>>(), ends.clone())?;
        }
    }
    Ok(())
}

/// The price of certainty where it is least and where it is greatest.
fn message(rows: &[&Row]) -> String {
    let ours = |share: f64| {
        let own = rows.iter().filter(|row| {
            row.info.ours && row.info.step.key == "triangle" && row.family == AT_EDGES
        });
        let mut at = own.filter(|row| row.value.total_cmp(&share).is_eq());
        at.find_map(|row| Some(row.time?.ns))
    };
    match [0.0, 0.01, 1.0].map(ours) {
        [Some(none), Some(few), Some(all)] => format!(
            "Certainty about a triangle takes {none:.0} ns, {few:.0} ns where 1 % of rays meet an edge, {:.1} us where all do",
            all / 1e3
        ),
        _ => "What certainty costs".to_owned(),
    }
}

fn step_panel<B: DrawingBackend>(
    page: &Page<B>,
    part: &Page<B>,
    rows: &[&Row],
    y: Axis,
) -> Drawn<B> {
    let Some(first) = rows.first() else {
        return Ok(());
    };
    let x = if first.family == AT_EDGES {
        // Most is told by the smallest shares.
        Axis::powers_of_ten(first.parameter, rows.iter().map(|row| row.value)).with_none(0.2, "0")
    } else {
        Axis::linear(first.parameter, 1.0, 0.25)
    };
    let title = format!("{}: {}", first.info.step.name, first.family);
    let panel = panel(page, part, &title, [x, y], 390)?;
    let ends = panel.curves(rows, |row| Some(row.time?.ns), None, (&[], 0.0))?;
    panel.end_labels(ends)
}
