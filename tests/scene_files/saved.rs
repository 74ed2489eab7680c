//! A saved scene reads back the same.

use crate::{
    common::{Random, mesh, placements},
    load, parse, write,
};
use glam::{DAffine3, DMat3, DVec3, dvec3};
use sightline::{
    camera::{CameraChoice, DepthMapping, SectionChoice, UpAxis},
    colour::Srgb,
    geometry::{Placement, Section},
    scene::{Loaded, MeshFile, Object, Scene, Shape, description::to_toml},
};
use std::path::PathBuf;

/// Fails unless two scenes of primitives are the same to the bit.
#[track_caller]
fn same(a: &[Object], b: &[Object]) {
    assert_eq!(a.len(), b.len());
    for (a, b) in a.iter().zip(b) {
        assert_eq!(
            (&a.name, a.shape.kind(), a.colour, a.visible),
            (&b.name, b.shape.kind(), b.colour, b.visible)
        );
        let bits = |object: &Object| object.placement.model().to_cols_array().map(f64::to_bits);
        assert_eq!(
            bits(a),
            bits(b),
            "{:?} and {:?}",
            a.placement.model(),
            b.placement.model()
        );
    }
}

#[test]
fn what_is_saved_reads_back_to_the_bit() {
    let mut random = Random::new(50);
    let shapes = [Shape::Sphere, Shape::Cube, Shape::Square];
    let mut models: Vec<_> = placements().into_iter().map(|(_, model)| model).collect();
    for _ in 0..200 {
        let size = 10_f64.powf(random.within(-20.0, 20.0));
        models.push(DAffine3 {
            matrix3: DMat3::from_cols(random.point(size), random.point(size), random.point(size)),
            translation: random.point(1e10),
        });
        models.push(DAffine3::from_scale(random.point(size)));
    }
    // Zeros of both signs are different bits.
    models.push(DAffine3 {
        translation: dvec3(-0.0, 1.0, 0.0),
        ..DAffine3::IDENTITY
    });
    models.push(DAffine3::from_cols_array(&[
        1.0, -0.0, 0.0, 0.0, -1.0, 0.0, -0.0, 0.0, 1.0, 0.0, 0.0, -0.0,
    ]));
    let names = [
        "plain",
        "",
        "quote \" and \\",
        "two\nlines",
        "# [[object]]",
        "Ünïcode ☃",
        "\u{7}",
    ];
    let objects = models.into_iter().enumerate().map(|(i, model)| {
        let mut object = Object::new(
            names[i % names.len()],
            shapes[i % 3].clone(),
            Placement::new(model).unwrap(),
        );
        object.visible = i % 4 != 0;
        object.colour = (i % 5 != 0).then_some(Srgb([u8::try_from(i % 256).unwrap(), 0, 255]));
        object
    });
    let scene = Scene::new(objects.collect());
    let section = Section::new(dvec3(0.1, -0.0, 1e-33), -1.0 / 3.0).unwrap();
    let camera = CameraChoice {
        eye: Some(dvec3(0.1, 1.0 / 3.0, -1e-17)),
        look: Some(dvec3(-0.0, 1e-33, 1e33)),
        up: Some(DVec3::Z),
        ortho: Some(2.0_f64.sqrt()),
        near: Some(-1e-7),
        far: Some(1e9),
        depth: Some(DepthMapping::Reversed),
        up_axis: Some(UpAxis::Y),
        section: Some(SectionChoice::Plane(section)),
        ..CameraChoice::default()
    };
    for camera in [camera, CameraChoice::default()] {
        let text = to_toml(&scene, &camera, &[]).unwrap();
        let again = parse(&text).expect("what was written can be read");
        same(&scene.objects().to_vec(), &again.objects);
        assert_eq!(again.camera.unwrap_or_default(), camera);
        // The text leaves out a camera that chooses nothing.
        assert_eq!(text.contains("[camera]"), camera != CameraChoice::default());
    }
    let placed = Scene::new(vec![Object::new(
        "Ball",
        Shape::Sphere,
        Placement::new(DAffine3::from_translation(dvec3(1.0, 2.0, 3.0))).unwrap(),
    )]);
    let text = to_toml(&placed, &CameraChoice::default(), &[]).unwrap();
    assert_eq!(
        text,
        "[[object]]\nname = \"Ball\"\nshape = \"sphere\"\nposition = [1.0, 2.0, 3.0]\n"
    );
}

#[test]
fn a_mesh_is_saved_as_its_files_part() {
    let mesh = mesh(vec![[0.0; 3]; 3], vec![[0, 1, 2]], DVec3::ZERO);
    let shape = Shape::Mesh {
        mesh: mesh.clone(),
        part: 0,
    };
    let scene = Scene::new(vec![Object::new("Bunny", shape, Placement::IDENTITY)]);
    let camera = CameraChoice::default();
    let text = to_toml(
        &scene,
        &camera,
        &[MeshFile {
            path: PathBuf::from("/meshes/bunny.obj"),
            mesh,
            contents: None,
        }],
    )
    .unwrap();
    assert_eq!(
        text,
        "[[object]]\nname = \"Bunny\"\nshape = \"mesh\"\nfile = \"/meshes/bunny.obj\"\npart = 1\n"
    );
    let error = to_toml(&scene, &camera, &[]).unwrap_err().to_string();
    assert!(error.contains("Bunny"), "{error}");
}

#[test]
fn mesh_files_bring_their_objects_once_and_are_saved_by_part() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| write(&folder, name, text);
    write("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let two = "v 0 0 0\nv 1 0 0\nv 0 1 0\no Roof\nf 1 2 3\no Wall\nf 3 2 1\nf 1 3 2\n";
    write("two.obj", two);
    let entry = |rest: &str| format!("[[object]]\nshape = \"mesh\"\n{rest}\n");
    let text = [
        entry("file = \"two.obj\""),
        entry("file = \"two.obj\"\nname = \"House\"\nposition = [5, 0, 0]"),
        entry("file = \"two.obj\"\npart = 2\nname = \"Fence\"\ncolour = \"#102030\""),
        entry("file = \"one.obj\"\nname = \"Sail\"\nscale = [1, -1, 1]\nvisible = false"),
    ];
    let loaded = load(&[write("scene.toml", &text.concat())]).unwrap();
    let objects = loaded.scene.objects();
    let names: Vec<_> = objects.iter().map(|object| object.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "Roof",
            "Wall",
            "House: Roof",
            "House: Wall",
            "Fence",
            "Sail"
        ]
    );
    let triangles: Vec<_> = objects
        .iter()
        .map(|object| object.shape.triangles().unwrap())
        .collect();
    assert_eq!(triangles, [0..1, 1..3, 0..1, 1..3, 1..3, 0..1]);
    assert_eq!(objects[4].colour, Some(Srgb([16, 32, 48])));
    assert_eq!(loaded.meshes.len(), 2, "each file once");
    // Parts of one mesh at one placement make one batch.
    assert_eq!(loaded.scene.batches(), [0..2, 2..4, 4..5, 5..6]);

    // The saved scene names its meshes by absolute paths, so it loads from any folder.
    let elsewhere = tempfile::tempdir().unwrap();
    let saved = to_toml(&loaded.scene, &loaded.camera, &loaded.meshes).unwrap();
    let path = elsewhere.path().join("saved.toml");
    std::fs::write(&path, &saved).unwrap();
    let again = load(&[path]).unwrap();
    same(&objects.to_vec(), &again.scene.objects().to_vec());
    let parts = |loaded: &Loaded| {
        let shapes = loaded
            .scene
            .objects()
            .iter()
            .map(|object| object.shape.triangles());
        shapes.collect::<Vec<_>>()
    };
    assert_eq!(parts(&loaded), parts(&again));
    assert_eq!(
        to_toml(&again.scene, &again.camera, &again.meshes).unwrap(),
        saved
    );

    let missing = write("part.toml", &entry("file = \"two.obj\"\npart = 3"));
    let error = load(&[missing]).unwrap_err();
    assert!(
        error.contains("part.toml:1:") && error.contains("2 objects"),
        "{error}"
    );
    let zero = write("zero.toml", &entry("file = \"two.obj\"\npart = 0"));
    assert!(load(&[zero]).unwrap_err().contains("count from 1"));
    // An OBJ file's objects are added to those of the scene file before it.
    let both = load(&[
        folder.path().join("scene.toml"),
        folder.path().join("one.obj"),
    ])
    .unwrap();
    assert_eq!(both.scene.objects().len(), 7);
    assert_eq!(both.meshes.len(), 2, "also when both name it");
}
