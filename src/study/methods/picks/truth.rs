//! Finds the nearest surface on a pixel's ray in a whole scene, by exact arithmetic on the stored numbers of camera,
//! placements and vertices.

use super::Picked;
use crate::{
    camera::View,
    geometry::{Aabb, Cuboid, Mesh, Placement, Ray, Sides, Sphere, Square},
    scene::{Scene, Shape},
    study::{prelude::*, truth::Meeting},
};
use glam::{DVec2, DVec3};
use std::cmp::Ordering;

/// A pixel's ray, multiplied by the picture's height, so that no division rounds.
struct ExactRay {
    line: Line,
    height: Exact,
}

/// A ray in an object's space, multiplied by `det`: the model's determinant times the picture's height.
struct Local {
    line: Line,
    det: Exact,
}

/// The nearest hit within the ray's interval on a visible side. Of equally near hits, the object with the lower index counts, then the
/// lower triangle.
pub fn truth(scene: &Scene, view: &View, px: DVec2) -> Picked {
    let exact_ray = ExactRay::new(view, px);
    let ray = exact_ray.rounded(view);
    let t_min = Exact::new(ray.t_min);
    let t_max = ray.t_max.is_finite().then(|| Exact::new(ray.t_max));
    let mut best: Option<(Exact, usize, Option<u32>)> = None;
    for (index, object) in scene.objects().iter().enumerate() {
        if !object.visible || !may_hit(&scene.bounds_of(index), &ray) {
            continue;
        }
        let local = Local::new(&object.placement, &exact_ray);
        let mut consider = |Meeting { t, front }: Meeting, triangle: Option<u32>| {
            let shown = front || view.sides == Sides::Both;
            let nearer = best.as_ref().is_none_or(|(known, _, _)| t < *known);
            let within = t >= t_min && t_max.as_ref().is_none_or(|end| t < *end);
            if shown && nearer && within {
                best = Some((t, index, triangle));
            }
        };
        match &object.shape {
            Shape::Sphere => {
                for at in local.line.sphere(&local.length(Sphere::RADIUS)) {
                    consider(at, None);
                }
            }
            Shape::Cube => {
                for at in local.line.cube(&local.length(Cuboid::HALF_SIDE)) {
                    consider(at, None);
                }
            }
            Shape::Square => {
                let [middle, u, v] = [DVec3::ZERO, DVec3::X, DVec3::Y]
                    .map(|at| local.point(&exact(2.0 * Square::HALF_SIDE * at)));
                if let Some(at) = local.line.parallelogram(&middle, [&u, &v]) {
                    consider(local.turned(at), None);
                }
            }
            Shape::Mesh { mesh, part } => {
                let range = mesh.part_triangles(*part);
                let origin = mesh.data().origin;
                let model = object.placement.model();
                let start = model.matrix3 * origin;
                let from_eye = start + model.translation - ray.origin;
                let sizes = [start, model.translation, ray.origin].map(DVec3::length);
                let grain = 1e-12 * sizes.iter().sum::<f64>();
                for triangle in range.clone() {
                    let corners = corners(mesh, triangle);
                    let apart = corners.map(|at| from_eye + model.matrix3 * DVec3::from(at));
                    let exactly = |corner| local.point(&(exact(origin) + Exact3::new(corner)));
                    if near_triangle(ray.direction, apart, grain)
                        && let Some(at) = local.line.triangle(corners.map(exactly))
                    {
                        consider(local.turned(at), Some(triangle - range.start));
                    }
                }
            }
        }
    }
    best.map(|(_, object, triangle)| (object, triangle))
}

/// A triangle's corners about the mesh's origin, as they are stored.
fn corners(mesh: &Mesh, triangle: u32) -> [V3<f64>; 3] {
    let data = mesh.data();
    let corners = data.triangles[triangle as usize].map(|i| data.positions[i as usize]);
    corners.map(|corner| V3::from(corner.map(f64::from)))
}

/// A filter: false where the ray certainly misses a box's bounding sphere, grown by a thousandth.
fn may_hit(bounds: &Aabb, ray: &Ray) -> bool {
    let center = bounds.center() - ray.origin;
    let along = ray.direction.normalize();
    let aside = center - center.dot(along) * along;
    aside.length() <= 1.001 * bounds.radius() + 1e-9 * center.length()
}

/// A filter: false where two `f64` volumes certainly differ in sign, so that the triangle is missed. Corners are in the
/// world, relative to the ray's origin, with errors up to `grain`.
fn near_triangle(direction: DVec3, corners: [DVec3; 3], grain: f64) -> bool {
    let [a, b, c] = corners;
    let size = a.length() + b.length() + c.length();
    let slack = direction.length() * size * (1e-9 * size + grain);
    let volumes = [b.cross(c), c.cross(a), a.cross(b)].map(|side| direction.dot(side));
    volumes.iter().all(|&v| v >= -slack) || volumes.iter().all(|&v| v <= slack)
}

fn exact(v: DVec3) -> Exact3 {
    Exact3::new(V3::from(v))
}

impl ExactRay {
    /// `eye + t (F + a)` or `eye + a + t F`, with `a = (h / H) ((2 px - W) R + (H - 2 py) U)`.
    fn new(view: &View, px: DVec2) -> Self {
        let camera = &view.camera;
        let [eye, right, up, forward] =
            [camera.eye(), camera.right(), camera.up(), camera.forward()].map(exact);
        let size = view.viewport.size_px();
        let [x, y] = [px.x, px.y].map(|at| Exact::int(2) * Exact::new(at));
        let [width, height] = [size.x, size.y].map(Exact::new);
        let aside = right.times(&(x - width)) + up.times(&(&height - y));
        let aside = aside.times(&Exact::new(camera.half_height()));
        let (eye, forward) = (eye.times(&height), forward.times(&height));
        let (origin, direction) = if camera.lens().is_orthographic() {
            (eye + aside, forward)
        } else {
            (eye, forward + aside)
        };
        Self {
            line: Line { origin, direction },
            height,
        }
    }

    /// The ray in `f64`, for the filters.
    fn rounded(&self, view: &View) -> Ray {
        let lens = view.camera.lens();
        let rounded =
            |of: &Exact3| DVec3::from(of.0.each_ref().map(|c| (c / &self.height).to_f64()));
        Ray {
            origin: rounded(&self.line.origin),
            direction: rounded(&self.line.direction),
            t_min: lens.near,
            t_max: lens.far,
        }
    }
}

impl Local {
    fn new(placement: &Placement, exact_ray: &ExactRay) -> Self {
        let model = placement.model();
        let m = model.matrix3;
        let [a, b, c] = [m.x_axis, m.y_axis, m.z_axis].map(exact);
        let rows = [b.cross(&c), c.cross(&a), a.cross(&b)];
        let adjugate = |v: &Exact3| Exact3(rows.each_ref().map(|row| row.dot(v)));
        let ExactRay { line, height } = exact_ray;
        let from = &line.origin - exact(model.translation).times(height);
        Self {
            line: Line {
                origin: adjugate(&from),
                direction: adjugate(&line.direction),
            },
            det: a.dot(&rows[0]) * height,
        }
    }

    /// A point of the object, scaled as the ray is.
    fn point(&self, at: &Exact3) -> Exact3 {
        at.times(&self.det)
    }

    /// A length, scaled as the ray is.
    fn length(&self, of: f64) -> Exact {
        (Exact::new(of) * &self.det).abs()
    }

    /// The meeting with the side corrected. A negative determinant reverses the ray, so it meets the other side of a
    /// surface whose corners give its normal.
    fn turned(&self, at: Meeting) -> Meeting {
        let front = at.front != (self.det.sign() == Ordering::Less);
        Meeting { front, ..at }
    }
}
