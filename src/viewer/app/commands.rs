//! What each command does.

use super::{
    modal::Modal,
    program::{App, Host},
    saved::NO_DIALOG,
    wake::{PathFor, Wake},
};
use crate::{
    camera::CameraChoice,
    json,
    scene::{Scene, description},
    viewer::{
        jobs::{self, Answer, Checking},
        model::{Action, MeasureAction, RayHits, Views, view_command},
        ui::{Attempt, Command, Intent, Reply, Topic},
    },
};
use egui::OutputCommand;

/// The part of a clipboard's text that is used; the rest may be objects.
#[derive(serde::Deserialize)]
struct Clipping {
    camera: Option<CameraChoice>,
}

impl App {
    /// Does what the user asks for.
    pub fn run_command(&mut self, command: Command) {
        match command {
            Command::Act(Action::ToggleFreeze) if self.state.views() != Views::Picture => {
                // The four views show the camera as it is: from outside it shows in the picture.
                self.show_views(Views::Picture);
                if self.state.frozen().is_none() {
                    self.act(Action::ToggleFreeze);
                }
            }
            Command::Act(Action::Views(views)) => self.show_views(views),
            Command::Act(action) => self.act(action),
            Command::OpenDialog if self.host == Host::Picture => {}
            Command::OpenDialog if !self.is_free() => {}
            Command::OpenDialog => {
                let number = self.wait_for_dialog(PathFor::Open, None);
                let wake = self.wake.clone();
                jobs::open_dialog(move |answer| {
                    wake(Wake::Answered(number, PathFor::Open, answer));
                });
            }
            Command::SaveDialog => self.ask_where_to_save(None),
            Command::Open(paths) => self.intend(Intent::Open(paths)),
            Command::Add(paths) => self.add(paths),
            Command::Reload => self.intend(Intent::Reload),
            Command::Reply(reply) => self.reply(reply),
            Command::CopyCommandLine => {
                let command = view_command(&self.state);
                let done = match self.state.pick_ray() {
                    Some(_) => "the pick as a command is copied",
                    None => "the view as a command is copied",
                };
                self.copy(command, done);
                if self.state.edited() {
                    self.failed(
                        Attempt::Copy,
                        "the command shows the scene as its files have it, without your edits: save first (Ctrl+S), then copy again"
                            .into(),
                    );
                }
            }
            Command::CopyCamera => {
                let camera = self.state.camera_choice();
                if let Ok(text) = description::to_toml(&Scene::default(), &camera, &[]) {
                    self.copy(text, "the camera is copied: Ctrl+V applies it");
                }
            }
            Command::Paste(text) => match self.paste_camera(&text) {
                Ok(()) => self.succeeded(Attempt::Paste),
                Err(reason) => self.failed(Attempt::Paste, reason),
            },
            Command::ToggleScreenshot => self.screenshots.is_open ^= true,
            Command::Shoot(shot, to) => {
                self.screenshots.is_open = false;
                self.screenshots.wanted = Some((shot, to));
                self.context.request_repaint();
            }
            Command::Copy(text) => self.copy(text, "copied"),
            Command::SelectRow { down } => {
                let now = self.state.selected();
                if let Some(next) = self.filter.next(&self.state, now, down) {
                    self.act(Action::Select(Some(next)));
                    self.reveal_selection = true;
                }
            }
            Command::SelectObjects(objects) => self.state.select_all(&objects),
            Command::ToggleFullScreen => self.fills_screen ^= true,
            Command::CopyPick => {
                let line = self.state.pick_ray().map(RayHits::line);
                match line.and_then(|line| json::text(&line).ok()) {
                    Some(json) => self.copy(json, "the pick is copied as JSON"),
                    None => self.failed(
                        Attempt::Copy,
                        "there is no pick to copy: click a surface first".into(),
                    ),
                }
            }
            Command::Escape => self.escape(),
            Command::NextExhibit { forward } => self.open_next_exhibit(forward),
            Command::NextFile { forward } => self.open_next_file(forward),
            Command::LeaveGallery if self.state.outside().is_some() => {
                self.intend(Intent::LeaveGallery);
            }
            // The gallery was opened first, so there is no scene to return to: open the demo.
            Command::LeaveGallery => self.intend(Intent::Open(Vec::new())),
            Command::ToggleCheck => {
                // Only the camera's picture can be compared.
                self.show_views(Views::Picture);
                self.toggle_check();
            }
            Command::ToggleHelp => self.helps ^= true,
            Command::ToggleFour => self.toggle_views(),
            Command::ToggleMoving => self.memory.panels.toggle(Topic::Placement),
            Command::TogglePipeline => self.memory.panels.toggle_matrices(),
            Command::ShowsDepthSteps => {}
            Command::Tour(to) => self.go_on_tour(to),
            Command::ShowOnePick => self.show_one_pick(),
            Command::NextLook => {
                self.memory.look = self.memory.look.next();
                self.memory.look.apply(&self.context);
            }
            Command::Quit => self.intend(Intent::Quit),
        }
    }

    /// What Esc does: ends the first thing in this list that is active.
    fn escape(&mut self) {
        let selects_none = self.state.selection().is_none();
        if matches!(self.modal, Modal::Question(_)) {
            self.reply(Reply::Stay);
        } else if self.give_up_dialog() {
            self.say("the file dialog is no longer waited for".into());
        } else if self.state.measuring().is_on {
            self.act(Action::Measure(MeasureAction::Toggle));
        } else if self.stop_loading() {
            // `stop_loading` did it.
        } else if self.helps {
            self.helps = false;
        } else if self.dismiss_latest() {
            // `dismiss_latest` did it.
        } else if self.state.method().is_some() {
            self.act(Action::PickBy(None));
        } else if !matches!(self.checking, Checking::Off) {
            self.checking = Checking::Off;
        } else if selects_none && !self.state.stages().is_empty() {
            self.toggle_views();
        } else if selects_none && self.state.outside().is_some() {
            self.intend(Intent::LeaveGallery);
        } else {
            self.act(Action::Select(None));
        }
    }

    fn copy(&mut self, text: String, done: &'static str) {
        self.put_on_clipboard(OutputCommand::CopyText(text), done);
    }

    /// Puts a text or a picture on the clipboard. Once it is there, `done` says so.
    pub(super) fn put_on_clipboard(&mut self, copies: OutputCommand, done: &'static str) {
        self.context.send_cmd(copies);
        self.context.request_repaint();
        self.copying = Some(done);
        if self.host == Host::Picture {
            // There is no clipboard that could refuse it.
            self.was_copied(Ok(()));
        }
    }

    /// What was copied is on the clipboard, or why it is not.
    pub fn was_copied(&mut self, result: Result<(), String>) {
        // What a text field copies is not spoken of.
        let done = self.copying.take();
        match result {
            Ok(()) => {
                self.succeeded(Attempt::Copy);
                if let Some(done) = done {
                    self.say(done.into());
                }
            }
            Err(reason) => self.failed(Attempt::Copy, format!("nothing is copied: {reason}")),
        }
    }

    /// Takes the answer of a file dialog. One that is no longer waited for changes nothing: it was about what was on show
    /// then.
    pub fn answered(&mut self, number: u64, what: PathFor, answer: Answer) {
        let asks = |modal: &Modal| match modal {
            Modal::Dialog(waiting, of, _) => (*waiting, *of) == (number, what),
            _ => false,
        };
        let Modal::Dialog(.., then) = self.modal.take_if(asks) else {
            if let Answer::Paths(_) = answer {
                let text = "a file dialog was answered that was no longer waited for: ask again";
                self.remind(text.into());
            }
            return;
        };
        match (what, answer) {
            (_, Answer::None) => {}
            (PathFor::Open, Answer::Paths(paths)) => self.run_after_typing(Command::Open(paths)),
            (PathFor::Open, Answer::NotShown) => self.failed(
                Attempt::Open,
                format!("{NO_DIALOG}: name files as arguments: sightline FILE; or drop files on the window, which Wayland does not pass on"),
            ),
            (PathFor::Save, Answer::Paths(paths)) => {
                if let Some(to) = paths.into_iter().next() {
                    self.save(to, then);
                }
            }
            (PathFor::Save, Answer::NotShown) => self.save_without_dialog(then),
        }
    }

    /// Does what the user asks for outside a pass: in the next pass, once the number that is being typed is entered.
    pub fn run_after_typing(&mut self, command: Command) {
        self.late.push(command);
        self.context.request_repaint();
    }

    /// Sets the camera from a text with a scene file's `[camera]` table.
    fn paste_camera(&mut self, text: &str) -> Result<(), String> {
        let none = "the clipboard holds no camera: copy one with Shift+C, or copy the [camera] table of a scene file";
        let says = toml::from_str::<Clipping>(text).map_err(|_| none)?;
        let camera = Action::Camera(says.camera.ok_or(none)?);
        self.state
            .check(&camera)
            .map_err(|error| format!("the camera on the clipboard: {error}"))?;
        self.act(camera);
        Ok(())
    }
}
