//! Scenes that were once picked wrongly are picked right, at every pixel of a small picture.

use super::{
    Sample, ask,
    blocks::{Layout, one_mesh},
    tally::Tally,
};
use crate::common::{box_triangles, orthographic, perspective, view};
use glam::{DAffine3, DMat3, DQuat, DVec3, EulerRot, dvec2, dvec3};
use sightline::{
    camera::View,
    geometry::Placement,
    scene::{Object, Scene, Shape},
};

fn object(shape: Shape, model: DAffine3) -> Object {
    Object::new("it", shape, Placement::new(model).unwrap())
}

/// A square of side 2 about the origin in the plane z = 0, as two triangles.
fn quad() -> Shape {
    let corners = [
        [-1.0, -1.0, 0.0],
        [1.0, -1.0, 0.0],
        [1.0, 1.0, 0.0],
        [-1.0, 1.0, 0.0_f32],
    ];
    one_mesh(corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]], DVec3::ZERO)
}

fn shift(x: f64, y: f64, z: f64) -> DAffine3 {
    DAffine3::from_translation(dvec3(x, y, z))
}

fn scaled(factor: f64) -> DAffine3 {
    DAffine3::from_scale(DVec3::splat(factor))
}

fn turned(degrees: f64) -> DAffine3 {
    DAffine3::from_rotation_z(degrees.to_radians())
}

/// A matrix given by rows, as in scene files.
fn rows(rows: [[f64; 3]; 3]) -> DAffine3 {
    DAffine3::from_mat3(DMat3::from_cols_array_2d(&rows).transpose())
}

/// Asks at each pixel's centre. Fails if an answer is wrong, and returns what was seen.
#[track_caller]
fn every_pixel(objects: Vec<Object>, view: View) -> Tally {
    let size = view.viewport;
    let rows = 0..size.height();
    let all = rows.flat_map(|y| (0..size.width()).map(move |x| dvec2(x.into(), y.into()) + 0.5));
    let sample = Sample {
        scene: Scene::new(objects),
        view,
        positions: all.collect(),
        layout: Layout::Picture,
    };
    let mut tally = Tally::default();
    ask(&sample, &mut tally);
    println!("{}", tally.row());
    let wrong = tally.wrong + tally.wrong_with_trees;
    assert!(wrong == 0, "{wrong} wrong\n{}", tally.mistakes());
    tally
}

#[test]
fn a_wall_on_the_near_or_the_far_plane() {
    for (near, far, shown) in [(2.0, 10.0, true), (1.0, 2.0, false)] {
        for wall in [quad(), Shape::Square, Shape::Cube] {
            let model = if matches!(wall, Shape::Cube) {
                shift(0.0, 0.0, -0.5)
            } else {
                shift(0.0, 0.0, 0.0)
            };
            let view = view(
                [0.0, 0.0, 2.0],
                [0.0, 0.0, 1.0],
                perspective(45.0, near, far),
                [40, 30],
            );
            let pixels = every_pixel(vec![object(wall, model)], view);
            assert_eq!(pixels.hits > 300, shown);
            assert!(pixels.planes > 300);
        }
    }
}

#[test]
fn two_squares_at_t_zero_among_many() {
    let far_cubes = (0..9).map(|i| {
        let model = DAffine3::from_scale_rotation_translation(
            DVec3::splat(0.1),
            DQuat::IDENTITY,
            dvec3(f64::from(i + 1), 30.0, -20.0),
        );
        object(Shape::Cube, model)
    });
    let first = object(Shape::Square, DAffine3::IDENTITY);
    let last = object(Shape::Square, DAffine3::from_scale(dvec3(3.0, 3.0, 1.0)));
    let objects = [first].into_iter().chain(far_cubes).chain([last]);
    let view = view(
        [0.0; 3],
        [0.0, 0.0, -1.0],
        orthographic(4.0, -50.0, 50.0),
        [32, 32],
    );
    let pixels = every_pixel(objects.collect(), view);
    assert_eq!((pixels.hits, pixels.ties), (24 * 24, 8 * 8));
}

#[test]
fn a_mesh_that_lies_nearer_by_a_hair() {
    let eye = [0.3, 0.2, 2.0];
    let view = view(eye, [0.0; 3], perspective(45.0, 0.1, 10.0), [32, 24]);
    let objects = vec![
        object(quad(), DAffine3::IDENTITY),
        object(quad(), shift(0.0, 0.0, 1e-17)),
    ];
    let pixels = every_pixel(objects, view);
    assert!(
        pixels.hits > 300 && pixels.hairs == pixels.hits,
        "{pixels:?}"
    );
}

#[test]
fn a_mesh_on_a_cubes_face() {
    let view = view(
        [0.3, 0.2, 2.0],
        [0.0; 3],
        perspective(45.0, 0.1, 10.0),
        [40, 30],
    );
    let objects = vec![
        object(quad(), turned(30.0)),
        object(Shape::Cube, shift(0.0, 0.0, -0.5)),
    ];
    let pixels = every_pixel(objects, view);
    assert!(pixels.ties > 100, "{pixels:?}");
}

#[test]
fn coplanar_squares() {
    let view = view(
        [0.0, 0.0, 3.0],
        [0.0; 3],
        perspective(45.0, 0.1, 10.0),
        [64, 48],
    );
    let objects = vec![
        object(Shape::Square, DAffine3::IDENTITY),
        object(Shape::Square, turned(30.0)),
        object(Shape::Square, turned(60.0) * scaled(0.7)),
    ];
    let pixels = every_pixel(objects, view);
    assert!(pixels.ties > 100, "{pixels:?}");
}

#[test]
fn a_square_far_from_the_origin() {
    let (x, y) = (500_000.125, 5_350_000.25);
    let lens = perspective(45.0, 1e-4, 1.0);
    let view = view([x, y, 0.01], [x, y, 0.0], lens, [64, 48]);
    let model = DAffine3::from_scale_rotation_translation(
        DVec3::splat(0.01),
        DQuat::IDENTITY,
        dvec3(x, y, 0.0),
    );
    let pixels = every_pixel(vec![object(Shape::Square, model)], view);
    assert!(pixels.hits > 1000, "{pixels:?}");
}

#[test]
fn a_sheared_sphere() {
    let model = rows([
        [
            0.911_684_611_677_103_6,
            0.911_684_611_677_115_8,
            -0.046_524_210_519_923_56,
        ],
        [
            0.341_881_729_378_913_8,
            0.341_881_729_378_889_33,
            -0.465_242_105_199_235_5,
        ],
        [
            -0.227_921_152_919_275_9,
            -0.227_921_152_919_263_65,
            -0.883_959_999_878_547_3,
        ],
    ]);
    for lens in [perspective(30.0, 0.5, 20.0), orthographic(1.5, -5.0, 20.0)] {
        let view = view([1.3, 1.1, 2.0], [0.0; 3], lens, [48, 36]);
        let pixels = every_pixel(vec![object(Shape::Sphere, model)], view);
        assert!(pixels.hits > 30, "{pixels:?}");
    }
}

#[test]
fn a_flattened_cube_through_a_long_lens() {
    let model = rows([
        [
            0.838_386_643_594_203_6,
            -0.259_343_380_052_230_8,
            0.479_425_538_604_203,
        ],
        [
            5.210_862_105_571_308e-9,
            6.394_089_303_668_974e-9,
            -5.653_542_083_811_438e-9,
        ],
        [
            -0.159_928_099_501_168_13,
            0.723_807_454_362_100_6,
            0.671_212_166_157_957_7,
        ],
    ]);
    let eye = [6e4, 4.8e4, 1e5];
    let lens = perspective(0.0007, 126_000.0, 126_250.0);
    let view = view(eye, [0.0; 3], lens, [64, 48]);
    let pixels = every_pixel(vec![object(Shape::Cube, model)], view);
    assert!(pixels.hits > 300, "{pixels:?}");
}

#[test]
fn plain_shapes_from_far_away() {
    let placed = |scale: DVec3, degrees: [f64; 3], at: DVec3| {
        let [x, y, z] = degrees.map(f64::to_radians);
        let turn = DQuat::from_euler(EulerRot::ZYX, z, y, x);
        DAffine3::from_scale_rotation_translation(scale, turn, at)
    };
    let (positions, triangles) = box_triangles(1.0);
    let small = DVec3::splat(0.6);
    let objects = vec![
        object(
            Shape::Sphere,
            placed(
                dvec3(1.0, 0.8, 0.7),
                [20.0, 30.0, 40.0],
                dvec3(0.3, 0.1, 0.0),
            ),
        ),
        object(
            Shape::Cube,
            placed(small, [10.0, 70.0, 20.0], dvec3(-0.4, 0.1, 0.0)),
        ),
        object(
            one_mesh(positions, triangles, DVec3::ZERO),
            placed(small, [10.0, 20.0, 20.0], dvec3(-0.4, -0.5, 0.0)),
        ),
    ];
    let far = 126_111_067.163_475_57;
    let lens = perspective(9.086_558_868_057_237e-7, far - 10.0, far);
    let view = view([6e7, 4.8e7, 1e8], [0.0; 3], lens, [64, 48]);
    let pixels = every_pixel(objects, view);
    assert!(pixels.hits > 500, "{pixels:?}");
}

/// A ray exactly along the edge of a cube is decided by exact arithmetic alone, and the record says so. The cube's box in
/// the world, whose corners are rounded, may begin behind the hit.
#[test]
fn an_edge_far_from_the_origin_is_said_to_be_exact() {
    let mut tally = Tally::default();
    for away in [0.0, 1e3, 1e6, 1e9] {
        for i in 0..20 {
            let part = f64::from(i) / 19.0;
            let z = away + 0.309_670_053_476_3 * part;
            let model = shift(0.0, 0.0, z) * DAffine3::from_scale(dvec3(1.0, 1.0, 0.3 + part));
            let view = view(
                [0.0, 0.0, away + 5.0],
                [0.0, 0.0, away + 4.0],
                orthographic(4.0, 0.5, 20.0),
                [64, 64],
            );
            let sample = Sample {
                scene: Scene::new(vec![object(Shape::Cube, model)]),
                view,
                positions: vec![dvec2(40.0, 32.0), dvec2(40.0, 40.0)],
                layout: Layout::Anywhere,
            };
            ask(&sample, &mut tally);
        }
    }
    let wrong = tally.wrong + tally.wrong_with_trees;
    assert!(wrong == 0, "{wrong} wrong\n{}", tally.mistakes());
    assert!(tally.borders >= 160, "{}", tally.row());
}
