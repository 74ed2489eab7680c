//! What the depth buffer still tells apart, against distance.

use super::{
    axis::{Labels, Panel},
    picture::{Anchor, COLOURS, Colour, INK, Picture, QUIET},
};
use crate::study::methods::depth::{DepthCase, Mapping};

/// A mapping with its name, colour and line width: those below are wider than those that cover them.
const MAPPINGS: [(&str, Mapping, Colour, u32); 5] = [
    ("standard, 32-bit float", Mapping::STANDARD, COLOURS[1], 9),
    (
        "standard, 24-bit integer",
        Mapping::STANDARD_24,
        COLOURS[5],
        6,
    ),
    (
        "reversed, 24-bit integer",
        Mapping::REVERSED_24,
        COLOURS[0],
        2,
    ),
    (
        "reversed, infinite far plane, 32-bit float",
        Mapping::INFINITE,
        COLOURS[2],
        7,
    ),
    (
        "reversed, 32-bit float: Sightline's",
        Mapping::REVERSED,
        [0, 0, 0],
        3,
    ),
];

/// The chart: near 0.1, far 1e6.
#[must_use]
pub fn chart(title: &str) -> Picture {
    const NEAR: f64 = 0.1;
    const FAR: f64 = 1e6;
    const PER_DECADE: i32 = 8;
    let mut picture = Picture::new(1600, 900);
    picture.text([40.0, 36.0], Anchor::Left, 27.0, INK, title);
    let line = format!(
        "The least step in depth that the buffer shows, between a near plane at {NEAR} and a far plane at {FAR:e}. Lower is finer."
    );
    picture.text([40.0, 68.0], Anchor::Left, 17.0, QUIET, line);
    let decades = -PER_DECADE + 1..6 * PER_DECADE;
    let depths: Vec<f64> = decades
        .map(|i| 10_f64.powf(f64::from(i) / f64::from(PER_DECADE)))
        .collect();
    let curves = MAPPINGS.map(|(name, mapping, colour, width)| {
        let steps: Vec<f64> = depths
            .iter()
            .map(|z| resolution(mapping, *z, NEAR, FAR))
            .collect();
        (name, colour, width, steps)
    });
    let xs = [depths[0], depths[depths.len() - 1]];
    let ys: Vec<f64> = curves
        .iter()
        .flat_map(|(_, _, _, steps)| steps)
        .copied()
        .filter(|y| y.is_finite())
        .collect();
    let panel = Panel::new([130.0, 120.0], [1080.0, 810.0], &xs, &ys, -16);
    panel.draw(
        &mut picture,
        &Labels {
            title: "",
            x: "view depth (world units)",
            has_x_ticks: true,
            y: "least step in depth (world units)",
            zero: "0",
            least: None,
        },
    );
    let mut ends: Vec<(f64, &str, Colour)> = Vec::new();
    for (name, colour, width, steps) in &curves {
        let points = depths
            .iter()
            .zip(steps)
            .filter(|(_, step)| step.is_finite());
        let points: Vec<[f64; 2]> = points.map(|(z, step)| panel.at(*z, *step)).collect();
        if let Some(&[_, y]) = points.last() {
            ends.push((y, name, *colour));
        }
        picture.line(points, *colour, *width, false);
    }
    // Labels beside the lines' ends, from the top, moved apart where lines end together.
    ends.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut lowest = f64::NEG_INFINITY;
    for (y, name, colour) in ends {
        lowest = y.max(lowest + 26.0);
        picture.line(vec![[1082.0, y], [1104.0, lowest]], colour, 1, false);
        picture.text([1110.0, lowest], Anchor::Left, 19.0, colour, name);
    }
    picture
}

/// From what the buffer holds for a depth to the depth of the next number that it can hold, away from the eye.
fn resolution(mapping: Mapping, depth: f64, near: f64, far: f64) -> f64 {
    #[expect(clippy::cast_possible_truncation, reason = "the card's input is f32")]
    let case = DepthCase {
        depth: depth as f32,
        near,
        far,
        parallel: false,
    };
    let stored = mapping.stored(&case);
    let next = mapping.next(stored);
    let step = mapping.read(next, &case) - mapping.read(stored, &case);
    // Beyond the last number there is nothing left to tell apart.
    if step > 0.0 && (0.0..=1.0).contains(&next) {
        step
    } else {
        f64::INFINITY
    }
}
