//! Tests that a face read again equals the text of the file, as a simple reader without pieces finds it.

use super::{
    super::{Again, AgainError, ObjFile, Stamp, is_utf16, text_lines::Text},
    any_file, foreign_files, read_in,
};
use crate::scene::{FileError, Progress};
use glam::DVec3;
use std::{
    fmt::Write as _,
    fs,
    path::{Path, PathBuf},
};
use tempfile::TempDir;

/// The lines of a text, with any of the three line ends, as an editor numbers them.
fn editor_lines(text: &str) -> Vec<String> {
    let text = text
        .trim_start_matches('\u{feff}')
        .replace("\r\n", "\n")
        .replace('\r', "\n");
    text.split('\n').map(str::to_owned).collect()
}

/// A line joined with those that continue it, without its comment.
fn joined(lines: &[String], at: usize) -> String {
    let mut text = String::new();
    for line in &lines[at..] {
        match line.trim_end().strip_suffix('\\') {
            Some(start) if !line.contains('#') => text.extend([start, " "]),
            _ => {
                text += line;
                break;
            }
        }
    }
    text.split('#').next().unwrap_or_default().to_owned()
}

/// Writes a file and loads it. It is removed with its folder.
fn loaded(piece: usize, bytes: &[u8]) -> (TempDir, PathBuf, ObjFile) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("some.obj");
    fs::write(&path, bytes).expect("written");
    let mut file = read_in(piece, &path, bytes).expect("it loads");
    file.contents.stamp = Stamp::of(&path).ok();
    (folder, path, file)
}

/// Reads every `step`th triangle again, and every face that has one if there are not too many. Counts the triangles,
/// and the faces that do not have three corners.
fn assert_read_again(path: &Path, bytes: &[u8], piece: usize, step: usize) -> [usize; 2] {
    let Ok(mut file) = read_in(piece, path, bytes) else {
        return [0, 0];
    };
    file.contents.stamp = Stamp::of(path).ok();
    let (progress, mesh) = (Progress::default(), &*file.mesh);
    let mut again = Again::new(path, &file.contents, mesh, &progress);
    let lines = editor_lines(&String::from_utf8_lossy(bytes));
    let is = |at: usize, keyword: &str| {
        let continues = at > 0 && {
            let before = &lines[at - 1];
            before.trim_end().ends_with('\\') && !before.contains('#')
        };
        let line = joined(&lines, at);
        let first = line.split_whitespace().next().unwrap_or_default();
        !continues && first.eq_ignore_ascii_case(keyword)
    };
    let all = |keyword: &'static str| (0..lines.len()).filter(move |at| is(*at, keyword));
    let (vertex_lines, face_lines): (Vec<_>, Vec<_>) = (all("v").collect(), all("f").collect());
    assert_eq!(file.contents.vertices(), vertex_lines.len());
    let origin = mesh.data().origin;
    let (mut triangles, mut polygons) = (0, 0);
    let count = mesh.data().triangles.len();
    for triangle in (0..count).step_by(step) {
        let triangle = u32::try_from(triangle).expect("few");
        let face = again
            .face_of(triangle)
            .unwrap_or_else(|error| panic!("{error}"));
        // The line equals the one that an editor shows under this number.
        assert_eq!(face.line, face_lines[face.face - 1] + 1, "{path:?}");
        let text = joined(&lines, face.line - 1);
        let named: Vec<isize> = text
            .split_whitespace()
            .skip(1)
            .map(|corner| {
                corner
                    .split('/')
                    .next()
                    .and_then(|n| n.parse().ok())
                    .expect("a number")
            })
            .collect();
        let before = vertex_lines.partition_point(|line| *line < face.line - 1);
        let numbers = named.iter().map(|&n| match usize::try_from(n) {
            Ok(number) => number,
            Err(_) => before + 1 - n.unsigned_abs(),
        });
        assert!(
            numbers.eq(face.vertices.iter().map(|vertex| vertex.vertex)),
            "{path:?}: {text}"
        );
        for vertex in &face.vertices {
            assert_eq!(vertex.line, vertex_lines[vertex.vertex - 1] + 1);
            let text = joined(&lines, vertex.line - 1);
            let words: Vec<_> = text.split_whitespace().skip(1).take(3).collect();
            assert_eq!(vertex.written, words.join(" "));
        }
        // The triangle's corners are corners of the polygon, stored as `f32` relative to the origin.
        let corners = face.corners[(triangle - face.triangles.start) as usize];
        let stored = corners.map(|corner| {
            let written = &face.vertices[corner as usize].written;
            let words: Vec<f64> = written
                .split(' ')
                .map(|word| word.parse().expect("a number"))
                .collect();
            let about = DVec3::from_slice(&words) - origin;
            origin + about.as_vec3().as_dvec3()
        });
        assert_eq!(stored, mesh.corners(triangle), "{path:?}");
        triangles += 1;
        polygons += usize::from(face.vertices.len() != 3);
    }
    if step == 1 {
        // Every triangle belongs to one face, in order.
        let mut next = 0;
        let mut last = 0;
        while (next as usize) < count {
            let face = again
                .face_of(next)
                .unwrap_or_else(|error| panic!("{error}"));
            assert!(face.face > last && face.triangles.start == next);
            (last, next) = (face.face, face.triangles.end);
        }
        assert_eq!(next as usize, count);
    }
    [triangles, polygons]
}

#[test]
fn every_triangle_is_found_in_its_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut counts = [0, 0];
    for seed in 0..60 {
        let text = any_file(seed);
        let path = folder.path().join(format!("{seed}.obj"));
        fs::write(&path, &text).expect("written");
        for piece in [1, 97, 1 << 18] {
            let found = assert_read_again(&path, text.as_bytes(), piece, 1);
            counts = [counts[0] + found[0], counts[1] + found[1]];
        }
    }
    assert!(counts[0] > 600 && counts[1] > 200, "{counts:?}");
}

#[test]
fn files_from_elsewhere_say_where_a_triangle_is_from() {
    let Some(files) = foreign_files() else {
        return;
    };
    let mut counts = [0, 0, 0];
    for path in files {
        let bytes = fs::read(&path).expect("a file");
        if is_utf16(&bytes) {
            continue;
        }
        let (piece, step) = match bytes.len() {
            0..100_000 => (333, 1),
            _ => (1 << 18, 997),
        };
        let [triangles, polygons] = assert_read_again(&path, &bytes, piece, step);
        counts = [counts[0] + 1, counts[1] + triangles, counts[2] + polygons];
    }
    let are_many = counts[0] > 80 && counts[1] > 3_500 && counts[2] > 3_000;
    assert!(are_many, "{counts:?}");
}

#[test]
fn a_triangle_takes_the_pieces_of_its_face_and_of_its_vertices_alone() {
    const COUNT: usize = 1_999;
    // On a parabola no three vertices are in line. Faces that follow each other are far apart.
    let mut vertices = String::new();
    for x in 0..=COUNT + 3 {
        writeln!(vertices, "v {x} {} 0", x * x).expect("text");
    }
    let face = |i: usize| match 1 + 617 * i % COUNT {
        a if i.is_multiple_of(3) => format!("f {a} {} {} {}\n", a + 1, a + 2, a + 3),
        a => format!("f {a} {} {}\n", a + 1, a + 2),
    };
    let faces: String = (0..COUNT).map(face).collect();
    let with_flat = faces.replace("9 ", "9 1 1 ");
    for faces in [faces, with_flat] {
        let (_folder, path, file) = loaded(1 << 10, format!("{vertices}{faces}").as_bytes());
        let count = u32::try_from(file.mesh.data().triangles.len()).expect("few");
        let mut most = 0;
        for triangle in (0..count).step_by(97) {
            let progress = Progress::default();
            let mut again = Again::new(&path, &file.contents, &file.mesh, &progress);
            let face = again.face_of(triangle).expect("it is there");
            assert!(face.triangles.contains(&triangle));
            most = most.max(again.pieces_read());
            // The same again reads nothing: its pieces stay in memory.
            progress.cancel();
            let same = again.face_of(triangle).expect("it is in memory");
            assert_eq!(same.face, face.face);
        }
        // The vertices of a face follow each other: they lie in one piece or in two.
        assert!(most <= 3, "{most}");
    }
}

#[test]
fn a_file_in_utf_16_is_read_again_too() {
    let text = "\u{feff}v 0 0 0\nv 1 0 0.1\nv 0 1 0\nf 1 2 3\n";
    let bytes: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
    let (_folder, path, file) = loaded(5, &bytes);
    let progress = Progress::default();
    let mut again = Again::new(&path, &file.contents, &file.mesh, &progress);
    let face = again.face_of(0).expect("it is there");
    assert_eq!((face.face, face.line), (1, 4));
    let second = &face.vertices[1];
    assert_eq!((&*second.written, second.line), ("1 0 0.1", 2));
    assert_eq!(
        second.stored,
        Some(DVec3::new(1.0, 0.0, f64::from(0.1_f32)))
    );
    assert_eq!(face.vertices[0].stored, None);
}

#[test]
fn a_changed_file_is_said_to_be_one() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let (_folder, path, file) = loaded(1 << 18, text.as_bytes());
    let progress = Progress::default();
    let face = || Again::new(&path, &file.contents, &file.mesh, &progress).face_of(0);
    assert_eq!(face().expect("unchanged").line, 4);
    // Other numbers, but the same size and the same time of modification.
    let modified = fs::metadata(&path)
        .and_then(|about| about.modified())
        .expect("a time");
    fs::write(&path, text.replace("v 1 0 0", "v 1 0 5")).expect("written");
    let opened = fs::File::options().write(true).open(&path).expect("a file");
    opened.set_modified(modified).expect("set");
    assert!(matches!(face(), Err(AgainError::Changed { .. })));
    // The same text, but a later time of modification.
    fs::write(&path, text).expect("written");
    let later = modified + std::time::Duration::from_secs(7);
    opened.set_modified(later).expect("set");
    assert!(matches!(face(), Err(AgainError::Changed { .. })));
    fs::remove_file(&path).expect("removed");
    let gone = face().expect_err("it is gone").to_string();
    assert!(gone.contains("cannot be read again"), "{gone}");
}

/// UTF-16 is read whole, but no further than the size that was found on opening.
#[test]
fn of_utf16_that_grows_no_more_is_read() {
    let text = |text: &str| -> Vec<u8> {
        let units = ['\u{feff}'].into_iter().chain(text.chars());
        let bytes = units.map(|c| u16::try_from(c).expect("one unit").to_le_bytes());
        bytes.flatten().collect()
    };
    let bytes = text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let (_folder, path, file) = loaded(1 << 18, &bytes);
    let progress = Progress::default();
    let face = || Again::new(&path, &file.contents, &file.mesh, &progress).face_of(0);
    assert_eq!(face().expect("unchanged").line, 4);
    let opened = || fs::File::open(&path).expect("a file");
    let size = bytes.len() as u64;
    fs::write(&path, [&*bytes, &text("more")].concat()).expect("written");
    let Ok(Text::Decoded(read)) = Text::of(opened(), size) else {
        panic!("UTF-16 is decoded");
    };
    assert_eq!(read.last(), Some(&b'\n'));
    assert!(matches!(face(), Err(AgainError::Changed { .. })));
}

/// Pieces that were read stay in memory, but are not used once the file has changed.
#[test]
fn a_change_after_the_first_answer_is_said_too() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let (folder, path, file) = loaded(1 << 18, text.as_bytes());
    let other = folder.path().join("other.obj");
    let progress = Progress::default();
    let mut again = Again::new(&path, &file.contents, &file.mesh, &progress);
    assert_eq!(again.face_of(0).expect("unchanged").line, 4);
    // Another file with the same name, size and time of modification.
    let modified = fs::metadata(&path).and_then(|about| about.modified());
    fs::write(&other, text).expect("written");
    let opened = fs::File::options().write(true).open(&other);
    (opened.and_then(|opened| opened.set_modified(modified?))).expect("set");
    #[cfg(unix)]
    {
        fs::rename(&other, &path).expect("renamed");
        assert!(matches!(again.face_of(0), Err(AgainError::Changed { .. })));
    }
    fs::write(&path, format!("# more\n{text}")).expect("written");
    assert!(matches!(again.face_of(0), Err(AgainError::Changed { .. })));
    fs::remove_file(&path).expect("removed");
    assert!(matches!(
        again.in_file(0).file_error,
        Some(error) if error.contains("cannot be read again")
    ));
    // A path that is no regular file is not opened: opening a pipe would wait for a writer.
    fs::create_dir(&path).expect("a folder");
    assert!(matches!(
        again.face_of(0),
        Err(AgainError::File(FileError::NotAFile { .. }))
    ));
}
