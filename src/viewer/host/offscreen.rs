//! The whole window without a window system: egui's events in, pictures out. Panels, keys, mouse and drawing are the
//! window's own. Only winit is missing.

use super::{
    controls::{Control, controls},
    memory_picture::MemoryPicture,
};
use crate::{
    camera::Viewport,
    image::{Image, Rgb},
    render::{GpuError, Restraint},
    viewer::{
        app::{App, Frame, Host, REST_S, Wake, Waker},
        model::Seen,
        options::Options,
    },
};
use egui::accesskit::TreeUpdate;
use std::{
    path::PathBuf,
    sync::{
        Arc, Mutex, PoisonError,
        mpsc::{Receiver, channel},
    },
    time::{Duration, Instant},
};

/// If one event takes more frames than this, the panels never come to rest: a cursor blinks, or a message waits to go.
const MOST_FRAMES: usize = 100;
/// No job takes as long as this.
const LONGEST_WAIT: Duration = Duration::from_mins(2);

/// Seconds between two passes.
const FRAME_S: f64 = 1.0 / 60.0;

/// A window that nobody sees.
pub struct Offscreen {
    pub(super) app: App,
    wakes: Receiver<Wake>,
    pub(super) picture: MemoryPicture,
    pixels_per_point: f32,
    time_s: f64,
    pub(super) copied: Option<String>,
    pub(super) controls: Vec<Control>,
    /// The last pass's accessibility tree, until [`Self::controls`] is made of it.
    tree: Option<TreeUpdate>,
    /// Whether passes that no other follows at once make that tree.
    tells_controls: bool,
    pub(super) at_rest: bool,
    theme: Option<egui::Theme>,
    due: Due,
}

/// In how many seconds the panels want their next pass, by what was asked since this was cleared.
#[derive(Clone, Default)]
struct Due(Arc<Mutex<Option<f64>>>);

impl Due {
    fn ask(&self, in_s: f64) {
        let mut due = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        *due = Some(due.map_or(in_s, |due| due.min(in_s)));
    }

    fn take(&self) -> Option<f64> {
        let mut due = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        due.take()
    }
}

impl Offscreen {
    /// A window of `size` physical pixels, with `pixels_per_point` pixels to a point. It loads what `options` name. It
    /// needs no graphics until a picture is asked for.
    pub fn open(options: Options, size: Viewport, pixels_per_point: f32) -> Self {
        let start = |wake| App::start(options, wake, Host::Picture);
        Self::of(start, size, pixels_per_point)
    }

    pub(super) fn of(
        start: impl FnOnce(Waker) -> App,
        size: Viewport,
        pixels_per_point: f32,
    ) -> Self {
        let (sender, wakes) = channel();
        // Sending fails once the window is gone: then nobody is to be woken.
        let wake = Arc::new(move |wake| drop(sender.send(wake)));
        let mut window = Self {
            app: start(wake),
            wakes,
            picture: MemoryPicture {
                canvas: None,
                restraint: Restraint::default(),
                size,
                is_another: false,
            },
            pixels_per_point,
            time_s: 0.0,
            copied: None,
            controls: Vec::new(),
            tree: None,
            tells_controls: true,
            at_rest: false,
            theme: None,
            due: Due::default(),
        };
        let due = window.due.clone();
        let ask = move |info: egui::RequestRepaintInfo| due.ask(info.delay.as_secs_f64());
        window.app.context.set_request_repaint_callback(ask);
        window.settle();
        window
    }

    /// Runs a pass for each event, then waits for the jobs that these began. Positions are in points. Nothing is drawn.
    /// Unless a picture is late, events act as if the wanted picture were on screen.
    pub fn send(&mut self, events: impl IntoIterator<Item = egui::Event>) {
        self.make_tree(false);
        for event in events {
            if self.app.picture.behind.is_none() {
                self.app.state.see(Seen::Wanted);
            }
            let input = self.input(vec![event]);
            self.pass(input);
        }
        self.settle();
    }

    /// Runs a pass for each event, as a window does with those that come while it draws: what was drawn last is on
    /// screen all the time.
    pub fn send_undrawn(&mut self, events: impl IntoIterator<Item = egui::Event>) {
        self.make_tree(false);
        for event in events {
            let input = self.input(vec![event]);
            self.pass(input);
        }
        self.settle();
    }

    /// Runs one pass for all of the events, as after a slow frame.
    pub fn send_at_once(&mut self, events: Vec<egui::Event>) {
        let input = self.input(events);
        self.pass(input);
        self.settle();
    }

    /// Lets time pass without events.
    pub fn wait_s(&mut self, seconds: f64) {
        self.time_s += seconds;
        self.settle();
    }

    /// Gives the window another size in physical pixels.
    pub fn resize(&mut self, size: Viewport) {
        self.picture.size = size;
        self.settle();
    }

    /// Makes the desktop dark or light.
    pub fn set_theme(&mut self, theme: egui::Theme) {
        self.theme = Some(theme);
        self.settle();
    }

    /// Turns the accessibility tree on or off. It is on at first. While it is off, [`Offscreen::controls`] stay as they
    /// were.
    pub fn tell_controls(&mut self, tells: bool) {
        self.tells_controls = tells;
        if tells {
            self.settle();
        }
    }

    /// Where screenshots go.
    pub fn save_screenshots_in(&mut self, folder: PathBuf) {
        self.app.screenshots.folder = folder;
    }

    /// Makes all pipelines ahead, as an idle window does one at a time.
    pub fn prepare_all(&mut self) {
        while self.app.prepare(&mut self.picture) {}
    }

    /// Draws the frame after these events as a window does, without waiting for more events, and the scene only if it
    /// changed. Returns whether a new picture of the scene is shown.
    pub fn draw(
        &mut self,
        events: impl IntoIterator<Item = egui::Event>,
    ) -> Result<bool, GpuError> {
        let input = self.input(events.into_iter().collect());
        self.make_tree(self.tells_controls);
        let Frame { platform, drawn } = self.app.frame(input, &mut self.picture);
        self.take_told(platform);
        self.take_controls();
        self.at_rest = self.app.rest.is_settled;
        drawn
    }

    /// A picture of the whole window at rest: its edges are smooth.
    pub fn picture(&mut self) -> Result<Image<Rgb>, GpuError> {
        self.draw_whole()?;
        // The first frame may have begun jobs, such as a comparison with what it drew.
        self.settle();
        self.draw_whole()?;
        self.drawn()
    }

    /// The frame that was drawn last, as it is on the screen. It is an error if nothing was drawn yet.
    pub fn drawn(&self) -> Result<Image<Rgb>, GpuError> {
        let canvas = self.picture.canvas.as_ref();
        canvas.ok_or(GpuError::NoAdapter)?.read()
    }

    fn draw_whole(&mut self) -> Result<(), GpuError> {
        self.draw([])?;
        while self.app.picture.behind.is_some() {
            self.draw([])?;
        }
        if self.app.picture.rough {
            self.time_s += REST_S;
        }
        while self.app.picture.rough {
            self.draw([])?;
        }
        Ok(())
    }

    /// Draws with a device that can do no more than this, from the next picture on.
    pub fn restrain(&mut self, restraint: Restraint) {
        self.picture.restraint = restraint;
        self.picture.canvas = None;
    }

    /// Destroys the device, as a driver that restarts does.
    pub fn lose_device(&mut self) {
        if let Some(canvas) = &self.picture.canvas {
            canvas.gpu.device.destroy();
            // The next poll reports the loss.
            let _ = canvas.gpu.wait();
        }
    }

    pub(super) fn pass(&mut self, input: egui::RawInput) {
        let platform = self.app.pass(input);
        self.take_told(platform);
    }

    /// egui's input, a frame later than the one before.
    pub(super) fn input(&mut self, events: Vec<egui::Event>) -> egui::RawInput {
        self.time_s += FRAME_S;
        #[expect(clippy::cast_precision_loss, reason = "windows are not that large")]
        let size = [self.picture.size.width(), self.picture.size.height()]
            .map(|px| px as f32 / self.pixels_per_point);
        let screen = egui::Rect::from_min_size(egui::Pos2::ZERO, size.into());
        let mut input = egui::RawInput {
            screen_rect: Some(screen),
            time: Some(self.time_s),
            events,
            system_theme: self.theme,
            ..egui::RawInput::default()
        };
        let viewport = input.viewports.entry(input.viewport_id).or_default();
        viewport.native_pixels_per_point = Some(self.pixels_per_point);
        input
    }

    /// Takes what a window would hand to the system.
    fn take_told(&mut self, platform: egui::PlatformOutput) {
        for command in platform.commands {
            if let egui::OutputCommand::CopyText(text) = command {
                self.copied = Some(text);
            }
        }
        if platform.accesskit_update.is_some() {
            self.tree = platform.accesskit_update;
        }
    }

    fn take_controls(&mut self) {
        if let Some(tree) = self.tree.take() {
            self.controls = controls(&tree);
        }
    }

    /// Whether the next passes make the accessibility tree. That takes as long as the panels themselves.
    fn make_tree(&self, makes: bool) {
        if makes {
            self.app.context.enable_accesskit();
        } else {
            self.app.context.disable_accesskit();
        }
    }

    /// Runs passes until nothing moves and nothing is under way. As a window does, it runs none before one is due.
    pub(super) fn settle(&mut self) {
        let start = Instant::now();
        self.make_tree(self.tells_controls);
        let mut left = MOST_FRAMES;
        while left > 0 {
            while self.app.is_busy() && start.elapsed() < LONGEST_WAIT {
                // Only answers of dialogs are taken: tests set the theme themselves.
                let wake = self.wakes.recv_timeout(Duration::from_millis(5));
                if let Ok(Wake::Answered(what, answer)) = wake {
                    self.app.answered(what, answer);
                }
                self.app.take_finished();
            }
            self.due.take();
            let input = self.input(Vec::new());
            self.pass(input);
            left -= 1;
            let is_busy = self.app.is_busy();
            self.at_rest = !self.app.context.has_requested_repaint() && !is_busy;
            if self.at_rest {
                break;
            }
            if !is_busy {
                self.sleep(&mut left);
            }
        }
        self.take_controls();
    }

    /// Lets the frames go by in which no pass is due, but for the last of those that are left.
    fn sleep(&mut self, left: &mut usize) {
        let mut wait_s = self.due.take().unwrap_or(0.0) - FRAME_S;
        while wait_s > 0.0 && *left > 1 {
            self.time_s += FRAME_S;
            wait_s -= FRAME_S;
            *left -= 1;
        }
    }
}
