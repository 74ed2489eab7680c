//! From what `tobj` read and the [`Outline`] to one mesh.

use super::{
    ObjError, ObjFile, material, notes,
    outline::{Name, Outline},
    polygon::Splitter,
};
use crate::{
    colour::Srgb,
    geometry::{Aabb, ColourRun, CornerNormals, Mesh, MeshData, Part},
    scene::Progress,
};
use glam::{DVec3, Vec3};
use std::{
    collections::{HashMap, HashSet},
    path::Path,
    sync::Arc,
};

/// Edges that bend by more are drawn sharp where the file has no normals. Radians.
const CREASE: f32 = 30.0 * std::f32::consts::PI / 180.0;

/// A face with more than this many corners of which half are repeats is left out, too.
const MOST_REPEATS: usize = 1 << 5;

/// Puts a file's mesh together. `models` is one, since the washer hides what begins others.
pub(super) fn build(
    path: &Path,
    models: Vec<tobj::Model>,
    outline: &Outline,
    progress: &Progress,
) -> Result<ObjFile, ObjError> {
    let model = models.into_iter().next();
    let model = model.ok_or_else(|| notes::nothing(path, outline, &LeftOut::default()))?;
    let materials = material::read_libraries(path, &outline.libraries, progress)?;

    let mut builder = Builder::new(path, &model.mesh)?;
    let mut objects = outline.objects.iter().peekable();
    let mut uses = outline.materials.iter().peekable();
    let names = object_names(path, &outline.objects);
    let mut names = names.into_iter();
    let mut corners = 0;
    for (face, &with_normals) in outline.with_normals.iter().enumerate() {
        if objects.next_if(|(first, _)| *first == face).is_some() {
            builder.begin_part(names.next().unwrap_or_default());
        }
        while let Some((_, material)) = uses.next_if(|(first, _)| *first <= face) {
            let (name, _) = &outline.material_names[*material];
            builder.begin_colour(
                materials
                    .by_name
                    .get(name)
                    .and_then(|material| material.colour),
            );
        }
        let arity = model.mesh.face_arities.get(face).map_or(3, |&n| n as usize);
        if arity > 4 {
            progress.advance(0)?;
        }
        builder.face(corners..corners + arity, with_normals);
        corners += arity;
    }
    if builder.data.triangles.is_empty() {
        return Err(notes::nothing(path, outline, &builder.left_out));
    }
    let mut warnings: Vec<_> = notes::about_lines(path, outline).collect();
    warnings.extend(notes::about_geometry(path, outline, &builder.left_out));
    warnings.extend(notes::about_materials(path, outline, &materials.by_name));
    warnings.extend(materials.warnings);

    let mesh = Mesh::new(builder.finish()).map_err(|source| ObjError::NoMesh {
        file: path.to_owned(),
        source,
    })?;
    let mesh = Arc::new(mesh);
    Ok(ObjFile { mesh, warnings })
}

/// A mesh in the making, face by face.
struct Builder<'a> {
    from: &'a tobj::Mesh,
    /// Vertices that are not three finite numbers.
    nowhere: HashSet<u32>,
    data: MeshData,
    /// The file's normals at unit length; zero where they have no direction.
    normals: Vec<[f32; 3]>,
    /// For each triangle, indices into `normals` or [`CornerNormals::NONE`]; empty while all are computed.
    shading: Vec<[u32; 3]>,
    splitter: Splitter,
    polygon: Vec<DVec3>,
    left_out: LeftOut,
}

/// How much of the file is not in the mesh.
#[derive(Default)]
pub(super) struct LeftOut {
    /// Triangles without area.
    pub without_area: usize,
    /// Faces with a corner that is not three finite numbers.
    pub nowhere: usize,
    /// Faces with too many corners, of which too many are the same.
    pub repetitive: usize,
}

impl<'a> Builder<'a> {
    fn new(path: &Path, from: &'a tobj::Mesh) -> Result<Self, ObjError> {
        let (vertices, _) = from.positions.as_chunks::<3>();
        let is_somewhere = |v: &DVec3| v.is_finite();
        let all = vertices.iter().map(|&v| DVec3::from_array(v));
        let bounds = Aabb::around(all.clone().filter(is_somewhere));
        let extent = (bounds.max - bounds.min).max_element();
        if extent > f64::from(f32::MAX) {
            return Err(ObjError::TooLarge {
                file: path.to_owned(),
                extent,
            });
        }
        let origin = origin(bounds);
        // No face uses those that are nowhere.
        let nowhere = (0..)
            .zip(all.clone())
            .filter_map(|(i, v)| (!is_somewhere(&v)).then_some(i));
        let positions = all.map(|v| {
            if is_somewhere(&v) {
                narrow(v - origin)
            } else {
                [0.0; 3]
            }
        });
        let (colours, _) = from.vertex_color.as_chunks::<3>();
        let (normals, _) = from.normals.as_chunks::<3>();
        Ok(Self {
            from,
            nowhere: nowhere.collect(),
            data: MeshData {
                origin,
                positions: positions.collect(),
                vertex_colours: colours.iter().map(|&c| Srgb::from_unit(c)).collect(),
                triangles: Vec::with_capacity(from.indices.len() / 3),
                ..MeshData::default()
            },
            normals: normals
                .iter()
                .map(|&n| unit(DVec3::from_array(n)))
                .collect(),
            shading: Vec::new(),
            splitter: Splitter::default(),
            polygon: Vec::new(),
            left_out: LeftOut::default(),
        })
    }

    fn end(&self) -> u32 {
        u32::try_from(self.data.triangles.len()).unwrap_or(u32::MAX)
    }

    fn begin_part(&mut self, name: String) {
        self.end_part();
        let triangles = self.end()..self.end();
        self.data.parts.push(Part { name, triangles });
    }

    fn end_part(&mut self) {
        let end = self.end();
        if let Some(part) = self.data.parts.last_mut() {
            part.triangles.end = end;
        }
        self.data.parts.pop_if(|part| part.triangles.is_empty());
    }

    fn begin_colour(&mut self, colour: Option<Srgb>) {
        self.end_colour();
        let start = self.end();
        if self
            .data
            .colours
            .last()
            .is_none_or(|run| run.colour != colour)
        {
            let triangles = start..start;
            self.data.colours.push(ColourRun { triangles, colour });
        }
    }

    /// Closes the run in progress. Triangles before the first have no colour.
    fn end_colour(&mut self) {
        let end = self.end();
        let runs = &mut self.data.colours;
        match runs.last_mut() {
            Some(run) => run.triangles.end = end,
            None if end > 0 => runs.push(ColourRun {
                triangles: 0..end,
                colour: None,
            }),
            None => {}
        }
        runs.pop_if(|run| run.triangles.is_empty());
    }

    /// Adds the face that has these places in `tobj`'s lists of corners.
    fn face(&mut self, corners: std::ops::Range<usize>, with_normals: bool) {
        let from = self.from;
        let vertices = &from.indices[corners.clone()];
        if !self.nowhere.is_empty() && vertices.iter().any(|i| self.nowhere.contains(i)) {
            self.left_out.nowhere += 1;
            return;
        }
        let normals = Some(&from.normal_indices)
            .filter(|_| with_normals)
            .and_then(|indices| indices.get(corners))
            .filter(|indices| {
                indices
                    .iter()
                    .all(|&i| Vec3::from_array(self.normals[i as usize]) != Vec3::ZERO)
            });
        if let [_, _, _] = vertices {
            self.triangle(vertices, normals, [0, 1, 2]);
            return;
        }
        if is_repetitive(vertices) {
            self.left_out.repetitive += 1;
            return;
        }
        let mut polygon = std::mem::take(&mut self.polygon);
        polygon.clear();
        polygon.extend(vertices.iter().map(|&i| self.position(i)));
        let mut splitter = std::mem::take(&mut self.splitter);
        for &corners in splitter.split(&polygon) {
            self.triangle(vertices, normals, corners);
        }
        self.splitter = splitter;
        self.polygon = polygon;
    }

    fn triangle(&mut self, vertices: &[u32], normals: Option<&[u32]>, corners: [u32; 3]) {
        let vertices = corners.map(|i| vertices[i as usize]);
        let [a, b, c] = vertices.map(|i| self.position(i));
        if (b - a).cross(c - a) == DVec3::ZERO {
            self.left_out.without_area += 1;
            return;
        }
        if normals.is_some() && self.shading.is_empty() {
            self.shading = vec![CornerNormals::NONE; self.data.triangles.len()];
        }
        if normals.is_some() || !self.shading.is_empty() {
            let shading = normals.map(|normals| corners.map(|i| normals[i as usize]));
            self.shading.push(shading.unwrap_or(CornerNormals::NONE));
        }
        self.data.triangles.push(vertices);
    }

    /// A vertex as it is stored, about the origin: what rays will meet.
    fn position(&self, vertex: u32) -> DVec3 {
        DVec3::from_array(self.data.positions[vertex as usize].map(f64::from))
    }

    fn finish(mut self) -> MeshData {
        self.end_part();
        self.end_colour();
        let corners = self.shading;
        if corners.is_empty() {
            self.normals.clear();
        }
        let is_complete = !corners.is_empty() && !corners.contains(&CornerNormals::NONE);
        self.data.crease = (!is_complete).then_some(CREASE);
        self.data.normals = CornerNormals {
            normals: self.normals,
            corners,
        };
        self.data
    }
}

/// Where `f32` positions are counted from. On an axis where the box reaches as near to 0 as it is large, 0: nothing
/// would be won. Otherwise the box's centre, rounded to a power of two near a sixteenth of the box, so that taking it
/// off is exact and the sum of both has the digits of the file.
fn origin(bounds: Aabb) -> DVec3 {
    let size = (bounds.max - bounds.min).max_element();
    let step = (size.log2().floor() - 4.0).exp2();
    let center = 0.5 * (bounds.min + bounds.max);
    DVec3::from_array(center.to_array().map(|c| {
        if c.abs() <= size || !step.is_normal() {
            0.0
        } else {
            (c / step).round() * step
        }
    }))
}

fn is_repetitive(vertices: &[u32]) -> bool {
    vertices.len() > MOST_REPEATS
        && 2 * vertices.iter().collect::<HashSet<_>>().len() <= vertices.len()
}

fn unit(normal: DVec3) -> [f32; 3] {
    let scaled = normal / normal.abs().max_element();
    narrow(scaled.normalize_or_zero())
}

#[expect(
    clippy::cast_possible_truncation,
    reason = "positions about an origin, unit vectors"
)]
fn narrow(v: DVec3) -> [f32; 3] {
    v.to_array().map(|c| c as f32)
}

/// What each object is called; see the module's rules.
fn object_names(path: &Path, objects: &[(usize, Name)]) -> Vec<String> {
    let mut groups = HashMap::<usize, usize>::new();
    for (_, name) in objects {
        *groups.entry(name.object_number).or_default() += 1;
    }
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let name_of = |(_, name): &(usize, Name)| match (&*name.object, &*name.group) {
        ("", "") => stem.to_string(),
        ("", group) => group.to_owned(),
        (object, "") => object.to_owned(),
        (object, _) if groups[&name.object_number] == 1 => object.to_owned(),
        (object, group) => format!("{object}/{group}"),
    };
    objects.iter().map(name_of).collect()
}
