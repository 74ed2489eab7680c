//! Points that clicks are led to, and the list of measures.

use super::{
    field::{short, value_text},
    names::{Hint, named},
};
use crate::{
    json,
    pick::snap::Snap,
    viewer::{
        model::{Action, Entry, MeasureAction, State, What},
        ui::command::Command,
    },
};
use egui::{Button, Label, Ui};

pub(super) fn show(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    let measuring = state.measuring();
    let mut actions = Vec::new();
    let mut is_on = measuring.is_on;
    let toggle = ui.checkbox(&mut is_on, "snap clicks");
    let hint = "lead each click to the nearest visible vertex within 8 pixels, else to an edge of the file, else to the surface";
    if toggle.hint(hint).clicked() {
        actions.push(MeasureAction::Toggle);
    }
    match &measuring.points[..] {
        _ if !measuring.is_on => {}
        [] => {
            ui.weak("Click a vertex, an edge or a surface.").hint(hint);
        }
        points => {
            for (name, point) in ["from", "to"]
                .into_iter()
                .skip(2 - points.len())
                .zip(points)
            {
                self::point(ui, name, point);
            }
        }
    }
    ui.horizontal_wrapped(|ui| {
        for what in What::ALL {
            let entry = measuring.entry(what);
            let button = ui.add_enabled(entry.is_some(), Button::new(what.name()));
            let now = entry.map_or_else(
                || "click what it is of, with snapping".to_owned(),
                |entry| format!("{}: add it to the list", text(&entry)),
            );
            if button.hint(now).clicked() {
                actions.push(MeasureAction::Add(what));
            }
        }
    });
    for (at, entry) in measuring.list.iter().enumerate() {
        ui.horizontal(|ui| {
            let remove = ui.small_button("\u{d7}");
            named(&remove, &format!("remove measure {}", at + 1));
            if remove.hint("take this line away").clicked() {
                actions.push(MeasureAction::Remove(at));
            }
            ui.add(Label::new(value_text(text(entry))).wrap())
                .hint("in world units, and how far it may be off at most");
        });
    }
    let has_some = !measuring.list.is_empty();
    ui.horizontal(|ui| {
        let mut copied = None;
        let copy = ui.add_enabled(has_some, Button::new("copy list"));
        if copy.hint("all lines as text, with all digits").clicked() {
            copied = Some(measuring.text());
        }
        let copy = ui.add_enabled(has_some, Button::new("list as JSON"));
        if copy.hint("all lines as JSON, with all digits").clicked() {
            copied = json::text(&measuring.list).ok();
        }
        let clear = ui.add_enabled(has_some, Button::new("clear list"));
        if clear
            .hint("take all lines away; undo brings them back")
            .clicked()
        {
            actions.push(MeasureAction::Clear);
        }
        commands.extend(copied.map(Command::Copy));
    });
    // Where the side scrolls, its bar lies over its last line.
    ui.add_space(10.0);
    let act = |action| Command::Act(Action::Measure(action));
    commands.extend(actions.into_iter().map(act));
}

fn point(ui: &mut Ui, name: &str, point: &Snap) {
    let at = match point.vertices.as_deref() {
        Some([vertex]) => vertex.written.clone(),
        _ => format!(
            "{} {} {}",
            point.point_world.x, point.point_world.y, point.point_world.z
        ),
    };
    ui.add(Label::new(format!("{name} {}", point.label())).wrap())
        .hint("what the click was led to");
    ui.add(Label::new(value_text(at)).wrap())
        .hint("a vertex as the file writes it; another point in the world, with all digits");
}

fn text(Entry { what, of, measured }: &Entry) -> String {
    format!(
        "{what} {} \u{b1} {:.0e}, {of}",
        short(measured.value),
        measured.error
    )
}
