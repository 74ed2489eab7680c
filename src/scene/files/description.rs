//! Scene files: objects with their placements, and a camera, in hand-written TOML.
//!
//! ```toml
//! [camera]                   # every field is optional
//! eye = [3, 2, 4]
//! target = [0, 0, 0]         # or look = [x, y, z], a direction
//! up = [0, 1, 0]
//! fov = 45                   # vertical, in degrees; or ortho = 5, the picture's full height
//! near = 0.1
//! far = 100
//! depth = "reversed"         # or "standard"
//! up_axis = "y"              # or "z"
//! section = "-x:0.5"         # what cuts the world, in the words of [`SectionChoice`](crate::camera::SectionChoice)
//!
//! [[object]]
//! shape = "sphere"           # sphere (radius 0.5), cube (side 1), square (side 1, facing +z) or mesh
//! name = "Ball"
//! colour = "#d95f02"         # or [r, g, b] with sRGB channels from 0 to 1
//! scale = [1, 2, 1]          # or one number; negative mirrors
//! rotation = [0, 45, 0]      # degrees about the world's x axis, then its y axis, then its z axis
//! position = [0, 1, 0]       # scale comes first, then rotation, then position
//! visible = true
//!
//! [[object]]
//! shape = "cube"
//! matrix = [[1, 0.5, 0, 2], [0, 1, 0, 0], [0, 0, 1, 0]]  # the model matrix's upper three rows, in place of those three
//!
//! [[object]]
//! shape = "mesh"
//! file = "bunny.obj"         # relative to this file; all its objects, each under its own name
//! part = 2                   # only the file's second object
//! ```
//!
//! For a mesh, `name` replaces the name of the file's only object, or prefixes the names of several.

use super::{
    DescriptionError, MeshFile, MeshFiles, ObjError, Object, Problem, Progress, SaveError, Scene,
    Warning, entry::Entry,
};
use crate::{camera::CameraChoice, geometry::range, plain};
use serde::{Deserialize, Serialize};
use std::path::Path;
use toml::Spanned;

/// The most characters of the parser's message that are said: it may quote any text.
const MOST_SAID: usize = 300;

/// What a scene file says.
#[derive(Debug)]
pub struct Description {
    /// Its objects, in order.
    pub objects: Vec<Object>,
    /// Its camera; `None` where the file has no `[camera]`.
    pub camera: Option<CameraChoice>,
    /// The line where its camera begins, from 1; 1 without a camera.
    pub camera_line: usize,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct SceneFile {
    camera: Option<Spanned<CameraChoice>>,
    #[serde(default, rename = "object", skip_serializing_if = "Vec::is_empty")]
    objects: Vec<Spanned<Entry>>,
}

/// Reads the text of a scene file. `file` is its path: errors name it, and mesh files are relative to its folder.
///
/// # Errors
/// When it is not a scene file, an object in it is not valid, or a mesh file is refused.
pub fn parse(
    text: &str,
    file: &Path,
    meshes: &mut MeshFiles,
    progress: &Progress,
    warnings: &mut Vec<Warning>,
) -> Result<Description, DescriptionError> {
    let fail = |at: usize, problem| {
        let before = text.get(..at).unwrap_or(text);
        DescriptionError {
            file: file.to_owned(),
            line: 1 + before.matches('\n').count(),
            column: 1 + before.chars().rev().take_while(|c| *c != '\n').count(),
            problem: Box::new(problem),
        }
    };
    let cancelled = |cancelled| fail(0, Problem::Mesh(ObjError::Cancelled(cancelled)));
    // Parsing takes about as long as making the objects.
    let bytes = text.len() as u64;
    progress.expect(2 * bytes);
    let scene: SceneFile = toml::from_str(text).map_err(|error| {
        let at = error.span().map_or(0, |span| span.start);
        let message = error.message().chars().take(MOST_SAID).collect::<String>();
        fail(at, Problem::Syntax(plain::plain(&message)))
    })?;
    progress.advance(bytes).map_err(cancelled)?;
    if let Some(camera) = &scene.camera {
        let checked = check_camera(camera.get_ref());
        checked.map_err(|problem| fail(camera.span().start, problem))?;
    }
    let folder = file.parent().unwrap_or(Path::new(""));
    let mut objects = Vec::new();
    let share = bytes / scene.objects.len().max(1) as u64;
    for entry in &scene.objects {
        let mut load = |path: &Path| meshes.load(path, progress, warnings);
        let made = entry.get_ref().objects(folder, &mut load);
        objects.extend(made.map_err(|problem| fail(entry.span().start, problem))?);
        progress.advance(share).map_err(cancelled)?;
    }
    let camera_at = scene
        .camera
        .as_ref()
        .map_or(0, |camera| camera.span().start);
    Ok(Description {
        objects,
        camera_line: 1 + text[..camera_at].matches('\n').count(),
        camera: scene.camera.map(Spanned::into_inner),
    })
}

fn check_camera(camera: &CameraChoice) -> Result<(), Problem> {
    if camera.target.is_some() && camera.look.is_some() {
        return Err(Problem::Both("target and look"));
    }
    if camera.fov.is_some() && camera.ortho.is_some() {
        return Err(Problem::Both("fov and ortho"));
    }
    let vectors = [camera.eye, camera.target, camera.look, camera.up];
    let numbers = [camera.fov, camera.ortho, camera.near, camera.far];
    let mut vectors = vectors.into_iter().flatten();
    let mut numbers = numbers.into_iter().flatten();
    let are_in_range = vectors.all(|vector| range::stored_vector(vector).is_some())
        && numbers.all(|number| range::stored(number).is_some());
    are_in_range
        .then_some(())
        .ok_or(Problem::OutOfRange("the camera's numbers"))
}

/// A scene as the text of a scene file, which reads back as the same scene to the bit. `meshes` are the files of
/// its meshes, as [`Loaded::meshes`](super::Loaded) has them.
///
/// # Errors
/// When a mesh has no file, or the path of its file is not UTF-8.
pub fn to_toml(
    scene: &Scene,
    camera: &CameraChoice,
    meshes: &[MeshFile],
) -> Result<String, SaveError> {
    let unplaced = |entry| Spanned::new(0..0, entry);
    let meshes = MeshFile::by_mesh(meshes);
    let objects = scene
        .objects()
        .iter()
        .map(|object| Entry::of(object, &meshes).map(unplaced))
        .collect::<Result<_, _>>()?;
    let camera = (*camera != CameraChoice::default()).then(|| Spanned::new(0..0, *camera));
    Ok(toml::to_string(&SceneFile { camera, objects })?)
}
