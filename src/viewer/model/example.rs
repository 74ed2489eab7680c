//! The point of view space that the tour works out. No object needs to have it.

use super::state::State;
use glam::DVec3;

/// The tour's point in the present view.
pub struct Example {
    /// In view space.
    pub view: DVec3,
    /// In world space.
    pub world: DVec3,
    /// In NDC.
    pub ndc: DVec3,
}

impl State {
    /// Sets the point, in view space.
    pub(in crate::viewer) fn set_example(&mut self, point_view: Option<DVec3>) {
        self.example = point_view;
    }

    /// The point; `None` where the tour speaks of none.
    pub fn example(&self) -> Option<Example> {
        self.example.map(|point| self.example_of(point))
    }

    /// A point of view space in the present view.
    pub(in crate::viewer) fn example_of(&self, view: DVec3) -> Example {
        let (camera, aspect) = (&self.view.camera, self.view.viewport.aspect());
        let clip = camera.lens().projection(aspect) * view.extend(1.0);
        Example {
            view,
            world: camera.eye() + camera.rotation().transpose() * view,
            ndc: clip.truncate() / clip.w,
        }
    }
}
