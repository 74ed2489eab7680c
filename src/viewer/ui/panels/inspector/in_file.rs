//! What a mesh's file says about the pick.

use super::{field::value_text, prelude::*, value_rows::rows};
use crate::pick::Pick;
use egui::CollapsingHeader;

/// The most corners of a polygon that are listed.
const MOST_CORNERS: usize = 12;

/// The face that the pick is on, as its file writes it.
pub(super) fn show(ui: &mut Ui, hit: &Pick) {
    let said = &hit.in_file;
    let Some(path) = &said.file else { return };
    if let Some(error) = &said.file_error {
        ui.colored_label(ui.visuals().warn_fg_color, error)
            .hint("the file is read again at each pick; this time that failed");
        return;
    }
    let (Some(line), Some(face), Some(vertices)) = (said.line, said.face, &said.vertices) else {
        return;
    };
    let name = path.rsplit(['/', '\\']).next().unwrap_or(path);
    let corners = vertices.len();
    let kind = match corners {
        3 => "a triangle".to_owned(),
        4 => "a quad".to_owned(),
        _ => format!("a polygon of {corners} corners"),
    };
    let hint = "the file that the mesh was loaded from";
    let file = ("file", name.to_owned(), hint);
    let hint = "where the face stands in the file";
    let line = ("line", line.to_string(), hint);
    let hint = "its number among the file's f lines, from 1, and how many corners it has there";
    let face = ("face", format!("{face}, {kind}"), hint);
    rows(ui, "in file", &[file, line, face]);
    let header = CollapsingHeader::new("Corners in the file").default_open(true);
    let header = header.show(ui, |ui| {
        let of_triangle = |place: usize| {
            let place = u32::try_from(place).ok();
            place.is_some_and(|place| said.corners.is_some_and(|all| all.contains(&place)))
        };
        for (place, vertex) in vertices.iter().enumerate().take(MOST_CORNERS) {
            let mark = if of_triangle(place) { "\u{2022}" } else { " " };
            let text = format!("{mark} v {}: {}", vertex.vertex, vertex.written);
            let hint = "a dot marks the corners of the triangle that was hit";
            let hint = format!("as line {} writes it; {hint}", vertex.line);
            ui.add(Label::new(value_text(text)).wrap()).hint(hint);
            if let Some(stored) = vertex.stored {
                let text = format!("    stored {} {} {}", stored.x, stored.y, stored.z);
                ui.add(Label::new(value_text(text).weak()).wrap())
                    .hint("what it was rounded to on loading: picks and pictures use this");
            }
        }
        if let Some(more @ 1..) = corners.checked_sub(MOST_CORNERS) {
            ui.weak(format!("and {more} more"))
                .hint("all of them are in the copied JSON");
        }
    });
    let hint = "the face's vertices with their numbers, as the file writes them";
    header.header_response.hint(hint);
}
