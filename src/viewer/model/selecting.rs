//! Selecting one object or several, and what is asked of all that is selected.

use super::{
    chosen::{Chosen, Selection},
    state::State,
};
use crate::{
    colour::Srgb,
    geometry::{Aabb, OnTriangle},
    scene::{Object, Shape},
};
use std::{collections::BTreeSet, mem, sync::Arc};

impl State {
    /// Indices of all that is selected: the object that was selected first, then the others in order.
    pub fn all_selected(&self) -> impl Iterator<Item = usize> {
        self.selection().into_iter().flat_map(Selection::all)
    }

    /// Whether an object is selected, alone or with others.
    pub fn is_selected(&self, object: usize) -> bool {
        let selection = self.selection();
        selection.is_some_and(|of| of.object == object || of.others.contains(&object))
    }

    /// The box in the world about all that is selected, or else about all that is visible.
    pub fn bounds_of_selection(&self) -> Aabb {
        match self.selected() {
            Some(_) => self.scene.bounds_among(self.all_selected()),
            None => self.scene.visible_bounds(),
        }
    }

    /// Whether most edges of triangles that a wireframe shows are so close in the picture that they fade: as many
    /// triangles as what is selected has, or else all of the scene, side by side in its picture.
    pub(in crate::viewer) fn edges_are_dense(&self) -> bool {
        /// The wireframe's shader has faded edges by 1.5 pixels, and begins at 14.
        const FADED_PX: f64 = 4.0;
        let objects = self.scene.objects();
        let triangles = |object: &Object| object.shape.triangles().map_or(0, |all| all.len());
        let count: usize = match self.selected() {
            Some(_) => self.all_selected().map(|of| triangles(&objects[of])).sum(),
            None => self.scene.triangle_count(),
        };
        let bounds = self.bounds_of_selection();
        let across = (self.view).px_across(2.0 * bounds.radius(), bounds.center());
        #[expect(clippy::cast_precision_loss, reason = "about a spacing")]
        let least = FADED_PX * (count as f64).sqrt();
        across.is_some_and(|px| px < least)
    }

    /// The name, where the file gives one, and the colour of the picked surface, at the pick. Where no surface is picked,
    /// of the selected object, if all of it has the same. `None` where several are selected.
    pub fn material(&self) -> Option<(Option<&str>, Srgb)> {
        let selection = self.selection().filter(|of| of.others.is_empty())?;
        let object = self.scene.objects().get(selection.object)?;
        let picked = self.picked();
        let picked = picked.and_then(|pick| Some((pick.triangle?, pick.barycentric?)));
        let (Shape::Mesh { mesh, .. }, Some((triangle, barycentric))) = (&object.shape, picked)
        else {
            return object.one_material();
        };
        let at = OnTriangle {
            triangle: object.shape.first_triangle() + triangle,
            barycentric,
        };
        let drawn = || Srgb::from_linear(mesh.albedo(&at));
        Some((
            object.material_name(triangle),
            object.colour.unwrap_or_else(drawn),
        ))
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
        self.timeline.begin(None);
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
        self.refresh_panes();
    }
}
