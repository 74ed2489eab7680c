//! The panel of a scene of the failure gallery: what breaks on the scene, which method picks, and what it gets wrong.

use super::{
    field::{short, value_text},
    plot::Plot,
    prelude::*,
    shown::Shown,
};
use crate::{
    look,
    scene::gallery::GALLERY,
    study::{
        Row,
        breaks::{as_good, breaks_on, swaps},
        charts::family,
        step::MethodInfo,
        swap::{Found, Swap},
    },
    viewer::{
        jobs::Chart,
        model::{Compared, Fault, Showing},
    },
};
use egui::ComboBox;

/// The colour of methods that are not the default, and of what is wrong: [`look::WRONG`].
pub(super) const WRONG: Color32 = color32(look::WRONG);
/// The colour of what is right.
pub(super) const RIGHT: Color32 = Color32::from_rgb(0x56, 0xb4, 0xe9);

/// The size of the chart in its own pixels.
const CHART_PX: (u32, u32) = (1060, 820);

/// The gallery's scenes, for the menu.
pub(super) fn menu(ui: &mut Ui, shown: &Shown, commands: &mut Vec<Command>) {
    let now = shown.state.showing().map(|showing| showing.exhibit.name);
    for exhibit in &GALLERY {
        let label = ui.selectable_label(now == Some(exhibit.name), exhibit.title());
        if label.hint(exhibit.about()).clicked() {
            commands.push(Command::Open(vec![exhibit.path()]));
        }
    }
    ui.separator();
    let leave = ui.add_enabled(now.is_some(), Button::new("leave the gallery"));
    let hint = "open again what was open before";
    if leave.hint(hint).clicked() {
        commands.push(Command::LeaveGallery);
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
    ui.heading(showing.exhibit.title())
        .hint("a scene of the gallery");
    let place = GALLERY.iter().position(|known| known == showing.exhibit);
    let place = place.map_or(0, |place| place + 1);
    ui.weak(format!("{place} of {}", GALLERY.len()))
        .hint("E: the next scene of the gallery; Shift+E: the one before");
    ui.label(showing.exhibit.about());
    ui.weak(match (showing.method, state.outside().is_some()) {
        (Some(_), _) => "Esc: pick by Sightline's own method again.",
        (None, true) => "Esc, with nothing selected, leaves the gallery.",
        (None, false) => "Menu Learn, leave the gallery: opens the demo.",
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
                // A backend of egui's never refuses.
                let _ = family(Plot::new(ui, CHART_PX), rows, subject.value, now);
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
    let names = as_good(rows).map(|row| format!("{} {}", row.info.name, row.info.precision));
    let names: Vec<String> = names.collect();
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
    let own = ui.radio(showing.method.is_none(), "Sightline's own, the default");
    own.asks("Esc goes back to it", Action::PickBy(None), commands);
    let all = swaps(showing.exhibit.name);
    let (broken, others) = all.split_at(breaks_on(showing.exhibit.name).count());
    for swap in broken {
        let text = RichText::new(step_and_name(swap)).color(WRONG);
        let radio = ui.radio(showing.method == Some(*swap), text);
        let hint = format!("breaks here\n{}", swap.info().source);
        radio.asks(hint, Action::PickBy(Some(*swap)), commands);
    }
    let other = showing.method.filter(|method| others.contains(method));
    let shown = other.map(|swap| name(&swap.info()));
    let shown = shown.unwrap_or_else(|| "another method of the step".to_owned());
    let list = ComboBox::from_id_salt("other methods").selected_text(shown);
    let list = list.width(ui.available_width() - 12.0);
    let list = list.show_ui(ui, |ui| {
        for swap in others {
            let label = ui.selectable_label(showing.method == Some(*swap), step_and_name(swap));
            label.asks(swap.info().source, Action::PickBy(Some(*swap)), commands);
        }
    });
    let hint = "the study's other methods for the step that breaks here";
    list.response.hint(hint);
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

fn numbers(ui: &mut Ui, state: &State, compared: &Compared) {
    let grid = Grid::new("compared").num_columns(3).striped(true);
    grid.show(ui, |ui| {
        ui.label("");
        let hint = "what the chosen method finds at the clicked pixel";
        ui.colored_label(WRONG, "this method").hint(hint);
        let hint = "what is there: Sightline's own pick";
        ui.colored_label(RIGHT, "Sightline").hint(hint);
        ui.end_row();
        let mut row = |what: &str, hint: &str, column: &dyn Fn(&Found) -> String| {
            ui.weak(what).hint(hint);
            for found in [&compared.theirs, &compared.ours] {
                ui.label(value_text(or_nothing(found.as_ref(), column)))
                    .hint(hint);
            }
            ui.end_row();
        };
        row("object", "what was hit", &|found| object(state, found));
        row("triangle", "which of its triangles", &|found| {
            let at = found.hit.hit.on_triangle;
            at.map_or("\u{2013}".to_owned(), |at| at.triangle.to_string())
        });
        let point = |found: &Found| vector(found.point_world);
        row("point", "where, in the world", &point);
        let normal = |found: &Found| vector(found.normal_world);
        row("normal", "the surface's outward direction there", &normal);
    });
}

fn or_nothing(found: Option<&Found>, text: impl Fn(&Found) -> String) -> String {
    found.map_or("nothing".to_owned(), text)
}

/// The result of the comparison, in words.
fn verdict(state: &State, compared: &Compared) -> (String, Color32) {
    let both = [&compared.theirs, &compared.ours];
    let [theirs, ours] = both.map(|found| or_nothing(found.as_ref(), |found| object(state, found)));
    let wrong = match compared.fault() {
        None => return ("Nothing is there, and nothing is picked.".to_owned(), RIGHT),
        Some(Fault::Off(by)) if !by.shows() => return ("Correct here.".to_owned(), RIGHT),
        Some(Fault::Missed) => format!("Wrong: it misses {ours}, which is there."),
        Some(Fault::Phantom) => format!("Wrong: it picks {theirs} where nothing is."),
        Some(Fault::Other) if theirs == ours => "Wrong: another triangle is there.".to_owned(),
        Some(Fault::Other) => format!("Wrong: it picks {theirs}, but {ours} is there."),
        Some(Fault::Off(by)) => {
            let place = format!("{} px and {} units", short(by.px), short(by.world));
            let normal = format!("{}\u{b0}", short(by.normal_deg));
            if by.normal_deg < 1.0 {
                format!("Right object, wrong place: {place} off.")
            } else if by.world == 0.0 {
                format!("Right object, wrong normal: {normal} off.")
            } else {
                format!("Right object, wrong place: {place} off, its normal {normal}.")
            }
        }
    };
    (wrong, WRONG)
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
