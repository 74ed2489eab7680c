//! A report judges differing pixels by class and count, and painting tints and marks them. The reports are handmade.

use sightline::{
    camera::Viewport,
    image::{Id, Image},
    look,
    verify::{Class, Disagreement, Report, Verdict, paint},
};

fn at(pixel: [u32; 2], class: Class, strain: f64) -> Disagreement {
    Disagreement {
        pixel,
        drawn: Id::default(),
        picked: Id::default(),
        class,
        strain,
        outline_px: 0.0,
        outline_error_px: 0.0,
        depth: [f64::NAN; 2],
    }
}

/// The verdict if nothing was drawn and `count` of 100 pixels differ, all of one class.
fn nothing_drawn(class: Class, count: usize) -> Verdict {
    nothing_drawn_of(&vec![class; count])
}

/// The verdict if nothing was drawn and pixels of these classes differ.
fn nothing_drawn_of(classes: &[Class]) -> Verdict {
    let differ = (0..).zip(classes).map(|(x, class)| at([x, 0], *class, 0.5));
    let report = Report {
        pixels: 100,
        picked: classes.len(),
        disagreements: differ.collect(),
        ..Report::default()
    };
    let turned = Report {
        drawn: report.picked,
        picked: 0,
        ..report.clone()
    };
    match report.verdict() {
        Verdict::NothingDrawn(count) => {
            assert_eq!(turned.verdict(), Verdict::NothingPicked(count));
        }
        other => assert_eq!(turned.verdict(), other),
    }
    report.verdict()
}

#[test]
fn the_worst_pixel_is_of_the_gravest_class_and_of_those_has_the_most_strain() {
    let [weak, worst, harmless] = [
        at([1, 1], Class::Depth, 0.2),
        at([2, 1], Class::Depth, 0.7),
        at([3, 1], Class::Edge, 0.9),
    ];
    let mut report = Report {
        disagreements: vec![weak, worst, harmless],
        ..Report::default()
    };
    assert_eq!(report.worst().map(|at| at.pixel), Some([2, 1]));
    report.disagreements.clear();
    assert_eq!(report.worst(), None);
}

#[test]
fn pixels_that_differ_are_counted_on_outlines_and_off_them() {
    let report = Report {
        pixels: 100,
        outline: 8,
        outline_differ: 2,
        disagreements: (0..5).map(|x| at([x, 0], Class::Edge, 0.5)).collect(),
        ..Report::default()
    };
    assert_eq!((report.same(), report.differ_off_outlines()), (95, 3));
    assert_eq!(report.share_of_outline().to_bits(), 0.25_f64.to_bits());
    assert_eq!(Report::default().share_of_outline().to_bits(), 0);
}

/// A speck of up to 4 pixels may be missed, and a face in a section's plane may be cut away. All else must show.
#[test]
fn a_picture_of_nothing_agrees_only_with_a_speck_or_a_section() {
    assert_eq!(nothing_drawn(Class::Edge, 4), Verdict::Agrees);
    assert_eq!(nothing_drawn(Class::Edge, 5), Verdict::NothingDrawn(5));
    assert_eq!(nothing_drawn(Class::Depth, 1), Verdict::NothingDrawn(1));
    assert_eq!(nothing_drawn(Class::Section, 50), Verdict::Agrees);
    let with_edges = |edge| [vec![Class::Edge; edge], vec![Class::Section; 20]].concat();
    assert_eq!(nothing_drawn_of(&with_edges(20)), Verdict::Agrees);
    assert_eq!(nothing_drawn_of(&with_edges(21)), Verdict::NothingDrawn(41));
    assert_eq!(
        nothing_drawn(Class::BeyondF32, 50),
        Verdict::NothingDrawn(50)
    );
    assert_eq!(
        nothing_drawn(Class::Unexplained, 3),
        Verdict::Unexplained(3)
    );
}

/// A colour of higher luma gives a paler grey. A tint is mixed in by half. A mark has a ring of half its brightness.
#[test]
fn the_picture_is_grey_with_tints_and_marks() {
    let size = Viewport::new(7, 4).expect("a size");
    let mut colours = Image::new(size, vec![[200; 3]; 28]);
    for (pixel, colour) in [[255, 0, 0], [0, 255, 0], [0, 0, 255]]
        .into_iter()
        .enumerate()
    {
        colours.pixels_mut()[pixel] = colour;
    }
    let marked = at([5, 2], Class::Unexplained, 1.0);
    let painted = paint(&colours, &[[1, 3]], &[marked]);
    // 64 plus half of 0.2126, 0.7152 and 0.0722 of 255.
    let brightness = [0, 1, 2].map(|x| painted.at(x, 0)[0]);
    assert_eq!(brightness, [64 + 27, 64 + 91, 64 + 9]);
    let tint = look::IN_ONE_PLACE.0.map(|c| c.midpoint(164));
    for (x, y) in painted.positions().filter(|(_, y)| *y > 0) {
        let expected = match (x, y) {
            (1, 3) => tint,
            (5, 2) => look::WRONG.0,
            (4..=6, 1..=3) => look::WRONG.0.map(|c| c / 2),
            _ => [164; 3],
        };
        assert_eq!(painted.at(x, y), expected, "{x} {y}");
    }
}
