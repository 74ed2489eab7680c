//! Loads the files that the user names as one scene.

use super::{
    Detail, LoadError, Loaded, MeshFiles, Object, Progress, Scene, Shape, Warning, demo,
    description, file, gallery::Exhibit,
};
use crate::{
    camera::{CameraChoice, SectionChoice},
    geometry::{Mesh, Placement},
};
use std::{
    ops::Range,
    path::{Path, PathBuf},
    sync::Arc,
};

/// The most bytes of a scene file. A saved scene of a million objects takes a quarter of this.
const MOST_BYTES: u64 = 1 << 30;
/// The most bytes of memory that parsing takes for each byte of a scene file, as measured: 48 for blank lines, 66 for
/// short objects.
const PARSED: usize = 70;

/// Loads files as one scene: `.toml` is a scene file, `gallery:NAME` is one of the gallery's, anything else is an OBJ
/// file. Ids run on in the order of `paths`. Without any path, loads the demo.
///
/// # Errors
/// When a file cannot be read or is refused, or the load is cancelled through `progress`.
pub fn load(paths: &[PathBuf], progress: &Progress) -> Result<Loaded, LoadError> {
    load_with(paths, progress, Detail::All)
}

/// [`load`] with a choice of detail.
///
/// # Errors
/// As [`load`].
pub fn load_with(
    paths: &[PathBuf],
    progress: &Progress,
    detail: Detail,
) -> Result<Loaded, LoadError> {
    if paths.is_empty() {
        return demo::demo(progress);
    }
    let mut meshes = MeshFiles::new(detail);
    let mut objects = Vec::new();
    let mut warnings = Vec::new();
    let mut camera = None;
    let mut without_objects = Vec::new();
    for path in paths {
        let (described, file) = if let Some(exhibit) = Exhibit::at(path)? {
            let mut meshes = exhibit.meshes(progress, &mut warnings)?;
            let file = exhibit.file();
            let described =
                description::parse(exhibit.text, &file, &mut meshes, progress, &mut warnings)?;
            (described, file)
        } else if is_scene_file(path) {
            let text = file::text(path, MOST_BYTES)?;
            file::check_memory(path, text.len().saturating_mul(PARSED))?;
            let described = description::parse(&text, path, &mut meshes, progress, &mut warnings)?;
            (described, path.clone())
        } else {
            let mesh = meshes.load(path, progress, &mut warnings)?;
            objects.extend(mesh_objects(&mesh));
            continue;
        };
        if described.objects.is_empty() {
            without_objects.push((path, described.camera.is_some()));
        }
        let own = objects.len()..objects.len() + described.objects.len();
        objects.extend(described.objects);
        let from = (file, described.camera_line);
        camera = camera.or(described.camera.map(|camera| (camera, own, from)));
    }
    let is_empty = objects.is_empty();
    let lacking = (without_objects.into_iter())
        .filter_map(|(path, has_camera)| lacking(path, has_camera, is_empty));
    warnings.extend(lacking);
    let camera = camera.map(|(camera, own, from)| (of_all(camera, &own, objects.len()), from));
    let (camera, camera_from) = camera.unzip();
    Ok(Loaded {
        scene: Scene::new(objects),
        camera: camera.unwrap_or_default(),
        camera_from,
        warnings,
        meshes: meshes.loaded,
        title: title(paths),
        exhibit: match paths {
            [only] => Exhibit::at(only)?,
            _ => None,
        },
    })
}

/// What a scene file without objects lacks. One that has a camera for the objects of other files lacks nothing.
fn lacking(file: &Path, has_camera: bool, scene_is_empty: bool) -> Option<Warning> {
    let message = match (has_camera, scene_is_empty) {
        (true, false) => return None,
        (true, true) => "has no objects, so there is nothing to see: [[object]] begins one",
        (false, _) => "has no objects and no camera: [[object]] begins an object",
    };
    Some(Warning {
        file: file.to_owned(),
        line: None,
        message: message.to_owned(),
    })
}

/// Renumbers a scene file's camera for the whole scene. The section along a face names an object by its id in the file;
/// the file's objects are `own` of the `count` in the scene. An id that the file lacks becomes one that the scene
/// lacks.
fn of_all(camera: CameraChoice, own: &Range<usize>, count: usize) -> CameraChoice {
    let Some(SectionChoice::Face { id, face }) = camera.section else {
        return camera;
    };
    let id = match id {
        1.. if id <= own.len() => own.start + id,
        1.. if id <= count => count + id,
        _ => id,
    };
    CameraChoice {
        section: Some(SectionChoice::Face { id, face }),
        ..camera
    }
}

/// Whether a path names a scene file.
pub(crate) fn is_scene_file(path: &Path) -> bool {
    path.extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case("toml"))
}

/// All parts of a mesh as objects, placed as in the file.
fn mesh_objects(mesh: &Arc<Mesh>) -> impl Iterator<Item = Object> {
    (0..).zip(&mesh.data().parts).map(|(part, in_file)| {
        let mesh = Arc::clone(mesh);
        let shape = Shape::Mesh { mesh, part };
        Object::new(in_file.name.as_str(), shape, Placement::IDENTITY)
    })
}

/// The title of a scene of these files.
pub(crate) fn title(paths: &[PathBuf]) -> String {
    let name = |path: &PathBuf| {
        let name = path.file_name().unwrap_or(path.as_os_str());
        name.to_string_lossy().into_owned()
    };
    match paths {
        [] => String::new(),
        [only] => name(only),
        [first, others @ ..] => format!("{} and {} more", name(first), others.len()),
    }
}
