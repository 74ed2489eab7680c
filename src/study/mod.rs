//! Speed against accuracy: runs the known methods for each step of a pick over workloads that stress them, compares
//! their answers with exact truth, and times them.
//!
//! ```text
//! methods (the registry), their workloads -> run -> Report -> table, csv, chart
//!                  truth (exact numbers) --^
//! a scene + chains (whole picks in the numbers that programs hold) -> budget
//! a scene, often of the gallery + swap (a method) -> a pick with the method's mistakes
//! ```
//!
//! Each step is one file or folder under [`methods`]: its methods, its workloads (seeded families with one parameter
//! each) and its truth, from exact arithmetic ([`exact`], [`truth`]) that shares no code with any method. To add a
//! method, add an entry to its step's list: tests, tables and charts read that list.
//!
//! Workloads use only sums, products, quotients and square roots, which every machine rounds alike: one seed gives one
//! workload everywhere. The results are rounded to `f32`, so that methods of both precisions get the same numbers; only
//! a camera's axes, what is computed from them, and the families of *f64 rays* keep all digits of `f64`.
//!
//! # How methods are compared
//!
//! All methods of a step do one job, which the table states. They get the same cases, in the form in which a program
//! would hold them, and answer the same question; a test gives each of them the others' inputs, too, which must change
//! nothing. Those whose sources use fused multiply-adds have them, where the processor does. A time is the median over
//! rounds, each in a new order that no processor can learn, less the time of a call that does nothing. Rates stand with
//! their 95 % intervals. The same seed gives the same verdicts, except for the ids that the adapter draws; times
//! differ, so the processor is named beside them.
//!
//! A method is *useful* for an error of e if its own is at most e and none whose error is at most e is more than 10 %,
//! and more than half a nanosecond, faster. A tie, a ray exactly through an edge or an outline, is 0 off. By the run in
//! `assets/study-summary.csv` (two cores of an Intel Xeon, model 207, 2026-11-29), Sightline's methods are useful as
//! follows, by the steps' keys. At any error, none is faster: clip, pick. Against a triangle it is below 9e-14 px; from
//! there on Jimenez's test in `f64` does as well. It is against a sphere below 1e-13 px, where Hearn & Baker's takes
//! over, against a box below 7e-14 px, where slabs do, against a square below 9e-9 px, into object space below 2e-7 px,
//! and against a closed mesh below 9e-5 wrong answers, where Moeller & Trumbore's takes over. At no error: ray, normal.
//! There a method in `f64` errs as little and is faster: Sightline's adds bounds on errors, and keeps a normal of 0.
//! Depth buffers are not timed; Sightline's has a far plane, for one bit of depth.
//!
//! # What the charts teach
//!
//! **Precision is not slow.** A formula takes the same time in `f32` and in `f64`,
//! and its errors are nine powers of ten apart. A processor with both in hardware saves next to nothing by `f32` on
//! single rays.
//!
//! **Coordinates lose more than formulas do.** Most digits are lost before any shape is tested. A ray made from a point
//! in the world, or by the inverse of a matrix that holds the eye's position, loses more digits the further the eye is
//! from the origin. The same ray as a sum of directions loses none. So: first subtract what is large and alike (eye,
//! translation, centre), then multiply.
//!
//! **A test for equality is a test of rounding.** Three areas that should add up to a fourth do so for only some of the
//! hits; the rest are lost. Signs need no test for equality: the side of an edge on which a ray passes is one sign, the
//! same for both triangles at the edge.
//!
//! **A mesh leaks where two of its triangles disagree.** Each of them may miss a ray at their edge by a rounding. A
//! test that computes the same number for the edge from either triangle closes this leak; a corner needs more.
//!
//! **Rounding fails at edges, exact arithmetic does not.** Products of numbers that fit `f32` are nearly exact in `f64`,
//! which then decides only ties wrongly: rays exactly through an edge, which whole-number coordinates produce. A
//! viewer's rays have all digits of `f64`. Aimed at an edge, up to a rounding, they are decided wrongly in `f64` too, a
//! ten millionth of a millionth of a pixel off. A bound on the rounding says when a sign is certain. Otherwise exact
//! arithmetic decides. Away from edges this is so rare that it costs next to nothing.
//!
//! **Subtract squares late.** `b^2 - 4ac` loses a far sphere's outline; the distance of the centre from the line keeps
//! it. A surface seen edge-on has a poor distance by any formula: that problem is ill-conditioned, and only more digits
//! help.
//!
//! **Infinity can be compared, NaN cannot.** A box test without branches is right for rays along an axis until
//! one starts on a face: `0 * inf` is NaN. Then the order of the operands decides.
//!
//! **Near and far are planes.** A test on the distance makes spheres of them and is wrong in a wide picture's corners.
//!
//! **Standard depth wastes its numbers near the eye.** It spends most of its numbers on the first few units in front of
//! the eye. Reversed, the same 32 bits are as precise at any distance as an `f32` can be.
//!
//! **A whole pick is only as good as its worst step**, and a tree saves more time than all of the above together.

pub mod breaks;
mod budget;
mod budget_page;
pub mod chains;
pub mod charts;
mod csv;
mod effort;
pub mod exact;
pub mod fma;
mod folder;
pub mod methods;
pub mod random;
pub mod real;
mod run;
mod scene_rays;
mod statistics;
pub mod step;
mod summary;
pub mod swap;
mod table;
mod timing;
pub mod truth;
pub mod worked;

pub use budget::{Budget, Depths, Growth, NothingHit, Reach, Tried};
pub use csv::{COLUMNS, SUMMARY_COLUMNS, csv, summary_csv};
pub use effort::Effort;
pub use folder::{SaveError, save, save_chart};
pub use run::{Report, Row, SCENE, family, run};
pub use scene_rays::SceneRays;
pub use table::table;
pub use timing::{Time, processor};

/// What most files of the study import.
mod prelude {
    pub use super::{
        effort::Effort,
        exact::{self, Exact, Exact3},
        methods::{
            boxes::BoxCase, clipping::ClipCase, depth::DepthCase, normals::NormalCase,
            object_space::PlacedCase, rays::PixelCase, spheres::SphereCase, squares::SquareCase,
            triangles::TriangleCase,
        },
        random::Random,
        real::{M3, Real, V3, through_f32, through_f32_each},
        run::{Report, Row, SCENE},
        scene_rays::{PX, SceneRays, TAN_30},
        step::{
            AT_EDGES, About, Case, Family, HIT_RATE, Method, MethodInfo, Methods,
            Precision::{self, F32, F64},
            Verdict,
        },
        summary::{Summary, distinct},
        truth::{self, Line, UNIT, UNIT_F32},
    };
    pub(in crate::study) use super::{
        random::two_to,
        step::{about, both, family},
        truth::{cross_sizes, relative},
    };
    pub use crate::pick::SceneHit;
}
