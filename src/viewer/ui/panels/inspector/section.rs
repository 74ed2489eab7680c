//! The section: where it is laid, and its numbers.

use super::{
    field::{AXES, Field, WIDTH},
    prelude::*,
    slide::Slide,
};
use crate::geometry::Section;
use egui::Slider;

pub(super) fn show(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    ui.horizontal_wrapped(|ui| where_to(ui, state, commands));
    if let Some(section) = &state.view().section {
        numbers(ui, state, section, commands);
    }
}

fn where_to(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    let section = state.view().section;
    let mut is_on = section.is_some();
    let on = ui.checkbox(&mut is_on, "cut");
    let hint = "cut the world by a plane: what lies behind it is neither drawn nor picked, and you look into solids (Z)";
    on.asks(hint, Action::ToggleSection, commands);
    // A section is computed only when its button is clicked: along a mesh's face, that takes all of the mesh's
    // triangles.
    let mut button =
        |word: &str, name: &str, hint: &str, can: bool, to: &dyn Fn() -> Option<Action>| {
            let button = ui.add_enabled(can, Button::new(word).small()).named(name);
            if button.hint(hint).clicked()
                && let Some(action) = to()
            {
                commands.extend([action, Action::Release].map(Command::Act));
            }
        };
    let lay = |section: Option<Section>| section.map(|section| Action::Section(Some(section)));
    let has_bounds = !state.scene().visible_bounds().is_empty();
    for (axis, word) in DVec3::AXES.into_iter().zip(AXES) {
        let hint = format!("across the world's {word} axis, through the middle of what is visible");
        let name = format!("section across {word}");
        let to = || lay(state.section_across(axis));
        button(word, &name, &hint, has_bounds, &to);
    }
    let hint = "along the picked face: the face and what lies behind it stay";
    let to = || lay(state.section_along_pick());
    let has_face = state.picked_face().is_some();
    button("face", "section along the face", hint, has_face, &to);
    if let Some(section) = section {
        let hint = "keep the other side";
        let to = || lay(Some(section.flipped()));
        button("flip", "flip the section", hint, true, &to);
    }
}

const NORMAL: &str =
    "the section's normal: it points to what is kept, the points p with n . p + c at least 0";
const OFFSET: &str = "the section's offset: points p with n . p + c at least 0 are kept; an arrow in the picture drags it";

fn numbers(ui: &mut Ui, state: &State, section: &Section, commands: &mut Vec<Command>) {
    let (normal, offset) = (section.normal(), section.offset());
    let bounds = state.scene().visible_bounds();
    let along = bounds.corners().map(|corner| -normal.dot(corner));
    let [least, most] = [f64::min, f64::max].map(|end| along.into_iter().fold(along[0], end));
    let check = |normal: DVec3, offset: f64| Section::new(normal, offset).map(|_| ());
    let (mut next, mut slide) = (None, Slide::default());
    let of = state.scene_revision();
    Grid::new("section").num_columns(4).show(ui, |ui| {
        ui.label("n").hint(NORMAL);
        for (i, axis) in AXES.into_iter().enumerate() {
            let with = |number| {
                let mut normal = normal;
                normal[i] = number;
                normal
            };
            let name = format!("section n {axis}");
            let field = Field::new(&name, NORMAL, of, WIDTH, normal[i]);
            let step = 0.01 * normal.abs().max_element();
            let check = |number| check(with(number), offset);
            if let Some(number) = field.show(ui, step, &mut slide, check) {
                next = Some((with(number), offset));
            }
        }
        ui.end_row();
        ui.label("c").hint(OFFSET);
        let field = Field::new("section c", OFFSET, of, WIDTH, offset);
        let step = 0.01 * (most - least);
        if let Some(number) = field.show(ui, step, &mut slide, |number| check(normal, number)) {
            next = Some((normal, number));
        }
        if least < most {
            let mut slid = offset;
            let slider = ui.add(Slider::new(&mut slid, least..=most).show_value(false));
            let slider = slider.named("section c, slid").hint(OFFSET);
            slide.note(&slider);
            if slider.changed() && check(normal, slid).is_ok() {
                next = Some((normal, slid));
            }
        }
    });
    let next = next.and_then(|(normal, offset)| Section::new(normal, offset).ok());
    slide.push(next.map(|next| Action::Section(Some(next))), commands);
}
