//! How much of a file is loaded.

/// How much of a mesh file is loaded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Detail {
    /// All that the file holds.
    #[default]
    All,
    /// Also the normals that the file lacks, computed now so that drawing need not wait for them.
    Drawn,
    /// What picks need: no normals, and nothing is said of them. Shading would compute all of them.
    Picked,
    /// The same without colours: MTL files are not read, and there are no warnings about them.
    Shapes,
}

impl Detail {
    /// Whether normals are loaded.
    pub(super) fn has_normals(self) -> bool {
        matches!(self, Self::All | Self::Drawn)
    }

    /// Whether colours are loaded.
    pub(super) fn has_colours(self) -> bool {
        self != Self::Shapes
    }
}
