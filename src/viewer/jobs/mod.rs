//! What takes long, on threads of its own that know no window. Most of it is a `Job`: when it is done, it wakes its
//! caller, who polls for the result. File dialogs and the question whether the desktop is dark are no `Job`: they hand
//! their answer to a function that the caller gave. A watch goes on until it is dropped, and wakes its caller at every
//! change. Freeing memory and writing what is remembered have no result.

mod check;
mod darkness;
mod dialogs;
mod job;
mod keeping;
mod letting_go;
mod loading;
mod portal;
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
pub(super) use darkness::ask_darkness;
pub(super) use dialogs::{Answer, open_dialog, save_dialog};
pub(super) use keeping::Keeping;
pub(super) use letting_go::let_go;
pub(super) use loading::Loading;
pub(super) use projecting::Projecting;
pub(super) use reading_again::{Found, Question, ReadingAgain};
pub(super) use saving::Saving;
pub(super) use snapping::Snapping;
pub(super) use study::Chart;
pub(super) use trees::TreeBuild;
pub(super) use typefaces::{Missing, Typeface, Typefaces};
pub(super) use uploading::{Making, Upload, Uploaded};
pub(super) use watching::{Stamps, Watching};
