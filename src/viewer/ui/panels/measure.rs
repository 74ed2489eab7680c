//! The points that clicks snap to, and the list of measures.

use super::{
    field::value_text,
    hints::{Hint, named},
};
use crate::{
    json,
    pick::{measure::Measured, snap::Snap},
    viewer::{
        model::{Action, Entry, MeasureAction, Measuring, State, What},
        ui::command::Command,
    },
};
use egui::{Button, Label, Ui};

pub(super) fn show(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    let measuring = state.measuring();
    let mut actions = Vec::new();
    let mut is_on = measuring.is_on;
    let toggle = ui.checkbox(&mut is_on, "snap clicks");
    let hint = "snap each click to the nearest visible vertex within 8 pixels, else to an edge of the file's polygons, else to the surface";
    if toggle.hint(hint).clicked() {
        actions.push(MeasureAction::Toggle);
    }
    // It has one line, whatever it says, so that nothing below it moves.
    ui.add(Label::new(measuring.next()).truncate())
        .hint("what to do next");
    ui.horizontal_wrapped(|ui| {
        for what in What::ALL {
            let entry = measuring.entry(what);
            let button = ui.add_enabled(entry.is_some(), Button::new(what.name()));
            let now = match entry {
                Some(entry) => format!("{}: add it to the list", text(&entry)),
                None => measuring.lacks(what).to_owned(),
            };
            if button.hint(now).clicked() {
                actions.push(MeasureAction::Add(what));
            }
        }
    });
    let has_some = !measuring.list.is_empty();
    ui.horizontal(|ui| copying(ui, measuring, has_some, commands, &mut actions));
    // Below all buttons, which therefore do not move as points come and go.
    for (name, at) in [("from", 2), ("to", 1)] {
        let at = measuring.points.len().checked_sub(at);
        point(ui, name, at.and_then(|at| measuring.points.get(at)));
    }
    for (at, entry) in measuring.list.iter().enumerate() {
        ui.horizontal(|ui| {
            let remove = ui.small_button("\u{d7}");
            named(&remove, &format!("remove measure {}", at + 1));
            if remove.hint("remove this line").clicked() {
                actions.push(MeasureAction::Remove(at));
            }
            ui.add(Label::new(value_text(text(entry))).wrap())
                .hint("in world units, with the most that it may be off");
        });
    }
    // Where the side scrolls, its scroll bar covers the last line.
    ui.add_space(10.0);
    let act = |action| Command::Act(Action::Measure(action));
    commands.extend(actions.into_iter().map(act));
}

/// Buttons for the whole list.
fn copying(
    ui: &mut Ui,
    measuring: &Measuring,
    has_some: bool,
    commands: &mut Vec<Command>,
    actions: &mut Vec<MeasureAction>,
) {
    let button = |ui: &mut Ui, name: &str, hint: &str| {
        let hint = if has_some {
            hint
        } else {
            "nothing was measured yet"
        };
        let button = ui.add_enabled(has_some, Button::new(name));
        button.hint(hint).clicked()
    };
    if button(ui, "copy list", "all lines as text, with all digits") {
        commands.push(Command::Copy(measuring.text()));
    }
    if button(ui, "list as JSON", "all lines as JSON, with all digits") {
        commands.extend(json::text(&measuring.list).ok().map(Command::Copy));
    }
    let hint = "remove all lines; undo brings them back";
    if button(ui, "clear list", hint) {
        actions.push(MeasureAction::Clear);
    }
}

/// One of the last two points, or a dash if there is none. Numbers that are too long for one line go on in the next.
fn point(ui: &mut Ui, name: &str, point: Option<&Snap>) {
    let (label, at) = match point {
        Some(point) => {
            let at = match point.vertices.as_deref() {
                Some([vertex]) => vertex.written.clone(),
                _ => format!(
                    "{} {} {}",
                    point.point_world.x, point.point_world.y, point.point_world.z
                ),
            };
            (point.label(), at)
        }
        None => ("\u{2013}".to_owned(), String::new()),
    };
    ui.add(Label::new(format!("{name} {label}")).truncate())
        .hint("what the last click (to), or the one before it (from), snapped to");
    ui.add(Label::new(value_text(at)).wrap()).hint(
        "a vertex as the file writes it; any other point in world coordinates, with all digits",
    );
}

fn text(entry: &Entry) -> String {
    let Entry { what, of, .. } = entry;
    let Measured { value, error } = entry.measured;
    let remark = if entry.outdated { "; " } else { "" };
    format!(
        "{what} {value} \u{b1} {error:.1e}, {of}{remark}{}",
        entry.remark()
    )
}
