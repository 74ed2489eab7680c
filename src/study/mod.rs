//! Speed against accuracy: the known methods for each step of a pick, over workloads that stress them, held against
//! exact truth and timed.
//!
//! ```text
//! methods (the registry), their workloads -> run -> Report -> table, csv, chart
//!                  truth (exact numbers) --^        its rays + Report -> estimates -> budget
//! a scene, often of the gallery + swap (a method) -> a pick with the method's mistakes
//! ```
//!
//! A step of a pick is one file or folder under [`methods`]: its methods, its workloads (seeded families with one parameter
//! each) and what is so, by numbers that know no rounding ([`exact`], [`truth`]), which share no code with any method. To
//! add a method is to add an entry to its step's list: tests, tables and charts then have it.
//!
//! All numbers of a workload come from additions, products, quotients and square roots, which every machine rounds alike, and
//! are then rounded to `f32`, but for a camera's axes and what they make: the same seed is the same workload everywhere, and
//! methods of both precisions get it.
//!
//! # What the charts teach
//!
//! **Precision is not what is slow.** In one chart of speed against error the same formula in `f32` and in `f64` stands
//! at the same place on the time axis, nine powers of ten apart on the other. On a processor that does both in
//! hardware, one ray at a time, `f32` saves next to nothing; it pays where many are done at once.
//!
//! **Coordinates lose more than formulas do.** Most of what goes wrong happens before any shape is met. A ray that is
//! made by way of a point in the world, or through the inverse of a matrix that holds the eye's position, loses as many
//! digits as the eye is far from the origin. The same ray as a sum of directions loses none. So: subtract first
//! what is large and alike (eye, translation, centre), and only then multiply.
//!
//! **A test for equality is a test of rounding.** Three areas that should add up to a fourth do so in a part of all
//! hits; the others fall through. A tolerance mends the middle of triangles and moves their edges. Signs need no
//! tolerance: on which side of an edge a ray passes is one sign, the same for both triangles that share the edge.
//!
//! **A mesh leaks where two of its triangles disagree.** A ray at an edge may miss both by a rounding each. Tests that take
//! one number for the edge, whichever triangle asks, close it; at a corner it takes more.
//!
//! **Rounding decides at edges, exact arithmetic does not.** In `f64` the wrong decisions that are left are ties: rays
//! exactly through an edge, as whole-number coordinates make them. A bound on the rounding says when a sign is
//! certain; where it is not, exact arithmetic settles it. That is so rare that it costs next to nothing.
//!
//! **Subtract squares late.** `b^2 - 4ac` loses a far sphere's outline; the distance of the centre from the line keeps
//! it. For the same reason a surface that is seen edge-on has a poor distance in any form: there the question itself
//! is sharp, and only digits help.
//!
//! **Infinity is a number, not-a-number is not.** A box test without branches is right for rays along an axis until
//! one starts on a face: `0 * inf`. The order of the comparison then decides what happens.
//!
//! **Near and far are planes.** A test on the distance makes spheres of them, and the corners of a wide picture pay.
//!
//! **Half of a depth buffer is empty.** Standard depth spends its numbers on the first few units before the eye.
//! Reversed, the same 32 bits are as good at any distance as an `f32` can be.
//!
//! **A whole pick is as good as its worst step**, and a tree is worth more time than all of the above together.

mod budget;
pub mod chart;
mod csv;
mod estimates;
pub mod exact;
pub mod gallery;
pub mod methods;
pub mod random;
pub mod real;
mod run;
mod save;
mod scene_rays;
pub mod step;
mod summary;
pub mod swap;
mod table;
mod timing;
pub mod truth;

pub use budget::{budget, measured};
pub use csv::{COLUMNS, SUMMARY_COLUMNS, csv, summary_csv};
pub use estimates::{Estimate, estimates};
pub use run::{Effort, Report, Row, SCENE, run};
pub use save::{SaveError, save, save_chart};
pub use scene_rays::SceneRays;
pub use table::table;
pub use timing::{Time, processor};

/// What the files of the study are made of.
mod prelude {
    pub use super::{
        exact::{self, Exact, Exact3},
        random::Random,
        real::{M3, Real, Ring, V3, narrow, narrow3},
        run::{Effort, Report, Row, SCENE},
        scene_rays::{PX, SceneRays, TAN_30},
        step::{
            About, Case, Family, Method, MethodInfo, Methods,
            Precision::{self, F32, F64},
            Verdict,
        },
        summary::Summary,
        truth::{self, Line, UNIT, UNIT_F32},
    };
    pub(in crate::study) use super::{
        step::{about, both, family},
        truth::{cross_sizes, relative},
    };
    pub use crate::pick::SceneHit;
}
