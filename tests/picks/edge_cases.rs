//! Families of positions on objects, to test distances to edges: ordinary ones, and those where digits run out.

use crate::common::{Random, mesh, orthographic, perspective, placements, view};
use glam::{DAffine3, DMat3, DVec2, DVec3, dvec2};
use sightline::{
    camera::{Camera, Lens, Projected, View},
    geometry::{Cuboid, Placement},
    pick,
    scene::{Object, Scene, Shape},
};

/// An object, a view of it, and a position.
#[derive(Debug)]
pub struct Case {
    pub object: Object,
    pub view: View,
    pub px: DVec2,
}

impl Case {
    pub fn scene(&self) -> Scene {
        Scene::new(vec![self.object.clone()])
    }
}

/// Makes a case; `None` if this try is of no use.
pub type Family = fn(&mut Random, &Shape) -> Option<Case>;

/// Points of a shape's surface in object space.
fn surface_point(random: &mut Random, shape: &Shape) -> DVec3 {
    let side = |random: &mut Random| random.within(-0.5, 0.5);
    match shape {
        Shape::Sphere => 0.5 * random.direction(),
        Shape::Cube => {
            let normal = Cuboid::NORMALS[random.below(6)];
            let (u, v) = normal.any_orthonormal_pair();
            0.5 * normal + side(random) * u + side(random) * v
        }
        Shape::Square => DVec3::new(side(random), side(random), 0.0),
        Shape::Mesh { mesh, .. } => {
            let [a, b, c] = mesh.corners(0);
            let (s, t) = (random.unit(), random.unit());
            let (s, t) = if s + t > 1.0 {
                (1.0 - s, 1.0 - t)
            } else {
                (s, t)
            };
            a + s * (b - a) + t * (c - a)
        }
    }
}

/// A case at the position where the picture shows a random point of the object; `None` if no try is shown.
fn aimed(random: &mut Random, shape: &Shape, model: DAffine3, view: View) -> Option<Case> {
    let placement = Placement::new(model).ok()?;
    let px = (0..50).find_map(|_| Some(shown_point(random, shape, &placement, &view)?.px))?;
    let object = Object::new("it", shape.clone(), placement);
    Some(Case { object, view, px })
}

/// Where the picture shows a random point of a shape; `None` outside the picture or before the near plane.
fn shown_point(
    random: &mut Random,
    shape: &Shape,
    placement: &Placement,
    view: &View,
) -> Option<Projected> {
    let shown = view.project(placement.point_to_world(surface_point(random, shape)))?;
    let is_there = shown.depth >= view.camera.lens().near && view.viewport.contains(shown.px);
    is_there.then_some(shown)
}

fn lens(random: &mut Random, fov: f64, near: f64) -> Lens {
    if random.below(3) == 0 {
        // As high as the perspective picture at distance 3.
        orthographic(6.0 * (0.5 * fov.to_radians()).tan(), near, 1e12)
    } else {
        perspective(fov, near, 1e12)
    }
}

fn placement(random: &mut Random) -> DAffine3 {
    let (_, model) = placements()[random.below(7)];
    DAffine3 {
        translation: random.point(0.5),
        ..model
    }
}

fn looking(random: &mut Random, eye: DVec3, lens: Lens) -> View {
    let target = random.point(0.3);
    view(eye.into(), target.into(), lens, [640, 480])
}

/// An eye 2 to 6 units from the origin, and a near plane close to the eye.
fn ordinary(random: &mut Random, shape: &Shape) -> Option<Case> {
    let fov = random.within(20.0, 100.0);
    let lens = lens(random, fov, 0.01);
    let eye = random.within(2.0, 6.0) * random.direction();
    let view = looking(random, eye, lens);
    let model = placement(random);
    aimed(random, shape, model, view)
}

/// The near plane cuts the object.
fn cut(random: &mut Random, shape: &Shape) -> Option<Case> {
    let fov = random.within(20.0, 100.0);
    let eye = random.within(2.0, 4.0) * random.direction();
    let near = eye.length() + random.within(-0.7, 0.7);
    let lens = lens(random, fov, near);
    let view = looking(random, eye, lens);
    let placement = Placement::new(placement(random)).ok()?;
    // Of several shown points, the one closest to the cut.
    let shown = (0..50).filter_map(|_| shown_point(random, shape, &placement, &view));
    let px = shown.min_by(|a, b| a.depth.total_cmp(&b.depth))?.px;
    let object = Object::new("it", shape.clone(), placement);
    Some(Case { object, view, px })
}

/// A tiny near distance, and an eye close to the object or inside it.
fn tiny_near(random: &mut Random, shape: &Shape) -> Option<Case> {
    let near = 10_f64.powf(random.within(-33.0, -1.0));
    let eye = random.within(0.05, 0.8) * random.direction();
    let fov = random.within(20.0, 120.0);
    let view = looking(random, eye, perspective(fov, near, 1e12));
    let model = placement(random);
    aimed(random, shape, model, view)
}

/// A position close to an edge of the shape as the picture shows it.
fn near_an_edge(random: &mut Random, shape: &Shape) -> Option<Case> {
    let Case { object, view, px } = ordinary(random, shape)?;
    let scene = Scene::new(vec![object.clone()]);
    let hits = |px: DVec2| !pick::all(&scene, view.ray(px), view.sides).is_empty();
    let direction = DVec2::from_angle(random.within(0.0, 6.3));
    let (mut inside, mut outside) = (0.0, 1e4);
    for _ in 0..5 + random.below(55) {
        let middle = 0.5 * (inside + outside);
        if hits(px + middle * direction) {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    Some(Case {
        px: px + inside * direction,
        object,
        view,
    })
}

/// An eye up to 1e9 sizes away, and a lens through which the object fills the picture.
fn far_away(random: &mut Random, shape: &Shape) -> Option<Case> {
    let distance = 10_f64.powf(random.within(2.0, 9.0));
    let fov = (2.0 / distance).atan().to_degrees() * random.within(0.3, 2.0);
    let lens = perspective(fov.max(1e-7), 0.5 * distance, 2e9);
    let eye = distance * random.direction();
    let view = looking(random, eye, lens);
    let model = placement(random);
    aimed(random, shape, model, view)
}

/// Lenses up to 179 degrees wide, through which outlines are hyperbolas.
fn wide_lens(random: &mut Random, shape: &Shape) -> Option<Case> {
    let lens = perspective(
        random.within(120.0, 179.0),
        10_f64.powf(random.within(-9.0, -1.0)),
        1e6,
    );
    let eye = random.within(0.3, 2.0) * random.direction();
    let view = looking(random, eye, lens);
    let model = placement(random);
    aimed(random, shape, model, view)
}

/// Lenses from 1e-7 degrees; half the objects are elongated, up to 1e30 times as long as wide.
fn long_lens(random: &mut Random, shape: &Shape) -> Option<Case> {
    let mut model = placement(random);
    let mut point = surface_point(random, shape);
    if random.below(2) == 0 {
        let length = 10_f64.powf(random.within(0.0, 30.0));
        model.matrix3.x_axis *= length;
        point.x /= length;
        if matches!(shape, Shape::Sphere) {
            point = 0.5 * point.normalize();
        }
    }
    let target = model.transform_point3(point);
    let eye = target + random.within(2.0, 6.0) * random.direction();
    let lens = perspective(10_f64.powf(random.within(-7.0, 0.0)), 0.01, 1e3);
    let camera = Camera::new(eye, target, DVec3::Y, lens).ok()?;
    let view = View {
        camera,
        ..view([1.0; 3], [0.0; 3], lens, [640, 480])
    };
    let px = view.project(target)?.px;
    let object = Object::new("it", shape.clone(), Placement::new(model).ok()?);
    Some(Case { object, view, px })
}

/// Squeezed and sheared, up to a condition number of 1e14.
fn squeezed(random: &mut Random, shape: &Shape) -> Option<Case> {
    let condition = 10_f64.powf(random.within(3.0, 14.0));
    let turn =
        |random: &mut Random| DMat3::from_axis_angle(random.direction(), random.within(0.0, 6.3));
    let sizes = [1.0, 1.0 / condition, random.within(0.0, 1.0).powi(4)];
    let sizes = [sizes, [1.0, 1.0, 1.0 / condition]][random.below(2)];
    let linear = turn(random) * DMat3::from_diagonal(sizes.into()) * turn(random);
    let model = DAffine3 {
        matrix3: linear,
        translation: random.point(0.2),
    };
    let fov = random.within(20.0, 60.0);
    let near = [0.01, 2.0][random.below(2)];
    let lens = lens(random, fov, near);
    let eye = 2.0 * random.direction();
    let view = looking(random, eye, lens);
    aimed(random, shape, model, view)
}

/// Coordinates that are large relative to the object.
fn far_from_the_origin(random: &mut Random, shape: &Shape) -> Option<Case> {
    let offset = 10_f64.powf(random.within(3.0, 12.0)) * random.direction();
    let mut model = placement(random);
    model.translation += offset;
    let fov = random.within(20.0, 90.0);
    let near = [0.01, 3.0][random.below(2)];
    let lens = lens(random, fov, near);
    let eye = offset + random.within(2.0, 4.0) * random.direction();
    let camera = Camera::looking(eye, offset + random.point(0.2) - eye, DVec3::Y, lens).ok()?;
    let view = View {
        camera,
        ..view([1.0; 3], [0.0; 3], lens, [640, 480])
    };
    aimed(random, shape, model, view)
}

/// Straight ahead, where everything is symmetrical.
fn straight(random: &mut Random, shape: &Shape) -> Option<Case> {
    let size = DVec3::from_array([0, 1, 2].map(|_| [0.5, 1.0, 2.0][random.below(3)]));
    let near = [0.01, 1.5, 2.0, 2.5][random.below(4)];
    let lens = lens(random, 60.0, near);
    let view = view([0.0, 0.0, 2.0], [0.0; 3], lens, [640, 480]);
    let model = DAffine3::from_scale(size);
    let step = |random: &mut Random| [0.0, 40.0, 80.0][random.below(3)];
    let px = dvec2(320.0 + step(random), 240.0 + step(random));
    let object = Object::new("it", shape.clone(), Placement::new(model).ok()?);
    Some(Case { object, view, px })
}

/// An edge that passes the eye about as closely as the near plane, so that the cut lies within the picture.
fn past_the_eye(random: &mut Random, shape: &Shape) -> Option<Case> {
    if !matches!(shape, Shape::Mesh { .. }) {
        return None;
    }
    let near = 10_f64.powf(random.within(-33.0, -1.0));
    let corners = vec![[0.0, 0.0, -1.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]];
    let mesh = mesh(corners, vec![[0, 1, 2]], DVec3::ZERO);
    let shape = &Shape::Mesh { mesh, part: 0 };
    let aside = random.point(1.0);
    let model = DAffine3::from_translation(near * aside);
    let fov = random.within(20.0, 120.0_f64);
    let lens = perspective(fov, near, 1e12);
    let view = view([0.0; 3], [0.0, 0.0, -1.0], lens, [640, 480]);
    let half_height = (0.5 * fov.to_radians()).tan();
    let cut = dvec2(320.0, 240.0) + 240.0 / half_height * dvec2(aside.x, -aside.y);
    let px = cut + 40.0 * dvec2(random.within(-1.0, 1.0), random.within(-1.0, 1.0));
    let object = Object::new("it", shape.clone(), Placement::new(model).ok()?);
    Some(Case { object, view, px })
}

pub const FAMILIES: [(&str, Family); 11] = [
    ("ordinary", ordinary),
    ("cut", cut),
    ("tiny near", tiny_near),
    ("near an edge", near_an_edge),
    ("far away", far_away),
    ("wide lens", wide_lens),
    ("long lens", long_lens),
    ("squeezed", squeezed),
    ("far from the origin", far_from_the_origin),
    ("straight", straight),
    ("past the eye", past_the_eye),
];
