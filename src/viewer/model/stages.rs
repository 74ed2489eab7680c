//! The stages of the pipeline, and the scene at the last stage: after P V M and the division by w.

use crate::{
    camera::{DepthMapping, Lens, View},
    colour::Srgb,
    geometry::{
        ColourRun, Cuboid, Mesh, MeshData, Part, Placement, Sphere, Square, clip_points,
        crease_normals, range, sin_cos_quarters,
    },
    scene::{Object, Scene, Shape},
};
use glam::{DVec2, DVec3, Vec3};
use std::{collections::HashMap, f64::consts::PI, sync::Arc};

/// How far along the pipeline something is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Stage {
    /// Before any matrix: one object in its own space.
    Object,
    /// After M: the scene as it stands, with the camera in it.
    #[default]
    World,
    /// After V M: the eye at the origin, x right, y up, z forward. Left-handed.
    View,
    /// After P V M and the division by w: the frustum as the box x, y in [-1, 1], z in [0, 1].
    Ndc,
}

impl Stage {
    /// All of them, in order, with their names.
    pub const ALL: [(Self, &'static str); 4] = [
        (Self::Object, "object"),
        (Self::World, "world"),
        (Self::View, "view"),
        (Self::Ndc, "NDC"),
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].1
    }
}

/// Rings of the mesh that stands in for a projected sphere, where spheres are few.
const RINGS: u32 = 24;
/// The same where there are very many.
const LEAST_RINGS: u32 = 4;
/// Between these limits, all spheres of a scene together have about twice this many quadrilaterals.
const SPHERE_QUADS: usize = 500_000;
/// Edges of a projected shape that bend by more than this stay sharp. Radians.
const CREASE: f32 = 0.5;

/// The scene in NDC as it is drawn, see `ndc_drawn`: the same objects in the same order as parts of one mesh, clipped
/// by the section and at the near plane. An object of which nothing is left is hidden.
pub fn projected(scene: &Scene, view: &View) -> Scene {
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
    let objects = objects.map(|(object, part)| match (part, &mesh) {
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
    });
    objects.collect()
}

/// Where a view space point is drawn in NDC: at x, y and minus the z of standard depth, whatever depth the lens stores.
/// So the near face is towards the viewer. Nothing is mirrored: view space is left-handed, the space drawn in is
/// right-handed.
pub(super) fn ndc_drawn(p_view: DVec3, half: DVec2, lens: &Lens) -> DVec3 {
    (p_view.truncate() / (half * lens.w(p_view.z))).extend(-lens.ndc_depth(p_view.z))
}

/// The view space point that is drawn at `at`: the inverse of [`ndc_drawn`].
pub(super) fn view_of_ndc_drawn(at: DVec3, half: DVec2, lens: &Lens) -> DVec3 {
    let depth = lens.depth_at(-at.z);
    (at.truncate() * half * lens.w(depth)).extend(depth)
}

/// The lens with standard depth.
pub(super) fn standard(view: &View) -> Lens {
    Lens {
        depth: DepthMapping::Standard,
        ..*view.camera.lens()
    }
}

/// Adds an object's surface in NDC, as it is drawn, to a mesh; returns its part, or `None` where nothing is left of it.
fn project(object: &Object, view: &View, rings: u32, data: &mut MeshData) -> Option<usize> {
    let (lens, half) = (standard(view), view.half_extent());
    let count = |data: &MeshData| u32::try_from(data.triangles.len()).ok();
    let begin = count(data)?;
    // Vertices are shared only within an object.
    let mut known = HashMap::new();
    for (corners, colour) in surface(object, rings) {
        let world = corners.map(|corner| object.placement.point_to_world(corner));
        let kept = match view.section {
            Some(section) => clip_points(&world, |p| section.side(p)),
            None => world.into(),
        };
        let seen: Vec<_> = (kept.into_iter())
            .map(|point| view.camera.to_view(point))
            .collect();
        let polygon = clip_points(&seen, |p| p.z - lens.near);
        let mut polygon: Vec<_> = (polygon.iter())
            .map(|&p| ndc_drawn(p, half, &lens).as_vec3())
            .collect();
        if object.placement.mirrors() {
            polygon.reverse();
        }
        let in_range = |corner: &Vec3| range::stored_vector(corner.as_dvec3()).is_some();
        if polygon.is_empty() || !polygon.iter().all(in_range) {
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
                material: None,
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

/// The index of the vertex at a position, which is added if it is new. Triangles share it, so that shading stays
/// smooth.
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

/// The triangles of an object in its own space, each with its colour. A sphere gets `rings` rings.
fn surface(object: &Object, rings: u32) -> Vec<([DVec3; 3], Srgb)> {
    let own = object.colour.unwrap_or(Srgb::NEUTRAL);
    let quads = |quads: Vec<[DVec3; 4]>| {
        let in_two = |[a, b, c, d]: [DVec3; 4]| [[a, b, c], [a, c, d]];
        let halves = quads.into_iter().flat_map(in_two);
        halves.map(|triangle| (triangle, own)).collect()
    };
    match &object.shape {
        Shape::Mesh { mesh, part } => {
            let triangles = mesh.part_triangles(*part);
            let painted = object.colour;
            let colour = |triangle| painted.or(mesh.triangle_colour(triangle)).unwrap_or(own);
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
    let point = |(ring, spoke): (u32, u32)| {
        let (sin, cos) = libm::sincos(PI * f64::from(ring) / f64::from(rings));
        let (side, front) = sin_cos_quarters(2.0 * f64::from(spoke) / f64::from(rings));
        Sphere::RADIUS * DVec3::new(sin * side, cos, sin * front)
    };
    let cells = (0..rings).flat_map(|ring| (0..2 * rings).map(move |spoke| (ring, spoke)));
    cells
        .map(|(i, j)| [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(point))
        .collect()
}
