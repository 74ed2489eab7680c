//! Reads a mesh's file again in the background, to say where a triangle comes from.

use super::job::Job;
use crate::scene::{
    MeshFile, Progress,
    obj::{Again, InFile},
};

/// Asks a file where a triangle of its mesh comes from; calls `wake` when it has answered.
pub(in crate::viewer) fn ask_about_triangle(
    file: MeshFile,
    triangle: u32,
    wake: impl FnOnce() + Send + 'static,
) -> Job<InFile> {
    let name = file.path.display().to_string();
    let answer = move |progress: &Progress| {
        let contents = file.contents.clone().unwrap_or_default();
        Again::new(&file.path, &contents, &file.mesh, progress).in_file(triangle)
    };
    let failed = || InFile {
        file_error: Some(format!("{name}: cannot be read again")),
        file: Some(name),
        ..InFile::default()
    };
    Job::start(answer, wake, failed)
}
