//! Drawing in `f32` stays within its bounds, or verify says that the view is beyond `f32`. The scenes are the families
//! that `tests/exact_picks` compares with exact arithmetic.
//!
//! `SIGHTLINE_VIEWS=1000 cargo test --locked --release --test verify -- --nocapture views` compares that many views of
//! each family and prints a line for each.

use crate::{
    blocks::{Layout, Sample, chance},
    common::{self, Random},
    compare, drawn, families, lattice,
    one_place::{is_of_two_surfaces, name},
    places,
    scenes::gpu,
    ties,
};
use glam::{DAffine3, DMat3, DQuat};
use sightline::{
    camera::{DepthMapping, Lens, View, Viewport, fit_near_far},
    geometry::Placement,
    pick,
    render::{Gpu, Renderer, SceneBuffers},
    scene::{Object, Scene, Shape},
    verify::{Class, Disagreement, Report, Verdict},
};
use std::f64::consts::TAU;

/// Views of each family in an ordinary run: enough that edges between two neighbours seen edge-on occur.
const VIEWS: usize = 40;

/// Small pictures: there are many.
const SIZES: [[u32; 2]; 3] = [[64, 48], [61, 37], [31, 80]];

/// Counts over the views of a family.
#[derive(Default)]
struct Tally {
    picked: usize,
    drawn: usize,
    classes: [usize; 6],
    /// Views that are beyond `f32` only by their planes or their depth mapping.
    by_planes: usize,
    /// Views with pixels beyond `f32`; then views with nothing drawn or nothing picked.
    beyond: usize,
    one_sided: usize,
    defects: Vec<String>,
    /// Pixels of the class *depth* because of two surfaces. The picks there name the drawn surface.
    of_two: usize,
}

impl Tally {
    fn add(&mut self, report: &Report, sample: &Sample) {
        self.picked += report.picked;
        self.drawn += report.drawn;
        for (count, class) in self.classes.iter_mut().zip(Class::ALL) {
            *count += report.count(class);
        }
        match report.verdict() {
            Verdict::Agrees => {}
            Verdict::BeyondF32(_) => self.beyond += 1,
            Verdict::NothingDrawn(_) | Verdict::NothingPicked(_) => self.one_sided += 1,
            Verdict::Unexplained(pixels) => self.defects.push(format!(
                "{pixels} pixels, {:?}, {:?}",
                report.worst(),
                sample.view
            )),
        }
    }
}

/// The limits of a family's counts.
struct Expected {
    /// Pixels that must show something, both drawn and picked, per thousand.
    shown: usize,
    /// Views that may be beyond `f32`, per thousand.
    beyond: usize,
    /// Pixels of the class *depth* at a plane of the lens, per thousand views.
    at_planes: usize,
    /// Views with one picture empty, per thousand: where a plane of the lens lies on a visible surface.
    one_sided: usize,
}

/// Views, in a thousand of each family, that may be beyond `f32` only by their planes or depth mapping: planes a
/// million times as far apart as what lies between them, or standard depth with the near plane at the eye.
const BY_PLANES: usize = 250;

fn wanted() -> usize {
    common::wanted("SIGHTLINE_VIEWS", VIEWS)
}

fn run(name: &str, seed: u64, make: fn(&mut Random) -> Sample, expected: &Expected) {
    let gpu = gpu();
    let mut renderer = Renderer::new(&gpu, 1);
    let mut random = Random::new(seed);
    let mut tally = Tally::default();
    let mut pixels = 0;
    for _ in 0..wanted() {
        let mut sample = make(&mut random);
        let [width, height] = SIZES[random.below(3)];
        sample.view.viewport = Viewport::new(width, height).expect("a viewport");
        if chance(&mut random, 4) {
            let lens = Lens {
                depth: DepthMapping::Standard,
                ..*sample.view.camera.lens()
            };
            sample.view.camera = sample.view.camera.with_lens(lens).expect("a lens");
        }
        let mut report = compared(&gpu, &mut renderer, &sample);
        if matches!(report.verdict(), Verdict::BeyondF32(_)) {
            let fitted = with_planes_that_fit(&sample);
            let again = compared(&gpu, &mut renderer, &fitted);
            if again.verdict() == Verdict::Agrees {
                (sample, report) = (fitted, again);
                tally.by_planes += 1;
            }
        }
        tally.of_two += depths_are_named(name, &sample, &report);
        pixels += report.pixels;
        tally.add(&report, &sample);
    }
    let [edge, depth, _, limit, beyond, unexplained] = tally.classes;
    println!(
        "{name:16} {pixels:>9} pixels, {:>8} picked, {:>8} drawn: {edge} edge, {depth} depth, {limit} f32 limit, \
         {beyond} beyond in {} views, {} only by their planes, {} one-sided, {unexplained} unexplained, {} of two",
        tally.picked, tally.drawn, tally.beyond, tally.by_planes, tally.one_sided, tally.of_two
    );
    assert!(
        tally.defects.is_empty(),
        "{name}: {}",
        tally.defects.join("\n")
    );
    // In the rest of the class *depth*, one of the two surfaces is the near or the far plane.
    let at_planes = depth - tally.of_two;
    let shown = tally.picked.min(tally.drawn) * 1000 / pixels;
    assert!(
        shown >= expected.shown,
        "{name}: only {shown} in 1000 show something"
    );
    for (what, seen, most) in [
        (
            "with a surface on a plane of the lens",
            at_planes,
            expected.at_planes,
        ),
        ("beyond f32 by their planes", tally.by_planes, BY_PLANES),
        ("beyond f32", tally.beyond, expected.beyond),
        ("one-sided", tally.one_sided, expected.one_sided),
    ] {
        // With so few views, a single one is allowed.
        let most = if most > 0 {
            1 + most * wanted() / 1000
        } else {
            0
        };
        assert!(seen <= most, "{name}: {seen} views or pixels are {what}");
    }
}

/// The same view with reversed depth, and near and far fitted to the scene.
fn with_planes_that_fit(Sample { scene, view, .. }: &Sample) -> Sample {
    let (near, far) = fit_near_far(&view.camera, &scene.visible_bounds(), None, None);
    let lens = Lens {
        near,
        far,
        depth: DepthMapping::Reversed,
        ..*view.camera.lens()
    };
    let camera = view.camera.with_lens(lens).expect("planes that fit");
    Sample {
        scene: scene.clone(),
        view: View { camera, ..*view },
        positions: Vec::new(),
        layout: Layout::Anywhere,
    }
}

fn compared(gpu: &Gpu, renderer: &mut Renderer, sample: &Sample) -> Report {
    let Sample { scene, view, .. } = sample;
    scene.build_trees();
    let buffers = SceneBuffers::upload(gpu, scene).expect("fits");
    let drawn = drawn(gpu, renderer, &buffers, view);
    compare(scene, view, &drawn, &pick::ids(scene, view))
}

/// Counts pixels of the class *depth* that show one surface and pick another. Asserts that the pick names both, but where
/// the near plane may cut a face that passes the eye edge-on: that plane has no name, and its error is any depth.
fn depths_are_named(family: &str, Sample { scene, view, .. }: &Sample, report: &Report) -> usize {
    let places = places(scene, view);
    let of_two = report.disagreements.iter();
    let of_two = of_two.filter(|at| is_of_two_surfaces(view, at));
    let are_named = |at: &&Disagreement| {
        let ids = [at.drawn, at.picked];
        let both = (ids.iter()).all(|id| name(scene, &places, at.pixel, *id));
        assert!(
            both || family == "edge_on_at_the_eye",
            "{family}: {at:?}, {view:?}"
        );
        both
    };
    of_two.filter(are_named).count()
}

/// A view whose near or far plane is at the `f64` nearest to some pixel's depth.
fn planes_through(random: &mut Random) -> Sample {
    loop {
        let make = [families::ordinary, families::far_eyes, families::condition][random.below(3)];
        let mut sample = make(random);
        let View { camera, .. } = sample.view;
        let at = sample.positions[random.below(sample.positions.len())];
        let hit = pick::closest(&sample.scene, sample.view.ray(at), sample.view.sides);
        let Some(hit) = hit else { continue };
        let lens = *camera.lens();
        let lens = if chance(random, 2) {
            Lens {
                near: hit.hit.t,
                ..lens
            }
        } else {
            Lens {
                far: hit.hit.t,
                ..lens
            }
        };
        if let Ok(camera) = camera.with_lens(lens) {
            sample.view.camera = camera;
            return sample;
        }
    }
}

/// Squares and thin boxes, up to a million times as large as what else is there, whose planes pass the eye nearly or
/// exactly: they are seen edge-on, and the near plane cuts them.
fn past_the_eye(random: &mut Random) -> Sample {
    let mut sample = families::ordinary(random);
    let eye = sample.view.camera.eye();
    let mut objects = sample.scene.objects().to_vec();
    for _ in 0..=random.below(4) {
        let normal = random.direction();
        let turn = DQuat::from_axis_angle(normal, random.within(0.0, TAU));
        let size = 10_f64.powf(random.within(0.0, 6.0));
        let along = turn * normal.any_orthonormal_vector();
        let across = normal.cross(along) * random.within(0.1, 1.0);
        let beside = match random.below(4) {
            0 => 0.0,
            _ => size * 10_f64.powf(random.within(-18.0, -2.0)),
        };
        let is_square = chance(random, 2);
        let (shape, thickness, face) = if is_square {
            (Shape::Square, size, 0.0)
        } else {
            let thickness = size * 10_f64.powf(random.within(-12.0, -1.0));
            (Shape::Cube, thickness, 0.5 * thickness)
        };
        let [aside, behind] = [0.45, 0.05].map(|most| size * random.within(-most, most));
        let model = DAffine3 {
            matrix3: DMat3::from_cols(size * along, size * across, thickness * normal),
            translation: eye + (beside - face) * normal + aside * along + behind * across,
        };
        let placement = Placement::new(model).expect("invertible");
        objects.push(Object::new("large", shape, placement));
    }
    sample.scene = Scene::new(objects);
    with_planes_that_fit(&sample)
}

macro_rules! families {
    ($($name:ident, $seed:literal, $make:path, $shown:literal, $beyond:literal, $at_planes:literal, $one_sided:literal;)*) => {
        $(#[test] fn $name() {
            let expected = Expected { shown: $shown, beyond: $beyond, at_planes: $at_planes, one_sided: $one_sided };
            run(stringify!($name), $seed, $make, &expected);
        })*
    };
}

// Coincident faces seen nearly edge-on are beyond f32. Pictures that show one to three pixels are one-sided.
families! {
    ordinary, 1, families::ordinary, 100, 0, 5, 0;
    culled, 2, families::culled, 100, 0, 5, 0;
    condition, 3, families::condition, 100, 5, 5, 5;
    far_eyes, 4, families::far_eyes, 100, 0, 5, 0;
    sizes, 5, families::sizes, 100, 0, 5, 0;
    narrow_gaps, 6, families::narrow_gaps, 100, 100, 5, 0;
    through_planes, 8, planes_through, 50, 0, 700, 5;
    exact_borders, 9, lattice::exact_borders, 100, 10, 5, 0;
    planes, 10, lattice::planes, 50, 5, 100, 5;
    ties, 11, ties::ties, 100, 10, 5, 0;
    ties_at_the_eye, 12, ties::ties_at_the_eye, 100, 50, 50, 0;
    edge_on_at_the_eye, 14, past_the_eye, 100, 200, 100, 5;
    long_ties, 13, ties::long_ties, 100, 10, 5, 0;
}
