//! What the four views hold.

use super::{observer::Observer, stages::Stage};
use crate::{camera::View, scene::Scene};
use glam::{DVec2, DVec3};

/// What the window shows of the scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Views {
    /// What the scene's camera sees.
    #[default]
    Picture,
    /// All stages side by side.
    Four,
    /// One of them, large.
    One(Stage),
}

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
    /// When one of the views was clicked last.
    pub clicked_s: Option<f64>,
    /// Which view was clicked last, where, and how that view stood.
    pub clicked_at: Option<(Stage, DVec2, View)>,
    /// A clicked point that the scene's camera does not see: its object, and the point in that object's space.
    pub point: Option<(usize, DVec3)>,
}
