//! A section as users write it, in the same words on the command line, in scene files and in the window.

use crate::geometry::{Section, SectionError};
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::{fmt, str::FromStr};

/// The section that the user chose. World space and units.
///
/// | word | keeps |
/// |---|---|
/// | `none` | everything |
/// | `1,0,0,-0.5` | the points p with n . p + c >= 0: the three numbers of n, and c |
/// | `x:0.5`, `-x:0.5` | the points with x >= 0.5, or with x <= 0.5; likewise for y and z |
/// | `points:0,0,0/1,0,0/0,1,0` | the side of three points from which they are counter-clockwise |
/// | `face:3,7` | what lies behind a face: triangle 7 of object 3, or a cube's face, counted from 0 in the order +x, -x, +y, -y, +z, -z; `face:3` for a square |
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
#[non_exhaustive]
pub enum SectionChoice {
    /// Nothing is cut away.
    #[default]
    Uncut,
    /// A plane.
    Plane(Section),
    /// The plane of a face.
    Face {
        /// The object's number, from 1.
        id: usize,
        /// Its triangle, or a cube's face, from 0; `None` for a square.
        face: Option<u32>,
    },
}

/// Why a text is not a section. One line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SectionWordError {
    /// Not one of the forms.
    #[error(
        "a section is NX,NY,NZ,C, or x:0.5 (-x:0.5 keeps the other side), or points:X,Y,Z/X,Y,Z/X,Y,Z, or face:ID,TRIANGLE"
    )]
    Form,
    /// The numbers do not define a plane.
    #[error(transparent)]
    Section(#[from] SectionError),
}

impl FromStr for SectionChoice {
    type Err = SectionWordError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        if text.trim() == "none" {
            return Ok(Self::Uncut);
        }
        let Some((word, numbers)) = text.split_once(':') else {
            let [x, y, z, offset] = parsed(text, ',', number::<f64>)?;
            return Ok(Self::Plane(Section::new(DVec3::new(x, y, z), offset)?));
        };
        match word.trim() {
            "points" => {
                let point = |text: &str| parsed(text, ',', number).map(DVec3::from_array);
                let points = parsed(numbers, '/', point)?;
                Ok(Self::Plane(Section::through_points(points)?))
            }
            "face" => {
                let (id, face) = match numbers.split_once(',') {
                    Some((id, face)) => (id, Some(number(face)?)),
                    None => (numbers, None),
                };
                let id = number(id)?;
                Ok(Self::Face { id, face })
            }
            axis => {
                let negative = axis.strip_prefix('-').map(|name| (-1.0, name));
                let (sign, name) = negative.unwrap_or((1.0, axis));
                let axis = ["x", "y", "z"].iter().position(|other| *other == name);
                let axis = DVec3::AXES[axis.ok_or(SectionWordError::Form)?];
                let at: f64 = number(numbers)?;
                // Adding 0 turns -0 into 0.
                let section = Section::new(sign * axis + DVec3::ZERO, 0.0 - sign * at)?;
                Ok(Self::Plane(section))
            }
        }
    }
}

fn number<T: FromStr>(text: &str) -> Result<T, SectionWordError> {
    text.trim().parse().map_err(|_| SectionWordError::Form)
}

fn parsed<const N: usize, T>(
    text: &str,
    between: char,
    part: impl Fn(&str) -> Result<T, SectionWordError>,
) -> Result<[T; N], SectionWordError> {
    let all: Result<Vec<T>, _> = text.split(between).map(part).collect();
    all?.try_into().map_err(|_| SectionWordError::Form)
}

impl fmt::Display for SectionChoice {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Uncut => write!(f, "none"),
            Self::Plane(section) => {
                let DVec3 { x, y, z } = section.normal();
                write!(f, "{x},{y},{z},{}", section.offset())
            }
            Self::Face { id, face: None } => write!(f, "face:{id}"),
            Self::Face {
                id,
                face: Some(face),
            } => write!(f, "face:{id},{face}"),
        }
    }
}

impl TryFrom<String> for SectionChoice {
    type Error = SectionWordError;

    fn try_from(text: String) -> Result<Self, Self::Error> {
        text.parse()
    }
}

impl From<SectionChoice> for String {
    fn from(choice: SectionChoice) -> Self {
        choice.to_string()
    }
}
