//! How far pictures have come.

use std::time::Duration;

/// How far the picture has come in a pass.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::viewer) struct Progress {
    /// Whether another picture of the scene is shown than before.
    pub anew: bool,
    /// How soon another pass is needed, while it is not yet the one that is wanted.
    pub behind: Option<Duration>,
    /// Whether its scene is on its way into graphics memory still.
    pub is_coming: bool,
    /// Whether it is, but for its edges, which are not smooth yet: another pass is needed once it rests.
    pub rough: bool,
    /// About so many triangles were drawn.
    pub drawn: u64,
    /// So many objects and triangles were taken into graphics memory by the pass itself.
    pub uploaded: usize,
}

impl Progress {
    /// That of two pictures together.
    pub fn and(self, other: Self) -> Self {
        Self {
            anew: self.anew || other.anew,
            behind: match (self.behind, other.behind) {
                (Some(a), Some(b)) => Some(a.min(b)),
                (a, b) => a.or(b),
            },
            is_coming: self.is_coming || other.is_coming,
            rough: self.rough || other.rough,
            drawn: self.drawn + other.drawn,
            uploaded: self.uploaded + other.uploaded,
        }
    }
}
