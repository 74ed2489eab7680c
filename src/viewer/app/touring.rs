//! The program's part in the tour, and in the gallery: from scene to scene, with the study's chart beside it.

use super::program::App;
use crate::{
    camera::{View, Viewport},
    scene::gallery::{Exhibit, GALLERY},
    viewer::{
        jobs::Chart,
        model::Showing,
        ui::{Command, Intent, JustDone, Start, Topic, TourMove},
    },
};

impl App {
    /// Moves through the tour, in the demo.
    pub(super) fn go_on_tour(&mut self, to: TourMove) {
        self.memory.toured = true;
        self.tour = self.tour.unwrap_or_default().after(to);
        let step = self.tour.map(|tour| tour.step().2);
        if to == TourMove::Begin {
            self.want_demo();
        }
        self.begin(step.and_then(|step| step.start));
    }

    /// Shows one pick in four spaces, of the demo.
    pub(super) fn show_one_pick(&mut self) {
        self.want_demo();
        self.begin(Some(Start {
            then: |_| vec![Command::ToggleFour],
            topics: &[Topic::WorkedOut],
            ..Start::EGG
        }));
    }

    fn want_demo(&mut self) {
        if !self.state.is_demo() {
            self.intend(Intent::Open(Vec::new()));
        }
    }

    /// Whether the tour is offered: as long as the demo is shown and the user has not answered.
    pub(super) fn offers_tour(&self) -> bool {
        let remembers = self.options.memory.is_some();
        remembers && !self.memory.toured && self.state.is_demo()
    }

    /// Checks whether the tour's step is done, after a command or any other change.
    pub(super) fn notice_step(&mut self, command: Option<&Command>) {
        // What was there before the step began does not count.
        if self.beginning.is_some() && self.state.is_demo() {
            return;
        }
        let Some(tour) = &mut self.tour else { return };
        let done = JustDone {
            command,
            state: &self.state,
            matrices: self.memory.panels.shows(Topic::Matrices),
            checking: &self.checking,
        };
        if tour.notice(&done) {
            self.context.request_repaint();
        }
    }

    /// Opens the gallery's scene after the one on screen, or before it; the first if none is on screen.
    pub fn open_next_exhibit(&mut self, forward: bool) {
        let on_screen = |exhibit: &Exhibit| {
            (self.state.showing()).is_some_and(|showing| showing.exhibit == exhibit)
        };
        let step = if forward { 1 } else { GALLERY.len() - 1 };
        let next =
            (GALLERY.iter().position(on_screen)).map_or(0, |now| (now + step) % GALLERY.len());
        self.intend(Intent::Open(vec![GALLERY[next].path()]));
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
                let scene = self.state.scene().clone();
                // The window may not be laid out yet, and its size is to change nothing.
                let view = View {
                    viewport: Viewport::DEFAULT,
                    ..*self.state.view()
                };
                self.chart = Some(Chart::start(subject, scene, view, self.waker()));
            }
        }
    }
}
