//! Clicks on a hard scene: a closed, bumpy ball of many small triangles, far from the world's origin, with the eye
//! close.

use super::{PickCase, PickWorld};
use crate::{
    camera::{Camera, DepthMapping, Lens, Projection, View, Viewport},
    geometry::{Mesh, MeshData, Placement, Sides},
    render::Gpu,
    scene::{Object, Scene, Shape},
    study::prelude::*,
};
use glam::DVec3;
use std::sync::{Arc, OnceLock};

/// The ball's distances from the world's origin, in its radii.
const OFFSETS: [f64; 3] = [0.0, 1e3, 5e6];

/// Every family.
pub const FAMILIES: &[Family<PickCase>] = &[
    family!("a ball of 5120 triangles", "offset / radius" OFFSETS => |random, offset| {
        let world = ball_world(offset);
        PickCase::new(world, random.pixel(world.view.viewport.size_px()))
    }),
];

/// The ball at an offset, made once.
fn ball_world(offset: f64) -> &'static Arc<PickWorld> {
    static WORLDS: [OnceLock<Arc<PickWorld>>; OFFSETS.len()] =
        [const { OnceLock::new() }; OFFSETS.len()];
    let index = OFFSETS.iter().position(|known| *known >= offset);
    WORLDS[index.unwrap_or(0)].get_or_init(|| {
        let (scene, view) = ball_scene(offset);
        Arc::new(PickWorld::new(&scene, view))
    })
}

/// The graphics adapter, looked up once; `None` where there is none.
pub fn gpu() -> Option<&'static Gpu> {
    static GPU: OnceLock<Option<Gpu>> = OnceLock::new();
    GPU.get_or_init(|| Gpu::headless().ok()).as_ref()
}

/// The ball and a camera that sees it well.
///
/// # Panics
/// Never: there is such a camera and such a picture.
pub fn ball_scene(offset: f64) -> (Scene, View) {
    let at = (DVec3::new(1.0, -2.0, 3.0).normalize() * offset).round();
    let mesh = ball(at);
    let fov_y = std::f64::consts::FRAC_PI_3;
    let lens = Lens {
        projection: Projection::Perspective { fov_y },
        near: 0.125,
        far: 16.0,
        depth: DepthMapping::Reversed,
    };
    let camera = Camera::new(at + DVec3::new(0.75, 0.5, 1.75), at, DVec3::Y, lens);
    let viewport = Viewport::new(320, 180);
    let view = View {
        camera: camera.expect("a camera"),
        viewport: viewport.expect("a picture"),
        sides: Sides::Both,
        section: None,
    };
    let object = Object::new("Ball", Shape::Mesh { mesh, part: 0 }, Placement::IDENTITY);
    (Scene::new(vec![object]), view)
}

/// An icosahedron whose faces are repeatedly split into four; its vertices are moved in and out a little.
fn ball(origin: DVec3) -> Arc<Mesh> {
    const SPLITS: u32 = 4;
    let (mut points, mut faces) = icosahedron();
    for _ in 0..SPLITS {
        let mut middles = std::collections::HashMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                points.push((points[a as usize] + points[b as usize]).normalize());
                u32::try_from(points.len() - 1).unwrap_or(0)
            })
        };
        let split = faces.iter().flat_map(|&[a, b, c]| {
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
        });
        faces = split.collect();
    }
    let mut random = Random::new(7);
    let moved = |p: &DVec3| (*p * random.within(0.97, 1.03)).as_vec3().to_array();
    let positions = points.iter().map(moved);
    let mesh = Mesh::new(MeshData {
        origin,
        ..MeshData::of_triangles("Ball", positions.collect(), faces)
    });
    Arc::new(mesh.expect("the ball's indices and ranges are right"))
}

/// Twelve corners, 1 from the origin, and twenty faces, counter-clockwise from outside.
pub(crate) fn icosahedron() -> (Vec<DVec3>, Vec<[u32; 3]>) {
    const FACES: [u32; 60] = [
        0, 2, 1, 0, 1, 7, 0, 6, 2, 0, 5, 6, 0, 7, 5, 1, 2, 8, 1, 3, 7, 1, 8, 3, 2, 6, 4, 2, 4,
        8, //
        3, 11, 7, 3, 8, 9, 3, 9, 11, 4, 6, 10, 4, 9, 8, 4, 10, 9, 5, 10, 6, 5, 7, 11, 5, 11,
        10, //
        9, 10, 11,
    ];
    let phi = 1.618_034;
    let planes = [(1.0, phi), (1.0, -phi), (-1.0, phi), (-1.0, -phi)];
    let points = planes.map(|(a, b)| [[0.0, a, b], [a, b, 0.0], [b, 0.0, a]]);
    let points = points.as_flattened().iter();
    let points = points.map(|point| DVec3::from(*point).normalize());
    (points.collect(), FACES.as_chunks().0.to_vec())
}
