//! Frames what a picture is to show: where the eye stands, so that it just fills the picture.

use crate::geometry::Aabb;
use glam::{DMat3, DVec3};

/// What is narrower than the picture comes close to its middle in so many steps.
const CENTRED: u32 = 5;

/// What a picture can frame.
pub trait Framed {
    /// The smallest box about all of its points, each taken through an invertible linear map; empty for no points.
    fn bounds_through(&self, map: &DMat3) -> Aabb;

    /// The same in the world.
    fn bounds(&self) -> Aabb {
        self.bounds_through(&DMat3::IDENTITY)
    }
}

/// A box counts as its corners.
impl Framed for Aabb {
    fn bounds_through(&self, map: &DMat3) -> Aabb {
        if self.is_empty() {
            return Self::EMPTY;
        }
        self.corners().bounds_through(map)
    }

    fn bounds(&self) -> Aabb {
        *self
    }
}

impl<const N: usize> Framed for [DVec3; N] {
    fn bounds_through(&self, map: &DMat3) -> Aabb {
        Aabb::around(self.map(|point| *map * point))
    }
}

/// Both together.
impl<A: Framed, B: Framed> Framed for (A, B) {
    fn bounds_through(&self, map: &DMat3) -> Aabb {
        (self.0.bounds_through(map)).union(self.1.bounds_through(map))
    }

    fn bounds(&self) -> Aabb {
        self.0.bounds().union(self.1.bounds())
    }
}

/// How much of the picture is to be filled, and by which projection it is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Framing {
    /// Vertical field of view in radians; of the perspective picture that shows as much of the target's plane, if it is
    /// orthographic.
    pub fov_y: f64,
    /// Width over height.
    pub aspect: f64,
    /// Whether the projection is orthographic.
    pub is_parallel: bool,
    /// The share of the picture's width or height, whichever is tighter, that is filled: above 0, at most 1.
    pub filled: f64,
}

impl Framing {
    /// [`Framing::filled`] of a picture without labels.
    pub const FILLED: f64 = 0.85;
    /// How far before what is framed the eye stands at least, as a share of half its depth.
    const BEFORE: f64 = 0.05;

    /// The target and the distance of an eye that sees all of `framed` as large as this allows. `axes` are the columns
    /// right, up and towards the viewer. Empty counts as the box from -1 to 1.
    ///
    /// A point p is left of the picture's right border, seen from e, where (r + s b) . p <= (r + s b) . e; r points
    /// right, b towards the viewer, and s is the border's slope. So the points that reach farthest along that
    /// direction and along its mirror image decide where e stands between right and left, and how far back. Up and down
    /// are alike.
    pub(super) fn place(&self, framed: &impl Framed, axes: &DMat3) -> (DVec3, f64) {
        let top = self.filled * libm::tan(0.5 * self.fov_y);
        let slopes = [top * self.aspect, top];
        let mut leaning = if self.is_parallel { [0.0; 2] } else { slopes };
        let mut seen = Reach::of(framed, axes, leaning);
        let middle = 0.5 * (seen.depths[0] + seen.depths[1]);
        let back = (seen.half[0] / slopes[0]).max(seen.half[1] / slopes[1]);
        let distance = if self.is_parallel {
            back
        } else {
            let depth = seen.depths[1] - middle;
            (back - middle).max((1.0 + Self::BEFORE) * depth)
        };
        let is_point = seen.is_point || distance <= 0.0;
        if !(self.is_parallel || is_point) {
            // From there the wider direction has room. Its own slopes, at which it would be full, centre it.
            for _ in 0..CENTRED {
                leaning = [0, 1].map(|i| (seen.half[i] - leaning[i] * middle) / distance);
                seen = Reach::of(framed, axes, leaning);
            }
        }
        let target = *axes * DVec3::new(seen.aside[0], seen.aside[1], middle);
        // A point has no size. Stay far enough away that the eye's rounded coordinates differ from the point's.
        let least = 1e-3 * target.length().max(1.0);
        (target, if is_point { least } else { distance })
    }
}

/// How far the points that are framed reach along directions that lean towards the viewer.
struct Reach {
    /// Where the eye stands, right and up, for each pair of mirrored directions to reach equally far.
    aside: [f64; 2],
    /// How far they reach then.
    half: [f64; 2],
    /// The least and the largest coordinate towards the viewer.
    depths: [f64; 2],
    is_point: bool,
}

impl Reach {
    fn of(framed: &impl Framed, axes: &DMat3, leaning: [f64; 2]) -> Self {
        let [plus, minus] = [1.0, -1.0].map(|sign| {
            let [along, above] = leaning.map(|slope| sign * slope * axes.z_axis);
            let map = DMat3::from_cols(axes.x_axis + along, axes.y_axis + above, axes.z_axis);
            let map = map.transpose();
            let bounds = framed.bounds_through(&map);
            if bounds.is_empty() {
                Aabb::EMPTY.or_unit().bounds_through(&map)
            } else {
                bounds
            }
        });
        let (aside, half) = (0.5 * (plus.max + minus.min), 0.5 * (plus.max - minus.min));
        Self {
            aside: [aside.x, aside.y],
            half: [half.x, half.y],
            depths: [plus.min.z, plus.max.z],
            is_point: plus.max == plus.min,
        }
    }
}
