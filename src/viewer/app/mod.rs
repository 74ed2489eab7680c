//! The program: executes commands, takes the results of jobs, and drives every frame.

mod acting;
mod beginning;
mod checks;
mod commands;
mod files;
mod frame;
mod in_turn;
mod intents;
mod looking_up;
mod memory;
mod modal;
mod next_file;
mod numbers;
mod program;
mod remembering;
mod rescue;
mod rest;
mod saved;
mod shooting;
mod touring;
mod typesetting;
mod wake;
mod watch;

pub use frame::Frame;
pub(super) use in_turn::in_turn;
pub(super) use memory::WindowPlace;
pub use memory::memory_file;
pub(super) use program::{App, Host};
#[cfg(target_os = "linux")]
pub(super) use rescue::{Unsaved, rescue};
pub use rest::REST_S;
#[cfg(feature = "screen-readers")]
pub(super) use wake::Reader;
pub(super) use wake::{PathFor, Wake, Waker};
