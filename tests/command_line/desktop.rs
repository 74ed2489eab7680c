//! The files for desktops, `man` and shells are accepted by these, and the Debian package has all of them.

use super::*;
use clap::CommandFactory;
use clap_mangen::Man;
use sightline::cli::Cli;
use std::{collections::BTreeSet, fs, io, path::Path};

fn here(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

/// Fails unless a program accepts a file without a word on standard error.
fn check(program: &str, args: &[&str], file: &str) {
    let output = Command::new(program)
        .args(args)
        .arg(here(file))
        .env("LC_ALL", "C.UTF-8")
        .output();
    let output = output.unwrap_or_else(|error| panic!("{program}: {error}"));
    let [said, more] = [&output.stderr, &output.stdout].map(|text| String::from_utf8_lossy(text));
    assert!(
        output.status.success() && said.is_empty(),
        "{program} {file}: {said}{more}"
    );
}

/// Fails unless the file holds this text. `SIGHTLINE_GOLDENS=write` writes it.
fn holds(file: &str, text: &[u8]) {
    if std::env::var_os("SIGHTLINE_GOLDENS").is_some_and(|what| what == "write") {
        fs::write(here(file), text).expect("a writable folder");
    }
    let golden = fs::read(here(file)).unwrap_or_default();
    assert!(golden == text, "{file}: SIGHTLINE_GOLDENS=write makes it");
}

/// The man page: the program's, and below it a part for each command.
fn page() -> io::Result<String> {
    type Render = fn(&Man, &mut dyn Write) -> io::Result<()>;
    const OF_ALL: [Render; 4] = [
        Man::render_synopsis_section,
        Man::render_description_section,
        Man::render_options_section,
        Man::render_extra_section,
    ];
    let sections = |command: &clap::Command, renders: &[Render]| {
        let (man, mut text) = (Man::new(command.clone()), Vec::new());
        for render in renders {
            render(&man, &mut text)?;
        }
        Ok::<_, io::Error>(String::from_utf8_lossy(&text).into_owned())
    };
    let mut cli = Cli::command();
    cli.build();
    let begin: [Render; 2] = [Man::render_title, Man::render_name_section];
    let mut page = sections(&cli, &begin)? + &sections(&cli, &OF_ALL)?;
    let commands = cli.get_subcommands();
    for command in commands.filter(|command| command.get_name() != "help") {
        let name = command.get_name().to_uppercase();
        let part = sections(command, &OF_ALL)?.replace("\n.SH ", "\n.SS ");
        page.extend([".SH \"SIGHTLINE ", &name, "\"\n", &part]);
    }
    Ok(page)
}

#[test]
fn man_shows_a_page_of_all_commands() {
    const PAGE: &str = "assets/desktop/sightline.1";
    let text = page().expect("memory takes all that is written");
    holds(PAGE, text.as_bytes());
    let flags = ["--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z"];
    check("man", &flags, PAGE);
    for command in Cli::command().get_subcommands() {
        let heading = format!("SIGHTLINE {}", command.get_name().to_uppercase());
        assert!(text.contains(&heading), "{heading}");
    }
}

#[test]
fn shells_complete() {
    let folder = Folder::new();
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let output = folder.run(&format!("completions {shell}"));
        assert!(output.status.success(), "{shell}: {output:?}");
        let text = String::from_utf8_lossy(&output.stdout);
        assert!(text.contains("all-hits"), "{shell}: {text}");
        if ["bash", "fish", "zsh"].contains(&shell) {
            holds(&format!("assets/desktop/sightline.{shell}"), &output.stdout);
        }
    }
    check("bash", &["-n"], "assets/desktop/sightline.bash");
    folder.error("completions tcsh", 2);
}

#[test]
fn the_menu_entry_is_valid() {
    let entry = "assets/desktop/sightline.desktop";
    check("desktop-file-validate", &[], entry);
}

#[test]
fn the_thumbnailer_draws() {
    let folder = Folder::new();
    let text = fs::read_to_string(here("assets/desktop/sightline.thumbnailer")).unwrap();
    let mut lines = text.lines();
    let exec = lines.find_map(|line| line.strip_prefix("Exec=")).unwrap();
    let line = exec
        .replacen("sightline", env!("CARGO_BIN_EXE_sightline"), 1)
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

/// What `cargo deb` packs is there, and it packs all files for desktops.
#[test]
fn the_package_has_all_files() {
    let manifest = fs::read_to_string(here("Cargo.toml")).unwrap();
    let manifest: toml::Table = manifest.parse().unwrap();
    let assets = manifest["package"]["metadata"]["deb"]["assets"].as_array();
    let sources = assets
        .unwrap()
        .iter()
        .map(|asset| asset[0].as_str().unwrap());
    let mut packed: BTreeSet<_> = sources.map(here).collect();
    assert!(packed.remove(&here("target/release/sightline")));
    for source in &packed {
        assert!(source.is_file(), "{}", source.display());
    }
    for entry in fs::read_dir(here("assets/desktop")).unwrap() {
        let file = entry.unwrap().path();
        assert!(packed.contains(&file), "{}", file.display());
    }
}
