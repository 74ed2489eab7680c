//! Near and far are planes: what lies between them is picked, and what they cut away is not.

use super::common::{self, assert_close, orthographic, perspective, scene_of, view};
use glam::{DAffine3, DMat3, DVec3, dvec2, dvec3};
use sightline::{camera::Lens, geometry::Sides, pick, scene::Shape};

#[test]
fn where_the_near_plane_cuts_a_cube_the_face_behind_is_picked() {
    let triangles = Shape::Mesh {
        mesh: common::box_mesh(),
        part: 0,
    };
    let scenes = [Shape::Cube, triangles].map(|shape| scene_of(shape, DAffine3::IDENTITY));
    let lenses = [perspective as fn(f64, f64, f64) -> Lens, orthographic];
    for (scene, lens) in scenes
        .iter()
        .flat_map(|scene| lenses.map(|lens| (scene, lens)))
    {
        let view_of =
            |near, far| view([0.0, 0.0, 3.0], [0.0; 3], lens(40.0, near, far), [100, 100]);
        let corner = view_of(1.0, 10.0).project(dvec3(0.5, -0.5, -0.5)).unwrap();
        // All over the back face: in the middle the ray runs along F, elsewhere depth rounds.
        let steps = || (-9..=9).map(|i| f64::from(i) / 9.3);
        let shares = steps().flat_map(|y| steps().map(move |x| dvec2(x, y)));
        for px in shares.map(|share| 50.0 + share * (corner.px - 50.0)) {
            let pick = |near, far| {
                let closest = pick::closest(scene, view_of(near, far).ray(px), Sides::Both);
                closest.map(|hit| hit.hit.normal.z > 0.0)
            };
            assert_eq!(pick(1.0, 10.0), Some(true), "at {px}");
            assert_eq!(
                pick(2.5, 10.0),
                Some(true),
                "the near plane belongs to it, at {px}"
            );
            assert_eq!(pick(3.0, 10.0), Some(false), "the face behind, at {px}");
            assert_eq!(pick(3.5, 10.0), Some(false), "the face behind, at {px}");
            assert_eq!(pick(3.6, 10.0), None, "at {px}");
            assert_eq!(pick(1.0, 2.5), None, "the far plane does not, at {px}");
            assert_eq!(pick(1.0, 2.6), Some(true), "at {px}");
        }
        let record = |near| pick::pick(scene, &view_of(near, 10.0), dvec2(50.0, 50.0)).unwrap();
        assert_eq!((record(2.5).front, record(2.5).depth), (true, 2.5));
        assert_eq!((record(3.0).front, record(3.0).depth), (false, 3.5));
    }
}

#[test]
fn near_and_far_are_planes_in_the_pictures_corners_too() {
    // A wall across the whole picture, just before and just behind each plane.
    let (near, far) = (2.0, 7.0);
    for lens in [perspective(120.0, near, far), orthographic(9.0, near, far)] {
        let view = view([1.0, -2.0, 3.0], [2.0, 1.0, 0.0], lens, [160, 90]);
        let camera = &view.camera;
        for (depth, shown) in [
            (1.999_999, false),
            (2.000_001, true),
            (6.999_999, true),
            (7.000_001, false),
        ] {
            let axes = DMat3::from_cols(camera.right(), camera.up(), -camera.forward());
            let model = DAffine3 {
                matrix3: axes * DMat3::from_diagonal(dvec3(1e3, 1e3, 1.0)),
                translation: camera.eye() + depth * camera.forward(),
            };
            let scene = scene_of(Shape::Square, model);
            for px in [
                dvec2(0.0, 0.0),
                dvec2(159.99, 0.0),
                dvec2(0.0, 89.99),
                dvec2(159.5, 89.5),
                dvec2(80.0, 45.0),
            ] {
                let pick = pick::pick(&scene, &view, px);
                assert_eq!(pick.is_some(), shown, "depth {depth} at {px}");
                if let Some(pick) = pick {
                    assert_close(pick.depth, depth, 1e-12);
                }
            }
        }
    }
}

#[test]
fn orthographic_views_pick_behind_the_eye_as_far_as_they_show() {
    let scene = scene_of(Shape::Sphere, DAffine3::from_translation(4.0 * DVec3::Z));
    let pick = |near, far| {
        let view = view(
            [0.0; 3],
            [0.0, 0.0, -1.0],
            orthographic(2.0, near, far),
            [50, 50],
        );
        pick::pick(&scene, &view, dvec2(25.0, 25.0))
    };
    for (near, far) in [(-5.0, 5.0), (-5.0, 100.0), (-5.0, -1.0)] {
        let pick = pick(near, far).expect("the sphere behind");
        assert_eq!((pick.t, pick.depth, pick.front), (-4.5, -4.5, true));
        assert_eq!(pick.distance.to_bits(), 4.5_f64.to_bits());
    }
    assert_eq!(pick(-3.0, 5.0), None);
}
