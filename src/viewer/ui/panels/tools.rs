//! What the toolbar offers, in groups, and its menus.

use super::{
    exhibit,
    hints::{Hint, named},
    shown::Shown,
};
use crate::viewer::{
    jobs::Checking,
    model::{Action, Overlay, State},
    ui::command::Command,
};
use egui::{Button, Ui};
use glam::DVec3;
use std::path::PathBuf;

/// A button of the toolbar.
pub(super) struct Tool {
    /// A glyph of the panels' own fonts.
    pub icon: &'static str,
    pub name: &'static str,
    /// What screen readers call it: its name, unless another control has that.
    pub called: &'static str,
    /// What it does, and its key.
    pub hint: String,
    /// Whether what it switches is on; `None` if it switches nothing.
    pub is_on: Option<bool>,
    pub enabled: bool,
    pub does: Does,
}

/// What a click on a tool does.
#[expect(
    clippy::large_enum_variant,
    reason = "few at a time, and a camera is most of one"
)]
pub(super) enum Does {
    Ask(Command),
    Open(Menu),
}

/// A menu of the toolbar.
#[derive(Clone, Copy)]
pub(super) enum Menu {
    Recent,
    Views,
    Overlays,
    Gallery,
}

impl Tool {
    /// The same tool as a switch that is on or off.
    fn switched(self, on: bool) -> Self {
        Self {
            is_on: Some(on),
            ..self
        }
    }
}

fn tool(icon: &'static str, name: &'static str, hint: impl Into<String>, does: Does) -> Tool {
    Tool {
        icon,
        name,
        called: name,
        hint: hint.into(),
        is_on: None,
        enabled: true,
        does,
    }
}

/// A button that asks for a command.
fn ask(icon: &'static str, name: &'static str, hint: impl Into<String>, command: Command) -> Tool {
    tool(icon, name, hint, Does::Ask(command))
}

fn act(icon: &'static str, name: &'static str, hint: &str, action: Action) -> Tool {
    ask(icon, name, hint, Command::Act(action))
}

/// All tools, by group.
pub(super) fn groups(shown: &Shown) -> Vec<Vec<Tool>> {
    let state = shown.state;
    vec![
        files(),
        steps(state),
        looking(),
        showing(state),
        learning(shown),
    ]
}

fn files() -> Vec<Tool> {
    vec![
        ask(
            "\u{1f4c2}",
            "Open\u{2026}",
            "OBJ and scene files (Ctrl+O); or drop them on the window",
            Command::OpenDialog,
        ),
        tool(
            "\u{1f553}",
            "Recent",
            "scenes that were opened before",
            Does::Open(Menu::Recent),
        ),
        ask(
            "\u{1f4be}",
            "Save\u{2026}",
            "as a scene file (Ctrl+S)",
            Command::SaveDialog,
        ),
        ask(
            "\u{27f3}",
            "Reload",
            "read the files again (R)",
            Command::Reload,
        ),
    ]
}

fn steps(state: &State) -> Vec<Tool> {
    let step = |icon, name, back: bool, key: &str| {
        let step = state.next_step(back);
        let action = if back { Action::Undo } else { Action::Redo };
        let hint = format!("{} ({key})", step.unwrap_or("nothing"));
        Tool {
            enabled: step.is_some(),
            ..ask(icon, name, hint, Command::Act(action))
        }
    };
    vec![
        step("\u{21a9}", "Undo", true, "Ctrl+Z"),
        step("\u{21aa}", "Redo", false, "Ctrl+Shift+Z, Ctrl+Y"),
    ]
}

fn looking() -> Vec<Tool> {
    vec![
        act(
            "\u{26f6}",
            "Frame all",
            "move the camera until all of the scene is in view (A)",
            Action::FrameAll,
        ),
        act(
            "\u{1f3af}",
            "Frame selection",
            "move the camera until the selected object fills the view (F)",
            Action::FrameSelection,
        ),
        tool(
            "\u{1f3a5}",
            "Views",
            "look along an axis of the world",
            Does::Open(Menu::Views),
        ),
        act(
            "\u{1f3e0}",
            "Reset",
            "the view that the scene opened with (Enter)",
            Action::ResetView,
        ),
    ]
}

fn showing(state: &State) -> Vec<Tool> {
    let freeze = act(
        "\u{2744}",
        "Freeze",
        "leave a copy of this camera in the scene, with the pick's ray, and look at it from elsewhere (T)",
        Action::ToggleFreeze,
    );
    vec![
        act(
            "\u{25a6}",
            "Grid",
            "with axes: x red, y green, z blue (G)",
            Action::ToggleGrid,
        )
        .switched(state.grid()),
        Tool {
            enabled: state.stages().is_empty(),
            ..freeze.switched(state.frozen().is_some())
        },
        tool(
            "\u{25f0}",
            "Overlays",
            "lines over the scene: triangles, normals, boxes",
            Does::Open(Menu::Overlays),
        ),
    ]
}

fn learning(shown: &Shown) -> Vec<Tool> {
    let matrices = ask(
        "\u{25a4}",
        "Matrices",
        "the matrices P, V and M, and the pick on its way through them (P)",
        Command::TogglePipeline,
    );
    vec![
        ask(
            "\u{229e}",
            "Four views",
            "object, world, view and NDC side by side, all live (4)",
            Command::ToggleFour,
        )
        .switched(!shown.state.stages().is_empty()),
        // The panel's heading is called "Matrices".
        Tool {
            called: "Matrices panel",
            ..matrices.switched(shown.floating.pipeline)
        },
        ask(
            "\u{2714}",
            "Compare",
            "compare each pixel as drawn with what a click there picks (V)",
            Command::ToggleCheck,
        )
        .switched(!matches!(shown.checking, Checking::Off)),
        tool(
            "\u{1f5bc}",
            "Gallery",
            "scenes on which known methods break (E: the next, Shift+E: the one before)",
            Does::Open(Menu::Gallery),
        ),
        ask(
            "\u{2600}",
            "Look",
            format!("dark or light panels; now: {}", shown.look.about()),
            Command::NextLook,
        ),
        ask(
            "\u{2753}",
            "Help",
            "keys and mouse (H)",
            Command::ToggleHelp,
        )
        .switched(shown.floating.help),
    ]
}

/// Shows what a menu holds.
pub(super) fn open(ui: &mut Ui, shown: &Shown, menu: Menu, commands: &mut Vec<Command>) {
    let state = shown.state;
    match menu {
        Menu::Recent => recent(ui, shown.recent, commands),
        Menu::Views => views(ui, commands),
        Menu::Overlays => {
            for which in Overlay::ALL {
                overlay(ui, state, which, commands);
            }
            tree_level(ui, state, commands);
        }
        Menu::Gallery => exhibit::menu(ui, state, commands),
    }
}

/// Scenes that were opened before.
fn recent(ui: &mut Ui, recent: &[Vec<PathBuf>], commands: &mut Vec<Command>) {
    if recent.is_empty() {
        ui.weak("nothing yet")
            .hint("files that you open are offered here");
    }
    for paths in recent {
        let names: Vec<_> = (paths.iter().filter_map(|path| path.file_name()))
            .map(|name| name.to_string_lossy())
            .collect();
        let whole: Vec<_> = paths
            .iter()
            .map(|path| path.display().to_string())
            .collect();
        if ui
            .button(names.join(" + "))
            .hint(whole.join("\n"))
            .clicked()
        {
            commands.push(Command::Open(paths.clone()));
        }
    }
}

fn views(ui: &mut Ui, commands: &mut Vec<Command>) {
    for (name, key, to_eye) in [
        ("Front", "1", DVec3::Z),
        ("Back", "Ctrl+1", DVec3::NEG_Z),
        ("Right", "3", DVec3::X),
        ("Left", "Ctrl+3", DVec3::NEG_X),
        ("Top", "7", DVec3::Y),
        ("Bottom", "Ctrl+7", DVec3::NEG_Y),
        ("Corner", "9", DVec3::ONE),
    ] {
        let button = ui.add(Button::new(name).shortcut_text(key));
        named(&button, name);
        let hint = "look at the scene from there";
        if button.hint(hint).clicked() {
            commands.push(Command::Act(Action::LookFrom(to_eye)));
        }
    }
}

/// Which level of the trees over meshes shows.
fn tree_level(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    ui.horizontal(|ui| {
        let level = state.overlays().tree_level;
        let shown = level.map_or("off".to_owned(), |level| level.to_string());
        let hint = "boxes of the meshes' search trees (BVH); small meshes have none; level 0 is the box around a mesh";
        ui.label(format!("tree level: {shown}")).hint(hint);
        for (name, deeper, hint) in [("\u{2212}", false, "(Shift+K)"), ("+", true, "(K)")] {
            let button = ui.small_button(name).hint(hint);
            named(&button, if deeper { "one level down" } else { "one level up" });
            if button.clicked() {
                commands.push(Command::Act(Action::TreeLevel { deeper }));
            }
        }
    });
}

/// A checkbox that shows an overlay.
pub(super) fn overlay(ui: &mut Ui, state: &State, which: Overlay, commands: &mut Vec<Command>) {
    let [name, key, hint] = which.about();
    let mut shows = state.overlays().shows(which);
    let hint = format!("{hint} ({key})");
    if ui.checkbox(&mut shows, name).hint(hint).changed() {
        commands.push(Command::Act(Action::Toggle(which)));
    }
}
