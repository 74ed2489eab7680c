//! What the window shows and how it answers: no window, no graphics, no threads. Everything that a user does to scene
//! and view arrives as an [`Action`]; [`State::apply`] does it. Tests replay actions.

mod action;
mod command_line;
mod comparing;
mod editing;
mod hits;
mod made;
mod matrices;
mod observer;
mod on_screen;
mod opening;
mod ortho_height;
mod overlay;
mod pane_mouse;
mod picking;
mod section_memory;
mod sectioning;
mod seeing;
mod showing;
mod stages;
mod staging;
mod state;
mod subject;
mod timeline;
mod undoing;
mod update;
mod viewing;
mod views;

pub use action::{Action, LensControls};
pub(super) use command_line::{pick_command, verify_command, view_command};
pub use hits::{DepthSteps, Landmark, PickView, RayHits, triangle};
pub(super) use made::Made;
pub use matrices::{Matrices, Matrix, Row, Steps};
pub(super) use on_screen::OnScreen;
pub(super) use opening::Snapshot;
pub use overlay::{Overlay, Overlays};
pub use pane_mouse::Followed;
pub use showing::{Compared, Distance, Fault, Showing};
pub use stages::{Stage, projected};
pub use state::{Cursor, DOUBLE_CLICK_S, Frozen, Selection, Source, State};
pub(super) use subject::{Lesson, Subject};
pub use viewing::CannotBe;
pub(super) use views::Source as ProjectedOf;
pub use views::{NDC_DRAWN, Views};
