//! Files that are made to be slow, large or endless: each one loads or is refused quickly.

use super::{CUBE, Folder, common::Random, parts};
use sightline::scene::{
    Progress,
    obj::{self, ObjError, ObjFile},
};
use std::{
    f64::consts::TAU,
    fmt::Write,
    fs::{self, File},
    time::{Duration, Instant},
};

/// A load that takes longer counts as hung. All loads here take less than a second; in quadratic time, minutes.
const HANGS: Duration = Duration::from_secs(10);

/// Loads an OBJ file with this text, beside an MTL file.
fn load(text: &str, mtl: &str) -> (Folder, Result<ObjFile, ObjError>) {
    let folder = Folder::new(&[("some.obj", text.as_bytes()), ("some.mtl", mtl.as_bytes())]);
    let start = Instant::now();
    let loaded = folder.load("some.obj");
    let took = start.elapsed();
    assert!(
        took < HANGS,
        "{took:?} for {}",
        &text[..text.len().min(200)]
    );
    (folder, loaded)
}

fn triangles(text: &str) -> usize {
    let (_, loaded) = load(text, "");
    loaded.expect("it loads").mesh.data().triangles.len()
}

fn polygon(corners: usize, at: impl FnMut(f64) -> [f64; 3]) -> String {
    let mut text = String::new();
    let counted = std::iter::successors(Some(0.0), |i| Some(i + 1.0)).take(corners);
    for [x, y, z] in counted.map(at) {
        writeln!(text, "v {x} {y} {z}").expect("text");
    }
    text += "f";
    (1..=corners).for_each(|i| write!(text, " {i}").expect("text"));
    text
}

#[test]
fn polygons_of_any_shape() {
    const CORNERS: usize = 40_000;
    let mut random = Random::new(3);
    let mut around = |i: f64, radius: f64, height: f64| {
        let (sin, cos) = (i * TAU / 40_000.0).sin_cos();
        let radius = 1.0 + radius * random.unit();
        [radius * cos, radius * sin, height * random.unit()]
    };
    assert_eq!(
        triangles(&polygon(CORNERS, |i| around(i, 0.0, 0.0))),
        CORNERS - 2
    );
    assert_eq!(
        triangles(&polygon(CORNERS, |i| around(i, 1.0, 0.0))),
        CORNERS - 2
    );
    assert_eq!(
        triangles(&polygon(CORNERS, |i| around(i, 1.0, 0.1))),
        CORNERS - 2
    );
    // Nearly all corners on a line.
    let line = polygon(CORNERS, |i| [i, if i > 0.0 { 1.0 } else { 0.0 }, 0.0]);
    assert_eq!(triangles(&line), CORNERS - 2);
    // Outlines that cross themselves everywhere: first with all corners at different points, then with few points.
    assert!(triangles(&polygon(CORNERS, |_| random.point(1.0).to_array())) > CORNERS / 2);
    let on_grid = polygon(CORNERS, |_| random.point(2.0).round().to_array());
    assert!(triangles(&on_grid) > CORNERS / 2);
    // Outlines that cross themselves, or go round more than once, and for which earcut takes cubic time.
    let around = |turns: f64, up: f64| {
        let triangles = triangles(&polygon(CORNERS, |i| {
            let angle = i * TAU / 40_000.0;
            let radius = if i % 2.0 > 0.0 { 0.4 } else { 1.0 };
            [
                radius * (turns * angle).cos(),
                radius * (up * angle).sin(),
                0.0,
            ]
        }));
        assert!(triangles > CORNERS / 2, "{triangles}");
    };
    around(13_334.0, 13_334.0);
    around(2.0, 3.0);
    around(4.0, 4.0);
    // Nearly all corners at one point.
    assert_eq!(
        triangles(&polygon(CORNERS, |i| [
            i.min(1.0),
            (i - 1.0).clamp(0.0, 1.0),
            0.0
        ])),
        1
    );
    // Many small polygons.
    let crossing = " 1 8 3 6 2 7 4 5".repeat(4);
    assert!(triangles(&format!("{CUBE}{}", format!("f{crossing}\n").repeat(5_000))) > 12);
}

#[test]
fn polygons_of_too_many_corners_are_left_out() {
    let text = polygon((1 << 16) + 1, |i| [i, i * i, 0.0]) + "\nf 1 2 3\n";
    let (folder, loaded) = load(&text, "");
    let told = ["some.obj: faces with too many corners are left out (1)"];
    assert_eq!(folder.warnings(&loaded.expect("it loads")), told);
}

#[test]
fn any_number_of_faces_about_a_vertex() {
    const FACES: usize = 100_000;
    let mut vertices = String::from("v 0 0 1\nv 0 0 2\n");
    for i in 0..=200_000 {
        let (sin, cos) = (f64::from(i) * TAU / 200_001.0).sin_cos();
        writeln!(vertices, "v {cos} {sin} 0").expect("text");
    }
    let faces = |face: fn(usize) -> [usize; 3]| {
        let mut text = vertices.clone();
        for [a, b, c] in (0..FACES).map(face) {
            writeln!(text, "f {a} {b} {c}").expect("text");
        }
        triangles(&text)
    };
    assert_eq!(faces(|i| [1, i + 3, i + 4]), FACES, "a cone");
    assert_eq!(
        faces(|i| [1, FACES - i + 3, FACES - i + 2]),
        FACES,
        "a cone, backwards"
    );
    assert_eq!(
        faces(|i| [1, 2 * i + 3, 2 * i + 4]),
        FACES,
        "no two share an edge"
    );
    assert_eq!(faces(|i| [1, 2, i + 3]), FACES, "all share one");
    assert_eq!(faces(|_| [1, 3, 4]), FACES, "all are the same");
}

#[test]
fn lines_of_any_length_and_number() {
    let joined = format!("{CUBE}{}f 1 2 3\n", "\\\n".repeat(1_000_000));
    assert_eq!(triangles(&joined), 13);
    assert_eq!(
        triangles(&format!("{}{CUBE}", "\r\n".repeat(1_000_000))),
        12
    );
    assert_eq!(
        triangles(&format!("# {}\n{CUBE}", "x".repeat(10_000_000))),
        12
    );
    let bad = "f 1 2 99\nv x\nvn\nf 1/x 2 3\n".repeat(200_000);
    assert_eq!(triangles(&format!("{CUBE}{bad}")), 12);
}

#[test]
fn names_of_any_length_and_number() {
    let long = "ü".repeat(100_000);
    let mut text = format!("{CUBE}o {long}\n");
    (0..20_000).for_each(|i| write!(text, "g {i}\nf 1 2 3\n").expect("text"));
    let (_, loaded) = load(&text, "");
    let file = loaded.expect("it loads");
    let parts = parts(&file.mesh);
    assert_eq!(parts.len(), 20_001);
    assert_eq!(parts[20_000].0, format!("{}…/19999", "ü".repeat(120)));
}

#[test]
fn material_files_of_any_name_and_number() {
    let red = "newmtl red\nKd 1 0 0\n";
    let coloured = |text: &str, told: &[&str]| {
        let (folder, loaded) = load(&format!("{text}usemtl red\n{CUBE}"), red);
        let file = loaded.expect("it loads");
        assert_eq!(folder.warnings(&file), told);
        file.mesh.triangle_colour(0).is_some()
    };
    // One file under many names is read once.
    let mut text = String::new();
    (0..2_000).for_each(|i| writeln!(text, "mtllib {}some.mtl", "./".repeat(i)).expect("text"));
    assert!(coloured(&text, &[]));
    let mut text = String::from("mtllib some.mtl\n");
    (0..20_000).for_each(|i| writeln!(text, "mtllib {i}.mtl").expect("text"));
    let told = "some.obj:2: the material file 0.mtl does not exist; the same with 1.mtl, 2.mtl, 3.mtl, 4.mtl, 5.mtl \
                and 4089 more";
    assert!(coloured(&text, &[told]));
    let (_, loaded) = load(&format!("{CUBE}mtllib {}\n", "a ".repeat(100_000)), red);
    assert_eq!(loaded.expect("it loads").warnings.len(), 1);
    // A name may lead to any file, but only materials are read from it.
    let escapes = "mtllib ../../../../../../../../../../../../etc/passwd\n";
    let told = format!(
        "some.obj:1: the material file {} has no materials in it",
        &escapes.trim()[7..]
    );
    if fs::exists("/etc/passwd").is_ok_and(|exists| exists) {
        assert!(!coloured(escapes, &[&told]));
    }
    assert!(!coloured(
        "mtllib .\n",
        &["some.obj:1: the material file . is not a file"]
    ));
    let ring = "mtllib some.obj\ncall some.obj\n";
    assert!(!coloured(
        ring,
        &["some.obj:1: the material file some.obj has no materials in it"]
    ));
    let mut many = String::new();
    (0..100_000).for_each(|i| write!(many, "newmtl {i}\nmap_Kd {i}.png\nKd x\n").expect("text"));
    let mut text = format!("mtllib some.mtl\n{CUBE}");
    (0..100_000).for_each(|i| write!(text, "usemtl {i}\nf 1 2 3\n").expect("text"));
    let (folder, loaded) = load(&text, &many);
    let told = [
        "some.obj: textures are not shown (100000 files: 0.png, 1.png, 2.png, 3.png, 4.png and 99995 more)",
        "some.mtl:3: Kd is not a colour: it takes one to three numbers (more such lines: 99999)",
    ];
    assert_eq!(folder.warnings(&loaded.expect("it loads")), told);
}

#[test]
fn files_too_large_to_be_meant() {
    let folder = Folder::new(&[("some.obj", format!("mtllib big.mtl\n{CUBE}").as_bytes())]);
    let make = |name: &str, bytes| {
        File::create(folder.path(name))
            .and_then(|file| file.set_len(bytes))
            .expect("a file with a hole");
    };
    make("big.obj", (1 << 32) + 1);
    let refused = folder.load("big.obj").expect_err("it is refused");
    assert_eq!(
        folder.relative(&refused),
        "big.obj: is too large: more than 4 GiB"
    );
    make("big.mtl", (1 << 26) + 1);
    let file = folder.load("some.obj").expect("it loads");
    assert_eq!(
        folder.warnings(&file),
        ["some.obj:1: the material file big.mtl is too large"]
    );
}

/// Files of the system whose size says 0 bytes. One holds about 256 GB, one the name of this thread.
#[cfg(target_os = "linux")]
#[test]
fn files_longer_than_their_size_says() {
    let thread = fs::canonicalize("/proc/thread-self").expect("this thread");
    fs::write(thread.join("comm"), "newmtl a").expect("its name");
    for target in [thread.join("comm"), "/proc/self/pagemap".into()] {
        let folder = Folder::new(&[(
            "some.obj",
            format!("mtllib link.mtl\nusemtl a\n{CUBE}").as_bytes(),
        )]);
        for name in ["link.obj", "link.mtl"] {
            std::os::unix::fs::symlink(&target, folder.path(name)).expect("a link");
        }
        let refused = folder.load("link.obj").expect_err("it is refused");
        assert_eq!(folder.relative(&refused), "link.obj: the file is empty");
        let file = folder.load("some.obj").expect("it loads");
        assert_eq!(
            folder.warnings(&file),
            ["some.obj:1: the material file link.mtl has no materials in it"]
        );
    }
}

/// A file with holes, whose bytes are 0 and take no space on the disk.
#[test]
fn gigabytes_of_nothing_are_refused_at_once() {
    let starts: [&[u8]; 3] = [b"", CUBE.as_bytes(), b"\xff\xfe#\0\n\0"];
    for start in starts {
        let folder = Folder::new(&[("some.obj", start)]);
        let path = folder.path("some.obj");
        File::options()
            .write(true)
            .open(&path)
            .and_then(|file| file.set_len(1 << 32))
            .expect("a file with a hole");
        let progress = Progress::default();
        let refused = obj::load(&path, &progress).expect_err("it is refused");
        assert_eq!(
            folder.relative(&refused),
            "some.obj: not an OBJ file: binary data"
        );
        // The progress is at 1 after 5 GiB.
        assert!(progress.fraction() < 1e-3, "{}", progress.fraction());
    }
}

#[cfg(unix)]
#[test]
fn what_is_no_regular_file() {
    let folder = Folder::new(&[("some.obj", format!("mtllib pipe.obj\n{CUBE}").as_bytes())]);
    let made = std::process::Command::new("mkfifo")
        .arg(folder.path("pipe.obj"))
        .status();
    assert!(made.expect("mkfifo").success());
    let refused = folder.load("pipe.obj").expect_err("it is refused");
    assert_eq!(folder.relative(&refused), "pipe.obj: is not a file");
    let file = folder.load("some.obj").expect("it loads");
    assert_eq!(
        folder.warnings(&file),
        ["some.obj:1: the material file pipe.obj is not a file"]
    );
    std::os::unix::fs::symlink("loop.obj", folder.path("loop.obj")).expect("a link");
    let refused = folder.load("loop.obj").expect_err("it is refused");
    assert!(
        folder
            .relative(&refused)
            .starts_with("loop.obj: cannot be read: "),
        "{refused}"
    );
}
