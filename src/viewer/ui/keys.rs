//! Keys to commands, in one table that the help is made from.

use super::{command::Command, focus::Focus, panels::give_up_refused};
use crate::viewer::model::{Action, Overlay};
use egui::{Event, Key, Modifiers};
use glam::DVec3;
use std::iter;

/// Keys that belong together, in a row of the help.
pub(in crate::viewer) struct Binding {
    /// The keys, as the help writes them.
    pub keys: &'static str,
    /// What they do, for the help.
    pub does: &'static str,
    /// What each shortcut asks for.
    pub shortcuts: &'static [(Modifiers, Key, Command)],
}

const NONE: Modifiers = Modifiers::NONE;
const SHIFT: Modifiers = Modifiers::SHIFT;
const CTRL: Modifiers = Modifiers::COMMAND;

/// Every key, in the order of the help. A shortcut with Shift stands before the one without, which would match both.
pub(in crate::viewer) const BINDINGS: &[Binding] = &[
    Binding {
        keys: "F",
        does: "frame the selection",
        shortcuts: &[(NONE, Key::F, act(Action::FrameSelection))],
    },
    Binding {
        keys: "A, Home",
        does: "frame all",
        shortcuts: &[
            (NONE, Key::A, act(Action::FrameAll)),
            (NONE, Key::Home, act(Action::FrameAll)),
        ],
    },
    Binding {
        keys: "Enter",
        does: "the view that the scene opened with",
        shortcuts: &[(NONE, Key::Enter, act(Action::ResetView))],
    },
    Binding {
        keys: "1, Ctrl+1",
        does: "front, back",
        shortcuts: &[
            (NONE, Key::Num1, look(DVec3::Z)),
            (CTRL, Key::Num1, look(DVec3::NEG_Z)),
        ],
    },
    Binding {
        keys: "3, Ctrl+3",
        does: "right, left",
        shortcuts: &[
            (NONE, Key::Num3, look(DVec3::X)),
            (CTRL, Key::Num3, look(DVec3::NEG_X)),
        ],
    },
    Binding {
        keys: "7, Ctrl+7",
        does: "top, bottom",
        shortcuts: &[
            (NONE, Key::Num7, look(DVec3::Y)),
            (CTRL, Key::Num7, look(DVec3::NEG_Y)),
        ],
    },
    Binding {
        keys: "9",
        does: "from the corner",
        shortcuts: &[(NONE, Key::Num9, look(DVec3::ONE))],
    },
    Binding {
        keys: "5",
        does: "perspective, orthographic",
        shortcuts: &[(NONE, Key::Num5, act(Action::ToggleProjection))],
    },
    Binding {
        keys: "B",
        does: "back faces",
        shortcuts: &[(NONE, Key::B, act(Action::ToggleSides))],
    },
    Binding {
        keys: "Z",
        does: "section",
        shortcuts: &[(NONE, Key::Z, act(Action::ToggleSection))],
    },
    Binding {
        keys: "G",
        does: "grid and axes",
        shortcuts: &[(NONE, Key::G, act(Action::ToggleGrid))],
    },
    Binding {
        keys: "Shift+H",
        does: "hide the selection",
        shortcuts: &[(SHIFT, Key::H, act(Action::HideSelection))],
    },
    Binding {
        keys: "I",
        does: "hide all but the selection",
        shortcuts: &[(NONE, Key::I, act(Action::Isolate))],
    },
    Binding {
        keys: "U",
        does: "show all",
        shortcuts: &[(NONE, Key::U, act(Action::ShowAll))],
    },
    Binding {
        keys: "Down, Up",
        does: "in the list of objects: select the next, the one before",
        shortcuts: &[
            (NONE, Key::ArrowUp, Command::SelectRow { down: false }),
            (NONE, Key::ArrowDown, Command::SelectRow { down: true }),
        ],
    },
    Binding {
        keys: "Ctrl+O",
        does: "open files",
        shortcuts: &[(CTRL, Key::O, Command::OpenDialog)],
    },
    Binding {
        keys: "Ctrl+S",
        does: "save as a scene file",
        shortcuts: &[(CTRL, Key::S, Command::SaveDialog)],
    },
    Binding {
        keys: "Ctrl+Z, Ctrl+Shift+Z, Ctrl+Y",
        does: "undo; redo (either key)",
        shortcuts: &[
            (CTRL.plus(SHIFT), Key::Z, act(Action::Redo)),
            (CTRL, Key::Y, act(Action::Redo)),
            (CTRL, Key::Z, act(Action::Undo)),
        ],
    },
    Binding {
        keys: "R",
        does: "read the files again",
        shortcuts: &[(NONE, Key::R, Command::Reload)],
    },
    Binding {
        keys: "N, Shift+N",
        does: "the next surface on the pick's ray, the one before",
        shortcuts: &[
            (SHIFT, Key::N, act(Action::Step { forward: false })),
            (NONE, Key::N, act(Action::Step { forward: true })),
        ],
    },
    Binding {
        keys: "Y",
        does: "the triangle under the pick, with its barycentrics",
        shortcuts: &[(NONE, Key::Y, act(Action::Toggle(Overlay::Triangle)))],
    },
    Binding {
        keys: "D",
        does: "the distance between the last two picks",
        shortcuts: &[(NONE, Key::D, act(Action::Toggle(Overlay::Distance)))],
    },
    Binding {
        keys: "W",
        does: "wireframe, of the selection or of everything",
        shortcuts: &[(NONE, Key::W, act(Action::Toggle(Overlay::Wireframe)))],
    },
    Binding {
        keys: "L",
        does: "normals of faces, of the selection or of everything",
        shortcuts: &[(NONE, Key::L, act(Action::Toggle(Overlay::Normals)))],
    },
    Binding {
        keys: "X",
        does: "bounding boxes, of the selection or of everything",
        shortcuts: &[(NONE, Key::X, act(Action::Toggle(Overlay::Boxes)))],
    },
    Binding {
        keys: "K, Shift+K",
        does: "boxes of the meshes' search trees: one level down, one up",
        shortcuts: &[
            (SHIFT, Key::K, act(Action::TreeLevel { deeper: false })),
            (NONE, Key::K, act(Action::TreeLevel { deeper: true })),
        ],
    },
    Binding {
        keys: "T",
        does: "freeze the camera: it stays as lines while you look around",
        shortcuts: &[(NONE, Key::T, act(Action::ToggleFreeze))],
    },
    Binding {
        keys: "4",
        does: "object, world, view and NDC side by side; the picture again",
        shortcuts: &[(NONE, Key::Num4, Command::ToggleFour)],
    },
    Binding {
        keys: "P",
        does: "the matrices, and the pick's way through them",
        shortcuts: &[(NONE, Key::P, Command::TogglePipeline)],
    },
    Binding {
        keys: "V",
        does: "compare drawn with picked, pixel by pixel",
        shortcuts: &[(NONE, Key::V, Command::ToggleCheck)],
    },
    Binding {
        keys: "E, Shift+E",
        does: "failure gallery: the next scene, the one before",
        shortcuts: &[
            (SHIFT, Key::E, Command::NextExhibit { forward: false }),
            (NONE, Key::E, Command::NextExhibit { forward: true }),
        ],
    },
    Binding {
        keys: "M, Shift+M",
        does: "in the gallery: pick by the next method, the one before",
        shortcuts: &[
            (SHIFT, Key::M, act(Action::NextMethod { forward: false })),
            (NONE, Key::M, act(Action::NextMethod { forward: true })),
        ],
    },
    Binding {
        keys: "Shift+C",
        does: "copy the camera; Ctrl+V applies a copied one",
        shortcuts: &[(SHIFT, Key::C, Command::CopyCamera)],
    },
    Binding {
        keys: "F12, Shift+F12",
        does: "save what is on screen as a PNG file; the picture alone",
        shortcuts: &[
            (SHIFT, Key::F12, Command::Screenshot { alone: true }),
            (NONE, Key::F12, Command::Screenshot { alone: false }),
        ],
    },
    Binding {
        keys: "F11",
        does: "full screen, and back",
        shortcuts: &[(NONE, Key::F11, Command::ToggleFullScreen)],
    },
    Binding {
        keys: "C",
        does: "copy a command that repeats the pick; no pick: the view",
        shortcuts: &[(NONE, Key::C, Command::CopyCommandLine)],
    },
    Binding {
        keys: "J",
        does: "copy the pick as JSON",
        shortcuts: &[(NONE, Key::J, Command::CopyPick)],
    },
    Binding {
        keys: "Esc",
        does: "cancel, close, deselect, leave the gallery",
        shortcuts: &[(NONE, Key::Escape, Command::Escape)],
    },
    Binding {
        keys: "H, ?",
        does: "this help",
        shortcuts: &[
            (NONE, Key::H, Command::ToggleHelp),
            (SHIFT, Key::Questionmark, Command::ToggleHelp),
            (NONE, Key::Questionmark, Command::ToggleHelp),
        ],
    },
    Binding {
        keys: "Ctrl+Q",
        does: "quit",
        shortcuts: &[(CTRL, Key::Q, Command::Quit)],
    },
];

/// What the mouse does, for the help.
pub(in crate::viewer) const MOUSE: &[(&str, &str)] = &[
    ("left drag", "orbit about the point under the cursor"),
    (
        "Ctrl+left drag",
        "turn the scene's camera, also from one of the four views",
    ),
    ("right, middle, Shift+left drag", "pan"),
    ("wheel, pinch", "zoom at the cursor"),
    ("click", "pick; the same pixel again: the surface behind"),
    ("right click", "a menu for what is under the cursor"),
    (
        "double click",
        "centre the point, turn about it; on nothing: frame all",
    ),
    (
        "click on the cross of axes",
        "look along an axis, from the end that is clicked",
    ),
    (
        "drag the section's arrow",
        "move the plane along its normal",
    ),
];

const fn act(action: Action) -> Command {
    Command::Act(action)
}

const fn look(to_eye: DVec3) -> Command {
    act(Action::LookFrom(to_eye))
}

/// Takes Esc, which closed a menu and does nothing else then.
pub(in crate::viewer) fn take_escape(ctx: &egui::Context) {
    ctx.input_mut(|input| input.consume_key(NONE, Key::Escape));
}

/// The commands of the keys that were pressed. While a text is edited, only Ctrl+O, Ctrl+S and Ctrl+Q count, and none
/// while a question waits for an answer. While a question waits and no text is edited, only Esc counts. A focused
/// control gets Enter, Esc and the arrows. If none has the focus, Esc first gives up texts that are shown in red.
pub(in crate::viewer) fn pressed(ctx: &egui::Context, has_question: bool) -> Vec<Command> {
    let focus = Focus::of_pass(ctx);
    if focus.types {
        return if has_question {
            Vec::new()
        } else {
            pressed_among(ctx, |modifiers, _, command| {
                modifiers == CTRL && command.ends_typing()
            })
        };
    }
    if has_question {
        let escapes = ctx.input_mut(|input| input.count_and_consume_key(NONE, Key::Escape));
        return vec![Command::Escape; escapes.min(1)];
    }
    if !focus.any && ctx.input(|input| input.key_pressed(Key::Escape)) && give_up_refused(ctx) {
        take_escape(ctx);
    }
    let is_taken = |key: Key| {
        focus.any
            && matches!(
                key,
                Key::Enter | Key::Escape | Key::ArrowUp | Key::ArrowDown
            )
    };
    let mut asked = pressed_among(ctx, |_, key, _| !is_taken(key));
    ctx.input(|input| {
        asked.extend(input.events.iter().filter_map(|event| match event {
            Event::Paste(text) => Some(Command::Paste(text.clone())),
            _ => None,
        }));
    });
    asked
}

/// The commands of those shortcuts that were pressed and that `counts` lets through.
fn pressed_among(
    ctx: &egui::Context,
    counts: impl Fn(Modifiers, Key, &Command) -> bool,
) -> Vec<Command> {
    let shortcuts = BINDINGS.iter().flat_map(|binding| binding.shortcuts);
    let shortcuts = shortcuts.filter(|(modifiers, key, command)| counts(*modifiers, *key, command));
    ctx.input_mut(|input| {
        let asked = shortcuts.flat_map(|(modifiers, key, command)| {
            // A key that was pressed twice within a slow frame acts twice.
            let times = input.count_and_consume_key(*modifiers, *key);
            iter::repeat_n(command.clone(), times)
        });
        asked.collect()
    })
}
