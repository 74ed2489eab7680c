//! Loads OBJ files, and the MTL files that they name, into meshes; also writes meshes as OBJ and MTL files.
//!
//! How a file flows:
//!
//!  1. `pieces` cuts the file into pieces of whole lines, about 256 KiB each, which are read on all cores.
//!  2. `text_lines` finds the lines of a piece: any line ends, lines that a backslash continues, UTF-16.
//!  3. `keyword` says what a line is about; `words` splits it.
//!  4. `coordinates` gives lines of vertices and normals to `tobj` as they are, which reads their numbers.
//!  5. `corners` reads the corners of faces. What they count back becomes a number once the pieces before are known
//!     (`named`).
//!  6. `block` holds a piece's vertices and faces, each face with its line; `survey` names, counts and bad lines.
//!  7. `names` finds objects, uses of materials and smoothing groups. `material` reads the MTL files that `library`
//!     finds; `material_name` compares the names of both.
//!  8. `vertices` stores the vertices that faces use as `f32`; `channels` scales colours from 0 to 255.
//!  9. `triangulation` splits polygons by earcut, except those that `tangled` finds.
//! 10. `assembling` makes the mesh; `notes` says what was left out, and `contents` keeps the line of each triangle.
//!
//! A digit is read twice: by a look for the end of its line, which also tells whether it is a plain line of numbers,
//! and then as a part of its number, by `tobj` for vertices and normals. Only a piece with a vertex or a normal that
//! cannot be read is gone through once more; a line with more than numbers is copied without the rest.
//!
//! The text of the faces is not kept. It is read again when it is needed (`again`, `in_file`). `write` writes a mesh as
//! OBJ and MTL text. The rules of loading:
//!
//! - **What is valid loads.** A face is left out if one of its vertices does not exist or has no three finite
//!   coordinates. Warnings say so and name the first bad line. A file is refused when no triangle is left, or at the
//!   first line of 256 KiB or more with a NUL in it: a hole in a file reads as one line of NULs.
//! - **Objects.** Each `o` line begins an object, even if the name is the same as before. Each `g` line that changes
//!   the group begins one, too. A material never does. An object is named after its `o` line if all its faces lie in
//!   one group, else `object/group`. A group outside any object has the group's name. Faces without any name are named
//!   after the file. Objects without faces are dropped.
//! - **Vertices** are shared across objects and materials, as in the file. Vertices that no face uses are left out.
//! - **Normals** come from the file on faces that have a usable normal at each corner. The others are computed: smooth
//!   within a smoothing group, else by a crease angle.
//! - **Colours** are `Kd`, as sRGB, times those of vertices. Textures and transparency are not shown; one warning each
//!   says so.

mod again;
mod assembling;
mod block;
mod channels;
mod contents;
mod coordinates;
mod corners;
mod counts;
mod in_file;
mod keyword;
mod library;
mod material;
mod material_name;
mod named;
mod names;
mod notes;
mod pieces;
mod survey;
mod tangled;
#[cfg(test)]
mod tests;
mod text_lines;
mod triangulation;
mod vertices;
mod words;
pub(super) mod write;

use super::{Cancelled, Detail, FileError, Progress, Stamp, Warning, file};
use crate::geometry::{Mesh, MeshError, shares::on_all_cores};
pub use crate::scene::in_file::{FaceInFile, InFile, VertexInFile};
pub use again::Again;
use block::Block;
pub use contents::Contents;
pub use in_file::AgainError;
use pieces::Pieces;
use std::{
    io::{self, BufRead, BufReader, Cursor, Read},
    path::{Path, PathBuf},
    sync::Arc,
    time::Instant,
};
use survey::Survey;
use text_lines::{decode, is_utf16};

/// A larger file is refused: it could have more triangles than a 32-bit index can count.
const MOST_BYTES: u64 = 1 << 32;
/// The bytes of memory that are asked for before reading, for each byte of a file. Scans take 1.5, as measured; a file
/// of the shortest lines 4.
const READ: usize = 2;
/// The approximate size of a piece in bytes. It is large enough that few faces name vertices of other pieces, and small
/// enough that the output of `tobj` stays in the processor's cache.
const PIECE: usize = 1 << 18;

/// A loaded OBJ file.
#[derive(Debug)]
pub struct ObjFile {
    /// All its objects as the parts of one mesh.
    pub mesh: Arc<Mesh>,
    /// What was left out or repaired.
    pub warnings: Vec<Warning>,
    /// Where its faces and vertices are in the file.
    pub contents: Contents,
}

/// Why a file was refused.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ObjError {
    /// Somebody asked to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// The file cannot be read.
    #[error(transparent)]
    File(#[from] FileError),
    /// The file has zero bytes.
    #[error("{}: the file is empty", file.display())]
    Empty {
        /// The file.
        file: PathBuf,
    },
    /// The file has neither vertices nor faces.
    #[error("{}: not an OBJ file: {looks_like}", file.display())]
    NotObj {
        /// The file.
        file: PathBuf,
        /// What the file seems to be.
        looks_like: &'static str,
    },
    /// The file has no faces to show; it may have points, lines or curves.
    #[error("{}: no faces to show ({holds})", file.display())]
    NoFaces {
        /// The file.
        file: PathBuf,
        /// What the file has instead, with counts.
        holds: String,
    },
    /// No triangle is left, and a line breaks the format.
    #[error("{}:{line}: {what}", file.display())]
    BadLine {
        /// The file.
        file: PathBuf,
        /// The number of the first such line, from 1.
        line: usize,
        /// What is wrong with it.
        what: BadLine,
    },
    /// The triangles do not form a valid mesh.
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
#[non_exhaustive]
pub enum BadLine {
    /// A vertex with fewer than three coordinates, or with one that is not a number.
    #[error("a vertex needs three numbers")]
    Vertex,
    /// A vertex with a coordinate beyond the range of numbers; see [`range`](crate::geometry::range).
    #[error("a coordinate is not a number up to 1.29e33")]
    OutOfRange,
    /// A normal with fewer than three coordinates, or with one that is not a number.
    #[error("a normal needs three numbers")]
    Normal,
    /// An `#MRGB` line without eight hexadecimal digits for each vertex.
    #[error("an #MRGB line has eight hexadecimal digits for each vertex")]
    Painted,
    /// A corner of a face that is not in one of the four valid forms.
    #[error("a corner of a face is written as 1, 1/2, 1//3 or 1/2/3")]
    Corner,
    /// A corner of a face names a vertex that does not exist.
    #[error("a face names vertex {vertex} of {vertices}")]
    NoSuchVertex {
        /// The vertex as the face writes it.
        vertex: String,
        /// How many vertices the file has.
        vertices: usize,
    },
    /// A corner of a face names a vertex by counting back, and comes to none.
    #[error("a face counts back to before the first vertex")]
    BeforeFirst,
}

/// Why reading the lines of a file stopped early.
enum Stop {
    /// Somebody asked to stop.
    Cancelled(Cancelled),
    /// The system could not read on.
    Unreadable(io::Error),
    /// A line of 256 KiB or more has a NUL in it.
    Binary,
}

impl Stop {
    fn at(self, path: &Path) -> ObjError {
        let file = path.to_owned();
        let looks_like = BINARY;
        match self {
            Self::Cancelled(cancelled) => cancelled.into(),
            Self::Unreadable(source) => match source.get_ref() {
                Some(why) if why.is::<Changed>() => FileError::Changed { file }.into(),
                _ => FileError::Unreadable { file, source }.into(),
            },
            Self::Binary => ObjError::NotObj { file, looks_like },
        }
    }
}

/// What a file with NULs looks like.
const BINARY: &str = "binary data";

/// Loads an OBJ file and the MTL files it names.
///
/// # Errors
/// When the file cannot be read or has nothing to show; see [`ObjError`]. Any other problem of the file or its MTL
/// files is a warning.
pub fn load(path: &Path, progress: &Progress) -> Result<ObjFile, ObjError> {
    load_with(path, progress, Detail::All)
}

/// Like [`load`], but loads only what `detail` requires.
pub(super) fn load_with(
    path: &Path,
    progress: &Progress,
    detail: Detail,
) -> Result<ObjFile, ObjError> {
    let stamp = Stamp::of(path)?;
    let mut file = read(path, progress, (PIECE, detail), || open(path, &stamp))?;
    file.contents.stamp = Some(stamp);
    Ok(file)
}

/// Like [`load`], but from bytes in memory. `path` is the file's name in errors.
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

/// Reads a file in pieces of about `piece` bytes.
fn read<R: BufRead + Send>(
    path: &Path,
    progress: &Progress,
    (piece, detail): (usize, Detail),
    open: impl Fn() -> Result<(R, u64), ObjError>,
) -> Result<ObjFile, ObjError> {
    let start = Instant::now();
    let (mut input, bytes) = open()?;
    // Building the mesh takes about a quarter as long as reading, and computing normals another quarter.
    let more = if detail == Detail::Drawn { 2 } else { 1 };
    progress.expect(bytes + more * (bytes / 4));
    let looks_like = looks_like(&mut input);
    if let Some(Look::Archive(looks_like)) = looks_like {
        return Err(ObjError::NotObj {
            file: path.to_owned(),
            looks_like,
        });
    }
    let read = decode(input).map_err(Stop::Unreadable).and_then(|input| {
        let pieces = Pieces::new(input, piece, progress);
        read_pieces(pieces, detail, progress)
    });
    let (blocks, survey) = read.map_err(|stop| stop.at(path))?;
    let bytes = bytes / 4;
    let (read, start) = (start.elapsed(), Instant::now());
    let built = assembling::build(path, blocks, survey, detail, (progress, bytes));
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
        built.mesh.normals();
        progress.advance(bytes)?;
    }
    log::info!(
        "read {} in {read:.1?}, built in {:.1?}",
        path.display(),
        start.elapsed()
    );
    Ok(built)
}

/// Reads the pieces of a file on all cores. Returns the blocks, and the survey of all other lines.
fn read_pieces(
    pieces: Pieces,
    detail: Detail,
    progress: &Progress,
) -> Result<(Vec<Block>, Survey), Stop> {
    let read = on_all_cores(pieces, |piece| Block::read(&piece?, detail));
    let mut blocks = Vec::with_capacity(read.len());
    let mut survey = Survey::default();
    let mut lines = 0;
    for piece in read {
        let (block, next) = piece?;
        progress.advance(0).map_err(Stop::Cancelled)?;
        survey.append(next, lines);
        lines += block.counts.lines;
        blocks.push(block);
    }
    Ok((blocks, survey))
}

/// Opens a file and returns its size. It must be a regular file and not empty. Bytes that are appended later are not
/// read, because they may never end. Reading its end fails if the file no longer has this stamp: its last line may have
/// been cut inside a number.
fn open<'a>(
    path: &'a Path,
    stamp: &'a Stamp,
) -> Result<(impl BufRead + Send + use<'a>, u64), ObjError> {
    let (opened, bytes) = file::open(path, MOST_BYTES)?;
    if bytes == 0 {
        let file = path.to_owned();
        return Err(ObjError::Empty { file });
    }
    file::check_memory(
        path,
        usize::try_from(bytes)
            .unwrap_or(usize::MAX)
            .saturating_mul(READ),
    )?;
    let input = opened.take(bytes);
    Ok((BufReader::new(Unchanged { input, path, stamp }), bytes))
}

/// The file has another stamp than before it was read.
#[derive(Debug, thiserror::Error)]
#[error("it changed while it was read")]
struct Changed;

/// Reads a file that must not change meanwhile.
struct Unchanged<'a, R> {
    input: R,
    path: &'a Path,
    /// The file's stamp before it was read.
    stamp: &'a Stamp,
}

impl<R: Read> Read for Unchanged<'_, R> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let read = self.input.read(into)?;
        if read == 0 && Stamp::of(self.path).ok().as_ref() != Some(self.stamp) {
            return Err(io::Error::other(Changed));
        }
        Ok(read)
    }
}

/// What the first bytes say about a file that is no OBJ file.
#[derive(Clone, Copy)]
enum Look {
    /// An archive of files. If they are stored uncompressed, their lines could be read as if the archive were an OBJ
    /// file.
    Archive(&'static str),
    /// Another kind of file. This matters only if nothing to show is found.
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
        Some(Look::Other(BINARY))
    } else {
        None
    }
}
