//! `sightline verify` reports agreement and defects by exit code, JSON, text and picture.

use serde_json::Value;
use std::process::{Command, Output};

fn run(args: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_sightline"));
    command
        .args(args.split_whitespace())
        .env("RUST_LOG", "error");
    command.output().expect("the program runs")
}

#[test]
fn the_demo_is_explained() {
    let output = run("verify --size 320x240");
    let text = String::from_utf8(output.stdout).expect("text");
    assert_eq!(output.status.code(), Some(0), "{text}");
    assert!(text.starts_with("320x240 pixels, "), "{text}");
    let unexplained = text.lines().find(|line| line.starts_with("unexplained"));
    assert_eq!(
        unexplained,
        Some("unexplained          0  defects"),
        "{text}"
    );
}

#[test]
fn json_counts_every_pixel_once() {
    let output = run("verify --size 320x240 --json");
    let line: Value = serde_json::from_slice(&output.stdout).expect("a line of JSON");
    let count = |name: &str| line[name].as_u64().expect("a count");
    let classes = [
        "same",
        "edge",
        "depth",
        "section",
        "f32_limit",
        "beyond_f32",
        "unexplained",
    ];
    assert_eq!(classes.map(count).iter().sum::<u64>(), 320 * 240);
    assert!(count("drawn") > 10_000, "{line}");
    assert!(count("picked") > 10_000, "{line}");
    assert!(count("outline") > 1000, "{line}");
}

/// Pixels in one place are tinted in the picture, and counted in the JSON line and in the text. The text counts them
/// beside the classes, which include them.
#[test]
fn pixels_in_one_place_are_counted_and_tinted() {
    let folder = tempfile::tempdir().expect("a folder");
    let (file, image) = (
        folder.path().join("two.toml"),
        folder.path().join("two.png"),
    );
    let square = "[[object]]\nshape = \"square\"\n";
    std::fs::write(&file, format!("{square}{square}rotation = [0, 0, 30]\n")).expect("a file");
    let view = "--size 160x120 --eye 0,0,3 --target 0,0,0";
    let args = format!(
        "verify {} {view} --image {}",
        file.display(),
        image.display()
    );
    let output = run(&format!("{args} --json"));
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let line: Value = serde_json::from_slice(&output.stdout).expect("a line of JSON");
    let count = line["in_one_place"].as_u64().expect("a count");
    assert!((1000..3000).contains(&count), "{line}");
    let picture = super::images::read(&image);
    let tinted = picture
        .pixels()
        .iter()
        .filter(|[red, _, blue]| blue > &(red.saturating_add(40)));
    let differ = line["pixels"].as_u64().unwrap_or(0) - line["same"].as_u64().unwrap_or(0);
    let off = count.abs_diff(u64::try_from(tinted.count()).expect("few"));
    assert!(off <= 9 * differ, "{off} of {line}");
    let text = String::from_utf8(run(&args).stdout).expect("text");
    let row = format!("in one place {count:>9}  of all the pixels above: ");
    assert!(text.contains(&row), "{text}");
}

/// From afar through a long lens the usual picker is wrong. Verify says so by its exit code, one line on stderr, and
/// the place of the worst pixel.
#[test]
fn a_defect_is_an_exit_code_a_line_and_a_place() {
    let folder = tempfile::tempdir().expect("a folder");
    let image = folder.path().join("where.png");
    let view =
        "--size 320x240 --eye 3000,2400,5000 --target 0,0.5,0 --fov 0.05 --near 1 --far 10000";
    let output = run(&format!("verify {view} --json"));
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let output = run(&format!(
        "verify {view} --picker usual --json --image {}",
        image.display()
    ));
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    let stderr = String::from_utf8(output.stderr).expect("text");
    assert_eq!(stderr.lines().count(), 1, "{stderr}");
    let line: Value = serde_json::from_slice(&output.stdout).expect("a line of JSON");
    let worst = &line["worst"];
    assert_eq!(worst["class"], "unexplained");
    let [x, y] = [0, 1]
        .map(|i| worst["pixel"][i].as_u64().expect("a pixel"))
        .map(|at| u32::try_from(at).expect("a pixel"));
    let at = super::images::read(&image).at(x, y);
    assert_eq!(at, [213, 94, 0], "the worst pixel is painted");
}

/// A ray within the plane of a cube's side enters at the rim of the cube's front face, so that face's depth is
/// reported.
#[test]
fn the_depth_of_a_rim_is_the_hits() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("cube.toml");
    let cube = "[[object]]\nshape = \"cube\"\nposition = [0.1875, 0.0625, 0]\nscale = 0.25\n";
    std::fs::write(&file, cube).expect("a file");
    let view = "--eye 0,0,5 --look 0,0,-1 --ortho 4 --near 0 --far 10 --size 32x32 --json";
    let output = run(&format!("verify {} {view}", file.display()));
    let line: Value = serde_json::from_slice(&output.stdout).expect("a line of JSON");
    assert_eq!(line["worst"]["picked"]["depth"], 4.875, "{line}");
}

#[test]
fn without_a_driver_it_says_what_needs_none() {
    let mut command = Command::new(env!("CARGO_BIN_EXE_sightline"));
    command.arg("verify").env("RUST_LOG", "error");
    command
        .env("VK_DRIVER_FILES", "/nowhere.json")
        .env("VK_ICD_FILENAMES", "/nowhere.json");
    let output = command.output().expect("the program runs");
    assert_eq!(output.status.code(), Some(4), "{output:?}");
    let stderr = String::from_utf8(output.stderr).expect("text");
    assert!(stderr.contains("apt-get install"), "{stderr}");
    let others = "`sightline pick` and `sightline render --by raycast` do without\n";
    assert!(stderr.ends_with(others), "{stderr}");
}
