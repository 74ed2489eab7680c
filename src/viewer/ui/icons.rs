//! The toolbar's drawings: one set, in `assets/icons`, on a grid of 18 by 18 points with strokes 1.5 points wide.

use egui::{ImageSource, include_image};

/// A drawing, white on a transparent ground.
pub(in crate::viewer) type Icon = ImageSource<'static>;

/// The sides of a drawing, in points.
pub(in crate::viewer) const SIDE: f32 = 18.0;

pub(in crate::viewer) const OPEN: Icon = include_image!("../../../assets/icons/open.svg");
pub(in crate::viewer) const SAVE: Icon = include_image!("../../../assets/icons/save.svg");
pub(in crate::viewer) const RELOAD: Icon = include_image!("../../../assets/icons/reload.svg");
pub(in crate::viewer) const SCREENSHOT: Icon =
    include_image!("../../../assets/icons/screenshot.svg");
pub(in crate::viewer) const UNDO: Icon = include_image!("../../../assets/icons/undo.svg");
pub(in crate::viewer) const REDO: Icon = include_image!("../../../assets/icons/redo.svg");
pub(in crate::viewer) const FRAME: Icon = include_image!("../../../assets/icons/frame.svg");
pub(in crate::viewer) const VIEWS: Icon = include_image!("../../../assets/icons/views.svg");
pub(in crate::viewer) const ORTHOGRAPHIC: Icon =
    include_image!("../../../assets/icons/orthographic.svg");
pub(in crate::viewer) const SECTION: Icon = include_image!("../../../assets/icons/section.svg");
pub(in crate::viewer) const OVERLAYS: Icon = include_image!("../../../assets/icons/overlays.svg");
pub(in crate::viewer) const FREEZE: Icon = include_image!("../../../assets/icons/freeze.svg");
pub(in crate::viewer) const MEASURE: Icon = include_image!("../../../assets/icons/measure.svg");
pub(in crate::viewer) const LEFT: Icon = include_image!("../../../assets/icons/left.svg");
pub(in crate::viewer) const RIGHT: Icon = include_image!("../../../assets/icons/right.svg");
