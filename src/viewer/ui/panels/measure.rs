//! The points that clicks snap to, and the list of measures.

use super::{field::value_text, prelude::*};
use crate::{
    json,
    pick::snap::Snap,
    viewer::model::{Entry, MeasureAction, Measuring, What},
};

pub(super) fn show(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    let measuring = state.measuring();
    let mut is_on = measuring.is_on;
    let toggle = ui.checkbox(&mut is_on, "snap clicks");
    let hint = "snap each click to the nearest visible vertex within 8 pixels, else to an edge of the file's polygons, else to the surface";
    toggle.asks(hint, Action::Measure(MeasureAction::Toggle), commands);
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
            button.asks(now, Action::Measure(MeasureAction::Add(what)), commands);
        }
    });
    ui.horizontal(|ui| copying(ui, measuring, commands));
    // Below all buttons, which therefore do not move as points come and go.
    for (name, at) in [("from", 2), ("to", 1)] {
        let at = measuring.points.len().checked_sub(at);
        point(ui, name, at.and_then(|at| measuring.points.get(at)));
    }
    for (at, entry) in measuring.list.iter().enumerate() {
        ui.horizontal(|ui| {
            let remove = ui.small_button("\u{d7}");
            let remove = remove.named(&format!("remove measure {}", at + 1));
            let action = Action::Measure(MeasureAction::Remove(at));
            remove.asks("remove this line", action, commands);
            ui.add(Label::new(value_text(text(entry))).wrap())
                .hint("in world units");
        });
    }
    // Where the side scrolls, its scroll bar covers the last line.
    ui.add_space(10.0);
}

/// Buttons for the whole list.
fn copying(ui: &mut Ui, measuring: &Measuring, commands: &mut Vec<Command>) {
    let has_some = !measuring.list.is_empty();
    let mut button = |name: &str, hint: &str| {
        let hint = if has_some {
            hint
        } else {
            "nothing was measured yet"
        };
        let button = ui.add_enabled(has_some, Button::new(name));
        button.hint(hint).clicked()
    };
    if button("copy list", "all lines as text, with all digits") {
        commands.push(Command::Copy(measuring.text()));
    }
    if button("list as JSON", "all lines as JSON, with all digits") {
        commands.extend(json::text(&measuring.list).ok().map(Command::Copy));
    }
    if button("clear list", "remove all lines; undo brings them back") {
        commands.push(Action::Measure(MeasureAction::Clear).into());
    }
}

/// One of the last two points, or a dash if there is none. Numbers that are too long for one line go on in the next.
fn point(ui: &mut Ui, name: &str, point: Option<&Snap>) {
    let (label, at) = match point {
        Some(point) => {
            let DVec3 { x, y, z } = point.point_world;
            let at = match point.vertices.as_deref() {
                Some([vertex]) => vertex.written.clone(),
                _ => format!("{x} {y} {z}"),
            };
            (point.label(), at)
        }
        None => ("\u{2013}".to_owned(), String::new()),
    };
    ui.add(Label::new(format!("{name} {label}")).truncate())
        .hint("what the last click (to), or the one before it (from), snapped to");
    let hint =
        "a vertex as the file writes it; any other point in world coordinates, with all digits";
    ui.add(Label::new(value_text(at)).wrap()).hint(hint);
}

fn text(entry: &Entry) -> String {
    let Entry {
        what, of, value, ..
    } = entry;
    let (mark, remark) = (if entry.outdated { "; " } else { "" }, entry.remark());
    format!("{what} {value}, {of}{mark}{remark}")
}
