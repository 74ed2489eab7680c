//! A scene saved with its meshes still loads after its folder is moved. A mesh whose file is gone is written beside the
//! scene.

use crate::{load, write};
use glam::DVec3;
use sightline::{
    camera::CameraChoice,
    colour::Srgb,
    geometry::{ColourRun, Mesh, MeshData, Part, Placement, crease_normals},
    scene::{Loaded, MeshFile, Object, Scene, Shape, save},
};
use std::{path::Path, sync::Arc};

const CORNERS: &str = "v 0.1 0 0\nv 1 0 0.3\nv 0 1 0\n";

/// Everything about a scene that is drawn and picked.
fn facts(loaded: &Scene) -> Vec<String> {
    let objects = loaded.objects().iter();
    let fact = |object: &Object| {
        let Shape::Mesh { mesh, .. } = &object.shape else {
            return format!("{object:?}");
        };
        let triangle = |triangle: u32| {
            let bits = |corner: DVec3| corner.to_array().map(f64::to_bits);
            let corners = mesh.corners(triangle).map(bits);
            let data = mesh.data();
            let own = data.triangles[triangle as usize].map(|corner| {
                let corner = corner as usize;
                let colour = data.vertex_colours.get(corner).copied();
                (data.positions[corner].map(f32::to_bits), colour)
            });
            format!("{corners:?} {own:?} {:?}", mesh.triangle_colour(triangle))
        };
        let triangles = object.shape.triangles().expect("a mesh");
        let triangles: Vec<_> = triangles.map(triangle).collect();
        let at = object.placement.model();
        format!("{} {:?} {at:?} {triangles:?}", object.name, object.colour)
    };
    objects.map(fact).collect()
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).expect("a folder");
    let name = |entry: std::io::Result<std::fs::DirEntry>| {
        entry
            .expect("an entry")
            .file_name()
            .to_string_lossy()
            .into_owned()
    };
    let mut names: Vec<_> = entries.map(name).collect();
    names.sort();
    names
}

fn saved(loaded: &Loaded, path: &Path) -> Vec<MeshFile> {
    let saved = save(path, &loaded.scene, &loaded.camera, &loaded.meshes);
    saved.unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn meshes_beside_or_below_move_with_the_scene() {
    let folder = tempfile::tempdir().unwrap();
    let elsewhere = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("parts")).unwrap();
    let beside = write(&folder, "one.obj", &format!("{CORNERS}f 1 2 3\n"));
    let below = write(&folder, "parts/two.obj", &format!("{CORNERS}f 3 2 1\n"));
    let away = write(&elsewhere, "three.obj", &format!("{CORNERS}f 2 3 1\n"));
    let loaded = load(&[beside, below, away.clone()]).unwrap();
    let path = folder.path().join("scene.toml");
    let files = saved(&loaded, &path);
    assert_eq!(files.len(), 3);
    let text = std::fs::read_to_string(&path).unwrap();
    for file in ["one.obj", "parts/two.obj", away.to_str().unwrap()] {
        assert!(
            text.contains(&format!("file = \"{file}\"")),
            "{file} in {text}"
        );
    }
    let moved = elsewhere.path().join("moved");
    std::fs::rename(folder.path(), &moved).unwrap();
    let again = load(&[moved.join("scene.toml")]).unwrap();
    assert_eq!(facts(&again.scene), facts(&loaded.scene));
}

#[test]
fn a_mesh_whose_file_is_gone_is_written_beside() {
    let folder = tempfile::tempdir().unwrap();
    let coloured = "mtllib c.mtl\nv 1000000.25 0 0 1 0 0\nv 1000001 0 0.1 0 1 0\nv 1000000 1 0 0.2 0.4 0.6\n\
        v 1000000 0 7 1 1 1\no Roof\nf 1 2 3\nusemtl red\nf 2 3 4\no Wall\nusemtl none\nf 1 2 4\nusemtl red\nf 1 3 4\n";
    let obj = write(&folder, "gone.obj", coloured);
    let mtl = write(
        &folder,
        "c.mtl",
        "newmtl red\nKd 0.8 0.1 0.1\nnewmtl none\n",
    );
    let loaded = load(std::slice::from_ref(&obj)).unwrap();
    let data = loaded.meshes[0].mesh.data();
    assert!(
        data.origin != DVec3::ZERO && data.colours.len() == 4 && !data.vertex_colours.is_empty()
    );
    std::fs::remove_file(obj).unwrap();
    std::fs::remove_file(mtl).unwrap();
    // A name in use is not taken.
    write(&folder, "scene-gone.obj", "his");
    let path = folder.path().join("scene.toml");
    for _ in 0..2 {
        let files = saved(&loaded, &path);
        assert_eq!(files[0].path, folder.path().join("scene-gone-2.obj"));
    }
    let all = [
        "scene-gone-2.mtl",
        "scene-gone-2.obj",
        "scene-gone.obj",
        "scene.toml",
    ];
    assert_eq!(
        names(folder.path()),
        all,
        "what is the same is not written again"
    );
    assert_eq!(
        std::fs::read(folder.path().join("scene-gone.obj")).unwrap(),
        b"his"
    );
    let again = load(&[path]).unwrap();
    assert_eq!(again.warnings.len(), 0, "{:?}", again.warnings);
    assert_eq!(facts(&again.scene), facts(&loaded.scene));
    // Materials keep their names. What had none got one.
    let of = |loaded: &Loaded| {
        let mesh = Arc::clone(&loaded.meshes[0].mesh);
        (0..4)
            .map(|i| mesh.triangle_material(i).map(str::to_owned))
            .collect::<Vec<_>>()
    };
    let [before, after] = [of(&loaded), of(&again)];
    let name = |name: &str| Some(name.to_owned());
    assert_eq!(before, [None, name("red"), name("none"), name("red")]);
    assert_eq!(
        after,
        [name("none_"), name("red"), name("none"), name("red")]
    );
}

/// What cannot be the mesh's file is not read: reading a pipe would wait for a writer.
#[cfg(unix)]
#[test]
fn a_pipe_under_the_name_of_a_mesh_file_is_passed_over() {
    let folder = tempfile::tempdir().expect("a folder");
    let obj = write(&folder, "corner.obj", &format!("{CORNERS}f 1 2 3\n"));
    let loaded = load(std::slice::from_ref(&obj)).expect("it loads");
    std::fs::remove_file(&obj).expect("a file");
    let made = std::process::Command::new("mkfifo")
        .arg(folder.path().join("scene-corner.obj"))
        .status();
    assert!(made.expect("mkfifo").success());
    // Of another size, and of the same size with other bytes.
    let text = std::fs::read_to_string(
        saved(&loaded, &folder.path().join("scene.toml"))[0]
            .path
            .clone(),
    );
    let text = text.expect("a file");
    assert_eq!(
        names(folder.path()),
        ["scene-corner-2.obj", "scene-corner.obj", "scene.toml"]
    );
    write(&folder, "scene-corner-2.obj", &format!("{text}\n"));
    write(&folder, "scene-corner-3.obj", &"#".repeat(text.len()));
    write(&folder, "scene-corner-4.obj", &text);
    let files = saved(&loaded, &folder.path().join("scene.toml"));
    assert_eq!(files[0].path, folder.path().join("scene-corner-4.obj"));
}

#[test]
fn a_mesh_that_obj_cannot_hold_exactly_is_refused_and_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    // A triangle without area, which loading leaves out.
    let positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let triangles = vec![[0, 1, 2], [0, 1, 1]];
    let mesh = Mesh::new(MeshData {
        normals: crease_normals(&positions, &triangles, 0.5, &[]),
        positions,
        triangles,
        parts: vec![Part {
            name: "flat".into(),
            triangles: 0..2,
        }],
        colours: vec![ColourRun {
            triangles: 0..2,
            colour: Some(Srgb([1, 2, 3])),
            material: None,
        }],
        ..MeshData::default()
    });
    let shape = Shape::Mesh {
        mesh: Arc::new(mesh.unwrap()),
        part: 0,
    };
    let scene = Scene::new(vec![Object::new("flat", shape, Placement::IDENTITY)]);
    let path = write(&folder, "scene.toml", "old");
    let error = save(&path, &scene, &CameraChoice::default(), &[]).unwrap_err();
    assert!(error.to_string().contains("flat"), "{error}");
    assert_eq!(std::fs::read(&path).unwrap(), b"old");
    assert_eq!(names(folder.path()), ["scene.toml"]);
}

/// A save that fails half way leaves the old scene file unchanged to the byte, and nothing beside it. A limit on file
/// size makes the save fail, for root too. A shell sets the limit and runs this test again under it.
#[cfg(unix)]
#[test]
fn a_save_that_fails_half_way_leaves_the_old_scene_file() {
    use std::process::Command;
    const SCENE_FILE: &str = "SIGHTLINE_TEST_SCENE_FILE";
    if let Some(path) = std::env::var_os(SCENE_FILE) {
        let ball = Object::new("ball", Shape::Sphere, Placement::IDENTITY);
        // Its text is longer than 40 kB.
        let scene = Scene::new(vec![ball; 1000]);
        let saved = save(Path::new(&path), &scene, &CameraChoice::default(), &[]);
        assert!(saved.is_err(), "it is beyond the limit");
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let path = write(&folder, "scene.toml", "old");
    // `ulimit` counts blocks of 512 or 1024 bytes. `trap` ignores the signal, so the write fails and the process lives.
    let limited = "trap '' XFSZ; ulimit -f 8; exec \"$0\" \"$@\"";
    let output = Command::new("sh")
        .args(["-c", limited])
        .arg(std::env::current_exe().unwrap())
        .args([
            "--exact",
            "moved_folder::a_save_that_fails_half_way_leaves_the_old_scene_file",
        ])
        .env(SCENE_FILE, &path)
        .output()
        .expect("sh runs");
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(
        output.status.success() && said.contains("1 passed"),
        "{said}"
    );
    assert_eq!(std::fs::read(&path).unwrap(), b"old");
    assert_eq!(names(folder.path()), ["scene.toml"]);
}
