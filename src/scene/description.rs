//! Scene files: objects, where they stand, and a camera, as TOML that people write by hand.
//!
//! ```toml
//! [camera]                   # every field is optional
//! eye = [3, 2, 4]
//! target = [0, 0, 0]         # or look = [x, y, z], a direction
//! up = [0, 1, 0]
//! fov = 45                   # vertical, in degrees; or ortho = 5, the picture's full height
//! near = 0.1
//! far = 100
//! depth = "reversed"         # or "standard"
//! up_axis = "y"              # or "z"
//!
//! [[object]]
//! shape = "sphere"           # sphere (radius 0.5), cube (side 1), square (side 1, facing +z) or mesh
//! name = "Ball"
//! colour = "#d95f02"         # or [r, g, b] with sRGB channels from 0 to 1
//! scale = [1, 2, 1]          # or one number; negative mirrors
//! rotation = [0, 45, 0]      # degrees about the world's x axis, then its y axis, then its z axis
//! position = [0, 1, 0]       # scale comes first, then rotation, then position
//! visible = true
//!
//! [[object]]
//! shape = "cube"
//! matrix = [[1, 0.5, 0, 2], [0, 1, 0, 0], [0, 0, 1, 0]]  # the model matrix's upper three rows, in place of those three
//!
//! [[object]]
//! shape = "mesh"
//! file = "bunny.obj"         # relative to this file; all its objects, each under its own name
//! part = 2                   # only the file's second object
//! ```
//!
//! A `name` replaces that of a mesh file's only object, or goes in front of the names when there are several.

use super::{MeshFiles, ObjError, Object, Progress, Scene, Shape, Warning};
use crate::{
    camera::{CameraChoice, exactly, some_vector},
    colour::Srgb,
    geometry::{Mesh, Placement, PlacementError},
};
use glam::{DAffine3, DMat3, DVec3};
use serde::{Deserialize, Serialize};
use std::{
    path::{Path, PathBuf},
    sync::Arc,
};
use toml::Spanned;

/// What a scene file says.
#[derive(Debug)]
pub struct Description {
    /// Its objects, in order.
    pub objects: Vec<Object>,
    /// Its camera; `None` where the file has no `[camera]`.
    pub camera: Option<CameraChoice>,
}

/// Why a scene file was refused. One line that names the file and, where it can be told, the line.
#[derive(Debug, thiserror::Error)]
#[error("{}: {problem}", place(file, *line))]
pub struct DescriptionError {
    /// The scene file.
    pub file: PathBuf,
    /// The line in it, from 1.
    pub line: Option<usize>,
    /// What is wrong there.
    #[source]
    pub problem: Box<Problem>,
}

fn place(file: &Path, line: Option<usize>) -> String {
    match line {
        Some(line) => format!("{}:{line}", file.display()),
        None => file.display().to_string(),
    }
}

/// What is wrong in a scene file.
#[derive(Debug, thiserror::Error)]
pub enum Problem {
    /// It is not TOML, or not a scene's.
    #[error("{0}")]
    Syntax(String),
    /// Two fields that say the same thing.
    #[error("{0} exclude each other: keep one")]
    Both(&'static str),
    /// TOML knows `nan` and `inf`; space does not.
    #[error("{0} must be finite")]
    NotFinite(&'static str),
    /// No such model matrix.
    #[error("{object}: {source}")]
    Placement {
        /// Name of the object.
        object: String,
        /// What is wrong with the matrix.
        source: PlacementError,
    },
    /// A mesh comes from a file.
    #[error("a mesh needs its file: file = \"name.obj\"")]
    NoFile,
    /// Only a mesh comes from a file.
    #[error("{0} is for shape = \"mesh\" only")]
    NotAMesh(&'static str),
    /// The mesh file has fewer objects.
    #[error("{file} has {parts} objects, so there is no part {part}: parts count from 1")]
    NoSuchPart {
        /// The mesh file.
        file: String,
        /// How many objects it has.
        parts: usize,
        /// What was asked for.
        part: usize,
    },
    /// The mesh file was refused.
    #[error("{file}: {source}")]
    Mesh {
        /// The mesh file.
        file: String,
        /// Why.
        source: ObjError,
    },
}

/// Why a scene cannot be written as a scene file.
#[derive(Debug, thiserror::Error)]
pub enum SaveError {
    /// A mesh that was made, not loaded.
    #[error("{0} comes from no file, so a scene file cannot name it")]
    NoFile(String),
    /// TOML is UTF-8.
    #[error("the path {0} is not text that a scene file can hold")]
    Path(String),
    /// The TOML writer's complaint.
    #[error("cannot write the scene as TOML: {0}")]
    Toml(#[from] toml::ser::Error),
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct SceneFile {
    camera: Option<Spanned<CameraChoice>>,
    #[serde(default, rename = "object")]
    objects: Vec<Spanned<Entry>>,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    name: Option<String>,
    shape: ShapeWord,
    file: Option<String>,
    part: Option<usize>,
    #[serde(alias = "color")]
    colour: Option<Colour>,
    #[serde(default, deserialize_with = "some_vector")]
    position: Option<DVec3>,
    #[serde(default, deserialize_with = "some_vector")]
    rotation: Option<DVec3>,
    scale: Option<Scale>,
    matrix: Option<Rows>,
    visible: Option<bool>,
}

/// The model matrix's upper three rows; the fourth is always (0, 0, 0, 1).
#[derive(Clone, Copy, Serialize, Deserialize)]
#[serde(transparent)]
struct Rows(#[serde(deserialize_with = "exactly")] [Row; 3]);

/// A row of the model matrix.
#[derive(Clone, Copy, Serialize, Deserialize)]
#[serde(transparent)]
struct Row(#[serde(deserialize_with = "exactly")] [f64; 4]);

#[derive(Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
enum ShapeWord {
    Sphere,
    Cube,
    Square,
    Mesh,
}

#[derive(Clone, Copy, Serialize, Deserialize)]
#[serde(untagged, expecting = "a scale is one number or [x, y, z]")]
enum Scale {
    Uniform(f64),
    Axes(#[serde(deserialize_with = "exactly")] [f64; 3]),
}

#[derive(Clone, Copy, Serialize, Deserialize)]
#[serde(try_from = "ColourText", into = "ColourText")]
struct Colour(Srgb);

#[derive(Serialize, Deserialize)]
#[serde(
    untagged,
    expecting = "a colour is \"#rrggbb\" or [r, g, b] with channels from 0 to 1"
)]
enum ColourText {
    Hex(String),
    Unit(#[serde(deserialize_with = "exactly")] [f64; 3]),
}

impl TryFrom<ColourText> for Colour {
    type Error = &'static str;

    fn try_from(text: ColourText) -> Result<Self, Self::Error> {
        const WANTED: &str = "a colour is \"#rrggbb\" or [r, g, b] with channels from 0 to 1";
        match text {
            ColourText::Hex(text) => {
                let digits = text.strip_prefix('#').ok_or(WANTED)?;
                if digits.len() != 6 || !digits.bytes().all(|digit| digit.is_ascii_hexdigit()) {
                    return Err(WANTED);
                }
                let value = u32::from_str_radix(digits, 16).map_err(|_| WANTED)?;
                let [_, r, g, b] = value.to_be_bytes();
                Ok(Self(Srgb([r, g, b])))
            }
            ColourText::Unit(channels) => {
                let all_in_range = channels.iter().all(|c| (0.0..=1.0).contains(c));
                all_in_range
                    .then(|| Self(Srgb::from_unit(channels)))
                    .ok_or(WANTED)
            }
        }
    }
}

impl From<Colour> for ColourText {
    fn from(Colour(Srgb([r, g, b])): Colour) -> Self {
        Self::Hex(format!("#{r:02x}{g:02x}{b:02x}"))
    }
}

/// Reads the text of a scene file. `file` is its path: errors name it, and mesh files are relative to its folder.
///
/// # Errors
/// When it is not a scene file, an object in it cannot be, or a mesh file is refused.
pub fn parse(
    text: &str,
    file: &Path,
    meshes: &mut MeshFiles,
    progress: &Progress,
    warnings: &mut Vec<Warning>,
) -> Result<Description, DescriptionError> {
    let fail = |at: Option<usize>, problem| DescriptionError {
        file: file.to_owned(),
        line: at.map(|byte| 1 + text.bytes().take(byte).filter(|&b| b == b'\n').count()),
        problem: Box::new(problem),
    };
    let scene: SceneFile = toml::from_str(text).map_err(|error| {
        // Some messages quote the file over several lines.
        let message = error.message().lines().next().unwrap_or_default();
        fail(
            error.span().map(|span| span.start),
            Problem::Syntax(message.to_owned()),
        )
    })?;
    if let Some(camera) = &scene.camera {
        check_camera(camera.get_ref())
            .map_err(|problem| fail(Some(camera.span().start), problem))?;
    }
    let folder = file.parent().unwrap_or(Path::new(""));
    let mut objects = Vec::new();
    for entry in &scene.objects {
        let mut load = |path: &Path| meshes.load(path, progress, warnings);
        let made = entry.get_ref().objects(folder, &mut load);
        objects.extend(made.map_err(|problem| fail(Some(entry.span().start), problem))?);
    }
    Ok(Description {
        objects,
        camera: scene.camera.map(Spanned::into_inner),
    })
}

fn check_camera(camera: &CameraChoice) -> Result<(), Problem> {
    if camera.target.is_some() && camera.look.is_some() {
        return Err(Problem::Both("target and look"));
    }
    if camera.fov.is_some() && camera.ortho.is_some() {
        return Err(Problem::Both("fov and ortho"));
    }
    let vectors = [camera.eye, camera.target, camera.look, camera.up];
    let numbers = [camera.fov, camera.ortho, camera.near, camera.far];
    let finite = vectors.into_iter().flatten().all(DVec3::is_finite)
        && numbers.into_iter().flatten().all(f64::is_finite);
    finite
        .then_some(())
        .ok_or(Problem::NotFinite("the camera's numbers"))
}

impl Entry {
    /// The objects that the entry stands for: one, or those of its mesh file.
    fn objects(
        &self,
        folder: &Path,
        load: &mut dyn FnMut(&Path) -> Result<Arc<Mesh>, ObjError>,
    ) -> Result<Vec<Object>, Problem> {
        let shape = match self.shape {
            ShapeWord::Sphere => Shape::Sphere,
            ShapeWord::Cube => Shape::Cube,
            ShapeWord::Square => Shape::Square,
            ShapeWord::Mesh => return self.mesh_objects(folder, load),
        };
        if self.file.is_some() {
            return Err(Problem::NotAMesh("file"));
        }
        if self.part.is_some() {
            return Err(Problem::NotAMesh("part"));
        }
        let kind = match shape {
            Shape::Cube => "Cube",
            Shape::Square => "Square",
            _ => "Sphere",
        };
        let name = self.name.as_deref().unwrap_or(kind);
        Ok(vec![self.object(
            name.to_owned(),
            shape,
            self.placement(name)?,
        )])
    }

    fn mesh_objects(
        &self,
        folder: &Path,
        load: &mut dyn FnMut(&Path) -> Result<Arc<Mesh>, ObjError>,
    ) -> Result<Vec<Object>, Problem> {
        let file = self.file.as_ref().ok_or(Problem::NoFile)?;
        let placement = self.placement(self.name.as_deref().unwrap_or(file))?;
        let mesh = load(&folder.join(file)).map_err(|source| Problem::Mesh {
            file: file.clone(),
            source,
        })?;
        let parts = mesh.data().parts.len();
        let wanted = match self.part {
            None => 0..parts,
            Some(part) if (1..=parts).contains(&part) => part - 1..part,
            Some(part) => {
                return Err(Problem::NoSuchPart {
                    file: file.clone(),
                    parts,
                    part,
                });
            }
        };
        let single = wanted.len() == 1;
        let objects = wanted.map(|part| {
            let own = &mesh.data().parts[part].name;
            let name = match &self.name {
                Some(name) if single => name.clone(),
                Some(name) => format!("{name}: {own}"),
                None => own.clone(),
            };
            let mesh = Arc::clone(&mesh);
            self.object(name, Shape::Mesh { mesh, part }, placement)
        });
        Ok(objects.collect())
    }

    fn object(&self, name: String, shape: Shape, placement: Placement) -> Object {
        Object {
            colour: self.colour.map(|Colour(colour)| colour),
            visible: self.visible.unwrap_or(true),
            ..Object::new(name, shape, placement)
        }
    }

    fn placement(&self, object: &str) -> Result<Placement, Problem> {
        let parts = self.position.is_some() || self.rotation.is_some() || self.scale.is_some();
        let model = match self.matrix {
            Some(_) if parts => {
                return Err(Problem::Both("matrix and position, rotation or scale"));
            }
            Some(rows) => from_rows(rows),
            None => DAffine3 {
                matrix3: self.rotation.map_or(DMat3::IDENTITY, rotation)
                    * DMat3::from_diagonal(match self.scale {
                        None => DVec3::ONE,
                        Some(Scale::Uniform(scale)) => DVec3::splat(scale),
                        Some(Scale::Axes(scale)) => scale.into(),
                    }),
                translation: self.position.unwrap_or(DVec3::ZERO),
            },
        };
        Placement::new(model).map_err(|source| Problem::Placement {
            object: object.to_owned(),
            source,
        })
    }

    /// The entry that says what an object is.
    fn of(object: &Object, meshes: &[(PathBuf, Arc<Mesh>)]) -> Result<Self, SaveError> {
        let mut entry = Self {
            name: Some(object.name.clone()),
            shape: match object.shape {
                Shape::Sphere => ShapeWord::Sphere,
                Shape::Cube => ShapeWord::Cube,
                Shape::Square => ShapeWord::Square,
                Shape::Mesh { .. } => ShapeWord::Mesh,
            },
            file: None,
            part: None,
            colour: object.colour.map(Colour),
            position: None,
            rotation: None,
            scale: None,
            matrix: None,
            visible: (!object.visible).then_some(false),
        };
        if let Shape::Mesh { mesh, part } = &object.shape {
            let known = meshes.iter().find(|(_, other)| Arc::ptr_eq(mesh, other));
            let (path, _) = known.ok_or_else(|| SaveError::NoFile(object.name.clone()))?;
            let text = path
                .to_str()
                .ok_or_else(|| SaveError::Path(path.display().to_string()))?;
            entry.file = Some(text.to_owned());
            entry.part = Some(part + 1);
        }
        // In words where they give the same bits, for people who read the file; as a matrix otherwise.
        let model = object.placement.model();
        let DMat3 {
            x_axis,
            y_axis,
            z_axis,
        } = model.matrix3;
        let scale = DVec3::new(x_axis.x, y_axis.y, z_axis.z);
        entry.position = (model.translation != DVec3::ZERO).then_some(model.translation);
        entry.scale = (scale != DVec3::ONE).then(|| Scale::Axes(scale.to_array()));
        let bits = |model: DAffine3| model.to_cols_array().map(f64::to_bits);
        let same = entry
            .placement(&object.name)
            .is_ok_and(|placement| bits(placement.model()) == bits(model));
        if !same {
            (entry.position, entry.scale) = (None, None);
            entry.matrix = Some(rows(model));
        }
        Ok(entry)
    }
}

/// A scene as the text of a scene file, which reads back as the same scene to the bit. `meshes` are the files of
/// its meshes, as [`Loaded::meshes`](super::Loaded) has them.
///
/// # Errors
/// When a mesh has no file, or one with a path that TOML cannot hold.
pub fn to_toml(
    scene: &Scene,
    camera: &CameraChoice,
    meshes: &[(PathBuf, Arc<Mesh>)],
) -> Result<String, SaveError> {
    let unplaced = |entry| Spanned::new(0..0, entry);
    let objects = scene
        .objects()
        .iter()
        .map(|object| Entry::of(object, meshes).map(unplaced))
        .collect::<Result<_, _>>()?;
    let camera = (*camera != CameraChoice::default()).then(|| Spanned::new(0..0, *camera));
    Ok(toml::to_string(&SceneFile { camera, objects })?)
}

/// Turns by degrees about the world's x axis, then its y axis, then its z axis: `Rz * Ry * Rx`.
fn rotation(degrees: DVec3) -> DMat3 {
    let [(sx, cx), (sy, cy), (sz, cz)] = degrees.to_array().map(sin_cos_degrees);
    DMat3::from_cols(
        DVec3::new(cz * cy, sz * cy, -sy),
        DVec3::new(cz * sy * sx - sz * cx, sz * sy * sx + cz * cx, cy * sx),
        DVec3::new(cz * sy * cx + sz * sx, sz * sy * cx - cz * sx, cy * cx),
    )
}

/// Sine and cosine of an angle in degrees; exact for quarter turns, so that a box turned by 90 stays axis-aligned.
fn sin_cos_degrees(angle: f64) -> (f64, f64) {
    let quarters = (angle / 90.0).round();
    let (sin, cos) = (angle - 90.0 * quarters).to_radians().sin_cos();
    match quarters.rem_euclid(4.0) {
        1.0 => (cos, -sin),
        2.0 => (-sin, -cos),
        3.0 => (-cos, sin),
        _ => (sin, cos),
    }
}

fn from_rows(Rows([Row(x), Row(y), Row(z)]): Rows) -> DAffine3 {
    let column = |i: usize| DVec3::new(x[i], y[i], z[i]);
    DAffine3 {
        matrix3: DMat3::from_cols(column(0), column(1), column(2)),
        translation: column(3),
    }
}

fn rows(model: DAffine3) -> Rows {
    let DAffine3 {
        matrix3,
        translation,
    } = model;
    Rows(std::array::from_fn(|i| {
        let row = matrix3.row(i);
        Row([row.x, row.y, row.z, translation[i]])
    }))
}
