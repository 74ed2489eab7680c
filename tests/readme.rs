//! What README shows and names is what this build does: commands, flags, a pick, a scene file, tests and pictures. Keys
//! are held by `tests/whole_window`, figures of the study by `tests/study`.
#![cfg(feature = "window")]

#[path = "common/images.rs"]
mod images;

use clap::{CommandFactory, Parser};
use images::{apart, read};
use serde_json::Value;
use sightline::{cli::Cli, image::Rgb, render::Gpu, scene::gallery::GALLERY};
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

/// README is read in one sitting: what explains a module stands on its page of `cargo doc`.
#[test]
fn it_is_no_longer_than_this() {
    let count = readme().lines().count();
    assert!(count <= 260, "{count} lines");
}

#[test]
fn every_command_is_in_the_table() {
    let text = readme();
    for command in Cli::command().get_subcommands() {
        let row = format!("| `sightline {}` |", command.get_name());
        assert!(text.contains(&row), "{row}");
    }
}

/// What a line of a block gives to `sightline`, or to `cargo run` for it; without a comment.
fn arguments(line: &str) -> Option<&str> {
    let line = line.split(" # ").next()?;
    let by_cargo = line.split_once("cargo run --release -- ");
    let (_, arguments) = by_cargo.or_else(|| line.split_once("sightline "))?;
    Some(arguments)
}

/// The program takes every command line in a block, its flags and their values.
#[test]
fn the_commands_that_are_shown_are_taken() {
    let text = blocks("sh").concat();
    let mut lines = text.lines();
    let view = lines.find_map(|line| line.strip_prefix("view=\"")?.strip_suffix('"'));
    let shown = text.replace("$view", view.expect("the view"));
    let mut seen = 0;
    for line in shown.lines() {
        let Some(arguments) = arguments(line) else {
            continue;
        };
        let words = std::iter::once("sightline").chain(arguments.split_whitespace());
        if let Err(error) = Cli::try_parse_from(words) {
            panic!("{line}: {error}");
        }
        seen += 1;
    }
    assert!(seen > 8, "{seen}: the search finds commands");
}

/// The code in the prose, outside of blocks: what stands between two backticks.
fn spans() -> Vec<String> {
    let text = readme();
    let prose = text.split("```").step_by(2);
    let spans = prose.flat_map(|part| part.split('`').skip(1).step_by(2));
    spans.map(str::to_owned).collect()
}

/// The long flags in a text.
fn flags_in(text: &str) -> impl Iterator<Item = &str> {
    let words = text.split_whitespace();
    words.filter_map(|word| word.strip_prefix("--")?.split('=').next())
}

/// Whether this is a file or folder of the repository. Rust's files may be named without their end.
fn is_path(name: &str) -> bool {
    here(name).exists() || here(&format!("{name}.rs")).exists()
}

/// Fails unless there is what `cargo` is told to run, or to build with.
fn cargo_finds(words: &[&str]) {
    let manifest = fs::read_to_string(here("Cargo.toml")).expect("Cargo.toml");
    for pair in words.windows(2) {
        let name = pair[1];
        let is_there = match pair[0] {
            "--test" => is_path(&format!("tests/{name}")),
            "--bench" => is_path(&format!("tests/bench/{name}")),
            "--example" => is_path(&format!("tests/examples/{name}")),
            "--features" => manifest.contains(&format!("\n{name} = [")),
            "--profile" => manifest.contains(&format!("\n[profile.{name}")),
            _ => true,
        };
        assert!(is_there, "{words:?}: no {name}");
    }
}

/// Every command and flag in the prose is in the program's help. A flag by itself is some command's.
#[test]
fn the_commands_and_flags_that_are_named_are_there() {
    let cli = Cli::command();
    let mut seen = 0;
    for span in spans() {
        let mut words: Vec<&str> = span.split_whitespace().collect();
        if words.first() == Some(&"cargo") {
            cargo_finds(&words);
            let Some(at) = words.iter().position(|word| *word == "--") else {
                continue;
            };
            // What `cargo run` gives to the program.
            words = words.split_off(at);
            words[0] = "sightline";
        }
        let is_name = |word: &str| word.starts_with(|c: char| c.is_ascii_lowercase());
        let commands: Vec<&clap::Command> = match words.as_slice() {
            ["sightline", name, ..] if is_name(name) => {
                vec![cli.find_subcommand(name).expect(&span)]
            }
            ["sightline", ..] => vec![&cli],
            _ => std::iter::once(&cli).chain(cli.get_subcommands()).collect(),
        };
        for flag in flags_in(&words.join(" ")) {
            let flags = commands.iter().flat_map(|command| command.get_arguments());
            let mut flags = flags.filter_map(clap::Arg::get_long).chain(["help"]);
            assert!(flags.any(|long| long == flag), "{span}: no --{flag}");
            seen += 1;
        }
    }
    assert!(seen > 5, "{seen}: the search finds flags");
}

/// Every file, folder, picture, heading and scene of the gallery that README names is there.
#[test]
fn every_place_that_is_named_is_there() {
    let text = readme();
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "_./-".contains(c);
    let mut seen = 0;
    for span in spans() {
        if span.contains('/') && span.chars().all(is_plain) {
            assert!(is_path(&span), "{span}");
            seen += 1;
        }
    }
    let headings = text.lines().filter(|line| line.starts_with('#'));
    let anchor = |line: &str| {
        line.trim_matches(['#', ' '])
            .to_lowercase()
            .replace(' ', "-")
    };
    let headings: Vec<String> = headings.map(anchor).collect();
    for link in text.split("](").skip(1) {
        let target = link.split(')').next().unwrap_or_default();
        let is_there = match target.strip_prefix('#') {
            Some(heading) => headings.iter().any(|known| known == heading),
            None => here(target).exists(),
        };
        assert!(is_there, "{target}");
        seen += 1;
    }
    for scene in text.split("gallery:").skip(1) {
        let mut words = scene.split(|c: char| !(c.is_ascii_lowercase() || c == '_'));
        // No name is in small letters in `gallery:NAME`.
        let name = words.next().unwrap_or_default();
        let is_there = name.is_empty() || GALLERY.iter().any(|exhibit| exhibit.name == name);
        assert!(is_there, "gallery:{name}");
    }
    assert!(seen > 30, "{seen}: the search finds places");
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
            // What is not a mark has the drawn brightness, which a driver may round by one step.
            let differ = |&(&seen, &shown): &(&Rgb, &Rgb)| apart(seen, shown, 1);
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
