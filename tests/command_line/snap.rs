//! `pick --snap` leads positions to vertices, edges and faces, and measures them as the file has them.

use super::{Folder, real_files::real_files};
use serde_json::{Value, json};

/// A house front: a wall of one quad, and a roof of one polygon of five corners above it, somewhere on a map.
const FRONT: &str = "\
v 447000.1 5411000.2 0
v 447010.1 5411000.2 0
v 447010.1 5411004.2 0
v 447000.1 5411004.2 0
v 447012.1 5411004.2 0
v 447005.1 5411008.2 0
v 446998.1 5411004.2 0
o Wall
f 1 2 3 4
o Roof
f 7 4 3 5 6
";

fn folder() -> Folder {
    let folder = Folder::new();
    std::fs::write(folder.path("front.obj"), FRONT).unwrap();
    folder
}

/// Ten pixels a unit; the middle of the picture is at 447005.1, 5411004.2.
const LOOK: &str =
    "--size 200x100 --eye 447005.1,5411004.2,10 --target 447005.1,5411004.2,0 --ortho 10";

#[track_caller]
fn is(measure: &Value, expected: f64, most: f64) {
    let off = measure.as_f64().map(|value| (value - expected).abs());
    assert!(
        off.is_some_and(|off| off <= most),
        "{measure}, not {expected}"
    );
}

#[test]
fn positions_are_led_to_vertices_edges_and_faces() {
    let folder = folder();
    // By vertices 1 and 3, the edge from 1 to 2, the wall, the wall's split, the edge from 6 to 7.
    let at = "52,88 148,52 100,92 120,70 101,71 60,27";
    let lines = folder.json(&format!("pick front.obj {LOOK} --snap 8 --at {at}"));
    let to: Vec<_> = lines
        .iter()
        .map(|line| line["snap"]["to"].as_str().unwrap_or("none"))
        .collect();
    assert_eq!(
        to,
        ["vertex", "vertex", "edge", "face", "face", "edge"],
        "{lines:?}"
    );
    let numbers = |line: &Value| -> Vec<u64> {
        let all = line["snap"]["vertices"].as_array().unwrap();
        all.iter()
            .map(|vertex| vertex["vertex"].as_u64().unwrap())
            .collect()
    };
    assert_eq!(numbers(&lines[0]), [1]);
    assert_eq!(
        lines[0]["snap"]["vertices"][0]["written"],
        "447000.1 5411000.2 0"
    );
    assert_eq!(lines[0]["distance"], Value::Null);
    // Both objects have vertex 3. The first one is named.
    assert_eq!(
        (numbers(&lines[1]), &lines[1]["snap"]["object"]),
        (vec![3], &json!("Wall"))
    );
    // From vertex 1 to vertex 3, by the numbers in the file, which are kept as `f32` about an origin; `f64` holds them
    // to 1e-9.
    is(&lines[1]["distance"], 116.0_f64.sqrt(), 2e-9);
    assert_eq!(numbers(&lines[2]), [1, 2]);
    is(&lines[2]["snap"]["length"], 10.0, 2e-9);
    let px = &lines[2]["snap"]["px"];
    assert!(
        (px[0].as_f64().unwrap() - 100.0).abs() < 1e-6
            && (px[1].as_f64().unwrap() - 90.0).abs() < 1e-6
    );
    is(&lines[3]["snap"]["area"], 40.0, 2e-8);
    // The object's vertices are stored as f32 about an origin nearby.
    is(&lines[3]["object_area"], 40.0, 1e-4);
    // The diagonal of the wall is none of its edges.
    assert_eq!(lines[4]["snap"]["object"], "Wall");
    assert_eq!(lines[5]["snap"]["object"], "Roof");
    is(&lines[5]["snap"]["length"], 65.0_f64.sqrt(), 2e-9);
    is(&lines[5]["snap"]["area"], 28.0, 2e-8);
}

#[test]
fn what_is_hidden_or_too_far_is_not_snapped_to() {
    let folder = folder();
    // A plate before the left half.
    let scene = "
[[object]]
shape = \"mesh\"
file = \"front.obj\"

[[object]]
name = \"Plate\"
shape = \"square\"
scale = 12
position = [446999.1, 5411004.2, 5]
";
    std::fs::write(folder.path("plate.toml"), scene).unwrap();
    let look = |scene: &str, radius: f64| {
        let lines = folder.json(&format!("pick {scene} {LOOK} --snap {radius} --at 52,88"));
        lines[0]["snap"].clone()
    };
    let hidden = look("plate.toml", 8.0);
    assert_eq!(
        (&hidden["to"], &hidden["object"]),
        (&json!("face"), &json!("Plate"))
    );
    is(&hidden["area"], 144.0, 1e-12);
    assert_eq!(look("front.obj", 3.0)["to"], "vertex");
    // 2.828... pixels away.
    assert_eq!(look("front.obj", 2.8)["to"], "edge");
    assert_eq!(look("front.obj", 1.0)["to"], "face");
    let away = folder.json(&format!("pick front.obj {LOOK} --snap 8 --at 5,5"));
    assert_eq!(
        (&away[0]["snap"], &away[0]["object_area"]),
        (&Value::Null, &Value::Null)
    );
    let error = folder.error("pick scene.toml --at 5,5 --snap 300", 2);
    assert!(error.contains("from 0 to 256"), "{error}");
}

#[test]
fn cubes_and_squares_have_corners_and_edges() {
    let folder = Folder::new();
    let lines = folder.json("pick scene.toml --size 200x100 --snap 8 --at 109,41 100,41 100,50");
    let of = |line: &Value| (line["snap"]["to"].clone(), line["snap"]["object"].clone());
    assert_eq!(of(&lines[0]), (json!("vertex"), json!("Front")));
    assert_eq!(lines[0]["snap"]["point_world"], json!([0.5, 0.5, 2.5]));
    assert_eq!(of(&lines[1]), (json!("edge"), json!("Front")));
    is(&lines[1]["snap"]["length"], 1.0, 2e-16);
    is(&lines[1]["object_area"], 6.0, 2e-15);
    // From a corner to the middle of the edge beside it.
    is(&lines[1]["distance"], 0.5, 1e-15);
    assert_eq!(lines[2]["snap"]["vertices"], Value::Null);
}

/// A ball keeps an area by formula however it is turned and however large it is; an ellipsoid has none.
#[test]
fn balls_have_an_area_and_ellipsoids_have_none() {
    let folder = Folder::new();
    let balls = "
[[object]]
shape = \"sphere\"
scale = 3
rotation = [10, 20, 30]

[[object]]
shape = \"sphere\"
scale = [1, 1, 1.001]
position = [4, 0, 0]
";
    std::fs::write(folder.path("balls.toml"), balls).unwrap();
    let look = "--size 200x100 --eye 2,0,10 --target 2,0,0 --ortho 10";
    let lines = folder.json(&format!(
        "pick balls.toml {look} --snap 0 --at 80,50 120,50"
    ));
    is(&lines[0]["object_area"], 9.0 * std::f64::consts::PI, 1e-13);
    assert_eq!(lines[1]["snap"]["id"], 2);
    assert_eq!(lines[1]["object_area"], Value::Null);
}

/// A ring as one polygon: its outline goes to the hole and back by one way, and names the vertices there twice.
#[test]
fn the_edges_of_a_polygon_with_a_hole_are_its_own() {
    const SIDES: u32 = 36;
    let folder = Folder::new();
    // Vertices 1 to 36 outside, 37 to 72 inside, run through the other way.
    let around = |radius: f64, i: u32| {
        let angle = std::f64::consts::TAU * (f64::from(i) + 0.3) / f64::from(SIDES);
        [radius * angle.cos(), radius * angle.sin()]
    };
    let mut points: Vec<_> = (0..SIDES).map(|i| around(2.0, i)).collect();
    points.extend((0..SIDES).map(|i| around(1.0, i)));
    let text = points.iter().map(|[x, y]| format!("v {x} {y} 0\n"));
    let outside = (1..=SIDES).chain([1]);
    let inside = [SIDES + 1].into_iter().chain((SIDES + 1..=2 * SIDES).rev());
    let corners: Vec<_> = outside.chain(inside).collect();
    let face: Vec<_> = corners.iter().map(u32::to_string).collect();
    let text = text.collect::<String>() + "f " + &face.join(" ") + "\n";
    std::fs::write(folder.path("ring.obj"), text).unwrap();
    // 100 pixels a unit. One point for each edge: a third of the way along, on the edge or a little inside the ring.
    let look = "--size 600x600 --eye 0,0,10 --target 0,0,0 --ortho 6";
    let edges = (0..corners.len()).map(|i| [corners[i], corners[(i + 1) % corners.len()]]);
    let at = edges.clone().map(|ends| {
        let [a, b] = ends.map(|vertex| points[vertex as usize - 1]);
        let [x, y] = [0, 1].map(|axis| a[axis] + (b[axis] - a[axis]) / 3.0);
        let radius = x.hypot(y);
        let moved = 1.0 + 0.005 * (1.5 - radius);
        format!(
            "{},{}",
            300.0 + 100.0 * moved * x,
            300.0 - 100.0 * moved * y
        )
    });
    let at = at.collect::<Vec<_>>().join(" ");
    let lines = folder.json(&format!("pick ring.obj {look} --snap 2 --at {at}"));
    assert_eq!(lines.len(), corners.len());
    for (line, mut ends) in lines.iter().zip(edges) {
        let snap = &line["snap"];
        assert_eq!(snap["to"], "edge", "{ends:?}");
        let found = [0, 1].map(|i| snap["vertices"][i]["vertex"].as_u64().unwrap());
        ends.sort_unstable();
        let [a, b] = found;
        assert_eq!([a.min(b), a.max(b)], ends.map(u64::from));
    }
}

/// A polygon with a hole from a real file. Both positions are near the hole's edge from vertex 32 to vertex 35: the
/// first a little inside the ring, the second on the edge.
#[test]
fn the_edge_of_a_hole_in_a_real_file_is_where_the_file_has_it() {
    let Some(shared) = real_files() else {
        return;
    };
    let folder = Folder::new();
    let model = shared.join("models/concave_polygon.obj");
    let look = "--size 600x600 --ortho 1.6 --eye=5,2.4,2.35 --look=-1,0,0 --snap 2";
    let at: [[f64; 2]; 2] = [[44.664_375, 270.8525], [44.66, 274.85]];
    let words = at.map(|[x, y]| format!("{x},{y}")).join(" ");
    let lines = folder.json(&format!("pick {} {look} --at {words}", model.display()));
    assert_eq!(lines.len(), at.len());
    for (line, [x, y]) in lines.iter().zip(at) {
        let snap = &line["snap"];
        let ends = [0, 1].map(|i| snap["vertices"][i]["vertex"].clone());
        assert_eq!(
            (&snap["to"], ends),
            (&json!("edge"), [json!(32), json!(35)])
        );
        let length = 0.134_768_981_965_435_94;
        is(&snap["length"], length, 2e-15);
        // As z and y in the plane of the ring: 375 pixels a unit, and the vertices as the file has them.
        let [z, y] = [2.35 + (300.0 - x) / 375.0, 2.4 + (300.0 - y) / 375.0];
        let aside = (z - 3.0375) * (2.534_12 - 2.4) - (y - 2.4) * (3.024_29 - 3.0375);
        let away = 375.0 * aside.abs() / length;
        let found = snap["away_px"].as_f64().unwrap();
        assert!((found - away).abs() < 1e-4, "{found}, not {away}");
    }
}

/// An outline that goes out and straight back encloses no area there.
#[test]
fn a_spike_adds_nothing_to_the_area() {
    let folder = Folder::new();
    let vertices = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\n";
    let look = "--size 200x200 --eye 1,1,10 --target 1,1,0 --ortho 4 --snap 0 --at 110,110";
    for (face, expected) in [
        ("1 2 3 4 4 3", 2.0),
        ("1 1 2 3 3 4", 4.0),
        ("2 3 4 1 4", 2.0),
        ("4 3 4 1 2 3", 4.0),
    ] {
        std::fs::write(folder.path("spike.obj"), format!("{vertices}f {face}\n")).unwrap();
        // A warning says that triangles without area are left out.
        let output = folder.run(&format!("pick spike.obj {look}"));
        let line: Value = serde_json::from_slice(&output.stdout).expect("a line of JSON");
        is(&line["snap"]["area"], expected, 1e-15);
        is(&line["object_area"], expected, 1e-5);
    }
}

/// A position equally far from two edges, to the last bit, snaps to the first, however the foot's share is rounded.
#[test]
fn of_edges_as_near_the_first_is_taken() {
    let folder = Folder::new();
    let beside = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1.2 1 0\nv 0.4 1 0\nv 0 1 0\nv 1 2 0\nf 1 2 3 4 5 6\nf 6 4 7\n";
    std::fs::write(folder.path("beside.obj"), beside).unwrap();
    let view = "--size 200x200 --eye 1,0.5,5 --target 1,0.5,0 --ortho 4";
    let at = "60,76 75,76 90,76 100,76";
    let lines = folder.json(&format!("pick beside.obj {view} --snap 4 --at {at}"));
    for (line, x) in lines.iter().zip([0.2, 0.5, 0.8, 1.0]) {
        let snap = &line["snap"];
        assert_eq!([&snap["to"], &snap["face"]], [&json!("edge"), &json!(1)]);
        is(&snap["point_world"][0], x, 1e-12);
        is(&snap["point_world"][1], 1.0, 1e-12);
    }
}
