//! Every chart is written as SVG and PNG, says what it must, and no words in it overlap.

use plotters_backend::{
    BackendColor, BackendCoord, BackendTextStyle, DrawingBackend, DrawingErrorKind, FontTransform,
    text_anchor::{HPos, VPos},
};
use sightline::study::{self, Effort, Report, charts::Chart, methods::registry};
use std::{cell::RefCell, collections::HashSet, convert::Infallible, rc::Rc, sync::OnceLock};

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
        study::run(effort, &|_, _| {})
    })
}

/// Words on a chart and the area that they take: left, top, right, bottom.
type Words = (String, [i32; 4]);

/// A backend that keeps the words.
struct Page(Rc<RefCell<Vec<Words>>>);

type Drawn = Result<(), DrawingErrorKind<Infallible>>;

impl DrawingBackend for Page {
    type ErrorType = Infallible;

    fn get_size(&self) -> (u32, u32) {
        Chart::SIZE
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        Ok(())
    }

    fn draw_pixel(&mut self, _: BackendCoord, _: BackendColor) -> Drawn {
        Ok(())
    }

    fn draw_text<S: BackendTextStyle>(
        &mut self,
        text: &str,
        style: &S,
        (x, y): BackendCoord,
    ) -> Drawn {
        let measured = style.layout_box(text);
        let ((x0, y0), (x1, y1)) = measured.unwrap_or_else(|_| panic!("{text:?} has no size"));
        let (width, height) = (x1 - x0, y1 - y0);
        let left = match style.anchor().h_pos {
            HPos::Left => 0,
            HPos::Center => -width / 2,
            HPos::Right => -width,
        };
        let top = match style.anchor().v_pos {
            VPos::Top => 0,
            VPos::Center => -height / 2,
            VPos::Bottom => -height,
        };
        let corners = [(left, top), (left + width, top + height)];
        let turned = corners.map(|(x, y)| match style.transform() {
            FontTransform::Rotate270 => (y, -x),
            _ => (x, y),
        });
        let [(ax, ay), (bx, by)] = turned.map(|(dx, dy)| (x + dx, y + dy));
        let area = [ax.min(bx), ay.min(by), ax.max(bx), ay.max(by)];
        self.0.borrow_mut().push((text.to_owned(), area));
        Ok(())
    }
}

fn words(chart: Chart) -> Vec<Words> {
    let all = Rc::new(RefCell::new(Vec::new()));
    chart.draw(timed(), Page(Rc::clone(&all))).expect("drawn");
    let words = all.borrow().clone();
    words
        .into_iter()
        .filter(|(text, _)| !text.is_empty())
        .collect()
}

#[test]
fn words_stay_apart_and_within_the_page() {
    let (width, height) = Chart::SIZE;
    for chart in Chart::ALL {
        let words = words(chart);
        assert!(words.len() > 15, "{chart:?} says {words:?}");
        for (i, (text, area)) in words.iter().enumerate() {
            let [left, top, right, bottom] = *area;
            let is_within = left >= 0
                && top >= 0
                && right.unsigned_abs() <= width
                && bottom.unsigned_abs() <= height;
            assert!(is_within, "{chart:?}: {text:?} leaves the page: {area:?}");
            for (other, [l, t, r, b]) in &words[..i] {
                let apart = left >= *r || *l >= right || top >= *b || *t >= bottom;
                assert!(apart, "{chart:?}: {text:?} lies over {other:?}");
            }
        }
    }
}

/// The title is a message made of the run's numbers; processor and number of cases stand below it.
#[test]
fn titles_say_what_was_found() {
    let titles = [
        (Chart::Front, "Never wrong takes ", " times"),
        (
            Chart::Heat,
            "Half a pixel off somewhere: ",
            " of Sightline's",
        ),
        (
            Chart::SharedEdge,
            "Rays slip between two triangles in ",
            "in Sightline's none",
        ),
        (
            Chart::Stability,
            "A ray by inverse(P V) in f32 is a pixel off from ",
            " px",
        ),
        (
            Chart::Depth,
            "Reversed float depth has steps of 1e-7 of any distance",
            " of up to ",
        ),
        (
            Chart::Cost,
            "Certainty about a triangle takes ",
            " us where all do",
        ),
    ];
    for (chart, begins, has) in titles {
        let words = words(chart);
        let (title, _) = &words[0];
        assert!(title.starts_with(begins) && title.contains(has), "{title}");
        let measured = ![Chart::SharedEdge, Chart::Depth].contains(&chart);
        let about = words
            .iter()
            .take(3)
            .any(|(text, _)| text.contains(" rays a point") && text.contains(study::processor()));
        assert_eq!(about, measured, "{chart:?}: {words:?}");
    }
}

/// Every whole pick has a name in the first chart, and Sightline has one in each of its three panels.
#[test]
fn the_front_names_who_is_compared() {
    let words = words(Chart::Front);
    let count = |name: &str| words.iter().filter(|(text, _)| text == name).count();
    assert_eq!(count("Sightline"), 3);
    for name in [
        "Moeller-Trumbore",
        "Embree robust",
        "Woop watertight",
        "Hearn & Baker",
    ] {
        assert_eq!(count(name), 1, "{name}");
    }
    let picks = registry()
        .into_iter()
        .filter(|method| method.step.key == "pick" && !method.ours);
    for method in picks {
        assert_eq!(count(method.name), 1, "{}", method.name);
    }
}

/// Where every ray meets one of two triangles, the exact methods let none through, and the first formula's tile says
/// how many slip through it.
#[test]
fn the_shared_edge_tells_leaks() {
    let words = words(Chart::SharedEdge);
    let place = words.iter().position(|(text, _)| text == "Sightline");
    let place = place.expect("a tile");
    assert_eq!(words[place + 1].0, "leaks: none");
    let leaks = words
        .iter()
        .filter(|(text, _)| text.contains(" leaks: ") && text.contains('%'));
    assert!(leaks.count() >= 2, "{words:?}");
}

/// An infinite error has a place of its own, and not that of the largest number.
#[test]
fn what_fails_is_not_drawn_as_a_number() {
    let words = words(Chart::Stability);
    let fails = words.iter().filter(|(text, _)| text == "fails").count();
    assert_eq!(fails, 2, "the far eye and the far plane");
}

#[test]
fn are_written_as_svg_and_png() {
    let folder = tempfile::tempdir().expect("a folder");
    for chart in Chart::ALL {
        let stem = chart.stem();
        study::save_chart(folder.path(), chart, timed()).expect("written");
        let svg = std::fs::read_to_string(folder.path().join(stem).with_extension("svg"));
        let svg = svg.expect("an SVG file");
        assert!(
            svg.trim_end().ends_with("</svg>") && svg.matches("<text").count() > 15,
            "{stem}"
        );
        let pixels = chart.pixels(timed()).expect("pixels");
        let (width, height) = Chart::SIZE;
        assert_eq!(pixels.len(), (width / 2 * (height / 2)) as usize);
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
    assert_eq!(names().count(), 14, "two tables, six charts twice");
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
