//! A list of what other modules use of exact arithmetic: its numbers, which are dyadic (integers times powers of two),
//! and points and rays expressed in them.

pub(crate) use super::{
    super::interval::InDoubt,
    big_number::{Dyadic, DyadicVector, rounded},
    enclosure::Enclosure,
    exact_line::{ExactLine, factors},
    integer::{Decided, Ring},
    matrix::Adjugate,
    number::{Number, Vector},
    point::{placed, point},
};
