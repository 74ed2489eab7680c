//! What the window shows and how it answers: no window, no graphics, no threads. Everything that a user does to scene
//! and view arrives as an [`Action`]; [`State::apply`] does it. Tests replay actions.

mod action;
mod command_line;
mod comparing;
mod editing;
mod hits;
mod made;
mod matrices;
mod measures;
mod measuring;
mod on_screen;
mod opening;
mod ortho_height;
mod overlay;
mod picking;
mod seeing;
mod showing;
mod stages;
mod staging;
mod state;
mod timeline;
mod undoing;
mod update;
mod viewing;

pub use action::{Action, LensControls};
pub(super) use command_line::{pick_command, verify_command, view_command};
pub use hits::{DepthSteps, Landmark, PickView, RayHits, triangle};
pub(super) use made::Made;
pub use matrices::{Matrices, Steps};
pub use measuring::{Entry, MeasureAction, Measuring, What};
pub(super) use on_screen::OnScreen;
pub(super) use opening::Snapshot;
pub use overlay::{Overlay, Overlays};
pub use showing::{Compared, Distance, Fault, Showing};
pub(super) use stages::Prepared;
pub use stages::{Stage, staged};
pub use state::{Cursor, DOUBLE_CLICK_S, Frozen, Selection, Source, State};
pub use viewing::CannotBe;
