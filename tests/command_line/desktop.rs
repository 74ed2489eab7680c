//! `install-desktop`: desktops, `man` and shells accept what it writes, and `--remove` leaves nothing.

use super::*;
use std::path::Path;

/// Fails unless a program accepts a file without a word on standard error.
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
    assert_eq!(pages.len(), 8, "the program's and one a command");
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

/// All files and folders below one, by their paths in it.
fn all_in(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in std::fs::read_dir(next).unwrap() {
            let path = entry.unwrap().path();
            found.push(path.strip_prefix(folder).unwrap().to_owned());
            if path.is_dir() && !path.is_symlink() {
                folders.push(path);
            }
        }
    }
    found.sort();
    found
}

#[test]
fn nothing_is_left_after_remove() {
    let folder = Folder::new();
    let files = install(&folder, "");
    assert!(
        all_in(&folder.path("share")).len() > files.len(),
        "folders too"
    );
    assert_eq!(install(&folder, "--remove"), files);
    assert_eq!(all_in(&folder.path("share")), Vec::<PathBuf>::new());
    assert!(
        install(&folder, "--remove").is_empty(),
        "nothing to take away"
    );
}

/// Files that others wrote stay, even under the names of Sightline's files. So does what the caches know of them.
#[test]
fn what_others_wrote_stays() {
    let folder = Folder::new();
    let share = folder.path("share");
    let others = [
        (
            "applications/sightline.desktop",
            "[Desktop Entry]\nName=Mine\n",
        ),
        (
            "applications/other.desktop",
            "[Desktop Entry]\nType=Application\nName=O\nExec=o\nMimeType=text/x-o;\n",
        ),
        ("man/man1/sightline.1", "mine"),
        (
            "mime/packages/other.xml",
            "<?xml version=\"1.0\"?><mime-info xmlns=\"http://www.freedesktop.org/standards/shared-mime-info\"><mime-type type=\"text/x-o\"><glob pattern=\"*.o1\"/></mime-type></mime-info>",
        ),
    ];
    install(&folder, "");
    for (place, text) in others {
        std::fs::write(share.join(place), text).unwrap();
    }
    // A file of another version, or of a program that stood elsewhere.
    let bash = share.join("bash-completion/completions/sightline");
    let script = std::fs::read_to_string(&bash).unwrap();
    std::fs::write(&bash, script.replace("--tour", "--more")).unwrap();
    let output = folder.run("install-desktop --to share --remove");
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{said}");
    assert_eq!(said.matches("not removed").count(), 2, "{said}");
    for (place, text) in others {
        assert_eq!(std::fs::read_to_string(share.join(place)).unwrap(), text);
    }
    assert!(!bash.exists());
    let cache = |place: &str| {
        let text = std::fs::read(share.join(place)).unwrap();
        String::from_utf8_lossy(&text).into_owned()
    };
    for (place, theirs) in [
        ("applications/mimeinfo.cache", "text/x-o"),
        ("mime/globs2", "*.o1"),
    ] {
        let text = cache(place);
        assert!(
            text.contains(theirs) && !text.contains("obj"),
            "{place}: {text}"
        );
    }
    let ours = all_in(&share);
    let ours = ours
        .iter()
        .filter(|path| path.to_string_lossy().contains("sightline"));
    assert_eq!(ours.count(), 2);
}

/// No version writes a file of more than 1 MiB: a larger one is another's, and is not read.
#[test]
fn a_large_file_stays_unread() {
    let folder = Folder::new();
    install(&folder, "");
    let page = folder.path("share/man/man1/sightline.1");
    let file = std::fs::File::options().write(true).open(&page).unwrap();
    for (bytes, is_ours) in [((1 << 20) + 1, false), (1 << 20, true)] {
        file.set_len(bytes).unwrap();
        install(&folder, "--remove");
        assert_eq!(page.exists(), !is_ours, "{bytes} bytes");
    }
}

#[cfg(unix)]
#[test]
fn what_a_link_points_to_is_not_written() {
    let folder = Folder::new();
    let link = folder.path("share/applications/sightline.desktop");
    std::fs::create_dir_all(link.parent().unwrap()).unwrap();
    let victim = folder.path("victim");
    std::fs::write(&victim, "mine").unwrap();
    std::os::unix::fs::symlink(&victim, &link).unwrap();
    install(&folder, "");
    assert_eq!(std::fs::read_to_string(&victim).unwrap(), "mine");
    assert!(std::fs::symlink_metadata(&link).unwrap().is_file());
    std::fs::remove_file(&link).unwrap();
    std::os::unix::fs::symlink(&victim, &link).unwrap();
    install(&folder, "--remove");
    assert!(link.is_symlink() && victim.exists());
}
