//! A mesh's tree finds the hits of brute force. Ties go to the lower index. Hidden parts, culled sides and triangles
//! without area are never hit.
#![cfg(feature = "window")]

mod common;

use common::{Random, mesh, placements, ray_to, scene_of};
use glam::{DAffine3, DVec3, dvec3};
use sightline::{
    geometry::{
        Aabb, ColourRun, Mesh, MeshData, Part, Placement, Ray, Sides, VertexRay, hit_guarded,
    },
    pick::{self, SceneHit},
    scene::{Object, Scene, Shape},
};
use std::sync::Arc;

/// Triangles anywhere in a cube: small, large, overlapping, and strips that share their corners.
fn soup(seed: u64, scale: f64) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
    let mut random = Random::new(seed);
    let mut positions = Vec::new();
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    for _ in 0..400 {
        let (center, size) = (random.point(1.0), 10_f64.powf(random.within(-3.0, 0.0)));
        let first = u32::try_from(positions.len()).unwrap();
        for _ in 0..6 {
            positions.push((scale * (center + random.point(size))).as_vec3().to_array());
        }
        triangles.extend((first..first + 4).map(|i| [i, i + 1, i + 2]));
    }
    (positions, triangles)
}

#[test]
fn the_tree_finds_what_brute_force_finds() {
    for (seed, scale, offset) in [
        (31, 1.0, 0.0),
        (32, 1e-6, 0.0),
        (33, 1e6, 0.0),
        (34, 1.0, 1e3),
    ] {
        let (positions, triangles) = soup(seed, scale);
        let origin = DVec3::splat(offset);
        let brute = mesh(positions.clone(), triangles.clone(), origin);
        let with_tree = mesh(positions, triangles.clone(), origin);
        with_tree.build_tree();
        let mut random = Random::new(seed);
        let (mut hit, mut missed) = (0, 0);
        for i in 0..2000_usize {
            let far = [0.5, 3.0, 1e3][i % 3];
            let eye = origin + scale * random.point(far);
            let triangle = u32::try_from(i % triangles.len()).unwrap();
            let [a, b, c] = brute.corners(triangle);
            // Anywhere, at a triangle, at an edge, at a corner, along an axis.
            let mut ray = match i % 5 {
                0 => ray_to(eye, origin + scale * random.point(1.0)),
                1 => ray_to(eye, (a + b + c) / 3.0),
                2 => ray_to(eye, a.lerp(b, random.unit())),
                3 => ray_to(eye, c),
                _ => Ray {
                    direction: DVec3::AXES[i / 5 % 3],
                    ..ray_to(a - scale * DVec3::AXES[i / 5 % 3], a)
                },
            };
            if i % 7 == 0 {
                (ray.t_min, ray.t_max) = (0.3 * scale, 1.5 * scale);
            }
            for sides in [Sides::Both, Sides::Front] {
                let expected = brute.all(&ray, sides, |_| true);
                assert_eq!(
                    with_tree.all(&ray, sides, |_| true),
                    expected,
                    "ray {i} of seed {seed}"
                );
                for mesh in [&brute, &with_tree] {
                    let closest = mesh.closest(&ray, sides, |_| true);
                    assert_eq!(closest.as_ref(), expected.first(), "ray {i} of seed {seed}");
                }
                if expected.is_empty() {
                    missed += 1;
                } else {
                    hit += 1;
                }
            }
        }
        assert!(
            hit > 2000 && missed > 200,
            "seed {seed}: {hit} hit, {missed} missed"
        );
    }
}

#[test]
fn of_equal_hits_the_lower_object_and_the_lower_triangle_win() {
    let corners = vec![[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, 0.0_f32]];
    // Enough copies of one triangle that a tree is built.
    let many = mesh(corners, vec![[0, 1, 2]; 600], DVec3::ZERO);
    // A scene of 5 objects has no tree, one of 20 has. Every third object is larger, so that it is first or last there.
    let scene = |shape: &Shape, count: i32| {
        let objects = (0..count).map(|i| {
            let size = if i % 3 == 0 { 8.0 } else { 1.0 };
            let model = DAffine3::from_scale(dvec3(size, size, 1.0));
            Object::new(i.to_string(), shape.clone(), Placement::new(model).unwrap())
        });
        let mut scene = Scene::new(objects.collect());
        scene.set_visible(0, false);
        scene
    };
    // From before the triangle, from its plane and from behind it.
    let rays = [3.0, 0.0, -1.0].map(|z| Ray {
        t_min: -2.0,
        direction: DVec3::NEG_Z,
        ..ray_to(dvec3(0.1, 0.2, z), DVec3::ZERO)
    });
    for (with_tree, count) in [(false, 5), (true, 5), (false, 20), (true, 20)] {
        let scene = scene(
            &Shape::Mesh {
                mesh: many.clone(),
                part: 0,
            },
            count,
        );
        if with_tree {
            scene.build_trees();
        }
        for ray in rays {
            let case = format!("{count} objects, z = {}", ray.origin.z);
            let hit = pick::closest(&scene, ray, Sides::Both).expect(&case);
            let surface = |hit: &SceneHit| (hit.object, hit.hit.on_triangle.unwrap().triangle);
            let hits = pick::all(&scene, ray, Sides::Both);
            let order: Vec<_> = hits.iter().map(surface).collect();
            let objects = 1..usize::try_from(count).unwrap();
            let expected = objects.flat_map(|object| (0..600).map(move |i| (object, i)));
            assert!(order == expected.collect::<Vec<_>>(), "{case}");
            assert_eq!(surface(&hit), (1, 0), "{case}");
        }
    }
    for shape in [Shape::Cube, Shape::Square] {
        for (count, ray) in [5, 20]
            .into_iter()
            .flat_map(|count| rays.map(|ray| (count, ray)))
        {
            let hit = pick::closest(&scene(&shape, count), ray, Sides::Both).unwrap();
            assert_eq!(hit.object, 1, "{count} of {shape:?}, z = {}", ray.origin.z);
        }
    }
}

/// Three squares of two triangles each, one behind the other, as three parts of a mesh.
fn three_parts() -> Arc<Mesh> {
    let positions = (0..12_u8).map(|i| {
        let (layer, corner) = (i / 4, i % 4);
        let (x, y) = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)][usize::from(corner)];
        [x, y, -f32::from(layer)]
    });
    let triangles = (0..3).flat_map(|layer| {
        let first = 4 * layer;
        [[first, first + 1, first + 2], [first, first + 2, first + 3]]
    });
    let part = |i: u32| Part {
        name: format!("part {i}"),
        triangles: 2 * i..2 * i + 2,
    };
    let data = MeshData {
        positions: positions.collect(),
        triangles: triangles.collect(),
        parts: (0..3).map(part).collect(),
        colours: vec![ColourRun {
            triangles: 0..6,
            colour: None,
            material: None,
        }],
        ..MeshData::default()
    };
    Arc::new(Mesh::new(data).unwrap())
}

#[test]
fn what_is_hidden_is_never_hit() {
    let mesh = three_parts();
    let object = |part| {
        Object::new(
            "",
            Shape::Mesh {
                mesh: mesh.clone(),
                part,
            },
            Placement::IDENTITY,
        )
    };
    let analytic = [Shape::Sphere, Shape::Cube, Shape::Square].map(|shape| {
        let model = DAffine3::from_translation(dvec3(0.0, 0.0, -9.0));
        Object::new("", shape, Placement::new(model).unwrap())
    });
    let mut scene = Scene::new((0..3).map(object).chain(analytic).collect());
    assert_eq!(scene.batches().len(), 4, "the parts are asked as one");
    let ray = ray_to(dvec3(0.3, 0.1, 3.0), dvec3(0.3, 0.1, 0.0));
    for hidden in 0..64_usize {
        for object in 0..6 {
            scene.set_visible(object, hidden >> object & 1 == 0);
        }
        let visible = |object: &usize| hidden >> object & 1 == 0;
        let mut expected: Vec<_> = (0..6).filter(visible).collect();
        let mut found: Vec<_> = pick::all(&scene, ray, Sides::Both)
            .iter()
            .map(|hit| hit.object)
            .collect();
        // Sphere, cube and square overlap; their order is not tested here.
        found.sort_unstable();
        found.dedup();
        assert_eq!(found, expected);
        expected.truncate(1);
        let closest = pick::closest(&scene, ray, Sides::Both).map(|hit| hit.object);
        if expected.first().is_none_or(|&first| first < 3) {
            assert_eq!(closest, expected.first().copied());
        } else {
            assert!(visible(&closest.unwrap()));
        }
    }
}

#[test]
fn a_part_that_is_no_object_is_never_hit() {
    let mesh = three_parts();
    let middle = Object::new("middle", Shape::Mesh { mesh, part: 1 }, Placement::IDENTITY);
    let ray = ray_to(dvec3(0.3, 0.1, 3.0), dvec3(0.3, 0.1, 0.0));
    let hits = pick::all(&Scene::new(vec![middle]), ray, Sides::Both);
    assert_eq!(hits.len(), 1);
    assert_eq!((hits[0].object, hits[0].hit.t), (0, 4.0));
}

#[test]
fn culling_hides_what_is_seen_from_behind() {
    let triangle = mesh(
        vec![[-0.5, -0.5, 0.0], [0.5, -0.5, 0.0], [0.0, 0.5, 0.0]],
        vec![[0, 1, 2]],
        DVec3::ZERO,
    );
    let shapes = [
        Shape::Sphere,
        Shape::Cube,
        Shape::Square,
        Shape::Mesh {
            mesh: triangle,
            part: 0,
        },
    ];
    for (kind, model) in placements() {
        for shape in &shapes {
            let scene = scene_of(shape.clone(), model);
            let closed = matches!(shape, Shape::Sphere | Shape::Cube);
            for (z, from_front) in [(2.0, true), (-2.0, false)] {
                let [eye, target] = [dvec3(0.05, -0.1, z), dvec3(0.05, -0.1, 0.0)];
                let ray = ray_to(model.transform_point3(eye), model.transform_point3(target));
                let both = pick::all(&scene, ray, Sides::Both).len();
                assert_eq!(both, if closed { 2 } else { 1 }, "{kind} {shape:?}");
                let front = pick::all(&scene, ray, Sides::Front);
                let expected = usize::from(closed || from_front);
                assert_eq!(front.len(), expected, "{kind} {shape:?} from z = {z}");
                assert_eq!(
                    pick::closest(&scene, ray, Sides::Front).as_ref(),
                    front.first()
                );
            }
            // From inside, a closed shape shows nothing.
            let inside = ray_to(
                model.translation,
                model.transform_point3(dvec3(0.1, 0.2, 1.0)),
            );
            if closed {
                assert_eq!(pick::all(&scene, inside, Sides::Both).len(), 1);
                assert_eq!(pick::closest(&scene, inside, Sides::Front), None);
            }
        }
    }
}

#[test]
fn triangles_without_area_are_never_hit() {
    let mut random = Random::new(36);
    let mut tried = 0;
    for _ in 0..2000 {
        let (a, step) = (
            random.point(1.0).as_vec3().as_dvec3(),
            random.point(1.0).as_vec3().as_dvec3(),
        );
        // A point, a segment, and three points of a line (small multiples are exact).
        let flat = [
            [a, a, a],
            [a, a, step],
            [a, step, a],
            [step, a, a],
            [step, 2.0 * step, 4.0 * step],
        ];
        for corners in flat {
            let target = corners[0].lerp(corners[2], random.unit());
            for ray in [
                ray_to(random.point(3.0), target),
                ray_to(target - step, target),
            ] {
                assert_eq!(
                    hit_guarded(&VertexRay::exact(ray), corners),
                    None,
                    "{ray:?} {corners:?}"
                );
                tried += 1;
            }
        }
        // A ray in a triangle's plane does not hit it either.
        let (b, c) = (a + DVec3::X, a + DVec3::Y);
        let within = Ray {
            direction: dvec3(1.0, 0.5, 0.0),
            ..ray_to(a - DVec3::X, a)
        };
        assert_eq!(hit_guarded(&VertexRay::exact(within), [a, b, c]), None);
    }
    assert_eq!(tried, 20_000);
    for bad in [f64::NAN, f64::INFINITY] {
        let corners = [dvec3(bad, 0.0, 0.0), DVec3::Y, DVec3::X];
        assert_eq!(
            hit_guarded(&VertexRay::exact(ray_to(DVec3::Z, DVec3::ZERO)), corners),
            None
        );
    }
}

#[test]
fn each_level_of_boxes_holds_every_triangle() {
    // A flat grid.
    let side = 40_u16;
    let positions = (0..=side).flat_map(|y| (0..=side).map(move |x| [x.into(), y.into(), 0.0]));
    let row = u32::from(side) + 1;
    let cells = (0..row - 1).flat_map(|y| (0..row - 1).map(move |x| y * row + x));
    let triangles = cells.flat_map(|a| [[a, a + 1, a + row], [a + 1, a + row + 1, a + row]]);
    let mesh = mesh(positions.collect(), triangles.collect(), 1000.0 * DVec3::X);
    let count = u32::try_from(mesh.data().triangles.len()).unwrap();
    assert!(mesh.tree_boxes(0, 9).is_empty(), "no tree yet");
    mesh.build_tree();
    let mut boxes_before = 0;
    for level in 0..6 {
        let boxes = mesh.tree_boxes(level, 1000);
        assert!(boxes.len() >= boxes_before, "{level}");
        boxes_before = boxes.len();
        for triangle in 0..count {
            let corners = mesh.corners(triangle);
            let holds = |bounds: &Aabb| {
                let inside = |c: &DVec3| c.cmpge(bounds.min).all() && c.cmple(bounds.max).all();
                corners.iter().all(inside)
            };
            assert!(boxes.iter().any(holds), "{triangle} at {level}");
        }
    }
    assert_eq!(mesh.tree_boxes(0, 9)[0], mesh.part_bounds(0));
    assert!(boxes_before > 8, "{boxes_before}");
    assert_eq!(mesh.tree_boxes(5, 7).len(), 7, "no more than asked for");
}
