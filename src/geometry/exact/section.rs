//! Decides in integers whether a section keeps what a ray hits.

use super::{
    super::{Section, WorldRay, line::Line},
    exact_line::ExactLine,
    integer::{Bits, Formula, Integer, Ring, solve},
    meeting::{Surface, parameter},
    number::{Number, Vector},
    root::Root,
    triangle::{Corners, Seen},
};
use num_bigint::BigInt;

/// Whether a section keeps the point where a ray meets a surface. The ray must meet it.
pub(crate) fn keeps(ray: &WorldRay, section: &Section, surface: &Surface) -> bool {
    let line = &ray.line;
    if !line.is_finite() {
        return false;
    }
    if let Surface::Triangle(triangle) = surface {
        return triangle.is_finite() && solve(&OfTriangle(line, triangle, section));
    }
    let [start, ahead] = along(&ExactLine::<BigInt>::new(line), section);
    let Some(at) = parameter(ray, surface) else {
        return false;
    };
    let against = ahead.sign().reverse();
    // Without a quotient, the ray runs along the plane.
    let plane = Root::quotient(start.negated(), ahead);
    plane.map_or(start.sign().is_ge(), |plane| at.compare(&plane) != against)
}

/// `n . p + c` at a ray's start, and its growth per unit of t; both times the ray's weight, which is above 0.
fn along<I: Ring>(line: &ExactLine<I>, section: &Section) -> [Number<I>; 2] {
    let normal = Vector::new(section.normal());
    let offset = Number::new(section.offset()).times(&line.weight);
    [
        normal.dot(&line.origin).plus(&offset),
        normal.dot(&line.direction),
    ]
}

struct OfTriangle<'a>(&'a Line<'a>, &'a Corners<'a>, &'a Section);

impl Formula for OfTriangle<'_> {
    /// `n . p + c` where the ray meets the triangle's plane, times the denominator of t; and that denominator.
    type Numbers<I: Ring> = [Number<I>; 2];
    type Answer = bool;

    fn numbers<I: Ring>(&self) -> Self::Numbers<I> {
        let Seen { line, plane, .. } = Seen::new(self.0, self.1);
        let [start, ahead] = along(&line, self.2);
        let way = ahead.times(&plane.numerator);
        [
            start.times(&plane.denominator).plus(&way),
            plane.denominator,
        ]
    }

    fn most_bits(numbers: &Self::Numbers<Bits>) -> u32 {
        Bits::most(numbers.each_ref().map(|number| number.integer))
    }

    fn answer<I: Integer>(&self, [side, denominator]: Self::Numbers<I>) -> bool {
        side.sign().is_eq() || side.sign() == denominator.sign()
    }
}
