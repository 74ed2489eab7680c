//! View depth into the depth buffer and back: what a graphics card stores and what can be read from it. The answer is
//! the view depth that comes back.

use crate::{
    camera::{DepthMapping, Lens, Projection},
    study::{
        step::{About, Bound, Case, Family, Method, Precision::F32, Verdict},
        truth::{depth as truth, relative},
        workloads::{self, scene::SceneRays},
    },
};

/// A view depth between two planes.
#[derive(Clone, Copy, Debug)]
pub struct DepthCase {
    /// The view depth.
    pub depth: f32,
    /// The near plane's.
    pub near: f64,
    /// The far plane's.
    pub far: f64,
    /// Whether the picture is orthographic: depth is stored as it is, not over w.
    pub parallel: bool,
}

const STANDARD: &str = "courses, OpenGL and Direct3D textbooks: near is 0, far is 1";
const REVERSED: &str = "Reed, Depth Precision Visualized, 2015: near is 1, far is 0";
const INFINITE: &str =
    "Upchurch & Desbrun, Tightening the Precision of Perspective Rendering, JGT 16(1), 2012";

impl Case for DepthCase {
    type Answer = f64;
    type Truth = f64;
    const ABOUT: About = About {
        name: "Depth buffer",
        key: "depth",
        error_unit: "of depth",
        wrong_unit: "",
    };

    fn methods() -> &'static [Method<Self>] {
        const {
            &[
                Method::new("standard, 32-bit float", F32, STANDARD, |c| {
                    Mapping::STANDARD.there_and_back(c)
                }),
                Method::new("standard, 24-bit integer", F32, STANDARD, |c| {
                    Mapping {
                        integer: true,
                        ..Mapping::STANDARD
                    }
                    .there_and_back(c)
                }),
                Method::new("reversed, 24-bit integer", F32, REVERSED, |c| {
                    Mapping {
                        integer: true,
                        ..Mapping::REVERSED
                    }
                    .there_and_back(c)
                }),
                Method::new("reversed, infinite far, float", F32, INFINITE, |c| {
                    Mapping {
                        infinite: true,
                        ..Mapping::REVERSED
                    }
                    .there_and_back(c)
                }),
                Method::ours("reversed, 32-bit float: Sightline's", F32, REVERSED, |c| {
                    Mapping::REVERSED.there_and_back(c)
                }),
            ]
        }
    }

    fn families() -> &'static [Family<Self>] {
        workloads::depth::FAMILIES
    }

    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        scene.depths()
    }

    fn truth(&self) -> f64 {
        f64::from(self.depth)
    }

    fn judge(&self, truth: &f64, answer: &f64) -> Verdict {
        Verdict::Right(relative(*truth, *answer))
    }

    fn bound(&self, _: &f64) -> Bound {
        truth::bound(self)
    }
}

/// A way to keep depth.
#[derive(Clone, Copy, Debug)]
pub struct Mapping {
    /// Which end is 1.
    pub depth: DepthMapping,
    /// 24-bit integers in place of 32-bit floating point.
    pub integer: bool,
    /// No far plane; in an orthographic picture there is always one.
    pub infinite: bool,
    /// Orthographic: there is no division by w.
    pub parallel: bool,
}

impl Mapping {
    /// Near is 0, in floating point.
    pub const STANDARD: Self = Self {
        depth: DepthMapping::Standard,
        integer: false,
        infinite: false,
        parallel: false,
    };
    /// Near is 1, in floating point.
    pub const REVERSED: Self = Self {
        depth: DepthMapping::Reversed,
        integer: false,
        infinite: false,
        parallel: false,
    };

    /// The projection's third row, in `f64`.
    fn row(self, near: f64, far: f64) -> (f64, f64) {
        let lens = Lens {
            projection: if self.parallel {
                Projection::Orthographic { height: 1.0 }
            } else {
                Projection::Perspective { fov_y: 1.0 }
            },
            near,
            far,
            depth: self.depth,
        };
        if self.infinite && !self.parallel {
            (0.0, near)
        } else {
            lens.depth_row()
        }
    }

    /// What the buffer holds: the vertex stage's `f32` arithmetic, the division by w, and the buffer's own rounding.
    #[must_use]
    pub fn stored(self, depth: f32, near: f64, far: f64) -> f32 {
        /// The largest 24-bit integer.
        const LARGEST: f32 = 16_777_215.0;
        let (a, b) = self.row(near, far);
        #[expect(
            clippy::cast_possible_truncation,
            reason = "matrices are f32 on the card"
        )]
        let (a, b) = (a as f32, b as f32);
        let ndc = (a * depth + b) / if self.parallel { 1.0 } else { depth };
        if self.integer {
            (ndc * LARGEST).round() / LARGEST
        } else {
            ndc
        }
    }

    /// The view depth that a stored number means.
    #[must_use]
    pub fn read(self, stored: f32, near: f64, far: f64) -> f64 {
        let (a, b) = self.row(near, far);
        let stored = f64::from(stored);
        if self.parallel {
            (stored - b) / a
        } else {
            b / (stored - a)
        }
    }

    fn there_and_back(self, case: &DepthCase) -> f64 {
        let mapping = Self {
            parallel: case.parallel,
            ..self
        };
        let stored = mapping.stored(case.depth, case.near, case.far);
        mapping.read(stored, case.near, case.far)
    }
}
