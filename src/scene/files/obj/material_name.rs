//! Finds the material that a `usemtl` line names among those that `newmtl` lines define.
//!
//! Exporters write any text as a name: `Plastic #1`, two blanks, a tab. So both lines mean the rest of the line, and
//! are compared in three ways. The first that finds a material counts:
//!
//! 1. as written;
//! 2. trimmed; then with each run of blanks and tabs as one blank, and without quotes around all of it;
//! 3. without a comment at the end of one of the two. `usemtl red # the door` finds `newmtl red`. But `Plastic #2`
//!    never finds `Plastic #1`: a comment is cut from one side only.
//!
//! Where only upper and lower case differ, the material is used, with a warning.

use super::library::unquoted;
use std::collections::HashMap;

/// The names that are defined. Of equal ones the first counts.
#[derive(Default)]
pub(super) struct MaterialNames {
    written: HashMap<String, usize>,
    trimmed: HashMap<String, usize>,
    squeezed: HashMap<String, usize>,
    lower: HashMap<String, usize>,
    /// By what stands before a `#`, which may begin a comment.
    before_comments: HashMap<String, Vec<Defined>>,
}

/// A material with a `#` in its name.
struct Defined {
    material: usize,
    is_comment: bool,
}

/// The material that a name means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Found {
    /// Its number.
    pub material: usize,
    /// False where the names differ by more than blanks, quotes and a comment.
    pub is_sure: bool,
}

impl MaterialNames {
    /// Adds a name as written.
    pub fn add(&mut self, name: &str, material: usize) {
        let squeezed = squeezed(name);
        self.written.entry(name.to_owned()).or_insert(material);
        let trimmed = self.trimmed.entry(name.trim_ascii().to_owned());
        trimmed.or_insert(material);
        if self.squeezed.contains_key(&squeezed) {
            return;
        }
        for (before, is_comment) in before_comments(&squeezed) {
            let defined = Defined {
                material,
                is_comment,
            };
            let all = self.before_comments.entry(before.to_owned());
            all.or_default().push(defined);
        }
        self.lower
            .entry(squeezed.to_lowercase())
            .or_insert(material);
        self.squeezed.entry(squeezed).or_insert(material);
    }

    /// The material that a name means, as written; `None` where none is defined for it.
    pub fn find(&self, name: &str) -> Option<Found> {
        let short = squeezed(name);
        let named = self.written.get(name);
        let named = named.or_else(|| self.trimmed.get(name.trim_ascii()));
        let named = named.or_else(|| self.squeezed.get(&short));
        if let Some(&material) = named {
            let is_sure = true;
            return Some(Found { material, is_sure });
        }
        let mut shorter = before_comments(&short);
        if let Some((material, is_sure)) = shorter.find_map(|(before, is_comment)| {
            // Where names differ only behind a `#`, it belongs to the names.
            let alike = self.before_comments.get(before);
            let has_alike = alike.is_some_and(|all| all.iter().any(|one| one.is_comment));
            let material = *self.squeezed.get(unquoted(before))?;
            Some((material, is_comment && !has_alike))
        }) {
            return Some(Found { material, is_sure });
        }
        if let Some([one]) = self.before_comments.get(&short).map(Vec::as_slice) {
            return Some(Found {
                material: one.material,
                is_sure: one.is_comment,
            });
        }
        let material = *self.lower.get(&short.to_lowercase())?;
        let is_sure = false;
        Some(Found { material, is_sure })
    }
}

/// Whether a name as written, for which nothing is defined, names no material: it is empty, nothing but a comment, or
/// what some exporters write for none.
pub(super) fn is_bare(name: &str) -> bool {
    let name = name.trim();
    name.is_empty() || name == "#" || name.starts_with("# ") || name == "(null)"
}

/// Trimmed, with each run of blanks and tabs as one blank, and without quotes around all of it.
fn squeezed(name: &str) -> String {
    let words: Vec<&str> = unquoted(name.trim_ascii())
        .split_ascii_whitespace()
        .collect();
    words.join(" ")
}

/// What stands before each `#` that follows a blank, the longest first, and whether a blank follows that `#`, as in a
/// comment.
fn before_comments(squeezed: &str) -> impl Iterator<Item = (&str, bool)> {
    // A name with more of them is no name.
    const MOST: usize = 8;
    let hashes = squeezed.rmatch_indices(" #").take(MOST);
    hashes.map(|(at, hash)| {
        let rest = &squeezed[at + hash.len()..];
        (&squeezed[..at], rest.is_empty() || rest.starts_with(' '))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(defined: &[&str], used: &str) -> Option<(usize, bool)> {
        let mut names = MaterialNames::default();
        for (material, name) in defined.iter().enumerate() {
            names.add(name, material);
        }
        let found = names.find(used)?;
        Some((found.material, found.is_sure))
    }

    #[test]
    fn a_name_is_the_rest_of_its_line_first() {
        let plastic = ["Plastic", "Plastic #1", "Plastic  #1", "Plastic #1 "];
        assert_eq!(found(&plastic, "Plastic"), Some((0, true)));
        assert_eq!(found(&plastic, "Plastic #1"), Some((1, true)));
        assert_eq!(found(&plastic, "Plastic  #1"), Some((2, true)));
        assert_eq!(found(&plastic, "Plastic #1 "), Some((3, true)));
        assert_eq!(found(&plastic, "Plastic\t#1"), Some((1, true)));
        assert_eq!(found(&["a", "a"], "a"), Some((0, true)), "the first");
        assert_eq!(found(&["\"a\"", "a"], "a "), Some((1, true)));
        assert_eq!(found(&["a  b", "a b"], "\ta b"), Some((1, true)));
        assert_eq!(found(&["a", "\"b c\""], "b c"), Some((1, true)));
        assert_eq!(found(&["a", "b c"], "'b c'"), Some((1, true)));
        assert_eq!(
            found(&["Grey # 1", "Grey # 2"], "Grey # 2"),
            Some((1, true))
        );
    }

    #[test]
    fn a_comment_is_cut_from_one_side() {
        assert_eq!(found(&["red"], "red # the door"), Some((0, true)));
        assert_eq!(found(&["red # the door"], "red"), Some((0, true)));
        assert_eq!(found(&["red # a", "red # a"], "red"), Some((0, true)));
        assert_eq!(found(&["red"], "\"red\" # a"), Some((0, true)));
        assert_eq!(found(&["red #1"], "red #1 # the door"), Some((0, true)));
        assert_eq!(found(&["red"], "red #1 # the door"), Some((0, false)));
        assert_eq!(found(&["red"], "red #2"), Some((0, false)));
        assert_eq!(found(&["red #1"], "red"), Some((0, false)));
    }

    #[test]
    fn a_name_is_never_another_ones() {
        assert_eq!(found(&["Plastic #1"], "Plastic #2"), None);
        assert_eq!(found(&["Grey # 1"], "Grey # 2"), None);
        assert_eq!(found(&["Grey #1", "Grey #2"], "Grey"), None);
        assert_eq!(found(&["Grey", "Grey # 1"], "Grey # 2"), Some((0, false)));
        assert_eq!(found(&["Red", "Blue"], "red"), Some((0, false)));
        assert_eq!(found(&["Red", "red"], "red"), Some((1, true)));
    }
}
