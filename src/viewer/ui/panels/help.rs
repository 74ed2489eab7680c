//! The help: what the mouse does, and every item of the menus with its keys, searched by any of its words.

use super::{arrangement::Topic, field::text_width, prelude::*, tour_card};
use crate::viewer::ui::{
    command::TourMove,
    focus::appears,
    menus::{Item, MENUS},
};
use egui::{Context, Id, Key, ScrollArea, TextEdit, TextStyle, Window};

/// The space around the rows, and the width of a row that does not wrap, in points.
const MARGIN: Vec2 = vec2(60.0, 120.0);
const ROW: f32 = 620.0;
/// Two columns stand side by side if each can be at least this wide, in points.
const NARROW: f32 = 500.0;

/// Width in points that keys take at least, so that most tables have their columns in one line.
const KEYS: f32 = 120.0;

/// What the mouse does.
const MOUSE: &[(&str, &str)] = &[
    ("left drag", "orbit about the point under the cursor"),
    (
        "Ctrl+left drag",
        "turn the scene's camera, also from one of the four views",
    ),
    ("right, middle, Shift+left drag", "pan"),
    (
        "wheel",
        "zoom at the cursor; so does a pinch on a touch screen, or on a Mac",
    ),
    ("Shift+wheel", "pan, on a trackpad in any direction"),
    (
        "click",
        "pick; the same pixel again: the next surface on the camera's ray",
    ),
    (
        "Ctrl+click, Shift+click",
        "add to what is selected, or take out; in the list, Shift: all rows between",
    ),
    ("right click", "a menu for what is under the cursor"),
    (
        "double click",
        "centre the point, turn about it; on nothing: frame all",
    ),
    (
        "click on the cross of axes",
        "look along an axis, from the end that is clicked",
    ),
    (
        "drag the section's arrow",
        "move the plane along its normal",
    ),
    (
        "drag an arrow of the selection",
        "move it along that axis; with Shift: turn it about the axis",
    ),
];

/// Rows about one subject: what is pressed, and what that does.
type Section = (&'static str, Vec<[String; 2]>);

pub(super) fn show(ctx: &Context, commands: &mut Vec<Command>) {
    let (mut open, mut escapes) = (true, false);
    let room = ctx.content_rect().size() - MARGIN;
    // Two columns where they fit: one is too long for a small screen.
    let (columns, width) = if room.x >= 2.0 * NARROW {
        (2, (0.5 * room.x).min(ROW))
    } else {
        (1, room.x.min(ROW))
    };
    Window::new("Help")
        .open(&mut open)
        .collapsible(false)
        .default_height(room.y)
        .resizable(false)
        // However few rows a search leaves, its field stays where it is.
        .anchor(Align2::CENTER_TOP, [0.0, MARGIN.y / 2.0])
        .show(ctx, |ui| {
            let searched = ui.horizontal_wrapped(|ui| {
                if ui.button("Take the tour").hint(tour_card::ABOUT).clicked() {
                    commands.push(Command::ToggleHelp);
                    commands.push(Command::Tour(TourMove::Begin));
                }
                search(ui)
            });
            #[expect(clippy::cast_precision_loss, reason = "one or two")]
            let all = columns as f32 * (width + ui.spacing().item_spacing.x);
            ui.set_min_width(all);
            let words;
            (words, escapes) = searched.inner;
            let sections = sections(&words);
            if sections.is_empty() {
                ui.weak("nothing has these words");
            }
            ScrollArea::vertical().max_height(room.y).show(ui, |ui| {
                ui.spacing_mut().item_spacing.y = 1.0;
                ui.horizontal_top(|ui| {
                    for column in in_columns(&sections, columns) {
                        ui.vertical(|ui| {
                            ui.set_width(width);
                            for (name, rows) in column {
                                ui.strong(*name);
                                table(ui, name, rows);
                                ui.add_space(4.0);
                            }
                        });
                    }
                });
            });
        });
    if !open || escapes {
        commands.push(Command::ToggleHelp);
    }
}

/// The field for words, which is empty whenever the help opens. Returns what stands in it, in small letters, and whether
/// Esc was pressed there.
fn search(ui: &mut Ui) -> (String, bool) {
    let id = Id::unique("words in the help");
    let is_new = appears(ui.ctx(), "help");
    let known = ui.data(|data| data.get_temp::<String>(id));
    let mut words = known.filter(|_| !is_new).unwrap_or_default();
    let field = TextEdit::singleline(&mut words).hint_text("search");
    let field = ui.add(field.desired_width(180.0)).named("search the help");
    // What is typed is for the help, and not for the scene behind it.
    if is_new {
        field.request_focus();
    }
    let escapes = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Escape));
    field.hint("shows only what has these words");
    let small = words.to_lowercase();
    ui.data_mut(|data| data.insert_temp(id, words));
    (small, escapes)
}

/// The rows that have all of these words, by subject.
fn sections(words: &str) -> Vec<Section> {
    let mouse = MOUSE.iter().map(|row| [row.0, row.1].map(str::to_owned));
    let row = |item: &Item| {
        let does = format!("{}: {}", item.name, item.hint);
        [item.all_keys(), does]
    };
    // Groups with a name are subjects of their own.
    let menus = MENUS.iter().flat_map(|menu| {
        let own = (menu.groups.iter()).filter(|group| group.name.is_none());
        let own = own.flat_map(|group| &group.items).map(row).collect();
        let named = menu.groups.iter().filter_map(|group| {
            let (name, _) = group.name.as_ref()?;
            Some((*name, group.items.iter().map(row).collect()))
        });
        std::iter::once((menu.name, own)).chain(named)
    });
    let topic = |topic: &Topic| {
        [
            "panel".to_owned(),
            format!("{}: {}", topic.name(), topic.about()),
        ]
    };
    let topics = Topic::ALL.iter().map(topic).collect();
    let all = std::iter::once(("Mouse", mouse.collect()))
        .chain(menus)
        .chain([("Inspector", topics)]);
    let found = all.map(|(name, rows): Section| {
        let has_all = |row: &[String; 2]| {
            let text = format!("{name} {} {}", row[0], row[1]).to_lowercase();
            words.split_whitespace().all(|word| text.contains(word))
        };
        (name, rows.into_iter().filter(has_all).collect::<Vec<_>>())
    });
    found.filter(|(_, rows)| !rows.is_empty()).collect()
}

/// The sections one after the other, in so many columns of about the same height.
fn in_columns(sections: &[Section], columns: usize) -> Vec<&[Section]> {
    let height =
        |sections: &[Section]| -> usize { sections.iter().map(|(_, rows)| rows.len() + 1).sum() };
    if columns < 2 {
        return vec![sections];
    }
    let longer = |at: &usize| height(&sections[..*at]).max(height(&sections[*at..]));
    let at = (0..=sections.len()).min_by_key(longer).unwrap_or(0);
    vec![&sections[..at], &sections[at..]]
}

fn table(ui: &mut Ui, name: &str, rows: &[[String; 2]]) {
    // In a narrow window, words wrap.
    let font = TextStyle::Monospace.resolve(ui.style());
    let keys = rows.iter().map(|[keys, _]| text_width(ui, keys, &font));
    let keys = keys.fold(0.0, f32::max);
    let room = ui.available_width() - ui.spacing().item_spacing.x;
    Grid::new(name)
        .num_columns(2)
        .min_col_width(KEYS.min(0.3 * room))
        .max_col_width((room - keys).max(0.5 * room))
        .striped(true)
        .show(ui, |ui| {
            for [keys, does] in rows {
                ui.monospace(keys);
                ui.label(does);
                ui.end_row();
            }
        });
}
