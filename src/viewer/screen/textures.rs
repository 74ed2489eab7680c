//! egui's textures, kept for the device that may come after this one.

use egui::TexturesDelta;

/// All of egui's textures, and those of them that no canvas was given yet.
#[derive(Default)]
pub(in crate::viewer) struct Textures {
    all: TexturesDelta,
    news: TexturesDelta,
}

impl Textures {
    /// What a pass made and gave up.
    pub fn append(&mut self, delta: TexturesDelta) {
        self.all.append(delta.clone());
        self.all.free.clear();
        self.news.append(delta);
    }

    /// What a canvas is to take from here.
    pub fn news(&mut self) -> &mut TexturesDelta {
        &mut self.news
    }

    /// A new device has none: all are news again.
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
