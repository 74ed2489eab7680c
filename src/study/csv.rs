//! The study as a table for programs: one line a method at each value of each parameter.

use super::run::{Report, Row};
use std::fmt::Write;

/// The columns, in order. All but the last two are the same for a seed on every machine.
pub const COLUMNS: [&str; 19] = [
    "step",
    "method",
    "precision",
    "sightlines",
    "family",
    "parameter",
    "value",
    "cases",
    "missed",
    "phantoms",
    "others",
    "wrong_percent",
    "worst_wrong",
    "wrong_unit",
    "median_error",
    "worst_error",
    "error_unit",
    "ns",
    "ratio",
];

/// The whole report: RFC 4180 with a header line. Measured numbers have two digits, so that machines whose square
/// roots or tangents differ in the last bit agree; a value that is no number is `inf`.
#[must_use]
pub fn csv(report: &Report) -> String {
    let mut text = COLUMNS.join(",") + "\n";
    for row in &report.rows {
        let time = report.time_of(row);
        let ns = time.map_or(String::new(), |time| format!("{:.2}", time.ns));
        let ratio = time.map_or(String::new(), |time| format!("{:.3}", time.ratio));
        let cells = verdict(row).into_iter().chain([ns, ratio]);
        let cells: Vec<String> = cells.map(|cell| quoted(&cell)).collect();
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{}", cells.join(","));
    }
    text
}

/// The columns that do not depend on the machine.
fn verdict(row: &Row) -> [String; 17] {
    [
        row.step.key.to_owned(),
        row.method.to_owned(),
        row.precision.to_string(),
        row.ours.to_string(),
        row.family.to_owned(),
        row.parameter.to_owned(),
        row.value.to_string(),
        row.cases.to_string(),
        row.missed.to_string(),
        row.phantoms.to_string(),
        row.others.to_string(),
        format!("{:.3}", row.wrong_percent()),
        format!("{:.1e}", row.worst_wrong),
        row.step.wrong_unit.to_owned(),
        format!("{:.1e}", row.median_error),
        format!("{:.1e}", row.worst_error),
        row.step.error_unit.to_owned(),
    ]
}

fn quoted(cell: &str) -> String {
    if cell.contains([',', '"', '\n']) {
        format!("\"{}\"", cell.replace('"', "\"\""))
    } else {
        cell.to_owned()
    }
}
