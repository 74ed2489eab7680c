//! A ray against triangles and parallelograms.

use super::{
    line::Line,
    number::{Dyadic, Vector, cross, dot, minus, plus, times},
    root::Parameter,
};
use std::cmp::Ordering;

/// A point and two sides: a triangle with that corner, or a parallelogram about that point.
pub struct Flat {
    corner: Vector,
    sides: [Vector; 2],
    normal: Vector,
}

/// Where a line crosses a flat: parameter and share of each side, all three over `determinant`.
pub struct Crossing {
    t: Dyadic,
    shares: [Dyadic; 2],
    determinant: Dyadic,
    /// Whether the line runs against the cross product of the sides.
    pub against: bool,
}

impl Flat {
    pub fn new(corner: Vector, sides: [Vector; 2]) -> Self {
        let normal = cross(&sides[0], &sides[1]);
        Self {
            corner,
            sides,
            normal,
        }
    }

    /// Cramer's rule for `origin + t direction = corner + u side + v side`; `None` for a line parallel to the plane.
    pub fn crossing(&self, line: &Line) -> Option<Crossing> {
        let along = dot(&self.normal, &line.direction);
        if along.is_zero() {
            return None;
        }
        // Relative to the corner, and times `scale`. The shares must be divided by `scale`, t must not.
        let from_corner = minus(&line.origin, &times(&line.scale, &self.corner));
        let moment = cross(&line.direction, &from_corner);
        let [a, b] = &self.sides;
        let mut t = -&dot(&self.normal, &from_corner);
        let mut shares = [dot(b, &moment), -&dot(a, &moment)];
        let mut determinant = along.clone();
        if along.sign().is_lt() {
            t = -&t;
            shares = shares.map(|share| -&share);
            determinant = -&determinant;
        }
        Some(Crossing {
            t,
            shares,
            determinant,
            against: along.sign().is_lt(),
        })
    }
}

impl Crossing {
    /// The determinant times the shares' scale: a share as large as this is one whole side.
    fn whole(&self, line: &Line) -> Dyadic {
        &self.determinant * &line.scale
    }

    pub fn parameter(&self) -> Parameter {
        Parameter::fraction(&self.t, &self.determinant)
    }

    /// For a triangle: whether the crossing is on its border, and the weights of its corners. `None` outside.
    pub fn in_triangle(&self, line: &Line) -> Option<(bool, [f64; 3])> {
        let [u, v] = &self.shares;
        if u.sign().is_lt() || v.sign().is_lt() {
            return None;
        }
        let whole = self.whole(line);
        let w = &(&whole - u) - v;
        if w.sign().is_lt() {
            return None;
        }
        let weights = [&w, u, v];
        let on_border = weights.iter().any(|weight| weight.is_zero());
        Some((on_border, weights.map(|weight| weight.over(&whole))))
    }

    /// For a parallelogram, half a side each way about its point: whether the crossing is on its border. `None`
    /// outside.
    pub fn in_parallelogram(&self, line: &Line) -> Option<bool> {
        let whole = self.whole(line);
        let mut on_border = false;
        for share in &self.shares {
            let twice = share.clone().shifted(1);
            let size = if twice.sign().is_lt() { -&twice } else { twice };
            match size.cmp(&whole) {
                Ordering::Greater => return None,
                Ordering::Equal => on_border = true,
                Ordering::Less => {}
            }
        }
        Some(on_border)
    }
}

/// The faces of the unit cube, each about its middle, with sides whose cross product points outwards in object space.
pub fn faces(axes: &[Vector; 3], centre: &Vector) -> Vec<(usize, i8, Flat)> {
    let all = (0..3).flat_map(|axis| [-1_i8, 1].map(|side| (axis, side)));
    let face = |(axis, side): (usize, i8)| {
        let half = Dyadic::whole(side.into()).shifted(-1);
        let middle = plus(centre, &times(&half, &axes[axis]));
        let (mut a, mut b) = ((axis + 1) % 3, (axis + 2) % 3);
        if side < 0 {
            (a, b) = (b, a);
        }
        let flat = Flat::new(middle, [axes[a].clone(), axes[b].clone()]);
        (axis, side, flat)
    };
    all.map(face).collect()
}
