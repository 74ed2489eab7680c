//! What is valid loads: a bad line affects only the faces that depend on it.

use super::{CUBE, Folder, bounds, parts};
use glam::DVec3;

/// Asserts that the cube loads in spite of the bad lines around it, with these warnings.
fn assert_cube_and(text: &str, told: &[&str]) {
    let folder = Folder::new(&[("some.obj", text.as_bytes())]);
    let file = folder.load("some.obj").expect("it loads");
    assert_eq!(folder.warnings(&file), told, "{text}");
    assert_eq!(parts(&file.mesh), [("some", 12)], "{text}");
    let bounds = bounds(&file.mesh);
    assert_eq!(
        (bounds.min, bounds.max),
        (DVec3::ZERO, DVec3::ONE),
        "{text}"
    );
}

#[test]
fn faces_with_vertices_that_are_not_there_are_left_out() {
    for (corner, named) in [
        ("0", "0 of 8"),
        ("9", "9 of 8"),
        ("4294967297", "4294967297 of 8"),
        ("x/1/1", "x of 8"),
        ("18446744073709551617", "18446744073709551617 of 8"),
    ] {
        let told = format!("some.obj:15: a face names vertex {named}; it is left out");
        assert_cube_and(&format!("{CUBE}f 1 2 {corner}\n"), &[&told]);
    }
    let told = "some.obj:15: a face counts back to before the first vertex; it is left out";
    assert_cube_and(&format!("{CUBE}f 1 2 -9\n"), &[told]);
    // The warning names the first bad line in the file.
    assert_cube_and(
        &format!("# first\n{CUBE}f 1 2 9\nf 1 2 12\nf 1 2 0"),
        &["some.obj:16: a face names vertex 9 of 8; it is left out (more such lines: 2)"],
    );
    // Vertices may come after the faces that name them.
    let (vertices, faces) = CUBE.split_at(CUBE.find('f').expect("faces"));
    assert_cube_and(&format!("{faces}{vertices}"), &[]);
    assert_cube_and(
        &format!("f 1 2 9\n{faces}{vertices}"),
        &["some.obj:1: a face names vertex 9 of 8; it is left out"],
    );
}

#[test]
fn faces_of_another_form_are_left_out() {
    for corner in ["1/x", "1/1/1/1", "1/--1/1"] {
        assert_cube_and(
            &format!("{CUBE}f {corner} 2 3\n"),
            &[
                "some.obj:15: a corner of a face is written as 1, 1/2, 1//3 or 1/2/3; it is left out",
            ],
        );
    }
    // The indices of texture coordinates are not checked.
    assert_cube_and(&CUBE.replacen("f 4 3", "f 4/0 3/99/", 1), &[]);
}

#[test]
fn vertices_that_cannot_be_read_keep_their_numbers() {
    for (coordinates, what) in [
        ("0 one 0", "a vertex needs three numbers"),
        ("0 1", "a vertex needs three numbers"),
        ("", "a vertex needs three numbers"),
        ("0 nan 0", "a coordinate is not a number up to 1.29e33"),
        ("-inf 0 0", "a coordinate is not a number up to 1.29e33"),
        ("0 0 -1.3e33", "a coordinate is not a number up to 1.29e33"),
        ("0 0 1e400", "a coordinate is not a number up to 1.29e33"),
    ] {
        let told = format!("some.obj:1: {what}");
        let faces = "f 5 4 3 2\nf 6 7 8 9\nf 2 3 7 6\nf 3 4 8 7\nf 4 5 9 8\nf 5 2 6 9\n";
        let (vertices, _) = CUBE.split_at(CUBE.find('f').expect("faces"));
        let stays = format!("v {coordinates}\n{vertices}{faces}");
        assert_cube_and(&stays, &[&told]);
        let gone = "some.obj: faces with a vertex that cannot be read are left out (2)";
        assert_cube_and(&format!("{stays}f 1 2 3\nf 4 1 1 2\n"), &[&told, gone]);
    }
}

#[test]
fn normals_that_cannot_be_read_keep_their_numbers() {
    let text = format!("{CUBE}vn 0 x 1\nvn 0 0 1\nvn 0 1\nf 5//2 6//2 7//2\nf 5//1 6//2 7//2\n");
    let folder = Folder::new(&[("some.obj", text.as_bytes())]);
    let file = folder.load("some.obj").expect("it loads");
    let told = ["some.obj:15: a normal needs three numbers; it is computed (more such lines: 1)"];
    assert_eq!(folder.warnings(&file), told);
    let normals = file.mesh.normals();
    let corners = normals.corners_of(&file.mesh.data().triangles);
    let of = |triangle: usize| corners[triangle].map(|i| normals.normals[i as usize]);
    assert_eq!(of(12), [[0.0, 0.0, 1.0]; 3]);
}

#[test]
fn each_kind_of_bad_line_is_told_once() {
    let bad = "v 0 one 0\nv nan 0 0\nvn 0\nf 1/x 2 3\nf 1 2 0\n";
    let text = format!("{CUBE}{}", bad.repeat(1000));
    let folder = Folder::new(&[("some.obj", text.as_bytes())]);
    let file = folder.load("some.obj").expect("it loads");
    assert_eq!(
        folder.warnings(&file),
        [
            "some.obj:15: a vertex needs three numbers (more such lines: 999)",
            "some.obj:16: a coordinate is not a number up to 1.29e33 (more such lines: 999)",
            "some.obj:17: a normal needs three numbers; it is computed (more such lines: 999)",
            "some.obj:18: a corner of a face is written as 1, 1/2, 1//3 or 1/2/3; it is left out \
             (more such lines: 999)",
            "some.obj:19: a face names vertex 0 of 2008; it is left out (more such lines: 999)",
        ]
    );
}
