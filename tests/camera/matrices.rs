//! The matrices are the textbook's, and points are shown where the matrices put them.

use super::{
    MAPPINGS,
    common::{assert_close, assert_near, orthographic, perspective, view},
    views, with_depth,
};
use glam::{DVec3, DVec4, Vec4Swizzles, dcamera::rh, dvec3};
use sightline::camera::{DepthMapping, Lens, Projection, View};

/// A point's NDC by the matrix that the GPU gets, not by `Camera::project`.
fn through_matrix(view: &View, point_world: DVec3) -> DVec3 {
    let clip: DVec4 =
        view.camera.projection(view.viewport) * view.camera.view() * point_world.extend(1.0);
    clip.xyz() / clip.w
}

#[test]
fn a_segment_is_shown_from_the_near_plane_on() {
    let seen = view(
        [0.0; 3],
        [0.0, 0.0, -1.0],
        perspective(90.0, 1.0, 10.0),
        [100, 100],
    );
    let px = |point: DVec3| seen.project(point).unwrap().px;
    // From depth 5 to depth -1: the near plane, at depth 1, cuts it after two thirds of the way.
    let (shown, behind) = (dvec3(4.0, 2.0, -5.0), dvec3(0.0, -2.0, 1.0));
    let cut = px(dvec3(4.0 / 3.0, -2.0 / 3.0, -1.0));
    let [first, last] = seen.project_segment(shown, behind).unwrap();
    assert_near(first.extend(0.0), px(shown).extend(0.0), 1e-9);
    assert_near(last.extend(0.0), cut.extend(0.0), 1e-9);
    let [first, last] = seen.project_segment(behind, shown).unwrap();
    assert_near(first.extend(0.0), cut.extend(0.0), 1e-9);
    assert_near(last.extend(0.0), px(shown).extend(0.0), 1e-9);
    let beside = shown + DVec3::X;
    let whole = seen.project_segment(shown, beside).unwrap();
    assert_eq!(whole, [px(shown), px(beside)]);
    assert!(seen.project_segment(behind, DVec3::ZERO).is_none());
}

#[test]
fn worked_values_of_the_course() {
    let standard = |lens| with_depth(lens, DepthMapping::Standard);
    let square = [100, 100];
    // Eye at the origin, R = +x, U = +y, F = -z.
    let perspective = standard(perspective(90.0, 1.0, 10.0));
    let seen = view([0.0; 3], [0.0, 0.0, -1.0], perspective, square);
    let expected = dvec3(-0.5, 0.75, 5.0 / 9.0);
    let point = dvec3(-1.0, 1.5, -2.0);
    assert_near(seen.project(point).unwrap().ndc, expected, 1e-12);
    assert_near(through_matrix(&seen, point), expected, 1e-12);

    let orthographic = standard(orthographic(20.0, 1.0, 10.0));
    let seen = view([0.0; 3], [0.0, 0.0, -1.0], orthographic, square);
    let expected = dvec3(-0.2, 0.5, -1.0 / 18.0);
    let point = dvec3(-2.0, 5.0, -0.5);
    assert_near(seen.project(point).unwrap().ndc, expected, 1e-12);
    assert_near(through_matrix(&seen, point), expected, 1e-12);
}

#[test]
fn projection_times_view_is_glams() {
    for view in views() {
        let lens = view.camera.lens();
        let Lens { near, far, .. } = *lens;
        let aspect = view.viewport.aspect();
        let of_planes = |near, far| match lens.projection {
            Projection::Perspective { fov_y } => {
                rh::proj::directx::perspective(fov_y, aspect, near, far)
            }
            Projection::Orthographic { height } => {
                let (top, right) = (0.5 * height, 0.5 * height * aspect);
                rh::proj::directx::orthographic(-right, right, -top, top, near, far)
            }
        };
        // Reversed depth is 1 - z: the same projection with near and far exchanged.
        let theirs = match lens.depth {
            DepthMapping::Standard => of_planes(near, far),
            DepthMapping::Reversed => of_planes(far, near),
        };
        let camera = &view.camera;
        let theirs = theirs * rh::view::look_to_mat4(camera.eye(), camera.forward(), camera.up());
        let ours = camera.projection(view.viewport) * camera.view();
        // Entries are sums of products. Their rounding error scales with the row's largest entry.
        for row in 0..4 {
            let (ours, theirs) = (ours.row(row), theirs.row(row));
            let error = (ours - theirs).abs().max_element();
            assert!(
                error <= 1e-12 * theirs.abs().max_element(),
                "{ours} is not {theirs}"
            );
        }
        assert_close(camera.view().determinant(), -1.0, 1e-12);
    }
}

#[test]
fn corners_of_the_frustum_are_corners_of_ndc() {
    for depth in MAPPINGS {
        for lens in [perspective(60.0, 0.5, 50.0), orthographic(7.0, -2.0, 50.0)] {
            let lens = with_depth(lens, depth);
            let view = view([3.0, -2.0, 5.0], [0.5, 1.0, -4.0], lens, [320, 200]);
            let camera = &view.camera;
            for (z, ndc_z) in match depth {
                DepthMapping::Standard => [(lens.near, 0.0), (lens.far, 1.0)],
                DepthMapping::Reversed => [(lens.near, 1.0), (lens.far, 0.0)],
            } {
                for (sx, sy) in [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)] {
                    let top = match lens.projection {
                        Projection::Perspective { fov_y } => z * (0.5 * fov_y).tan(),
                        Projection::Orthographic { height } => 0.5 * height,
                    };
                    let aside = sx * top * 1.6 * camera.right() + sy * top * camera.up();
                    let corner = camera.eye() + z * camera.forward() + aside;
                    let expected = dvec3(sx, sy, ndc_z);
                    assert_near(through_matrix(&view, corner), expected, 1e-12);
                    assert_near(view.project(corner).unwrap().ndc, expected, 1e-12);
                }
            }
        }
    }
}
