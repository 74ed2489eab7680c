//! One `[[object]]` of a scene file, with its colour and model matrix as people write them.

use super::{MeshFile, ObjError, Object, Problem, SaveError, Shape, mesh_files::address};
use crate::{
    camera::{exactly, some_vector},
    colour::Srgb,
    geometry::{Mesh, Placement, Trs},
};
use glam::{DAffine3, DMat3, DVec3};
use serde::{Deserialize, Serialize};
use std::{collections::HashMap, path::Path, sync::Arc};

/// What a scene file says about one object, or about all objects of a mesh file.
#[derive(Default, Serialize, Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "an object, which begins with [[object]]"
)]
pub(super) struct Entry {
    name: Option<String>,
    shape: Option<ShapeWord>,
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
    fn from(Colour(colour): Colour) -> Self {
        Self::Hex(colour.to_string())
    }
}

impl Entry {
    /// The objects that the entry describes: one, or all objects of its mesh file.
    pub(super) fn objects(
        &self,
        folder: &Path,
        load: &mut dyn FnMut(&Path) -> Result<Arc<Mesh>, ObjError>,
    ) -> Result<Vec<Object>, Problem> {
        let (shape, kind) = match self.shape.ok_or(Problem::NoShape)? {
            ShapeWord::Sphere => (Shape::Sphere, "Sphere"),
            ShapeWord::Cube => (Shape::Cube, "Cube"),
            ShapeWord::Square => (Shape::Square, "Square"),
            ShapeWord::Mesh => return self.mesh_objects(folder, load),
        };
        if self.file.is_some() {
            return Err(Problem::NotAMesh("file"));
        }
        if self.part.is_some() {
            return Err(Problem::NotAMesh("part"));
        }
        let name = self.name.as_deref().unwrap_or(kind);
        let object = self.object(name.to_owned(), shape, self.placement(name)?);
        Ok(vec![object])
    }

    fn mesh_objects(
        &self,
        folder: &Path,
        load: &mut dyn FnMut(&Path) -> Result<Arc<Mesh>, ObjError>,
    ) -> Result<Vec<Object>, Problem> {
        let file = self.file.as_ref().filter(|file| !file.is_empty());
        let file = file.ok_or(Problem::NoFile)?;
        let placement = self.placement(self.name.as_deref().unwrap_or(file))?;
        let mesh = load(&folder.join(file)).map_err(Problem::Mesh)?;
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
            None => Trs {
                translation: self.position.unwrap_or(DVec3::ZERO),
                rotation_deg: self.rotation.unwrap_or(DVec3::ZERO),
                scale: match self.scale {
                    None => DVec3::ONE,
                    Some(Scale::Uniform(scale)) => DVec3::splat(scale),
                    Some(Scale::Axes(scale)) => scale.into(),
                },
            }
            .to_model(),
        };
        Placement::new(model).map_err(|source| Problem::Placement {
            object: object.to_owned(),
            source,
        })
    }

    /// The entry that describes an object. `meshes` are the files by the addresses of their meshes.
    pub(super) fn of(
        object: &Object,
        meshes: &HashMap<usize, &MeshFile>,
    ) -> Result<Self, SaveError> {
        let mut entry = Self {
            name: Some(object.name.clone()),
            shape: Some(match object.shape {
                Shape::Sphere => ShapeWord::Sphere,
                Shape::Cube => ShapeWord::Cube,
                Shape::Square => ShapeWord::Square,
                Shape::Mesh { .. } => ShapeWord::Mesh,
            }),
            colour: object.colour.map(Colour),
            visible: (!object.visible).then_some(false),
            ..Self::default()
        };
        if let Shape::Mesh { mesh, part } = &object.shape {
            let known = meshes.get(&address(mesh));
            let known = known.ok_or_else(|| SaveError::NoFile(object.name.clone()))?;
            let text = (known.path.to_str())
                .ok_or_else(|| SaveError::Path(known.path.display().to_string()))?;
            entry.file = Some(text.to_owned());
            entry.part = Some(part + 1);
        }
        // For readability, written as scale and position if they give the same bits; otherwise as a matrix.
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
            entry.matrix = Some(Rows(matrix_rows(model).map(Row)));
        }
        Ok(entry)
    }
}

fn from_rows(Rows([Row(x), Row(y), Row(z)]): Rows) -> DAffine3 {
    let column = |i: usize| DVec3::new(x[i], y[i], z[i]);
    DAffine3 {
        matrix3: DMat3::from_cols(column(0), column(1), column(2)),
        translation: column(3),
    }
}

/// A model matrix's upper three rows, as scene files have them.
pub(crate) fn matrix_rows(model: DAffine3) -> [[f64; 4]; 3] {
    let DAffine3 {
        matrix3,
        translation,
    } = model;
    std::array::from_fn(|i| {
        let row = matrix3.row(i);
        [row.x, row.y, row.z, translation[i]]
    })
}
