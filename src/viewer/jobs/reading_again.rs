//! Reads a mesh's file again in the background, to answer a question about it.

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
    let failed = |error| InFile {
        file: Some(name),
        file_error: Some(error),
        ..InFile::default()
    };
    ask(file, move |again| again.in_file(triangle), wake, failed)
}

/// Asks a file; calls `wake` when it has answered. If reading fails, `failed` makes an answer of the reason.
pub(in crate::viewer) fn ask<T: Send + 'static>(
    file: MeshFile,
    question: impl FnOnce(&mut Again) -> T + Send + 'static,
    wake: impl FnOnce() + Send + 'static,
    failed: impl FnOnce(String) -> T + Send + 'static,
) -> Job<T> {
    let reason = format!("{}: cannot be read again", file.path.display());
    let answer = move |progress: &Progress| {
        let contents = file.contents.clone().unwrap_or_default();
        question(&mut Again::new(&file.path, &contents, &file.mesh, progress))
    };
    Job::start(answer, wake, || failed(reason))
}
