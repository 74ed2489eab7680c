//! `pick --stored`: the printed numbers are those of scene and view, and they alone give the same picks.

use super::{Folder, json};
use crate::exact::{
    line::Line,
    number::{Dyadic, plus, times, vector},
    truth::{Hit, World},
};
use crate::stored_line::{Camera, Stored, StoredMesh, StoredObject, StoredSection};
use clap::Parser;
use glam::{DAffine3, DMat3, DVec3};
use serde::Deserialize;
use serde_json::Value;
use sightline::{
    camera::View,
    cli::{Cli, Command},
    geometry::{ColourRun, Mesh, MeshData, Part, Placement, Sides},
    scene::{self, Object, Progress, Scene, Shape},
};
use std::sync::Arc;

/// A mesh of two parts far from its own origin, used twice, and each other shape; long numbers everywhere.
const SCENE: &str = r#"
[camera]
eye = [2.3, 1.9, 9.7]
target = [0.1, 0.05, 0]
fov = 41

[[object]]
name = "A \"ball\""
shape = "sphere"
scale = [1.3, 1.7, 0.9]
rotation = [10, 20, 30]
position = [-2.1, 0.3, 0]

[[object]]
shape = "cube"
matrix = [[1.1, 0.5, 0, 0.1], [-0.3, 1.3, 0, -0.2], [0.1, 0, 0.7, 0.4]]

[[object]]
name = "Meshes"
shape = "mesh"
file = "mesh.obj"
position = [-399998, 0.1, 0.2]

[[object]]
shape = "square"
rotation = [-60, 15, 0]
scale = 2.5
position = [0, -1.6, 0.1]

[[object]]
name = "Mirrored"
shape = "mesh"
file = "mesh.obj"
scale = [-1, 1, 1]
position = [400000, 1.9, 0]
"#;

const MESH: &str = "\
o left
v 399999.1 -0.7 0.3
v 400000.2 -0.6 0.7
v 399999.6 0.9 0.1
v 399999.7 0.1 -0.9
f 1 2 3
f 2 4 3
o right
v 400000.3 -0.4 0.7
v 401000.4 0.1 -0.9
f 5 6 3
";

fn folder() -> Folder {
    let folder = Folder::new();
    std::fs::write(folder.path("scene.toml"), SCENE).unwrap();
    std::fs::write(folder.path("mesh.obj"), MESH).unwrap();
    folder
}

/// A line of `--stored`.
fn stored(line: &Value) -> Stored {
    let object = line.as_object().expect("an object");
    assert_eq!(object.len(), 1, "nothing but \"stored\"");
    Stored::deserialize(&line["stored"]).expect("its numbers")
}

/// The scene and view that the program makes of the same arguments.
fn loaded(folder: &Folder, flags: &str) -> (Scene, View) {
    let scene = folder.path("scene.toml");
    let words = ["sightline", "pick", scene.to_str().unwrap(), "--at", "1,1"];
    let cli = Cli::try_parse_from(words.into_iter().chain(flags.split_whitespace())).unwrap();
    let Some(Command::Pick(args)) = cli.command else {
        panic!("not a pick");
    };
    let mut loaded = scene::load(&args.scene.scenes, &Progress::default()).unwrap();
    let view = args.view.apply(&mut loaded).unwrap();
    (loaded.scene, view)
}

fn bits(numbers: impl IntoIterator<Item = f64>) -> Vec<u64> {
    numbers.into_iter().map(f64::to_bits).collect()
}

fn same_camera(
    printed: &Camera,
    View {
        camera,
        viewport,
        sides,
        section,
    }: &View,
) {
    let vectors = [camera.eye(), camera.right(), camera.up(), camera.forward()];
    let lens = camera.lens();
    let numbers = [camera.half_height(), lens.near, lens.far];
    assert_eq!(
        bits([printed.eye, printed.right, printed.up, printed.forward].concat()),
        bits(vectors.map(|v| v.to_array()).concat())
    );
    assert_eq!(
        bits([printed.half_height, printed.near, printed.far]),
        bits(numbers)
    );
    assert_eq!(printed.size, [viewport.width(), viewport.height()]);
    assert_eq!(
        (printed.orthographic, printed.cull),
        (lens.is_orthographic(), *sides == Sides::Front)
    );
    let section = section.map(|section| StoredSection {
        normal: section.normal().to_array(),
        offset: section.offset(),
    });
    assert_eq!(printed.section, section);
}

fn same_scene(printed: &Stored, scene: &Scene) {
    assert_eq!(printed.objects.len(), scene.objects().len());
    for (index, (printed_object, object)) in printed
        .objects
        .iter()
        .zip(scene.objects().iter())
        .enumerate()
    {
        let StoredObject {
            id,
            name,
            shape,
            visible,
            matrix,
            mesh: place,
            triangles,
        } = printed_object;
        assert_eq!(
            (*id, name.as_str(), shape.as_str(), *visible),
            (
                index + 1,
                object.name.as_str(),
                object.shape.kind(),
                object.visible
            )
        );
        let model = object.placement.model();
        let rows = [0, 1, 2].map(|i| {
            let row = model.matrix3.row(i);
            [row.x, row.y, row.z, model.translation[i]]
        });
        assert_eq!(bits(matrix.concat()), bits(rows.concat()), "{name}");
        let Shape::Mesh { mesh, part } = &object.shape else {
            assert_eq!((place, triangles), (&None, &None), "{name}");
            continue;
        };
        let data = mesh.data();
        let range = &data.parts[*part].triangles;
        assert_eq!(*triangles, Some([range.start, range.end]), "{name}");
        let printed = &printed.meshes[place.expect("a mesh")];
        assert_eq!(bits(printed.origin), bits(data.origin.to_array()), "{name}");
        assert_eq!(
            bits(printed.positions.concat()),
            bits(data.positions.as_flattened().iter().map(|c| f64::from(*c))),
            "{name}"
        );
        assert_eq!(printed.triangles, data.triangles, "{name}");
    }
}

#[test]
fn the_stored_numbers_are_printed_to_the_bit_and_each_mesh_once() {
    let folder = folder();
    for flags in [
        "",
        "--cull --hide 2,4 --size 321x123",
        "--ortho 7.7 --near -3.3 --far 15.1 --up 0.1,1,0.3",
    ] {
        let lines = folder.json(&format!("pick scene.toml --stored --at 1,1 {flags}"));
        let [line, _] = &lines[..] else {
            panic!("a line of numbers and a pick: {lines:?}");
        };
        let printed = stored(line);
        let (scene, view) = loaded(&folder, flags);
        same_camera(&printed.camera, &view);
        same_scene(&printed, &scene);
        // Four objects share one mesh: its two parts, twice.
        let used: Vec<_> = printed.objects.iter().map(|object| object.mesh).collect();
        assert_eq!(used, [None, None, Some(0), Some(0), None, Some(0), Some(0)]);
        assert_eq!(printed.meshes.len(), 1);
        assert!(
            printed.meshes[0].origin[0] > 399_000.0,
            "an origin of its own"
        );
        // Without `--stored`, the same picks and nothing else.
        let plain = folder.json(&format!("pick scene.toml --at 1,1 {flags}"));
        assert_eq!(plain, lines[1..]);
    }
}

/// The scene that printed numbers describe. It only holds them; the oracle computes the hits.
fn scene_of(printed: &Stored) -> Scene {
    let meshes: Vec<_> = (0..printed.meshes.len())
        .map(|place| Arc::new(mesh_of(printed, place)))
        .collect();
    let objects = printed.objects.iter().map(|object| {
        let shape = match (object.shape.as_str(), object.mesh, object.triangles) {
            ("sphere", None, None) => Shape::Sphere,
            ("cube", None, None) => Shape::Cube,
            ("square", None, None) => Shape::Square,
            ("mesh", Some(place), Some([start, _])) => Shape::Mesh {
                mesh: Arc::clone(&meshes[place]),
                part: meshes[place].part_of(start),
            },
            other => panic!("no such shape: {other:?}"),
        };
        let [x, y, z, translation] =
            [0, 1, 2, 3].map(|i| DVec3::from(object.matrix.map(|row| row[i])));
        let model = DAffine3::from_mat3_translation(DMat3::from_cols(x, y, z), translation);
        Object {
            visible: object.visible,
            ..Object::new(object.name.clone(), shape, Placement::new(model).unwrap())
        }
    });
    Scene::new(objects.collect())
}

#[expect(clippy::cast_possible_truncation, reason = "they are f32 already")]
fn mesh_of(printed: &Stored, place: usize) -> Mesh {
    let StoredMesh {
        origin,
        positions,
        triangles,
    } = &printed.meshes[place];
    let users = printed
        .objects
        .iter()
        .filter(|object| object.mesh == Some(place));
    let mut ranges: Vec<_> = users.filter_map(|object| object.triangles).collect();
    ranges.sort_unstable();
    ranges.dedup();
    let parts = ranges.iter().map(|&[start, end]| Part {
        name: String::new(),
        triangles: start..end,
    });
    Mesh::new(MeshData {
        origin: (*origin).into(),
        positions: positions.iter().map(|p| p.map(|c| c as f32)).collect(),
        triangles: triangles.clone(),
        parts: parts.collect(),
        colours: vec![ColourRun {
            triangles: 0..u32::try_from(triangles.len()).unwrap(),
            colour: None,
            material: None,
        }],
        ..MeshData::default()
    })
    .unwrap()
}

/// The ray through a position, as the contract has it, times the picture's height.
fn line_of(camera: &Camera, [x, y]: [f64; 2]) -> Line {
    let [width, height] = camera.size.map(|size| Dyadic::of(size.into()));
    let half_height = Dyadic::of(camera.half_height);
    let right = &Dyadic::of(2.0 * x) - &width;
    let up = &height - &Dyadic::of(2.0 * y);
    let aside = times(
        &half_height,
        &plus(
            &times(&right, &vector(camera.right)),
            &times(&up, &vector(camera.up)),
        ),
    );
    let eye = times(&height, &vector(camera.eye));
    let forward = times(&height, &vector(camera.forward));
    let (origin, direction) = if camera.orthographic {
        (plus(&eye, &aside), forward)
    } else {
        (eye, plus(&forward, &aside))
    };
    Line {
        origin,
        direction,
        scale: height,
        near: Dyadic::of(camera.near),
        far: Dyadic::of(camera.far),
        section: (camera.section.as_ref())
            .map(|section| (vector(section.normal), Dyadic::of(section.offset))),
    }
}

/// Fails unless a printed hit is this one.
fn same_hit(printed: &Stored, picked: &Value, [hit, next]: [Option<&Hit>; 2]) {
    let Some(hit) = hit else {
        assert_eq!(picked, &Value::Null);
        return;
    };
    let first = printed.objects[hit.object]
        .triangles
        .map(|[start, _]| start);
    let triangle = hit
        .triangle
        .zip(first)
        .map(|(triangle, first)| triangle - first);
    assert_eq!(picked["id"], hit.object + 1);
    assert_eq!(picked["object"], printed.objects[hit.object].name.as_str());
    assert_eq!(picked["triangle"], serde_json::json!(triangle));
    assert_eq!(picked["front"], hit.front);
    assert_eq!(picked["t"], hit.t.rounded());
    let gap = next.map(|next| next.t.rounded_minus(&hit.t));
    assert_eq!(picked["gap"], serde_json::json!(gap), "{picked}");
}

/// A grid of positions from standard input, each pick found again from the printed numbers alone.
#[test]
fn picks_can_be_checked_from_the_stored_numbers_alone() {
    let folder = folder();
    let positions: Vec<[f64; 2]> = (0..28)
        .flat_map(|y| (0..40).map(move |x| [5.0 * f64::from(x) + 0.3, 5.0 * f64::from(y) + 0.7]))
        .collect();
    let lines: Vec<String> = positions.iter().map(|[x, y]| format!("{x},{y}")).collect();
    let input = lines.join("\n");
    let flags = "--size 200x140 --stored --all-hits --at -";
    for view in [
        "",
        "--cull --hide 5",
        "--ortho 7 --near -20 --far 40",
        "--section 0.1,0.2,-1,0.4",
    ] {
        let lines = json(&folder.run_with(&format!("pick scene.toml {view} {flags}"), &input));
        let (first, picks) = lines.split_first().expect("lines");
        let printed = stored(first);
        let world = World::of(&scene_of(&printed));
        let sides = if printed.camera.cull {
            Sides::Front
        } else {
            Sides::Both
        };
        let mut seen = vec![0; printed.objects.len()];
        for (px, line) in positions.iter().zip(picks) {
            assert_eq!(line["px"], serde_json::json!(px));
            let hits = world.hits(&line_of(&printed.camera, *px), sides);
            let picked = line["hits"].as_array().expect("a list");
            assert_eq!(picked.len(), hits.len(), "{line}");
            for (i, picked) in picked.iter().enumerate() {
                same_hit(&printed, picked, [hits.get(i), hits.get(i + 1)]);
                seen[hits[i].object] += 1;
            }
        }
        assert_eq!(picks.len(), positions.len());
        println!("hits by object, {view:?}: {seen:?}");
        for (object, seen) in printed.objects.iter().zip(seen) {
            assert_eq!(seen >= 5, object.visible, "{}: {seen}", object.name);
        }
    }
}
