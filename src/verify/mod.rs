//! Drawn against picked: every pixel's (object, triangle) as the GPU drew it and as a ray through the pixel's centre
//! hits it; each difference is put down to geometry, or is a defect.
//!
//! A rasteriser moves vertices to a grid, mostly of 1/256 pixel, and computes in `f32`; the pick does neither. How far that may
//! carry a surface at a pixel is bounded from camera, scene and the driver's steps before anybody looks at what differs,
//! and never by trying pixels nearby. Where drawn and picked differ, one of these has to hold:
//!
//! * **edge**: one side's surface has its outline (projected edges, the cut of the near plane, a sphere's rim) so near
//!   the pixel's centre that the grid, and what `f32` moves the outline by ([`transform`](crate::render::transform),
//!   [`sphere`](crate::render::sphere)), carry it across, and its depth there is one that the answer needs;
//! * **depth**: both surfaces cover the centre, as deep as the depth buffer can tell, or closer together than the ceiling;
//!   the empty buffer counts as a surface at the far plane, and so does the near plane;
//! * **section**: a section passes one side's surface at the centre so near that the grid, and what `f32` makes of the test
//!   in the shaders ([`ScreenSection`](crate::render)), leave open whether it is kept, and its depth there is one that the
//!   answer needs;
//! * **f32 limit**: an edge, but `f32` moves the outline by more than the grid does;
//! * **beyond f32**: one of these, but by a bound above the ceiling ([`OUTLINE_CEILING_PX`], [`DEPTH_CEILING_STEPS`]); or a
//!   surface for which there is no bound, or one larger than the picture; or one well before the far plane that the buffer
//!   cannot tell from nothing. Drawing in `f32` cannot hold the view; the picture cast by rays can. A view whose bounds all
//!   lie below the ceiling, and above what the buffer can tell from nothing, has no such pixel;
//! * **unexplained**: anything else. Somebody is wrong.
//!
//! A surface has no outline where it goes on beyond an edge: there its neighbours may show, and nothing behind.
//!
//! A bound that is infinite or NaN is none, and explains nothing. A picture that is empty where picks are not, or the
//! reverse, fails whatever explains its pixels one by one, but for a speck smaller than a pixel ([`Report::verdict`]).
//!
//! Whether drawing and pick differ there or not: where the bounds leave the order of two surfaces open, they lie *in one
//! place* ([`Places`]).
//!
//! # What the bounds take for granted
//!
//! * The driver's `f32` sums, products and conversions are rounded once, in any order, fused or not; a division takes 2.5
//!   units in the last place (WGSL's rules).
//! * Corners are moved by no more than half a step of a grid along each axis. Direct3D asks for one of 1/256 pixel, Vulkan for
//!   1/16, and wgpu does not tell: each device's is measured ([`Rasteriser::grid_px`](crate::render::Rasteriser)).
//! * A pixel is covered when its centre is, by edges through the rounded corners; clipping at a border of the picture makes new
//!   corners between old ones and rounds them.
//! * Depth over a triangle is the plane through its corners, with slopes that are rounded relatively to their terms; of one
//!   that leaves the picture, through corners of what is left of it within the picture's borders, or as good as that. Not so
//!   good is `SwiftShader`: its plane goes through the corners of the whole triangle in the picture's plane, to its grid and to
//!   `f32`, however far outside or behind the eye they lie, so that of triangles far larger than the picture it may show
//!   pixels by wrong depths. Those are called unexplained, since nothing bounds them.
//! * The same numbers drawn twice give the same pixels and depths, to the bit, and the first of equal depths stays.
//! * The geometry here is in `f64`. Its own roundings are small beside those of `f32`.
//!
//! # What it cannot see
//!
//! The far side of a cube or a sphere where its near side ought to be: both have one id.
//!
//! A ray's error below the bound at a pixel: whether a pick is exactly right, this does not tell. That is held by an
//! oracle (`tests/exact_picks`). Where a pixel's ray runs is defined once for picks, for the drawing of spheres and for the
//! bounds here ([`PixelGrid`](crate::geometry::PixelGrid)); vertices go through matrices and do not share it.
//!
//! [`compare`] is pure: whatever answers for a pixel can be put to the test.

mod adjoining;
mod bound;
mod face;
mod flat;
mod interpolation;
mod one_place;
mod picture;
mod polygon;
mod report;
mod round;
mod section;
mod surface;
#[cfg(test)]
mod tests;

pub use one_place::{Places, in_one_place};
pub use picture::{COLOURS, IN_ONE_PLACE, marks, paint};
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

/// The most that drawing may move an outline by, in pixels, and be held to hold the view: a picture that is off by more
/// shows other pixels than the scene has.
pub const OUTLINE_CEILING_PX: f64 = 0.5;

/// The most that `f32` may be off in depth and be held to hold the view, in steps of 2^-23 of the depth, or of the distance
/// between near and far where that is less: 1/8192 of it. Nor may it be off by more than half a pixel's width, or by more
/// than moving the surface aside by half a pixel makes of it, where that is more.
///
/// These are lengths, and do not depend on what a depth buffer stores. They hold for sections, too: for how far off along
/// the line of sight the shaders may be about where the plane passes.
pub const DEPTH_CEILING_STEPS: f64 = 1024.0;

/// Why a pixel is drawn as one thing and picked as another, from harmless to not.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Class {
    /// The centre lies on an outline, to the rasteriser's grid.
    Edge,
    /// Both surfaces are as deep, to the depth buffer's steps.
    Depth,
    /// The section passes a surface at the centre, to what drawing can tell.
    Section,
    /// The centre lies on an outline, to what `f32` can tell, which here is less than the grid.
    F32Limit,
    /// One of these by a bound above the ceiling, or there is no bound: drawing in `f32` cannot hold the view.
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

    /// The word for it.
    #[must_use]
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

/// Compares two id pictures of a scene, pixel by pixel; the first is this rasteriser's. Where that names no triangles, objects
/// are compared.
///
/// # Panics
/// When either has another size than the view.
#[must_use]
pub fn compare(
    scene: &Scene,
    view: &View,
    rasteriser: Rasteriser,
    drawn: &Image<Id>,
    picked: &Image<Id>,
) -> Report {
    assert_eq!(
        drawn.size(),
        view.viewport,
        "the drawn picture is the view's"
    );
    assert_eq!(
        picked.size(),
        view.viewport,
        "the picked picture is the view's"
    );
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
        let is_same = if rasteriser.names_triangles {
            ids[0] == ids[1]
        } else {
            ids[0].object == ids[1].object
        };
        if !is_same {
            report.outline_differ += usize::from(is_outline);
            let difference = explain(&surfaces, [x, y], ids);
            report.disagreements.push(difference);
        }
    }
    report
}

/// Whether a neighbour to the left, right, top or bottom shows something else.
fn on_outline(ids: &Image<Id>, x: u32, y: u32) -> bool {
    // Past the border the last pixel goes on.
    let (right, bottom) = (ids.size().width() - 1, ids.size().height() - 1);
    let around = [
        (x.saturating_sub(1), y),
        ((x + 1).min(right), y),
        (x, y.saturating_sub(1)),
        (x, (y + 1).min(bottom)),
    ];
    around
        .into_iter()
        .any(|(i, j)| ids.at(i, j) != ids.at(x, y))
}

/// Puts a difference down to geometry.
fn explain(surfaces: &Surfaces, pixel: [u32; 2], [drawn, picked]: [Id; 2]) -> Disagreement {
    let px = pixel_centre(DVec2::from(pixel.map(f64::from)));
    let sides = [
        surface::may_be_drawn(surfaces.of_id(px, drawn)),
        surface::may_be_picked(surfaces.of_id(px, picked)),
    ];
    // From the same the GPU makes the same: which of the two shows is settled by their order.
    let twins = (sides[0].first().zip(sides[1].first())).is_some_and(|(a, b)| a.source == b.source);
    let pairs = sides[0]
        .iter()
        .filter(|_| !twins)
        .flat_map(|of_drawn| sides[1].iter().map(move |of_picked| (of_drawn, of_picked)));
    let depths = Depths::new(&surfaces.space);
    let explained = pairs.filter_map(|(of_drawn, of_picked)| {
        let reason = surface::explain(&depths, of_drawn, of_picked)?;
        Some((reason, [of_drawn.depth, of_picked.depth]))
    });
    let best = explained
        .min_by(|(a, _), (b, _)| (a.class.cmp(&b.class)).then(a.strain.total_cmp(&b.strain)));
    let unexplained = || {
        let outlines = sides.iter().flatten().map(|surface| surface.outline);
        let is_bounded =
            |surface: &Surface| surface.outline.is_bounded() && surface.stored.is_bounded();
        let reason = Reason {
            class: if sides.iter().flatten().all(is_bounded) {
                Class::Unexplained
            } else {
                Class::BeyondF32
            },
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
    if !depth[1].is_finite() && picked != Id::default() {
        // A face that is seen edge-on has no depth of its own; the hit on its rim has.
        let (scene, view) = (surfaces.scene, surfaces.space.view());
        let hit = pick::closest(scene, view.ray(px), view.sides);
        depth[1] = hit.map_or(f64::NAN, |hit| hit.hit.t);
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
