//! The points that clicks snap to, and the list of measures.

use crate::pick::snap::{Snap, SnapTo};
use serde::Serialize;

/// What is measured. All of it is in world units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum What {
    /// Between the last two points.
    Distance,
    /// Of the edge that the last point is on.
    Length,
    /// Of the face that the last point is on.
    FaceArea,
    /// Of the object that the last point is on.
    ObjectArea,
}

impl What {
    /// All of them.
    pub const ALL: [Self; 4] = [
        Self::Distance,
        Self::Length,
        Self::FaceArea,
        Self::ObjectArea,
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Distance => "distance",
            Self::Length => "edge length",
            Self::FaceArea => "face area",
            Self::ObjectArea => "object area",
        }
    }
}

/// A line of the list. The field names are the JSON's.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Entry {
    /// What was measured.
    pub what: &'static str,
    /// The points, edge, face or object that was measured.
    pub of: String,
    /// In world units.
    pub value: f64,
    /// The scene has changed since: a file was read again, or something was moved.
    pub outdated: bool,
}

impl Entry {
    /// What the list adds after the value.
    pub fn remark(&self) -> &'static str {
        if self.outdated {
            "before the scene changed"
        } else {
            ""
        }
    }
}

/// The list of measures, and the points that can be measured next.
#[derive(Clone, Debug, Default)]
pub struct Measuring {
    /// Whether clicks snap to vertices and edges.
    pub is_on: bool,
    /// The last two points, the older one first.
    pub points: Vec<Snap>,
    /// The area of the last point's object; `None` without a point, and for an ellipsoid.
    pub object_area: Option<f64>,
    /// What was measured, oldest first.
    pub list: Vec<Entry>,
}

impl Measuring {
    /// Clicks snap to a vertex or an edge within this many pixels.
    pub const RADIUS_PX: f64 = 8.0;

    /// The measure of the last points; `None` where they do not give it.
    pub fn entry(&self, what: What) -> Option<Entry> {
        let last = self.points.last()?;
        let (of, value) = match what {
            What::Distance => {
                let [from, to] = &self.points[..] else {
                    return None;
                };
                let of = format!("{} to {}", from.label(), to.label());
                (of, from.measured_from.distance(to.measured_from))
            }
            What::Length => (last.label(), last.length?),
            What::FaceArea => (face_label(last), last.area?),
            What::ObjectArea => (last.object.clone(), self.object_area?),
        };
        let what = what.name();
        Some(Entry {
            what,
            of,
            value,
            outdated: false,
        })
    }

    /// Why a measure cannot be taken, or what to do first.
    pub fn lacks(&self, what: What) -> &'static str {
        match what {
            _ if !self.is_on => {
                "tick \u{201c}snap clicks\u{201d} first, then click what is to be measured"
            }
            What::Distance if self.points.is_empty() => "click two points",
            What::Distance => "click a second point",
            What::Length if !self.points.is_empty() => {
                "the last click did not snap to an edge: click one"
            }
            What::FaceArea if !self.points.is_empty() => {
                "a corner of that face is not three numbers in the file"
            }
            What::ObjectArea if !self.points.is_empty() => "an ellipsoid's area is not computed",
            What::Length | What::FaceArea | What::ObjectArea => "click what is to be measured",
        }
    }

    /// What to do next, in a line.
    pub fn next(&self) -> &'static str {
        match (self.is_on, self.points.len()) {
            (false, _) => "Tick \u{201c}snap clicks\u{201d}, then click in the picture.",
            (true, 0) => "Click a vertex, an edge or a face.",
            (true, 1) => "Click a second point, or choose a measure:",
            (true, _) => "Choose what to measure, or click on:",
        }
    }

    /// The list as text, a line each.
    pub fn text(&self) -> String {
        let line = |entry: &Entry| {
            let Entry {
                what, of, value, ..
            } = entry;
            let text = format!("{what}\t{value}\t{of}\t{}", entry.remark());
            format!("{}\n", text.trim_end())
        };
        self.list.iter().map(line).collect()
    }
}

fn face_label(snap: &Snap) -> String {
    match (snap.face, snap.triangle) {
        (Some(face), _) => format!("face {face} of {}", snap.object),
        (None, Some(triangle)) => format!("triangle {triangle} of {}", snap.object),
        (None, None) => snap.object.clone(),
    }
}

impl Snap {
    /// What it is, in a few words.
    pub fn label(&self) -> String {
        let vertices = self.vertices.as_deref().unwrap_or_default();
        match (self.to, vertices) {
            (SnapTo::Vertex, [vertex]) => format!("v {} of {}", vertex.vertex, self.object),
            (SnapTo::Edge, [a, b]) => format!("edge {}-{} of {}", a.vertex, b.vertex, self.object),
            (SnapTo::Vertex, _) => format!("a corner of {}", self.object),
            (SnapTo::Edge, _) => format!("an edge of {}", self.object),
            (SnapTo::Face, _) => face_label(self),
        }
    }
}

/// A change to the list of measures, or to whether clicks snap. All but [`Self::Toggle`] can be undone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeasureAction {
    /// Snap clicks to vertices and edges, or stop that.
    Toggle,
    /// Add a measure to the list; does nothing where it cannot be taken.
    Add(What),
    /// Remove a line, by its index.
    Remove(usize),
    /// Remove all lines.
    Clear,
}
