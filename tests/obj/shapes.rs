//! Triangles cover exactly the file's polygons, at the file's coordinates.

use super::{CUBE, Folder, bounds, common::Random, mesh, triangles, vector_area};
use glam::DVec3;
use sightline::geometry::Mesh;
use std::{collections::HashMap, fmt::Write};

/// The text of a polygon in the plane z = x + y, so that no axis is special.
fn polygon(corners: &[[f64; 2]]) -> String {
    let mut text = String::new();
    for [x, y] in corners {
        writeln!(text, "v {x} {y} {}", x + y).expect("text");
    }
    text += "f";
    for i in 1..=corners.len() {
        write!(text, " {i}").expect("text");
    }
    text + "\n"
}

fn shoelace(corners: &[[f64; 2]]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    let twice = corners
        .iter()
        .zip(next)
        .map(|([ax, ay], [bx, by])| ax * by - bx * ay);
    0.5 * twice.sum::<f64>()
}

/// Whether a triangle covers the point (x, y), seen along z.
fn covers(mesh: &Mesh, x: f64, y: f64) -> bool {
    triangles(mesh).any(|[a, b, c]| {
        let side = |p: DVec3, q: DVec3| (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
        side(a, b) > 0.0 && side(b, c) > 0.0 && side(c, a) > 0.0
    })
}

/// Asserts that the n - 2 triangles have the polygon's winding and area, and that each inner edge has a triangle on
/// both sides. Then there are no overlaps and no gaps.
fn assert_fills(mesh: &Mesh, corners: &[[f64; 2]]) {
    let areas: Vec<DVec3> = triangles(mesh).map(vector_area).collect();
    assert_eq!(areas.len(), corners.len() - 2);
    let sign = shoelace(corners).signum();
    assert!(areas.iter().all(|area| area.z * sign > 0.0), "{areas:?}");
    let area: f64 = areas.iter().map(|area| area.z).sum();
    let error = (area / shoelace(corners) - 1.0).abs();
    assert!(error < 1e-12, "area off by {error:e}");
    let mut sides = HashMap::<_, u32>::new();
    for &[a, b, c] in &mesh.data().triangles {
        for (p, q) in [(a, b), (b, c), (c, a)] {
            *sides.entry((p.min(q), p.max(q))).or_default() += 1;
        }
    }
    assert!(sides.values().all(|&n| n <= 2));
    let outline = sides.values().filter(|&&n| n == 1).count();
    assert_eq!(
        outline,
        corners.len(),
        "each side of the polygon, and no more"
    );
}

#[test]
fn a_notch_stays_empty() {
    let arrow = [[2.0, 4.0], [0.0, 0.0], [2.0, 1.0], [4.0, 0.0]];
    for start in 0..arrow.len() {
        let mut corners = arrow;
        corners.rotate_left(start);
        for _ in 0..2 {
            let arrow = mesh(&polygon(&corners));
            assert_fills(&arrow, &corners);
            corners.reverse();
        }
        let arrow = mesh(&polygon(&corners));
        assert!(covers(&arrow, 1.9, 2.0) && !covers(&arrow, 1.9, 0.5));
    }
    let comb = [
        [0.0, 0.0],
        [5.0, 0.0],
        [5.0, 3.0],
        [4.0, 3.0],
        [4.0, 1.0],
        [3.0, 1.0],
        [3.0, 3.0],
    ];
    let comb = [
        &comb[..],
        &[[2.0, 3.0], [2.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]],
    ]
    .concat();
    assert_fills(&mesh(&polygon(&comb)), &comb);
}

#[test]
fn straight_corners_stay() {
    // An L with extra corners in the middle of its sides. Which of them earcut would drop depends on the first corner,
    // so each corner is the first once.
    let ell = [
        [0, 0],
        [1, 0],
        [2, 0],
        [3, 0],
        [4, 0],
        [4, 1],
        [4, 2],
        [2, 2],
        [1, 2],
        [1, 3],
        [1, 4],
        [0, 4],
        [0, 2],
    ];
    let mut corners: Vec<[f64; 2]> = ell.map(|corner| corner.map(f64::from)).to_vec();
    for _ in 0..corners.len() {
        corners.rotate_left(1);
        let ell = mesh(&polygon(&corners));
        assert_fills(&ell, &corners);
        assert!(!covers(&ell, 1.5, 2.5));
    }
    // Outlines of columns with a corner at each step of the grid.
    let mut random = Random::new(1);
    for _ in 0..500 {
        let heights = [(); 6].map(|()| i32::try_from(random.below(4)).expect("small") + 1);
        let corners: Vec<[f64; 2]> = skyline(&heights)
            .iter()
            .map(|corner| corner.map(f64::from))
            .collect();
        assert_fills(&mesh(&polygon(&corners)), &corners);
    }
}

/// The outline of adjacent columns with these heights and width 1, with a corner at each whole step.
fn skyline(heights: &[i32]) -> Vec<[i32; 2]> {
    let width = i32::try_from(heights.len()).expect("small");
    let mut corners: Vec<_> = (0..=width).map(|x| [x, 0]).collect();
    let mut at = [width, 0];
    for (x, &height) in (0..width).zip(heights).rev() {
        while at[1] != height {
            at[1] += (height - at[1]).signum();
            corners.push(at);
        }
        at[0] = x;
        corners.push(at);
    }
    corners.extend((1..at[1]).rev().map(|y| [0, y]));
    corners
}

#[test]
fn a_large_polygon_is_quick_and_a_mad_one_is_left_out() {
    let corners: Vec<[f64; 2]> = (0..9_999)
        .map(|i| {
            let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 9_999.0).sin_cos();
            let radius = if i % 2 == 0 { 1.0 } else { 2.0 };
            [radius * cos, radius * sin]
        })
        .collect();
    let start = std::time::Instant::now();
    assert_eq!(mesh(&polygon(&corners)).data().triangles.len(), 9_997);
    let text = format!("{CUBE}f{}\n", " 1 2 3 4 5 6 7 8".repeat(100_000));
    let folder = Folder::new(&[("some.obj", text.as_bytes())]);
    let file = folder.load("some.obj").expect("it loads");
    let told = ["some.obj: faces with too many corners are left out (1)"];
    assert_eq!(folder.warnings(&file), told);
    assert!(start.elapsed().as_secs() < 5);
}

#[test]
fn a_large_polygon_keeps_its_holes() {
    // A square with a round hole and a star-shaped one; the outline goes to each and back along the same bridge.
    let hole = |x: f64, deep: f64| {
        (0..=400).map(move |i| {
            let (sin, cos) = (f64::from(i % 400) * std::f64::consts::TAU / 400.0).sin_cos();
            let radius = if i % 2 == 0 { 1.0 } else { deep };
            [x - radius * cos, radius * sin]
        })
    };
    let at = |x: f64, y: f64| std::iter::once([x, y]);
    let bottom = at(-4.0, -4.0).chain(at(4.0, -4.0)).chain(at(4.0, 4.0));
    let top = at(-4.0, 4.0).chain(at(-4.0, 0.0));
    let between = hole(2.0, 0.5).chain(at(-1.0, 0.0));
    let holes = hole(-2.0, 1.0)
        .take(201)
        .chain(between)
        .chain(hole(-2.0, 1.0).skip(201));
    let corners: Vec<[f64; 2]> = bottom
        .chain(top)
        .chain(holes)
        .chain(at(-4.0, 0.0))
        .collect();
    let plate = mesh(&polygon(&corners));
    let area: f64 = triangles(&plate).map(|t| vector_area(t).z).sum();
    assert!((area / shoelace(&corners) - 1.0).abs() < 1e-5, "{area}");
    assert!(covers(&plate, 0.1, 0.1) && covers(&plate, 1.986, 0.9));
    assert!(!covers(&plate, 2.1, 0.1) && !covers(&plate, -1.9, 0.1));
}

#[test]
fn twisted_and_touching_outlines_leave_no_hole() {
    // The Newell normal of this polygon lies in the plane of three corners. Seen along it, two corners coincide.
    let twisted = mesh("v 0 0 0\nv 1 0 0\nv 0 1 0.25\nv 1 1 0\nf 1 2 3 4\n");
    assert_eq!(twisted.data().triangles.len(), 2);
    let crossed = mesh("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3 4 5\n");
    assert_eq!(crossed.data().triangles.len(), 3);
    // A square with a square hole. The outline goes to the hole and back along the same bridge.
    let ring = [
        [0, 0],
        [4, 0],
        [4, 4],
        [0, 4],
        [0, 0],
        [1, 1],
        [1, 3],
        [3, 3],
        [3, 1],
        [1, 1],
    ];
    let ring = mesh(&polygon(&ring.map(|corner| corner.map(f64::from))));
    let area: f64 = triangles(&ring).map(|t| vector_area(t).z).sum();
    assert_eq!(ring.data().triangles.len(), 8);
    assert!((area - 12.0).abs() < 1e-12 && !covers(&ring, 2.1, 1.9));
}

#[test]
fn far_coordinates_come_back() {
    // A mesh of walls on map coordinates with millimetres; each wall's end is the next one's start.
    let at = |i: i32| {
        let along = f64::from(i);
        [
            447_306.694 + 1.037 * along,
            5_350_108.537 + 10.271 * along,
            251.374 + 0.007 * along,
        ]
    };
    let mut text = String::new();
    for i in 0..100 {
        let [x, y, z] = at(i);
        writeln!(
            text,
            "v {x:.3} {y:.3} {z:.3}\nv {x:.3} {y:.3} {:.3}",
            z + 5.0
        )
        .expect("text");
    }
    for i in 0..99 {
        let (a, b) = (2 * i + 1, 2 * i + 3);
        writeln!(text, "o wall{i}\nf {a} {b} {} {}", b + 1, a + 1).expect("text");
    }
    let walls = mesh(&text);
    assert_eq!(
        (walls.data().parts.len(), walls.data().positions.len()),
        (99, 200)
    );
    let extent = (bounds(&walls).max - bounds(&walls).min).max_element();
    // Half a step of f32 at the ends of the box, as positions are relative to its centre.
    let step = extent * f64::from(f32::EPSILON) / 2.0;
    for i in 0..99 {
        let [a, b, ..] = walls.corners(u32::try_from(2 * i).expect("small"));
        for (corner, [x, y, z]) in [(a, at(i)), (b, at(i + 1))] {
            let file = DVec3::new(x, y, z);
            let file = (file * 1000.0).round() / 1000.0;
            assert!(
                (corner - file).abs().max_element() <= step,
                "{corner} is not {file}"
            );
        }
    }
    assert_eq!(
        mesh(CUBE).data().origin,
        DVec3::ZERO,
        "near 0 nothing is moved"
    );
}

#[test]
fn any_size_loads() {
    for scale in ["e-30", "e-6", "e6", "e30"] {
        let (vertices, faces) = CUBE.split_once('f').expect("faces");
        let text = vertices.replace('1', &format!("1{scale}")) + "f" + faces;
        let cube = mesh(&text);
        let side: f64 = format!("1{scale}").parse().expect("a number");
        let area: f64 = triangles(&cube).map(|t| vector_area(t).length()).sum();
        assert!(
            (area / (6.0 * side * side) - 1.0).abs() < 1e-6,
            "{scale}: {area:e}"
        );
        assert!(
            cube.normals()
                .normals
                .as_flattened()
                .iter()
                .all(|c| c.is_finite())
        );
    }
}
