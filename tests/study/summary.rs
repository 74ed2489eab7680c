//! The recorded run whose charts README shows fits the registry, and where methods are useful follows from its figures.
//! The tests read that run from `assets`, because times measured while other tests run would prove nothing.

use super::{cells, readme::page_says, report};
use num_traits::ToPrimitive;
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
    own_error: f64,
    useful_below: Option<f64>,
    instead: String,
}

fn recorded() -> Vec<Line> {
    let mut lines = RECORDED.lines();
    assert_eq!(lines.next(), Some(SUMMARY_COLUMNS));
    let line = |line: &str| {
        let cells = cells(line);
        assert_eq!(cells.len(), 14, "{line}");
        let number = |at: usize| cells[at].parse::<f64>().ok();
        Line {
            step: cells[0].clone(),
            method: cells[1].clone(),
            precision: cells[2].clone(),
            ours: cells[3] == "true",
            ns: number(4),
            own_error: number(11).expect("an error"),
            useful_below: number(12),
            instead: cells[13].clone(),
        }
    };
    lines.map(line).collect()
}

/// The page of module `study` says of each step where Sightline's method is useful.
#[test]
fn the_page_says_where_each_star_is_useful() {
    let ours: Vec<Line> = recorded().into_iter().filter(|line| line.ours).collect();
    assert_eq!(ours.len(), report().steps().len());
    let (mut always, mut never) = (Vec::new(), Vec::new());
    for line in &ours {
        match line.useful_below {
            Some(below) if below.is_infinite() => always.push(&*line.step),
            Some(below) if below <= 1.1 * line.own_error => never.push(&*line.step),
            Some(below) => {
                let words = format!("below {below:.0e}");
                assert!(page_says(&words), "{}: {words}", line.step);
            }
            None => assert_eq!(line.step, "depth", "all others are timed"),
        }
    }
    for (steps, words) in [
        (always, "At any error, none is faster"),
        (never, "At no error"),
    ] {
        let words = format!("{words}: {}.", steps.join(", "));
        assert!(page_says(&words), "{words}");
    }
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

/// A method is useful up to the error of the best one that is more than a tenth faster. Figures printed alike may
/// differ in later digits; where those decide, either answer is right.
#[test]
fn where_recorded_methods_are_useful_follows_from_their_figures() {
    let lines = recorded();
    let mut timed = 0;
    for own in &lines {
        let Some(own_ns) = own.ns else {
            assert_eq!(own.useful_below, None, "{}", own.method);
            continue;
        };
        let least = |slack: f64| {
            let rivals = lines.iter().filter(|other| other.step == own.step);
            let own_ns = own_ns * slack;
            let is_faster = |ns: f64| 1.1 * ns < own_ns && ns + 0.5 < own_ns;
            let faster = rivals.filter(|other| other.ns.is_some_and(is_faster));
            faster
                .map(|other| other.own_error)
                .fold(f64::INFINITY, f64::min)
        };
        let [most, least] = [0.995, 1.005].map(least);
        let below = own.useful_below.expect("it was timed");
        assert!(
            least <= below && below <= most,
            "{} {}: {below}",
            own.step,
            own.method
        );
        assert_eq!(below.is_infinite(), own.instead.is_empty());
        timed += 1;
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
        worst_wrong: 0.01 * wrong[which].to_f64().expect("few"),
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
fn a_method_is_useful_where_none_as_good_is_faster() {
    let useful = |ns, wrong| {
        let cells = of_two(ns, wrong);
        [cells[11].clone(), cells[12].clone(), cells[13].clone()]
    };
    let other = of_two([10.0, 11.1], [0, 0])[13].clone();
    assert!(!other.is_empty());
    assert_eq!(useful([10.0, 11.1], [0, 0]), ["0.00e0", "0.00e0", &other]);
    assert_eq!(
        useful([10.0, 10.9], [0, 0]),
        ["0.00e0", "inf", ""],
        "within a tenth"
    );
    assert_eq!(
        useful([10.0, 30.0], [1, 0]),
        ["0.00e0", "1.00e-2", &other],
        "slower, but right"
    );
    assert_eq!(useful([10.0, 30.0], [1, 2]), ["2.00e-2", "1.00e-2", &other]);
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
