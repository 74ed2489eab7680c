//! A pick names its file, line, face and vertices as written.

use super::Folder;
use serde_json::{Value, json};

/// Two walls, one behind the other, across the z axis: a quad, and a triangle that names its corners from the back.
const WALLS: &str = "\
# two walls
o Front
v -1 -1 2
v 1.1 -1 2
v 1.1 1.00 2e0
v -1 1 2
f 1 2 3 4
o Back
v -5 -5 0
v 5.5 -1 0
v 0 8 0
f -3 -2 \\
  -1
";

const LOOK: &str = "--size 200x100 --eye 0,0,10 --target 0,0,0";

fn folder() -> Folder {
    let folder = Folder::new();
    std::fs::write(folder.path("walls.obj"), WALLS).unwrap();
    folder
}

/// A coordinate that is too small for the range of numbers is 0, also when the file is read again for a pick.
#[test]
fn a_coordinate_that_counts_as_0_is_no_other_one_when_read_again() {
    let folder = Folder::new();
    let small = "v -1 -1 1e-40\nv 1 -1 0\nv 1e-34 1 0\nf 1 2 3\n";
    std::fs::write(folder.path("small.obj"), small).unwrap();
    let lines = folder.json(&format!("pick small.obj {LOOK} --at 100,50"));
    let hit = &lines[0]["hit"];
    assert_eq!(
        [&hit["line"], &hit["file_error"]],
        [&json!(4), &Value::Null]
    );
    assert_eq!(hit["vertices"][2]["written"], "1e-34 1 0");
    assert_eq!(hit["vertices"][2]["stored"], json!([0.0, 1.0, 0.0]));
}

#[test]
fn a_pick_names_file_line_face_and_corners() {
    let folder = folder();
    let lines = folder.json(&format!(
        "pick walls.obj {LOOK} --at 100,50 140,60 --all-hits"
    ));
    let hits = lines[0]["hits"].as_array().unwrap();
    let file = folder.path("walls.obj").display().to_string();
    let [front, back] = &hits[..] else {
        panic!("{hits:?}");
    };
    assert_eq!(
        (&front["file"], &front["line"], &front["face"]),
        (&json!(file), &json!(7), &json!(1))
    );
    let vertices = json!([
        {"vertex": 1, "line": 3, "written": "-1 -1 2", "stored": null},
        {"vertex": 2, "line": 4, "written": "1.1 -1 2", "stored": [f64::from(1.1_f32), -1.0, 2.0]},
        {"vertex": 3, "line": 5, "written": "1.1 1.00 2e0", "stored": [f64::from(1.1_f32), 1.0, 2.0]},
        {"vertex": 4, "line": 6, "written": "-1 1 2", "stored": null},
    ]);
    assert_eq!(front["vertices"], vertices);
    // The triangle of the quad that was hit, in the order of its weights.
    assert_eq!(front["corners"].as_array().unwrap().len(), 3);
    assert_eq!(
        (&back["line"], &back["face"], &back["corners"]),
        (&json!(12), &json!(2), &json!([0, 1, 2]))
    );
    assert_eq!(back["vertices"][0]["vertex"], 5);
    assert_eq!(back["file_error"], Value::Null);
    // Objects that are no mesh are in no file.
    let ball = folder.json("pick scene.toml --size 200x100 --at 100,50");
    assert_eq!(
        (&ball[0]["hit"]["file"], &ball[0]["hit"]["vertices"]),
        (&Value::Null, &Value::Null)
    );
}
