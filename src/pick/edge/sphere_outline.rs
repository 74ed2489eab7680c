//! Distance in pixels to a sphere's outline: the curve where rays of the picture touch the sphere.

use super::conic::{Conic, HalfPlane};
use crate::{
    camera::View,
    geometry::{
        Placement,
        dyadic::{Adjugate, Dyadic, DyadicVector, factors, rounded},
    },
};
use glam::DVec2;

/// A function over the picture: the factors of 1, x and y, in pixels right and down from the position.
type Over<T> = [T; 3];

/// Distance in pixels to the part of a sphere's outline at or behind the near plane that the section keeps; `None` when
/// there is none.
///
/// Over the picture, a ray's origin `o` and direction `d` in the sphere's space are linear (one of them is constant). Its
/// line touches the sphere where `r^2 d . d - m . m` is 0, with the line's moment `m = o x d`: a conic, since m is
/// linear, too (Plücker coordinates; Pottmann & Wallner, "Computational Line Geometry", 2001, 2.1). The form is above 0
/// where the line meets the sphere, as at the position. There it touches at t = T / s, of which one is constant and the
/// other linear: in perspective `(o . o - r^2) / -(o . d)`, in orthographic projection `-(o . d) / (d . d)`. So near
/// plane and section keep what is on one side of a line.
///
/// All factors are exact until they are rounded, at the end. So none loses digits, however small the picture is beside
/// the outline: they are those of the curve as seen from the position.
pub(super) fn distance_px(view: &View, px: DVec2, placement: &Placement) -> Option<f64> {
    let grid = view.camera.pixel_grid(view.viewport);
    let is_parallel = grid.is_orthographic;
    let vector = DyadicVector::new;
    let [of_right, of_up] = factors(&grid, px);
    let step = Dyadic::new(2.0).times(&Dyadic::new(grid.half_height));
    let height = Dyadic::new(grid.size_px[1].into());
    let (right, up) = (vector(grid.right), vector(grid.up));
    // In world space, times the picture's height.
    let aside = [
        right.times(&of_right).plus(&up.times(&of_up)),
        right.times(&step),
        up.times(&step.negated()),
    ];
    let plus_aside = |v: DyadicVector, is_added: bool| {
        let [here, right, down] = aside.clone();
        if is_added {
            [v.plus(&here), right, down]
        } else {
            let zero = || vector(glam::DVec3::ZERO);
            [v, zero(), zero()]
        }
    };
    let origin_world = plus_aside(vector(grid.eye).times(&height), is_parallel);
    let direction_world = plus_aside(vector(grid.forward).times(&height), !is_parallel);
    // In the sphere's space, times this weight.
    let to_object = Adjugate::new(placement.model().matrix3);
    let weight = to_object.determinant.times(&height);
    let center = vector(placement.model().translation).times(&height);
    let mut origin = origin_world.clone();
    origin[0] = origin[0].minus(&center);
    let [origin, direction] =
        [&origin, &direction_world].map(|over| over.each_ref().map(|v| to_object.times(v)));

    let radius_squared = weight.times(&weight).times(&Dyadic::new(0.25));
    let [o, d] = [&origin[0], &direction[0]];
    let moment: Over<_> = [0, 1, 2].map(|i| match i {
        0 => o.cross(d),
        _ => origin[i].cross(d).plus(&o.cross(&direction[i])),
    });
    let form = |i: usize, j: usize| {
        let of_directions = direction[i].dot(&direction[j]);
        (of_directions.times(&radius_squared)).minus(&moment[i].dot(&moment[j]))
    };
    let twice = |n: Dyadic| n.plus(&n);
    let conic = in_f64([
        form(0, 0),
        twice(form(0, 1)),
        twice(form(0, 2)),
        form(1, 1),
        twice(form(1, 2)),
        form(2, 2),
    ]);

    let zero = || Dyadic::new(0.0);
    let constant = |n: Dyadic| [n, zero(), zero()];
    let towards: Over<_> = [0, 1, 2].map(|i| match is_parallel {
        true => origin[i].dot(d).negated(),
        false => o.dot(&direction[i]).negated(),
    });
    let (t, s) = if is_parallel {
        (towards, constant(d.dot(d)))
    } else {
        let outside = o.dot(o).minus(&radius_squared);
        if !outside.sign().is_gt() {
            return None;
        }
        (constant(outside), towards)
    };
    let near = Dyadic::new(view.camera.lens().near);
    let behind_near = [0, 1, 2].map(|i| t[i].minus(&s[i].times(&near)));
    let kept = view.section.map(|section| {
        let normal = vector(section.normal());
        let [at_origin, along] =
            [&origin_world, &direction_world].map(|over| over.each_ref().map(|v| normal.dot(v)));
        let offset = Dyadic::new(section.offset()).times(&height);
        let at_origin = plus(&at_origin, &constant(offset));
        plus(&product(&at_origin, &s), &product(&t, &along))
    });
    let half_planes: Vec<HalfPlane> = [Some(s), Some(behind_near), kept]
        .into_iter()
        .flatten()
        .map(|over| {
            let [constant, x, y] = in_f64(over);
            let linear = DVec2::new(x, y);
            HalfPlane { constant, linear }
        })
        .collect();
    let [constant, x, y, xx, xy, yy] = conic;
    let conic = Conic {
        constant,
        linear: DVec2::new(x, y),
        square: [xx, xy, yy],
    };
    conic.distance(&half_planes)
}

fn plus(a: &Over<Dyadic>, b: &Over<Dyadic>) -> Over<Dyadic> {
    [0, 1, 2].map(|i| a[i].plus(&b[i]))
}

/// The product of two functions over the picture, one of which is constant.
fn product(a: &Over<Dyadic>, b: &Over<Dyadic>) -> Over<Dyadic> {
    let across = |i: usize| a[i].times(&b[0]).plus(&a[0].times(&b[i]));
    [a[0].times(&b[0]), across(1), across(2)]
}

/// Numbers, over the least power of two above them all.
fn in_f64<const N: usize>(numbers: [Dyadic; N]) -> [f64; N] {
    let sizes = numbers.iter().filter_map(Dyadic::magnitude);
    let unit = sizes.max().unwrap_or(0);
    numbers.map(|n| rounded(&n.integer, n.exponent - unit))
}
