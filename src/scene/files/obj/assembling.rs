//! Builds one mesh from the blocks of its pieces and from the survey of all other lines.

use super::{
    BadLine, ObjError, ObjFile,
    block::{Block, Faces},
    channels,
    contents::Contents,
    counts::Counts,
    material::{self, Materials},
    material_name::{Found, is_bare},
    named::Named,
    names::{Names, distinct_names},
    notes::{self, LeftOut},
    survey::Survey,
    triangulation::{Splitter, has_area},
    vertices::Stored,
};
use crate::{
    geometry::{ColourRun, CornerNormals, Mesh, MeshData, Part, SmoothingRun},
    scene::{Cancelled, Detail, Progress},
};
use std::{ops::Range, path::Path, sync::Arc};

/// Where the file has neither normals nor smoothing groups, an edge whose faces differ by a larger angle is drawn
/// sharp. In radians.
const CREASE: f32 = 30.0 * std::f32::consts::PI / 180.0;

/// Builds the mesh of a file. In the progress, this counts as `bytes` bytes.
pub(super) fn build(
    path: &Path,
    mut blocks: Vec<Block>,
    mut survey: Survey,
    detail: Detail,
    (progress, bytes): (&Progress, u64),
) -> Result<ObjFile, ObjError> {
    let said = std::mem::take(&mut survey.said);
    let names = Names::new(path, said, survey.faces, progress)?;
    let mut materials = if detail.has_colours() {
        let has_uses = !names.materials.is_empty();
        material::read_libraries(path, &names.libraries, has_uses, progress)?
    } else {
        Materials::default()
    };
    let found = names.materials.iter();
    let found: Vec<_> = found.map(|(name, _)| materials.find(name)).collect();
    channels::spread_painted(&mut blocks);
    let beyond = channels::scale_bytes(&mut blocks);
    let count = blocks.len().max(1) as u64;
    // Besides the steps of the vertices: splitting, merging, and making the mesh.
    let steps = (Stored::STEPS + 3) * count;
    progress.advance(bytes % steps)?;
    let bytes = bytes / steps;
    let mut before = vec![Counts::default()];
    for block in &blocks {
        let last = before[before.len() - 1];
        before.push(last.and(block.counts));
    }
    let all_counts = before[before.len() - 1];
    let (vertices, faces): (Vec<_>, Vec<_>) = (blocks.into_iter())
        .map(|block| (block.vertices, block.faces))
        .unzip();
    let vertices = Stored::new(vertices, &faces, &before, (progress, bytes))?;
    let cuts = names.cuts();
    let (mut first, mut rest) = (0, &*cuts);
    let with_cuts: Vec<_> = (faces.into_iter().zip(&before))
        .map(|(faces, before)| {
            let next = first + faces.count();
            let (cuts, others) = rest.split_at(rest.partition_point(|&cut| cut < next));
            let cuts: Vec<usize> = cuts.iter().map(|cut| cut - first).collect();
            (first, rest) = (next, others);
            let file = InFile {
                before: *before,
                all: all_counts,
                has_lines: detail != Detail::Shapes,
            };
            (faces, cuts, file)
        })
        .collect();
    let split = progress.on_all_cores(bytes, with_cuts.into_iter(), |(faces, cuts, file)| {
        Triangles::of(&faces, &cuts, &vertices, &file, progress)
    })?;
    let split = split.into_iter().collect::<Result<Vec<_>, _>>()?;
    let mut all = Triangles::default();
    let count_of = |of: fn(&Triangles) -> usize| split.iter().map(of).sum();
    all.corners
        .reserve_exact(count_of(|piece| piece.corners.len()));
    all.lines.reserve_exact(count_of(|piece| piece.lines.len()));
    for next in split {
        progress.advance(bytes)?;
        all.append(next);
    }
    survey.append(std::mem::take(&mut all.survey), 0);
    survey.know_vertices(all_counts.vertices);
    if all.corners.is_empty() {
        let vertices = all_counts.vertices;
        return Err(notes::nothing(path, vertices, &survey, &all.left_out));
    }
    let mut warnings: Vec<_> = notes::about_lines(path, &survey).collect();
    warnings.extend(notes::about_geometry(path, &survey, &all.left_out));
    warnings.extend(beyond.map(|beyond| notes::of_colours(path, beyond)));
    warnings.extend(notes::about_materials(path, &names, &found, &materials));
    warnings.extend(std::mem::take(&mut materials.warnings));

    let contents = Contents {
        starts: before,
        lines: std::mem::take(&mut all.lines),
        libraries: std::mem::take(&mut materials.files),
        stamp: None,
    };
    let data = all.mesh(vertices, (names, &found), &cuts, &materials, progress)?;
    let mesh = Mesh::new(data);
    progress.advance(count * bytes)?;
    let mesh = mesh.map_err(|source| ObjError::NoMesh {
        file: path.to_owned(),
        source,
    })?;
    Ok(ObjFile {
        mesh: Arc::new(mesh),
        warnings,
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
    /// For each triangle, the line of its face in the file, from 1; empty where nobody asks for it.
    lines: Vec<u32>,
    left_out: LeftOut,
    /// The faces that name vertices or normals that do not exist.
    survey: Survey,
}

/// What is known of the file when the faces of a piece are split.
struct InFile {
    /// What comes before the piece.
    before: Counts,
    /// What the whole file has.
    all: Counts,
    /// Whether the lines of triangles are kept.
    has_lines: bool,
}

impl Triangles {
    /// The triangles of the faces of a block. `cuts` are the faces before which an object or a material begins.
    fn of(
        faces: &Faces,
        cuts: &[usize],
        vertices: &Stored,
        file: &InFile,
        progress: &Progress,
    ) -> Result<Self, Cancelled> {
        let InFile { before, all, .. } = file;
        let mut made = Self::default();
        made.corners.reserve_exact(faces.corners.len() / 3);
        let mut cuts = cuts.iter().peekable();
        let mut splitter = Splitter::default();
        let (mut places, mut normals) = (Vec::new(), Vec::new());
        for (face, (at, named)) in faces.each().enumerate() {
            if cuts.next_if_eq(&&face).is_some() {
                made.before_cuts.push(made.count());
            }
            let arity = named.len();
            let line = before.lines + faces.lines[face] as usize + 1;
            places.clear();
            let known = named.iter();
            let known = known.map_while(|corner| corner.index(before.vertices, all.vertices));
            places.extend(known.map(|vertex| vertices.place(vertex)));
            if let Some(missing) = named.get(places.len()) {
                let what = no_such_vertex(*missing, before.vertices);
                made.survey.note(line, what);
                continue;
            }
            if vertices.any_nowhere(&places) {
                made.left_out.nowhere += 1;
                continue;
            }
            normals.clear();
            let named = faces.normals.get(at..at + arity).unwrap_or_default();
            let is_named = named.first().is_some_and(|first| *first != Named::NONE);
            if is_named {
                let known = named.iter();
                let known = known.map_while(|normal| normal.index(before.normals, all.normals));
                normals.extend(known);
                made.survey.bad_normals += usize::from(normals.len() < arity);
            }
            let are_usable =
                normals.len() == arity && normals.iter().all(|&normal| vertices.has_normal(normal));
            let normals = are_usable.then_some(&*normals);
            let first = made.corners.len();
            if arity == 3 {
                made.add(&places, normals, [0, 1, 2], vertices);
            } else {
                if arity > 4 {
                    progress.advance(0)?;
                }
                let split = splitter.face(&places, |place| vertices.position(place));
                let Some(triangles) = split else {
                    made.left_out.repetitive += 1;
                    continue;
                };
                for &corners in triangles {
                    made.add(&places, normals, corners, vertices);
                }
            }
            if file.has_lines {
                let line = u32::try_from(line).unwrap_or(u32::MAX);
                let added = made.corners.len() - first;
                made.lines.extend(std::iter::repeat_n(line, added));
            }
        }
        Ok(made)
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
        self.lines.extend(next.lines);
        self.survey.append(next.survey, 0);
        self.shading.extend(next.shading);
        self.left_out.without_area += next.left_out.without_area;
        self.left_out.nowhere += next.left_out.nowhere;
        self.left_out.repetitive += next.left_out.repetitive;
    }

    /// Makes the data of the mesh from all triangles of a file.
    fn mesh(
        self,
        vertices: Stored,
        (names, found): (Names, &[Option<Found>]),
        cuts: &[usize],
        materials: &Materials,
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
        let is_none =
            |material: &usize| found[*material].is_none() && is_bare(&names.materials[*material].0);
        let uses = names.uses.iter();
        let uses = uses.map(|(face, material)| (*face, material.filter(|of| !is_none(of))));
        let uses = runs(None, uses, &start_of, end, progress)?;
        let colours = uses.into_iter().map(|(triangles, material)| ColourRun {
            triangles,
            colour: material
                .and_then(|material| found[material])
                .and_then(|found| materials.all[found.material].colour),
            material: material.and_then(|material| u32::try_from(material).ok()),
        });
        let colours = colours.collect();
        let smoothing = names.smoothing.iter().copied();
        let smoothing = runs(0, smoothing, &start_of, end, progress)?.into_iter();
        let smoothing = smoothing.map(|(triangles, group)| SmoothingRun { triangles, group });
        let mut smoothing: Vec<_> = smoothing.collect();
        let materials = distinct_names(names.materials);

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
        if is_complete || smoothing.iter().all(|run| run.group == 0) {
            smoothing = Vec::new();
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
            smoothing,
        })
    }
}

/// Runs of triangles with one value. `starts` has the faces at which a value begins, in order; it is `first` before.
fn runs<T: Copy + PartialEq>(
    first: T,
    starts: impl Iterator<Item = (usize, T)>,
    start_of: &impl Fn(usize) -> u32,
    end: u32,
    progress: &Progress,
) -> Result<Vec<(Range<u32>, T)>, Cancelled> {
    let mut runs = vec![(0..end, first)];
    for (step, (face, value)) in starts.enumerate() {
        progress.go_on_at(step)?;
        let start = start_of(face);
        if let Some((last, _)) = runs.last_mut() {
            last.end = start;
        }
        runs.pop_if(|(last, _)| (*last).is_empty());
        match runs.last_mut() {
            Some((last, known)) if *known == value => last.end = end,
            _ => runs.push((start..end, value)),
        }
    }
    runs.pop_if(|(last, _)| (*last).is_empty());
    Ok(runs)
}

/// What is wrong with a face that names this vertex, which does not exist.
fn no_such_vertex(named: Named, before: usize) -> BadLine {
    if named.is_counted_back() {
        return BadLine::BeforeFirst;
    }
    BadLine::NoSuchVertex {
        vertex: named.number(before).to_string(),
        // Said later.
        vertices: 0,
    }
}
