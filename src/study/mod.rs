//! Other ways to pick, to be compared with the one that is used.

pub mod methods;
