//! Names the surfaces at a position that drawing cannot tell apart, for people and for JSON.

use super::SceneHit;
use crate::scene::Scene;
use serde::Serialize;
use std::fmt::{self, Display, Formatter};

/// At most this many surfaces are named; the count is always complete.
pub const MOST_NAMED: usize = 8;

/// Surfaces at a position that lie so close together that drawing may show any of them: the picked one and those that
/// drawing cannot tell from it. The field names are the JSON's.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct InOnePlace {
    /// How many: two or more.
    pub count: usize,
    /// Up to eight of them in the order of picks; the picked one is the first.
    pub named: Vec<NamedSurface>,
}

/// A surface by its name.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NamedSurface {
    /// The object's name.
    pub object: String,
    /// The object's id: its number for people, from 1. Its index is one less.
    pub id: usize,
    /// Triangle of the object, from 0; `None` for analytic shapes.
    pub triangle: Option<u32>,
    /// Whether it is seen from outside.
    pub front: bool,
}

impl NamedSurface {
    /// The surface of a hit.
    ///
    /// # Panics
    /// When the hit is on another scene, as [`SceneHit::triangle_of_object`].
    pub fn of(scene: &Scene, hit: &SceneHit) -> Self {
        Self {
            object: scene.objects()[hit.object].name.clone(),
            id: hit.object + 1,
            triangle: hit.triangle_of_object(scene),
            front: hit.hit.front,
        }
    }
}

impl InOnePlace {
    /// From hits in the order of picks; `None` for fewer than two.
    ///
    /// # Panics
    /// When a hit is on another scene, as [`SceneHit::triangle_of_object`].
    pub fn of(scene: &Scene, hits: &[SceneHit]) -> Option<Self> {
        (hits.len() > 1).then(|| Self {
            count: hits.len(),
            named: (hits.iter().take(MOST_NAMED))
                .map(|hit| NamedSurface::of(scene, hit))
                .collect(),
        })
    }

    /// A surface's name, with what tells it from the others named.
    fn label(&self, of: &NamedSurface) -> String {
        let others = || self.named.iter().filter(|other| *other != of);
        let mut label = of.object.clone();
        if others().any(|other| other.object == of.object && other.id != of.id) {
            label = format!("{} {label}", of.id);
        }
        match of.triangle {
            Some(triangle) if others().any(|other| other.id == of.id) => {
                format!("{label} triangle {triangle}")
            }
            _ => label,
        }
    }
}

/// As "two in one place: A and B".
impl Display for InOnePlace {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match self.count {
            2 => write!(f, "two")?,
            3 => write!(f, "three")?,
            count => write!(f, "{count}")?,
        }
        let mut names: Vec<_> = self.named.iter().map(|of| self.label(of)).collect();
        let last = match self.count - self.named.len() {
            0 => names.pop().unwrap_or_default(),
            more => format!("{more} more"),
        };
        write!(f, " in one place: {} and {last}", names.join(", "))
    }
}
