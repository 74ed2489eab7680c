//! Makes a scene from the one on show and from what its files hold now.

use crate::scene::{Object, Scene, Shape};
use std::{collections::HashMap, sync::Arc};

/// A scene that is made from another.
pub(super) struct Made {
    /// The scene itself.
    pub scene: Scene,
    /// For each object of the scene that it was made from, its index now.
    became: Vec<Option<usize>>,
}

impl Made {
    /// What the files of a scene hold now. Objects keep their visibility, and are matched by name: an object takes the
    /// place of the old one at the same index if that has the same name, else of the first old one that has it.
    pub fn again(scene: &Scene, mut now: Scene) -> Self {
        let old = scene.objects();
        let by_name: HashMap<&str, usize> = (old.iter().enumerate().rev())
            .map(|(index, object)| (object.name.as_str(), index))
            .collect();
        let before = |(index, object): (usize, &Object)| {
            let same_place = old.get(index).filter(|old| old.name == object.name);
            let elsewhere = || by_name.get(object.name.as_str()).copied();
            same_place.map(|_| index).or_else(elsewhere)
        };
        let was: Vec<_> = now.objects().iter().enumerate().map(before).collect();
        let differs = |(index, was): &(usize, &Option<usize>)| {
            was.is_some_and(|was| old[was].visible != now.objects()[*index].visible)
        };
        let changed = was.iter().enumerate().filter(differs);
        let changed: Vec<usize> = changed.map(|(index, _)| index).collect();
        now.toggle(&changed);
        let mut became = vec![None; old.len()];
        for (index, was) in was.iter().enumerate().rev() {
            if let Some(was) = was {
                became[*was] = Some(index);
            }
        }
        Self { scene: now, became }
    }

    /// The index that an object of the scene before has now.
    pub fn became(&self, object: usize) -> Option<usize> {
        self.became.get(object).copied().flatten()
    }
}

/// Whether two scenes are the same but for what is hidden. Meshes count as equal if they are one in memory:
/// [`Loaded::share_meshes`](crate::scene::Loaded) has put the old ones in place of equal new ones.
pub(super) fn is_same(a: &Scene, b: &Scene) -> bool {
    let (a, b) = (a.objects(), b.objects());
    a.len() == b.len() && a.iter().zip(b.iter()).all(are_one)
}

/// Whether two objects are the same but for their visibility.
fn are_one((a, b): (&Object, &Object)) -> bool {
    let one_shape = match (&a.shape, &b.shape) {
        (Shape::Mesh { mesh, part }, Shape::Mesh { mesh: of, part: at }) => {
            Arc::ptr_eq(mesh, of) && part == at
        }
        (a, b) => a == b,
    };
    one_shape && a.name == b.name && a.colour == b.colour && a.placement == b.placement
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Placement;

    fn scene(objects: &[(&str, bool)]) -> Scene {
        let object = |&(name, visible): &(&str, bool)| Object {
            visible,
            ..Object::new(name, Shape::Sphere, Placement::IDENTITY)
        };
        objects.iter().map(object).collect()
    }

    #[test]
    fn what_was_hidden_stays_so_by_its_name() {
        let old = scene(&[("a", true), ("b", false), ("b", true)]);
        let now = scene(&[("b", true), ("b", true), ("c", false), ("a", false)]);
        let made = Made::again(&old, now);
        let visible = made.scene.objects().iter().map(|object| object.visible);
        assert_eq!(visible.collect::<Vec<_>>(), [false, false, false, true]);
        let became = [0, 1, 2].map(|object| made.became(object));
        assert_eq!(became, [Some(3), Some(0), None]);
    }
}
