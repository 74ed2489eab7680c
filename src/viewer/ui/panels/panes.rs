//! The four views side by side, or one of them large, each with its heading, its mouse actions and its axes.

use super::{axis_cross, lit_numbers, menu, pane_labels, prelude::*};
use crate::{
    camera::{DepthMapping, View},
    viewer::{
        model::{Stage, Views},
        ui::mouse::{self, Drag},
    },
};
use egui::UiBuilder;
use glam::DMat3;

/// The gap between two views, in points.
const GAP: f32 = 2.0;
/// Height of a view's heading in points.
const HEADING: f32 = 34.0;
/// Smaller than this, in points, a view has no room for a cross of axes.
const ROOM_FOR_CROSS: f32 = 190.0;

/// Shows the views within the scene's rectangle, with the numbers of the worked pick where these show. Returns where
/// each is.
pub(super) fn show(
    ui: &mut Ui,
    rect: Rect,
    (state, works): (&State, bool),
    drag: &mut Option<Drag>,
    commands: &mut Vec<Command>,
) -> Vec<(Stage, SceneRect)> {
    let stages = state.stages();
    if stages.len() > 1 {
        let line = Stroke::new(GAP, ui.visuals().window_stroke.color);
        let middle = rect.center().round();
        ui.painter().hline(rect.x_range(), middle.y, line);
        ui.painter().vline(middle.x, rect.y_range(), line);
    }
    let mut places = Vec::new();
    let mut hovers = false;
    for (at, &stage) in stages.iter().enumerate() {
        let is_alone = stages.len() == 1;
        let rect = if is_alone { rect } else { quarter(rect, at) };
        let Some(place) = SceneRect::new(rect, ui.ctx().pixels_per_point()) else {
            continue;
        };
        places.push((stage, place));
        let mut asked = Vec::new();
        hovers |= pane(ui, stage, rect, place, (state, works), drag, &mut asked);
        // The actions between these two are for this view.
        commands.push(Command::Act(Action::Enter(Some(stage))));
        commands.extend(asked);
        commands.push(Command::Act(Action::Enter(None)));
    }
    if !hovers {
        commands.push(Command::Act(Action::Hover(None)));
    }
    places
}

/// The rectangle of the view at an index: object and world stand above view and NDC.
fn quarter(rect: Rect, at: usize) -> Rect {
    let (middle, half) = (rect.center().round(), 0.5 * GAP);
    let (left, right) = if at.is_multiple_of(2) {
        (rect.left(), middle.x - half)
    } else {
        (middle.x + half, rect.right())
    };
    let (top, bottom) = if at < 2 {
        (rect.top(), middle.y - half)
    } else {
        (middle.y + half, rect.bottom())
    };
    Rect::from_min_max(pos2(left, top), pos2(right, bottom))
}

/// Shows one view. Returns whether the cursor is in it.
fn pane(
    ui: &mut Ui,
    stage: Stage,
    rect: Rect,
    place: SceneRect,
    (state, works): (&State, bool),
    drag: &mut Option<Drag>,
    commands: &mut Vec<Command>,
) -> bool {
    let (response, actions) = mouse::scene(ui, Some(stage), rect, place, drag);
    let response = response.named(&format!("stage {}", stage.name())).bounded();
    let px = response.interact_pointer_pos().map(|at| place.to_px(at));
    menu::of_picture(&response, state, px, commands);
    response.names(state.under_cursor());
    let mut hovers = false;
    for action in actions {
        if action != Action::Hover(None) {
            hovers |= matches!(action, Action::Hover(_));
            commands.push(Command::Act(action));
        }
    }
    let Some(view) = state.pane_view(stage) else {
        return hovers;
    };
    let seen = View {
        viewport: place.viewport,
        ..view
    };
    if works {
        lit_numbers::in_pane(ui, stage, rect, place, state, &seen, commands);
    }
    pane_labels::show(ui, stage, rect, place, state, &seen);
    if rect.size().min_elem() >= ROOM_FOR_CROSS {
        let axes = axes(state, stage);
        ui.push_id(stage.name(), |ui| {
            if let Some(to) = axis_cross::cross(ui, rect, &(view.camera.rotation() * axes)) {
                // In the space that the stage is drawn in, z may run the other way.
                let drawn = drawn_axes(state, stage) * to;
                commands.push(Command::Act(Action::LookFrom(drawn)));
            }
        });
    }
    heading(ui, stage, rect, state, commands);
    hovers
}

/// The unit vectors of a stage's axes in the space of the scene that it shows.
fn axes(state: &State, stage: Stage) -> DMat3 {
    match stage {
        Stage::View => state.view().camera.rotation().transpose(),
        _ => drawn_axes(state, stage),
    }
}

/// The unit vectors of a stage's axes in the right-handed space that it is drawn in: z is reversed where the stage's
/// own space is left-handed.
fn drawn_axes(state: &State, stage: Stage) -> DMat3 {
    let is_left_handed = match stage {
        Stage::Object | Stage::World => false,
        Stage::View => true,
        Stage::Ndc => state.view().camera.lens().depth == DepthMapping::Standard,
    };
    let z = if is_left_handed { -1.0 } else { 1.0 };
    DMat3::from_diagonal(DVec3::new(1.0, 1.0, z))
}

/// What a view shows, in a line, and which way depth runs.
fn about(state: &State, stage: Stage) -> (String, &'static str) {
    let lens = state.view().camera.lens();
    match stage {
        Stage::Object => {
            let hint = "right-handed; depth runs along the ray, which the inverse of M takes to this space";
            let Some(object) = state.pane_object() else {
                return ("no object".into(), hint);
            };
            let object = &state.scene().objects()[object];
            let mirrors = if object.placement.mirrors() {
                " mirrors it"
            } else {
                ""
            };
            (format!("{}, before M{mirrors}", object.name), hint)
        }
        Stage::World => (
            "depth runs along F; right-handed, after M".into(),
            "all objects and the camera that the panel drives: depth is measured from its eye along its axis F",
        ),
        Stage::View => (
            "z is depth, away from the eye; left-handed, after V".into(),
            "the eye is the origin, x its right, y its up, z its forward. Nothing is mirrored: in a left-handed space x, y and z point as thumb, forefinger and middle finger of the left hand do",
        ),
        Stage::Ndc => match lens.depth {
            DepthMapping::Reversed => (
                "z is depth, near 1, far 0; after P and / w".into(),
                "what the camera sees fills the box. With reversed depth z runs towards the eye, and the space is right-handed. Nothing is mirrored",
            ),
            DepthMapping::Standard => (
                "z is depth, near 0, far 1; after P and / w".into(),
                "what the camera sees fills the box. With standard depth z runs away from the eye, and the space is left-handed. Nothing is mirrored",
            ),
        },
    }
}

/// A view's name, what it shows, and the buttons that enlarge it and frame it again.
fn heading(ui: &mut Ui, stage: Stage, rect: Rect, state: &State, commands: &mut Vec<Command>) {
    let name = stage.name();
    let strip = Rect::from_min_size(rect.min, vec2(rect.width(), HEADING.min(rect.height())));
    let painter = ui.painter().with_clip_rect(rect);
    painter.rect_filled(strip, 0.0, backing(ui.ctx(), 190));
    // A click here is none in the view below.
    let id = ui.scope_id().with(("heading", stage as usize));
    if ui.interact(strip, id, Sense::CLICK).double_clicked() {
        commands.push(Action::Views(state.views_with_other_size(stage)).into());
    }
    let inside = UiBuilder::new().max_rect(strip.shrink2(vec2(6.0, 2.0)));
    let inside = inside.layout(Layout::right_to_left(Align::Min));
    ui.scope_builder(inside, |ui| {
        ui.spacing_mut().item_spacing.x = 3.0;
        let mut button = |icon: &str, does: &str, hint: &str, action: Action| {
            let button = Button::new(RichText::new(icon).size(12.0)).small();
            let button = ui.add(button.frame_when_inactive(false));
            let button = button.named(&format!("{does} {name}"));
            button.asks(hint, action, commands);
        };
        let (icon, does, hint) = match state.views() {
            Views::One(_) => (
                "\u{229e}",
                "four views beside",
                "all four again (double click)",
            ),
            _ => (
                "\u{26f6}",
                "enlarge",
                "this one alone, large (double click)",
            ),
        };
        let resize = Action::Views(state.views_with_other_size(stage));
        button(icon, does, hint, resize);
        let hint = "all of it in view again, as it was at first";
        button("\u{27f3}", "frame", hint, Action::ResetView);
        ui.with_layout(Layout::top_down(Align::Min), |ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            let (shows, hint) = about(state, stage);
            let title = Label::new(RichText::new(name).size(14.0).strong());
            ui.add(title.selectable(false)).hint(hint);
            let shows = Label::new(RichText::new(shows).size(11.0));
            ui.add(shows.selectable(false).truncate()).hint(hint);
        });
    });
}
