//! Saving: what the scene file says of its meshes.

use super::*;
use std::fs;

#[test]
fn a_mesh_beside_the_scene_is_named_by_its_name_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    let [models, sub, link] = ["models", "sub", "link"].map(|name| folder.path().join(name));
    for new in [&models, &sub] {
        fs::create_dir(new).expect("writable");
    }
    fs::write(
        models.join("tri.obj"),
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    )
    .expect("writable");
    let mut ways = vec![sub.join("../models/tri.obj")];
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(&models, &link).expect("a link");
        ways.push(link.join("tri.obj"));
    }
    for opened in ways {
        let mut window = open(vec![opened.clone()], 1.0);
        let kept = models.join("kept.toml");
        window.save_as(kept.clone());
        let text = fs::read_to_string(&kept).expect("a file");
        assert!(text.contains("file = \"tri.obj\""), "{opened:?}: {text}");
        let kept = open(vec![kept], 1.0);
        assert_eq!(kept.state().scene().triangle_count(), 1);
    }
    // What lies elsewhere is named in full.
    let mut window = open(vec![models.join("tri.obj")], 1.0);
    let kept = sub.join("kept.toml");
    window.save_as(kept.clone());
    let text = fs::read_to_string(&kept).expect("a file");
    assert!(
        text.contains("models/tri.obj") && !text.contains(".."),
        "{text}"
    );
}
