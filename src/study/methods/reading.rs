//! Reads an OBJ file: a site 900 m wide, surveyed to the millimetre, somewhere on a national grid. The answer is the
//! triangles' corners. Picks and pictures lack the digits that a method drops here.

use crate::{
    geometry::Mesh,
    scene::{Progress, obj},
    study::prelude::*,
};
use std::{fmt::Write, path::Path, sync::Arc};

/// Squares along a side of the site.
const SIDE: usize = 48;
/// A file's size; lines of blanks fill it up.
pub const BYTES: usize = 250_000;

/// A file with its content.
#[derive(Clone, Debug)]
pub struct FileCase {
    text: Arc<[u8]>,
    /// In millimetres.
    vertices: Arc<Vec<[i64; 3]>>,
    triangles: Arc<Vec<[u32; 3]>>,
}

/// What was read.
#[derive(Debug)]
pub enum Read {
    /// A point, coordinates relative to it, and the corners' indices.
    Plain([f64; 3], Vec<f32>, Vec<u32>),
    /// A mesh that can be picked from.
    Mesh(Arc<Mesh>),
}

const TOBJ: &str =
    "tobj 4, load_obj_buf, as its default build stores numbers: in f32 from the grid's origin";
const TOBJ_F64: &str = "tobj 4 with use_f64, minus the first vertex: in f32 across the site";
const OURS: &str = "scene::obj, through tobj in f64, minus the middle: in f32 across half the site";

impl Case for FileCase {
    type Answer = Option<Read>;
    type Truth = ();
    const ABOUT: About = about!(
        "Reading a file" "file", off by "mm", wrong by "";
        "an OBJ file of 250 kB in memory: its triangles as graphics cards take them, in f32 about one point"
    );
    const TIMED: usize = 3;
    const MOST_ROUNDS: usize = 11;
    const METHODS: Methods<Self> = &[&[
        Method::new("tobj", F32, TOBJ, |c| c.tobj(|_| [0.0; 3])),
        Method::new("tobj, about the first vertex", F64, TOBJ_F64, |c| {
            c.tobj(|positions| [positions[0], positions[1], positions[2]])
        }),
        Method::ours(F32, OURS, |c: &Self| {
            let read = obj::from_bytes(&c.text, Path::new("site.obj"), &Progress::default());
            Some(Read::Mesh(read.ok()?.mesh))
        })
        .named("Sightline's, through tobj"),
    ]];
    const FAMILIES: &'static [Family<Self>] = &[
        Family::ordinary(|random, _| site(random, 4e5)),
        family!("national coordinates", "offset (m)" [1e4, 1e5, 1e6, 1e7] => site),
    ];

    fn count(effort: Effort) -> usize {
        effort.picks.min(Self::TIMED)
    }

    fn truth(&self) {}

    fn judge(&self, (): &(), answer: &Option<Read>) -> Verdict {
        let Some(read) = answer else {
            return Verdict::Missed(0.0);
        };
        let corners = self.triangles.as_flattened().iter().enumerate();
        let errors = corners.map(|(i, vertex)| {
            let given = self.vertices[*vertex as usize];
            let Some(kept) = read.corner(i) else {
                return f64::INFINITY;
            };
            let off = |axis: usize| {
                let kept = Exact::new(kept[0][axis]) + Exact::new(kept[1][axis]);
                let mm = kept * Exact::int(1000) - Exact::int(given[axis]);
                mm.abs().to_f64()
            };
            off(0).max(off(1)).max(off(2))
        });
        Verdict::Right(errors.fold(0.0, f64::max))
    }

    /// A coordinate is at most 480 m from the middle; as `f32` it rounds by `2^-24` of that. The coordinate, the middle
    /// and their difference each round by `2^-53` of the largest coordinate.
    fn bound(&self, (): &()) -> f64 {
        let sizes = self.vertices.as_flattened().iter();
        let largest = sizes.map(|mm| mm.unsigned_abs()).max();
        #[expect(clippy::cast_precision_loss, reason = "below 2^53")]
        let largest = largest.unwrap_or(0) as f64;
        480e3 * UNIT_F32 + 2.0 * largest * f64::EPSILON
    }
}

impl Read {
    /// A corner's position, as two terms of a sum.
    fn corner(&self, index: usize) -> Option<[[f64; 3]; 2]> {
        let (origin, position): ([f64; 3], [f32; 3]) = match self {
            Self::Plain(origin, positions, corners) => {
                let first = 3 * *corners.get(index)? as usize;
                (*origin, positions.get(first..first + 3)?.try_into().ok()?)
            }
            Self::Mesh(mesh) => {
                let data = mesh.data();
                let vertex = *data.triangles.as_flattened().get(index)?;
                (data.origin.to_array(), data.positions[vertex as usize])
            }
        };
        Some([origin, position.map(f64::from)])
    }
}

impl FileCase {
    /// The file's triangles by `tobj`, relative to the point that `origin` makes of its coordinates.
    fn tobj(&self, origin: fn(&[f64]) -> [f64; 3]) -> Option<Read> {
        let options = tobj::LoadOptions::default();
        let no_materials = |_: &Path| Err(tobj::LoadError::GenericFailure);
        let (models, _) = tobj::load_obj_buf(&mut &*self.text, &options, no_materials).ok()?;
        let mesh = models.into_iter().next()?.mesh;
        let origin = origin(&mesh.positions);
        let positions = mesh.positions.chunks_exact(3).flat_map(|at| {
            let apart = [at[0] - origin[0], at[1] - origin[1], at[2] - origin[2]];
            apart.map(f32::of)
        });
        Some(Read::Plain(origin, positions.collect(), mesh.indices))
    }
}

/// A hilly site, this many whole metres north and east of the grid's origin.
fn site(random: &mut Random, metres: f64) -> FileCase {
    #[expect(clippy::cast_possible_truncation, reason = "whole metres")]
    let metres = metres as i64;
    let points = (0..(SIDE + 1) * (SIDE + 1)).map(|i| {
        let place = |step: usize| 1000 * i64::try_from(900 * step / SIDE).unwrap_or(0);
        let mut jitter = || i64::from(random.integer(-5000, 5000));
        [
            1000 * metres + place(i % (SIDE + 1)) + jitter(),
            1000 * metres + place(i / (SIDE + 1)) + jitter(),
            100_000 + 4 * jitter(),
        ]
    });
    let vertices: Vec<[i64; 3]> = points.collect();
    let index = |x: usize, y: usize| u32::try_from(y * (SIDE + 1) + x).unwrap_or(0);
    let squares = (0..SIDE * SIDE).map(|i| (i % SIDE, i / SIDE));
    let triangles = squares.flat_map(|(x, y)| {
        let [a, b] = [index(x, y), index(x + 1, y)];
        let [c, d] = [index(x, y + 1), index(x + 1, y + 1)];
        [[a, b, d], [a, d, c]]
    });
    let triangles: Vec<[u32; 3]> = triangles.collect();
    let mut text = String::with_capacity(BYTES);
    // Writing to a string cannot fail.
    for [x, y, z] in &vertices {
        let [x, y, z] = [x, y, z].map(|mm| {
            let sign = if *mm < 0 { "-" } else { "" };
            format!("{sign}{}.{:03}", mm.abs() / 1000, mm.abs() % 1000)
        });
        let _ = writeln!(text, "v {x} {y} {z}");
    }
    for [a, b, c] in triangles.iter().map(|corners| corners.map(|i| i + 1)) {
        let _ = writeln!(text, "f {a} {b} {c}");
    }
    while text.len() < BYTES {
        let room = (BYTES - text.len() - 1).min(99);
        text.push_str(&" ".repeat(room));
        text.push('\n');
    }
    FileCase {
        text: text.into_bytes().into(),
        vertices: vertices.into(),
        triangles: triangles.into(),
    }
}
