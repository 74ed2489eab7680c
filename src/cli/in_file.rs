//! `sightline pick --face` and `--vertex`: finds where a face or vertex of an OBJ file is in the picture.

use super::CliError;
use crate::{
    camera::View,
    json,
    pick::Whereabouts,
    scene::{FilesAgain, Loaded, MeshFile, Shape, obj::VertexInFile},
    viewer::model::no_such_object,
};
use serde::Serialize;
use std::io::Write;

/// The line for a face.
#[derive(Serialize)]
struct FaceLine {
    file: String,
    face: usize,
    line: usize,
    written: String,
    vertices: Vec<VertexInFile>,
    left_out: Option<String>,
    places: Vec<Whereabouts>,
}

/// The line for a vertex.
#[derive(Serialize)]
struct VertexLine {
    file: String,
    #[serde(flatten)]
    vertex: VertexInFile,
    places: Vec<Whereabouts>,
}

/// What `--face`, `--vertex` and `--object` ask for.
pub(super) struct Wanted<'a> {
    pub faces: &'a [usize],
    pub vertices: &'a [usize],
    pub object: Option<usize>,
}

/// Prints where the requested faces and vertices are.
pub(super) fn write(
    mut out: impl Write,
    wanted: &Wanted<'_>,
    loaded: &Loaded,
    view: &View,
    files: &mut FilesAgain,
) -> Result<(), CliError> {
    if wanted.faces.is_empty() && wanted.vertices.is_empty() {
        return Ok(());
    }
    let file = file(wanted.object, loaded)?;
    let (scene, mesh) = (&loaded.scene, &file.mesh);
    let again = files.of(mesh).ok_or_else(no_file)?;
    let name = file.path.display().to_string();
    let mut print = |line: std::io::Result<String>| {
        line.and_then(|line| writeln!(out, "{line}"))
            .map_err(CliError::stdout)
    };
    for &number in wanted.faces {
        let found = again.face(number)?;
        print(json::text(&FaceLine {
            file: name.clone(),
            face: found.face,
            line: found.line,
            written: found.written,
            vertices: found.vertices,
            left_out: found.left_out,
            places: Whereabouts::of_face(scene, view, mesh, found.triangles),
        }))?;
    }
    for &number in wanted.vertices {
        let vertex = again.vertex(number)?;
        let places = match vertex.value {
            Some(_) => Whereabouts::of_vertex(scene, view, mesh, vertex.position),
            None => Vec::new(),
        };
        print(json::text(&VertexLine {
            file: name.clone(),
            vertex,
            places,
        }))?;
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
            _ => Err(CliError::Usage(
                "the scene has several OBJ files: name an object from the one you mean with --object ID".to_owned(),
            )),
        };
    };
    let index = loaded.scene.index_of(id);
    let index =
        index.map_err(|error| CliError::Usage(format!("--object: {}", no_such_object(error))))?;
    match &loaded.scene.objects()[index].shape {
        Shape::Mesh { mesh, .. } => MeshFile::of(&loaded.meshes, mesh).ok_or_else(no_file),
        _ => Err(no_file()),
    }
}

fn no_file() -> CliError {
    CliError::Usage(
        "only OBJ files number faces and vertices: --face and --vertex need an object from one"
            .to_owned(),
    )
}
