//! The study finds methods wrong where they are known to be, and Sightline's methods within their derived bounds. The
//! same seed gives the same report.
#![cfg(feature = "window")]
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

mod breaks;
mod budget;
mod by_hand;
mod charts;
mod complete;
mod gallery;
mod jobs;
mod no_adapter;
mod readme;
#[path = "../common/real_files.rs"]
mod real_files;
mod summary;
mod views;
mod worked;

use sightline::study::{
    self, COLUMNS, Effort, Report, Row,
    methods::registry,
    step::{About, Precision},
};
use std::{collections::HashSet, sync::OnceLock};

/// One run that many tests read.
fn report() -> &'static Report {
    static REPORT: OnceLock<Report> = OnceLock::new();
    REPORT.get_or_init(|| {
        let effort = Effort {
            cases: 250,
            picks: 40,
            rounds: 0,
            seed: 1,
        };
        study::run(effort, &|_, _| {})
    })
}

/// Sightline's rows, of every step that the registry names.
fn own_rows() -> impl Iterator<Item = &'static Row> {
    let own = report().rows.iter().filter(|row| row.info.ours);
    let steps: HashSet<_> = own.clone().map(|row| row.info.step.key).collect();
    let named = registry().iter().filter(|method| method.ours).count();
    assert_eq!(steps.len(), named, "{steps:?}");
    own
}

/// A method's rows in a family, by the parameter's value.
fn rows(step: &str, method: &str, precision: Precision, family: &str) -> Vec<&'static Row> {
    let wanted = |row: &&Row| {
        (row.info.step.key, row.info.name, row.info.precision) == (step, method, precision)
            && row.family == family
    };
    let rows: Vec<_> = report().rows.iter().filter(wanted).collect();
    assert!(!rows.is_empty(), "{method} {precision} has no {family}");
    rows
}

fn row(step: &str, method: &str, precision: Precision, family: &str, value: f64) -> &'static Row {
    let rows = rows(step, method, precision, family);
    rows.into_iter()
        .find(|row| row.value == value)
        .expect("a row of that value")
}

#[test]
fn registry_names_each_method_once_and_where_it_is_from() {
    let methods = registry();
    let names: HashSet<_> = methods
        .iter()
        .map(|m| (m.step.key, m.name, m.precision))
        .collect();
    assert_eq!(names.len(), methods.len(), "two methods of one name");
    assert!(
        methods.iter().all(|method| method.source.len() > 10),
        "a source for each"
    );
    let steps: HashSet<_> = methods.iter().map(|method| method.step.key).collect();
    for step in steps {
        let ours = methods
            .iter()
            .filter(|method| method.step.key == step && method.ours)
            .count();
        assert_eq!(ours, 1, "{step} has one method of ours");
    }
}

#[test]
fn same_seed_gives_the_same_verdicts() {
    let effort = Effort {
        cases: 12,
        picks: 4,
        rounds: 0,
        seed: 9,
    };
    let csv = |seed| study::csv(&study::run(Effort { seed, ..effort }, &|_, _| {}));
    let first = csv(9);
    assert_eq!(first, csv(9));
    assert_ne!(first, csv(10));
}

#[test]
fn what_this_program_does_stays_within_its_bounds() {
    for row in own_rows() {
        let share = row.of_bound.expect("a bound");
        assert!(
            share <= 1.0,
            "{} {} {}: {share} of the bound",
            row.info.step.key,
            row.family,
            row.value
        );
    }
}

/// An infinite bound, or a step in which no error is above zero, would prove nothing.
#[test]
fn bounds_of_values_say_something() {
    let with_errors = |step: &About| !step.error_unit.is_empty();
    let steps: Vec<About> = report().steps().into_iter().filter(with_errors).collect();
    assert_eq!(steps.len(), 8, "{steps:?}");
    for step in steps {
        let rows = || own_rows().filter(move |row| row.info.step == step);
        let first = rows().next().expect("a row");
        let bound = first.bound.expect("a bound");
        assert!(bound.is_finite(), "{first:?}");
        assert!(rows().any(|row| row.of_bound > Some(0.0)), "{first:?}");
    }
}

#[test]
fn what_this_program_does_decides_right() {
    for row in own_rows() {
        assert_eq!(
            row.worst_wrong, 0.0,
            "{} {} {}",
            row.info.step.key, row.family, row.value
        );
        let wrong = row.wrong();
        assert_eq!(
            wrong, 0,
            "{} {} {}",
            row.info.step.key, row.family, row.value
        );
    }
}

#[test]
fn csv_parses_back() {
    let text = study::csv(report());
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some(COLUMNS));
    let mut count = 0;
    for (line, row) in lines.zip(&report().rows) {
        let cells = cells(line);
        assert_eq!(cells.len(), COLUMNS.split(',').count(), "{line}");
        assert_eq!(
            (cells[0].as_str(), cells[1].as_str()),
            (row.info.step.key, row.info.name)
        );
        assert_eq!(cells[6].parse(), Ok(row.value), "{line}");
        assert_eq!(cells[8].parse(), Ok(row.missed), "{line}");
        let error: f64 = cells[16].parse().expect("a number");
        assert!(
            error == row.worst_error || (error / row.worst_error - 1.0).abs() < 0.06,
            "{line}"
        );
        count += 1;
    }
    assert_eq!(count, report().rows.len());
}

/// The cells of a CSV line, by RFC 4180.
fn cells(line: &str) -> Vec<String> {
    let mut cells = vec![String::new()];
    let mut quoted = false;
    for c in line.chars() {
        match c {
            '"' => quoted = !quoted,
            ',' if !quoted => cells.push(String::new()),
            c => cells.last_mut().expect("one at least").push(c),
        }
    }
    cells
}

#[test]
fn table_names_every_method() {
    let table = study::table(report());
    for method in registry() {
        assert!(
            table.contains(method.name),
            "{} is not in\n{table}",
            method.name
        );
    }
}
