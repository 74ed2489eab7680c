//! One pass over the panels: egui's input in, commands done, triangles out. The same with and without a window.

use super::{
    Command,
    action::Action,
    app::App,
    canvas::{Canvas, Laid},
    input::{self, SceneRect},
    overlay::Overlay,
    panels::{self, Shown},
    state::Cursor,
};
use crate::render::GpuError;
use std::time::Duration;

/// What a pass leaves to draw, and to tell the system.
pub(super) struct Pass {
    shapes: Vec<egui::epaint::ClippedShape>,
    pixels_per_point: f32,
    /// Where the scene goes; `None` where there is no room for it.
    place: Option<SceneRect>,
    /// Clipboard, cursor and the like.
    pub platform: egui::PlatformOutput,
}

/// egui as the viewer wants it: panels as dark as the scene, whatever the desktop's theme, with words that are
/// readable on them.
pub(super) fn context() -> egui::Context {
    let context = egui::Context::default();
    input::options(&context);
    context.set_theme(egui::Theme::Dark);
    let mut visuals = egui::Visuals::dark();
    visuals.error_fg_color = egui::Color32::from_rgb(255, 120, 105);
    // For projectors, which swallow dark greys.
    visuals.override_text_color = Some(egui::Color32::from_gray(222));
    visuals.weak_text_color = Some(egui::Color32::from_gray(160));
    context.set_visuals(visuals);
    context
}

impl App {
    /// Shows the panels to what has happened since the last pass and does what that asks for.
    pub fn pass(&mut self, input: egui::RawInput) -> Pass {
        let dropped: Vec<_> = input
            .dropped_files
            .iter()
            .map(|file| file.path().to_path_buf())
            .collect();
        self.take_chart();
        let mut commands = Vec::new();
        let mut place = None;
        let context = self.context.clone();
        let mut output = context.run_ui(input, |ui| {
            let mut shown = Shown {
                state: &self.state,
                notices: &mut self.notices,
                loading: self.loading.as_ref().map(|(load, ..)| load.fraction()),
                floating: self.floating,
                chart: self.chart.as_ref(),
                checking: &self.checking,
                statistics: &self.statistics,
                filter: &mut self.filter,
                reveal_selection: self.reveal_selection,
            };
            let (scene, asked) = panels::show(ui, &mut shown, &mut self.drag);
            place = scene;
            commands.extend(asked);
        });
        self.reveal_selection = false;
        self.textures.append(output.textures_delta);
        if !dropped.is_empty() {
            commands.push(Command::Open(dropped));
        }
        let idle = |command: &Command| {
            matches!(command, Command::Act(Action::Hover(_) | Action::Resize(_)))
        };
        let (acted, cursor) = (!commands.iter().all(idle), self.state.cursor());
        for command in commands {
            self.run_command(command);
        }
        // The panels showed the state before that: they show what came of it in the next pass.
        let follows_cursor = self.floating.pipeline && cursor != self.state.cursor();
        let hovered = |cursor: Option<Cursor>| Some(cursor?.hit?.0);
        if acted || follows_cursor || hovered(cursor) != self.state.hover() {
            context.request_repaint();
        } else if self.loading.is_some() {
            context.request_repaint_after(Duration::from_millis(50));
        }
        let copied = self.copied.take().map(egui::OutputCommand::CopyText);
        output.platform_output.commands.extend(copied);
        Pass {
            shapes: output.shapes,
            pixels_per_point: output.pixels_per_point,
            place,
            platform: output.platform_output,
        }
    }

    /// A pass as triangles, with the textures that they need given to the canvas that will draw them.
    pub fn lay(&mut self, pass: Pass, canvas: &mut Canvas) -> Laid {
        canvas.take_textures(self.textures.news());
        Laid {
            place: pass.place,
            primitives: self.context.tessellate(pass.shapes, pass.pixels_per_point),
            pixels_per_point: pass.pixels_per_point,
        }
    }

    /// Takes what came of drawing a frame: whether the scene itself was drawn anew.
    pub fn drawn(&mut self, drawn: Result<bool, GpuError>, canvas: &mut Canvas, laid: &Laid) {
        match drawn {
            Ok(true) => self.announce(),
            Ok(false) => {}
            Err(error) => self.complain(error.to_string()),
        }
        if self.state.overlays().shows(Overlay::Wireframe) && !canvas.gpu.draws_wireframes() {
            self.act(Action::Toggle(Overlay::Wireframe));
            let adapter = canvas.gpu.adapter_name();
            self.complain(format!(
                "{adapter} draws no edges of triangles: there is no wireframe"
            ));
        }
        self.start_check(canvas);
        self.take_screenshot(canvas, laid);
    }
}
