//! Objects, groups and materials are those of the file, whichever way it is written.

use super::{CUBE, Folder, bounds, mesh, parts};
use glam::DVec3;
use sightline::colour::Srgb;

const RED: &[u8] = b"newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n";

/// Vertices 1 to 5 of a strip of three triangles.
const STRIP: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 2 0\n";

#[test]
fn materials_split_colours_and_not_objects() {
    let text = format!(
        "mtllib red.mtl\n{STRIP}o Sheet\nusemtl red\nf 1 2 3\nusemtl blue\nf 2 4 3\nusemtl red\nf 3 4 5\n"
    );
    let folder = Folder::new(&[("some.obj", text.as_bytes()), ("red.mtl", RED)]);
    let file = folder.load("some.obj").expect("it loads");
    assert_eq!(folder.warnings(&file), [""; 0]);
    assert_eq!(parts(&file.mesh), [("Sheet", 3)]);
    let colours: Vec<_> = (0..3).map(|i| file.mesh.triangle_colour(i)).collect();
    let (red, blue) = (Some(Srgb([255, 0, 0])), Some(Srgb([0, 0, 255])));
    assert_eq!(colours, [red, blue, red]);
    assert_eq!(
        file.mesh.data().positions.len(),
        5,
        "a vertex is one across materials"
    );
}

#[test]
fn objects_of_one_name_stay_two_and_a_group_goes_on() {
    let repeated = mesh(&format!("{STRIP}o Cube\nf 1 2 3\no Cube\nf 2 4 3\n"));
    assert_eq!(parts(&repeated), [("Cube", 1), ("Cube", 1)]);
    let group = mesh(&format!(
        "{STRIP}g wall\nf 1 2 3\ng wall\nf 2 4 3\ng roof\nf 3 4 5\n"
    ));
    assert_eq!(parts(&group), [("wall", 2), ("roof", 1)]);
    assert_eq!(
        group.data().positions.len(),
        5,
        "walls share their vertices"
    );
}

#[test]
fn names_come_from_object_then_group_then_file() {
    let one_group = mesh(&format!("{STRIP}o House\ng House_default\nf 1 2 3\n"));
    assert_eq!(parts(&one_group), [("House", 1)]);
    let two_groups = mesh(&format!(
        "{STRIP}o House\ng wall\nf 1 2 3\ng roof\nf 2 4 3\n"
    ));
    assert_eq!(parts(&two_groups), [("House/wall", 1), ("House/roof", 1)]);
    let unnamed = mesh(&format!("{STRIP}f 1 2 3\ng\nf 2 4 3\no  A # B \nf 3 4 5\n"));
    assert_eq!(parts(&unnamed), [("some", 2), ("A # B", 1)]);
    let later = mesh(&format!(
        "{STRIP}g wall\nf 1 2 3\no A\nf 2 4 3\ng roof\nf 3 4 5\n"
    ));
    assert_eq!(parts(&later), [("wall", 1), ("A", 1), ("A/roof", 1)]);
    let empty = mesh(&format!("o Nothing\n{STRIP}o Number #2\nf 1 2 3\no Last\n"));
    assert_eq!(parts(&empty), [("Number #2", 1)]);
}

#[test]
fn missing_materials_are_told_once() {
    let text = format!("mtllib no.mtl\n{CUBE}usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n");
    let folder = Folder::new(&[("some.obj", text.as_bytes())]);
    let file = folder.load("some.obj").expect("it loads");
    let told = ["some.obj:1: the material file no.mtl does not exist"];
    assert_eq!(folder.warnings(&file), told);

    let text = "mtllib red.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 1 3 2\n";
    let folder = Folder::new(&[("some.obj", text.as_bytes()), ("red.mtl", RED)]);
    let file = folder.load("some.obj").expect("it loads");
    assert_eq!(
        folder.warnings(&file),
        ["some.obj:5: no material file defines a, b"]
    );
    assert_eq!(file.mesh.triangle_colour(0), None);
}

#[test]
fn kd_takes_one_value_and_survives_garbage() {
    let library = b"Kd 1 1 1\nnewmtl grey\nKd 0.5\nnewmtl bad\nKd nan 0 0\nNs abc\nKd 1 x\nillum 99\nKs 0.2\n\
        newmtl last\nKd 0 1 0 # green";
    let text = format!(
        "mtllib\ta file.mtl\n{STRIP}usemtl grey\nf 1 2 3\nusemtl bad\nf 2 4 3\nusemtl\tlast\nf 3 4 5\n"
    );
    let folder = Folder::new(&[("some.obj", text.as_bytes()), ("a file.mtl", library)]);
    let file = folder.load("some.obj").expect("it loads");
    let told =
        ["a file.mtl:5: Kd is not a colour: it takes one to three numbers (more such lines: 1)"];
    assert_eq!(folder.warnings(&file), told);
    let colours: Vec<_> = (0..3).map(|i| file.mesh.triangle_colour(i)).collect();
    assert_eq!(
        colours,
        [Some(Srgb([128; 3])), None, Some(Srgb([0, 255, 0]))]
    );
}

#[test]
fn textures_and_transparency_are_named_once() {
    let library = b"newmtl a\nKd 1 1 1\nmap_Kd wood.png\nmap_Bump -bm 0.5 bumps.png\nd 0.5\n\
        newmtl b\nmap_Kd wood.png\nmap_d leaf mask.png\nnewmtl unused\nmap_Kd unused.png\nd 0\n";
    let text = format!("mtllib a.mtl\n{STRIP}usemtl a\nf 1 2 3\nusemtl b\nf 2 4 3\n");
    let folder = Folder::new(&[("some.obj", text.as_bytes()), ("a.mtl", library)]);
    let file = folder.load("some.obj").expect("it loads");
    let told = [
        "some.obj: textures are not shown (3 files: wood.png, bumps.png, leaf mask.png)",
        "some.obj: transparency is not shown: 1 material is drawn opaque",
    ];
    assert_eq!(folder.warnings(&file), told);
}

#[test]
fn each_way_of_writing_reads_the_same() {
    let plain = mesh(CUBE);
    let tabs = CUBE.replace(' ', "\t");
    let crlf = CUBE.replace('\n', "\r\n");
    let ways = [
        format!("\u{feff}{CUBE}"),
        CUBE.replace('\n', " # comment\n"),
        CUBE.replacen("f 4 3 2 1", "f 4 3 \\\n 2 1", 1),
        CUBE.replacen("f 4 3 2 1", "f -5 -6 -7 -8", 1),
        CUBE.replacen("f 4 3 2 1", "f 4/1 3/2 2/3 1/4", 1),
        CUBE.replace("v 1 ", "v +1.0e0 "),
        format!("vt 0 0\nvp 1 2\ns off\n{}", CUBE.trim_end()),
        CUBE.replacen("v 0 0 0", "v 0 0 0 2.5", 1),
        tabs,
        crlf,
    ];
    for text in ways {
        let other = mesh(&text);
        assert_eq!(other.data().positions, plain.data().positions, "{text}");
        assert_eq!(other.data().triangles, plain.data().triangles, "{text}");
    }
}

#[test]
fn names_of_another_encoding_are_kept_readable() {
    let mut bytes = b"o Stra\xdfe\r\n".to_vec();
    bytes.extend(CUBE.as_bytes());
    let folder = Folder::new(&[("some.obj", &bytes)]);
    let file = folder.load("some.obj").expect("it loads");
    assert_eq!(parts(&file.mesh), [("Stra\u{df}e", 12)]);
}

#[test]
fn what_is_not_a_surface_is_counted() {
    let text = format!("{CUBE}f 1 2\nf 3\nl 1 2 3\np 1\ncurv 0 1 1 2\nf 1 1 2\nf 1 2 3\n");
    let folder = Folder::new(&[("some.obj", text.as_bytes())]);
    let file = folder.load("some.obj").expect("it loads");
    let told = [
        "some.obj: triangles without area are left out (1)",
        "some.obj: points and lines are not shown (4)",
        "some.obj: free-form curves and surfaces are not shown (1)",
    ];
    assert_eq!(folder.warnings(&file), told);
    assert_eq!(parts(&file.mesh), [("some", 13)]);
}

#[test]
fn vertices_without_a_face_are_outside_the_bounds() {
    let stray = mesh(&format!("{CUBE}v 1000 0 1000\nv -50 0 0\n"));
    assert_eq!(stray.data().positions.len(), 8);
    assert_eq!(
        (bounds(&stray).min, bounds(&stray).max),
        (DVec3::ZERO, DVec3::ONE)
    );
}
