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
const CTRL_SHIFT: Modifiers = CTRL.plus(SHIFT);

/// The bindings: in each row keys, what they do, and each shortcut with what it asks for.
macro_rules! bindings {
    ($($keys:literal, $does:literal: $($modifiers:ident $key:ident => $command:expr),+;)+) => {
        &[$(Binding {
            keys: $keys,
            does: $does,
            shortcuts: &[$(($modifiers, Key::$key, $command)),+],
        }),+]
    };
}

/// Every key, in the order of the help. A shortcut with Shift stands before the one without, which would match both.
pub(in crate::viewer) const BINDINGS: &[Binding] = bindings! {
    "F", "frame the selection": NONE F => act(Action::FrameSelection);
    "A, Home", "frame all": NONE A => act(Action::FrameAll), NONE Home => act(Action::FrameAll);
    "Enter", "the view that the scene opened with": NONE Enter => act(Action::ResetView);
    "1, Ctrl+1", "front, back": NONE Num1 => look(DVec3::Z), CTRL Num1 => look(DVec3::NEG_Z);
    "3, Ctrl+3", "right, left": NONE Num3 => look(DVec3::X), CTRL Num3 => look(DVec3::NEG_X);
    "7, Ctrl+7", "top, bottom": NONE Num7 => look(DVec3::Y), CTRL Num7 => look(DVec3::NEG_Y);
    "9", "from the corner": NONE Num9 => look(DVec3::ONE);
    "5", "perspective, orthographic": NONE Num5 => act(Action::ToggleProjection);
    "B", "back faces": NONE B => act(Action::ToggleSides);
    "Z", "section": NONE Z => act(Action::ToggleSection);
    "G", "grid and axes": NONE G => act(Action::ToggleGrid);
    "Shift+H", "hide the selection": SHIFT H => act(Action::HideSelection);
    "I", "hide all but the selection": NONE I => act(Action::Isolate);
    "U", "show all": NONE U => act(Action::ShowAll);
    "Down, Up", "in the list of objects: select the next, the one before":
        NONE ArrowUp => Command::SelectRow { down: false }, NONE ArrowDown => Command::SelectRow { down: true };
    "Ctrl+O", "open files": CTRL O => Command::OpenDialog;
    "Ctrl+S", "save as a scene file": CTRL S => Command::SaveDialog;
    "Ctrl+Z, Ctrl+Shift+Z, Ctrl+Y", "undo; redo (either key)":
        CTRL_SHIFT Z => act(Action::Redo), CTRL Y => act(Action::Redo), CTRL Z => act(Action::Undo);
    "R", "read the files again": NONE R => Command::Reload;
    "N, Shift+N", "the next surface on the pick's ray, the one before":
        SHIFT N => act(Action::Step { forward: false }), NONE N => act(Action::Step { forward: true });
    "Y", "the triangle under the pick, with its barycentrics": NONE Y => act(Action::Toggle(Overlay::Triangle));
    "D", "the distance between the last two picks": NONE D => act(Action::Toggle(Overlay::Distance));
    "W", "wireframe, of the selection or of everything": NONE W => act(Action::Toggle(Overlay::Wireframe));
    "L", "normals of faces, of the selection or of everything": NONE L => act(Action::Toggle(Overlay::Normals));
    "X", "bounding boxes, of the selection or of everything": NONE X => act(Action::Toggle(Overlay::Boxes));
    "K, Shift+K", "boxes of search trees, of the selection's mesh or of all: one level down, up":
        SHIFT K => act(Action::TreeLevel { deeper: false }), NONE K => act(Action::TreeLevel { deeper: true });
    "T", "freeze the camera: it stays as lines while you look around": NONE T => act(Action::ToggleFreeze);
    "4", "object, world, view and NDC side by side; the picture again": NONE Num4 => Command::ToggleFour;
    "P", "the matrices, and the pick's way through them": NONE P => Command::TogglePipeline;
    "V", "compare drawn with picked, pixel by pixel": NONE V => Command::ToggleCheck;
    "E, Shift+E", "failure gallery: the next scene, the one before":
        SHIFT E => Command::NextExhibit { forward: false }, NONE E => Command::NextExhibit { forward: true };
    "M, Shift+M", "in the gallery: pick by the next method, the one before":
        SHIFT M => act(Action::NextMethod { forward: false }), NONE M => act(Action::NextMethod { forward: true });
    "Shift+C", "copy the camera; Ctrl+V applies a copied one": SHIFT C => Command::CopyCamera;
    "F12, Shift+F12", "save what is on screen as a PNG file; the picture alone":
        SHIFT F12 => Command::Screenshot { alone: true }, NONE F12 => Command::Screenshot { alone: false };
    "F11", "full screen, and back": NONE F11 => Command::ToggleFullScreen;
    "C", "copy a command that repeats the pick; no pick: the view": NONE C => Command::CopyCommandLine;
    "J", "copy the pick as JSON": NONE J => Command::CopyPick;
    "Esc", "cancel, close, deselect, leave the gallery": NONE Escape => Command::Escape;
    "H, F1, ?", "this help":
        NONE H => Command::ToggleHelp,
        NONE F1 => Command::ToggleHelp,
        SHIFT Questionmark => Command::ToggleHelp,
        NONE Questionmark => Command::ToggleHelp;
    "Ctrl+Q", "quit": CTRL Q => Command::Quit;
};

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
