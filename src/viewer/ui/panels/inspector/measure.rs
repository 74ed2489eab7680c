//! Measures of the points that were clicked last, and the list of measures.

use super::{
    field::{short, value_text},
    overlay_toggle,
    prelude::*,
};
use crate::{
    json,
    viewer::model::{Entry, MeasureAction, MeasuredPoint, Measuring, Overlay, What},
};

pub(super) fn show(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    let measuring = state.measuring();
    ui.horizontal(|ui| {
        let mut is_on = measuring.is_on;
        let toggle = ui.checkbox(&mut is_on, "snap clicks");
        let hint = "snap each click to the nearest visible vertex within 8 pixels, else to an edge of the file's polygons, else to the surface";
        toggle.asks(hint, Action::Measure(MeasureAction::Toggle), commands);
        overlay_toggle::show(ui, state, Overlay::Distance, commands);
    });
    // It has one line, whatever it says, so that nothing below it moves.
    ui.add(Label::new(measuring.next()).truncate())
        .hint("what to do next");
    Grid::new("measures").num_columns(2).show(ui, |ui| {
        for what in What::ALL {
            measure(ui, measuring, what, commands);
        }
    });
    ui.horizontal(|ui| copying(ui, measuring, commands));
    // Below all buttons, which therefore do not move as measures and points come and go.
    for (at, entry) in measuring.list.iter().enumerate() {
        ui.horizontal(|ui| {
            let remove = ui.small_button("\u{d7}");
            let remove = remove.named(&format!("remove measure {}", at + 1));
            let action = Action::Measure(MeasureAction::Remove(at));
            remove.asks("remove this line", action, commands);
            ui.add(Label::new(value_text(text(entry))).wrap())
                .hint("in world units; angles in degrees");
        });
    }
    for (at, name) in ["first", "second", "third"].into_iter().enumerate() {
        point(ui, name, measuring.points.get(at));
    }
}

/// A measure of the last points: a button that adds it to the list, and its value.
fn measure(ui: &mut Ui, measuring: &Measuring, what: What, commands: &mut Vec<Command>) {
    let entry = measuring.entry(what);
    let button = Button::new(what.name()).min_size(vec2(82.0, 0.0));
    let button = ui.add_enabled(entry.is_some(), button);
    let now = match &entry {
        Some(entry) => format!("{}: add it to the list", text(entry)),
        None => measuring.lacks(what).to_owned(),
    };
    button.asks(&now, Action::Measure(MeasureAction::Add(what)), commands);
    let value = match &entry {
        Some(entry) => {
            let unit = if what == What::Angle { "\u{b0}" } else { "" };
            let of = match what {
                What::Length | What::FaceArea | What::ObjectArea => format!("  {}", entry.of),
                _ => String::new(),
            };
            format!("{}{unit}{of}", short(entry.value))
        }
        None => "\u{2013}".to_owned(),
    };
    ui.add(Label::new(value_text(value)).truncate()).hint(now);
    ui.end_row();
    if what == What::Distance {
        let hint = "how far the second of the two points lies from the first along x, y and z";
        ui.weak("along x, y, z").hint(hint);
        let along = entry.and_then(|entry| entry.along);
        let along = along.map(|by| by.to_array().map(short).join("  "));
        ui.label(value_text(along.as_deref().unwrap_or("\u{2013}")))
            .hint(hint);
        ui.end_row();
    }
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

/// One of the last points, or a dash if there is none. Numbers that are too long for one line go on in the next.
fn point(ui: &mut Ui, name: &str, point: Option<&MeasuredPoint>) {
    let (label, at, whole) = match point {
        Some(point) => {
            let DVec3 { x, y, z } = point.point_world;
            let snap = point.snap.as_ref();
            let at = match snap.and_then(|snap| snap.vertices.as_deref()) {
                Some([vertex]) => vertex.written.clone(),
                _ => [x, y, z].map(short).join(" "),
            };
            let whole =
                format!("{x} {y} {z}: in world coordinates; a vertex shows as its file writes it");
            (point.label(), at, whole)
        }
        None => ("\u{2013}".to_owned(), String::new(), String::new()),
    };
    ui.add(Label::new(format!("{name}: {label}")).truncate())
        .hint("the points that were clicked last, the oldest first");
    if !at.is_empty() {
        ui.add(Label::new(value_text(at)).wrap()).hint(whole);
    }
}

fn text(entry: &Entry) -> String {
    let Entry {
        what, of, value, ..
    } = entry;
    let (mark, remark) = (if entry.outdated { "; " } else { "" }, entry.remark());
    format!("{what} {value}, {of}{mark}{remark}")
}
