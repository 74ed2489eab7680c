//! Builds one mesh from the blocks of its pieces and from the survey of all other lines.

use super::{
    ObjError, ObjFile,
    block::{Block, Faces},
    contents::Contents,
    material::{self, Material, Materials},
    names::Names,
    notes::{self, LeftOut},
    survey::Survey,
    triangulation::{Splitter, has_area},
    vertices::Stored,
};
use crate::{
    geometry::{ColourRun, CornerNormals, Mesh, MeshData, Part},
    scene::{Cancelled, Detail, Progress},
};
use std::{collections::HashMap, path::Path, sync::Arc};

/// Where the file has no normals, an edge whose faces differ by a larger angle is drawn sharp. In radians.
const CREASE: f32 = 30.0 * std::f32::consts::PI / 180.0;

/// Builds the mesh of a file. In the progress, this counts as `bytes` bytes.
pub(super) fn build(
    path: &Path,
    blocks: Vec<Block>,
    mut survey: Survey,
    detail: Detail,
    (progress, bytes): (&Progress, u64),
) -> Result<ObjFile, ObjError> {
    let said = std::mem::take(&mut survey.said);
    let names = Names::new(path, said, survey.faces, progress)?;
    let materials = match detail {
        Detail::Shapes => Materials::default(),
        _ => material::read_libraries(path, &names.libraries, progress)?,
    };
    let count = blocks.len().max(1) as u64;
    // Besides the steps of the vertices: splitting, merging, and making the mesh.
    let steps = (Stored::STEPS + 3) * count;
    progress.advance(bytes % steps)?;
    let bytes = bytes / steps;
    let mut contents = Contents::new(blocks.iter().map(|block| block.counts));
    let (vertices, faces): (Vec<_>, Vec<_>) = (blocks.into_iter())
        .map(|block| (block.vertices, block.faces))
        .unzip();
    let vertices = Stored::new(vertices, &faces, (progress, bytes))?;
    let cuts = names.cuts();
    let (mut first, mut rest) = (0, &*cuts);
    let with_cuts: Vec<_> = (faces.into_iter())
        .map(|faces| {
            let next = first + faces.count();
            let (cuts, others) = rest.split_at(rest.partition_point(|&cut| cut < next));
            let cuts: Vec<usize> = cuts.iter().map(|cut| cut - first).collect();
            (first, rest) = (next, others);
            (faces, cuts)
        })
        .collect();
    let split = progress.on_all_cores(bytes, with_cuts.into_iter(), |(faces, cuts)| {
        Triangles::of(&faces, &cuts, &vertices, progress)
    })?;
    let split = split.into_iter().collect::<Result<Vec<_>, _>>()?;
    let mut all = Triangles::default();
    all.corners
        .reserve_exact(split.iter().map(|piece| piece.corners.len()).sum());
    for (piece, next) in split.into_iter().enumerate() {
        progress.advance(bytes)?;
        contents.begin(piece, all.count(), (next.faces, next.are_plain()));
        all.append(next);
    }
    contents.end(all.count());
    if all.corners.is_empty() {
        return Err(notes::nothing(path, &survey, &all.left_out));
    }
    let mut warnings: Vec<_> = notes::about_lines(path, &survey).collect();
    warnings.extend(notes::about_geometry(path, &survey, &all.left_out));
    warnings.extend(notes::about_materials(path, &names, &materials.by_name));
    warnings.extend(materials.warnings);

    let data = all.mesh(vertices, names, &cuts, &materials.by_name, progress)?;
    let mesh = Mesh::new(data);
    progress.advance(count * bytes)?;
    let mesh = mesh.map_err(|source| ObjError::NoMesh {
        file: path.to_owned(),
        source,
    })?;
    let mesh = Arc::new(mesh);
    let libraries = materials.files.iter();
    let named = libraries.map(|(file, _)| file.clone()).collect();
    contents.libraries = materials.files;
    Ok(ObjFile {
        mesh,
        warnings,
        materials: named,
        contents,
    })
}

/// The triangles of faces, in the order of the faces.
#[derive(Default)]
struct Triangles {
    corners: Vec<[u32; 3]>,
    /// For each triangle, indices into the file's normals, or [`CornerNormals::NONE`] if its normals are computed.
    /// Empty as long as no triangle has normals from the file.
    shading: Vec<[u32; 3]>,
    /// For each cut, the number of triangles before it.
    before_cuts: Vec<u32>,
    left_out: LeftOut,
    /// The number of faces.
    faces: usize,
    /// How many polygons were split into another number of triangles than two fewer than corners.
    odd: usize,
}

impl Triangles {
    /// The triangles of the faces of a block. `cuts` are the faces before which an object or a material begins.
    fn of(
        faces: &Faces,
        cuts: &[usize],
        vertices: &Stored,
        progress: &Progress,
    ) -> Result<Self, Cancelled> {
        let mut all = Self {
            faces: faces.count(),
            ..Self::default()
        };
        all.corners.reserve_exact(faces.corners.len() / 3);
        let mut cuts = cuts.iter().peekable();
        let mut splitter = Splitter::default();
        let mut places = Vec::new();
        let mut at = 0;
        for (face, &with_normals) in faces.with_normals.iter().enumerate() {
            if cuts.next_if_eq(&&face).is_some() {
                all.before_cuts.push(all.count());
            }
            let arity = faces.arities.get(face).map_or(3, |&arity| arity as usize);
            let corners = at..at + arity;
            at += arity;
            places.clear();
            let named = faces.corners[corners.clone()].iter();
            places.extend(named.map(|&vertex| vertices.place(vertex)));
            if vertices.any_nowhere(&places) {
                all.left_out.nowhere += 1;
                continue;
            }
            let normals = Some(&faces.normals)
                .filter(|_| with_normals)
                .and_then(|normals| normals.get(corners))
                .filter(|normals| normals.iter().all(|&i| vertices.has_normal(i)));
            if arity == 3 {
                all.add(&places, normals, [0, 1, 2], vertices);
                continue;
            }
            if arity > 4 {
                progress.advance(0)?;
            }
            let Some(triangles) = splitter.face(&places, |place| vertices.position(place)) else {
                all.left_out.repetitive += 1;
                continue;
            };
            all.odd += usize::from(triangles.len() + 2 != arity);
            for &corners in triangles {
                all.add(&places, normals, corners, vertices);
            }
        }
        Ok(all)
    }

    /// Whether each face has two triangles fewer than corners.
    fn are_plain(&self) -> bool {
        self.odd == 0 && self.left_out.is_nothing()
    }

    fn count(&self) -> u32 {
        u32::try_from(self.corners.len()).unwrap_or(u32::MAX)
    }

    /// Adds the triangle of these corners of a face, unless it has no area.
    fn add(&mut self, face: &[u32], normals: Option<&[u32]>, corners: [u32; 3], vertices: &Stored) {
        let triangle = corners.map(|i| face[i as usize]);
        if !has_area(triangle.map(|place| vertices.position(place))) {
            self.left_out.without_area += 1;
            return;
        }
        if normals.is_some() {
            self.begin_shading();
        }
        if !self.shading.is_empty() || normals.is_some() {
            let shading = normals.map(|normals| corners.map(|i| normals[i as usize]));
            self.shading.push(shading.unwrap_or(CornerNormals::NONE));
        }
        self.corners.push(triangle);
    }

    /// Extends `shading` to all triangles that were added so far.
    fn begin_shading(&mut self) {
        self.shading.resize(self.corners.len(), CornerNormals::NONE);
    }

    fn append(&mut self, mut next: Self) {
        if !self.shading.is_empty() || !next.shading.is_empty() {
            self.begin_shading();
            next.begin_shading();
        }
        let before = self.count();
        let before_cuts = next.before_cuts.iter();
        self.before_cuts
            .extend(before_cuts.map(|count| before + count));
        self.corners.extend(next.corners);
        self.shading.extend(next.shading);
        self.left_out.without_area += next.left_out.without_area;
        self.left_out.nowhere += next.left_out.nowhere;
        self.left_out.repetitive += next.left_out.repetitive;
    }

    /// Makes the data of the mesh from all triangles of a file.
    fn mesh(
        self,
        vertices: Stored,
        names: Names,
        cuts: &[usize],
        materials: &HashMap<String, Material>,
        progress: &Progress,
    ) -> Result<MeshData, Cancelled> {
        let end = self.count();
        // A cut that no face follows starts after the last triangle.
        let start_of = |face: usize| {
            let cut = cuts.binary_search(&face).unwrap_or(cuts.len());
            self.before_cuts.get(cut).copied().unwrap_or(end)
        };
        let mut parts: Vec<Part> = Vec::new();
        for (step, (face, name)) in names.objects.into_iter().enumerate() {
            progress.go_on_at(step)?;
            let triangles = start_of(face)..end;
            if let Some(last) = parts.last_mut() {
                last.triangles.end = triangles.start;
            }
            parts.pop_if(|part| part.triangles.is_empty());
            parts.push(Part { name, triangles });
        }
        parts.pop_if(|part| part.triangles.is_empty());
        // Triangles before the first use of a material have no colour.
        let mut colours = vec![ColourRun {
            triangles: 0..end,
            colour: None,
            material: None,
        }];
        for (step, (face, material)) in names.uses.into_iter().enumerate() {
            progress.go_on_at(step)?;
            let (name, _) = &names.materials[material];
            let colour = materials.get(name).and_then(|known| known.colour);
            let material = u32::try_from(material).ok();
            let triangles = start_of(face)..end;
            if let Some(last) = colours.last_mut() {
                last.triangles.end = triangles.start;
            }
            colours.pop_if(|run| run.triangles.is_empty());
            match colours.last_mut() {
                Some(last) if last.material == material => last.triangles.end = end,
                _ => colours.push(ColourRun {
                    triangles,
                    colour,
                    material,
                }),
            }
        }
        colours.pop_if(|run| run.triangles.is_empty());

        let materials = names.materials.into_iter();
        let materials = materials.map(|(name, _)| name).collect();

        let mut corners = self.shading;
        let is_complete = !corners.is_empty() && !corners.contains(&CornerNormals::NONE);
        let normals = if corners.is_empty() {
            Vec::new()
        } else {
            vertices.normals
        };
        if normals.len() == vertices.positions.len() && corners == self.corners {
            // Each vertex has one normal, at its own index.
            corners = Vec::new();
        }
        Ok(MeshData {
            origin: vertices.origin,
            positions: vertices.positions,
            triangles: self.corners,
            parts,
            colours,
            materials,
            vertex_colours: vertices.colours,
            normals: CornerNormals { normals, corners },
            crease: (!is_complete).then_some(CREASE),
        })
    }
}
