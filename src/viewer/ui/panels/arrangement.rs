//! What shows beside the picture, and how much of the window it leaves to the picture: the objects at the left, the
//! inspector at the right.

use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// A side of the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(in crate::viewer) enum Side {
    Left,
    Right,
}

impl Side {
    pub const BOTH: [Self; 2] = [Self::Left, Self::Right];
}

/// What the inspector says below what is picked, in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(in crate::viewer) enum Topic {
    Camera,
    Placement,
    Details,
    WorkedOut,
    Matrices,
    Measure,
    Section,
    DepthBuffer,
}

impl Topic {
    pub(super) const ALL: [Self; 8] = [
        Self::Camera,
        Self::Placement,
        Self::Details,
        Self::WorkedOut,
        Self::Matrices,
        Self::Measure,
        Self::Section,
        Self::DepthBuffer,
    ];

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Camera => "Camera",
            Self::Placement => "Placement",
            Self::Details => "Details",
            Self::WorkedOut => "Worked out",
            Self::Matrices => "Matrices",
            Self::Measure => "Measure",
            Self::Section => "Section",
            Self::DepthBuffer => "Depth buffer",
        }
    }

    /// What it holds, in a few words.
    pub(super) fn about(self) -> &'static str {
        match self {
            Self::Camera => {
                "where the camera stands, and what it takes in: projection, field of view (fov), near, far, up axis, eye, target"
            }
            Self::Placement => {
                "where the selected object stands: position, rotation and scale, the parts of its model matrix"
            }
            Self::Details => {
                "all that is known about the pick: digits, file, line, face, normal, NDC"
            }
            Self::WorkedOut => {
                "how courses compute this pick, step by step, by the study's methods in f64. Point at a number, and the views show what it is; point at it there, and the number lights up"
            }
            Self::Matrices => "P, V and M, and the pick on its way through them (P)",
            Self::Measure => {
                "distances, angles, radii, edge lengths and areas between clicked points, which snap to vertices and edges"
            }
            Self::Section => "a plane that cuts the scene open",
            Self::DepthBuffer => {
                "what the depth buffer stores, and how finely it tells depths apart"
            }
        }
    }
}

/// From a panel to the window's border, in points.
pub(super) const TO_BORDER: i8 = 8;
/// From a panel's gutter to the picture, in points.
pub(super) const TO_PICTURE: i8 = 4;
/// The width in points beside panels in which their scroll bars lie: they cover nothing.
pub(super) const GUTTER: f32 = 7.0;
/// How much wider a side is than what it holds, in points. The 1 is the line at its edge.
const AROUND: f32 = TO_BORDER as f32 + TO_PICTURE as f32 + GUTTER + 1.0;
/// The least width of the list of objects in points.
const OBJECTS: f32 = 140.0;
/// The same of a scene of the gallery.
const EXHIBIT: f32 = 250.0;
/// The least width in points for the four numbers of a matrix's row, the widest of the inspector. A window of 640 x 400
/// has room for it.
pub(super) const MATRIX: f32 = 267.0;
/// The places in [`Arrangement::before`].
const GALLERY: usize = 0;
const MATRICES: usize = 1;
/// A side that is dragged to less than this, in points, is closed.
const CLOSED: f32 = 50.0;

/// Which sides are open, how wide they are, and which topics of the inspector are unfolded.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub(in crate::viewer) struct Arrangement {
    open: [bool; 2],
    /// As wide as the user wants each side, in points.
    widths: [f32; 2],
    /// The side that was opened last. It shows where there is no room for both.
    latest: Side,
    pub(super) unfolded: BTreeSet<Topic>,
    /// Which sides showed in the last pass.
    #[serde(skip)]
    pub showing: [bool; 2],
    /// Whether the gallery showed in the last pass.
    #[serde(skip)]
    in_gallery: bool,
    /// Which sides were open, and which was opened last, before the gallery, and before the matrices opened one. Forgotten
    /// once the user opens or closes a side.
    #[serde(skip)]
    before: [Option<([bool; 2], Side)>; 2],
    /// The topic that is to come into view.
    #[serde(skip)]
    pub(super) revealed: Option<Topic>,
    /// How far the inspector is to be scrolled, in points.
    #[serde(skip)]
    pub(super) scroll_to: Option<f32>,
}

impl Default for Arrangement {
    fn default() -> Self {
        Self {
            open: [true; 2],
            widths: [210.0, 310.0],
            latest: Side::Right,
            unfolded: [Topic::Camera].into(),
            showing: [true; 2],
            in_gallery: false,
            before: [None; 2],
            revealed: None,
            scroll_to: None,
        }
    }
}

impl Arrangement {
    /// Opens a side. Where there is no room for both, it shows in place of the other.
    fn open(&mut self, side: Side) {
        self.open[side as usize] = true;
        self.latest = side;
    }

    /// Closes a side that shows; opens a side that does not.
    pub fn toggle_side(&mut self, side: Side) {
        self.before = [None; 2];
        if self.showing[side as usize] {
            self.open[side as usize] = false;
        } else {
            self.open(side);
        }
    }

    /// Whether a topic is unfolded in a side that shows.
    pub fn shows(&self, topic: Topic) -> bool {
        self.showing[Side::Right as usize] && self.unfolded.contains(&topic)
    }

    /// Unfolds a topic and brings it into view.
    pub fn show(&mut self, topic: Topic) {
        self.open(Side::Right);
        self.unfolded.insert(topic);
        self.revealed = Some(topic);
    }

    /// Folds a topic if it shows, and else shows it.
    pub fn toggle(&mut self, topic: Topic) {
        if self.shows(topic) {
            self.fold(topic);
        } else {
            self.show(topic);
        }
    }

    /// Folds the matrices if they show, and else shows them. As they are folded, the sides are as they were before,
    /// unless the user has opened or closed one since.
    pub fn toggle_matrices(&mut self) {
        if self.shows(Topic::Matrices) {
            self.fold(Topic::Matrices);
            self.give_back(MATRICES);
        } else {
            self.lend(MATRICES, |sides| sides.show(Topic::Matrices));
        }
    }

    /// Opens what is needed, and notes how the sides were.
    fn lend(&mut self, to: usize, open: impl FnOnce(&mut Self)) {
        self.before[to] = Some((self.open, self.latest));
        open(self);
    }

    /// What was opened has gone: the sides are as they were before.
    fn give_back(&mut self, from: usize) {
        if let Some(before) = self.before[from].take() {
            (self.open, self.latest) = before;
        }
    }

    pub fn fold(&mut self, topic: Topic) {
        self.unfolded.remove(&topic);
    }

    /// How wide each side is in points, both together at most `room`; `None` for a side that does not show. The
    /// gallery opens the left side as it is entered, and gives it back as it is left.
    pub(super) fn lay_out(&mut self, in_gallery: bool, room: f32) -> [Option<f32>; 2] {
        match (self.in_gallery, in_gallery) {
            (false, true) => self.lend(GALLERY, |sides| sides.open(Side::Left)),
            (true, false) => self.give_back(GALLERY),
            _ => {}
        }
        self.in_gallery = in_gallery;
        // A file may hold NaN.
        if self.widths.iter().any(|width| !width.is_finite()) {
            self.widths = Self::default().widths;
        }
        let widths = self.widths(room);
        self.showing = widths.map(|width| width.is_some());
        widths
    }

    fn widths(&self, room: f32) -> [Option<f32>; 2] {
        let left = if self.in_gallery { EXHIBIT } else { OBJECTS };
        let least = [left, MATRIX].map(|held| held + AROUND);
        let wanted = |side: Side| self.widths[side as usize].max(least[side as usize]);
        let alone = |side: Side| Some(wanted(side).min(room)).filter(|width| *width >= CLOSED);
        match self.open {
            [false, false] => [None, None],
            [true, true] if least[0] + least[1] <= room => {
                let right = wanted(Side::Right).min(room - least[0]);
                [Some(wanted(Side::Left).min(room - right)), Some(right)]
            }
            [left, right] if left && (!right || self.latest == Side::Left) => {
                [alone(Side::Left), None]
            }
            _ => [None, alone(Side::Right)],
        }
    }

    /// The edge of a side was dragged: the side is `width` points wide now, or closed if that is very little.
    pub(super) fn drag(&mut self, side: Side, width: f32) {
        self.before = [None; 2];
        self.open[side as usize] = width >= CLOSED;
        if width >= CLOSED {
            self.widths[side as usize] = width;
        }
    }
}

/// How wide both sides may be together, in points, so that the picture keeps half of the window's area. `left` is what
/// the panels above and below leave of the window.
pub(super) fn room(window: egui::Vec2, left: egui::Vec2) -> f32 {
    if left.y <= 0.0 {
        return 0.0;
    }
    // A point less: in the gallery the picture may be a pixel narrower than its place.
    (left.x - 0.5 * window.x * window.y / left.y - 1.0)
        .floor()
        .max(0.0)
}
