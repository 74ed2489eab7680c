//! `install-desktop`: what it writes is what desktops, `man` and shells take, and `--remove` leaves nothing.

use super::*;
use std::path::Path;

/// What a program says of a file, and whether it takes it.
fn check(program: &str, args: &[&str], file: &Path) {
    let output = Command::new(program)
        .args(args)
        .arg(file)
        .env("LC_ALL", "C.UTF-8")
        .output();
    let output = output.unwrap_or_else(|error| panic!("{program}: {error}"));
    let [said, more] = [&output.stderr, &output.stdout].map(|text| String::from_utf8_lossy(text));
    assert!(
        output.status.success() && said.is_empty(),
        "{program} {}: {said}{more}",
        file.display()
    );
}

fn install(folder: &Folder, flags: &str) -> Vec<PathBuf> {
    let output = folder.run(&format!("install-desktop --to share {flags}"));
    assert!(output.status.success(), "{output:?}");
    let lines = String::from_utf8(output.stdout).unwrap();
    lines.lines().map(|line| folder.path(line)).collect()
}

#[test]
fn desktops_man_and_shells_take_what_is_installed() {
    let folder = Folder::new();
    let files = install(&folder, "");
    let file = |end: &str| {
        let mut such = files.iter().filter(|file| file.ends_with(end));
        such.next()
            .unwrap_or_else(|| panic!("no {end} among {files:?}"))
    };
    assert!(files.iter().all(|file| file.is_file()));
    check("desktop-file-validate", &[], file("sightline.desktop"));
    check(
        "bash",
        &["-n"],
        file("bash-completion/completions/sightline"),
    );
    let pages: Vec<_> = files
        .iter()
        .filter(|file| file.extension().is_some_and(|end| end == "1"))
        .collect();
    assert_eq!(pages.len(), 7, "the program's and one a command");
    for page in pages {
        check(
            "man",
            &["--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z"],
            page,
        );
        let text = std::fs::read_to_string(page).unwrap();
        assert!(text.contains("Exit codes"), "{}", page.display());
    }
    let entry = std::fs::read_to_string(file("sightline.desktop")).unwrap();
    assert!(entry.contains(env!("CARGO_BIN_EXE_sightline")), "{entry}");
}

#[test]
fn the_thumbnailer_draws() {
    let folder = Folder::new();
    let files = install(&folder, "");
    let thumbnailer = files
        .iter()
        .find(|file| file.ends_with("sightline.thumbnailer"))
        .unwrap();
    let text = std::fs::read_to_string(thumbnailer).unwrap();
    let exec = text
        .lines()
        .find_map(|line| line.strip_prefix("Exec="))
        .unwrap();
    let line = exec
        .replace("%s", "64")
        .replace("%o", "small.png")
        .replace("%i", "scene.toml");
    let drawn = Command::new("sh")
        .args(["-c", &line])
        .current_dir(folder.path("."))
        .status()
        .unwrap();
    assert!(
        drawn.success() && folder.path("small.png").exists(),
        "{line}"
    );
}

#[test]
fn nothing_is_left_after_remove() {
    let folder = Folder::new();
    let files = install(&folder, "");
    assert_eq!(install(&folder, "--remove"), files);
    assert!(!files.iter().any(|file| file.exists()));
    assert!(
        install(&folder, "--remove").is_empty(),
        "nothing to take away"
    );
}
