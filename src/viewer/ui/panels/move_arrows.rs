//! Three arrows at the selected object, along the world's axes. A drag moves the object along one, or with Shift turns it
//! about one. They show while Placement does.

use super::{arrow::Arrow, field::AXES, prelude::*, slide::Slide};
use crate::{
    camera::{Projection, View},
    geometry::Trs,
    look,
    viewer::model::with_linear,
};
use egui::Pos2;
use glam::{DAffine3, DVec2};

/// How long an arrow is that is seen from the side, in points.
const LENGTH: f64 = 72.0;
/// A shorter one, seen nearly end-on, is left out.
const SHORTEST: f32 = 18.0;

/// Shown over the picture.
pub(super) fn show(
    ui: &Ui,
    rect: Rect,
    place: SceneRect,
    state: &State,
    commands: &mut Vec<Command>,
) {
    let Some(object) = state.selected() else {
        return;
    };
    let moved = &state.scene().objects()[object];
    if !moved.visible {
        return;
    }
    let (model, view) = (moved.placement.model(), state.view());
    let centre_object = state.scene().centre_of(object);
    let per_point = f64::from(ui.ctx().pixels_per_point());
    let arrow_px = LENGTH * per_point;
    // The place from where it is dragged.
    let dragged_from = ui.scope_id().with("dragged from");
    for (axis, (letter, colour)) in DVec3::AXES
        .into_iter()
        .zip(AXES.into_iter().zip(look::AXES))
    {
        let handle = |model: DAffine3| Handle::new(model, centre_object, axis, view, arrow_px);
        let Some(shown) = handle(model) else { continue };
        let [foot, head] = shown.ends_px.map(|px| place.to_position(px));
        if (head - foot).length() < SHORTEST {
            continue;
        }
        let name = format!("move along {letter}");
        let hint =
            format!("drag: moves the object along {letter}; with Shift: turns it about {letter}");
        let response = Arrow { foot, head }.show(ui, rect, &name, color32(colour), &hint);
        if response.drag_started() {
            ui.data_mut(|data| data.insert_temp(dragged_from, model));
        }
        let mut slide = Slide::default();
        slide.note(&response);
        let dragged = response.dragged().then(|| {
            let from = ui.data(|data| data.get_temp::<DAffine3>(dragged_from))?;
            let (pressed, now, turns) = ui.input(|input| {
                let [pressed, now] = [input.pointer.press_origin(), input.pointer.latest_pos()];
                (pressed, now, input.modifiers.shift)
            });
            let [pressed_px, now_px] = [pressed?, now?].map(|at: Pos2| place.to_px(at));
            let handle = handle(from)?;
            if turns {
                handle.turned(now_px - pressed_px)
            } else {
                handle.moved(pressed_px, now_px)
            }
        });
        let dragged = dragged.flatten().filter(|dragged| *dragged != model);
        slide.push(dragged.map(|to| Action::Place(object, to)), commands);
    }
}

/// An arrow of an object that stands somewhere.
struct Handle<'a> {
    model: DAffine3,
    centre_object: DVec3,
    /// One of the world's axes.
    axis: DVec3,
    view: &'a View,
    /// The arrow's length in world units.
    length: f64,
    /// The arrow's foot and head in the picture.
    ends_px: [DVec2; 2],
}

impl<'a> Handle<'a> {
    /// `None` where the picture does not show it.
    fn new(
        model: DAffine3,
        centre_object: DVec3,
        axis: DVec3,
        view: &'a View,
        arrow_px: f64,
    ) -> Option<Self> {
        let centre = model.transform_point3(centre_object);
        let length = arrow_px / view.px_across(1.0, centre)?;
        let ends_px = view
            .uncut()
            .project_segment(centre, centre + length * axis)?;
        Some(Self {
            model,
            centre_object,
            axis,
            view,
            length,
            ends_px,
        })
    }

    fn centre_world(&self) -> DVec3 {
        self.model.transform_point3(self.centre_object)
    }

    /// Moved along the axis as far as the cursor: what was under it stays nearest to it.
    fn moved(&self, from_px: DVec2, to_px: DVec2) -> Option<DAffine3> {
        let by = self.along(to_px) - self.along(from_px);
        let translation = self.model.translation + by * self.axis;
        let model = DAffine3::from_mat3_translation(self.model.matrix3, translation);
        by.is_finite().then_some(model)
    }

    /// Where the line of the axis through the centre comes nearest to the ray of a position, from the centre. It is no
    /// number where both run alike.
    fn along(&self, px: DVec2) -> f64 {
        let [start, one] = [0.0, 1.0].map(|t| self.view.offset_from_eye(px, t));
        let ray = (one - start).normalize();
        let to_centre = self.centre_world() - self.view.camera.eye() - start;
        let slant = self.axis.dot(ray);
        (slant * ray.dot(to_centre) - self.axis.dot(to_centre)) / (1.0 - slant * slant)
    }

    /// Turned about the axis through the centre, so that the side towards the eye follows the cursor: by a radian for
    /// as many pixels as the arrow seen from the side has.
    fn turned(&self, by_px: DVec2) -> Option<DAffine3> {
        let (centre, camera) = (self.centre_world(), &self.view.camera);
        let to_eye = match camera.lens().projection {
            Projection::Perspective { .. } => camera.eye() - centre,
            Projection::Orthographic { .. } => -camera.forward(),
        };
        let rightwards = self.axis.cross(to_eye).try_normalize()?;
        let [from, to] =
            (self.view.uncut()).project_segment(centre, centre + self.length * rightwards)?;
        let along = to - from;
        let angle = by_px.dot(along) / along.length_squared();
        let turn = Trs {
            rotation_deg: angle.to_degrees() * self.axis,
            ..Trs::default()
        };
        let linear = turn.to_model().matrix3 * self.model.matrix3;
        let model = with_linear(self.model, linear, self.centre_object);
        angle.is_finite().then_some(model)
    }
}
