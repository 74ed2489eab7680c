//! Surfaces in one place: named wherever drawing may show another one than is picked, and nowhere else.

use crate::{
    blocks::one_mesh,
    common::{box_triangles, orthographic, perspective, view},
    drawn_once,
};
use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3, dvec2, dvec3};
use sightline::{
    camera::{DepthMapping, Lens, View},
    geometry::Placement,
    image::Id,
    pick::{self, InOnePlace, MOST_NAMED, SceneHit},
    scene::{self, Object, Progress, Scene, Shape},
    verify::{Class, Disagreement, Places, compare, in_one_place},
};

fn object(name: &str, shape: Shape, model: DAffine3) -> Object {
    Object::new(name, shape, Placement::new(model).expect("invertible"))
}

fn moved(z: f64) -> DAffine3 {
    DAffine3::from_translation(dvec3(0.0, 0.0, z))
}

fn turned(degrees: f64, side: f64) -> DAffine3 {
    DAffine3::from_scale_rotation_translation(
        dvec3(side, side, 1.0),
        DQuat::from_rotation_z(degrees.to_radians()),
        DVec3::ZERO,
    )
}

/// Side 2 about the origin in the plane z = 0; by triangles of these corners.
fn quad(triangles: Vec<[u32; 3]>) -> Shape {
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let corners = corners.map(|[x, y]| [x, y, 0.0_f32]);
    one_mesh(corners.to_vec(), triangles, DVec3::ZERO)
}

fn halves() -> Shape {
    quad(vec![[0, 1, 2], [0, 2, 3]])
}

/// Three squares in one plane.
fn coplanar() -> Scene {
    Scene::new(vec![
        object("A", Shape::Square, DAffine3::IDENTITY),
        object("B", Shape::Square, turned(30.0, 1.0)),
        object("C", Shape::Square, turned(60.0, 0.7)),
    ])
}

fn centres(view: &View) -> impl Iterator<Item = DVec2> {
    let size = view.viewport;
    let row = move |y: u32| (0..size.width()).map(move |x| dvec2(x.into(), y.into()) + 0.5);
    (0..size.height()).flat_map(row)
}

/// Whether the surfaces in one place at a pixel are there and have one that an id may stand for among them.
pub fn name(scene: &Scene, places: &Places, pixel: [u32; 2], id: Id) -> bool {
    let stands_for = |SceneHit { object, hit }: &SceneHit| {
        let first = scene.objects()[*object].shape.first_triangle();
        let triangle = hit.on_triangle.map_or(0, |at| at.triangle - first + 1);
        (object + 1, triangle) == (id.object as usize, id.triangle)
    };
    let px = DVec2::from(pixel.map(f64::from)) + 0.5;
    places.at(px).iter().any(stands_for)
}

/// Whether a pixel is of the class *depth* by two surfaces: neither by the empty buffer nor by the near or far plane, which
/// one of them lies on, to drawing.
pub fn is_of_two_surfaces(view: &View, at: &Disagreement) -> bool {
    let lens = view.camera.lens();
    let off = 1e-5 * (lens.far - lens.near).min(lens.near.abs().max(lens.far.abs()));
    let is_on_plane =
        |depth: f64| (depth - lens.near).abs() <= off || (depth - lens.far).abs() <= off;
    at.class == Class::Depth
        && [at.drawn, at.picked].iter().all(|id| id.object > 0)
        && !at.depth.into_iter().any(is_on_plane)
}

/// Draws and compares: how many pixels of the class *depth*, all of which name what is drawn, how many in one place, and
/// how many unexplained.
#[track_caller]
fn counts(scene: &Scene, view: &View) -> [usize; 3] {
    scene.build_trees();
    let report = compare(
        scene,
        view,
        &drawn_once(scene, view),
        &pick::ids(scene, view),
    );
    let places = Places::new(scene, view);
    for at in &report.disagreements {
        if at.class == Class::Depth {
            for id in [at.drawn, at.picked] {
                assert!(name(scene, &places, at.pixel, id), "{id:?} at {at:?}");
            }
        }
    }
    let marked = places.pixels(|| false);
    [
        report.count(Class::Depth),
        marked.len(),
        report.count(Class::Unexplained),
    ]
}

#[test]
fn coplanar_squares_seen_from_the_side() {
    let lens = perspective(45.0, 0.1, 10.0);
    let [depth, marked, unexplained] = counts(
        &coplanar(),
        &view([1.0, 2.0, 2.0], [0.0; 3], lens, [320, 240]),
    );
    assert!(depth > 500, "{depth}");
    assert!(marked > 2000, "{marked}");
    assert_eq!(unexplained, 0);
}

/// `f32` takes both for one and draws the first: that is no defect, and the pick names both.
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
    // But for a few on edges.
    assert!((depth..depth + 20).contains(&marked), "{depth} of {marked}");
    let said = in_one_place(&scene, &view, dvec2(80.0, 50.5)).expect("two");
    assert_eq!(said.to_string(), "two in one place: B and A");
}

#[test]
fn what_standard_depth_cannot_tell_far_away() {
    let loaded = scene::load(&["gallery:far_over_near".into()], &Progress::default());
    let scene = loaded.expect("an exhibit").scene;
    for (depth, expected) in [
        (DepthMapping::Reversed, 0..=0),
        (DepthMapping::Standard, 1000..=10_000),
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

/// At each pixel those squares that cover it.
#[test]
fn all_that_lie_in_one_plane_are_found() {
    let scene = coplanar();
    let lens = perspective(45.0, 0.1, 10.0);
    let view = view([0.0, 0.0, 3.0], [0.0; 3], lens, [96, 72]);
    let places = Places::new(&scene, &view);
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

/// As far as reversed depth tells two squares apart at depth 3: 2^-24 of it is 2e-7, of which the bound is some.
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
        let places = Places::new(&scene, &view);
        let marked = places.pixels(|| false).len();
        let both = |px: &DVec2| pick::all(&scene, view.ray(*px), view.sides).len() == 2;
        let both = centres(&view).filter(both).count();
        assert!(both > 250, "{both}");
        assert_eq!(marked, if found { both } else { 0 }, "{gap}");
    }
}

/// Two surfaces of one kind that come apart over the picture, the farther one drawn: it is excused as *depth* where both are
/// in one place, and a defect elsewhere.
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
            let report = compare(&scene, &view, &drawn, &pick::ids(&scene, &view));
            let places = Places::new(&scene, &view);
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

/// What lies behind another surface between them is found; what does not lie as deep is not.
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
    let found = Places::new(&scene, &view).at(dvec2(30.0, 20.0));
    let found: Vec<_> = found.iter().map(|hit| hit.object).collect();
    assert_eq!(found, [2, 0, 1, 3]);
    let said = in_one_place(&scene, &view, dvec2(30.0, 20.0)).expect("four");
    assert_eq!(
        said.to_string(),
        "4 in one place: 3 square, 1 square, 2 square and 4 square"
    );
}

/// Positions on the diagonal of a quad of two triangles, which both are hit there.
#[test]
fn an_edge_that_two_triangles_share_is_one_surface() {
    let once = Scene::new(vec![object("once", halves(), DAffine3::IDENTITY)]);
    let twice = Scene::new(vec![
        object("A", halves(), DAffine3::IDENTITY),
        object("B", halves(), DAffine3::IDENTITY),
    ]);
    let view = view(
        [0.0, 0.0, 3.0],
        [0.0; 3],
        perspective(45.0, 0.1, 10.0),
        [64, 48],
    );
    let hits = |scene: &Scene, px| pick::all(scene, view.ray(px), view.sides).len();
    for i in -9..=9 {
        let px = dvec2(32.0 + f64::from(i), 24.0 - f64::from(i));
        assert_eq!([hits(&once, px), hits(&twice, px)], [2, 4], "{px}");
        assert_eq!(Places::new(&once, &view).at(px), [], "{px}");
        let found = Places::new(&twice, &view).at(px);
        let found: Vec<_> = found.iter().map(|hit| hit.object).collect();
        assert_eq!(found, [0, 1], "{px}");
    }
}

#[test]
fn identical_triangles_are_as_many_surfaces() {
    for count in [2, 10_000] {
        let scene = Scene::new(vec![object(
            "faces",
            quad(vec![[0, 1, 2]; count]),
            DAffine3::IDENTITY,
        )]);
        scene.build_trees();
        let view = view(
            [0.0, 0.0, 3.0],
            [0.0; 3],
            perspective(45.0, 0.1, 10.0),
            [64, 48],
        );
        // Within, on an edge, on a corner.
        for px in [dvec2(40.5, 30.5), dvec2(35.0, 21.0), dvec2(32.0, 24.0)] {
            let said = in_one_place(&scene, &view, px).expect("identical ones");
            assert_eq!(said.count, count);
            let named: Vec<_> = said.named.iter().map(|at| at.triangle).collect();
            let expected: Vec<_> = (0..8).take(count).map(Some).collect();
            assert_eq!(named, expected);
            let start = "in one place: faces triangle 0";
            let text = if count == 2 {
                format!("two {start} and faces triangle 1")
            } else {
                let rest = [1, 2, 3, 4, 5, 6, 7].map(|i| format!(", faces triangle {i}"));
                format!("10000 {start}{} and 9992 more", rest.concat())
            };
            assert_eq!(said.to_string(), text);
        }
    }
}

/// A solid's front and back come together at its rim. Thin all over, they are two.
#[test]
fn a_rim_is_one_surface_and_a_thin_solid_two() {
    let (positions, triangles) = box_triangles(1.0);
    let mesh = one_mesh(positions, triangles, DVec3::ZERO);
    let turn = DMat3::from_rotation_y(0.5) * DMat3::from_rotation_x(0.4);
    let lenses = [perspective(45.0, 0.1, 10.0), orthographic(2.0, 0.1, 10.0)];
    let mut both_hit = 0;
    for shape in [Shape::Cube, mesh, Shape::Sphere] {
        for lens in lenses {
            let view = view([0.2, 0.1, 3.0], [0.0; 3], lens, [64, 48]);
            let solid = |thick: f64| {
                let linear = turn * DMat3::from_diagonal(dvec3(1.0, 1.0, thick));
                Scene::new(vec![object(
                    "it",
                    shape.clone(),
                    DAffine3::from_mat3(linear),
                )])
            };
            let scene = solid(1.0);
            let places = Places::new(&scene, &view);
            // From pixels within to pixels without, as near to the rim as f64 goes.
            for i in 0..60 {
                let (sin, cos) = (0.1 * f64::from(i)).sin_cos();
                let ray = |s: f64| dvec2(32.0, 24.0) + s * dvec2(cos, sin);
                let hit = |s: f64| pick::closest(&scene, view.ray(ray(s)), view.sides).is_some();
                let (mut inside, mut outside) = (0.0, 30.0);
                while 0.5 * (inside + outside) > inside && 0.5 * (inside + outside) < outside {
                    let middle = 0.5 * (inside + outside);
                    *(if hit(middle) {
                        &mut inside
                    } else {
                        &mut outside
                    }) = middle;
                }
                for back in [
                    0.0, 1e-12, 1e-9, 1e-6, 1e-4, 1e-3, 3e-3, 4e-3, 5e-3, 1e-2, 0.1, 1.0,
                ] {
                    let px = ray(inside - back);
                    both_hit += pick::all(&scene, view.ray(px), view.sides).len() / 2;
                    let found = places.at(px);
                    assert_eq!(found, [], "{} {back} from the rim at {px}", shape.kind());
                }
            }
            let thin = solid(1e-9);
            let said = in_one_place(&thin, &view, dvec2(33.0, 22.0)).expect("both sides");
            assert_eq!(said.count, 2, "{said}");
            assert_eq!(
                said.named.iter().map(|at| at.front).collect::<Vec<_>>(),
                [true, false]
            );
            if shape.triangles().is_none() {
                assert_eq!(said.to_string(), "two in one place: it front and it back");
            }
        }
    }
    assert!(both_hit > 4000, "{both_hit}");
}

#[test]
fn what_is_named_is_capped_and_counted() {
    let scene = Scene::new(
        (0..20)
            .map(|i| object(&format!("S{i}"), Shape::Square, turned(f64::from(i), 1.0)))
            .collect(),
    );
    let view = view(
        [0.0, 0.0, 3.0],
        [0.0; 3],
        perspective(45.0, 0.1, 10.0),
        [64, 48],
    );
    let said = in_one_place(&scene, &view, dvec2(32.5, 24.5)).expect("all of them");
    let InOnePlace { count, named } = &said;
    assert_eq!((*count, named.len()), (20, MOST_NAMED));
    assert_eq!(
        said.to_string(),
        "20 in one place: S0, S1, S2, S3, S4, S5, S6, S7 and 12 more"
    );
}
