//! What the four views hold.

use super::{observer::Observer, stages::Stage};
use crate::scene::Scene;
use glam::DVec3;

/// The four views.
pub(super) struct Panes {
    pub large: Option<Stage>,
    /// The view that the next mouse actions are in.
    pub entered: Option<Stage>,
    pub observers: [Observer; 4],
    /// The document that the views were framed for.
    pub of: Option<u64>,
    /// The object whose space is shown.
    pub object: Option<usize>,
    /// It alone, in its own space, and which object of which scene it is.
    pub alone: Scene,
    pub alone_of: Option<(u64, usize)>,
    /// A clicked point that the scene's camera does not see: its object, and the point in that object's space.
    pub point: Option<(usize, DVec3)>,
}
