//! One way to pick a module: what it does, and where it comes from.

pub mod usual;
