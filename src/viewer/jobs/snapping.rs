//! Snaps a click to a point. This reads files again and sums the areas of large objects, so it runs in the background.

use super::job::Job;
use crate::{
    camera::View,
    pick::snap::{Snap, object_area},
    scene::{FilesAgain, MeshFile, Progress, Scene},
    viewer::model::Measuring,
};
use glam::DVec2;

/// A position that is being snapped: the point, and the area of the object there if it is known; `None` if nothing is
/// near.
pub(in crate::viewer) type Snapping = Job<Option<(Snap, Option<f64>)>>;

/// Begins to snap a position of a view; calls `wake` when done. The area is left out of what is only shown ahead of a
/// click.
pub(in crate::viewer) fn snap(
    scene: Scene,
    (view, px): (View, DVec2),
    files: Vec<MeshFile>,
    is_click: bool,
    wake: impl FnOnce() + Send + 'static,
) -> Snapping {
    let find = move |progress: &Progress| {
        let mut files = FilesAgain::new(&scene, &files, progress);
        let mut faces = |object, triangle| files.face_of(object, triangle).map_err(Into::into);
        let snap = Snap::at(&scene, &view, px, Measuring::RADIUS_PX, &mut faces)?;
        let area = is_click.then(|| object_area(&scene.objects()[snap.id - 1]));
        Some((snap, area.flatten()))
    };
    Job::start(find, wake, || None)
}
