//! What decides which objects and triangles a picture shows.

use crate::camera::View;

/// All that the object and the triangle at each pixel depend on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::viewer) struct OnScreen {
    pub view: View,
    pub scene_revision: u64,
    pub visibility_revision: u64,
}

/// What is on screen, as the last frame left it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::viewer) enum Seen {
    /// Whatever the state wants.
    #[default]
    Wanted,
    /// What the state wanted when the frame was drawn.
    Whole(OnScreen),
    /// An earlier picture.
    Earlier(OnScreen),
    /// There is no picture yet.
    Nothing,
}
