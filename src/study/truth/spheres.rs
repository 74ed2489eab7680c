//! Which rays hit a sphere, where, and how far from its outline they pass.

use super::{UNIT, decide, relative};
use crate::study::{
    exact::{Exact, Exact3},
    methods::spheres::RaySphere,
    step::{Bound, Verdict},
};
use std::cmp::Ordering;

/// What is so about a ray and a sphere.
#[derive(Clone, Debug)]
pub struct Truth {
    /// The least t >= 0 on the sphere.
    pub t: Option<f64>,
    /// How far the ray passes from the outline, in radians seen from its origin.
    pub outline_angle: f64,
    /// Half the chord, in world units; 0 for a line that misses.
    half_chord: f64,
}

/// By the sign of the discriminant.
#[must_use]
pub fn truth(case: &RaySphere<f64>) -> Truth {
    let d = Exact3::new(case.direction);
    let from_center = &Exact3::new(case.origin) - &Exact3::new(case.center);
    let radius = Exact::new(case.radius);
    let a = d.dot(&d);
    let b = -from_center.dot(&d);
    let c = &from_center.dot(&from_center) - &(&radius * &radius);
    let discriminant = &(&b * &b) - &(&a * &c);
    let hits = discriminant.sign() != Ordering::Less;
    let root = discriminant.clone().abs().sqrt();
    let t = hits.then(|| {
        let near = &(&b - &root) / &a;
        if near.sign() == Ordering::Less {
            &(&b + &root) / &a
        } else {
            near
        }
    });
    let t = t.filter(|t| t.sign() != Ordering::Less);
    // The line's distance from the centre less the radius is (distance^2 - r^2) / (distance + r), and the first of
    // these is the discriminant over -a; the outline lies a tangent's length away.
    let off = (&discriminant / &a).to_f64();
    let distance = from_center.cross(&d).length().to_f64() / d.length().to_f64();
    let tangent = c.to_f64().max(0.0).sqrt();
    Truth {
        t: t.map(|t| t.to_f64()),
        outline_angle: (off / (distance + case.radius) / tangent).abs(),
        half_chord: off.max(0.0).sqrt(),
    }
}

impl Truth {
    /// Holds an answer against it; `px` is the width of a pixel in radians.
    #[must_use]
    pub fn judge(&self, answer: Option<f64>, px: f64) -> Verdict {
        decide(self.t, answer, relative, || self.outline_angle / px)
    }
}

/// Bounds of Hearn & Baker's form in `f64` under a model matrix.
///
/// With u = 2^-53, D the distance of the origin from the centre and r the radius: object space's origin carries 5u in
/// each coordinate (difference, inverse scale, product), its direction 4u; the nearest point `o + (b/a) d` then errs
/// by at most 26u D (b and a 8u each with what they are made of, quotient, product and sum 4u, and the inputs' own).
/// A decision is wrong only where the line passes that close to the outline, which lies a tangent's length L away.
///
/// Half the chord is a root of `r^2 - nearest^2`, so an error e = 26u D moves it by at most
/// `min(2 r e / half, sqrt(2 r e))`. The larger root `q / a` errs by that plus 10u D; the smaller is `c / q`, where
/// `c = (D - r)(D + r)` errs by `8u D / (D - r) + 12u` relative.
#[must_use]
pub fn bound(case: &RaySphere<f64>, truth: &Truth, px: f64) -> Bound {
    let from_center = case.origin - case.center;
    let distance = from_center.length();
    let r = case.radius;
    let off = 26.0 * UNIT * distance + 2.0 * UNIT * r;
    let tangent = ((distance - r) * (distance + r)).max(0.0).sqrt();
    let half = truth.half_chord;
    let slack = 2.0 * r * off + off * off;
    let root = (slack / half).min(slack.sqrt());
    let middle = from_center.dot(case.direction).abs() / case.direction.length();
    let q = middle + half;
    let relative =
        8.0 * UNIT * distance / (distance - r).abs() + (10.0 * UNIT * distance + root) / q;
    Bound {
        error: relative + 20.0 * UNIT,
        wrong: off / tangent / px,
    }
}
