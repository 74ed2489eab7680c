//! How often picks need exact arithmetic, and what it costs: `cargo bench --bench decisions`. First come whole
//! pictures: how many picks need it, and how many tests of a ray and a triangle. Then comes the time of one decision,
//! for each kind in `doubt`.

#[path = "../common/mod.rs"]
mod common;
mod doubt;

use common::{box_mesh, mesh, orthographic, view};
use glam::{DAffine3, DVec2, DVec3, dvec2, dvec3};
use sightline::{
    camera::{View, Viewport},
    cli::ViewArgs,
    geometry::{Mesh, Placement},
    pick,
    scene::{self, Object, Progress, Scene, Shape, gallery::GALLERY},
};
use std::{collections::HashMap, hint::black_box, path::PathBuf, sync::Arc, time::Instant};

/// Size of the ordinary scenes' pictures, in pixels.
const SIZE: [u32; 2] = [160, 120];
const ROUNDS: usize = 101;

fn main() {
    println!("A pick at each position:");
    let demo = opened(&[]);
    count("demo", &demo.0, &demo.1, &centres(&demo.1));
    for exhibit in &GALLERY {
        let (scene, view) = opened(&[exhibit.path()]);
        count(exhibit.name, &scene, &view, &centres(&view));
    }
    let lattice = along_the_axes([0.0, 0.5, 1.0]);
    count("lattice", &lattice.0, &lattice.1, &corners(&lattice.1));
    let ties = along_the_axes([0.0, 0.0, 0.0]);
    count("ties", &ties.0, &ties.1, &centres(&ties.1));

    let (scene, view) = &demo;
    let positions = centres(view);
    let nearest = |px: &DVec2| pick::closest(scene, view.ray(*px), view.sides);
    let hit = positions.iter().filter(|px| nearest(px).is_some());
    let few: Vec<DVec2> = hit.step_by(97).copied().collect();
    let record = |px: &DVec2| pick::pick(scene, view, *px);
    let mut kinds = doubt::kinds();
    kinds.push((
        "a ray of the demo: what is hit".to_owned(),
        Box::new(|| time(&positions, nearest)),
    ));
    kinds.push((
        "a pick of the demo: the whole record".to_owned(),
        Box::new(|| time(&few, record)),
    ));
    report(&kinds);
}

/// A timed kind: its name, and a pass over its inputs, which returns the nanoseconds for one input.
type Kind<'a> = (String, Box<dyn Fn() -> f64 + 'a>);

/// The mean time for one input, in nanoseconds. One pass over all inputs warms up; a second pass is timed.
fn time<T, A>(inputs: &[T], answer: impl Fn(&T) -> A) -> f64 {
    let pass = || {
        let start = Instant::now();
        for input in inputs {
            black_box(answer(black_box(input)));
        }
        start.elapsed().as_secs_f64()
    };
    pass();
    let calls = u32::try_from(inputs.len()).expect("few inputs");
    1e9 * pass() / f64::from(calls)
}

/// Times all kinds in turns, so that other work on the machine slows all alike, and prints medians.
fn report(kinds: &[Kind]) {
    let mut passes = vec![Vec::new(); kinds.len()];
    for _ in 0..ROUNDS {
        for ((_, pass), times) in kinds.iter().zip(&mut passes) {
            times.push(pass());
        }
    }
    println!("\nWhat one takes, medians of {ROUNDS} passes in turns; a triangle hit by f64 is 1:");
    let medians = passes.iter_mut().map(|times| {
        times.sort_by(f64::total_cmp);
        times[ROUNDS / 2]
    });
    let medians: Vec<f64> = medians.collect();
    let one = kinds.iter().position(|(name, _)| name == doubt::UNIT);
    let one = medians[one.expect("a kind of that name")];
    for ((name, _), median) in kinds.iter().zip(&medians) {
        println!("{name:52} {median:9.0} ns {:9.1}", median / one);
    }
}

/// A scene and its view, as a window of [`SIZE`] opens it.
fn opened(paths: &[PathBuf]) -> (Scene, View) {
    let mut loaded =
        scene::load(paths, &Progress::default()).expect("a scene of the program's own");
    let size = Viewport::new(SIZE[0], SIZE[1]).expect("a viewport");
    let flags = ViewArgs {
        size: Some(size),
        ..ViewArgs::default()
    };
    let view = flags.apply(&mut loaded).expect("a view");
    loaded.scene.build_trees();
    (loaded.scene, view)
}

/// Squares, cubes and box meshes of side 1, side by side, seen along z with four pixels to a unit. The nearest faces of
/// each kind are at a depth of their own.
fn along_the_axes(depths: [f64; 3]) -> (Scene, View) {
    let box_of_triangles = box_mesh();
    let at = |shape: Shape, centre: DVec3| {
        let placement = Placement::new(DAffine3::from_translation(centre)).expect("a translation");
        Object::new("", shape, placement)
    };
    let mut objects = Vec::new();
    for y in -4..=4_i8 {
        for x in -6..=6_i8 {
            let place = |depth: f64| dvec3(x.into(), y.into(), -depth);
            let half = 0.5 * DVec3::Z;
            objects.push(at(Shape::Square, place(depths[0])));
            objects.push(at(Shape::Cube, place(depths[1]) - half));
            let shape = Shape::Mesh {
                mesh: Arc::clone(&box_of_triangles),
                part: 0,
            };
            objects.push(at(shape, place(depths[2]) - half));
        }
    }
    let lens = orthographic(12.0, 0.0, 20.0);
    let view = view([0.0, 0.0, 10.0], [0.0; 3], lens, [64, 48]);
    (Scene::new(objects), view)
}

/// The centre of each pixel.
fn centres(view: &View) -> Vec<DVec2> {
    corners(view).into_iter().map(|px| px + 0.5).collect()
}

/// The top left corner of each pixel.
fn corners(View { viewport, .. }: &View) -> Vec<DVec2> {
    let columns = || (0..viewport.width()).map(f64::from);
    let rows = (0..viewport.height()).map(f64::from);
    rows.flat_map(|y| columns().map(move |x| dvec2(x, y)))
        .collect()
}

/// Counts and prints the exact picks, and the triangle tests in doubt.
fn count(name: &str, scene: &Scene, view: &View, positions: &[DVec2]) {
    let (mut hits, mut exact, mut tests, mut in_doubt) = (0, 0, 0, 0);
    let triangles = Triangles::of(scene);
    for &px in positions {
        let pick = pick::pick(scene, view, px);
        hits += usize::from(pick.is_some());
        exact += usize::from(pick.is_some_and(|pick| pick.exact));
        tests += triangles.count();
        in_doubt += triangles.in_doubt(view, px);
    }
    let rays = positions.len();
    println!(
        "{name:20} {rays:6} rays, {hits:6} hit, {exact:5} of them exact; {tests:8} triangle tests, {in_doubt:5} exact"
    );
    assert!(hits > 0, "{name} is empty");
}

/// Each visible triangle as a mesh of its own, so that doubt is counted for each.
struct Triangles<'a>(Vec<(&'a Placement, Arc<Mesh>)>);

impl<'a> Triangles<'a> {
    fn of(scene: &'a Scene) -> Self {
        let mut singles: HashMap<_, Arc<Mesh>> = HashMap::new();
        let mut all = Vec::new();
        for object in scene.objects().iter().filter(|object| object.visible) {
            let (Shape::Mesh { mesh: of, .. }, Some(range)) =
                (&object.shape, object.shape.triangles())
            else {
                continue;
            };
            for triangle in range {
                let single = singles
                    .entry((Arc::as_ptr(of), triangle))
                    .or_insert_with(|| single(of, triangle));
                all.push((&object.placement, Arc::clone(single)));
            }
        }
        Self(all)
    }

    fn count(&self) -> usize {
        self.0.len()
    }

    /// How many tests `f64` leaves open, with or without the ray's interval.
    fn in_doubt(&self, view: &View, px: DVec2) -> usize {
        let ray = view.ray(px);
        let whole = view.camera.pixel_grid(view.viewport);
        let whole = whole.ray(px, [f64::MIN, f64::MAX]);
        let is_in_doubt = |(placement, mesh): &&(&Placement, Arc<Mesh>)| {
            [&ray, &whole]
                .iter()
                .any(|ray| mesh.is_in_doubt(&placement.local_ray(ray), |_| true))
        };
        self.0.iter().filter(is_in_doubt).count()
    }
}

fn single(of: &Mesh, triangle: u32) -> Arc<Mesh> {
    let data = of.data();
    let corners = data.triangles[triangle as usize].map(|vertex| data.positions[vertex as usize]);
    mesh(corners.to_vec(), vec![[0, 1, 2]], data.origin)
}
