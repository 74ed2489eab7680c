//! The box about a mesh that is moved again and again: of most of its triangles, a box about them says enough.

use super::{Object, Shape};
use crate::geometry::{Aabb, Mesh, Placement};
use glam::{DMat3, DVec3};
use std::{ops::Range, sync::Arc};

/// Triangles of a block.
const BLOCK: u32 = 256;

/// Half a unit in the last place of 1.
const U: f64 = 0.5 * f64::EPSILON;

/// Boxes about blocks of an object's triangles, in object space.
#[derive(Clone, Debug)]
pub(super) struct Extent {
    object: usize,
    mesh: Arc<Mesh>,
    triangles: Range<u32>,
    blocks: Vec<Aabb>,
}

impl Extent {
    /// Of an object by its index; `None` where it has no triangles of its own.
    pub fn of(index: usize, object: &Object) -> Option<Self> {
        let Shape::Mesh { mesh, .. } = &object.shape else {
            return None;
        };
        let triangles = object.shape.triangles()?;
        let blocks = triangles.clone().step_by(BLOCK as usize);
        let blocks = blocks.map(|first| {
            let block = block(&triangles, first);
            Aabb::around(block.flat_map(|triangle| mesh.corners(triangle)))
        });
        Some(Self {
            object: index,
            mesh: Arc::clone(mesh),
            blocks: blocks.collect(),
            triangles,
        })
    }

    /// Whether it is that of the object with this index.
    pub fn is_of(&self, index: usize) -> bool {
        self.object == index
    }

    /// [`Object::bounds_world`], to the bit.
    pub fn bounds_world(&self, placement: &Placement) -> Aabb {
        self.bounds_and_work(placement).0
    }

    /// The box, and how many blocks had to be asked for their triangles.
    fn bounds_and_work(&self, placement: &Placement) -> (Aabb, usize) {
        let around: Vec<Aabb> = (self.blocks.iter())
            .map(|block| around(block, placement))
            .collect();
        let mut is_asked = vec![false; around.len()];
        let mut found = Aabb::EMPTY;
        let mut ask = |index: usize, found: Aabb| {
            if std::mem::replace(&mut is_asked[index], true) {
                return found;
            }
            let first = self.triangles.start + BLOCK * u32::try_from(index).unwrap_or(u32::MAX);
            let corners = block(&self.triangles, first).flat_map(|i| self.mesh.corners(i));
            let corners = corners.map(|corner| placement.point_to_world(corner));
            found.union(Aabb::around(corners))
        };
        // Those that reach furthest: after them most others lie within what was found.
        for axis in 0..3 {
            let least = (0..around.len()).min_by(|&a, &b| {
                let [a, b] = [a, b].map(|index| around[index].min[axis]);
                a.total_cmp(&b)
            });
            let most = (0..around.len()).max_by(|&a, &b| {
                let [a, b] = [a, b].map(|index| around[index].max[axis]);
                a.total_cmp(&b)
            });
            for index in least.into_iter().chain(most) {
                found = ask(index, found);
            }
        }
        for (index, block) in around.iter().enumerate() {
            let within = block.min.cmpge(found.min).all() && block.max.cmple(found.max).all();
            if !within {
                found = ask(index, found);
            }
        }
        let work = is_asked.iter().filter(|asked| **asked).count();
        (found, work)
    }
}

/// The triangles of the block that begins with `first`.
fn block(all: &Range<u32>, first: u32) -> Range<u32> {
    first..first.saturating_add(BLOCK).min(all.end)
}

/// A world-space box about an object-space one: about every point in it as [`Placement::point_to_world`] rounds it, which
/// takes 3 products and 3 sums, each off by `U` of what it adds up, at most `s = |M| m + |T|` with m the largest
/// coordinates of the box. Middle, half size and their images are off by less than `16 U s`, so `32 U s` is room enough.
fn around(bounds: &Aabb, placement: &Placement) -> Aabb {
    let model = placement.model();
    let sizes = DMat3::from_cols(
        model.matrix3.x_axis.abs(),
        model.matrix3.y_axis.abs(),
        model.matrix3.z_axis.abs(),
    );
    let largest = bounds.min.abs().max(bounds.max.abs());
    let room: DVec3 = 32.0 * U * (sizes * largest + model.translation.abs());
    let half = sizes * (0.5 * (bounds.max - bounds.min)) + room;
    let middle = placement.point_to_world(bounds.center());
    Aabb {
        min: middle - half,
        max: middle + half,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::MeshData;
    use glam::DAffine3;

    /// A hill of `2 * side^2` triangles.
    fn hill(side: u16) -> Object {
        let width = u32::from(side) + 1;
        let at = |i: u16| 7.0 * f32::from(i) / f32::from(side) - 3.3;
        let positions = (0..=side).flat_map(|j| {
            let height = move |i| (-at(i) * at(i) - at(j) * at(j)).exp();
            (0..=side).map(move |i| [at(i), height(i), at(j)])
        });
        let cells = (0..u32::from(side)).flat_map(|j| (1..width).map(move |i| j * width + i - 1));
        let triangles = cells.flat_map(|a| [[a, a + 1, a + width], [a + 1, a + width, a]]);
        let mesh = Mesh::new(MeshData {
            origin: DVec3::new(1e6, -0.1, 3.0),
            ..MeshData::of_triangles("hill", positions.collect(), triangles.collect())
        });
        let mesh = Arc::new(mesh.expect("a mesh"));
        let shape = Shape::Mesh { mesh, part: 0 };
        Object::new("hill", shape, Placement::IDENTITY)
    }

    #[test]
    fn the_box_is_that_about_all_triangles_to_the_bit_and_few_are_asked() {
        let mut object = hill(200);
        let extent = Extent::of(0, &object).expect("triangles");
        let mut asked = 0;
        for i in 0..60_i32 {
            let turn = f64::from(i);
            let model = DAffine3 {
                matrix3: DMat3::from_rotation_y(0.7 * turn)
                    * DMat3::from_cols_array(&[1.0, 0.1, 0.0, turn, 1.0, 0.3, -2.0, 0.0, 1e-3])
                    * DMat3::from_rotation_x(turn),
                translation: DVec3::new(0.1, 1e5 * turn, -turn),
            };
            object.placement = Placement::new(model).expect("invertible");
            let (bounds, work) = extent.bounds_and_work(&object.placement);
            let whole = object.bounds_world();
            assert_eq!(
                bounds.min.to_array().map(f64::to_bits),
                whole.min.to_array().map(f64::to_bits)
            );
            assert_eq!(
                bounds.max.to_array().map(f64::to_bits),
                whole.max.to_array().map(f64::to_bits)
            );
            asked += work;
        }
        let all = 60 * extent.blocks.len();
        assert_eq!(extent.blocks.len(), 313);
        assert!(asked < all / 8, "{asked} of {all} blocks");
    }
}
