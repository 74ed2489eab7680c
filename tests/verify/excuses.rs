//! The bounds excuse what drawing in `f32` must get wrong and nothing else. The cases are triangles slimmer than the
//! grid, floors that run under the eye, worlds of any size, sections, specks, and surfaces that `f32` cannot tell apart.

use crate::{
    broken_drawings::{SIZE, mapped},
    cameras::culled,
    common::{mesh, orthographic, perspective, view},
    compare, compare_made, drawn_once,
    scenes::{bumpy, object},
};
use glam::{DAffine3, DQuat, DVec2, DVec3};
use sightline::{
    camera::{DepthMapping, Lens, View},
    geometry::Section,
    image::Id,
    pick,
    scene::{Scene, Shape},
    verify::{Class, Verdict},
};

/// A pipe in front of a wall, six pixels wide and made of strips 1/400 pixel wide. Drawing may move an edge onto every
/// pixel of the pipe, yet nothing but the pipe can show there.
fn pipe(lens: Lens) -> (Scene, View) {
    const STRIPS: u32 = 4000;
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    for i in 0..STRIPS {
        let (x, z) = (std::f64::consts::TAU * f64::from(i) / f64::from(STRIPS)).sin_cos();
        positions
            .extend([-1.0, 1.0].map(|y| DVec3::new(0.15 * x, y, 0.15 * z).as_vec3().to_array()));
        let [a, b] = [2 * i, 2 * ((i + 1) % STRIPS)];
        triangles.extend([[a, b, b + 1], [a, b + 1, a + 1]]);
    }
    let mesh = Shape::Mesh {
        mesh: mesh(positions, triangles, DVec3::ZERO),
        part: 0,
    };
    let wall =
        DAffine3::from_scale_rotation_translation(DVec3::splat(4.0), DQuat::IDENTITY, DVec3::NEG_Z);
    let scene = Scene::new(vec![
        object("pipe", mesh, DAffine3::from_rotation_z(0.3), None),
        object("wall", Shape::Square, wall, None),
    ]);
    let view = view([0.0, 0.0, 5.0], [0.01, 0.02, 0.0], lens, SIZE);
    (scene, view)
}

#[test]
fn a_mesh_missing_whose_triangles_are_slimmer_than_the_grid() {
    for lens in [orthographic(7.5, 0.5, 20.0), perspective(73.0, 0.5, 20.0)] {
        let (scene, both_sides) = pipe(lens);
        for view in [both_sides, culled(&both_sides)] {
            is_missed(&scene, &view, 150);
        }
    }
}

/// Asserts that verify agrees with a right drawing, and finds out one without the first object, which more than `least`
/// pixels show.
#[track_caller]
fn is_missed(scene: &Scene, view: &View, least: usize) {
    scene.build_trees();
    let picked = pick::ids(scene, view);
    let right = compare(scene, view, &drawn_once(scene, view), &picked);
    let worst = right.worst();
    assert_eq!(right.verdict(), Verdict::Agrees, "{view:?}: {worst:?}");
    let shown = picked.pixels().iter().filter(|id| id.object == 1).count();
    assert!(shown > least, "only {shown} pixels show it: {view:?}");
    let mut without = scene.clone();
    without.set_visible(0, false);
    let wrong = compare(scene, view, &drawn_once(&without, view), &picked);
    let found = wrong.count(Class::Unexplained);
    assert!(
        found >= shown * 9 / 10,
        "{found} of {shown} are found out: {:?}, {view:?}",
        wrong.worst()
    );
}

/// A board that shows its back, of strips this wide, in a picture with one unit per pixel. One edge runs 0.001 pixels
/// beside a row of pixel centres; `below` says how many of the strips lie on the far side of it.
fn board_from_behind(strips: u32, width_px: f64, below: u32) -> (Scene, View) {
    let row = 0.5 + 0.001 - f64::from(below) * width_px;
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    for i in 0..=strips {
        let y = row + f64::from(i) * width_px;
        positions.extend([-50.0, 50.0].map(|x| DVec3::new(x, y, 0.0).as_vec3().to_array()));
    }
    for i in 0..strips {
        let a = 2 * i;
        triangles.extend([[a, a + 3, a + 1], [a, a + 2, a + 3]]);
    }
    let mesh = mesh(positions, triangles, DVec3::ZERO);
    let board = object(
        "board",
        Shape::Mesh { mesh, part: 0 },
        DAffine3::IDENTITY,
        None,
    );
    let (_, view) = in_pixels(&[]);
    (Scene::new(vec![board]), culled(&view))
}

/// Moving corners may turn over a triangle as slim as the grid. Of a back, such a triangle may show though picks find
/// nothing. A wider one may not, not even at its edges.
#[test]
fn of_a_back_only_triangles_as_slim_as_the_grid_may_show() {
    // The middle of many, where only other strips are near; the board's edge; an edge between wide strips.
    for (strips, width_px, below, class) in [
        (40, 0.004, 20, Class::Edge),
        (40, 0.0075, 20, Class::Edge),
        (40, 0.009, 20, Class::Unexplained),
        (1, 0.4, 0, Class::Unexplained),
        (2, 0.4, 1, Class::Unexplained),
    ] {
        let (scene, view) = board_from_behind(strips, width_px, below);
        let picked = pick::ids(&scene, &view);
        assert!(picked.pixels().iter().all(|id| *id == Id::default()));
        let nearest = 2 * below.min(strips - 1) + 1;
        let wrong = mapped(&picked, |x, y| {
            let is_on_board = y == SIZE[1] / 2 - 1 && (60..140).contains(&x);
            if is_on_board {
                Id {
                    object: 1,
                    triangle: nearest,
                }
            } else {
                Id::default()
            }
        });
        let report = compare_made(&scene, &view, &wrong, &picked);
        assert_eq!(report.drawn, 80);
        assert_eq!(report.count(class), 80, "{width_px}: {:?}", report.worst());
    }
}

/// A floor runs from before the eye to behind it, and the near plane is as close as 1e-6. The part behind the eye must
/// not cost digits of the visible part.
#[test]
fn a_floor_under_the_eye_missing() {
    let floor = DAffine3::from_rotation_x(-std::f64::consts::FRAC_PI_2)
        * DAffine3::from_scale(DVec3::splat(40.0));
    let scene = Scene::new(vec![
        object("floor", Shape::Square, floor, None),
        object(
            "box",
            Shape::Cube,
            DAffine3::from_translation(DVec3::new(0.3, 0.5, -4.0)),
            None,
        ),
    ]);
    for near in [1e-2, 1e-6] {
        let lens = perspective(60.0, near, 100.0);
        let view = view([0.0, 1.6, 1.0], [0.5, 1.2, -4.0], lens, SIZE);
        is_missed(&scene, &view, 10_000);
    }
}

fn bumpy_mesh() -> Shape {
    let (positions, triangles) = bumpy(3);
    Shape::Mesh {
        mesh: mesh(positions, triangles, DVec3::ZERO),
        part: 0,
    }
}

/// However large or small the world is: products of lengths leave the range of `f32`.
#[test]
fn a_shape_missing_in_worlds_of_any_size() {
    for exponent in [-24, -15, -8, 8, 15, 29] {
        let size = 10_f64.powi(exponent);
        let place = |at: DVec3, scale: f64| {
            DAffine3::from_translation(size * at) * DAffine3::from_scale(DVec3::splat(size * scale))
        };
        let perspective = perspective(45.0, size, 30.0 * size);
        let orthographic = orthographic(3.0 * size, size, 30.0 * size);
        for shape in [bumpy_mesh(), Shape::Cube] {
            let scene = Scene::new(vec![
                object("shape", shape, place(DVec3::ZERO, 1.0), None),
                object("wall", Shape::Square, place(-2.0 * DVec3::Z, 9.0), None),
            ]);
            let eye = [0.5, 0.7, 5.0].map(|along: f64| size * along);
            for lens in [perspective, orthographic] {
                is_missed(&scene, &view(eye, [0.0; 3], lens, SIZE), 1000);
            }
        }
    }
}

/// A drawing shows a shape that the section cuts away. Its outline explains none of that.
#[test]
fn a_section_that_does_not_cut() {
    let size = DAffine3::from_scale(DVec3::splat(1.2));
    for (name, shape) in [
        ("square", Shape::Square),
        ("cube", Shape::Cube),
        ("sphere", Shape::Sphere),
        ("mesh", bumpy_mesh()),
    ] {
        let scene = Scene::new(vec![object(name, shape, size, None)]);
        for lens in [perspective(45.0, 1.0, 30.0), orthographic(3.0, 1.0, 30.0)] {
            let whole = view([0.5, 0.7, 5.0], [0.0, 0.0, 0.0], lens, SIZE);
            let section = Section::through(DVec3::new(0.0, 2.0, 0.0), DVec3::Y).ok();
            let cut = View { section, ..whole };
            let [drawn, picked] = [drawn_once(&scene, &whole), pick::ids(&scene, &cut)];
            let report = compare(&scene, &cut, &drawn, &picked);
            assert!(report.drawn > 1000 && report.picked == 0, "{name}");
            let found = report.count(Class::Unexplained);
            assert_eq!(found, report.drawn, "{name}: {report:?}");
        }
    }
}

/// The GPU gets the same numbers for both squares. A pick knows that the second one is nearer.
#[test]
fn what_f32_cannot_tell_apart_is_as_deep() {
    let square = |depth: f64| {
        let turn = DAffine3::from_rotation_y(0.3) * DAffine3::from_scale(DVec3::splat(3.0));
        object(
            "square",
            Shape::Square,
            DAffine3::from_translation(depth * DVec3::Z) * turn,
            None,
        )
    };
    let scene = Scene::new(vec![square(0.0), square(1e-11)]);
    let view = view(
        [0.1, 0.2, 5.0],
        [0.4, 0.3, 0.0],
        perspective(45.0, 1.0, 30.0),
        SIZE,
    );
    let picked = pick::ids(&scene, &view);
    let report = compare(&scene, &view, &drawn_once(&scene, &view), &picked);
    assert_eq!(report.verdict(), Verdict::Agrees, "{:?}", report.worst());
    assert!(report.count(Class::Depth) > 5000, "{report:?}");
}

/// Squares and wires, by centre and size, in a picture with one unit per pixel and pixel centres at halves.
fn in_pixels(squares: &[(DVec3, DVec2)]) -> (Scene, View) {
    let squares = squares.iter().map(|(centre, size)| {
        let scale = DAffine3::from_scale(size.extend(1.0));
        let at = DAffine3::from_translation(*centre) * scale;
        object("square", Shape::Square, at, None)
    });
    let lens = orthographic(SIZE[1].into(), 1.0, 100.0);
    let view = view([0.0, 0.0, 50.0], [0.0, 0.0, 0.0], lens, SIZE);
    (Scene::new(squares.collect()), view)
}

/// The verdicts on a blank drawing with right picks, and on empty picks with a right drawing.
fn one_sided(squares: &[(DVec3, DVec2)]) -> [Verdict; 2] {
    let (scene, view) = in_pixels(squares);
    let all = pick::ids(&scene, &view);
    let blank = mapped(&all, |_, _| Id::default());
    [(&blank, &all), (&all, &blank)]
        .map(|(drawn, picked)| compare(&scene, &view, drawn, picked).verdict())
}

/// A speck smaller than a pixel may be missed if a pixel's centre lies within the grid of its edge. It may not be
/// missed if the centre lies farther inside.
#[test]
fn a_speck_at_an_edge_is_no_blank_picture() {
    let at = |px: f64, inside: f64| {
        (
            DVec3::new(px + 0.5 - 0.2 + inside, 0.5, 0.0),
            DVec2::splat(0.4),
        )
    };
    let speck = [at(3.0, 0.001)];
    assert_eq!(one_sided(&speck), [Verdict::Agrees; 2]);
    // Drawing really leaves this speck out.
    let (scene, view) = in_pixels(&speck);
    assert_eq!(
        pick::ids(&scene, &view)
            .pixels()
            .iter()
            .filter(|id| id.object > 0)
            .count(),
        1
    );
    let drawn = drawn_once(&scene, &view);
    assert!(
        drawn.pixels().iter().all(|id| id.object == 0),
        "it is drawn"
    );
    assert_eq!(one_sided(&[at(3.0, 0.2)]), [Verdict::Unexplained(1); 2]);
    let four: Vec<_> = (0..4).map(|i| at(f64::from(i), 0.001)).collect();
    assert_eq!(one_sided(&four), [Verdict::Agrees; 2]);
    let five: Vec<_> = (0..5).map(|i| at(f64::from(i), 0.001)).collect();
    assert_eq!(
        one_sided(&five),
        [Verdict::NothingDrawn(5), Verdict::NothingPicked(5)]
    );
}

/// A wire runs through the pixel centres of a row. Each pixel lies on an edge, but the whole row may not be missing.
#[test]
fn a_blank_picture_fails_where_an_edge_explains_each_pixel() {
    let wire = [(DVec3::new(0.0, 0.5, 0.0), DVec2::new(150.0, 0.002))];
    assert_eq!(
        one_sided(&wire),
        [Verdict::NothingDrawn(150), Verdict::NothingPicked(150)]
    );
}

/// A board just in front of a cube's back face is drawn in front of the cube. The board is as deep as the back face,
/// but that is no excuse, since picks show the front face. With near at the eye, standard depth tells none of the three
/// apart.
#[test]
fn a_cubes_front_missing_before_a_board_at_its_back() {
    let board = |z: f64| {
        let model = DAffine3::from_translation(DVec3::Z * z);
        Scene::new(vec![
            object("cube", Shape::Cube, DAffine3::IDENTITY, None),
            object("board", Shape::Square, model, None),
        ])
    };
    let lens = Lens {
        depth: DepthMapping::Standard,
        ..perspective(30.0, 1e-7, 100.0)
    };
    let view = view([0.0, 0.0, 5.0], [0.0; 3], lens, SIZE);
    let (scene, wrong) = (board(-0.4999), board(0.5001));
    let picked = pick::ids(&scene, &view);
    let report = compare_made(&scene, &view, &pick::ids(&wrong, &view), &picked);
    let lost = report.disagreements.iter();
    let lost = lost.filter(|at| (at.drawn.object, at.picked.object) == (2, 1));
    let counts = lost.fold([0; 6], |mut counts, at| {
        counts[at.class as usize] += 1;
        counts
    });
    let [edge, depth, section, limit, beyond, _] = counts;
    assert!(beyond > 1000, "{counts:?}");
    assert_eq!([depth, section, limit], [0; 3], "{counts:?}");
    assert!(edge < 300, "{counts:?}");
}
