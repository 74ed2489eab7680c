//! How far pictures have come.

use std::time::Duration;

/// How far the picture has come in a pass.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::viewer) struct PictureProgress {
    /// Whether a new picture of the scene is shown.
    pub anew: bool,
    /// How soon another pass is needed; `None` once the wanted picture is shown.
    pub behind: Option<Duration>,
    /// Whether its scene is still being uploaded.
    pub is_coming: bool,
    /// Whether the wanted picture is shown without smooth edges: at rest it needs another pass.
    pub rough: bool,
    /// About how many triangles were drawn.
    pub drawn: u64,
    /// Objects and triangles that the pass itself uploaded.
    pub uploaded: usize,
}

impl PictureProgress {
    /// The progress of two pictures together.
    pub fn and(self, other: Self) -> Self {
        Self {
            anew: self.anew || other.anew,
            behind: self.behind.into_iter().chain(other.behind).min(),
            is_coming: self.is_coming || other.is_coming,
            rough: self.rough || other.rough,
            drawn: self.drawn + other.drawn,
            uploaded: self.uploaded + other.uploaded,
        }
    }
}
