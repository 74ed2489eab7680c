//! What the user sees beside the scene, and how keys, mouse and buttons become commands.

mod command;
mod focus;
mod icons;
mod keys;
mod menus;
mod mouse;
mod notice;
mod panels;
mod theme;
mod tour;

pub(super) use command::{Command, Intent, Reply, Shot, ShotTo, TourMove};
pub(super) use focus::leave_text;
pub(super) use mouse::{Drag, moves_ahead, set_click};
pub(super) use notice::{Attempt, Kind, Notice, Notices};
pub(super) use panels::{Arrangement, Filter, Shown, Statistics, Sums, Topic, Underway, show};
pub(super) use theme::{Look, background, color32, dress, note_missing, panels_on};
pub(super) use tour::{JustDone, Start, Tour};
