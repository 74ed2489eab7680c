//! The row at the top: the menus, and the tools, which are what has an icon in the menus. As the row gets narrower, names
//! go first; then the last tools move into a menu at the end.

use super::{arrangement::Side, exhibit, field::text_width, prelude::*, shown::Shown};
use crate::{
    scene::gallery::GALLERY,
    viewer::ui::{
        icons::{self, Icon},
        menus::{Group, Item, MENUS, Menu, More},
    },
};
use egui::{Atoms, Image, MenuBar, ScrollArea, TextStyle, containers::menu::MenuButton};
use std::slice;

/// Marks a tool that opens a menu.
const OPENS: &str = "\u{23f7}";

/// The button of the tools that the row has no room for.
const MORE: &str = "\u{bb}";

/// Width in points of the buttons at the end, which fold sides.
const END: f32 = 70.0;

/// Height in points of the window that a menu cannot have: the bar, and its own frame.
const ROOM_AROUND: f32 = 50.0;

/// Height in points of a menu's line, with the gap below it.
const LINE: f32 = 23.0;

pub(super) fn show(ui: &mut Ui, shown: &mut Shown, commands: &mut Vec<Command>) {
    MenuBar::new().ui(ui, |ui| {
        // A menu's own padding leaves switches too little of their colour.
        ui.spacing_mut().button_padding = vec2(5.0, 1.0);
        for menu in MENUS.iter() {
            let inside = |ui: &mut Ui| {
                opened(ui, line_count(menu, shown), commands, |ui, commands| {
                    items(ui, menu, shown, commands);
                });
            };
            ui.menu_button(menu.name, inside).response.hint(menu.hint);
        }
        let groups = tools();
        let (named, mut room_for) = fit(ui, &groups, ui.available_width() - END);
        let mut rest = Vec::new();
        for (group, named) in groups.iter().zip(named) {
            let (fits, over) = group.split_at(room_for.min(group.len()));
            room_for -= fits.len();
            if !fits.is_empty() {
                ui.separator();
            }
            for each in fits {
                tool(ui, shown, each, named, commands);
            }
            if !over.is_empty() {
                rest.push(over);
            }
        }
        if !rest.is_empty() {
            more(ui, shown, &rest, commands);
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            for (side, drawing, name) in [
                (Side::Right, icons::RIGHT, "right side"),
                (Side::Left, icons::LEFT, "left side"),
            ] {
                let on = shown.arrangement.showing[side as usize];
                let fold = Button::selectable(on, picture(&drawing)).frame_when_inactive(true);
                let fold = fold.image_tint_follows_text_color(true);
                let fold = ui.add(fold).named(name);
                let hint =
                    "show or fold the panels at this side; the picture keeps half of the window";
                if fold.hint(hint).clicked() {
                    shown.arrangement.toggle_side(side);
                }
            }
        });
    });
}

/// An open menu of so many lines. It scrolls where the window is lower, and closes once something is asked for.
fn opened(
    ui: &mut Ui,
    line_count: usize,
    commands: &mut Vec<Command>,
    lines: impl FnOnce(&mut Ui, &mut Vec<Command>),
) {
    let asked = commands.len();
    let room = ui.ctx().content_rect().height() - ROOM_AROUND;
    #[expect(clippy::cast_precision_loss, reason = "a few")]
    let is_room = LINE * line_count as f32 <= room;
    if is_room {
        lines(ui, commands);
    } else {
        let scrolled = ScrollArea::vertical().max_height(room);
        scrolled.show(ui, |ui| lines(ui, commands));
    }
    if commands.len() > asked {
        // By a key too, where egui leaves the menu open.
        ui.close();
    }
}

/// An open menu of these items.
fn opened_items(ui: &mut Ui, items: &[Item], shown: &Shown, commands: &mut Vec<Command>) {
    opened(ui, items.len(), commands, |ui, commands| {
        lines(ui, items, shown, commands);
    });
}

/// About how many lines a menu has.
fn line_count(menu: &Menu, shown: &Shown) -> usize {
    let items: usize = (menu.groups.iter())
        .map(|group| {
            if group.name.is_some() {
                2
            } else {
                group.items.len() + 1
            }
        })
        .sum();
    let more = match menu.more {
        None => 0,
        Some(More::Recent) => shown.recent.len().max(1) + 1,
        Some(More::Exhibits) => GALLERY.len() + 3,
    };
    items + more
}

/// What a menu holds.
fn items(ui: &mut Ui, menu: &Menu, shown: &Shown, commands: &mut Vec<Command>) {
    for (at, group) in menu.groups.iter().enumerate() {
        if at > 0 {
            ui.separator();
        }
        match &group.name {
            Some((name, _)) => submenu(ui, name, &group.items, shown, commands),
            None => lines(ui, &group.items, shown, commands),
        }
    }
    if let Some(more) = menu.more {
        ui.separator();
        match more {
            More::Recent => {
                ui.weak("Recent").hint("what was opened before");
                recent(ui, shown, commands);
            }
            More::Exhibits => {
                ui.weak("Gallery")
                    .hint("scenes on which known methods break");
                exhibit::menu(ui, shown, commands);
            }
        }
    }
}

/// Items, a line for each.
fn lines(ui: &mut Ui, items: &[Item], shown: &Shown, commands: &mut Vec<Command>) {
    for item in items {
        let is_on = item.is_on.as_ref().is_some_and(|is_on| is_on(shown));
        let line = Button::selectable(is_on, item.name).shortcut_text(item.first_keys());
        let line = ui.add_enabled((item.is_of_use)(shown), line);
        let line = line.named(item.name);
        line.asks(item.tells(shown), item.command.clone(), commands);
    }
}

/// What a group of items has.
fn names_of(items: &[Item]) -> String {
    let names: Vec<_> = items.iter().map(|item| item.name).collect();
    names.join(", ")
}

/// Items in a menu of their own, which opens beside its name.
fn submenu(
    ui: &mut Ui,
    name: &'static str,
    items: &[Item],
    shown: &Shown,
    commands: &mut Vec<Command>,
) {
    let opens = ui.menu_button(name, |ui| opened_items(ui, items, shown, commands));
    opens.response.hint(names_of(items));
}

/// Scenes that were opened before.
fn recent(ui: &mut Ui, shown: &Shown, commands: &mut Vec<Command>) {
    if shown.recent.is_empty() {
        ui.weak("nothing was opened before")
            .hint("files that you open are offered here");
    }
    for paths in shown.recent {
        let names = paths.iter().filter_map(|path| path.file_name());
        let names: Vec<_> = names.map(|name| name.to_string_lossy()).collect();
        let whole = paths.iter().map(|path| path.display().to_string());
        let whole: Vec<_> = whole.collect();
        let open = ui.button(names.join(" + "));
        open.asks(whole.join("\n"), Command::Open(paths.clone()), commands);
    }
}

/// A button of the toolbar.
enum Tool {
    /// It asks for an item.
    Item(&'static Item, &'static Icon),
    /// It opens a group of items.
    Group(&'static str, &'static Icon, &'static [Item]),
}

impl Tool {
    fn name(&self) -> &'static str {
        match self {
            Self::Item(item, _) => item.name.trim_end_matches('\u{2026}'),
            Self::Group(name, ..) => name,
        }
    }

    fn icon(&self) -> &'static Icon {
        match self {
            Self::Item(_, icon) | Self::Group(_, icon, _) => icon,
        }
    }
}

/// The tools, by the menus that they are from.
fn tools() -> Vec<Vec<Tool>> {
    let of_group = |group: &'static Group| {
        let opens = (group.name.as_ref()).map(|(name, icon)| Tool::Group(name, icon, &group.items));
        let items = group.items.iter();
        let items = items.filter_map(|item| Some(Tool::Item(item, item.icon.as_ref()?)));
        opens.into_iter().chain(items)
    };
    let groups = MENUS
        .iter()
        .map(|menu| menu.groups.iter().flat_map(of_group).collect());
    groups.filter(|group: &Vec<_>| !group.is_empty()).collect()
}

/// Which groups have names in `room` points, and how many tools show. Groups whose icons say least stand last and keep
/// their names longest: no group has names while a later one has none.
fn fit(ui: &Ui, groups: &[Vec<Tool>], room: f32) -> (Vec<bool>, usize) {
    let spacing = ui.spacing();
    let (gap, padding) = (spacing.item_spacing.x, 2.0 * spacing.button_padding.x);
    let font = TextStyle::Button.resolve(ui.style());
    let text = |text: &str| text_width(ui, text, &font) + spacing.icon_spacing;
    let bare = |tool: &Tool| {
        let arrow = match tool {
            Tool::Item(..) => 0.0,
            Tool::Group(..) => text(OPENS),
        };
        gap + padding + icons::SIDE + arrow
    };
    let separator = 6.0 + gap;
    let count: usize = groups.iter().map(Vec::len).sum();
    let mut named = vec![true; groups.len()];
    let width = |(group, named): (&Vec<Tool>, &bool)| -> f32 {
        let tool = |tool: &Tool| bare(tool) + if *named { text(tool.name()) } else { 0.0 };
        separator + group.iter().map(tool).sum::<f32>()
    };
    for at in 0..=groups.len() {
        if groups.iter().zip(&named).map(width).sum::<f32>() <= room {
            return (named, count);
        }
        if let Some(named) = named.get_mut(at) {
            *named = false;
        }
    }
    let mut left = room - gap - padding - text_width(ui, MORE, &font);
    let fitting = groups.iter().flat_map(|group| {
        let before = |at| if at == 0 { separator } else { 0.0 };
        (group.iter().enumerate()).map(move |(at, tool)| before(at) + bare(tool))
    });
    let fitting = fitting.take_while(|width| {
        left -= width;
        left >= 0.0
    });
    let shown = fitting.count();
    (named, shown)
}

/// Opens the tools that the row has no room for.
fn more(ui: &mut Ui, shown: &Shown, rest: &[&[Tool]], commands: &mut Vec<Command>) {
    let names: Vec<_> = rest.iter().copied().flatten().map(Tool::name).collect();
    let count = rest.iter().map(|group| group.len() + 1).sum();
    let inside = |ui: &mut Ui| {
        opened(ui, count, commands, |ui, commands| {
            for (at, group) in rest.iter().enumerate() {
                if at > 0 {
                    ui.separator();
                }
                for tool in *group {
                    match tool {
                        Tool::Item(item, _) => lines(ui, slice::from_ref(*item), shown, commands),
                        Tool::Group(name, _, items) => {
                            submenu(ui, name, items, shown, commands);
                        }
                    }
                }
            }
        });
    };
    let opens = ui.menu_button(MORE, inside).response;
    opens.named("more tools").hint(names.join(", "));
}

/// An icon in the colour of the text beside it.
fn picture(icon: &Icon) -> Image<'static> {
    Image::new(icon.clone()).fit_to_exact_size(Vec2::splat(icons::SIDE))
}

/// A tool in the row.
fn tool(ui: &mut Ui, shown: &Shown, tool: &Tool, with_name: bool, commands: &mut Vec<Command>) {
    let mut atoms = Atoms::new(picture(tool.icon()));
    if with_name {
        atoms.push_right(tool.name());
    }
    if let Tool::Group(..) = tool {
        atoms.push_right(OPENS);
    }
    let button = |is_on: Option<bool>| match is_on {
        Some(is_on) => Button::selectable(is_on, atoms.clone()).frame_when_inactive(true),
        None => Button::new(atoms.clone()),
    };
    let dressed = |button: Button<'static>| button.image_tint_follows_text_color(true);
    let hint = |tells: String| {
        if with_name {
            tells
        } else {
            format!("{}: {tells}", tool.name())
        }
    };
    match tool {
        Tool::Item(item, _) => {
            let is_on = item.is_on.as_ref().map(|is_on| is_on(shown));
            let button = ui.add_enabled((item.is_of_use)(shown), dressed(button(is_on)));
            let tells = format!("{} ({})", item.tells(shown), item.all_keys());
            let button = button.named(item.name);
            button.asks(hint(tells), item.command.clone(), commands);
        }
        Tool::Group(name, _, items) => {
            let menu = MenuButton::from_button(dressed(button(None)));
            let (opens, _) = menu.ui(ui, |ui| opened_items(ui, items, shown, commands));
            (opens.named(name)).hint(hint(names_of(items)));
        }
    }
}
