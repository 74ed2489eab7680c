//! Every chart is written as SVG and PNG, and no words in it overlap.

use sightline::study::{
    self, Effort, Report,
    chart::{
        charts,
        picture::{Anchor, Mark, Picture, text_width},
    },
    methods::registry,
};
use std::{collections::HashSet, sync::OnceLock};

/// A report with times, since half of a chart is speed.
fn timed() -> &'static Report {
    static REPORT: OnceLock<Report> = OnceLock::new();
    REPORT.get_or_init(|| {
        let effort = Effort {
            cases: 30,
            picks: 8,
            rounds: 1,
            seed: 1,
        };
        study::run(effort, None, &|_, _| {})
    })
}

#[test]
fn are_written_and_say_something() {
    let folder = tempfile::tempdir().expect("a folder");
    let charts = charts(timed());
    assert_eq!(charts.len(), 5);
    every_formula_is_named(&charts[0].1);
    for (stem, picture) in charts {
        no_words_overlap(stem, &picture);
        study::save_chart(folder.path(), stem, &picture).expect("written");
        let svg = std::fs::read_to_string(folder.path().join(stem).with_extension("svg"));
        let svg = svg.expect("an SVG file");
        assert!(
            svg.trim_end().ends_with("</svg>") && svg.matches("<text").count() > 4,
            "{stem}"
        );
        let pixels = picture.pixels().expect("pixels");
        let colours: HashSet<_> = pixels.iter().collect();
        assert!(colours.len() > 40, "{stem} has {} colours", colours.len());
        let png = std::fs::metadata(folder.path().join(stem).with_extension("png"));
        assert!(png.expect("a PNG file").len() > 10_000, "{stem}");
    }
}

/// A save never writes into an existing file: a new file replaces it once the new one is complete.
#[test]
fn what_an_earlier_run_left_is_replaced_whole() {
    let folder = tempfile::tempdir().expect("a folder");
    let [out, kept] = ["out", "kept"].map(|name| folder.path().join(name));
    std::fs::create_dir(&out).expect("a folder");
    std::fs::create_dir(&kept).expect("a folder");
    let report = timed();
    study::save(&out, report).expect("written");
    let names = || {
        let entries = std::fs::read_dir(&out).expect("a folder");
        entries.map(|entry| entry.expect("a file").file_name())
    };
    for name in names() {
        std::fs::write(out.join(&name), "earlier").expect("writable");
        std::fs::hard_link(out.join(&name), kept.join(&name)).expect("a link");
    }
    study::save(&out, report).expect("written");
    assert_eq!(names().count(), 12, "two tables, five charts twice");
    for name in names() {
        assert_eq!(
            std::fs::read(kept.join(&name)).expect("a file"),
            b"earlier",
            "{name:?}"
        );
        assert!(
            std::fs::metadata(out.join(&name)).expect("a file").len() > 1000,
            "{name:?}"
        );
    }
}

/// Each formula has one label in the large panels, and Sightline has one in each of the three.
fn every_formula_is_named(front: &Picture) {
    let words: Vec<&str> = texts(front).map(|(_, text)| text).collect();
    let steps = ["triangle", "sphere", "pick"];
    let methods = registry()
        .into_iter()
        .filter(|method| steps.contains(&method.step.key));
    let ours = methods.clone().filter(|method| method.ours);
    assert_eq!(ours.count(), steps.len());
    for method in methods {
        let name = if method.ours {
            "Sightline"
        } else {
            method.name
        };
        let named = words.iter().filter(|words| {
            let rest = words.strip_prefix(name);
            rest.is_some_and(|rest| {
                rest.is_empty()
                    || rest.starts_with(", up to")
                    || rest.ends_with('s') && rest.starts_with(", ") && rest.len() < 10
            })
        });
        let count = if method.ours { 3 } else { 1 };
        assert_eq!(named.count(), count, "{name}: {words:?}");
    }
}

fn texts(picture: &Picture) -> impl Iterator<Item = ([f64; 2], &str)> {
    picture.marks.iter().filter_map(|mark| match mark {
        Mark::Text { at, text, .. } => Some((*at, text.as_str())),
        _ => None,
    })
}

/// Fails if the boxes around two texts overlap, or if one leaves the picture.
fn no_words_overlap(stem: &str, picture: &Picture) {
    let mut boxes: Vec<([f64; 4], &str)> = Vec::new();
    for mark in &picture.marks {
        let Mark::Text {
            at: [x, y],
            anchor,
            size,
            upwards,
            text,
            ..
        } = mark
        else {
            continue;
        };
        let length = text_width(text, *size);
        let start = match anchor {
            Anchor::Left => 0.0,
            Anchor::Middle => -0.5 * length,
            Anchor::Right => -length,
        };
        let half = 0.36 * size;
        let area = if *upwards {
            [x - half, y - 0.5 * length, x + half, y + 0.5 * length]
        } else {
            [x + start, y - half, x + start + length, y + half]
        };
        let [left, top, right, bottom] = area;
        let inside = left >= 0.0
            && top >= 0.0
            && right <= f64::from(picture.width)
            && bottom <= f64::from(picture.height);
        assert!(
            inside || text.is_empty(),
            "{stem}: {text:?} leaves the picture"
        );
        for (other, words) in &boxes {
            let apart = area[0] >= other[2]
                || other[0] >= area[2]
                || area[1] >= other[3]
                || other[1] >= area[3];
            assert!(
                apart || text.is_empty(),
                "{stem}: {text:?} lies over {words:?}"
            );
        }
        boxes.push((area, text));
    }
}
