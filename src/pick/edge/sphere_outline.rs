//! Distance in pixels to a sphere's outline: the curve where rays of the picture touch the sphere.

use super::{
    conic::Arcs,
    picture_space::{PictureSpace, Shown},
    section::{Kept, Part},
};
use crate::geometry::{
    Placement,
    dyadic::{Dyadic, DyadicVector, to_object},
};
use num_bigint::BigInt;
use std::{array, cmp::Ordering};

/// The circle in which rays touch the sphere, as the picture shows it; exact, with two square roots not yet taken.
///
/// In object space the sphere is |y| = 1/2. The eye is at o / m, m = det L, and a ray touches the sphere where
/// `y . o = m / 4`. Let g = o . o and k = 4 g - m^2, which is above 0 where the eye is outside. Then the circle has the
/// centre `o m / (4 g)` and the squared radius `k / (16 g)`. (In orthographic projection o is the rays' direction and m
/// = 0.) Let n be the gradient of depth. In the circle's plane, b = o x n keeps the depth and a = b x o raises it; a .
/// a = g b . b. So with q = b . b the circle consists of
///
/// (m o + sqrt(k / q) (cos a + sin sqrt(g) b)) / (4 g).
///
/// The picture coordinates (u, v, w) are linear and 0 at the eye, so those of the direction o are -m times those of the
/// sphere's centre. The circle is shown, up to a factor, as
///
/// sqrt(k q) centre + cos a + sin sqrt(g) b.
pub(super) struct Circle {
    /// Picture coordinates of the sphere's centre.
    center: Vec3,
    /// Those of the direction a.
    a: Vec3,
    /// Those of the direction b; its `w` is 0.
    b: Vec3,
    g: Dyadic,
    kq: Dyadic,
    /// A point lies at or behind the near plane where sqrt(k q) cos is at least this.
    threshold: Dyadic,
    /// All points have the same depth: 0 takes the place of sqrt(k q) cos.
    is_level: bool,
    kept: Option<Kept>,
}

/// Picture coordinates (u, v, w).
type Vec3 = [Dyadic; 3];

/// Distance in pixels to the part of a sphere's outline at or behind the near plane that the section keeps; `None` when
/// there is none.
pub(super) fn distance_px(space: &PictureSpace<BigInt>, placement: &Placement) -> Option<f64> {
    let circle = Circle::new(space, placement)?;
    if !circle.is_visible() {
        return None;
    }
    // 112 bits are enough for all but extreme views. Coordinates need at most three more, and a sign.
    let narrow = |n: BigInt| i128::try_from(n).unwrap_or_default();
    let mut distance = circle.arcs(112, narrow)?.distance_px();
    for bits in [448, 1792, 7168] {
        if distance.is_err() {
            distance = circle.arcs(bits, |n| n)?.distance_px();
        }
    }
    Some(distance.unwrap_or_else(|nearest_known| nearest_known))
}

impl Circle {
    /// `None` unless the eye is outside.
    fn new(space: &PictureSpace<BigInt>, placement: &Placement) -> Option<Self> {
        let grid = &space.grid;
        let (eye, forward, determinant) = to_object(placement, grid.eye, grid.forward);
        let (o, m) = if grid.is_orthographic {
            (forward, Dyadic::new(0.0))
        } else {
            (eye, determinant)
        };
        let g = o.dot(&o);
        let four_g = Dyadic::new(4.0).times(&g);
        let m_squared = m.squared();
        let k = four_g.minus(&m_squared);
        if !k.sign().is_gt() {
            return None;
        }
        let model = placement.model();
        let linear = model.matrix3;
        let axes = [linear.x_axis, linear.y_axis, linear.z_axis]
            .map(|axis| space.direction(&DyadicVector::new(axis)));
        let row = |of: fn(&Shown<BigInt>) -> &Dyadic| {
            DyadicVector::of(&axes.each_ref().map(|axis| of(axis).clone()))
        };
        let [u, v, w] = [row(|p| &p.u), row(|p| &p.v), row(|p| &p.w)];
        let shown = |step: &DyadicVector| [&u, &v, &w].map(|row| row.dot(step));
        let steepest = o.cross(&row(|p| &p.depth));
        let is_level = steepest.is_zero();
        let b = if is_level { across(&o) } else { steepest };
        let center = space.point(&DyadicVector::new(model.translation));
        let (a, q) = (b.cross(&o), b.dot(&b));
        let kept = Kept::new(space, placement, [&o, &a, &b], [&m, &four_g, &q]);
        Some(Self {
            a: shown(&a),
            kq: k.times(&q),
            b: shown(&b),
            threshold: (m_squared.times(&center.depth))
                .minus(&four_g.times(&space.behind_near(&center))),
            center: [center.u, center.v, center.w],
            g,
            is_level,
            kept,
        })
    }

    /// Whether some of it lies at or behind the near plane.
    fn is_visible(&self) -> bool {
        match self.threshold.sign() {
            Ordering::Greater => !self.is_level && !self.beyond_threshold().is_negative(),
            _ => true,
        }
    }

    /// k q times the squared sine at the threshold; negative where no point lies on the near plane.
    fn beyond_threshold(&self) -> Dyadic {
        self.kq.minus(&self.threshold.squared())
    }

    /// The parts at or behind the near plane that the section keeps; tangents of half angles have `bits` bits.
    fn visible_parts(&self, [root, root_g]: [&Dyadic; 2], bits: i64) -> Vec<Part> {
        let [zero, one] = [0.0, 1.0].map(Dyadic::new);
        let sine = self.beyond_threshold();
        // tan(angle / 2) = sin / (1 + cos), with the angle counted from the end on the same side.
        let tangent = || {
            let sine = sine.sqrt(bits);
            sine.quotient(&root.plus(&self.threshold.abs()), bits)
        };
        let ends = if self.is_level || (self.threshold.is_negative() && sine.is_negative()) {
            vec![(false, zero.clone(), one.clone()), (true, zero, one)]
        } else if self.threshold.is_negative() {
            vec![(false, zero, one.clone()), (true, tangent(), one)]
        } else {
            vec![(false, zero, tangent())]
        };
        let parts = ends.into_iter().flat_map(|(turned, from, to)| {
            [false, true].map(|left| Part {
                turned,
                left,
                from: from.clone(),
                to: to.clone(),
            })
        });
        match &self.kept {
            None => parts.collect(),
            Some(kept) => {
                let squares = [&self.kq, &self.g];
                let of_part = |part| kept.of_part(&part, squares, [root, root_g], bits);
                parts.flat_map(of_part).collect()
            }
        }
    }

    /// The visible parts in fixed point of `bits` bits; `None` where there are none.
    fn arcs<T>(&self, bits: i64, fixed: impl Fn(BigInt) -> T) -> Option<Arcs<T>> {
        // Guard bits: what is cut off before the last step adds up to less than one unit.
        let longer = bits + 8;
        let root = self.kq.sqrt(longer);
        let root_g = self.g.sqrt(longer);
        let center = self.center.each_ref().map(|c| root.times(c));
        let right = self.b.each_ref().map(|c| root_g.times(c));
        let magnitude = |i: usize| {
            let all = [&center[i], &self.a[i], &right[i]].map(Dyadic::magnitude);
            all.into_iter().max().flatten()
        };
        let size_uv = magnitude(0).max(magnitude(1)).unwrap_or(0);
        let size_w = magnitude(2).unwrap_or(0);
        let sizes = [size_uv, size_uv, size_w];
        let short = |v: &Vec3| -> Vec3 { array::from_fn(|i| v[i].cut_off(sizes[i] - longer)) };
        let [center, a, right] = [&center, &self.a, &right].map(short);
        let deepest: Vec3 = array::from_fn(|i| center[i].plus(&a[i]));
        let opposite: Vec3 = array::from_fn(|i| center[i].minus(&a[i]));
        let left = right.each_ref().map(Dyadic::negated);
        let mut controls = Vec::new();
        for part in self.visible_parts([&root, &root_g], longer) {
            let (from, to) = (part.from, part.to);
            let (first, last) = if part.turned {
                (&opposite, &deepest)
            } else {
                (&deepest, &opposite)
            };
            let side = if part.left { &left } else { &right };
            // The polar form of first + 2 p side + p^2 last.
            let control = |p: &Dyadic, q: &Dyadic| -> [T; 3] {
                let (sum, product) = (p.plus(q), p.times(q));
                array::from_fn(|i| {
                    let c = first[i].plus(&side[i].times(&sum));
                    fixed(c.plus(&last[i].times(&product)).in_units(sizes[i] - bits))
                })
            };
            let ends = [(&from, &from), (&from, &to), (&to, &to)];
            controls.push(ends.map(|(p, q)| control(p, q)));
        }
        (!controls.is_empty()).then(|| Arcs {
            controls,
            bits,
            // One unit for what fixed point cuts off, one for all that was cut off before.
            error: 2.0,
            exponent: size_uv - size_w,
        })
    }
}

/// A vector perpendicular to one that is not 0.
fn across(v: &DyadicVector) -> DyadicVector {
    let [x, y, z] = &v.integers;
    let zero = BigInt::ZERO;
    let integers = if *x == zero && *y == zero {
        [z.clone(), zero.clone(), zero]
    } else {
        [-y, x.clone(), zero]
    };
    DyadicVector {
        integers,
        exponent: v.exponent,
    }
}
