//! Sightline: what you see is what you pick, to the pixel, and it tells you how sure it is.

pub mod camera;
pub mod cli;
pub mod colour;
pub mod geometry;
pub mod image;
pub mod look;
pub mod pick;
pub mod render;
pub mod scene;
