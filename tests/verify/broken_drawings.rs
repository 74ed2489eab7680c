//! Drawings that are wrong in the ways that drawings are: each is found out, on ordinary views where the right one is not.

use crate::{
    cameras::culled,
    common::{mesh, orthographic, perspective, view},
    drawn_once,
    scenes::{object, shapes},
};
use glam::{DAffine3, DQuat, DVec2, DVec3};
use sightline::{
    camera::{DepthMapping, Lens, View},
    geometry::Placement,
    image::{Id, Image},
    pick::{self, SceneHit},
    scene::{self, Object, Progress, Scene, Shape},
    verify::{Class, Report, Verdict, compare},
};

const SIZE: [u32; 2] = [200, 150];

/// A scene, a view of it, and what is drawn rightly.
struct Case {
    name: &'static str,
    scene: Scene,
    view: View,
    drawn: Image<Id>,
    picked: Image<Id>,
}

/// Ordinary views of all shapes and of the demo, through lenses of each kind.
fn cases() -> Vec<Case> {
    let demo = scene::load(&[], &Progress::default()).expect("the demo");
    let scenes = [("shapes", shapes(DVec3::ZERO)), ("demo", demo.scene)];
    let lenses = [
        perspective(45.0, 1.0, 30.0),
        perspective(90.0, 0.01, 1000.0),
        orthographic(6.0, 0.5, 20.0),
    ];
    let mut cases = Vec::new();
    for (name, scene) in scenes {
        for (i, lens) in lenses.into_iter().enumerate() {
            let seen = view([3.5, 2.8, 5.6], [0.0, 0.3, 0.0], lens, SIZE);
            let view = if i == 1 { culled(&seen) } else { seen };
            cases.push(Case {
                name,
                drawn: drawn_once(&scene, &view),
                picked: pick::ids(&scene, &view),
                scene: scene.clone(),
                view,
            });
        }
    }
    cases
}

impl Case {
    fn compare(&self, drawn: &Image<Id>) -> Report {
        compare(&self.scene, &self.view, drawn, &self.picked)
    }
}

/// Fails unless the right drawing of each case agrees, and the `broken` one leaves at least so many pixels unexplained.
#[track_caller]
fn found_out(least: usize, broken: impl Fn(&Case) -> Image<Id>) {
    for case in cases() {
        let right = case.compare(&case.drawn);
        let shown = right.drawn.min(right.picked);
        assert!(shown > 1000, "{}: only {shown} pixels shown", case.name);
        assert_eq!(right.verdict(), Verdict::Agrees, "{}", case.name);
        let wrong = case.compare(&broken(&case));
        let unexplained = wrong.count(Class::Unexplained);
        println!(
            "{}: {unexplained} of {} pixels that differ are unexplained",
            case.name,
            wrong.disagreements.len()
        );
        assert!(
            unexplained >= least,
            "{}: only {unexplained} of {} pixels that differ are found out",
            case.name,
            wrong.disagreements.len()
        );
        assert_eq!(wrong.verdict(), Verdict::Unexplained(unexplained));
    }
}

/// Standard depth between planes so far apart stores the far plane's depth for everything: each pixel by itself is
/// explained, a blank picture is not.
#[test]
fn a_blank_picture_fails_where_depth_explains_each_pixel() {
    let scene = shapes(DVec3::ZERO);
    let lens = Lens {
        depth: DepthMapping::Standard,
        ..perspective(45.0, 1e-9, 1e3)
    };
    let view = view([3.5, 2.8, 5.6], [0.0, 0.3, 0.0], lens, SIZE);
    let picked = pick::ids(&scene, &view);
    let blank = mapped(&picked, |_, _| Id::default());
    let report = compare(&scene, &view, &blank, &picked);
    assert!(report.picked > 5000, "{} picked", report.picked);
    assert!(report.count(Class::Depth) > 5000, "{:?}", report.worst());
    assert_eq!(report.count(Class::Unexplained), 0, "{:?}", report.worst());
    assert_eq!(report.verdict(), Verdict::NothingDrawn(report.picked));
    let report = compare(&scene, &view, &picked, &blank);
    assert_eq!(report.verdict(), Verdict::NothingPicked(report.drawn));
    assert!((0.0..=1.0).contains(&report.share_of_outline()));
    assert!(report.differ_off_outlines() > 1000);
}

/// An id picture from another one's ids.
fn mapped(size: &Image<Id>, id: impl Fn(u32, u32) -> Id) -> Image<Id> {
    let mut picture = size.clone();
    let width = size.size().width();
    let positions: Vec<_> = size.positions().collect();
    for (x, y) in positions {
        picture.pixels_mut()[(y * width + x) as usize] = id(x, y);
    }
    picture
}

#[test]
fn a_blank_picture() {
    found_out(1000, |case| mapped(&case.drawn, |_, _| Id::default()));
}

#[test]
fn a_picture_shifted_by_a_pixel() {
    for [dx, dy] in [[1, 0], [0, 1]] {
        found_out(300, |case| {
            mapped(&case.drawn, |x, y| {
                (case.drawn).at(u32::saturating_sub(x, dx), u32::saturating_sub(y, dy))
            })
        });
    }
}

/// Half of what is shown lies before the wrong plane.
#[test]
fn a_wrong_near_plane() {
    found_out(500, |case| {
        let depth = case.view.camera.eye().length();
        let lens = Lens {
            near: depth,
            ..*case.view.camera.lens()
        };
        let camera = case.view.camera.with_lens(lens).expect("a lens");
        let view = View {
            camera,
            ..case.view
        };
        drawn_once(&case.scene, &view)
    });
}

/// The object that most pixels show.
fn most_shown(ids: &Image<Id>) -> usize {
    let mut counts = std::collections::BTreeMap::new();
    for id in ids.pixels().iter().filter(|id| id.object > 0) {
        *counts.entry(id.object).or_insert(0) += 1;
    }
    let most = counts.into_iter().max_by_key(|&(_, count)| count);
    most.expect("something is shown").0 as usize - 1
}

#[test]
fn an_object_missing() {
    found_out(300, |case| {
        let mut scene = case.scene.clone();
        scene.set_visible(most_shown(&case.drawn), false);
        drawn_once(&scene, &case.view)
    });
}

#[test]
fn what_is_behind_drawn_before() {
    found_out(300, |case| {
        pick::ids_by(&case.scene, &case.view, |px| {
            let hits = pick::all(&case.scene, case.view.ray(px), case.view.sides);
            let other = |hit: &&SceneHit| hit.object != hits[0].object;
            hits.iter().rev().find(other).or(hits.first()).copied()
        })
    });
}

/// A hundredth of its size, where it stands: what an object drawn from rounded matrices looks like.
#[test]
fn an_object_moved_by_a_hundredth() {
    found_out(5, |case| {
        let moved = most_shown(&case.drawn);
        let objects = case.scene.objects().iter().enumerate().map(|(i, object)| {
            let model = object.placement.model();
            let by = if i == moved {
                DVec3::splat(0.01)
            } else {
                DVec3::ZERO
            };
            let model = DAffine3::from_translation(by) * model;
            Object {
                placement: Placement::new(model).expect("invertible"),
                ..object.clone()
            }
        });
        drawn_once(&Scene::new(objects.collect()), &case.view)
    });
}

/// A pipe through the middle of a wall, six pixels wide, of strips a four-hundredth of a pixel wide: each pixel lies as near
/// to an edge as drawing may move edges, and yet nothing but the pipe can show.
fn pipe() -> (Scene, View) {
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
    let lens = orthographic(7.5, 0.5, 20.0);
    let view = view([0.0, 0.0, 5.0], [0.01, 0.02, 0.0], lens, SIZE);
    (scene, view)
}

#[test]
fn a_mesh_missing_whose_triangles_are_slimmer_than_the_grid() {
    let (scene, view) = pipe();
    let picked = pick::ids(&scene, &view);
    let right = compare(&scene, &view, &drawn_once(&scene, &view), &picked);
    assert_eq!(right.verdict(), Verdict::Agrees, "{:?}", right.worst());
    let shown = picked.pixels().iter().filter(|id| id.object == 1).count();
    assert!(shown > 150, "only {shown} pixels show the pipe");
    let mut without = scene.clone();
    without.set_visible(0, false);
    let wrong = compare(&scene, &view, &drawn_once(&without, &view), &picked);
    let found = wrong.count(Class::Unexplained);
    assert!(found >= shown * 9 / 10, "{found} of {shown} are found out");
}

/// Pixels that show one triangle of a mesh show what is behind it.
#[test]
fn a_triangle_missing() {
    found_out(2, |case| {
        let mut counts = std::collections::BTreeMap::new();
        for id in case.picked.pixels().iter().filter(|id| id.triangle > 0) {
            *counts.entry([id.object, id.triangle]).or_insert(0) += 1;
        }
        let most = counts.into_iter().max_by_key(|&(_, count)| count);
        let [object, triangle] = most.expect("a mesh is shown").0;
        let missing = Id { object, triangle };
        let behind = pick::ids_by(&case.scene, &case.view, |px| {
            let hits = pick::all(&case.scene, case.view.ray(px), case.view.sides);
            hits.get(1).copied()
        });
        mapped(&case.drawn, |x, y| {
            if case.drawn.at(x, y) == missing {
                behind.at(x, y)
            } else {
                case.drawn.at(x, y)
            }
        })
    });
}

/// From before the eye to behind it, with a near plane a millionth of a step away: what is behind the eye takes no digits
/// from what is seen.
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
        let picked = pick::ids(&scene, &view);
        let right = compare(&scene, &view, &drawn_once(&scene, &view), &picked);
        assert_eq!(
            right.verdict(),
            Verdict::Agrees,
            "{near}: {:?}",
            right.worst()
        );
        let shown = picked.pixels().iter().filter(|id| id.object == 1).count();
        assert!(shown > 10_000, "only {shown} pixels show the floor");
        let mut without = scene.clone();
        without.set_visible(0, false);
        let wrong = compare(&scene, &view, &drawn_once(&without, &view), &picked);
        let found = wrong.count(Class::Unexplained);
        assert!(
            found >= shown * 9 / 10,
            "{near}: {found} of {shown} are found out"
        );
    }
}

/// The GPU gets the same numbers for both, of which a pick tells the second one to be nearer.
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
        [0.0, 0.0, 5.0],
        [0.0, 0.0, 0.0],
        perspective(45.0, 1.0, 30.0),
        SIZE,
    );
    let picked = pick::ids(&scene, &view);
    let report = compare(&scene, &view, &drawn_once(&scene, &view), &picked);
    assert_eq!(report.verdict(), Verdict::Agrees, "{:?}", report.worst());
    assert!(report.count(Class::Depth) > 5000, "{report:?}");
}

/// Squares and wires in a picture of a unit a pixel, whose pixel centres lie at halves: centre and size.
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

/// What a blank drawing of it comes to, and what picks of nothing where all of it is drawn come to.
fn one_sided(squares: &[(DVec3, DVec2)]) -> [Verdict; 2] {
    let (scene, view) = in_pixels(squares);
    let all = pick::ids(&scene, &view);
    let blank = mapped(&all, |_, _| Id::default());
    [(&blank, &all), (&all, &blank)]
        .map(|(drawn, picked)| compare(&scene, &view, drawn, picked).verdict())
}

/// Something smaller than a pixel may be seen or not where a centre lies on its edge, to the grid; where it lies inside, it
/// must be.
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
    // Drawing leaves it out indeed.
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

/// A wire through the centres of a row: each of its pixels lies on an edge, but all of them are a picture.
#[test]
fn a_blank_picture_fails_where_an_edge_explains_each_pixel() {
    let wire = [(DVec3::new(0.0, 0.5, 0.0), DVec2::new(150.0, 0.002))];
    assert_eq!(
        one_sided(&wire),
        [Verdict::NothingDrawn(150), Verdict::NothingPicked(150)]
    );
}
