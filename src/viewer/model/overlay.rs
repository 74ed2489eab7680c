//! What is shown over the scene on request.

/// Something shown over the scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Overlay {
    /// The grid on the ground, with axes.
    Grid,
    /// The triangle under the pick, with its corners and barycentrics.
    Triangle,
    /// The distance between the last two picks.
    Distance,
    /// The edges of triangles.
    Wireframe,
    /// Outward normals of faces.
    Normals,
    /// World-space bounding boxes.
    Boxes,
}

impl Overlay {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::Grid,
        Self::Triangle,
        Self::Distance,
        Self::Wireframe,
        Self::Normals,
        Self::Boxes,
    ];

    /// Whether its lines in the scene are those of what is selected, or else of all. The grid has lines of its own, and
    /// the panels draw what belongs to the pick.
    fn depends_on_selection(self) -> bool {
        !matches!(self, Self::Grid | Self::Triangle | Self::Distance)
    }
}

/// Which overlays show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Overlays {
    /// A bit for each [`Overlay`].
    shown: u32,
    /// The level whose boxes show, of the trees over meshes; 0 is the root.
    pub tree_level: Option<u32>,
}

impl Default for Overlays {
    fn default() -> Self {
        Self {
            shown: 1 << Overlay::Grid as u32 | 1 << Overlay::Triangle as u32,
            tree_level: None,
        }
    }
}

impl Overlays {
    /// Whether one shows.
    pub fn shows(self, overlay: Overlay) -> bool {
        self.shown & (1 << overlay as u32) != 0
    }

    /// The same with one of them switched.
    pub fn toggled(mut self, overlay: Overlay) -> Self {
        self.shown ^= 1 << overlay as u32;
        self
    }

    /// The same with the next tree level, or with the one before.
    pub(super) fn next_tree_level(self, deeper: bool) -> Self {
        let tree_level = match (self.tree_level, deeper) {
            (None, true) => Some(0),
            (None, false) => Some(DEEPEST),
            (Some(level), true) => Some(level + 1).filter(|level| *level <= DEEPEST),
            (Some(level), false) => level.checked_sub(1),
        };
        Self { tree_level, ..self }
    }

    /// Whether the lines in the scene depend on what is selected.
    pub(in crate::viewer) fn depend_on_selection(self) -> bool {
        let mut all = Overlay::ALL.into_iter();
        let shows = all.any(|overlay| self.shows(overlay) && overlay.depends_on_selection());
        shows || self.tree_level.is_some()
    }
}

/// Trees over real meshes are 5 to 8 nodes deep, even over millions of triangles.
const DEEPEST: u32 = 8;
