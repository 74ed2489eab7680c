//! `--budget` prints five lines, and the methods' measured errors stay within its estimates.

use super::gallery::view_of;
use sightline::{
    camera::View,
    scene::{
        self, Loaded, Progress,
        gallery::{Exhibit, GALLERY},
    },
    study::{
        self, Effort, Report, SceneRays,
        step::Precision::{F32, F64},
    },
};
use std::{collections::HashMap, fmt::Write, path::PathBuf, process::Command};

/// UTM's easting and northing.
const MAP: [f64; 2] = [447_000.037, 5_350_050.041];

/// Blocks, balls and signs of a town, turned and stretched, about a point of the world.
fn town(folder: &tempfile::TempDir, [east, north]: [f64; 2], camera: &str) -> PathBuf {
    let (eye, target) = (
        [east + 310.0625, north - 29.7, 180.7],
        [east + 100.2, north + 110.9, 12.3],
    );
    let mut text = format!("[camera]\neye = {eye:?}\ntarget = {target:?}\n{camera}\n");
    for i in 0..60_u32 {
        let shape = ["cube", "sphere", "square"][i as usize % 3];
        let at = |step: f64| f64::from(i) * step % 211.0;
        let [x, y] = [east + at(37.13), north + at(83.71)];
        let size = 4.7 + f64::from(i % 7) * 3.1;
        writeln!(
            text,
            "[[object]]\nshape = \"{shape}\"\nposition = [{x}, {y}, {}]\nscale = [{size}, {}, {}]\nrotation = [{}, 20, {}]",
            0.4 * size,
            1.7 * size,
            2.3 * size,
            i * 13 % 90,
            i * 29 % 360,
        )
        .expect("text");
    }
    let file = folder.path().join("town.toml");
    std::fs::write(&file, text).expect("a file");
    file
}

/// Scenes seen through a lens so long that a rounding error of `f32` is many pixels. The targets lie on outlines.
fn long_lenses(folder: &tempfile::TempDir) -> Vec<PathBuf> {
    let needles = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/gallery/needles.obj");
    std::fs::copy(needles, folder.path().join("needles.obj")).expect("a mesh");
    let scenes = [
        ("sphere", "", "[0.28767, -0.40897, 0]"),
        ("cube", "", "[0.5, -0.5, 0.1]"),
        ("square", "", "[0.5, 0.1, 0]"),
        ("mesh", "file = \"needles.obj\"", "[0.9, 0, 0]"),
    ];
    let scene = |(shape, file, target): (&str, &str, &str)| {
        let text = format!(
            "[camera]\neye = [612.3, 430.7, 730.1]\ntarget = {target}\nfov = 1e-5\n[[object]]\nshape = \"{shape}\"\n{file}\n"
        );
        let path = folder.path().join(shape).with_extension("toml");
        std::fs::write(&path, text).expect("a file");
        path
    };
    scenes.map(scene).to_vec()
}

fn studied(path: PathBuf) -> (SceneRays, View, Report) {
    let loaded: Loaded = scene::load(&[path], &Progress::default()).expect("a scene");
    let view = view_of(&loaded, 321, 180);
    let rays = SceneRays::new(&loaded.scene, view, 800, 1);
    let effort = Effort {
        rounds: 0,
        ..Effort::SCENE_ONLY
    };
    let report = study::run(effort, Some(&rays), &|_, _| {});
    (rays, view, report)
}

#[test]
fn no_estimate_is_beaten_by_what_was_measured() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut scenes: Vec<PathBuf> = GALLERY.iter().map(Exhibit::path).collect();
    scenes.push(town(&folder, MAP, "fov = 60"));
    let parallel = tempfile::tempdir().expect("a folder");
    scenes.push(town(&parallel, MAP, "ortho = 150"));
    let lens = tempfile::tempdir().expect("a folder");
    scenes.extend(long_lenses(&lens));
    let mut seen: HashMap<&str, usize> = HashMap::new();
    for path in scenes {
        let (rays, view, report) = studied(path.clone());
        for estimate in [F32, F64]
            .map(|p| study::estimates(&rays, &view, &report, p))
            .concat()
        {
            let measured = study::measured(&report, &estimate).expect("a row");
            assert!(
                measured <= estimate.px,
                "{}: {measured} of {estimate:?}",
                path.display()
            );
            assert!(estimate.px_by_origin[0] <= estimate.px, "{estimate:?}");
            *seen.entry(estimate.step).or_default() += usize::from(measured > 0.0);
        }
    }
    // Every step has an error somewhere, so none is skipped.
    for step in ["ray", "object-space", "triangle", "sphere", "box", "square"] {
        assert!(seen.get(step) > Some(&0), "{step}: {seen:?}");
    }
}

/// In a town far from the origin `f32` cannot hold positions well enough, and the budget says so.
#[test]
fn a_town_far_from_the_origin_needs_f64() {
    let folder = tempfile::tempdir().expect("a folder");
    let (rays, view, report) = studied(town(&folder, [30_000.0, 20_000.0], "fov = 60"));
    study::has_budget(&rays).expect("it is near enough");
    let page = study::budget(&rays, &view, &report, 0.005);
    assert_eq!(page.lines().count(), 5, "{page}");
    let lines: Vec<&str> = page.lines().collect();
    assert!(
        lines[0].contains("in f64 object-space by inverse(A) (o - T)"),
        "{page}"
    );
    assert!(lines[0].contains("within the budget of 5e-3 px"), "{page}");
    assert!(lines[1].starts_with("Most of it is "), "{page}");
    assert!(lines[2].contains("units from the world's origin"), "{page}");
    assert!(
        lines[4].starts_with("Sample: 800 pixels, of which "),
        "{page}"
    );
    for wrong in ["M n", "by distance", "sum == 1", "the course's"] {
        assert!(!page.contains(wrong), "{wrong}: {page}");
    }
    // A coarse budget allows f32; a budget below f64's own errors cannot be met.
    let coarse = study::budget(&rays, &view, &report, 1e6);
    assert!(
        coarse.starts_with("in f32 ") && !coarse.contains("; in f64 ray"),
        "{coarse}"
    );
    let none = study::budget(&rays, &view, &report, 1e-18);
    assert!(
        none.contains("over the budget of 1e-18 px") && none.contains("No distance"),
        "{none}"
    );
}

/// The stated distance is right: a scene moved 0.9 times as far is within the budget, and moved 4 times as far it is
/// not.
#[test]
fn a_budget_holds_as_far_as_it_says() {
    let folder = tempfile::tempdir().expect("a folder");
    let moved = |by: f64| {
        let file = folder.path().join("moved.toml");
        let text = format!(
            "[camera]\neye = [{}, 1, 5]\ntarget = [{by}, 0, 0]\n[[object]]\nshape = \"sphere\"\nposition = [{by}, 0, 0]\n",
            by + 0.5
        );
        std::fs::write(&file, text).expect("a file");
        let (rays, view, report) = studied(file);
        study::budget(&rays, &view, &report, 0.005)
    };
    let near = moved(0.0);
    assert!(near.starts_with("in f32 "), "{near}");
    let words = "That holds until eye and objects are ";
    let line = near
        .lines()
        .find_map(|line| line.strip_prefix(words))
        .expect("how far");
    let far: f64 = line
        .split(' ')
        .next()
        .and_then(|n| n.parse().ok())
        .expect("a number");
    assert!(far > 100.0, "{near}");
    assert!(
        !moved(0.9 * far)
            .lines()
            .next()
            .expect("a line")
            .contains("f64"),
        "{far}"
    );
    let over = moved(4.0 * far);
    assert!(
        over.lines()
            .next()
            .expect("a line")
            .contains("in f64 object-space"),
        "{over}"
    );
}

#[test]
fn the_command_prints_it() {
    let run = Command::new(env!("CARGO_BIN_EXE_sightline"))
        .args(["study", "--budget", "0.05", "gallery:needles"])
        .output()
        .expect("the program");
    assert!(run.status.success());
    let page = String::from_utf8(run.stdout).expect("text");
    assert_eq!(page.lines().count(), 5, "{page}");
    assert!(page.contains("Sample: 2000 pixels"), "{page}");
    assert!(
        page.contains("f32 in place of f64 saves ") && page.contains(" ns that a pick takes here"),
        "{page}"
    );
}

#[test]
fn the_command_refuses_what_it_cannot_tell() {
    for (arguments, why) in [
        (
            ["gallery:far_from_the_origin", "--fov=45"],
            "times as large as what is seen",
        ),
        (
            ["gallery:needles", "--look=0,0,1"],
            "none of 2000 rays hits anything",
        ),
    ] {
        let run = Command::new(env!("CARGO_BIN_EXE_sightline"))
            .args(["study", "--budget", "0.05"])
            .args(arguments)
            .output()
            .expect("the program");
        let said = String::from_utf8(run.stderr).expect("text");
        assert_eq!(run.status.code(), Some(2), "{said}");
        assert!(run.stdout.is_empty() && said.contains(why), "{said}");
        assert_eq!(said.lines().count(), 1, "{said}");
    }
}
