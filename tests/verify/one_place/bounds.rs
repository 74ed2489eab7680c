//! Surfaces are in one place exactly where they lie within the bounds of drawing.

use super::*;
use crate::compare_made;
use sightline::render::Rasteriser;

/// Which of the squares is drawn at a pixel is up to the driver's last bits; that they are in one place is not.
#[test]
fn coplanar_squares_seen_from_the_side() {
    let lens = perspective(45.0, 0.1, 10.0);
    let [_, marked, unexplained] = counts(
        &coplanar(),
        &view([1.0, 2.0, 2.0], [0.0; 3], lens, [320, 240]),
    );
    assert!(marked > 2000, "{marked}");
    assert_eq!(unexplained, 0);
}

/// The two meshes are large enough for a tree, which the rays of a tile enter together.
#[test]
fn a_ball_and_its_copy() {
    let (points, triangles) = icosphere(3);
    let positions = points.iter().map(|p| p.as_vec3().to_array()).collect();
    let ball = one_mesh(positions, triangles, DVec3::ZERO);
    let larger = DAffine3::from_scale(DVec3::splat(1.0 + 1e-9));
    let scene = Scene::new(vec![
        object("A", ball.clone(), DAffine3::IDENTITY),
        object("B", ball, larger),
    ]);
    let lens = perspective(45.0, 0.1, 10.0);
    let view = view([0.3, 0.2, 3.0], [0.0; 3], lens, [160, 120]);
    let [_, marked, unexplained] = counts(&scene, &view);
    assert_eq!(unexplained, 0);
    assert!(marked > 5_000, "{marked}");
}

/// `f32` cannot tell the two meshes apart and draws the first. That is no defect, and the pick names both.
#[test]
fn a_mesh_nearer_by_a_hair() {
    let scene = Scene::new(vec![
        object("A", halves(), DAffine3::IDENTITY),
        object("B", halves(), moved(1e-17)),
    ]);
    let lens = perspective(45.0, 0.1, 10.0);
    let view = view([0.3, 0.2, 2.0], [0.0; 3], lens, [160, 120]);
    let [depth, marked, unexplained] = counts(&scene, &view);
    assert_eq!(unexplained, 0);
    assert!(depth > 10_000, "{depth}");
    // A few more pixels on edges are marked.
    assert!((depth..depth + 20).contains(&marked), "{depth} of {marked}");
    let said = in_one_place(&scene, &view, dvec2(80.0, 50.5)).expect("two");
    assert_eq!(said.to_string(), "two in one place: B and A");
}

#[test]
fn what_standard_depth_cannot_tell_far_away() {
    let wide = DAffine3::from_scale(DVec3::splat(8.0));
    let scene = Scene::new(vec![
        object("A", Shape::Square, wide),
        object("B", Shape::Square, moved(0.002) * wide),
    ]);
    for (depth, expected) in [
        (DepthMapping::Reversed, 0..=0),
        (DepthMapping::Standard, 3000..=4000),
    ] {
        let lens = Lens {
            depth,
            ..perspective(45.0, 1e-3, 1e5)
        };
        let view = view([0.0, 0.0, 40.0], [0.0; 3], lens, [320, 240]);
        let [_, marked, unexplained] = counts(&scene, &view);
        assert!(expected.contains(&marked), "{depth}: {marked}");
        assert_eq!(unexplained, 0);
    }
}

/// Near a ball's rim, its surface half a pixel aside is far deeper. Where `f32` cannot hold depths, a board nearer than
/// that depth is in one place with the ball, and a board beyond it is not.
#[test]
fn a_board_behind_the_steep_part_of_a_ball() {
    let scene = |z| {
        Scene::new(vec![
            object("ball", Shape::Sphere, DAffine3::IDENTITY),
            object("board", Shape::Square, moved(z) * turned(0.0, 4.0)),
        ])
    };
    let lens = Lens {
        depth: DepthMapping::Standard,
        ..perspective(30.0, 1e-7, 100.0)
    };
    let view = view([0.0, 0.0, 5.0], [0.0; 3], lens, [64, 64]);
    // The pixel at the ball's right rim.
    let pixels = (32..64).map(|x| dvec2(f64::from(x) + 0.5, 32.5));
    let picks = pixels.map_while(|px| Some((px, pick::pick(&scene(-2.0), &view, px)?)));
    let (px, at) = picks.filter(|(_, at)| at.id == 1).last().expect("a ball");
    let z = at.point_world.z;
    assert!(z > 0.05, "{z}");
    for (behind, expected) in [(0.02, true), (0.2, false)] {
        let said = in_one_place(&scene(z - behind), &view, px);
        assert_eq!(said.is_some(), expected, "{behind} {z}");
    }
}

/// The corners are so far out that `f64` cannot compute the squares' depth from them, so the pick's depth is used.
#[test]
fn squares_of_one_plane_too_large_for_their_depth() {
    let sheared = |exponent: i32| {
        let s = 2.0_f64.powi(exponent);
        let columns = [[s, -s, 0.0], [0.0, s, -s], [1.0; 3]].map(DVec3::from_array);
        DAffine3::from_mat3(DMat3::from_cols(columns[0], columns[1], columns[2]))
    };
    let view = view(
        [1.0, 2.0, 3.0],
        [0.0; 3],
        perspective(40.0, 0.1, 100.0),
        [64, 48],
    );
    for exponent in [30, 45, 60, 100] {
        let squares = [exponent, exponent - 1].map(|e| object("S", Shape::Square, sheared(e)));
        let scene = Scene::new(squares.to_vec());
        let px = dvec2(20.25, 30.5);
        let hits = pick::all(&scene, view.ray(px), view.sides);
        assert_eq!(hits.len(), 2, "{exponent}");
        assert_eq!(places(&scene, &view).at(px), hits, "{exponent}");
    }
}

/// At each pixel, all squares that cover it are named.
#[test]
fn all_that_lie_in_one_plane_are_found() {
    let scene = coplanar();
    let lens = perspective(45.0, 0.1, 10.0);
    let view = view([0.0, 0.0, 3.0], [0.0; 3], lens, [96, 72]);
    let places = places(&scene, &view);
    let mut of_count = [0; 4];
    for px in centres(&view) {
        let hits = pick::all(&scene, view.ray(px), view.sides);
        of_count[hits.len()] += 1;
        let expected = if hits.len() > 1 { hits } else { Vec::new() };
        assert_eq!(places.at(px), expected, "{px}");
    }
    let [none, one, two, three] = of_count;
    assert!(
        none > 1000 && one > 200 && two > 150 && three > 300,
        "{of_count:?}"
    );
    let text = |x, y| in_one_place(&scene, &view, dvec2(x, y)).map(|all| all.to_string());
    assert_eq!(
        text(48.5, 36.5).as_deref(),
        Some("three in one place: A, B and C")
    );
    assert_eq!(text(0.5, 0.5), None);
}

/// The gap at which reversed depth tells two squares at depth 3 apart: a few times 2^-24 of the depth, 2e-7.
#[test]
fn a_gap_that_drawing_can_tell_or_not() {
    for (gap, found) in [
        (0.0, true),
        (1e-9, true),
        (2e-7, true),
        (2e-5, false),
        (0.1, false),
    ] {
        let scene = Scene::new(vec![
            object("behind", Shape::Square, turned(30.0, 1.0)),
            object("before", Shape::Square, moved(gap)),
        ]);
        let lens = perspective(45.0, 0.1, 10.0);
        let view = view([0.0, 0.0, 3.0], [0.0; 3], lens, [64, 48]);
        let places = places(&scene, &view);
        let marked = places.pixels(|| false).len();
        let both = |px: &DVec2| pick::all(&scene, view.ray(*px), view.sides).len() == 2;
        let both = centres(&view).filter(both).count();
        assert!(both > 250, "{both}");
        assert_eq!(marked, if found { both } else { 0 }, "{gap}");
    }
}

/// Two surfaces of one kind diverge across the picture, and the farther one is drawn. That is excused as *depth* where
/// both are in one place, and is a defect elsewhere.
#[test]
fn the_bound_is_the_one_that_excuses_depth() {
    let wedge = |angle: f64| DAffine3::from_rotation_x(0.3 + angle) * turned(10.0, 1.0);
    let ball = |size: f64| DAffine3::from_scale(dvec3(1.0, 1.0, size));
    let kinds = [
        (Shape::Square, [-4e-4, 4e-4].map(wedge)),
        (halves(), [-4e-4, 4e-4].map(wedge)),
        (
            Shape::Cube,
            [-4e-4, 4e-4].map(|angle| wedge(angle) * ball(0.3)),
        ),
        (Shape::Sphere, [1.0, 1.0 + 1e-5].map(ball)),
    ];
    for (shape, [a, b]) in kinds {
        let scene = Scene::new(vec![
            object("A", shape.clone(), a),
            object("B", shape.clone(), b),
        ]);
        for depth in [DepthMapping::Reversed, DepthMapping::Standard] {
            let lens = Lens {
                depth,
                ..perspective(45.0, 2.0, 10.0)
            };
            let view = view([1.0, 0.5, 3.0], [0.0; 3], lens, [160, 120]);
            let farther = |px: DVec2| {
                let hits = pick::all(&scene, view.ray(px), view.sides);
                let other = |hit: &&SceneHit| hit.object != hits[0].object;
                hits.iter().find(other).or(hits.first()).copied()
            };
            let drawn = pick::ids_by(&scene, &view, farther);
            let report = compare_made(&scene, &view, &drawn, &pick::ids(&scene, &view));
            let places = Places::new(&scene, &view, Rasteriser::COMMON);
            for at in &report.disagreements {
                let named = name(&scene, &places, at.pixel, at.drawn);
                match at.class {
                    Class::Depth => assert!(named, "{at:?}"),
                    Class::Unexplained => assert!(!named, "{at:?}"),
                    _ => {}
                }
            }
            let [close, apart] = [Class::Depth, Class::Unexplained].map(|c| report.count(c));
            assert!(
                close > 200 && apart > 200,
                "{} {depth}: {close} and {apart} of {}",
                shape.kind(),
                report.picked
            );
        }
    }
}

/// Surfaces behind the second one are found, too, as long as they are equally deep.
#[test]
fn not_only_the_next_one() {
    let squares = [0.0, 0.0, 1e-9, -1e-9, -1e-3];
    let mut objects: Vec<_> = squares
        .map(|z| object("square", Shape::Square, moved(z)))
        .into();
    objects.push(object("far", Shape::Cube, moved(-2.0)));
    let scene = Scene::new(objects);
    let view = view(
        [0.0, 0.0, 3.0],
        [0.0; 3],
        perspective(45.0, 0.1, 10.0),
        [64, 48],
    );
    let found = places(&scene, &view).at(dvec2(30.0, 20.0));
    let found: Vec<_> = found.iter().map(|hit| hit.object).collect();
    assert_eq!(found, [2, 0, 1, 3]);
    let said = in_one_place(&scene, &view, dvec2(30.0, 20.0)).expect("four");
    assert_eq!(
        said.to_string(),
        "4 in one place: 3 square, 1 square, 2 square and 4 square"
    );
}
