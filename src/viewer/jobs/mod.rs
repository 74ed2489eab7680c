//! What takes long, on threads of its own that know no window. Most of it is a `Job`, or holds one: when it is done, it
//! wakes its caller, who polls for the result. File dialogs and the question whether the desktop is dark are no `Job`:
//! they hand their answer to a function that the caller gave. A watch goes on until it is dropped, and wakes its caller
//! at every change.

mod check;
mod darkness;
mod dialogs;
mod job;
mod keeping;
mod loading;
mod portal;
mod reading_again;
mod saving;
mod snapping;
mod study;
mod trees;
mod typefaces;
mod watching;

pub(super) use check::{Check, Checked, Checking};
pub(super) use darkness::ask_darkness;
pub(super) use dialogs::{Answer, open_dialog, save_dialog};
pub(super) use job::Job;
pub(super) use keeping::keep;
pub(super) use loading::{Loading, load};
pub(super) use reading_again::ask_about_triangle;
pub(super) use saving::{Saving, save};
pub(super) use snapping::{Snapping, snap};
pub(super) use study::Chart;
pub(super) use trees::build_trees;
pub(super) use typefaces::{Missing, Typeface, Typefaces};
pub(super) use watching::{Stamps, Watching};
