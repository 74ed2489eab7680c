//! OBJ and MTL files: `tobj` reads the numbers, this module decides what they mean.
//!
//! Lines reach `tobj` washed (`source`); polygons become triangles (`polygon`); colours come from the MTL files
//! (`material`); `build` puts the mesh together. The rules:
//!
//! - **Objects.** Each `o` line begins an object, even one of the same name as the last; so does each `g` line that
//!   changes the group. Materials never do. An object whose faces all lie in one group has the name that `o` gives,
//!   else `object/group`; a group outside any object has its own name; what has no name at all has the file's.
//!   Objects without faces are dropped.
//! - **Vertices** are one where the file has one, across objects and materials; those that no face uses are left out.
//! - **Normals** are the file's on faces that have a usable one at each corner; others are computed from a crease angle.
//! - **Colours** are `Kd`, as sRGB. Textures and transparency are not shown, which a warning says once.

mod build;
mod material;
mod notes;
mod outline;
mod polygon;
mod source;

use super::{Cancelled, Progress, Warning};
use crate::geometry::{Mesh, MeshError};
use source::{Source, Stop};
use std::{
    fs::File,
    io::{BufRead, BufReader, Read},
    path::{Path, PathBuf},
    sync::Arc,
    time::Instant,
};

/// What an OBJ file holds.
#[derive(Debug)]
pub struct ObjFile {
    /// All its objects as the parts of one mesh.
    pub mesh: Arc<Mesh>,
    /// What was left out or mended.
    pub warnings: Vec<Warning>,
}

/// Why a file was refused.
#[derive(Debug, thiserror::Error)]
pub enum ObjError {
    /// Somebody asked to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// It cannot be opened or read.
    #[error("{}: cannot be read: {source}", file.display())]
    Unreadable {
        /// The file.
        file: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// A directory, a device, a pipe.
    #[error("{}: is not a file", file.display())]
    NotAFile {
        /// The file.
        file: PathBuf,
    },
    /// Zero bytes.
    #[error("{}: the file is empty", file.display())]
    Empty {
        /// The file.
        file: PathBuf,
    },
    /// Neither a vertex nor a face in it.
    #[error("{}: not an OBJ file: {looks_like}", file.display())]
    NotObj {
        /// The file.
        file: PathBuf,
        /// What it seems to be.
        looks_like: &'static str,
    },
    /// Points or lines at most.
    #[error("{}: no faces to show ({holds})", file.display())]
    NoFaces {
        /// The file.
        file: PathBuf,
        /// What there is, with counts.
        holds: String,
    },
    /// A line that breaks the format.
    #[error("{}:{line}: {problem}", file.display())]
    BadLine {
        /// The file.
        file: PathBuf,
        /// The line in it, from 1.
        line: usize,
        /// What is wrong with it.
        problem: &'static str,
    },
    /// A face with a corner that is not there.
    #[error("{}:{line}: a face names vertex {vertex} of {vertices}", file.display())]
    NoSuchVertex {
        /// The file.
        file: PathBuf,
        /// The line in it, from 1.
        line: usize,
        /// The vertex as the face names it.
        vertex: String,
        /// How many vertices there are; for a relative index, before the line.
        vertices: usize,
    },
    /// The extent does not fit in single precision.
    #[error("{}: its coordinates lie too far apart to show ({extent:e} units)", file.display())]
    TooLarge {
        /// The file.
        file: PathBuf,
        /// The longest side of its box, in the file's units.
        extent: f64,
    },
    /// What was read is no mesh.
    #[error("{}: {source}", file.display())]
    NoMesh {
        /// The file.
        file: PathBuf,
        /// Why not.
        source: MeshError,
    },
}

/// Loads an OBJ file and the MTL files it names.
///
/// # Errors
/// When it cannot be read, breaks the format or holds nothing to show; see [`ObjError`]. Missing or broken MTL files
/// are warnings.
pub fn load(path: &Path, progress: &Progress) -> Result<ObjFile, ObjError> {
    let start = Instant::now();
    let mut input = open(path, progress)?;
    let looks_like = looks_like(&mut input);
    let mut source = Source::new(input, progress, false);
    let mut parsed = tobj::load_obj_buf(&mut source, &tobj::LoadOptions::default(), no_materials);
    if matches!(source.stop, Some(Stop::ColoursComeLate)) {
        source = Source::new(open(path, progress)?, progress, true);
        parsed = tobj::load_obj_buf(&mut source, &tobj::LoadOptions::default(), no_materials);
    }
    let file = || path.to_owned();
    match source.stop {
        Some(Stop::Cancelled(cancelled)) => return Err(cancelled.into()),
        Some(Stop::Unreadable(source)) => {
            let file = file();
            return Err(ObjError::Unreadable { file, source });
        }
        Some(Stop::NoSuchVertex(vertex)) => {
            return Err(ObjError::NoSuchVertex {
                file: file(),
                line: source.line_number,
                vertex,
                vertices: source.outline.vertices,
            });
        }
        Some(Stop::ColoursComeLate) | None => {}
    }
    let outline = source.outline;
    if let Some((vertex, line)) = outline.highest_vertex
        && vertex > outline.vertices
    {
        return Err(ObjError::NoSuchVertex {
            file: file(),
            line,
            vertex: vertex.to_string(),
            vertices: outline.vertices,
        });
    }
    let (models, _) = parsed.map_err(|error| ObjError::BadLine {
        file: file(),
        line: source.line_number,
        problem: problem(error),
    })?;
    if outline.vertices == 0 && outline.faces() == 0 {
        let file = file();
        return Err(ObjError::NotObj { file, looks_like });
    }
    let (read, start) = (start.elapsed(), Instant::now());
    let built = build::build(path, models, &outline);
    log::info!(
        "read {} in {read:.1?}, built in {:.1?}",
        path.display(),
        start.elapsed()
    );
    built
}

/// The file, when it is one and not empty; tells `progress` of its bytes.
fn open(path: &Path, progress: &Progress) -> Result<BufReader<File>, ObjError> {
    let file = path.to_owned();
    let opened = std::fs::metadata(path).and_then(|about| Ok((File::open(path)?, about)));
    match opened {
        Err(source) => Err(ObjError::Unreadable { file, source }),
        Ok((_, about)) if !about.is_file() => Err(ObjError::NotAFile { file }),
        Ok((_, about)) if about.len() == 0 => Err(ObjError::Empty { file }),
        Ok((opened, about)) => {
            progress.expect(about.len());
            Ok(BufReader::with_capacity(1 << 16, opened))
        }
    }
}

/// What a file that turns out to be no OBJ seems to be, by its first bytes.
fn looks_like(input: &mut impl BufRead) -> &'static str {
    let start = input.fill_buf().unwrap_or_default();
    let text = start.trim_ascii_start();
    if text.starts_with(b"version https://git-lfs") {
        "a Git LFS pointer (git lfs pull fetches the file itself)"
    } else if start.starts_with(&[0x1f, 0x8b]) {
        "gzip data"
    } else if start.starts_with(&[0xff, 0xfe]) || start.starts_with(&[0xfe, 0xff]) {
        "UTF-16 text"
    } else if text.first() == Some(&b'<') {
        "HTML or XML"
    } else if start.contains(&0) {
        "binary data"
    } else {
        "no vertices and no faces"
    }
}

/// `tobj` never sees an `mtllib` line.
fn no_materials(_: &Path) -> tobj::MTLLoadResult {
    Err(tobj::LoadError::GenericFailure)
}

fn problem(error: tobj::LoadError) -> &'static str {
    match error {
        tobj::LoadError::PositionParseError => "a vertex needs three numbers",
        tobj::LoadError::NormalParseError => "a normal needs three numbers",
        tobj::LoadError::FaceParseError => "a corner of a face is written as 1, 1/2, 1//3 or 1/2/3",
        _ => "the line cannot be read",
    }
}

/// The line of the first vertex with a coordinate that is not a finite number.
fn line_of_endless_vertex(path: &Path) -> Option<usize> {
    let mut bytes = Vec::new();
    File::open(path).ok()?.read_to_end(&mut bytes).ok()?;
    let mut lines = (1..).zip(bytes.split(|&b| b == b'\n'));
    let endless = lines.find(|(_, line)| {
        let mut fields = source::fields(line).map(|at| &line[at]);
        fields.next() == Some(b"v")
            && (fields.take(3))
                .filter_map(source::number)
                .any(|c| !c.is_finite())
    });
    Some(endless?.0)
}
