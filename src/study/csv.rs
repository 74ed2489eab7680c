//! The study as CSV: one table with a line for each method at each value of each parameter, one with a line for each
//! method.

use super::{prelude::*, timing::processor};

/// The header of [`csv`]. All columns but the last five are the same for a seed on every machine.
pub const COLUMNS: &str = "step,method,precision,sightlines,family,parameter,value,cases,missed,phantoms,others,wrong_percent,\
                           worst_wrong,wrong_unit,median_error,p999_error,worst_error,error_unit,ties,wrong_percent_high,ns,ns_low,\
                           ns_high,ns_learnt,processor";

/// The header of [`summary_csv`].
pub const SUMMARY_COLUMNS: &str = "step,method,precision,ours,ordinary_ns,worst_ns,wrong_rate,wrong_rate_high,median_error,\
                                   p999_error,worst_error,own_error,useful_below,instead";

/// The whole report: RFC 4180 with a header line. Measured numbers have two digits, so that machines whose tangents
/// differ in the last bit agree; the error of a value that is NaN is `inf`.
pub fn csv(report: &Report) -> String {
    let rows = report.rows.iter().map(|row| {
        let times = row.time.map(|time| {
            let [low, high] = time.quartiles.map(nanoseconds);
            let [ns, learnt] = [time.ns, time.learnt].map(nanoseconds);
            [ns, low, high, learnt, processor().to_owned()]
        });
        let times = times.unwrap_or_default();
        verdict(row).into_iter().chain(times).collect()
    });
    lines(COLUMNS, rows)
}

/// A line for each method over all of the report's workloads. Time and `median_error` are those of the ordinary
/// workload, the other errors those of the worst. `own_error` is how far off wrong decisions are, in the step's unit, or
/// a value's error. A method is useful from its own error on and below `useful_below`, where `instead` does as well and
/// is more than a tenth faster.
pub fn summary_csv(report: &Report) -> String {
    let rows = report.steps().into_iter().flat_map(|step| {
        let all = report.summaries(step);
        let rows = all.iter().map(|summary| of_method(summary, &all));
        rows.collect::<Vec<_>>()
    });
    lines(SUMMARY_COLUMNS, rows)
}

fn of_method(summary: &Summary<'_>, all: &[Summary<'_>]) -> Vec<String> {
    let row = summary.method;
    let ns = |ns: Option<f64>| ns.map_or(String::new(), nanoseconds);
    let useful = summary.useful(all);
    let instead = useful.and_then(|useful| useful.then);
    vec![
        row.info.step.key.to_owned(),
        row.info.name.to_owned(),
        row.info.precision.to_string(),
        row.info.ours.to_string(),
        ns(summary.ns()),
        ns(summary.slowest().map(|(_, time)| time.ns)),
        format!("{:.2e}", summary.wrong_rate()),
        format!("{:.2e}", summary.wrong_rate_high()),
        format!("{:.2e}", row.median_error),
        format!("{:.2e}", summary.p999_error()),
        format!("{:.2e}", summary.worst(|row| row.worst_error).worst_error),
        format!("{:.2e}", summary.own_error()),
        useful.map_or(String::new(), |useful| format!("{:.2e}", useful.below)),
        instead.map_or(String::new(), |row| {
            format!("{} {}", row.info.name, row.info.precision)
        }),
    ]
}

fn nanoseconds(ns: f64) -> String {
    format!("{ns:.2}")
}

fn lines(header: &str, rows: impl Iterator<Item = Vec<String>>) -> String {
    let mut text = format!("{header}\n");
    for row in rows {
        let cells: Vec<String> = row.into_iter().map(quoted).collect();
        text += &(cells.join(",") + "\n");
    }
    text
}

/// The columns that do not depend on the machine.
fn verdict(row: &Row) -> [String; 20] {
    [
        row.info.step.key.to_owned(),
        row.info.name.to_owned(),
        row.info.precision.to_string(),
        row.info.ours.to_string(),
        row.family.to_owned(),
        row.parameter.to_owned(),
        row.value.to_string(),
        row.cases.to_string(),
        row.missed.to_string(),
        row.phantoms.to_string(),
        row.others.to_string(),
        format!("{:.3}", row.wrong_percent()),
        format!("{:.1e}", row.worst_wrong),
        row.info.step.wrong_unit.to_owned(),
        format!("{:.1e}", row.median_error),
        format!("{:.1e}", row.p999_error),
        format!("{:.1e}", row.worst_error),
        row.info.step.error_unit.to_owned(),
        row.ties.to_string(),
        format!("{:.1e}", row.wrong_percent_within()[1]),
    ]
}

fn quoted(cell: String) -> String {
    if cell.contains([',', '"', '\n']) {
        return format!("\"{}\"", cell.replace('"', "\"\""));
    }
    cell
}
