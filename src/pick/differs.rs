//! How far away the picture shows something else: `differs_px`.
//!
//! Mostly one of the nearest pixels shows something else, and a ray through the whole scene tells quickly. Otherwise
//! some 200 rays are cast. Each asks only whether it meets the surface that shows at the position, with nothing before
//! it. What may occlude that surface is gathered once, by the pyramid about all rays. A coplanar flat shape that loses
//! the tie with the surface loses it along every ray and is left out, so ten thousand coplanar faces cost as much as
//! one. Where nothing may occlude the surface and it fills the square of all these pixels, no ray is cast.

use super::{
    Primitive, SceneHit,
    beam::{self, CornerRays},
    nearest::{closest, first_on, shown_object},
    order::{comes_later, order},
};
use crate::{
    camera::{View, pixel_centre},
    geometry::{Cuboid, Placement, Sides, Sphere, WorldRay, binary::power_of_two},
    scene::{Object, Scene, Shape},
};
use glam::DVec2;
use std::ops::ControlFlow;

/// How far, in pixels, to look for a pixel with another answer.
pub(super) const REACH: f64 = 8.0;
/// Up to this distance in pixels, rays go through the whole scene before occluders are gathered.
const NEARBY: f64 = 2.0;
/// With more occluders, each ray goes through the trees instead, which costs as much as testing a few.
const MOST: usize = 6;
/// The same where `f64` leaves ties at the position: a tree would test each of the tied surfaces.
const MOST_WHERE_TIED: usize = 64;

/// Distance from `px` to the nearest pixel centre whose answer (object and triangle) differs from `here`, the answer at
/// `px`. It looks within [`REACH`] and the picture, at the pixel's own centre too. `is_alone` says that `f64` leaves no
/// other hit tied with `here`.
///
/// Also `None` while a tree is being built: every triangle would have to be tested.
pub(super) fn differs_px(
    scene: &Scene,
    view: &View,
    px: DVec2,
    here: &SceneHit,
    is_alone: bool,
) -> Option<f64> {
    if !scene.trees_are_built() {
        return None;
    }
    let shown = here.primitive();
    let differs = |ray: WorldRay| {
        let there = closest(scene, ray, view.sides);
        there.is_none_or(|there| there.primitive() != shown)
    };
    let mut asked = 0.0;
    if is_alone {
        let mut nearby = centres(view, px, [asked, NEARBY]).into_iter();
        if let Some((distance, _)) = nearby.find(|(_, centre)| differs(view.ray(*centre))) {
            return Some(distance);
        }
        asked = NEARBY;
    }
    let most = if is_alone { MOST } else { MOST_WHERE_TIED };
    let occluders = occluders(scene, view, px, here, most);
    let fills = occluders.is_some() && fills(scene, view, px, shown);
    if fills && occluders.as_ref().is_some_and(Vec::is_empty) {
        return None;
    }
    let differs = |centre: DVec2| {
        let ray = view.ray(centre);
        let Some(occluders) = &occluders else {
            return differs(ray);
        };
        let mut there = None;
        if !fills {
            there = first_on(scene, &ray, view.sides, shown);
            if there.is_none() {
                return true;
            }
        }
        let mut hits =
            (occluders.iter()).filter_map(|occluder| first_on(scene, &ray, view.sides, *occluder));
        hits.any(|occluder| {
            there = there.or_else(|| first_on(scene, &ray, view.sides, shown));
            there.is_none_or(|there| order(scene, &ray, &occluder, &there).is_lt())
        })
    };
    let others = centres(view, px, [asked, REACH]).into_iter();
    Some({ others }.find(|(_, centre)| differs(*centre))?.0)
}

/// Distance and place of the picture's pixel centres that lie more than `from` and at most `to` away from a position,
/// nearest first.
fn centres(view: &View, px: DVec2, [from, to]: [f64; 2]) -> Vec<(f64, DVec2)> {
    let own = pixel_centre(px);
    let is_near = |step: &f64| step.abs() <= to + 0.5;
    let steps = || (-8_i8..=8).map(f64::from).filter(is_near);
    let all = steps().flat_map(|y| steps().map(move |x| own + DVec2::new(x, y)));
    let all = all.map(|centre| (centre.distance(px), centre));
    let mut centres: Vec<(f64, DVec2)> = all
        .filter(|(away, at)| from < *away && *away <= to && view.viewport.contains(*at))
        .collect();
    centres.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    centres
}

/// Whether every ray within [`REACH`] meets the surface that shows at a position. Comparisons fail on NaN.
///
/// The picture of a convex shape is convex, so it is enough that the rays through the corners meet it, unless the near
/// or far plane or the section cuts the shape in between. A flat shape's depth lies between those at the corners. For a
/// solid, the depths of all its points are bounded, with room for a few roundings.
fn fills(scene: &Scene, view: &View, px: DVec2, shown: Primitive) -> bool {
    const ROOM: f64 = power_of_two(-40);
    let Object {
        shape, placement, ..
    } = &scene.objects()[shown.object];
    let model = placement.model();
    let axes = model.matrix3.transpose() * view.camera.forward();
    let spread = match shape {
        Shape::Sphere => Some(Sphere::RADIUS * axes.length()),
        Shape::Cube => Some(Cuboid::HALF_SIDE * axes.abs().element_sum()),
        Shape::Square | Shape::Mesh { .. } => None,
    };
    let lies_between = spread.is_none_or(|spread| {
        let (eye, lens) = (view.camera.eye(), view.camera.lens());
        let depth = view.camera.forward().dot(model.translation - eye);
        let columns = model.matrix3.to_cols_array();
        let size = eye.abs().element_sum()
            + model.translation.abs().element_sum()
            + columns.iter().map(|c| c.abs()).sum::<f64>();
        let spread = spread + ROOM * size;
        lens.near < depth - spread && depth + spread < lens.far
    });
    // The two sides of a solid that a section cuts still show as one convex region; its front alone may not.
    let is_convex = spread.is_none() || view.section.is_none() || view.sides == Sides::Both;
    let meets = |px: &DVec2| first_on(scene, &view.ray(*px), view.sides, shown).is_some();
    lies_between && is_convex && beam::corners([px - REACH, px + REACH]).iter().all(meets)
}

/// What may occlude `here` on rays through pixel centres near a position; `None` when there are more than `most`.
fn occluders(
    scene: &Scene,
    view: &View,
    px: DVec2,
    here: &SceneHit,
    most: usize,
) -> Option<Vec<Primitive>> {
    let corners = CornerRays::about(view, px, REACH);
    let mut occluders = Vec::new();
    let mut is_complete = true;
    scene.visit_batches_within(&corners.pyramid(&Placement::IDENTITY)?, |batch| {
        if occluders.len() > most {
            return ControlFlow::Break(());
        }
        let first = &scene.objects()[batch.start];
        let Shape::Mesh { mesh, part } = &first.shape else {
            let may_occlude = first.visible && !comes_later(scene, here, batch.start, None);
            occluders.extend(may_occlude.then_some(Primitive {
                object: batch.start,
                triangle: None,
            }));
            return ControlFlow::Continue(());
        };
        let Some(pyramid) = corners.pyramid(&first.placement) else {
            is_complete = false;
            return ControlFlow::Break(());
        };
        mesh.within(&pyramid, |triangle, corners| {
            let object = shown_object(scene, batch, *part, mesh.part_of(triangle));
            let may_occlude =
                |object: &usize| !comes_later(scene, here, *object, Some((triangle, corners)));
            occluders.extend(object.filter(may_occlude).map(|object| Primitive {
                object,
                triangle: Some(triangle),
            }));
            if occluders.len() > most {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        });
        ControlFlow::Continue(())
    });
    (is_complete && occluders.len() <= most).then_some(occluders)
}
