//! What takes long. Each job is a thread and a receiver. It knows no window, and wakes its caller when it is done.

mod check;
mod desktop;
mod dialogs;
mod job;
mod keeping;
mod letting_go;
mod loading;
mod projecting;
mod reading_again;
mod saving;
mod snapping;
mod study;
mod trees;
mod typefaces;
mod uploading;
mod watching;

pub(super) use check::{Check, Checked, Checking};
pub(super) use desktop::ask_darkness;
pub(super) use dialogs::{Answer, open_dialog, save_dialog};
pub(super) use keeping::Keeping;
pub(super) use letting_go::let_go;
pub(super) use loading::Loading;
pub(super) use projecting::{InNdc, Projecting};
pub(super) use reading_again::{Found, Question, ReadingAgain};
pub(super) use saving::Saving;
pub(super) use snapping::Snapping;
pub(super) use study::Chart;
pub(super) use trees::TreeBuild;
pub(super) use typefaces::{Missing, Typeface, Typefaces};
pub(super) use uploading::{LITTLE, Making, Upload, Uploaded};
pub(super) use watching::Watching;
