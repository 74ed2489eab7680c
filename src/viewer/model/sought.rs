//! A face or vertex that the user went to by its number.

use crate::geometry::PlacedPoint;

/// What a file has a number for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Numbered {
    /// A face.
    Face(usize),
    /// A vertex.
    Vertex(usize),
}

impl Numbered {
    /// Its name in panels and marks.
    pub fn name(self) -> String {
        match self {
            Self::Face(number) => format!("face {number}"),
            Self::Vertex(number) => format!("v {number}"),
        }
    }
}

/// A face or vertex that the user went to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sought {
    /// Its number.
    pub of: Numbered,
    /// The index of the object that it is on.
    pub object: usize,
    /// One of the object's triangles that contain it.
    pub triangle: u32,
    /// The vertex, or a point inside the face.
    pub point: PlacedPoint,
}
