//! Saves a scene as a scene file, and each mesh that has no file as an OBJ file beside it.

use super::{
    MeshFile, MeshFiles, Progress, SaveError, Scene,
    description::to_toml,
    file::{absolute, holds},
    mesh_files::address,
    obj::write,
};
use crate::{camera::CameraChoice, geometry::Mesh, replace::replace};
use std::{
    fs,
    io::Write,
    path::{Component, Path, PathBuf},
    sync::Arc,
};

/// Writes a scene file that reads back as the same scene to the bit. `meshes` are the files of its meshes, as
/// [`Loaded::meshes`](super::Loaded) has them. Files in the folder of `path` or below it are named relative to that
/// folder, so that the folder can be moved; others by their absolute paths. A mesh without a file, or whose file is
/// gone or holds another mesh by now, is written as an OBJ file beside `path`, under a name that is free. Returns the
/// files of all meshes after saving.
///
/// # Errors
/// When a file cannot be written, or a mesh without a file cannot be written exactly. Then `path` is unchanged.
pub fn save(
    path: &Path,
    scene: &Scene,
    camera: &CameraChoice,
    meshes: &[MeshFile],
) -> Result<Vec<MeshFile>, SaveError> {
    let path = absolute(path);
    let mut made = Made(Vec::new());
    let mut files: Vec<MeshFile> = Vec::new();
    let by_mesh = MeshFile::by_mesh(meshes);
    for mesh in scene.meshes() {
        let known = by_mesh.get(&address(mesh)).copied();
        files.push(match known.and_then(MeshFile::now) {
            Some(file) => file,
            None => write_mesh(&path, known.map(|file| &*file.path), mesh, &mut made)?,
        });
    }
    let folder = path.parent().unwrap_or(Path::new(""));
    let named: Vec<_> = (files.iter())
        .map(|file| MeshFile {
            path: from(folder, &file.path),
            ..file.clone()
        })
        .collect();
    let text = to_toml(scene, camera, &named)?;
    write_file(&path, &text)?;
    made.0.clear();
    Ok(files)
}

/// Mesh files written for a scene file that is not written yet. Dropping this removes them, in case the scene file
/// fails.
struct Made(Vec<PathBuf>);

impl Drop for Made {
    fn drop(&mut self) {
        for file in &self.0 {
            // A file that cannot be removed does no harm.
            let _ = fs::remove_file(file);
        }
    }
}

/// The path by which a scene file in `folder` names a file. For a file in `folder` or below it, also through links, the
/// path is relative, with slashes. Another file keeps its own path; on Unix, any `..` in it is resolved.
fn from(folder: &Path, file: &Path) -> PathBuf {
    let goes_up = |path: &Path| path.components().any(|word| word == Component::ParentDir);
    let below = |folder: &Path, file: &Path| {
        let inside = file.strip_prefix(folder).ok()?;
        (!goes_up(inside)).then(|| inside.to_owned())
    };
    // The file itself may be a link: its own name stays.
    let resolved = || {
        let folder = fs::canonicalize(file.parent()?).ok()?;
        Some(folder.join(file.file_name()?))
    };
    let inside =
        below(folder, file).or_else(|| below(&fs::canonicalize(folder).ok()?, &resolved()?));
    let Some(inside) = inside else {
        return resolved()
            .filter(|_| cfg!(unix) && goes_up(file))
            .unwrap_or_else(|| file.to_owned());
    };
    let words: Option<Vec<_>> = inside.iter().map(|word| word.to_str()).collect();
    words.map_or_else(|| inside.clone(), |words| words.join("/").into())
}

/// The longest file name, in bytes, that common file systems allow.
const LONGEST_NAME: usize = 255;

/// Writes a mesh beside the scene file, and checks that it reads back the same.
fn write_mesh(
    scene_file: &Path,
    was: Option<&Path>,
    mesh: &Arc<Mesh>,
    made: &mut Made,
) -> Result<MeshFile, SaveError> {
    let stem = |path: &Path| Some(path.file_stem()?.to_string_lossy().into_owned());
    let part = mesh.data().parts.first().map(|part| part.name.clone());
    let name = was.and_then(stem).or(part).unwrap_or_default();
    let is_plain = |c: char| c.is_alphanumeric() || "-_".contains(c);
    let mut name = name.replace(|c: char| !is_plain(c), "_");
    let scene = stem(scene_file).unwrap_or_default();
    let rest = scene.len() + "--1000000.obj".len();
    name.truncate(name.floor_char_boundary(LONGEST_NAME.saturating_sub(rest)));
    let not_exact = || SaveError::NotExact(name.clone());
    let colours = write::materials(mesh);
    for number in 1.. {
        let base = match number {
            1 => format!("{scene}-{name}"),
            _ => format!("{scene}-{name}-{number}"),
        };
        let [file, library] =
            ["obj", "mtl"].map(|ending| scene_file.with_file_name(format!("{base}.{ending}")));
        let library_name = colours.as_ref().map(|_| format!("{base}.mtl"));
        let text = write::text(mesh, library_name.as_deref());
        let is_free = |path: &Path, text: &str| !path.exists() || holds(path, text.as_bytes());
        if !is_free(&file, &text) || !colours.as_ref().is_none_or(|text| is_free(&library, text)) {
            continue;
        }
        let library = colours.iter().map(|text| (&library, text));
        for (path, text) in library.chain([(&file, &text)]) {
            if !path.exists() {
                write_file(path, text)?;
                made.0.push(path.clone());
            }
        }
        let mut warnings = Vec::new();
        let mut again = MeshFiles::default();
        let loaded = again.load(&file, &Progress::default(), &mut warnings);
        let loaded = loaded.map_err(|_| not_exact())?;
        let written = MeshFile::of(&again.loaded, &loaded).filter(|_| write::same(mesh, &loaded));
        let written = written.cloned().ok_or_else(not_exact)?;
        return Ok(MeshFile {
            mesh: Arc::clone(mesh),
            ..written
        });
    }
    Err(not_exact())
}

fn write_file(path: &Path, text: &str) -> Result<(), SaveError> {
    let written = replace(path, |out: &mut dyn Write| out.write_all(text.as_bytes()));
    written.map_err(|source| SaveError::Unwritable {
        file: path.to_owned(),
        source,
    })
}
