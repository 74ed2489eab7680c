//! Normalised device coordinates as a space that somebody looks at, in place of the world.

use super::{DepthMapping, Lens, View};
use crate::geometry::{Aabb, Ray, WorldRay};
use glam::{DMat4, DVec3};

/// What P V and the division by w make of the world before a view's camera.
///
/// A point is drawn at its x and y in NDC and at minus its z of standard depth, whatever depth the lens stores. So the
/// near face is towards the viewer. Nothing is mirrored: view space is left-handed, the space drawn in is right-handed.
/// What lies in front of the near plane is not there. What lies beside the picture or beyond far is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NdcSpace {
    /// The camera's view.
    pub of: View,
}

impl NdcSpace {
    /// The box that the frustum becomes.
    pub const FRUSTUM: Aabb = Aabb {
        min: DVec3::new(-1.0, -1.0, -1.0),
        max: DVec3::new(1.0, 1.0, 0.0),
    };

    /// From view space (right, up, forward) to homogeneous coordinates here. Their w is that of clip space.
    pub fn matrix(&self) -> DMat4 {
        let projection = self.standard().projection(self.of.viewport.aspect());
        DMat4::from_scale(DVec3::new(1.0, 1.0, -1.0)) * projection
    }

    /// Where a world point is drawn; `None` in front of the near plane.
    pub fn drawn(&self, point_world: DVec3) -> Option<DVec3> {
        let near = self.of.camera.lens().near;
        let p_view = self.of.camera.to_view(point_world);
        // Rounding may put a point of the near plane in front of it.
        (p_view.z >= near - 1e-9 * near.abs()).then(|| self.of_view(p_view))
    }

    /// Where a world-space segment is drawn, as far as it lies behind the near plane; `None` if nothing is left.
    pub(crate) fn drawn_segment(&self, ends_world: [DVec3; 2]) -> Option<[DVec3; 2]> {
        let [from, to, ..] = self.of.past_near(&ends_world)[..] else {
            return None;
        };
        Some([from, to].map(|end| self.of_view(self.of.camera.to_view(end))))
    }

    /// A box about all that a world-space box is drawn as.
    pub(crate) fn drawn_box(&self, bounds_world: &Aabb) -> Aabb {
        if bounds_world.is_empty() {
            return Aabb::EMPTY;
        }
        let corners = bounds_world.corners();
        let pairs = (0..8_usize).flat_map(|from| [1, 2, 4].map(|bit| [from, from | bit]));
        let edges = pairs.map(|ends| ends.map(|i| corners[i]));
        Aabb::around(edges.filter_map(|edge| self.drawn_segment(edge)).flatten())
    }

    /// The z here of a plane behind all of a world-space box.
    pub(crate) fn back(&self, bounds_world: &Aabb) -> f64 {
        let lens = self.standard();
        let depths = bounds_world
            .corners()
            .map(|corner| self.of.camera.to_view(corner).z);
        let deepest = depths.into_iter().fold(lens.far, f64::max);
        -lens.ndc_depth(deepest + 0.01 * (deepest - lens.near))
    }

    /// The world-space ray that is drawn as a ray here, cut as the camera's rays are. It runs from the first point (`t`
    /// is 0) to the last (`t` is 1) between the near plane and a z behind all. `None` if there is no such part.
    pub(crate) fn ray(&self, drawn: &Ray, back: f64) -> Option<WorldRay<'static>> {
        let [mut begin, mut end] = [drawn.t_min, drawn.t_max];
        // Between the near plane, at z = 0, and the back.
        let (z, per_t) = (drawn.origin.z, drawn.direction.z);
        for (inside, per_t) in [(-z, -per_t), (z - back, per_t)] {
            let border = -inside / per_t;
            if per_t > 0.0 {
                begin = begin.max(border);
            } else if per_t < 0.0 {
                end = end.min(border);
            } else if inside < 0.0 {
                return None;
            }
        }
        if !(begin < end) {
            return None;
        }
        let [from, to] = [begin, end].map(|t| self.world(drawn.at(t)));
        let ray = WorldRay::from(Ray::over(from, to - from, [0.0, 1.0]));
        Some((self.of.section).map_or(ray, |section| ray.cut_by(&section)))
    }

    /// Gives a vector along the normal, here, of a surface that has a normal at a point; both are in view space. Planes
    /// go by the inverse transpose.
    pub(crate) fn normals(&self) -> impl Fn(DVec3, DVec3) -> DVec3 + use<> {
        let planes = self.matrix().inverse().transpose();
        move |p_view, normal_view| {
            let plane = normal_view.extend(-normal_view.dot(p_view));
            (planes * plane).truncate()
        }
    }

    /// Where a point of view space is drawn.
    pub(crate) fn of_view(&self, p_view: DVec3) -> DVec3 {
        let lens = self.standard();
        let aside = p_view.truncate() / (self.of.half_extent() * lens.w(p_view.z));
        aside.extend(-lens.ndc_depth(p_view.z))
    }

    /// The world point that is drawn at a point.
    fn world(&self, drawn: DVec3) -> DVec3 {
        let (lens, camera) = (self.standard(), &self.of.camera);
        let depth = lens.depth_at(-drawn.z);
        let p_view = (drawn.truncate() * self.of.half_extent() * lens.w(depth)).extend(depth);
        camera.eye() + camera.rotation().transpose() * p_view
    }

    /// The lens with standard depth.
    fn standard(&self) -> Lens {
        Lens {
            depth: DepthMapping::Standard,
            ..*self.of.camera.lens()
        }
    }
}
