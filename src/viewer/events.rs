//! The event loop's side: events in, passes over the panels, frames out.

use super::{
    Command, Wake,
    action::Action,
    app::App,
    frame::Panels,
    input::SceneRect,
    loading::Answer,
    panels::{self, Shown},
    shell::Shell,
};
use std::time::{Duration, Instant};
use winit::{
    application::ApplicationHandler,
    dpi::PhysicalSize,
    event::{StartCause, WindowEvent},
    event_loop::{ActiveEventLoop, ControlFlow},
    window::WindowId,
};

/// What a pass over the panels leaves to draw.
struct Pass {
    shapes: Vec<egui::epaint::ClippedShape>,
    pixels_per_point: f32,
    /// Where the scene goes; `None` where there is no room for it.
    place: Option<SceneRect>,
}

impl App {
    /// Shows the panels to what has happened since the last pass and does what that asks for.
    fn pass(&mut self, event_loop: &ActiveEventLoop) -> Option<Pass> {
        let shell = self.shell.as_mut()?;
        let input = shell.egui.take_egui_input(&shell.window);
        let dropped: Vec<_> = input
            .dropped_files
            .iter()
            .map(|file| file.path().to_path_buf())
            .collect();
        let context = shell.egui.egui_ctx().clone();
        let mut commands = Vec::new();
        let mut place = None;
        let output = context.run_ui(input, |ui| {
            let mut shown = Shown {
                state: &self.state,
                notices: &mut self.notices,
                loading: self.loading.as_ref().map(|(load, ..)| load.fraction()),
                floating: self.floating,
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
        shell
            .egui
            .handle_platform_output(&shell.window, output.platform_output);
        shell.textures.append(output.textures_delta);
        if !dropped.is_empty() {
            commands.push(Command::Open(dropped));
        }
        let idle = |command: &Command| {
            matches!(command, Command::Act(Action::Hover(_) | Action::Resize(_)))
        };
        let (acted, hover) = (!commands.iter().all(idle), self.state.hover());
        for command in commands {
            self.run_command(command, event_loop);
        }
        // The panels showed the state before that: they show what came of it in the next pass.
        if acted || hover != self.state.hover() {
            context.request_repaint();
        } else if self.loading.is_some() {
            context.request_repaint_after(Duration::from_millis(50));
        }
        Some(Pass {
            shapes: output.shapes,
            pixels_per_point: output.pixels_per_point,
            place,
        })
    }

    fn redraw(&mut self, event_loop: &ActiveEventLoop) {
        let start = Instant::now();
        self.take_loaded();
        self.take_checked();
        let Some(pass) = self.pass(event_loop) else {
            return;
        };
        let Some(shell) = &mut self.shell else { return };
        shell
            .window
            .set_title(&format!("{} \u{2013} Sightline", self.state.name()));
        let context = shell.egui.egui_ctx();
        let panels = Panels {
            primitives: context.tessellate(pass.shapes, pass.pixels_per_point),
            textures: std::mem::take(&mut shell.textures),
            pixels_per_point: pass.pixels_per_point,
        };
        match shell.frame.draw(&self.state, pass.place, panels) {
            Ok(true) => {
                self.statistics.frame = start.elapsed();
                self.announce();
            }
            Ok(false) => {}
            Err(error) => {
                context.request_repaint();
                self.complain(error.to_string());
            }
        }
        self.start_check();
    }

    fn request_redraw(&self) {
        if let Some(shell) = &self.shell {
            shell.window.request_redraw();
        }
    }
}

impl ApplicationHandler<Wake> for App {
    fn new_events(&mut self, event_loop: &ActiveEventLoop, cause: StartCause) {
        if let StartCause::ResumeTimeReached { .. } = cause {
            event_loop.set_control_flow(ControlFlow::Wait);
            self.request_redraw();
        }
    }

    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.shell.is_some() {
            return;
        }
        match Shell::open(event_loop, &self.options, &self.proxy) {
            Ok(shell) => {
                self.statistics.adapter = shell.frame.adapter_name();
                self.statistics.software = shell.frame.is_software();
                self.shell = Some(shell);
                self.request_redraw();
            }
            Err(error) => {
                self.failed = Some(error);
                event_loop.exit();
            }
        }
    }

    fn user_event(&mut self, event_loop: &ActiveEventLoop, wake: Wake) {
        match wake {
            Wake::Look => self.request_redraw(),
            Wake::Answered(answer) => {
                match answer {
                    Answer::Open(paths) => self.open(paths),
                    Answer::Save(path) => self.save(path),
                    Answer::NoDialog => self.complain(
                        "this desktop shows no file dialog: drop files on the window, or name them when starting".into(),
                    ),
                }
                self.request_redraw();
            }
            Wake::RepaintAt(time) if time <= Instant::now() => self.request_redraw(),
            Wake::RepaintAt(time) => event_loop.set_control_flow(ControlFlow::WaitUntil(time)),
        }
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        let Some(shell) = &mut self.shell else {
            return;
        };
        match &event {
            WindowEvent::CloseRequested => return event_loop.exit(),
            WindowEvent::RedrawRequested => return self.redraw(event_loop),
            WindowEvent::Resized(PhysicalSize { width, height }) => {
                shell.frame.resize(*width, *height);
            }
            _ => {}
        }
        // A press, the moves after it and the release are each seen in a pass of their own, however slow frames are:
        // of what happens within one pass egui sees only the end.
        let is_button = matches!(event, WindowEvent::MouseInput { .. });
        if is_button {
            self.pass(event_loop);
        }
        let Some(shell) = &mut self.shell else { return };
        if shell.egui.on_window_event(&shell.window, &event).repaint {
            self.request_redraw();
        }
        if is_button {
            self.pass(event_loop);
        }
    }
}
