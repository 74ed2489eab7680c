//! An OBJ file and the MTL file it may name, parted by a byte 1. Either an error names the file, or what loads has
//! finite bounds and can be picked.

#![no_main]

use glam::DVec3;
use libfuzzer_sys::fuzz_target;
use sightline::{
    geometry::{Ray, Sides},
    pick,
    scene::{Progress, load},
};
use std::{fs, path::PathBuf, sync::LazyLock};

static FOLDER: LazyLock<PathBuf> = LazyLock::new(|| {
    let folder = std::env::temp_dir().join(format!("sightline-fuzz-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    folder
});

fuzz_target!(|bytes: &[u8]| {
    let mut parts = bytes.splitn(2, |&b| b == 1);
    for name in ["a.obj", "a.mtl"] {
        let (file, bytes) = (FOLDER.join(name), parts.next());
        // A run depends on its own bytes alone: no file of an earlier run is left.
        match bytes {
            Some(bytes) => fs::write(&file, bytes).expect("a file"),
            None if file.exists() => fs::remove_file(&file).expect("no file"),
            None => {}
        }
        assert_eq!(fs::read(&file).ok().as_deref(), bytes, "{name}");
    }
    let loaded = match load(&[FOLDER.join("a.obj")], &Progress::default()) {
        Ok(loaded) => loaded,
        Err(error) => {
            assert!(error.to_string().contains("a.obj"));
            return;
        }
    };
    // At most one warning of each kind, and one for each material file.
    assert!(loaded.warnings.len() < 20);
    let scene = loaded.scene;
    assert!(scene.triangle_count() > 0);
    let bounds = scene.bounds();
    assert!(!bounds.is_empty() && bounds.min.is_finite() && bounds.max.is_finite());
    scene.build_trees();
    let toward = DVec3::new(0.3, 1.0, 0.2);
    let ray = Ray {
        origin: bounds.center() + toward * bounds.radius(),
        direction: -toward,
        t_min: 0.0,
        t_max: f64::INFINITY,
    };
    if let Some(hit) = pick::closest(&scene, &ray, Sides::Both) {
        assert!(hit.hit.t.is_finite() && hit.hit.normal.is_finite());
    }
});
