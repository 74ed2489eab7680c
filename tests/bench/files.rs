//! How long an OBJ file takes until it can be picked and drawn, and how much memory, beside what `tobj` alone takes.
//!
//! `cargo bench --bench files`, or with `-- FILE.obj`. Each measurement is a process of its own, since its peak of
//! memory counts; the contenders take turns. Peaks need Linux.

mod terrain;

use glam::DVec3;
use sightline::{
    geometry::Ray,
    pick,
    scene::{Progress, load},
};
use std::{
    env,
    error::Error,
    ffi::OsString,
    fs,
    path::{Path, PathBuf},
    process::{Command, ExitCode},
    time::Instant,
};

const ROUNDS: usize = 7;
/// Squares along a side of the file that is measured where none is named: twice its square is the triangle count.
const SIDE: u32 = 708;

/// Takes a file as far as it does, and returns how much it found there.
type Contender = fn(&Path) -> Result<usize, Box<dyn Error>>;

/// What is measured, each in a process of its own. The first is what the others are compared with.
const CONTENDERS: [(&str, Contender); 3] = [
    ("tobj", tobj_alone),
    ("first pick", first_pick),
    ("render", render),
];

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).filter(|a| a != "--bench").collect();
    if let [contender, file] = &*arguments {
        let (_, run) = CONTENDERS
            .iter()
            .find(|(name, _)| name == contender)
            .ok_or("no such contender")?;
        let triangles = run(Path::new(file))?;
        println!("{} {triangles}", peak_mb());
        return Ok(());
    }
    let folder = tempfile::tempdir()?;
    let file = match arguments.first() {
        Some(file) => PathBuf::from(file),
        None => terrain::write(folder.path(), SIDE)?,
    };
    let mut measured = [const { Vec::new() }; CONTENDERS.len()];
    for round in 0..=ROUNDS {
        for ((name, _), all) in CONTENDERS.iter().zip(&mut measured) {
            let start = Instant::now();
            let run = Command::new(env::current_exe()?)
                .args([name.as_ref(), file.as_os_str()])
                .output()?;
            let ms = start.elapsed().as_secs_f64() * 1e3;
            let said = String::from_utf8(run.stdout)?;
            let said = said.split_whitespace().map(str::parse);
            let said = said.collect::<Result<Vec<f64>, _>>()?;
            let &[mb, triangles] = &*said else {
                return Err(String::from_utf8_lossy(&run.stderr).into());
            };
            // The first round brings the file into the system's cache.
            if round > 0 {
                all.push([ms, mb, triangles]);
            }
        }
    }
    println!(
        "{}: {} triangles, medians of {ROUNDS} rounds",
        file.display(),
        measured[0][0][2]
    );
    println!("              ms   ratio  peak MB   ratio");
    for ((name, _), all) in CONTENDERS.iter().zip(&measured) {
        let [ms, mb] = [0, 1].map(|what| median(all.iter().map(|one| one[what])));
        // Per round: what else the machine does slows down both.
        let [time, memory] = [0, 1].map(|what| {
            median(
                all.iter()
                    .zip(&measured[0])
                    .map(|(one, tobj)| one[what] / tobj[what]),
            )
        });
        println!("{name:12} {ms:9.0} {time:7.2} {mb:9.0} {memory:7.2}");
    }
    Ok(())
}

/// `tobj` as everybody calls it.
fn tobj_alone(file: &Path) -> Result<usize, Box<dyn Error>> {
    let options = tobj::LoadOptions {
        triangulate: true,
        ..tobj::LoadOptions::default()
    };
    let (models, _) = tobj::load_obj(file, &options)?;
    Ok(models
        .iter()
        .map(|model| model.mesh.indices.len() / 3)
        .sum())
}

/// From the file to the answer to a click in the middle of what it holds.
fn first_pick(file: &Path) -> Result<usize, Box<dyn Error>> {
    let scene = load(&[file.to_owned()], &Progress::default())?.scene;
    let bounds = scene.bounds();
    let (center, diagonal) = (0.5 * (bounds.min + bounds.max), bounds.max - bounds.min);
    let toward = DVec3::new(0.3, 1.0, 0.2);
    let ray = Ray {
        origin: center + toward * diagonal.length(),
        direction: -toward,
        t_min: 0.0,
        t_max: f64::INFINITY,
    };
    pick::closest(&scene, ray, sightline::geometry::Sides::Both).ok_or("nothing there")?;
    Ok(scene.triangle_count())
}

/// The whole of `sightline render`.
fn render(file: &Path) -> Result<usize, Box<dyn Error>> {
    let folder = tempfile::tempdir()?;
    let picture = folder.path().join("picture.png");
    let arguments = ["sightline".as_ref(), "render".as_ref(), file.as_os_str()];
    let output = ["-o".as_ref(), picture.as_os_str()];
    let arguments = arguments.into_iter().chain(output).map(OsString::from);
    if sightline::cli::run(arguments) != ExitCode::SUCCESS {
        return Err("no picture".into());
    }
    Ok(usize::try_from(fs::metadata(picture)?.len())?)
}

/// The most memory that this process had, in MB.
fn peak_mb() -> f64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let peak = status.lines().find_map(|line| {
        line.strip_prefix("VmHWM:")?
            .trim()
            .strip_suffix(" kB")?
            .parse::<f64>()
            .ok()
    });
    peak.map_or(f64::NAN, |kb| kb / 1024.0)
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}
