//! A pick's `differs_px` and `exact` are right, checked against all pixels and on cases that `f64` cannot decide. For
//! `edge_px` see `edges`.

use crate::common::{Random, mesh, orthographic, perspective, scene_of, view};
use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3, dvec2};
use sightline::{
    camera::View,
    geometry::{Cuboid, Placement, Sides},
    image::{Id, Image},
    pick::{self, Pick},
    scene::{Object, Scene, Shape},
};

/// Quads, spheres and squares of many sizes, some touching, in a picture of 80 x 60.
fn crowded() -> (Scene, View) {
    let mut random = Random::new(51);
    let mut objects = Vec::new();
    for i in 0..9 {
        let size = 10_f64.powf(random.within(-1.0, 0.6));
        let model = DAffine3 {
            matrix3: DMat3::from_diagonal(DVec3::splat(size)),
            translation: random.point(2.0),
        };
        let corners = [
            [-0.5, -0.5, 0.0],
            [0.5, -0.5, 0.0],
            [0.5, 0.5, 0.1],
            [-0.5, 0.5, -0.1],
        ];
        let quad = Shape::Mesh {
            mesh: mesh(corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]], DVec3::ZERO),
            part: 0,
        };
        let shape = [quad, Shape::Sphere, Shape::Square][i % 3].clone();
        objects.push(Object::new("", shape, Placement::new(model).unwrap()));
    }
    let view = view(
        [0.0, 0.0, 6.0],
        [0.0; 3],
        perspective(50.0, 0.5, 50.0),
        [80, 60],
    );
    (Scene::new(objects), view)
}

/// The distance to the nearest pixel with another id, where that is at most eight.
fn differs_px(ids: &Image<Id>, px: (u32, u32)) -> Option<f64> {
    let here = ids.at(px.0, px.1);
    let center = |(x, y): (u32, u32)| dvec2(x.into(), y.into());
    let others = ids.positions().filter(|&(x, y)| ids.at(x, y) != here);
    let nearest = others.map(|other| center(px).distance(center(other)));
    nearest.reduce(f64::min).filter(|px| *px <= 8.0)
}

#[test]
fn differs_px_is_the_way_to_the_nearest_pixel_that_shows_something_else() {
    let (scene, view) = crowded();
    let (ids, _) = pick::raycast(&scene, &view);
    let (mut near, mut none) = (0, 0);
    for (x, y) in ids.positions() {
        let center = dvec2(x.into(), y.into());
        let Some(pick) = pick::pick(&scene, &view, center + 0.5) else {
            continue;
        };
        let truth = differs_px(&ids, (x, y));
        assert_eq!(pick.differs_px, truth, "at {center}");
        match pick.differs_px {
            Some(px) if px < 8.0 => near += 1,
            Some(_) => {}
            None => none += 1,
        }
        if x % 4 != 0 {
            continue;
        }
        for pick in pick::pick_all(&scene, &view, center + 0.5) {
            assert_eq!(pick.differs_px, truth, "one number for all");
        }
    }
    assert!(near > 500 && none > 20, "{near} near, {none} far");
}

/// The near plane cuts the tip off a solid that faces the eye; the hole lies in the middle of what shows.
#[test]
fn differs_px_finds_what_the_near_plane_cuts_out_of_a_solid() {
    let mut random = Random::new(52);
    let mut far = 0;
    for case in 0..8 {
        let rotation = DQuat::from_axis_angle(random.direction(), random.within(0.0, 3.0));
        let center = random.point(20.0);
        let model = DAffine3::from_scale_rotation_translation(DVec3::splat(3.0), rotation, center);
        let eye = center + 4.0 * random.direction();
        let camera = |near| perspective(50.0, near, 100.0);
        let framed = |near| view(eye.into(), center.into(), camera(near), [80, 60]);
        let (shape, nearest) = if case % 2 == 0 {
            (Shape::Sphere, 2.5)
        } else {
            let corners = Cuboid::bounds()
                .corners()
                .map(|p| model.transform_point3(p));
            let depths = corners.map(|p| framed(0.1).camera.forward().dot(p - eye));
            (
                Shape::Cube,
                depths.into_iter().fold(f64::INFINITY, f64::min),
            )
        };
        let scene = scene_of(shape, model);
        scene.build_trees();
        let mut view = framed(nearest + 0.02);
        view.sides = Sides::Front;
        let (ids, _) = pick::raycast(&scene, &view);
        let shown = ids.positions().filter(|&(x, y)| ids.at(x, y).object == 1);
        for (x, y) in shown {
            let center = dvec2(x.into(), y.into());
            let truth = differs_px(&ids, (x, y));
            let pick = pick::pick(&scene, &view, center + 0.5).expect("it shows");
            assert_eq!(pick.differs_px, truth, "case {case} at {center}");
            far += i32::from(truth.is_some_and(|px| px >= 4.0));
        }
    }
    assert!(far > 1000, "only {far}");
}

#[test]
fn exact_says_when_f64_cannot_decide() {
    let sheet = |z: f64| {
        // Two triangles that share a diagonal, on whole coordinates.
        let corners = [[-8.0, -8.0], [8.0, -8.0], [8.0, 8.0], [-8.0, 8.0_f32]];
        #[expect(clippy::cast_possible_truncation, reason = "small and whole")]
        let positions = corners.map(|[x, y]| [x, y, z as f32]);
        let triangles = vec![[0, 1, 2], [0, 2, 3]];
        Shape::Mesh {
            mesh: mesh(positions.to_vec(), triangles, DVec3::ZERO),
            part: 0,
        }
    };
    let object = |shape: Shape| Object::new("", shape, Placement::IDENTITY);
    let view = view(
        [0.0, 0.0, 8.0],
        [0.0; 3],
        orthographic(16.0, 1.0, 50.0),
        [16, 16],
    );
    let exact = |scene: &Scene, px: DVec2| -> Vec<bool> {
        let picks = pick::pick_all(scene, &view, px);
        picks.iter().map(|pick| pick.exact).collect()
    };
    let (beside, diagonal) = (dvec2(9.5, 3.5), dvec2(9.5, 6.5));
    // The quad alone: exact only on the diagonal, where both triangles are hit.
    let one = Scene::new(vec![object(sheet(0.0))]);
    assert_eq!(exact(&one, beside), [false]);
    assert_eq!(exact(&one, diagonal), [true, true]);
    // What lies behind a hit does not put it in doubt.
    let mut two = Scene::new(vec![object(Shape::Square), object(sheet(-3.0))]);
    let front = dvec2(8.25, 7.75);
    assert_eq!(exact(&two, front), [false, true, true]);
    // A hidden object puts no hit in doubt either.
    two.set_visible(1, false);
    assert_eq!(exact(&two, front), [false]);
    let mut solid = Scene::new(vec![object(Shape::Square), object(Shape::Cube)]);
    solid.set_visible(1, false);
    assert_eq!(exact(&solid, front), [false]);
    // The same triangle twice in one mesh: exact arithmetic decides which is nearer.
    let corners = vec![[-8.0, -8.0, 0.0], [8.0, -8.0, 0.1], [0.0, 8.0, 0.3_f32]];
    let twice = mesh(corners, vec![[0, 1, 2], [1, 2, 0]], DVec3::ZERO);
    let twice = Scene::new(vec![object(Shape::Mesh {
        mesh: twice,
        part: 0,
    })]);
    let picks = pick::pick_all(&twice, &view, dvec2(7.3, 9.1));
    let found: Vec<_> = picks
        .iter()
        .map(|pick| (pick.triangle, pick.exact))
        .collect();
    assert_eq!(found, [(Some(0), true), (Some(1), true)]);
    assert_eq!(picks[0].gap, Some(0.0));
}

/// Threads share the records of a ray through many surfaces. The records are in order all the same.
#[test]
fn many_surfaces_on_a_ray_are_in_order() {
    let square = |i: u32| {
        let at = DAffine3::from_translation(-f64::from(i) * DVec3::Z);
        Object::new(i.to_string(), Shape::Square, Placement::new(at).unwrap())
    };
    let scene = Scene::new((0..300).map(square).collect());
    let lens = orthographic(2.0, 1.0, 400.0);
    let view = view([0.0, 0.0, 2.0], [0.0; 3], lens, [80, 60]);
    let picks = pick::pick_all(&scene, &view, dvec2(41.5, 31.5));
    let found: Vec<_> = picks
        .iter()
        .map(|pick| (pick.id, pick.t, pick.gap))
        .collect();
    let expected = (1..=300_u32).map(|id| {
        let gap = (id < 300).then_some(1.0);
        (id as usize, f64::from(id) + 1.0, gap)
    });
    assert_eq!(found, expected.collect::<Vec<_>>());
}

#[test]
fn a_pick_does_not_wait_for_a_tree() {
    let side = 30_u32;
    let positions = (0..=side).flat_map(|y| (0..=side).map(move |x| (x, y)));
    #[expect(clippy::cast_precision_loss, reason = "small")]
    let positions = positions.map(|(x, y)| [x as f32 / 15.0 - 1.0, y as f32 / 15.0 - 1.0, 0.0]);
    let cells = (0..side).flat_map(|y| (0..side).map(move |x| y * (side + 1) + x));
    let triangles = cells.flat_map(|a| [[a, a + 1, a + side + 2], [a, a + side + 2, a + side + 1]]);
    let mesh = mesh(positions.collect(), triangles.collect(), DVec3::ZERO);
    let scene = scene_of(Shape::Mesh { mesh, part: 0 }, DAffine3::IDENTITY);
    let view = view(
        [0.3, 0.2, 3.0],
        [0.0; 3],
        perspective(40.0, 0.1, 10.0),
        [64, 48],
    );
    let px = dvec2(30.5, 20.5);
    let before = pick::pick(&scene, &view, px).expect("a hit");
    assert!(!scene.trees_are_built());
    assert_eq!(before.differs_px, None, "it would take a tree to say");
    scene.build_trees();
    let after = pick::pick(&scene, &view, px).expect("a hit");
    assert!(
        after.differs_px.is_some_and(|px| px < 4.0),
        "{:?}",
        after.differs_px
    );
    assert_eq!(
        before,
        Pick {
            differs_px: None,
            ..after
        },
        "all else is the same"
    );
}
