//! What is selected: objects, and the surface of the first of them that is picked.

use super::hits::RayHits;
use std::{collections::BTreeSet, iter, sync::Arc};

/// What is selected.
#[derive(Clone, Debug, PartialEq)]
pub struct Selection {
    /// Index of the object; of several, of the one that was selected first.
    pub object: usize,
    /// Indices of the other objects.
    pub others: Arc<BTreeSet<usize>>,
}

impl Selection {
    /// The object that was selected first, then the others in order.
    pub fn all(&self) -> impl Iterator<Item = usize> {
        let others = self.others.iter().copied();
        iter::once(self.object).chain(others)
    }
}

/// What is selected, and what the last click's ray hits.
#[derive(Clone, Default)]
pub(super) struct Chosen {
    pub selection: Option<Selection>,
    /// Where a surface of it is picked, its object is the one that was selected first.
    pub hits: Option<RayHits>,
}

impl Chosen {
    /// An object without a point of it, or nothing.
    pub fn object(object: Option<usize>) -> Self {
        Self {
            selection: object.map(|object| Selection {
                object,
                others: Arc::default(),
            }),
            hits: None,
        }
    }

    /// Forgets what is selected. What the last click's ray hits stays.
    pub fn deselect(&mut self) {
        self.selection = None;
        if let Some(hits) = &mut self.hits {
            hits.at = None;
        }
    }

    /// Selects these objects, too.
    pub fn add(&mut self, objects: BTreeSet<usize>) {
        if let Some(Selection { object, others, .. }) = &mut self.selection {
            let others = Arc::make_mut(others);
            others.extend(objects);
            others.remove(object);
        }
    }
}
