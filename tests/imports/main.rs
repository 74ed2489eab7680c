//! Imports have no circles, and only the modules that need graphics and windows import them.

mod graph;
mod names;
mod reached;
mod viewer;

use graph::Modules;
use std::{
    collections::BTreeSet,
    fs,
    path::{Path, PathBuf},
};

/// Each module and what it may name, as in the map of `lib.rs`: only modules in the rows above it.
const MAY_NAME: [(&str, &str); 16] = [
    ("plain", ""),
    ("json", "plain"),
    ("replace", ""),
    ("colour", ""),
    ("geometry", "colour"),
    ("look", "colour"),
    ("camera", "geometry"),
    ("image", "replace colour look camera"),
    ("scene", "plain replace colour geometry camera"),
    ("pick", "colour geometry look camera image scene"),
    ("render", "colour geometry look camera image scene"),
    (
        "verify",
        "colour geometry look camera image scene pick render",
    ),
    (
        "study",
        "replace geometry look camera image scene pick render",
    ),
    (
        "viewer",
        "plain json replace colour geometry look camera image scene pick render verify study",
    ),
    (
        "cli",
        "plain json replace colour geometry look camera image scene pick render verify study viewer",
    ),
    ("main", "cli"),
];

/// The core, without features: it names no other module, and no crate that only those need.
const CORE: [&str; 7] = [
    "colour", "geometry", "look", "camera", "image", "scene", "pick",
];

/// Folders within the core that a feature adds.
const ADDED: [&str; 2] = ["scene/files", "image/png.rs"];

/// Crates that only some modules may name.
const KEPT: [(&str, &[&str]); 5] = [
    ("wgpu", &["render", "viewer"]),
    ("winit", &["viewer"]),
    ("egui", &["viewer"]),
    ("tobj", &["scene"]),
    ("clap", &["cli"]),
];

/// Every file in a folder and those within it.
fn files_under(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            files.extend(files_under(&path));
        } else {
            files.push(path);
        }
    }
    files
}

/// Each source file and the module that it belongs to.
fn sources() -> Vec<(String, PathBuf)> {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let files = files_under(&src);
    let module = |path: &Path| {
        let first = path.strip_prefix(&src).ok()?.components().next()?;
        let name = Path::new(&first).file_stem()?.to_str()?;
        Some(name.to_owned())
    };
    let named = files
        .into_iter()
        .map(|path| (module(&path).expect("a name"), path));
    named.filter(|(module, _)| module != "lib").collect()
}

/// The file without its comments.
fn code(path: &Path) -> String {
    let text = fs::read_to_string(path).expect("a source file");
    let lines = text
        .lines()
        .map(|line| line.split("//").next().unwrap_or_default());
    lines.collect::<Vec<_>>().join("\n")
}

/// The words that follow `prefix` in paths: one, or the first of each path within braces.
fn named_after<'a>(code: &'a str, prefix: &str) -> BTreeSet<&'a str> {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let first_word = |text: &'a str| text.trim_start().split(|c| !is_word(c)).next();
    let mut words = BTreeSet::new();
    for (at, _) in code.match_indices(prefix) {
        let rest = &code[at + prefix.len()..];
        let Some(inner) = rest.strip_prefix('{') else {
            words.extend(first_word(rest));
            continue;
        };
        let mut depth = 0;
        let mut start = 0;
        for (i, c) in inner.char_indices() {
            match c {
                '{' => depth += 1,
                ',' | '}' if depth == 0 => {
                    words.extend(first_word(&inner[start..i]));
                    start = i + 1;
                    if c == '}' {
                        break;
                    }
                }
                '}' => depth -= 1,
                _ => {}
            }
        }
    }
    words.remove("");
    words
}

#[test]
fn modules_name_only_what_they_may() {
    let mut seen = 0;
    for (module, path) in sources() {
        let row = MAY_NAME.iter().position(|(name, _)| *name == module);
        let row = row.unwrap_or_else(|| panic!("{module} has no row"));
        let may: Vec<&str> = MAY_NAME[row].1.split_whitespace().collect();
        let above = MAY_NAME[..row].iter().map(|(name, _)| *name);
        let above: Vec<&str> = above.collect();
        assert!(may.iter().all(|name| above.contains(name)), "{module}");
        let prefix = if module == "main" {
            "sightline::"
        } else {
            "crate::"
        };
        for name in named_after(&code(&path), prefix) {
            let own = name == module;
            assert!(
                own || may.contains(&name),
                "{} names {name}",
                path.display()
            );
            seen += usize::from(!own);
        }
    }
    assert!(seen > 200, "{seen}: the search finds imports");
}

#[test]
fn graphics_and_windows_are_known_to_those_who_draw_and_show() {
    for (name, modules) in KEPT {
        let mut seen = BTreeSet::new();
        for (module, path) in sources() {
            let code = code(&path);
            if code.contains(&format!("{name}::")) || code.contains(&format!("use {name}")) {
                assert!(
                    modules.contains(&module.as_str()),
                    "{} names {name}",
                    path.display()
                );
                seen.insert(module);
            }
        }
        assert_eq!(seen.len(), modules.len(), "{name}: {seen:?}");
    }
}

#[test]
fn the_core_names_no_crate_and_no_module_that_a_feature_adds() {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let manifest = fs::read_to_string(package.join("Cargo.toml")).expect("a manifest");
    let optional = manifest.lines().filter_map(|line| {
        let (name, rest) = line.split_once(" = {")?;
        let is_optional = rest.contains("optional = true");
        is_optional.then(|| name.replace('-', "_"))
    });
    let optional: Vec<String> = optional.collect();
    let beyond: Vec<&str> = (MAY_NAME.iter().map(|(name, _)| *name))
        .filter(|name| !CORE.contains(name))
        .collect();
    let added = ADDED.map(|path| package.join("src").join(path));
    assert!(added.iter().all(|path| path.exists()), "{added:?}");
    let of_core = |(module, path): &(String, PathBuf)| {
        CORE.contains(&module.as_str()) && !added.iter().any(|added| path.starts_with(added))
    };
    let files: Vec<_> = sources().into_iter().filter(of_core).collect();
    for (_, path) in &files {
        let code = code(path);
        for name in named_after(&code, "crate::") {
            assert!(!beyond.contains(&name), "{} names {name}", path.display());
        }
        for name in &optional {
            let named = format!("{name}::");
            let is_named = code.match_indices(&named).any(|(at, _)| {
                !code[..at].ends_with(|c: char| c == '_' || c == ':' || c.is_alphanumeric())
            });
            assert!(!is_named, "{} names {name}", path.display());
        }
    }
    assert!(optional.len() > 30, "{optional:?}");
    assert!(files.len() > 70, "only {} files", files.len());
}

/// The files can then be read one after another. `mod.rs` files are left out: they re-export names, and hold what the
/// files of their folder share.
#[test]
fn no_file_names_itself_by_a_detour() {
    let mut left = Modules::read().edges();
    assert!(left.len() > 300, "{}", left.len());
    loop {
        let named: BTreeSet<_> = left.values().flatten().cloned().collect();
        let before = left.len();
        let files: BTreeSet<_> = left.keys().cloned().collect();
        left.retain(|file, names| named.contains(file) && !names.is_disjoint(&files));
        if left.len() == before {
            break;
        }
    }
    let files: BTreeSet<_> = left.keys().cloned().collect();
    let circles = left.iter().map(|(file, names)| {
        let names = names.intersection(&files).map(|name| name.join("::"));
        format!(
            "{} names {}",
            file.join("::"),
            names.collect::<Vec<_>>().join(", ")
        )
    });
    let circles: Vec<_> = circles.collect();
    assert!(
        circles.is_empty(),
        "in circles, or between two: {circles:#?}"
    );
}
