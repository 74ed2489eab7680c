//! README's counts of scenes and cases and its worst rate of wrong decisions are those of the study.

use sightline::{
    scene::gallery::GALLERY,
    study::{
        Effort,
        methods::triangles::TriangleCase,
        step::{Case, Precision::F32},
        swap::AnyStep,
    },
};

/// Whether README has these words, across line breaks.
fn says(words: &str) -> bool {
    one_line(include_str!("../../README.md").lines()).contains(words)
}

/// Whether the page of module `study` has them.
pub fn page_says(words: &str) -> bool {
    let lines = include_str!("../../src/study/mod.rs").lines();
    one_line(lines.filter_map(|line| line.strip_prefix("//!"))).contains(words)
}

fn one_line<'a>(lines: impl Iterator<Item = &'a str>) -> String {
    let words = lines.flat_map(str::split_whitespace);
    words.collect::<Vec<_>>().join(" ")
}

fn word(count: usize) -> &'static str {
    ["none", "one", "two", "three", "four", "five", "six"]
        .into_iter()
        .chain(["seven", "eight", "nine", "ten", "eleven", "twelve"])
        .chain(["thirteen"])
        .nth(count)
        .expect("a word for it")
}

#[test]
fn it_counts_scenes_and_cases() {
    let scenes = word(GALLERY.len());
    assert!(says(&format!("opens {scenes} small scenes")), "{scenes}");
    let values = TriangleCase::FAMILIES.iter().map(|f| f.values.len());
    let cases = values.sum::<usize>() * Effort::FULL.cases;
    let cases = format!("none of {},{:03} cases", cases / 1000, cases % 1000);
    assert!(says(&cases), "{cases}");
}

/// README's figure is that of the worst workload.
#[test]
fn it_says_how_much_moeller_trumbore_gets_wrong() {
    let step = AnyStep::of::<TriangleCase>();
    let rows = (step.rows)("exactly through edges", Effort::FULL, None, &|| true);
    let (mut wrong, mut ours) = (0.0_f64, 0);
    for row in rows.expect("nobody stops it") {
        if row.info.key() == ("Moeller-Trumbore", F32) {
            wrong = wrong.max(row.wrong_percent());
        }
        assert!(!row.info.ours || row.wrong_percent() == 0.0, "{row:?}");
        ours += usize::from(row.info.ours);
    }
    assert!(ours > 0, "Sightline's is among them");
    let words = format!("up to {wrong:.0} % of a workload wrong");
    assert!(says(&words), "{words}");
}
