//! Imports among the window's files: rooms name only rooms above them.

use super::{
    code, files_under,
    graph::{Modules, Words, is_facade},
};
use std::{
    path::{Path, PathBuf},
    slice,
};

/// The rooms, each of which names only those before it; `options` is a file beside them.
const ROOMS: [&str; 7] = ["model", "options", "jobs", "screen", "ui", "app", "host"];

/// What the files of a room must not name.
const KEPT_OUT: [(&str, &[&str]); 3] = [
    (
        "model",
        &["egui", "winit", "wgpu", "rfd", "std::thread", "mpsc"],
    ),
    ("jobs", &["egui", "winit", "wgpu"]),
    ("ui", &["winit", "wgpu"]),
];

fn is_of_viewer(module: &Words) -> bool {
    module.get(1).is_some_and(|name| name == "viewer")
}

fn room(module: &Words) -> usize {
    let room = ROOMS.iter().position(|room| *room == module[2]);
    room.unwrap_or_else(|| panic!("{} is no room", module.join("::")))
}

#[test]
fn rooms_of_the_viewer_name_only_those_above_them() {
    let edges = Modules::read().edges();
    let mut seen = 0;
    for (from, named) in edges.iter().filter(|(from, _)| is_of_viewer(from)) {
        for to in named.iter().filter(|to| is_of_viewer(to)) {
            let (from_room, to_room) = (room(from), room(to));
            assert!(from_room >= to_room, "{from:?} names {to:?}");
            seen += usize::from(from_room > to_room);
        }
    }
    assert!(seen > 80, "{seen}: the search finds imports");
}

#[test]
fn facades_of_the_viewer_hold_nothing_of_their_own() {
    let mut seen = 0;
    let files = Modules::read().files;
    let of_viewer = files.iter().filter(|(module, _)| is_of_viewer(module));
    for path in of_viewer
        .map(|(_, path)| path)
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
        1 + ROOMS.len() - 1 + 2,
        "the viewer, its rooms, the panels, the inspector"
    );
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

/// One file orders the steps of a frame, for windows and for pictures of them. Hosts ask it for a whole frame, or for a
/// pass without a picture and for a picture of a pass; to prepare what later frames need, or for the results of jobs. Who
/// runs egui asks it for the panels. They ask for no step in between.
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
    assert_eq!(
        offered,
        [
            "frame",
            "pass",
            "draw_frame",
            "prepare",
            "take_finished",
            "ui"
        ]
    );
}

/// Where files of the panels and of the screen name all objects or all batches: the list and its filter, which goes
/// through them once for each text, and the overlays of a scene in which nothing is selected, which stop at their most
/// lines.
const OF_ALL_OBJECTS: [(&str, &str); 4] = [
    ("objects.rs", "letobjects=state.scene().objects().iter()"),
    ("objects.rs", "letobjects=state.scene().objects();"),
    (
        "overlay_lines.rs",
        "selected.map_or(0..scene.objects().len(),",
    ),
    ("overlay_lines.rs", "None=>scene.batches(),"),
];

/// Panels are laid out in each pass, and what stands over the scene is made for each picture, so they go through no
/// list of all objects.
#[test]
fn panels_and_pictures_go_through_no_list_of_all_objects() {
    let (mut seen, mut named) = (0, 0);
    for path in ["ui/panels", "screen"].into_iter().flat_map(files_of) {
        let mut code: String = code(&path).split_whitespace().collect();
        for (_, words) in OF_ALL_OBJECTS
            .iter()
            .filter(|(file, _)| path.ends_with(file))
        {
            named += code.matches(words).count();
            code = code.replace(words, "");
        }
        for list in [".objects()", ".batches()"] {
            let whole = code.split(list).skip(1).find(|after| {
                let of_one = ["[", ".get(", ".len()", ".is_empty()"];
                !of_one.iter().any(|part| after.starts_with(part))
            });
            assert_eq!(whole, None, "{}", path.display());
        }
        seen += 1;
    }
    assert!(seen > 50, "{seen}");
    assert_eq!(named, OF_ALL_OBJECTS.len(), "each exception is one place");
}
