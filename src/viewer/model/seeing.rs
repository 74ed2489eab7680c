//! The picture on screen, which the user points into, and rays quick enough to follow the mouse.

use super::{
    on_screen::{OnScreen, Seen},
    state::State,
};
use crate::{
    camera::View,
    geometry::WorldRay,
    pick::{self, SceneHit},
};

/// Testing this many triangles without a tree takes half a millisecond.
const MOST_WITHOUT_TREE: usize = 30_000;

impl State {
    /// What the next picture shows.
    pub(in crate::viewer) fn to_show(&self) -> OnScreen {
        OnScreen {
            view: self.view,
            scene_revision: self.scene_revision,
            visibility_revision: self.visibility_revision,
        }
    }

    /// Notes what is on screen.
    #[expect(clippy::large_types_passed_by_value, reason = "once a frame, and kept")]
    pub(in crate::viewer) fn see(&mut self, seen: Seen) {
        self.seen = seen;
    }

    /// Whether the scene as it is has yet to be drawn: on screen is another one, or this one before objects were added.
    /// Then a click picks nothing, since the user has not seen what is there.
    pub(in crate::viewer) fn awaits_scene(&self) -> bool {
        match self.seen {
            Seen::Wanted => false,
            Seen::Picture(seen) => seen.scene_revision != self.scene_revision,
            Seen::Nothing => true,
        }
    }

    /// The view of the picture on screen, which the user clicks into: another key or button may have changed the view
    /// since. If that picture still shows objects that are gone or have moved, nobody can pick them any more: then it
    /// is the present view.
    pub(super) fn clicked_view(&self) -> View {
        match self.seen {
            Seen::Picture(seen) if self.shows_these(&seen) => seen.view,
            _ => self.view,
        }
    }

    /// Whether a picture shows the objects as they are.
    fn shows_these(&self, seen: &OnScreen) -> bool {
        let now = self.to_show();
        seen.scene_revision == now.scene_revision
            && seen.visibility_revision == now.visibility_revision
    }

    /// Whether a ray is quick enough for a mouse move: meshes have their trees, or are small.
    pub fn rays_are_quick(&self) -> bool {
        let meshes = self.scene.meshes().iter();
        let tried = meshes.filter(|mesh| !mesh.is_ready());
        let tried: usize = tried.map(|mesh| mesh.data().triangles.len()).sum();
        tried <= MOST_WITHOUT_TREE
    }

    /// The nearest hit, for what follows the mouse; `None` while rays are slow.
    pub(super) fn quick_hit(&self, ray: &WorldRay) -> Option<SceneHit> {
        let is_quick = self.rays_are_quick();
        is_quick.then(|| pick::closest(&self.scene, ray, self.view.sides))?
    }
}
