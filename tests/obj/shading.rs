//! Normals are the file's where it has them, and else computed: smooth over gentle bends, flat beside sharp edges.
//! Vertex colours stay with their vertices.

use super::{CUBE, Folder, mesh, triangles, vector_area};
use glam::{DVec3, Vec3};
use sightline::{colour::Srgb, geometry::Mesh};
use std::fmt::Write;

fn corner_normals(mesh: &Mesh, triangle: usize) -> [Vec3; 3] {
    let normals = mesh.normals();
    let corners = normals.corners_of(&mesh.data().triangles);
    corners[triangle].map(|i| Vec3::from_array(normals.normals[i as usize]))
}

fn assert_flat(mesh: &Mesh, triangle: usize) {
    let face = triangles(mesh)
        .nth(triangle)
        .map(vector_area)
        .expect("a triangle")
        .normalize();
    for normal in corner_normals(mesh, triangle) {
        assert!(
            normal.as_dvec3().dot(face) > 1.0 - 1e-6,
            "{normal} is not {face}"
        );
    }
}

#[test]
fn a_cube_is_flat_and_a_bent_strip_smooth() {
    let cube = mesh(CUBE);
    (0..12).for_each(|triangle| assert_flat(&cube, triangle));
    // A quarter of a cylinder in steps of 10 degrees, with two materials. Its normals point away from its axis.
    let mut text = String::new();
    for step in 0..10 {
        let (sin, cos) = (f64::from(step) * 10.0).to_radians().sin_cos();
        writeln!(text, "v {cos} {sin} 0\nv {cos} {sin} 1").expect("text");
    }
    for i in 0..9 {
        let a = 2 * i + 1;
        writeln!(
            text,
            "usemtl m{}\nf {a} {} {} {}",
            i % 2,
            a + 2,
            a + 3,
            a + 1
        )
        .expect("text");
    }
    let folder = Folder::new(&[("some.obj", text.as_bytes())]);
    let strip = folder.load("some.obj").expect("it loads").mesh;
    for (triangle, corners) in triangles(&strip)
        .enumerate()
        .filter(|(i, _)| (2..16).contains(i))
    {
        for (corner, normal) in corners.iter().zip(corner_normals(&strip, triangle)) {
            let outward = DVec3::new(corner.x, corner.y, 0.0);
            assert!(
                normal.as_dvec3().dot(outward) > 1.0 - 1e-4,
                "{normal} at {corner}"
            );
        }
    }
}

#[test]
fn the_files_normals_are_kept_on_faces_that_have_them() {
    let tilted = Vec3::new(0.6, 0.0, 0.8);
    let corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 2 0\nvn 6 0 8\nvn 0 0 0\nvn nan 0 1\n";
    let some = mesh(&format!(
        "{corners}f 1//1 2//1 3//1\nf 2 4 3\nf 2//1 4 3//1\nf 3//2 4//1 5//1\nf 3/7/3 4/7/1 5/7/1\nf 3//-3 4//-3 5//-3\n"
    ));
    for kept in [0, 5] {
        assert!(
            corner_normals(&some, kept)
                .iter()
                .all(|n| n.distance(tilted) < 1e-6)
        );
    }
    (1..5).for_each(|computed| assert_flat(&some, computed));
    let all = mesh(&format!("{corners}f 1//1 2//1 3//1\nf 2//1 4//1 3//1\n"));
    assert!((0..2).all(|i| {
        corner_normals(&all, i)
            .iter()
            .all(|n| n.distance(tilted) < 1e-6)
    }));
}

#[test]
fn normals_that_do_not_exist_are_computed() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 6 0 8\nf 1//1 2//1 3//2\nf 1//-2 2//1 3//1\nf 1//0 2//1 3//1\n\
        f 1//6148914691236517206 2//1 3//1\n";
    let folder = Folder::new(&[("some.obj", text.as_bytes())]);
    let file = folder.load("some.obj").expect("it loads");
    let told = ["some.obj: faces name normals that do not exist; theirs are computed (4)"];
    assert_eq!(folder.warnings(&file), told);
    (0..4).for_each(|triangle| assert_flat(&file.mesh, triangle));
}

#[test]
fn vertex_colours_stay_with_their_vertices() {
    let corners = ["v 0 0 0", "v 1 0 0", "v 0 1 0", "v 1 1 0"];
    let coloured = |which: &[usize]| {
        let mut text = "v 9 9 9\n".to_owned();
        for (i, corner) in corners.iter().enumerate() {
            let colour = if which.contains(&i) { " 1 0 0.5" } else { "" };
            writeln!(text, "{corner}{colour}").expect("text");
        }
        mesh(&(text + "f 5 4 3\nf 2 3 4\n"))
    };
    for which in [&[0, 1, 2, 3][..], &[0], &[3], &[1, 2], &[]] {
        let mesh = coloured(which);
        let data = mesh.data();
        assert_eq!(data.vertex_colours.is_empty(), which.is_empty());
        for (position, &colour) in data.positions.iter().zip(&data.vertex_colours) {
            let own = corners.iter().position(|corner| {
                let [x, y, z] = position;
                *corner == format!("v {x} {y} {z}")
            });
            let red = which.contains(&own.expect("a corner"));
            let expected = if red {
                Srgb([255, 0, 128])
            } else {
                Srgb::WHITE
            };
            assert_eq!(colour, expected, "of {position:?} when {which:?} are red");
        }
    }
}
