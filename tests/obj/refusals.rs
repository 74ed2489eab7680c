//! A refused file gets one line that names the file, the line in it and the fault.

use super::{CUBE, Folder, refusal};
use sightline::scene::{
    Progress,
    obj::{ObjError, load},
};

#[test]
fn each_refusal_says_what_is_wrong() {
    let cases: [(&[u8], &str); 19] = [
        (b"", "some.obj: the file is empty"),
        (
            b"# only\n\n",
            "some.obj: not an OBJ file: no vertices and no faces",
        ),
        (b"<!DOCTYPE html>", "some.obj: not an OBJ file: HTML or XML"),
        (
            b"\x1f\x8b\x08\0",
            "some.obj: not an OBJ file: gzip data (unpack it first)",
        ),
        (
            b"\xfe\xff\0v\0 \0",
            "some.obj:1: a vertex needs three numbers",
        ),
        (b"\x89PNG\0\0\0", "some.obj: not an OBJ file: binary data"),
        (
            b"version https://git-lfs.github.com/spec/v1\n",
            "some.obj: not an OBJ file: a Git LFS pointer (git lfs pull fetches the file itself)",
        ),
        (
            b"v 0 0 0\nv 1 0 0\n",
            "some.obj: no faces to show (vertices: 2)",
        ),
        (
            b"v 0 0 0\nv 1 0 0\nl 1 2\n",
            "some.obj: no faces to show (vertices: 2, points and lines: 1)",
        ),
        (
            b"v 0 0 0\nv 1 0 0\nf 1 2 2\n",
            "some.obj: no faces to show (vertices: 2, triangles without area: 1)",
        ),
        (
            b"v 0 0 0\nv 1 0\nv 0 1 0\n",
            "some.obj:2: a vertex needs three numbers",
        ),
        (
            b"v 0 0 0\nv 1 0 one\n",
            "some.obj:2: a vertex needs three numbers",
        ),
        (
            b"v 0 0 0\nvn 0 1\n",
            "some.obj:2: a normal needs three numbers",
        ),
        (
            b"v 0 0 0\nf 1/x 1 1\n",
            "some.obj:2: a corner of a face is written as 1, 1/2, 1//3 or 1/2/3",
        ),
        (
            b"v 0 0 0\nf 1 1 0\n",
            "some.obj:2: a face names vertex 0 of 1",
        ),
        (
            b"v 0 0 0\nf 1 1 -2\n",
            "some.obj:2: a face counts back to before the first vertex",
        ),
        (
            b"v 0 0 0\n\\\nf 1 1 4294967297\nv 0 0 0\n",
            "some.obj:2: a face names vertex 4294967297 of 2",
        ),
        (b"f 1 one/2 3\n", "some.obj:1: a face names vertex one of 0"),
        (
            b"f 1 99999999999999999999 3\n",
            "some.obj:1: a face names vertex 99999999999999999999 of 0",
        ),
    ];
    for (bytes, message) in cases {
        assert_eq!(refusal(bytes), message);
    }
}

/// An archive without compression contains the lines of its files unchanged.
#[test]
fn an_archive_is_said_to_be_one_and_not_read_as_what_is_in_it() {
    let zip = [
        b"PK\x03\x04".as_slice(),
        &[0; 22],
        &[8, 0, 0, 0],
        b"cube.obj\n",
        CUBE.as_bytes(),
    ];
    let mut tar_header = [0; 512];
    tar_header[..8].copy_from_slice(b"cube.obj");
    tar_header[257..262].copy_from_slice(b"ustar");
    let tar = [tar_header.as_slice(), b"\n", CUBE.as_bytes()];
    let gzip = [b"\x1f\x8b\x08".as_slice(), &[0; 7], b"\n", CUBE.as_bytes()];
    for (bytes, name) in [
        (zip.concat(), "a zip archive"),
        (tar.concat(), "a tar archive"),
        (gzip.concat(), "gzip data"),
    ] {
        let message = format!("some.obj: not an OBJ file: {name} (unpack it first)");
        assert_eq!(refusal(&bytes), message);
    }
}

#[test]
fn what_is_no_file_is_refused() {
    let folder = Folder::new(&[]);
    let missing = folder.load("no.obj").expect_err("it is not there");
    assert!(
        folder
            .relative(&missing)
            .starts_with("no.obj: cannot be read: "),
        "{missing}"
    );
    std::fs::create_dir(folder.path("dir.obj")).expect("a folder");
    let refused = folder.load("dir.obj").expect_err("it is a folder");
    assert_eq!(folder.relative(&refused), "dir.obj: is not a file");
}

#[test]
fn a_cancelled_load_stops_and_a_whole_one_is_done() {
    let folder = Folder::new(&[("some.obj", CUBE.as_bytes())]);
    let progress = Progress::default();
    load(&folder.path("some.obj"), &progress).expect("it loads");
    assert!((progress.fraction() - 1.0).abs() < f32::EPSILON);
    let progress = Progress::default();
    progress.cancel();
    let stopped = load(&folder.path("some.obj"), &progress);
    assert!(matches!(stopped, Err(ObjError::Cancelled(_))));
}

#[test]
fn a_load_can_be_cancelled_after_the_last_byte_is_read() {
    use std::fmt::Write;
    let mut text = String::new();
    for i in 0..10_000 {
        let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 10_000.0).sin_cos();
        writeln!(text, "v {cos} {sin} 0").expect("text");
    }
    let mut face = String::from("f");
    (1..=10_000).for_each(|i| write!(face, " {i}").expect("text"));
    // A small file that takes seconds to load.
    text += &(face + "\n").repeat(300);
    let folder = Folder::new(&[("some.obj", text.as_bytes())]);
    let progress = Progress::default();
    std::thread::scope(|scope| {
        let loading = scope.spawn(|| load(&folder.path("some.obj"), &progress));
        // Below this fraction the file is being read; above it polygons are being split.
        while progress.fraction() < 0.8 {
            std::thread::yield_now();
        }
        progress.cancel();
        let cancelled = std::time::Instant::now();
        let stopped = loading.join().expect("no panic");
        assert!(
            matches!(stopped, Err(ObjError::Cancelled(_))),
            "{stopped:?}"
        );
        let took = cancelled.elapsed().as_secs_f64();
        assert!(took < 1.0, "one polygon more, not all: {took} s");
    });
}
