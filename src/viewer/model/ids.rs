//! Ids of objects as people write them, from 1, and what messages about them advise.

use crate::scene::{FlatFaces, NoSection, NoSuchObject, Scene};

/// What the flags `--hide` and `--show` say, by ids.
#[derive(Clone, Debug, Default)]
pub struct HideAndShow {
    /// Objects that are hidden.
    pub hide: Vec<usize>,
    /// Objects that show, though their scene file hides them.
    pub show: Vec<usize>,
}

impl HideAndShow {
    /// Hides and shows the objects, or none of a flag where one of its ids names no object. The error says what to do.
    pub(crate) fn apply(&self, scene: &mut Scene) -> Result<(), String> {
        for (flag, ids, visible) in [("hide", &self.hide, false), ("show", &self.show, true)] {
            let objects: Result<Vec<_>, _> = ids.iter().map(|id| scene.index_of(*id)).collect();
            let objects = objects.map_err(no_such_object);
            scene.show(
                &objects.map_err(|error| format!("--{flag}: {error}"))?,
                visible,
            );
        }
        Ok(())
    }
}

/// Why there is no object, and what to do.
fn no_such_object(error: NoSuchObject) -> String {
    format!("{error}; see 'sightline list'")
}

/// Why there is no section, and what to do.
pub(crate) fn no_section(error: &NoSection) -> String {
    let advice = match error {
        NoSection::Object(error) => return no_such_object(*error),
        NoSection::Section(_) => "",
        NoSection::Face { has, .. } | NoSection::Unnamed { has, .. } => match has {
            FlatFaces::None => "",
            FlatFaces::One => "; say face:ID",
            FlatFaces::Six => "; say face:ID,FACE",
            FlatFaces::Triangles => "; say face:ID,TRIANGLE, as picks name them",
        },
    };
    format!("{error}{advice}")
}
