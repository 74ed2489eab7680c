//! Mouse and keys to actions. The scene is a widget like any other, so egui decides who owns a gesture: a press that
//! began on a panel never reaches the scene.

use super::{
    Command,
    action::{Action, LensControls},
};
use crate::camera::{Projection, View, Viewport};
use crate::geometry::Sides;
use egui::{Event, Key, Modifiers, MouseWheelUnit, PointerButton, Pos2, Rect, Sense, Ui};
use glam::{DVec2, DVec3};

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

/// A key and what it does.
pub(super) struct Binding {
    /// As the help writes it.
    pub keys: &'static str,
    /// What it does, for the help.
    pub does: &'static str,
    shortcuts: &'static [(Modifiers, Key)],
    command: fn(&View, LensControls) -> Command,
}

const NONE: Modifiers = Modifiers::NONE;
const SHIFT: Modifiers = Modifiers::SHIFT;
const CTRL: Modifiers = Modifiers::COMMAND;

/// Every key, in the order of the help.
pub(super) const BINDINGS: &[Binding] = &[
    Binding {
        keys: "F",
        does: "frame the selection",
        shortcuts: &[(NONE, Key::F)],
        command: |_, _| Command::Act(Action::FrameSelection),
    },
    Binding {
        keys: "A, Home",
        does: "frame all",
        shortcuts: &[(NONE, Key::A), (NONE, Key::Home)],
        command: |_, _| Command::Act(Action::FrameAll),
    },
    Binding {
        keys: "Enter",
        does: "the view that the scene opened with",
        shortcuts: &[(NONE, Key::Enter)],
        command: |_, _| Command::Act(Action::ResetView),
    },
    Binding {
        keys: "1, Ctrl+1",
        does: "front, back",
        shortcuts: &[(NONE, Key::Num1)],
        command: |_, _| look(DVec3::Z),
    },
    Binding {
        keys: "",
        does: "",
        shortcuts: &[(CTRL, Key::Num1)],
        command: |_, _| look(DVec3::NEG_Z),
    },
    Binding {
        keys: "3, Ctrl+3",
        does: "right, left",
        shortcuts: &[(NONE, Key::Num3)],
        command: |_, _| look(DVec3::X),
    },
    Binding {
        keys: "",
        does: "",
        shortcuts: &[(CTRL, Key::Num3)],
        command: |_, _| look(DVec3::NEG_X),
    },
    Binding {
        keys: "7, Ctrl+7",
        does: "top, bottom",
        shortcuts: &[(NONE, Key::Num7)],
        command: |_, _| look(DVec3::Y),
    },
    Binding {
        keys: "",
        does: "",
        shortcuts: &[(CTRL, Key::Num7)],
        command: |_, _| look(DVec3::NEG_Y),
    },
    Binding {
        keys: "9",
        does: "from the corner",
        shortcuts: &[(NONE, Key::Num9)],
        command: |_, _| look(DVec3::ONE),
    },
    Binding {
        keys: "5",
        does: "perspective, orthographic",
        shortcuts: &[(NONE, Key::Num5)],
        command: |_, controls| {
            Command::Act(Action::Lens(LensControls {
                orthographic: !controls.orthographic,
                ..controls
            }))
        },
    },
    Binding {
        keys: "B",
        does: "back faces",
        shortcuts: &[(NONE, Key::B)],
        command: |view, _| {
            Command::Act(Action::Sides(if view.sides == Sides::Both {
                Sides::Front
            } else {
                Sides::Both
            }))
        },
    },
    Binding {
        keys: "G",
        does: "grid and axes",
        shortcuts: &[(NONE, Key::G)],
        command: |_, _| Command::Act(Action::ToggleGrid),
    },
    Binding {
        keys: "Shift+H",
        does: "hide the selection",
        shortcuts: &[(SHIFT, Key::H)],
        command: |_, _| Command::Act(Action::HideSelection),
    },
    Binding {
        keys: "I",
        does: "hide all but the selection",
        shortcuts: &[(NONE, Key::I)],
        command: |_, _| Command::Act(Action::Isolate),
    },
    Binding {
        keys: "U",
        does: "show all",
        shortcuts: &[(NONE, Key::U)],
        command: |_, _| Command::Act(Action::ShowAll),
    },
    Binding {
        keys: "Ctrl+O",
        does: "open files",
        shortcuts: &[(CTRL, Key::O)],
        command: |_, _| Command::OpenDialog,
    },
    Binding {
        keys: "Ctrl+S",
        does: "save as a scene file",
        shortcuts: &[(CTRL, Key::S)],
        command: |_, _| Command::SaveDialog,
    },
    Binding {
        keys: "R",
        does: "read the files again",
        shortcuts: &[(NONE, Key::R)],
        command: |_, _| Command::Reload,
    },
    Binding {
        keys: "T",
        does: "freeze the camera: it stays as lines, with the pick's ray, while you look from elsewhere",
        shortcuts: &[(NONE, Key::T)],
        command: |_, _| Command::Act(Action::ToggleFreeze),
    },
    Binding {
        keys: "P",
        does: "the matrices, and the pick on its way through them",
        shortcuts: &[(NONE, Key::P)],
        command: |_, _| Command::TogglePipeline,
    },
    Binding {
        keys: "V",
        does: "compare what is drawn with what is picked, pixel by pixel",
        shortcuts: &[(NONE, Key::V)],
        command: |_, _| Command::ToggleCheck,
    },
    Binding {
        keys: "C",
        does: "copy the view as a command",
        shortcuts: &[(NONE, Key::C)],
        command: |_, _| Command::CopyCommandLine,
    },
    Binding {
        keys: "J",
        does: "copy the pick as JSON",
        shortcuts: &[(NONE, Key::J)],
        command: |_, _| Command::CopyPick,
    },
    Binding {
        keys: "Esc",
        does: "stop loading, close the help or the comparison, select nothing",
        shortcuts: &[(NONE, Key::Escape)],
        command: |_, _| Command::Escape,
    },
    Binding {
        keys: "H, ?",
        does: "this help",
        shortcuts: &[
            (NONE, Key::H),
            (SHIFT, Key::Questionmark),
            (NONE, Key::Questionmark),
        ],
        command: |_, _| Command::ToggleHelp,
    },
    Binding {
        keys: "Ctrl+Q",
        does: "quit",
        shortcuts: &[(CTRL, Key::Q)],
        command: |_, _| Command::Quit,
    },
];

/// What the mouse does, for the help.
pub(super) const MOUSE: &[(&str, &str)] = &[
    ("left drag", "orbit about the point under the cursor"),
    ("right, middle or Shift + left drag", "pan"),
    ("wheel, pinch", "zoom at the cursor"),
    ("click", "pick; the same pixel again: the surface behind"),
    (
        "double click",
        "set pivot and centre; on nothing: frame all",
    ),
];

fn look(to_eye: DVec3) -> Command {
    Command::Act(Action::LookFrom(to_eye))
}

/// What the keys say, unless somebody is typing.
pub(super) fn keys(ctx: &egui::Context, view: &View, controls: LensControls) -> Vec<Command> {
    if ctx.egui_wants_keyboard_input() {
        return Vec::new();
    }
    ctx.input_mut(|input| {
        let pressed = BINDINGS.iter().filter(|binding| {
            binding
                .shortcuts
                .iter()
                .any(|(modifiers, key)| input.consume_key(*modifiers, *key))
        });
        pressed
            .map(|binding| (binding.command)(view, controls))
            .collect()
    })
}

/// The word for a projection.
pub(super) fn projection_name(view: &View) -> &'static str {
    match view.camera.lens().projection {
        Projection::Perspective { .. } => "perspective",
        Projection::Orthographic { .. } => "orthographic",
    }
}
