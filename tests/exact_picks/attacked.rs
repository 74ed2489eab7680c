//! Attacks on the core found picks that were wrong or slow, or misjudged their certainty. All of these are right now.

use super::common::{self, orthographic};
use glam::{DAffine3, DMat3, DVec2, DVec3};
use sightline::{
    camera::View,
    geometry::{PixelGrid, Placement, Sides},
    pick,
    scene::{Object, Scene, Shape},
};

/// An orthographic view along -z.
fn view(eye: [f64; 3], height: f64) -> View {
    let [x, y, z] = eye;
    common::view(
        eye,
        [x, y, z - 1.0],
        orthographic(height, 0.1, 10.0),
        [1280, 720],
    )
}

fn at(shape: Shape, size: f64, center: DVec3) -> Object {
    let model = DAffine3 {
        matrix3: DMat3::from_diagonal(DVec3::splat(size)),
        translation: center,
    };
    Object::new("it", shape, Placement::new(model).expect("invertible"))
}

/// Cubes far away, so many that their scene has a tree.
fn crowd() -> impl Iterator<Item = Object> {
    (0..9).map(|i| {
        at(
            Shape::Cube,
            1.0,
            DVec3::new(1e3 + 10.0 * f64::from(i), 1e3, 0.0),
        )
    })
}

/// The roots cancel in the gap, which lies halfway between two `f64`: no interval around it rounds to one number.
#[test]
fn the_gap_between_two_balls_is_a_quotient() {
    let balls = [0.25, 0.05].map(|z| at(Shape::Sphere, 1.0, DVec3::new(0.0, 0.0, z)));
    let scene = Scene::new(balls.to_vec());
    let found = pick::pick(
        &scene,
        &view([0.25, 0.0, 5.0], 2.0),
        DVec2::new(640.0, 360.0),
    );
    let gap = found.and_then(|found| found.gap).expect("two balls");
    // 1/4 - f64(1/20), rounded to even.
    assert_eq!(gap.to_bits(), f64::to_bits(0.25 - 0.05));
}

/// The ray misses by less than the rounding error of half a side and its bound.
#[test]
fn a_ray_just_beside_a_cube_misses_it() {
    let scene = Scene::new(vec![at(Shape::Cube, 1.0, DVec3::ZERO)]);
    for (px, is_hit) in [
        (640.0, true),
        (640.0_f64.next_up(), false),
        (640.0_f64.next_down(), true),
    ] {
        let view = view([0.5, 0.0, 5.0], 2e-5);
        let hit = pick::closest(&scene, view.ray(DVec2::new(px, 360.0)), Sides::Both);
        assert_eq!(hit.is_some(), is_hit, "{px}");
    }
}

/// The ray starts near the origin, but its start is off by the rounding of its two large terms.
#[test]
fn a_tree_over_the_scene_knows_how_far_rays_are_off() {
    let small = at(Shape::Cube, 2e-7, DVec3::ZERO);
    let alone = Scene::new(vec![small.clone()]);
    let among = Scene::new([small].into_iter().chain(crowd()).collect());
    let mut hits = 0;
    for i in 0..2000 {
        let px = DVec2::new(
            100.0 + 0.37 * f64::from(i % 600),
            200.0 + 0.1 * f64::from(i % 100),
        );
        let grid = PixelGrid {
            eye: DVec3::Z * 5.0,
            right: DVec3::X,
            up: DVec3::Y,
            forward: DVec3::NEG_Z,
            half_height: 1e9 * (1.0 + 1e-3 * f64::from(i)),
            size_px: [1280, 720],
            is_orthographic: true,
        };
        let aside = grid.aside(px);
        let beside = if i % 2 == 0 {
            (-aside.x).next_up()
        } else {
            (-aside.x).next_down()
        };
        let ray = PixelGrid {
            eye: DVec3::new(beside, -aside.y, 5.0),
            ..grid
        }
        .ray(px, [0.0, 10.0]);
        let found = [&alone, &among].map(|scene| pick::closest(scene, ray, Sides::Both).is_some());
        assert_eq!(found[0], found[1], "{ray:?}");
        hits += u32::from(found[0]);
    }
    assert!(hits > 50, "{hits}");
}

/// A ball behind what is seen, and one behind the eye, that the ray just touches: neither makes the pick exact.
#[test]
fn what_lies_behind_makes_no_pick_exact() {
    for (square, eye) in [(2.0, 5.0), (-4.0, -2.0)] {
        let near = [
            at(Shape::Square, 4.0, DVec3::Z * square),
            at(Shape::Sphere, 1.0, DVec3::ZERO),
        ];
        let view = view([0.5, 0.0, eye], 2.0);
        for with in [0, 9] {
            let scene = Scene::new(near.iter().cloned().chain(crowd().take(with)).collect());
            let found = pick::pick(&scene, &view, DVec2::new(640.0, 360.0)).expect("the square");
            assert_eq!((found.id, found.exact), (1, false), "{with} others");
        }
    }
}
