//! What is shown over the scene when asked for: which, and those that are lines in the world.

use super::state::State;
use crate::{
    colour::Srgb,
    geometry::{Aabb, Cuboid},
    render::Line,
    scene::{Object, Shape},
};
use glam::DVec3;

/// Something shown over the scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Overlay {
    /// The triangle under the pick, with its corners and barycentrics.
    Triangle,
    /// The way from the pick before to this one.
    Distance,
    /// The edges of triangles.
    Wireframe,
    /// Outward normals of faces.
    Normals,
    /// World-space bounding boxes.
    Boxes,
}

impl Overlay {
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::Triangle,
        Self::Distance,
        Self::Wireframe,
        Self::Normals,
        Self::Boxes,
    ];

    /// Its name, its key and what it shows.
    #[must_use]
    pub fn about(self) -> [&'static str; 3] {
        match self {
            Self::Triangle => ["picked triangle", "Y", "with its corners and barycentrics"],
            Self::Distance => [
                "distance",
                "D",
                "between the last two picks, in world units",
            ],
            Self::Wireframe => [
                "wireframe",
                "W",
                "of the selection, or of everything; spheres have none",
            ],
            Self::Normals => [
                "normals",
                "L",
                "outward, of the selection's faces, or of all",
            ],
            Self::Boxes => [
                "bounding boxes",
                "X",
                "along the world's axes, of the selection, or of everything",
            ],
        }
    }

    /// Whether it is drawn with the scene, and not by the panels over the picture.
    fn is_in_scene(self) -> bool {
        match self {
            Self::Triangle | Self::Distance => false,
            Self::Wireframe | Self::Normals | Self::Boxes => true,
        }
    }
}

/// Which overlays show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Overlays {
    /// A bit for each.
    shown: u32,
    /// Boxes of the trees over meshes, so many steps below the root.
    pub tree_level: Option<u32>,
}

impl Default for Overlays {
    fn default() -> Self {
        Self {
            shown: 0,
            tree_level: None,
        }
        .toggled(Overlay::Triangle)
    }
}

impl Overlays {
    /// Whether one shows.
    #[must_use]
    pub fn shows(self, overlay: Overlay) -> bool {
        self.shown & (1 << overlay as u32) != 0
    }

    /// The same, but for one.
    #[must_use]
    pub fn toggled(mut self, overlay: Overlay) -> Self {
        self.shown ^= 1 << overlay as u32;
        self
    }

    /// The same at another level of trees.
    pub(super) fn next_tree_level(self, deeper: bool) -> Self {
        let tree_level = match (self.tree_level, deeper) {
            (None, true) => Some(0),
            (None, false) => Some(DEEPEST),
            (Some(level), true) => Some(level + 1).filter(|level| *level <= DEEPEST),
            (Some(level), false) => level.checked_sub(1),
        };
        Self { tree_level, ..self }
    }

    /// Whether one of them is drawn with the scene.
    pub(super) fn in_scene(self) -> bool {
        let mut shown = Overlay::ALL
            .into_iter()
            .filter(|&overlay| self.shows(overlay));
        shown.any(Overlay::is_in_scene) || self.tree_level.is_some()
    }
}

/// More lines than these take longer than a frame may.
const MOST: usize = 100_000;
const NORMAL: Srgb = Srgb([110, 190, 255]);
/// Trees over real meshes are 5 to 8 nodes deep, even over millions of triangles.
const DEEPEST: u32 = 8;
const TREE: Srgb = Srgb([130, 220, 140]);
const BOX: Srgb = Srgb([240, 180, 80]);

/// Normals, boxes and trees of the selection, or of all that is visible where nothing is selected: the first [`MOST`] lines.
pub(super) fn lines(state: &State) -> Vec<Line> {
    let (scene, overlays) = (state.scene(), state.overlays());
    let selected = state.selection().map(|selection| selection.object);
    let objects = (0..).zip(scene.objects()).filter(|(index, object)| {
        object.visible && selected.is_none_or(|selected| selected == *index)
    });
    let mut lines = Vec::new();
    for (index, object) in objects {
        if overlays.shows(Overlay::Normals) {
            lines.extend(normals(object).take(MOST));
        }
        if overlays.shows(Overlay::Boxes) {
            lines.extend(edges(&scene.bounds_of(index), BOX));
        }
        if lines.len() >= MOST {
            lines.truncate(MOST);
            break;
        }
    }
    if let Some(level) = overlays.tree_level {
        for batch in scene.batches() {
            let shows = |index: usize| {
                scene.objects()[index].visible && selected.is_none_or(|selected| selected == index)
            };
            let object = &scene.objects()[batch.start];
            let left = MOST.saturating_sub(lines.len());
            if batch.clone().any(shows)
                && let Shape::Mesh { mesh, .. } = &object.shape
            {
                for bounds in mesh.tree_boxes(level, left / 12) {
                    lines.extend(edges(&bounds, TREE).map(|line| Line {
                        from: object.placement.point_to_world(line.from),
                        to: object.placement.point_to_world(line.to),
                        ..line
                    }));
                }
            }
        }
    }
    lines
}

/// The edges of a box; none of an empty one.
pub(super) fn edges(bounds: &Aabb, colour: Srgb) -> impl Iterator<Item = Line> {
    let corners = bounds.corners();
    // Corners that differ in one coordinate, from each pair once.
    let pairs = (0..8_usize).flat_map(|from| [1, 2, 4].map(move |bit| (from, from | bit)));
    let pairs = pairs.filter(|(from, to)| from != to);
    let is_there = !bounds.is_empty();
    pairs.filter(move |_| is_there).map(move |(from, to)| Line {
        from: corners[from],
        to: corners[to],
        colour,
    })
}

/// A line from the middle of each face, outwards.
fn normals(object: &Object) -> Box<dyn Iterator<Item = Line> + '_> {
    let placement = &object.placement;
    let line = move |point: DVec3, normal: DVec3, length_world: f64| {
        let from = placement.point_to_world(point);
        let to = from + length_world * placement.normal_to_world(normal);
        Line {
            from,
            to,
            colour: NORMAL,
        }
    };
    let size = object.bounds_world().radius();
    match &object.shape {
        Shape::Sphere => {
            let all =
                (-1..=1).flat_map(|x| (-1..=1).flat_map(move |y| (-1..=1).map(move |z| (x, y, z))));
            let outward = all.map(|(x, y, z)| DVec3::new(x.into(), y.into(), z.into()));
            let outward = outward.filter(|v| *v != DVec3::ZERO).map(DVec3::normalize);
            Box::new(outward.map(move |normal| line(0.5 * normal, normal, 0.2 * size)))
        }
        Shape::Cube => {
            let outward = Cuboid::NORMALS.into_iter();
            Box::new(
                outward.map(move |normal| line(Cuboid::HALF_SIDE * normal, normal, 0.2 * size)),
            )
        }
        Shape::Square => Box::new(std::iter::once(line(DVec3::ZERO, DVec3::Z, 0.2 * size))),
        Shape::Mesh { mesh, .. } => {
            let triangles = object.shape.triangles().unwrap_or_default();
            Box::new(triangles.map(move |triangle| {
                let [a, b, c] = mesh.corners(triangle);
                let world = [a, b, c].map(|corner| placement.point_to_world(corner));
                let area = 0.5 * (world[1] - world[0]).cross(world[2] - world[0]).length();
                // As long as its face is wide, about.
                line((a + b + c) / 3.0, (b - a).cross(c - a), 0.7 * area.sqrt())
            }))
        }
    }
}
