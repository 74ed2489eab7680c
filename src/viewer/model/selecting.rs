//! Selecting one object or several, and what is asked of all that is selected.

use super::state::{Chosen, Selection, State};
use crate::{colour::Srgb, geometry::Aabb};
use std::{collections::BTreeSet, mem, sync::Arc};

impl State {
    /// Indices of all that is selected: the object that was selected first, then the others in order.
    pub fn all_selected(&self) -> impl Iterator<Item = usize> {
        let selection = self.selection().into_iter();
        let all = selection.flat_map(|selection| {
            let others = selection.others.iter().copied();
            std::iter::once(selection.object).chain(others)
        });
        let count = self.scene.objects().len();
        all.filter(move |object| *object < count)
    }

    /// Whether an object is selected, alone or with others.
    pub fn is_selected(&self, object: usize) -> bool {
        let selection = self.selection();
        selection.is_some_and(|of| of.object == object || of.others.contains(&object))
    }

    /// The box in the world about all that is selected, or else about all that is visible.
    pub fn bounds_of_selection(&self) -> Aabb {
        let boxes = self
            .all_selected()
            .map(|object| self.scene.bounds_of(object));
        let both = boxes.reduce(Aabb::union);
        both.unwrap_or_else(|| self.scene.visible_bounds())
    }

    /// The name, where the file gives one, and the colour of the picked surface. Where no surface is picked, of the
    /// selected object, if all of it has the same.
    pub fn material(&self) -> Option<(Option<&str>, Srgb)> {
        let object = self.scene.objects().get(self.selected()?)?;
        let triangle = self.picked().and_then(|pick| pick.triangle);
        object.material(triangle)
    }

    /// Selects an object without a point of it, or nothing.
    pub(super) fn select(&mut self, object: Option<usize>) {
        self.chosen = Chosen::object(object);
        if object.is_none() && !self.measuring.is_on {
            self.forget_points();
        }
    }

    /// Adds an object to what is selected, or takes it out. The picked point stays, unless its object is taken out.
    pub(super) fn toggle_selected(&mut self, object: usize) {
        let Some(selection) = &mut self.chosen.selection else {
            return self.select(Some(object));
        };
        let others = Arc::make_mut(&mut selection.others);
        if selection.object != object {
            if !others.remove(&object) {
                others.insert(object);
            }
        } else if let Some(next) = others.pop_first() {
            let others = mem::take(others);
            self.chosen = Chosen::object(Some(next));
            self.chosen.add(others);
        } else {
            self.select(None);
        }
    }

    /// Selects all of these objects. What was selected first stays first, with its picked point, if it is among them.
    pub(in crate::viewer) fn select_all(&mut self, objects: &BTreeSet<usize>) {
        if self
            .selected()
            .is_none_or(|first| !objects.contains(&first))
        {
            self.select(objects.first().copied());
        }
        if let Some(selection) = &mut self.chosen.selection {
            selection.others = Arc::default();
        }
        self.chosen.add(objects.clone());
    }
}

impl Chosen {
    /// Selects these objects, too.
    pub(super) fn add(&mut self, objects: BTreeSet<usize>) {
        if let Some(Selection { object, others, .. }) = &mut self.selection {
            let others = Arc::make_mut(others);
            others.extend(objects);
            others.remove(object);
        }
    }
}
