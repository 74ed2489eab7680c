//! The row of buttons at the top, in groups. As the row gets narrower, names go first; then groups move into a menu at
//! its end.

use super::{
    docks::Side,
    field::text_width,
    prelude::*,
    shown::Shown,
    tools::{Does, Tool, groups},
};
use egui::{AtomExt as _, Atoms, TextStyle};

/// How much of a group shows.
#[derive(Clone, Copy, PartialEq)]
enum Shows {
    Names,
    Icons,
    InMenu,
}

/// Width of an icon in points.
const ICON: f32 = 18.0;
/// Width in points of what stands at the end: the menu and the buttons that fold sides.
const END: f32 = 100.0;

pub(super) fn show(ui: &mut Ui, shown: &mut Shown, commands: &mut Vec<Command>) {
    let groups = groups(shown);
    let shows = fit(ui, &groups, ui.available_width() - END);
    ui.horizontal(|ui| {
        let mut add_groups = |ui: &mut Ui, in_menu: bool| {
            let here = groups.iter().zip(&shows);
            let here = here.filter(|(_, how)| (**how == Shows::InMenu) == in_menu);
            for (at, (group, how)) in here.enumerate() {
                if at > 0 {
                    ui.separator();
                }
                for tool in group {
                    add(ui, shown, tool, *how != Shows::Icons, commands);
                }
            }
        };
        add_groups(ui, false);
        if shows.contains(&Shows::InMenu) {
            let more = ui.menu_button(icon("\u{22ef}"), |ui| add_groups(ui, true));
            more.response.named("more").hint("what has no room here");
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            for (side, picture, name) in [
                (Side::Right, "\u{25e8}", "right side"),
                (Side::Left, "\u{25e7}", "left side"),
            ] {
                let on = shown.docks.showing[side as usize];
                let fold = Button::selectable(on, icon(picture)).frame_when_inactive(true);
                let fold = ui.add(fold).named(name);
                let hint =
                    "show or fold the panels at this side; the picture keeps half of the window";
                if fold.hint(hint).clicked() {
                    shown.docks.toggle(side);
                }
            }
        });
    });
}

/// How much of each group shows in `room` points. Groups whose icons say least stand last and keep their names longest:
/// no group has names while a later one in the row has none.
fn fit(ui: &Ui, groups: &[Vec<Tool>], room: f32) -> Vec<Shows> {
    let mut shows = vec![Shows::Names; groups.len()];
    let spacing = ui.spacing();
    let (gap, padding) = (spacing.item_spacing.x, 2.0 * spacing.button_padding.x);
    let font = TextStyle::Button.resolve(ui.style());
    let width = |group: &[Tool], named: bool| -> f32 {
        let tool = |tool: &Tool| {
            let name = || text_width(ui, tool.name, &font) + spacing.icon_spacing;
            padding + gap + ICON + if named { name() } else { 0.0 }
        };
        group.iter().map(tool).sum::<f32>() + 6.0 + gap
    };
    let named: Vec<_> = groups.iter().map(|group| width(group, true)).collect();
    let bare: Vec<_> = groups.iter().map(|group| width(group, false)).collect();
    let all = 0..groups.len();
    let names = all.clone().map(|at| (at, Shows::Icons));
    let groups = all.rev().map(|at| (at, Shows::InMenu));
    let mut total: f32 = named.iter().sum();
    for (at, how) in names.chain(groups) {
        if total <= room {
            break;
        }
        total -= if how == Shows::InMenu {
            bare[at]
        } else {
            named[at] - bare[at]
        };
        shows[at] = how;
    }
    shows
}

/// An icon. It is as large beside a name as alone.
fn icon(picture: &str) -> RichText {
    RichText::new(picture).font(FontId::monospace(14.0))
}

/// A tool in the row, or in the menu.
fn add(ui: &mut Ui, shown: &Shown, tool: &Tool, with_name: bool, commands: &mut Vec<Command>) {
    let atoms = |name: bool| {
        // As wide as any other icon: names stand in a column in the menu.
        let mut atoms = Atoms::new(icon(tool.icon).atom_size(vec2(ICON, 16.0)));
        if name {
            atoms.push_right(tool.name);
        }
        atoms
    };
    let response = match &tool.does {
        Does::Open(menu) => {
            let inside = |ui: &mut Ui| menu(ui, shown, commands);
            ui.menu_button(atoms(with_name), inside).response
        }
        Does::Ask(command) => {
            let button = match tool.is_on {
                Some(on) => Button::selectable(on, atoms(with_name)).frame_when_inactive(true),
                None => Button::new(atoms(with_name)),
            };
            let response = ui.add_enabled(tool.enabled, button);
            if response.clicked() {
                commands.push(command.clone());
            }
            response
        }
    };
    let response = response.named(tool.called);
    if with_name {
        response.hint(&tool.hint);
    } else {
        response.hint(format!("{}: {}", tool.name, tool.hint));
    }
}
