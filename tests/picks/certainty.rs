//! A pick's `exact` is right, on cases that `f64` cannot decide. For `edge_px` see `edges`.

use crate::common::{mesh, orthographic, perspective, scene_of, view};
use glam::{DAffine3, DVec2, DVec3, dvec2};
use sightline::{
    geometry::Placement,
    pick,
    scene::{Object, Scene, Shape},
};

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
    scene.build_trees();
    let after = pick::pick(&scene, &view, px).expect("a hit");
    assert_eq!(before, after);
}
