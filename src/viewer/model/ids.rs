//! Ids of objects as people write them, from 1, and what messages about them advise.

use crate::scene::{FlatFaces, NoSection, NoSuchObject, Scene};

/// Hides the objects with these ids, or none where an id names no object. The error says what to do.
pub(crate) fn hide(scene: &mut Scene, ids: &[usize]) -> Result<(), String> {
    let objects: Result<Vec<_>, _> = ids.iter().map(|id| scene.index_of(*id)).collect();
    scene.hide(&objects.map_err(no_such_object)?);
    Ok(())
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
