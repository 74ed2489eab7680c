//! How far away the picture shows something else.
//!
//! Some 200 rays are asked, and each only one thing: whether it meets what shows at the position, and nothing before it.
//! What may come before it is gathered once, by the pyramid about all of them. Triangles of its own plane that come later
//! in order do so along every ray, and are left out: ten thousand faces in one place cost as much as one.

use super::{
    SceneHit,
    nearest::{closest, hits_of, shows_part},
    order::{comes_later_in_plane, order},
};
use crate::{
    camera::{View, pixel_centre},
    geometry::{LocalRay, Placement, Pyramid, WorldRay},
    scene::{Scene, Shape},
};
use glam::DVec2;
use std::ops::ControlFlow;

/// How far, in pixels, to look for a pixel with another answer.
const REACH: f64 = 8.0;
/// From a position to the sides of a square that holds all centres within reach, and a pixel of room.
const ASIDE: f64 = REACH + 1.0;
/// With more to ask, each ray goes through the trees by itself.
const MOST: usize = 64;

/// Something that may come before what shows at the position: an object, or a triangle of its mesh.
#[derive(Clone, Copy)]
struct Rival {
    object: usize,
    triangle: Option<u32>,
}

/// How far from `px` the centre of the nearest pixel lies whose answer, object or triangle, is not `here`, that at `px`;
/// within [`REACH`] and the picture. The pixel's own centre is one of them.
///
/// `None` too while a tree is still being built: every triangle would have to be asked.
pub(super) fn differs_px(scene: &Scene, view: &View, px: DVec2, here: &SceneHit) -> Option<f64> {
    if !scene.trees_are_built() {
        return None;
    }
    let shown = Rival {
        object: here.object,
        triangle: here.triangle(),
    };
    let rivals = rivals(scene, view, px, here);
    let differs = |centre: DVec2| {
        let ray = view.ray(centre);
        let Some(rivals) = &rivals else {
            let there = closest(scene, ray, view.sides);
            return there.is_none_or(|there| {
                (there.object, there.triangle()) != (shown.object, shown.triangle)
            });
        };
        let Some(there) = first_of(scene, view, &ray, shown) else {
            return true;
        };
        let mut hits = (rivals.iter()).filter_map(|rival| first_of(scene, view, &ray, *rival));
        hits.any(|rival| order(scene, &ray, &rival, &there).is_lt())
    };
    let own = pixel_centre(px);
    let steps = || (-9_i8..=9).map(f64::from);
    let mut nearby: Vec<(f64, DVec2)> = steps()
        .flat_map(|y| steps().map(move |x| own + DVec2::new(x, y)))
        .map(|centre| (centre.distance(px), centre))
        .filter(|(distance, centre)| {
            *centre != px && *distance <= REACH && view.viewport.contains(*centre)
        })
        .collect();
    nearby.sort_by(|a, b| a.0.total_cmp(&b.0));
    let nearest = nearby.into_iter().find(|(_, centre)| differs(*centre))?;
    Some(nearest.0)
}

/// The first shown hit on an object, or on a triangle of it.
fn first_of(scene: &Scene, view: &View, ray: &WorldRay, what: Rival) -> Option<SceneHit> {
    let mut hits = hits_of(scene, ray, what.object, what.triangle);
    hits.find(|hit| view.sides.shows(&hit.hit))
}

/// What may come before `here` on a ray through the centre of a pixel near a position; `None` when that is too much to ask
/// one by one.
fn rivals(scene: &Scene, view: &View, px: DVec2, here: &SceneHit) -> Option<Vec<Rival>> {
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
        .map(|(x, y)| view.ray(px + ASIDE * DVec2::new(x, y)));
    let pyramid_in = |placement: &Placement| {
        let local = corners.each_ref().map(|ray| placement.local_ray(ray));
        Pyramid::new(&local.each_ref().map(LocalRay::from), 2.0 * ASIDE)
    };
    let mut rivals = Vec::new();
    let mut is_complete = true;
    scene.visit_batches_within(&pyramid_in(&Placement::IDENTITY)?, |batch| {
        if rivals.len() > MOST || !is_complete {
            return;
        }
        let first = &scene.objects()[batch.start];
        let Shape::Mesh { mesh, part } = &first.shape else {
            let is_rival = first.visible && batch.start != here.object;
            rivals.extend(is_rival.then_some(Rival {
                object: batch.start,
                triangle: None,
            }));
            return;
        };
        let Some(pyramid) = pyramid_in(&first.placement) else {
            is_complete = false;
            return;
        };
        mesh.within(&pyramid, |triangle, corners| {
            let part_hit = mesh.part_of(triangle);
            if shows_part(scene, batch, *part, part_hit) {
                let object = batch.start + part_hit - part;
                if !comes_later_in_plane(scene, here, object, triangle, corners) {
                    rivals.push(Rival {
                        object,
                        triangle: Some(triangle),
                    });
                }
            }
            if rivals.len() > MOST {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        });
    });
    (is_complete && rivals.len() <= MOST).then_some(rivals)
}
