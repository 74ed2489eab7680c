//! Scenes that drawing tests share.
#![allow(dead_code, reason = "each test uses its share")]

use crate::common::icosphere;
use glam::{DAffine3, DMat3, DQuat, DVec3, dvec3};
use sightline::{
    colour::Srgb,
    geometry::{ColourRun, Mesh, MeshData, Part, Placement},
    render::Gpu,
    scene::{Object, Scene, Shape},
};
use std::{path::Path, sync::Arc};

/// The device. If there is none, the test fails and says what to install.
pub fn gpu() -> Gpu {
    Gpu::headless().unwrap_or_else(|error| panic!("{error}"))
}

/// A visible object.
pub fn object(name: &str, shape: Shape, model: DAffine3, colour: Option<[u8; 3]>) -> Object {
    Object {
        colour: colour.map(Srgb),
        ..Object::new(
            name,
            shape,
            Placement::new(model).expect("an invertible matrix"),
        )
    }
}

/// A mesh from positions about `origin` and one or more parts, with crease normals.
pub fn mesh(origin: DVec3, positions: Vec<[f32; 3]>, parts: &[&[[u32; 3]]]) -> Mesh {
    let triangles: Vec<[u32; 3]> = parts.concat();
    let mut end = 0;
    let parts: Vec<Part> = parts
        .iter()
        .enumerate()
        .map(|(i, part)| {
            let start = end;
            end += u32::try_from(part.len()).expect("a small mesh");
            Part {
                name: format!("part {i}"),
                triangles: start..end,
            }
        })
        .collect();
    let mesh = Mesh::new(MeshData {
        origin,
        positions,
        triangles,
        parts,
        colours: vec![ColourRun {
            triangles: 0..end,
            colour: None,
            material: None,
        }],
        crease: Some(0.7),
        ..MeshData::default()
    });
    mesh.expect("a mesh")
}

/// Positions and triangles of a bumpy sphere of radius about 1.
pub fn bumpy(levels: u32) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
    let (points, triangles) = icosphere(levels);
    let bump =
        |p: DVec3| p * (1.0 + 0.12 * (7.0 * p.x).sin() * (6.0 * p.y).sin() * (5.0 * p.z).cos());
    let positions = points
        .into_iter()
        .map(|p| bump(p).as_vec3().to_array())
        .collect();
    (positions, triangles)
}

/// All shapes under all kinds of model matrices: spheres (ellipsoid, sheared, mirrored), cubes, squares, a bumpy
/// mesh, and a mesh of two parts used twice, once mirrored. About 6 units wide, about `center`.
pub fn shapes(center: DVec3) -> Scene {
    let at = |x: f64, y: f64, z: f64| DAffine3::from_translation(center + dvec3(x, y, z));
    let turn = DAffine3::from_quat(DQuat::from_euler(glam::EulerRot::XYZ, 0.5, 0.8, -0.3));
    let scale = |x: f64, y: f64, z: f64| DAffine3::from_scale(dvec3(x, y, z));
    let shear = DAffine3::from_mat3(DMat3::from_cols(DVec3::X, dvec3(0.7, 1.0, 0.2), DVec3::Z));
    let (positions, triangles) = bumpy(4);
    let whole = Arc::new(mesh(DVec3::ZERO, positions, &[&triangles]));
    let (positions, triangles) = bumpy(3);
    let (left, right) = triangles.split_at(triangles.len() / 3);
    let halves = Arc::new(mesh(dvec3(0.25, 0.0, 0.0), positions, &[left, right]));
    let part = |mesh: &Arc<Mesh>, part| Shape::Mesh {
        mesh: Arc::clone(mesh),
        part,
    };
    let floor = DAffine3::from_rotation_x(-std::f64::consts::FRAC_PI_2);
    let pair = at(2.0, -0.2, -1.2) * scale(0.7, 0.7, 0.7);
    let mirrored = at(-2.1, 0.0, -1.0) * turn * scale(-0.8, 0.6, 0.6);
    let scene = Scene::new(vec![
        object(
            "floor",
            Shape::Square,
            at(0.0, -1.0, 0.0) * floor * scale(7.0, 6.0, 1.0),
            Some([92, 98, 110]),
        ),
        object(
            "bumpy",
            part(&whole, 0),
            at(0.0, 0.05, 0.0),
            Some([226, 221, 209]),
        ),
        object(
            "ball",
            Shape::Sphere,
            at(-1.5, -0.5, 1.2),
            Some([214, 74, 62]),
        ),
        object(
            "ellipsoid",
            Shape::Sphere,
            at(1.6, -0.3, 1.1) * turn * scale(1.6, 0.7, 0.9),
            Some([66, 135, 214]),
        ),
        object(
            "sheared",
            Shape::Sphere,
            at(0.2, -0.65, 1.7) * shear * scale(0.7, 0.6, 0.6),
            Some([96, 176, 92]),
        ),
        object(
            "mirrored",
            Shape::Sphere,
            at(-0.7, 1.4, 0.0) * turn * scale(-0.5, 0.9, 0.5),
            Some([233, 188, 71]),
        ),
        object(
            "box",
            Shape::Cube,
            at(1.0, -0.7, -1.6) * scale(0.6, 0.6, 0.6),
            Some([155, 106, 186]),
        ),
        object(
            "turned box",
            Shape::Cube,
            at(-2.4, -0.4, 0.4) * turn * scale(0.9, 0.5, 0.7),
            Some([72, 176, 168]),
        ),
        object(
            "mirrored box",
            Shape::Cube,
            at(1.2, 1.2, -0.6) * turn * shear * scale(0.5, -0.6, 0.4),
            None,
        ),
        object(
            "card",
            Shape::Square,
            at(2.4, 0.5, 0.6) * turn * scale(0.8, 1.1, 1.0),
            Some([240, 240, 240]),
        ),
        object("left", part(&halves, 0), pair, Some([217, 140, 80])),
        object("right", part(&halves, 1), pair, None),
        object("left again", part(&halves, 0), mirrored, None),
        object(
            "right again",
            part(&halves, 1),
            mirrored,
            Some([120, 160, 90]),
        ),
    ]);
    scene.build_trees();
    scene
}

/// A real file, as the parts of one mesh about its middle. Faces with more corners become fans.
pub fn load(path: &Path) -> Scene {
    let options = tobj::LoadOptions {
        triangulate: true,
        ..Default::default()
    };
    let (models, _) = tobj::load_obj(path, &options).expect("a readable file");
    let points: Vec<DVec3> = models
        .iter()
        .flat_map(|model| model.mesh.positions.as_chunks::<3>().0)
        .map(|&p| DVec3::from_array(p))
        .collect();
    let bounds = sightline::geometry::Aabb::around(points.iter().copied());
    let origin = bounds.center();
    let mut first = 0;
    let mut parts = Vec::new();
    for model in &models {
        let corners = model.mesh.indices.as_chunks::<3>().0;
        parts.push(
            corners
                .iter()
                .map(|c| c.map(|i| i + first))
                .collect::<Vec<_>>(),
        );
        first += u32::try_from(model.mesh.positions.len() / 3).expect("32 bits");
    }
    let parts: Vec<&[[u32; 3]]> = parts.iter().map(Vec::as_slice).collect();
    let positions = points
        .iter()
        .map(|&p| (p - origin).as_vec3().to_array())
        .collect();
    let mesh = Arc::new(mesh(origin, positions, &parts));
    mesh.build_tree();
    let objects = models.iter().enumerate().map(|(part, model)| {
        Object::new(
            model.name.clone(),
            Shape::Mesh {
                mesh: Arc::clone(&mesh),
                part,
            },
            Placement::IDENTITY,
        )
    });
    Scene::new(objects.collect())
}
