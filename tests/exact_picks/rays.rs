//! Rays given by their numbers, which are taken as exact, hit what exact arithmetic says.

use super::{
    aim::point_of,
    blocks::{chance, lattice_point},
    compare::Case,
    exact::truth::World,
    families, lattice,
    tally::Tally,
    wanted,
};
use crate::common::Random;
use glam::DVec3;
use sightline::geometry::Ray;

/// The rays run to borders or anywhere, from surfaces or anywhere, with directions of any length.
#[test]
fn families_of_given_rays() {
    let mut random = Random::new(20);
    let mut tally = Tally::default();
    while tally.positions < wanted() {
        let make = [
            families::ordinary,
            families::condition,
            lattice::exact_borders,
        ][random.below(3)];
        let sample = make(&mut random);
        sample.scene.build_trees();
        let world = World::of(&sample.scene);
        let case = Case {
            scene: &sample.scene,
            view: &sample.view,
            world: &world,
        };
        for _ in 0..20 {
            let ray = some_ray(&mut random, &case);
            case.check_ray(&ray, &mut tally);
        }
    }
    println!("{:16} {}", "given_rays", tally.row());
    assert!(tally.hits * 2 > tally.positions && tally.borders * 60 > tally.positions);
    assert!(tally.wrong == 0, "{}", tally.mistakes());
}

fn some_ray(random: &mut Random, case: &Case) -> Ray {
    let objects = case.scene.objects();
    let on_some_object = |random: &mut Random| {
        let object = &objects[random.below(objects.len())];
        let on_border = chance(random, 2);
        let point = point_of(random, &object.shape, on_border);
        object.placement.point_to_world(point)
    };
    let target = on_some_object(random);
    let origin = match random.below(4) {
        0 => on_some_object(random),
        1 => lattice_point(random, 8),
        _ => case.view.camera.eye(),
    };
    let direction = match random.below(4) {
        0 => lattice_point(random, 1),
        1 => (target - origin).normalize_or_zero() * 1e-3,
        _ => target - origin,
    };
    let direction = if direction == DVec3::ZERO {
        DVec3::X
    } else {
        direction
    };
    Ray {
        origin,
        direction,
        t_min: if chance(random, 2) { 0.0 } else { -10.0 },
        t_max: 1e12,
    }
}
