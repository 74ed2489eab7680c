//! What the window remembers about sections beside the one that the view holds.

use crate::geometry::Section;
use glam::DVec3;

/// What turns a section on again, and what one by three points waits for.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct SectionMemory {
    /// The section that was turned off last.
    pub off: Option<Section>,
    /// The points picked so far, while the window waits for three.
    pub points: Option<Vec<DVec3>>,
}
