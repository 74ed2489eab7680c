//! Loads the files that the user names as one scene.

use super::{
    Cancelled, DescriptionError, FileError, ObjError, Object, Problem, Progress, Scene, Shape,
    Warning, demo, description, file,
    gallery::{self, Exhibit},
    obj,
};
use crate::{
    camera::{CameraChoice, SectionChoice},
    geometry::{Mesh, Placement},
};
use std::{
    io::Read,
    ops::Range,
    path::{Path, PathBuf},
    sync::Arc,
};

/// The most bytes of a scene file. A saved scene of a million objects takes a quarter of this.
const MOST_BYTES: u64 = 1 << 30;

/// A scene and what was loaded with it; empty by default.
#[derive(Debug, Default)]
pub struct Loaded {
    /// The objects of all files, in the order of the files.
    pub scene: Scene,
    /// The camera of the first scene file that has one; empty if none has.
    pub camera: CameraChoice,
    /// The scene file that the camera is from.
    pub camera_file: Option<PathBuf>,
    /// What was left out or mended.
    pub warnings: Vec<Warning>,
    /// The meshes' files, by their absolute paths: what saving the scene needs.
    pub meshes: Vec<MeshFile>,
    /// The MTL files that the meshes' files name, by their absolute paths, including missing ones.
    pub materials: Vec<PathBuf>,
    /// A name for the scene, for the window's title.
    pub title: String,
    /// The gallery scene, if it is the only thing loaded.
    pub exhibit: Option<&'static Exhibit>,
}

/// Why there is no scene. One line that names the file.
#[derive(Debug, thiserror::Error)]
pub enum LoadError {
    /// The load was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// A scene file could not be read.
    #[error(transparent)]
    File(#[from] FileError),
    /// A scene file was refused.
    #[error(transparent)]
    Scene(DescriptionError),
    /// The gallery has no scene of that name.
    #[error(
        "no \u{201c}{name}\u{201d} in the gallery: there are {}",
        gallery::names()
    )]
    NoExhibit {
        /// What was asked for.
        name: String,
    },
    /// A mesh file was refused.
    #[error(transparent)]
    Obj(ObjError),
}

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
    let mut meshes = MeshFiles {
        detail,
        ..MeshFiles::default()
    };
    let mut objects = Vec::new();
    let mut warnings = Vec::new();
    let mut camera = None;
    for path in paths {
        let (described, file) = if let Some(exhibit) = Exhibit::at(path)? {
            let mut meshes = exhibit.meshes(progress, &mut warnings)?;
            let file = exhibit.file();
            let described =
                description::parse(exhibit.text, &file, &mut meshes, progress, &mut warnings)?;
            (described, file)
        } else if is_scene_file(path) {
            let text = text(path)?;
            let described = description::parse(&text, path, &mut meshes, progress, &mut warnings)?;
            (described, path.clone())
        } else {
            let mesh = meshes.load(path, progress, &mut warnings)?;
            objects.extend(mesh_objects(&mesh));
            continue;
        };
        let own = objects.len()..objects.len() + described.objects.len();
        objects.extend(described.objects);
        camera = camera.or(described.camera.map(|camera| (camera, own, file)));
    }
    let camera = camera.map(|(camera, own, file)| (of_all(camera, &own, objects.len()), file));
    let (camera, camera_file) = camera.unzip();
    Ok(Loaded {
        scene: Scene::new(objects),
        camera: camera.unwrap_or_default(),
        camera_file,
        warnings,
        meshes: meshes.loaded,
        materials: meshes.materials,
        title: title(paths),
        exhibit: match paths {
            [only] => Exhibit::at(only)?,
            _ => None,
        },
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

/// The text of a scene file.
fn text(path: &Path) -> Result<String, FileError> {
    let (mut file, _) = file::open(path, MOST_BYTES)?;
    let mut text = String::new();
    file.read_to_string(&mut text)
        .map_err(|source| FileError::Unreadable {
            file: path.to_owned(),
            source,
        })?;
    Ok(text)
}

/// A mesh and its file.
#[derive(Clone, Debug)]
pub struct MeshFile {
    /// Absolute.
    pub path: PathBuf,
    /// The mesh.
    pub mesh: Arc<Mesh>,
    /// The positions of its faces and vertices in the file; `None` where there is no such file.
    pub contents: Option<Arc<obj::Contents>>,
}

impl MeshFile {
    /// The file of a mesh, among `files`.
    #[must_use]
    pub fn of<'a>(files: &'a [Self], mesh: &Arc<Mesh>) -> Option<&'a Self> {
        files.iter().find(|file| Arc::ptr_eq(&file.mesh, mesh))
    }
}

/// Mesh files by their absolute paths; each is loaded once.
#[derive(Debug, Default)]
pub struct MeshFiles {
    loaded: Vec<MeshFile>,
    /// The MTL files that they name.
    materials: Vec<PathBuf>,
    detail: Detail,
}

/// How much of a mesh file is loaded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Detail {
    /// All that the file holds.
    #[default]
    All,
    /// Also the normals that the file lacks, computed now so that drawing need not wait for them.
    Drawn,
    /// No material colours: MTL files are not read, and there are no warnings about them.
    Shapes,
}

impl MeshFiles {
    /// Uses `mesh` as the mesh of a file. The file is then not read.
    pub(super) fn insert(&mut self, path: &Path, mesh: Arc<Mesh>) {
        self.loaded.push(MeshFile {
            path: absolute(path),
            mesh,
            contents: None,
        });
    }

    /// The files that were loaded.
    pub(super) fn files(&self) -> &[MeshFile] {
        &self.loaded
    }

    /// The mesh of a file.
    ///
    /// # Errors
    /// As [`obj::load`].
    pub fn load(
        &mut self,
        as_named: &Path,
        progress: &Progress,
        warnings: &mut Vec<Warning>,
    ) -> Result<Arc<Mesh>, ObjError> {
        let path = absolute(as_named);
        if let Some(known) = self.loaded.iter().find(|known| known.path == path) {
            return Ok(Arc::clone(&known.mesh));
        }
        let file = obj::load_with(as_named, progress, self.detail)?;
        warnings.extend(file.warnings);
        self.materials.extend(file.materials);
        self.loaded.push(MeshFile {
            path,
            mesh: Arc::clone(&file.mesh),
            contents: Some(Arc::new(file.contents)),
        });
        Ok(file.mesh)
    }
}

/// The path as an absolute one.
pub(super) fn absolute(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
}

/// All parts of a mesh as objects, placed as in the file.
fn mesh_objects(mesh: &Arc<Mesh>) -> impl Iterator<Item = Object> {
    (0..).zip(&mesh.data().parts).map(|(part, in_file)| {
        let mesh = Arc::clone(mesh);
        Object::new(
            in_file.name.as_str(),
            Shape::Mesh { mesh, part },
            Placement::IDENTITY,
        )
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

impl From<ObjError> for LoadError {
    fn from(error: ObjError) -> Self {
        match error {
            ObjError::Cancelled(cancelled) => Self::Cancelled(cancelled),
            error => Self::Obj(error),
        }
    }
}

impl From<DescriptionError> for LoadError {
    fn from(error: DescriptionError) -> Self {
        match *error.problem {
            Problem::Mesh(ObjError::Cancelled(cancelled)) => Self::Cancelled(cancelled),
            _ => Self::Scene(error),
        }
    }
}
