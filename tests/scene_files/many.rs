//! Files of very many objects, and very many files, load, list, pick and save in time that grows as they do.

use super::{scene, write};
use sightline::{
    camera::CameraChoice,
    scene::{Detail, FilesAgain, Progress, Shape},
};
use std::{collections::HashSet, fmt::Write, sync::Arc};

#[test]
fn each_of_six_hundred_thousand_groups_is_an_object() {
    const GROUPS: usize = 600_000;
    let folder = tempfile::tempdir().unwrap();
    let mut text = String::from("v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    for i in 0..GROUPS {
        writeln!(text, "g group{i}\nf 1 2 3").unwrap();
    }
    let path = write(&folder, "groups.obj", &text);
    let progress = Progress::default();
    let loaded = scene::load_with(&[path], &progress, Detail::Picked).unwrap();
    let objects = loaded.scene.objects();
    assert_eq!(objects.len(), GROUPS);
    let mut again = FilesAgain::new(&loaded.scene, &loaded.meshes, &progress);
    for i in [0, GROUPS / 2, GROUPS - 1] {
        assert_eq!(objects[i].name, format!("group{i}"));
        assert_eq!(objects[i].shape.triangles().unwrap().len(), 1);
        assert_eq!(again.in_file(i, Some(0)).line, Some(2 * i + 5));
    }
}

#[test]
fn each_of_thousands_of_mesh_files_is_read_once_and_found_again() {
    const FILES: usize = 2_000;
    const OBJECTS: usize = 20 * FILES;
    let folder = tempfile::tempdir().unwrap();
    for i in 0..FILES {
        let text = format!("v 0 0 {i}\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        write(&folder, &format!("mesh{i}.obj"), &text);
    }
    let mut text = String::new();
    for i in 0..OBJECTS {
        let file = i % FILES;
        writeln!(
            text,
            "[[object]]\nshape = \"mesh\"\nfile = \"mesh{file}.obj\""
        )
        .unwrap();
    }
    let path = write(&folder, "many.toml", &text);
    let progress = Progress::default();
    let loaded = scene::load(&[path], &progress).unwrap();
    let mut again = FilesAgain::new(&loaded.scene, &loaded.meshes, &progress);
    let mut meshes = HashSet::new();
    for (i, object) in loaded.scene.objects().iter().enumerate() {
        let Shape::Mesh { mesh, .. } = &object.shape else {
            panic!("a mesh");
        };
        meshes.insert(Arc::as_ptr(mesh));
        assert!(again.of(mesh).is_some());
        let z = mesh.corners(0)[0].z;
        assert_eq!(z.to_string(), (i % FILES).to_string());
    }
    let counts = [
        loaded.scene.objects().len(),
        meshes.len(),
        loaded.meshes.len(),
    ];
    assert_eq!(counts, [OBJECTS, FILES, FILES]);
    let saved = folder.path().join("saved.toml");
    let files = scene::save(
        &saved,
        &loaded.scene,
        &CameraChoice::default(),
        &loaded.meshes,
    );
    assert_eq!(files.unwrap().len(), FILES);
    let read = scene::load(&[saved], &progress).unwrap();
    assert_eq!(read.scene.objects().len(), OBJECTS);
}
