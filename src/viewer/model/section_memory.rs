//! What of the section the view does not hold.

use crate::geometry::Section;
use glam::DVec3;

/// What turns a section on again, and what one by three points waits for.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct SectionMemory {
    /// The one that was turned off last.
    pub off: Option<Section>,
    /// While three picks are waited for: those that were made.
    pub points: Option<Vec<DVec3>>,
}
