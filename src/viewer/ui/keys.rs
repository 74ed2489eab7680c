//! Keys to commands, in one table that the help is made from.

use super::{command::Command, focus::Focus, panels::give_up_refused};
use crate::viewer::model::{Action, Overlay};
use egui::{Event, Key, Modifiers};
use glam::DVec3;

/// A key and what it does.
pub(in crate::viewer) struct Binding {
    /// As the help writes it.
    pub keys: &'static str,
    /// What it does, for the help.
    pub does: &'static str,
    /// Any of these triggers it.
    pub shortcuts: &'static [(Modifiers, Key)],
    /// What it asks for.
    pub command: Command,
}

const NONE: Modifiers = Modifiers::NONE;
const SHIFT: Modifiers = Modifiers::SHIFT;
const CTRL: Modifiers = Modifiers::COMMAND;

/// Every key, in the order of the help. A shortcut with Shift stands before the one without, which would match both.
pub(in crate::viewer) const BINDINGS: &[Binding] = &[
    Binding {
        keys: "F",
        does: "frame the selection",
        shortcuts: &[(NONE, Key::F)],
        command: Command::Act(Action::FrameSelection),
    },
    Binding {
        keys: "A, Home",
        does: "frame all",
        shortcuts: &[(NONE, Key::A), (NONE, Key::Home)],
        command: Command::Act(Action::FrameAll),
    },
    Binding {
        keys: "Enter",
        does: "the view that the scene opened with",
        shortcuts: &[(NONE, Key::Enter)],
        command: Command::Act(Action::ResetView),
    },
    Binding {
        keys: "1, Ctrl+1",
        does: "front, back",
        shortcuts: &[(NONE, Key::Num1)],
        command: look(DVec3::Z),
    },
    Binding {
        keys: "",
        does: "",
        shortcuts: &[(CTRL, Key::Num1)],
        command: look(DVec3::NEG_Z),
    },
    Binding {
        keys: "3, Ctrl+3",
        does: "right, left",
        shortcuts: &[(NONE, Key::Num3)],
        command: look(DVec3::X),
    },
    Binding {
        keys: "",
        does: "",
        shortcuts: &[(CTRL, Key::Num3)],
        command: look(DVec3::NEG_X),
    },
    Binding {
        keys: "7, Ctrl+7",
        does: "top, bottom",
        shortcuts: &[(NONE, Key::Num7)],
        command: look(DVec3::Y),
    },
    Binding {
        keys: "",
        does: "",
        shortcuts: &[(CTRL, Key::Num7)],
        command: look(DVec3::NEG_Y),
    },
    Binding {
        keys: "9",
        does: "from the corner",
        shortcuts: &[(NONE, Key::Num9)],
        command: look(DVec3::ONE),
    },
    Binding {
        keys: "5",
        does: "perspective, orthographic",
        shortcuts: &[(NONE, Key::Num5)],
        command: Command::Act(Action::ToggleProjection),
    },
    Binding {
        keys: "B",
        does: "back faces",
        shortcuts: &[(NONE, Key::B)],
        command: Command::Act(Action::ToggleSides),
    },
    Binding {
        keys: "Z",
        does: "section",
        shortcuts: &[(NONE, Key::Z)],
        command: Command::Act(Action::ToggleSection),
    },
    Binding {
        keys: "G",
        does: "grid and axes",
        shortcuts: &[(NONE, Key::G)],
        command: Command::Act(Action::ToggleGrid),
    },
    Binding {
        keys: "Shift+H",
        does: "hide the selection",
        shortcuts: &[(SHIFT, Key::H)],
        command: Command::Act(Action::HideSelection),
    },
    Binding {
        keys: "I",
        does: "hide all but the selection",
        shortcuts: &[(NONE, Key::I)],
        command: Command::Act(Action::Isolate),
    },
    Binding {
        keys: "U",
        does: "show all",
        shortcuts: &[(NONE, Key::U)],
        command: Command::Act(Action::ShowAll),
    },
    Binding {
        keys: "",
        does: "",
        shortcuts: &[(NONE, Key::ArrowUp)],
        command: Command::SelectRow { down: false },
    },
    Binding {
        keys: "Down, Up",
        does: "in the list of objects: select the next, the one before",
        shortcuts: &[(NONE, Key::ArrowDown)],
        command: Command::SelectRow { down: true },
    },
    Binding {
        keys: "Ctrl+O",
        does: "open files",
        shortcuts: &[(CTRL, Key::O)],
        command: Command::OpenDialog,
    },
    Binding {
        keys: "Ctrl+S",
        does: "save as a scene file",
        shortcuts: &[(CTRL, Key::S)],
        command: Command::SaveDialog,
    },
    Binding {
        keys: "",
        does: "",
        shortcuts: &[(CTRL.plus(SHIFT), Key::Z), (CTRL, Key::Y)],
        command: Command::Act(Action::Redo),
    },
    Binding {
        keys: "Ctrl+Z, Ctrl+Shift+Z, Ctrl+Y",
        does: "undo; the others redo",
        shortcuts: &[(CTRL, Key::Z)],
        command: Command::Act(Action::Undo),
    },
    Binding {
        keys: "R",
        does: "read the files again",
        shortcuts: &[(NONE, Key::R)],
        command: Command::Reload,
    },
    Binding {
        keys: "",
        does: "",
        shortcuts: &[(SHIFT, Key::N)],
        command: Command::Act(Action::Step { forward: false }),
    },
    Binding {
        keys: "N, Shift+N",
        does: "the next surface on the pick's ray, the one before",
        shortcuts: &[(NONE, Key::N)],
        command: Command::Act(Action::Step { forward: true }),
    },
    Binding {
        keys: "Y",
        does: "the triangle under the pick, with its barycentrics",
        shortcuts: &[(NONE, Key::Y)],
        command: Command::Act(Action::Toggle(Overlay::Triangle)),
    },
    Binding {
        keys: "D",
        does: "the distance between the last two picks",
        shortcuts: &[(NONE, Key::D)],
        command: Command::Act(Action::Toggle(Overlay::Distance)),
    },
    Binding {
        keys: "W",
        does: "wireframe, of the selection or of everything",
        shortcuts: &[(NONE, Key::W)],
        command: Command::Act(Action::Toggle(Overlay::Wireframe)),
    },
    Binding {
        keys: "L",
        does: "normals of faces, of the selection or of everything",
        shortcuts: &[(NONE, Key::L)],
        command: Command::Act(Action::Toggle(Overlay::Normals)),
    },
    Binding {
        keys: "X",
        does: "bounding boxes, of the selection or of everything",
        shortcuts: &[(NONE, Key::X)],
        command: Command::Act(Action::Toggle(Overlay::Boxes)),
    },
    Binding {
        keys: "",
        does: "",
        shortcuts: &[(SHIFT, Key::K)],
        command: Command::Act(Action::TreeLevel { deeper: false }),
    },
    Binding {
        keys: "K, Shift+K",
        does: "boxes of the meshes' trees: a level deeper, less deep",
        shortcuts: &[(NONE, Key::K)],
        command: Command::Act(Action::TreeLevel { deeper: true }),
    },
    Binding {
        keys: "T",
        does: "freeze the camera: it stays as lines while you look around",
        shortcuts: &[(NONE, Key::T)],
        command: Command::Act(Action::ToggleFreeze),
    },
    Binding {
        keys: "4",
        does: "object, world, view and NDC side by side; the picture again",
        shortcuts: &[(NONE, Key::Num4)],
        command: Command::ToggleFour,
    },
    Binding {
        keys: "P",
        does: "the matrices, and the pick's way through them",
        shortcuts: &[(NONE, Key::P)],
        command: Command::TogglePipeline,
    },
    Binding {
        keys: "V",
        does: "compare drawn with picked, pixel by pixel",
        shortcuts: &[(NONE, Key::V)],
        command: Command::ToggleCheck,
    },
    Binding {
        keys: "",
        does: "",
        shortcuts: &[(SHIFT, Key::E)],
        command: Command::NextExhibit { forward: false },
    },
    Binding {
        keys: "E, Shift+E",
        does: "failure gallery: the next scene, the one before",
        shortcuts: &[(NONE, Key::E)],
        command: Command::NextExhibit { forward: true },
    },
    Binding {
        keys: "",
        does: "",
        shortcuts: &[(SHIFT, Key::M)],
        command: Command::Act(Action::NextMethod { forward: false }),
    },
    Binding {
        keys: "M, Shift+M",
        does: "in the gallery: pick by the next method, the one before",
        shortcuts: &[(NONE, Key::M)],
        command: Command::Act(Action::NextMethod { forward: true }),
    },
    Binding {
        keys: "Shift+C",
        does: "copy the camera; Ctrl+V takes over a copied one",
        shortcuts: &[(SHIFT, Key::C)],
        command: Command::CopyCamera,
    },
    Binding {
        keys: "",
        does: "",
        shortcuts: &[(SHIFT, Key::F12)],
        command: Command::Screenshot { alone: true },
    },
    Binding {
        keys: "F12, Shift+F12",
        does: "save what is on screen as a PNG file; the picture alone",
        shortcuts: &[(NONE, Key::F12)],
        command: Command::Screenshot { alone: false },
    },
    Binding {
        keys: "F11",
        does: "full screen, and back",
        shortcuts: &[(NONE, Key::F11)],
        command: Command::ToggleFullScreen,
    },
    Binding {
        keys: "C",
        does: "copy the pick in its view as a command, else the view",
        shortcuts: &[(NONE, Key::C)],
        command: Command::CopyCommandLine,
    },
    Binding {
        keys: "J",
        does: "copy the pick as JSON",
        shortcuts: &[(NONE, Key::J)],
        command: Command::CopyPick,
    },
    Binding {
        keys: "Esc",
        does: "stop waiting or loading, close, select nothing, leave gallery",
        shortcuts: &[(NONE, Key::Escape)],
        command: Command::Escape,
    },
    Binding {
        keys: "H, ?",
        does: "this help",
        shortcuts: &[
            (NONE, Key::H),
            (SHIFT, Key::Questionmark),
            (NONE, Key::Questionmark),
        ],
        command: Command::ToggleHelp,
    },
    Binding {
        keys: "Ctrl+Q",
        does: "quit",
        shortcuts: &[(CTRL, Key::Q)],
        command: Command::Quit,
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
        "set pivot and centre; on nothing: frame all",
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

const fn look(to_eye: DVec3) -> Command {
    Command::Act(Action::LookFrom(to_eye))
}

/// The commands of the keys that were pressed: none while a text is edited, only Esc's while a question waits for an answer.
/// A focused control has Enter, Esc and the arrows to itself. Without one, Esc gives up red texts first.
pub(in crate::viewer) fn pressed(ctx: &egui::Context, is_asked: bool) -> Vec<Command> {
    let now = Focus::now(ctx);
    let focus = Focus::before(ctx).or(now);
    now.keep(ctx);
    if focus.types {
        return Vec::new();
    }
    if is_asked {
        let escapes = ctx.input_mut(|input| input.count_and_consume_key(NONE, Key::Escape));
        return vec![Command::Escape; escapes.min(1)];
    }
    if !focus.any && ctx.input(|input| input.key_pressed(Key::Escape)) && give_up_refused(ctx) {
        ctx.input_mut(|input| input.consume_key(NONE, Key::Escape));
    }
    let is_taken = |key: Key| {
        focus.any
            && matches!(
                key,
                Key::Enter | Key::Escape | Key::ArrowUp | Key::ArrowDown
            )
    };
    ctx.input_mut(|input| {
        let mut asked = Vec::new();
        for binding in BINDINGS {
            // What was pressed twice within a slow frame is done twice.
            let times = (binding.shortcuts.iter().filter(|(_, key)| !is_taken(*key)))
                .map(|(modifiers, key)| input.count_and_consume_key(*modifiers, *key))
                .sum();
            asked.extend(std::iter::repeat_n(binding.command.clone(), times));
        }
        asked.extend(input.events.iter().filter_map(|event| match event {
            Event::Paste(text) => Some(Command::Paste(text.clone())),
            _ => None,
        }));
        asked
    })
}
