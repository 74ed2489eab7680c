//! How good a picture of the scene is.

use crate::{
    camera::{View, Viewport},
    geometry::shares::cores,
};

/// Pixels of a moving picture for each core. A core draws them, or casts their rays, in about a hundredth of a second.
const PIXELS_A_CORE: u64 = 50_000;
/// Pixels of the window, along each side, that a pixel of a moving picture covers at most.
const COARSEST: u32 = 4;

/// How good a picture is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Finish {
    /// The resolution is lower: each pixel covers this many of the window's along each side.
    Coarse(u32),
    /// The resolution is the window's, so the ids are exact.
    Rough,
    /// The edges are smooth, too.
    Smooth,
}

impl Finish {
    /// The finish of a moving picture: the least coarse that this machine draws quickly.
    pub fn coarse(viewport: Viewport) -> Self {
        Self::coarse_on(viewport, cores() as u64)
    }

    fn coarse_on(viewport: Viewport, cores: u64) -> Self {
        let is_little = |coarseness: &u32| {
            let of = |side: u32| u64::from(side.div_ceil(*coarseness));
            of(viewport.width()) * of(viewport.height()) <= PIXELS_A_CORE * cores
        };
        Self::Coarse((2..COARSEST).find(is_little).unwrap_or(COARSEST))
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moving_pictures_are_as_fine_as_the_cores_allow() {
        let on = |[width, height]: [u32; 2], cores| {
            let viewport = Viewport::new(width, height).expect("a viewport");
            Finish::coarse_on(viewport, cores).coarseness()
        };
        assert_eq!(on([320, 400], 2), 2);
        assert_eq!(on([740, 670], 2), 3);
        assert_eq!(on([740, 670], 4), 2);
        assert_eq!(on([2560, 1440], 2), COARSEST);
        assert_eq!(on([2560, 1440], 16), 3);
    }
}
