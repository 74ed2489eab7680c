//! An MTL file that a good OBJ file names: whatever is in it, the mesh loads, and a few warnings of one line each say
//! what is wrong.

#![no_main]

use libfuzzer_sys::fuzz_target;
use sightline::scene::{Progress, load};
use std::{fs, path::PathBuf, sync::LazyLock};

const OBJ: &str =
    "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b c\nf 3 2 1\n";

static FOLDER: LazyLock<PathBuf> = LazyLock::new(|| {
    let folder = std::env::temp_dir().join(format!("sightline-fuzz-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    fs::write(folder.join("a.obj"), OBJ).expect("a file");
    folder
});

fuzz_target!(|bytes: &[u8]| {
    fs::write(FOLDER.join("a.mtl"), bytes).expect("a file");
    let loaded = load(&[FOLDER.join("a.obj")], &Progress::default());
    let loaded = loaded.expect("a mesh loads without its materials");
    assert_eq!(loaded.scene.triangle_count(), 2);
    // At most one warning of each kind.
    assert!(loaded.warnings.len() < 20);
    for warning in &loaded.warnings {
        assert_eq!(warning.to_string().lines().count(), 1, "{warning}");
    }
});
