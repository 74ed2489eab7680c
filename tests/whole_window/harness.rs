//! The window without a window system, in `egui_kittest`: egui's events in, pictures out.
//!
//! kittest owns egui's context, runs the panels and keeps their accessibility tree, in which controls are found by name.
//! So the tree is always made, as with a screen reader, and the panels lie in a part of kittest's own. What is drawn is
//! drawn by the program itself, as in its window.

use crate::dropped::Dropped;
use egui::{
    ColorImage, Context, Event, OutputCommand, RawInput, Rect, Role, Shape, TexturesDelta, Theme,
    UiBuilder,
    accesskit::{Action, Toggled},
    epaint::ClippedShape,
    pos2,
};
use egui_kittest::{
    Harness, TestRenderer,
    kittest::{AccessKitNode, NodeT},
};
use sightline::{
    camera::Viewport,
    image::{Image, Rgb},
    render::{GpuError, Restraint},
    viewer::{Offscreen, Options, REST_S, model::State},
};
use std::{
    cell::RefCell,
    mem,
    path::PathBuf,
    rc::Rc,
    sync::{Arc, Mutex, PoisonError},
    time::{Duration, Instant},
};

/// If one event takes more frames than this, the panels never come to rest: a cursor blinks, or a message waits to go.
const MOST_FRAMES: usize = 100;
/// No job takes as long as this.
const LONGEST_WAIT: Duration = Duration::from_mins(2);
/// Seconds between two passes.
const FRAME_S: f64 = 1.0 / 60.0;

/// A window that nobody sees.
pub struct Window {
    /// The program, from its first pass on.
    harness: Harness<'static, Option<Offscreen>>,
    textures: Textures,
    size: Viewport,
    time_s: f64,
    copied: Option<String>,
    copied_picture: Option<ColorImage>,
    controls: Vec<Control>,
    is_settled: bool,
    due: Due,
}

/// A button, a field, a text, as screen readers see it.
#[derive(Clone, Debug, PartialEq)]
pub struct Control {
    /// Its name; for a text, the text itself. Empty if it has no name.
    pub name: String,
    /// What it is.
    pub role: Role,
    /// Its value; empty if it cannot have one.
    pub value: String,
    /// Its description, such as why a number is refused; empty if there is none.
    pub description: String,
    /// Whether it is ticked or chosen.
    pub is_on: bool,
    /// Whether it can be used.
    pub is_enabled: bool,
    /// Whether it has the keyboard focus.
    pub has_focus: bool,
    /// Where it is, in points.
    pub rect: Rect,
}

/// The changes of egui's textures that the program has not taken yet.
#[derive(Clone, Default)]
struct Textures(Rc<RefCell<TexturesDelta>>);

impl TestRenderer for Textures {
    fn handle_delta(&mut self, delta: &mut TexturesDelta) {
        self.0.borrow_mut().append(mem::take(delta));
    }
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

impl Window {
    /// A window of `size` physical pixels, with `pixels_per_point` pixels to a point. It loads what `options` name.
    pub fn open(options: Options, size: Viewport, pixels_per_point: f32) -> Self {
        let (textures, due, mut options) = (Textures::default(), Due::default(), Some(options));
        let panels = move |ui: &mut egui::Ui, program: &mut Option<Offscreen>| {
            let context = ui.ctx().clone();
            // kittest leaves a margin, a window none.
            let whole = UiBuilder::new().max_rect(context.content_rect());
            let mut whole = ui.new_child(whole);
            whole.set_clip_rect(context.content_rect());
            let start = || Offscreen::open(options.take().expect("the first pass"), context);
            program.get_or_insert_with(start).ui(&mut whole);
        };
        #[expect(clippy::cast_precision_loss, reason = "windows are not that large")]
        let points = [size.width(), size.height()].map(|px| px as f32 / pixels_per_point);
        let harness = Harness::builder()
            .with_size(points)
            .with_pixels_per_point(pixels_per_point)
            .allow_missing_glyphs()
            .renderer(textures.clone())
            .build_ui_state(panels, None);
        let mut window = Self {
            textures,
            size,
            time_s: harness.ctx.input(|input| input.time),
            harness,
            copied: None,
            copied_picture: None,
            controls: Vec::new(),
            is_settled: false,
            due: due.clone(),
        };
        // kittest has changed the styles, so that nothing moves.
        window.program().dress();
        let ask = move |info: egui::RequestRepaintInfo| due.ask(info.delay.as_secs_f64());
        window.context().set_request_repaint_callback(ask);
        window.settle();
        window
    }

    fn program(&self) -> &Offscreen {
        self.harness.state().as_ref().expect("it runs")
    }

    fn program_mut(&mut self) -> &mut Offscreen {
        self.harness.state_mut().as_mut().expect("it runs")
    }

    fn context(&self) -> &Context {
        &self.harness.ctx
    }

    /// Runs a pass for each event, then waits for the jobs that these began. Positions are in points. Nothing is drawn.
    /// Events act as if the wanted picture were on screen.
    pub fn send(&mut self, events: impl IntoIterator<Item = Event>) {
        for event in events {
            self.program_mut().see_wanted();
            self.pass(vec![event]);
        }
        self.settle();
    }

    /// Runs a pass for each event, as a window does with those that come while it draws: what was drawn last is on
    /// screen all the time.
    pub fn send_undrawn(&mut self, events: impl IntoIterator<Item = Event>) {
        for event in events {
            self.pass(vec![event]);
        }
        self.settle();
    }

    /// Runs all of the events as one input, as after a slow frame.
    pub fn send_at_once(&mut self, events: Vec<Event>) {
        self.pass_in_turn(events);
        self.settle();
    }

    /// Lets time pass without events.
    pub fn wait_s(&mut self, seconds: f64) {
        self.time_s += seconds;
        self.settle();
    }

    /// Gives the window another size in physical pixels.
    pub fn resize(&mut self, size: Viewport) {
        self.size = size;
        self.settle();
    }

    /// Makes the desktop dark or light.
    pub fn set_theme(&mut self, theme: Theme) {
        self.harness.input_mut().system_theme = Some(theme);
        self.settle();
    }

    /// Drops a file on the window and waits for what comes of it.
    pub fn drop_file(&mut self, path: PathBuf) {
        self.begin_to_drop(path);
        self.settle();
    }

    /// Drops a file on the window and waits for nothing: later frames take the result.
    pub fn begin_to_drop(&mut self, path: PathBuf) {
        self.harness.input_mut().dropped_files = vec![Arc::new(Dropped(path))];
        self.pass(Vec::new());
    }

    /// Opens files, as when the dialog is answered with them.
    pub fn open_files(&mut self, paths: Vec<PathBuf>) {
        self.settle_after(|program| program.open_files(paths));
    }

    /// Saves to a file, as when the dialog is answered with it.
    pub fn save_as(&mut self, path: PathBuf) {
        self.settle_after(|program| program.save_as(path));
    }

    /// Cancels the save dialog.
    pub fn save_nowhere(&mut self) {
        self.settle_after(Offscreen::save_nowhere);
    }

    /// Answers that no dialog to open files can be shown.
    pub fn open_without_dialog(&mut self) {
        self.settle_after(Offscreen::open_without_dialog);
    }

    /// Answers that no dialog to save can be shown.
    pub fn save_without_dialog(&mut self) {
        self.settle_after(Offscreen::save_without_dialog);
    }

    /// Closes the window, as the button of its frame does.
    pub fn close(&mut self) {
        self.settle_after(Offscreen::close);
    }

    /// Tells the program something, and waits for what comes of it.
    fn settle_after(&mut self, tell: impl FnOnce(&mut Offscreen)) {
        tell(self.program_mut());
        self.settle();
    }

    /// Where screenshots go.
    pub fn save_screenshots_in(&mut self, folder: PathBuf) {
        self.program_mut().save_screenshots_in(folder);
    }

    /// Draws with a device that can do no more than this, from the next picture on.
    pub fn restrain(&mut self, restraint: Restraint) {
        self.program_mut().restrain(restraint);
    }

    /// Destroys the device, as a driver that restarts does.
    pub fn lose_device(&mut self) {
        self.program_mut().lose_device();
    }

    /// Draws the frame after these events as a window does, without waiting for more events, and the scene only if it
    /// changed. Returns whether a new picture of the scene is shown.
    pub fn draw(&mut self, events: impl IntoIterator<Item = Event>) -> Result<bool, GpuError> {
        self.pass_in_turn(events.into_iter().collect());
        self.take_controls();
        let mut output = self.harness.output().clone();
        leave_out_background(&mut output.shapes);
        let changes = mem::take(&mut *self.textures.0.borrow_mut());
        let size = self.size;
        let program = self.program_mut();
        program.take_textures(changes);
        let drawn = program.draw(&mut output, size);
        self.is_settled = self.program().is_settled();
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

    fn draw_whole(&mut self) -> Result<(), GpuError> {
        self.draw([])?;
        if self.program().is_rough() {
            self.time_s += REST_S;
        }
        while self.program().is_rough() {
            self.draw([])?;
        }
        Ok(())
    }

    /// Runs the panels on events that come together.
    fn pass_in_turn(&mut self, events: Vec<Event>) {
        let input = RawInput {
            events,
            ..RawInput::default()
        };
        for part in Offscreen::in_turn(input) {
            self.pass(part.events);
        }
    }

    /// Runs the panels once, a frame later than before.
    fn pass(&mut self, events: Vec<Event>) {
        self.time_s += FRAME_S;
        self.program_mut().take_finished();
        let scale = self.context().pixels_per_point();
        #[expect(clippy::cast_precision_loss, reason = "windows are not that large")]
        let points = [self.size.width(), self.size.height()].map(|px| px as f32 / scale);
        self.harness.set_size(points.into());
        let input = self.harness.input_mut();
        input.time = Some(self.time_s);
        input.events = events;
        self.harness.step();
        for command in &self.harness.output().platform_output.commands {
            match command {
                OutputCommand::CopyText(text) => self.copied = Some(text.clone()),
                OutputCommand::CopyImage(picture) => self.copied_picture = Some(picture.clone()),
                _ => {}
            }
        }
    }

    /// Runs passes until nothing moves and nothing is under way. As a window does, it runs none before one is due.
    fn settle(&mut self) {
        let start = Instant::now();
        let mut left = MOST_FRAMES;
        while left > 0 {
            while self.program().is_busy() && start.elapsed() < LONGEST_WAIT {
                self.program_mut().wait_for_jobs();
            }
            self.due.take();
            self.pass(Vec::new());
            left -= 1;
            let is_busy = self.program().is_busy();
            self.is_settled = !self.context().has_requested_repaint() && !is_busy;
            if self.is_settled {
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

    fn take_controls(&mut self) {
        let nodes = self.harness.root().children_recursive();
        self.controls = nodes
            .filter_map(|node| control(&node.accesskit_node()))
            .collect();
    }

    /// The window's controls and texts, by its accessibility tree.
    pub fn controls(&self) -> &[Control] {
        &self.controls
    }

    /// The frame that was drawn last, as it is on the screen. It is an error if nothing was drawn yet.
    pub fn drawn(&self) -> Result<Image<Rgb>, GpuError> {
        self.program().drawn()
    }

    /// What stands in the window's title.
    pub fn title(&self) -> String {
        self.program().title()
    }

    /// What it shows.
    pub fn state(&self) -> &State {
        self.program().state()
    }

    /// The messages that wait to be read, oldest first.
    pub fn messages(&self) -> impl Iterator<Item = &str> {
        self.program().messages()
    }

    /// Whether the window is at rest after the last event: nothing is animated, and nothing but smooth edges is under
    /// way.
    pub fn is_at_rest(&self) -> bool {
        self.is_settled
    }

    /// How many triangles of meshes were uploaded so far.
    pub fn uploaded_triangles(&self) -> u64 {
        self.program().uploaded_triangles()
    }

    /// Whether it fills the screen.
    pub fn is_full_screen(&self) -> bool {
        self.program().is_full_screen()
    }

    /// Whether the panels have a glyph for each character of a text.
    pub fn can_write(&self, text: &str) -> bool {
        let font = egui::FontId::default();
        self.context()
            .fonts_mut(|fonts| fonts.has_glyphs(&font, text))
    }

    /// What was put on the clipboard last.
    pub fn copied(&self) -> Option<&str> {
        self.copied.as_deref()
    }

    /// The picture that was put on the clipboard last.
    pub fn copied_picture(&self) -> Option<&ColorImage> {
        self.copied_picture.as_ref()
    }

    /// Whether the user has closed it.
    pub fn has_quit(&self) -> bool {
        self.program().has_quit()
    }

    /// Whether a file dialog is open.
    pub fn has_dialog(&self) -> bool {
        self.program().has_dialog()
    }

    /// How often the panels were laid out so far: once a frame, or more often where the first time changes what they
    /// show.
    pub fn passes(&self) -> u64 {
        self.context().cumulative_pass_nr()
    }

    /// What the adapter calls itself, once something was drawn.
    pub fn adapter_name(&self) -> &str {
        self.program().adapter_name()
    }

    /// Whether the adapter is a program on the CPU, once something was drawn.
    pub fn is_software(&self) -> bool {
        self.program().is_software()
    }
}

impl Drop for Window {
    fn drop(&mut self) {
        // egui asserts that no change is lost by accident.
        self.textures.0.borrow_mut().clear();
    }
}

/// kittest paints a panel behind everything, which would hide the scene.
fn leave_out_background(shapes: &mut Vec<ClippedShape>) {
    let first = &shapes[0].shape;
    assert!(matches!(first, Shape::Rect(_) | Shape::Noop), "{first:?}");
    shapes.remove(0);
}

/// A node that has a name or can be used.
fn control(node: &AccessKitNode<'_>) -> Option<Control> {
    let (has_focus, node) = (node.is_focused(), node.data());
    let value = node.value().unwrap_or_default();
    // A field shows its number shortened.
    let is_field = matches!(node.role(), Role::SpinButton | Role::TextInput);
    let number = node.numeric_value().filter(|_| !is_field);
    let number = number.map(|number| number.to_string());
    let said = (node.role() == Role::Label).then_some(value);
    let is_of_use = node.supports_action(Action::Click) || node.supports_action(Action::Focus);
    let name = node.label().or(said).or(is_of_use.then_some(""))?;
    let bounds = node.bounds()?;
    #[expect(clippy::cast_possible_truncation, reason = "egui made them of f32")]
    let [left, top, right, bottom] =
        [bounds.x0, bounds.y0, bounds.x1, bounds.y1].map(|at| at as f32);
    Some(Control {
        name: name.to_owned(),
        role: node.role(),
        value: number.unwrap_or_else(|| value.to_owned()),
        description: node.description().unwrap_or_default().to_owned(),
        is_on: node.toggled() == Some(Toggled::True),
        is_enabled: !node.is_disabled(),
        has_focus,
        rect: Rect::from_min_max(pos2(left, top), pos2(right, bottom)),
    })
}
