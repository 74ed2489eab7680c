//! egui's textures, kept for a device that may replace this one.

use egui::TexturesDelta;

/// All of egui's textures.
#[derive(Default)]
pub(in crate::viewer) struct Textures {
    all: TexturesDelta,
    /// The changes that no canvas has taken yet.
    pub news: TexturesDelta,
}

impl Textures {
    /// Adds the changes of a pass.
    pub fn append(&mut self, delta: TexturesDelta) {
        self.all.append(delta.clone());
        self.all.free.clear();
        self.news.append(delta);
    }

    /// A new device has no textures: all of them are changes again.
    pub fn renew(&mut self) {
        self.news.clear();
        self.news.append(self.all.clone());
    }
}

impl Drop for Textures {
    fn drop(&mut self) {
        // egui asserts that nothing is lost by accident.
        self.all.clear();
        self.news.clear();
    }
}
