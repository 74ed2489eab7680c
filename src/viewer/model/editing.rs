//! Objects that are moved, hidden and shown.

use super::{stages::Stage, state::State};
use crate::geometry::Placement;
use glam::DAffine3;
use std::iter;

impl State {
    /// Moves an object; its pick follows.
    pub(super) fn place(&mut self, object: usize, model: DAffine3) {
        let Ok(placement) = Placement::new(model) else {
            return;
        };
        // Other stages are made from the world, and show it as it was when they were.
        if self.stage != Stage::World || object >= self.scene.objects().len() {
            return;
        }
        self.scene.place(object, placement);
        self.edited = true;
        self.rearranged();
    }

    pub(super) fn show(&mut self, which: impl Fn(usize) -> bool, visible: bool) {
        for scene in iter::once(&mut self.scene).chain(self.world.as_mut().map(|(scene, ..)| scene))
        {
            for index in (0..scene.objects().len()).filter(|&index| which(index)) {
                scene.set_visible(index, visible);
            }
        }
        self.rearranged();
    }

    /// Objects came, went or moved: what is known of the picture follows.
    fn rearranged(&mut self) {
        self.visibility_revision += 1;
        self.cursor = None;
        self.clicked_s = None;
        if let Some(showing) = &mut self.showing {
            showing.compared = None;
        }
        self.repick();
        self.fit();
    }
}
