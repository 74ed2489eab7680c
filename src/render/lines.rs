//! Lines in the world. They are in the picture, hidden by what is in front of them, but not in the ids.

use super::{
    gpu::{Gpu, GpuError},
    shader_structs::LineEnd,
    view_units::{depth_origin, view_unit},
};
use crate::{
    camera::{DepthMapping, View},
    colour::Srgb,
    look::Background,
};
use glam::DVec3;

/// A line, as wide as [`Renderer::scale_factor`](super::Renderer::scale_factor) says.
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
    /// Whether it ends at the near and the far plane, as surfaces do. Else the parts of it before near and beyond far
    /// are drawn over the background alone: never over a surface.
    pub is_clipped: bool,
}

impl Line {
    /// A line from one end to the other that covers what is behind it, between near and far.
    pub const fn new(from: DVec3, to: DVec3, colour: Srgb) -> Self {
        Self {
            from,
            to,
            colour,
            opacity: [1.0; 2],
            is_clipped: true,
        }
    }
}

/// The lines of a picture on the GPU.
pub(super) struct LineBuffer {
    pub count: u32,
    buffer: wgpu::Buffer,
}

impl LineBuffer {
    pub fn new(
        gpu: &Gpu,
        view: &View,
        lines: &[Line],
        background: Background,
    ) -> Result<Self, GpuError> {
        let ends = ends(view, lines, background);
        Ok(Self {
            count: u32::try_from(ends.len()).unwrap_or(u32::MAX),
            buffer: gpu.buffer("lines", wgpu::BufferUsages::VERTEX, &ends)?,
        })
    }

    /// Draws each as a strip of two triangles.
    pub fn record(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_vertex_buffer(0, self.buffer.slice(..));
        pass.draw(0..4, 0..self.count);
    }
}

/// The ends of all lines in view space, computed relative to the eye in `f64`. A line that is not clipped is in up to
/// three parts: the one between near and far has depths of its own, and those outside lie just before the background.
fn ends(view: &View, lines: &[Line], background: Background) -> Vec<[LineEnd; 2]> {
    let (origin, unit, lens) = (depth_origin(view), view_unit(view), view.camera.lens());
    let mut all = Vec::with_capacity(lines.len());
    for line in lines {
        let [from, to] = [line.from, line.to].map(|end_world| view.camera.to_view(end_world));
        let colour = background.over(line.colour);
        let end = |share: f64, is_between: bool| {
            let at = from.lerp(to, share);
            let [at_from, at_to] = line.opacity.map(f64::from);
            #[expect(clippy::cast_possible_truncation, reason = "of a colour")]
            let opacity = (at_from + (at_to - at_from) * share) as f32;
            let buffer_depth = if is_between {
                at.z - origin
            } else {
                before_background(lens.depth) * lens.w(at.z) / lens.depth_row().0
            };
            let position = at.truncate().extend(buffer_depth).extend(at.z);
            LineEnd {
                position: (unit * position).as_vec4().to_array(),
                colour: colour.map(|channel| channel * opacity),
                opacity,
            }
        };
        let mut between = [0.0, 1.0];
        if !line.is_clipped {
            let crossing = |depth: f64| {
                let share = (depth - from.z) / (to.z - from.z);
                // It is no number where the line lies in the plane.
                if share > 0.0 { share.min(1.0) } else { 0.0 }
            };
            between = [lens.near, lens.far].map(crossing);
            between.sort_by(f64::total_cmp);
        }
        let [first, second] = between;
        for (shares, is_between) in [
            ([0.0, first], false),
            ([first, second], true),
            ([second, 1.0], false),
        ] {
            if shares[0] < shares[1] {
                all.push(shares.map(|share| end(share, is_between)));
            }
        }
    }
    all
}

/// The depth in NDC of what only the background is behind. It must not round to the background's own.
fn before_background(depth: DepthMapping) -> f64 {
    match depth {
        DepthMapping::Reversed => libm::exp2(-60.0),
        DepthMapping::Standard => 1.0 - libm::exp2(-21.0),
    }
}
