//! A part that its mesh lacks has no triangles: it is drawn, picked and compared as nothing.

use crate::{common, compare, drawn_once, scenes::object};
use glam::{DAffine3, DQuat, DVec3};
use sightline::{
    camera::View,
    image::{Id, Image},
    pick,
    scene::{Object, Scene, Shape},
    verify::Verdict,
};

fn view() -> View {
    let lens = common::perspective(45.0, 0.1, 100.0);
    common::view([0.5, 0.5, 4.0], [0.0, 0.0, 0.0], lens, [60, 40])
}

/// A part of a mesh that has part 0 alone.
fn part(part: usize, model: DAffine3) -> Object {
    let mesh = common::box_mesh();
    object("part", Shape::Mesh { mesh, part }, model, None)
}

/// The ids that are drawn and picked, which agree.
#[track_caller]
fn ids(scene: &Scene) -> [Image<Id>; 2] {
    let (drawn, picked) = (drawn_once(scene, &view()), pick::ids(scene, &view()));
    let report = compare(scene, &view(), &drawn, &picked);
    assert_eq!(report.verdict(), Verdict::Agrees);
    [drawn, picked]
}

#[test]
fn alone_it_shows_nothing() {
    let nothing = ids(&Scene::default());
    let turned = DAffine3::from_quat(DQuat::from_rotation_y(0.5));
    for model in [DAffine3::IDENTITY, turned] {
        for number in [1, 7, usize::MAX] {
            let scene = Scene::new(vec![part(number, model)]);
            assert_eq!(ids(&scene), nothing, "part {number}");
        }
    }
}

/// Objects are culled many at a time, by the box about them. The last one here lies behind the eye.
#[test]
fn beside_others_it_hides_nothing() {
    let first = part(0, DAffine3::IDENTITY);
    let behind = DAffine3::from_translation(DVec3::new(0.0, 0.0, 20.0));
    let last = object("behind", Shape::Cube, behind, None);
    let whole = ids(&Scene::new(vec![first.clone()]));
    let shown = |ids: &Image<Id>| ids.pixels().iter().filter(|id| id.object == 1).count();
    assert!(whole.iter().all(|ids| shown(ids) > 100));
    for number in [1, 7] {
        // Part 1 of the same mesh would be drawn together with part 0, part 7 by itself.
        let mut lacking = first.clone();
        if let Shape::Mesh { part, .. } = &mut lacking.shape {
            *part = number;
        }
        let scene = Scene::new(vec![first.clone(), lacking, last.clone()]);
        assert_eq!(ids(&scene), whole, "part {number}");
    }
}

#[test]
fn a_drawing_that_claims_to_show_it_is_found_out() {
    let scene = Scene::new(vec![part(7, DAffine3::IDENTITY)]);
    let [mut drawn, picked] = ids(&scene);
    for triangle in [0, 1] {
        let object = 1;
        drawn.pixels_mut()[0] = Id { object, triangle };
        let report = compare(&scene, &view(), &drawn, &picked);
        assert_eq!(report.verdict(), Verdict::Unexplained(1));
    }
}
