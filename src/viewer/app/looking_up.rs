//! Looks things up in the files of meshes: the face of a pick, and faces and vertices to go to.

use super::{
    errands::finished,
    numbers::{Found, Triangle, file_of, situation},
    program::App,
};
use crate::{
    camera::View,
    geometry::Mesh,
    pick::Whereabouts,
    scene::{
        MeshFile, Scene, Shape,
        obj::{Again, AgainError, InFile},
    },
    viewer::{
        jobs::{self, Job},
        model::{Action, Numbered, Sought, State},
        ui::GoTo,
    },
};
use std::sync::Arc;

impl App {
    /// Asks the file about the pick, and takes the answers that have come.
    pub(super) fn take_numbers(&mut self) {
        self.look_up_pick();
        self.take_snapped();
        let done = finished(&mut self.numbers.going, |(_, reading)| reading.poll());
        if let Some(((scene, _), found)) = done
            && scene == self.state.scene_revision()
        {
            match found {
                Ok(found) => self.arrive_at(found),
                Err(reason) => self.tell(reason),
            }
            self.context.request_repaint();
        }
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
            let snapping = jobs::snap(scene, ray.view, ray.px, files, self.waker());
            self.numbers.snapping = Some((scene_now(&self.state), snapping));
        }
    }

    fn take_snapped(&mut self) {
        let done = finished(&mut self.numbers.snapping, |(_, job)| job.poll());
        let Some(((of, _), found)) = done else { return };
        if let Some((snap, area)) = found.filter(|_| of == scene_now(&self.state)) {
            self.state.take_snap(snap, area);
        }
        self.context.request_repaint();
    }

    /// Goes to an object, or asks the file where the face or vertex is.
    pub(super) fn go_to(&mut self, to: GoTo) {
        (self.numbers.going, self.numbers.said) = (None, None);
        self.act(Action::Unmark);
        let of = match to {
            GoTo::Object(id) => return self.go_to_object(id),
            GoTo::Face(number) => Numbered::Face(number),
            GoTo::Vertex(number) => Numbered::Vertex(number),
        };
        match file_in_question(&self.state) {
            Ok(file) => {
                let (scene, view) = (self.state.scene().clone(), *self.state.view());
                let mesh = Arc::clone(&file.mesh);
                let question = move |again: &mut Again| {
                    let found = find(of, &scene, &view, &mesh, again);
                    found.map_err(|error| error.to_string())
                };
                let reading = jobs::ask(file, question, self.waker(), Err);
                self.numbers.going = Some((self.state.scene_revision(), reading));
            }
            Err(reason) => self.tell(reason.to_owned()),
        }
    }

    fn go_to_object(&mut self, id: usize) {
        let object = match self.state.scene().index_of(id) {
            Ok(object) => object,
            Err(error) => return self.tell(error.to_string()),
        };
        let it = &self.state.scene().objects()[object];
        let hidden = if it.visible { "" } else { "; it is hidden" };
        let text = format!("object {id}: {}{hidden}", it.name);
        self.act(Action::Select(Some(object)));
        self.act(Action::FrameSelection);
        self.reveal_selection = true;
        self.tell(text);
    }

    fn tell(&mut self, text: String) {
        self.numbers.said = Some((situation(&self.state), text));
    }

    /// Shows and marks the face or vertex that was found; the panel says how it is seen.
    fn arrive_at(&mut self, Found { of, text, places }: Found) {
        let objects = self.state.scene().objects();
        let is_shown = |place: &&Whereabouts| objects[place.id - 1].visible;
        let place = places.iter().find(is_shown).or(places.first());
        let text = match (place, of) {
            (Some(place), _) => {
                let sought = Sought {
                    of,
                    object: place.id - 1,
                    triangle: place.triangle,
                    point: place.point,
                };
                self.act(Action::GoTo(sought));
                self.reveal_selection = true;
                text
            }
            (None, Numbered::Vertex(_)) => format!("{text}: no face uses it"),
            (None, Numbered::Face(_)) => format!("{text}: nothing of it is shown"),
        };
        self.tell(text);
    }
}

/// Revisions that change with the scene.
fn scene_now(state: &State) -> [u64; 2] {
    [state.scene_revision(), state.visibility_revision()]
}

/// The pick's object, triangle and file; `None` if no file is still to be asked about it.
fn unknown_pick(state: &State) -> Option<(usize, u32, MeshFile)> {
    let hit = state.picked()?;
    let (triangle, file) = file_of(state, hit)?;
    Some((hit.id - 1, triangle, file))
}

/// Finds a face or vertex of a mesh's file, and where a view of a scene has it.
fn find(
    of: Numbered,
    scene: &Scene,
    view: &View,
    mesh: &Arc<Mesh>,
    again: &mut Again,
) -> Result<Found, AgainError> {
    let (text, places) = match of {
        Numbered::Face(number) => {
            let face = again.face(number)?;
            let mut text = format!("face {}, line {}", face.face, face.line);
            if let Some(why) = &face.left_out {
                text = format!("{text}, left out: {why}");
            }
            let places = Whereabouts::of_face(scene, view, mesh, face.triangles);
            (text, places)
        }
        Numbered::Vertex(number) => {
            let vertex = again.vertex(number)?;
            let (v, written) = (vertex.vertex, &vertex.written);
            let text = format!("v {v}: {written}, line {}", vertex.line);
            let places = match vertex.value {
                Some(_) => Whereabouts::of_vertex(scene, view, mesh, vertex.position),
                None => Vec::new(),
            };
            (text, places)
        }
    };
    Ok(Found { of, text, places })
}

/// The file whose faces and vertices are meant: the selected object's, or the only one.
fn file_in_question(state: &State) -> Result<MeshFile, &'static str> {
    let files = &state.source().meshes;
    let selected = state.selected();
    let of_selected = selected.and_then(|object| match &state.scene().objects()[object].shape {
        Shape::Mesh { mesh, .. } => MeshFile::of(files, mesh),
        _ => None,
    });
    let mut with_numbers = files.iter().filter(|file| file.contents.is_some());
    let only = match (with_numbers.next(), with_numbers.next()) {
        (Some(only), None) => Some(only),
        (None, _) => return Err("only OBJ files number faces and vertices: none is open"),
        _ => None,
    };
    let file = of_selected.filter(|file| file.contents.is_some()).or(only);
    file.cloned()
        .ok_or("the scene has several OBJ files: select an object from the one you mean")
}
