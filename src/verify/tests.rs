//! Tests the terms of the bounds against `f32` computed step by step, as shader and hardware do: no error exceeds its
//! bound, and some come so near that the bound would fail without the term.

use super::{
    Class,
    projection::{project, shift_px},
    section::Sectioned,
    surface::Depths,
    view_ray::ViewRay,
};
use crate::{
    camera::{Camera, DepthMapping, Lens, Projection, View, Viewport},
    geometry::{Aabb, Placement, Section, random::Random},
    look::Background,
    render::{
        Rasteriser,
        rounding::U,
        section::{ScreenSection, q},
        transform::{self, VertexToView, ViewError},
        view_space::ViewSpace,
        view_units::{depth_origin, view_unit},
    },
};
use glam::{DAffine3, DMat3, DVec2, DVec3, Vec3};

/// The largest ratio of an error to its bound.
#[derive(Default)]
struct Shares(f64);

impl Shares {
    #[track_caller]
    fn add(&mut self, off: f64, bound: f64) {
        assert!(off.abs() <= bound, "{off:e} is above {bound:e}");
        if off != 0.0 {
            self.0 = self.0.max(off.abs() / bound);
        }
    }

    #[track_caller]
    fn reach(&self, least: f64) {
        assert!(self.0 >= least, "only {} of the bound", self.0);
    }
}

/// A number rounded to `f32`, with subnormals flushed to 0, as GPUs may.
#[expect(clippy::cast_possible_truncation, reason = "that is its purpose")]
fn rounded(value: f64) -> f32 {
    let rounded = value as f32;
    if rounded.is_normal() { rounded } else { 0.0 }
}

/// A product or a sum as a GPU computes it: `f64` holds that of two `f32` exactly, or nearly so.
fn product(a: f32, b: f32) -> f32 {
    rounded(f64::from(a) * f64::from(b))
}

fn sum(a: f32, b: f32) -> f32 {
    rounded(f64::from(a) + f64::from(b))
}

/// A reciprocal that is off by two units in the last place.
fn reciprocal(random: &mut Random, w: f32) -> f32 {
    let exact = 1.0 / w;
    if random.next() > 0.0 {
        exact.next_up().next_up()
    } else {
        exact.next_down().next_down()
    }
}

const MAPPINGS: [DepthMapping; 2] = [DepthMapping::Reversed, DepthMapping::Standard];

/// A view of the unit ball about the origin.
fn view(random: &mut Random, depth: DepthMapping, orthographic: bool) -> View {
    let eye = (3.0 + random.next()) * random.point().normalize();
    let fov_y = 0.8 + 0.5 * random.next();
    let lens = Lens {
        projection: if orthographic {
            Projection::Orthographic {
                height: 4.0 * fov_y,
            }
        } else {
            Projection::Perspective { fov_y }
        },
        near: 0.3 + 0.2 * random.next(),
        far: 20.0 + 10.0 * random.next(),
        depth,
    };
    let target = 0.3 * random.point();
    let camera = Camera::new(eye, target, random.point(), lens).expect("a camera");
    View::new(camera, Viewport::DEFAULT)
}

fn views(count: usize) -> impl Iterator<Item = (View, Random)> {
    (0..count).map(|i| {
        let mut random = Random(i as u64);
        let view = view(&mut random, MAPPINGS[i % 2], i / 2 % 2 == 0);
        (view, random)
    })
}

/// The vertex shader's result: right, up, buffer depth, view depth.
fn vertex(to_view: &VertexToView, position: Vec3) -> [f32; 4] {
    let from_pivot = [0, 1, 2].map(|i| sum(position[i], -to_view.pivot[i]));
    let row = |i: usize| {
        let terms = [0, 1, 2].map(|k| product(to_view.linear.col(k)[i], from_pivot[k]));
        sum(sum(terms[0], terms[1]), terms[2])
    };
    let turned = [0, 1, 2].map(row);
    let [x, y, z] = [0, 1, 2].map(|i| sum(turned[i], to_view.translation[i]));
    [x, y, z, sum(turned[2], to_view.view_depth)]
}

/// The vertex shader's errors over their bounds, for vertices of this size: aside, and in depth.
fn vertices(size: f64, views: impl Iterator<Item = (View, Random)>) -> [Shares; 2] {
    let mut shares = <[Shares; 2]>::default();
    for (view, mut random) in views {
        let space = ViewSpace::new(&view);
        let linear = DMat3::from_cols(random.point(), random.point(), random.point());
        let placement = Placement::new(DAffine3::from_mat3(linear)).expect("no singular one");
        let bounds = Aabb::of_half_size(DVec3::splat(size));
        let to_view = VertexToView::new(&space, &placement, DVec3::ZERO, &bounds);
        let rounding = to_view.rounding(&space, &placement, DVec3::ZERO);
        let position = (size * random.point()).as_vec3();
        let error = to_view.error_view(&rounding, position);
        let exact = space.at(&placement, DVec3::ZERO, position.as_dvec3());
        let exact = [
            exact.aside.x,
            exact.aside.y,
            exact.buffer_depth,
            exact.depth,
        ];
        let bounds = [
            error.aside.x,
            error.aside.y,
            error.buffer_depth,
            error.depth,
        ];
        let found = vertex(&to_view, position).map(|at| f64::from(at) / space.unit());
        for i in 0..4 {
            shares[i / 2].add(found[i] - exact[i], bounds[i]);
        }
    }
    shares
}

#[test]
fn vertices_lie_within_their_bounds() {
    for shares in vertices(1.0, views(4000)) {
        shares.reach(0.3);
    }
}

/// Vertices as small as the least `f32` numbers, on the line of sight: only underflow moves them aside.
#[test]
fn vertices_that_underflow_lie_within_their_bounds() {
    let straight = views(4000).map(|(view, random)| {
        let camera = Camera::new(3.0 * DVec3::Z, DVec3::ZERO, DVec3::Y, *view.camera.lens());
        let camera = camera.expect("a camera");
        (View { camera, ..view }, random)
    });
    let [aside, _] = vertices(4.0 * f64::from(f32::MIN_POSITIVE), straight);
    aside.reach(0.1);
}

/// The projection in the vertex shader and the hardware's steps after it.
#[test]
fn projected_points_lie_within_their_bounds() {
    let mut shares = Shares::default();
    for (view, mut random) in views(20_000) {
        let frame = transform::frame(&view, Background::BLACK);
        let unit = view_unit(&view);
        let orthographic = view.camera.lens().is_orthographic();
        let depth = rounded(3.0 + random.next());
        let w = if orthographic { 1.0 } else { depth };
        let ndc = DVec2::new(random.next(), random.next());
        let aside = (ndc * view.half_extent() * f64::from(w)).to_array();
        // In orthographic projection lengths of view space are in view units.
        let unit = if orthographic { unit } else { 1.0 };
        let aside = aside.map(|at| rounded(at * unit));
        let size = view.viewport.size_px();
        let by_w = if orthographic {
            1.0
        } else {
            reciprocal(&mut random, w)
        };
        let found = [0, 1].map(|i| {
            let clip = product(aside[i], frame.ndc_per_view[i]);
            let half = rounded([0.5 * size.x, -0.5 * size.y][i]);
            let half_size = rounded([0.5 * size.x, 0.5 * size.y][i]);
            f64::from(sum(product(product(clip, by_w), half), half_size))
        });
        let exact = view.px_of(DVec2::from(aside.map(|at| f64::from(at) / unit)), w.into());
        let bound = shift_px(&view, exact, w.into(), &ViewError::default());
        shares.add(DVec2::from(found).distance(exact), bound);
    }
    shares.reach(0.3);
}

/// Clipping at the near and the far plane decides rightly wherever the plane is farther off than the bound.
#[test]
fn planes_cut_within_their_bounds() {
    for mapping in MAPPINGS {
        for (orthographic, is_far) in [(false, false), (false, true), (true, false), (true, true)] {
            let mut shares = Shares::default();
            for i in 0..20_000 {
                let mut random = Random(i);
                let view = view(&mut random, mapping, orthographic);
                let (space, lens) = (ViewSpace::new(&view), *view.camera.lens());
                let (depths, unit) = (Depths::new(&space), space.unit());
                let plane = if is_far { lens.far } else { lens.near };
                let from_origin = plane - depth_origin(&view);
                let error = ViewError {
                    aside: DVec2::ZERO,
                    depth: 4.0 * U * plane,
                    buffer_depth: 4.0 * U * from_origin.abs().max(lens.near),
                };
                let bound = if is_far {
                    depths.far_error(&error)
                } else {
                    depths.near_error(&error, false)
                };
                let past = 1.5 * bound * random.next();
                // A quarter of the bound is left for rounding.
                let mut off = |at: f64, error: f64| at + 0.75 * error * random.next().signum();
                let buffer_depth = rounded(unit * off(from_origin + past, error.buffer_depth));
                let depth = rounded(unit * off(plane + past, error.depth));
                let clip = product(
                    transform::frame(&view, Background::BLACK).clip_per_depth,
                    buffer_depth,
                );
                let stores_0 = is_far == (mapping == DepthMapping::Reversed);
                let is_seen = if stores_0 {
                    clip >= 0.0
                } else {
                    clip <= if orthographic { 1.0 } else { depth }
                };
                if is_seen != (is_far == (past < 0.0)) {
                    shares.add(past, bound);
                }
            }
            shares.reach(0.3);
        }
    }
}

/// The depth buffer's errors over their bounds, for depths from `near` to far.
fn stored(near: f64) -> [Shares; 2] {
    MAPPINGS.map(|mapping| {
        let mut shares = Shares::default();
        for i in 0..20_000 {
            let mut random = Random(i);
            let any = view(&mut random, mapping, false);
            let mut lens = *any.camera.lens();
            lens.near = near;
            let camera = any.camera.with_lens(lens).expect("a lens");
            let view = View { camera, ..any };
            let space = ViewSpace::new(&view);
            let (depths, unit) = (Depths::new(&space), space.unit());
            let depth = near * (random.next().abs() * (lens.far / near).ln()).exp();
            let past_near = depth - near;
            let to_origin = depth_origin(&view) - near;
            let exact = [past_near - to_origin, depth];
            let error = ViewError {
                aside: DVec2::ZERO,
                depth: 2.0 * U * depth,
                buffer_depth: 2.0 * U * exact[0].abs(),
            };
            let [buffer_depth, w] = exact.map(|at| rounded(unit * at));
            let factor = rounded(
                transform::frame(&view, Background::BLACK)
                    .clip_per_depth
                    .into(),
            );
            let found = product(product(factor, buffer_depth), reciprocal(&mut random, w));
            let bound = depths.error(past_near, &error);
            shares.add(f64::from(found) - depths.stored(past_near), bound);
        }
        shares
    })
}

#[test]
fn stored_depths_lie_within_their_bounds() {
    for shares in stored(0.1) {
        shares.reach(0.3);
    }
}

/// A section's test on a triangle whose corners the grid moves, with q interpolated between them as moved. It decides
/// as the exact test does, except within the bound; a face in the plane is kept whole.
#[test]
fn sections_decide_within_their_bounds_on_moved_corners() {
    let grid_px = Rasteriser::COMMON.grid_px;
    let mut shares = Shares::default();
    let mut kept_in_plane = 0;
    for (any, mut random) in views(20_000) {
        let (at, normal) = (0.3 * random.point(), random.point().normalize());
        let section = Section::through(at, normal).expect("a plane");
        let view = View {
            section: Some(section),
            ..any
        };
        // In the plane, or inclined to it by an angle of any size.
        let steep = match random.small() {
            -3.0 => 0.0,
            power => 10_f64.powf(power - 4.0),
        };
        let corners = [(); 3].map(|()| {
            let aside = random.point();
            let off = steep * random.next();
            at + aside - (aside.dot(normal) - off) * normal
        });
        let space = ViewSpace::new(&view);
        let seen = corners.map(|corner| space.at(&Placement::IDENTITY, DVec3::ZERO, corner));
        let seen = seen.map(|at| at.aside.extend(at.past_near));
        let half_step = 0.5 * grid_px;
        let moved = seen.map(|at| {
            let by = random.point().truncate();
            project(&view, at) + half_step * by.signum()
        });
        let shares_of = random.point().abs();
        let shares_of = (shares_of / shares_of.element_sum()).to_array();
        let px: DVec2 = (0..3).map(|i| shares_of[i] * moved[i]).sum();
        let q_moved: f64 = (0..3).map(|i| shares_of[i] * q(&space, seen[i].z)[0]).sum();
        let screen = ScreenSection::of(&view).expect("a section");
        let is_drawn =
            screen.value(px, q_moved) >= -screen.corner_slack() - screen.bound(px, q_moved);
        let ray = ViewRay::new(&view, px);
        let face = (seen[1] - seen[0]).cross(seen[2] - seen[0]);
        let past_near = ray.depth_on(seen[0], face);
        let slope = ray.slope(view.camera.lens().near + past_near, face);
        let (sectioned, error) = (Sectioned::new(&space), ViewError::default());
        let exact = sectioned.face(px, past_near, slope, [grid_px, 0.0], &error, || 0.0);
        if steep == 0.0 {
            assert!(is_drawn, "{view:?}: {corners:?}");
            kept_in_plane += 1;
        }
        if is_drawn != exact.keeps {
            let reason = exact.reason.expect("a reason");
            // `f32` cannot hold a section along a face that is seen edge-on.
            let sine = face.normalize().dot(ray.direction.normalize()).abs();
            assert!(reason.class == Class::Section || sine < 1e-3, "{sine}");
            shares.add(reason.strain, 1.0);
        }
    }
    assert!(kept_in_plane > 1000, "{kept_in_plane}");
    shares.reach(0.3);
}

/// Near and far are powers of two, so only the depth's own digits count.
#[test]
fn clipping_is_exact_where_f32_holds_the_depth() {
    for orthographic in [false, true] {
        let projection = if orthographic {
            Projection::Orthographic { height: 4.0 }
        } else {
            Projection::Perspective { fov_y: 1.0 }
        };
        for depth in MAPPINGS {
            let (near, far) = (1.0, 2.0);
            let lens = Lens {
                projection,
                near,
                far,
                depth,
            };
            let camera = Camera::new(DVec3::Z, DVec3::ZERO, DVec3::Y, lens).expect("a camera");
            let view = View::new(camera, Viewport::new(8, 8).expect("a viewport"));
            let depths = Depths::new(&ViewSpace::new(&view));
            for (past_near, expected) in [(0.0, true), (-0.25, true), (0.1, false)] {
                let found = depths.clips_exactly(past_near);
                assert_eq!(found, expected, "{projection:?} {depth:?} {past_near}");
            }
        }
    }
}
