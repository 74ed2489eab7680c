//! Time and memory to list, pick from and draw an OBJ file, beside those of `tobj` alone. Where `f3d`, `Xvfb` and
//! GNU `time` are installed, the picture is measured beside F3D's too.
//!
//! `cargo bench --bench files` for 100 thousand, a million and 10 million triangles, or with `-- FILE.obj`. Each
//! measurement is a process of its own, and contenders take turns. Memory and `taskset` need Linux.

#[expect(dead_code, reason = "another benchmark asks more of it")]
mod f3d;
mod terrain;

use f3d::{Cost, F3d};
use std::{
    env,
    error::Error,
    ffi::OsString,
    fs,
    path::Path,
    process::{Command, ExitCode},
    time::Instant,
};

const ROUNDS: usize = 5;
/// Squares along a side of the generated files; twice the square of this is the triangle count.
const SIDES: [u32; 3] = [224, 708, 2236];
/// Size of the pictures.
const SIZE: [u32; 2] = [1280, 720];

type Failure = Box<dyn Error>;

/// Each contender: its word on this program's command line, and the command in front of it, if any. All are compared
/// with the first.
const CONTENDERS: [(&str, &[&str]); 5] = [
    ("tobj", &[]),
    ("list", &[]),
    ("pick", &[]),
    ("pick, one core", &["taskset", "-c", "0"]),
    ("render", &[]),
];

fn main() -> Result<(), Failure> {
    let arguments: Vec<String> = env::args().skip(1).filter(|a| a != "--bench").collect();
    if let [contender, file] = &*arguments {
        run(contender, Path::new(file))?;
        println!("{}", peak_mb());
        return Ok(());
    }
    let f3d = F3d::find(SIZE)?;
    if let Some(file) = arguments.first() {
        return compare(Path::new(file), f3d.as_ref());
    }
    let folder = tempfile::tempdir()?;
    for side in SIDES {
        compare(&terrain::write(folder.path(), side)?, f3d.as_ref())?;
    }
    Ok(())
}

/// Measures all contenders with a file and prints their costs.
fn compare(file: &Path, f3d: Option<&F3d>) -> Result<(), Failure> {
    let mut measured = [const { Vec::new() }; CONTENDERS.len()];
    let mut others = Vec::new();
    // The first round brings the file into the system's cache and does not count.
    for round in 0..=ROUNDS {
        for ((name, before), costs) in CONTENDERS.iter().zip(&mut measured) {
            costs.push(cost_of(name, before, file)?);
        }
        if let Some(f3d) = f3d {
            others.push(f3d.picture(file)?);
        }
        if round == 0 {
            measured.iter_mut().for_each(Vec::clear);
            others.clear();
        }
    }
    let [tobj, .., render] = &measured;
    let bytes = fs::metadata(file)?.len() / 1_000_000;
    println!(
        "\n{} ({bytes} MB), medians of {ROUNDS} rounds",
        file.display()
    );
    println!("                     ms  to tobj (all rounds)  peak MB  to tobj");
    for ((name, _), costs) in CONTENDERS.iter().zip(&measured) {
        print_row(name, costs, tobj);
    }
    if f3d.is_none() {
        println!("F3D: absent");
    } else {
        print_row("F3D", &others, tobj);
        println!("                         to F3D                         to F3D");
        print_row("render", render, &others);
    }
    Ok(())
}

/// Prints the medians of a contender's costs, and of its ratios to another's costs. Each ratio is of one round, in
/// which other work on the machine slows both alike.
fn print_row(name: &str, costs: &[Cost], others: &[Cost]) {
    let ratios = |of: fn(&Cost) -> f64| {
        let ratios = costs
            .iter()
            .zip(others)
            .map(|(one, other)| of(one) / of(other));
        sorted(ratios)
    };
    let [time, memory] = [ratios(|cost| cost.ms), ratios(|cost| cost.peak_mb)];
    println!(
        "{name:14} {:8.0} {:8.2} ({:.2} to {:.2}) {:8.0} {:8.2}",
        median(&sorted(costs.iter().map(|cost| cost.ms))),
        median(&time),
        time[0],
        time[time.len() - 1],
        median(&sorted(costs.iter().map(|cost| cost.peak_mb))),
        median(&memory),
    );
}

/// The cost of one contender for a file, in a process of its own.
fn cost_of(name: &str, before: &[&str], file: &Path) -> Result<Cost, Failure> {
    let mut words: Vec<OsString> = before.iter().map(OsString::from).collect();
    words.push(env::current_exe()?.into());
    words.extend([name.into(), file.into()]);
    let start = Instant::now();
    let run = Command::new(&words[0]).args(&words[1..]).output()?;
    let ms = start.elapsed().as_secs_f64() * 1e3;
    let said = String::from_utf8(run.stdout)?;
    let Some(Ok(peak_mb)) = said.lines().last().map(str::parse) else {
        return Err(String::from_utf8_lossy(&run.stderr).into());
    };
    Ok(Cost { ms, peak_mb })
}

/// Does a contender's work.
fn run(contender: &str, file: &Path) -> Result<(), Failure> {
    let folder = tempfile::tempdir()?;
    let [width, height] = SIZE.map(f64::from);
    let size = format!("--size={}x{}", SIZE[0], SIZE[1]);
    let center = format!("--at={},{}", 0.5 * width, 0.5 * height);
    let picture = folder.path().join("picture.png");
    let arguments: &[OsString] = match contender {
        "tobj" => return tobj_alone(file),
        "list" => &["list".into(), file.into()],
        "render" => &[
            "render".into(),
            file.into(),
            size.into(),
            "-o".into(),
            picture.into(),
        ],
        _ => &["pick".into(), file.into(), size.into(), center.into()],
    };
    let arguments = [OsString::from("sightline")]
        .into_iter()
        .chain(arguments.iter().cloned());
    match sightline::cli::run(arguments) {
        ExitCode::SUCCESS => Ok(()),
        _ => Err("it failed".into()),
    }
}

/// `tobj` alone, with the whole file at once.
fn tobj_alone(file: &Path) -> Result<(), Failure> {
    let (models, _) = tobj::load_obj(file, &tobj::LoadOptions::default())?;
    println!("{} models", models.len());
    Ok(())
}

/// The peak of this process's memory.
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

fn sorted(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values
}

fn median(sorted: &[f64]) -> f64 {
    sorted[sorted.len() / 2]
}
