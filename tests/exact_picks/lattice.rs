//! Scenes of short numbers: rays pass exactly through edges, corners and tangents, and faces lie exactly on each other
//! and on the near and far planes.

use super::blocks::{Layout, Sample, chance, lattice_point, lattice_turn, one_mesh, scene, whole};
use crate::common::{Random, box_triangles, orthographic, perspective};
use glam::{DAffine3, DMat3, DVec2, DVec3, dvec2, dvec3};
use sightline::{
    camera::{Camera, Lens, Projection, View, Viewport},
    geometry::{Placement, Sides},
    scene::{Object, Scene, Shape},
};

/// A perspective lens. The tangent of half its field of view is `half_height`, to the bit.
fn short_lens(half_height: f64, near: f64, far: f64) -> Lens {
    let guess = 2.0 * half_height.atan();
    let mut around = (0..64_u64).flat_map(|i| [guess.to_bits() + i, guess.to_bits() - i]);
    let fits = |fov_y: f64| (0.5 * fov_y).tan().to_bits() == half_height.to_bits();
    let found = around.find(|bits| fits(f64::from_bits(*bits)));
    let fov_y = f64::from_bits(found.expect("a field of view with a short tangent"));
    Lens {
        projection: Projection::Perspective { fov_y },
        ..perspective(90.0, near, far)
    }
}

/// A camera whose axes are the world's. Up and down from its middle it sees a slope of 1/2, or 2, 4 or 8 units.
pub fn short_view(random: &mut Random, eye: DVec3, forward: DVec3, near: f64, far: f64) -> View {
    let lens = if near > 0.0 && chance(random, 2) {
        short_lens(0.5, near, far)
    } else {
        orthographic([4.0, 8.0, 16.0][random.below(3)], near, far)
    };
    let ups: Vec<DVec3> = DVec3::AXES
        .into_iter()
        .filter(|axis| axis.dot(forward) == 0.0)
        .collect();
    let up = ups[random.below(2)] * if chance(random, 2) { 1.0 } else { -1.0 };
    let camera = Camera::looking(eye, forward, up, lens).expect("a camera");
    let (width, height) =
        [(64, 64), (128, 64), (32, 16), (60, 48), (9, 7), (10, 8)][random.below(6)];
    View {
        camera,
        viewport: Viewport::new(width, height).expect("a viewport"),
        sides: if chance(random, 4) {
            Sides::Front
        } else {
            Sides::Both
        },
        section: None,
    }
}

/// Where the picture shows a point. The position is exact if the numbers are short enough.
pub fn shown(view: &View, point: DVec3) -> DVec2 {
    let camera = &view.camera;
    let seen = point - camera.eye();
    let depth = seen.dot(camera.forward());
    let size = view.viewport.size_px();
    let aside = dvec2(seen.dot(camera.right()), -seen.dot(camera.up()));
    let w = if camera.lens().is_orthographic() {
        1.0
    } else {
        depth
    };
    0.5 * size + aside * size.y / (2.0 * camera.half_height() * w)
}

/// A shape with whole or half coordinates, in a placement of whole numbers.
pub fn lattice_object(random: &mut Random, centre: DVec3) -> Object {
    let linear = loop {
        let linear = if chance(random, 3) {
            DMat3::from_cols_array(&std::array::from_fn(|_| whole(random, -2, 2)))
        } else {
            let even = |random: &mut Random| 2.0 * whole(random, 1, 3);
            let scale = dvec3(even(random), even(random), even(random));
            let scale = if chance(random, 3) {
                DVec3::splat(scale.x)
            } else {
                scale
            };
            lattice_turn(random) * DMat3::from_diagonal(scale)
        };
        if linear.determinant() != 0.0 {
            break linear;
        }
    };
    let shape = match random.below(6) {
        0 | 1 => Shape::Sphere,
        2 => Shape::Cube,
        3 => Shape::Square,
        4 => {
            let (positions, triangles) = box_triangles(1.0);
            one_mesh(positions, triangles, DVec3::ZERO)
        }
        _ => lattice_mesh(random),
    };
    let model = DAffine3::from_mat3_translation(linear, centre);
    match Placement::new(model) {
        Ok(placement) => Object::new("lattice", shape, placement),
        Err(_) => lattice_object(random, centre),
    }
}

/// Triangles between a few whole points: many share edges and corners, some have no area.
fn lattice_mesh(random: &mut Random) -> Shape {
    let corners = 4 + random.below(8);
    let positions = (0..corners).map(|_| lattice_point(random, 2).as_vec3().to_array());
    let positions = positions.collect();
    let mut corner = || u32::try_from(random.below(corners)).expect("few");
    let triangles = (0..4 + 5 * corners)
        .map(|_| [corner(), corner(), corner()])
        .collect();
    one_mesh(positions, triangles, DVec3::ZERO)
}

/// Rays exactly through corners, edges and tangents, or as nearly as positions can be.
pub fn exact_borders(random: &mut Random) -> Sample {
    let forward = lattice_turn(random).z_axis;
    let eye = lattice_point(random, 2) - 8.0 * forward;
    let view = short_view(random, eye, forward, 1.0, 64.0);
    let mut objects = Vec::new();
    for _ in 0..=random.below(14) {
        let centre = lattice_point(random, 3);
        objects.push(lattice_object(random, centre));
    }
    // A ball of radius 3 n at a distance of 5 n, which is seen up to a slope of 3/4.
    let n = whole(random, 1, 3);
    let linear = 6.0 * n * lattice_turn(random);
    let model = DAffine3::from_mat3_translation(linear, eye + 5.0 * n * forward);
    objects.push(Object::new(
        "ball",
        Shape::Sphere,
        Placement::new(model).expect("a turn"),
    ));
    let last = objects.len() - 1;
    objects.swap(random.below(last + 1), last);
    let scene = scene(random, objects);
    let mut positions: Vec<_> = (0..20)
        .map(|_| border_position(random, &scene, &view))
        .collect();
    // The tangents above and below lie outside of most pictures.
    let slope = 0.75 * view.viewport.size_px().y / (2.0 * view.camera.half_height());
    let side = if chance(random, 2) { slope } else { -slope };
    positions.push(0.5 * view.viewport.size_px() + dvec2(side, 0.0));
    sample(scene, view, positions)
}

/// Where an object's corner, the middle of an edge, or the end of an axis is shown.
fn border_position(random: &mut Random, scene: &Scene, view: &View) -> DVec2 {
    let objects = scene.objects();
    let object = &objects[random.below(objects.len() - 1)];
    let point = match &object.shape {
        Shape::Mesh { mesh, .. } => {
            let triangle = random.below(mesh.data().triangles.len());
            let corners = mesh.corners(u32::try_from(triangle).expect("few"));
            let (a, b) = (corners[random.below(3)], corners[random.below(3)]);
            if chance(random, 2) { a } else { 0.5 * (a + b) }
        }
        Shape::Sphere => 0.5 * lattice_turn(random).x_axis,
        Shape::Square => 0.5 * lattice_point(random, 1).with_z(0.0),
        Shape::Cube => 0.5 * lattice_point(random, 1),
    };
    let px = shown(view, object.placement.point_to_world(point));
    if px.is_finite() {
        px
    } else {
        0.5 * view.viewport.size_px()
    }
}

pub fn sample(scene: Scene, view: View, positions: Vec<DVec2>) -> Sample {
    Sample {
        scene,
        view,
        positions,
        layout: Layout::Anywhere,
    }
}

fn all_pixels(view: &View) -> Vec<DVec2> {
    let (width, height) = (view.viewport.width(), view.viewport.height());
    let rows = (0..height).flat_map(|y| (0..width).map(move |x| dvec2(x.into(), y.into()) + 0.5));
    rows.collect()
}

/// Faces on the near and far planes, and shapes that these planes cut, at every pixel of a small picture.
pub fn planes(random: &mut Random) -> Sample {
    let forward = lattice_turn(random).z_axis;
    let eye = lattice_point(random, 3);
    let near = [0.25, 0.5, 1.0, 2.0, 3.0, -1.0, -3.0, 0.0][random.below(8)];
    let far = near + whole(random, 1, 5);
    let mut view = short_view(random, eye, forward, near, far);
    let (width, height) = [(10, 8), (8, 8), (11, 7)][random.below(3)];
    view.viewport = Viewport::new(width, height).expect("a viewport");
    let mut objects = Vec::new();
    for _ in 0..=random.below(4) {
        let depth = if chance(random, 2) { near } else { far };
        let on_plane = eye + depth * forward;
        let aside = |random: &mut Random| {
            let step = lattice_point(random, 3);
            step - step.dot(forward) * forward
        };
        let linear = lattice_turn(random) * DMat3::from_diagonal(dvec3(8.0, 4.0, 2.0));
        let (shape, centre) = match random.below(5) {
            // A face on the plane. The cube's axis along the line of sight is 8, 4 or 2 long.
            0 => {
                let length = (linear.transpose() * forward).abs().max_element();
                let side = if chance(random, 2) { 0.5 } else { -0.5 };
                (
                    Shape::Cube,
                    on_plane + side * length * forward + aside(random),
                )
            }
            1 => (Shape::Square, on_plane + aside(random)),
            2 => {
                let corners = [
                    [-1.0, -1.0, 0.0],
                    [1.0, -1.0, 0.0],
                    [1.0, 1.0, 0.0],
                    [-1.0, 1.0, 0.0_f32],
                ];
                let mesh = one_mesh(corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]], DVec3::ZERO);
                (mesh, on_plane + aside(random))
            }
            3 => (Shape::Sphere, on_plane + aside(random)),
            _ => {
                let centre = on_plane + aside(random);
                objects.push(lattice_object(random, centre));
                continue;
            }
        };
        let model = DAffine3::from_mat3_translation(linear, centre);
        objects.push(Object::new(
            "on a plane",
            shape,
            Placement::new(model).expect("a turn"),
        ));
    }
    let scene = scene(random, objects);
    let positions = all_pixels(&view);
    Sample {
        layout: Layout::Picture,
        ..sample(scene, view, positions)
    }
}
