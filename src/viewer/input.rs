//! The mouse's events to actions. The scene is a widget like any other, so egui decides who owns a gesture: a press that
//! began on a panel never reaches the scene.

use super::action::Action;
use crate::camera::Viewport;
use egui::{Event, MouseWheelUnit, PointerButton, Pos2, Rect, Sense, Ui};
use glam::DVec2;

/// A press that travels further than this, in points, is a drag.
const CLICK_TRAVEL: f32 = 3.0;
/// Zoom factor of one line of the wheel.
const ZOOM_PER_LINE: f64 = 1.15;
/// Points that a trackpad moves for one line of a wheel.
const POINTS_PER_LINE: f64 = 50.0;

/// How egui tells clicks from drags: by the farthest travel, never by time.
pub(super) fn options(ctx: &egui::Context) {
    ctx.options_mut(|options| {
        options.input_options.max_click_dist = CLICK_TRAVEL;
        options.input_options.max_click_duration = f64::INFINITY;
        options.input_options.max_double_click_delay = super::state::DOUBLE_CLICK_S;
    });
}

/// The drag that is under way on the scene: what it does and where the cursor was.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Drag {
    turns: bool,
    at: DVec2,
}

/// The rectangle of the window that shows the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SceneRect {
    /// Top left corner in physical pixels of the window.
    pub origin_px: [u32; 2],
    /// Its size in physical pixels.
    pub viewport: Viewport,
    pixels_per_point: f32,
}

impl SceneRect {
    /// The pixels that a rectangle in points covers; `None` when that is not even one.
    pub fn new(rect: Rect, pixels_per_point: f32) -> Option<Self> {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "clamped by the cast"
        )]
        let px = |points: f32| (points * pixels_per_point).round() as u32;
        let (left, top) = (px(rect.left()), px(rect.top()));
        let size = [
            px(rect.right()).saturating_sub(left),
            px(rect.bottom()).saturating_sub(top),
        ];
        Some(Self {
            origin_px: [left, top],
            viewport: Viewport::new(size[0], size[1]).ok()?,
            pixels_per_point,
        })
    }

    /// The pixels as a rectangle in points.
    pub fn to_points(self) -> Rect {
        #[expect(clippy::cast_precision_loss, reason = "windows are not that large")]
        let points = |px: [u32; 2]| px.map(|px| px as f32 / self.pixels_per_point);
        let size = points([self.viewport.width(), self.viewport.height()]);
        Rect::from_min_size(points(self.origin_px).into(), size.into())
    }

    /// A position within the rectangle in pixels as a position in points.
    #[expect(clippy::cast_possible_truncation, reason = "points are f32")]
    pub fn to_position(self, px: DVec2) -> Pos2 {
        let scale = f64::from(self.pixels_per_point);
        let origin = DVec2::from(self.origin_px.map(f64::from));
        let points = (px + origin) / scale;
        Pos2::new(points.x as f32, points.y as f32)
    }

    /// A position in points as a position within the rectangle in pixels. The pointer's own pixels went through
    /// `f32` points and back: what is off by that rounding is put right.
    pub fn to_px(self, position: Pos2) -> DVec2 {
        const STEPS: f64 = 64.0;
        let scale = f64::from(self.pixels_per_point);
        let px = DVec2::new(f64::from(position.x), f64::from(position.y)) * scale;
        let origin = DVec2::new(f64::from(self.origin_px[0]), f64::from(self.origin_px[1]));
        (px * STEPS).round() / STEPS - origin
    }
}

/// What the mouse did on the scene.
pub(super) fn scene(
    ui: &mut Ui,
    rect: Rect,
    place: SceneRect,
    drag: &mut Option<Drag>,
) -> Vec<Action> {
    let response = ui.interact(rect, ui.scope_id().with("scene"), Sense::click_and_drag());
    let mut actions = vec![Action::Resize(place.viewport)];
    let (shift, time_s) = ui.input(|input| (input.modifiers.shift, input.time));

    if response.drag_started()
        && let Some(pressed) = ui.input(|input| input.pointer.press_origin())
    {
        let at = place.to_px(pressed);
        let turns = response.dragged_by(PointerButton::Primary) && !shift;
        actions.push(if turns {
            Action::BeginTurn(at)
        } else {
            Action::BeginPan(at)
        });
        *drag = Some(Drag { turns, at });
    }
    if let (Some(moving), Some(pointer)) = (drag.as_mut(), response.interact_pointer_pos()) {
        let to = place.to_px(pointer);
        let by = to - moving.at;
        if by != DVec2::ZERO {
            actions.push(if moving.turns {
                Action::Turn(by)
            } else {
                Action::Pan(by)
            });
            moving.at = to;
        }
    }
    if !response.dragged() {
        *drag = None;
    }
    if response.clicked()
        && let Some(released) = released_at(ui)
    {
        actions.push(Action::Click(place.to_px(released), time_s));
        if response.double_clicked() {
            actions.push(Action::Recentre(place.to_px(released)));
        }
    }
    let hovering = response
        .hover_pos()
        .filter(|_| drag.is_none() && !response.is_pointer_button_down_on());
    if let Some(pointer) = hovering {
        wheel(ui, place, pointer, &mut actions);
    }
    actions.push(Action::Hover(hovering.map(|pointer| place.to_px(pointer))));
    actions
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

/// Wheel and trackpad: zoom at the pointer; with Shift, shift. With Ctrl they are egui's.
fn wheel(ui: &Ui, place: SceneRect, pointer: Pos2, actions: &mut Vec<Action>) {
    let at = place.to_px(pointer);
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
                        actions.push(Action::Zoom(at, ZOOM_PER_LINE.powf(by.y / POINTS_PER_LINE)));
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
