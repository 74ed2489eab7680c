//! The menu of the right mouse button: what can be done with what is under the cursor.

use super::prelude::*;
use crate::viewer::ui::menus::{item_of, keys_of};
use egui::{Id, Label, PointerButton, Popup, RichText};
use glam::DVec2;

/// The width of an object's menu in points, however long its name is.
const WIDEST: f32 = 220.0;

/// What was under the cursor when the menu was opened.
#[derive(Clone, Copy)]
struct Opened {
    object: Option<usize>,
    px: DVec2,
}

/// The menu on the picture, or on one of the four views. `px` is where the cursor is now, in pixels.
pub(super) fn of_picture(
    picture: &Response,
    state: &State,
    px: Option<DVec2>,
    commands: &mut Vec<Command>,
) {
    let id = Id::unique("under the cursor");
    // What is under the cursor is noted at the press: while the button is down, nothing counts as hovered.
    let secondary = PointerButton::Secondary;
    let pressed = (picture.ctx).input(|input| input.pointer.button_pressed(secondary));
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

/// The menu on an object, in the list or at a pixel of the picture.
pub(super) fn of_object(
    on: &Response,
    state: &State,
    index: usize,
    px: Option<DVec2>,
    commands: &mut Vec<Command>,
) {
    Popup::context_menu(on).show(|ui| {
        let object = &state.scene().objects()[index];
        ui.set_max_width(WIDEST);
        let name = Label::new(RichText::new(&object.name).strong()).truncate();
        ui.add(name).hint("what is under the cursor");
        ui.separator();
        let mut lines = Lines { ui, commands };
        if let Some(px) = px {
            // Never, so that it is not taken for another click on what was picked there.
            let time_s = f64::NEG_INFINITY;
            let hint = "as a click there: picks the nearest surface";
            let pick = [Action::Click(px, time_s)];
            lines.add("Pick this point", "", hint, &pick);
            // In one of the four views, a double click makes it large.
            if state.stages().is_empty() {
                let hint = "the camera looks at this point, and turns about it";
                let centre = [Action::Recentre(px)];
                lines.add("Centre the view here", "double click", hint, &centre);
            }
        }
        // These act on all that is selected, so they select the object first. If it is selected already, what else is
        // selected and the picked point stay.
        let is_selected = state.is_selected(index);
        let select = (!is_selected).then_some(Action::Select(Some(index)));
        let others = state
            .selection()
            .map_or(0, |selection| selection.others.len());
        let what = match others {
            1.. if is_selected => format!("the {} selected", others + 1),
            _ => "it".to_owned(),
        };
        let mut selected = |does: &str, hint, action| {
            let name = &format!("{does} {what}");
            // The key acts on what is selected.
            let key = Some(keys_of(action)).filter(|_| is_selected);
            let asked: Vec<_> = select.into_iter().chain([action]).collect();
            lines.add(name, &key.unwrap_or_default(), hint, &asked);
        };
        let hint = "move the camera until that fills the view";
        selected("Frame", hint, Action::FrameSelection);
        let hint = "what is hidden is neither drawn nor picked";
        selected("Hide", hint, Action::HideSelection);
        let hint = "only that is drawn and picked";
        selected("Isolate", hint, Action::Isolate);
        lines.show_all(state);
        lines.ui.separator();
        if state.selected() == Some(index) && state.picked().is_some() {
            let hint = "the full record of its picked point, as JSON";
            lines.ask("Copy its pick", hint, Command::CopyPick);
        }
        let copy = Command::Copy(object.name.clone());
        lines.ask("Copy its name", "as it stands in the list", copy);
    });
}

/// The menu on the background.
fn of_nothing(picture: &Response, state: &State, commands: &mut Vec<Command>) {
    Popup::context_menu(picture).show(|ui| {
        let mut lines = Lines { ui, commands };
        if state.stages().is_empty() {
            let hint = "move the camera until all of the scene is in view";
            lines.ask("Frame all", hint, Action::FrameAll);
            let hint = "the view that the scene opened with";
            lines.ask("Reset the view", hint, Action::ResetView);
        } else {
            let hint = "all of it in view again, as it was at first; the camera stays";
            lines.add("Frame this view", "", hint, &[Action::ResetView]);
        }
        lines.show_all(state);
        lines.ui.separator();
        let name = "Copy the view as a command";
        let hint = "a command line that shows and picks exactly this";
        lines.ask(name, hint, Command::CopyCommandLine);
        let hint = "as a scene file writes it; Ctrl+V pastes it";
        lines.ask("Copy the camera", hint, Command::CopyCamera);
        if let Some(item) = item_of(&Command::ToggleScreenshot) {
            lines.ask(item.name, item.hint, Command::ToggleScreenshot);
        }
    });
}

/// The lines of an open menu.
struct Lines<'a> {
    ui: &'a mut Ui,
    commands: &'a mut Vec<Command>,
}

impl Lines<'_> {
    /// A line with its name, what it means and what it asks for. It shows the key that asks for the same.
    fn ask(&mut self, name: &str, hint: &str, command: impl Into<Command>) {
        let command = command.into();
        if self.is_clicked(name, &keys_of(command.clone()), hint) {
            self.commands.push(command);
        }
    }

    /// The same for actions, one after the other, with a text in place of the key.
    fn add(&mut self, name: &str, key: &str, hint: &str, actions: &[Action]) {
        if self.is_clicked(name, key, hint) {
            (self.commands).extend(actions.iter().copied().map(Command::Act));
        }
    }

    /// Adds "Show all" if something is hidden.
    fn show_all(&mut self, state: &State) {
        if state.scene().hidden_count() > 0 {
            self.ask("Show all", "show what is hidden", Action::ShowAll);
        }
    }

    fn is_clicked(&mut self, name: &str, key: &str, hint: &str) -> bool {
        let line = self.ui.add(Button::new(name).shortcut_text(key));
        let is_clicked = line.named(name).hint(hint).clicked();
        if is_clicked {
            // By a key too, where egui leaves the menu open.
            self.ui.close();
        }
        is_clicked
    }
}
