//! What README shows and names is what this build does: commands, flags, a pick, a scene file, tests and pictures.
#![cfg(feature = "window")]

#[path = "common/images.rs"]
mod images;

use clap::CommandFactory;
use images::{apart, read};
use serde_json::Value;
use sightline::{cli::Cli, image::Rgb, render::Gpu};
use std::{
    fs,
    io::{self, Write},
    path::{Path, PathBuf},
    process::{Command, Output},
};

fn here(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

fn readme() -> String {
    fs::read_to_string(here("README.md")).expect("README.md")
}

/// The fenced blocks of a language.
fn blocks(language: &str) -> Vec<String> {
    let text = readme();
    let fence = format!("```{language}\n");
    text.split(&fence)
        .skip(1)
        .map(|block| block.split("```").next().unwrap_or_default().to_owned())
        .collect()
}

/// Runs a line of README with this build's `sightline`.
fn run(line: &str) -> Output {
    let program = env!("CARGO_BIN_EXE_sightline");
    let line = line.replacen("sightline", program, 1);
    Command::new("sh")
        .args(["-c", &line])
        .output()
        .expect("a shell")
}

fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|_| panic!("{}", String::from_utf8_lossy(&output.stderr)))
}

#[test]
fn the_picture_that_is_promised_first_is_drawn() {
    let block = blocks("sh").remove(0);
    let line = block.lines().find(|line| line.contains(" render "));
    let line = line.expect("a picture");
    let arguments = line.strip_prefix("cargo run --release -- ").expect(line);
    let folder = tempfile::tempdir().expect("a folder");
    let cd = format!("cd {} && sightline {arguments}", folder.path().display());
    let output = run(&cd);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    assert!(folder.path().join("picture.png").exists(), "{said}");
}

#[test]
fn the_pick_that_is_shown_is_the_pick() {
    let blocks = blocks("sh");
    let block = blocks
        .iter()
        .find_map(|block| block.strip_prefix("$ "))
        .expect("an example");
    let (command, shown) = block.split_once('\n').expect("its output");
    assert!(command.starts_with("sightline pick "), "{command}");
    let shown: Value = serde_json::from_str(shown).expect("JSON");
    assert_eq!(json(&run(command)), shown);
}

#[test]
fn the_scene_file_that_is_shown_loads() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = blocks("toml").concat();
    fs::write(folder.path().join("scene.toml"), text).expect("a writable folder");
    fs::write(
        folder.path().join("model.obj"),
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    )
    .expect("a writable folder");
    let output = run(&format!(
        "sightline list --json {}",
        folder.path().join("scene.toml").display()
    ));
    let lines = String::from_utf8(output.stdout).expect("UTF-8");
    assert_eq!(
        lines.lines().count(),
        2,
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
}

#[test]
fn the_rust_that_is_asked_for_is_the_one_that_builds() {
    let asked = concat!("Rust ", env!("CARGO_PKG_RUST_VERSION"), " or later");
    assert!(readme().contains(asked), "{asked}");
}

#[test]
fn every_command_and_camera_flag_is_named() {
    let text = readme();
    let cli = Cli::command();
    for command in cli.get_subcommands() {
        let name = command.get_name();
        let rows = [" [SCENE...]", "`"].map(|end| format!("| `sightline {name}{end}"));
        assert!(rows.iter().any(|row| text.contains(row)), "{name}");
    }
    let flags = cli
        .get_arguments()
        .filter_map(|argument| argument.get_long());
    for flag in flags.filter(|flag| !["help", "version", "verbose"].contains(flag)) {
        assert!(text.contains(&format!("--{flag}")), "--{flag}");
    }
}

/// The flags that a text names.
fn flags_in(text: &str) -> impl Iterator<Item = &str> {
    let named = text.split('`').skip(1).step_by(2);
    named.filter_map(|code| {
        let (_, flag) = code.split_once("--")?;
        flag.split(|c: char| !(c.is_ascii_lowercase() || c == '-'))
            .next()
    })
}

/// A row's flags are its command's, and the camera's flags are those of the commands that the sentence about them
/// names.
#[test]
fn each_command_takes_the_flags_that_are_named_for_it() {
    let text = readme();
    let cli = Cli::command();
    let takes = |command: &clap::Command, flag: &str| {
        let mut flags = command.get_arguments().filter_map(clap::Arg::get_long);
        flags.any(|long| long == flag)
    };
    let sentence = text
        .split(". ")
        .find(|sentence| sentence.contains("take `--size WxH`"));
    let sentence = sentence.expect("the sentence about the camera's flags");
    let (who, camera) = sentence.split_once(" take ").expect("who takes them");
    let camera: Vec<&str> = flags_in(camera).collect();
    assert!(camera.len() > 12, "{camera:?}");
    let mut seen = 0;
    let window = std::iter::once((&cli, "The window".to_owned(), "[SCENE...]"));
    let commands = cli.get_subcommands().map(|command| {
        let name = command.get_name();
        (command, format!("`{name}`"), name)
    });
    for (command, named, start) in window.chain(commands) {
        let is_named = who.contains(&named);
        for flag in &camera {
            assert_eq!(takes(command, flag), is_named, "{named} --{flag}");
        }
        let start = format!("| `sightline {start}");
        let row = text.lines().find(|line| line.starts_with(&start));
        for flag in flags_in(row.expect("a row")) {
            assert!(takes(command, flag), "{named} takes no --{flag}");
            seen += 1;
        }
    }
    assert!(seen > 15, "{seen}: the search finds flags");
}

/// A test file is `tests/NAME.rs` or `tests/NAME/main.rs`.
#[test]
fn every_test_file_is_in_the_table_of_promises() {
    let text = readme();
    let mut count = 0;
    for entry in fs::read_dir(here("tests")).expect("tests") {
        let path = entry.expect("an entry").path();
        if path.extension().is_some_and(|end| end == "rs") || path.join("main.rs").exists() {
            let name = path.file_stem().expect("a name").display().to_string();
            assert!(text.contains(&format!("`tests/{name}`")), "{name}");
            count += 1;
        }
    }
    assert!(count > 20, "{count}");
    for (name, _) in text
        .match_indices("`tests/")
        .map(|(at, _)| text[at + 7..].split_once('`').expect("an end"))
    {
        let name = name.split(['/', '.']).next().unwrap_or(name);
        let there = [
            here("tests").join(name),
            here("tests").join(format!("{name}.rs")),
        ];
        assert!(there.iter().any(|path| path.exists()), "{name}");
    }
}

/// The count on the first screen. Another driver rounds outlines differently.
#[test]
fn the_demo_differs_where_it_is_said_to() {
    let report = json(&run("sightline verify --json"));
    assert_eq!(report["unexplained"], 0, "{report}");
    let gpu = Gpu::headless().expect("a driver");
    if gpu.adapter_name().contains("llvmpipe") {
        let said = "Of the demo's 921,600 pixels 7 differ, all on edges";
        assert!(readme().contains(said), "{said}");
        let counts = ["pixels", "same", "edge"].map(|name| report[name].as_i64());
        assert_eq!(counts, [921_600, 921_600 - 7, 7].map(Some), "{report}");
    }
}

/// The two commands of the chapter on verify, and the counts that its table gives for them.
#[test]
fn the_pictures_of_verify_are_of_what_it_finds() {
    let text = readme();
    let view = text
        .lines()
        .find_map(|line| line.strip_prefix("view=\"")?.strip_suffix('"'));
    let view = view.expect("the view");
    let head = text
        .lines()
        .find(|line| line.starts_with("| Sightline: "))
        .expect("the table's head");
    let numbers: Vec<i64> = head
        .split(|c: char| !c.is_ascii_digit())
        .filter_map(|word| word.parse().ok())
        .collect();
    let &[ours, usual, usual_unexplained] = numbers.as_slice() else {
        panic!("{head}");
    };
    // Another driver rounds outlines differently.
    let gpu = Gpu::headless().expect("a driver");
    let is_the_pictures_driver = gpu.adapter_name().contains("llvmpipe");
    let folder = tempfile::tempdir().expect("a folder");
    let check = |picker: &str, said: [i64; 2], asset: &str| {
        let picture = folder.path().join(asset);
        let line = format!("sightline verify {view} {picker} --json --image");
        let report = json(&run(&format!("{line} {}", picture.display())));
        let count = |name: &str| report[name].as_i64().unwrap_or_else(|| panic!("{report}"));
        let seen = [count("pixels") - count("same"), count("unexplained")];
        if is_the_pictures_driver {
            assert_eq!(seen, said, "{picker}");
            let [seen, shown] = [picture, here("assets").join(asset)].map(|path| read(&path));
            assert_eq!(seen.size(), shown.size(), "assets/{asset}");
            let pairs = seen.pixels().iter().zip(shown.pixels());
            // Grey pixels have the drawn brightness; marks are coloured.
            let is_grey = |[r, g, b]: Rgb| r == g && g == b;
            let differ = |&(&seen, &shown): &(&Rgb, &Rgb)| {
                let most = u8::from(is_grey(seen) && is_grey(shown));
                apart(seen, shown, most)
            };
            let differ = pairs.filter(differ).count();
            assert_eq!(differ, 0, "assets/{asset} is of another time");
        } else {
            // Past the test runner, which keeps what a passing test prints to itself.
            let told =
                "readme: llvmpipe does not draw, so counts are compared roughly and not with";
            let _ = writeln!(io::stderr(), "{told} assets/{asset}");
        }
        for (seen, said) in seen.into_iter().zip(said) {
            assert!(
                (seen - said).abs() <= 4 + said / 20,
                "{picker}: {seen}, not {said}"
            );
        }
        seen
    };
    let [_, unexplained] = check("", [ours, 0], "verify.png");
    assert_eq!(unexplained, 0);
    check(
        "--picker usual",
        [usual, usual_unexplained],
        "verify-usual.png",
    );
}
