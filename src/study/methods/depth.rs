//! Stores a view depth in the depth buffer and reads it back, as a graphics card does. The answer is the view depth
//! that is read back.

use crate::{
    camera::{Camera, DepthMapping, Lens, Projection},
    geometry::Ray,
    study::prelude::*,
};

/// A view depth between two planes.
#[derive(Clone, Copy, Debug)]
pub struct DepthCase {
    /// The view depth.
    pub depth: f32,
    /// The planes, and whether the picture is orthographic: then depth is not divided by w.
    lens: Lens,
}

impl DepthCase {
    /// A view depth, rounded to `f32`, between two planes in perspective.
    pub(in crate::study) fn new(depth: f64, [near, far]: [f64; 2]) -> Self {
        let lens = Lens {
            projection: Projection::Perspective { fov_y: 1.0 },
            near,
            far,
            depth: DepthMapping::Reversed,
        };
        let depth = f32::of(depth);
        Self { depth, lens }
    }

    /// A view depth, rounded to `f32`, as a lens stores it.
    pub(in crate::study) fn between(depth: f64, lens: Lens) -> Self {
        let depth = f32::of(depth);
        Self { depth, lens }
    }

    /// The depth of a hit at `t` on a ray that a camera cast.
    pub(in crate::study) fn of_hit(camera: &Camera, ray: &Ray, t: f64) -> Self {
        let depth = t * ray.direction.dot(camera.forward());
        Self::between(depth, *camera.lens())
    }
}

const STANDARD: &str = "courses, OpenGL and Direct3D textbooks: near is 0, far is 1";
const REVERSED: &str = "Reed, Depth Precision Visualized, 2015: near is 1, far is 0";
const LOGARITHMIC: &str = "Kemen, Logarithmic Depth Buffer, 2009; three.js, logdepthbuf_fragment: log2(1 + z) / log2(1 + far)";
const INFINITE: &str =
    "Upchurch & Desbrun, Tightening the Precision of Perspective Rendering, JGT 16(1), 2012";

/// A method that stores depth by a mapping and reads it back.
macro_rules! stored {
    ($name:expr, $source:expr, $mapping:ident) => {
        Method::new($name, F32, $source, |case| {
            Mapping::$mapping.there_and_back(case)
        })
    };
}

impl Case for DepthCase {
    type Answer = f64;
    type Truth = f64;
    const ABOUT: About = about!(
        "Depth buffer" "depth", off by "of depth", wrong by "";
        "a view depth: what can be read of it from the depth buffer (simulated, so not timed)"
    );

    const METHODS: Methods<Self> = &[&[
        stored!("standard, 32-bit float", STANDARD, STANDARD),
        stored!("standard, 24-bit integer", STANDARD, STANDARD_24),
        stored!("reversed, 24-bit integer", REVERSED, REVERSED_24),
        stored!("reversed, infinite far, float", INFINITE, INFINITE),
        stored!("logarithmic, 32-bit float", LOGARITHMIC, LOGARITHMIC),
        stored!("logarithmic, 24-bit integer", LOGARITHMIC, LOGARITHMIC_24),
        Method::ours(F32, REVERSED, |c| Mapping::REVERSED.there_and_back(c))
            .named("reversed, 32-bit float: Sightline's"),
    ]];
    const TIMED: usize = 0;
    const FAMILIES: &'static [Family<Self>] = &[
        Family::ordinary(|random, _| make(random, 0.125, 1e2)),
        family!("far plane", "far / near" [1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8] =>
            |random, ratio| make(random, 0.125, 0.125 * ratio)),
    ];

    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        let camera = &scene.view.camera;
        let case = |(ray, hit): &(Ray, SceneHit)| Self::of_hit(camera, ray, hit.hit.t);
        scene.hits.iter().map(case).collect()
    }

    fn truth(&self) -> f64 {
        f64::from(self.depth)
    }

    fn judge(&self, truth: &f64, answer: &f64) -> Verdict {
        Verdict::Right(relative(*truth, *answer))
    }

    /// Bound of reversed depth in `f32`.
    ///
    /// With u = 2^-24 and depth z: `a z + b` is `n (f - z) / (f - n)`; matrix entries, product, sum, quotient and the
    /// buffer err together by at most 2u |a| + 4u (|a| + b / z) with |a| = n / (f - n) and b = f |a|. Read back,
    /// `z = b / (stored - a)`: the relative error of z is this error divided by b / z.
    fn bound(&self, _: &f64) -> f64 {
        let (Lens { near, far, .. }, depth) = (self.lens, f64::from(self.depth));
        if self.lens.is_orthographic() {
            // `a z + b` with |a| = 1 / (f - n) and b = f |a|, read back as `(stored - b) / a`: entries, product, sum
            // and buffer err together by at most 4u (|a| z + b). Divided by |a|, this is an error of depth.
            return 4.0 * UNIT_F32 * (depth.abs() + far.abs()) / depth.abs();
        }
        let slope = near / (far - near);
        let at = far * slope / depth;
        let stored = UNIT_F32 * (6.0 * slope + 4.0 * at);
        let share = stored / at;
        share / (1.0 - share)
    }
}

/// A format of the depth buffer.
#[derive(Clone, Copy, Debug)]
pub struct Mapping {
    /// Which end is 1.
    pub depth: DepthMapping,
    /// Stored as 24-bit integers, else as 32-bit floating point.
    pub integer: bool,
    /// Without a far plane; ignored in an orthographic picture.
    pub infinite: bool,
    /// Stores the depth's logarithm, as a fragment shader does; ignored in an orthographic picture.
    pub logarithmic: bool,
}

impl Mapping {
    /// Near is 0, in floating point.
    pub const STANDARD: Self = Self::new(DepthMapping::Standard, false, false);
    /// Near is 0, in integers.
    pub const STANDARD_24: Self = Self::STANDARD.in_integers();
    /// Near is 1, in floating point.
    pub const REVERSED: Self = Self::new(DepthMapping::Reversed, false, false);
    /// Near is 1, in integers.
    pub const REVERSED_24: Self = Self::REVERSED.in_integers();
    /// Near is 1 and infinity is 0, in floating point.
    pub const INFINITE: Self = Self::new(DepthMapping::Reversed, true, false);
    /// The eye is 0, far is 1, in floating point.
    pub const LOGARITHMIC: Self = Self::new(DepthMapping::Standard, false, true);
    /// The eye is 0, far is 1, in integers.
    pub const LOGARITHMIC_24: Self = Self::LOGARITHMIC.in_integers();
    /// The largest 24-bit integer.
    const LARGEST: f32 = 16_777_215.0;

    const fn new(depth: DepthMapping, infinite: bool, logarithmic: bool) -> Self {
        Self {
            depth,
            integer: false,
            infinite,
            logarithmic,
        }
    }

    const fn in_integers(mut self) -> Self {
        self.integer = true;
        self
    }

    /// The depth entries `(a, b)` of the projection matrix, in `f64`: clip depth is `a z + b`.
    fn row(self, case: &DepthCase) -> (f64, f64) {
        let depth = self.depth;
        if self.infinite && !case.lens.is_orthographic() {
            return (0.0, case.lens.near);
        }
        Lens { depth, ..case.lens }.depth_row()
    }

    /// The number in the buffer, after the vertex shader's `f32` arithmetic, the division by w and the buffer's own
    /// rounding.
    pub(in crate::study) fn stored(self, case: &DepthCase) -> f32 {
        let parallel = case.lens.is_orthographic();
        let ndc = if self.logarithmic && !parallel {
            libm::log2f(1.0 + case.depth) * f32::of(libm::log2(1.0 + case.lens.far).recip())
        } else {
            let (a, b) = self.row(case);
            (f32::of(a) * case.depth + f32::of(b)) / if parallel { 1.0 } else { case.depth }
        };
        if self.integer {
            (ndc * Self::LARGEST).round() / Self::LARGEST
        } else {
            ndc
        }
    }

    /// The next number that the buffer can hold, away from the eye.
    pub(in crate::study) fn next(self, stored: f32) -> f32 {
        match (self.integer, self.depth) {
            (true, DepthMapping::Standard) => stored + 1.0 / Self::LARGEST,
            (true, DepthMapping::Reversed) => stored - 1.0 / Self::LARGEST,
            (false, DepthMapping::Standard) => stored.next_up(),
            (false, DepthMapping::Reversed) => stored.next_down(),
        }
    }

    /// The view depth that a stored number means between a case's planes.
    pub(in crate::study) fn read(self, stored: f32, case: &DepthCase) -> f64 {
        let (a, b) = self.row(case);
        let stored = f64::from(stored);
        match (case.lens.is_orthographic(), self.logarithmic) {
            (true, _) => (stored - b) / a,
            (false, true) => libm::pow(1.0 + case.lens.far, stored) - 1.0,
            (false, false) => b / (stored - a),
        }
    }

    fn there_and_back(self, case: &DepthCase) -> f64 {
        self.read(self.stored(case), case)
    }
}

/// Any depth, each octave equally likely, except the last percent before the far plane.
fn make(random: &mut Random, near: f64, far: f64) -> DepthCase {
    loop {
        let mut depth = near * random.within(1.0, 2.0);
        for _ in 0..random.below(30) {
            depth *= 2.0;
        }
        if depth < 0.99 * far {
            return DepthCase::new(depth, [near, far]);
        }
    }
}
