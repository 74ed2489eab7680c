//! Looks up in the files of meshes: the face of a pick, and what a click snaps to.

use super::{numbers::Triangle, program::App};
use crate::{
    scene::{MeshFile, obj::InFile},
    viewer::{
        jobs::{self, Job, Snapping},
        model::State,
    },
};

impl App {
    /// Asks the file about the pick, and takes the answers that have come.
    pub(super) fn take_numbers(&mut self) {
        self.look_up_pick();
        self.take_snapped();
        self.take_ahead();
    }

    fn look_up_pick(&mut self) {
        let wanted = unknown_pick(&self.state);
        let wanted = wanted.map(|(object, triangle, file)| {
            ((self.state.scene_revision(), object, triangle), file)
        });
        let is_wanted = |(of, _): &mut (Triangle, Job<InFile>)| {
            wanted.as_ref().is_none_or(|(wanted, _)| wanted != of)
        };
        drop(self.numbers.of_pick.take_if(is_wanted));
        match (&self.numbers.of_pick, wanted) {
            (Some((_, reading)), _) => {
                if let Some(in_file) = reading.poll() {
                    self.numbers.of_pick = None;
                    self.state.learn(&in_file);
                    self.context.request_repaint();
                }
            }
            (None, Some((of, file))) => {
                let reading = jobs::ask_about_triangle(file, of.2, self.waker());
                self.numbers.of_pick = Some((of, reading));
            }
            (None, None) => {}
        }
    }

    /// Begins to snap a click to a vertex or an edge, while measuring.
    pub(super) fn snap(&mut self) {
        self.numbers.snapping = None;
        let ray = self.state.hits().filter(|_| self.state.measuring().is_on);
        if let Some(ray) = ray {
            let files = self.state.source().meshes.clone();
            let scene = self.state.scene().clone();
            let snapping = jobs::snap(scene, (ray.view, ray.px), files, true, self.waker());
            self.numbers.snapping = Some((scene_now(&self.state), snapping));
        }
    }

    fn take_snapped(&mut self) {
        let snapping = self.numbers.snapping.as_ref();
        let done = snapping.and_then(|(of, job)| Some((*of, job.poll()?)));
        let Some((of, found)) = done else { return };
        self.numbers.snapping = None;
        if let Some((snap, area)) = found.filter(|_| of == scene_now(&self.state)) {
            self.state.take_snap(snap, area);
        }
        self.context.request_repaint();
    }

    /// Begins to find what a click under the cursor would snap to, while measuring: one position at a time, the latest
    /// next.
    pub(super) fn look_ahead(&mut self) {
        let is_measured = self.state.measuring().is_on && self.state.stages().is_empty();
        let Some(cursor) = self.state.cursor().filter(|_| is_measured) else {
            self.numbers.ahead = None;
            return self.state.aim(None);
        };
        let aim = (scene_now(&self.state), *self.state.view(), cursor.px);
        match &self.numbers.ahead {
            Some((_, Some(_))) => {}
            Some((last, None)) if *last == aim => {}
            _ => {
                let scene = self.state.scene().clone();
                let files = self.state.source().meshes.clone();
                let job = jobs::snap(scene, (aim.1, aim.2), files, false, self.waker());
                self.numbers.ahead = Some((aim, Some(job)));
            }
        }
    }

    fn take_ahead(&mut self) {
        let Some((_, asked)) = &mut self.numbers.ahead else {
            return;
        };
        let Some(found) = asked.as_ref().and_then(Snapping::poll) else {
            return;
        };
        *asked = None;
        self.state.aim(found.map(|(snap, _)| snap));
        self.context.request_repaint();
    }
}

/// Revisions that change with the scene.
fn scene_now(state: &State) -> [u64; 2] {
    [state.scene_revision(), state.visibility_revision()]
}

/// The pick's object, triangle of the mesh, and file; `None` if there is no file, or it was asked already.
fn unknown_pick(state: &State) -> Option<(usize, u32, MeshFile)> {
    let hit = state.picked()?;
    let shape = &state.scene().objects().get(hit.id - 1)?.shape;
    let file = MeshFile::of(&state.source().meshes, shape.mesh()?)?;
    let is_unknown = hit.in_file.file.is_none() && file.contents.is_some();
    let triangle = shape.first_triangle() + hit.triangle?;
    is_unknown.then(|| (hit.id - 1, triangle, file.clone()))
}
