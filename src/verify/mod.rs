//! Compares drawing with picks: each pixel's (object, triangle) that the GPU drew, and the one that the ray through the
//! pixel's centre hits. Each difference is explained by geometry, or is a defect.
//!
//! A rasteriser snaps vertices to a grid, mostly of 1/256 pixel, and computes in `f32`; the pick does neither. The
//! bounds on how far that may move a surface at a pixel come from camera, scene and the driver's rounding alone, never
//! from the pixels that differ or their neighbours. Where drawn and picked differ, one of these has to hold:
//!
//! * **edge**: the drawn or the picked surface has an outline (projected edges, the cut of the near plane, the horizon of
//!   a plane that passes the eye, a sphere's rim) so near the pixel's centre that the grid and `f32`
//!   ([`transform`](crate::render::transform), [`sphere`](crate::render::sphere)) may move it across, and the surface's
//!   depth fits that answer;
//! * **depth**: both surfaces cover the centre, and the depth buffer may order them either way, by bounds below the
//!   ceiling or because they are closer together than the ceiling. The empty buffer counts as a surface at the far
//!   plane; the near plane counts as a surface, too;
//! * **section**: a section cuts the drawn or the picked surface so near the centre that the grid and the shaders'
//!   `f32` test ([`ScreenSection`](crate::render)) leave open whether it is kept, and the surface's depth fits that
//!   answer;
//! * **f32 limit**: an edge, but `f32` may move the outline by more than the grid does;
//! * **beyond f32**: one of these, but by a bound above the ceiling ([`OUTLINE_CEILING_PX`], [`DEPTH_CEILING`]);
//!   or a bound that does not exist or exceeds the picture; or a surface well between near and far that the buffer
//!   cannot tell from nothing. Drawing in `f32` cannot render the view faithfully; casting rays can. An example is the
//!   cut of a section through a lens of 0.02 degrees. No such pixel occurs where all bounds lie below the ceiling and
//!   the buffer can tell every surface from nothing;
//! * **unexplained**: anything else: a defect.
//!
//! An edge across which the surface continues is no outline: a neighbour may show there, but not what lies behind.
//! Where only front sides show, rounding the corners may flip the winding of a narrow back face. It is then drawn while
//! its neighbours stay culled, so all of its edges are outlines.
//!
//! A bound that is infinite or NaN explains nothing: the pixel is then beyond f32. If nothing is drawn but something is
//! picked, or the reverse, the comparison fails, whatever explains the single pixels. There are two exceptions: at most
//! four pixels differ, all *edge*; or all are *section* or *edge*, at least half of them *section*
//! ([`Report::verdict`]).
//!
//! Where the bounds leave the order of two surfaces open, the surfaces lie *in one place* ([`Places`]), whether or not
//! drawing and pick differ there.
//!
//! # What the bounds assume
//!
//! * The driver's `f32` sums, products and conversions are rounded once, in any order, fused or not; a division takes
//!   2.5 units in the last place (WGSL's rules).
//! * Corners move by at most half a grid step along each axis. Direct3D requires a grid of 1/256 pixel, Vulkan of 1/16,
//!   and wgpu does not report it: each device's grid is measured ([`Rasteriser::grid_px`](crate::render::Rasteriser)).
//! * A pixel is covered when its centre lies within the edges through the rounded corners. Clipping at the picture's
//!   border makes new corners between old ones and rounds them.
//! * What is interpolated over a triangle belongs to its corners as given (lavapipe) or as rounded (an NVIDIA H100).
//!   How far rounding corners moves a surface is bounded for both. The roundings of slopes are those of the corners as
//!   given.
//! * Depth over a triangle is the plane through its corners, with slopes rounded relative to their terms. For a
//!   triangle that leaves the picture, it is the plane through the corners of its clipped part, or as accurate.
//!   `SwiftShader` does not keep to this: its plane goes through the whole triangle's corners as projected, rounded to
//!   its grid and to `f32`, however far outside or behind the eye they lie. It may therefore show triangles far larger
//!   than the picture at wrong depths, and leave out those with a corner exactly beside the eye. Those pixels are
//!   called unexplained, since nothing bounds them.
//! * The same numbers drawn twice give the same pixels and depths, to the bit; of equal depths, the first drawn stays.
//! * The geometry here is in `f64`, whose own roundings are small beside those of `f32`.
//!
//! # What it cannot see
//!
//! A cube's or sphere's far side that is drawn in place of its near side: both have one id.
//!
//! An error of a ray that is below the bounds at its pixel. An oracle checks whether picks are exactly right
//! (`tests/exact_picks`). Picks, the drawing of spheres and the bounds here share one definition of a pixel's ray
//! ([`PixelGrid`](crate::geometry::PixelGrid)); vertices go through matrices and do not share it.
//!
//! [`compare`] is pure: any picker or drawing can be tested with it.

mod adjoining;
mod bound;
mod culling;
mod face;
mod flat;
mod interpolation;
mod one_place;
mod paint;
mod polygon;
mod projection;
mod report;
mod section;
mod sphere;
mod surface;
#[cfg(test)]
mod tests;
mod view_ray;

pub use one_place::{Places, in_one_place};
pub use paint::{COLOURS, IN_ONE_PLACE, marks, paint};
pub use report::{Disagreement, Report, Verdict};

use crate::{
    camera::{View, pixel_centre},
    image::{Id, Image},
    pick,
    render::Rasteriser,
    scene::Scene,
};
use bound::{Outline, Reason};
use face::Surfaces;
use glam::DVec2;
use serde::Serialize;
use surface::{Depths, Surface};

/// The most by which drawing may move an outline, in pixels, in a view that `f32` can draw. Beyond it, whole pixels are
/// wrong.
pub const OUTLINE_CEILING_PX: f64 = 0.5;

/// The largest depth error of `f32` in a view that it can draw, over the depth, or over the distance between near and
/// far where that is less: 1024 of its steps. The error is also at most half a pixel's width. A slanted surface may in
/// addition be off by the change of its depth when it is moved aside by half a pixel.
///
/// These are lengths and do not depend on what a depth buffer stores. The shaders may misplace a section by as much,
/// along its normal, whatever the distance between near and far; in orthographic projection by half a pixel's width.
pub const DEPTH_CEILING: f64 = 1024.0 * f32::EPSILON as f64;

/// Why a pixel is drawn as one thing and picked as another, from harmless to grave.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Class {
    /// The centre lies on an outline, to within the rasteriser's grid.
    Edge,
    /// Both surfaces are equally deep, to within the depth buffer's steps.
    Depth,
    /// The section cuts a surface at the centre, as closely as drawing can tell.
    Section,
    /// The centre lies on an outline to within `f32`, which here is coarser than the grid.
    F32Limit,
    /// One of these, but with a bound above the ceiling, or without a bound: `f32` cannot draw the view faithfully.
    BeyondF32,
    /// A defect.
    Unexplained,
}

impl Class {
    /// All, in order.
    pub const ALL: [Self; 6] = [
        Self::Edge,
        Self::Depth,
        Self::Section,
        Self::F32Limit,
        Self::BeyondF32,
        Self::Unexplained,
    ];

    /// This class, unless a bound is above its ceiling.
    fn within(self, beyond_f32: bool) -> Self {
        if beyond_f32 { Self::BeyondF32 } else { self }
    }

    /// The word for it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Edge => "edge",
            Self::Depth => "depth",
            Self::Section => "section",
            Self::F32Limit => "f32 limit",
            Self::BeyondF32 => "beyond f32",
            Self::Unexplained => "unexplained",
        }
    }
}

/// Compares two id pictures of a scene, pixel by pixel. `rasteriser` drew the first.
///
/// # Panics
/// When either differs from the view in size.
pub fn compare(
    scene: &Scene,
    view: &View,
    rasteriser: Rasteriser,
    drawn: &Image<Id>,
    picked: &Image<Id>,
) -> Report {
    for (size, name) in [(drawn.size(), "drawn"), (picked.size(), "picked")] {
        assert_eq!(size, view.viewport, "the {name} picture is the view's");
    }
    let surfaces = Surfaces::new(scene, view, rasteriser);
    let mut report = Report {
        pixels: drawn.pixels().len(),
        ..Report::default()
    };
    for (x, y) in drawn.positions() {
        let ids = [drawn.at(x, y), picked.at(x, y)];
        let [is_drawn, is_picked] = ids.map(|id| usize::from(id != Id::default()));
        report.drawn += is_drawn;
        report.picked += is_picked;
        let is_outline = on_outline(drawn, x, y) || on_outline(picked, x, y);
        report.outline += usize::from(is_outline);
        if ids[0] != ids[1] {
            report.outline_differ += usize::from(is_outline);
            let difference = explain(&surfaces, [x, y], ids);
            report.disagreements.push(difference);
        }
    }
    report
}

/// Whether a neighbour to the left, right, top or bottom shows something else.
fn on_outline(ids: &Image<Id>, x: u32, y: u32) -> bool {
    // Beyond the border the last pixel continues.
    let (right, bottom) = (ids.size().width() - 1, ids.size().height() - 1);
    let beside = [x.saturating_sub(1), (x + 1).min(right)].map(|i| (i, y));
    let above = [y.saturating_sub(1), (y + 1).min(bottom)].map(|j| (x, j));
    let mut around = beside.into_iter().chain(above);
    around.any(|(i, j)| ids.at(i, j) != ids.at(x, y))
}

/// Explains a difference by geometry.
fn explain(surfaces: &Surfaces, pixel: [u32; 2], [drawn, picked]: [Id; 2]) -> Disagreement {
    let px = pixel_centre(DVec2::from(pixel.map(f64::from)));
    // What drawing may show, and what a pick may find: picks have exact order.
    let sides = [
        surface::not_behind(surfaces.of_id(px, drawn), |near, far| {
            near.stored.farthest > far.stored.nearest
        }),
        surface::not_behind(surfaces.of_id(px, picked), |near, far| {
            near.depth < far.depth
        }),
    ];
    // Identical input gives identical output on the GPU: the order of the two decides which shows.
    let twins = (sides[0].first().zip(sides[1].first())).is_some_and(|(a, b)| a.source == b.source);
    let drawn_ones = sides[0].iter().filter(|_| !twins);
    let pairs = drawn_ones.flat_map(|drawn| sides[1].iter().map(move |picked| (drawn, picked)));
    let depths = Depths::new(&surfaces.space);
    let explained = pairs.filter_map(|(of_drawn, of_picked)| {
        let reason = surface::explain(&depths, of_drawn, of_picked)?;
        Some((reason, [of_drawn.depth, of_picked.depth]))
    });
    let best = explained
        .min_by(|(a, _), (b, _)| (a.class.cmp(&b.class)).then(a.strain.total_cmp(&b.strain)));
    let unexplained = || {
        let outlines = sides.iter().flatten().map(|surface| surface.outline);
        let is_unbounded =
            |surface: &Surface| !(surface.outline.is_bounded() && surface.stored.is_bounded());
        let reason = Reason {
            class: Class::Unexplained.within(sides.iter().flatten().any(is_unbounded)),
            strain: f64::INFINITY,
            outline: outlines.fold(Outline::NONE, Outline::nearer),
        };
        let depths = [0, 1].map(|side| {
            let depths = sides[side].iter().map(|surface: &Surface| surface.depth);
            depths.fold(f64::NAN, f64::min)
        });
        (reason, depths)
    };
    let (reason, mut depth) = best.unwrap_or_else(unexplained);
    // A surface that explains may be another face of the picked shape, or one seen edge-on, which has no depth.
    let (scene, view) = (surfaces.scene, surfaces.space.view());
    let hit = pick::closest(scene, view.ray(px), view.sides);
    if let Some(hit) = hit.filter(|hit| pick::id(scene, hit) == picked) {
        depth[1] = hit.hit.t;
    }
    Disagreement {
        pixel,
        drawn,
        picked,
        class: reason.class,
        strain: reason.strain,
        outline_px: reason.outline.distance_px,
        outline_error_px: reason.outline.error_px(),
        depth,
    }
}
