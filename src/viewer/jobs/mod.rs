//! What takes long. Each job has a thread of its own and knows no window. When it is done, it wakes its caller, who polls for
//! the result, or it hands the result to a function that the caller gave.

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
