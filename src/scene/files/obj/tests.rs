//! Loading gives the same result for pieces of every size, and agrees with `tobj` alone.

mod again;
#[path = "../../../../tests/common/real_files.rs"]
mod real_files;
mod shortcuts;

use super::{ObjError, ObjFile, PIECE, Stamp, decode, load, open, read};
use crate::{
    geometry::{CornerNormals, random::Random},
    scene::{Detail, Progress, Warning},
};
use glam::{DVec3, Vec3};
use real_files::real_files;
use std::{
    fmt::Write as _,
    fs,
    io::{self, BufReader, Cursor, Read, Write as _},
    path::{Path, PathBuf},
    sync::atomic::{AtomicU64, Ordering::Relaxed},
};

fn read_in(piece: usize, path: &Path, bytes: &[u8]) -> Result<ObjFile, ObjError> {
    read_as((piece, Detail::All), path, bytes, &Progress::default())
}

fn read_as(
    options: (usize, Detail),
    path: &Path,
    bytes: &[u8],
    progress: &Progress,
) -> Result<ObjFile, ObjError> {
    read(path, progress, options, || {
        Ok((Cursor::new(bytes), bytes.len() as u64))
    })
}

/// The OBJ files from elsewhere; `None` where they are absent.
fn foreign_files() -> Option<Vec<PathBuf>> {
    let folder = real_files()?;
    let folders = ["models", "hostile"].map(|name| folder.join(name));
    let entries = (folders.iter()).flat_map(|at| fs::read_dir(at).expect("a folder"));
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let is_obj = |path: &PathBuf| path.extension().is_some_and(|end| end == "obj");
    Some(
        paths
            .filter(|path| is_obj(path) && path.is_file())
            .collect(),
    )
}

/// Counts the bytes that are read.
struct Counted<'a, R>(R, &'a AtomicU64);

impl<R: Read> Read for Counted<'_, R> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let read = self.0.read(into)?;
        self.1.fetch_add(read as u64, Relaxed);
        Ok(read)
    }
}

/// A hole in a file, which reads as a line of NULs, is not read to its end, and neither is other binary data. What
/// comes before it may be valid.
#[test]
fn binary_data_is_not_read_to_its_end() {
    const MOST: u64 = 2 << 20;
    let cube = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let utf16 = b"\xfe\xff\0#\0\n";
    let starts: [&[u8]; 4] = [b"", cube, utf16, &cube.repeat(1 << 14)];
    for start in starts {
        let (bytes, taken) = (1 << 28, AtomicU64::new(0));
        let progress = Progress::default();
        let refused = read(Path::new("a.obj"), &progress, (PIECE, Detail::All), || {
            let zeros = start.chain(io::repeat(0)).take(bytes);
            Ok((BufReader::new(Counted(zeros, &taken)), bytes))
        });
        let message = refused.map_err(|error| error.to_string()).map(|_| ());
        assert_eq!(
            message,
            Err("a.obj: not an OBJ file: binary data".to_owned())
        );
        let taken = taken.into_inner();
        assert!(taken <= MOST, "{taken} bytes were read");
    }
}

/// A NUL here and there is no reason to refuse a file, and neither is a long line.
#[test]
fn long_lines_and_single_nuls_are_text() {
    let path = Path::new("some.obj");
    let long = "x".repeat(1 << 20);
    let text = format!("# \0\nv 0 0 0\nv 1 0 0\nv 0 1 0\n# {long}\nf 1 2 3\n\0");
    for piece in [1 << 10, PIECE, 1 << 22] {
        let file = read_in(piece, path, text.as_bytes()).expect("it loads");
        assert_eq!(file.mesh.data().triangles.len(), 1);
    }
    let text = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n# {long}\0");
    for piece in [1 << 10, PIECE, 1 << 22] {
        let refused = read_in(piece, path, text.as_bytes()).expect_err("it is refused");
        assert!(refused.to_string().ends_with("binary data"), "{refused}");
    }
}

/// UTF-16 is converted block by block. Some characters take two of its units, which may lie in two blocks.
#[test]
fn utf16_is_the_same_in_blocks() {
    for before in 4090..4100 {
        let text = format!("#{}\u{1f980}\u{1f980}\u{e9}\n", "x".repeat(before)).repeat(3);
        // Half a character in the middle and at the end.
        let units: Vec<u16> = text.encode_utf16().chain([0xd83e, 0x78, 0xd83e]).collect();
        let expected = String::from_utf16_lossy(&units);
        let all = [0xfeff].into_iter().chain(units);
        let swapped: Vec<u8> = all.clone().flat_map(u16::to_be_bytes).collect();
        let bytes: Vec<u8> = all.flat_map(u16::to_le_bytes).collect();
        for bytes in [bytes, swapped] {
            let mut read = String::new();
            let mut decoded = decode(Cursor::new(bytes)).expect("memory");
            decoded.read_to_string(&mut read).expect("memory");
            assert_eq!(read, expected, "{before}");
        }
    }
}

/// The mesh and the warnings of a file, or its error, as text.
fn outcome(piece: usize, path: &Path, bytes: &[u8]) -> String {
    match read_in(piece, path, bytes) {
        Ok(file) => format!("{:?}{:?}", file.mesh.data(), file.warnings),
        Err(error) => error.to_string(),
    }
}

/// Asserts that a file gives the same result in pieces of each size as in one piece. Returns the number of sizes.
fn assert_same(path: &Path, bytes: &[u8], pieces: impl IntoIterator<Item = usize>) -> usize {
    let whole = outcome(bytes.len() + 1, path, bytes);
    let mut count = 0;
    for piece in pieces {
        let parted = outcome(piece, path, bytes);
        assert!(parted == whole, "{} by {piece} bytes", path.display());
        count += 1;
    }
    count
}

/// Random numbers below a limit.
struct Dice(Random);

impl Dice {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "below the limit"
    )]
    fn below(&mut self, limit: usize) -> usize {
        let limit_f64 = f64::from(u32::try_from(limit).expect("a small limit"));
        ((0.5 + 0.5 * self.0.next()) * limit_f64) as usize
    }

    fn of<'a>(&mut self, all: &[&'a str]) -> &'a str {
        all[self.below(all.len())]
    }
}

/// The index of one of `count` vertices or normals, positive or negative; sometimes one that does not exist, or not
/// yet.
fn index(dice: &mut Dice, count: usize, wild: bool) -> String {
    match dice.below(if wild { 40 } else { 36 }) {
        0..24 => (1 + dice.below(count.max(1))).to_string(),
        24..36 => format!("-{}", 1 + dice.below(count.max(1))),
        36 => (count + 1 + dice.below(4)).to_string(),
        37 => format!("-{}", count + 1 + dice.below(2)),
        38 => "0".to_owned(),
        _ => dice
            .of(&["x", "", "1.5", "99999999999999999999"])
            .to_owned(),
    }
}

fn face(dice: &mut Dice, [vertices, normals]: [usize; 2], wild: bool) -> String {
    let mut face = String::from("f");
    let form = dice.below(4);
    let corners = if wild { dice.below(7) } else { 3 };
    for _ in 0..corners {
        let vertex = index(dice, vertices, wild);
        let normal = index(dice, normals, wild);
        let form = if wild && dice.below(20) == 0 {
            dice.below(4)
        } else {
            form
        };
        let corner = match form {
            _ if normals == 0 => vertex,
            0 => vertex,
            1 => format!("{vertex}/1"),
            2 => format!("{vertex}//{normal}"),
            _ => format!("{vertex}/1/{normal}"),
        };
        write!(face, " {corner}").expect("text");
    }
    face
}

/// A file of every kind of line, in any order.
fn any_file(seed: u64) -> String {
    let mut dice = Dice(Random(seed));
    let coloured = dice.below(3);
    let ends = ["\n", "\r\n", "\r", " \\\n", "\n\n", " # words\n"];
    let mut text = String::new();
    let mut counts = [0, 0];
    for _ in 0..60 {
        let line = match dice.below(24) {
            0..9 => {
                counts[0] += 1;
                let p = dice.0.point();
                let colour = match dice.below(4 + 4 * coloured) {
                    0..4 => "",
                    4 => " 0.25",
                    _ => " 0.5 0 1",
                };
                format!("v {} {} {}{colour}", p.x, p.y, p.z)
            }
            9 => {
                counts[0] += 1;
                dice.of(&["v 1 2", "v nan 0 0", "v a b c", "v 1 2 1e999"])
                    .to_owned()
            }
            10 | 11 => {
                counts[1] += 1;
                let n = dice.0.point();
                format!("vn {} {} {}", n.x, n.y, n.z)
            }
            12 => {
                counts[1] += 1;
                dice.of(&["vn 0 0 0", "vn 1", "vn inf 1 1"]).to_owned()
            }
            13..20 => face(&mut dice, counts, true),
            20 => format!("o {}", dice.of(&["one", "two", ""])),
            21 => format!("g {}", dice.of(&["left", "right", ""])),
            22 => format!("usemtl {}", dice.of(&["red", "blue", "grey"])),
            _ => dice
                .of(&[
                    "mtllib none.mtl",
                    "l 1 2",
                    "p 1",
                    "# f 1 2 3",
                    "s 1",
                    "vt 0 0",
                    "curv 0 1 1 2",
                ])
                .to_owned(),
        };
        text += &line;
        text += if dice.below(4) > 0 {
            "\n"
        } else {
            dice.of(&ends)
        };
    }
    text
}

#[test]
fn a_file_is_the_same_in_pieces_of_any_size() {
    let path = Path::new("any.obj");
    let (mut count, mut meshes) = (0, 0);
    for seed in 0..40 {
        let text = any_file(seed);
        meshes += usize::from(read_in(text.len() + 1, path, text.as_bytes()).is_ok());
        // Each size cuts the file at other lines; the smallest cuts it after every line.
        let sizes = (1..40).chain((40..text.len() + 2).step_by(37));
        count += assert_same(path, text.as_bytes(), sizes);
    }
    assert!(count > 2_500 && meshes > 30, "{count}, {meshes}");
}

#[test]
fn files_from_elsewhere_are_the_same_in_pieces() {
    let Some(files) = foreign_files() else {
        return;
    };
    let mut count = 0;
    for path in files {
        let bytes = fs::read(&path).expect("a file");
        let sizes: &[usize] = match bytes.len() {
            0..10_000 => &[1, 7, 64, 333, 1024],
            10_000..3_000_000 => &[5_000, 99_999],
            _ => continue,
        };
        count += assert_same(&path, &bytes, sizes.iter().copied());
    }
    assert!(count > 200, "{count}");
}

#[test]
fn a_file_in_pieces_is_what_tobj_reads_at_once() {
    let mut triangles = 0;
    for seed in 0..200 {
        let mut dice = Dice(Random(1000 + seed));
        let mut text = String::from("v 0 0 0\nvn 0 0 1\n");
        let mut counts = [1, 1];
        for _ in 0..80 {
            let p = dice.0.point().as_vec3();
            let line = match dice.below(4) {
                0 | 1 => {
                    counts[0] += 1;
                    format!("v {} {} {}", p.x, p.y, p.z)
                }
                2 => {
                    counts[1] += 1;
                    format!("vn {} {} {}", p.x, p.y, p.z)
                }
                _ => face(&mut dice, counts, false),
            };
            text += &line;
            text.push('\n');
        }
        let none = |_: &Path| Err(tobj::LoadError::GenericFailure);
        // The way `tobj` is usually called.
        let (models, _) =
            tobj::load_obj_buf(&mut text.as_bytes(), &tobj::LoadOptions::default(), none)
                .expect("tobj reads it");
        let mesh = &models[0].mesh;
        let (positions, _) = mesh.positions.as_chunks::<3>();
        let expected = mesh
            .indices
            .chunks(3)
            .map(|t| [0, 1, 2].map(|i| DVec3::from_array(positions[t[i] as usize]).as_vec3()));
        let has_area = |t: &[Vec3; 3]| {
            let [a, b, c] = t.map(Vec3::as_dvec3);
            (b - a).cross(c - a) != DVec3::ZERO
        };
        let expected: Vec<_> = expected.filter(has_area).collect();
        for piece in [1, 100, 1000] {
            let Ok(file) = read_in(piece, Path::new("some.obj"), text.as_bytes()) else {
                assert!(expected.is_empty());
                continue;
            };
            let found = 0..u32::try_from(file.mesh.data().triangles.len()).expect("few");
            let found = found.map(|t| file.mesh.corners(t).map(DVec3::as_vec3));
            assert_eq!(found.collect::<Vec<_>>(), expected, "{text}");
        }
        triangles += expected.len();
    }
    assert!(triangles > 1000, "{triangles}");
}

/// A hilly terrain with this many squares along a side.
fn terrain(side: usize) -> String {
    terrain_of_height(side, |x, z| (x * z) % 7)
}

fn terrain_of_height(side: usize, height: impl Fn(usize, usize) -> usize) -> String {
    let mut text = String::new();
    for (z, x) in (0..=side).flat_map(|z| (0..=side).map(move |x| (z, x))) {
        writeln!(text, "v {x} {} {z}", height(x, z)).expect("text");
    }
    for a in (0..side).flat_map(|z| (1..=side).map(move |x| z * (side + 1) + x)) {
        let (b, c, d) = (a + 1, a + side + 1, a + side + 2);
        writeln!(text, "f {a} {c} {b}\nf {b} {c} {d}").expect("text");
    }
    text
}

/// The sizes that the docs of [`Mesh`](crate::geometry::Mesh) state.
#[test]
fn a_smooth_mesh_keeps_no_more_than_its_docs_say() {
    let text = terrain_of_height(200, |_, _| 0);
    // The same with a normal for each vertex, in the same order.
    let with_normals = text.lines().map(|line| match line.split_once(' ') {
        Some(("f", corners)) => {
            let corners = corners.split(' ').map(|i| format!(" {i}//{i}"));
            format!("f{}\n", corners.collect::<String>())
        }
        _ => format!("{line}\nvn 0 1 0\n"),
    });
    let with_normals = with_normals.collect();
    for text in [text, with_normals] {
        let file = read_in(PIECE, Path::new("some.obj"), text.as_bytes()).expect("it loads");
        let (mesh, pieces) = (file.mesh, text.len().div_ceil(PIECE));
        let (data, normals) = (mesh.data(), mesh.normals());
        let [vertices, triangles] = [201 * 201, 2 * 200 * 200];
        assert_eq!(data.positions.capacity(), vertices);
        assert_eq!(data.triangles.capacity(), triangles);
        assert_eq!(data.vertex_colours.capacity(), 0);
        assert_eq!(normals.normals.capacity(), vertices);
        assert_eq!(normals.corners.capacity(), 0);
        let given = data.normals.normals.len();
        assert!(given == 0 || std::ptr::eq(normals, &raw const data.normals));
        assert_eq!((data.parts.len(), data.colours.len()), (1, 1));
        assert_eq!(mesh.blocks().len(), triangles.div_ceil(256));
        assert_eq!(size_of_val(mesh.blocks()), 48 * mesh.blocks().len());
        mesh.build_tree();
        let tree = mesh.tree().expect("a tree").bytes();
        assert!(tree <= 64 * triangles, "{tree}");
        assert!(file.contents.pieces() <= pieces + 1);
        assert_eq!(file.contents.lines.capacity(), triangles);
    }
}

/// Each step of a load reports progress after every piece. If a single report is told to stop, the load ends: none of
/// them ignores the answer.
#[test]
fn every_step_of_a_load_reports_and_can_be_the_last() {
    let text = format!("g ground\nusemtl none\n{}", terrain(160));
    let load = |stopped_at: u64| {
        let progress = Progress::default();
        progress.stopped_at.store(stopped_at, Relaxed);
        let (options, path) = ((PIECE, Detail::Drawn), Path::new("some.obj"));
        let loaded = read_as(options, path, text.as_bytes(), &progress);
        (loaded, progress)
    };
    let (loaded, progress) = load(0);
    loaded.expect("it loads");
    assert!((progress.fraction() - 1.0).abs() < f32::EPSILON);
    let reports = progress.reports.into_inner();
    let pieces = text.len().div_ceil(PIECE);
    // Each piece reports when it is read, when all are counted, in each of the four steps of the vertices, when it is
    // split into triangles and when these are merged. The end of the file is reported twice. Lines that name something
    // are gone through five times. What rounding left of the steps' shares, the mesh and its normals report once each.
    let (read, built) = (pieces + 2, 7 * pieces + 5 + 2);
    assert_eq!(reports, (read + built + 1) as u64);
    for last in 1..=reports {
        let (stopped, progress) = load(last);
        assert!(matches!(stopped, Err(ObjError::Cancelled(_))), "at {last}");
        assert!(progress.fraction() <= 1.0);
    }
}

/// Picks need no normals. Without them and what is said of them, everything else is the same.
#[test]
fn normals_are_left_out_where_nothing_is_shaded() {
    let path = Path::new("any.obj");
    let (mut shaded, mut coloured) = (0, 0);
    for seed in 0..200 {
        let text = any_file(seed);
        let read_as = |detail| read_as((99, detail), path, text.as_bytes(), &Progress::default());
        let outcome = |file: &Result<ObjFile, ObjError>| match file {
            Ok(file) => {
                let data = file.mesh.data();
                let is_other = |warning: &&Warning| !warning.message.contains("normal");
                let warnings: Vec<_> = file.warnings.iter().filter(is_other).collect();
                let rest = (&data.parts, warnings);
                format!("{:?}{:?}{rest:?}", data.positions, data.triangles)
            }
            Err(error) => error.to_string(),
        };
        let [all, picked] = [Detail::All, Detail::Picked].map(read_as);
        let outcomes = [outcome(&all), outcome(&picked)];
        if !outcomes[0].starts_with("any.obj") || !outcomes[0].contains("normal") {
            assert_eq!(outcomes[0], outcomes[1], "{seed}");
        }
        let (Ok(all), Ok(picked)) = (all, picked) else {
            continue;
        };
        let [all, picked] = [&all, &picked].map(|file| file.mesh.data());
        shaded += all.normals.normals.len();
        coloured += all.vertex_colours.len();
        assert_eq!(picked.normals, CornerNormals::default());
        assert_eq!(picked.vertex_colours, all.vertex_colours);
    }
    assert!(shaded > 100 && coloured > 100, "{shaded}, {coloured}");
}

/// A file with any part missing is read, or refused with a message of one line.
#[test]
fn a_file_that_ends_anywhere_is_read_or_refused() {
    let text = terrain(12);
    let (mut read, mut refused) = (0, 0);
    for end in 0..text.len() {
        match read_in(64, Path::new("some.obj"), &text.as_bytes()[..end]) {
            Ok(file) => {
                read += 1;
                assert!(file.warnings.len() < 3);
            }
            Err(error) => {
                refused += 1;
                assert!(!error.to_string().contains('\n'));
            }
        }
    }
    assert!(read > 1000 && refused > 1000, "{read}, {refused}");
}

#[test]
fn what_is_added_to_a_file_while_it_is_read_is_not() {
    let mut file = tempfile::NamedTempFile::new().expect("a file");
    file.write_all(b"v 0 0 0\n").expect("written");
    let path = file.path().to_owned();
    let stamp = Stamp::of(&path).expect("a file");
    let (mut input, bytes) = open(&path, &stamp).expect("a file");
    file.write_all(b"v 1 1 1\n").expect("written");
    let mut text = String::new();
    input.read_to_string(&mut text).expect_err("it has changed");
    assert_eq!((&*text, bytes), ("v 0 0 0\n", 8));
}

/// Its last line could be cut inside a number, and so be another valid line.
#[test]
fn a_file_that_changes_while_it_is_read_is_refused_in_one_line() {
    type Change = fn(&Path, &str);
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("some.obj");
    let start = "v 0 0 0\nv 1 0 0\nv 0 10 0\nv 5 5 0\n";
    let text = format!("{start}f 1 2 3\nf 1 2 ");
    let changes: [Change; 3] = [
        |path, text| fs::write(path, format!("{text}4\n")).expect("writable"),
        |path, text| fs::write(path, &text[..text.len() - 6]).expect("writable"),
        |path, _| fs::remove_file(path).expect("removable"),
    ];
    for change in changes {
        // It changes once the first bytes have been read.
        fs::write(&path, format!("{text}3")).expect("writable");
        let stamp = Stamp::of(&path).expect("a file");
        let refused = read(&path, &Progress::default(), (PIECE, Detail::All), || {
            let input = open(&path, &stamp)?;
            change(&path, &text);
            Ok(input)
        });
        let message = refused.expect_err("it is refused").to_string();
        let expected = "changed while it was read: open it again once it is complete";
        assert_eq!(message, format!("{}: {expected}", path.display()));
    }
    fs::write(&path, format!("{text}3")).expect("writable");
    load(&path, &Progress::default()).expect("it loads while nobody changes it");
}
