//! The menu of the right mouse button: what can be done with what is under the cursor.

use super::names::{Hint, named};
use crate::viewer::{
    model::{Action, State},
    ui::command::Command,
};
use egui::{Button, Id, PointerButton, Popup, Response, Ui};
use glam::DVec2;

/// What was under the cursor when the menu was opened.
#[derive(Clone, Copy)]
struct Opened {
    object: Option<usize>,
    px: DVec2,
}

/// On the picture: `px` is the cursor's pixel position now.
pub(super) fn of_picture(
    picture: &Response,
    state: &State,
    px: Option<DVec2>,
    commands: &mut Vec<Command>,
) {
    let id = Id::unique("under the cursor");
    // While the button is down nothing is hovered.
    let button = PointerButton::Secondary;
    let pressed = picture
        .ctx
        .input(|input| input.pointer.button_pressed(button));
    if let (true, Some(px)) = (pressed && picture.contains_pointer(), px) {
        let object = state.hover();
        let opened = Opened { object, px };
        picture.ctx.data_mut(|data| data.insert_temp(id, opened));
    }
    let opened = picture.ctx.data(|data| data.get_temp::<Opened>(id));
    match opened {
        Some(Opened {
            object: Some(object),
            px,
        }) if object < state.scene().objects().len() => {
            of_object(picture, state, object, Some(px), commands);
        }
        _ => of_nothing(picture, state, commands),
    }
}

/// On an object: in the list, or at a pixel of the picture.
pub(super) fn of_object(
    on: &Response,
    state: &State,
    index: usize,
    px: Option<DVec2>,
    commands: &mut Vec<Command>,
) {
    Popup::context_menu(on).show(|ui| {
        let object = &state.scene().objects()[index];
        ui.strong(&object.name).hint("what is under the cursor");
        ui.separator();
        if let Some(px) = px {
            let time_s = ui.input(|input| input.time);
            let hint = "as a click there does: picks the nearest surface";
            let pick = [Action::Select(None), Action::Click(px, time_s)];
            entry(
                ui,
                "Pick this point",
                "",
                hint,
                &pick.map(Command::Act),
                commands,
            );
            let hint = "the camera looks at this point, and turns about it";
            let centre = [Command::Act(Action::Recentre(px))];
            entry(
                ui,
                "Centre the view here",
                "double click",
                hint,
                &centre,
                commands,
            );
        }
        // These act on the selection. So the object is selected, unless it is: then its picked point stays.
        let is_selected = (state.selection()).is_some_and(|selection| selection.object == index);
        let select = (!is_selected).then_some(Action::Select(Some(index)));
        for (name, key, hint, action) in [
            (
                "Frame it",
                "F",
                "move the camera until it fills the view",
                Action::FrameSelection,
            ),
            (
                "Hide it",
                "Shift+H",
                "what is hidden is neither drawn nor picked",
                Action::HideSelection,
            ),
            (
                "Hide all others",
                "I",
                "only this object is drawn and picked",
                Action::Isolate,
            ),
        ] {
            let asked: Vec<_> = select
                .into_iter()
                .chain([action])
                .map(Command::Act)
                .collect();
            entry(ui, name, key, hint, &asked, commands);
        }
        if state.scene().hidden_count() > 0 {
            show_all(ui, commands);
        }
        ui.separator();
        if is_selected
            && state
                .selection()
                .is_some_and(|selection| selection.pick.is_some())
        {
            let hint = "the full record of its picked point, as JSON";
            entry(
                ui,
                "Copy the pick",
                "J",
                hint,
                &[Command::CopyPick],
                commands,
            );
        }
        let hint = "as it stands in the list";
        let copy = [Command::Copy(object.name.clone())];
        entry(ui, "Copy its name", "", hint, &copy, commands);
    });
}

/// On the background.
fn of_nothing(picture: &Response, state: &State, commands: &mut Vec<Command>) {
    Popup::context_menu(picture).show(|ui| {
        let hint = "move the camera until all of the scene is in view";
        entry(
            ui,
            "Frame all",
            "A",
            hint,
            &[Command::Act(Action::FrameAll)],
            commands,
        );
        let hint = "the view that the scene opened with";
        entry(
            ui,
            "Reset the view",
            "Enter",
            hint,
            &[Command::Act(Action::ResetView)],
            commands,
        );
        if state.scene().hidden_count() > 0 {
            show_all(ui, commands);
        }
        ui.separator();
        let hint = "a command line that shows and picks exactly this";
        entry(
            ui,
            "Copy the view as a command",
            "C",
            hint,
            &[Command::CopyCommandLine],
            commands,
        );
        let hint = "as a scene file writes it; Ctrl+V pastes it";
        entry(
            ui,
            "Copy the camera",
            "Shift+C",
            hint,
            &[Command::CopyCamera],
            commands,
        );
        let hint = "a PNG file without the panels";
        let save = [Command::Screenshot { alone: true }];
        entry(ui, "Save the picture", "Shift+F12", hint, &save, commands);
    });
}

fn show_all(ui: &mut Ui, commands: &mut Vec<Command>) {
    let show = [Command::Act(Action::ShowAll)];
    entry(ui, "Show all", "U", "show what is hidden", &show, commands);
}

/// A line of a menu.
fn entry(
    ui: &mut Ui,
    name: &str,
    key: &str,
    hint: &str,
    asked: &[Command],
    commands: &mut Vec<Command>,
) {
    let line = ui.add(Button::new(name).shortcut_text(key));
    named(&line, name);
    if line.hint(hint).clicked() {
        commands.extend_from_slice(asked);
    }
}
