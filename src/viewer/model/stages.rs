//! The scene as each matrix leaves it: with none, after M, after V M, and after P V M with its division by w.

use crate::{
    camera::{DepthMapping, Lens, View},
    colour::Srgb,
    geometry::{
        ColourRun, Cuboid, Mesh, MeshData, Part, Placement, Sphere, Square, clip, crease_normals,
        sin_cos_quarters,
    },
    scene::{Object, Scene, SceneKey, Shape},
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

/// Rings of the spheres that stand in for projected ones: of a few.
const RINGS: u32 = 24;
/// The least, of very many.
const LEAST_RINGS: u32 = 4;
/// About so many quadrilaterals, twice, is what the spheres of a scene come to.
const SPHERE_QUADS: usize = 500_000;
/// Edges of a projected shape that bend by more stay sharp. Radians.
const CREASE: f32 = 0.5;

/// A stage that was made beforehand.
pub(in crate::viewer) struct Prepared {
    pub stage: Stage,
    /// The scene at the stage.
    pub scene: Scene,
    /// What it was made of.
    pub of: SceneKey,
    /// The view that its matrices are of.
    pub through: View,
}

/// The scene at a stage, seen through the camera of `view`: the same objects in the same order. In NDC they are parts of
/// one mesh, cut at the near plane; what lies before it is gone.
#[must_use]
pub fn staged(scene: &Scene, view: &View, stage: Stage) -> Scene {
    let to_view = DAffine3::from_mat4(view.camera.view());
    let placed = |placement: &dyn Fn(&Object) -> Placement| {
        let objects = scene.objects().iter().map(|object| Object {
            placement: placement(object),
            ..object.clone()
        });
        Scene::new(objects.collect())
    };
    match stage {
        Stage::World => scene.clone(),
        Stage::Object => placed(&|_| Placement::IDENTITY),
        // V is a rotation, a mirror and a shift: what had an inverse still has one.
        Stage::View => placed(&|object| {
            Placement::new(to_view * object.placement.model()).unwrap_or(object.placement)
        }),
        Stage::Ndc => Scene::new(projected(scene, view)),
    }
}

/// The objects in NDC. Of one of which nothing lies behind the near plane, nothing is to be seen.
fn projected(scene: &Scene, view: &View) -> Vec<Object> {
    let mut data = MeshData::default();
    let spheres = scene.objects().iter();
    let spheres = spheres.filter(|object| matches!(object.shape, Shape::Sphere));
    let rings = (SPHERE_QUADS / spheres.count().max(1)).isqrt();
    let rings = u32::try_from(rings).map_or(RINGS, |rings| rings.clamp(LEAST_RINGS, RINGS));
    let parts: Vec<Option<usize>> = (scene.objects().iter())
        .map(|object| project(object, view, rings, &mut data))
        .collect();
    data.normals = crease_normals(&data.positions, &data.triangles, CREASE);
    let mesh = Mesh::new(data).ok().map(Arc::new);
    let objects = scene.objects().iter().zip(parts);
    objects
        .map(|(object, part)| match (part, &mesh) {
            (Some(part), Some(mesh)) => Object {
                shape: Shape::Mesh {
                    mesh: Arc::clone(mesh),
                    part,
                },
                placement: Placement::IDENTITY,
                colour: None,
                ..object.clone()
            },
            _ => Object {
                visible: false,
                ..object.clone()
            },
        })
        .collect()
}

/// Adds an object's surface in NDC to a mesh; returns which part it is, where there is any of it.
fn project(object: &Object, view: &View, rings: u32, data: &mut MeshData) -> Option<usize> {
    let lens = Lens {
        depth: DepthMapping::Standard,
        ..*view.camera.lens()
    };
    let count = |data: &MeshData| u32::try_from(data.triangles.len()).ok();
    let begin = count(data)?;
    // Vertices are shared within an object, so that shading stays smooth, and not beyond.
    let mut known = HashMap::new();
    for (corners, colour) in surface(object, rings) {
        let seen =
            corners.map(|corner| view.camera.to_view(object.placement.point_to_world(corner)));
        let polygon = clip(&seen, |p| p.z - lens.near, |a, b, s| a.lerp(*b, s));
        let polygon: Vec<_> = (polygon.iter())
            .map(|&p| to_ndc(p, view, &lens).as_vec3())
            .collect();
        if polygon.is_empty() || !polygon.iter().all(|corner| corner.is_finite()) {
            continue;
        }
        let first = count(data)?;
        let corners: Vec<u32> = (polygon.iter())
            .map(|p| vertex(&mut data.positions, &mut known, p.to_array()))
            .collect();
        data.triangles
            .extend((2..corners.len()).map(|i| [corners[0], corners[i - 1], corners[i]]));
        let (colour, end) = (Some(colour), count(data)?);
        match data.colours.last_mut() {
            Some(run) if run.colour == colour => run.triangles.end = end,
            _ => data.colours.push(ColourRun {
                triangles: first..end,
                colour,
            }),
        }
    }
    let triangles = begin..count(data)?;
    if triangles.is_empty() {
        return None;
    }
    data.parts.push(Part {
        name: object.name.clone(),
        triangles,
    });
    Some(data.parts.len() - 1)
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

/// The triangles of an object in its own space, each with its colour. A sphere has so many rings.
fn surface(object: &Object, rings: u32) -> Vec<([DVec3; 3], Srgb)> {
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
        Shape::Sphere => quads(sphere_quads(rings)),
    }
}

/// The sphere by parallels and meridians, counter-clockwise seen from outside.
fn sphere_quads(rings: u32) -> Vec<[DVec3; 4]> {
    let point = |ring: u32, spoke: u32| {
        let (sin, cos) = (PI * f64::from(ring) / f64::from(rings)).sin_cos();
        let (side, front) = sin_cos_quarters(2.0 * f64::from(spoke) / f64::from(rings));
        Sphere::RADIUS * DVec3::new(sin * side, cos, sin * front)
    };
    let cells = (0..rings).flat_map(|ring| (0..2 * rings).map(move |spoke| (ring, spoke)));
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
