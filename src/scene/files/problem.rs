//! What can be wrong with a scene file, and with saving one.

use super::ObjError;
use crate::geometry::PlacementError;
use std::path::PathBuf;

/// Why a scene file was refused. One line that names the file and, where it can be told, the line.
#[derive(Debug, thiserror::Error)]
#[error("{}:{line}:{column}: {problem}", file.display())]
pub struct DescriptionError {
    /// The scene file.
    pub file: PathBuf,
    /// The line in it, and the column there, from 1.
    pub line: usize,
    /// See `line`.
    pub column: usize,
    /// What is wrong there.
    #[source]
    pub problem: Box<Problem>,
}

/// What is wrong in a scene file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Problem {
    /// It is not TOML, or not a scene file: what the parser says.
    #[error("{0}")]
    Syntax(String),
    /// Two fields that say the same thing.
    #[error("{0} exclude each other: keep one")]
    Both(&'static str),
    /// A number is beyond the range of numbers; see [`range`](crate::geometry::range).
    #[error("{0} must be numbers up to 1.29e33")]
    OutOfRange(&'static str),
    /// The model matrix is not valid.
    #[error("{object}: {source}")]
    Placement {
        /// Name of the object.
        object: String,
        /// What is wrong with the matrix.
        source: PlacementError,
    },
    /// An object without a shape.
    #[error("an object needs its shape: shape = \"sphere\", \"cube\", \"square\" or \"mesh\"")]
    NoShape,
    /// A mesh without a file.
    #[error("a mesh needs its file: file = \"name.obj\"")]
    NoFile,
    /// A field that only a mesh may have.
    #[error("{0} is for shape = \"mesh\" only")]
    NotAMesh(&'static str),
    /// The mesh file has fewer objects.
    #[error("{file} has {parts} objects, so there is no part {part}: parts count from 1")]
    NoSuchPart {
        /// The mesh file.
        file: String,
        /// How many objects it has.
        parts: usize,
        /// What was asked for.
        part: usize,
    },
    /// The mesh file was refused; the message names it.
    #[error(transparent)]
    Mesh(ObjError),
}

/// Why a scene cannot be written as a scene file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum SaveError {
    /// A mesh that was made, not loaded.
    #[error("{0} comes from no file, so a scene file cannot name it")]
    NoFile(String),
    /// A path that is not UTF-8, as TOML requires.
    #[error("the path {0} is not text that a scene file can hold")]
    Path(String),
    /// A mesh without a file that an OBJ file cannot hold exactly.
    #[error("the mesh {0} has no file, and an OBJ file would not hold it exactly")]
    NotExact(String),
    /// A file cannot be written.
    #[error("cannot write {}: {source}", file.display())]
    Unwritable {
        /// The file.
        file: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// The TOML writer failed.
    #[error("cannot write the scene as TOML: {0}")]
    Toml(#[from] toml::ser::Error),
}
