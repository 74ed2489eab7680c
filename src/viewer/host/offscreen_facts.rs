//! What is so in the program without a window system.

use super::offscreen::Offscreen;
use crate::{render::Gpu, viewer::model::State};

impl Offscreen {
    /// What stands in the window's title.
    pub fn title(&self) -> String {
        self.app.title()
    }

    /// What it shows.
    pub fn state(&self) -> &State {
        &self.app.state
    }

    /// The messages that wait to be read, oldest first.
    pub fn messages(&self) -> impl Iterator<Item = &str> {
        let notices = self.app.notices.iter();
        notices.map(|notice| notice.text.as_str())
    }

    /// How many triangles of meshes were uploaded so far.
    pub fn uploaded_triangles(&self) -> u64 {
        self.gpu().map_or(0, Gpu::uploaded_triangles)
    }

    /// Whether it fills the screen.
    pub fn is_full_screen(&self) -> bool {
        self.app.fills_screen
    }

    /// Whether the user has closed it.
    pub fn has_quit(&self) -> bool {
        self.app.quit
    }

    /// What the adapter calls itself, once something was drawn.
    pub fn adapter_name(&self) -> &str {
        self.gpu().map_or("", Gpu::adapter_name)
    }

    /// Whether the adapter is a program on the CPU, once something was drawn.
    pub fn is_software(&self) -> bool {
        self.gpu().is_some_and(Gpu::is_software)
    }

    fn gpu(&self) -> Option<&Gpu> {
        Some(self.picture.canvas.as_ref()?.gpu())
    }
}
