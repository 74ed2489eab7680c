//! OBJ and MTL files: `tobj` reads the numbers, this module decides what they mean.
//!
//! A file is read in pieces (`pieces`), on all cores. The lines (`lines`, `words`) of each are washed and made a file by
//! themselves (`wash`, `places`), of which `tobj` makes vertices and faces (`block`); what their other lines say
//! (`outline`, `names`) is put in order. Then vertices are narrowed (`vertices`), polygons become triangles (`polygon`,
//! `delaunay`), colours come from the MTL files (`material`), and `build` puts the mesh together. What the file writes of a
//! face (`in_file`) is not kept: it is read again (`again`), at the place where the file has it (`contents`). The rules:
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

mod again;
mod block;
mod build;
mod contents;
mod corners;
mod delaunay;
mod in_file;
mod lines;
mod material;
mod names;
mod notes;
mod outline;
mod pieces;
mod places;
mod polygon;
#[cfg(test)]
mod tests;
mod vertices;
mod wash;
mod words;
pub(super) mod write;

use super::{Cancelled, Detail, FileError, Progress, Warning, file};
use crate::geometry::{Mesh, MeshError, shares::on_all_cores};
pub use crate::scene::in_file::{FaceInFile, InFile, VertexInFile};
pub use again::Again;
use block::Block;
pub use contents::Contents;
use contents::Stamp;
pub use in_file::AgainError;
use lines::{decode, is_utf16};
use outline::Outline;
use pieces::Pieces;
use std::{
    io::{self, BufRead, BufReader, Cursor, Read},
    path::{Path, PathBuf},
    sync::{
        Arc,
        atomic::{AtomicU64, Ordering::Relaxed},
    },
    time::Instant,
};

/// A larger file is refused: its triangles could be more than 32 bits count.
const MOST_BYTES: u64 = 1 << 32;
/// `tobj` gets files by about so many bytes: enough that few faces name vertices of other pieces, and so few that what
/// it makes of them stays in the processor's cache.
const PIECE: usize = 1 << 18;

/// What an OBJ file holds.
#[derive(Debug)]
pub struct ObjFile {
    /// All its objects as the parts of one mesh.
    pub mesh: Arc<Mesh>,
    /// What was left out or mended.
    pub warnings: Vec<Warning>,
    /// The MTL files that it names, by their absolute paths, also those that are not there.
    pub materials: Vec<PathBuf>,
    /// Where its faces and vertices stand.
    pub contents: Contents,
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
}

impl Stop {
    fn at(self, path: &Path) -> ObjError {
        match self {
            Self::Cancelled(cancelled) => cancelled.into(),
            Self::Unreadable(source) => ObjError::File(FileError::Unreadable {
                file: path.to_owned(),
                source,
            }),
        }
    }
}

/// Loads an OBJ file and the MTL files it names.
///
/// # Errors
/// When it cannot be read or holds nothing to show; see [`ObjError`]. What else is wrong with it or with its MTL files
/// is a warning.
pub fn load(path: &Path, progress: &Progress) -> Result<ObjFile, ObjError> {
    load_with(path, progress, Detail::All)
}

/// Loads what somebody wants of an OBJ file.
pub(super) fn load_with(
    path: &Path,
    progress: &Progress,
    detail: Detail,
) -> Result<ObjFile, ObjError> {
    let stamp = Stamp::of(path).ok();
    let mut file = read(path, progress, (PIECE, detail), || open(path))?;
    file.contents.stamp = stamp;
    Ok(file)
}

/// [`load`] from the bytes of a file in memory; errors name it by `path`.
pub(crate) fn from_bytes(
    bytes: &(impl AsRef<[u8]> + Clone + Send),
    path: &Path,
    progress: &Progress,
) -> Result<ObjFile, ObjError> {
    let size = bytes.as_ref().len() as u64;
    read(path, progress, (PIECE, Detail::All), || {
        Ok((Cursor::new(bytes.clone()), size))
    })
}

/// Reads in pieces of about so many bytes.
fn read<R: BufRead + Send>(
    path: &Path,
    progress: &Progress,
    (piece, detail): (usize, Detail),
    open: impl Fn() -> Result<(R, u64), ObjError>,
) -> Result<ObjFile, ObjError> {
    let start = Instant::now();
    let mut known = None;
    let (blocks, outline, looks_like, bytes) = loop {
        let (mut input, bytes) = open()?;
        // Putting the mesh together, and normals, take about a quarter as long as reading, each; once.
        let more = if detail == Detail::Drawn { 2 } else { 1 };
        progress.expect(bytes + known.map_or(more * (bytes / 4), |_| 0));
        let looks_like = looks_like(&mut input);
        if let Some(Look::Archive(looks_like)) = looks_like {
            return Err(ObjError::NotObj {
                file: path.to_owned(),
                looks_like,
            });
        }
        let (blocks, outline) = decode(input)
            .map_err(Stop::Unreadable)
            .and_then(|input| read_pieces(Pieces::new(input, piece, progress), known))
            .map_err(|stop| stop.at(path))?;
        // Only the end of a file tells which vertices there are. Where faces name others, it is read again.
        if outline.highest_vertex <= outline.vertices {
            break (blocks, outline, looks_like, bytes / 4);
        }
        known = Some(outline.vertices);
    };
    let (read, start) = (start.elapsed(), Instant::now());
    let built = build::build(path, blocks, outline, detail, (progress, bytes));
    let built = built.map_err(|error| match (error, looks_like) {
        (
            ObjError::NotObj { file, .. }
            | ObjError::NoFaces { file, .. }
            | ObjError::BadLine { file, .. },
            Some(Look::Other(looks_like)),
        ) => ObjError::NotObj { file, looks_like },
        (error, _) => error,
    })?;
    if detail == Detail::Drawn {
        compute_normals(&built.mesh, progress, bytes)?;
    }
    log::info!(
        "read {} in {read:.1?}, built in {:.1?}",
        path.display(),
        start.elapsed()
    );
    Ok(built)
}

/// Computes the normals that a mesh has not. That counts for so many bytes.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    reason = "a share of the bytes"
)]
fn compute_normals(mesh: &Mesh, progress: &Progress, bytes: u64) -> Result<(), Cancelled> {
    let left = AtomicU64::new(bytes);
    mesh.normals_while(|share| {
        let done = (share * bytes as f64) as u64;
        left.fetch_sub(done, Relaxed);
        progress.advance(done)
    })?;
    progress.advance(left.into_inner())
}

/// What `tobj` makes of the pieces of a file, on all cores, and what it did not see.
fn read_pieces(pieces: Pieces, known: Option<usize>) -> Result<(Vec<Block>, Outline), Stop> {
    let read = on_all_cores(pieces, |piece| {
        let block = Block::read(piece?, known);
        block.map_err(|error| Stop::Unreadable(io::Error::other(error)))
    });
    let mut blocks = Vec::with_capacity(read.len());
    let mut outline = Outline::default();
    for piece in read {
        let (block, next) = piece?;
        blocks.push(block);
        outline.append(next);
    }
    Ok((blocks, outline))
}

/// The file, when it is one and not empty, and its size. What is added to it later is not read: that may be without end.
fn open(path: &Path) -> Result<(impl BufRead + Send + use<>, u64), ObjError> {
    match file::open(path, MOST_BYTES)? {
        (_, 0) => Err(ObjError::Empty {
            file: path.to_owned(),
        }),
        (opened, bytes) => Ok((BufReader::new(opened).take(bytes), bytes)),
    }
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
