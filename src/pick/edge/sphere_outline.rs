//! Distance in pixels to a sphere's outline: the curve where rays of the picture touch the sphere.

use super::conic::{Conic, HalfPlane};
use crate::{
    camera::View,
    geometry::{
        PixelGrid, Placement,
        dyadic::{Adjugate, Dyadic, DyadicVector, ExactLine, rounded},
    },
};
use glam::{DVec2, DVec3};

/// A function over the picture: its value at the position, and how much it changes for a pixel to the right and for one
/// down. All such functions here are linear.
type Over<T> = [T; 3];

/// Distance in pixels from a position where a sphere is hit to the part of its outline at or behind the near plane that
/// the section keeps; `None` when there is none.
///
/// All factors are exact until they are rounded, at the end, and those of the curve as seen from the position. So no
/// digits are lost, however small the picture is beside the outline.
pub(super) fn distance_px(view: &View, px: DVec2, placement: &Placement) -> Option<f64> {
    let grid = view.camera.pixel_grid(view.viewport);
    let world = Rays::new(&grid, px);
    let local = world.to_object(placement);
    let (t, s) = touching(&grid, &local)?;
    let near = Dyadic::new(view.camera.lens().near);
    let behind_near = [0, 1, 2].map(|i| t[i].minus(&s[i].times(&near)));
    let section = view.section.map(|section| {
        let normal = DyadicVector::new(section.normal());
        let [mut origin, direction] =
            [&world.origin, &world.direction].map(|over| over.each_ref().map(|v| normal.dot(v)));
        origin[0] = origin[0].plus(&Dyadic::new(section.offset()).times(&world.weight));
        let (of_s, of_t) = (product(&origin, &s), product(&direction, &t));
        [0, 1, 2].map(|i| of_s[i].plus(&of_t[i]))
    });
    let kept = [Some(s), Some(behind_near), section].into_iter().flatten();
    let kept: Vec<HalfPlane> = kept.map(half_plane).collect();
    outline(&local).distance(&kept)
}

/// The rays of a picture about a position: origin and direction, both times a weight. One of them is the same for all
/// rays.
struct Rays {
    origin: Over<DyadicVector>,
    direction: Over<DyadicVector>,
    weight: Dyadic,
}

impl Rays {
    /// In world space. The weight is the picture's height.
    fn new(grid: &PixelGrid, px: DVec2) -> Self {
        let vector = DyadicVector::new;
        let ExactLine {
            origin,
            direction,
            weight,
        } = ExactLine::of_pixel(grid, px);
        let per_px = Dyadic::new(2.0).times(&Dyadic::new(grid.half_height));
        let steps = [
            vector(grid.right).times(&per_px),
            vector(grid.up).times(&per_px.negated()),
        ];
        let still = [vector(DVec3::ZERO), vector(DVec3::ZERO)];
        let over = |here, [right, down]: [DyadicVector; 2]| [here, right, down];
        let (origin, direction) = if grid.is_orthographic {
            (over(origin, steps), over(direction, still))
        } else {
            (over(origin, still), over(direction, steps))
        };
        Self {
            origin,
            direction,
            weight,
        }
    }

    /// In the object space of a placement. The weight is that in the world times the determinant of the model matrix.
    fn to_object(&self, placement: &Placement) -> Self {
        let model = placement.model();
        let to_object = Adjugate::new(model.matrix3);
        let mut origin = self.origin.clone();
        let center = DyadicVector::new(model.translation);
        origin[0] = origin[0].minus(&center.times(&self.weight));
        Self {
            origin: origin.map(|v| to_object.times(&v)),
            direction: self.direction.each_ref().map(|v| to_object.times(v)),
            weight: to_object.determinant.times(&self.weight),
        }
    }

    /// The square of the sphere's radius, times that of the weight.
    fn radius_squared(&self) -> Dyadic {
        self.weight.squared().times(&Dyadic::new(0.25))
    }
}

/// The outline as a conic. A line with origin `o`, direction `d` and moment `m = o x d` touches the sphere where `r^2 d .
/// d - m . m` is 0, and meets it where that is above 0. `d` and `m` are linear over the picture (Plücker coordinates;
/// Pottmann & Wallner, "Computational Line Geometry", 2001, 2.1).
fn outline(rays: &Rays) -> Conic {
    let (o, d) = (&rays.origin, &rays.direction);
    let moment: Over<_> = [0, 1, 2].map(|i| match i {
        0 => o[0].cross(&d[0]),
        _ => o[i].cross(&d[0]).plus(&o[0].cross(&d[i])),
    });
    let radius_squared = rays.radius_squared();
    let form = |i: usize, j: usize| {
        let of_directions = radius_squared.times(&d[i].dot(&d[j]));
        of_directions.minus(&moment[i].dot(&moment[j]))
    };
    let twice = |n: Dyadic| n.plus(&n);
    let [xx, yy] = [form(1, 1), form(2, 2)];
    let [x, y, xy] = [(0, 1), (0, 2), (1, 2)].map(|(i, j)| twice(form(i, j)));
    let [constant, x, y, xx, xy, yy] = in_f64([form(0, 0), x, y, xx, xy, yy]);
    Conic {
        constant,
        linear: DVec2::new(x, y),
        square: [xx, xy, yy],
    }
}

/// Numerator and denominator of the parameter at which the rays of the outline touch the sphere; the denominator is
/// above 0 there. `None` when the eye is not outside.
///
/// In perspective the points of touch lie in the plane `y . o = r^2` of object space, so the parameter is `(o . o - r^2)
/// / -(o . d)`. In orthographic projection they lie in `y . d = 0`, so it is `-(o . d) / (d . d)`. Of numerator and
/// denominator one is constant and one linear over the picture: near plane and section keep what is on one side of a
/// line.
fn touching(grid: &PixelGrid, rays: &Rays) -> Option<(Over<Dyadic>, Over<Dyadic>)> {
    let (o, d) = (&rays.origin, &rays.direction);
    let constant = |n: Dyadic| [n, Dyadic::new(0.0), Dyadic::new(0.0)];
    if grid.is_orthographic {
        let along = [0, 1, 2].map(|i| o[i].dot(&d[0]).negated());
        return Some((along, constant(d[0].dot(&d[0]))));
    }
    let outside = o[0].dot(&o[0]).minus(&rays.radius_squared());
    let towards = [0, 1, 2].map(|i| o[0].dot(&d[i]).negated());
    let is_outside = outside.sign().is_gt();
    is_outside.then(|| (constant(outside), towards))
}

/// The product of two functions, of which one is constant.
fn product(a: &Over<Dyadic>, b: &Over<Dyadic>) -> Over<Dyadic> {
    [0, 1, 2].map(|i| match i {
        0 => a[0].times(&b[0]),
        _ => a[i].times(&b[0]).plus(&a[0].times(&b[i])),
    })
}

/// Where a function is not negative.
fn half_plane(over: Over<Dyadic>) -> HalfPlane {
    let [constant, x, y] = in_f64(over);
    let linear = DVec2::new(x, y);
    HalfPlane { constant, linear }
}

/// Numbers, over the least power of two above them all.
fn in_f64<const N: usize>(numbers: [Dyadic; N]) -> [f64; N] {
    let sizes = numbers.iter().filter_map(Dyadic::magnitude);
    let unit = sizes.max().unwrap_or(0);
    numbers.map(|n| rounded(&n.integer, n.exponent - unit))
}
