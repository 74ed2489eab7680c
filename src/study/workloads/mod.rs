//! What the methods are put to: seeded families of cases, each with one parameter from harmless to absurd.
//!
//! All numbers come from additions, products, quotients and square roots, which every machine rounds alike, and are
//! then rounded to `f32`, but for a camera's axes and what they make: the same seed is the same workload everywhere, and
//! methods of both precisions get it.

pub mod boxes;
pub mod object_space;
pub mod picks;
pub mod rays;
pub mod scene;
pub mod spheres;
pub mod squares;
pub mod triangles;

use crate::camera::{Projection, View};

/// The width of a pixel in a view's middle, in radians seen from the eye at a distance, which in perspective does not
/// matter.
#[must_use]
pub fn px_angle(view: &View, distance: f64) -> f64 {
    let lens = view.camera.lens();
    let height = 2.0 * lens.half_extent(1.0).y / f64::from(view.viewport.height());
    match lens.projection {
        Projection::Perspective { .. } => height,
        Projection::Orthographic { .. } => height / distance,
    }
}

/// The width of a pixel in radians where nothing else is said: 60 degrees over 1080 rows, `2 tan(30 deg) / 1080`.
pub const PX: f64 = 2.0 * TAN_30 / 1080.0;
/// tan(30 degrees).
pub const TAN_30: f64 = 0.577_350_269_189_625_7;
