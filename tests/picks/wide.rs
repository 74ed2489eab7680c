//! Where the picture shows edges and outlines, computed from the stored numbers with enough digits.
//!
//! Shares no code with the program: it uses another crate's floats, inverse matrices and sampled angles.

use dashu_float::{FBig, round::mode::HalfEven};
use glam::{DMat3, DVec2, DVec3};
use sightline::{camera::View, geometry::Placement};
use std::{
    array,
    cmp::Ordering,
    ops::{Add, Div, Mul, Sub},
};

type Float = FBig<HalfEven, 2>;

/// A number of [`Truth::bits`] bits.
#[derive(Clone, Debug, PartialEq, PartialOrd)]
pub struct Wide(Float);

macro_rules! operators {
    ($($name:ident $function:ident),*) => {$(
        impl $name for &Wide {
            type Output = Wide;
            fn $function(self, other: Self) -> Wide {
                Wide(self.0.clone().$function(other.0.clone()))
            }
        }
        impl $name for Wide {
            type Output = Wide;
            fn $function(self, other: Self) -> Wide {
                Wide(self.0.$function(other.0))
            }
        }
    )*};
}
operators!(Add add, Sub sub, Mul mul, Div div);

impl Wide {
    fn new(x: f64, bits: usize) -> Self {
        let float = Float::try_from(x).expect("a finite number");
        Self(float.with_precision(bits).value())
    }

    fn sqrt(&self) -> Self {
        Self(self.0.sqrt())
    }

    fn abs(&self) -> Self {
        let negative = self.0 < Float::ZERO;
        Self(if negative {
            -self.0.clone()
        } else {
            self.0.clone()
        })
    }

    fn to_f64(&self) -> f64 {
        self.0.to_f64().value()
    }
}

type V = [Wide; 3];

fn dot(a: &V, b: &V) -> Wide {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn cross(a: &V, b: &V) -> V {
    array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &a[j] * &b[k] - &a[k] * &b[j]
    })
}

fn minus(a: &V, b: &V) -> V {
    array::from_fn(|i| &a[i] - &b[i])
}

fn columns(m: DMat3) -> [DVec3; 3] {
    [m.x_axis, m.y_axis, m.z_axis]
}

/// The rows of a matrix's inverse, from its columns.
fn dual([x, y, z]: &[V; 3]) -> [V; 3] {
    let rows = [cross(y, z), cross(z, x), cross(x, y)];
    let determinant = dot(x, &rows[0]);
    rows.map(|row| row.map(|c| c / determinant.clone()))
}

/// x + s d.
fn along(x: &V, s: &Wide, d: &V) -> V {
    array::from_fn(|i| &x[i] + &(s * &d[i]))
}

fn scaled(s: &Wide, d: &V) -> V {
    array::from_fn(|i| s * &d[i])
}

/// A camera and a position of its picture.
pub struct Truth {
    bits: usize,
    eye: V,
    /// The rows of the inverse of (R, U, F).
    dual: [V; 3],
    forward: V,
    half_height: Wide,
    size: [Wide; 2],
    px: [Wide; 2],
    near: Wide,
    perspective: bool,
}

impl Truth {
    pub fn new(view: &View, px: DVec2, bits: usize) -> Self {
        let wide = |x: f64| Wide::new(x, bits);
        let vector = |v: DVec3| v.to_array().map(wide);
        let camera = &view.camera;
        let axes = [camera.right(), camera.up(), camera.forward()].map(vector);
        Self {
            bits,
            eye: vector(camera.eye()),
            dual: dual(&axes),
            forward: vector(camera.forward()),
            half_height: wide(camera.half_height()),
            size: view.viewport.size_px().to_array().map(wide),
            px: px.to_array().map(wide),
            near: wide(camera.lens().near),
            perspective: !camera.lens().is_orthographic(),
        }
    }

    fn wide(&self, x: f64) -> Wide {
        Wide::new(x, self.bits)
    }

    fn vector(&self, v: DVec3) -> V {
        v.to_array().map(|x| self.wide(x))
    }

    /// Coordinates along R, U and F from the eye. The one along F is t.
    fn coordinates(&self, world: &V) -> V {
        let q = minus(world, &self.eye);
        self.dual.each_ref().map(|row| dot(row, &q))
    }

    /// Offset in pixels from the position to where the picture shows a point.
    fn offset(&self, [r, u, t]: &V) -> [Wide; 2] {
        let depth = if self.perspective {
            t.clone()
        } else {
            self.wide(1.0)
        };
        let half = self.wide(0.5);
        let px_per_length = &self.size[1] * &half / (&self.half_height * &depth);
        let x = &self.size[0] * &half + r * &px_per_length;
        let y = &self.size[1] * &half - u * &px_per_length;
        [x - self.px[0].clone(), y - self.px[1].clone()]
    }

    /// The world point of a vertex about an origin.
    pub fn world(&self, placement: &Placement, origin: DVec3, vertex: DVec3) -> V {
        let [x, y, z] = columns(placement.model().matrix3).map(|v| self.vector(v));
        let local: V = array::from_fn(|i| self.wide(origin[i]) + self.wide(vertex[i]));
        let translation = self.vector(placement.model().translation);
        let point = along(&translation, &local[0], &x);
        along(&along(&point, &local[1], &y), &local[2], &z)
    }

    /// Distance in pixels to the nearest side of a polygon, and whether a cut by the near plane is nearest.
    pub fn polygon_px(&self, corners: &[V]) -> Option<(f64, bool)> {
        let corners: Vec<V> = corners
            .iter()
            .map(|corner| self.coordinates(corner))
            .collect();
        let sides = (0..corners.len()).map(|i| (&corners[i], &corners[(i + 1) % corners.len()]));
        let nearest = sides.filter_map(|(a, b)| self.side_px(a, b));
        let (px, cut) = nearest.min_by(|a, b| a.0.partial_cmp(&b.0).unwrap())?;
        Some((px.to_f64(), cut))
    }

    fn side_px(&self, a: &V, b: &V) -> Option<(Wide, bool)> {
        let shows = |p: &V| p[2] >= self.near;
        let (a, b) = if shows(a) { (a, b) } else { (b, a) };
        if !shows(a) {
            return None;
        }
        let is_cut = !shows(b);
        let b = if is_cut {
            let s = (&a[2] - &self.near) / (&a[2] - &b[2]);
            let [r, u, _] = along(a, &s, &minus(b, a));
            [r, u, self.near.clone()]
        } else {
            b.clone()
        };
        let [p, q] = [a, &b].map(|end| self.offset(end));
        let d: [Wide; 2] = array::from_fn(|i| &q[i] - &p[i]);
        let square = |v: &[Wide; 2]| &v[0] * &v[0] + &v[1] * &v[1];
        let zero = self.wide(0.0);
        if square(&d) == zero {
            return Some((square(&p).sqrt(), false));
        }
        let s = (&p[0] * &d[0] + &p[1] * &d[1]) / (zero.clone() - square(&d));
        if s <= zero {
            return Some((square(&p).sqrt(), false));
        }
        if s >= self.wide(1.0) {
            return Some((square(&q).sqrt(), is_cut));
        }
        // Check: no sampled point is nearer.
        let foot = square(&array::from_fn(|i| &p[i] + &(&s * &d[i])));
        for i in 0..=16 {
            let point = along(a, &self.wide(f64::from(i) / 16.0), &minus(&b, a));
            let there = square(&self.offset(&point));
            assert!(there + self.wide(1e-30) >= foot, "the foot is nearest");
        }
        Some((foot.sqrt(), false))
    }

    /// Distance in pixels to the part of a sphere's outline beyond the near plane, and whether one of that part's ends
    /// is nearest.
    pub fn outline_px(&self, placement: &Placement) -> Option<(f64, bool)> {
        Outline::new(self, placement)?.distance_px()
    }
}

/// A sphere's outline as a circle in object space.
struct Outline<'a> {
    truth: &'a Truth,
    /// Its centre and two radii, in R, U and F coordinates like every vector here.
    center: V,
    radii: [V; 2],
}

impl<'a> Outline<'a> {
    fn new(truth: &'a Truth, placement: &Placement) -> Option<Self> {
        let wide = |x| truth.wide(x);
        let axes = columns(placement.model().matrix3).map(|v| truth.vector(v));
        let inverse = dual(&axes);
        let to_object = |v: &V| inverse.each_ref().map(|row| dot(row, v));
        let translation = truth.vector(placement.model().translation);
        let (center, squared_radius, axis) = if truth.perspective {
            let eye = to_object(&minus(&truth.eye, &translation));
            let distance = dot(&eye, &eye);
            if distance <= wide(0.25) {
                return None;
            }
            // y . eye = 1/4 and y . y = 1/4.
            let share = wide(0.25) / distance.clone();
            let rest = wide(0.25) - wide(0.0625) / distance;
            (scaled(&share, &eye), rest, eye)
        } else {
            let direction = to_object(&truth.forward);
            (array::from_fn(|_| wide(0.0)), wide(0.25), direction)
        };
        let least = (0..3).min_by(|&i, &j| axis[i].abs().partial_cmp(&axis[j].abs()).unwrap())?;
        let first = cross(
            &axis,
            &array::from_fn(|i| wide(f64::from(u8::from(i == least)))),
        );
        let second = cross(&axis, &first);
        let radii = [first, second].map(|v| {
            let length = (squared_radius.clone() / dot(&v, &v)).sqrt();
            let object = scaled(&length, &v);
            let [x, y, z] = &axes;
            let world = along(&along(&scaled(&object[0], x), &object[1], y), &object[2], z);
            truth.dual.each_ref().map(|row| dot(row, &world))
        });
        let [x, y, z] = &axes;
        let center = along(
            &along(&along(&translation, &center[0], x), &center[1], y),
            &center[2],
            z,
        );
        Some(Self {
            truth,
            center: truth.coordinates(&center),
            radii,
        })
    }

    /// The point at a parameter in [-2, 2]. Each unit is a quarter of the circle; 0 is in the middle.
    fn at(&self, s: &Wide) -> V {
        let wide = |x| self.truth.wide(x);
        let minus = |x: Wide| wide(0.0) - x;
        let side = s.abs();
        let is_second = side > wide(1.0);
        let p = if is_second { &side - &wide(1.0) } else { side };
        // (1 - p^2, 2 p) / (1 + p^2) is one quarter for p from 0 to 1.
        let scale = wide(1.0) / (wide(1.0) + &p * &p);
        let (cos, sin) = ((wide(1.0) - &p * &p) * scale.clone(), wide(2.0) * p * scale);
        let (cos, sin) = if is_second {
            (minus(sin), cos)
        } else {
            (cos, sin)
        };
        let sin = if *s < wide(0.0) { minus(sin) } else { sin };
        along(
            &along(&self.center, &cos, &self.radii[0]),
            &sin,
            &self.radii[1],
        )
    }

    /// Squared distance in pixels.
    fn square_px(&self, s: &Wide) -> Wide {
        let [x, y] = self.truth.offset(&self.at(s));
        &x * &x + &y * &y
    }

    fn distance_px(mut self) -> Option<(f64, bool)> {
        let truth = self.truth;
        let [zero, one] = [0.0, 1.0].map(|x| truth.wide(x));
        // The circle is turned so that its deepest point is at 0.
        let [slope_0, slope_1] = self.radii.each_ref().map(|radius| radius[2].clone());
        let amplitude = (&slope_0 * &slope_0 + &slope_1 * &slope_1).sqrt();
        let missing = &truth.near - &self.center[2];
        if missing > amplitude {
            return None;
        }
        let is_whole = missing <= &zero - &amplitude;
        let mut end = truth.wide(2.0);
        if !is_whole {
            let (cos, sin) = (&slope_0 / &amplitude, &slope_1 / &amplitude);
            let [first, second] = &self.radii;
            let turned = along(&scaled(&cos, first), &sin, second);
            let across = along(&scaled(&cos, second), &(&zero - &sin), first);
            self.radii = [turned, across];
            let cos = missing / amplitude;
            let sin = (&one - &(&cos * &cos)).sqrt();
            end = if cos >= zero {
                sin / (one + cos)
            } else {
                &one + &((zero.clone() - cos) / (one.clone() + sin))
            };
        }
        let start = &zero - &end;
        let (at, square) = least(&start, &end, 256, truth, |s| self.square_px(s));
        let is_end = !is_whole && (at == start || at == end);
        Some((square.sqrt().to_f64(), is_end))
    }
}

/// Where a squared distance is least within an interval, and its value there. Samples the interval, then recursively
/// the neighbourhood of each local minimum, until neighbours hardly differ.
fn least(
    start: &Wide,
    end: &Wide,
    samples: u32,
    truth: &Truth,
    f: impl Fn(&Wide) -> Wide + Copy,
) -> (Wide, Wide) {
    let fine = |a: &Wide, b: &Wide| {
        let [a, b] = [a, b].map(|square| square.sqrt().to_f64());
        (a - b).abs() <= (1e-8_f64).max(1e-11 * a)
    };
    let span = end - start;
    let at = |i: u32| start + &(&span * &truth.wide(f64::from(i) / f64::from(samples)));
    let all: Vec<(Wide, Wide)> = (0..=samples)
        .map(|i| {
            let s = if i == samples { end.clone() } else { at(i) };
            let value = f(&s);
            (s, value)
        })
        .collect();
    let mut best: Option<(Wide, Wide)> = None;
    for i in 0..all.len() {
        let (before, after) = (i.saturating_sub(1), (i + 1).min(all.len() - 1));
        if all[before].1 < all[i].1 || all[after].1 < all[i].1 {
            continue;
        }
        let done = fine(&all[before].1, &all[after].1) && fine(&all[before].1, &all[i].1);
        let found = if done {
            all[i].clone()
        } else {
            least(&all[before].0, &all[after].0, 8, truth, f)
        };
        best = match best {
            Some(best) if best.1.partial_cmp(&found.1) != Some(Ordering::Greater) => Some(best),
            _ => Some(found),
        };
    }
    best.expect("some sample is least")
}
