//! Computes the surfaces of spheres at a pixel.

use super::{
    OUTLINE_CEILING_PX,
    bound::{self, Outline, Reason, Stored},
    section::Sectioned,
    surface::{Depths, Source, Surface},
};
use crate::{
    camera::Projection,
    geometry::{
        Placement, RayDifferential, Sides, Sphere, double_double::DoubleDouble, vector::V3,
    },
    render::{sphere, transform::ViewError, view_space::ViewSpace},
};
use glam::DVec2;

/// What drawing may show of a sphere at a pixel: its front, and its back where the near plane or a section opens it or
/// the eye is inside.
pub(super) fn surfaces(space: &ViewSpace, placement: &Placement, px: DVec2) -> Vec<Surface> {
    let (both, is_opened) = both(space, placement, px);
    let shown = 1 + usize::from(is_opened && space.view().sides == Sides::Both);
    both.into_iter().take(shown).collect()
}

/// The sphere's front and its back at a pixel, and whether the near plane or a section may open it.
///
/// A sphere has no vertices, so no grid moves it: the shader solves the ray's quadratic at the pixel's exact centre.
/// Its only error is that of `f32`, bounded by [`sphere::rounding`].
pub(super) fn both(space: &ViewSpace, placement: &Placement, px: DVec2) -> ([Surface; 2], bool) {
    let (view, depths) = (space.view(), Depths::new(space));
    let lens = view.camera.lens();
    let error = sphere::rounding(&sphere::sphere(space, placement, 0), space.unit(), px);
    let ray = sphere::ray_object::<DoubleDouble>(view, placement, px);
    let d2 = ray.direction.rounded().length_squared();
    // Computed from the ray's point nearest to the sphere's centre, where no digits cancel.
    let (middle, outside) = sphere::nearest_to_centre(&ray);
    let middle: f64 = (middle - lens.near.into()).into();
    let discriminant = -d2 * outside;
    let change = Change::of_discriminant(lens.projection, &ray);
    let rim = Outline {
        distance_px: change.least_distance_px(discriminant),
        grid_px: 0.0,
        f32_px: change.least_distance_px(error.discriminant),
    };
    // The root is 0 on the rim, and never -0: the slope is divided by it.
    let root = (outside.min(0.0).abs() / d2).sqrt();
    // How much half a pixel aside changes the root, which is `sqrt(discriminant) / d^2`. It is at most the sphere's
    // radius.
    let of_slope = OUTLINE_CEILING_PX * change.slope / (2.0 * d2 * d2 * root);
    let of_slope = (Sphere::RADIUS / d2.sqrt()).min(of_slope);
    let ends = [middle - root, middle + root];
    let errors = [0, 1].map(|i| ViewError {
        aside: DVec2::ZERO,
        depth: error.depth[i],
        buffer_depth: error.buffer_depth[i],
    });
    let section = Sectioned::new(space);
    let projectable = ends.map(|end| depths.projectable(end));
    let sections = [0, 1].map(|i| section.sphere(px, projectable[i], of_slope, &errors[i]));
    let is_opened = ends[0] < depths.near_error(&errors[0], false)
        || !sections[0].keeps
        || sections[0].reason.is_some();
    let both = [0, 1].map(|i| {
        let (past_near, error) = (ends[i], errors[i]);
        let at = projectable[i];
        let nearness = depths.nearness(at);
        let rounding = depths.error(at, &error);
        // Nothing moves the surface aside at the centre: no grid acts on it, and the rim is handled on its own.
        let ceiling =
            |past_near| depths.ceiling(past_near) + of_slope * depths.stored_per_depth(past_near);
        let beyond_f32 = bound::beyond_f32(0.0, rounding, ceiling(at));
        let near_error = depths.near_error(&error, false);
        let cut_error = near_error * depths.stored_per_depth(0.0);
        let cut_beyond = bound::beyond_f32(0.0, cut_error, ceiling(0.0));
        let cut = Reason::at_near_plane(past_near.abs(), [0.0, near_error], cut_beyond);
        Surface {
            coverage: (rim.reason().into_iter().chain(cut))
                .chain(sections[i].reason)
                .reduce(Reason::or),
            neighbour: None,
            section: None,
            may_keep: sections[i].may_keep,
            triangle: None,
            outline: rim,
            covers: discriminant >= 0.0 && past_near >= 0.0 && sections[i].keeps,
            depth: lens.near + past_near,
            stored: Stored {
                nearness,
                nearest: nearness + rounding,
                farthest: nearness - rounding,
                rounding,
                ceiling: ceiling(at),
                beyond_f32,
            },
            source: Source::Sphere(*placement),
        }
    });
    (both, is_opened)
}

/// How fast the discriminant changes over the picture: by at most `slope s + bend s^2` within s pixels.
///
/// The discriminant is `r^2 |d|^2 - |o x d|^2`, which is quadratic over the picture. Let w be the ray's step for a
/// pixel offset: that of the direction d in perspective, that of the origin o in orthographic projection. In
/// perspective the slope is `2 r^2 d.w - 2 (o x d).(o x w)`, and the bend is at most `r^2 |w|^2 + |o x w|^2`. In
/// orthographic projection the slope is `-2 (o x d).(w x d)`, and the bend is at most `|w x d|^2`.
struct Change {
    slope: f64,
    bend: f64,
}

impl Change {
    fn of_discriminant(projection: Projection, ray: &RayDifferential<DoubleDouble>) -> Self {
        let (o, d) = (ray.origin, ray.direction);
        let r2 = Sphere::RADIUS * Sphere::RADIUS;
        let across = |a: V3<DoubleDouble>, b: V3<DoubleDouble>| a.cross(b).rounded();
        let moment = across(o, d);
        let [(x, bend_x), (y, bend_y)] = [ray.right, ray.down].map(|step| match projection {
            Projection::Perspective { .. } => {
                let turn = across(o, step);
                let (d, step) = (d.rounded(), step.rounded());
                let slope = 2.0 * (r2 * d.dot(step) - moment.dot(turn));
                (slope, r2 * step.length_squared() + turn.length_squared())
            }
            Projection::Orthographic { .. } => {
                let turn = across(step, d);
                (-2.0 * moment.dot(turn), turn.length_squared())
            }
        });
        Self {
            slope: DVec2::new(x, y).length(),
            bend: bend_x + bend_y,
        }
    }

    /// A lower bound on the distance in pixels at which the discriminant differs by `change` from its value at the
    /// centre.
    fn least_distance_px(&self, change: f64) -> f64 {
        let (Self { slope, bend }, change) = (self, change.abs());
        2.0 * change / (slope + (slope * slope + 4.0 * bend * change).sqrt())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        camera::{Camera, DepthMapping, Lens, Viewport},
        geometry::random::Random,
    };
    use glam::DVec3;

    /// Positions in pictures of spheres as large as the picture: no discriminant changes by more than its bound.
    #[test]
    fn a_discriminant_changes_within_its_bound() {
        let viewport = Viewport::new(64, 48).expect("a viewport");
        let mut random = Random(61);
        for projection in [
            Projection::Perspective { fov_y: 1.0 },
            Projection::Orthographic { height: 1.5 },
        ] {
            let lens = Lens {
                projection,
                near: 0.1,
                far: 10.0,
                depth: DepthMapping::Reversed,
            };
            let mut reached = 0.0_f64;
            for _ in 0..20_000 {
                let eye = 2.0 * random.point().normalize();
                let camera = Camera::new(eye, DVec3::ZERO, DVec3::Y, lens).expect("a camera");
                let grid = camera.pixel_grid(viewport);
                let ray = |px| grid.differential::<DoubleDouble>(px, DVec3::ZERO);
                let discriminant = |px| {
                    let RayDifferential {
                        origin, direction, ..
                    } = ray(px);
                    let moment = origin.cross(direction).rounded();
                    let size = direction.rounded().length_squared();
                    Sphere::RADIUS.powi(2) * size - moment.length_squared()
                };
                let px = 24.0 * (random.point().truncate() + 1.0);
                let aside = 10.0 * random.point().truncate();
                let change = Change::of_discriminant(projection, &ray(px));
                let (s, changed) = (aside.length(), discriminant(px + aside) - discriminant(px));
                let bound = change.slope * s + change.bend * s * s;
                // The eye is 2 away, so the discriminants' terms are not much larger than the direction's square.
                let size = ray(px + aside).direction.rounded().length_squared();
                let rounding = 100.0 * f64::EPSILON * size;
                assert!(
                    changed.abs() <= bound + rounding,
                    "{changed} at {px} and {aside}"
                );
                reached = reached.max(changed.abs() / bound);
                let nearest = change.least_distance_px(bound);
                assert!((nearest - s).abs() <= 1e-9 * s, "{nearest} for {s}");
            }
            assert!(reached > 0.9, "{projection:?}: {reached}");
        }
    }
}
