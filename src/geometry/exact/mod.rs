//! Intersects rays with shapes in exact arithmetic, from the stored numbers, in the few cases that `f64` cannot decide.
//!
//! Every finite `f64` is an integer times a power of two, and so is every sum and product of such numbers. Integers
//! wide enough neither round nor overflow. Triangles are decided in the world, by the barycentric weights where the ray
//! meets their plane. Spheres, cubes and squares are decided in object space, with all numbers times the determinant of
//! the model matrix, which avoids a division. A ray parameter is a quotient, or a root of a quadratic with rational
//! coefficients, and is compared as such ([`mod@root`]).
//!
//! Hits, orders and the numbers of a pick's record (parameters, points, distances in the picture) are first tried in
//! pairs of `f64` with bounds ([`enclosure`]). These pairs count where they round to what integers would.
//!
//! Integers have 128 or 512 bits where that is enough, else any number. (Floating-point expansions, Shewchuk
//! 1997, fail as soon as a product underflows.)

mod big_number;
mod coplanar;
pub(crate) mod dyadic;
mod enclosure;
mod exact_line;
mod integer;
mod matrix;
mod meeting;
mod number;
mod parameter;
mod plane;
mod point;
mod root;
mod section;
mod solids;
mod surface_order;
mod touching;
mod triangle;

pub(crate) use coplanar::{are_coplanar, are_in_one_plane};
#[cfg(test)]
pub(super) use exact_line::LocalLine;
pub(super) use exact_line::{Rounded, rounded_line};
pub(super) use matrix::{inverse, mirrors};
pub(crate) use meeting::Surface;
pub(crate) use parameter::Parameter;
pub(super) use plane::{keeps_point, normal_of};
pub(crate) use section::keeps;
pub(super) use solids::{cube, sphere, square};
pub(crate) use surface_order::{compare_surfaces, compare_to_point, is_point_within};
pub(crate) use touching::{is_between, overlap_at};
pub(crate) use triangle::Corners;
pub(super) use triangle::{compare, hit, reaches_plane};
