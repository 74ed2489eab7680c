//! What the window remembers about sections, besides the one in the view.

use crate::geometry::Section;
use glam::DVec3;

/// The section to turn on again, and the picks so far for a section by three points.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct SectionMemory {
    /// The section that was turned off last.
    pub off: Option<Section>,
    /// The points picked so far, while the window waits for three.
    pub points: Option<Vec<DVec3>>,
}
