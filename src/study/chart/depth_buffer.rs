//! Shows the depths that a depth buffer tells apart. One part has every number of a small format on the curve of 1 / z,
//! after Reed, Depth Precision Visualized, 2015. The other has the least step of real formats against distance.

use super::prelude::*;
use crate::study::methods::depth::Mapping;

/// Mappings with name, index into [`COLOURS`] (black beyond the last) and line width. A line that another one covers is
/// wider.
const MAPPINGS: [(&str, Mapping, usize, u32); 5] = [
    ("standard, 32-bit float", Mapping::STANDARD, 1, 9),
    ("standard, 24-bit integer", Mapping::STANDARD_24, 5, 6),
    ("reversed, 24-bit integer", Mapping::REVERSED_24, 0, 2),
    (ENDLESS, Mapping::INFINITE, 2, 7),
    (OURS, Mapping::REVERSED, usize::MAX, 3),
];
const ENDLESS: &str = "reversed, infinite far plane, float";
const OURS: &str = "reversed, 32-bit float: Sightline's";

/// Near and far plane of the upper panels, and of the lower one.
const MARKS: [f64; 2] = [1.0, 10.0];
const STEPS: [f64; 2] = [0.1, 1e6];

/// The chart.
pub fn chart() -> Picture {
    let title = "What the depth buffer tells apart";
    let line = "Above: every number of a 5-bit float, and the view depth that it stands for. Below: the least step of real formats, near \
                0.1, far 1e6; lower is finer.";
    let mut picture = page(900.0, title, &[line]);
    let [standard, reversed] = ["Standard: near is 0", "Reversed: near is 1"];
    marks(&mut picture, standard, Mapping::STANDARD, 110.0);
    marks(&mut picture, reversed, Mapping::REVERSED, 890.0);
    steps(&mut picture);
    picture
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

fn marks(picture: &mut Picture, title: &str, mapping: Mapping, left: f64) {
    let [near, far] = MARKS;
    let [from, to] = [[left, 136.0], [left + 660.0, 420.0]];
    let x = Axis::linear(far, [from[0], to[0]]);
    let y = Axis::linear(1.0, [to[1], from[1]]);
    let panel = Panel { x, y, from, to };
    let names = ["view depth (near 1, far 10)", "stored"];
    panel.draw(picture, title, names, "");
    let case = |depth: f64| DepthCase::new(depth, MARKS);
    let mut depths = Vec::new();
    for number in small_floats() {
        let depth = mapping.read(number, &case(near));
        let at = panel.at(depth, f64::from(number));
        depths.push(depth);
        let (foot, mark) = ([at[0], to[1]], [at[0], to[1] - 12.0]);
        let guide = vec![[from[0], at[1]], at, foot];
        picture.line(guide, [0xb8, 0xc6, 0xd6], 1, false);
        picture.line(vec![mark, foot], COLOURS[1], 3, false);
    }
    let curve = (0..=180_u16).map(|i| near + (far - near) * f64::from(i) / 180.0);
    let curve = curve.map(|depth| panel.at(depth, f64::from(mapping.stored(&case(depth)))));
    picture.line(curve.collect(), INK, 3, false);
    depths.sort_by(f64::total_cmp);
    let gaps = depths.windows(2).map(|pair| pair[1] - pair[0]);
    let words = format!("widest gap {:.1}", gaps.fold(0.0, f64::max));
    let at = [to[0] - 8.0, 0.5 * (from[1] + to[1])];
    picture.text(at, Anchor::Right, 20.0, INK, words);
}

fn steps(picture: &mut Picture) {
    const PER_DECADE: i32 = 8;
    let decades = -PER_DECADE + 1..6 * PER_DECADE;
    let depths = decades.map(|i| libm::exp10(f64::from(i) / f64::from(PER_DECADE)));
    let depths: Vec<f64> = depths.collect();
    let curves = MAPPINGS.map(|(name, mapping, colour, width)| {
        let step = |z: &f64| Some((*z, resolution(mapping, *z)?));
        let steps = depths.iter().filter_map(step);
        let colour = COLOURS.get(colour).copied().unwrap_or_default();
        (name, colour, width, steps.collect::<Vec<_>>())
    });
    let ys = curves.iter().flat_map(|(_, _, _, steps)| steps);
    let ys: Vec<f64> = ys.map(|(_, step)| *step).collect();
    let xs = [depths[0], STEPS[1]];
    let panel = Panel::new([110.0, 500.0], [1180.0, 840.0], &xs, &ys);
    panel.draw(picture, "", ["view depth", "least step (same unit)"], "0");
    let mut ends: Vec<(f64, f64, &str, Colour)> = Vec::new();
    for (name, colour, width, steps) in curves {
        let points = steps.into_iter().map(|(z, step)| panel.at(z, step));
        let points: Vec<[f64; 2]> = points.collect();
        if let Some(&[x, y]) = points.last() {
            ends.push((y, x, name, colour));
        }
        picture.line(points, colour, width, false);
    }
    // Labels stand beside the lines' ends and move down where they would overlap.
    ends.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut lowest = f64::NEG_INFINITY;
    for (y, x, name, colour) in ends {
        lowest = y.max(lowest + 28.0);
        picture.line(vec![[x + 2.0, y], [1204.0, lowest]], colour, 1, false);
        picture.rectangle([1206.0, lowest - 6.0], [1222.0, lowest + 6.0], colour);
        picture.text([1230.0, lowest], Anchor::Left, 19.0, QUIET, name);
    }
}

/// The distance in depth between the buffer's number for a depth and its next number away from the eye; none after the
/// last.
fn resolution(mapping: Mapping, depth: f64) -> Option<f64> {
    let case = DepthCase::new(depth, STEPS);
    let stored = mapping.stored(&case);
    let next = mapping.next(stored);
    let step = mapping.read(next, &case) - mapping.read(stored, &case);
    (step > 0.0 && step.is_finite() && (0.0..=1.0).contains(&next)).then_some(step)
}
