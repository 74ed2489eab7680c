//! Which file names which: a graph of the imports in `src`.

use super::{code, files_under};
use std::{
    collections::{BTreeMap, BTreeSet},
    path::{Path, PathBuf},
};

/// A path as Rust writes it, from `crate`: its words.
pub(super) type Words = Vec<String>;

/// The files of the crate by the words of their modules.
pub(super) struct Modules {
    pub files: BTreeMap<Words, PathBuf>,
    /// What facades re-export: from a facade's words and a name to the words of what is named.
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

/// The use trees of a file, and the rest of it. Every `use` begins a line.
fn uses(code: &str) -> (Vec<&str>, String) {
    let (mut trees, mut rest, mut at) = (Vec::new(), String::new(), 0);
    while at < code.len() {
        let line = code[at..].lines().next().unwrap_or_default();
        let declared = line.trim_start();
        let declared = match declared.split_once(' ') {
            Some((visibility, declared)) if visibility.starts_with("pub") => declared,
            _ => declared,
        };
        if let Some(tree) = declared.strip_prefix("use ") {
            let start = at + line.len() - tree.len();
            let end = start + code[start..].find(';').expect("a use ends");
            trees.push(&code[start..end]);
            at = end + 1;
        } else {
            rest.push_str(line);
            rest.push('\n');
            at += line.len() + 1;
        }
    }
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
    /// All files in `src` except the binary's.
    pub fn read() -> Self {
        let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
        let mut files = BTreeMap::new();
        for path in files_under(&src) {
            let inner = path.strip_prefix(&src).expect("under it");
            if inner == Path::new("main.rs") {
                continue;
            }
            let inner = inner.with_extension("");
            let inner = inner.iter().map(|word| word.to_str().expect("text"));
            let inner = inner.filter(|word| !["mod", "lib"].contains(word));
            let module = ["crate"].into_iter().chain(inner);
            files.insert(module.map(str::to_owned).collect(), path.clone());
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
                let to = modules.absolute(&module, &leaf);
                let name = to.last().expect("a word").clone();
                modules.names.insert((module.clone(), name), to);
            }
        }
        modules
    }

    /// The file that a path leads to; `None` outside the crate.
    fn file_of(&self, path: &[String]) -> Option<Words> {
        if path.first().is_none_or(|first| first != "crate") {
            return None;
        }
        let mut at: Words = path[..1].to_vec();
        for word in &path[1..] {
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

    /// The path from `crate` for a path as a file writes it. A bare path starts at the file's own module if it has a
    /// module of that name; otherwise it leads to another crate and stays as it is.
    fn absolute(&self, module: &Words, path: &str) -> Words {
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
            first => {
                from.push(first.to_owned());
                if !self.files.contains_key(&from) {
                    return rest;
                }
                from.pop();
            }
        }
        from.extend(rest);
        from
    }

    /// The files that a file names.
    fn named_by(&self, module: &Words, path: &Path) -> BTreeSet<Words> {
        let code = untested(&code(path));
        let (trees, rest) = uses(&code);
        let mut paths: Vec<Words> = Vec::new();
        for leaf in trees.into_iter().flat_map(leaves) {
            let full = self.absolute(module, &leaf);
            // For an imported module, what the file names through it.
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
            paths.extend(found.iter().map(|path| self.absolute(module, path)));
        }
        let files = paths.iter().filter_map(|path| self.file_of(path));
        let files = files.filter(|file| file != module && !is_facade(&self.files[file]));
        files.collect()
    }

    /// Every file that is no facade, with those that it names.
    pub fn edges(&self) -> BTreeMap<Words, BTreeSet<Words>> {
        let files = self.files.iter().filter(|(_, path)| !is_facade(path));
        let named =
            |(module, path): (&Words, &PathBuf)| (module.clone(), self.named_by(module, path));
        files.map(named).collect()
    }
}

pub(super) fn is_facade(path: &Path) -> bool {
    path.file_name()
        .is_some_and(|name| name == "mod.rs" || name == "lib.rs")
}

/// The code before the file's own tests.
fn untested(code: &str) -> String {
    let tests = code.find("#[cfg(test)]\nmod tests {");
    code[..tests.unwrap_or(code.len())].to_owned()
}
