//! Charts are written, and no words lie over each other.

use sightline::study::{
    self, Effort, Report,
    chart::{
        self, charts,
        picture::{Anchor, Mark, Picture},
    },
};
use std::collections::HashSet;

/// With times, since speed is half of a chart.
fn timed() -> Report {
    study::run(
        Effort {
            cases: 30,
            picks: 8,
            rounds: 1,
            seed: 1,
        },
        None,
        &|_, _| {},
    )
}

#[test]
fn are_written_and_say_something() {
    let folder = tempfile::tempdir().expect("a folder");
    let charts = charts(&timed());
    assert_eq!(charts.len(), 4);
    for (stem, picture) in charts {
        no_words_overlap(stem, &picture);
        chart::write(folder.path(), stem, &picture).expect("written");
        let svg = std::fs::read_to_string(folder.path().join(stem).with_extension("svg"));
        let svg = svg.expect("an SVG file");
        assert!(
            svg.trim_end().ends_with("</svg>") && svg.matches("<text").count() > 4,
            "{stem}"
        );
        let pixels = picture.pixels().expect("pixels");
        let colours: HashSet<_> = pixels.iter().collect();
        assert!(colours.len() > 100, "{stem} has {} colours", colours.len());
        let png = std::fs::metadata(folder.path().join(stem).with_extension("png"));
        assert!(png.expect("a PNG file").len() > 10_000, "{stem}");
    }
}

/// Boxes about the words, by the typeface's mean width.
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
        let length = 0.46 * size * f64::from(u32::try_from(text.chars().count()).expect("short"));
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
