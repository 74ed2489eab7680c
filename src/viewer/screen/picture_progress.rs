//! How far pictures have come.

use std::time::Duration;

/// How far the picture has come in a pass.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::viewer) struct PictureProgress {
    /// Whether a new picture of the scene is shown.
    pub anew: bool,
    /// How soon another pass is needed; `None` once the wanted picture is shown.
    pub behind: Option<Duration>,
    /// Whether the wanted picture is shown without smooth edges: at rest it needs another pass.
    pub rough: bool,
    /// About how many triangles were drawn.
    pub drawn: u64,
}

impl PictureProgress {
    /// The progress of two pictures together.
    pub fn and(self, other: Self) -> Self {
        Self {
            anew: self.anew || other.anew,
            behind: self.behind.into_iter().chain(other.behind).min(),
            rough: self.rough || other.rough,
            drawn: self.drawn + other.drawn,
        }
    }
}
