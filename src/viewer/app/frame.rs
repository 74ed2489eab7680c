//! The driver of a frame, which windows and pictures of windows share. A frame takes the results of jobs, runs the
//! panels on egui's input, executes their commands, replaces a lost device, and draws.

use super::{
    checks::painted,
    in_turn::in_turn,
    modal::Modal,
    program::{App, Host},
    rest::REST_S,
};
use crate::{
    render::GpuError,
    viewer::{
        model::{Action, Seen, State},
        screen::{Canvas, Laid, Screen, Updated},
        ui::{self, Command, Notices, Shown, Topic},
    },
};
use std::{
    mem,
    time::{Duration, Instant},
};

/// While the program is idle, it prepares something this often.
const PREPARE_EVERY: Duration = Duration::from_millis(16);

/// After a device was lost while it was replaced, another is tried.
const LOST_AGAIN: Duration = Duration::from_millis(500);

/// A progress bar moves this often. In software a frame costs the work under way about 20 ms.
const PROGRESS_EVERY: Duration = Duration::from_millis(200);

/// The outcome of a frame.
pub struct Frame {
    /// Clipboard, cursor and the like, for the system.
    pub platform: egui::PlatformOutput,
    /// Whether a new picture of the scene is shown.
    pub drawn: Result<bool, GpuError>,
}

impl App {
    /// Runs the panels on the input since the last frame, draws the result and shows it.
    pub fn frame(&mut self, input: egui::RawInput, screen: &mut impl Screen) -> Frame {
        let start = Instant::now();
        let mut output = self.run(input);
        let drawn = self.draw_frame(&mut output, screen);
        if drawn == Ok(true) && self.host == Host::Window {
            let now_s = self.context.input(|input| input.time);
            self.statistics.frame = Some((start.elapsed(), now_s));
        }
        Frame {
            platform: output.platform_output,
            drawn,
        }
    }

    /// Runs the panels on the input since the last run, and draws nothing.
    pub fn pass(&mut self, input: egui::RawInput) -> egui::PlatformOutput {
        self.run(input).platform_output
    }

    /// Takes the results of jobs, and runs the panels on each part of an input. Returns the last output, with what all
    /// of them tell the system.
    fn run(&mut self, input: egui::RawInput) -> egui::FullOutput {
        self.take_finished();
        let context = self.context.clone();
        let runs = (in_turn(input).into_iter()).map(|part| context.run_ui(part, |ui| self.ui(ui)));
        let all = runs.reduce(|mut output, next| {
            // What a part asked for at once, the next one has served.
            let asked = next.viewport_output.clone();
            output.append(next);
            output.viewport_output = asked;
            output
        });
        let mut output = all.unwrap_or_default();
        self.textures.append(mem::take(&mut output.textures_delta));
        output
    }

    /// Draws the shapes that the last run of the panels has put out, and takes them. Returns whether a new picture of
    /// the scene is shown.
    pub fn draw_frame(
        &mut self,
        output: &mut egui::FullOutput,
        screen: &mut impl Screen,
    ) -> Result<bool, GpuError> {
        let pixels_per_point = output.pixels_per_point;
        let shapes = mem::take(&mut output.shapes);
        let now_s = self.context.input(|input| input.time);
        let laid = Laid {
            place: self.place,
            panes: self.panes.clone(),
            primitives: self.context.tessellate(shapes, pixels_per_point),
            panels_on: ui::panels_on(&self.context),
            background: (self.options.background).unwrap_or_else(|| ui::background(&self.context)),
            pixels_per_point,
            moves: self.rest.moves(self.state.all_to_show(), now_s),
        };
        let drawn = self.draw(&laid, screen);
        if let Err(error) = &drawn {
            self.complain(error.to_string());
            if matches!(error, GpuError::Lost(_)) {
                (self.context).request_repaint_after(LOST_AGAIN);
            }
        }
        let mut delays = output.viewport_output.values();
        self.rest.is_settled =
            delays.all(|viewport| viewport.repaint_delay > Duration::ZERO) && !self.is_busy();
        if self.rest.is_rough {
            let wait_s = if laid.moves { REST_S } else { 0.0 };
            (self.context).request_repaint_after(Duration::from_secs_f64(wait_s));
        }
        if self.host == Host::Window && self.rest.is_settled && self.prepare(screen) {
            (self.context).request_repaint_after(PREPARE_EVERY);
        }
        drawn
    }

    /// Makes a pipeline, which no frame then has to wait for. Returns whether any may be left.
    pub fn prepare(&mut self, screen: &mut impl Screen) -> bool {
        let view = self.state.view();
        let makes = |canvas: &mut Canvas| canvas.make_ahead(view);
        screen.canvas().is_some_and(makes)
    }

    /// Takes the results of jobs.
    pub fn take_finished(&mut self) {
        self.take_loaded();
        self.take_saved();
        self.take_checked();
        self.take_chart();
        self.take_changed();
        self.take_typefaces();
        self.take_numbers();
    }

    /// Lays out the panels for the input at hand, and executes their commands. If these changed what the panels show,
    /// egui lays them out again at once.
    pub fn ui(&mut self, ui: &mut egui::Ui) {
        let context = ui.ctx().clone();
        self.take_beginning();
        let example = self.tour.and_then(|tour| tour.step().2.example);
        self.state.set_example(example.map(Into::into));
        self.notice_step(None);
        let now_s = context.input(|input| input.time);
        self.forget_said(now_s);
        let moves = context.input(|input| ui::moves_ahead(&mut self.drag, &input.raw.events));
        for action in moves {
            self.obey(Command::Act(action));
        }
        let underway = self.underway();
        let arrangement = self.memory.panels.clone();
        // A screenshot without panels shows no passing messages either.
        let wanted = self.screenshots.wanted;
        let is_shot = wanted.is_some_and(|(shot, _)| !shot.has_panels);
        let offers_tour = !is_shot && self.offers_tour();
        let mut none = Notices::new();
        let due = mem::take(&mut self.late);
        if !due.is_empty() {
            ui::leave_text(&context);
        }
        let mut shown = Shown {
            state: &self.state,
            notices: if is_shot {
                &mut none
            } else {
                &mut self.notices
            },
            underway,
            helps: self.helps,
            shot: (self.screenshots.is_open).then_some(&mut self.screenshots.shot),
            tour: self.tour,
            offers_tour,
            question: match &self.modal {
                Modal::Question(intent) => Some(intent),
                _ => None,
            },
            chart: self.chart.as_ref(),
            checking: &self.checking,
            marks: painted(&context, &self.state, &self.checking, &mut self.marks),
            statistics: &self.statistics,
            arrangement: &mut self.memory.panels,
            recent: &self.memory.recent,
            look: self.memory.look,
            sums: &mut self.sums,
            filter: &mut self.filter,
            is_bare: self.options.is_bare,
            reveal_selection: self.reveal_selection,
        };
        let asked = ui::show(ui, &mut shown, &mut self.drag);
        (self.place, self.panes) = (asked.place, asked.panes);
        let mut commands = asked.commands;
        self.reveal_selection = false;
        commands.extend(dropped(&context));
        if context.text_edit_focused() {
            let waits = |command: &mut Command| command.ends_typing();
            self.late.extend(commands.extract_if(.., waits));
        }
        commands.extend(due);
        let acted = !commands.iter().all(is_idle) || !self.late.is_empty();
        let lit = |state: &State| (state.hover(), state.row(), state.worked_number());
        let before = lit(&self.state);
        let cursor = self.state.cursor();
        // A row lights its object only while the cursor is on it.
        self.state.apply(Action::Light(None));
        for command in commands {
            self.obey(command);
        }
        self.look_ahead();
        let follows_cursor =
            self.memory.panels.shows(Topic::Matrices) || !self.state.stages().is_empty();
        let is_outdated = acted
            || (follows_cursor && cursor != self.state.cursor())
            || before != lit(&self.state)
            || arrangement != self.memory.panels;
        if is_outdated && context.current_pass_index() == 0 {
            context.request_discard("commands have changed what the panels show");
        } else if is_outdated {
            context.request_repaint();
        }
        if self.underway().is_some() {
            context.request_repaint_after(PROGRESS_EVERY);
        }
    }

    /// Executes a command, and notices whether it was the step that the tour waits for.
    fn obey(&mut self, command: Command) {
        let done = self.tour.map(|_| command.clone());
        self.run_command(command);
        self.notice_step(done.as_ref());
    }

    /// Draws a pass, on a new device if the old one is lost. Then does what waited for the frame.
    fn draw(&mut self, laid: &Laid, screen: &mut impl Screen) -> Result<bool, GpuError> {
        self.rest.is_rough = false;
        if screen.restore()? {
            self.textures.renew();
        }
        let Some(canvas) = screen.canvas() else {
            return Ok(false);
        };
        if self.host == Host::Window {
            let gpu = canvas.gpu();
            gpu.adapter_name().clone_into(&mut self.statistics.adapter);
            self.statistics.software = gpu.is_software();
        }
        canvas.take_textures(&mut self.textures.news);
        let updated = canvas.update(&self.state, laid);
        self.state.see(match canvas.on_screen() {
            _ if !laid.panes.is_empty() || laid.place.is_none() => Seen::Wanted,
            Some(seen) => Seen::Picture(seen),
            None => Seen::Nothing,
        });
        match &updated {
            Ok(Updated { anew, rough }) => {
                self.state.accepted();
                self.rest.is_rough = *rough;
                if *anew {
                    self.announce();
                }
            }
            // `refused` has brought back the scene that was shown before.
            Err(GpuError::SceneTooLarge { .. }) if self.state.refused() => {
                self.build_trees();
                self.context.request_repaint();
            }
            Err(_) => {}
        }
        screen.paint(laid)?;
        let size = screen.size();
        if let Some(canvas) = screen.canvas() {
            self.start_check(canvas);
            if let Some(size) = size {
                self.take_screenshot(canvas, laid, size);
            }
        }
        updated.map(|updated| updated.anew)
    }
}

/// The command to open, or with Shift to add, the files that were dropped on the window.
fn dropped(context: &egui::Context) -> Option<Command> {
    context.input(|input| {
        let files = input.raw.dropped_files.iter();
        let paths: Vec<_> = files.map(|file| file.path().to_path_buf()).collect();
        let adds = input.modifiers.shift;
        let command = if adds { Command::Add } else { Command::Open };
        (!paths.is_empty()).then(|| command(paths))
    })
}

/// Whether a command alone does not make the panels outdated: it comes with each pass, or only follows the cursor. What
/// follows the cursor is compared apart, in [`App::ui`].
fn is_idle(command: &Command) -> bool {
    use Action::{Enter, Hover, Light, LightNumber, LightRow, Resize};
    matches!(
        command,
        Command::ShowsDepthSteps
            | Command::Act(
                Enter(_) | Hover(_) | Light(_) | LightNumber(_) | LightRow(_) | Resize(_)
            )
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::viewer::{app::program::SAID_S, options::Options};
    use egui::{Event, Key, Modifiers, OutputCommand, RawInput};
    use std::sync::Arc;

    /// A copied camera, Tab and a text are three parts of one input. The system gets what each of them asks for, once.
    #[test]
    fn an_input_of_several_parts_tells_the_system_all() {
        let context = egui::Context::default();
        let mut app = App::start(Options::default(), Arc::new(drop), Host::Picture, context);
        app.pass(RawInput::default());
        let key = |key, modifiers| Event::Key {
            key,
            physical_key: None,
            pressed: true,
            repeat: false,
            modifiers,
        };
        let events = vec![
            key(Key::C, Modifiers::SHIFT),
            key(Key::Tab, Modifiers::NONE),
            Event::Text("5".into()),
        ];
        let passes = app.context.cumulative_frame_nr();
        let told = app.pass(RawInput {
            events,
            ..RawInput::default()
        });
        assert_eq!(app.context.cumulative_frame_nr(), passes + 3);
        let copies = told.commands.iter().filter_map(|command| match command {
            OutputCommand::CopyText(text) => Some(text.starts_with("[camera]")),
            _ => None,
        });
        assert_eq!(copies.collect::<Vec<_>>(), [true]);
    }

    /// A message goes when its time is over, though nothing else calls for a frame then.
    #[test]
    fn a_message_asks_for_the_frame_without_it() {
        let context = egui::Context::default();
        let mut app = App::start(Options::default(), Arc::new(drop), Host::Picture, context);
        let run = |app: &mut App, time_s| {
            let input = RawInput {
                time: Some(time_s),
                ..RawInput::default()
            };
            let output = app.run(input);
            let delays = output.viewport_output.values();
            delays.map(|viewport| viewport.repaint_delay).min()
        };
        // A scene that comes takes the messages about the one before away.
        while app.is_busy() {
            run(&mut app, 1.0);
        }
        app.say("done".into());
        // Frames for another reason come in between.
        for time_s in [1.1, 1.2, 2.0, 2.5] {
            run(&mut app, time_s);
        }
        let delay = run(&mut app, 3.0).expect("a window");
        assert!(!app.notices.is_empty());
        let left = Duration::from_secs_f64(SAID_S - 2.0);
        assert!(delay <= left, "{delay:?}");
        run(&mut app, 1.0 + SAID_S + 0.01);
        assert!(app.notices.is_empty());
    }
}
