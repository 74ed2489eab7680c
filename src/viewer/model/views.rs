//! What the four views hold.

use super::{observer::Observer, stages::Stage};
use crate::{camera::View, geometry::Aabb, scene::Scene};
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

/// The box that the frustum becomes, as it is drawn: see `stages::projected`.
pub const NDC_DRAWN: Aabb = Aabb {
    min: DVec3::new(-1.0, -1.0, -1.0),
    max: DVec3::new(1.0, 1.0, 0.0),
};

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
    pub alone: Staged,
    pub ndc: Staged,
    /// When one of the views was clicked last.
    pub clicked_s: Option<f64>,
    /// Which view was clicked last, where, and how that view stood.
    pub clicked_at: Option<(Stage, DVec2, View)>,
    /// A clicked point that the scene's camera does not see: its object, and the point in that object's space.
    pub point: Option<(usize, DVec3)>,
}

/// A scene that was made from the one that is shown.
#[derive(Default)]
pub(super) struct Staged {
    pub scene: Scene,
    pub of: Option<Source>,
    /// Counts the scenes that were here.
    pub revision: u64,
}

/// What a [`Staged`] scene is made from.
#[derive(Clone, Copy, PartialEq)]
#[expect(
    clippy::large_enum_variant,
    reason = "one at a time, and a view is most of one"
)]
pub(in crate::viewer) enum Source {
    /// A scene's revision, and the index of one object. Only the object's colour and shape count.
    Alone(u64, usize),
    /// A scene's two revisions, and the view that it is seen through.
    Through([u64; 2], View),
}

impl Staged {
    /// Takes another scene.
    pub fn take(&mut self, scene: Scene, of: &Source) {
        (self.scene, self.of) = (scene, Some(*of));
        self.revision += 1;
    }
}
