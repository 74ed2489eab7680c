//! Applies actions to the state, and starts what they call for: tree builds, comparisons, snapping.

use super::program::{App, Host};
use crate::{
    json,
    viewer::{
        jobs::Checking,
        model::{Action, MeasureAction, Overlay, Views, pick_command},
        screen::shown_trees,
        ui::Topic,
    },
};
use std::time::Instant;

impl App {
    /// Applies an action to the scene or the view. An edit waits for the end of a load. A click does not wait for trees:
    /// its ray tries every triangle.
    pub fn act(&mut self, action: Action) {
        if self.waits(&action) {
            return;
        }
        let clicks = matches!(action, Action::Click(..)) && !self.state.awaits_scene();
        let start = Instant::now();
        let (method, scene) = (self.state.method(), self.state.scene_revision());
        let picked = self.state.apply(action);
        if let Some(why) = self.shows_nothing(action) {
            self.say(why.into());
        }
        if self.state.scene_revision() != scene {
            self.build_trees();
        }
        if self.state.method() != method {
            self.checking = match self.state.method() {
                Some(_) => Checking::Wanted,
                None => Checking::Off,
            };
        }
        if let Some(topic) = self.turned_on(action) {
            self.memory.panels.show(topic);
        }
        if clicks {
            if self.host == Host::Window {
                self.statistics.pick = Some(start.elapsed());
            }
            self.reveal_selection = true;
            self.snap();
        }
        if let (Some(line), Some(ray)) = (picked, self.state.hits()) {
            log::info!("{}", pick_command(&self.state, ray));
            log::info!("{}", json::text(&line).unwrap_or_default());
        }
    }

    /// The panel of what an action has turned on.
    fn turned_on(&self, action: Action) -> Option<Topic> {
        let (is_on, topic) = match action {
            Action::Measure(MeasureAction::Toggle) => {
                (self.state.measuring().is_on, Topic::Measure)
            }
            Action::ToggleSection => (self.state.view().section.is_some(), Topic::Section),
            _ => return None,
        };
        is_on.then_some(topic)
    }

    /// Why what an action has made show cannot be seen, or not all of it; `None` if it can, or if the action has made
    /// nothing show.
    fn shows_nothing(&self, action: Action) -> Option<&'static str> {
        let state = &self.state;
        match action {
            Action::Toggle(overlay) if state.overlays().shows(overlay) => match overlay {
                Overlay::Triangle if state.picked().is_none_or(|pick| pick.triangle.is_none()) => {
                    Some("the picked triangle shows once one is picked")
                }
                Overlay::Wireframe if state.edges_are_dense() => {
                    Some("most edges are closer together than pixels, and fade: come nearer")
                }
                Overlay::Distance if state.measuring().last_two().is_none() => {
                    Some("the distance shows once two points are picked")
                }
                _ => None,
            },
            Action::TreeLevel { .. } if state.scene().trees_are_built() => {
                let level = state.overlays().tree_level?;
                let has_boxes = shown_trees(state.scene(), state.selected())
                    .any(|(mesh, _)| !mesh.tree_boxes(level, 1).is_empty());
                (!has_boxes).then_some(
                    "no mesh here has search tree boxes at this level: small ones have none",
                )
            }
            _ => None,
        }
    }

    /// Switches between the four views and the camera's picture.
    pub(super) fn toggle_views(&mut self) {
        self.show_views(match self.state.views() {
            Views::Picture => Views::Four,
            _ => Views::Picture,
        });
    }

    /// Shows these views. Stages unfold the matrices; back in the picture, they are folded if they were before.
    pub(super) fn show_views(&mut self, views: Views) {
        let was_picture = self.state.views() == Views::Picture;
        let shows = self.memory.panels.shows(Topic::Matrices);
        if was_picture && views != Views::Picture {
            self.matrices_showed = shows;
        }
        let is_picture = views == Views::Picture;
        if was_picture != is_picture && !self.matrices_showed && shows == is_picture {
            self.memory.panels.toggle_matrices();
        }
        self.act(Action::Views(views));
    }
}
