//! Rolling ground, as an OBJ file.

use std::{
    fmt::Write,
    fs, io,
    path::{Path, PathBuf},
};

/// Writes `side * side` cells of two triangles into a folder, and returns the file's path.
pub fn write(folder: &Path, side: u32) -> io::Result<PathBuf> {
    let mut text = "o terrain\n".to_owned();
    let at = |i: u32| 10.0 * f64::from(i) / f64::from(side) - 5.0;
    for (z, x) in (0..=side).flat_map(|j| (0..=side).map(move |i| (at(j), at(i)))) {
        let y = 0.3 * (1.7 * x).sin() * (1.3 * z).cos() + 0.05 * (9.0 * x + 4.0 * z).sin();
        writeln!(text, "v {x:.6} {y:.6} {z:.6}").map_err(io::Error::other)?;
    }
    for a in (0..side).flat_map(|j| (1..=side).map(move |i| j * (side + 1) + i)) {
        let (b, c, d) = (a + 1, a + side + 1, a + side + 2);
        writeln!(text, "f {a} {c} {b}\nf {b} {c} {d}").map_err(io::Error::other)?;
    }
    let file = folder.join("terrain.obj");
    fs::write(&file, text)?;
    Ok(file)
}
