//! Parts of a sphere's outline, and which of them a section keeps.

use super::picture_space::PictureSpace;
use crate::geometry::{
    Placement,
    dyadic::{Dyadic, DyadicVector},
};
use num_bigint::BigInt;

/// A part of the circle's left or right half, given by a range of p: (1 - p^2, 2 p, 1 + p^2) is a multiple of (cosine,
/// sine, 1) of the angle from the deepest point or, where `turned`, from its opposite.
#[derive(Clone)]
pub(super) struct Part {
    pub turned: bool,
    pub left: bool,
    pub from: Dyadic,
    pub to: Dyadic,
}

/// The outline is kept where `middle + sqrt(k q) (cos a + sin sqrt(g) b)` is not below 0. This is n . p + c times 4 g
/// q, in the names of [`Circle`](super::sphere_outline::Circle).
pub(super) struct Kept {
    middle: Dyadic,
    a: Dyadic,
    b: Dyadic,
}

impl Kept {
    /// From the outline circle's o, a and b, and m, 4 g and q; `None` without a section.
    pub fn new(
        space: &PictureSpace<BigInt>,
        placement: &Placement,
        [o, a, b]: [&DyadicVector; 3],
        [m, four_g, q]: [&Dyadic; 3],
    ) -> Option<Self> {
        let model = placement.model();
        let linear = model.matrix3;
        let of_center = space.kept(&DyadicVector::new(model.translation))?;
        let [x, y, z] = [linear.x_axis, linear.y_axis, linear.z_axis]
            .map(|axis| space.kept_along(&DyadicVector::new(axis)));
        let normal = DyadicVector::of(&[x?, y?, z?]);
        let middle = (four_g.times(&of_center)).plus(&m.times(&normal.dot(o)));
        Some(Self {
            middle: middle.times(q),
            a: normal.dot(a),
            b: normal.dot(b),
        })
    }

    /// The kept pieces of a part. `kq` and `g` come with their roots; new ends have `bits` bits.
    ///
    /// With p the tangent of half the angle, the condition is `alpha p^2 + 2 h p + gamma >= 0`.
    pub fn of_part(
        &self,
        part: &Part,
        [kq, g]: [&Dyadic; 2],
        [root, root_g]: [&Dyadic; 2],
        bits: i64,
    ) -> Vec<Part> {
        let signed = |minus: bool, n: Dyadic| if minus { n.negated() } else { n };
        let along = signed(part.turned, root.times(&self.a));
        let h = signed(part.left, root.times(root_g).times(&self.b));
        let (alpha, gamma) = (self.middle.minus(&along), self.middle.plus(&along));
        let squares = g.times(&self.b.squared()).plus(&self.a.squared());
        let discriminant = kq.times(&squares).minus(&self.middle.squared());
        let mut ends = vec![part.from.clone(), part.to.clone()];
        if !discriminant.is_negative() {
            // One root comes from the sum that does not cancel, the other from the product of both.
            let sum = h.plus(&signed(h.is_negative(), discriminant.sqrt(bits)));
            for (n, by) in [(&sum, &alpha), (&gamma, &sum)] {
                if by.is_zero() {
                    continue;
                }
                let root = n.negated().quotient(by, bits);
                let sides = [root.minus(&part.from), part.to.minus(&root)];
                if sides.iter().all(|side| side.sign().is_gt()) {
                    ends.push(root);
                }
            }
        }
        ends.sort_by(|a, b| a.minus(b).sign());
        let half = Dyadic::new(0.5);
        let is_kept = |ends: &&[Dyadic]| {
            let p = ends[0].plus(&ends[1]).times(&half);
            let linear = alpha.times(&p).plus(&h).plus(&h);
            !linear.times(&p).plus(&gamma).is_negative()
        };
        let pieces = ends.windows(2).filter(is_kept);
        let piece = |ends: &[Dyadic]| Part {
            from: ends[0].clone(),
            to: ends[1].clone(),
            ..part.clone()
        };
        pieces.map(piece).collect()
    }
}
