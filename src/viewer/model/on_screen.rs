//! What decides the ids that a picture shows.

use super::state::State;
use crate::camera::View;

/// All that object and triangle at each pixel depend on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::viewer) struct OnScreen {
    pub view: View,
    pub scene_revision: u64,
    pub visibility_revision: u64,
}

impl OnScreen {
    /// Of what a state shows.
    pub fn of(state: &State) -> Self {
        Self {
            view: *state.view(),
            scene_revision: state.scene_revision(),
            visibility_revision: state.visibility_revision(),
        }
    }
}
