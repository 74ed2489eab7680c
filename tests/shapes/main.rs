//! Rays hit each shape where closed forms in world space say, under every kind of transform.
#![cfg(feature = "window")]

mod borders;
#[path = "../common/mod.rs"]
mod common;
#[path = "../common/exact/mod.rs"]
mod exact;
mod rims;

use common::{Random, assert_close, assert_near, mesh, placements, ray_to, scene_of};
use glam::{DAffine3, DMat3, DVec3, dvec3};
use sightline::{
    geometry::{Placement, PlacementError, Ray, Sides, Sphere},
    pick::{self, SceneHit},
    scene::{Scene, Shape},
};

/// A hit by the closed forms below, in world space.
struct Truth {
    t: f64,
    /// Outward, of any length.
    normal: DVec3,
}

/// Rays in world space that start around (and in) a unit-sized object and mostly hit it.
fn rays(model: DAffine3, seed: u64) -> impl Iterator<Item = Ray> {
    let mut random = Random::new(seed);
    (0..400).map(move |_| {
        let origin = model.transform_point3(random.point(2.0));
        ray_to(origin, model.transform_point3(random.point(0.55)))
    })
}

/// Fails unless the hits are the expected ones: as many, at the same t, facing the same way. True if there is a hit.
#[track_caller]
fn same_hits(kind: &str, scene: &Scene, ray: &Ray, found: &[SceneHit], truth: &[Truth]) -> bool {
    assert_eq!(found.len(), truth.len(), "{kind}: {ray:?}");
    let placement = &scene.objects()[0].placement;
    for (found, truth) in found.iter().zip(truth) {
        let normal = truth.normal.normalize();
        let cos = normal.dot(ray.direction);
        let reach = ray.origin.distance(placement.point_to_world(DVec3::ZERO)) + truth.t;
        let error = (found.hit.t - truth.t).abs();
        assert!(
            error <= 1e-13 * reach / cos.abs(),
            "{kind}: t is off by {error} of {reach}"
        );
        assert_near(placement.normal_to_world(found.hit.normal), normal, 1e-10);
        assert_eq!(found.hit.front, cos < 0.0, "{kind}: front or back");
        assert!(ray.contains(found.hit.t));
    }
    // The nearest is the first of all.
    assert_eq!(
        pick::closest(scene, ray, Sides::Both).as_ref(),
        found.first()
    );
    !found.is_empty()
}

#[test]
fn spheres_and_ellipsoids() {
    for (kind, model) in placements() {
        let scene = scene_of(Shape::Sphere, model);
        // In world space the surface is (p - c)^T Q (p - c) = r^2 with Q = (M M^T)^-1.
        let q = (model.matrix3 * model.matrix3.transpose()).inverse();
        let mut hits = 0;
        for ray in rays(model, 21) {
            let from_center = ray.origin - model.translation;
            let (a, b, c) = (
                ray.direction.dot(q * ray.direction),
                from_center.dot(q * ray.direction),
                from_center.dot(q * from_center) - 0.25,
            );
            let discriminant = b * b - a * c;
            if discriminant.abs() <= 1e-2 * b * b {
                // Near the outline the closed form is less accurate than the tested code, so exact arithmetic decides.
                rims::as_exact(&scene, &ray);
                continue;
            }
            let root = discriminant.max(0.0).sqrt();
            let roots = [(-b - root) / a, (-b + root) / a];
            let in_front = roots
                .into_iter()
                .filter(|t| discriminant > 0.0 && *t >= 0.0);
            let truth: Vec<_> = in_front
                .map(|t| Truth {
                    t,
                    normal: q * (from_center + t * ray.direction),
                })
                .collect();
            let found = pick::all(&scene, ray, Sides::Both);
            hits += usize::from(same_hits(kind, &scene, &ray, &found, &truth));
            for hit in &found {
                let local = scene.objects()[0]
                    .placement
                    .ray_to_object(&ray)
                    .at(hit.hit.t);
                assert_close(local.length(), Sphere::RADIUS, 1e-12);
                assert_near(hit.hit.normal, local, 1e-15);
            }
        }
        assert!(hits > 150, "{kind}: only {hits} rays hit");
    }
}

#[test]
fn cubes_and_boxes() {
    for (kind, model) in placements() {
        let scene = scene_of(Shape::Cube, model);
        // The six faces as planes in world space; the normals by cofactors, which need the determinant's sign.
        let DMat3 {
            x_axis: x,
            y_axis: y,
            z_axis: z,
        } = model.matrix3;
        let sign = model.matrix3.determinant().signum();
        let planes = [(x, y.cross(z)), (y, z.cross(x)), (z, x.cross(y))].into_iter();
        let planes: Vec<_> = planes
            .flat_map(|(axis, normal)| [(0.5 * axis, sign * normal), (-0.5 * axis, -sign * normal)])
            .collect();
        let mut hits = 0;
        for ray in rays(model, 22) {
            let from_center = ray.origin - model.translation;
            let mut enter = Truth {
                t: f64::NEG_INFINITY,
                normal: DVec3::ZERO,
            };
            let mut leave = Truth {
                t: f64::INFINITY,
                normal: DVec3::ZERO,
            };
            for &(on_face, normal) in &planes {
                let along = normal.dot(ray.direction);
                let t = normal.dot(on_face - from_center) / along;
                if along < 0.0 && t > enter.t {
                    enter = Truth { t, normal };
                } else if along > 0.0 && t < leave.t {
                    leave = Truth { t, normal };
                }
            }
            if (enter.t - leave.t).abs() <= 1e-3 * leave.t.abs() {
                // Through an edge, or nearly.
                rims::as_exact(&scene, &ray);
                continue;
            }
            let truth: Vec<_> = [enter, leave].into_iter().collect();
            let passes = truth[0].t > truth[1].t;
            let truth: Vec<_> = truth
                .into_iter()
                .filter(|hit| !passes && hit.t >= 0.0)
                .collect();
            let found = pick::all(&scene, ray, Sides::Both);
            hits += usize::from(same_hits(kind, &scene, &ray, &found, &truth));
        }
        assert!(hits > 150, "{kind}: only {hits} rays hit");
    }
}

#[test]
fn a_cube_is_its_twelve_triangles() {
    let mesh = common::box_mesh();
    let mut hits = 0;
    for (kind, model) in placements() {
        let cube = scene_of(Shape::Cube, model);
        let triangles = scene_of(
            Shape::Mesh {
                mesh: mesh.clone(),
                part: 0,
            },
            model,
        );
        for ray in rays(model, 23) {
            let ours = pick::all(&cube, ray, Sides::Both);
            let theirs = pick::all(&triangles, ray, Sides::Both);
            if ours.len() == 2 && (ours[1].hit.t - ours[0].hit.t) <= 1e-3 * ours[1].hit.t {
                rims::as_exact(&cube, &ray);
                rims::as_exact(&triangles, &ray);
                continue;
            }
            assert_eq!(ours.len(), theirs.len(), "{kind}: {ray:?}");
            for (ours, theirs) in ours.iter().zip(&theirs) {
                let cos = ours.hit.normal.dot(
                    cube.objects()[0]
                        .placement
                        .ray_to_object(&ray)
                        .direction
                        .normalize(),
                );
                assert_close(ours.hit.t, theirs.hit.t, 1e-12 / cos.abs());
                assert_near(ours.hit.normal, theirs.hit.normal, 1e-15);
                hits += 1;
            }
        }
    }
    assert!(hits > 4000, "only {hits} hits");
}

#[test]
fn squares_and_triangles() {
    // The half of the square below its diagonal.
    let corners = [[-0.5, -0.5, 0.0], [0.5, -0.5, 0.0], [-0.5, 0.5, 0.0_f32]];
    let mesh = mesh(corners.to_vec(), vec![[0, 1, 2]], DVec3::ZERO);
    for (kind, model) in placements() {
        let square = scene_of(Shape::Square, model);
        let triangle = scene_of(
            Shape::Mesh {
                mesh: mesh.clone(),
                part: 0,
            },
            model,
        );
        let DMat3 {
            x_axis: x,
            y_axis: y,
            ..
        } = model.matrix3;
        // The inverse transpose times (0, 0, 1): the cross product of the sides, with its sign flipped by mirroring.
        let normal = model.matrix3.determinant().signum() * x.cross(y);
        let mut hits = [0, 0];
        for ray in rays(model, 24) {
            // Cramer: origin + t d = c + u x + v y.
            let from_center = ray.origin - model.translation;
            let solved = DMat3::from_cols(x, y, -ray.direction).inverse() * from_center;
            let (u, v, t) = (solved.x, solved.y, solved.z);
            let rim = (u.abs() - 0.5).abs().min((v.abs() - 0.5).abs());
            if rim < 1e-6 || (u + v).abs() < 1e-6 {
                rims::as_exact(&square, &ray);
                rims::as_exact(&triangle, &ray);
                continue;
            }
            let truth = |inside: bool| {
                let hit = (inside && t >= 0.0).then_some(Truth { t, normal });
                hit.into_iter().collect::<Vec<_>>()
            };
            let inside = u.abs() < 0.5 && v.abs() < 0.5;
            let found = pick::all(&square, ray, Sides::Both);
            hits[0] += usize::from(same_hits(kind, &square, &ray, &found, &truth(inside)));

            let found = pick::all(&triangle, ray, Sides::Both);
            let inside = inside && u + v < 0.0;
            if same_hits(kind, &triangle, &ray, &found, &truth(inside)) {
                hits[1] += 1;
                let at = found[0].hit.on_triangle.unwrap();
                let expected = dvec3(-u - v, u + 0.5, v + 0.5);
                assert!((DVec3::from(at.barycentric) - expected).abs().max_element() <= 1e-8);
                assert_close(at.barycentric.iter().sum(), 1.0, 1e-15);
            }
        }
        assert!(
            hits[0] > 60 && hits[1] > 30,
            "{kind}: only {hits:?} rays hit"
        );
    }
}

#[test]
fn matrices_without_an_inverse_are_refused() {
    let rows =
        |rows: [[f64; 3]; 3]| DAffine3::from_mat3(DMat3::from_cols_array_2d(&rows).transpose());
    let turned = DMat3::from_rotation_z(0.3) * DMat3::from_rotation_x(1.0);
    let flat = |x, y, z| DMat3::from_diagonal(dvec3(x, y, z));
    let singular = [
        rows([[0.0; 3]; 3]),
        DAffine3::from_scale(dvec3(1.0, 0.0, 1.0)),
        DAffine3::from_mat3(turned * flat(0.0, 1.0, 1.0)),
        // Rank 2.
        rows([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]]),
        rows([[0.1, 0.3, 0.6], [0.2, 0.6, 1.2], [0.7, 0.8, 0.9]]),
        // Its inverse is beyond the range of numbers; so small entries count as 0.
        DAffine3::from_mat3(flat(1e-33, 1.0, 1.0) * DMat3::from_diagonal(dvec3(0.5, 1.0, 1.0))),
        DAffine3::from_scale(DVec3::splat(1e-34)),
    ];
    for model in singular {
        assert_eq!(
            Placement::new(model),
            Err(PlacementError::Singular),
            "{model:?}"
        );
    }
    for bad in [f64::NAN, f64::INFINITY, -1.3e33] {
        let mut model = DAffine3::IDENTITY;
        model.translation.y = bad;
        assert_eq!(Placement::new(model), Err(PlacementError::OutOfRange));
        let mut model = DAffine3::IDENTITY;
        model.matrix3.y_axis.x = bad;
        assert_eq!(Placement::new(model), Err(PlacementError::OutOfRange));
    }
    // Small entries are stored as 0.
    let mut model = DAffine3::IDENTITY;
    (model.translation.y, model.matrix3.y_axis.x) = (1.2e33, -7e-34);
    let stored = Placement::new(model).expect("an inverse").model();
    assert_eq!(
        (stored.translation.y, stored.matrix3.y_axis.x),
        (1.2e33, 0.0)
    );
    // A matrix is accepted if only rounding keeps it from being singular.
    let nearly = rows([[0.1, 0.2, 0.3], [0.4, 0.5, 0.6], [0.7, 0.8, 0.9]]);
    assert!(Placement::new(nearly).is_ok());
    // Very flat, small and large matrices have an inverse, accurate relative to each row's length.
    let (turned_back, flattened) = (turned.transpose(), flat(1e-12, 1.0, 1e12));
    let stretched = flat(1e12, 1.0, 1e-12);
    for (linear, expected) in [
        (flat(1e-30, 1e-30, 1e-30), flat(1e30, 1e30, 1e30)),
        (flat(1e30, 1e30, 1e30), flat(1e-30, 1e-30, 1e-30)),
        (turned * flattened, stretched * turned_back),
        (flattened * turned, turned_back * stretched),
    ] {
        let placement = Placement::new(DAffine3::from_mat3(linear)).expect("an inverse");
        let inverse = placement.inverse_linear();
        for axis in 0..3 {
            let (row, expected) = (inverse.row(axis), expected.row(axis));
            let off = (row - expected).abs().max_element();
            assert!(off <= 1e-14 * expected.length(), "{inverse}");
        }
    }
}

#[test]
fn what_is_hit_does_not_depend_on_the_scale() {
    for exponent in [-12, -6, -3, 0, 3, 6, 12] {
        let scale = 10_f64.powi(exponent);
        for (shape, expected) in [(Shape::Sphere, 2), (Shape::Cube, 2), (Shape::Square, 1)] {
            let scene = scene_of(shape, DAffine3::from_scale(DVec3::splat(scale)));
            let ray = ray_to(scale * dvec3(0.3, 0.4, 3.0), scale * dvec3(0.01, 0.02, 0.0));
            let hits = pick::all(&scene, ray, Sides::Both);
            assert_eq!(hits.len(), expected, "at 1e{exponent}");
        }
    }
}
