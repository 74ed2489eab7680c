//! Finds typefaces of the system for characters that egui's own lack.

use super::job::Job;
use skrifa::{FontRef, MetadataProvider};
use std::{
    collections::BTreeSet,
    sync::{Arc, Mutex},
};

/// Characters that no typeface in use has; shared with the layout of text.
#[derive(Clone, Default)]
pub(in crate::viewer) struct Missing(Arc<Mutex<BTreeSet<char>>>);

impl Missing {
    /// Adds one.
    pub fn add(&self, character: char) {
        if let Ok(mut all) = self.0.lock() {
            all.insert(character);
        }
    }

    /// Takes all of them.
    fn take(&self) -> BTreeSet<char> {
        self.0
            .lock()
            .map(|mut all| std::mem::take(&mut *all))
            .unwrap_or_default()
    }
}

/// A typeface, with the bytes of its file.
pub(in crate::viewer) struct Typeface {
    pub name: String,
    pub bytes: Vec<u8>,
    /// Its index in the file.
    pub index: u32,
}

/// The search for typefaces, one search at a time.
#[derive(Default)]
pub(in crate::viewer) struct Typefaces {
    pub missing: Missing,
    /// Characters that were searched for already.
    known: BTreeSet<char>,
    search: Option<Job<Vec<Typeface>>>,
}

impl Typefaces {
    /// Begins to search for characters that were not missing before; calls `wake` when done.
    pub fn search(&mut self, wake: impl FnOnce() + Send + 'static) {
        if self.search.is_some() {
            return;
        }
        let mut wanted = self.missing.take();
        wanted.retain(|character| !self.known.contains(character));
        if wanted.is_empty() {
            return;
        }
        self.known.extend(&wanted);
        self.search = Some(Job::start(move || search(wanted), wake));
    }

    /// What was found, once the search is over.
    pub fn poll(&mut self) -> Vec<Typeface> {
        let Some(found) = self.search.as_ref().and_then(Job::poll) else {
            return Vec::new();
        };
        self.search = None;
        found.unwrap_or_default()
    }

    /// Whether anything was missing so far.
    #[cfg(test)]
    pub fn has_searched(&self) -> bool {
        !self.known.is_empty()
    }

    /// Whether a search is under way.
    pub fn is_busy(&self) -> bool {
        self.search.is_some()
    }
}

/// Typefaces of the system that have these characters: each time the one with most of those left. Of equals, an
/// upright, proportional one of regular weight.
fn search(mut wanted: BTreeSet<char>) -> Vec<Typeface> {
    let mut system = fontdb::Database::new();
    system.load_system_fonts();
    let faces: Vec<_> = system
        .faces()
        .map(|face| {
            let upright = face.style == fontdb::Style::Normal;
            let heavier = face.weight.0.abs_diff(fontdb::Weight::NORMAL.0);
            let rank = (upright, std::cmp::Reverse((face.monospaced, heavier)));
            (face.id, face.post_script_name.clone(), rank)
        })
        .collect();
    let mut found = Vec::new();
    while !wanted.is_empty() {
        let has = |id| {
            system
                .with_face_data(id, |bytes, index| held(bytes, index, &wanted))
                .unwrap_or_default()
        };
        let held = faces
            .iter()
            .map(|(id, name, rank)| (has(*id), id, name, rank));
        let best = held.max_by_key(|(held, _, _, rank)| (held.len(), *rank));
        let Some((held, id, name, _)) = best.filter(|(held, ..)| !held.is_empty()) else {
            log::info!("no typeface of this system has {wanted:?}");
            break;
        };
        wanted.retain(|character| !held.contains(character));
        let read = |bytes: &[u8], index| Typeface {
            name: name.clone(),
            bytes: bytes.to_vec(),
            index,
        };
        found.extend(system.with_face_data(*id, read));
    }
    found
}

/// The characters of `wanted` that a typeface has.
fn held(bytes: &[u8], index: u32, wanted: &BTreeSet<char>) -> BTreeSet<char> {
    let Ok(face) = FontRef::from_index(bytes, index) else {
        return BTreeSet::new();
    };
    let characters = face.charmap();
    let has = |character: &&char| characters.map(**character).is_some();
    wanted.iter().filter(has).copied().collect()
}
