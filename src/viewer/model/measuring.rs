//! The points that were clicked last, what is measured of them, and the list of measures.

use crate::pick::snap::{Snap, SnapTo};
use glam::DVec3;
use serde::Serialize;

/// What is measured. Lengths and areas are in world units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum What {
    /// Between the last two points.
    Distance,
    /// At the second of the last three points, between the directions to the others. In degrees.
    Angle,
    /// Of the circle through the last three points.
    Radius,
    /// Of the edge that the last point is on.
    Length,
    /// Of the face that the last point is on.
    FaceArea,
    /// Of the object that the last point is on.
    ObjectArea,
}

impl What {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::Distance,
        Self::Angle,
        Self::Radius,
        Self::Length,
        Self::FaceArea,
        Self::ObjectArea,
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Distance => "distance",
            Self::Angle => "angle",
            Self::Radius => "radius",
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
    /// In world units; an angle in degrees.
    pub value: f64,
    /// Of a distance: how far the second point lies from the first along each axis of the world.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub along: Option<DVec3>,
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

/// A point that is measured.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredPoint {
    /// Name of the object that it was clicked on.
    pub object: String,
    /// Where it is in the world: on the surface that was hit, or where the click snapped to.
    pub point_world: DVec3,
    /// What the click snapped to; `None` where clicks do not snap.
    pub snap: Option<Snap>,
    /// The area of its object; `None` where clicks do not snap, and for an ellipsoid.
    pub object_area: Option<f64>,
}

impl MeasuredPoint {
    /// The point to measure from, in the world: a vertex as its file writes it.
    fn measured_from(&self) -> DVec3 {
        let snapped = self.snap.as_ref().map(|snap| snap.measured_from);
        snapped.unwrap_or(self.point_world)
    }

    /// What it is, in a few words.
    pub fn label(&self) -> String {
        match &self.snap {
            Some(snap) => snap.label(),
            None => self.object.clone(),
        }
    }
}

/// The angle in degrees between two directions; `None` where one has no length. By `atan2`, which stays accurate at 0
/// and 180 degrees (Kahan, "Miscalculating Area and Angles of a Needle-like Triangle", section 13).
fn angle_deg(a: DVec3, b: DVec3) -> Option<f64> {
    let (a, b) = (a.try_normalize()?, b.try_normalize()?);
    Some(2.0 * libm::atan2((a - b).length(), (a + b).length()).to_degrees())
}

/// The radius of the circle through three points; `None` where they are in a line to within their rounding.
fn radius([a, b, c]: [DVec3; 3]) -> Option<f64> {
    let (ab, ac) = (b - a, c - a);
    let (twice_area, sides) = (ab.cross(ac).length(), [ab.length(), ac.length()]);
    // Coordinates and differences are rounded, each by half a unit in the last place, and so are the products.
    let size = a.abs().max(b.abs()).max(c.abs()).max_element();
    let rounding = f64::EPSILON * (4.0 * sides[0] * sides[1] + 4.0 * size * (sides[0] + sides[1]));
    let radius = sides[0] * sides[1] * (c - b).length() / (2.0 * twice_area);
    (twice_area > rounding).then_some(radius)
}

/// The list of measures, and the points that can be measured next.
#[derive(Clone, Debug, Default)]
pub struct Measuring {
    /// Whether clicks snap to vertices and edges.
    pub is_on: bool,
    /// The last points, at most [`Self::MOST`], the oldest first.
    pub points: Vec<MeasuredPoint>,
    /// What a click under the cursor would snap to.
    pub ahead: Option<Snap>,
    /// What was measured, oldest first.
    pub list: Vec<Entry>,
}

impl Measuring {
    /// Clicks snap to a vertex or an edge within this many pixels.
    pub const RADIUS_PX: f64 = 8.0;
    /// As many points as a measure needs.
    pub const MOST: usize = 3;

    /// Takes another point. The oldest ones go.
    pub(super) fn take(&mut self, point: MeasuredPoint) {
        self.points.push(point);
        let old = self.points.len().saturating_sub(Self::MOST);
        self.points.drain(..old);
    }

    /// The last two points, the older one first; `None` if there are fewer.
    pub fn last_two(&self) -> Option<&[MeasuredPoint; 2]> {
        self.points.last_chunk()
    }

    /// The measure of the last points; `None` where they do not give it.
    pub fn entry(&self, what: What) -> Option<Entry> {
        let last = self.points.last()?;
        let snap = last.snap.as_ref();
        let mut along = None;
        let (of, value) = match what {
            What::Distance => {
                let [from, to] = self.last_two()?;
                let of = format!("{} to {}", from.label(), to.label());
                let [from, to] = [from, to].map(MeasuredPoint::measured_from);
                along = Some(to - from);
                (of, from.distance(to))
            }
            What::Angle | What::Radius => {
                let points: &[MeasuredPoint; 3] = self.points.last_chunk()?;
                let [a, b, c] = points.each_ref().map(MeasuredPoint::label);
                let at = points.each_ref().map(MeasuredPoint::measured_from);
                let value = match what {
                    What::Angle => angle_deg(at[0] - at[1], at[2] - at[1])?,
                    _ => radius(at)?,
                };
                (format!("{a}, {b}, {c}"), value)
            }
            What::Length => (last.label(), snap?.length?),
            What::FaceArea => (face_label(snap?), snap?.area?),
            What::ObjectArea => (last.object.clone(), last.object_area?),
        };
        let what = what.name();
        Some(Entry {
            what,
            of,
            value,
            along,
            outdated: false,
        })
    }

    /// Why a measure cannot be taken, or what to do first.
    pub fn lacks(&self, what: What) -> &'static str {
        let has_some = !self.points.is_empty();
        match what {
            What::Distance if has_some => "click a second point",
            What::Distance => "click two points",
            What::Angle | What::Radius if self.points.len() < 3 => "click three points",
            What::Angle => "two of the points are the same",
            What::Radius => "the three points are in a line",
            _ if !self.is_on => {
                "tick \u{201c}snap clicks\u{201d} first, then click what is to be measured"
            }
            What::Length if has_some => "the last click did not snap to an edge: click one",
            What::FaceArea if has_some => "a corner of that face is not three numbers in the file",
            What::ObjectArea if has_some => "an ellipsoid's area is not computed",
            What::Length | What::FaceArea | What::ObjectArea => "click what is to be measured",
        }
    }

    /// What to do next, in a line.
    pub fn next(&self) -> &'static str {
        match (self.points.len(), self.is_on) {
            (0, false) => "Click a point in the picture.",
            (0, true) => "Click a vertex, an edge or a face.",
            (1, _) => "Click a second point.",
            (2, _) => "Click a third, for angle and radius.",
            _ => "Click on: the last points count.",
        }
    }

    /// The list as text, a line each.
    pub fn text(&self) -> String {
        let line = |entry: &Entry| {
            let Entry {
                what, of, value, ..
            } = entry;
            let along = entry.along.map_or(String::new(), |by| {
                format!("; along x {}, y {}, z {}", by.x, by.y, by.z)
            });
            let text = format!("{what}\t{value}\t{of}{along}\t{}", entry.remark());
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

#[cfg(test)]
mod tests {
    use super::{angle_deg, radius};
    use glam::dvec3;

    /// Against closed forms, also where `acos` of a product of unit vectors has lost half of its digits.
    #[test]
    fn angles_and_radii_are_those_of_closed_forms() {
        for half_turns in [1e-9, 1e-3, 0.25, 0.5, 1.0 - 1e-9] {
            let (sin, cos) = libm::sincos(std::f64::consts::PI * half_turns);
            let angle = angle_deg(dvec3(3.0, 0.0, 0.0), 7.0 * dvec3(cos, sin, 0.0));
            let off = angle.expect("an angle") / (180.0 * half_turns) - 1.0;
            assert!(off.abs() < 1e-14, "{half_turns}: {off}");
        }
        assert_eq!(angle_deg(dvec3(1.0, 0.0, 0.0), dvec3(0.0, 0.0, 0.0)), None);
        let on_circle = [0.1, 2.0, 4.5].map(|turn: f64| {
            let (sin, cos) = libm::sincos(turn);
            dvec3(5.0 + 2.5 * cos, -1.0 + 2.5 * sin, 7.0)
        });
        let off = radius(on_circle).expect("a circle") / 2.5 - 1.0;
        assert!(off.abs() < 1e-14, "{off}");
        for along in [
            [0.0, 1.0, 3.0],
            [0.1, 0.2, 0.3],
            [1e6, 1e6 + 0.1, 1e6 + 0.3],
        ] {
            let in_line = along.map(|x| dvec3(x, 2.0 * x, -3.0 * x));
            assert_eq!(radius(in_line), None, "{along:?}");
        }
    }
}
