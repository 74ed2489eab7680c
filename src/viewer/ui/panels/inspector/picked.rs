//! What is picked, in what one wants to know first; where nothing is, the whole scene. Its height never changes.

use super::{
    field::{count_of, short, value_text},
    prelude::*,
};
use crate::{
    camera::UpAxis,
    colour::Srgb,
    geometry::Aabb,
    pick::Pick,
    viewer::{
        model::{PickView, Selection},
        ui::menus::item_of,
    },
};
use egui::UiBuilder;
use std::{collections::BTreeSet, sync::Arc};

/// Width in points of the names of rows.
const NAMES: f32 = 76.0;
/// What stands where there is nothing to say.
const NOTHING: &str = "\u{2013}";

/// What several selected objects are together. It is found once for each selection: there may be very many.
#[derive(Default)]
pub(in crate::viewer) struct Sums {
    /// Of which objects of which scene.
    of: Option<([u64; 2], usize, Arc<BTreeSet<usize>>)>,
    bounds: Aabb,
    triangles: usize,
    /// The name, where there is one, and the colour of all of them, if they have the same.
    material: Option<(Option<String>, Srgb)>,
}

impl Sums {
    fn update(&mut self, state: &State, selection: &Selection) {
        let scene = [state.scene_revision(), state.visibility_revision()];
        let of = (scene, selection.object, Arc::clone(&selection.others));
        let is_same = |(a, b, others): &([u64; 2], usize, Arc<BTreeSet<usize>>)| {
            (*a, *b) == (of.0, of.1) && Arc::ptr_eq(others, &of.2)
        };
        if !self.of.as_ref().is_some_and(is_same) {
            self.bounds = state.bounds_of_selection();
            let shapes = state
                .all_selected()
                .map(|index| state.scene().objects()[index].shape.triangles());
            self.triangles = shapes.flatten().map(|triangles| triangles.len()).sum();
            let mut all = state
                .all_selected()
                .map(|index| state.scene().objects()[index].one_material());
            let first = all.next().flatten();
            let shared = first.filter(|first| all.all(|other| other == Some(*first)));
            self.material = shared.map(|(name, colour)| (name.map(str::to_owned), colour));
            self.of = Some(of);
        }
    }
}

pub(super) fn show(ui: &mut Ui, state: &State, sums: &mut Sums, commands: &mut Vec<Command>) {
    let selection = state.selection();
    title(ui, state, selection);
    let several = selection.filter(|selection| !selection.others.is_empty());
    if let Some(selection) = several {
        sums.update(state, selection);
    }
    let own = || {
        let (name, colour) = state.material()?;
        Some((name.map(str::to_owned), colour))
    };
    let made_of = match several {
        Some(_) => sums.material.clone(),
        None => own(),
    };
    material(ui, made_of);
    let bounds = match several {
        Some(_) => sums.bounds,
        None => state.bounds_of_selection(),
    };
    let hint = "width, height and depth in world units, of all that is selected, or else of the scene: from its least to its greatest coordinate along each axis; height is along the up axis";
    row(ui, "W x H x D", &size(&bounds, state.up_axis()), hint);
    let hint = "what is selected, or else what the scene holds; spheres, cubes and squares have no triangles";
    row(ui, "shape", &shape(state, selection, sums), hint);
    // Of several, only the first can be picked, and all rows are about all of them.
    let hit = state.picked().filter(|_| several.is_none());
    let position = hit.map(|hit| hit.point_world.to_array().map(short).join(" "));
    let hint =
        "the picked point: x, y and z in the scene's own coordinates; Details has all digits";
    row(ui, "position", position.as_deref().unwrap_or(NOTHING), hint);
    let edge = hit.map(edge);
    let hint = "how far the clicked position is from the outline of the surface that was hit, in pixels of the picture";
    row(ui, "nearest edge", edge.as_deref().unwrap_or(NOTHING), hint);
    remark(ui, state);
    copies(ui, state, commands);
}

/// The name of what is picked.
fn title(ui: &mut Ui, state: &State, selection: Option<&Selection>) {
    let (name, hint, count) = match selection {
        None => (
            state.name().to_owned(),
            "nothing is selected: this is the whole scene",
            "scene".to_owned(),
        ),
        Some(Selection { object, others, .. }) => {
            let name = &state.scene().objects()[*object].name;
            let (hint, number) = ("what is selected, as its file calls it", object + 1);
            match others.len() {
                0 => (name.clone(), hint, format!("object {number}")),
                more => {
                    let first = format!("object {number} first");
                    (format!("{} objects", more + 1), hint, first)
                }
            }
        }
    };
    ui.horizontal(|ui| {
        // The number is laid out first, and the name is cut to fit.
        ui.with_layout(Layout::right_to_left(Align::Max), |ui| {
            ui.weak(count).hint("its number in the list, and in what is copied; of several, what was selected first");
            ui.with_layout(Layout::left_to_right(Align::Max), |ui| {
                let text = RichText::new(&name).size(18.0).strong();
                let label = Label::new(text).truncate().show_tooltip_when_elided(false);
                ui.add(label).hint(format!("{name}: {hint}"));
            });
        });
    });
}

/// What is selected, in a few words, or else what the scene holds.
fn shape(state: &State, selection: Option<&Selection>, sums: &Sums) -> String {
    let scene = state.scene();
    let Some(Selection { object, others, .. }) = selection else {
        let objects = count_of(scene.objects().len(), "object");
        return match scene.triangle_count() {
            0 => objects,
            triangles => format!("{objects}, {triangles} triangles"),
        };
    };
    if !others.is_empty() {
        return match sums.triangles {
            0 => "shapes".to_owned(),
            triangles => format!("together {triangles} triangles"),
        };
    }
    let shape = &scene.objects()[*object].shape;
    match shape.triangles() {
        Some(triangles) => format!("{}, {} triangles", shape.kind(), triangles.len()),
        None => shape.kind().to_owned(),
    }
}

/// The name and the colour of what the picked surface, or all that is selected, is made of.
fn material(ui: &mut Ui, of: Option<(Option<String>, Srgb)>) {
    let hint = "what the picked surface, or all that is selected, is made of, as its file calls it, and its colour";
    in_row(ui, "material", hint, |ui| {
        let Some((name, colour)) = of else {
            ui.label(value_text(NOTHING)).hint(hint);
            return;
        };
        swatch(ui, colour);
        let colour = colour.to_string();
        let text = name.unwrap_or_else(|| colour.clone());
        ui.add(Label::new(value_text(text)).truncate())
            .hint(format!("{hint}: {colour}"));
    });
}

/// A patch of a colour.
pub(in crate::viewer::ui::panels) fn swatch(ui: &mut Ui, colour: Srgb) {
    let (rect, _) = ui.allocate_exact_size(vec2(10.0, 10.0), Sense::hover());
    let edge = ui.visuals().widgets.noninteractive.bg_stroke;
    let fill = color32(colour);
    ui.painter()
        .rect(rect, 2.0, fill, edge, egui::StrokeKind::Inside);
}

/// Width, height and depth of a box.
fn size(bounds: &Aabb, up_axis: UpAxis) -> String {
    if bounds.is_empty() {
        return NOTHING.to_owned();
    }
    let DVec3 { x, y, z } = bounds.max - bounds.min;
    let all = match up_axis {
        UpAxis::Y => [x, y, z],
        UpAxis::Z => [x, z, y],
    };
    all.map(short).join(" x ")
}

fn edge(hit: &Pick) -> String {
    let away = hit.edge_px.map(|px| format!("{px:.3} px away"));
    away.unwrap_or_else(|| "none in view".into())
}

/// A row of a fixed height: its name, its value and what it means.
fn row(ui: &mut Ui, name: &str, value: &str, hint: &str) {
    in_row(ui, name, hint, |ui| {
        ui.add(Label::new(value_text(value)).truncate()).hint(hint);
    });
}

fn in_row(ui: &mut Ui, name: &str, hint: &str, value: impl FnOnce(&mut Ui)) {
    ui.horizontal(|ui| {
        ui.spacing_mut().interact_size.y = 15.0;
        let (rect, _) = ui.allocate_exact_size(vec2(NAMES, 15.0), Sense::hover());
        let place = UiBuilder::new()
            .max_rect(rect)
            .layout(Layout::left_to_right(Align::Center));
        ui.new_child(place).weak(name).hint(hint);
        value(ui);
    });
}

/// One line, whatever it says; a tooltip has all of it.
fn remark(ui: &mut Ui, state: &State) {
    let (short, whole) = said(state);
    let is_hidden = state.pick_ray().is_some_and(|ray| ray.at > Some(0));
    let is_elsewhere = matches!(state.pick_view(), Some(view) if view != PickView::Own);
    let is_warning = is_hidden || is_elsewhere;
    let mut text = RichText::new(short);
    if is_warning {
        text = text.color(ui.visuals().warn_fg_color);
    } else {
        text = text.weak();
    }
    let line = Label::new(text).truncate().show_tooltip_when_elided(false);
    ui.add(line).hint(whole);
}

/// What there is to say about the pick, in a line and in full.
fn said(state: &State) -> (String, String) {
    let own = |short: &str, whole: &str| (short.to_owned(), whole.to_owned());
    if state.method().is_some() {
        return own(
            "Another method picks now.",
            "what it says is beside the picture and is not copied; Esc: pick by Sightline's own method again",
        );
    }
    let Some(selection) = state.selection() else {
        if state.pick_ray().is_some() {
            return own(
                "Nothing is there.",
                "the clicked pixel shows the background: its ray hits no surface between near and far",
            );
        }
        return own(
            "Click a surface.",
            "a ray from the eye through the clicked pixel finds what that pixel shows",
        );
    };
    if !selection.others.is_empty() {
        return own(
            "Several are selected.",
            "the rows above are about all of them; Details has the point that was picked on the first",
        );
    }
    let Some(hit) = state.picked() else {
        return if state.followed().is_some_and(|followed| followed.is_picked) {
            own(
                "Its point is out of the camera's view.",
                "it was clicked in one of the four views, where the camera does not see it: no pixel shows it",
            )
        } else {
            own(
                "No point of it is picked: click its surface.",
                "it was chosen in the list, and no ray has hit it",
            )
        };
    };
    match state.pick_view() {
        Some(PickView::Resized) => {
            return own(
                "Picked at an earlier size.",
                "the window's size has changed since; copies repeat the pick in its own view",
            );
        }
        Some(PickView::Earlier) if state.pick_is_hidden() => {
            return own(
                "Picked in an earlier view, and hidden here.",
                "the camera or the lens has changed since, and another surface is in front of the point; copies repeat the pick in its own view",
            );
        }
        Some(PickView::Earlier) => {
            return own(
                "Picked in an earlier view.",
                "the camera or the lens has changed since; copies repeat the pick in its own view",
            );
        }
        Some(PickView::LeftOut) => {
            return own(
                "Picked earlier; this view does not show it.",
                "near, far, culling or the section removes the point; copies repeat the pick in its own view",
            );
        }
        Some(PickView::Own) | None => {}
    }
    let in_one_place = state.hits().and_then(|hits| hits.in_one_place.as_ref());
    if let Some(all) = in_one_place.filter(|all| hit.may_be_of(all)) {
        let whole = format!(
            "{all} They are closer together than drawing can tell apart. The picture may show any of them; the pick's order is exact."
        );
        return (all.to_string(), whole);
    }
    if let Some(ray) = state.pick_ray()
        && let Some(before) = ray.at.and_then(|at| at.checked_sub(1))
    {
        let (number, count) = (before + 2, ray.picks.len());
        let (before, first) = (&ray.picks[before].object, &ray.picks[0].object);
        return own(
            &format!("Surface {number} of {count}, behind {before}."),
            &format!(
                "the same pixel was clicked again, or N pressed, which leads on to the next; Shift+N leads back. The pixel shows {first}"
            ),
        );
    }
    let decided = if hit.exact {
        "exact arithmetic decided, since 64-bit numbers left it open"
    } else {
        "64-bit numbers, with a bound on their rounding error, were enough"
    };
    let short = "Certain: as exact arithmetic has it.";
    let alone = "no other surface is closer to it than drawing can tell apart";
    own(short, &format!("{decided}; and {alone}"))
}

fn copies(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    let has_pick = state.pick_ray().is_some();
    ui.horizontal(|ui| {
        for (command, is_of_use) in [
            (Command::CopyPick, has_pick),
            (Command::CopyCommandLine, true),
        ] {
            if let Some(item) = item_of(&command) {
                let hint = format!("{} ({})", item.hint, item.all_keys());
                let copy = ui.add_enabled(is_of_use, Button::new(item.name));
                copy.asks(hint, command, commands);
            }
        }
    });
}
