//! Opens the file after the one on show in its folder.

use super::program::App;
use crate::{
    scene::{absolute, is_scene_file},
    viewer::ui::{Attempt, Intent},
};
use std::{
    fs::{self, File},
    io::{self, Read},
    path::{Path, PathBuf},
};

/// As much of a `.toml` is read to see whether it is a scene file.
const HEAD_BYTES: u64 = 1 << 16;

impl App {
    /// Opens the file after the one on show in its folder, or before it; in the gallery, its next scene. A file that
    /// could not be opened counts as on show: the next one follows it.
    pub(super) fn open_next_file(&mut self, forward: bool) {
        if self.state.is_in_gallery() {
            return self.open_next_exhibit(forward);
        }
        let shown = self.state.source().paths.first();
        let Some(from) = self.not_opened.as_ref().or(shown) else {
            return self.say("no file is open: Ctrl+O opens one".into());
        };
        match next_file(from, forward) {
            Ok(Some(next)) => self.intend(Intent::Open(vec![next])),
            Ok(None) => self.say("its folder has no other OBJ or scene file".into()),
            Err(error) => {
                let text = format!("the folder of {} cannot be read: {error}", from.display());
                self.failed(Attempt::Open, text);
            }
        }
    }
}

/// The file after this one in its folder, or the one before it, of those that can be opened: OBJ files, and scene files
/// that list an object. They stand in the order of their names, numbers in them by value, and the last is followed by
/// the first. The file itself may be gone. `None` where there is no other.
///
/// # Errors
/// When the folder cannot be read.
fn next_file(file: &Path, forward: bool) -> io::Result<Option<PathBuf>> {
    let file = absolute(file);
    let Some(folder) = file.parent() else {
        return Ok(None);
    };
    let entries = fs::read_dir(folder)?.map(|entry| Ok(entry?.path()));
    let mut others = entries.collect::<io::Result<Vec<_>>>()?;
    others.retain(|path| *path != file && can_be_opened(path));
    let order = |a: &Path, b: &Path| alphanumeric_sort::compare_path(a, b).then(a.cmp(b));
    others.sort_by(|a, b| order(a, b));
    let after = others.partition_point(|path| order(path, &file).is_lt());
    let count = others.len();
    let at = if forward { after } else { after + count - 1 };
    Ok((count > 0).then(|| others.swap_remove(at % count)))
}

fn can_be_opened(path: &Path) -> bool {
    let ends_as_obj = || (path.extension()).is_some_and(|end| end.eq_ignore_ascii_case("obj"));
    path.is_file() && (ends_as_obj() || (is_scene_file(path) && lists_an_object(path)))
}

/// Other programs have files that end in `.toml`, too.
fn lists_an_object(path: &Path) -> bool {
    let mut head = Vec::new();
    let read = File::open(path).and_then(|file| file.take(HEAD_BYTES).read_to_end(&mut head));
    let text = String::from_utf8_lossy(&head);
    read.is_ok()
        && text
            .lines()
            .any(|line| line.trim_start().starts_with("[[object]]"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_follow_each_other_by_name_round_about() {
        let folder = tempfile::tempdir().expect("a folder");
        let at = |name: &str| folder.path().join(name);
        let object = "# a scene\n[[object]]\nshape = \"cube\"\n";
        for (name, text) in [
            ("part10.obj", ""),
            ("part9.OBJ", ""),
            ("part11.toml", object),
            ("Cargo.toml", "[package]\n"),
            ("part9.mtl", ""),
            ("notes.txt", object),
        ] {
            fs::write(at(name), text).expect("a file");
        }
        fs::create_dir(at("part12.obj")).expect("a folder");
        let next = |name: &str, forward| {
            let next = next_file(&at(name), forward).expect("a folder");
            next.map(|path| {
                path.file_name()
                    .expect("a name")
                    .to_string_lossy()
                    .into_owned()
            })
        };
        let round = ["part9.OBJ", "part10.obj", "part11.toml", "part9.OBJ"];
        for pair in round.windows(2) {
            assert_eq!(next(pair[0], true).as_deref(), Some(pair[1]));
            assert_eq!(next(pair[1], false).as_deref(), Some(pair[0]));
        }
        // One that is gone keeps its place.
        assert_eq!(next("part9b.obj", true).as_deref(), Some("part10.obj"));
        for name in ["part10.obj", "part11.toml"] {
            fs::remove_file(at(name)).expect("it is there");
        }
        assert_eq!(next("part9.OBJ", true), None);
        assert!(next_file(&at("none/part1.obj"), true).is_err());
    }
}
