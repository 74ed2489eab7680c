//! `sightline install-desktop`: writes the files that tell desktops and shells about the program.

use super::{Cli, CliError, terminal::start_log};
use crate::{
    replace::replace,
    viewer::{APP_ID, ICON_PNG},
};
use clap::CommandFactory;
use clap_complete::Shell;
use etcetera::BaseStrategy;
use std::{
    env, fs,
    io::{self, ErrorKind, Read, Write},
    path::{Path, PathBuf},
    process,
};

/// Arguments of `install-desktop`.
#[derive(Debug, clap::Args)]
pub struct InstallDesktopArgs {
    /// Remove all these files again
    #[arg(long)]
    pub remove: bool,
    /// The share folder that desktops read [default: your own, as ~/.local/share]
    #[arg(long, value_name = "DIR")]
    pub to: Option<PathBuf>,
}

const ICON_SVG: &[u8] = include_bytes!("../../assets/icon.svg");
/// The MIME type of OBJ files. Some systems assign `*.obj` to another type. The higher weight wins; the default is 50.
const TYPES: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<mime-info xmlns="http://www.freedesktop.org/standards/shared-mime-info">
  <mime-type type="model/obj">
    <comment>Wavefront OBJ model</comment>
    <glob pattern="*.obj" weight="60"/>
  </mime-type>
</mime-info>
"#;

/// The commands that tell desktops about new files.
const TELLERS: [Teller; 2] = [
    Teller {
        command: "update-desktop-database",
        folder: "applications",
        files: "",
        end: "desktop",
        caches: "mimeinfo.cache",
    },
    Teller {
        command: "update-mime-database",
        folder: "mime",
        files: "packages",
        end: "xml",
        caches: "XMLnamespaces aliases generic-icons globs globs2 icons magic mime.cache subclasses treemagic \
                 types version",
    },
];

struct Teller {
    command: &'static str,
    /// The folder, in the share folder, that the command gets.
    folder: &'static str,
    /// The folder, in that folder, with the files that the command reads; empty for the folder itself.
    files: &'static str,
    /// The extension of the files that the command reads.
    end: &'static str,
    /// The files that the command writes, with spaces between them.
    caches: &'static str,
}

/// The most bytes that a file of any version of this program has. A longer file is not read.
const MOST_BYTES: u64 = 1 << 20;

/// The last comment of a file whose text depends on the version or the program's path. It shows that this program wrote
/// the file.
const MARK: &str = "Written by sightline install-desktop, which --remove takes away.";

/// Writes or removes the files, and prints which.
pub(super) fn run(args: &InstallDesktopArgs) -> Result<(), CliError> {
    start_log(false);
    let share = match &args.to {
        Some(folder) => folder.clone(),
        None => own_share_folder()?,
    };
    let program = env::current_exe().map_err(|error| CliError::file(Path::new(APP_ID), &error))?;
    let mut out = io::stdout().lock();
    let files = files(&program);
    for (place, contents) in &files {
        let path = share.join(place);
        let done = if args.remove {
            remove(&path, contents)
        } else {
            write(&path, contents)
        };
        if done.map_err(|error| CliError::file(&path, &error))? {
            writeln!(out, "{}", path.display()).map_err(CliError::stdout)?;
        }
    }
    for teller in &TELLERS {
        teller.tell(&share, args.remove);
    }
    if args.remove {
        // The command for MIME types writes its result for OBJ files to this last path.
        let places = files.iter().map(|(place, _)| &**place);
        for place in places.chain([Path::new("mime/model/obj.xml")]) {
            let folders = place.ancestors().skip(1);
            for folder in folders.filter(|folder| *folder != Path::new("")) {
                // Fails where the folder is not empty: then it stays.
                let _ = fs::remove_dir(share.join(folder));
            }
        }
    }
    Ok(())
}

/// The user's own share folder.
fn own_share_folder() -> Result<PathBuf, CliError> {
    let unknown = "desktops of this system read no such files; --to DIR writes them for others";
    if cfg!(any(windows, target_os = "macos")) {
        return Err(CliError::usage(unknown));
    }
    let no_home = |_| CliError::usage("there is no home folder: say --to DIR");
    let places = etcetera::choose_base_strategy().map_err(no_home)?;
    Ok(places.data_dir())
}

/// Writes a file and returns true. A symbolic link is replaced itself, so that the file that it leads to is kept.
fn write(path: &Path, contents: &[u8]) -> io::Result<bool> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    if fs::symlink_metadata(path).is_ok_and(|about| about.is_symlink()) {
        fs::remove_file(path)?;
    }
    replace(path, |out| out.write_all(contents))?;
    Ok(true)
}

/// Removes a file if any version of this program wrote it. Returns whether the file was removed.
fn remove(path: &Path, contents: &[u8]) -> io::Result<bool> {
    let about = match fs::symlink_metadata(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(false),
        about => about?,
    };
    let is_ours = about.is_file() && about.len() <= MOST_BYTES && {
        let mut there = Vec::new();
        let file = fs::File::open(path)?;
        file.take(about.len()).read_to_end(&mut there)?;
        there == contents || String::from_utf8_lossy(&there).contains(MARK)
    };
    if !is_ours {
        log::warn!(
            "{}: not removed, because Sightline did not write it",
            path.display()
        );
        return Ok(false);
    }
    fs::remove_file(path)?;
    Ok(true)
}

impl Teller {
    /// Runs the command, so that the system reads the folder again. If the command is missing, the system does this by
    /// itself, or at the next login. With `take_away`, also removes the files that the command wrote, if the folder has
    /// no other files for it.
    fn tell(&self, share: &Path, take_away: bool) {
        let folder = share.join(self.folder);
        if !folder.is_dir() {
            return;
        }
        let told = process::Command::new(self.command).arg(&folder).output();
        if let Err(error) = told {
            log::info!("{}: {error}", self.command);
        }
        let files = folder.join(self.files);
        let is_one = |path: PathBuf| path.extension().is_some_and(|end| end == self.end);
        let mut left = (fs::read_dir(files).into_iter().flatten()).flatten();
        if take_away && !left.any(|entry| is_one(entry.path())) {
            for cache in self.caches.split(' ') {
                let _ = fs::remove_file(folder.join(cache));
            }
        }
    }
}

/// All files to write: their paths in a share folder, and their contents.
fn files(program: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let mut files = vec![
        (
            "applications/sightline.desktop".into(),
            entry(program).into(),
        ),
        (
            "thumbnailers/sightline.thumbnailer".into(),
            thumbnailer(program).into(),
        ),
        ("mime/packages/sightline.xml".into(), TYPES.into()),
        (
            "icons/hicolor/scalable/apps/sightline.svg".into(),
            ICON_SVG.into(),
        ),
        (
            "icons/hicolor/256x256/apps/sightline.png".into(),
            ICON_PNG.into(),
        ),
    ];
    for (shell, place) in [
        (Shell::Bash, "bash-completion/completions/sightline"),
        (Shell::Fish, "fish/vendor_completions.d/sightline.fish"),
        (Shell::Zsh, "zsh/site-functions/_sightline"),
    ] {
        let mut script = Vec::new();
        clap_complete::generate(shell, &mut Cli::command(), APP_ID, &mut script);
        script.extend(format!("# {MARK}\n").bytes());
        files.push((place.into(), script));
    }
    let mut cli = Cli::command();
    cli.build();
    let commands = cli
        .get_subcommands()
        .filter(|command| command.get_name() != "help");
    for command in [&cli].into_iter().chain(commands) {
        let page = clap_mangen::Man::new(command.clone());
        let mut text = Vec::new();
        page.render(&mut text)
            .expect("memory takes all that is written");
        text.extend(format!(".\\\" {MARK}\n").bytes());
        let name = command.get_display_name().unwrap_or(APP_ID);
        files.push((format!("man/man1/{name}.1").into(), text));
    }
    files
}

/// The menu entry. It also lets file managers open files with the program.
fn entry(program: &Path) -> String {
    let exec = quoted(program);
    format!(
        "[Desktop Entry]\n\
         Type=Application\n\
         Version=1.0\n\
         Name=Sightline\n\
         GenericName=3D Viewer\n\
         Comment=What you see is what you pick, to the pixel\n\
         Exec={exec} %F\n\
         Icon={APP_ID}\n\
         Terminal=false\n\
         Categories=Graphics;3DGraphics;Viewer;\n\
         Keywords=3D;OBJ;mesh;pick;measure;\n\
         MimeType=model/obj;\n\
         StartupWMClass={APP_ID}\n\
         StartupNotify=true\n\
         Actions=tour;\n\
         \n\
         [Desktop Action tour]\n\
         Name=Tour of cameras and raycasting\n\
         Exec={exec} --tour\n\
         # {MARK}\n"
    )
}

/// The thumbnailer entry. The thumbnailer draws by rays, because its sandbox has no graphics driver.
fn thumbnailer(program: &Path) -> String {
    let exec = quoted(program);
    format!(
        "[Thumbnailer Entry]\n\
         Exec={exec} render --by raycast --size %sx%s -o %o %i\n\
         MimeType=model/obj;\n\
         # {MARK}\n"
    )
}

/// A path for the key `Exec`: quoted by the rules of this key, then escaped by the rules of all strings (Desktop Entry
/// Specification, "The Exec key").
fn quoted(path: &Path) -> String {
    let mut text = String::from("\"");
    for character in path.to_string_lossy().chars() {
        match character {
            '"' | '`' | '$' => text.extend(["\\\\", character.encode_utf8(&mut [0; 4])]),
            '\\' => text.push_str("\\\\\\\\"),
            '%' => text.push_str("%%"),
            other => text.push(other),
        }
    }
    text + "\""
}

#[cfg(test)]
mod tests {
    use super::quoted;
    use std::path::Path;

    /// The expected texts are written by hand, from the specification.
    #[test]
    fn a_path_of_any_name_can_be_started() {
        for (path, exec) in [
            ("/usr/bin/sightline", r#""/usr/bin/sightline""#),
            ("/a b/100%/s", r#""/a b/100%%/s""#),
            (r"/a\b", r#""/a\\\\b""#),
            ("/a$b`c\"d", r#""/a\\$b\\`c\\"d""#),
        ] {
            assert_eq!(quoted(Path::new(path)), exec);
        }
    }
}
