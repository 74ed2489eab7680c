//! Where panels stand beside the picture, which are folded, and how much of the window they leave to the picture.

use serde::{Deserialize, Serialize};
use std::mem;

/// A side of the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(in crate::viewer) enum Side {
    Left,
    Right,
}

impl Side {
    pub const BOTH: [Self; 2] = [Self::Left, Self::Right];

    /// Those of `panels` that stand at this side.
    pub fn of(self, panels: &[PanelKind]) -> Vec<PanelKind> {
        let here = panels.iter().copied();
        here.filter(|panel| panel.side() == self).collect()
    }
}

/// A panel. Each side shows its panels in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::viewer) enum PanelKind {
    Gallery,
    Camera,
    Pipeline,
    Pick,
    Measure,
    /// Last: it takes the height that is left.
    Objects,
}

impl PanelKind {
    pub const ALL: [Self; 6] = [
        Self::Gallery,
        Self::Camera,
        Self::Pipeline,
        Self::Pick,
        Self::Measure,
        Self::Objects,
    ];

    pub fn name(self) -> &'static str {
        match self {
            Self::Gallery => "Gallery scene",
            Self::Camera => "Camera",
            Self::Pipeline => "Matrices",
            Self::Pick => "Pick",
            Self::Measure => "Measure",
            Self::Objects => "Objects",
        }
    }

    /// Where it stands.
    pub(super) fn side(self) -> Side {
        match self {
            Self::Camera | Self::Pick => Side::Right,
            Self::Gallery | Self::Pipeline | Self::Measure | Self::Objects => Side::Left,
        }
    }

    /// The least width in points of a side that shows the whole panel.
    fn least_width(self) -> f32 {
        let panel = match self {
            Self::Objects => 120.0,
            Self::Pipeline => MATRIX,
            Self::Pick => RECORD,
            Self::Gallery | Self::Camera | Self::Measure => FIELDS,
        };
        panel + AROUND
    }

    /// The least height in points of what is below the heading, while the panel is open. What is longer scrolls.
    pub(super) fn least_height(self) -> f32 {
        match self {
            Self::Objects => 135.0,
            Self::Camera | Self::Pick | Self::Gallery | Self::Pipeline => 120.0,
            Self::Measure => 80.0,
        }
    }
}

/// From a panel to the window's border, in points.
pub(super) const TO_BORDER: i8 = 8;
/// From a panel's gutter, or the panel, to the picture, in points.
pub(super) const TO_PICTURE: i8 = 4;
/// The width in points beside panels in which their scroll bars lie: they cover nothing.
pub(super) const GUTTER: f32 = 7.0;
/// How much wider a side is than its panels, in points. The 1 is the line at its edge.
const AROUND: f32 = TO_BORDER as f32 + TO_PICTURE as f32 + GUTTER + 1.0;
/// The least width of a panel in points for three numbers in a row beside their name. A window of 640 x 400 has room
/// for it.
pub(super) const FIELDS: f32 = 250.0;
/// The same for three numbers with all their digits, beside a longer name.
const RECORD: f32 = 280.0;
/// The same for the four numbers of a matrix's row. A window of 1280 x 720 has room for it beside [`RECORD`].
pub(super) const MATRIX: f32 = 267.0;
/// Narrower than this, in points, a side is folded.
const NARROWEST: f32 = 100.0;

/// A side's panels together.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(in crate::viewer) struct Wing {
    pub open: bool,
    /// As wide as the user wants it, in points.
    pub width: f32,
}

/// How the sides were before panels that come and go took their room.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Before {
    wings: [Wing; 2],
    /// The side that was opened last.
    first: Side,
    /// Which panels took room since, and are still there.
    takers: [bool; PanelKind::ALL.len()],
}

/// What shows beside the picture, and how wide.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(in crate::viewer) struct Docks {
    /// Of which panels only the heading shows.
    pub(super) folded: [bool; PanelKind::ALL.len()],
    wings: [Wing; 2],
    /// The side that was opened last. It shows where there is no room for both.
    first: Side,
    /// How the sides were before panels that come and go took their room.
    #[serde(skip)]
    before: Option<Before>,
    /// Whether the gallery showed in the last pass.
    #[serde(skip)]
    in_gallery: bool,
    /// Which sides showed in the last pass.
    #[serde(skip)]
    pub showing: [bool; 2],
}

impl Default for Docks {
    fn default() -> Self {
        let wing = |width| Wing { open: true, width };
        Self {
            folded: PanelKind::ALL.map(|panel| panel == PanelKind::Measure),
            wings: [wing(210.0), wing(310.0)],
            first: Side::Right,
            before: None,
            in_gallery: false,
            showing: [true; 2],
        }
    }
}

impl Docks {
    /// Opens a side. Where there is no room for both, it shows in place of the other.
    pub fn open(&mut self, side: Side) {
        self.wings[side as usize].open = true;
        self.first = side;
        self.before = None;
    }

    /// Folds a side that shows; opens a side that does not.
    pub fn toggle(&mut self, side: Side) {
        if self.showing[side as usize] {
            self.wings[side as usize].open = false;
            self.before = None;
        } else {
            self.open(side);
        }
    }

    /// Makes the matrices visible. If they are visible already, they are no longer wanted.
    /// Returns whether they are wanted.
    pub fn toggle_matrices(&mut self, are_wanted: bool) -> bool {
        let are_visible = self.shows_matrices(are_wanted);
        if are_visible {
            self.leave_matrices();
        } else {
            self.take_room(PanelKind::Pipeline);
        }
        !are_visible
    }

    /// Whether the matrices, if they are wanted, can be seen.
    pub fn shows_matrices(&self, are_wanted: bool) -> bool {
        are_wanted && self.is_visible(PanelKind::Pipeline)
    }

    /// The matrices are no longer wanted: gives their room back, as `give_back` says.
    pub fn leave_matrices(&mut self) {
        self.give_back(PanelKind::Pipeline);
    }

    /// How wide each side is, as [`Self::widths`] says. As the gallery is entered, its panel becomes visible. As it is
    /// left, the sides are as they were before, unless the user has arranged them since.
    pub(super) fn lay_out(&mut self, panels: &[PanelKind], room: f32) -> [Option<f32>; 2] {
        let in_gallery = panels.contains(&PanelKind::Gallery);
        let was = mem::replace(&mut self.in_gallery, in_gallery);
        if was && !in_gallery {
            self.give_back(PanelKind::Gallery);
        }
        let widths = self.widths_shown(panels, room);
        // If another panel has taken room, the gallery's panel could vanish when that room is given back.
        let is_safe = self.is_visible(PanelKind::Gallery) && self.before.is_none();
        if in_gallery && !was && !is_safe {
            self.take_room(PanelKind::Gallery);
            return self.widths_shown(panels, room);
        }
        widths
    }

    /// The same as [`Self::widths`], and notes which sides show.
    fn widths_shown(&mut self, panels: &[PanelKind], room: f32) -> [Option<f32>; 2] {
        let widths = self.widths(panels, room);
        self.showing = widths.map(|width| width.is_some());
        widths
    }

    fn is_visible(&self, panel: PanelKind) -> bool {
        !self.folded[panel as usize] && self.showing[panel.side() as usize]
    }

    /// Makes a panel visible that comes and goes, and keeps how the sides were before.
    fn take_room(&mut self, panel: PanelKind) {
        let mut before = self.before.unwrap_or(Before {
            wings: self.wings,
            first: self.first,
            takers: [false; PanelKind::ALL.len()],
        });
        before.takers[panel as usize] = true;
        self.show(panel);
        self.before = Some(before);
    }

    /// After a panel that comes and goes has gone: if no other one still takes room, puts the sides back as they were
    /// before, unless the user has arranged them since.
    fn give_back(&mut self, panel: PanelKind) {
        let Some(before) = &mut self.before else {
            return;
        };
        before.takers[panel as usize] = false;
        if !before.takers.contains(&true) {
            (self.wings, self.first) = (before.wings, before.first);
            self.before = None;
        }
    }

    /// Makes a panel visible.
    pub fn show(&mut self, panel: PanelKind) {
        self.folded[panel as usize] = false;
        self.open(panel.side());
    }

    /// How wide each side is in points, both together at most `room`; `None` for a side that does not show: it is
    /// folded, has no panel or has no room. If there is no room for the panels of both sides, the one that was opened
    /// last shows.
    pub fn widths(&self, panels: &[PanelKind], room: f32) -> [Option<f32>; 2] {
        let least = Side::BOTH.map(|side| {
            let here = side.of(panels).into_iter();
            let open = here.filter(|panel| !self.folded[*panel as usize]);
            open.map(PanelKind::least_width).fold(NARROWEST, f32::max)
        });
        let wing = |side: Side| self.wings[side as usize];
        let shows = |side: Side| wing(side).open && !side.of(panels).is_empty();
        // NaN, which a file may hold, becomes the least.
        let wanted = |side: Side| wing(side).width.max(least[side as usize]);
        let alone = |side| Some(wanted(side).min(room)).filter(|width| *width >= NARROWEST);
        match [shows(Side::Left), shows(Side::Right)] {
            [false, false] => [None, None],
            [true, true] if least[0] + least[1] <= room => {
                let right = wanted(Side::Right).min(room - least[0]);
                [Some(wanted(Side::Left).min(room - right)), Some(right)]
            }
            [left, right] if left && (!right || self.first == Side::Left) => {
                [alone(Side::Left), None]
            }
            _ => [None, alone(Side::Right)],
        }
    }

    /// The edge of a side was dragged: the side is `width` points wide now, or folded if that is very little.
    pub fn drag(&mut self, side: Side, width: f32) {
        self.before = None;
        self.wings[side as usize] = Wing {
            width: width.max(NARROWEST),
            open: width >= 0.5 * NARROWEST,
        };
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
