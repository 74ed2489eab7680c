//! A scene of many objects gives the same hits as each object alone. A ray tests few of them.
#![cfg(feature = "window")]

mod common;

use common::Random;
use glam::{DAffine3, DMat3, DVec3};
use sightline::{
    geometry::{Aabb, Placement, Ray, Sides},
    pick::{self, SceneHit},
    scene::{Object, Scene, Shape},
};

/// Spheres, cubes, squares and meshes scattered over a cube of this half side about `center`. Their model matrices
/// turn, shear and mirror, and stretch or shrink by up to `stretch`.
fn scattered(count: usize, center: DVec3, half_side: f64, stretch: f64) -> Scene {
    let mut random = Random::new(7);
    let corners = vec![[-0.5, -0.5, 0.0], [0.5, -0.5, 0.0], [-0.5, 0.5, 0.0]];
    let mesh = common::mesh(corners, vec![[0, 1, 2]], DVec3::ZERO);
    let objects = (0..count).map(|i| {
        let shape = match i % 4 {
            0 => Shape::Sphere,
            1 => Shape::Cube,
            2 => Shape::Square,
            _ => Shape::Mesh {
                mesh: mesh.clone(),
                part: 0,
            },
        };
        let turn = |random: &mut Random| {
            DMat3::from_axis_angle(random.direction(), random.within(0.0, 6.0))
        };
        let mut scale = DVec3::from(random.point(1.0).to_array().map(|s| stretch.powf(s)));
        if i % 3 == 0 {
            scale.x = -scale.x;
        }
        let model = DAffine3 {
            matrix3: turn(&mut random) * DMat3::from_diagonal(scale) * turn(&mut random),
            translation: center + random.point(half_side),
        };
        Object::new(
            i.to_string(),
            shape,
            Placement::new(model).expect("invertible"),
        )
    });
    Scene::new(objects.collect())
}

/// Each object as a scene of its own.
fn alone(scene: &Scene) -> Vec<Scene> {
    let objects = scene.objects().iter();
    objects
        .map(|object| Scene::new(vec![object.clone()]))
        .collect()
}

/// All hits, with each object intersected by itself.
fn one_by_one(alone: &[Scene], ray: &Ray) -> Vec<SceneHit> {
    let each = alone.iter().enumerate().flat_map(|(object, scene)| {
        let hits = pick::all(scene, ray, Sides::Both).into_iter();
        hits.map(move |hit| SceneHit { object, ..hit })
    });
    let mut hits: Vec<SceneHit> = each.collect();
    hits.sort_by(|a, b| a.hit.t.total_cmp(&b.hit.t).then(a.object.cmp(&b.object)));
    hits
}

/// A point where rounding could decide: a corner, an edge or the rim of an object, in its space.
fn critical(random: &mut Random, shape: &Shape) -> DVec3 {
    let [x, y, z] = std::array::from_fn(|_| match random.within(0.0, 3.0) {
        0.0..1.0 => -0.5,
        1.0..2.0 => 0.5,
        _ => random.within(-0.5, 0.5),
    });
    match shape {
        Shape::Sphere => 0.5 * random.direction(),
        Shape::Cube => DVec3::new(x, y, z),
        Shape::Square | Shape::Mesh { .. } => DVec3::new(x, y, 0.0),
    }
}

/// Rays at critical points of the objects: past the surface, along an axis, in any direction. Some start at the point.
fn rays(scene: &Scene, count: usize, distance: f64) -> Vec<Ray> {
    let mut random = Random::new(11);
    let objects = scene.objects();
    (0..count)
        .map(|i| {
            let object = &objects[i % objects.len()];
            let on_object = critical(&mut random, &object.shape);
            let to = object.placement.point_to_world(on_object);
            let direction = match i % 3 {
                // Just past a sphere: across its normal there.
                0 => {
                    let normal = object.placement.normal_to_world(on_object);
                    random.direction().cross(normal).normalize_or(DVec3::X)
                }
                1 => DVec3::AXES[i % 7 % 3] * if i % 2 == 0 { 1.0 } else { -1.0 },
                _ => random.direction(),
            };
            // From a surface, or so far away that the distance rounds.
            let back = if i % 5 == 0 {
                0.0
            } else {
                distance * random.unit()
            };
            let (origin, direction) = (to - back * direction, -0.0 + direction);
            Ray {
                origin,
                direction,
                t_min: 0.0,
                t_max: f64::INFINITY,
            }
        })
        .collect()
}

#[test]
fn many_objects_answer_as_each_alone() {
    let mut hits = 0;
    for (center, half_side, stretch, distance) in [
        (DVec3::ZERO, 12.0, 2.0, 30.0),
        (DVec3::ZERO, 6.0, 1000.0, 1e4),
        (DVec3::new(447_000.0, 5_350_000.0, 300.0), 12.0, 2.0, 1e3),
        (DVec3::ZERO, 12.0, 2.0, 1e9),
        (DVec3::new(1e9, -1e9, 1e9), 1e6, 300.0, 1e10),
    ] {
        let scene = scattered(200, center, half_side, stretch);
        let alone = alone(&scene);
        for ray in rays(&scene, 3000, distance) {
            let expected = one_by_one(&alone, &ray);
            assert_eq!(pick::all(&scene, ray, Sides::Both), expected, "{ray:?}");
            let closest = pick::closest(&scene, ray, Sides::Both);
            assert_eq!(closest.as_ref(), expected.first(), "{ray:?}");
            hits += expected.len();
        }
    }
    assert!(hits > 15_000, "{hits}");
}

#[test]
fn hidden_objects_and_interval_ends_count() {
    let mut scene = scattered(100, DVec3::ZERO, 5.0, 2.0);
    let mut seen = 0;
    for index in 0..100 {
        scene.set_visible(index, index % 2 == 0);
    }
    let alone = alone(&scene);
    for (i, ray) in rays(&scene, 2000, 20.0).into_iter().enumerate() {
        let whole = one_by_one(&alone, &ray);
        // The interval begins or ends exactly on a hit.
        let Some(hit) = whole.get(i % 3) else {
            continue;
        };
        for ray in [
            Ray {
                t_min: hit.hit.t,
                ..ray
            },
            Ray {
                t_max: hit.hit.t,
                ..ray
            },
        ] {
            let expected = one_by_one(&alone, &ray);
            assert_eq!(pick::all(&scene, ray, Sides::Both), expected, "{ray:?}");
            assert!(expected.iter().all(|hit| hit.object % 2 == 0));
            seen += expected.len();
        }
    }
    assert!(seen > 500, "{seen}");
}

#[test]
fn of_thousands_few_are_asked() {
    // A city: 3,000 houses on a plain.
    let mut random = Random::new(3);
    let house = |_| {
        let height = random.within(5.0, 40.0);
        let model = DAffine3 {
            matrix3: DMat3::from_diagonal(DVec3::new(8.0, height, 8.0)),
            translation: DVec3::new(
                random.within(-600.0, 600.0),
                0.5 * height,
                random.within(-600.0, 600.0),
            ),
        };
        Object::new(
            "house",
            Shape::Cube,
            Placement::new(model).expect("invertible"),
        )
    };
    let scene = Scene::new((0..3000).map(house).collect());
    let rays = rays(&scene, 3000, 2000.0);
    let (mut asked, mut hit) = (0, 0);
    for ray in &rays {
        let closest = pick::closest(&scene, ray, Sides::Both);
        hit += usize::from(closest.is_some());
        let end = closest.map_or(f64::INFINITY, |hit| hit.hit.t);
        scene.visit_batches(&ray.into(), |_| {
            asked += 1;
            end
        });
    }
    assert!(hit > 1500, "{hit}");
    assert!(asked < 20 * rays.len(), "{asked} for {} rays", rays.len());
}

#[test]
fn degenerate_scenes_are_searched_too() {
    // All at one place, flat, and far apart by twelve orders of magnitude.
    let at = |x: f64, size: f64| {
        let model = DAffine3 {
            matrix3: DMat3::from_diagonal(DVec3::splat(size)),
            translation: DVec3::X * x,
        };
        Object::new(
            "",
            Shape::Square,
            Placement::new(model).expect("invertible"),
        )
    };
    let ray = |x: f64, z: f64| Ray {
        origin: DVec3::new(x, 0.0, z),
        direction: DVec3::new(-0.0, 0.0, -1.0),
        t_min: -2.0,
        t_max: f64::INFINITY,
    };
    // Objects of one size, and of many sizes, so that the tree has the last ones first.
    let sizes = [|_| 1.0, |i| f64::from(1 + 29 * i % 64)];
    for size in sizes {
        let same = Scene::new((0..64_u32).map(|i| at(0.0, size(i))).collect());
        // Before them, on them, behind them, and from far away.
        for z in [1.0, 0.0, -1.0, 1e9] {
            let ray = ray(0.1, z);
            let hits = pick::all(&same, ray, Sides::Both);
            assert_eq!(hits.len(), 64, "z = {z}");
            assert!(hits.is_sorted_by_key(|hit| hit.object), "z = {z}");
            let closest = pick::closest(&same, ray, Sides::Both);
            assert_eq!(closest.map(|hit| hit.object), Some(0), "z = {z}");
        }
    }
    let apart = Scene::new(
        (-30..30)
            .map(|i| at(10_f64.powi(i / 3), 10_f64.powi(i / 3)))
            .collect(),
    );
    let alone = alone(&apart);
    for i in -30..30 {
        let ray = ray(1.2 * 10_f64.powi(i / 3), 1.0);
        let expected = one_by_one(&alone, &ray);
        assert!(!expected.is_empty());
        assert_eq!(pick::all(&apart, ray, Sides::Both), expected);
    }
}

#[test]
fn what_was_moved_is_found_where_it_is() {
    let mut scene = scattered(50, DVec3::ZERO, 5.0, 2.0);
    let far = DVec3::new(100.0, 0.0, 0.0);
    scene.place(
        0,
        Placement::new(DAffine3::from_translation(far)).expect("invertible"),
    );
    let ray = Ray {
        origin: far + DVec3::Z,
        direction: DVec3::NEG_Z,
        t_min: 0.0,
        t_max: f64::INFINITY,
    };
    let hit = pick::closest(&scene, ray, Sides::Both).expect("the sphere");
    assert_eq!((hit.object, hit.hit.t), (0, 0.5));
}

/// Boxes and counts equal those computed anew from each object.
fn holds_its_sums(scene: &Scene) {
    let (mut all, mut visible, mut hidden) = (Aabb::EMPTY, Aabb::EMPTY, 0);
    for object in scene.objects().iter() {
        let bounds = object.bounds_world();
        all = all.union(bounds);
        if object.visible {
            visible = visible.union(bounds);
        } else {
            hidden += 1;
        }
    }
    assert_eq!(scene.bounds(), all);
    assert_eq!(scene.visible_bounds(), visible);
    assert_eq!(scene.hidden_count(), hidden);
}

/// Indices need no order, and an object that occurs twice stays as it was.
#[test]
fn many_objects_are_toggled_as_one_by_one() {
    let count = 9_000;
    let mut scene = scattered(count, DVec3::ZERO, 8.0, 2.0);
    scene.toggle(&(0..count).step_by(3).collect::<Vec<_>>());
    holds_its_sums(&scene);
    let before = scene.clone();
    let objects: Vec<_> = (0..count - 100)
        .map(|i| i * 7 % count)
        .chain([8300, 8300])
        .collect();
    scene.toggle(&objects);
    holds_its_sums(&scene);
    let times = |object| objects.iter().filter(|other| **other == object).count();
    assert_eq!(times(8300), 2);
    for object in (0..count).step_by(13).chain([8300]) {
        let [was, is] = [&before, &scene].map(|scene| scene.objects()[object].visible);
        assert_eq!(was != is, times(object) % 2 == 1, "object {object}");
    }
}

/// The derived data of a scene follows its objects: boxes, counts, the tree.
#[test]
fn a_scene_whose_objects_were_changed_is_as_one_made_of_them() {
    let mut random = Random::new(3);
    let mut scene = scattered(1300, DVec3::ZERO, 8.0, 2.0);
    for i in 0..200 {
        let object = (i * 37) % 1300;
        let moved = i % 4 != 0;
        if moved {
            let by = DAffine3::from_translation(random.point(9.0));
            let model = by * scene.objects()[object].placement.model();
            scene.place(object, Placement::new(model).expect("invertible"));
        } else if scene.objects()[object].visible == (i % 8 == 0) {
            scene.set_visible(object, i % 8 == 0);
        } else {
            let hidden = scene.hidden_count();
            scene.toggle(&[object]);
            assert_eq!(hidden.abs_diff(scene.hidden_count()), 1);
        }
    }
    let fresh = Scene::new(scene.objects().to_vec());
    holds_its_sums(&scene);
    assert!(scene.hidden_count() > 10);
    assert_eq!(scene.triangle_count(), 325);
    // Toggles all objects and runs of them, which are hidden, shown or mixed.
    let mut turned = scene.clone();
    for range in [0..1300, 0..600, 500..1024, 600..1300, 0..1300] {
        turned.toggle(&range.collect::<Vec<_>>());
        holds_its_sums(&turned);
    }
    let shown: Vec<usize> = (0..1300).filter(|i| turned.objects()[*i].visible).collect();
    turned.toggle(&shown);
    holds_its_sums(&turned);
    assert!(turned.visible_bounds().is_empty());
    turned.toggle(&(0..1300).collect::<Vec<_>>());
    holds_its_sums(&turned);
    assert_eq!(turned.visible_bounds(), turned.bounds());
    let mut hits = 0;
    for ray in rays(&scene, 3000, 20.0) {
        let found = pick::closest(&scene, ray, Sides::Both);
        assert_eq!(found, pick::closest(&fresh, ray, Sides::Both), "{ray:?}");
        hits += usize::from(found.is_some());
    }
    assert!(hits > 1000, "{hits}");
}
