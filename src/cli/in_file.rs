//! What the files of meshes say, for `sightline pick`: of what was hit, and of a face or a vertex by its number.

use super::{CliError, PickArgs};
use crate::{
    camera::View,
    geometry::Mesh,
    pick::{Pick, Whereabouts},
    scene::{
        Loaded, MeshFile, Progress, Scene, Shape,
        obj::{Again, FaceInFile, VertexInFile},
    },
};
use serde::Serialize;
use std::{io::Write, sync::Arc};

/// The files of a scene's meshes, to be read again.
pub(super) struct Files<'a> {
    scene: &'a Scene,
    files: Vec<(&'a Arc<Mesh>, Again<'a>)>,
}

impl<'a> Files<'a> {
    pub fn new(loaded: &'a Loaded, progress: &'a Progress) -> Self {
        let again = |file: &'a MeshFile| {
            let contents = file.contents.as_ref()?;
            let again = Again::new(&file.path, contents, &file.mesh, progress);
            Some((&file.mesh, again))
        };
        Self {
            scene: &loaded.scene,
            files: loaded.meshes.iter().filter_map(again).collect(),
        }
    }

    fn of(&mut self, mesh: &Arc<Mesh>) -> Option<&mut Again<'a>> {
        let mut files = self.files.iter_mut();
        let found = files.find(|(known, _)| Arc::ptr_eq(known, mesh));
        found.map(|(_, again)| again)
    }

    /// The face that a triangle of an object's mesh came from, where the file says.
    pub fn face_of(&mut self, object: usize, triangle: u32) -> Option<FaceInFile> {
        let Shape::Mesh { mesh, .. } = &self.scene.objects()[object].shape else {
            return None;
        };
        self.of(mesh)?.face_of(triangle).ok()
    }

    /// Adds to a pick what the file of its mesh says.
    pub fn look_up(&mut self, pick: &mut Pick) {
        let object = &self.scene.objects()[pick.id - 1];
        if let (Shape::Mesh { mesh, .. }, Some(triangle)) = (&object.shape, pick.triangle)
            && let Some(again) = self.of(mesh)
        {
            pick.in_file = again.in_file(object.shape.first_triangle() + triangle);
        }
    }
}

/// The line for a face.
#[derive(Serialize)]
struct FaceLine {
    file: String,
    face: usize,
    line: usize,
    vertices: Vec<VertexInFile>,
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

/// Prints where the faces and vertices are that are asked for.
pub(super) fn write(
    mut out: impl Write,
    args: &PickArgs,
    loaded: &Loaded,
    view: &View,
    files: &mut Files,
) -> Result<(), CliError> {
    if args.face.is_empty() && args.vertex.is_empty() {
        return Ok(());
    }
    let file = file(args, loaded)?;
    let (scene, mesh) = (&loaded.scene, &file.mesh);
    let again = files.of(mesh).ok_or_else(no_file)?;
    let name = file.path.display().to_string();
    let mut print = |line: Result<String, serde_json::Error>| {
        line.map_err(std::io::Error::from)
            .and_then(|line| writeln!(out, "{line}"))
            .map_err(CliError::stdout)
    };
    for &number in &args.face {
        let found = again.face(number)?;
        print(serde_json::to_string(&FaceLine {
            file: name.clone(),
            face: found.face,
            line: found.line,
            vertices: found.vertices,
            places: Whereabouts::of_face(scene, view, mesh, found.triangles),
        }))?;
    }
    for &number in &args.vertex {
        let vertex = again.vertex(number)?;
        let places = match vertex.value {
            Some(_) => Whereabouts::of_vertex(scene, view, mesh, vertex.position),
            None => Vec::new(),
        };
        print(serde_json::to_string(&VertexLine {
            file: name.clone(),
            vertex,
            places,
        }))?;
    }
    Ok(())
}

/// The file whose faces and vertices are meant.
fn file<'a>(args: &PickArgs, loaded: &'a Loaded) -> Result<&'a MeshFile, CliError> {
    let Some(id) = args.object else {
        let mut files = loaded.meshes.iter().filter(|file| file.contents.is_some());
        return match (files.next(), files.next()) {
            (Some(only), None) => Ok(only),
            (None, _) => Err(no_file()),
            _ => Err(CliError::Usage(
                "there are several OBJ files: --object ID says whose face or vertex".to_owned(),
            )),
        };
    };
    let object = id
        .checked_sub(1)
        .and_then(|index| loaded.scene.objects().get(index));
    let Some(object) = object else {
        let objects = loaded.scene.objects().len();
        return Err(CliError::Usage(format!(
            "--object: there is no object {id}: ids run from 1 to {objects}; see 'sightline list'"
        )));
    };
    match &object.shape {
        Shape::Mesh { mesh, .. } => MeshFile::of(&loaded.meshes, mesh).ok_or_else(no_file),
        _ => Err(no_file()),
    }
}

fn no_file() -> CliError {
    CliError::Usage("faces and vertices have numbers where an OBJ file is shown".to_owned())
}
