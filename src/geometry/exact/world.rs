//! Turns rays, points and placements into exact numbers, in world space and in object space.

#[cfg(test)]
use super::super::LocalRay;
use super::{
    super::{PixelGrid, PlacedPoint, Placement, ThroughPoint, local_ray::Exactly, ray::Line},
    integer::Ring,
    number::{Number, Vector},
    root::Root,
};
use glam::{DAffine3, DMat3, DVec2, DVec3};
use num_bigint::BigInt;

/// A ray: `(origin + t direction) / weight`, which avoids dividing by the picture's height.
pub(super) struct ExactLine<I> {
    pub origin: Vector<I>,
    pub direction: Vector<I>,
    pub weight: Number<I>,
}

impl<I: Ring> ExactLine<I> {
    pub fn new(line: &Line) -> Self {
        match line {
            Line::Given { origin, direction } => Self {
                origin: Vector::new(*origin),
                direction: Vector::new(*direction),
                weight: Number::new(1.0),
            },
            Line::Pixel { grid, px } => {
                let height = Number::new(grid.size_px[1].into());
                let [of_right, of_up] = factors(grid, *px);
                let right = Vector::new(grid.right).times(&of_right);
                let up = Vector::new(grid.up).times(&of_up);
                let aside = right.plus(&up);
                let [eye, forward] =
                    [grid.eye, grid.forward].map(|v| Vector::new(v).times(&height));
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
            Line::Through(through) => Self::through(through),
        }
    }

    /// Let n = U x R, which points into the picture. The point P lies at depth t = n . (P - eye) / n . F. The line is
    /// `eye + t' (P - eye) / t` in perspective and `P - t F + t' F` in orthographic projection. Each is multiplied by its
    /// denominator.
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
    pub fn to(&self, point: &Vector<I>) -> Vector<I> {
        point.times(&self.weight).minus(&self.origin)
    }
}

/// The factors of R and U in [`PixelGrid::ray`], times the picture's height: `h (2 x - W)` and `h (H - 2 y)`.
pub(super) fn factors<I: Ring>(grid: &PixelGrid, px: DVec2) -> [Number<I>; 2] {
    let [width, height] = grid.size_px.map(|size| Number::new(size.into()));
    let two = Number::new(2.0);
    let [x, y] = [px.x, px.y].map(|at| two.times(&Number::new(at)));
    let half_height = Number::new(grid.half_height);
    [x.minus(&width), height.minus(&y)].map(|factor| factor.times(&half_height))
}

/// Where a placement puts the sum of two vectors of object space.
pub(super) fn point<I: Ring>(placement: Option<&Placement>, sum_of: [DVec3; 2]) -> Vector<I> {
    let object = match sum_of {
        [DVec3::ZERO, point] => Vector::new(point),
        [a, b] => Vector::new(a).plus(&Vector::new(b)),
    };
    match moved(placement) {
        Some(placement) => {
            turned(placement, &object).plus(&Vector::new(placement.model().translation))
        }
        None => object,
    }
}

/// The vector from one point of object space to another, in the world of the placement.
pub(super) fn way<I: Ring>(placement: Option<&Placement>, from: DVec3, to: DVec3) -> Vector<I> {
    let object = Vector::new(to).minus(&Vector::new(from));
    match moved(placement) {
        Some(placement) => turned(placement, &object),
        None => object,
    }
}

/// The placement, unless it is the identity.
fn moved(placement: Option<&Placement>) -> Option<&Placement> {
    placement.filter(|placement| !placement.is_identity())
}

/// A point of a shape in the world.
pub(super) fn placed<I: Ring>(point: &PlacedPoint) -> Vector<I> {
    let from = Vector::new(point.from);
    // A share of 0 adds nothing, but the exponent of `to` would still lengthen the integers.
    let here = if point.share == 0.0 {
        from
    } else {
        let way = Vector::new(point.to).minus(&from);
        from.plus(&way.times(&Number::new(point.share)))
    };
    let object = match point.origin {
        DVec3::ZERO => here,
        origin => here.plus(&Vector::new(origin)),
    };
    if point.model == DAffine3::IDENTITY {
        return object;
    }
    turned_by(point.model.matrix3, &object).plus(&Vector::new(point.model.translation))
}

/// Where a placement puts a point of object space. Both points are given times `weight`.
pub(super) fn moved_by(
    placement: &Placement,
    point: &Vector<BigInt>,
    weight: &Number<BigInt>,
) -> Vector<BigInt> {
    let translation = Vector::new(placement.model().translation);
    turned(placement, point).plus(&translation.times(weight))
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
    if !super::is_finite(line) {
        return None;
    }
    let exact = ExactLine::<BigInt>::new(line);
    exact.weight.sign().is_gt().then(|| Rounded {
        origin: rounded(&exact.origin, &exact.weight),
        direction: rounded(&exact.direction, &exact.weight),
    })
}

/// Where a point is in the world, each coordinate rounded once.
pub(in super::super) fn point_world(point: &PlacedPoint) -> DVec3 {
    divided(&placed(point), &Number::new(1.0))
}

/// A point divided by a number other than 0, each coordinate rounded once.
pub(crate) fn divided(point: &Vector<BigInt>, by: &Number<BigInt>) -> DVec3 {
    let nearest = |axis| Root::quotient(point.component(axis), by.clone());
    DVec3::from_array([0, 1, 2].map(|axis| nearest(axis).map_or(f64::NAN, |root| root.to_f64())))
}

fn rounded(v: &Vector<BigInt>, weight: &Number<BigInt>) -> DVec3 {
    DVec3::from_array([0, 1, 2].map(|axis| v.component(axis).ratio(weight)))
}

/// A vector of object space times the placement's linear part.
fn turned<I: Ring>(placement: &Placement, object: &Vector<I>) -> Vector<I> {
    turned_by(placement.model().matrix3, object)
}

fn turned_by<I: Ring>(matrix: DMat3, object: &Vector<I>) -> Vector<I> {
    let columns = columns(matrix);
    let [x, y, z] = [0, 1, 2].map(|i| columns[i].times(&object.component(i)));
    x.plus(&y).plus(&z)
}

fn columns<I: Ring>(matrix: DMat3) -> [Vector<I>; 3] {
    [matrix.x_axis, matrix.y_axis, matrix.z_axis].map(Vector::new)
}

/// A ray in object space, times [`LocalLine::one`].
pub(super) struct LocalLine<I> {
    pub origin: Vector<I>,
    pub direction: Vector<I>,
    /// What stands for 1: the ray's weight times the determinant. Where it is negative, origin and direction have to be
    /// negated.
    pub one: Number<I>,
}

impl<I: Ring> LocalLine<I> {
    pub fn new(exactly: &Exactly) -> Self {
        let line = ExactLine::<I>::new(&exactly.line);
        let Some(placement) = moved(exactly.placement) else {
            return Self {
                origin: line.origin,
                direction: line.direction,
                one: line.weight,
            };
        };
        let model = placement.model();
        let Adjugate { rows, determinant } = Adjugate::new(model.matrix3);
        let translation = Vector::new(model.translation).times(&line.weight);
        let from_translation = line.origin.minus(&translation);
        Self {
            origin: product(&rows, &from_translation),
            direction: product(&rows, &line.direction),
            one: determinant.times(&line.weight),
        }
    }
}

/// A matrix's inverse times its determinant, by rows.
pub(super) struct Adjugate<I> {
    pub rows: [Vector<I>; 3],
    pub determinant: Number<I>,
}

impl<I: Ring> Adjugate<I> {
    pub fn new(matrix: DMat3) -> Self {
        let [x, y, z] = &columns(matrix);
        let rows = [y.cross(z), z.cross(x), x.cross(y)];
        let determinant = x.dot(&rows[0]);
        Self { rows, determinant }
    }
}

/// A matrix, by rows, times a vector.
fn product<I: Ring>(rows: &[Vector<I>; 3], v: &Vector<I>) -> Vector<I> {
    Vector::of(&rows.each_ref().map(|row| row.dot(v)))
}

/// How far a local ray's origin and direction are from the exact ones, by component.
#[cfg(test)]
pub(in super::super) fn errors(ray: &LocalRay) -> [DVec3; 2] {
    let LocalLine {
        origin,
        direction,
        one,
    } = LocalLine::<BigInt>::new(&ray.exactly());
    [(origin, ray.ray.origin), (direction, ray.ray.direction)].map(|(exact, rounded)| {
        let error = exact.minus(&Vector::new(rounded).times(&one));
        DVec3::from_array([0, 1, 2].map(|axis| error.component(axis).ratio(&one).abs()))
    })
}
