//! The study as text: a table for each step.

use super::{
    methods::{
        files::{self, FileCase},
        registry,
    },
    prelude::*,
    timing::processor,
};
use std::fmt::Write;

/// The tables of every step.
pub fn table(report: &Report) -> String {
    let mut text = format!("Times in nanoseconds, on {}.\n\n", processor());
    let [general, own] = report.split().map(Option::unwrap_or_default);
    for step in report.steps() {
        let summaries = own.summaries(step);
        if !summaries.is_empty() {
            section(&mut text, SCENE, step, &summaries);
            if let Some(need) = need(step, &summaries) {
                // Writing to a string cannot fail.
                let _ = writeln!(text, "  {need}\n");
            }
        }
        section(&mut text, "every workload", step, &general.summaries(step));
    }
    text
}

fn header(step: About, decides: bool, measures: bool) -> Vec<String> {
    let timed = ["ns", "quartiles", "ratio", "learnt", "worst ns", "in"];
    let first = ["method", "", "front"].into_iter().chain(timed);
    let mut header: Vec<String> = first.map(str::to_owned).collect();
    if decides {
        header.extend(["wrong %", "95 %", "in", "ties %"].map(str::to_owned));
    }
    if !step.wrong_unit.is_empty() {
        header.extend([format!("off by ({})", step.wrong_unit), "in".to_owned()]);
    }
    if measures {
        header.extend(["median", "99.9 %"].map(str::to_owned));
        header.extend([
            format!("worst error ({})", step.error_unit),
            "in".to_owned(),
        ]);
    }
    header.push("of bound".to_owned());
    header
}

fn section(text: &mut String, of: &str, step: About, summaries: &[Summary<'_>]) {
    let Some(first) = summaries.first().map(Summary::ns) else {
        return;
    };
    let [decides, measures] = [step.wrong_unit, step.error_unit].map(|unit| !unit.is_empty());
    let decides = decides || !measures;
    let mut rows = vec![header(step, decides, measures)];
    rows.extend(summaries.iter().map(|summary| {
        let method = summary.method;
        let mut cells = vec![method.method.to_owned(), method.precision.to_string()];
        let is_on_front = summary.is_on_front(summaries);
        cells.push(if is_on_front { "yes" } else { "" }.to_owned());
        cells.extend(match (method.time, summary.slowest()) {
            (Some(of), Some((slowest, worst))) => [
                time(of.ns),
                of.quartiles.map(time).join(".."),
                first.map_or(String::new(), |first| format!("{:.2}", of.ns / first)),
                time(of.learnt),
                time(worst.ns),
                place(slowest, worst.ns),
            ],
            _ => std::array::from_fn(|_| String::new()),
        });
        if decides {
            let row = summary.worst(Row::wrong_percent);
            let [low, high] = row.wrong_percent_within();
            let within = if low == 0.0 {
                format!("<{}", percent(high))
            } else {
                format!("{}..{}", percent(low), percent(high))
            };
            cells.extend([
                percent(row.wrong_percent()),
                within,
                place(row, row.wrong_percent()),
                percent(100.0 * summary.tie_rate()),
            ]);
        }
        if !step.wrong_unit.is_empty() {
            let row = summary.worst(|row| row.worst_wrong);
            cells.extend([number(row.worst_wrong), place(row, row.worst_wrong)]);
        }
        if measures {
            let row = summary.worst(|row| row.worst_error);
            cells.extend([
                number(summary.method.median_error),
                number(summary.p999_error()),
                number(row.worst_error),
                place(row, row.worst_error),
            ]);
        }
        let share = summary.of_bound().map(|share| format!("{share:.2}"));
        cells.push(share.unwrap_or("-".to_owned()));
        cells
    }));
    let columns = rows[0].len();
    // Methods that cannot run on this machine.
    let known = |method: &MethodInfo| {
        let mut known = summaries.iter().map(|summary| summary.method.method_key());
        known.any(|known| known == method.key())
    };
    let mut methods = registry();
    methods.retain(|method| method.step == step && !known(method));
    rows.extend(methods.into_iter().map(|method| {
        let precision = method.precision.to_string();
        let why = "no graphics adapter".to_owned();
        let mut cells = vec![method.name.to_owned(), precision, why];
        cells.resize(columns, String::new());
        cells
    }));
    let About { name, job, .. } = step;
    let _ = writeln!(text, "{name}, {of}\nEach method is given {job}.");
    aligned(text, &rows);
    notes(text, step, summaries);
    text.push('\n');
}

/// Rows of cells in columns: words aligned to the left, numbers to the right.
fn aligned(text: &mut String, rows: &[Vec<String>]) {
    let lengths = |column: usize| rows.iter().map(move |row| row[column].chars().count());
    for row in rows {
        let cells = row.iter().enumerate().map(|(column, cell)| {
            let width = lengths(column).max().unwrap_or(0);
            if column < 2 || rows[0][column] == "in" {
                format!("{cell:<width$}")
            } else {
                format!("{cell:>width$}")
            }
        });
        let line = cells.collect::<Vec<_>>().join("  ");
        let _ = writeln!(text, "  {}", line.trim_end());
    }
}

/// The lines below a table: how fast files are read, and what a method offers where others are faster.
fn notes(text: &mut String, step: About, summaries: &[Summary<'_>]) {
    if step == FileCase::ABOUT {
        for summary in summaries {
            let Some(ns) = summary.ns() else { continue };
            let (name, precision) = summary.method.method_key();
            #[expect(clippy::cast_precision_loss, reason = "a few bytes")]
            let speed = 1e3 * files::BYTES as f64 / ns;
            let _ = writeln!(text, "  {name}, {precision}: {speed:.0} MB/s");
        }
    }
    for summary in summaries {
        if let Some(reason) = summary.method.reason {
            let _ = writeln!(text, "  {} offers: {reason}", summary.method.method);
        }
    }
}

/// Names the fastest method whose mistakes no picture shows: no wrong decision, and no error above a twentieth of a pixel, a
/// quarter of a degree or a ten-thousandth.
fn need(step: About, summaries: &[Summary<'_>]) -> Option<String> {
    let most = match step.error_unit {
        "px" => 0.05,
        "degrees" => 0.25,
        _ => 1e-4,
    };
    let does = |summary: &&Summary<'_>| {
        let is_good = |row: &&Row| row.wrong() == 0 && row.worst_error <= most;
        summary.rows.iter().all(is_good)
    };
    let timed = summaries.iter().filter(does);
    let timed = timed.filter_map(|summary| Some((summary.method, summary.ns()?)));
    let (fastest, _) = timed.min_by(|a, b| a.1.total_cmp(&b.1))?;
    let (name, precision) = fastest.method_key();
    Some(format!(
        "The fastest that is right here: {name}, {precision}."
    ))
}

/// Family and parameter of a row; empty where the figure found there is 0.
fn place(row: &Row, found: f64) -> String {
    if found == 0.0 {
        String::new()
    } else if row.parameter == "-" {
        row.family.to_owned()
    } else {
        format!("{} {}", row.family, short(row.value))
    }
}

/// Nanoseconds with two or three digits.
fn time(ns: f64) -> String {
    if ns < 1e4 {
        format!("{ns:.1}")
    } else {
        format!("{:.0}k", ns / 1e3)
    }
}

/// Per cent.
fn percent(value: f64) -> String {
    match value {
        0.0 => "0".to_owned(),
        value if value >= 1.0 => format!("{value:.1}"),
        value if value >= 0.001 => format!("{value:.4}"),
        value => format!("{value:.1e}"),
    }
}

/// A measured number with two digits.
pub fn number(value: f64) -> String {
    match value {
        0.0 => "0".to_owned(),
        value if value.is_infinite() => "fails".to_owned(),
        10.0..1000.0 => format!("{value:.0}"),
        1.0..10.0 => format!("{value:.1}"),
        0.01..1.0 => format!("{value:.3}"),
        value => format!("{value:.1e}"),
    }
}

/// A parameter's value.
pub fn short(value: f64) -> String {
    if (0.01..1e4).contains(&value) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}
