//! How far objects reach: the bounding box of a mesh that is moved often, and what a picture of a scene frames. Only
//! the blocks of a mesh that reach beyond the box found so far have their triangles visited.

use super::{Object, Scene, Shape};
use crate::{
    camera::Framed,
    geometry::{Aabb, BLOCK, Mesh, Placement, U},
};
use glam::{DAffine3, DMat3, DVec3};
use std::ops::Range;

/// In objects with fewer triangles than this, every triangle is visited.
const FEW: usize = 8 * BLOCK;

/// [`Object::bounds_world`], to the bit.
pub(super) fn bounds_world(object: &Object) -> Aabb {
    bounds_at(&object.shape, &object.placement)
}

/// The same in the object's own space.
pub(super) fn bounds_object(object: &Object) -> Aabb {
    bounds_at(&object.shape, &Placement::IDENTITY)
}

/// The same for a shape that a placement puts somewhere.
fn bounds_at(shape: &Shape, placement: &Placement) -> Aabb {
    match (shape, shape.triangles()) {
        (Shape::Mesh { mesh, .. }, Some(triangles)) if triangles.len() >= FEW => {
            bounds_and_work(mesh, &triangles, placement).0
        }
        _ => shape.bounds_at(placement),
    }
}

/// A scene's visible objects.
impl Framed for Scene {
    fn bounds_through(&self, map: &DMat3) -> Aabb {
        let all = self.objects().iter().enumerate();
        let visible = all.filter(|(_, object)| object.visible);
        through(self, visible.map(|(index, _)| index), map)
    }

    fn bounds(&self) -> Aabb {
        self.visible_bounds()
    }
}

/// Some objects of a scene, by their indices, hidden ones too.
#[derive(Clone, Copy, Debug)]
pub struct Among<'a>(pub &'a Scene, pub &'a [usize]);

impl Framed for Among<'_> {
    fn bounds_through(&self, map: &DMat3) -> Aabb {
        through(self.0, self.1.iter().copied(), map)
    }

    fn bounds(&self) -> Aabb {
        self.0.bounds_among(self.1.iter().copied())
    }
}

/// The box about objects whose points are taken through a map.
fn through(scene: &Scene, objects: impl Iterator<Item = usize>, map: &DMat3) -> Aabb {
    objects.fold(Aabb::EMPTY, |found, index| {
        let most = scene.bounds_of(index).bounds_through(map);
        if found.holds(&most) {
            return found;
        }
        let object = &scene.objects()[index];
        let model = DAffine3::from_mat3(*map) * object.placement.model();
        let mapped = Placement::new(model);
        found.union(mapped.map_or(most, |placement| bounds_at(&object.shape, &placement)))
    })
}

/// The box about some of a mesh's triangles, and the number of blocks whose triangles were visited.
fn bounds_and_work(mesh: &Mesh, triangles: &Range<u32>, placement: &Placement) -> (Aabb, usize) {
    let first = triangles.start as usize / BLOCK;
    let blocks = &mesh.blocks()[first..(triangles.end as usize).div_ceil(BLOCK)];
    let around: Vec<Aabb> = (blocks.iter())
        .map(|block| around(block, placement))
        .collect();
    let mut is_asked = vec![false; around.len()];
    let mut found = Aabb::EMPTY;
    let mut ask = |index: usize, found: Aabb| {
        if std::mem::replace(&mut is_asked[index], true) {
            return found;
        }
        // The first and the last block may hold triangles of other objects too.
        let block = [index, index + 1].map(|index| (first + index) * BLOCK);
        let [start, end] = block.map(|at| u32::try_from(at).unwrap_or(u32::MAX));
        let own = triangles.start.max(start)..triangles.end.min(end);
        let corners = own.flat_map(|triangle| mesh.corners(triangle));
        let corners = corners.map(|corner| placement.point_to_world(corner));
        found.union(Aabb::around(corners))
    };
    // The outermost blocks first: most others then lie within the box found so far.
    for axis in 0..3 {
        let all = 0..around.len();
        let min = |index: usize| around[index].min[axis];
        let max = |index: usize| around[index].max[axis];
        let least = (all.clone()).min_by(|&a, &b| min(a).total_cmp(&min(b)));
        let most = all.max_by(|&a, &b| max(a).total_cmp(&max(b)));
        for index in least.into_iter().chain(most) {
            found = ask(index, found);
        }
    }
    for (index, block) in around.iter().enumerate() {
        if !found.holds(block) {
            found = ask(index, found);
        }
    }
    let work = is_asked.iter().filter(|asked| **asked).count();
    (found, work)
}

/// A world-space box that holds the rounded result of [`Placement::point_to_world`] for every point of an object-space
/// box. Each coordinate takes 3 products and 3 sums. Each of these is off by at most `U s`, where `s = |M| m + |T|` and
/// m has the largest absolute coordinates of the box. The centre, the half size and their images are off by less than
/// `16 U s`, so a margin of `32 U s` is enough.
///
/// A world coordinate that depends on a single object coordinate rounds monotonically, so it needs no margin. With a
/// margin, every block along a straight border would reach beyond the box found so far and would be visited.
fn around(bounds: &Aabb, placement: &Placement) -> Aabb {
    let largest = bounds.min.abs().max(bounds.max.abs());
    let room: DVec3 = 32.0 * U * placement.sizes_in_world(largest);
    let half = placement.sizes_along(0.5 * (bounds.max - bounds.min)) + room;
    let middle = placement.point_to_world(bounds.center());
    let (mut min, mut max) = (middle - half, middle + half);
    let ends = [bounds.min, bounds.max].map(|end| placement.point_to_world(end));
    let rows = placement.model().matrix3.transpose();
    for axis in 0..3 {
        let row = rows.col(axis);
        let hangs_on = row.to_array().into_iter().filter(|entry| *entry != 0.0);
        if hangs_on.count() <= 1 {
            min[axis] = ends[0][axis].min(ends[1][axis]);
            max[axis] = ends[0][axis].max(ends[1][axis]);
        }
    }
    Aabb { min, max }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{MeshData, Part};
    use glam::{DAffine3, DMat3};
    use std::sync::Arc;

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
        let triangles: Vec<_> = triangles.collect();
        let end = u32::try_from(triangles.len()).expect("few");
        let parts = [0..1001, 1001..end - 77, end - 77..end].map(|triangles| Part {
            name: "hill".into(),
            triangles,
        });
        let mesh = Mesh::new(MeshData {
            origin: DVec3::new(1e6, -0.1, 3.0),
            parts: parts.into(),
            ..MeshData::of_triangles("hill", positions.collect(), triangles)
        });
        let mesh = Arc::new(mesh.expect("a mesh"));
        let shape = Shape::Mesh { mesh, part: 1 };
        Object::new("hill", shape, Placement::IDENTITY)
    }

    #[test]
    fn the_box_is_that_about_all_triangles_to_the_bit_and_few_are_asked() {
        let mut object = hill(200);
        let mesh = Arc::clone(object.shape.mesh().expect("a mesh"));
        let triangles = object.shape.triangles().expect("triangles");
        let bits = |b: Aabb| [b.min, b.max].map(|v| v.to_array().map(f64::to_bits));
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
            let (bounds, work) = bounds_and_work(&mesh, &triangles, &object.placement);
            let whole = object.bounds_world();
            assert_eq!(bits(bounds), bits(whole));
            asked += work;
        }
        // All blocks along a border reach equally far out.
        for matrix3 in [
            DMat3::IDENTITY,
            DMat3::from_cols_array(&[0.0, 0.3, 0.0, 0.0, 0.0, -0.7, 1.1, 0.0, 0.0]),
        ] {
            let model = DAffine3 {
                matrix3,
                translation: DVec3::new(0.1, 1e5, -7.0),
            };
            object.placement = Placement::new(model).expect("invertible");
            let (bounds, work) = bounds_and_work(&mesh, &triangles, &object.placement);
            assert_eq!(bounds, object.bounds_world());
            assert!(work <= 16, "{work} blocks");
        }
        // Of the 313 blocks, the first three hold triangles of the first part only.
        let all = 60 * (mesh.blocks().len() - 3);
        assert_eq!(mesh.blocks().len(), 313);
        assert!(asked < all / 8, "{asked} of {all} blocks");
    }
}
