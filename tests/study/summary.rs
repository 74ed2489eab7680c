//! The recorded run that README shows fits the registry, and its front follows from its figures. The tests read that
//! run from `assets`, because times measured while other tests run would prove nothing.

use super::{cells, report};
use sightline::study::{self, Report, Row, SUMMARY_COLUMNS, Time, methods::registry};

/// Written by `cargo run --profile bench -- study --out study` on the day and machine that README names.
const RECORDED: &str = include_str!("../../assets/study-summary.csv");

/// A line of the recorded run.
struct Line {
    step: String,
    method: String,
    precision: String,
    ours: bool,
    ns: Option<f64>,
    wrong: f64,
    error: f64,
    on_front: bool,
    reason: String,
}

fn recorded() -> Vec<Line> {
    let mut lines = RECORDED.lines();
    assert_eq!(lines.next(), Some(SUMMARY_COLUMNS));
    let line = |line: &str| {
        let cells = cells(line);
        assert_eq!(cells.len(), 13, "{line}");
        let number = |at: usize| cells[at].parse::<f64>().ok();
        Line {
            step: cells[0].clone(),
            method: cells[1].clone(),
            precision: cells[2].clone(),
            ours: cells[3] == "true",
            ns: number(4),
            wrong: number(6).expect("a rate"),
            error: number(9).expect("an error"),
            on_front: cells[11] == "true",
            reason: cells[12].clone(),
        }
    };
    lines.map(line).collect()
}

#[test]
fn each_star_is_on_the_front_or_says_what_it_offers() {
    let ours: Vec<Line> = recorded().into_iter().filter(|line| line.ours).collect();
    assert_eq!(ours.len(), report().steps().len());
    for Line {
        step,
        on_front,
        reason,
        ..
    } in &ours
    {
        assert!(*on_front || !reason.is_empty(), "{step} is off the front");
    }
    let reasons = ours.iter().filter(|line| !line.reason.is_empty());
    // Rays are measured as a pick makes them: with bounds, which no other method has.
    assert!(reasons.count() <= 4);
}

#[test]
fn the_recorded_run_is_of_these_methods() {
    let known = |line: &Line| {
        (
            line.step.clone(),
            line.method.clone(),
            line.precision.clone(),
        )
    };
    let recorded = recorded();
    let recorded: Vec<_> = recorded
        .iter()
        .map(|line| (known(line), line.ours))
        .collect();
    let methods = registry().into_iter().map(|method| {
        let key = method.step.key.to_owned();
        let name = (key, method.name.to_owned(), method.precision.to_string());
        (name, method.ours)
    });
    assert_eq!(recorded, methods.collect::<Vec<_>>());
}

/// A recorded method is on the front exactly when no method at most as wrong is more than a tenth faster. Figures
/// printed alike may differ in later digits; where those digits decide, either answer is right.
#[test]
fn the_recorded_front_follows_from_its_figures() {
    let lines = recorded();
    let mut timed = 0;
    for own in &lines {
        let is_below = |theirs: f64, own: f64| theirs < own || (theirs, own) == (0.0, 0.0);
        let beats = |other: &&Line, is_sure: bool| {
            let mut figures = [(other.wrong, own.wrong), (other.error, own.error)].into_iter();
            let slack = if is_sure { 0.995 } else { 1.005 };
            let is_faster = match (other.ns, own.ns) {
                (Some(theirs), Some(own)) => theirs * 1.1 < own * slack,
                _ => (other.wrong, other.error) != (own.wrong, own.error),
            };
            let is_as_right =
                figures.all(|(theirs, own)| is_below(theirs, own) || !is_sure && theirs <= own);
            other.step == own.step && is_as_right && is_faster
        };
        let is_beaten = |is_sure: bool| lines.iter().any(|other| beats(&other, is_sure));
        assert!(
            !(own.on_front && is_beaten(true)),
            "{} {}",
            own.step,
            own.method
        );
        assert!(
            own.on_front || is_beaten(false),
            "{} {}",
            own.step,
            own.method
        );
        timed += u32::from(own.ns.is_some());
    }
    assert!(timed > 100, "{timed}");
}

fn timed(row: &Row, ns: f64) -> Row {
    Row {
        time: Some(Time {
            ns,
            quartiles: [ns; 2],
            learnt: ns,
        }),
        ..*row
    }
}

/// The summary's cells for the second of two methods with these times and these numbers of wrong decisions.
fn of_two(ns: [f64; 2], wrong: [usize; 2]) -> Vec<String> {
    let rows = report()
        .rows
        .iter()
        .filter(|row| row.info.step.key == "clip");
    let rows: Vec<&Row> = rows.take(2).collect();
    let row = |which: usize| Row {
        missed: wrong[which],
        phantoms: 0,
        others: 0,
        cases: 100,
        ..timed(rows[which], ns[which])
    };
    let report = Report {
        rows: vec![row(0), row(1)],
    };
    let text = study::summary_csv(&report);
    cells(text.lines().nth(2).expect("two methods"))
}

#[test]
fn a_front_is_speed_against_what_is_wrong() {
    let on_front = |ns, wrong| of_two(ns, wrong)[11] == "true";
    assert!(
        !on_front([10.0, 11.1], [0, 0]),
        "a tenth slower and no better"
    );
    assert!(on_front([10.0, 10.9], [0, 0]), "within a tenth");
    assert!(on_front([10.0, 30.0], [1, 0]), "slower, but right");
    assert!(!on_front([10.0, 30.0], [1, 1]));
}

/// The upper limits are Wilson's, as in textbooks' tables, and 3 / n where none of n is wrong.
#[test]
fn rates_have_their_interval() {
    let high = |wrong: usize| {
        of_two([1.0; 2], [0, wrong])[7]
            .parse::<f64>()
            .expect("a rate")
    };
    assert_eq!([0, 10, 50].map(high), [0.03, 0.174, 0.596]);
}
