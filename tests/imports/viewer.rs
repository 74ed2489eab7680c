//! Imports among the window's files. Rooms name only rooms above them, and no file imports itself indirectly.

use super::{code, files_under};
use std::{
    collections::{BTreeMap, BTreeSet},
    path::{Path, PathBuf},
    slice,
};

/// The rooms, each of which names only those before it; `options` is a file beside them.
const ROOMS: [&str; 7] = ["model", "options", "jobs", "screen", "ui", "app", "host"];

/// What some rooms do without.
const KEPT_OUT: [(&str, &[&str]); 3] = [
    (
        "model",
        &["egui", "winit", "wgpu", "rfd", "std::thread", "mpsc"],
    ),
    ("jobs", &["egui", "winit", "wgpu"]),
    ("ui", &["winit", "wgpu"]),
];

/// A path as Rust writes it, from `crate`: its words.
type Words = Vec<String>;

/// The files of the viewer by the words of their modules.
struct Modules {
    files: BTreeMap<Words, PathBuf>,
    /// What facades hand on: a facade's words and a name, to what it is the name of.
    names: BTreeMap<(Words, String), Words>,
}

fn words(path: &str) -> Words {
    path.split("::")
        .map(|word| word.trim().to_owned())
        .collect()
}

/// The paths of a use tree, one for each leaf.
fn leaves(tree: &str) -> Vec<String> {
    let Some((before, inside)) = tree.split_once('{') else {
        let path = tree.split(" as ").next().unwrap_or_default().trim();
        return vec![path.trim_end_matches("::self").to_owned()];
    };
    let inside = &inside[..inside.rfind('}').expect("braces in pairs")];
    let (mut depth, mut start, mut parts) = (0, 0, Vec::new());
    for (i, c) in inside.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                parts.push(&inside[start..i]);
                start = i + 1;
            }
            _ => {}
        }
    }
    parts.push(&inside[start..]);
    let parts = parts
        .into_iter()
        .map(str::trim)
        .filter(|part| !part.is_empty());
    parts
        .flat_map(|part| leaves(&format!("{}{part}", before.trim())))
        .collect()
}

/// The use trees of a file, and the rest of it.
fn uses(code: &str) -> (Vec<&str>, String) {
    let (mut trees, mut rest, mut left) = (Vec::new(), String::new(), code);
    while let Some(at) = left.find("use ") {
        let is_word = left[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_');
        if is_word {
            rest.push_str(&left[..at + 4]);
            left = &left[at + 4..];
            continue;
        }
        rest.push_str(&left[..at]);
        let end = at + left[at..].find(';').expect("a use ends");
        trees.push(&left[at + 4..end]);
        left = &left[end..];
    }
    rest.push_str(left);
    (trees, rest)
}

/// The paths that begin with `first` in code without use trees.
fn inline(code: &str, first: &str) -> Vec<String> {
    let is_path = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
    let starts = code.match_indices(first).filter(|(at, _)| {
        let before = code[..*at].chars().next_back();
        !before.is_some_and(is_path)
    });
    let path = |at: usize| code[at..].split(|c| !is_path(c)).next().unwrap_or_default();
    starts
        .map(|(at, _)| path(at).trim_end_matches(':').to_owned())
        .collect()
}

impl Modules {
    fn read() -> Self {
        let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
        let mut files = BTreeMap::new();
        for path in files_under(&src.join("viewer")) {
            let inner = path
                .strip_prefix(&src)
                .expect("under it")
                .with_extension("");
            let mut module: Words = vec!["crate".into()];
            module.extend(
                inner
                    .iter()
                    .map(|word| word.to_str().expect("text").to_owned()),
            );
            module.retain(|word| word != "mod");
            files.insert(module, path);
        }
        let mut modules = Self {
            files,
            names: BTreeMap::new(),
        };
        for (module, path) in modules.files.clone() {
            if !is_facade(&path) {
                continue;
            }
            for leaf in uses(&code(&path)).0.into_iter().flat_map(leaves) {
                let to = absolute(&module, &leaf, true);
                let name = to.last().expect("a word").clone();
                modules.names.insert((module.clone(), name), to);
            }
        }
        modules
    }

    /// The file that a path leads to; `None` outside the viewer.
    fn file_of(&self, path: &[String]) -> Option<Words> {
        if path.len() < 2 || path[..2] != ["crate", "viewer"] {
            return None;
        }
        let mut at: Words = path[..2].to_vec();
        for word in &path[2..] {
            let inner: Words = at.iter().chain([word]).cloned().collect();
            if self.files.contains_key(&inner) {
                at = inner;
            } else if let Some(to) = self.names.get(&(at.clone(), word.clone())) {
                at = self.file_of(to)?;
            } else {
                break;
            }
        }
        Some(at)
    }

    /// The files of the viewer that a file names.
    fn named_by(&self, module: &Words, path: &Path) -> BTreeSet<Words> {
        let code = code(path);
        let (trees, rest) = uses(&code);
        let facade = is_facade(path);
        let mut paths: Vec<Words> = Vec::new();
        for leaf in trees.into_iter().flat_map(leaves) {
            let full = absolute(module, &leaf, facade);
            // A module that is named as such: what is named through it.
            if self.files.contains_key(&full) {
                let name = full.last().expect("a word");
                for through in inline(&rest, &format!("{name}::")) {
                    let inner = words(&through).into_iter().skip(1);
                    paths.push(full.iter().cloned().chain(inner).collect());
                }
            }
            paths.push(full);
        }
        for first in ["crate::", "super::"] {
            let found = inline(&rest, first);
            paths.extend(found.iter().map(|path| absolute(module, path, facade)));
        }
        let files = paths.iter().filter_map(|path| self.file_of(path));
        let files = files.filter(|file| file != module && !is_facade(&self.files[file]));
        files.collect()
    }

    /// Every file that is no facade, with those that it names.
    fn edges(&self) -> BTreeMap<Words, BTreeSet<Words>> {
        let files = self.files.iter().filter(|(_, path)| !is_facade(path));
        let named =
            |(module, path): (&Words, &PathBuf)| (module.clone(), self.named_by(module, path));
        files.map(named).collect()
    }
}

fn is_facade(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name == "mod.rs")
}

/// A path as a file writes it, from `crate`. What a facade writes without `super` is its own.
fn absolute(module: &Words, path: &str, facade: bool) -> Words {
    let mut from: Words = module.clone();
    let mut rest = words(path);
    match rest[0].as_str() {
        "crate" => return rest,
        "self" => drop(rest.remove(0)),
        "super" => {
            while rest.first().is_some_and(|word| word == "super") {
                from.pop();
                rest.remove(0);
            }
        }
        _ if facade => {}
        _ => return rest,
    }
    from.extend(rest);
    from
}

fn room(module: &Words) -> usize {
    let room = ROOMS.iter().position(|room| *room == module[2]);
    room.unwrap_or_else(|| panic!("{} is no room", module.join("::")))
}

#[test]
fn rooms_of_the_viewer_name_only_those_above_them() {
    let edges = Modules::read().edges();
    let mut seen = 0;
    for (from, named) in &edges {
        for to in named {
            let (from_room, to_room) = (room(from), room(to));
            assert!(from_room >= to_room, "{from:?} names {to:?}");
            seen += usize::from(from_room > to_room);
        }
    }
    assert!(seen > 80, "{seen}: the search finds imports");
}

#[test]
fn no_file_of_the_viewer_names_itself_by_a_detour() {
    let edges = Modules::read().edges();
    assert!(edges.len() > 50, "{}", edges.len());
    let mut done: BTreeSet<&Words> = BTreeSet::new();
    loop {
        let free = |from: &&Words| {
            let named = &edges[*from];
            !done.contains(*from) && named.iter().all(|to| done.contains(to))
        };
        let next: Vec<_> = edges.keys().filter(free).collect();
        if next.is_empty() {
            break;
        }
        done.extend(next);
    }
    let left: Vec<_> = edges.keys().filter(|file| !done.contains(file)).collect();
    assert!(left.is_empty(), "in circles, or behind one: {left:#?}");
}

#[test]
fn facades_of_the_viewer_hold_nothing_of_their_own() {
    let mut seen = 0;
    for path in Modules::read()
        .files
        .values()
        .filter(|path| is_facade(path))
    {
        let code = code(path);
        for word in [
            "fn ", "struct ", "enum ", "impl ", "trait ", "const ", "static ",
        ] {
            assert!(!code.contains(word), "{}: {word}", path.display());
        }
        seen += 1;
    }
    assert_eq!(
        seen,
        1 + ROOMS.len() - 1 + 1,
        "the viewer, its rooms, the panels"
    );
}

#[test]
fn files_of_the_viewer_have_a_name_each() {
    let modules = Modules::read();
    let mut names = BTreeMap::new();
    for (module, path) in modules.files.iter().filter(|(_, path)| !is_facade(path)) {
        if let Some(other) = names.insert(module.last(), path) {
            panic!("{} and {}", other.display(), path.display());
        }
    }
}

#[test]
fn rooms_do_without_what_is_kept_out_of_them() {
    for (room, kept_out) in KEPT_OUT {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("src/viewer")
            .join(room);
        let files = files_under(&folder);
        assert!(files.len() > 3, "{room}");
        for path in files {
            let code = code(&path);
            for word in kept_out {
                let named = [format!("{word}::"), format!("use {word}")];
                let found = named.iter().any(|named| code.contains(named.as_str()));
                assert!(!found, "{} names {word}", path.display());
            }
        }
    }
}

/// The files of a room, or of a folder in it.
fn files_of(folder: &str) -> Vec<PathBuf> {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/viewer");
    files_under(&src.join(folder))
}

/// One file orders the steps of a frame, for windows and for pictures of them. Hosts ask it for a whole frame, for a
/// pass without a picture, or for the results of jobs. They ask for no step in between.
#[test]
fn one_driver_orders_the_steps_of_a_frame() {
    let driver = files_of("app")
        .into_iter()
        .find(|path| path.ends_with("frame.rs"));
    let driver = driver.expect("a driver");
    for step in [".run_ui(", ".tessellate(", ".restore()", ".take_textures("] {
        let files = ["app", "host"].map(files_of).into_iter().flatten();
        let callers: Vec<_> = files.filter(|path| code(path).contains(step)).collect();
        assert_eq!(callers, slice::from_ref(&driver), "{step}");
    }
    let code = code(&driver);
    let offered = code.lines().filter_map(|line| {
        let (before, name) = line.split_once("fn ")?;
        let is_offered = before.trim_start().starts_with("pub");
        is_offered.then(|| name.split('(').next().unwrap_or_default())
    });
    let offered: Vec<_> = offered.collect();
    assert_eq!(offered, ["frame", "pass", "take_finished"]);
}

/// Panels are laid out in each pass, so they go through no list of all objects. The list's filter goes through it once
/// for each text.
#[test]
fn panels_go_through_no_list_of_all_objects() {
    let mut seen = 0;
    for path in files_of("ui/panels") {
        let code: String = code(&path).split_whitespace().collect();
        let walks = [".objects().iter()", ".objects(){", ".batches().iter()"];
        let walks = walks.map(|walk| code.matches(walk).count());
        let may = usize::from(path.ends_with("objects.rs"));
        assert_eq!(walks.iter().sum::<usize>(), may, "{}", path.display());
        seen += 1;
    }
    assert!(seen > 30, "{seen}");
}
