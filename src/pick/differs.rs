//! How far away the picture shows something else.
//!
//! Mostly one of the nearest pixels shows something else, which a ray through the whole scene is quick to tell. Else some 200
//! rays are asked, and each only one thing: whether it meets what shows at the position, and nothing before it.
//! What may come before it is gathered once, by the pyramid about all of them. Triangles and squares of its own plane that
//! come later in order do so along every ray, and are left out: ten thousand faces in one place cost as much as one. Where
//! nothing is left and what shows fills the square of all these pixels, no ray is asked.

use super::{
    SceneHit,
    around::{REACH, corners, corners_px, pyramid},
    nearest::{closest, first_on, shows_part},
    order::{comes_later, order},
};
use crate::{
    camera::{View, pixel_centre},
    geometry::{Cuboid, Placement, Sides, Sphere, WorldRay, binary::power_of_two},
    scene::{Object, Scene, Shape},
};
use glam::DVec2;
use std::ops::ControlFlow;

/// So far each ray asks the whole scene, before anything is gathered: mostly one of these finds something else.
const NEARBY: f64 = 2.0;
/// With more to ask, each ray goes through the trees by itself, which costs as much as a few.
const MOST: usize = 6;
/// The same where many surfaces are in one place, each of which a tree would ask about.
const MOST_IN_A_CROWD: usize = 64;

/// Something that may come before what shows at the position: an object, or a triangle of its mesh.
#[derive(Clone, Copy)]
struct Rival {
    object: usize,
    triangle: Option<u32>,
}

/// How far from `px` the centre of the nearest pixel lies whose answer, object or triangle, is not `here`, that at `px`;
/// within [`REACH`] and the picture. The pixel's own centre is one of them. `is_alone` says that nothing else is at one place
/// with `here`, as far as `f64` tells.
///
/// `None` too while a tree is still being built: every triangle would have to be asked.
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
    let shown = Rival {
        object: here.object,
        triangle: here.triangle(),
    };
    let differs = |ray: WorldRay| {
        let there = closest(scene, ray, view.sides);
        there.is_none_or(|there| (there.object, there.triangle()) != (shown.object, shown.triangle))
    };
    let mut asked = 0.0;
    if is_alone {
        let mut nearby = centres(view, px, [asked, NEARBY]).into_iter();
        if let Some((distance, _)) = nearby.find(|(_, centre)| differs(view.ray(*centre))) {
            return Some(distance);
        }
        asked = NEARBY;
    }
    let most = if is_alone { MOST } else { MOST_IN_A_CROWD };
    let rivals = rivals(scene, view, px, here, most);
    let fills = rivals.is_some() && fills(scene, view, px, shown);
    if fills && rivals.as_ref().is_some_and(Vec::is_empty) {
        return None;
    }
    let differs = |centre: DVec2| {
        let ray = view.ray(centre);
        let Some(rivals) = &rivals else {
            return differs(ray);
        };
        let mut there = None;
        if !fills {
            there = first_of(scene, view, &ray, shown);
            if there.is_none() {
                return true;
            }
        }
        let mut hits = (rivals.iter()).filter_map(|rival| first_of(scene, view, &ray, *rival));
        hits.any(|rival| {
            there = there.or_else(|| first_of(scene, view, &ray, shown));
            there.is_none_or(|there| order(scene, &ray, &rival, &there).is_lt())
        })
    };
    let others = centres(view, px, [asked, REACH]).into_iter();
    let nearest = { others }.find(|(_, centre)| differs(*centre))?;
    Some(nearest.0)
}

/// The centres of the picture's pixels that lie farther from a position than one distance and no farther than another,
/// nearest first, with how far.
fn centres(view: &View, px: DVec2, [from, to]: [f64; 2]) -> Vec<(f64, DVec2)> {
    let own = pixel_centre(px);
    let steps = || {
        (-8_i8..=8)
            .map(f64::from)
            .filter(|step| step.abs() <= to + 0.5)
    };
    let mut centres: Vec<(f64, DVec2)> = steps()
        .flat_map(|y| steps().map(move |x| own + DVec2::new(x, y)))
        .map(|centre| (centre.distance(px), centre))
        .filter(|(distance, centre)| {
            from < *distance && *distance <= to && view.viewport.contains(*centre)
        })
        .collect();
    centres.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    centres
}

/// Whether every ray within reach meets what shows at a position. Written so that NaN is none.
///
/// The picture of a convex shape is convex, so it is enough that the rays through the corners meet it; unless some of it
/// does not count. The depth of a flat shape lies between those at the corners. Of a solid the depths of all its points are
/// bounded, with room for what a few roundings take.
fn fills(scene: &Scene, view: &View, px: DVec2, shown: Rival) -> bool {
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
    // A section leaves convex what shows of a solid's both sides together, not of its front.
    let is_convex = spread.is_none() || view.section.is_none() || view.sides == Sides::Both;
    let meets = |px: &DVec2| first_of(scene, view, &view.ray(*px), shown).is_some();
    lies_between && is_convex && corners_px(px).iter().all(meets)
}

/// The first shown hit on it.
fn first_of(scene: &Scene, view: &View, ray: &WorldRay, what: Rival) -> Option<SceneHit> {
    first_on(scene, ray, view.sides, what.object, what.triangle)
}

/// What may come before `here` on a ray through the centre of a pixel near a position; `None` when that is more than
/// `most`.
fn rivals(
    scene: &Scene,
    view: &View,
    px: DVec2,
    here: &SceneHit,
    most: usize,
) -> Option<Vec<Rival>> {
    let corners = corners(view, px);
    let pyramid_in = |placement: &Placement| pyramid(&corners, placement);
    let mut rivals = Vec::new();
    let mut is_complete = true;
    scene.visit_batches_within(&pyramid_in(&Placement::IDENTITY)?, |batch| {
        if rivals.len() > most {
            return ControlFlow::Break(());
        }
        let first = &scene.objects()[batch.start];
        let Shape::Mesh { mesh, part } = &first.shape else {
            let is_rival = first.visible && !comes_later(scene, here, batch.start, None);
            rivals.extend(is_rival.then_some(Rival {
                object: batch.start,
                triangle: None,
            }));
            return ControlFlow::Continue(());
        };
        let Some(pyramid) = pyramid_in(&first.placement) else {
            is_complete = false;
            return ControlFlow::Break(());
        };
        mesh.within(&pyramid, |triangle, corners| {
            let part_hit = mesh.part_of(triangle);
            if shows_part(scene, batch, *part, part_hit) {
                let object = batch.start + part_hit - part;
                if !comes_later(scene, here, object, Some((triangle, corners))) {
                    rivals.push(Rival {
                        object,
                        triangle: Some(triangle),
                    });
                }
            }
            if rivals.len() > most {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        });
        ControlFlow::Continue(())
    });
    (is_complete && rivals.len() <= most).then_some(rivals)
}
