//! Speed against accuracy: the known methods for each step of a pick, over workloads that stress them, held against
//! exact truth and timed.

mod budget;
pub mod chart;
mod csv;
pub mod exact;
pub mod methods;
pub mod random;
pub mod real;
mod run;
pub mod step;
mod table;
mod timing;
pub mod truth;
pub mod workloads;

pub use budget::{Term, budget};
pub use csv::{COLUMNS, csv};
pub use run::{Effort, Report, Row, SCENE, run};
pub use table::{Summary, table};
pub use timing::Time;
pub use workloads::scene::SceneRays;
