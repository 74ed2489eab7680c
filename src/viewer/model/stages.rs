//! The scene as each matrix leaves it: with none, after M, after V M, and after P V M with its division by w.

use crate::{
    camera::{DepthMapping, Lens, View},
    colour::Srgb,
    geometry::{
        ColourRun, Cuboid, Mesh, MeshData, Part, Placement, Sphere, Square, clip, crease_normals,
        sin_cos_quarters,
    },
    scene::{Object, Scene, Shape},
};
use glam::{DAffine3, DVec3};
use std::{collections::HashMap, f64::consts::PI, sync::Arc};

/// How far along the pipeline the scene is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Stage {
    /// No matrix at all: every shape about the origin.
    Object,
    /// M: the world, as it is drawn and picked.
    #[default]
    World,
    /// V M: the eye at the origin, x right, y up, z forward. Left-handed, so it shows mirrored.
    View,
    /// P V M, divided by w: the frustum as the box x, y in [-1, 1], z in [0, 1], with standard depth.
    Ndc,
}

impl Stage {
    /// All of them, in order, with their names.
    pub const ALL: [(Self, &'static str); 4] = [
        (Self::Object, "no matrix"),
        (Self::World, "M"),
        (Self::View, "V M"),
        (Self::Ndc, "P V M"),
    ];
}

/// Rings of the sphere that stands in for a projected one.
const RINGS: u32 = 24;
/// Edges of a projected shape that bend by more stay sharp. Radians.
const CREASE: f32 = 0.5;

/// The scene at a stage, seen through the camera of `view`: the same objects in the same order. In NDC they are meshes,
/// cut at the near plane; what lies before it is gone.
#[must_use]
pub fn staged(scene: &Scene, view: &View, stage: Stage) -> Scene {
    let to_view = DAffine3::from_mat4(view.camera.view());
    let lens = Lens {
        depth: DepthMapping::Standard,
        ..*view.camera.lens()
    };
    let objects = scene.objects().iter().map(|object| match stage {
        Stage::World => object.clone(),
        Stage::Object => Object {
            placement: Placement::IDENTITY,
            ..object.clone()
        },
        Stage::View => Object {
            // V is a rotation, a mirror and a shift: what had an inverse still has one.
            placement: Placement::new(to_view * object.placement.model())
                .unwrap_or(object.placement),
            ..object.clone()
        },
        Stage::Ndc => projected(object, view, &lens).unwrap_or_else(|| Object {
            visible: false,
            ..object.clone()
        }),
    });
    Scene::new(objects.collect())
}

/// An object's surface in NDC; `None` when nothing of it lies behind the near plane.
fn projected(object: &Object, view: &View, lens: &Lens) -> Option<Object> {
    let mut data = MeshData::default();
    let mut known = HashMap::new();
    for (corners, colour) in surface(object) {
        let seen =
            corners.map(|corner| view.camera.to_view(object.placement.point_to_world(corner)));
        let polygon = clip(&seen, |p| p.z - lens.near, |a, b, s| a.lerp(*b, s));
        let first = u32::try_from(data.triangles.len()).ok()?;
        let corners: Vec<u32> = (polygon.iter().map(|&p| to_ndc(p, view, lens).as_vec3()))
            .map(|p| vertex(&mut data.positions, &mut known, p.to_array()))
            .collect();
        data.triangles
            .extend((2..corners.len()).map(|i| [corners[0], corners[i - 1], corners[i]]));
        data.colours.push(ColourRun {
            triangles: first..u32::try_from(data.triangles.len()).ok()?,
            colour: Some(colour),
        });
    }
    let triangles = u32::try_from(data.triangles.len()).ok()?;
    data.parts = vec![Part {
        name: object.name.clone(),
        triangles: 0..triangles,
    }];
    data.normals = crease_normals(&data.positions, &data.triangles, CREASE);
    let mesh = Mesh::new(data).ok().filter(|_| triangles > 0)?;
    Some(Object {
        shape: Shape::Mesh {
            mesh: Arc::new(mesh),
            part: 0,
        },
        placement: Placement::IDENTITY,
        colour: None,
        ..object.clone()
    })
}

/// The vertex at a position, made where it is new: shared, so that shading stays smooth.
fn vertex(
    positions: &mut Vec<[f32; 3]>,
    known: &mut HashMap<[u32; 3], u32>,
    position: [f32; 3],
) -> u32 {
    *known.entry(position.map(f32::to_bits)).or_insert_with(|| {
        positions.push(position);
        u32::try_from(positions.len() - 1).unwrap_or(u32::MAX)
    })
}

fn to_ndc(p_view: DVec3, view: &View, lens: &Lens) -> DVec3 {
    let clip = lens.projection(view.viewport.aspect()) * p_view.extend(1.0);
    clip.truncate() / clip.w
}

/// The triangles of an object in its own space, each with its colour.
fn surface(object: &Object) -> Vec<([DVec3; 3], Srgb)> {
    let own = object.colour.unwrap_or(Srgb::NEUTRAL);
    let quads = |quads: Vec<[DVec3; 4]>| {
        let halves = quads
            .into_iter()
            .flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]);
        halves.map(|triangle| (triangle, own)).collect()
    };
    match &object.shape {
        Shape::Mesh { mesh, part } => {
            let triangles = mesh.data().parts[*part].triangles.clone();
            let colour = |triangle| {
                object
                    .colour
                    .or(mesh.triangle_colour(triangle))
                    .unwrap_or(own)
            };
            triangles
                .map(|triangle| (mesh.corners(triangle), colour(triangle)))
                .collect()
        }
        Shape::Square => quads(vec![Square::corners()]),
        Shape::Cube => quads(Cuboid::NORMALS.map(Cuboid::face).to_vec()),
        Shape::Sphere => quads(sphere_quads()),
    }
}

/// The sphere by parallels and meridians, counter-clockwise seen from outside.
fn sphere_quads() -> Vec<[DVec3; 4]> {
    let point = |ring: u32, spoke: u32| {
        let (sin, cos) = (PI * f64::from(ring) / f64::from(RINGS)).sin_cos();
        let (side, front) = sin_cos_quarters(2.0 * f64::from(spoke) / f64::from(RINGS));
        Sphere::RADIUS * DVec3::new(sin * side, cos, sin * front)
    };
    let cells = (0..RINGS).flat_map(|ring| (0..2 * RINGS).map(move |spoke| (ring, spoke)));
    cells
        .map(|(i, j)| {
            [
                point(i, j),
                point(i + 1, j),
                point(i + 1, j + 1),
                point(i, j + 1),
            ]
        })
        .collect()
}
