//! Turns mouse events into actions. The scene is a widget like any other, so egui decides who owns a slide: a press
//! that began on a panel never reaches the scene.

use super::panels::is_hint;
use crate::viewer::{
    model::{Action, DOUBLE_CLICK_S, Stage},
    screen::SceneRect,
};
use egui::{Event, MouseWheelUnit, PointerButton, Pos2, Rect, Response, Sense, Ui};
use glam::DVec2;
use std::mem;

/// A press that travels further than this, in points, is a drag.
const CLICK_TRAVEL: f32 = 3.0;
/// Zoom factor of one line of the wheel.
const ZOOM_PER_LINE: f64 = 1.15;
/// Points that a trackpad moves for one line of a wheel.
const POINTS_PER_LINE: f64 = 50.0;

/// How egui tells clicks from drags: by the farthest travel, never by time.
pub(in crate::viewer) fn set_click(ctx: &egui::Context) {
    ctx.options_mut(|options| {
        options.input_options.max_click_dist = CLICK_TRAVEL;
        options.input_options.max_click_duration = f64::INFINITY;
        options.input_options.max_double_click_delay = DOUBLE_CLICK_S;
    });
}

/// The drag that is under way on the scene, or on one of its four views: what it does and where the cursor was.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::viewer) struct Drag {
    of: Option<Stage>,
    place: SceneRect,
    does: Does,
    at: DVec2,
    /// Whether the last pass showed what is dragged.
    is_shown: bool,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Does {
    Turn,
    Pan,
    Steer,
}

impl Drag {
    fn moves_to(&mut self, pointer: Pos2) -> Option<Action> {
        let to = self.place.to_px(pointer);
        let by = to - mem::replace(&mut self.at, to);
        (by != DVec2::ZERO).then_some(match self.does {
            Does::Turn => Action::Turn(by),
            Does::Pan => Action::Pan(by),
            Does::Steer => Action::Steer(by),
        })
    }
}

/// The actions of a drag under way, if events only move the mouse. They are done before the panels are laid out, so
/// that these show the outcome at once.
pub(in crate::viewer) fn moves_ahead(drag: &mut Option<Drag>, events: &[Event]) -> Vec<Action> {
    let mut to = None;
    for event in events {
        match event {
            Event::PointerMoved(at) => to = Some(*at),
            Event::MouseMoved(_) => {}
            _ => return Vec::new(),
        }
    }
    let (Some(drag), Some(to)) = (drag, to) else {
        return Vec::new();
    };
    if !mem::take(&mut drag.is_shown) {
        return Vec::new();
    }
    let moved = drag.moves_to(to);
    let moved = moved.map(|action| [Action::Enter(drag.of), action, Action::Enter(None)]);
    moved.into_iter().flatten().collect()
}

/// What the mouse did on the scene, or on one of its four views, with the response of that widget.
pub(in crate::viewer) fn scene(
    ui: &mut Ui,
    of: Option<Stage>,
    rect: Rect,
    place: SceneRect,
    drag: &mut Option<Drag>,
) -> (Response, Vec<Action>) {
    // Tab does not stop here: there is nothing to type.
    let id = (ui.scope_id()).with(("scene", of.map(|stage| stage as usize)));
    let response = ui.interact(rect, id, Sense::CLICK | Sense::DRAG);
    let mut actions = vec![Action::Resize(place.viewport)];
    let (modifiers, time_s) = ui.input(|input| (input.modifiers, input.time));

    // egui also gives a widget what happens slightly outside of it, where there is no picture.
    let within =
        |position: Pos2| Some(place.to_px(position)).filter(|at| place.viewport.contains(*at));
    let pressed_at = ui.input(|input| input.pointer.press_origin());
    if response.drag_started()
        && let Some(at) = pressed_at.and_then(within)
    {
        let does = match response.dragged_by(PointerButton::Primary) {
            true if modifiers.command => Does::Steer,
            true if !modifiers.shift => Does::Turn,
            _ => Does::Pan,
        };
        match does {
            Does::Turn => actions.push(Action::BeginTurn(at)),
            Does::Pan => actions.push(Action::BeginPan(at)),
            Does::Steer => {}
        }
        *drag = Some(Drag {
            of,
            place,
            does,
            at,
            is_shown: true,
        });
    }
    let own = drag.as_mut().filter(|drag| drag.of == of);
    if let (Some(moving), Some(pointer)) = (own, response.interact_pointer_pos()) {
        (moving.place, moving.is_shown) = (place, true);
        actions.extend(moving.moves_to(pointer));
    }
    if !response.dragged() {
        drag.take_if(|drag| drag.of == of);
    }
    if response.clicked()
        && let Some(at) = released_at(ui).and_then(within)
    {
        if modifiers.command || modifiers.shift {
            actions.push(Action::ClickAlso(at));
        } else {
            actions.push(Action::Click(at, time_s));
            if response.double_clicked() {
                actions.push(Action::Recentre(at));
            }
        }
    }
    let is_idle = drag.is_none() && !response.is_pointer_button_down_on();
    let hovering = (response.hover_pos().filter(|_| is_idle)).and_then(within);
    // The wheel acts on the picture below a hint, too: what it does may have brought the hint under the cursor.
    let pointer = ui.ctx().pointer_hover_pos().filter(|_| of.is_none());
    let on_hint = pointer.filter(|at| ui.ctx().layer_id_at(*at).is_some_and(is_hint));
    if let Some(at) = hovering.or(on_hint.and_then(within)) {
        wheel(ui, place, at, &mut actions);
    }
    actions.push(Action::Hover(hovering));
    (response, actions)
}

/// Where the primary button was released in this frame: the pointer may have moved on since.
fn released_at(ui: &Ui) -> Option<Pos2> {
    let released = |event: &Event| match event {
        Event::PointerButton {
            pos,
            button: PointerButton::Primary,
            pressed: false,
            ..
        } => Some(*pos),
        _ => None,
    };
    ui.input(|input| input.events.iter().rev().find_map(released))
}

/// Wheel and trackpad: zoom at the pointer; with Shift, pan. With Ctrl, egui makes zoom events of them.
fn wheel(ui: &Ui, place: SceneRect, at: DVec2, actions: &mut Vec<Action>) {
    ui.input(|input| {
        for event in &input.events {
            match *event {
                Event::MouseWheel {
                    unit,
                    delta,
                    modifiers,
                    ..
                } if !modifiers.command => {
                    let points = match unit {
                        MouseWheelUnit::Point => 1.0,
                        MouseWheelUnit::Line => POINTS_PER_LINE,
                        MouseWheelUnit::Page => 10.0 * POINTS_PER_LINE,
                    };
                    let by = DVec2::new(f64::from(delta.x), f64::from(delta.y)) * points;
                    if modifiers.shift {
                        let by_px = by * f64::from(place.pixels_per_point);
                        actions.extend([Action::BeginPan(at), Action::Pan(by_px)]);
                    } else if by.y != 0.0 {
                        actions.push(Action::Zoom(
                            at,
                            libm::pow(ZOOM_PER_LINE, by.y / POINTS_PER_LINE),
                        ));
                    }
                }
                Event::Zoom(factor) if factor > 0.0 => {
                    actions.push(Action::Zoom(at, f64::from(factor)));
                }
                _ => {}
            }
        }
    });
}
