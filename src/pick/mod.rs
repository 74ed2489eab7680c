//! What a pixel shows, by casting a ray: pure functions of scene, view and pixel.
//!
//! # What a pick is
//!
//! A pick is the answer of exact arithmetic for the stored numbers. `f64` decides only where a proven bound shows that
//! its rounding cannot matter. Whatever it leaves open goes to exact arithmetic.
//!
//! **The stored numbers.** A camera stores the eye, the axes R, U and F, half the picture's height h (at view depth 1
//! in perspective), near and far; a [`View`] adds the picture's W x H pixels. An object stores its model matrix M, a
//! mesh its `f32` vertices about one `f64` origin, which lie at M (origin + vertex) in the world. They count exactly as
//! stored: the axes as rounded, h and not the angle that it came from, the matrix and not its inverse. `sightline pick
//! --stored` prints them with all digits. They have a [`range`](crate::geometry::range): a larger number is refused, a
//! smaller one is stored as 0.
//!
//! **The ray** of a position x, y in pixels, with nothing rounded:
//!
//! ```text
//! a = (h / H) ((2 x - W) R + (H - 2 y) U)
//! perspective:   eye + t (F + a)
//! orthographic:  eye + a + t F
//! ```
//!
//! F + a is not normalised, so t is view depth ([`PixelGrid::ray`](crate::geometry::PixelGrid::ray)). A ray that is
//! given by its own numbers ([`Ray`](crate::geometry::Ray)) is taken as exact.
//!
//! **The answer.** A hit counts where `near <= t < far`, each hit on its own: where the near plane cuts a sphere, the
//! exit counts and the entry does not. A [`Section`](crate::geometry::Section) keeps a hit whose exact point has
//! `n . p + c >= 0` (closed), for the stored n and c. With [`Sides::Front`](crate::geometry::Sides::Front) only front
//! hits count. The pick is the hit with the least t on the visible objects; of equal ones, that on the first object,
//! then on the first triangle. [`all`] has every hit in this order, a solid's entry before its exit.
//!
//! **The shapes** are closed: edges, corners and rims belong to them.
//!
//! * A triangle's corners run counter-clockwise seen from outside. A ray within its plane misses it. A triangle without
//!   area is never hit.
//! * The square of side 1 lies about the origin in the plane z = 0 and faces +z. A ray within its plane misses it.
//! * The cube of side 1 about the origin is solid. The ray enters it (front) and leaves it (back). Where both are one
//!   point, at an edge or corner that the ray touches, that is one hit: the entry. Where it enters or leaves by several
//!   faces at once, the face across the lowest axis is named. A ray does not enter by a face in whose plane it lies.
//! * The sphere of radius 1/2 lies about the origin. The ray enters it (front) and leaves it (back). A tangent ray hits
//!   it once, and not from the front.
//!
//! **Front** is decided in object space: a hit is at the front where the ray runs against the outward normal there,
//! also under a mirroring matrix. A singular matrix is refused, as is one whose inverse is beyond the range of numbers
//! ([`PlacementError`](crate::geometry::PlacementError)).
//!
//! # What a record adds
//!
//! [`Pick`] says where the hit lies and how sure it is. `t` is the exact parameter rounded once (and kept below far);
//! `gap`, the difference to the next hit, is rounded once, too. `exact` says whether exact arithmetic had to decide;
//! this does not depend on whether a tree is built. `edge_px` says how many pixels away the nearest edge is.
//!
//! The order of picks is exact however close two surfaces lie; a drawing's is not. Where surfaces lie so close to the
//! nearest one that drawing may show any of them, the answer names them ([`InOnePlace`], found by
//! [`verify::in_one_place`](crate::verify::in_one_place)).

mod beam;
mod edge;
mod narrowed;
mod nearest;
mod one_place;
mod order;
mod raycast;
mod record;
mod selection;
mod sight;
pub mod snap;

pub(crate) use beam::Beam;
pub(crate) use edge::face_of;
pub use narrowed::narrowed;
pub(crate) use nearest::all_near;
#[doc(hidden)] // public for tests
pub use nearest::{ShapeTest, closest_by};
pub use nearest::{all, closest};
#[doc(hidden)] // public for tests
pub use one_place::MOST_NAMED;
pub use one_place::{InOnePlace, NamedSurface};
pub(crate) use raycast::{RAYCAST_BYTES, each_ray, id};
pub use raycast::{ids, raycast};
#[doc(hidden)] // public for tests and benches
pub use raycast::{ids_by, raycast_ndc_until, raycast_until};
pub use record::Pick;
#[doc(hidden)] // public for tests: the shape of the program's lines
pub use record::{PickLine, PickLines};
pub use selection::mark;
pub use sight::{Sight, sight};

use crate::{
    camera::View,
    geometry::{Hit, overlap, shares::on_all_cores},
    scene::Scene,
};
use glam::DVec2;
use nearest::{is_in_doubt, is_tied, nearest};

/// A hit on an object of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SceneHit {
    /// The object's index, from 0; its id is one more.
    pub object: usize,
    /// The hit in the object's space; its `t` is the world ray's.
    pub hit: Hit,
}

/// An object, or a triangle of its mesh. Its order is that by which ties are decided.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
struct Primitive {
    object: usize,
    /// By its number in the mesh.
    triangle: Option<u32>,
}

impl SceneHit {
    /// Whether `f64` leaves open which of the two is nearer.
    fn overlaps(&self, other: &Self) -> bool {
        let t = |hit: &Hit| (hit.t, hit.t_error);
        overlap(t(&self.hit), t(&other.hit))
    }

    /// The triangle that was hit, counted from the object's first; `None` on an analytic shape.
    ///
    /// # Panics
    /// When the scene lacks the object, or the object the triangle: the hit is on another scene.
    pub fn triangle_of_object(&self, scene: &Scene) -> Option<u32> {
        let first = scene.objects()[self.object].shape.first_triangle();
        (self.primitive().triangle).map(|triangle| triangle - first)
    }

    /// The object or triangle that was hit.
    fn primitive(&self) -> Primitive {
        Primitive {
            object: self.object,
            triangle: self.hit.on_triangle.map(|at| at.triangle),
        }
    }

    /// An upper bound on the `t` of any hit that can come before this one.
    fn limit(&self) -> f64 {
        self.hit.t + self.hit.t_error
    }
}

/// What a click picks: the surface nearest to the eye at exactly this pixel position. `None` where the picture shows
/// the background.
pub fn pick(scene: &Scene, view: &View, px: DVec2) -> Option<Pick> {
    let ray = view.ray(px);
    let beam = &Beam::whole(scene);
    let hit = nearest(beam, &ray, view.sides, None)?;
    let next = nearest(beam, &ray, view.sides, Some(&hit));
    let exact = next.is_some_and(|next| next.overlaps(&hit))
        || is_tied(scene, &ray, view.sides, &hit)
        || is_in_doubt(scene, &ray, hit.limit());
    let at = record::At { scene, view, px };
    Some(Pick::of(&at, &hit, next.as_ref(), exact))
}

/// Records take some hundredths of a millisecond each: with this many, threads are quicker.
const WORTH_THREADS: usize = 64;

/// Every surface at a pixel position, from front to back.
pub fn pick_all(scene: &Scene, view: &View, px: DVec2) -> Vec<Pick> {
    let ray = view.ray(px);
    let hits = all(scene, ray, view.sides);
    let tied = tied(&hits);
    // Once a hit is in doubt, all later hits are.
    let sure = hits.partition_point(|hit| !is_in_doubt(scene, &ray, hit.limit()));
    let at = record::At { scene, view, px };
    let pick = |i: usize| {
        let exact = tied[i] || i >= sure;
        Pick::of(&at, &hits[i], hits.get(i + 1), exact)
    };
    if hits.len() < WORTH_THREADS {
        (0..hits.len()).map(pick).collect()
    } else {
        on_all_cores(0..hits.len(), pick)
    }
}

/// For each hit, from front to back: whether `f64` leaves its order with some other hit open.
fn tied(hits: &[SceneHit]) -> Vec<bool> {
    let [low, high] =
        [-1.0, 1.0].map(|sign| move |hit: &SceneHit| hit.hit.t + sign * hit.hit.t_error);
    let mut tied = vec![false; hits.len()];
    let mut before = f64::NEG_INFINITY;
    for (hit, tied) in hits.iter().zip(&mut tied) {
        *tied |= before >= low(hit);
        before = before.max(high(hit));
    }
    let mut behind = f64::INFINITY;
    for (hit, tied) in hits.iter().zip(&mut tied).rev() {
        *tied |= behind <= high(hit);
        behind = behind.min(low(hit));
    }
    tied
}
