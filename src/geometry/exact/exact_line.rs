//! The lines of rays in exact numbers, in world space and in object space.

use super::{
    super::{PixelGrid, ThroughPoint, line::Line, local_ray::Exactly},
    integer::Ring,
    matrix::Adjugate,
    number::{Number, Vector},
    point::{moved, placed},
    root::Root,
};
use glam::{DVec2, DVec3};
use num_bigint::BigInt;

/// A ray: `(origin + t direction) / weight`, which avoids dividing by the picture's height.
pub(crate) struct ExactLine<I> {
    pub origin: Vector<I>,
    pub direction: Vector<I>,
    pub weight: Number<I>,
}

impl<I: Ring> ExactLine<I> {
    pub(super) fn new(line: &Line) -> Self {
        match line {
            Line::Given { origin, direction } => Self {
                origin: Vector::new(*origin),
                direction: Vector::new(*direction),
                weight: Number::new(1.0),
            },
            Line::Pixel { grid, px } => Self::of_pixel(grid, *px),
            Line::Through(through) => Self::through(through),
        }
    }

    /// The ray of a grid through a position; see [`PixelGrid::ray`]. The weight is the picture's height.
    pub fn of_pixel(grid: &PixelGrid, px: DVec2) -> Self {
        let height = Number::new(grid.size_px[1].into());
        let [of_right, of_up] = factors(grid, px);
        let right = Vector::new(grid.right).times(&of_right);
        let up = Vector::new(grid.up).times(&of_up);
        let aside = right.plus(&up);
        let [eye, forward] = [grid.eye, grid.forward].map(|v| Vector::new(v).times(&height));
        let (origin, direction) = if grid.is_orthographic {
            (eye.plus(&aside), forward)
        } else {
            (eye, forward.plus(&aside))
        };
        Self {
            origin,
            direction,
            weight: height,
        }
    }

    /// Let n = U x R, which points into the picture. The point P lies at depth t = n . (P - eye) / n . F. The line is
    /// `eye + t' (P - eye) / t` in perspective and `P - t F + t' F` in orthographic projection. Each is multiplied by
    /// its denominator.
    fn through(ThroughPoint { grid, point, .. }: &ThroughPoint) -> Self {
        let point = placed(point);
        let [depth, unit] = depth_of(grid, &point);
        let [eye, forward] = [grid.eye, grid.forward].map(Vector::new);
        if grid.is_orthographic {
            Self {
                origin: point.times(&unit).minus(&forward.times(&depth)),
                direction: forward.times(&unit),
                weight: unit,
            }
        } else {
            Self {
                origin: eye.times(&depth),
                direction: point.minus(&eye).times(&unit),
                weight: depth,
            }
        }
    }

    /// From the ray's origin to a point, times the weight.
    pub(super) fn to(&self, point: &Vector<I>) -> Vector<I> {
        point.times(&self.weight).minus(&self.origin)
    }
}

/// The factors of R and U in [`PixelGrid::ray`], times the picture's height: `h (2 x - W)` and `h (H - 2 y)`.
pub(crate) fn factors<I: Ring>(grid: &PixelGrid, px: DVec2) -> [Number<I>; 2] {
    let [width, height] = grid.size_px.map(|size| Number::new(size.into()));
    let two = Number::new(2.0);
    let [x, y] = [px.x, px.y].map(|at| two.times(&Number::new(at)));
    let half_height = Number::new(grid.half_height);
    [x.minus(&width), height.minus(&y)].map(|factor| factor.times(&half_height))
}

/// The depth of a point in a picture as a quotient: with n = U x R, n . (P - eye) over n . F.
fn depth_of<I: Ring>(grid: &PixelGrid, point: &Vector<I>) -> [Number<I>; 2] {
    let normal = Vector::new(grid.up).cross(&Vector::new(grid.right));
    let from_eye = point.minus(&Vector::new(grid.eye));
    [
        normal.dot(&from_eye),
        normal.dot(&Vector::new(grid.forward)),
    ]
}

/// The parameter of the point that a ray was made through; `None` for other rays.
pub(super) fn point_parameter(line: &Line) -> Option<Root> {
    let Line::Through(ThroughPoint { grid, point, .. }) = line else {
        return None;
    };
    let [depth, unit] = depth_of::<BigInt>(grid, &placed(point));
    Root::quotient(depth, unit)
}

/// A line's numbers, rounded.
pub(in super::super) struct Rounded {
    pub origin: DVec3,
    pub direction: DVec3,
}

/// The numbers of a line, each within three roundings; `None` where a number is not finite, or the line's weight is not
/// above 0.
pub(in super::super) fn rounded_line(line: &Line) -> Option<Rounded> {
    if !line.is_finite() {
        return None;
    }
    let exact = ExactLine::<BigInt>::new(line);
    exact.weight.sign().is_gt().then(|| Rounded {
        origin: rounded(&exact.origin, &exact.weight),
        direction: rounded(&exact.direction, &exact.weight),
    })
}

fn rounded(v: &Vector<BigInt>, weight: &Number<BigInt>) -> DVec3 {
    DVec3::from_array([0, 1, 2].map(|axis| v.component(axis).ratio(weight)))
}

/// A ray in object space, times [`LocalLine::weight`].
pub(in super::super) struct LocalLine<I> {
    pub origin: Vector<I>,
    pub direction: Vector<I>,
    /// Origin and direction are to be divided by this: the line's weight times the determinant of the model matrix.
    /// Negative where that mirrors: then all three are to be negated.
    pub weight: Number<I>,
}

impl<I: Ring> LocalLine<I> {
    pub fn new(exactly: &Exactly) -> Self {
        let line = ExactLine::<I>::new(&exactly.line);
        let Some(placement) = moved(exactly.placement) else {
            return Self {
                origin: line.origin,
                direction: line.direction,
                weight: line.weight,
            };
        };
        let model = placement.model();
        let to_object = Adjugate::new(model.matrix3);
        let translation = Vector::new(model.translation).times(&line.weight);
        let from_translation = line.origin.minus(&translation);
        Self {
            origin: to_object.times(&from_translation),
            direction: to_object.times(&line.direction),
            weight: to_object.determinant.times(&line.weight),
        }
    }
}
