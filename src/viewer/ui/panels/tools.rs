//! What the toolbar offers, in groups, and its menus.

use super::{exhibit, prelude::*, shown::Shown};
use crate::viewer::{jobs::Checking, model::Overlay};

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

/// Shows what a menu of the toolbar holds.
type Menu = fn(&mut Ui, &Shown, &mut Vec<Command>);

impl Tool {
    /// The same tool as a switch that is on or off.
    fn switched(self, on: bool) -> Self {
        let is_on = Some(on);
        Self { is_on, ..self }
    }

    fn enabled(self, enabled: bool) -> Self {
        Self { enabled, ..self }
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
fn ask(
    icon: &'static str,
    name: &'static str,
    hint: impl Into<String>,
    command: impl Into<Command>,
) -> Tool {
    tool(icon, name, hint, Does::Ask(command.into()))
}

/// A button that opens a menu.
fn menu(icon: &'static str, name: &'static str, hint: &str, opens: Menu) -> Tool {
    tool(icon, name, hint, Does::Open(opens))
}

/// All tools, by group.
pub(super) fn groups(shown: &Shown) -> [Vec<Tool>; 5] {
    let state = shown.state;
    [
        files(),
        steps(state),
        looking(),
        showing(state),
        learning(shown),
    ]
}

fn files() -> Vec<Tool> {
    let hint = "OBJ and scene files (Ctrl+O); or drop them on the window";
    let open = ask("\u{1f4c2}", "Open\u{2026}", hint, Command::OpenDialog);
    let hint = "scenes that were opened before";
    let recent = menu("\u{1f553}", "Recent", hint, recent);
    let hint = "as a scene file (Ctrl+S)";
    let save = ask("\u{1f4be}", "Save\u{2026}", hint, Command::SaveDialog);
    let hint = "read the files again (R)";
    let reload = ask("\u{27f3}", "Reload", hint, Command::Reload);
    vec![open, recent, save, reload]
}

fn steps(state: &State) -> Vec<Tool> {
    let step = |icon, name, back: bool, key: &str| {
        let step = state.next_step(back);
        let action = if back { Action::Undo } else { Action::Redo };
        let hint = format!("{} ({key})", step.unwrap_or("nothing"));
        ask(icon, name, hint, action).enabled(step.is_some())
    };
    vec![
        step("\u{21a9}", "Undo", true, "Ctrl+Z"),
        step("\u{21aa}", "Redo", false, "Ctrl+Shift+Z, Ctrl+Y"),
    ]
}

fn looking() -> Vec<Tool> {
    let hint = "move the camera until all of the scene is in view (A)";
    let all = ask("\u{26f6}", "Frame all", hint, Action::FrameAll);
    let hint = "move the camera until the selected object fills the view (F)";
    let selection = ask("\u{1f3af}", "Frame selection", hint, Action::FrameSelection);
    let hint = "look along an axis of the world";
    let views = menu("\u{1f3a5}", "Views", hint, views);
    let hint = "the view that the scene opened with (Enter)";
    let reset = ask("\u{1f3e0}", "Reset", hint, Action::ResetView);
    vec![all, selection, views, reset]
}

fn showing(state: &State) -> Vec<Tool> {
    let hint = "with axes: x red, y green, z blue (G)";
    let grid = ask("\u{25a6}", "Grid", hint, Action::ToggleGrid);
    let hint = "leave a copy of this camera in the scene, with the pick's ray, and look at it from elsewhere (T)";
    let freeze = ask("\u{2744}", "Freeze", hint, Action::ToggleFreeze);
    let freeze = freeze.switched(state.frozen().is_some());
    let hint = "lines over the scene: triangles, normals, boxes";
    vec![
        grid.switched(state.grid()),
        freeze.enabled(state.stages().is_empty()),
        menu("\u{25f0}", "Overlays", hint, overlays),
    ]
}

fn learning(shown: &Shown) -> Vec<Tool> {
    let hint = "object, world, view and NDC side by side, all live (4)";
    let four = ask("\u{229e}", "Four views", hint, Command::ToggleFour);
    let hint = "the matrices P, V and M, and the pick on its way through them (P)";
    let matrices = ask("\u{25a4}", "Matrices", hint, Command::TogglePipeline);
    let matrices = Tool {
        // The panel's heading is called "Matrices".
        called: "Matrices panel",
        ..matrices
    };
    let hint = "compare each pixel as drawn with what a click there picks (V)";
    let compare = ask("\u{2714}", "Compare", hint, Command::ToggleCheck);
    let hint = "scenes on which known methods break (E: the next, Shift+E: the one before)";
    let gallery = menu("\u{1f5bc}", "Gallery", hint, exhibit::menu);
    let hint = format!("dark or light panels; now: {}", shown.look.about());
    let look = ask("\u{2600}", "Look", hint, Command::NextLook);
    let hint = "keys and mouse (H)";
    let help = ask("\u{2753}", "Help", hint, Command::ToggleHelp);
    vec![
        four.switched(!shown.state.stages().is_empty()),
        matrices.switched(shown.docks.shows_matrices(shown.floating.pipeline)),
        compare.switched(!matches!(shown.checking, Checking::Off)),
        gallery,
        look,
        help.switched(shown.floating.help),
    ]
}

/// Scenes that were opened before.
fn recent(ui: &mut Ui, shown: &Shown, commands: &mut Vec<Command>) {
    if shown.recent.is_empty() {
        ui.weak("nothing yet")
            .hint("files that you open are offered here");
    }
    for paths in shown.recent {
        let names = paths.iter().filter_map(|path| path.file_name());
        let names: Vec<_> = names.map(|name| name.to_string_lossy()).collect();
        let whole = paths.iter().map(|path| path.display().to_string());
        let whole: Vec<_> = whole.collect();
        let open = ui.button(names.join(" + "));
        if open.hint(whole.join("\n")).clicked() {
            commands.push(Command::Open(paths.clone()));
        }
    }
}

fn views(ui: &mut Ui, _: &Shown, commands: &mut Vec<Command>) {
    for (name, key, to_eye) in [
        ("Front", "1", DVec3::Z),
        ("Back", "Ctrl+1", DVec3::NEG_Z),
        ("Right", "3", DVec3::X),
        ("Left", "Ctrl+3", DVec3::NEG_X),
        ("Top", "7", DVec3::Y),
        ("Bottom", "Ctrl+7", DVec3::NEG_Y),
        ("Corner", "9", DVec3::ONE),
    ] {
        let button = ui.add(Button::new(name).shortcut_text(key)).named(name);
        let hint = "look at the scene from there";
        button.asks(hint, Action::LookFrom(to_eye), commands);
    }
}

fn overlays(ui: &mut Ui, shown: &Shown, commands: &mut Vec<Command>) {
    for which in Overlay::ALL {
        overlay(ui, shown.state, which, commands);
    }
    tree_level(ui, shown.state, commands);
}

/// Which level of the trees over meshes shows.
fn tree_level(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    ui.horizontal(|ui| {
        let level = state.overlays().tree_level;
        let shown = level.map_or("off".to_owned(), |level| level.to_string());
        let hint = "boxes of the search trees (BVH) of the selection's whole mesh, or of all; small meshes have none; level 0 is the box around a mesh";
        ui.label(format!("tree level: {shown}")).hint(hint);
        for (icon, deeper, name, hint) in [
            ("\u{2212}", false, "one level up", "(Shift+K)"),
            ("+", true, "one level down", "(K)"),
        ] {
            let button = ui.small_button(icon).named(name);
            button.asks(hint, Action::TreeLevel { deeper }, commands);
        }
    });
}

/// A checkbox that shows an overlay.
pub(super) fn overlay(ui: &mut Ui, state: &State, which: Overlay, commands: &mut Vec<Command>) {
    let [name, key, hint] = which.about();
    let mut shows = state.overlays().shows(which);
    let toggle = ui.checkbox(&mut shows, name);
    toggle.asks(format!("{hint} ({key})"), Action::Toggle(which), commands);
}
