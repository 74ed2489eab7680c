//! The oracle: whole picks by exact arithmetic and brute force. It shares no code with the program. `exact_picks`
//! checks it against cases worked out by hand.

#![allow(dead_code, reason = "each test uses its share")]

pub mod flat;
pub mod line;
pub mod number;
pub mod root;
pub mod truth;
