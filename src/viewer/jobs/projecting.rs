//! Makes the scene in NDC, in the background.

use super::job::Job;
use crate::{
    camera::View,
    scene::Scene,
    viewer::model::{ProjectedOf, projected},
};

/// A scene that is being projected, and what it is made of; `None` if that has failed.
pub(in crate::viewer) type Projecting = Job<Option<(Scene, ProjectedOf)>>;

/// Begins to project a scene by a view's matrices; `of` identifies the result. Calls `wake` when done.
pub(in crate::viewer) fn project(
    (scene, through, of): (Scene, View, ProjectedOf),
    wake: impl FnOnce() + Send + 'static,
) -> Projecting {
    let project = move |_: &_| {
        let made = projected(&scene, &through);
        made.build_trees();
        // Dropped early: only a sole owner can change a scene in place.
        drop(scene);
        Some((made, of))
    };
    Job::start(project, wake, || None)
}
