//! What each way to do a step in `f32` adds to the error in pixels, from what a scene and its camera are: formulas whose
//! factors are the largest that workloads showed. Derived bounds, of what this program does, are with `truth`.
//!
//! With u = 2^-24 a rounding in `f32` and `pix` the width of a pixel in radians, q = u / pix is a rounding in pixels.

use super::{methods::triangles::TriangleCase, truth::UNIT_F32, workloads::px_angle};
use crate::{
    camera::View,
    scene::{Scene, Shape},
};

/// What a way to do a step adds to the error.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// Key of the step.
    pub step: &'static str,
    /// The method, in `f32`.
    pub method: &'static str,
    /// The formula in words.
    pub formula: &'static str,
    /// Its value here, in pixels; infinite where the method fails.
    pub px: f64,
}

/// What the formulas know of a scene and its camera.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sizes {
    /// A rounding in pixels.
    pub q: f64,
    /// Whether rays are parallel.
    parallel: bool,
    /// From the world's origin to the eye, over what the eye is from its target.
    eye_over_length: f64,
    /// The same over the near plane.
    eye_over_near: f64,
    far_over_near: f64,
    /// Largest distance of an object's own origin from the world's, over what the eye is from it.
    translation: f64,
    /// Largest ratio of an object's longest and shortest scale.
    anisotropy: f64,
    /// Largest distance of a sphere over its radius; none without spheres.
    sphere: Option<f64>,
    /// Whether there are triangles.
    meshes: bool,
    /// Least sine of the angle between a sampled ray and the triangle that it hits; 1 without triangles.
    graze: f64,
}

fn term(step: &'static str, method: &'static str, formula: &'static str, px: f64) -> Term {
    Term {
        step,
        method,
        formula,
        px,
    }
}

impl Sizes {
    pub fn new(scene: &Scene, view: &View, triangles: &[TriangleCase]) -> Self {
        let lens = view.camera.lens();
        let eye = view.camera.eye();
        let length = view.camera.target().distance(eye);
        let mut sizes = Self {
            q: UNIT_F32 / px_angle(view, length),
            parallel: lens.is_orthographic(),
            eye_over_length: eye.length() / length,
            eye_over_near: eye.length() / lens.near.abs(),
            far_over_near: lens.far / lens.near.abs(),
            translation: 0.0,
            anisotropy: 1.0,
            sphere: None,
            meshes: false,
            graze: 1.0,
        };
        let visible = scene
            .objects()
            .iter()
            .enumerate()
            .filter(|(_, object)| object.visible);
        for (index, object) in visible {
            let bounds = scene.bounds_of(index);
            let nearest = eye
                .clamp(bounds.min, bounds.max)
                .distance(eye)
                .max(lens.near.abs());
            let model = object.placement.model();
            sizes.translation = sizes.translation.max(model.translation.length() / nearest);
            let longest = |m: glam::DMat3| {
                [m.x_axis, m.y_axis, m.z_axis]
                    .map(glam::DVec3::length)
                    .into_iter()
                    .fold(0.0, f64::max)
            };
            let stretch = longest(model.matrix3) * longest(object.placement.inverse_linear());
            sizes.anisotropy = sizes.anisotropy.max(stretch);
            match object.shape {
                Shape::Sphere => {
                    let far = bounds.center().distance(eye) / (0.5 * longest(model.matrix3));
                    sizes.sphere = Some(sizes.sphere.unwrap_or(0.0).max(far));
                }
                Shape::Mesh { .. } => sizes.meshes = true,
                Shape::Cube | Shape::Square => {}
            }
        }
        for case in triangles
            .iter()
            .filter(|case| super::step::Case::truth(*case).is_some())
        {
            let [a, b, c] = case.wide.corners;
            let normal = (b - a).cross(c - a);
            let sine = normal.dot(case.wide.direction).abs()
                / (normal.length() * case.wide.direction.length());
            sizes.graze = sizes.graze.min(sine);
        }
        sizes
    }

    /// Estimates for the ways from a pixel to a ray.
    fn ray_terms(&self) -> [Term; 3] {
        /// Where a clip-space w in f32 is 0 at the far plane.
        const SINGULAR: f64 = 8_388_608.0;
        let q = self.q;
        let term = |method, formula, px| term("ray", method, formula, px);
        let basis = term("eye basis", "5 q", 5.0 * q);
        let placed = "5 q + 2 q |eye| / length";
        let by_place = 5.0 * q + 2.0 * q * self.eye_over_length;
        let course = term("target + sx H + sy V - eye", placed, by_place);
        let unproject = "inverse(P V), far - near";
        if self.parallel {
            // Such a ray starts at a place in the world, whatever it is made by.
            let [basis, unproject] =
                ["eye basis", unproject].map(|method| term(method, placed, by_place));
            return [basis, course, unproject];
        }
        let fails = self.far_over_near > SINGULAR;
        let worst = 6.0 * q * self.eye_over_near.max(1.0);
        let formula = "6 q |eye| / near, fails where far / near > 2^23";
        [
            basis,
            course,
            term(
                unproject,
                formula,
                if fails { f64::INFINITY } else { worst },
            ),
        ]
    }

    /// Every estimate that this scene has a use for.
    pub fn terms(&self) -> Vec<Term> {
        let q = self.q;
        let mut terms = self.ray_terms().to_vec();
        terms.extend([
            term(
                "object-space",
                "inverse(A) (o - T)",
                "2 q anisotropy",
                2.0 * q * self.anisotropy,
            ),
            term(
                "object-space",
                "inverse(M)",
                "2 q anisotropy + 2 q |T| / t",
                2.0 * q * (self.anisotropy + self.translation),
            ),
        ]);
        if self.meshes {
            let steep = self.graze > 3e-3;
            terms.extend([
                term("triangle", "Woop watertight", "q", q),
                term(
                    "triangle",
                    "Moeller-Trumbore",
                    "8 q, without limit where rays graze below 3e-3",
                    if steep { 8.0 * q } else { f64::INFINITY },
                ),
                term(
                    "triangle",
                    "areas, sum == 1",
                    "the whole triangle",
                    f64::INFINITY,
                ),
            ]);
        }
        if let Some(distance) = self.sphere {
            terms.extend([
                term("sphere", "Hearn & Baker", "1.6 q", 1.6 * q),
                term(
                    "sphere",
                    "plain quadratic",
                    "1.6 q distance / radius",
                    1.6 * q * distance,
                ),
            ]);
        }
        terms
    }
}
