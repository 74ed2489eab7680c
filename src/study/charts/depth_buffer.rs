//! Shows the depths that a depth buffer tells apart. Above: every number of a small format on the curve of 1 / z, after
//! Reed, Depth Precision Visualized, 2015. Below: the least step of real formats, as a share of the distance.

use super::prelude::*;
use crate::study::methods::depth::Mapping;

/// The formats, by their methods' names in the registry, with a line width: a line that another one covers is wider.
const MAPPINGS: [(&str, Mapping, u32); 5] = [
    ("standard, 32-bit float", Mapping::STANDARD, 14),
    ("standard, 24-bit integer", Mapping::STANDARD_24, 6),
    ("reversed, 24-bit integer", Mapping::REVERSED_24, 6),
    ("logarithmic, 32-bit float", Mapping::LOGARITHMIC, 6),
    (OURS, Mapping::REVERSED, 8),
];
const OURS: &str = "reversed, 32-bit float: Sightline's";

/// Near and far plane of the upper panels, and of the lower one.
const MARKS: [f64; 2] = [1.0, 10.0];
const STEPS: [f64; 2] = [0.1, 1e6];
/// Height of the upper panels.
const HEIGHT_OF_MARKS: i32 = 640;

/// Draws the chart.
pub fn draw<B: DrawingBackend>(page: &Page<B>) -> Drawn<B> {
    let share = |mapping: Mapping, depth: f64| step(mapping, depth).map(|step| step / depth);
    let depths: Vec<f64> = depths().collect();
    let curves = MAPPINGS.map(|(name, mapping, width)| {
        let points = depths
            .iter()
            .filter_map(|z| Some([*z, share(mapping, *z)?]));
        (name, width, points.collect::<Vec<[f64; 2]>>())
    });
    let worst = |wanted: &str| {
        let (_, _, points) = curves.iter().find(|(name, ..)| *name == wanted)?;
        points.iter().map(|[_, share]| *share).reduce(f64::max)
    };
    let message = format!(
        "Reversed float depth has steps of {:.0e} of any distance; standard 24-bit depth, of up to {:.0} %",
        worst(OURS).unwrap_or_default(),
        100.0 * worst("standard, 24-bit integer").unwrap_or_default(),
    );
    let line = "Above: every number of a 5-bit float, and the view depth that it stands for. Below: the least step that real formats tell apart, as a share \
                of the distance; near 0.1, far 1e6.";
    let rest = head(page, &message, &[line.to_owned()])?;
    let (above, below) = rest.split_vertically(HEIGHT_OF_MARKS);
    let (left, right) = above.split_horizontally(1540);
    marks(page, &left, "Standard: near is 0", Mapping::STANDARD)?;
    marks(page, &right, "Reversed: near is 1", Mapping::REVERSED)?;
    let x = Axis::powers_of_ten("view depth", depths.iter().copied());
    let shares = || {
        curves
            .iter()
            .flat_map(|(_, _, points)| points)
            .map(|[_, share]| *share)
    };
    let y = Axis::powers_of_ten("step / depth (less is better)", shares()).wider([0.2, 0.5]);
    let panel = panel(page, &below, "", [x, y], 760)?;
    let mut ends = Vec::new();
    for (name, width, points) in &curves {
        let info = DepthCase::methods().find(|method| method.info.name == *name);
        let info = info.map(|method| method.info).unwrap_or_default();
        let ink = colour(&info).unwrap_or(GREY);
        panel.line(points, ink, *width, false)?;
        if let Some([x, y]) = points.last() {
            ends.push((panel.at(*x, *y), (*name).to_owned(), ink));
        }
    }
    panel.end_labels(ends)
}

/// Depths between the lower panel's planes, eight in each power of ten.
fn depths() -> impl Iterator<Item = f64> {
    const PER_DECADE: i32 = 8;
    let decades = -PER_DECADE + 1..6 * PER_DECADE;
    decades.map(|i| libm::exp10(f64::from(i) / f64::from(PER_DECADE)))
}

/// Every number in \[0, 1\] of a float with two bits of exponent and three of fraction.
fn small_floats() -> impl Iterator<Item = f32> {
    let of = |exponent: u8| {
        let lowest = f32::from(exponent.min(1));
        let scale = 0.5_f32.powi(4 - i32::from(exponent.max(1)));
        (0..8_u8).map(move |fraction| scale * (lowest + 0.125 * f32::from(fraction)))
    };
    let numbers = (0..4).flat_map(of).chain([1.0]);
    numbers.filter(|number| *number <= 1.0)
}

/// The numbers of a small format as stored by a mapping, and the widest gap between the depths that they stand for.
fn marks<B: DrawingBackend>(
    page: &Page<B>,
    part: &Page<B>,
    title: &str,
    mapping: Mapping,
) -> Drawn<B> {
    const GUIDE: Ink = RGBColor(0xb8, 0xc6, 0xd6);
    let [near, far] = MARKS;
    let x = Axis::linear("view depth (near 1, far 10)", far, 2.0);
    let y = Axis::linear("stored", 1.0, 0.25);
    let panel = panel(page, part, title, [x, y], 0)?;
    let case = |depth: f64| DepthCase::new(depth, MARKS);
    let mut depths = Vec::new();
    for number in small_floats() {
        let depth = mapping.read(number, &case(near));
        let number = f64::from(number);
        depths.push(depth);
        panel.line(
            &[[0.0, number], [depth, number], [depth, 0.0]],
            GUIDE,
            2,
            false,
        )?;
        let (x, foot) = panel.at(depth, 0.0);
        page.draw(&PathElement::new(
            [(x, foot), (x, foot - 26)],
            QUIET.stroke_width(6),
        ))?;
    }
    let curve = (0..=180_u16).map(|i| near + (far - near) * f64::from(i) / 180.0);
    let curve = curve.map(|depth| [depth, f64::from(mapping.stored(&case(depth)))]);
    panel.line(&curve.collect::<Vec<_>>(), INK, 6, false)?;
    depths.sort_by(f64::total_cmp);
    let gaps = depths.windows(2).map(|pair| pair[1] - pair[0]);
    let text = format!("widest gap {:.1}", gaps.fold(0.0, f64::max));
    let [_, top, right, bottom] = panel.frame();
    words(
        page,
        &text,
        (right - 16, i32::midpoint(top, bottom)),
        INK,
        Side::Left,
    )
}

/// The distance in depth between the buffer's number for a depth and its next number away from the eye; none after the
/// last.
fn step(mapping: Mapping, depth: f64) -> Option<f64> {
    let case = DepthCase::new(depth, STEPS);
    let stored = mapping.stored(&case);
    let next = mapping.next(stored);
    let step = mapping.read(next, &case) - mapping.read(stored, &case);
    (step > 0.0 && step.is_finite() && (0.0..=1.0).contains(&next)).then_some(step)
}
