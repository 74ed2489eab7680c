//! What a mesh's file says about the pick, and fields that go to something by its number.

use super::{field::value_text, prelude::*, value_rows::rows};
use crate::{pick::Pick, viewer::ui::command::GoTo};
use egui::{CollapsingHeader, Id, TextEdit};

/// The most corners of a polygon that are listed.
const MOST_CORNERS: usize = 12;

/// Width of a field beyond its text, in points.
const FRAME: f32 = 8.0;

/// A field: its name, what is typed there, and where that leads.
type GoToField = (&'static str, &'static str, fn(usize) -> GoTo);

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

/// Fields that go to an object, face or vertex by its number, and the outcome of the last "go to".
pub(super) fn go_to(ui: &mut Ui, state: &State, said: Option<&str>, commands: &mut Vec<Command>) {
    let mut wrong = None;
    ui.horizontal(|ui| {
        ui.weak("go to").hint("type a number and press Enter");
        let object = "an object by its number in the list";
        let face = "a face by its number among the f lines of the selected object's file, or of the only file";
        let vertex = "a vertex by its number in the selected object's file, or in the only file";
        let fields: [GoToField; 3] = [
            ("object", object, GoTo::Object),
            ("face", face, GoTo::Face),
            ("vertex", vertex, GoTo::Vertex),
        ];
        let room = ui.available_width() - 2.0 * ui.spacing().item_spacing.x;
        let width = (room / 3.0 - FRAME).floor().max(40.0);
        for (name, hint, to) in fields {
            // A number is about one scene.
            let id = Id::unique(("go to", name, state.document()));
            let mut text: String = ui.data(|data| data.get_temp(id)).unwrap_or_default();
            let number = text.trim().parse::<usize>();
            let number = number.ok().filter(|number| *number > 0);
            let is_wrong = number.is_none() && !text.trim().is_empty();
            if is_wrong {
                wrong = Some(format!("{name} {}: type a whole number from 1", text.trim()));
            }
            let field = TextEdit::singleline(&mut text).id(id).hint_text(name);
            let mut field = field.desired_width(width);
            if is_wrong {
                field = field.text_color(ui.visuals().error_fg_color);
            }
            let response = ui.add(field).named(&format!("go to {name}"));
            let has_enter = ui.input(|input| input.key_pressed(egui::Key::Enter));
            let entered = response.lost_focus() && has_enter;
            if response.hint(hint).changed() {
                ui.data_mut(|data| data.insert_temp(id, text));
            }
            if let (true, Some(number)) = (entered, number) {
                commands.push(Command::GoTo(to(number)));
            }
        }
    });
    if let Some(wrong) = wrong {
        ui.colored_label(ui.visuals().error_fg_color, wrong)
            .hint("numbers are whole and begin at 1");
    }
    if let Some(said) = said {
        let text = match state.says_of_sought() {
            Some(seen) => format!("{said}: {seen}"),
            None => said.to_owned(),
        };
        let label = ui.add(Label::new(text).wrap());
        label.hint("where it is, and what hides it");
    }
}
