//! The oracle itself, on cases whose answers are known without it.
