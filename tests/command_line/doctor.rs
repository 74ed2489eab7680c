//! `doctor` says what this machine draws with, and what works on a machine that cannot draw.

use super::Folder;
use std::process::{Command, Output};

/// The report with these variables, none of which names a display.
fn doctor(variables: &[(&str, &str)]) -> (Output, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_sightline"));
    command.arg("doctor").env("RUST_LOG", "off");
    for name in ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"] {
        command.env_remove(name);
    }
    command.envs(variables.iter().copied());
    let output = command.output().expect("the program runs");
    let text = String::from_utf8(output.stdout.clone()).expect("text");
    (output, text)
}

#[test]
fn adapters_are_described_and_a_missing_display_is_named() {
    let (output, text) = doctor(&[]);
    assert_eq!(output.status.code(), Some(5), "{text}");
    assert!(text.starts_with(concat!("sightline ", env!("CARGO_PKG_VERSION"))));
    let one_each = [
        ", which draws: ",
        "display: no display to open a window on",
        "works without an adapter: list, pick",
    ];
    for words in one_each {
        assert_eq!(text.matches(words).count(), 1, "{words}: {text}");
    }
    let of_adapter = [
        "driver ",
        "  triangles in ids: by ",
        " sub-pixel bits, measured",
        "  pictures: up to ",
        "larger meshes are split",
    ];
    for words in of_adapter {
        assert!(text.contains(words), "{words}: {text}");
    }
    let stderr = String::from_utf8(output.stderr).expect("text");
    assert_eq!(stderr.lines().count(), 1, "{stderr}");
    assert!(stderr.contains("no display"), "{stderr}");
}

/// `doctor` uses the error messages of the commands that fail without an adapter.
#[test]
fn without_an_adapter_it_says_what_works() {
    let nowhere = "/nowhere.json";
    let (output, text) = doctor(&[("VK_DRIVER_FILES", nowhere), ("VK_ICD_FILENAMES", nowhere)]);
    assert_eq!(output.status.code(), Some(4), "{text}");
    assert!(text.contains("\nVK_DRIVER_FILES=/nowhere.json\n"), "{text}");
    assert!(
        text.contains("\ndrawing: no graphics driver found"),
        "{text}"
    );
    assert!(text.contains("render (by rays, without --views)"), "{text}");
    assert!(!text.contains("which draws"), "{text}");
    let stderr = String::from_utf8(output.stderr).expect("text");
    assert_eq!(stderr.lines().count(), 1, "{stderr}");
    assert!(stderr.contains("no graphics driver found"), "{stderr}");
}

#[test]
fn its_help_says_what_its_exit_codes_mean() {
    let help = Folder::new().run("doctor --help").stdout;
    let help = String::from_utf8(help).expect("text");
    assert!(
        help.contains("4 no adapter draws, 5 one does, but there is no display"),
        "{help}"
    );
}
