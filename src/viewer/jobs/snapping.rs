//! Snaps a click to a point. This reads files again and sums the areas of large objects, so it runs in the background.

use super::job::Job;
use crate::{
    camera::View,
    pick::snap::{Snap, object_area},
    scene::{FilesAgain, MeshFile, Progress, Scene},
    viewer::model::Measuring,
};
use glam::DVec2;

/// A click that is being snapped: the point, and the area of the object there if it is known; `None` if nothing is
/// near.
pub(in crate::viewer) type Snapping = Job<Option<(Snap, Option<f64>)>>;

/// Begins to snap a click at a position of a view; calls `wake` when done.
pub(in crate::viewer) fn snap(
    scene: Scene,
    view: View,
    px: DVec2,
    files: Vec<MeshFile>,
    wake: impl FnOnce() + Send + 'static,
) -> Snapping {
    let find = move |progress: &Progress| {
        let mut files = FilesAgain::new(&scene, &files, progress);
        let mut faces = |object, triangle| files.face_of(object, triangle).map_err(Into::into);
        let snap = Snap::at(&scene, &view, px, Measuring::RADIUS_PX, &mut faces)?;
        let area = object_area(&scene.objects()[snap.id - 1]);
        Some((snap, area))
    };
    Job::start(find, wake, || None)
}
