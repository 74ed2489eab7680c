//! A loaded scene, until it is shown.

use super::{
    errands::{Arrival, Pending, Purpose},
    program::App,
};
use crate::viewer::ui::{Attempt, Underway};

impl App {
    /// Shows a loaded scene, or asks first.
    pub(super) fn arrive(&mut self, arrival: Arrival) {
        self.ready = Some(arrival);
        self.take_ready();
    }

    /// Shows what has arrived. If that would drop edits that were made while it was loaded, asks first. While a
    /// question waits for an answer, this waits too.
    pub(super) fn take_ready(&mut self) {
        if self.question.is_some() {
            return;
        }
        let Some(arrival) = self.ready.take() else {
            return;
        };
        let errand = &arrival.errand;
        let drops_more = !errand.is_stale(&self.state) && errand.drops_more(&self.state);
        match errand.intent().filter(|_| drops_more) {
            Some(_) if errand.purpose == Purpose::Follow => self.keep_edits(),
            Some(intent) => self.ask(Pending {
                intent,
                arrival: Some(Box::new(arrival)),
            }),
            None => self.show_arrival(arrival),
        }
    }

    /// Shows a loaded scene.
    pub(super) fn show_arrival(&mut self, arrival: Arrival) {
        if arrival.errand.is_stale(&self.state) {
            return;
        }
        match self.show_scene(*arrival.loaded, arrival.errand) {
            Ok(()) => self.build_trees(),
            Err(text) => self.failed(Attempt::Open, text),
        }
    }

    /// Cancels loading. Returns whether there was anything to cancel.
    pub(super) fn stop_arriving(&mut self) -> bool {
        let loading = self.loading.take();
        if let Some((_, errand)) = &loading {
            self.give_up_change(errand);
        }
        loading.is_some()
    }

    /// What is being loaded, for the progress message.
    pub(super) fn underway(&self) -> Option<Underway> {
        let loading = self.loading.as_ref();
        loading.map(|(load, _)| ("loading", Some(load.fraction())))
    }
}
