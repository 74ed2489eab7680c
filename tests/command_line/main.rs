//! The command line does what it says: arguments go in; results, one-line errors and exit codes come out.
#![cfg(feature = "window")]

mod changed;
mod desktop;
mod doctor;
#[path = "../common/exact/mod.rs"]
mod exact;
mod in_file;
mod no_driver;
mod pictures;
#[path = "../common/real_files.rs"]
mod real_files;
mod refusals;
mod section;
mod snap;
mod stored;
mod stored_line;
mod streams;

use serde_json::Value;
use std::{
    io::Write,
    path::PathBuf,
    process::{Command, Output, Stdio},
};
use tempfile::TempDir;

/// Two cubes in a row and a ball behind them, all on the z axis, and a camera that looks along it.
const SCENE: &str = r#"
[camera]
eye = [0, 0, 10]
target = [0, 0, 0]
fov = 40

[[object]]
name = "Front"
shape = "cube"
position = [0, 0, 2]

[[object]]
name = "Middle"
shape = "cube"

[[object]]
name = "Ball"
shape = "sphere"
position = [0, 0, -2]
scale = 2
"#;

struct Folder(TempDir);

impl Folder {
    fn new() -> Self {
        let folder = Self(tempfile::tempdir().unwrap());
        std::fs::write(folder.path("scene.toml"), SCENE).unwrap();
        folder
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn command(&self, args: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_sightline"));
        command
            .args(args.split_whitespace())
            .current_dir(self.0.path());
        command.env_remove("RUST_LOG");
        command
    }

    fn run(&self, args: &str) -> Output {
        self.command(args).output().unwrap()
    }

    /// Runs with lines on standard input.
    fn run_with(&self, args: &str, input: impl AsRef<[u8]>) -> Output {
        let mut command = self.command(args);
        command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        let written = child.stdin.take().unwrap().write_all(input.as_ref());
        // The program may stop reading at a bad line.
        written
            .or_else(|error| {
                if error.kind() == std::io::ErrorKind::BrokenPipe {
                    Ok(())
                } else {
                    Err(error)
                }
            })
            .unwrap();
        child.wait_with_output().unwrap()
    }

    /// Standard output of a run that must succeed in silence, as JSON lines.
    #[track_caller]
    fn json(&self, args: &str) -> Vec<Value> {
        json(&self.run(args))
    }

    /// The one line on standard error of a run that must fail with this code and no result.
    #[track_caller]
    fn error(&self, args: &str, code: i32) -> String {
        let output = self.run(args);
        assert!(output.stdout.is_empty(), "{args}: no result");
        error(&output, code, args)
    }
}

#[track_caller]
fn json(output: &Output) -> Vec<Value> {
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && stderr.is_empty(), "{stderr}");
    let stdout = std::str::from_utf8(&output.stdout).unwrap();
    stdout
        .lines()
        .map(|line| serde_json::from_str(line).expect("a line of JSON"))
        .collect()
}

#[track_caller]
fn error(output: &Output, code: i32, args: &str) -> String {
    let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(code), "{args}: {stderr}");
    assert_eq!(stderr.lines().count(), 1, "{args}: one line, not {stderr}");
    assert!(stderr.starts_with("sightline: "), "{args}: {stderr}");
    stderr
}

#[test]
fn a_pick_is_a_line_of_json() {
    let lines = Folder::new().json("pick scene.toml --size 200x100 --at 100,50 5.25,7.5");
    let [hit, miss] = &lines[..] else {
        panic!("two lines, not {lines:?}");
    };
    assert_eq!(hit["px"], serde_json::json!([100.0, 50.0]));
    let pick = &hit["hit"];
    assert_eq!(
        (&pick["object"], &pick["id"]),
        (&Value::from("Front"), &Value::from(1))
    );
    assert_eq!(pick["point_world"], serde_json::json!([0.0, 0.0, 2.5]));
    assert_eq!(pick["normal_world"], serde_json::json!([0.0, 0.0, 1.0]));
    assert_eq!(
        (&pick["t"], &pick["depth"], &pick["gap"]),
        (&Value::from(7.5), &Value::from(7.5), &Value::from(1.0))
    );
    assert_eq!(
        (&pick["front"], &pick["triangle"]),
        (&Value::from(true), &Value::Null)
    );
    assert_eq!(
        miss,
        &serde_json::json!({"px": [5.25, 7.5], "hit": null, "in_one_place": null})
    );
}

#[test]
fn all_hits_come_from_front_to_back() {
    let lines = Folder::new().json("pick scene.toml --size 200x100 --at 100,50 --all-hits");
    let hits = lines[0]["hits"].as_array().unwrap();
    let found: Vec<_> = hits
        .iter()
        .map(|hit| (hit["id"].as_u64().unwrap(), hit["t"].as_f64().unwrap()))
        .collect();
    assert_eq!(
        found,
        [
            (1, 7.5),
            (1, 8.5),
            (2, 9.5),
            (2, 10.5),
            (3, 11.0),
            (3, 13.0)
        ]
    );
    assert!(lines[0].get("hit").is_none());
}

#[test]
fn flags_choose_the_view() {
    let folder = Folder::new();
    let pick = |flags: &str| {
        folder
            .json(&format!(
                "pick scene.toml --size 200x100 --at 100,50 {flags}"
            ))
            .remove(0)["hit"]
            .take()
    };
    let object = |flags: &str| pick(flags)["object"].as_str().map(str::to_owned);
    // Negative numbers are values, not flags.
    assert_eq!(object("--eye -0.1,-0.1,-9").as_deref(), Some("Ball"));
    assert_eq!(
        object("--eye 0,0,-9 --look 0,0,-1"),
        None,
        "away from everything"
    );
    assert_eq!(object("--look -0,0,-1").as_deref(), Some("Front"));
    assert_eq!(pick("--ortho 3 --near -5 --far 20")["t"], 7.5);
    assert_eq!(pick("--ortho 3 --eye 0,0,-1 --near -5 --far 20")["t"], -2.0);
    assert_eq!(pick("--near 8")["depth"], 8.5);
    assert_eq!(
        pick("--near 8 --cull")["depth"],
        9.5,
        "not the back of the first cube"
    );
    assert_eq!(object("--far 7"), None);
    assert_eq!(
        pick("--near 1 --far 100 --depth standard")["ndc"][2],
        100.0 / 99.0 - 100.0 / 99.0 / 7.5
    );
    assert_eq!(object("--hide 1").as_deref(), Some("Middle"));
    assert_eq!(object("--hide 2,1").as_deref(), Some("Ball"));
    assert_eq!(object("--hide 1,2,3"), None);
    assert_eq!(object("--hide 1,2 --show 2").as_deref(), Some("Middle"));
    // With z up, the eye above looks down and needs no `--up`.
    assert_eq!(
        object("--up-axis z --target 0,0,0").as_deref(),
        Some("Front")
    );
    // The pixel moves with the field of view, and up turns the picture.
    let at = |flags: &str| {
        folder
            .json(&format!(
                "pick scene.toml --size 200x200 --at 110,100 {flags}"
            ))
            .remove(0)["hit"]["point_world"]
            .take()
    };
    let expected = 7.5 * 0.1 * 20_f64.to_radians().tan();
    assert!((at("")[0].as_f64().unwrap() - expected).abs() < 1e-12);
    assert!((at("--up 1,0,0")[1].as_f64().unwrap() + expected).abs() < 1e-12);
    assert_eq!(
        folder.json("pick scene.toml --at 639.5,719").len(),
        1,
        "1280x720 unless said otherwise"
    );
}

#[test]
fn lists_have_a_line_an_object() {
    let folder = Folder::new();
    let lines = folder.json("list scene.toml scene.toml --json");
    assert_eq!(lines.len(), 6);
    assert_eq!(
        lines[5],
        serde_json::json!({
            "id": 6, "name": "Ball", "shape": "sphere", "triangles": null, "visible": true,
            "material": null, "colour": "#e8e8ec",
            "bounds": {"min": [-1.0, -1.0, -3.0], "max": [1.0, 1.0, -1.0]},
        })
    );
    let output = folder.run("list scene.toml");
    let table = String::from_utf8(output.stdout).unwrap();
    let rows: Vec<Vec<&str>> = table
        .lines()
        .map(|line| line.split_whitespace().collect())
        .collect();
    assert_eq!(rows[0], ["id", "name", "shape", "triangles", "min", "max"]);
    assert_eq!(
        rows[1],
        [
            "1", "Front", "cube", "-", "-0.5,", "-0.5,", "1.5", "0.5,", "0.5,", "2.5"
        ]
    );
    assert_eq!(rows.len(), 4);
    // Without a scene it is the demo, which has triangles.
    let demo = folder.json("list --json");
    assert!(
        demo.iter()
            .any(|line| line["triangles"].as_u64().is_some_and(|count| count > 200))
    );
}

/// Rust's own widths end at 65,535 characters.
#[test]
fn a_list_takes_names_of_any_length_and_scenes_of_any_size() {
    let folder = Folder::new();
    let name = "x".repeat(70_000);
    let scene =
        format!("[[object]]\nshape = \"cube\"\nname = \"{name}\"\nscale = [1e-20, 1e-20, 1e-20]\n");
    std::fs::write(folder.path("tiny.toml"), scene).unwrap();
    let output = folder.run("list tiny.toml");
    assert!(output.status.success(), "{output:?}");
    let table = String::from_utf8(output.stdout).unwrap();
    let row = table.lines().nth(1).unwrap();
    let cells: Vec<&str> = row.split("  ").filter(|cell| !cell.is_empty()).collect();
    assert_eq!(cells[1], name);
    let corners = ["-5e-21, -5e-21, -5e-21", "5e-21, 5e-21, 5e-21"];
    assert_eq!(cells[4..], corners);
    let heads = table.lines().next().unwrap();
    assert_eq!(
        heads.find("max"),
        row.find(corners[1]).filter(|at| *at > 70_000)
    );
}

#[test]
fn a_list_reads_no_more_than_it_prints() {
    let folder = Folder::new();
    let model = "mtllib no.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    std::fs::write(folder.path("model.obj"), model).unwrap();
    let said = |args| String::from_utf8(folder.run(args).stderr).unwrap();
    assert!(said("pick model.obj --at 1,1").contains("no.mtl does not exist"));
    assert_eq!(said("list model.obj"), "");
}

#[test]
fn the_demo_is_there_without_a_scene() {
    let lines = Folder::new().json("pick --at 640,360");
    assert_ne!(lines[0]["hit"], Value::Null);
}

#[test]
fn help_and_version_go_to_standard_output() {
    let folder = Folder::new();
    for args in [
        "--help",
        "pick --help",
        "render -h",
        "list --help",
        "--version",
    ] {
        let output = folder.run(args);
        assert!(
            output.status.success() && output.stderr.is_empty(),
            "{args}"
        );
        assert!(!output.stdout.is_empty(), "{args}");
    }
    for command in ["render", "pick", "list", "study", "verify"] {
        let help = folder.run(&format!("{command} --help")).stdout;
        let help = String::from_utf8(help).unwrap();
        assert!(help.contains("Exit codes: 0 done"), "{command}");
        assert!(help.contains("default: the demo"), "{command}");
    }
    // The help explains every field of a pick's line.
    let help = String::from_utf8(folder.run("pick --help").stdout).unwrap();
    let line = folder
        .json("pick scene.toml --size 200x100 --at 100,50")
        .remove(0);
    for field in line["hit"].as_object().unwrap().keys() {
        let words = help.split(|c: char| c != '_' && !c.is_alphanumeric());
        assert!(words.into_iter().any(|word| word == field), "{field}");
    }
    // It fits into a terminal of 80 columns.
    assert!(
        help.lines().all(|line| line.chars().count() <= 80),
        "{help}"
    );
    let version = String::from_utf8(folder.run("--version").stdout).unwrap();
    assert_eq!(
        version.trim(),
        concat!("sightline ", env!("CARGO_PKG_VERSION"))
    );
}

#[test]
fn verbose_says_on_standard_error_what_is_done() {
    let folder = Folder::new();
    // In radians and back, 12 degrees round to a neighbour.
    for (flag, fov) in [("", "40"), ("--fov 12", "12")] {
        let output = folder.run(&format!("pick scene.toml --at 1,1 -v {flag}"));
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert!(stderr.contains("loaded scene.toml: 3 objects"), "{stderr}");
        let camera = format!("camera: --eye 0,0,10 --target 0,0,0 --up 0,1,0 --fov {fov} --near ");
        assert!(stderr.contains(&camera), "{stderr}");
        assert_eq!(String::from_utf8_lossy(&output.stdout).lines().count(), 1);
    }
}
