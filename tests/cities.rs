//! Scenes of thousands of objects: a ray asks few of them, and hits what it would hit by asking them all.

mod common;

use common::{Random, mesh, placements, ray_to};
use glam::{DAffine3, DMat3, DQuat, DVec3, dvec3};
use sightline::{
    geometry::{Placement, Ray, Sides},
    pick::{self, SceneHit},
    scene::{Object, Scene, Shape},
};

/// Objects of every shape and placement, scattered over a square `side` wide; a few of them flat, tiny, far or hidden.
fn city(seed: u64, count: usize, side: f64, center: DVec3) -> Scene {
    let mut random = Random::new(seed);
    let corners = vec![[-0.5, -0.5, 0.0], [0.5, -0.4, 0.1], [0.0, 0.5, 0.3_f32]];
    let small = mesh(corners, vec![[0, 1, 2]], DVec3::ZERO);
    let kinds = placements();
    let mut object = |i: usize| {
        let mesh = || Shape::Mesh {
            mesh: small.clone(),
            part: 0,
        };
        let shape = [Shape::Sphere, Shape::Cube, Shape::Square, mesh()][i % 4].clone();
        let turn = DMat3::from_quat(DQuat::from_axis_angle(
            random.direction(),
            random.within(0.0, 6.0),
        ));
        let size = 10_f64.powf(random.within(-2.0, 0.3));
        let linear = match i % 10 {
            // Flat, long, sheared, mirrored.
            0 => turn * DMat3::from_diagonal(size * dvec3(1.0, 1e-5, 1.0)),
            1 => turn * DMat3::from_diagonal(size * dvec3(30.0, 0.01, 1.0)),
            2 => size * kinds[i / 10 % kinds.len()].1.matrix3,
            _ => size * turn,
        };
        let at = dvec3(
            random.within(-side, side),
            random.within(-2.0, 2.0),
            random.within(-side, side),
        );
        let away = if i % 500 == 499 { 1e4 } else { 1.0 };
        let placement = Placement::new(DAffine3 {
            matrix3: linear,
            translation: center + away * at,
        });
        let mut object = Object::new(i.to_string(), shape, placement.expect("an inverse"));
        object.visible = i % 17 != 5;
        object
    };
    Scene::new((0..count).map(&mut object).collect())
}

/// By asking every batch: each as a scene of its own, which is too small for a tree.
fn by_brute_force(scene: &Scene, ray: &Ray, sides: Sides) -> Vec<SceneHit> {
    let mut hits = Vec::new();
    for (index, object) in scene.objects().iter().enumerate() {
        let alone = Scene::new(vec![object.clone()]);
        let own = pick::all(&alone, ray, sides).into_iter();
        hits.extend(own.map(|hit| SceneHit {
            object: index,
            ..hit
        }));
    }
    // Batches are single objects here, each of which has its hits in order.
    hits.sort_by(|a, b| a.hit.t.total_cmp(&b.hit.t).then(a.object.cmp(&b.object)));
    hits
}

fn asked(scene: &Scene, ray: &Ray) -> usize {
    let mut asked = 0;
    scene.visit_batches(ray, |_| {
        asked += 1;
        ray.t_max
    });
    asked
}

#[test]
fn a_tree_over_objects_hits_what_asking_them_all_hits() {
    let far = dvec3(4e5, 100.0, 5.6e6);
    for (seed, count, side, center) in [
        (1, 7, 2.0, DVec3::ZERO),
        (2, 8, 2.0, DVec3::ZERO),
        (3, 400, 8.0, DVec3::ZERO),
        (4, 400, 8.0, far),
    ] {
        let scene = city(seed, count, side, center);
        let mut random = Random::new(seed + 100);
        let (mut hit, mut several) = (0, 0);
        for i in 0..500_usize {
            // At the middle, an outline or a corner of something, from near and from far; along axes with zeros of both signs.
            let object = (7 * i) % count;
            let bounds = scene.bounds_of(object);
            let target = match i % 3 {
                0 => bounds.center(),
                1 => bounds.corners()[i / 3 % 8],
                _ => bounds.center() + 0.5 * bounds.radius() * random.direction(),
            };
            let away = [0.1, 3.0, 30.0, 1e4, 1e8][i % 5];
            let mut ray = ray_to(target + away * random.direction(), target);
            if i % 7 == 0 {
                let zero = [0.0, -0.0][i / 7 % 2];
                ray.direction = dvec3([1.0, -1.0][i / 14 % 2], zero, zero);
                ray.origin = target - away * ray.direction;
            }
            if i % 11 == 0 {
                (ray.t_min, ray.t_max) = (0.5, 1.0 + 1e-9);
            }
            for sides in [Sides::Both, Sides::Front] {
                let expected = by_brute_force(&scene, &ray, sides);
                assert_eq!(
                    pick::all(&scene, &ray, sides),
                    expected,
                    "{seed} {i} {ray:?}"
                );
                let closest = pick::closest(&scene, &ray, sides);
                assert_eq!(closest.as_ref(), expected.first(), "{seed} {i} {ray:?}");
                hit += usize::from(!expected.is_empty());
                several += usize::from(expected.len() > 3);
            }
        }
        println!("{count} objects: {hit} of 1000 rays hit, {several} more than one object");
        assert!(
            hit > 300 && (several > 100 || count < 10),
            "{hit} {several}"
        );
    }
}

#[test]
fn a_ray_through_a_city_asks_few_of_it() {
    // Houses side by side.
    let city = |side: i32| {
        let houses = (-side..=side).flat_map(|x| (-side..=side).map(move |z| (x, z)));
        let houses = houses.map(|(x, z)| {
            let at = DAffine3::from_translation(dvec3(f64::from(x), 0.0, f64::from(z)));
            let house = Placement::new(at * DAffine3::from_scale(dvec3(0.8, 3.0, 0.8)));
            Object::new("", Shape::Cube, house.expect("an inverse"))
        });
        Scene::new(houses.collect())
    };
    let mut random = Random::new(6);
    let mut mean = |scene: &Scene, side: f64| {
        let mut total = 0;
        for _ in 0..500 {
            let target = dvec3(random.within(-side, side), 0.0, random.within(-side, side));
            total += asked(scene, &ray_to(target + dvec3(1.0, 20.0, 2.0), target));
        }
        f64::from(u32::try_from(total).unwrap()) / 500.0
    };
    let (town, city) = (city(2), city(27));
    let (few, many) = (mean(&town, 1.5), mean(&city, 25.0));
    println!(
        "{few} of {} houses asked, {many} of {}",
        town.objects().len(),
        city.objects().len()
    );
    assert!(city.objects().len() > 3000);
    assert!(few > 0.5 && many < few + 1.0, "{few} {many}");
}

#[test]
fn equal_hits_in_a_city_are_the_lowest_objects() {
    let objects = (0..100).map(|i| Object::new(i.to_string(), Shape::Cube, Placement::IDENTITY));
    let mut scene = Scene::new(objects.collect());
    scene.set_visible(0, false);
    let ray = ray_to(dvec3(0.1, 0.2, 3.0), dvec3(0.1, 0.2, 0.0));
    let hit = pick::closest(&scene, &ray, Sides::Both).expect("a hit");
    assert_eq!((hit.object, hit.hit.t), (1, 2.5));
    let all: Vec<_> = pick::all(&scene, &ray, Sides::Both)
        .iter()
        .map(|hit| hit.object)
        .collect();
    assert_eq!(all, (1..100).chain(1..100).collect::<Vec<_>>());
}
