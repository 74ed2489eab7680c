//! Why drawn and picked ids differ at a pixel: geometry, or a defect.
#![allow(dead_code, reason = "each test uses its share")]

use glam::{DMat3, DVec2, DVec3};
use sightline::{
    camera::{DepthMapping, Projection, View},
    geometry::{Cuboid, Ray, Sides, Sphere, Square},
    image::Id,
    render::{
        sphere,
        transform::{VertexToView, depth_origin},
    },
    scene::{Object, Scene, Shape},
};
use std::f64::consts::TAU;

/// The rasteriser's sub-pixel step.
pub const STEP_PX: f64 = 1.0 / 256.0;
/// Half a unit in the last place of 1 in `f32`.
const U: f64 = 0.5 * f32::EPSILON as f64;

/// Why a pixel differs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// The pixel centre is within the rasteriser's step, and less than as much again for `f32`, of an outline.
    Edge,
    /// The two surfaces are as deep as the depth buffer can tell.
    Depth,
    /// As `Edge`, but `f32` moves the outline by more than the rasteriser's step.
    F32Limit,
    /// A defect.
    Unexplained,
}

/// What one side saw at a pixel: distance to its outline, its depth, and how far either may be off.
struct Seen {
    outline_px: f64,
    vertex_px: f64,
    /// NDC z at the pixel, and the most that it may be off; NaN where it does not cover the pixel centre, so that no
    /// depth explains it.
    ndc: f64,
    ndc_error: f64,
}

/// Why `drawn` and `picked` differ at a pixel centre.
pub fn explain(scene: &Scene, view: &View, px: DVec2, drawn: Id, picked: Id) -> Class {
    let [drawn, picked] = [drawn, picked].map(|id| seen(scene, view, px, id));
    let limit = |seen: &Seen| seen.outline_px <= STEP_PX + seen.vertex_px;
    if [&drawn, &picked]
        .into_iter()
        .any(|seen| limit(seen) && seen.vertex_px <= STEP_PX)
    {
        return Class::Edge;
    }
    if (drawn.ndc - picked.ndc).abs() <= drawn.ndc_error + picked.ndc_error {
        return Class::Depth;
    }
    if limit(&drawn) || limit(&picked) {
        Class::F32Limit
    } else {
        Class::Unexplained
    }
}

fn seen(scene: &Scene, view: &View, px: DVec2, id: Id) -> Seen {
    let Some(index) = (id.object as usize).checked_sub(1) else {
        let clear = match view.camera.lens().depth {
            DepthMapping::Reversed => 0.0,
            DepthMapping::Standard => 1.0,
        };
        return Seen {
            outline_px: f64::INFINITY,
            vertex_px: 0.0,
            ndc: clear,
            ndc_error: 0.0,
        };
    };
    let object = &scene.objects()[index];
    match &object.shape {
        Shape::Sphere => of_sphere(object, view, px),
        Shape::Mesh { mesh, part } => {
            let bounds = (scene.batches().iter().find(|batch| batch.contains(&index)))
                .map(|batch| {
                    batch
                        .clone()
                        .fold(sightline::geometry::Aabb::EMPTY, |all, other| {
                            all.union(mesh.part_bounds(part + other - index))
                        })
                })
                .expect("each object is in a batch");
            let origin = mesh.data().origin;
            let bounds = sightline::geometry::Aabb {
                min: bounds.min - origin,
                max: bounds.max - origin,
            };
            let to_view = VertexToView::new(view, &object.placement, origin, &bounds);
            let first = mesh.data().parts[*part].triangles.start;
            let corners = mesh.data().triangles[(first + id.triangle - 1) as usize];
            let corners = corners
                .map(|i| DVec3::from_array(mesh.data().positions[i as usize].map(f64::from)));
            of_polygon(object, view, px, origin, &to_view, &corners)
        }
        Shape::Cube => {
            let to_view =
                VertexToView::new(view, &object.placement, DVec3::ZERO, &Cuboid::bounds());
            let faces = (0..6).map(|face| {
                let n = DVec3::AXES[face % 3] * if face < 3 { 1.0 } else { -1.0 };
                let (u, v) = (DVec3::AXES[(face + 1) % 3], DVec3::AXES[(face + 2) % 3]);
                [n - u - v, n + u - v, n + u + v, n - u + v].map(|p| 0.5 * p)
            });
            let ray = object.placement.ray_to_object(&view.ray(px));
            let shown = Cuboid::hits(&ray)
                .into_iter()
                .flatten()
                .find(|hit| view.sides.shows(ray.direction, hit.normal));
            let all: Vec<_> = faces
                .map(|face| {
                    let normal = (face[1] - face[0]).cross(face[2] - face[0]);
                    (
                        of_polygon(object, view, px, DVec3::ZERO, &to_view, &face),
                        normal.dot(face[0]).signum() * normal,
                    )
                })
                .collect();
            let outline_px = all
                .iter()
                .map(|(seen, _)| seen.outline_px)
                .fold(f64::INFINITY, f64::min);
            let vertex_px = all
                .iter()
                .map(|(seen, _)| seen.vertex_px)
                .fold(0.0, f64::max);
            let face = all
                .into_iter()
                .find(|(_, normal)| shown.is_some_and(|hit| hit.normal.dot(*normal) > 0.5));
            let depth = face.map(|(seen, _)| (seen.ndc, seen.ndc_error));
            let (ndc, ndc_error) = depth.unwrap_or((f64::NAN, 0.0));
            Seen {
                outline_px,
                vertex_px,
                ndc,
                ndc_error,
            }
        }
        Shape::Square => {
            let to_view =
                VertexToView::new(view, &object.placement, DVec3::ZERO, &Square::bounds());
            let face = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)]
                .map(|(x, y)| DVec3::new(x, y, 0.0));
            of_polygon(object, view, px, DVec3::ZERO, &to_view, &face)
        }
    }
}

/// A flat convex polygon, corners in vertex space.
fn of_polygon(
    object: &Object,
    view: &View,
    px: DVec2,
    origin: DVec3,
    to_view: &VertexToView,
    corners: &[DVec3],
) -> Seen {
    let lens = view.camera.lens();
    let half = lens.half_extent(view.viewport.aspect());
    let size = DVec2::new(
        f64::from(view.viewport.width()),
        f64::from(view.viewport.height()),
    );
    let focal = 0.5 * size / half;
    let in_view: Vec<DVec3> = corners
        .iter()
        .map(|&corner| {
            view.camera
                .to_view(object.placement.point_to_world(origin + corner))
        })
        .collect();
    // How far f32 moves the polygon's points at this pixel: the worst corner's error, over the depth there.
    let errors = corners
        .iter()
        .map(|corner| to_view.error_view(corner.as_vec3()));
    let error = errors.fold(DVec3::ZERO, DVec3::max);
    let edges = (0..in_view.len()).filter_map(|i| {
        let [a, b] = clip(in_view[i], in_view[(i + 1) % in_view.len()], lens.near)?;
        let [a, b] = [a, b].map(|p| project(view, p));
        Some(segment_px(px, a, b))
    });
    let cuts = near_cut(&in_view, lens.near);
    let cut = cuts.map(|[a, b]| segment_px(px, project(view, a), project(view, b)));
    let outline_px = edges.chain(cut).fold(f64::INFINITY, f64::min);
    let plane = |px: DVec2| {
        let ray = view_ray(view, px);
        let normal = (in_view[1] - in_view[0]).cross(in_view[2] - in_view[0]);
        let t = normal.dot(in_view[0] - ray.origin) / normal.dot(ray.direction);
        ray.at(t).z
    };
    let depth = plane(px);
    let perspective = matches!(lens.projection, Projection::Perspective { .. });
    let w = if perspective { depth.abs() } else { 1.0 };
    let ndc = lens.ndc_depth(depth);
    let slope = DVec2::new(
        lens.ndc_depth(plane(px + DVec2::X * 0.25)) - lens.ndc_depth(plane(px - DVec2::X * 0.25)),
        lens.ndc_depth(plane(px + DVec2::Y * 0.25)) - lens.ndc_depth(plane(px - DVec2::Y * 0.25)),
    )
    .abs()
        * 2.0;
    // To the picture: x and y by the focal length, z by how it shifts the point; then four roundings of the
    // projection, each relative to the position from the picture's middle.
    let view_px = (error.truncate() * focal / w).max_element();
    let shift = if perspective {
        error.z / w * (px - 0.5 * size).abs().max_element()
    } else {
        0.0
    };
    let vertex_px = view_px + shift + 4.0 * U * size.max_element();
    // A depth step: of the stored value, of the row's two terms, of the interpolation over the picture.
    let (a, b) = lens.depth_row();
    let terms = a.abs()
        * if perspective {
            1.0
        } else {
            (depth - depth_origin(view)).abs()
        }
        + if perspective { b.abs() / w } else { 0.0 };
    let per_depth = if perspective {
        b.abs() / (w * w)
    } else {
        a.abs()
    };
    let ndc_error = 4.0 * U * (ndc.abs() + terms)
        + per_depth * error.z
        + (slope.x + slope.y) * (STEP_PX + vertex_px + 4.0 * U * size.max_element());
    Seen {
        outline_px,
        vertex_px,
        ndc: if covers(&view_ray(view, px), &in_view) {
            ndc
        } else {
            f64::NAN
        },
        ndc_error,
    }
}

fn of_sphere(object: &Object, view: &View, px: DVec2) -> Seen {
    let lens = view.camera.lens();
    let uniform = sphere::sphere(view, &object.placement, 0);
    let (vertex_px, depth_error) = sphere::error(&uniform, px);
    let size = DVec2::new(
        f64::from(view.viewport.width()),
        f64::from(view.viewport.height()),
    );
    let vertex_px = vertex_px + 4.0 * U * size.max_element();
    // Which of the two surfaces count, and how deep they are.
    let at = |px: DVec2| -> [Option<f64>; 2] {
        let ray = view.ray(px);
        let local = object.placement.ray_to_object(&ray);
        let unlimited = Ray {
            t_min: f64::NEG_INFINITY,
            t_max: f64::INFINITY,
            ..local
        };
        let depth = |t: f64| t * ray.direction.dot(view.camera.forward());
        Sphere::hits(&unlimited).map(|hit| {
            hit.filter(|hit| local.contains(hit.t))
                .filter(|hit| view.sides == Sides::Both || hit.is_front(local.direction))
                .map(|hit| depth(hit.t))
        })
    };
    let here = at(px);
    let around = |radius: f64| {
        (0..64).map(move |i| px + radius * DVec2::from_angle(TAU * f64::from(i) / 64.0))
    };
    let reach = STEP_PX + vertex_px;
    let differs = |radius: f64| {
        around(radius).any(|px| at(px).map(|d| d.is_some()) != here.map(|d| d.is_some()))
    };
    let shown = here[0].or(here[1]);
    let which = usize::from(here[0].is_none());
    let ndc = shown.map_or(f64::NAN, |depth| lens.ndc_depth(depth));
    let slopes = around(reach)
        .filter_map(|px| at(px)[which])
        .map(|depth| (lens.ndc_depth(depth) - ndc).abs());
    let depth = shown.unwrap_or(f64::NAN);
    let (a, b) = lens.depth_row();
    let perspective = matches!(lens.projection, Projection::Perspective { .. });
    let per_depth = if perspective {
        b.abs() / (depth * depth)
    } else {
        a.abs()
    };
    // The sphere may also be cut by a plane that lies as deep as it, to what f32 can tell.
    let near_plane = here
        .iter()
        .flatten()
        .chain(&at_any(object, view, px))
        .any(|depth| {
            [lens.near, lens.far]
                .iter()
                .any(|plane| (depth - plane).abs() <= depth_error + 2.0 * U * plane.abs())
        });
    let terms = if perspective {
        a.abs() + b.abs() / depth.abs()
    } else {
        (a * (depth - depth_origin(view))).abs()
    };
    Seen {
        outline_px: if near_plane {
            0.0
        } else if differs(reach) {
            reach
        } else {
            f64::INFINITY
        },
        vertex_px,
        ndc,
        ndc_error: 4.0 * U * (ndc.abs() + terms)
            + per_depth * depth_error
            + slopes.fold(0.0, f64::max),
    }
}

/// Both depths of a sphere on the ray through `px`, whether they count or not.
fn at_any(object: &Object, view: &View, px: DVec2) -> Vec<f64> {
    let ray = view.ray(px);
    let local = object.placement.ray_to_object(&ray);
    let unlimited = Ray {
        t_min: f64::NEG_INFINITY,
        t_max: f64::INFINITY,
        ..local
    };
    let hits = Sphere::hits(&unlimited).into_iter().flatten();
    hits.map(|hit| hit.t * ray.direction.dot(view.camera.forward()))
        .collect()
}

/// Whether a line passes through a convex polygon: on one side of all its edges.
fn covers(ray: &Ray, corners: &[DVec3]) -> bool {
    let sides = (0..corners.len()).map(|i| {
        let [a, b] = [corners[i], corners[(i + 1) % corners.len()]].map(|p| p - ray.origin);
        ray.direction.dot(a.cross(b))
    });
    let (least, most) = sides.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), side| {
        (least.min(side), most.max(side))
    });
    least >= 0.0 || most <= 0.0
}

/// The ray through `px` in view space.
fn view_ray(view: &View, px: DVec2) -> Ray {
    let ray = view.ray(px);
    let rotation: DMat3 = view.camera.rotation();
    Ray {
        origin: rotation * (ray.origin - view.camera.eye()),
        direction: rotation * ray.direction,
        ..ray
    }
}

fn project(view: &View, p: DVec3) -> DVec2 {
    let half = view.camera.lens().half_extent(view.viewport.aspect());
    let w = match view.camera.lens().projection {
        Projection::Perspective { .. } => p.z,
        Projection::Orthographic { .. } => 1.0,
    };
    view.viewport.ndc_to_px(p.truncate() / (half * w))
}

/// The part of a view-space segment at or behind the near plane.
fn clip(a: DVec3, b: DVec3, near: f64) -> Option<[DVec3; 2]> {
    let [da, db] = [a.z - near, b.z - near];
    let cut = || a.lerp(b, da / (da - db));
    match (da >= 0.0, db >= 0.0) {
        (true, true) => Some([a, b]),
        (true, false) => Some([a, cut()]),
        (false, true) => Some([cut(), b]),
        (false, false) => None,
    }
}

/// Where the near plane cuts a convex polygon.
fn near_cut(corners: &[DVec3], near: f64) -> Option<[DVec3; 2]> {
    let crossings: Vec<DVec3> = (0..corners.len())
        .filter_map(|i| {
            let (a, b) = (corners[i], corners[(i + 1) % corners.len()]);
            ((a.z >= near) != (b.z >= near)).then(|| a.lerp(b, (a.z - near) / (a.z - b.z)))
        })
        .collect();
    <[DVec3; 2]>::try_from(crossings).ok()
}

fn segment_px(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let along = b - a;
    let s = (p - a).dot(along) / along.length_squared();
    p.distance(if s.is_nan() {
        a
    } else {
        a + s.clamp(0.0, 1.0) * along
    })
}
