//! The driver of a frame, which windows and pictures of windows share. A frame takes the results of jobs, runs the
//! panels on egui's input, executes their commands, replaces a lost device, and draws.

use super::{
    checks::painted,
    in_turn::in_turn,
    program::{App, Host, Shot},
    rest::REST_S,
};
use crate::{
    render::GpuError,
    viewer::{
        model::{Action, Seen, Stage},
        screen::{Canvas, Laid, Motion, PictureProgress, SceneRect, Screen, write_screenshot},
        ui::{self, Attempt, Command, Notices, Shown},
    },
};
use std::{
    mem,
    time::{Duration, Instant},
};

/// While the program is idle, it prepares something this often.
const PREPARE_EVERY: Duration = Duration::from_millis(16);

/// The outcome of a frame.
pub(in crate::viewer) struct Frame {
    /// Clipboard, cursor and the like, for the system.
    pub platform: egui::PlatformOutput,
    /// Whether a new picture of the scene is shown.
    pub drawn: Result<bool, GpuError>,
}

/// The outcome of a pass over the panels: what to draw, and what to tell the system.
struct Pass {
    shapes: Vec<egui::epaint::ClippedShape>,
    pixels_per_point: f32,
    /// Where the scene goes; `None` where there is no room for it.
    place: Option<SceneRect>,
    /// Where the stages go within that place.
    panes: Vec<(Stage, SceneRect)>,
    platform: egui::PlatformOutput,
    /// Whether the panels show the state from before their own commands.
    is_outdated: bool,
    /// After how long egui wants another pass.
    next_in: Duration,
}

impl Pass {
    /// The next pass, with what both of them tell the system.
    fn then(mut self, next: Self) -> Self {
        self.platform.append(next.platform);
        let platform = self.platform;
        Self { platform, ..next }
    }
}

impl App {
    /// Runs a pass, and another if the first changed something, so that panels and scene show one state. Draws and
    /// shows the result.
    pub fn frame(&mut self, input: egui::RawInput, screen: &mut impl Screen) -> Frame {
        let start = Instant::now();
        self.take_finished();
        let again = egui::RawInput {
            events: Vec::new(),
            dropped_files: Vec::new(),
            ..input.clone()
        };
        let mut pass = self.run_passes(input);
        if pass.is_outdated {
            pass = pass.then(self.run_pass(again));
        }
        if pass.is_outdated {
            self.context.request_repaint();
        }
        let (place, pixels_per_point) = (pass.place, pass.pixels_per_point);
        let primitives = (self.context)
            .tessellate(pass.shapes, pixels_per_point)
            .into();
        let (now_s, is_held) = (self.context).input(|input| (input.time, input.pointer.any_down()));
        let laid = Laid {
            place,
            panes: pass.panes,
            primitives,
            pixels_per_point,
            motion: (self.rest).motion(self.state.all_to_show(), now_s, is_held),
        };
        let drawn = self.draw(&laid, screen);
        self.rest.drew(&self.picture, now_s);
        self.rest.is_settled = pass.next_in > Duration::ZERO
            && !pass.is_outdated
            && self.picture.behind.is_none()
            && !self.is_busy();
        if self.picture.rough {
            let rests = laid.motion == Motion::Rests;
            let wait_s = if rests { 0.0 } else { REST_S };
            (self.context).request_repaint_after(Duration::from_secs_f64(wait_s));
        }
        if self.host == Host::Window && self.rest.is_settled && self.prepare(screen) {
            (self.context).request_repaint_after(PREPARE_EVERY);
        }
        match &drawn {
            Ok(true) if self.host == Host::Window => {
                self.statistics.frame = Some((start.elapsed(), now_s));
            }
            Ok(_) => {}
            Err(error) => self.complain(error.to_string()),
        }
        Frame {
            platform: pass.platform,
            drawn,
        }
    }

    /// Makes a pipeline, which no frame then has to wait for. Returns whether any may be left.
    pub fn prepare(&mut self, screen: &mut impl Screen) -> bool {
        let view = self.state.view();
        let makes = |canvas: &mut Canvas| canvas.make_ahead(view);
        screen.canvas().is_some_and(makes)
    }

    /// Runs a pass without drawing. A press, the moves after it and the release each get a pass of their own, however
    /// slow frames are: within one pass, egui sees only the final state.
    pub fn pass(&mut self, input: egui::RawInput) -> egui::PlatformOutput {
        self.take_finished();
        let pass = self.run_passes(input);
        if pass.is_outdated {
            self.context.request_repaint();
        }
        pass.platform
    }

    /// Takes the results of jobs.
    pub fn take_finished(&mut self) {
        self.take_loaded();
        self.take_projected();
        self.take_saved();
        self.take_settled();
        self.take_ready();
        self.take_checked();
        self.take_chart();
        self.take_waiting();
        self.take_changed();
        self.take_typefaces();
        self.take_numbers();
    }

    /// Runs a pass on each part of an input. Returns the last one, with what all of them tell the system.
    fn run_passes(&mut self, input: egui::RawInput) -> Pass {
        let mut parts = in_turn(input).into_iter();
        let first = self.run_pass(parts.next().unwrap_or_default());
        parts.fold(first, |pass, part| pass.then(self.run_pass(part)))
    }

    /// Runs the panels on the input since the last pass, and executes their commands.
    fn run_pass(&mut self, input: egui::RawInput) -> Pass {
        let dropped = input.dropped_files.iter();
        let dropped: Vec<_> = dropped.map(|file| file.path().to_path_buf()).collect();
        let mut commands = Vec::new();
        let (mut place, mut panes) = (None, Vec::new());
        let context = self.context.clone();
        self.notice_step(None);
        let now_s = input.time.unwrap_or_default();
        self.forget_said(now_s);
        for action in ui::moves_ahead(&mut self.drag, &input) {
            self.obey(Command::Act(action));
        }
        let underway = self.underway().or_else(|| self.drawing(now_s));
        let docks = self.docks;
        // A screenshot without panels shows no passing messages either.
        let is_shot = self.screenshots.wanted.is_some_and(|shot| shot.alone);
        let offers_tour = !is_shot && self.offers_tour();
        let mut none = Notices::new();
        let due = mem::take(&mut self.late);
        let mut output = context.run_ui(input, |ui| {
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
                floating: self.floating,
                tour: self.tour,
                offers_tour,
                question: self.question.as_ref().map(|pending| &pending.intent),
                chart: self.chart.as_ref(),
                checking: &self.checking,
                marks: painted(&context, &self.state, &self.checking, &mut self.marks),
                statistics: &self.statistics,
                docks: &mut self.docks,
                recent: &self.memory.recent,
                look: self.memory.look,
                filter: &mut self.filter,
                is_bare: self.options.is_bare,
                reveal_selection: self.reveal_selection,
            };
            let asked = ui::show(ui, &mut shown, &mut self.drag);
            (place, panes) = (asked.place, asked.panes);
            commands.extend(asked.commands);
        });
        self.reveal_selection = false;
        self.textures.append(output.textures_delta);
        if !dropped.is_empty() {
            let adds = context.input(|input| input.modifiers.shift);
            let command = if adds { Command::Add } else { Command::Open };
            commands.push(command(dropped));
        }
        if context.text_edit_focused() {
            let waits = |command: &mut Command| command.ends_typing();
            self.late.extend(commands.extract_if(.., waits));
        }
        commands.extend(due);
        let acted = !commands.iter().all(is_idle) || !self.late.is_empty();
        let before = (self.state.hover(), self.state.row());
        let cursor = self.state.cursor();
        // A row lights its object only while the cursor is on it.
        self.state.apply(Action::Light(None));
        for command in commands {
            self.obey(command);
        }
        let follows_cursor = self.floating.pipeline || !self.state.stages().is_empty();
        let is_outdated = acted
            || (follows_cursor && cursor != self.state.cursor())
            || before != (self.state.hover(), self.state.row())
            || docks != self.docks;
        if self.underway().is_some() {
            context.request_repaint_after(Duration::from_millis(50));
        }
        let copied = self.copied.take().map(egui::OutputCommand::CopyText);
        output.platform_output.commands.extend(copied);
        Pass {
            shapes: output.shapes,
            pixels_per_point: output.pixels_per_point,
            place,
            panes,
            platform: output.platform_output,
            is_outdated,
            next_in: (output.viewport_output.values())
                .map(|viewport| viewport.repaint_delay)
                .min()
                .unwrap_or(Duration::MAX),
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
        self.picture = PictureProgress::default();
        if screen.restore()? {
            self.textures.renew();
        }
        let Some(canvas) = screen.canvas() else {
            return Ok(false);
        };
        if self.host == Host::Window {
            let gpu = &canvas.gpu;
            gpu.adapter_name().clone_into(&mut self.statistics.adapter);
            self.statistics.software = gpu.is_software();
        }
        canvas.take_textures(&mut self.textures.news);
        let drawn = screen.draw(&self.state, laid);
        match &drawn {
            Ok(progress) => {
                self.state.accepted();
                self.picture = *progress;
                if progress.anew {
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
        if let Some(canvas) = screen.canvas() {
            let is_late = self.picture.behind.is_some();
            self.state.see(match canvas.on_screen() {
                _ if !laid.panes.is_empty() || laid.place.is_none() => Seen::Wanted,
                Some(seen) if is_late => Seen::Earlier(seen),
                Some(seen) => Seen::Whole(seen),
                None => Seen::Nothing,
            });
            self.follow_up(canvas, laid);
        }
        if let Some(wait) = self.picture.behind {
            self.context.request_repaint_after(wait);
        }
        drawn.map(|progress| progress.anew)
    }

    /// Does what needs a drawn frame: starts comparisons and takes screenshots.
    fn follow_up(&mut self, canvas: &mut Canvas, laid: &Laid) {
        self.start_check(canvas);
        self.take_screenshot(canvas, laid);
    }

    /// Saves the frame that was just drawn, if a screenshot was asked for.
    fn take_screenshot(&mut self, canvas: &mut Canvas, laid: &Laid) {
        let Some(Shot { alone }) = self.screenshots.wanted.take() else {
            return;
        };
        let picture = match laid.place.filter(|_| alone) {
            Some(place) if laid.panes.is_empty() => canvas.picture_alone(&self.state, place),
            // The labels over the views belong to the panels.
            Some(place) => (canvas.picture(&self.state, laid))
                .map(|whole| whole.part(place.origin_px, place.viewport)),
            None => canvas.picture(&self.state, laid),
        };
        let written = picture
            .map_err(|error| error.to_string())
            .and_then(|picture| write_screenshot(&self.screenshots.folder, &picture));
        match written {
            Ok(path) => {
                self.succeeded(Attempt::Screenshot);
                self.say(format!("saved {}", path.display()));
            }
            Err(text) => self.failed(Attempt::Screenshot, text),
        }
    }
}

/// Whether a command alone does not make the panels outdated: it comes with each pass, or only follows the cursor. What
/// follows the cursor is compared apart, in `run_pass`.
fn is_idle(command: &Command) -> bool {
    use Action::{Enter, Hover, Light, LightRow, Resize};
    matches!(
        command,
        Command::ShowsDepthSteps
            | Command::Act(Enter(_) | Hover(_) | Light(_) | LightRow(_) | Resize(_))
    )
}
