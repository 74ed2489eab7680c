//! Extreme views that were once drawn wrongly and excused are now drawn right, or verify says that they are beyond
//! `f32`: near or far on a visible surface, planes close together far away, matrices that flatten, scenes too large for
//! `f32`, extremely distant eyes. Each case is the command that found it.

use glam::{DMat3, DVec3};
use serde_json::Value;
use std::{
    path::PathBuf,
    process::{Command, Output},
};

/// A scene file in a folder of its own.
pub fn scene(toml: &str) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("scene.toml");
    std::fs::write(&file, toml).expect("a file");
    (folder, file)
}

pub fn run(scene: Option<&PathBuf>, args: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_sightline"));
    command.arg("verify").args(scene).arg("--json");
    command
        .args(args.split_whitespace())
        .env("RUST_LOG", "error");
    command.output().expect("the program runs")
}

/// The counts of a run, and its exit code.
pub struct Counts {
    pub line: Value,
    pub code: Option<i32>,
    pub stderr: String,
}

impl Counts {
    pub fn of(output: Output) -> Self {
        let stderr = String::from_utf8(output.stderr).expect("text");
        let line = serde_json::from_slice(&output.stdout);
        Self {
            line: line.unwrap_or_else(|error| panic!("{error}: {stderr}")),
            code: output.status.code(),
            stderr,
        }
    }

    pub fn get(&self, name: &str) -> u64 {
        self.line[name]
            .as_u64()
            .unwrap_or_else(|| panic!("{name}: {}", self.line))
    }

    /// Asserts that pixels differ by an edge or by depth alone, edges as few as centres lie within two steps of the
    /// rasteriser's grid of an outline, and that enough pixels are shown.
    #[track_caller]
    fn agree(&self, least_shown: u64) {
        assert_eq!(self.code, Some(0), "{} {}", self.line, self.stderr);
        let differ = self.get("pixels") - self.get("same");
        assert_eq!(
            differ,
            self.get("edge") + self.get("depth"),
            "{}",
            self.line
        );
        let near_edges = (4 * self.get("outline")) >> self.get("sub_pixel_bits");
        assert!(
            self.get("edge") <= near_edges + 4 && self.get("depth") <= 10,
            "{}",
            self.line
        );
        for side in ["drawn", "picked"] {
            assert!(self.get(side) >= least_shown, "{}", self.line);
        }
    }
}

/// A wall, which the views of the test see at depth 2 exactly.
const WALL: &str = "[[object]]\nshape = \"square\"\nscale = 3\n";

#[test]
fn a_plane_exactly_on_a_wall() {
    let (_folder, wall) = scene(WALL);
    let view = "--size 200x150 --eye 0,0,2 --look 0,0,-1";
    let near = Counts::of(run(Some(&wall), &format!("{view} --near 2 --far 10")));
    assert_eq!(near.get("same"), 200 * 150, "{}", near.line);
    assert_eq!([near.get("drawn"), near.get("picked")], [200 * 150; 2]);
    let far = Counts::of(run(Some(&wall), &format!("{view} --near 1 --far 2")));
    assert_eq!(far.get("same"), 200 * 150, "{}", far.line);
    assert_eq!([far.get("drawn"), far.get("picked")], [0, 0]);
}

const MIXED: &str = r#"
[[object]]
shape = "sphere"
scale = [1, 0.8, 0.7]
rotation = [20, 30, 40]
position = [0.3, 0.1, 0]
[[object]]
shape = "cube"
scale = 0.6
rotation = [10, 70, 20]
position = [-0.4, 0.1, 0]
[[object]]
shape = "square"
rotation = [10, 20, 20]
position = [-0.4, -0.5, 0]
"#;

/// Once nothing was drawn here, and verify excused it.
#[test]
fn planes_close_together_in_the_distance() {
    let (_folder, mixed) = scene(MIXED);
    let eye = "--size 320x240 --eye 60000000,48000000,100000000 --target 0,0,0 \
               --fov 9.086558868057237e-07";
    for planes in ["", "--near 126111057.16347557 --far 126111067.16347557"] {
        for depth in ["reversed", "standard"] {
            let view = format!("{eye} {planes} --depth {depth}");
            Counts::of(run(Some(&mixed), &view)).agree(15_000);
        }
    }
}

/// From eyes 1e7 to 1e12 units away, drawing and picking agree as well as from nearby.
#[test]
fn eyes_far_away() {
    for distance in [1e7, 1e9, 1e11, 1e12] {
        let eye = distance * DVec3::new(0.6, 0.48, 1.0);
        let fov = (2.0 * (3.0 / eye.length()).atan()).to_degrees();
        let view = format!(
            "--size 160x120 --eye {},{},{} --target 0,0.5,0 --fov {fov}",
            eye.x, eye.y, eye.z
        );
        Counts::of(run(None, &view)).agree(6000);
    }
}

/// A matrix with two columns that differ by 1e-14 of their length, and a cube 1e-8 thick, also through a long lens.
#[test]
fn matrices_that_flatten() {
    let (_folder, sphere) = scene(
        "[[object]]\nshape = \"sphere\"\nmatrix = [[0.9116846116771036, 0.9116846116771158, -0.04652421051992356, 0],
        [0.3418817293789138, 0.34188172937888933, -0.4652421051992355, 0],
        [-0.2279211529192759, -0.22792115291926365, -0.8839599998785473, 0]]\n",
    );
    Counts::of(run(Some(&sphere), "--size 160x120")).agree(900);
    let (_folder, cube) = scene(
        "[[object]]\nshape = \"cube\"\nmatrix = [[0.8383866435942036, -0.2593433800522308, 0.479425538604203, 0],
        [5.210862105571308e-09, 6.394089303668974e-09, -5.653542083811438e-09, 0],
        [-0.15992809950116813, 0.7238074543621006, 0.6712121661589577, 0]]\n",
    );
    Counts::of(run(Some(&cube), "--size 160x120")).agree(2000);
    let long = "--size 160x120 --eye 60000,48000,100000 --target 0,0,0 --fov 0.0007";
    Counts::of(run(Some(&cube), long)).agree(3000);
}

/// Scenes of any size are framed, drawn and picked, or refused with one line.
#[test]
fn scenes_of_any_size() {
    for exponent in [-24, -15, 15, 29] {
        let text = format!(
            "[[object]]\nshape = \"sphere\"\nscale = 1e{exponent}
            [[object]]\nshape = \"cube\"\nscale = 1e{exponent}\nposition = [1e{exponent}, 0, 0]\n"
        );
        let (_folder, file) = scene(&text);
        Counts::of(run(Some(&file), "--size 96x64")).agree(1500);
    }
    for (exponent, code, said) in [
        (-300, 3, "no inverse"),
        (-30, 2, "units across"),
        (-26, 2, "units across"),
        (31, 2, "units across"),
        (150, 3, "up to 1.29e33"),
    ] {
        let text = format!("[[object]]\nshape = \"cube\"\nscale = 1e{exponent}\n");
        let (_folder, file) = scene(&text);
        let output = run(Some(&file), "--size 96x64");
        let stderr = String::from_utf8(output.stderr).expect("text");
        assert_eq!(output.status.code(), Some(code), "1e{exponent}: {stderr}");
        assert_eq!(stderr.lines().count(), 1, "{stderr}");
        assert!(stderr.contains(said), "{stderr}");
    }
}

/// Coordinates are 1e13 times the size of features, in placements and in a mesh's own vertices under a rotation.
#[test]
fn far_from_the_origin() {
    let turn = DMat3::from_rotation_y(0.5) * DMat3::from_rotation_x(0.3);
    let vertex = DVec3::new(3e12, -7e12, 5e12);
    let at = turn * vertex;
    let [x, y, z] = [0, 1, 2].map(|i| turn.row(i).to_array());
    let mut text = format!(
        "[[object]]\nshape = \"mesh\"\nfile = \"far.obj\"
        matrix = [[{}, {}, {}, 0], [{}, {}, {}, 0], [{}, {}, {}, 0]]\n",
        x[0], x[1], x[2], y[0], y[1], y[2], z[0], z[1], z[2]
    );
    let others = ["sphere", "cube", "square"]
        .into_iter()
        .zip([1.0, -1.2, -0.4]);
    let others = others.map(|(shape, aside)| {
        let DVec3 { x, y, z } = at + aside * DVec3::X + DVec3::Z;
        format!("[[object]]\nshape = \"{shape}\"\nposition = [{x}, {y}, {z}]\n")
    });
    text.extend(others);
    let (folder, file) = scene(&text);
    let corners = [
        [0.0, 0.0, 0.0],
        [1.5, 0.0, 0.5],
        [0.0, 1.5, 0.5],
        [-1.0, -1.0, 0.5],
    ];
    let corners = corners.map(|corner| vertex + DVec3::from_array(corner));
    let mut obj: String = corners
        .map(|p| format!("v {} {} {}\n", p.x, p.y, p.z))
        .concat();
    obj += "f 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n";
    std::fs::write(folder.path().join("far.obj"), obj).expect("a file");
    let eye = at + DVec3::new(1.0, 2.0, 4.0);
    let view = format!(
        "--size 160x120 --eye {},{},{} --target {},{},{}",
        eye.x, eye.y, eye.z, at.x, at.y, at.z
    );
    Counts::of(run(Some(&file), &view)).agree(3000);
}

/// The nearest near planes in the range of numbers. It is up to the driver whether any pixel goes wrong.
#[test]
fn a_near_plane_next_to_the_eye() {
    for near in ["1e-33", "7.8e-34"] {
        let counts = Counts::of(run(None, &format!("--size 160x120 --near {near}")));
        assert_eq!(counts.get("unexplained"), 0, "{near}: {}", counts.line);
        assert!(counts.get("picked") > 6000, "{near}: {}", counts.line);
        let lost = counts.get("beyond_f32") > 0;
        assert_eq!(
            counts.code,
            Some(i32::from(lost)),
            "{near}: {}",
            counts.line
        );
    }
}

/// With planes at the limits of the range of numbers.
#[test]
fn planes_farther_off_than_f32_can_hold() {
    for far in ["1e33", "1.2e33"] {
        for depth in ["reversed", "standard"] {
            let planes = format!("--ortho 3 --near=-{far} --far {far} --depth {depth}");
            let view = format!("--size 160x120 --eye 1,2,6 --target 0,0,0 {planes}");
            let counts = Counts::of(run(None, &view));
            assert_eq!(counts.get("unexplained"), 0, "{planes}: {}", counts.line);
            assert_eq!(counts.code, Some(1), "{planes}: {}", counts.line);
            assert!(counts.get("picked") > 10_000, "{planes}: {}", counts.line);
            assert!(counts.get("beyond_f32") > 5000, "{planes}: {}", counts.line);
            assert!(
                counts.stderr.contains("render --by raycast"),
                "{}",
                counts.stderr
            );
            assert_eq!(counts.stderr.lines().count(), 1, "{}", counts.stderr);
        }
    }
}

/// Lenses so wide that one pixel at the border spans more than the middle of the picture.
#[test]
fn the_widest_lenses() {
    for fov in ["179", "179.9", "179.999"] {
        for depth in ["reversed", "standard"] {
            let view = format!(
                "--size 160x120 --eye 0.3,0.6,0.9 --target 0,0.5,0 --near 1e-4 --far 100 --fov {fov} --depth {depth}"
            );
            let counts = Counts::of(run(None, &view));
            assert_eq!(
                counts.get("unexplained"),
                0,
                "{fov} {depth}: {}",
                counts.line
            );
            assert!(counts.get("drawn") > 50, "{fov} {depth}: {}", counts.line);
            let failed = counts.get("beyond_f32") > 0;
            assert_eq!(
                counts.code,
                Some(i32::from(failed)),
                "{fov} {depth}: {}",
                counts.line
            );
        }
    }
}

/// Vertices of 1e8 under a matrix of 1e-33, whose products a driver may flush to 0. Drawing holds such numbers with
/// near and far planes that fit. With a distant far plane it may lose them, and verify says so.
#[test]
fn matrices_below_what_f32_holds() {
    let (folder, file) = scene(
        "[[object]]\nshape = \"mesh\"\nfile = \"far.obj\"\nscale = 1e-33\nrotation = [20, 30, 0]\n",
    );
    let corners = ["-1e8 -1e8 0", "1e8 -1e8 0", "0 1e8 0"].map(|at| format!("v {at}\n"));
    let obj = corners.concat() + "f 1 2 3\n";
    std::fs::write(folder.path().join("far.obj"), obj).expect("a file");
    let flags = "--eye 0,0,6e-25 --target 0,0,0 --fov 40 --size 64x48 --near 1e-27";
    let held = Counts::of(run(Some(&file), &format!("{flags} --far 2e-24")));
    held.agree(150);
    let beyond = Counts::of(run(Some(&file), &format!("{flags} --far 1.6")));
    assert_eq!(beyond.get("unexplained"), 0, "{}", beyond.line);
    assert!(beyond.get("picked") > 150, "{}", beyond.line);
    let lost = beyond.get("beyond_f32") > 0 || beyond.get("drawn") == 0;
    assert_eq!(beyond.code, Some(i32::from(lost)), "{}", beyond.stderr);
}

/// Edges that a near plane just before the eye cuts beside it, far outside the picture.
#[test]
fn edges_that_begin_beside_the_eye_are_where_they_are_drawn() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("fins.obj");
    std::fs::write(&file, FINS).expect("a file");
    for near in ["1e-6", "1.7194707655031198e-12"] {
        let args = format!(
            "--size 640x480 --eye 0,0,0 --look -0.017325137228178522,0.25533366041445077,-1.0 --up 0,1,0 --fov 90 \
             --near {near} --far 100"
        );
        let counts = Counts::of(run(Some(&file), &args));
        assert_eq!(counts.code, Some(0), "{near}: {}", counts.line);
        assert!(counts.get("picked") >= 1000, "{near}: {}", counts.line);
    }
}

const FINS: &str = "
v 0.4257082520821909 -0.09185145650636373 3.0
v 0.473825344623509 -0.8835301085064693 -3.0
v 0.9467692499997158 -0.5521253166299775 -1.9526597725486015
v -0.6623124960524833 0.12476121413337182 3.0
v -0.4905618957227491 0.4513961204299477 -3.0
v -0.050123739651577015 1.081948974630229 -2.918629913673244
v 0.6695077354771919 -0.3567177979858427 3.0
v 0.4637768439484238 -0.6548947519398154 -3.0
v 1.4584003445153302 1.7155174606121402 -0.5656979711195023
v 0.33600165861811293 0.7906354758726128 3.0
v -0.4293441580246935 0.5115039287352472 -3.0
v -1.7662662178651587 1.0447756438396776 -2.4128438502219702
v -0.596079234598907 -0.1516515286777591 3.0
v 0.6622111298578155 0.5485264384620632 -3.0
v 0.5869105691021788 1.7826515012539366 -0.8687633396075118
v -0.49920968125461584 -0.6795106381311493 3.0
v -0.08203328733374149 0.6439525496956364 -3.0
v -1.2629039944649283 0.9276712105459355 1.6264745782215222
f 1 2 3
f 4 5 6
f 7 8 9
f 10 11 12
f 13 14 15
f 16 17 18
";
