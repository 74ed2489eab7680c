//! Compares picks with what an engine might use instead: three.js's camera and raycaster (ported), which tests every
//! triangle, and the same camera with parry3d's mesh, which has a tree. All pick the same positions of one picture and
//! return triangle and distance.
//!
//! `cargo run --profile bench --no-default-features --features rivals --example beside`: times are of the fastest pass;
//! passes alternate, so that ratios hold on a busy machine. An answer that differs from Sightline's is wrong, since
//! Sightline's is exact arithmetic's.

use parry3d::{
    math::Vector,
    query::{self, RayCast},
    shape::TriMesh,
};
use sightline::{
    camera::{Camera, CameraError, DepthMapping, Lens, Projection, View, Viewport},
    geometry::{Mesh, MeshData, Placement},
    glam::{DAffine3, DMat4, DQuat, DVec2, DVec3, DVec4},
    pick,
    scene::{Object, Scene, Shape},
};
use std::{error::Error, f64::consts::TAU, hint::black_box, sync::Arc, time::Instant};

const SIZE: [u32; 2] = [320, 240];
const FOV_DEG: f64 = 40.0;
const EYE: DVec3 = DVec3::new(1.0, 1.5, 3.0);
const PASSES: usize = 9;
/// About so many of the positions test every triangle.
const FEW: usize = 75;

/// A position's triangle, and its distance along the ray.
type Answer = Option<(u32, f64)>;

/// `PerspectiveCamera` with `lookAt`: `f64` matrices, as in JavaScript; looks along its -z.
struct ThreeCamera {
    matrix_world: DMat4,
    projection_inverse: DMat4,
}

impl ThreeCamera {
    fn new(fov_deg: f64, aspect: f64, near: f64, far: f64, eye: DVec3, target: DVec3) -> Self {
        let top = near * (0.5 * fov_deg.to_radians()).tan();
        let projection = DMat4::from_cols(
            DVec4::new(near / (top * aspect), 0.0, 0.0, 0.0),
            DVec4::new(0.0, near / top, 0.0, 0.0),
            DVec4::new(0.0, 0.0, -(far + near) / (far - near), -1.0),
            DVec4::new(0.0, 0.0, -2.0 * far * near / (far - near), 0.0),
        );
        let z = (eye - target).normalize();
        let x = DVec3::Y.cross(z).normalize();
        let axes = [x, z.cross(x), z].map(|axis| axis.extend(0.0));
        Self {
            matrix_world: DMat4::from_cols(axes[0], axes[1], axes[2], eye.extend(1.0)),
            projection_inverse: projection.inverse(),
        }
    }

    /// `Raycaster.setFromCamera`: origin, and a direction of length 1.
    fn ray(&self, ndc: DVec2) -> (DVec3, DVec3) {
        let origin = self.matrix_world.w_axis.truncate();
        let in_view = self.projection_inverse.project_point3(ndc.extend(0.5));
        let through = self.matrix_world.transform_point3(in_view);
        (origin, (through - origin).normalize())
    }
}

/// `Mesh.raycast` with `DoubleSide`: in the mesh's space, `Ray.intersectTriangle` on each triangle.
fn three_closest(data: &MeshData, inverse: &DMat4, (origin, direction): (DVec3, DVec3)) -> Answer {
    let origin = inverse.transform_point3(origin);
    let direction = (*inverse * direction.extend(0.0)).truncate().normalize();
    let mut best: Answer = None;
    for (index, corners) in (0..).zip(&data.triangles) {
        let [a, b, c] = corners.map(|i| {
            let position = data.positions[i as usize].map(f64::from);
            DVec3::from_array(position)
        });
        let Some(t) = intersect_triangle(origin, direction, [a, b, c]) else {
            continue;
        };
        if best.is_none_or(|(_, nearest)| t < nearest) {
            best = Some((index, t));
        }
    }
    best
}

/// After David Eberly, "Intersection of a Ray and a Triangle", as three.js has it.
fn intersect_triangle(origin: DVec3, direction: DVec3, [a, b, c]: [DVec3; 3]) -> Option<f64> {
    let (edge1, edge2, diff) = (b - a, c - a, origin - a);
    let normal = edge1.cross(edge2);
    let facing = direction.dot(normal);
    if facing == 0.0 {
        return None;
    }
    let (sign, facing) = (facing.signum(), facing.abs());
    let weight_b = sign * direction.dot(diff.cross(edge2));
    let weight_c = sign * direction.dot(edge1.cross(diff));
    if weight_b < 0.0 || weight_c < 0.0 || weight_b + weight_c > facing {
        return None;
    }
    let along = -sign * diff.dot(normal);
    (along >= 0.0).then_some(along / facing)
}

/// parry's mesh (`f32`), in its own space.
fn parry_closest(mesh: &TriMesh, inverse: &DMat4, (origin, direction): (DVec3, DVec3)) -> Answer {
    let narrow = |v: DVec3| Vector::from(v.as_vec3().to_array());
    let origin = inverse.transform_point3(origin);
    let direction = (*inverse * direction.extend(0.0)).truncate();
    let ray = query::Ray::new(narrow(origin), narrow(direction));
    let hit = mesh.cast_local_ray_and_get_normal(&ray, f32::INFINITY, false)?;
    Some((hit.subshape, f64::from(hit.time_of_impact)))
}

/// A ball of triangles, radius 1: `rings` from pole to pole, twice as many around.
fn ball(rings: u16) -> MeshData {
    let around = 2 * rings;
    let point = |ring: u16, step: u16| {
        let (sin, cos) = (0.5 * TAU * f64::from(ring) / f64::from(rings)).sin_cos();
        let (sin_u, cos_u) = (TAU * f64::from(step) / f64::from(around)).sin_cos();
        DVec3::new(sin * cos_u, cos, sin * sin_u)
            .as_vec3()
            .to_array()
    };
    let positions = (0..=rings).flat_map(|i| (0..around).map(move |j| point(i, j)));
    let [rows, width] = [rings, around].map(u32::from);
    let quad = |i: u32, j: u32| {
        let at = |i, j| i * width + j % width;
        let [a, b, c, d] = [at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)];
        [[a, b, c], [a, c, d]]
    };
    let quads = (0..rows).flat_map(|i| (0..width).map(move |j| (i, j)));
    // At the poles, every second triangle has no area.
    let triangles = quads.flat_map(|(i, j)| quad(i, j)).enumerate();
    let whole = triangles.filter(|(n, _)| {
        let (row, second) = (n / 2 / width as usize, n % 2 == 1);
        !(row == 0 && !second || row + 1 == rows as usize && second)
    });
    let triangles = whole.map(|(_, triangle)| triangle).collect();
    MeshData::of_triangles("ball", positions.collect(), triangles)
}

/// Nanoseconds per position in one pass.
fn pass(positions: &[DVec2], answer: impl Fn(DVec2) -> Answer) -> f64 {
    let start = Instant::now();
    for px in positions {
        black_box(answer(*px));
    }
    let count = u32::try_from(positions.len()).expect("fits");
    1e9 * start.elapsed().as_secs_f64() / f64::from(count)
}

fn view() -> Result<View, CameraError> {
    let lens = Lens {
        projection: Projection::Perspective {
            fov_y: FOV_DEG.to_radians(),
        },
        near: 0.1,
        far: 100.0,
        depth: DepthMapping::Standard,
    };
    let camera = Camera::new(EYE, DVec3::ZERO, DVec3::Y, lens)?;
    Ok(View::new(camera, Viewport::new(SIZE[0], SIZE[1])?))
}

fn main() -> Result<(), Box<dyn Error>> {
    let view = view()?;
    let aspect = view.viewport.aspect();
    let three = ThreeCamera::new(FOV_DEG, aspect, 0.1, 100.0, EYE, DVec3::ZERO);
    let model = DAffine3::from_rotation_translation(
        DQuat::from_rotation_z(0.3),
        DVec3::new(0.1, -0.2, 0.3),
    );
    let inverse = DMat4::from(model).inverse();
    assert_eq!(inverse.row(3), DVec4::W, "an affine one");
    let ray = |px: DVec2| three.ray(view.viewport.px_to_ndc(px));
    for rings in [20, 100, 500] {
        let data = ball(rings);
        let vertices = data.positions.iter().map(|&p| Vector::from(p)).collect();
        let parry = TriMesh::new(vertices, data.triangles.clone())?;
        let mesh = Arc::new(Mesh::new(data)?);
        let shape = Shape::Mesh {
            mesh: Arc::clone(&mesh),
            part: 0,
        };
        let scene = Scene::new(vec![Object::new("ball", shape, Placement::new(model)?)]);
        scene.build_trees();

        let ours = |px: DVec2| {
            let hit = pick::closest(&scene, view.ray(px), view.sides)?.hit;
            Some((hit.on_triangle?.triangle, hit.t))
        };
        let parry = |px: DVec2| parry_closest(&parry, &inverse, ray(px));
        let each = |px: DVec2| three_closest(mesh.data(), &inverse, ray(px));

        // In an order that branch prediction cannot learn.
        let pixels = u64::from(SIZE[0] * SIZE[1]);
        let centre = |n: u64| {
            let n = n * 48_271 % pixels;
            let [x, y] = [n % u64::from(SIZE[0]), n / u64::from(SIZE[0])];
            #[expect(clippy::cast_precision_loss, reason = "pixels are few")]
            DVec2::new(x as f64 + 0.5, y as f64 + 0.5)
        };
        let positions: Vec<DVec2> = (0..20_000).map(centre).collect();
        let few: Vec<DVec2> = (positions.iter().copied())
            .step_by(positions.len() / FEW)
            .collect();

        let mut fastest = [f64::INFINITY; 3];
        for _ in 0..PASSES {
            let times = [
                pass(&positions, ours),
                pass(&positions, parry),
                pass(&few, each),
            ];
            fastest = std::array::from_fn(|i| fastest[i].min(times[i]));
        }
        let differs = |positions: &[DVec2], other: &dyn Fn(DVec2) -> Answer| {
            let named = |answer: Answer| answer.map(|(triangle, _)| triangle);
            let differ = positions
                .iter()
                .filter(|&&px| named(ours(px)) != named(other(px)));
            format!("{} of {}", differ.count(), positions.len())
        };
        let hits = positions.iter().filter(|&&px| ours(px).is_some()).count();
        let [sightline, of_parry, of_each] = fastest;
        println!(
            "{} triangles, {hits} of {} positions hit",
            mesh.data().triangles.len(),
            positions.len()
        );
        println!("  Sightline                          {sightline:>12.0} ns         wrong 0");
        println!(
            "  three.js-like camera, parry's mesh {of_parry:>12.0} ns {:>7.2}x wrong {}",
            of_parry / sightline,
            differs(&positions, &parry)
        );
        println!(
            "  three.js-like camera and raycaster {of_each:>12.0} ns {:>7.1}x wrong {}",
            of_each / sightline,
            differs(&few, &each)
        );
    }
    Ok(())
}
