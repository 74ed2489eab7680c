//! Why there is no scene.

use super::{Cancelled, DescriptionError, FileError, ObjError, Problem};

/// Why there is no scene. One line that names the file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LoadError {
    /// The load was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// A scene file could not be read.
    #[error(transparent)]
    File(#[from] FileError),
    /// A scene file was refused.
    #[error(transparent)]
    Scene(DescriptionError),
    /// The gallery has no scene of that name.
    #[error("no \u{201c}{name}\u{201d} in the gallery: there are {known}")]
    NoExhibit {
        /// What was asked for.
        name: String,
        /// The names there are.
        known: String,
    },
    /// A mesh file was refused.
    #[error(transparent)]
    Obj(ObjError),
}

impl LoadError {
    /// Whether a mesh file changed while it was read: once it is complete, it can be read.
    pub(crate) fn is_of_change(&self) -> bool {
        let error = match self {
            Self::Obj(error) => error,
            Self::Scene(DescriptionError { problem, .. }) => match &**problem {
                Problem::Mesh(error) => error,
                _ => return false,
            },
            _ => return false,
        };
        matches!(error, ObjError::File(FileError::Changed { .. }))
    }
}

impl From<ObjError> for LoadError {
    fn from(error: ObjError) -> Self {
        match error {
            ObjError::Cancelled(cancelled) => Self::Cancelled(cancelled),
            error => Self::Obj(error),
        }
    }
}

impl From<DescriptionError> for LoadError {
    fn from(error: DescriptionError) -> Self {
        match *error.problem {
            Problem::Mesh(ObjError::Cancelled(cancelled)) => Self::Cancelled(cancelled),
            _ => Self::Scene(error),
        }
    }
}
