//! The gallery: from scene to scene, with the study's chart beside it.

use super::{errands::Purpose, program::App};
use crate::{
    scene::gallery::{Exhibit, GALLERY},
    viewer::{jobs::Chart, model::Showing},
};

impl App {
    /// Opens the gallery's scene after the one on screen, or before it; the first if none is on screen.
    pub fn open_next_exhibit(&mut self, forward: bool) {
        let on_screen = |exhibit: &Exhibit| {
            (self.state.showing()).is_some_and(|showing| showing.exhibit == exhibit)
        };
        let step = if forward { 1 } else { GALLERY.len() - 1 };
        let next =
            (GALLERY.iter().position(on_screen)).map_or(0, |now| (now + step) % GALLERY.len());
        self.load(vec![GALLERY[next].path()], Purpose::Open);
    }

    /// Takes the chart for the scene of the gallery, or begins to compute it.
    pub fn take_chart(&mut self) {
        let Some(subject) = self.state.showing().and_then(Showing::subject) else {
            self.chart = None;
            return;
        };
        match &mut self.chart {
            Some(chart) if chart.is_of(subject) => chart.poll(),
            _ => {
                let (scene, view) = (self.state.scene().clone(), *self.state.view());
                self.chart = Some(Chart::start(subject, scene, view, self.waker()));
            }
        }
    }
}
