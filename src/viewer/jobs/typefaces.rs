//! Finds typefaces of the system for characters that egui's own lack.

use super::job::Job;
use skrifa::{FontRef, MetadataProvider};
use std::{
    collections::BTreeSet,
    mem,
    sync::{Arc, Mutex},
};

/// Characters that no typeface in use has; shared with the layout of text.
#[derive(Clone, Default)]
pub(in crate::viewer) struct Missing(Arc<Mutex<BTreeSet<char>>>);

impl Missing {
    /// Adds a character.
    pub fn add(&self, character: char) {
        if let Ok(mut all) = self.0.lock() {
            all.insert(character);
        }
    }

    /// Takes all characters.
    fn take(&self) -> BTreeSet<char> {
        let all = self.0.lock();
        all.map(|mut all| mem::take(&mut *all)).unwrap_or_default()
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
        let search = move |_: &_| {
            let mut system = fontdb::Database::new();
            system.load_system_fonts();
            choose(&system, wanted)
        };
        self.search = Some(Job::start(search, wake, Vec::new));
    }

    /// What was found, once the search is over.
    pub fn poll(&mut self) -> Vec<Typeface> {
        let Some(found) = self.search.as_ref().and_then(Job::poll) else {
            return Vec::new();
        };
        self.search = None;
        found
    }

    /// The characters that were missing so far.
    #[cfg(test)]
    pub fn searched(&self) -> &BTreeSet<char> {
        &self.known
    }

    /// Whether a search is under way.
    pub fn is_busy(&self) -> bool {
        self.search.is_some()
    }
}

/// Typefaces that have these characters. Each time, takes the one that has most of the characters left; among equals,
/// an upright, proportional one of regular weight.
fn choose(system: &fontdb::Database, mut wanted: BTreeSet<char>) -> Vec<Typeface> {
    let ranked = |face: &fontdb::FaceInfo| {
        let upright = face.style == fontdb::Style::Normal;
        let heavier = face.weight.0.abs_diff(fontdb::Weight::NORMAL.0);
        let rank = (upright, std::cmp::Reverse((face.monospaced, heavier)));
        (face.id, face.post_script_name.clone(), rank)
    };
    let faces: Vec<_> = system.faces().map(ranked).collect();
    let mut found = Vec::new();
    while !wanted.is_empty() {
        let has = |id| {
            let held = |bytes: &[u8], index| held(bytes, index, &wanted);
            system.with_face_data(id, held).unwrap_or_default()
        };
        let faces = faces.iter();
        let held = faces.map(|(id, name, rank)| (has(*id), id, name, rank));
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

#[cfg(test)]
mod tests {
    use super::{choose, held};
    use fontdb::{Database, FaceInfo, ID, Source, Stretch, Style, Weight};
    use std::{collections::BTreeSet, sync::Arc};

    /// The file of a typeface that has these characters. It holds only the table that says so, and no outlines.
    fn file(characters: &str) -> Vec<u8> {
        let characters: BTreeSet<char> = characters.chars().collect();
        let count = u32::try_from(characters.len()).expect("few");
        let tag = u32::from_be_bytes(*b"cmap");
        let directory = [0x0001_0000, 0x0001_0010, 0, tag, 0, 28, 28 + 12 * count];
        let table = [1, 0x0003_000a, 12, 0x000c_0000, 16 + 12 * count, 0, count];
        let glyphs = (1_u32..).zip(characters);
        let groups = glyphs.flat_map(|(glyph, c)| [u32::from(c), u32::from(c), glyph]);
        let words = directory.into_iter().chain(table).chain(groups);
        words.flat_map(u32::to_be_bytes).collect()
    }

    /// Each script gets a typeface that has it, upright and of regular weight. A character that no typeface has ends
    /// the search. The test does not use the system's own typefaces.
    #[test]
    fn every_script_gets_a_typeface_that_has_it() {
        let scripts = [
            ("Arabic", "\u{633}\u{644}\u{627}\u{645}"),
            ("Chinese", "\u{4f60}\u{597d}"),
            ("Emoji", "\u{1f980}\u{1fabf}"),
            ("Japanese", "\u{65e5}\u{672c}\u{306b}"),
            ("Korean", "\u{d55c}\u{ad6d}"),
            ("Thai", "\u{e2a}\u{e27}\u{e31}\u{e14}\u{e35}"),
        ];
        let mut system = Database::new();
        for (script, characters) in scripts {
            for (kind, style, weight) in [
                ("Italic", Style::Italic, Weight::NORMAL),
                ("Regular", Style::Normal, Weight::NORMAL),
                ("Bold", Style::Normal, Weight::BOLD),
            ] {
                system.push_face_info(FaceInfo {
                    id: ID::dummy(),
                    source: Source::Binary(Arc::new(file(characters))),
                    index: 0,
                    families: Vec::new(),
                    post_script_name: format!("{script}-{kind}"),
                    style,
                    weight,
                    stretch: Stretch::Normal,
                    monospaced: false,
                });
            }
        }
        let of_scripts = scripts.iter().flat_map(|(_, text)| text.chars());
        let wanted: BTreeSet<char> = of_scripts.chain(['\u{e000}']).collect();
        let mut found = choose(&system, wanted.clone());
        found.sort_by(|a, b| a.name.cmp(&b.name));
        assert_eq!(found.len(), scripts.len());
        for ((script, characters), face) in scripts.into_iter().zip(&found) {
            assert_eq!(face.name, format!("{script}-Regular"));
            let has = held(&face.bytes, face.index, &wanted);
            assert_eq!(has, characters.chars().collect(), "{script}");
        }
    }
}
