//! Makes a whole pick in which a method of the registry does one step and Sightline does all others. This shows the
//! method's mistakes on a scene.

use super::{methods::rays::PixelRay, prelude::*, run};
use crate::{
    camera::View,
    geometry::{Cuboid, Hit, Mesh, OnTriangle, Ray, Sphere, Square, WorldRay},
    pick,
    scene::{Object, Scene, Shape},
};
use glam::{DVec2, DVec3};

/// The result of a pick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// Object and triangle. `t` is that of the ray that was cast.
    pub hit: SceneHit,
    /// The point in the world.
    pub point_world: DVec3,
    /// The outward unit normal in the world.
    pub normal_world: DVec3,
}

/// A position in a view of a scene, with Sightline's ray through it.
#[derive(Debug)]
pub struct Click<'a> {
    scene: &'a Scene,
    view: &'a View,
    px: DVec2,
    ray: WorldRay<'static>,
}

/// A step of a pick that any of the step's methods can do.
pub trait Step: Case {
    /// The pick with this step done by `run`; `None` for a miss.
    fn pick(click: &Click<'_>, run: fn(&Self) -> Self::Answer) -> Option<Found>;
}

/// [`run::family`] of a step.
type FamilyRows = fn(&str, Effort, Option<&SceneRays>, &dyn Fn() -> bool) -> Option<Vec<Row>>;

/// A [`Step`] as a value.
#[derive(Clone, Copy, Debug)]
pub struct AnyStep {
    /// Names and units.
    pub about: About,
    methods: fn() -> Vec<MethodInfo>,
    pick: fn(usize, &Click<'_>) -> Option<Found>,
    /// The rows of all its methods in one of its families, and on a scene's own rays. `None` once the last argument,
    /// which is asked now and then, says no.
    pub rows: FamilyRows,
}

impl AnyStep {
    /// The step that a case belongs to.
    pub const fn of<C: Step>() -> Self {
        Self {
            about: C::ABOUT,
            methods: || C::methods().map(|method| method.info).collect(),
            pick: |method, click| C::pick(click, C::methods().nth(method)?.run),
            rows: run::family::<C>,
        }
    }

    /// Its methods, in the registry's order.
    pub fn methods(self) -> Vec<MethodInfo> {
        (self.methods)()
    }
}

impl PartialEq for AnyStep {
    fn eq(&self, other: &Self) -> bool {
        self.about.key == other.about.key
    }
}

/// A step and the method that does it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Swap {
    /// The step.
    pub step: AnyStep,
    /// Index into the step's methods.
    pub method: usize,
}

impl Swap {
    /// What is known about the method.
    pub fn info(&self) -> MethodInfo {
        self.step.methods()[self.method]
    }

    /// The pick at a pixel position with this method.
    pub fn pick(&self, scene: &Scene, view: &View, px: DVec2) -> Option<Found> {
        (self.step.pick)(self.method, &Click::new(scene, view, px))
    }
}

impl Found {
    /// Sightline's own pick at a pixel position.
    pub fn sightlines(scene: &Scene, view: &View, px: DVec2) -> Option<Self> {
        Click::new(scene, view, px).sightlines()
    }
}

impl<'a> Click<'a> {
    fn new(scene: &'a Scene, view: &'a View, px: DVec2) -> Self {
        Self {
            scene,
            view,
            px,
            ray: view.ray(px),
        }
    }

    fn sightlines(&self) -> Option<Found> {
        let hit = pick::closest(self.scene, self.ray, self.view.sides)?;
        Some(self.found(&self.ray, hit))
    }

    /// A hit on a ray with its point and normal in world space.
    fn found(&self, ray: &Ray, hit: SceneHit) -> Found {
        let placement = &self.scene.objects()[hit.object].placement;
        Found {
            hit,
            point_world: ray.at(hit.hit.t),
            normal_world: placement.normal_to_world(hit.hit.normal),
        }
    }

    /// The nearest visible hit. Objects whose shape `is_about` are tested by `meet`, which gets the ray in object
    /// space; all others by Sightline.
    fn nearest<Hits: IntoIterator<Item = Hit>>(
        &self,
        is_about: impl Fn(&Shape) -> bool,
        meet: impl Fn(&Object, &Ray) -> Hits,
    ) -> Option<Found> {
        let (ray, sides, objects) = (&*self.ray, self.view.sides, self.scene.objects());
        // Exactly decided and ordered.
        let mut others = pick::all(self.scene, self.ray, sides).into_iter();
        let other = others.find(|hit| !is_about(&objects[hit.object].shape));
        let met = (0..).zip(objects.iter());
        let met = met.filter(|(_, object)| object.visible && is_about(&object.shape));
        let met = met.flat_map(|(object, about)| {
            let hits = meet(about, &about.placement.ray_to_object(ray)).into_iter();
            let shown = hits.filter(move |hit| sides.shows(hit) && ray.contains(hit.t));
            shown.map(move |hit| SceneHit { object, hit })
        });
        let all = other.into_iter().chain(met);
        let hit = all.min_by(|a, b| a.hit.t.total_cmp(&b.hit.t).then(a.object.cmp(&b.object)))?;
        Some(self.found(ray, hit))
    }
}

/// The first hit in a ray's interval, by a method that finds the first hit at or after a ray's start. The method first
/// runs from `t = 0`, or from `t_min` if that is negative. If its hit lies before the interval, it runs again from
/// `t_min`.
pub(super) fn first(ray: &Ray, method: impl Fn(&Ray) -> Option<f64>) -> Option<f64> {
    let from = |start: f64| {
        let origin = ray.at(start);
        Some(start + method(&Ray { origin, ..*ray })?)
    };
    let t = from(ray.t_min.min(0.0))?;
    if t < ray.t_min {
        return from(ray.t_min);
    }
    Some(t)
}

impl Step for PixelCase {
    fn pick(click: &Click<'_>, run: fn(&Self) -> PixelRay) -> Option<Found> {
        let Click { scene, view, .. } = click;
        let mut ray = run(&Self::of_view(view, click.px)).ray(view)?;
        if !view.camera.lens().is_orthographic() {
            ray.origin = view.camera.eye();
        }
        let hit = pick::closest(scene, ray, view.sides)?;
        Some(click.found(&ray, hit))
    }
}

impl Step for PlacedCase {
    fn pick(click: &Click<'_>, run: fn(&Self) -> Self::Answer) -> Option<Found> {
        let (ray, sides) = (&click.ray, click.view.sides);
        let meet = |object: &Object, own: &Ray| {
            let case = Self::of_object(&object.placement, ray, 1.0);
            let [origin, direction] = run(&case).map(DVec3::from);
            // A normalised direction changes the ray parameter.
            let stretch = own.direction.length() / direction.length();
            let local = Ray {
                origin,
                direction,
                t_min: ray.t_min * stretch,
                t_max: ray.t_max * stretch,
            };
            let local = local.stored()?;
            let [entry, exit] = match &object.shape {
                Shape::Sphere => Sphere::hits(&local),
                Shape::Cube => Cuboid::hits(&local),
                Shape::Square => [Square::hit(&local), None],
                Shape::Mesh { mesh, part } => {
                    [mesh.closest(&local, sides, |other| other == *part), None]
                }
            };
            let hit = entry.or(exit)?;
            let t = hit.t / stretch;
            Some(Hit { t, ..hit })
        };
        click.nearest(|_| true, meet)
    }
}

impl Step for TriangleCase {
    fn pick(click: &Click<'_>, run: fn(&Self) -> Option<f64>) -> Option<Found> {
        let is_mesh = |shape: &Shape| matches!(shape, Shape::Mesh { .. });
        click.nearest(is_mesh, |object, local| {
            let Shape::Mesh { mesh, part } = &object.shape else {
                return Vec::new();
            };
            let triangles = mesh.part_triangles(*part);
            let hits = triangles.filter_map(|triangle| {
                let test = |ray: &Ray| run(&Self::of_mesh(mesh, triangle, ray, 1.0));
                Some(on_triangle(mesh, triangle, local, first(local, test)?))
            });
            hits.collect()
        })
    }
}

/// The hit on a triangle at the `t` that a method found.
fn on_triangle(mesh: &Mesh, triangle: u32, local: &Ray, t: f64) -> Hit {
    let [a, b, c] = mesh.corners(triangle);
    let normal = (b - a).cross(c - a);
    let area2 = normal.length_squared();
    let point = local.at(t);
    let weight = |p: DVec3, q: DVec3| (p - point).cross(q - point).dot(normal) / area2;
    let barycentric = [weight(b, c), weight(c, a), weight(a, b)];
    Hit {
        on_triangle: Some(OnTriangle {
            triangle,
            barycentric,
        }),
        ..analytic(local, t, normal)
    }
}

impl Step for SphereCase {
    fn pick(click: &Click<'_>, run: fn(&Self) -> Option<f64>) -> Option<Found> {
        let is_sphere = |shape: &Shape| matches!(shape, Shape::Sphere);
        click.nearest(is_sphere, |_, local| {
            let t = first(local, |ray| run(&Self::of_object(ray, 1.0)))?;
            Some(analytic(local, t, local.at(t)))
        })
    }
}

impl Step for BoxCase {
    fn pick(click: &Click<'_>, run: fn(&Self) -> Option<f64>) -> Option<Found> {
        let is_cube = |shape: &Shape| matches!(shape, Shape::Cube);
        click.nearest(is_cube, |_, local| {
            let t = first(local, |ray| run(&Self::of_object(ray, 1.0)))?;
            Some(analytic(local, t, cube_normal(local.at(t))?))
        })
    }
}

/// The outward normal of the unit cube's face that a point is on.
pub(super) fn cube_normal(point: DVec3) -> Option<DVec3> {
    let depth = |axis: &DVec3| point.dot(*axis).abs();
    let axes = DVec3::AXES.into_iter();
    let face = axes.max_by(|a, b| depth(a).total_cmp(&depth(b)))?;
    Some(face * point.dot(face).signum())
}

impl Step for SquareCase {
    fn pick(click: &Click<'_>, run: fn(&Self) -> Option<f64>) -> Option<Found> {
        let is_square = |shape: &Shape| matches!(shape, Shape::Square);
        click.nearest(is_square, |object, local| {
            let test = |ray: &Ray| run(&Self::of_object(&object.placement, ray, 1.0));
            Some(analytic(local, first(&click.ray, test)?, DVec3::Z))
        })
    }
}

/// The hit at the `t` that a method found, on a surface with this outward normal.
pub(super) fn analytic(local: &Ray, t: f64, normal: DVec3) -> Hit {
    Hit {
        t,
        t_error: 0.0,
        normal,
        front: local.direction.dot(normal) < 0.0,
        on_triangle: None,
    }
}

impl Step for ClipCase {
    fn pick(click: &Click<'_>, run: fn(&Self) -> bool) -> Option<Found> {
        let Click { view, ray, .. } = click;
        let mut endless = **ray;
        [endless.t_min, endless.t_max] = [f64::NEG_INFINITY, f64::INFINITY];
        let mut hits = pick::all(click.scene, endless, view.sides).into_iter();
        let shown = |hit: &SceneHit| run(&Self::of_camera(&view.camera, **ray, hit.hit.t));
        Some(click.found(ray, hits.find(shown)?))
    }
}

impl Step for NormalCase {
    fn pick(click: &Click<'_>, run: fn(&Self) -> [f64; 3]) -> Option<Found> {
        let mut own = click.sightlines()?;
        let model = click.scene.objects()[own.hit.object].placement.model();
        let case = Self::new(model.matrix3.into(), own.hit.hit.normal.into())?;
        own.normal_world = DVec3::from(run(&case)).normalize();
        Some(own)
    }
}

impl Step for DepthCase {
    fn pick(click: &Click<'_>, run: fn(&Self) -> f64) -> Option<Found> {
        let mut own = click.sightlines()?;
        let (camera, ray) = (&click.view.camera, &click.ray);
        let read = run(&Self::of_hit(camera, ray, own.hit.hit.t));
        own.point_world = ray.at(read / ray.direction.dot(camera.forward()));
        Some(own)
    }
}
