//! `edge_px` is as exact as documented, whatever the lens, the distance and the near plane.

use crate::{
    common::{Random, mesh},
    edge_cases::{Case, FAMILIES, Family},
    wide::Truth,
};
use glam::{DVec2, DVec3};
use sightline::{
    camera::{Camera, DepthMapping, Lens, Projection, View, Viewport},
    geometry::{Placement, Square},
    pick::{self, Pick},
    scene::{Object, Scene, Shape},
};

/// Counts over a family's cases.
#[derive(Debug, Default, PartialEq)]
struct Counts {
    /// Positions where the object is picked.
    picked: u32,
    /// Picked positions where no edge lies beyond the near plane.
    none: u32,
    /// Picked positions where the nearest point is where the near plane cuts an edge.
    cut: u32,
    /// Picked positions where `edge_px` is less exact than promised, or a number in place of null, or the reverse.
    wrong: u32,
}

/// A triangle whose world vertices (origin + vertex) do not fit into `f64`.
fn triangle() -> Shape {
    let corners = vec![[-0.5, -0.5, 0.1], [0.6, -0.4, 0.0], [-0.3, 0.5, -0.2]];
    let mesh = mesh(
        corners,
        vec![[0, 1, 2]],
        DVec3::new(0.1, 1e-9 / 3.0, -1e3 / 3e3),
    );
    Shape::Mesh { mesh, part: 0 }
}

/// The distance to the nearest edge, and whether the nearest point is a cut by the near plane.
fn truth(case: &Case, pick: &Pick) -> Option<(f64, bool)> {
    let placement = &case.object.placement;
    let corners = |origin: DVec3, vertices: &[DVec3], bits| {
        let truth = Truth::new(&case.view, case.px, bits);
        let world = vertices
            .iter()
            .map(|&vertex| truth.world(placement, origin, vertex));
        truth.polygon_px(&world.collect::<Vec<_>>())
    };
    let square = Square::corners();
    let found = match &case.object.shape {
        Shape::Sphere => Truth::new(&case.view, case.px, 700).outline_px(placement),
        Shape::Square => corners(DVec3::ZERO, &square, 700),
        Shape::Cube => {
            // The square's corners, turned onto the face that was hit.
            let n = pick.normal_object;
            let (u, v) = n.any_orthonormal_pair();
            corners(
                DVec3::ZERO,
                &square.map(|c| c.x * u + c.y * v + 0.5 * n),
                700,
            )
        }
        Shape::Mesh { mesh, .. } => {
            let data = mesh.data();
            let vertices = data.positions.iter().map(|p| DVec3::from(p.map(f64::from)));
            corners(data.origin, &vertices.collect::<Vec<_>>(), 700)
        }
    };
    found.filter(|(px, _)| px.is_finite())
}

fn counts(family: Family, shape: &Shape, tries: u32, seed: u64) -> Counts {
    let mut random = Random::new(seed);
    let mut counts = Counts::default();
    for _ in 0..tries {
        let Some(case) = family(&mut random, shape) else {
            continue;
        };
        let Some(pick) = pick::pick(&case.scene(), &case.view, case.px) else {
            continue;
        };
        let truth = truth(&case, &pick);
        counts.picked += 1;
        counts.none += u32::from(truth.is_none());
        counts.cut += u32::from(truth.is_some_and(|(_, cut)| cut));
        let right = match (pick.edge_px, truth) {
            (Some(px), Some((truth, _))) => (px - truth).abs() <= (1e-6_f64).max(1e-9 * truth),
            (px, truth) => px.is_none() && truth.is_none(),
        };
        if !right {
            counts.wrong += 1;
            println!("{:?} but {truth:?}: {case:?}", pick.edge_px);
        }
    }
    counts
}

/// Sums the counts of all families, with `tries` each.
fn all_counts(shape: &Shape, tries: u32) -> Counts {
    let mut all = Counts::default();
    for (seed, (name, family)) in (100..).zip(FAMILIES) {
        let counts = counts(family, shape, tries, seed);
        println!("{name}, {}: {counts:?}", shape.kind());
        assert_eq!(counts.wrong, 0, "{name}");
        all.picked += counts.picked;
        all.none += counts.none;
        all.cut += counts.cut;
    }
    all
}

#[test]
fn edges_are_as_far_as_wide_arithmetic_says() {
    for shape in [triangle(), Shape::Square, Shape::Cube] {
        let Counts {
            picked, none, cut, ..
        } = all_counts(&shape, 100);
        let kind = shape.kind();
        assert!(picked > 800, "{kind}: only {picked} picked");
        assert_eq!(
            none, 0,
            "{kind}: a flat face that is hit has a corner behind the near plane"
        );
        assert!(cut > 10, "{kind}: only {cut} nearest at a cut");
    }
}

#[test]
fn outlines_are_as_far_as_wide_arithmetic_says() {
    let Counts {
        picked, none, cut, ..
    } = all_counts(&Shape::Sphere, 50);
    assert!(picked > 400, "only {picked} picked");
    assert!(none > 40, "only {none} without an outline");
    assert!(cut > 8, "only {cut} nearest at a cut");
}

/// A picture of next to nothing, beside the sphere's topmost point: its outline is a straight line there.
#[test]
fn a_spheres_outline_in_pictures_of_next_to_nothing() {
    let sphere = Object::new("ball", Shape::Sphere, Placement::IDENTITY);
    let scene = Scene::new(vec![sphere]);
    for exponent in -32..=-20 {
        let lens = Lens {
            projection: Projection::Orthographic {
                height: 10_f64.powi(exponent),
            },
            near: 0.0,
            far: 10.0,
            depth: DepthMapping::default(),
        };
        let eye = DVec3::new(0.0, 0.5, 3.0);
        let camera = Camera::looking(eye, DVec3::NEG_Z, DVec3::Y, lens).expect("a camera");
        let view = View::new(camera, Viewport::new(33, 17).expect("a size"));
        let pick = pick::pick(&scene, &view, DVec2::new(0.0, 16.0)).expect("below the top");
        let edge_px = pick.edge_px.expect("an outline");
        assert!((edge_px - 7.5).abs() <= 1e-9, "1e{exponent}: {edge_px}");
    }
}
