//! What decides which objects and triangles a picture shows.

use crate::camera::View;

/// All that the object and the triangle at each pixel depend on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::viewer) struct OnScreen {
    pub view: View,
    pub scene_revision: u64,
    pub visibility_revision: u64,
}

/// What is on screen, as far as it is not what the state wants.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "there is one, and it is copied")]
pub(in crate::viewer) enum Seen {
    /// The picture is the wanted one.
    #[default]
    Wanted,
    /// The picture is an earlier one.
    Earlier(OnScreen),
    /// There is no picture yet.
    Nothing,
}
