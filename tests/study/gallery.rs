//! The gallery: scenes on which methods break; and what the budget says about one.

use sightline::{
    camera::{View, Viewport},
    geometry::Sides,
    scene::{self, Progress},
    study::{self, Effort, Report, Row, SCENE, SceneRays, step::Precision},
};
use std::path::{Path, PathBuf};

/// Which method breaks on which scene: the step, the method, its precision, and the least that goes wrong, in per
/// cent of decisions for steps that make them and in the step's unit for those that give values.
const BREAKS: [(&str, &str, &str, Precision, f64); 12] = [
    (
        "far_from_the_origin",
        "ray",
        "target + sx H + sy V - eye",
        Precision::F32,
        1.0,
    ),
    (
        "far_from_the_origin",
        "ray",
        "inverse(P V), near - eye",
        Precision::F32,
        10.0,
    ),
    (
        "far_from_the_origin",
        "object-space",
        "inverse(M)",
        Precision::F32,
        1.0,
    ),
    (
        "far_over_near",
        "ray",
        "inverse(P V), far - near",
        Precision::F32,
        f64::INFINITY,
    ),
    (
        "far_over_near",
        "depth",
        "standard, 32-bit float",
        Precision::F32,
        1e-4,
    ),
    (
        "small_and_far",
        "sphere",
        "plain quadratic",
        Precision::F32,
        0.2,
    ),
    ("stretched", "normal", "M n", Precision::F64, 60.0),
    ("mirrored", "normal", "cofactors", Precision::F64, 179.0),
    ("wide_lens", "clip", "by distance", Precision::F64, 50.0),
    (
        "along_a_face",
        "box",
        "slabs by min and max",
        Precision::F64,
        0.1,
    ),
    ("edge_on", "plane", "N . (S - o)", Precision::F32, 1e-4),
    (
        "needles",
        "triangle",
        "areas, sum == 1",
        Precision::F32,
        5.0,
    ),
];

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/gallery")
}

fn study_of(scene: &str) -> Report {
    let path = folder().join(scene).with_extension("toml");
    let loaded = scene::load(&[path], &Progress::default()).expect("a scene");
    let viewport = Viewport::new(321, 180).expect("a picture");
    let camera = loaded
        .camera
        .resolve(&loaded.scene.visible_bounds(), viewport)
        .expect("a camera");
    let view = View {
        camera,
        viewport,
        sides: Sides::Both,
    };
    let rays = SceneRays::new(&loaded.scene, view, 1500, 1);
    study::run(
        Effort {
            rounds: 0,
            ..Effort::SCENE_ONLY
        },
        Some(&rays),
        &|_, _| {},
    )
}

#[test]
fn each_scene_breaks_its_method_and_not_ours() {
    let mut failed: Vec<String> = Vec::new();
    for (scene, step, method, precision, least) in BREAKS {
        let report = study_of(scene);
        let row = |wanted: &dyn Fn(&Row) -> bool| {
            let mut rows = report
                .rows
                .iter()
                .filter(|row| row.step.key == step && row.family == SCENE);
            *rows.find(|row| wanted(row)).expect("a row")
        };
        let bad = row(&|row| (row.method, row.precision) == (method, precision));
        let decides = !bad.step.wrong_unit.is_empty();
        let broken = if decides {
            bad.wrong_percent()
        } else {
            bad.worst_error
        };
        if broken < least {
            failed.push(format!("{scene}: {bad:?}"));
        }
        let ours = row(&|row| row.ours);
        if ours.wrong_percent() > 0.0 {
            failed.push(format!("{scene}: {ours:?}"));
        }
        assert!(
            ours.of_bound.is_some_and(|share| share <= 1.0),
            "{scene}: {ours:?}"
        );
    }
    assert!(failed.is_empty(), "{failed:#?}");
}

#[test]
fn every_scene_is_tested() {
    for entry in std::fs::read_dir(folder()).expect("the gallery") {
        let path = entry.expect("an entry").path();
        let name = path
            .file_stem()
            .expect("a name")
            .to_string_lossy()
            .into_owned();
        let toml = path
            .extension()
            .is_some_and(|extension| extension == "toml");
        assert!(
            !toml || BREAKS.iter().any(|(scene, ..)| *scene == name),
            "{name} is in no test"
        );
    }
}

#[test]
fn a_budget_names_each_step_and_its_bounds() {
    let path = folder().join("far_from_the_origin.toml");
    let run = std::process::Command::new(env!("CARGO_BIN_EXE_sightline"))
        .args(["study", "--budget", "0.05"])
        .arg(path)
        .output()
        .expect("the program");
    assert!(run.status.success());
    let page = String::from_utf8(run.stdout).expect("text");
    for words in [
        "Ray from pixel: f32 would do, by eye basis",
        "Ray into object space: ",
        "Ray against sphere: ",
        "Near and far: ",
        "Normal into the world: ",
        "Depth buffer: ",
        "Whole pick: ",
    ] {
        assert!(page.contains(words), "no {words:?} in\n{page}");
    }
    let course = page
        .lines()
        .find(|line| line.contains("estimate") && line.contains("target + sx H"));
    assert!(
        course.is_some_and(|line| line.contains("too much")),
        "{page}"
    );
    assert!(
        page.lines().any(|line| line.starts_with("  bound ")),
        "{page}"
    );
}
