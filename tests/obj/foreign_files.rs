//! Files made by other programs load with the counts that another reader found. Hostile files get their known verdict.

use super::{bounds, common::real_files};
use sightline::{
    camera::{CameraChoice, View, Viewport},
    geometry::{Placement, Sides},
    pick,
    scene::{Object, Progress, Scene, Shape, obj::load},
};
use std::{fmt::Write, fs, path::Path, sync::Arc};

/// The rows of a table with a header, as text.
fn table(path: &Path) -> Vec<Vec<String>> {
    let text = fs::read_to_string(path).expect("a table");
    let rows = text
        .lines()
        .skip(1)
        .map(|line| line.split('\t').map(str::to_owned).collect());
    rows.collect()
}

#[test]
fn models_hold_what_they_should() {
    let Some(shared) = real_files() else {
        return;
    };
    let models = shared.join("models");
    let rows = table(&models.join("expect.tsv"));
    let files = fs::read_dir(&models).expect("a folder");
    let files = files.map(|entry| entry.expect("an entry").path());
    let files = files.filter(|path| path.extension().is_some_and(|extension| extension == "obj"));
    assert!(!rows.is_empty() && rows.len() == files.count(), "{rows:?}");
    for row in rows {
        let name = &*row[0];
        let number = |column: usize| row[column].parse::<f64>().expect("a number");
        let count = |column: usize| row[column].parse::<usize>().expect("a count");
        let file = load(&models.join(name), &Progress::default()).expect(name);
        let data = file.mesh.data();

        let (all, without_area) = (count(6), count(17));
        let triangles = data.triangles.len();
        assert!(
            (all - without_area..=all).contains(&triangles),
            "{name}: {triangles} of {all}"
        );

        // Two files differ from the counts: one has a group beside an object, one an object without faces.
        let objects = match name {
            "cornell_box.obj" => 8,
            "bunny10k_textured.obj" => 1,
            _ => count(7).max(count(8)).max(1),
        };
        assert_eq!(data.parts.len(), objects, "{name}");

        let bounds = bounds(&file.mesh);
        let found = [bounds.min.to_array(), bounds.max.to_array()].concat();
        let extent = (bounds.max - bounds.min).max_element();
        // The origin stays 0 if the box's centre is no farther from 0 than the box is large. Then coordinates reach up
        // to 1.5 times the size of the box, and f32 rounds them by at most half a step there.
        let step = 1.5 * extent * f64::from(f32::EPSILON) / 2.0;
        for (axis, found) in found.into_iter().enumerate() {
            let expected = number(10 + axis);
            assert!(
                (found - expected).abs() <= step,
                "{name}: {found} is not {expected}"
            );
        }
    }
}

/// Files whose coordinates are the smallest, the largest and the farthest apart that we know of are read whole, framed
/// whole and picked.
#[test]
fn what_is_large_or_small_is_read_whole() {
    let Some(shared) = real_files() else {
        return;
    };
    for (name, triangles) in [
        ("models/rabbit.obj", 1252),
        ("models/spot.obj", 5856),
        ("models/teapot_tiny.obj", 6320),
        ("models/teapot_huge.obj", 6320),
        ("models/teapot.obj", 6320),
        ("hostile/huge_extent.obj", 12),
    ] {
        let file = load(&shared.join(name), &Progress::default()).expect(name);
        assert_eq!(file.mesh.data().triangles.len(), triangles, "{name}");
        let said = file.warnings.iter().map(ToString::to_string);
        let left_out: Vec<_> = said.filter(|said| said.contains("left out")).collect();
        assert!(left_out.is_empty(), "{name}: {left_out:?}");
        let parts = 0..file.mesh.data().parts.len();
        let object = |part| {
            let mesh = Arc::clone(&file.mesh);
            Object::new(name, Shape::Mesh { mesh, part }, Placement::IDENTITY)
        };
        let scene: Scene = parts.map(object).collect();
        let viewport = Viewport::new(64, 48).expect("a size");
        let camera = CameraChoice::default().resolve(&scene.bounds(), viewport);
        let camera = camera.expect(name);
        for corner in scene.bounds().corners() {
            let shown = camera.project(viewport, corner).expect("before the eye");
            assert!(
                viewport.contains(shown.px),
                "{name}: {corner} at {}",
                shown.px
            );
        }
        let view = View {
            camera,
            viewport,
            sides: Sides::Both,
            section: None,
        };
        let ids = pick::ids(&scene, &view);
        let hits = ids.pixels().iter().filter(|id| id.object > 0).count();
        assert!(hits > 300, "{name}: {hits}");
    }
}

/// The result of each hostile file: its name, verdict, number of triangles, and messages.
const VERDICTS: &str = include_str!("hostile.tsv");

/// Files whose verdict or number of triangles differs from the table beside the files, and why.
const EXCEPTIONS: [(&str, &str); 2] = [
    (
        "ufbx_obj_zoo.obj",
        "its one face has all corners in one point: without area there is nothing to show",
    ),
    (
        "assimp_malformed.obj",
        "a corner of a quad is there twice: one of its two triangles has no area",
    ),
];

#[test]
fn hostile_files_get_their_verdict() {
    let Some(shared) = real_files() else {
        return;
    };
    let hostile = shared.join("hostile");
    let mut verdicts = String::new();
    for row in table(&hostile.join("expect.tsv")) {
        let [name, allowed, counts] = [0, 1, 2].map(|column| &*row[column]);
        let loaded = load(&hostile.join(name), &Progress::default());
        let (verdict, triangles, said) = match &loaded {
            Ok(file) => {
                let said: Vec<_> = file.warnings.iter().map(ToString::to_string).collect();
                let verdict = if said.is_empty() { "ok" } else { "warn" };
                (verdict, file.mesh.data().triangles.len(), said.join("; "))
            }
            Err(refused) => ("error", 0, refused.to_string()),
        };
        assert_eq!(said.lines().count(), usize::from(verdict != "ok"), "{said}");
        let said = said.replace(&format!("{}/", hostile.display()), "");
        assert!(verdict != "error" || said.contains(name), "{said}");
        writeln!(verdicts, "{name}\t{verdict}\t{triangles}\t{said}").expect("text");

        let right = (allowed == "any" || allowed.split('|').any(|v| v == verdict))
            && (verdict == "error"
                || counts.is_empty()
                || counts.split('|').any(|n| n.parse() == Ok(triangles)));
        let exception = EXCEPTIONS.iter().any(|(known, _)| *known == name);
        assert_ne!(
            right, exception,
            "{name}: {verdict} {triangles}, not {allowed} {counts}"
        );
    }
    let changed = verdicts.lines().zip(VERDICTS.lines());
    let changed: Vec<_> = changed.filter(|(now, before)| now != before).collect();
    assert!(
        verdicts == VERDICTS,
        "{changed:#?}\nall of them:\n{verdicts}"
    );
}
