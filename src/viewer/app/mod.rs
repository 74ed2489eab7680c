//! The program: what commands do, what jobs bring, and the one driver that every frame goes through.

mod acting;
mod arriving;
mod checks;
mod commands;
mod exhibits;
mod files;
mod frame;
mod intents;
mod program;
mod rest;
mod wake;

pub(super) use frame::Frame;
pub(super) use program::{App, Host};
pub(super) use rest::REST_S;
pub(super) use wake::{Wake, Waker};
