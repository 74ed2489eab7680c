//! Verify finds every broken drawing, each with a typical bug, on ordinary views where the right drawing passes.

use crate::{
    cameras::culled,
    common::{orthographic, perspective, view},
    compare, drawn_once,
    scenes::shapes,
};
use glam::{DAffine3, DVec3};
use sightline::{
    camera::{DepthMapping, Lens, View},
    geometry::Placement,
    image::{Id, Image},
    pick::{self, SceneHit},
    scene::{self, Object, Progress, Scene},
    verify::{Class, Report, Verdict},
};

pub const SIZE: [u32; 2] = [200, 150];

/// A scene, a view of it, and the right drawing.
struct Case {
    name: &'static str,
    scene: Scene,
    view: View,
    drawn: Image<Id>,
    picked: Image<Id>,
}

/// Ordinary views of all shapes and of the demo, with every kind of lens.
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

/// Asserts for each case that the right drawing agrees, and that `broken` leaves at least `least` pixels unexplained.
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

/// Standard depth between planes this far apart stores the far plane's depth for everything, so it cannot tell a
/// surface from nothing. Still, neither a blank picture nor one with a tenth left may pass.
#[test]
fn a_picture_that_standard_depth_loses_fails() {
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
    let lost = report.count(Class::BeyondF32);
    assert!(lost > 5000, "{:?}", report.worst());
    assert_eq!(report.count(Class::Depth), 0, "{:?}", report.worst());
    assert_eq!(report.count(Class::Unexplained), 0, "{:?}", report.worst());
    assert_eq!(report.verdict(), Verdict::NothingDrawn(report.picked));
    let report = compare(&scene, &view, &picked, &blank);
    assert_eq!(report.verdict(), Verdict::NothingPicked(report.drawn));
    assert!((0.0..=1.0).contains(&report.share_of_outline()));
    assert!(report.differ_off_outlines() > 1000);
    let kept = |x: u32, y: u32| {
        if x.is_multiple_of(10) {
            picked.at(x, y)
        } else {
            Id::default()
        }
    };
    let report = compare(&scene, &view, &mapped(&picked, kept), &picked);
    assert!((1..lost).contains(&report.drawn));
    assert!(
        matches!(report.verdict(), Verdict::BeyondF32(pixels) if pixels > lost / 2),
        "{:?}",
        report.verdict()
    );
}

/// An id picture of the same size as `size`, computed pixel by pixel.
pub fn mapped(size: &Image<Id>, id: impl Fn(u32, u32) -> Id) -> Image<Id> {
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

/// The misplaced near plane cuts away about half of what is shown.
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

/// The object that covers most pixels.
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

/// The object is moved by a hundredth of a unit along each axis, as rounded matrices may do.
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

/// The pixels of one mesh triangle show what is behind it.
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
