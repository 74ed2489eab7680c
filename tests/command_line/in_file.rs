//! A pick names its file, line, face and vertices as written. Faces and vertices are found by their numbers.

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

#[test]
fn faces_and_vertices_are_found_by_their_numbers() {
    let folder = folder();
    let lines = folder.json(&format!("pick walls.obj {LOOK} --face 1 2 --vertex 5 3"));
    let [first, second, behind, seen] = &lines[..] else {
        panic!("{lines:?}");
    };
    let place = |line: &Value| {
        let places = line["places"].as_array().unwrap();
        assert_eq!(places.len(), 1, "{line}");
        places[0].clone()
    };
    assert_eq!((&first["face"], &first["line"]), (&json!(1), &json!(7)));
    let front = place(first);
    assert_eq!(
        (&front["object"], &front["id"], &front["seen"]),
        (&json!("Front"), &json!(1), &json!(true))
    );
    // The front wall hides the middle of the back triangle.
    let back = place(second);
    assert_eq!(
        (&back["seen"], &back["hidden_by"]["object"]),
        (&json!(false), &json!("Front"))
    );
    assert_eq!(
        (&behind["vertex"], &behind["written"]),
        (&json!(5), &json!("-5 -5 0"))
    );
    let corner = place(behind);
    assert_eq!(
        (&corner["object"], &corner["in_picture"]),
        (&json!("Back"), &json!(false))
    );
    let corner = place(seen);
    assert_eq!(
        (&corner["seen"], &corner["hidden_by"]),
        (&json!(true), &Value::Null)
    );
    // Vertex 3 is shown in the upper right quarter of the picture.
    let px = |i: usize| corner["px"][i].as_f64().unwrap();
    assert!(
        (100.0..200.0).contains(&px(0)) && (0.0..50.0).contains(&px(1)),
        "{corner}"
    );
}

#[test]
fn numbers_that_are_not_there_are_said_to_be_none() {
    let folder = folder();
    let error = folder.error(&format!("pick walls.obj {LOOK} --face 3"), 2);
    assert!(
        error.contains("there is no face 3: they run from 1 to 2"),
        "{error}"
    );
    let error = folder.error(&format!("pick walls.obj {LOOK} --vertex 8"), 2);
    assert!(
        error.contains("there is no vertex 8: they run from 1 to 7"),
        "{error}"
    );
    let error = folder.error("pick scene.toml --face 1", 2);
    assert!(error.contains("OBJ file"), "{error}");
    std::fs::copy(folder.path("walls.obj"), folder.path("more.obj")).unwrap();
    let error = folder.error("pick walls.obj more.obj --face 1", 2);
    assert!(error.contains("--object"), "{error}");
    let lines = folder.json(&format!(
        "pick walls.obj more.obj {LOOK} --face 1 --object 4"
    ));
    assert!(lines[0]["file"].as_str().unwrap().ends_with("more.obj"));
    assert_eq!(lines[0]["places"][0]["id"], 3);
}

#[test]
fn a_face_that_is_left_out_is_shown_as_it_is_written() {
    let folder = Folder::new();
    let text = "\
v -1 -1 0
v 1 -1 0
v 1 1 0
v 0 nan 0
f 1 2 3
f 1/4 2 9/ -1
f 1 x 3
f 1 2
f 1 2 4
f 1 2 2
";
    std::fs::write(folder.path("bad.obj"), text).unwrap();
    let lines = folder.run(&format!("pick bad.obj {LOOK} --face 1 2 3 4 5 6"));
    let lines: Vec<Value> = String::from_utf8(lines.stdout)
        .unwrap()
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    let expected = [
        ("1 2 3", vec![1, 2, 3], None),
        (
            "1/4 2 9/ -1",
            vec![1, 2, 4],
            Some("a face names vertex 9 of 4"),
        ),
        ("1 x 3", vec![1, 3], Some("a face names vertex x of 4")),
        ("1 2", vec![1, 2], Some("less than three corners")),
        (
            "1 2 4",
            vec![1, 2, 4],
            Some("vertex 4 is not three finite numbers"),
        ),
        ("1 2 2", vec![1, 2, 2], Some("no area")),
    ];
    assert_eq!(lines.len(), expected.len());
    for (line, (written, vertices, why)) in lines.iter().zip(expected) {
        assert_eq!(line["written"], written);
        let found = line["vertices"].as_array().unwrap();
        let numbers = found
            .iter()
            .map(|vertex| vertex["vertex"].as_u64().unwrap());
        assert!(numbers.eq(vertices), "{line}");
        let said = line["left_out"].as_str();
        assert_eq!(said.is_some(), why.is_some(), "{line}");
        assert!(
            said.unwrap_or_default().contains(why.unwrap_or_default()),
            "{line}"
        );
        assert_eq!(line["places"].as_array().unwrap().is_empty(), why.is_some());
    }
}
