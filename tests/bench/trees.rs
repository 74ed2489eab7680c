//! How fast nearest hits are found, against other libraries. All get the same rays, in passes that take turns. Where
//! answers differ, and on a sample, brute force decides which are right. Prints the fastest passes' times and their
//! ratios, which vary less than times on a busy machine.
//!
//! `cargo bench --features rivals --bench trees [-- FILE.obj ...]`: files take the place of the small generated meshes.
//! Embree 3 is measured where its library is installed (Debian's `libembree3-3`), Embree 4 where the loader finds
//! `libembree4.so.4` (Debian 13: `libembree4-4`) or the variable `EMBREE4` names it (the Python package `embreex` has
//! one in `embreex.libs`). `--features tinybvh` adds tinybvh's tree of eight, where everything is compiled for AVX2
//! (`RUSTFLAGS="-C target-cpu=native"`). It needs a C++ compiler; version 0.1.0-beta.3 crashes on some processors.
//!
//! The last line of each mesh is the cost of a hover: rays through one pixel after the other, each timed alone.

mod allocations;
mod embree;
mod meshes;
mod rays;
mod rivals;

use allocations::Cost;
use meshes::Sample;
use rivals::{Answer, Built, Rival};
use sightline::geometry::{Aabb, Mesh, Ray, Sides};
use std::{hint::black_box, path::PathBuf, process::ExitCode, time::Instant};

/// Width and height of the picture that the rays go through.
const SIDE: u32 = 384;
/// Passes over the rays; the fastest counts.
const PASSES: usize = 15;
/// Timed builds; the fastest counts.
const BUILDS: usize = 3;
/// Triangle tests that brute force may spend on a mesh.
const TRUTH: usize = 400_000_000;

/// A rival's figures on one mesh.
struct Row {
    /// Nanoseconds a ray in the fastest pass, by kind of rays.
    nanoseconds: [f64; 3],
    wrong: usize,
    judged: usize,
    cost: Cost,
}

fn main() -> ExitCode {
    let files = std::env::args()
        .skip(1)
        .filter(|arg| !arg.starts_with("--"));
    let files: Vec<_> = files
        .filter_map(|path| meshes::of_file(PathBuf::from(path)))
        .collect();
    let generated = meshes::generated(files.is_empty());
    let rivals = rivals::all();
    let reference = usize::from(rivals[1].name.starts_with("Embree"));
    println!(
        "ratios to {}, {} rays a pass",
        rivals[reference].name,
        SIDE * SIDE
    );
    let mut all = Vec::new();
    for sample in files.into_iter().chain(generated) {
        let rows = measure(&sample, &rivals);
        print(&sample, &rivals, &rows, &rows[reference]);
        let [median, p99] = hover(&sample);
        println!("Sightline, hover: median {median} ns, 99th percentile {p99} ns");
        all.push(rows);
    }
    println!("\ngeometric means of the ratios");
    println!(
        "{:16} {:>10} {:>10} {:>10} {:>6} {:>6} {:>6}  wrong",
        "", "incoherent", "coherent", "all around", "build", "memory", "peak"
    );
    let wrong_of = |i: usize| all.iter().map(|rows| rows[i].wrong).sum::<usize>();
    let judged: usize = all.iter().map(|rows| rows[0].judged).sum();
    for (i, rival) in rivals.iter().enumerate() {
        let mean = |of: &dyn Fn(&Row) -> f64, width: usize| {
            let ratios = all.iter().map(|rows| of(&rows[i]) / of(&rows[reference]));
            print!(" {:width$.2}", geometric_mean(ratios));
        };
        print!("{:16}", rival.name);
        for kind in 0..3 {
            mean(&|row| row.nanoseconds[kind], 10);
        }
        mean(&|row| row.cost.seconds, 6);
        for of in [0, 1] {
            // Memory that is not counted is NaN.
            #[expect(clippy::cast_precision_loss, reason = "a size")]
            mean(&|row| row.cost.memory.map_or(f64::NAN, |m| m[of] as f64), 6);
        }
        println!("  {} of {judged}", wrong_of(i));
    }
    let wrong = wrong_of(0);
    if wrong == 0 {
        ExitCode::SUCCESS
    } else {
        println!("Sightline gave {wrong} wrong answers");
        ExitCode::FAILURE
    }
}

fn measure(sample: &Sample, rivals: &[Rival]) -> Vec<Row> {
    let truth = Mesh::new(sample.data()).expect("a mesh");
    let bounds = truth.part_bounds(0);
    let rays = [
        rays::camera(&bounds, SIDE, true),
        rays::camera(&bounds, SIDE, false),
        rays::from_all_around(&bounds, (SIDE * SIDE) as usize),
    ];
    let mut built: Vec<Built> = rivals.iter().map(|r| (r.build)(sample)).collect();
    for _ in 1..BUILDS {
        for (rival, (_, cost)) in rivals.iter().zip(&mut built) {
            cost.seconds = cost.seconds.min((rival.build)(sample).1.seconds);
        }
    }
    let mut rows: Vec<Row> = built
        .iter()
        .map(|&(_, cost)| Row {
            nanoseconds: [f64::INFINITY; 3],
            wrong: 0,
            judged: 0,
            cost,
        })
        .collect();
    for (kind, rays) in rays.iter().enumerate() {
        let mut answers = vec![vec![Answer::None; rays.len()]; rivals.len()];
        let mut seconds = vec![Vec::new(); rivals.len()];
        for _ in 0..PASSES {
            for (i, (tree, _)) in built.iter().enumerate() {
                let start = Instant::now();
                tree(rays, &mut answers[i]);
                seconds[i].push(start.elapsed().as_secs_f64());
            }
        }
        judge(&truth, &bounds, rays, &answers, &mut rows);
        let fastest = |seconds: &[f64]| seconds.iter().copied().fold(f64::INFINITY, f64::min);
        #[expect(clippy::cast_precision_loss, reason = "a count")]
        for (row, own) in rows.iter_mut().zip(&seconds) {
            row.nanoseconds[kind] = 1e9 * fastest(own) / rays.len() as f64;
        }
    }
    rows
}

/// Counts wrong answers by brute force in `f64`: first where rivals disagree, then on every `step`-th ray.
fn judge(truth: &Mesh, bounds: &Aabb, rays: &[Ray], answers: &[Vec<Answer>], rows: &mut [Row]) {
    let budget = TRUTH / truth.data().triangles.len() / 3;
    // Generous for t in f32: answers further apart are different surfaces.
    let tolerance = 1e-4 * bounds.radius();
    let same = |ray: &Ray, a: Answer, b: Answer| match (a, b) {
        (Some((a, _)), Some((b, _))) => (a - b).abs() * ray.direction.length() <= tolerance,
        (a, b) => a.is_none() && b.is_none(),
    };
    let disputed = (0..rays.len()).filter(|&i| {
        let first = answers[0][i];
        answers.iter().any(|own| !same(&rays[i], own[i], first))
    });
    let step = (2 * rays.len()).div_ceil(budget);
    let sample = (0..rays.len()).step_by(step);
    for i in disputed.take(budget / 2).chain(sample) {
        let ray = &rays[i];
        let hit = truth.closest(ray, Sides::Both, |_| true);
        let hit = hit.and_then(|hit| Some((hit.t, hit.on_triangle?.triangle)));
        for (rival, row) in rows.iter_mut().enumerate() {
            let answer = answers[rival][i];
            row.judged += 1;
            // Sightline's must be equal to the bit.
            let right = if rival == 0 {
                answer == hit
            } else {
                same(ray, answer, hit)
            };
            row.wrong += usize::from(!right);
        }
    }
}

fn print(sample: &Sample, rivals: &[Rival], rows: &[Row], reference: &Row) {
    #[expect(clippy::cast_precision_loss, reason = "a count")]
    let millions = sample.triangles.len() as f64 / 1e6;
    println!("\n{}: {} triangles", sample.name, sample.triangles.len());
    println!(
        "{:16} {:>18} {:>18} {:>18} {:>14} {:>9} {:>9} {:>9}",
        "", "incoherent ns", "coherent ns", "all around ns", "wrong", "build ms", "MB", "peak MB"
    );
    for (rival, row) in rivals.iter().zip(rows) {
        print!("{:16}", rival.name);
        for kind in 0..3 {
            let (own, other) = (row.nanoseconds[kind], reference.nanoseconds[kind]);
            print!(" {own:11.0} ({:.2})", own / other);
        }
        #[expect(clippy::cast_precision_loss, reason = "a size")]
        let mb = |bytes: isize| bytes as f64 / 1e6;
        print!(
            " {:5} of {:5} {:9.1}",
            row.wrong,
            row.judged,
            1e3 * row.cost.seconds
        );
        match row.cost.memory {
            Some(memory) => {
                let [held, peak] = memory.map(mb);
                println!(" {held:9.1} {peak:9.1}");
            }
            None => println!(" {:>9} {:>9}", "-", "-"),
        }
    }
    println!(
        "Sightline, per million triangles: {:.0} ms",
        1e3 * rows[0].cost.seconds / millions
    );
}

/// Median and 99th percentile of single rays' times, in nanoseconds, including the clock's own.
fn hover(sample: &Sample) -> [u128; 2] {
    let mesh = Mesh::new(sample.data()).expect("a mesh");
    mesh.build_tree();
    let rays = rays::camera(&mesh.part_bounds(0), SIDE, false);
    let timed = |ray: &Ray| {
        let start = Instant::now();
        black_box(mesh.closest(ray, Sides::Both, |_| true));
        start.elapsed().as_nanos()
    };
    let mut times: Vec<_> = rays.iter().map(timed).collect();
    times.sort_unstable();
    [50, 99].map(|percent| times[times.len() * percent / 100])
}

#[expect(clippy::cast_precision_loss, reason = "a count")]
fn geometric_mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len() as f64;
    (values.map(f64::ln).sum::<f64>() / count).exp()
}
