//! Reads a mesh's file again in the background, to answer a question about it.

use super::job::Job;
use crate::scene::{
    MeshFile, Progress,
    obj::{Again, FaceInFile, InFile, VertexInFile},
};
use std::fmt::Display;

/// A question to a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::viewer) enum Question {
    /// Where a triangle of its mesh comes from.
    Triangle(u32),
    /// A face by its number.
    Face(usize),
    /// A vertex by its number.
    Vertex(usize),
}

/// The answer, or why there is none.
pub(in crate::viewer) enum Found {
    Triangle(InFile),
    Face(Result<FaceInFile, String>),
    Vertex(Result<VertexInFile, String>),
}

/// A question under way. Dropping it cancels it.
pub(in crate::viewer) struct ReadingAgain(Job<Found>);

impl ReadingAgain {
    /// Asks a file; calls `wake` when it has answered.
    pub fn start(file: MeshFile, question: Question, wake: impl FnOnce() + Send + 'static) -> Self {
        let ask = move |progress: &Progress| {
            let contents = file.contents.clone().unwrap_or_default();
            let mut again = Again::new(&file.path, &contents, &file.mesh, progress);
            match question {
                Question::Triangle(triangle) => Found::Triangle(again.in_file(triangle)),
                Question::Face(number) => Found::Face(said(again.face(number))),
                Question::Vertex(number) => Found::Vertex(said(again.vertex(number))),
            }
        };
        Self(Job::start(ask, wake))
    }

    /// The answer, once it is there.
    pub fn poll(&self) -> Option<Found> {
        self.0.poll()?.ok()
    }

    /// The answer, waited for; `None` where none will come.
    pub fn wait(&self) -> Option<Found> {
        self.0.wait()
    }
}

fn said<T>(found: Result<T, impl Display>) -> Result<T, String> {
    found.map_err(|error| error.to_string())
}
