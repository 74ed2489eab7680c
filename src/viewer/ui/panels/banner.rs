//! The warning that a method other than Sightline's picks: a bar over the picture, a frame around it, and marks of what
//! both methods found at the last click.

use super::{
    exhibit::{RIGHT, WRONG, step_and_name},
    prelude::*,
};
use crate::{study::swap::Found, viewer::model::Compared};
use egui::{Painter, Shape, StrokeKind, UiBuilder};

/// The bar's height in points where its text does not wrap.
const HEIGHT: f32 = 50.0;
/// The bar's colour. Marks in the picture hardly use it.
const BAR: Color32 = Color32::from_rgb(0xf0, 0xe4, 0x42);

/// Shown over the scene's rectangle; nothing while Sightline's own method picks. Returns the bar's height in points.
pub(super) fn show(
    ui: &mut Ui,
    rect: Rect,
    place: SceneRect,
    state: &State,
    commands: &mut Vec<Command>,
) -> f32 {
    let Some(method) = state.method() else {
        return 0.0;
    };
    let painter = ui.painter().with_clip_rect(rect);
    if let Some(showing) = state.showing()
        && let Some(compared) = &showing.compared
    {
        marks(&painter, place, state, compared);
    }
    painter.rect_stroke(rect, 0.0, Stroke::new(4.0, BAR), StrokeKind::Inside);
    let mut bar = Rect::from_min_size(rect.min, vec2(rect.width(), HEIGHT));
    // It lies behind its text, whose height is known later.
    let back = painter.add(Shape::Noop);
    let inside = UiBuilder::new().max_rect(bar.shrink2(vec2(10.0, 4.0)));
    let inside = inside.layout(Layout::right_to_left(Align::Center));
    let text = ui.scope_builder(inside, |ui| {
        let back = RichText::new("back (Esc)").size(15.0).strong();
        let hint = "pick by Sightline's own method again, the default";
        ui.button(back).asks(hint, Action::PickBy(None), commands);
        ui.with_layout(Layout::top_down(Align::Min), |ui| {
            let text = |text: String, size| RichText::new(text).size(size).color(Color32::BLACK);
            let warning = "Not the default: another method picks".to_owned();
            let hint = "clicks are answered by the method below, not by Sightline's own";
            ui.label(text(warning, 17.0).strong()).hint(hint);
            let name = Label::new(text(step_and_name(&method), 14.0)).truncate();
            ui.add(name).hint(method.info().source);
        });
    });
    bar.max.y = bar.bottom().max(text.response.rect.bottom() + 4.0);
    painter.set(back, Shape::rect_filled(bar, 0.0, BAR));
    bar.height()
}

/// The click, and the point and normal as the method and as Sightline find them.
fn marks(painter: &Painter, place: SceneRect, state: &State, compared: &Compared) {
    /// Length of a normal in points.
    const NORMAL: f32 = 70.0;
    let view = state.view();
    let arrow = |found: &Found, colour: Color32, wide: f32| {
        let Some(from) = view.project(found.point_world) else {
            return;
        };
        let from = place.to_position(from.px);
        painter.circle_filled(from, 3.0 * wide, colour);
        // NORMAL points long where it is parallel to the picture, shorter where it tilts.
        let along = (view.camera.rotation() * found.normal_world).as_vec3();
        let by = vec2(along.x, -along.y) * NORMAL;
        painter.arrow(from, by, Stroke::new(2.0 * wide, colour));
    };
    if let Some(ours) = &compared.ours {
        arrow(ours, RIGHT, 2.0);
    }
    if let Some(theirs) = &compared.theirs {
        arrow(theirs, WRONG, 1.2);
    }
    // The ring and its labels are about the view of the click.
    if compared.view != *view {
        return;
    }
    let at = place.to_position(compared.px);
    let wrong = compared.fault().is_some_and(|fault| fault.is_wrong());
    let colour = if wrong { WRONG } else { RIGHT };
    // With a dark rim it shows on any picture.
    for stroke in [Stroke::new(6.0, Color32::BLACK), Stroke::new(2.5, colour)] {
        painter.circle_stroke(at, 11.0, stroke);
        for by in [vec2(17.0, 0.0), vec2(0.0, 17.0)] {
            painter.line_segment([at - by, at - 0.4 * by], stroke);
            painter.line_segment([at + 0.4 * by, at + by], stroke);
        }
    }
    let [picked, drawn] = labels(state, compared);
    let lines = [
        (format!("picked: {picked}"), colour),
        (format!("drawn: {drawn}"), RIGHT),
    ];
    let mut corner = at + vec2(20.0, 14.0);
    for (text, colour) in lines {
        let colour = of_words(painter.ctx(), colour);
        let galley = painter.layout_no_wrap(text, FontId::proportional(16.0), colour);
        let size = galley.size();
        let plate = Rect::from_min_size(corner, size).expand2(vec2(5.0, 1.0));
        painter.rect_filled(plate, 3.0, backing(painter.ctx(), 210));
        painter.galley(corner, galley, colour);
        corner.y += size.y + 3.0;
    }
}

/// What the method and Sightline find: the object, and where both find the same one, the triangle too.
fn labels(state: &State, compared: &Compared) -> [String; 2] {
    let both = [&compared.theirs, &compared.ours].map(Option::as_ref);
    let [theirs, ours] = both.map(|found| found.map(|found| found.hit.object));
    both.map(|found| {
        let Some(found) = found else {
            return "nothing".to_owned();
        };
        let name = &state.scene().objects()[found.hit.object].name;
        match found.hit.hit.on_triangle {
            Some(at) if theirs == ours => format!("triangle {} of {name}", at.triangle),
            _ => name.clone(),
        }
    })
}
