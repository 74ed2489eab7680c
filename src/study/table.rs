//! The study as text: a table for each step.

use super::{
    methods::registry,
    prelude::*,
    timing::{Time, processor},
};
use std::{fmt::Write, iter};

/// The tables of every step.
pub fn table(report: &Report) -> String {
    let mut text = format!("Times in nanoseconds, on {}.\n\n", processor());
    for step in report.steps() {
        let summaries = report.summaries(step);
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{}\nEach method is given {}.", step.name, step.job);
        aligned(&mut text, &columns(step, &summaries));
        notes(&mut text, step, &summaries);
        text.push('\n');
    }
    text
}

/// The columns of a step's table, each with its header first.
fn columns(step: About, summaries: &[Summary<'_>]) -> Vec<Vec<String>> {
    let column = |header: &str, cell: &dyn Fn(&Summary<'_>) -> String| -> Vec<String> {
        let cells = summaries.iter().map(cell);
        iter::once(header.to_owned()).chain(cells).collect()
    };
    let timed = |header: &str, cell: &dyn Fn(Time, (&Row, Time)) -> String| {
        column(header, &|of| match (of.method.time, of.slowest()) {
            (Some(own), Some(slowest)) => cell(own, slowest),
            _ => String::new(),
        })
    };
    let at_worst = |header: &str, of: fn(&Row) -> f64, cell: fn(f64) -> String| {
        let value = column(header, &|summary| cell(of(summary.worst(of))));
        let found = column("in", &|summary| {
            let row = summary.worst(of);
            place(row, of(row))
        });
        [value, found]
    };
    let first = summaries.first().and_then(Summary::ns);
    let ratio = |ns: f64| first.map_or(String::new(), |first| format!("{:.2}", ns / first));
    let mut columns: Vec<Vec<String>> = vec![
        column("method", &|of| of.method.info.name.to_owned()),
        column("", &|of| of.method.info.precision.to_string()),
        timed("ns", &|own, _| time(own.ns)),
        timed("quartiles", &|own, _| own.quartiles.map(time).join("..")),
        timed("ratio", &|own, _| ratio(own.ns)),
        timed("learnt", &|own, _| time(own.learnt)),
        timed("worst ns", &|_, (_, worst)| time(worst.ns)),
        timed("in", &|_, (row, worst)| place(row, worst.ns)),
    ];
    let [decides, measures] = [step.wrong_unit, step.error_unit].map(|unit| !unit.is_empty());
    if decides || !measures {
        let [wrong, found] = at_worst("wrong %", Row::wrong_percent, percent);
        let worst = |of: &Summary<'_>| of.worst(Row::wrong_percent).wrong_percent_within();
        let within = column("95 %", &|of| match worst(of) {
            [0.0, high] => format!("<{}", percent(high)),
            [low, high] => format!("{}..{}", percent(low), percent(high)),
        });
        let ties = column("ties %", &|of| percent(100.0 * of.tie_rate()));
        columns.extend([wrong, within, found, ties]);
    }
    if decides {
        let header = format!("off by ({})", step.wrong_unit);
        columns.extend(at_worst(&header, |row| row.worst_wrong, number));
    }
    if measures {
        columns.push(column("median", &|of| number(of.method.median_error)));
        columns.push(column("99.9 %", &|of| number(of.p999_error())));
        let header = format!("worst error ({})", step.error_unit);
        columns.extend(at_worst(&header, |row| row.worst_error, number));
    }
    let share = |of: &Summary<'_>| of.of_bound().map(|share| format!("{share:.2}"));
    let share = |of: &Summary<'_>| share(of).unwrap_or("-".to_owned());
    columns.push(column("of bound", &share));
    // Methods that cannot run on this machine.
    let ran: Vec<_> = summaries.iter().map(|of| of.method.info.key()).collect();
    let mut absent = registry();
    absent.retain(|method| method.step == step && !ran.contains(&method.key()));
    for method in absent {
        let why = "no graphics adapter".to_owned();
        let cells = [method.name.to_owned(), method.precision.to_string(), why];
        let cells = cells.into_iter().chain(iter::repeat(String::new()));
        for (column, cell) in columns.iter_mut().zip(cells) {
            column.push(cell);
        }
    }
    columns
}

/// Columns side by side, words aligned to the left, numbers to the right.
fn aligned(text: &mut String, columns: &[Vec<String>]) {
    for row in 0..columns[0].len() {
        let cells = columns.iter().enumerate().map(|(index, column)| {
            let widths = column.iter().map(|cell| cell.chars().count());
            let (cell, width) = (&column[row], widths.max().unwrap_or(0));
            if index < 2 || column[0] == "in" {
                format!("{cell:<width$}")
            } else {
                format!("{cell:>width$}")
            }
        });
        let line = cells.collect::<Vec<_>>().join("  ");
        let _ = writeln!(text, "  {}", line.trim_end());
    }
}

/// The line below a table: for which errors Sightline's method is useful, and what does elsewhere.
fn notes(text: &mut String, step: About, summaries: &[Summary<'_>]) {
    let ours = summaries.iter().find(|of| of.method.info.ours);
    let Some(useful) = ours.and_then(|ours| ours.useful(summaries)) else {
        return;
    };
    let unit = [step.wrong_unit, step.error_unit]
        .into_iter()
        .find(|unit| !unit.is_empty());
    let error = |error: f64| match unit {
        Some(unit) => format!("{} {unit}", number(error)),
        None => format!("{} % wrong", percent(100.0 * error)),
    };
    let told = match useful.then {
        None => "useful at any error from its own on: none is faster".to_owned(),
        Some(row) => {
            let instead = format!("{} in {}", row.info.name, row.info.precision);
            if useful.is_anywhere() {
                format!(
                    "useful below {}; from there on {instead} is faster",
                    error(useful.below)
                )
            } else {
                format!("useful at no error: {instead} does as well and is faster")
            }
        }
    };
    let _ = writeln!(
        text,
        "  Sightline's is {told}. Its own error is {}.",
        error(useful.from)
    );
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

/// Nanoseconds with one decimal, or whole thousands from 10,000 on.
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

/// A measured number, rounded to a few digits.
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
