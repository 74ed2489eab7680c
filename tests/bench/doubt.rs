//! Rays that `f64` decides, and rays that need exact arithmetic, against each shape: with short numbers, through
//! pixels, under general model matrices, and with the longest numbers that models have.

use crate::{
    Kind,
    common::{Random, mesh, perspective, view},
    time,
};
use glam::{DAffine3, DMat3, DVec2, DVec3, dvec2, dvec3};
use sightline::{
    camera::View,
    geometry::{
        Cuboid, LocalRay, Mesh, PlacedRay, Placement, Ray, Sides, Sphere, Square, VertexRay,
        WorldRay, hit_guarded,
    },
    pick,
    scene::{Object, Scene, Shape},
};

const CASES: usize = 100;

/// A ray, and one shape with its placement.
struct Case {
    /// The pixel position in [`pixel_view`] that the ray goes through, if any.
    px: Option<DVec2>,
    ray: WorldRay<'static>,
    placement: Placement,
    shape: Shape,
}

/// Makes a random case of a kind.
type Make = fn(&mut Random) -> Case;

/// The kind that the others are compared with.
pub const UNIT: &str = "triangle by f64, hit";

const TRIANGLES: [(&str, bool, Make); 6] = [
    ("triangle by f64, missed", true, missed),
    (UNIT, true, hit),
    ("triangle, exact, short numbers", false, short_triangle),
    ("triangle, exact, a pixel's ray", false, pixel_triangle),
    (
        "triangle, exact, a pixel's ray, any model matrix",
        false,
        placed_triangle,
    ),
    ("triangle, exact, the longest numbers", false, long_triangle),
];

const SOLIDS: [(&str, Shape); 3] = [
    ("square", Shape::Square),
    ("cube", Shape::Cube),
    ("sphere", Shape::Sphere),
];

/// Makes a random case of a solid.
type MakeSolid = fn(&mut Random, Shape) -> Case;

const RAYS_AT_SOLIDS: [(&str, MakeSolid); 2] = [
    ("short numbers", short_solid),
    ("a pixel's ray, any model matrix", placed_solid),
];

/// All kinds, in this order.
pub fn kinds() -> Vec<Kind<'static>> {
    let triangles = TRIANGLES.into_iter().map(|(name, settled, make)| {
        let cases = cases(make, |case| is_in_doubt(case) != settled);
        let pass: Box<dyn Fn() -> f64> = Box::new(move || triangle_pass(&cases));
        (name.to_owned(), pass)
    });
    let solids = SOLIDS.into_iter().flat_map(|(solid, shape)| {
        RAYS_AT_SOLIDS.map(|(rays, make)| {
            let cases = cases(|random| make(random, shape.clone()), is_exact);
            let pass: Box<dyn Fn() -> f64> = Box::new(move || solid_pass(&cases));
            (format!("{solid}, exact, {rays}"), pass)
        })
    });
    triangles.chain(solids).collect()
}

fn triangle_pass(cases: &[Case]) -> f64 {
    let placed: Vec<PlacedRay> = cases.iter().map(Case::placed).collect();
    let locals: Vec<LocalRay> = placed.iter().map(LocalRay::from).collect();
    let pairs = cases.iter().zip(&locals);
    let inputs: Vec<_> = pairs
        .map(|(case, local)| {
            let mesh = case.mesh();
            (VertexRay::new(local, &mesh.data().origin), corners(mesh))
        })
        .collect();
    time(&inputs, |(ray, corners)| hit_guarded(ray, *corners))
}

fn solid_pass(cases: &[Case]) -> f64 {
    let placed: Vec<PlacedRay> = cases.iter().map(Case::placed).collect();
    let locals: Vec<LocalRay> = placed.iter().map(LocalRay::from).collect();
    match cases[0].shape {
        Shape::Sphere => time(&locals, |local| Sphere::hits(local)),
        Shape::Cube => time(&locals, |local| Cuboid::hits(local)),
        _ => time(&locals, |local| Square::hit(local)),
    }
}

/// The first [`CASES`] wanted cases; at least one case of twenty must be wanted.
fn cases(make: impl Fn(&mut Random) -> Case, is_wanted: impl Fn(&Case) -> bool) -> Vec<Case> {
    let mut random = Random::new(13);
    let made = (0..20 * CASES).map(|_| make(&mut random));
    let cases: Vec<Case> = made.filter(is_wanted).take(CASES).collect();
    assert_eq!(cases.len(), CASES, "too few of the kind");
    cases
}

impl Case {
    fn placed(&self) -> PlacedRay<'_> {
        self.placement.local_ray(&self.ray)
    }

    fn hits(&self) -> bool {
        self.mesh()
            .closest(&self.placed(), Sides::Both, |_| true)
            .is_some()
    }

    fn mesh(&self) -> &Mesh {
        match &self.shape {
            Shape::Mesh { mesh, .. } => mesh,
            _ => unreachable!("a case of triangles"),
        }
    }
}

/// The corners of a mesh of one triangle, relative to its origin.
fn corners(mesh: &Mesh) -> [DVec3; 3] {
    let corner = |i: usize| DVec3::from(mesh.data().positions[i].map(f64::from));
    [0, 1, 2].map(corner)
}

fn is_in_doubt(case: &Case) -> bool {
    case.mesh().is_in_doubt(&case.placed(), |_| true)
}

/// Whether a pick in a scene of this shape alone hits and is decided exactly. A ray of short numbers always is: it runs
/// exactly through a rim or touches a sphere exactly, which no error bound decides.
fn is_exact(case: &Case) -> bool {
    let Some(px) = case.px else {
        return true;
    };
    let scene = Scene::new(vec![Object::new("", case.shape.clone(), case.placement)]);
    pick::pick(&scene, &pixel_view(), px).is_some_and(|pick| pick.exact)
}

/// A view like the demo's.
fn pixel_view() -> View {
    let lens = perspective(33.0, 5.1, 12.5);
    view([3.7, 3.4, 7.6], [0.1, 0.6, 0.1], lens, [1280, 720])
}

/// A ray of [`pixel_view`], and a point on it.
fn pixel_ray(random: &mut Random) -> (DVec2, WorldRay<'static>, DVec3) {
    let px = dvec2(random.within(0.0, 1280.0), random.within(0.0, 720.0));
    let ray = pixel_view().ray(px);
    let point = ray.at(random.within(6.0, 12.0));
    (px, ray, point)
}

/// A random model matrix of ordinary size.
fn any_placement(random: &mut Random) -> Placement {
    loop {
        let [x, y, z] = [(); 3].map(|()| random.point(1.0));
        let linear = DMat3::from_cols(x, y, z);
        if linear.determinant().abs() > 0.1 {
            let model = DAffine3::from_mat3_translation(linear, random.point(3.0));
            return Placement::new(model).expect("invertible");
        }
    }
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "rounded to what meshes hold"
)]
fn triangle(corners: [DVec3; 3], origin: DVec3) -> Shape {
    let positions = corners.map(|corner| corner.to_array().map(|c| c as f32));
    Shape::Mesh {
        mesh: mesh(positions.to_vec(), vec![[0, 1, 2]], origin),
        part: 0,
    }
}

/// A triangle with an edge through its mesh's origin. That origin is a point of the ray, rounded.
fn edge_through(
    random: &mut Random,
    origin: DVec3,
    mut corner: impl FnMut(&mut Random) -> DVec3,
) -> Shape {
    let edge = corner(random).as_vec3().as_dvec3();
    triangle([edge, -edge, corner(random)], origin)
}

/// A triangle about a unit large, near the ray.
fn ordinary(random: &mut Random, spread: f64) -> Case {
    let (px, ray, point) = pixel_ray(random);
    let placement = any_placement(random);
    let middle = placement.point_to_object(point) + random.point(spread);
    let corners = [(); 3].map(|()| middle + random.point(1.0));
    Case {
        px: Some(px),
        ray,
        placement,
        shape: triangle(corners, DVec3::ZERO),
    }
}

fn missed(random: &mut Random) -> Case {
    loop {
        let case = ordinary(random, 3.0);
        if !case.hits() {
            return case;
        }
    }
}

fn hit(random: &mut Random) -> Case {
    loop {
        let case = ordinary(random, 0.0);
        if case.hits() {
            return case;
        }
    }
}

fn lattice_point(random: &mut Random, half: f64) -> DVec3 {
    random.point(half).round()
}

/// A triangle of whole numbers up to 8, and a ray through a corner or the middle of an edge.
fn short_triangle(random: &mut Random) -> Case {
    let corners = [(); 3].map(|()| 2.0 * lattice_point(random, 4.0));
    let through = corners[0].midpoint(corners[random.below(2)]);
    Case {
        px: None,
        ray: lattice_ray(random, through),
        placement: Placement::IDENTITY,
        shape: triangle(corners, DVec3::ZERO),
    }
}

fn lattice_ray(random: &mut Random, through: DVec3) -> WorldRay<'static> {
    let direction = loop {
        let direction = lattice_point(random, 4.0);
        if direction.abs().min_element() > 0.0 {
            break direction;
        }
    };
    ray_to(through, direction)
}

fn ray_to(through: DVec3, direction: DVec3) -> WorldRay<'static> {
    let ray = Ray {
        origin: through - 8.0 * direction,
        direction,
        t_min: 0.0,
        t_max: 64.0,
    };
    ray.into()
}

fn pixel_triangle(random: &mut Random) -> Case {
    let (px, ray, point) = pixel_ray(random);
    Case {
        px: Some(px),
        ray,
        placement: Placement::IDENTITY,
        shape: edge_through(random, point, |random| random.point(1.0)),
    }
}

fn placed_triangle(random: &mut Random) -> Case {
    let (px, ray, point) = pixel_ray(random);
    let placement = any_placement(random);
    let origin = placement.point_to_object(point);
    Case {
        px: Some(px),
        ray,
        placement,
        shape: edge_through(random, origin, |random| random.point(1.0)),
    }
}

/// A number of either sign with a random size between two powers of ten.
fn of_size(random: &mut Random, least: f64, most: f64) -> f64 {
    let size = 10_f64.powf(random.within(least, most));
    if random.below(2) == 0 { size } else { -size }
}

/// An eye up to a billion units away that looks almost along an axis, a matrix with entries as small as rounding
/// errors, and vertices from `1e-30` to 1.
fn long_triangle(random: &mut Random) -> Case {
    let mut spread = |least, most| DVec3::from([(); 3].map(|()| of_size(random, least, most)));
    let (eye, towards) = (spread(0.0, 9.0), spread(-17.0, -9.0) - DVec3::Z);
    let linear = DMat3::from_cols(
        spread(-17.0, 0.0) + 2.0 * DVec3::X,
        spread(-17.0, 0.0) + 2.0 * DVec3::Y,
        spread(-17.0, 0.0) + 4.0 * DVec3::Z,
    );
    let model = DAffine3::from_mat3_translation(linear, spread(-9.0, 9.0));
    let placement = Placement::new(model).expect("invertible");
    let lens = perspective(1e-7, 1e8, 1e10);
    let view = view(
        eye.to_array(),
        (eye + 1e9 * towards).to_array(),
        lens,
        [1280, 720],
    );
    let px = dvec2(random.within(0.0, 1280.0), random.within(0.0, 720.0));
    let ray = view.ray(px);
    let origin = placement.point_to_object(ray.at(1e9));
    let vertex = |random: &mut Random| DVec3::from([(); 3].map(|()| of_size(random, -30.0, 0.0)));
    Case {
        px: None,
        ray,
        placement,
        shape: edge_through(random, origin, vertex),
    }
}

/// A point on the rim of a square or cube, or where a ray along `direction` touches a sphere. `along` is from -1/2 to
/// 1/2.
fn rim(shape: &Shape, direction: DVec3, along: f64) -> DVec3 {
    match shape {
        Shape::Sphere => 0.5 * direction.cross(dvec3(along, 1.0, 0.2)).normalize(),
        Shape::Cube => dvec3(0.5, along, -0.5),
        _ => dvec3(0.5, along, 0.0),
    }
}

fn short_solid(random: &mut Random, shape: Shape) -> Case {
    let eighths = (8.0 * random.within(-0.4, 0.4)).round() / 8.0;
    let ray = match shape {
        Shape::Sphere => {
            let direction = lattice_ray(random, DVec3::ZERO).direction.with_x(0.0);
            ray_to(dvec3(0.5, 0.0, 0.0), direction)
        }
        _ => lattice_ray(random, rim(&shape, DVec3::ZERO, eighths)),
    };
    Case {
        px: None,
        ray,
        placement: Placement::IDENTITY,
        shape,
    }
}

fn placed_solid(random: &mut Random, shape: Shape) -> Case {
    let (px, ray, point) = pixel_ray(random);
    let linear = any_placement(random).model().matrix3;
    let direction = linear.inverse() * ray.direction;
    let on_rim = rim(&shape, direction, random.within(-0.4, 0.4));
    let model = DAffine3::from_mat3_translation(linear, point - linear * on_rim);
    Case {
        px: Some(px),
        ray,
        placement: Placement::new(model).expect("invertible"),
        shape,
    }
}
