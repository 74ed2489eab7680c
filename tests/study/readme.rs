//! What README says of the study is what it is. Figures that depend on a machine's speed are not held here.

use super::report;
use sightline::{
    scene::gallery::GALLERY,
    study::{
        Effort,
        chart::{self, picture::Mark},
        methods::triangles::TriangleCase,
        step::{Case, Precision::F32},
        swap::AnyStep,
    },
};
use std::collections::HashSet;

/// Whether README says this, wherever its lines break.
fn says(words: &str) -> bool {
    let text = include_str!("../../README.md");
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    text.contains(words)
}

fn word(count: usize) -> &'static str {
    ["none", "one", "two", "three", "four", "five", "six"]
        .into_iter()
        .chain(["seven", "eight", "nine", "ten", "eleven", "twelve"])
        .chain(["thirteen"])
        .nth(count)
        .expect("a word for it")
}

fn capital(word: &str) -> String {
    word[..1].to_uppercase() + &word[1..]
}

#[test]
fn it_counts_panels_scenes_and_cases() {
    let steps = capital(word(report().steps().len()));
    assert!(says(&format!("![{steps} panels, one a step")), "{steps}");
    let (_, stability) = chart::charts(report()).swap_remove(1);
    let families = report().rows.iter();
    let titles = families.map(|row| format!("{}: {}", row.step.name, row.family));
    let titles: HashSet<String> = titles.collect();
    let shown = stability.marks.iter().filter(|mark| match mark {
        Mark::Text { text, .. } => titles.contains(text),
        _ => false,
    });
    let panels = capital(word(shown.count()));
    assert!(says(&format!("![{panels} panels: each method")), "{panels}");
    let scenes = word(GALLERY.len());
    assert!(says(&format!("opens {scenes} small scenes")), "{scenes}");
    let values = TriangleCase::FAMILIES.iter().map(|f| f.values.len());
    let cases = values.sum::<usize>() * Effort::FULL.cases;
    let cases = format!("none of {},{:03} cases", cases / 1000, cases % 1000);
    assert!(says(&cases), "{cases}");
}

/// The workload of the whole study that is worst for it.
#[test]
fn it_says_how_much_moeller_trumbore_gets_wrong() {
    let rows = AnyStep::of::<TriangleCase>().rows("exactly through edges", Effort::FULL);
    let mut wrong = 0.0_f64;
    for row in rows {
        if (row.method, row.precision) == ("Moeller-Trumbore", F32) {
            wrong = wrong.max(row.wrong_percent());
        }
        assert!(!row.ours || row.wrong_percent() == 0.0, "{row:?}");
    }
    let words = format!("up to {wrong:.0} % of a workload wrong");
    assert!(says(&words), "{words}");
}
