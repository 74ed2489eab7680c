//! The program without a window system: whoever has egui's input runs it and draws onto a picture. Panels, keys, mouse
//! and drawing are the window's own. Only winit is missing.

use super::memory_picture::MemoryPicture;
use crate::{
    camera::Viewport,
    image::{Image, Rgb},
    render::{GpuError, Restraint, read_rgb},
    scene::Loaded,
    viewer::{
        app::{App, Frame, Host, Wake, Waker, in_turn},
        model::Seen,
        options::Options,
    },
};
use egui::{Context, FullOutput, Pos2, RawInput, Rect, TexturesDelta, Ui};
use std::{
    path::PathBuf,
    sync::{
        Arc,
        mpsc::{Receiver, channel},
    },
    time::Duration,
};

/// The program, and the picture that its frames are drawn onto.
pub struct Offscreen {
    pub(super) app: App,
    wakes: Receiver<Wake>,
    pub(super) picture: MemoryPicture,
}

impl Offscreen {
    /// Begins to load what `options` name. Its panels are to be run in `context`. It needs no graphics until something
    /// is drawn.
    pub fn open(options: Options, context: Context) -> Self {
        Self::of(|wake| App::start(options, wake, Host::Picture, context))
    }

    /// The same with a scene that is loaded already.
    pub(super) fn open_loaded(loaded: Loaded, options: Options, context: Context) -> Self {
        Self::of(|wake| App::start_with(loaded, options, wake, Host::Picture, context))
    }

    fn of(start: impl FnOnce(Waker) -> App) -> Self {
        let (sender, wakes) = channel();
        // Sending fails once the program is gone: then nobody is to be woken.
        let app = start(Arc::new(move |wake| drop(sender.send(wake))));
        Self {
            app,
            wakes,
            picture: MemoryPicture {
                canvas: None,
                restraint: Restraint::default(),
                size: Viewport::DEFAULT,
                page: None,
            },
        }
    }

    /// Gives its context the window's looks.
    #[doc(hidden)] // public for tests
    pub fn dress(&self) {
        self.app.dress();
    }

    /// Lays out the panels for the input at hand, and executes their commands.
    #[doc(hidden)] // public for tests
    pub fn ui(&mut self, ui: &mut Ui) {
        self.app.ui(ui);
    }

    /// The inputs that a window makes of one, such as that of a slow frame: text goes to the field that it was typed
    /// into.
    #[doc(hidden)] // public for tests
    pub fn in_turn(input: RawInput) -> Vec<RawInput> {
        in_turn(input)
    }

    /// Takes the changes of egui's textures.
    #[doc(hidden)] // public for tests
    pub fn take_textures(&mut self, changes: TexturesDelta) {
        self.app.textures.append(changes);
    }

    /// Draws what the panels have put out last, as a window does. Returns whether a new picture of the scene is shown.
    #[doc(hidden)] // public for tests
    pub fn draw(&mut self, output: &mut FullOutput, size: Viewport) -> Result<bool, GpuError> {
        self.picture.size = size;
        self.app.draw_frame(output, &mut self.picture)
    }

    /// Runs the panels on an input, and draws them, as a window does.
    pub fn frame(&mut self, input: RawInput, size: Viewport) -> Frame {
        self.picture.size = size;
        self.app.frame(input, &mut self.picture)
    }

    /// The frame that was drawn last, as it is on the screen. It is an error if nothing was drawn yet.
    pub fn drawn(&self) -> Result<Image<Rgb>, GpuError> {
        match (&self.picture.canvas, &self.picture.page) {
            (Some(canvas), Some(page)) => read_rgb(canvas.gpu(), page, self.picture.size),
            _ => Err(GpuError::NoAdapter),
        }
    }

    /// Whether the picture on screen gets better once nothing has moved for [`REST_S`].
    pub fn is_rough(&self) -> bool {
        self.app.rest.is_rough
    }

    /// Whether the last frame left nothing to do but that.
    pub fn is_settled(&self) -> bool {
        self.app.rest.is_settled
    }

    /// Whether something is under way that will change what is shown.
    pub fn is_busy(&self) -> bool {
        self.app.is_busy()
    }

    /// Waits until nothing is under way.
    pub fn finish_jobs(&mut self) {
        while self.is_busy() {
            self.wait_for_jobs();
        }
    }

    /// egui's input at a time, for a picture of this size at scale 1.
    pub fn input_at(time_s: f64, size: Viewport) -> RawInput {
        #[expect(clippy::cast_precision_loss, reason = "no picture is that large")]
        let sides = [size.width(), size.height()].map(|px| px as f32);
        RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, sides.into())),
            time: Some(time_s),
            ..RawInput::default()
        }
    }

    /// Waits a moment for what is under way, and takes what has come of it. Returns whether anything has.
    pub fn wait_for_jobs(&mut self) -> bool {
        let wake = self.wakes.recv_timeout(Duration::from_millis(5));
        let has_come = wake.is_ok();
        // Only answers of dialogs are taken here: a test has a desktop of its own.
        if let Ok(Wake::Answered(number, what, answer)) = wake {
            self.app.answered(number, what, answer);
        }
        self.app.take_finished();
        has_come
    }

    /// Takes what has come of jobs.
    #[doc(hidden)] // public for tests
    pub fn take_finished(&mut self) {
        self.app.take_finished();
    }

    /// The next events act as if the wanted picture were on screen.
    #[doc(hidden)] // public for tests
    pub fn see_wanted(&mut self) {
        self.app.state.see(Seen::Wanted);
    }

    /// Where screenshots go.
    pub fn save_screenshots_in(&mut self, folder: PathBuf) {
        self.app.screenshots.folder = folder;
    }

    /// Makes all pipelines ahead, as an idle window does one at a time.
    pub fn prepare_all(&mut self) {
        while self.app.prepare(&mut self.picture) {}
    }

    /// Draws with a device that can do no more than this, from the next picture on.
    pub fn restrain(&mut self, restraint: Restraint) {
        self.picture.restraint = restraint;
        self.picture.canvas = None;
    }

    /// Destroys the device, as a driver that restarts does.
    pub fn lose_device(&mut self) {
        if let Some(canvas) = &self.picture.canvas {
            canvas.gpu().device.destroy();
            // The next poll reports the loss.
            let _ = canvas.gpu().wait();
        }
    }
}
