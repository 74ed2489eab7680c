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
#[expect(clippy::large_enum_variant, reason = "a state has one")]
pub(in crate::viewer) enum Seen {
    /// Whatever the state wants.
    #[default]
    Wanted,
    /// What the state wanted when the last frame was drawn.
    Picture(OnScreen),
    /// There is no picture yet.
    Nothing,
}
