//! What a ray and an edit cost in scenes of many objects: `cargo bench --bench objects`. Houses on a plain are asked in
//! turns: through the scene's tree, and one after the other. The answers are compared. Then one house is hidden, one is
//! moved, and the list of all is copied, in turns too, while the scene before is held.

use glam::{DAffine3, DMat3, DVec3};
use sightline::{
    geometry::{Placement, Ray, Sides},
    pick,
    scene::{Object, Scene, Shape},
};
use std::{hint::black_box, time::Instant};

const RAYS: u32 = 2000;
const ROUNDS: usize = 9;
const EDITS: u32 = 20;

fn main() {
    for houses in [1, 30, 3000, 50_000] {
        let scene = city(houses);
        let alone: Vec<Scene> = scene
            .objects()
            .iter()
            .map(|object| Scene::new(vec![object.clone()]))
            .collect();
        let rays: Vec<Ray> = (0..RAYS).map(|i| ray(&scene, i)).collect();
        let mut times = [const { Vec::new() }; 2];
        // One after the other is slow, so it gets fewer rays.
        let few = rays.len().min(2_000_000 / houses as usize);
        for _ in 0..ROUNDS {
            times[0].push(time(&rays, |ray| pick::closest(&scene, ray, Sides::Both)));
            times[1].push(time(&rays[..few], |ray| one_by_one(&alone, ray)));
        }
        for ray in &rays[..few] {
            let hit = pick::closest(&scene, ray, Sides::Both).map(|hit| hit.hit.t);
            assert_eq!(hit, one_by_one(&alone, ray), "{ray:?}");
        }
        let [tree, each] = times.map(median);
        let hits = rays
            .iter()
            .filter(|ray| pick::closest(&scene, *ray, Sides::Both).is_some());
        println!(
            "{houses:6} houses: {tree:9.3} us a ray, one after the other {each:9.3} us ({} of {RAYS} rays hit)",
            hits.count()
        );
        let [hide, place, copy] = edits(&scene).map(median);
        println!(
            "               one hidden {hide:9.3} us, one moved {place:9.3} us, a copy of the list {copy:9.3} us"
        );
    }
}

/// Microseconds to hide an object, to move it, and to copy the list of all, in each round.
fn edits(scene: &Scene) -> [Vec<f64>; 3] {
    let of_one = |edit: &dyn Fn(&mut Scene, usize)| {
        let mut micros = 0.0;
        for i in 0..EDITS {
            let object = i as usize * 7919 % scene.objects().len();
            let mut after = scene.clone();
            let start = Instant::now();
            edit(&mut after, object);
            micros += 1e6 * start.elapsed().as_secs_f64();
            black_box(after);
        }
        micros / f64::from(EDITS)
    };
    let mut times = [const { Vec::new() }; 3];
    for _ in 0..ROUNDS {
        times[0].push(of_one(&|scene, object| scene.set_visible(object, false)));
        times[1].push(of_one(&|scene, object| {
            let mut model = scene.objects()[object].placement.model();
            model.translation.x += 3.0;
            scene.place(object, Placement::new(model).expect("a shift"));
        }));
        times[2].push(of_one(&|scene, _| {
            drop(black_box(scene.objects().to_vec()));
        }));
    }
    times
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn one_by_one(alone: &[Scene], ray: &Ray) -> Option<f64> {
    let hits = alone
        .iter()
        .filter_map(|scene| pick::closest(scene, ray, Sides::Both));
    hits.map(|hit| hit.hit.t).min_by(f64::total_cmp)
}

/// Microseconds a ray.
fn time<T>(rays: &[Ray], answer: impl Fn(&Ray) -> T) -> f64 {
    let start = Instant::now();
    for ray in rays {
        black_box(answer(ray));
    }
    let rays = u32::try_from(rays.len()).expect("few rays");
    1e6 * start.elapsed().as_secs_f64() / f64::from(rays)
}

/// Points spread evenly over the unit square: Roberts's R2 sequence.
fn spread(i: u32) -> [f64; 2] {
    [0.754_877_666_246_692_8, 0.569_840_290_998_053_3]
        .map(|step| (0.5 + step * f64::from(i)).fract())
}

fn city(houses: u32) -> Scene {
    let side = 20.0 * f64::from(houses).sqrt();
    let house = |i| {
        let [x, z] = spread(i).map(|s| side * (s - 0.5));
        let height = 5.0 + f64::from(i % 31);
        let model = DAffine3 {
            matrix3: DMat3::from_diagonal(DVec3::new(8.0, height, 8.0)),
            translation: DVec3::new(x, 0.5 * height, z),
        };
        Object::new(
            "house",
            Shape::Cube,
            Placement::new(model).expect("invertible"),
        )
    };
    Scene::new((0..houses).map(house).collect())
}

/// A ray from above the city's edge to a place in it.
fn ray(scene: &Scene, i: u32) -> Ray {
    let bounds = scene.bounds();
    let [u, v] = spread(i);
    let size = bounds.max - bounds.min;
    let origin = bounds.min + size * DVec3::new(v, 0.0, -0.2) + DVec3::Y * (30.0 + 0.3 * size.z);
    let to = bounds.min + size * DVec3::new(u, 0.0, v);
    Ray {
        origin,
        direction: (to - origin).normalize(),
        t_min: 0.0,
        t_max: f64::INFINITY,
    }
}
