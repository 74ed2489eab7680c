//! Converts the vertices of a file to what a mesh stores: only the used ones, as `f32` positions relative to an origin.

use super::{block::Faces, coordinates::Vertices, counts::Counts, named::Named};
use crate::{
    colour::Srgb,
    geometry::{Aabb, binary::power_of_two_below, range},
    scene::{Cancelled, Progress},
};
use glam::{DVec3, Vec3};
use std::{
    collections::HashSet,
    sync::atomic::{AtomicBool, Ordering::Relaxed},
};

/// Vertices as a mesh stores them.
#[derive(Default)]
pub(super) struct Stored {
    pub origin: DVec3,
    /// Relative to the origin.
    pub positions: Vec<[f32; 3]>,
    /// The colour of every vertex; empty if no vertex has one.
    pub colours: Vec<Srgb>,
    /// The file's normals, scaled to unit length. A normal without a direction is zero.
    pub normals: Vec<[f32; 3]>,
    /// The vertices that are not three numbers in range. Their positions are stored as zeros.
    nowhere: HashSet<u32>,
    /// For each vertex of the file, its index in `positions`; `None` if faces use all vertices.
    places: Option<Vec<u32>>,
}

/// The vertices of a block, and for each whether a face uses it.
type Block<'a> = (Vertices, &'a [bool]);

impl Stored {
    /// How many times [`Self::new`] goes through all blocks and reports progress for each.
    pub const STEPS: u64 = 4;

    /// Stores the vertices that faces use. `before` counts what comes before each block, and at the end, before none.
    /// In the progress, each block counts as `bytes` bytes in each step.
    pub fn new(
        blocks: Vec<Vertices>,
        faces: &[Faces],
        before: &[Counts],
        (progress, bytes): (&Progress, u64),
    ) -> Result<Self, Cancelled> {
        let coloured = blocks.iter().any(|block| !block.colours.is_empty());
        let used = used(faces, before, (progress, bytes))?;
        let mut unread = &*used;
        let mut blocks: Vec<Block> = (blocks.into_iter())
            .map(|block| {
                let (used, rest) = unread.split_at(block.positions.len());
                unread = rest;
                (block, used)
            })
            .collect();
        let bounds = progress.on_all_cores(bytes, blocks.iter(), |block| {
            Aabb::around(used_of(block, &block.0.positions).filter_map(range::stored_vector))
        })?;
        let bounds = bounds.into_iter().fold(Aabb::EMPTY, Aabb::union);
        let origin = origin(bounds);
        let stored = progress.on_all_cores(bytes, blocks.drain(..), |block| {
            Self::of_block(&block, origin, coloured)
        })?;
        let all_used = !used.contains(&false);
        let mut all = Self {
            origin,
            places: (!all_used).then(|| places(&used)),
            ..Self::default()
        };
        let count = |of: fn(&Self) -> usize| stored.iter().map(of).sum();
        all.positions
            .reserve_exact(count(|block| block.positions.len()));
        all.colours
            .reserve_exact(count(|block| block.colours.len()));
        all.normals
            .reserve_exact(count(|block| block.normals.len()));
        for block in stored {
            progress.advance(bytes)?;
            all.append(block);
        }
        Ok(all)
    }

    fn of_block(block: &Block, origin: DVec3, coloured: bool) -> Self {
        let Vertices {
            positions,
            colours,
            normals,
        } = &block.0;
        let mut nowhere = HashSet::new();
        let positions = (0..).zip(used_of(block, positions)).map(|(index, v)| {
            let position = position(v, origin);
            if position.is_none() {
                nowhere.insert(index);
            }
            position.unwrap_or_default().to_array()
        });
        let positions: Vec<_> = positions.collect();
        let colours = if coloured && colours.is_empty() {
            vec![Srgb::WHITE; positions.len()]
        } else {
            used_of(block, colours)
                .map(|colour| Srgb::from_unit(colour.to_array()))
                .collect()
        };
        Self {
            positions,
            colours,
            normals: (normals.iter())
                .map(|&n| unit(DVec3::from_array(n)))
                .collect(),
            nowhere,
            ..Self::default()
        }
    }

    fn append(&mut self, next: Self) {
        let before = u32::try_from(self.positions.len()).unwrap_or(u32::MAX);
        self.nowhere
            .extend(next.nowhere.into_iter().map(|i| before + i));
        self.positions.extend(next.positions);
        self.colours.extend(next.colours);
        self.normals.extend(next.normals);
    }

    /// The index in `positions` of a vertex of the file.
    pub fn place(&self, vertex: u32) -> u32 {
        match &self.places {
            Some(places) => places[vertex as usize],
            None => vertex,
        }
    }

    /// The stored position of a vertex, relative to the origin. Rays are tested against this position.
    pub fn position(&self, place: u32) -> DVec3 {
        DVec3::from_array(self.positions[place as usize].map(f64::from))
    }

    /// Whether a normal has a direction.
    pub fn has_normal(&self, normal: u32) -> bool {
        Vec3::from_array(self.normals[normal as usize]) != Vec3::ZERO
    }

    /// Whether one of these vertices is not three numbers in range.
    pub fn any_nowhere(&self, places: &[u32]) -> bool {
        !self.nowhere.is_empty() && places.iter().any(|place| self.nowhere.contains(place))
    }
}

/// The position that a mesh stores of a vertex, relative to the origin; `None` for a number beyond the range.
pub(super) fn position(vertex: DVec3, origin: DVec3) -> Option<Vec3> {
    let position = (range::stored_vector(vertex)? - origin).as_vec3();
    Some(range::stored_vector(position.as_dvec3())?.as_vec3())
}

/// For each vertex, whether a face uses it.
fn used(
    faces: &[Faces],
    before: &[Counts],
    (progress, bytes): (&Progress, u64),
) -> Result<Vec<bool>, Cancelled> {
    let count = before.last().map_or(0, |all| all.vertices);
    let used: Vec<_> = std::iter::repeat_with(AtomicBool::default)
        .take(count)
        .collect();
    let blocks = faces.iter().zip(before);
    progress.on_all_cores(bytes, blocks, |(faces, before)| {
        for (_, corners) in faces.each() {
            let index = |corner: &Named| corner.index(before.vertices, count);
            if corners.iter().all(|corner| index(corner).is_some()) {
                for vertex in corners.iter().filter_map(index) {
                    used[vertex as usize].store(true, Relaxed);
                }
            }
        }
    })?;
    Ok(used.into_iter().map(AtomicBool::into_inner).collect())
}

/// Selects the values of used vertices, from one value for each vertex of a block.
fn used_of<'a>((_, used): &'a Block, values: &'a [[f64; 3]]) -> impl Iterator<Item = DVec3> + 'a {
    let used = values.iter().zip(*used).filter(|(_, used)| **used);
    used.map(|(&value, _)| DVec3::from_array(value))
}

/// For each vertex, the number of used vertices before it.
fn places(used: &[bool]) -> Vec<u32> {
    let before = used.iter().scan(0, |before, &used| {
        let place = *before;
        *before += u32::from(used);
        Some(place)
    });
    before.collect()
}

/// The origin of the `f32` positions, axis by axis. It is 0 if the box's centre is no farther from 0 than the box's
/// largest side, because another origin would gain no precision. Otherwise it is the box's centre, rounded to a
/// multiple of a power of two near a sixteenth of that side. Subtracting the origin is then exact, and origin plus
/// position has the digits of the file.
fn origin(bounds: Aabb) -> DVec3 {
    let size = (bounds.max - bounds.min).max_element();
    let step = power_of_two_below(size) / 16.0;
    let center = 0.5 * (bounds.min + bounds.max);
    DVec3::from_array(center.to_array().map(|c| {
        if c.abs() <= size || !step.is_normal() {
            0.0
        } else {
            (c / step).round() * step
        }
    }))
}

fn unit(normal: DVec3) -> [f32; 3] {
    let scaled = normal / normal.abs().max_element();
    scaled.normalize_or_zero().as_vec3().to_array()
}
