//! `sightline pick --face` and `--vertex`: finds where a face or vertex of an OBJ file is in the picture.

use super::CliError;
use crate::{
    camera::View,
    json,
    pick::Whereabouts,
    scene::{FilesAgain, Loaded, MeshFile},
    viewer::model::no_such_object,
};
use std::io::Write;

/// Prints where the faces and vertices of these numbers are, in the file of an object or in the only one.
pub(super) fn write(
    mut out: impl Write,
    (faces, vertices): (&[usize], &[usize]),
    object: Option<usize>,
    loaded: &Loaded,
    view: &View,
    files: &mut FilesAgain,
) -> Result<(), CliError> {
    if faces.is_empty() && vertices.is_empty() {
        return Ok(());
    }
    let file = file(object, loaded)?;
    let (scene, mesh) = (&loaded.scene, &file.mesh);
    let again = files.of(mesh).ok_or_else(no_file)?;
    let name = file.path.display().to_string();
    for &number in faces {
        let found = again.face(number)?;
        let line = json::object! {
            file: &name,
            face: found.face,
            line: found.line,
            written: found.written,
            vertices: found.vertices,
            left_out: found.left_out,
            places: Whereabouts::of_face(scene, view, mesh, found.triangles),
        };
        json::write_line(&mut out, &line).map_err(CliError::stdout)?;
    }
    for &number in vertices {
        let vertex = again.vertex(number)?;
        let places = match vertex.value {
            Some(_) => Whereabouts::of_vertex(scene, view, mesh, vertex.position),
            None => Vec::new(),
        };
        let line = json::object! {
            file: &name,
            #[serde(flatten)] vertex: vertex,
            places: places,
        };
        json::write_line(&mut out, &line).map_err(CliError::stdout)?;
    }
    Ok(())
}

/// The file that `--face` and `--vertex` refer to.
fn file(object: Option<usize>, loaded: &Loaded) -> Result<&MeshFile, CliError> {
    let Some(id) = object else {
        let mut files = loaded.meshes.iter().filter(|file| file.contents.is_some());
        return match (files.next(), files.next()) {
            (Some(only), None) => Ok(only),
            (None, _) => Err(no_file()),
            _ => Err(CliError::usage(
                "the scene has several OBJ files: name an object from the one you mean with --object ID",
            )),
        };
    };
    let index = loaded.scene.index_of(id);
    let index =
        index.map_err(|error| CliError::usage(format!("--object: {}", no_such_object(error))))?;
    let mesh = loaded.scene.objects()[index].shape.mesh();
    let file = mesh.and_then(|mesh| MeshFile::of(&loaded.meshes, mesh));
    file.ok_or_else(no_file)
}

fn no_file() -> CliError {
    CliError::usage(
        "only OBJ files number faces and vertices: --face and --vertex need an object from one",
    )
}
