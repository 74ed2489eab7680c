//! Files from the world outside, against counts by another reader.

use super::{bounds, common::shared};
use sightline::scene::{Progress, obj::load};
use std::{fs, path::Path};

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
    let Some(shared) = shared() else {
        println!("real files: absent");
        return;
    };
    let models = shared.join("models");
    for row in table(&models.join("expect.tsv")) {
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

        // As counted, but for a group beside an object, and for what has no faces.
        let objects = match name {
            "cornell_box.obj" => 8,
            "bunny10k_textured.obj" => 1,
            _ => count(7).max(count(8)).max(1),
        };
        assert_eq!(data.parts.len(), objects, "{name}");

        let bounds = bounds(&file.mesh);
        let found = [bounds.min.to_array(), bounds.max.to_array()].concat();
        let extent = (bounds.max - bounds.min).max_element();
        // A box that reaches to its own size from 0 is not moved: 1.5 times its size, in f32.
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

/// Files that get another verdict, or another number of triangles, than the table has; and why.
const EXCEPTIONS: [(&str, &str); 1] = [(
    "ufbx_obj_zoo.obj",
    "its one face has all corners in one point: without area there is nothing to show",
)];

#[test]
fn hostile_files_get_their_verdict() {
    let Some(shared) = shared() else {
        println!("real files: absent");
        return;
    };
    let hostile = shared.join("hostile");
    let mut otherwise = Vec::new();
    for row in table(&hostile.join("expect.tsv")) {
        let loaded = load(&hostile.join(&row[0]), &Progress::default());
        let (verdict, triangles) = match &loaded {
            Ok(file) if file.warnings.is_empty() => ("ok", file.mesh.data().triangles.len()),
            Ok(file) => ("warn", file.mesh.data().triangles.len()),
            Err(refused) => {
                let refused = refused.to_string();
                assert!(refused.contains(&row[0]), "{refused}");
                assert_eq!(refused.lines().count(), 1, "{refused}");
                ("error", 0)
            }
        };
        let right = row[1] == "any" || row[1].split('|').any(|v| v == verdict);
        let counts = verdict == "error"
            || row[2].is_empty()
            || row[2].split('|').any(|n| n.parse() == Ok(triangles));
        if !(right && counts) {
            otherwise.push((row[0].clone(), format!("{verdict} {triangles}: {loaded:?}")));
        }
    }
    let unexpected: Vec<_> = otherwise
        .iter()
        .filter(|(name, _)| !EXCEPTIONS.iter().any(|(known, _)| known == name))
        .collect();
    assert!(unexpected.is_empty(), "{unexpected:#?}");
    assert_eq!(
        otherwise.len(),
        EXCEPTIONS.len(),
        "an exception is none any more"
    );
}
