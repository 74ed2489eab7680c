//! What decides which objects and triangles a picture shows.

use crate::camera::View;

/// All that the object and the triangle at each pixel depend on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::viewer) struct OnScreen {
    pub view: View,
    pub scene_revision: u64,
    pub visibility_revision: u64,
}
