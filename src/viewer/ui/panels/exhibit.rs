//! The panel of a scene of the failure gallery: what breaks on the scene, which method picks, and what it gets wrong.

use super::{
    field::{short, value_text},
    hints::Hint,
    plot,
};
use crate::{
    look,
    scene::gallery::GALLERY,
    study::{
        Row,
        breaks::{as_good, breaks_on, swaps},
        chart::family,
        step::MethodInfo,
        swap::{Found, Swap},
    },
    viewer::{
        jobs::Chart,
        model::{Action, Compared, Fault, Showing, State},
        ui::{command::Command, theme::color32},
    },
};
use egui::{Button, Color32, ComboBox, Grid, RichText, Ui};
use glam::DVec3;

/// The colour of methods that are not the default, and of what is wrong: [`look::WRONG`].
pub(super) const WRONG: Color32 = color32(look::WRONG);
/// The colour of what is right.
pub(super) const RIGHT: Color32 = Color32::from_rgb(0x56, 0xb4, 0xe9);

/// The gallery's scenes, for the toolbar.
pub(super) fn menu(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    let now = state.showing().map(|showing| showing.exhibit.name);
    for exhibit in &GALLERY {
        let label = ui.selectable_label(now == Some(exhibit.name), exhibit.title());
        if label.hint(exhibit.about()).clicked() {
            commands.push(Command::Open(vec![exhibit.path()]));
            ui.close();
        }
    }
    ui.separator();
    let leave = ui.add_enabled(now.is_some(), Button::new("leave the gallery"));
    let hint = "open again what was open before";
    if leave.hint(hint).clicked() {
        commands.push(Command::LeaveGallery);
        ui.close();
    }
}

/// Stands in place of the list of objects.
pub(super) fn show(
    ui: &mut Ui,
    state: &State,
    showing: &Showing,
    drawn: Option<&Chart>,
    commands: &mut Vec<Command>,
) {
    let place = GALLERY.iter().position(|known| known == showing.exhibit);
    let place = place.map_or(0, |place| place + 1);
    ui.weak(format!("{place} of {}", GALLERY.len()))
        .hint("E: the next scene of the gallery; Shift+E: the one before");
    ui.label(showing.exhibit.about());
    ui.weak(match (showing.method, state.has_outside()) {
        (Some(_), _) => "Esc: pick by Sightline's own method again.",
        (None, true) => "Esc, with nothing selected, leaves the gallery.",
        (None, false) => "Menu Gallery, leave the gallery: opens the demo.",
    });
    ui.separator();
    methods(ui, showing, commands);
    ui.separator();
    outcome(ui, state, showing);
    ui.separator();
    if let Some(subject) = showing.subject() {
        match drawn.and_then(|chart| chart.rows.as_ref()) {
            Some(rows) => {
                ui.label("The study, on ever harder cases of what breaks here:");
                let now = showing.method.map(|method| method.info());
                let now = now.map(|info| (info.name, info.precision));
                plot::show(ui, &family(rows, subject.value, now));
                ui.weak("In pixels of this view. Dashed: f32. Solid: f64 or exact. Black: Sightline's. Thick: the method that picks now.");
                ui.label(others(rows));
            }
            None => {
                ui.horizontal(|ui| {
                    ui.spinner();
                    ui.label(format!("studying \u{201c}{}\u{201d}", subject.family));
                });
            }
        }
    }
}

/// Which other methods are correct here.
fn others(rows: &[Row]) -> String {
    let names: Vec<String> = as_good(rows)
        .map(|row| format!("{} {}", row.info.name, row.info.precision))
        .collect();
    if names.is_empty() {
        return "No other method of this step is correct here.".to_owned();
    }
    format!("Also correct here: {}.", names.join("; "))
}

/// A method's name with its precision.
fn name(info: &MethodInfo) -> String {
    format!("{}, {}", info.name, info.precision)
}

fn methods(ui: &mut Ui, showing: &Showing, commands: &mut Vec<Command>) {
    ui.strong("Pick by")
        .hint("M: the next method; Shift+M: the one before");
    let mut asked = None;
    if ui
        .radio(showing.method.is_none(), "Sightline's own, the default")
        .hint("Esc goes back to it")
        .clicked()
    {
        asked = Some(None);
    }
    let all = swaps(showing.exhibit.name);
    let (broken, others) = all.split_at(breaks_on(showing.exhibit.name).count());
    for swap in broken {
        let info = swap.info();
        let text = RichText::new(step_and_name(swap)).color(WRONG);
        let radio = ui.radio(showing.method == Some(*swap), text);
        let hint = format!("breaks here\n{}", info.source);
        if radio.hint(hint).clicked() {
            asked = Some(Some(*swap));
        }
    }
    let other = showing.method.filter(|method| others.contains(method));
    let shown = other.map_or("another method of the step".to_owned(), |swap| {
        name(&swap.info())
    });
    let list = ComboBox::from_id_salt("other methods")
        .selected_text(shown)
        .width(ui.available_width() - 12.0)
        .show_ui(ui, |ui| {
            for swap in others {
                let info = swap.info();
                let label = ui.selectable_label(showing.method == Some(*swap), step_and_name(swap));
                if label.hint(info.source).clicked() {
                    asked = Some(Some(*swap));
                }
            }
        });
    let hint = "the study's other methods for the step that breaks here";
    list.response.hint(hint);
    if let Some(method) = asked {
        commands.push(Command::Act(Action::PickBy(method)));
    }
}

fn outcome(ui: &mut Ui, state: &State, showing: &Showing) {
    if showing.method.is_none() {
        ui.weak("Choose a method that breaks, then click where the picture is marked.");
        return;
    }
    let Some(compared) = &showing.compared else {
        ui.weak("Click the picture to compare this method's pick with Sightline's.");
        return;
    };
    let (text, colour) = verdict(state, compared);
    ui.label(RichText::new(text).strong().color(colour));
    let header = ui.collapsing("in numbers", |ui| numbers(ui, state, compared));
    let hint = "object, triangle, point and normal by both methods";
    header.header_response.hint(hint);
}

/// Writes what a row says about a method's hit.
type Column = fn(&State, &Found) -> String;

fn numbers(ui: &mut Ui, state: &State, compared: &Compared) {
    Grid::new("compared")
        .num_columns(3)
        .striped(true)
        .show(ui, |ui| {
            ui.label("");
            ui.colored_label(WRONG, "this method")
                .hint("what the chosen method finds at the clicked pixel");
            ui.colored_label(RIGHT, "Sightline")
                .hint("what is there: Sightline's own pick");
            ui.end_row();
            let rows: [(&str, &str, Column); 4] = [
                ("object", "what was hit", object),
                ("triangle", "which of its triangles", |_, found| {
                    let at = found.hit.hit.on_triangle;
                    at.map_or("\u{2013}".to_owned(), |at| at.triangle.to_string())
                }),
                ("point", "where, in the world", |_, found| {
                    vector(found.point_world)
                }),
                (
                    "normal",
                    "the surface's outward direction there",
                    |_, found| vector(found.normal_world),
                ),
            ];
            for (what, hint, column) in rows {
                ui.weak(what).hint(hint);
                for found in [&compared.theirs, &compared.ours] {
                    let text = found
                        .as_ref()
                        .map_or("nothing".to_owned(), |found| column(state, found));
                    ui.label(value_text(text)).hint(hint);
                }
                ui.end_row();
            }
        });
}

/// The result of the comparison, in words.
fn verdict(state: &State, compared: &Compared) -> (String, Color32) {
    let name = |found: &Option<Found>| {
        found
            .as_ref()
            .map_or("nothing".to_owned(), |found| object(state, found))
    };
    let (theirs, ours) = (name(&compared.theirs), name(&compared.ours));
    match compared.fault() {
        None => ("Nothing is there, and nothing is picked.".to_owned(), RIGHT),
        Some(Fault::Missed) => (format!("Wrong: it misses {ours}, which is there."), WRONG),
        Some(Fault::Phantom) => (format!("Wrong: it picks {theirs} where nothing is."), WRONG),
        Some(Fault::Other) if theirs == ours => {
            ("Wrong: another triangle is there.".to_owned(), WRONG)
        }
        Some(Fault::Other) => (
            format!("Wrong: it picks {theirs}, but {ours} is there."),
            WRONG,
        ),
        Some(Fault::Off(by)) if !by.shows() => ("Correct here.".to_owned(), RIGHT),
        Some(Fault::Off(by)) => {
            let place = format!("{} px and {} units", short(by.px), short(by.world));
            let normal = format!("{}\u{b0}", short(by.normal_deg));
            let text = if by.normal_deg < 1.0 {
                format!("Right object, wrong place: {place} off.")
            } else if by.world == 0.0 {
                format!("Right object, wrong normal: {normal} off.")
            } else {
                format!("Right object, wrong place: {place} off, its normal {normal}.")
            };
            (text, WRONG)
        }
    }
}

fn object(state: &State, found: &Found) -> String {
    state.scene().objects()[found.hit.object].name.clone()
}

fn vector(v: DVec3) -> String {
    v.to_array().map(short).join("\n")
}

/// A method by its step, name and precision.
pub(super) fn step_and_name(swap: &Swap) -> String {
    let info = swap.info();
    format!("{}: {}", info.step.name, name(&info))
}
