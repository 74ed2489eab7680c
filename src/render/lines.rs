//! Lines in the world. They are in the picture, hidden by what is in front of them, but not in the ids.

use super::{
    shader_structs::LineVertex,
    view_units::{depth_origin, view_unit},
};
use crate::{camera::View, colour::Srgb, look::Background};
use glam::DVec3;

/// A line one pixel wide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// One end, in world space.
    pub from: DVec3,
    /// The other end, in world space.
    pub to: DVec3,
    /// Its colour; no light falls on it.
    pub colour: Srgb,
    /// How much of what is behind each end it covers, from 0 to 1; in between it fades from the one to the other.
    pub opacity: [f32; 2],
}

impl Line {
    /// A line from one end to the other that covers what is behind it.
    pub const fn new(from: DVec3, to: DVec3, colour: Srgb) -> Self {
        Self {
            from,
            to,
            colour,
            opacity: [1.0; 2],
        }
    }
}

/// The ends of all lines in view space, computed relative to the eye in `f64`.
pub(super) fn vertices(view: &View, lines: &[Line], background: Background) -> Vec<LineVertex> {
    let (origin, unit) = (depth_origin(view), view_unit(view));
    let ends = lines.iter().flat_map(|line| {
        let [at_from, at_to] = line.opacity;
        [
            (line.from, line.colour, at_from),
            (line.to, line.colour, at_to),
        ]
    });
    ends.map(|(end_world, colour, opacity)| LineVertex {
        position: {
            let at = view.camera.to_view(end_world);
            let with_buffer_depth = at.truncate().extend(at.z - origin);
            (unit * with_buffer_depth.extend(at.z)).as_vec4().to_array()
        },
        colour: background.over(colour).map(|channel| channel * opacity),
        opacity,
    })
    .collect()
}
