//! What the user has just done. From this the tour notices that a step is done.

use crate::{
    scene::{Object, Shape},
    viewer::{
        jobs::Checking,
        model::{Action, State, Views},
        ui::command::Command,
    },
};

/// What the user has just done.
pub(in crate::viewer) struct JustDone<'a> {
    /// The command; `None` where something else happened, such as the end of a load.
    pub command: Option<&'a Command>,
    /// The state after it.
    pub state: &'a State,
    /// Whether the matrices show.
    pub matrices: bool,
    pub checking: &'a Checking,
}

/// Whether the scene's camera turns, and not just one of the four views.
pub(super) fn turns(done: &JustDone) -> bool {
    let in_picture = done.state.views() == Views::Picture;
    done.acts(|action| match action {
        Action::Turn(_) => in_picture,
        Action::Steer(_) => true,
        _ => false,
    })
}

impl JustDone<'_> {
    pub(super) fn acts(&self, is_it: impl Fn(&Action) -> bool) -> bool {
        matches!(self.command, Some(Command::Act(action)) if is_it(action))
    }

    pub(super) fn clicks(&self) -> bool {
        self.acts(|action| matches!(action, Action::Click(..)))
    }

    pub(super) fn clicks_on(&self, is_it: impl Fn(&Shape) -> bool) -> bool {
        self.clicks() && self.picked().is_some_and(|object| is_it(&object.shape))
    }

    /// The object that a click has selected.
    pub(super) fn picked(&self) -> Option<&Object> {
        let pick = self.state.picked()?;
        self.state.scene().objects().get(pick.id - 1)
    }

    pub(super) fn has_picked(&self, name: &str) -> bool {
        self.picked().is_some_and(|object| object.name == name)
    }

    /// Whether near is set beyond all of an object, but leaves some of the scene in view.
    pub(super) fn near_is_past(&self, name: &str) -> bool {
        let (scene, view) = (self.state.scene(), self.state.view());
        let objects = scene.objects();
        let Some(object) = objects.iter().position(|object| object.name == name) else {
            return false;
        };
        let corners = scene.bounds_of(object).corners();
        let furthest = (corners.iter())
            .map(|&corner| view.camera.to_view(corner).z)
            .fold(f64::NEG_INFINITY, f64::max);
        let near = self.state.controls().near;
        near.is_some_and(|near| near > furthest) && view.may_see(&scene.visible_bounds())
    }
}
