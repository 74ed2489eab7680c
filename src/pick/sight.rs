//! Whether a point of the scene is seen, and what hides it.
//!
//! This is decided exactly, as picks are: by what the picture's ray through the point picks. (See
//! [`ThroughPoint::ray`](crate::geometry::ThroughPoint::ray); its pixel position need not be an `f64`.) A point is seen
//! where the pick lies at the point, and hidden where the pick lies before it. Otherwise no shown surface passes
//! through the point: its faces are culled, of a hidden object, or seen edge-on.

use super::{SceneHit, closest, nearest::first_on, order::surface};
use crate::{
    camera::View,
    geometry::{PlacedPoint, ThroughPoint, WorldRay, compare_to_point, is_point_within},
    scene::Scene,
};
use std::cmp::Ordering;

/// Whether a point is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sight {
    /// It is seen on this surface, the first of those through the point.
    Seen(SceneHit),
    /// It is hidden by this hit, the nearest to the eye.
    Hidden(SceneHit),
    /// It lies before the near plane, at or behind the far one, or is cut away by a section; or no surface through it
    /// is shown.
    NotShown,
}

/// Whether a point is seen. It may lie outside the picture.
pub fn sight(scene: &Scene, view: &View, point: &PlacedPoint) -> Sight {
    let through = view.through(point);
    let Some(ray) = ray(view, &through) else {
        return Sight::NotShown;
    };
    let hit = closest(scene, ray, view.sides);
    let order = hit.and_then(|hit| compare_to_point(&ray, &surface(scene, &hit)));
    match (hit, order) {
        (Some(hit), Some(Ordering::Less)) => Sight::Hidden(hit),
        (Some(hit), Some(Ordering::Equal)) => Sight::Seen(hit),
        _ => Sight::NotShown,
    }
}

/// Whether the object or triangle of another hit also hides a point.
pub(super) fn hides(scene: &Scene, view: &View, by: &SceneHit, point: &PlacedPoint) -> bool {
    let through = view.through(point);
    ray(view, &through).is_some_and(|ray| {
        let hit = first_on(scene, &ray, view.sides, by.primitive());
        hit.and_then(|hit| compare_to_point(&ray, &surface(scene, &hit))) == Some(Ordering::Less)
    })
}

/// The picture's ray through a point; `None` where the point is outside near and far.
fn ray<'a>(view: &View, through: &'a ThroughPoint) -> Option<WorldRay<'a>> {
    let ray = through.ray().filter(is_point_within)?;
    Some(view.section.map_or(ray, |section| ray.cut_by(&section)))
}
