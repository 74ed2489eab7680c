//! The nearest surface on a pixel's ray in a whole scene, decided without rounding for the stored numbers of camera,
//! placements and vertices.

use crate::{
    camera::View,
    geometry::{Aabb, Cuboid, Mesh, MeshData, Ray, Sides, Sphere, Square},
    scene::{Object, Scene, Shape},
    study::{
        exact::{Exact, Exact3},
        methods::picks::Picked,
        real::V3,
    },
};
use glam::{DVec2, DVec3};
use std::cmp::Ordering;

/// A pixel's ray, times the picture's height: nothing is divided, and nothing rounds.
struct Line {
    origin: Exact3,
    direction: Exact3,
    height: Exact,
}

/// A ray in an object's space, times the model's determinant and the picture's height, so that nothing is divided: `origin / det`
/// is where it starts.
struct Local {
    origin: Exact3,
    direction: Exact3,
    det: Exact,
    t_min: Exact,
    t_max: Option<Exact>,
}

/// A meeting of a ray and a surface.
struct Meeting {
    t: Exact,
    /// Whether the ray runs against the outward normal.
    front: bool,
}

/// The nearest hit within the ray's interval on a side that shows; of equal ones the lower object, then the lower triangle.
#[must_use]
pub fn truth(scene: &Scene, view: &View, px: DVec2) -> Picked {
    let line = Line::new(view, px);
    let ray = line.rounded(view);
    let mut best: Option<(Exact, usize, Option<u32>)> = None;
    for (index, object) in scene.objects().iter().enumerate() {
        if !object.visible || !may_hit(&scene.bounds_of(index), &ray) {
            continue;
        }
        let local = Local::new(object, &line, &ray);
        let mut consider = |Meeting { t, front }: Meeting, triangle: Option<u32>| {
            let shown = front || view.sides == Sides::Both;
            let nearer = best.as_ref().is_none_or(|(known, _, _)| t < *known);
            if shown && nearer && local.contains(&t) {
                best = Some((t, index, triangle));
            }
        };
        match &object.shape {
            Shape::Sphere => (local.sphere().into_iter()).for_each(|at| consider(at, None)),
            Shape::Cube => (local.cube().into_iter()).for_each(|at| consider(at, None)),
            Shape::Square => (local.square().into_iter()).for_each(|at| consider(at, None)),
            Shape::Mesh { mesh, part } => {
                let range = mesh.data().parts[*part].triangles.clone();
                let origin = mesh.data().origin;
                let model = object.placement.model();
                let start = model.matrix3 * origin;
                let from_eye = start + model.translation - ray.origin;
                let sizes = [start, model.translation, ray.origin].map(DVec3::length);
                let grain = 1e-12 * sizes.iter().sum::<f64>();
                for triangle in range.clone() {
                    let corners = corners(mesh, triangle);
                    let apart = corners.map(|at| from_eye + model.matrix3 * DVec3::from(at));
                    if near_triangle(ray.direction, apart, grain)
                        && let Some(at) = local.triangle(&origin, corners)
                    {
                        consider(at, Some(triangle - range.start));
                    }
                }
            }
        }
    }
    best.map(|(_, object, triangle)| (object, triangle))
}

/// A triangle's corners about the mesh's origin, as they are stored.
fn corners(mesh: &Mesh, triangle: u32) -> [V3<f64>; 3] {
    let MeshData {
        positions,
        triangles,
        ..
    } = mesh.data();
    triangles[triangle as usize].map(|i| V3::from(positions[i as usize].map(f64::from)))
}

/// Whether the ray comes near a box grown by a thousandth of its size: leaves out what is certainly missed.
fn may_hit(bounds: &Aabb, ray: &Ray) -> bool {
    let center = bounds.center() - ray.origin;
    let along = ray.direction.normalize();
    let aside = center - center.dot(along) * along;
    aside.length() <= 1.001 * bounds.radius() + 1e-9 * center.length()
}

/// Whether no `f64` volume has certainly another sign than the others: leaves out what is certainly missed. Corners are
/// in the world, relative to the ray's origin and off by no more than `grain`.
fn near_triangle(direction: DVec3, corners: [DVec3; 3], grain: f64) -> bool {
    let [a, b, c] = corners;
    let size = a.length() + b.length() + c.length();
    let slack = direction.length() * size * (1e-9 * size + grain);
    let volumes = [b.cross(c), c.cross(a), a.cross(b)].map(|side| direction.dot(side));
    volumes.iter().all(|&v| v >= -slack) || volumes.iter().all(|&v| v <= slack)
}

impl Line {
    /// `eye + t (F + a)` or `eye + a + t F`, with `a = (h / H) ((2 px - W) R + (H - 2 py) U)`.
    fn new(view: &View, px: DVec2) -> Self {
        let camera = &view.camera;
        let [eye, right, up, forward] =
            [camera.eye(), camera.right(), camera.up(), camera.forward()]
                .map(|v| Exact3::new(V3::from(v)));
        let size = view.viewport.size_px();
        let [x, y] = [px.x, px.y].map(|at| &Exact::int(2) * &Exact::new(at));
        let [width, height] = [size.x, size.y].map(Exact::new);
        let aside = &right.times(&(&x - &width)) + &up.times(&(&height - &y));
        let aside = aside.times(&Exact::new(camera.half_height()));
        let (eye, forward) = (eye.times(&height), forward.times(&height));
        let (origin, direction) = if camera.lens().is_orthographic() {
            (&eye + &aside, forward)
        } else {
            (eye, &forward + &aside)
        };
        Self {
            origin,
            direction,
            height,
        }
    }
}

impl Line {
    /// For what leaves out what is certainly missed.
    fn rounded(&self, view: &View) -> Ray {
        let lens = view.camera.lens();
        let rounded =
            |of: &Exact3| DVec3::from(of.0.each_ref().map(|c| (c / &self.height).to_f64()));
        Ray {
            origin: rounded(&self.origin),
            direction: rounded(&self.direction),
            t_min: lens.near,
            t_max: lens.far,
        }
    }
}

impl Local {
    fn new(object: &Object, line: &Line, ray: &Ray) -> Self {
        let model = object.placement.model();
        let exact = |v: DVec3| Exact3::new(V3::from(v));
        let m = model.matrix3;
        let [a, b, c] = [m.x_axis, m.y_axis, m.z_axis].map(exact);
        let rows = [b.cross(&c), c.cross(&a), a.cross(&b)];
        let det = a.dot(&rows[0]);
        let adjugate = |v: &Exact3| Exact3(rows.each_ref().map(|row| row.dot(v)));
        let from = &line.origin - &exact(model.translation).times(&line.height);
        Self {
            origin: adjugate(&from),
            direction: adjugate(&line.direction),
            det: &det * &line.height,
            t_min: Exact::new(ray.t_min),
            t_max: ray.t_max.is_finite().then(|| Exact::new(ray.t_max)),
        }
    }

    fn contains(&self, t: &Exact) -> bool {
        *t >= self.t_min && self.t_max.as_ref().is_none_or(|end| t < end)
    }

    /// Whether a ray runs against a normal, given their scalar product here, where a mirrored object's direction is
    /// turned about.
    fn is_front(&self, fall: &Exact) -> bool {
        (fall * &self.det).sign() == Ordering::Less
    }

    fn triangle(&self, origin: &DVec3, corners: [V3<f64>; 3]) -> Option<Meeting> {
        let origin = Exact3::new(V3::from(*origin));
        let [a, b, c] = corners.map(|corner| {
            let corner = &origin + &Exact3::new(corner);
            &corner.times(&self.det) - &self.origin
        });
        let d = &self.direction;
        let volumes = [b.cross(&c), c.cross(&a), a.cross(&b)].map(|side| d.dot(&side));
        let none_is = |excluded: Ordering| volumes.iter().all(|volume| volume.sign() != excluded);
        let normal = (&b - &a).cross(&(&c - &a));
        let fall = normal.dot(d);
        if !(none_is(Ordering::Less) || none_is(Ordering::Greater)) || fall.is_zero() {
            return None;
        }
        Some(Meeting {
            t: &normal.dot(&a) / &fall,
            front: self.is_front(&fall),
        })
    }

    fn sphere(&self) -> Vec<Meeting> {
        let radius = &Exact::new(Sphere::RADIUS) * &self.det;
        let (o, d) = (&self.origin, &self.direction);
        let (a, b) = (d.dot(d), -o.dot(d));
        let c = &o.dot(o) - &(&radius * &radius);
        let discriminant = &(&b * &b) - &(&a * &c);
        if discriminant.sign() == Ordering::Less {
            return Vec::new();
        }
        let root = discriminant.sqrt();
        // The scalar product with the normal is the root, less than 0 at the entry.
        let front = !root.is_zero();
        let at = |t: Exact, front: bool| Meeting { t, front };
        vec![at(&(&b - &root) / &a, front), at(&(&b + &root) / &a, false)]
    }

    fn cube(&self) -> Vec<Meeting> {
        let half = (&Exact::new(Cuboid::HALF_SIDE) * &self.det).abs();
        let mut hits: Vec<Meeting> = Vec::new();
        for axis in 0..3 {
            if self.direction.0[axis].is_zero() {
                continue;
            }
            for plane in [half.clone(), -half.clone()] {
                let t = &(&plane - &self.origin.0[axis]) / &self.direction.0[axis];
                let inside = (0..3).filter(|&other| other != axis).all(|other| {
                    // Without the quotient: |o + t d| <= half at t = (plane - o) / d.
                    let fall = &self.direction.0[axis];
                    let at = &(&self.origin.0[other] * fall)
                        + &(&(&plane - &self.origin.0[axis]) * &self.direction.0[other]);
                    at.abs() <= (&half * fall).abs()
                });
                if inside {
                    let front = (&plane * &self.direction.0[axis]).sign() == Ordering::Less;
                    hits.push(Meeting { t, front });
                }
            }
        }
        hits
    }

    fn square(&self) -> Option<Meeting> {
        let half = (&Exact::new(Square::HALF_SIDE) * &self.det).abs();
        let [x, y, z] = &self.origin.0;
        let [dx, dy, dz] = &self.direction.0;
        if dz.is_zero() {
            return None;
        }
        let inside = |o: &Exact, d: &Exact| (&(o * dz) - &(z * d)).abs() <= (&half * dz).abs();
        (inside(x, dx) && inside(y, dy)).then(|| Meeting {
            t: &(-z.clone()) / dz,
            front: self.is_front(dz),
        })
    }
}
