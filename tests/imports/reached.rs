//! Every file is compiled: some root names it, or something that a root names.

use crate::files_under;
use std::{
    collections::BTreeSet,
    fs,
    path::{Path, PathBuf},
};

/// What the compiler is pointed at: the crate, its tests, and the other targets whose paths `Cargo.toml` lists.
fn roots(package: &Path) -> Vec<PathBuf> {
    let manifest = fs::read_to_string(package.join("Cargo.toml")).expect("a manifest");
    let listed = manifest.lines().filter_map(|line| {
        let path = line.strip_prefix("path = \"")?.strip_suffix('"')?;
        Some(package.join(path))
    });
    let tests = fs::read_dir(package.join("tests")).expect("tests");
    let tests = tests.filter_map(|entry| {
        let path = entry.expect("an entry").path();
        let root = if path.is_dir() {
            path.join("main.rs")
        } else {
            path
        };
        root.exists().then_some(root)
    });
    let sources = ["src/lib.rs", "src/main.rs"].map(|path| package.join(path));
    listed.chain(tests).chain(sources).collect()
}

/// The files of the modules that a file names.
fn named_in(file: &Path, is_root: bool) -> Vec<PathBuf> {
    let folder = file.parent().expect("a folder");
    let stem = file.file_stem().expect("a name");
    // The modules of `a.rs` lie in `a`, unless it stands for its folder.
    let within = if is_root || stem == "mod" {
        folder.to_owned()
    } else {
        folder.join(stem)
    };
    let text = fs::read_to_string(file).expect("a source file");
    let mut path = None;
    let mut files = Vec::new();
    for line in text.lines().map(str::trim) {
        if let Some(named) = line.strip_prefix("#[path = \"") {
            path = named.strip_suffix("\"]").map(|named| folder.join(named));
        } else if let Some(declared) = line.strip_suffix(';')
            && let Some((visibility, name)) = declared.split_once("mod ")
            && (visibility.is_empty() || visibility.starts_with("pub"))
        {
            let files_of = [
                within.join(name).with_extension("rs"),
                within.join(name).join("mod.rs"),
            ];
            let found = files_of.into_iter().find(|file| file.exists());
            files.extend(path.take().or(found));
        }
    }
    files
}

#[test]
fn every_file_is_compiled() {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let plain = |path: &Path| path.canonicalize().expect("a file");
    let mut reached = BTreeSet::new();
    let mut open: Vec<_> = (roots(package).into_iter())
        .map(|root| (root, true))
        .collect();
    while let Some((file, is_root)) = open.pop() {
        if reached.insert(plain(&file)) {
            open.extend(
                named_in(&file, is_root)
                    .into_iter()
                    .map(|file| (file, false)),
            );
        }
    }
    let all = ["src", "tests"].map(|folder| files_under(&package.join(folder)));
    // The fuzz targets are a package of their own.
    let fuzz = package.join("tests/fuzz");
    let is_ours = |file: &&PathBuf| {
        file.extension().is_some_and(|kind| kind == "rs") && !file.starts_with(&fuzz)
    };
    let files: Vec<_> = all.iter().flatten().filter(is_ours).collect();
    assert!(files.len() > 250, "only {} files", files.len());
    let left: Vec<_> = files
        .iter()
        .filter(|file| !reached.contains(&plain(file)))
        .collect();
    assert!(left.is_empty(), "never compiled: {left:?}");
}
