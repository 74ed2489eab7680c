//! How good a picture of the scene is.

use crate::{
    camera::{View, Viewport},
    render::Piece,
};

/// With more work than this, triangles take longer than pixels.
const MUCH: u64 = 50_000;

/// How good a picture is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Finish {
    /// Of lower resolution: each pixel covers this many of the window's along each side.
    Coarse(u32),
    /// Of the window's resolution, so its ids are exact.
    Rough,
    /// Its edges are smooth, too.
    Smooth,
}

impl Finish {
    /// The finish of a moving picture of a scene with this much work.
    pub fn coarse(scene: Piece) -> Self {
        Self::Coarse(if scene.work > MUCH { 3 } else { 2 })
    }

    /// Pixels of the window, along each side, that a pixel covers.
    pub fn coarseness(self) -> u32 {
        match self {
            Self::Coarse(pixels) => pixels,
            Self::Rough | Self::Smooth => 1,
        }
    }

    /// Whether its ids are those of the window's pixels.
    pub fn is_exact(self) -> bool {
        self >= Self::Rough
    }

    /// The view that a picture of this finish is drawn through.
    pub fn drawn(self, view: &View) -> View {
        let of = |side: u32| side.div_ceil(self.coarseness());
        let size = [view.viewport.width(), view.viewport.height()].map(of);
        View {
            viewport: Viewport::new(size[0], size[1]).unwrap_or(view.viewport),
            ..*view
        }
    }
}
