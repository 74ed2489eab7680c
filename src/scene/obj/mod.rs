//! OBJ and MTL files: `tobj` reads the numbers, this module decides what they mean.
//!
//! Lines (`lines`) reach `tobj` washed (`wash`); polygons become triangles (`polygon`, `delaunay`); colours come from the MTL files
//! (`material`); `build` puts the mesh together. The rules:
//!
//! - **What is valid loads.** A face that names a vertex which is not there, or one without three finite coordinates, is
//!   left out, which a warning says with the first such line. A file is refused when no triangle is left.
//! - **Objects.** Each `o` line begins an object, even one of the same name as the last; so does each `g` line that
//!   changes the group. Materials never do. An object whose faces all lie in one group has the name that `o` gives,
//!   else `object/group`; a group outside any object has its own name; what has no name at all has the file's.
//!   Objects without faces are dropped.
//! - **Vertices** are one where the file has one, across objects and materials; those that no face uses are left out.
//! - **Normals** are the file's on faces that have a usable one at each corner; others are computed from a crease angle.
//! - **Colours** are `Kd`, as sRGB. Textures and transparency are not shown, which a warning says once.

mod build;
mod delaunay;
mod lines;
mod material;
mod notes;
mod outline;
mod polygon;
mod wash;
pub(super) mod write;

use super::{Cancelled, FileError, Progress, Warning, file};
use crate::geometry::{Mesh, MeshError};
use lines::{Blocks, Lines, decode, is_utf16};
use outline::Outline;
use std::{
    fs::File,
    io::{self, BufRead, BufReader, Cursor},
    panic::resume_unwind,
    path::{Path, PathBuf},
    sync::{Arc, mpsc::sync_channel},
    thread,
    time::Instant,
};
use wash::{Foresight, Washer};

/// A larger file is refused: its triangles could be more than 32 bits count.
const MOST_BYTES: u64 = 1 << 32;
/// Files are read, and washed lines handed on, by this many bytes.
const BLOCK: usize = 1 << 16;
/// How many blocks of washed lines may wait for `tobj`.
const BLOCKS: usize = 8;

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
    /// It cannot be read.
    #[error(transparent)]
    File(#[from] FileError),
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
    /// Nothing to show, and a line that breaks the format.
    #[error("{}:{line}: {what}", file.display())]
    BadLine {
        /// The file.
        file: PathBuf,
        /// The first such line in it, from 1.
        line: usize,
        /// What is wrong with it.
        what: BadLine,
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

/// What is wrong with a line of an OBJ file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum BadLine {
    /// A vertex of less than three coordinates, or with a word among them.
    #[error("a vertex needs three numbers")]
    Vertex,
    /// A vertex that is nowhere.
    #[error("a coordinate is not a finite number")]
    NotFinite,
    /// A normal of less than three coordinates, or with a word among them.
    #[error("a normal needs three numbers")]
    Normal,
    /// A corner of another form.
    #[error("a corner of a face is written as 1, 1/2, 1//3 or 1/2/3")]
    Corner,
    /// A corner that is not there.
    #[error("a face names vertex {vertex} of {vertices}")]
    NoSuchVertex {
        /// The vertex as the face names it.
        vertex: String,
        /// How many vertices there are; for a relative index, before the line.
        vertices: usize,
    },
}

/// Why the lines of a file ended early.
enum Stop {
    /// Somebody asked to.
    Cancelled(Cancelled),
    /// The system says so.
    Unreadable(io::Error),
    /// A vertex has a colour after others that have none.
    ColoursComeLate,
}

/// Loads an OBJ file and the MTL files it names.
///
/// # Errors
/// When it cannot be read or holds nothing to show; see [`ObjError`]. What else is wrong with it or with its MTL files
/// is a warning.
pub fn load(path: &Path, progress: &Progress) -> Result<ObjFile, ObjError> {
    read(path, progress, || open(path))
}

/// [`load`] from the bytes of a file in memory; errors name it by `path`.
pub(crate) fn from_bytes(
    bytes: &(impl AsRef<[u8]> + Clone + Send + 'static),
    path: &Path,
    progress: &Progress,
) -> Result<ObjFile, ObjError> {
    let size = bytes.as_ref().len() as u64;
    read(path, progress, || Ok((Cursor::new(bytes.clone()), size)))
}

fn read<R: BufRead + Send + 'static>(
    path: &Path,
    progress: &Progress,
    open: impl Fn() -> Result<(R, u64), ObjError>,
) -> Result<ObjFile, ObjError> {
    let start = Instant::now();
    let unreadable = |source| FileError::Unreadable {
        file: path.to_owned(),
        source,
    };
    let mut foresight = Foresight::default();
    let (parsed, outline, looks_like, bytes) = loop {
        let (mut input, bytes) = open()?;
        // Putting the mesh together takes about half as long as reading.
        progress.expect(bytes + bytes / 2);
        let looks_like = looks_like(&mut input);
        if let Some(Look::Archive(looks_like)) = looks_like {
            return Err(ObjError::NotObj {
                file: path.to_owned(),
                looks_like,
            });
        }
        let lines = Lines::new(decode(input).map_err(unreadable)?, progress);
        let (parsed, outline, stop) = parse(Washer::new(lines, foresight));
        match stop {
            Some(Stop::Cancelled(cancelled)) => return Err(cancelled.into()),
            Some(Stop::Unreadable(source)) => return Err(unreadable(source).into()),
            Some(Stop::ColoursComeLate) => foresight.coloured = true,
            None if outline.highest_vertex > outline.vertices => {
                foresight.vertices = Some(outline.vertices);
            }
            None => break (parsed, outline, looks_like, bytes),
        }
    };
    progress.advance(bytes / 4)?;
    let (models, _) = parsed.map_err(|error| unreadable(io::Error::other(error)))?;
    let (read, start) = (start.elapsed(), Instant::now());
    let built = build::build(path, models, &outline, progress);
    let built = built.map_err(|error| match (error, looks_like) {
        (
            ObjError::NotObj { file, .. }
            | ObjError::NoFaces { file, .. }
            | ObjError::BadLine { file, .. },
            Some(Look::Other(looks_like)),
        ) => ObjError::NotObj { file, looks_like },
        (error, _) => error,
    })?;
    progress.advance(bytes.div_ceil(4))?;
    log::info!(
        "read {} in {read:.1?}, built in {:.1?}",
        path.display(),
        start.elapsed()
    );
    Ok(built)
}

/// The file, when it is one and not empty, and its size.
fn open(path: &Path) -> Result<(BufReader<File>, u64), ObjError> {
    match file::open(path, MOST_BYTES)? {
        (_, 0) => Err(ObjError::Empty {
            file: path.to_owned(),
        }),
        (opened, bytes) => Ok((BufReader::with_capacity(BLOCK, opened), bytes)),
    }
}

/// Lets `tobj` read what is washed on a thread beside it. What it makes of that, what it did not see, and why the
/// lines ended early.
fn parse(mut washer: Washer) -> (tobj::LoadResult, Outline, Option<Stop>) {
    let (sender, receiver) = sync_channel(BLOCKS);
    thread::scope(|scope| {
        let washing = scope.spawn(move || {
            let stop = loop {
                match washer.block() {
                    Ok(block) => {
                        if block.is_empty() || sender.send(Some(block)).is_err() {
                            break None;
                        }
                    }
                    Err(stop) => {
                        // If nobody takes it, nobody needs to know.
                        let _ = sender.send(None);
                        break Some(stop);
                    }
                }
            };
            (washer.outline, stop)
        });
        let mut blocks = Blocks::new(receiver);
        let parsed = tobj::load_obj_buf(&mut blocks, &tobj::LoadOptions::default(), no_materials);
        drop(blocks);
        let (outline, stop) = washing.join().unwrap_or_else(|panic| resume_unwind(panic));
        (parsed, outline, stop)
    })
}

/// What a file is by its first bytes, if not an OBJ.
#[derive(Clone, Copy)]
enum Look {
    /// Files in one file. They may lie in it as they are, and would be read as if they were all of it.
    Archive(&'static str),
    /// What counts only where nothing is found to show.
    Other(&'static str),
}

fn looks_like(input: &mut impl BufRead) -> Option<Look> {
    let start = input.fill_buf().unwrap_or_default();
    let text = start.trim_ascii_start();
    if start.starts_with(b"PK\x03\x04") {
        Some(Look::Archive("a zip archive (unpack it first)"))
    } else if start.get(257..262) == Some(b"ustar") {
        Some(Look::Archive("a tar archive (unpack it first)"))
    } else if start.starts_with(&[0x1f, 0x8b]) {
        Some(Look::Archive("gzip data (unpack it first)"))
    } else if text.starts_with(b"version https://git-lfs") {
        Some(Look::Other(
            "a Git LFS pointer (git lfs pull fetches the file itself)",
        ))
    } else if text.first() == Some(&b'<') {
        Some(Look::Other("HTML or XML"))
    } else if start.contains(&0) && !is_utf16(start) {
        Some(Look::Other("binary data"))
    } else {
        None
    }
}

/// `tobj` never sees an `mtllib` line.
fn no_materials(_: &Path) -> tobj::MTLLoadResult {
    Err(tobj::LoadError::GenericFailure)
}
