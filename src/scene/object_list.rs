//! The objects of a scene in order, each with its world-space box. Clones share the list in pieces: a change of one
//! object copies the piece that it is in, and no other. So undo and a drawing in progress may hold the scene as it was.

use super::{Object, extent};
use crate::geometry::Aabb;
use std::{
    collections::BTreeSet,
    ops::Index,
    sync::{Arc, Weak},
};

/// Objects in a piece: what a change of one object copies.
const PIECE: usize = 64;

/// The objects of a scene in order, hidden ones too.
#[derive(Clone, Debug, Default)]
pub struct ObjectList {
    /// All but the last are full.
    pieces: Arc<Vec<Arc<Piece>>>,
    sums: Sums,
}

/// A run of objects, and the box about each.
#[derive(Clone, Debug)]
struct Piece {
    objects: Vec<Object>,
    bounds_world: Vec<Aabb>,
    sums: Sums,
}

/// World-space boxes about objects, and counts of them.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sums {
    /// About all of them.
    pub bounds: Aabb,
    /// About those that are visible.
    pub visible_bounds: Aabb,
    /// How many there are.
    pub objects: usize,
    /// How many are hidden.
    pub hidden: usize,
    /// Triangles of their meshes.
    pub triangles: usize,
}

/// Identifies a list and its clones until they are changed. Holds no object.
#[derive(Clone, Debug)]
pub(super) struct ListKey(Weak<Vec<Arc<Piece>>>);

impl ObjectList {
    pub(super) fn new(objects: Vec<Object>) -> Self {
        let mut objects = objects.into_iter().peekable();
        let mut pieces = Vec::new();
        while objects.peek().is_some() {
            let some: Vec<Object> = objects.by_ref().take(PIECE).collect();
            let mut piece = Piece {
                bounds_world: some.iter().map(Object::bounds_world).collect(),
                objects: some,
                sums: Sums::default(),
            };
            piece.add_up();
            pieces.push(Arc::new(piece));
        }
        Self {
            sums: Sums::of(&pieces),
            pieces: Arc::new(pieces),
        }
    }

    /// How many objects there are.
    pub fn len(&self) -> usize {
        self.sums.objects
    }

    /// Whether there is no object.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// An object by its index, from 0; `None` where there is none.
    pub fn get(&self, index: usize) -> Option<&Object> {
        self.pieces.get(index / PIECE)?.objects.get(index % PIECE)
    }

    /// The first object; `None` where there is none.
    pub fn first(&self) -> Option<&Object> {
        self.get(0)
    }

    /// Each object in order.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = &Object> + ExactSizeIterator + Clone {
        (0..self.len()).map(|index| &self[index])
    }

    /// A copy of each object in order.
    pub fn to_vec(&self) -> Vec<Object> {
        self.iter().cloned().collect()
    }

    pub(super) fn sums(&self) -> &Sums {
        &self.sums
    }

    pub(super) fn key(&self) -> ListKey {
        ListKey(Arc::downgrade(&self.pieces))
    }

    /// The world-space box about an object. Panics where there is none of this index.
    pub(super) fn bounds_of(&self, index: usize) -> Aabb {
        self.pieces[index / PIECE].bounds_world[index % PIECE]
    }

    /// Whether a condition holds for the box about some visible object. It must hold for a box if it holds for one
    /// inside that box.
    pub(super) fn any_visible(&self, holds: impl Fn(&Aabb) -> bool) -> bool {
        holds(&self.sums.visible_bounds)
            && self.pieces.iter().any(|piece| {
                let mut each = piece.objects.iter().zip(&piece.bounds_world);
                holds(&piece.sums.visible_bounds)
                    && each.any(|(object, bounds)| object.visible && holds(bounds))
            })
    }

    /// Changes objects, but not where they are. Panics where an index names no object.
    pub(super) fn change(&mut self, indices: &[usize], change: impl Fn(&mut Object)) {
        let pieces = Arc::make_mut(&mut self.pieces);
        for index in indices {
            let piece = Arc::make_mut(&mut pieces[index / PIECE]);
            change(&mut piece.objects[index % PIECE]);
        }
        let changed: BTreeSet<usize> = indices.iter().map(|index| index / PIECE).collect();
        for piece in changed {
            Arc::make_mut(&mut pieces[piece]).add_up();
        }
        self.sums = Sums::of(pieces);
    }

    /// Changes an object and where it is. Panics where no object has this index.
    pub(super) fn change_bounds(&mut self, index: usize, change: impl Fn(&mut Object)) {
        let piece = Arc::make_mut(&mut Arc::make_mut(&mut self.pieces)[index / PIECE]);
        change(&mut piece.objects[index % PIECE]);
        piece.bounds_world[index % PIECE] = extent::bounds_world(&piece.objects[index % PIECE]);
        piece.add_up();
        self.sums = Sums::of(&self.pieces);
    }
}

impl Index<usize> for ObjectList {
    type Output = Object;

    /// # Panics
    /// When no object has this index.
    fn index(&self, index: usize) -> &Object {
        &self.pieces[index / PIECE].objects[index % PIECE]
    }
}

impl Piece {
    fn add_up(&mut self) {
        let mut sums = Sums::default();
        for (object, bounds) in self.objects.iter().zip(&self.bounds_world) {
            sums.bounds = sums.bounds.union(*bounds);
            if object.visible {
                sums.visible_bounds = sums.visible_bounds.union(*bounds);
            } else {
                sums.hidden += 1;
            }
            sums.objects += 1;
            sums.triangles += object.shape.triangles().map_or(0, |range| range.len());
        }
        self.sums = sums;
    }
}

impl Sums {
    fn of(pieces: &[Arc<Piece>]) -> Self {
        let each = pieces.iter().map(|piece| piece.sums);
        each.fold(Self::default(), |a, b| Self {
            bounds: a.bounds.union(b.bounds),
            visible_bounds: a.visible_bounds.union(b.visible_bounds),
            objects: a.objects + b.objects,
            hidden: a.hidden + b.hidden,
            triangles: a.triangles + b.triangles,
        })
    }
}

impl ListKey {
    pub fn is_in_use(&self) -> bool {
        self.0.strong_count() > 0
    }
}

impl PartialEq for ListKey {
    fn eq(&self, other: &Self) -> bool {
        Weak::ptr_eq(&self.0, &other.0)
    }
}

impl Eq for ListKey {}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{geometry::Placement, scene::Shape};
    use glam::{DAffine3, DVec3};

    #[test]
    fn a_change_copies_the_piece_of_its_object_and_no_other() {
        let mut at = -1.0;
        let mut ball = |i: usize| {
            at += 1.0;
            let place = DAffine3::from_translation(DVec3::new(at, 0.0, 0.0));
            let placement = Placement::new(place).expect("a shift");
            Object::new(i.to_string(), Shape::Sphere, placement)
        };
        let count = 5 * PIECE + 7;
        let before = ObjectList::new((0..count).map(&mut ball).collect());
        let shared = |after: &ObjectList| {
            let pairs = before.pieces.iter().zip(&*after.pieces);
            pairs.map(|(a, b)| Arc::ptr_eq(a, b)).collect::<Vec<_>>()
        };
        let mut after = before.clone();
        after.change(&[PIECE, 2 * PIECE - 1], |object| object.visible = false);
        assert_eq!(shared(&after), [true, false, true, true, true, true]);
        assert_ne!(after.key(), before.key());
        assert_eq!((before.sums.hidden, after.sums.hidden), (0, 2));

        let mut after = before.clone();
        after.change_bounds(count - 1, |object| object.placement = before[0].placement);
        assert_eq!(shared(&after), [true, true, true, true, true, false]);
        let whole = ObjectList::new(after.to_vec());
        assert_eq!(whole.sums.bounds, after.sums.bounds);
        assert_ne!(before.sums.bounds, after.sums.bounds);
        let names = after.iter().map(|object| object.name.clone());
        assert!(names.eq((0..count).map(|i| i.to_string())));
        assert_eq!(after.iter().len(), count);
        assert!(after.get(count).is_none());
    }
}
