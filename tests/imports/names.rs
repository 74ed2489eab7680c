//! Files of one name are about one subject.

use super::graph::{Modules, is_facade};
use std::{collections::BTreeMap, path::Path};

/// What several files are about, each in its own way: their folders say which. Within `viewer` each name is one file's.
const SHARED: [(&str, &[&str]); 14] = [
    ("again", &["scene/files/obj", "scene/files/obj/tests"]),
    (
        "in_file",
        &["scene", "scene/files/obj", "viewer/ui/panels/inspector"],
    ),
    ("narrowed", &["scene", "pick"]),
    ("one_place", &["pick", "verify"]),
    ("random", &["geometry", "study"]),
    ("record", &["pick", "pick/snap"]),
    (
        "section",
        &[
            "geometry",
            "geometry/exact",
            "scene",
            "render",
            "verify",
            "viewer/ui/panels/inspector",
        ],
    ),
    ("sphere", &["geometry", "render", "verify"]),
    ("study", &["cli", "viewer/jobs"]),
    (
        "tests",
        &[
            "geometry/exact/triangle",
            "geometry/interval",
            "geometry/local_ray",
            "geometry/triangle",
            "scene/files/obj",
            "verify",
            "viewer/ui/panels",
        ],
    ),
    ("triangle", &["geometry", "geometry/exact"]),
    ("truth", &["study", "study/methods/picks"]),
    ("window", &["cli", "viewer/host"]),
    (
        "workloads",
        &["study/methods/rays", "study/methods/triangles"],
    ),
];

#[test]
fn files_of_one_name_are_about_one_subject() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut folders: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for (module, path) in Modules::read().files {
        if !is_facade(&path) {
            let folder = path.strip_prefix(&src).expect("under it").parent();
            let folder = folder.expect("a folder").to_str().expect("text");
            let name = module.last().expect("a name").clone();
            folders.entry(name).or_default().push(folder.to_owned());
        }
    }
    assert!(folders.len() > 300, "{}", folders.len());
    folders.retain(|_, folders| folders.len() > 1);
    for folders in folders.values_mut() {
        folders.sort();
    }
    let shared = SHARED.map(|(name, folders)| {
        let mut folders: Vec<_> = folders.iter().map(|&folder| folder.to_owned()).collect();
        folders.sort();
        (name.to_owned(), folders)
    });
    assert_eq!(folders, BTreeMap::from(shared));
}
