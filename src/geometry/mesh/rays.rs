//! Intersects rays with a mesh: through its tree, or by testing every triangle in turn.
#![allow(
    clippy::inline_always,
    reason = "what is not inlined into a walk is not compiled for its instructions"
)]

use super::{Mesh, wide};
use crate::geometry::{
    Aabb, Bvh, Entry, Hit, LocalRay, Pyramid, Sides, Simd, TriangleHit, TriangleTest, VertexRay,
    Visit, hit_guarded,
    shares::in_shares,
    triangle::{compare_t, hit_filtered, is_in_doubt, reaches_plane},
};
use glam::DVec3;
use std::{
    cmp::Ordering,
    ops::ControlFlow,
    sync::{Arc, atomic::AtomicBool},
};

/// Below this many triangles, trying all takes less than a microsecond. From here on a tree pays for itself after a
/// dozen rays, whatever the mesh's size, and a click asks up to 200 (measured: 0.13 us a triangle to build, 14 ns to
/// try).
const WORTH_A_TREE: usize = 32;

impl Mesh {
    /// Builds the tree, if there is none yet and the mesh is large enough to be worth one. Without a tree, picks try
    /// every triangle, with the same answer.
    pub fn build_tree(&self) {
        self.build_tree_unless(&AtomicBool::new(false));
    }

    /// [`Mesh::build_tree`], given up soon after `stop` is set.
    pub(crate) fn build_tree_unless(&self, stop: &AtomicBool) {
        self.build_tree_by(Simd::fastest(), stop);
    }

    /// `build_tree_unless` for the given instructions; no tree is built where the processor lacks them.
    #[doc(hidden)] // public for tests and benches
    pub fn build_tree_by(&self, simd: Simd, stop: &AtomicBool) {
        if self.is_ready() {
            return;
        }
        let (positions, triangles) = (&self.data.positions, &self.data.triangles);
        if let Some(tree) = Bvh::build(positions, triangles, simd, stop) {
            debug_assert_eq!(tree.validate(positions, triangles), Ok(()));
            // A tree that another thread built meanwhile is the same.
            let _ = self.tree.set(tree);
        }
    }

    /// The tree, once it is built.
    pub(crate) fn tree(&self) -> Option<&Bvh> {
        self.tree.get()
    }

    /// The object-space boxes of the tree at a level (0 is the box about everything): at most `most`, none without a
    /// tree.
    #[doc(hidden)] // public for tests
    pub fn tree_boxes(&self, level: u32, most: usize) -> Vec<Aabb> {
        let boxes = self.tree.get().map(|tree| tree.boxes(level, most));
        let placed = boxes.into_iter().flatten().map(|bounds| Aabb {
            min: bounds.min + self.data.origin,
            max: bounds.max + self.data.origin,
        });
        placed.collect()
    }

    /// Whether rays are as fast as they will be: the tree is built, or not worth building.
    pub(crate) fn is_ready(&self) -> bool {
        self.data.triangles.len() < WORTH_A_TREE || self.tree.get().is_some() || self.few.is_some()
    }

    /// The same mesh, for rays within one of these pyramids of object space. Each vertex and each triangle is tested
    /// once against each pyramid; rays are then tested only against the few triangles that they may meet. Rays
    /// outside the pyramids may wrongly miss.
    pub(crate) fn narrowed(&self, pyramids: &[Pyramid]) -> Self {
        let near = |pyramid: &Pyramid| self.triangles_near(&pyramid.about(self.data.origin));
        let few = match pyramids {
            [] => Vec::new(),
            [pyramid] => near(pyramid),
            _ => {
                let mut are_near = vec![false; self.data.triangles.len()];
                for triangle in pyramids.iter().flat_map(near) {
                    are_near[triangle as usize] = true;
                }
                let all = (0..).zip(are_near).filter(|(_, is_near)| *is_near);
                all.map(|(triangle, _)| triangle).collect()
            }
        };
        Self::of(Arc::clone(&self.data), Arc::clone(&self.bounds), Some(few))
    }

    /// The triangles that rays within a pyramid may meet, in order. The pyramid is about the vertices' (0, 0, 0).
    fn triangles_near(&self, pyramid: &Pyramid) -> Vec<u32> {
        let (positions, triangles) = (&self.data.positions, &self.data.triangles);
        let beyond_of = |&position: &[f32; 3]| pyramid.beyond(wide(position));
        let beyond = in_shares(positions.len(), |share| {
            positions[share].iter().map(beyond_of).collect::<Vec<u8>>()
        });
        let beyond = beyond.concat();
        let near = in_shares(triangles.len(), |share| {
            let all = (0..).zip(triangles).skip(share.start).take(share.len());
            let near = all.filter(|(_, corners)| {
                let [a, b, c] = corners.map(|corner| beyond[corner as usize]);
                a & b & c == 0
            });
            near.map(|(triangle, _)| triangle).collect::<Vec<u32>>()
        });
        near.concat()
    }

    /// The nearest hit of an object-space ray on the parts that `accept` names; of ties, the lowest triangle. It is the
    /// hit that exact arithmetic would choose.
    pub fn closest<'a>(
        &self,
        ray: impl Into<LocalRay<'a>>,
        sides: Sides,
        accept: impl Fn(usize) -> bool,
    ) -> Option<Hit> {
        self.closest_of(&ray.into(), None, sides, |part, _: &Hit| accept(part))
    }

    /// [`Mesh::closest`] among the hits that `accept` takes, each given with its part.
    pub(crate) fn closest_of(
        &self,
        ray: &LocalRay,
        entry: Option<&Entry>,
        sides: Sides,
        accept: impl Fn(usize, &Hit) -> bool,
    ) -> Option<Hit> {
        let center = &self.data.origin;
        match self.tree.get() {
            // The tree has filtered already.
            Some(tree) => Nearest::of(self, ray, sides, Filtered, accept, |nearest| {
                tree.visit_from::<true>(entry, ray, center, nearest);
            }),
            None => Nearest::of(self, ray, sides, hit_guarded, accept, |nearest| {
                self.every_triangle(nearest);
            }),
        }
    }

    /// [`Mesh::closest`] by another triangle test, which is asked about every triangle whose box the ray may meet.
    #[doc(hidden)] // public for tests
    pub fn closest_by<'a>(
        &self,
        ray: impl Into<LocalRay<'a>>,
        sides: Sides,
        test: TriangleTest,
        accept: impl Fn(usize) -> bool,
    ) -> Option<Hit> {
        let ray = &ray.into();
        let accept = |part, _: &Hit| accept(part);
        Nearest::of(self, ray, sides, test, accept, |nearest| {
            self.visit::<false>(ray, None, nearest);
        })
    }

    /// All hits of an object-space ray on the parts that `accept` names, in the order of [`Mesh::closest`].
    pub fn all<'a>(
        &self,
        ray: impl Into<LocalRay<'a>>,
        sides: Sides,
        accept: impl Fn(usize) -> bool,
    ) -> Vec<Hit> {
        let ray = &ray.into();
        let local = VertexRay::new(ray, &self.data.origin);
        let mut all = self.each(ray, None, sides, accept);
        all.sort_by(|a, b| self.order(a, b, &local));
        all
    }

    /// [`Mesh::all`] in no order.
    pub(crate) fn each(
        &self,
        ray: &LocalRay,
        entry: Option<&Entry>,
        sides: Sides,
        accept: impl Fn(usize) -> bool,
    ) -> Vec<Hit> {
        let local = VertexRay::new(ray, &self.data.origin);
        let mut all = Vec::new();
        self.visit::<true>(ray, entry, &mut |triangle, corners| {
            if let Some(hit) = hit_guarded(&local, corners)
                && (sides == Sides::Both || hit.front)
                && accept(self.part_of(triangle))
            {
                all.push(hit.on(triangle, corners));
            }
            ray.limit
        });
        all
    }

    /// Where an object-space ray meets one triangle.
    pub(crate) fn hit(&self, ray: &LocalRay, triangle: u32) -> Option<Hit> {
        let corners = self.vertex_corners(triangle);
        let hit = hit_guarded(&VertexRay::new(ray, &self.data.origin), corners)?;
        Some(hit.on(triangle, corners))
    }

    /// Calls `visit` with every triangle that may be inside a pyramid of object space, and its corners about the mesh's
    /// origin, until `visit` breaks.
    pub(crate) fn within(
        &self,
        pyramid: &Pyramid,
        mut visit: impl FnMut(u32, [DVec3; 3]) -> ControlFlow<()>,
    ) {
        let pyramid = pyramid.about(self.data.origin);
        match self.tree.get() {
            Some(tree) => tree.visit_pyramid(&pyramid, visit),
            None => {
                for triangle in self.asked() {
                    let corners = self.vertex_corners(triangle);
                    if pyramid.may_hold(&corners) && visit(triangle, corners).is_break() {
                        return;
                    }
                }
            }
        }
    }

    /// Whether there is a triangle for which `f64` alone cannot decide if an object-space ray hits it. The triangle
    /// must lie in the ray's interval and before its limit, and `accept` must name its part. The same with and without
    /// a tree.
    #[doc(hidden)] // public for tests and benches
    pub fn is_in_doubt<'a>(
        &self,
        ray: impl Into<LocalRay<'a>>,
        accept: impl Fn(usize) -> bool,
    ) -> bool {
        let ray = &ray.into();
        let local = VertexRay::new(ray, &self.data.origin);
        let inverse = ray.ray.direction.recip();
        let mut found = false;
        let mut visit = |triangle, corners: [DVec3; 3]| {
            found = found
                || is_in_doubt(&local, corners)
                    && Aabb::around(corners).may_hit_before(&local, inverse, ray.limit)
                    && reaches_plane(&local, corners, ray.limit)
                    && accept(self.part_of(triangle));
            // One is enough: this ends the interval.
            if found { f64::NEG_INFINITY } else { ray.limit }
        };
        self.visit::<false>(ray, None, &mut visit);
        found
    }

    /// The order of two hits along a ray.
    fn order(&self, a: &Hit, b: &Hit, local: &VertexRay) -> Ordering {
        let (Some(on_a), Some(on_b)) = (a.on_triangle, b.on_triangle) else {
            return a.t.total_cmp(&b.t);
        };
        let triangles = [on_a.triangle, on_b.triangle];
        let corners = || triangles.map(|triangle| self.vertex_corners(triangle));
        compare_t(local, (a.t, a.t_error), (b.t, b.t_error), corners)
            .then(triangles[0].cmp(&triangles[1]))
    }

    /// Visits every triangle that the ray may hit, with its corners: through the tree, or all in order. Without
    /// `FILTER` the tree rejects by boxes alone.
    #[inline]
    fn visit<const FILTER: bool>(
        &self,
        ray: &LocalRay,
        entry: Option<&Entry>,
        visit: &mut impl Visit,
    ) {
        let center = &self.data.origin;
        match self.tree.get() {
            Some(tree) => tree.visit_from::<FILTER>(entry, ray, center, visit),
            None => self.every_triangle(visit),
        }
    }

    fn every_triangle(&self, visit: &mut impl Visit) {
        for triangle in self.asked() {
            visit.visit(triangle, self.vertex_corners(triangle));
        }
    }

    /// The triangles that a ray is tested against without a tree.
    fn asked(&self) -> impl Iterator<Item = u32> {
        let few = self.few.as_deref();
        let count = few.map_or(self.data.triangles.len(), <[u32]>::len);
        (0..)
            .take(count)
            .map(move |i: u32| few.map_or(i, |few| few[i as usize]))
    }
}

/// A [`TriangleTest`], a closure like one, or a test that is sure to be inlined.
trait Test {
    fn test(&self, ray: &VertexRay, corners: [DVec3; 3]) -> Option<TriangleHit>;
}

impl<F: Fn(&VertexRay, [DVec3; 3]) -> Option<TriangleHit>> Test for F {
    #[inline]
    fn test(&self, ray: &VertexRay, corners: [DVec3; 3]) -> Option<TriangleHit> {
        self(ray, corners)
    }
}

/// [`hit_filtered`].
struct Filtered;

impl Test for Filtered {
    #[inline(always)]
    fn test(&self, ray: &VertexRay, corners: [DVec3; 3]) -> Option<TriangleHit> {
        hit_filtered(ray, corners)
    }
}

/// The nearest hit among the triangles seen so far.
struct Nearest<'a, T, A> {
    mesh: &'a Mesh,
    ray: &'a LocalRay<'a>,
    sides: Sides,
    test: T,
    accept: A,
    /// Made when needed: most rays meet no triangle.
    local: Option<VertexRay<'a>>,
    end: f64,
    best: Option<Hit>,
}

impl<'a, T: Test, A: Fn(usize, &Hit) -> bool> Nearest<'a, T, A> {
    /// The nearest hit among those that `visit` shows it.
    #[inline]
    fn of(
        mesh: &'a Mesh,
        ray: &'a LocalRay<'a>,
        sides: Sides,
        test: T,
        accept: A,
        visit: impl FnOnce(&mut Self),
    ) -> Option<Hit> {
        let mut nearest = Self {
            mesh,
            ray,
            sides,
            test,
            accept,
            local: None,
            end: ray.limit,
            best: None,
        };
        visit(&mut nearest);
        nearest.best
    }
}

impl<T: Test, A: Fn(usize, &Hit) -> bool> Visit for Nearest<'_, T, A> {
    #[inline(always)]
    fn visit(&mut self, triangle: u32, corners: [DVec3; 3]) -> f64 {
        let local = self
            .local
            .get_or_insert_with(|| VertexRay::new(self.ray, &self.mesh.data.origin));
        if let Some(hit) = self.test.test(local, corners)
            && (self.sides == Sides::Both || hit.front)
        {
            let hit = hit.on(triangle, corners);
            // Compares a copy, so that the hit itself need not lie in memory.
            let is_first = |best: &Hit| self.mesh.order(&{ hit }, best, local).is_lt();
            if self.best.as_ref().is_none_or(is_first)
                && (self.accept)(self.mesh.part_of(triangle), &hit)
            {
                // The exact parameter may be larger by `t_error`: nearer or equal hits may lie up to there.
                self.end = self.end.min(hit.t + hit.t_error);
                self.best = Some(hit);
            }
        }
        self.end
    }
}
