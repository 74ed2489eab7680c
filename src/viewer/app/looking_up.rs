//! What the files of meshes say: of the pick, and of faces and vertices that somebody goes to.

use super::{numbers::Triangle, program::App, wake::Wake};
use crate::{
    pick::Whereabouts,
    scene::{MeshFile, Shape},
    viewer::{
        jobs::{Found, Question, ReadingAgain, Snapping},
        model::{Action, State},
        ui::GoTo,
    },
};
use std::sync::mpsc::TryRecvError;

impl App {
    /// Asks the file about the pick, and takes what files have answered.
    pub(super) fn take_numbers(&mut self) {
        self.look_up_pick();
        self.take_snapped();
        let answer = self.numbers.going.as_ref();
        let Some(found) = answer.and_then(|(.., reading)| reading.poll()) else {
            return;
        };
        if let Some((to, file, scene, _)) = self.numbers.going.take()
            && scene == self.state.scene_revision()
        {
            self.arrive_at(to, &file, found);
            self.context.request_repaint();
        }
    }

    fn look_up_pick(&mut self) {
        let wanted = unknown_pick(&self.state);
        let wanted = wanted.map(|(object, triangle, file)| {
            ((self.state.scene_revision(), object, triangle), file)
        });
        let is_wanted = |(of, _): &mut (Triangle, ReadingAgain)| {
            wanted.as_ref().is_none_or(|(wanted, _)| wanted != of)
        };
        drop(self.numbers.of_pick.take_if(is_wanted));
        match (&self.numbers.of_pick, wanted) {
            (Some((_, reading)), _) => {
                if let Some(Found::Triangle(in_file)) = reading.poll() {
                    self.numbers.of_pick = None;
                    self.state.learn(&in_file);
                    self.context.request_repaint();
                }
            }
            (None, Some((of, file))) => {
                let wake = self.wake.clone();
                let question = Question::Triangle(of.2);
                let reading = ReadingAgain::start(file, question, move || wake(Wake::Look));
                self.numbers.of_pick = Some((of, reading));
            }
            (None, None) => {}
        }
    }

    /// Leads a click to a vertex or an edge, where that is asked for.
    pub(super) fn snap(&mut self) {
        self.numbers.snapping = None;
        let ray = self.state.hits().filter(|_| self.state.measuring().is_on);
        if let Some(ray) = ray {
            let wake = self.wake.clone();
            let files = self.state.source().meshes.clone();
            let scene = self.state.scene().clone();
            let snapping =
                Snapping::start(scene, ray.view, ray.px, files, move || wake(Wake::Look));
            self.numbers.snapping = Some((scene_now(&self.state), snapping));
        }
    }

    fn take_snapped(&mut self) {
        let found = match self.numbers.snapping.as_ref().map(|(_, job)| job.poll()) {
            None | Some(Err(TryRecvError::Empty)) => return,
            Some(found) => found.ok().flatten(),
        };
        let of = self.numbers.snapping.take().map(|(of, _)| of);
        if let Some((snap, area)) = found.filter(|_| of == Some(scene_now(&self.state))) {
            self.state.take_snap(snap, area);
        }
        self.context.request_repaint();
    }

    /// Goes to an object, or asks the file where the face or vertex is.
    pub(super) fn go_to(&mut self, to: GoTo) {
        (self.numbers.going, self.numbers.said) = (None, None);
        let question = match to {
            GoTo::Object(id) => return self.go_to_object(id),
            GoTo::Face(number) => Question::Face(number),
            GoTo::Vertex(number) => Question::Vertex(number),
        };
        match file_in_question(&self.state) {
            Ok(file) => {
                let wake = self.wake.clone();
                let reading = ReadingAgain::start(file.clone(), question, move || wake(Wake::Look));
                self.numbers.going = Some((to, file, self.state.scene_revision(), reading));
            }
            Err(reason) => self.numbers.said = Some(reason.to_owned()),
        }
    }

    fn go_to_object(&mut self, id: usize) {
        let objects = self.state.scene().objects();
        let Some(object) = id.checked_sub(1).filter(|index| *index < objects.len()) else {
            let count = objects.len();
            self.numbers.said = Some(format!(
                "there is no object {id}: they run from 1 to {count}"
            ));
            return;
        };
        let hidden = if objects[object].visible {
            ""
        } else {
            "; it is hidden"
        };
        self.numbers.said = Some(format!("object {id}: {}{hidden}", objects[object].name));
        self.act(Action::Select(Some(object)));
        self.act(Action::FrameSelection);
        self.reveal_selection = true;
    }

    /// Shows what was asked for, and says how it is seen.
    fn arrive_at(&mut self, to: GoTo, file: &MeshFile, found: Found) {
        let found = match found {
            Found::Face(face) => face.map(|face| {
                let mut name = format!("face {}, line {}", face.face, face.line);
                if let Some(why) = &face.left_out {
                    name = format!("{name}, left out: {why}");
                }
                let places = |state: &State| {
                    let (scene, view) = (state.scene(), state.view());
                    Whereabouts::of_face(scene, view, &file.mesh, face.triangles.clone())
                };
                (name, self.go_to_first(places))
            }),
            Found::Vertex(vertex) => vertex.map(|vertex| {
                let name = format!(
                    "v {}: {}, line {}",
                    vertex.vertex, vertex.written, vertex.line
                );
                let places = |state: &State| {
                    let (scene, view) = (state.scene(), state.view());
                    match vertex.value {
                        Some(_) => Whereabouts::of_vertex(scene, view, &file.mesh, vertex.position),
                        None => Vec::new(),
                    }
                };
                (name, self.go_to_first(places))
            }),
            Found::Triangle(_) => return,
        };
        self.numbers.said = Some(match (found, to) {
            (Err(error), _) => error,
            (Ok((name, Some(place))), _) => format!("{name}: {}", seen(&place)),
            (Ok((name, None)), GoTo::Vertex(_)) => format!("{name}: no face uses it"),
            (Ok((name, None)), _) => format!("{name}: nothing of it is shown"),
        });
    }

    /// Goes to the first of some places; gives where that is then.
    fn go_to_first(&mut self, places: impl Fn(&State) -> Vec<Whereabouts>) -> Option<Whereabouts> {
        let first = places(&self.state).into_iter().next()?;
        let (object, at) = (first.id - 1, first.point_world);
        self.act(Action::GoTo(object, first.triangle, at));
        self.reveal_selection = true;
        places(&self.state).into_iter().next()
    }
}

/// What changes with the scene.
fn scene_now(state: &State) -> [u64; 2] {
    [state.scene_revision(), state.visibility_revision()]
}

/// How a place is seen.
fn seen(place: &Whereabouts) -> String {
    match (&place.hidden_by, place.px) {
        (Some(by), _) => {
            let triangle = by
                .triangle
                .map_or_else(String::new, |n| format!(", triangle {n}"));
            format!("hidden by {}{triangle}", by.object)
        }
        (None, Some(px)) if place.seen => format!("seen at {:.2}, {:.2}", px.x, px.y),
        _ => "not shown: before near, beyond far, culled, hidden or edge-on".to_owned(),
    }
}

/// The pick's object, triangle and file, where the file was not asked yet.
fn unknown_pick(state: &State) -> Option<(usize, u32, MeshFile)> {
    let hit = state.selection()?.pick.as_ref()?.hit.as_ref()?;
    let object = state.scene().objects().get(hit.id - 1)?;
    let Shape::Mesh { mesh, .. } = &object.shape else {
        return None;
    };
    let triangle = object.shape.first_triangle() + hit.triangle?;
    let file = MeshFile::of(&state.source().meshes, mesh)?;
    let is_unknown = hit.in_file.file.is_none() && file.contents.is_some();
    is_unknown.then(|| (hit.id - 1, triangle, file.clone()))
}

/// The file whose faces and vertices are meant: the selected object's, or the only one.
fn file_in_question(state: &State) -> Result<MeshFile, &'static str> {
    let files = &state.source().meshes;
    let selected = state.selection().map(|selection| selection.object);
    let of_selected = selected.and_then(|object| match &state.scene().objects()[object].shape {
        Shape::Mesh { mesh, .. } => MeshFile::of(files, mesh),
        _ => None,
    });
    let mut with_numbers = files.iter().filter(|file| file.contents.is_some());
    let only = match (with_numbers.next(), with_numbers.next()) {
        (Some(only), None) => Some(only),
        (None, _) => return Err("faces and vertices have numbers where an OBJ file is shown"),
        _ => None,
    };
    let file = of_selected.filter(|file| file.contents.is_some()).or(only);
    file.cloned()
        .ok_or("there are several OBJ files: select an object of the one that is meant")
}
