//! A scene file is refused in one line, or what loads has bounds and reads back the same once it is saved.

#![no_main]

use libfuzzer_sys::fuzz_target;
use sightline::scene::{LoadError, Loaded, Progress, description::to_toml, load};
use std::{fs, path::PathBuf, sync::LazyLock};

/// A folder with a mesh file of two objects, `a.obj`, beside the scene file.
static FOLDER: LazyLock<PathBuf> = LazyLock::new(|| {
    let folder = std::env::temp_dir().join(format!("sightline-fuzz-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    let mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\no one\nf 1 2 3\no two\nf 3 2 1\n";
    fs::write(folder.join("a.obj"), mesh).expect("a file");
    folder
});

fn parse(text: &str) -> Result<Loaded, LoadError> {
    let file = FOLDER.join("a.toml");
    fs::write(&file, text).expect("a file");
    load(&[file], &Progress::default())
}

fn save(loaded: &Loaded) -> String {
    to_toml(&loaded.scene, &loaded.camera, &loaded.meshes).expect("what was loaded can be saved")
}

fuzz_target!(|text: &str| {
    let loaded = match parse(text) {
        Ok(loaded) => loaded,
        Err(error) => {
            assert_eq!(error.to_string().lines().count(), 1, "{error}");
            return;
        }
    };
    let bounds = loaded.scene.bounds();
    assert!(!bounds.min.is_nan() && !bounds.max.is_nan());
    let saved = save(&loaded);
    let again = parse(&saved).expect("what was saved reads back");
    assert_eq!(saved, save(&again));
});
