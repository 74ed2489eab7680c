//! Overlays that are lines in the world: normals, boxes, trees.

use super::box_edges::edges;
use crate::{
    geometry::{Cuboid, Mesh, Placement, Section, clip_points},
    look,
    render::Line,
    scene::{Object, Scene, Shape},
    viewer::model::{Overlay, Subject},
};
use glam::DVec3;
use std::slice;

/// More lines than this take longer than a frame may.
const MOST: usize = 100_000;

/// The meshes whose trees are shown, each with its model matrix: the selection's, or all that are visible if nothing is
/// selected. Objects of one mesh that stand alike have one tree.
pub(in crate::viewer) fn shown_trees(
    scene: &Scene,
    selected: Option<usize>,
) -> impl Iterator<Item = (&Mesh, &Placement)> {
    let batches = match selected {
        Some(selected) if selected >= scene.objects().len() => &[],
        Some(selected) => slice::from_ref(scene.batch_of(selected)),
        None => scene.batches(),
    };
    let shows = move |index: usize| {
        scene.objects()[index].visible && selected.is_none_or(|selected| selected == index)
    };
    let shown = batches
        .iter()
        .filter(move |batch| (*batch).clone().any(shows));
    shown.filter_map(|batch| match &scene.objects()[batch.start] {
        Object {
            shape: Shape::Mesh { mesh, .. },
            placement,
            ..
        } => Some((&**mesh, placement)),
        _ => None,
    })
}

/// The lines of an object, by its index.
type LinesOf = for<'a> fn(&'a Scene, usize) -> Box<dyn Iterator<Item = Line> + 'a>;

/// Normals, boxes and trees of the selection, or of all that is visible if nothing is selected: the first [`MOST`]
/// lines.
pub(in crate::viewer) fn lines(subject: &Subject) -> Vec<Line> {
    let (scene, overlays, selected) = (subject.scene, subject.overlays, subject.selection);
    let of_objects: [(Overlay, LinesOf); 2] = [
        (Overlay::Normals, |scene, index| {
            normals(&scene.objects()[index])
        }),
        (Overlay::Boxes, |scene, index| {
            Box::new(edges(&scene.bounds_of(index), look::BOXES))
        }),
    ];
    let is_asked = |index: &usize| {
        let object = scene.objects().get(*index);
        object.is_some_and(|object| object.visible)
    };
    let mut lines = Vec::new();
    for (_, of) in of_objects
        .iter()
        .filter(|(overlay, _)| overlays.shows(*overlay))
    {
        let objects = selected.map_or(0..scene.objects().len(), |at| at..at + 1);
        let all = objects.filter(is_asked).flat_map(|index| of(scene, index));
        lines.extend(all.take(MOST - lines.len()));
    }
    if let Some(level) = overlays.tree_level {
        for (mesh, placement) in shown_trees(scene, selected) {
            let left = MOST.saturating_sub(lines.len());
            for bounds in mesh.tree_boxes(level, left / 12) {
                lines.extend(edges(&bounds, look::TREE).map(|line| Line {
                    from: placement.point_to_world(line.from),
                    to: placement.point_to_world(line.to),
                    ..line
                }));
            }
        }
    }
    let ndc = subject.ndc();
    if let Some(section) = ndc.map_or(subject.view.section, |ndc| ndc.of.section) {
        let kept = |line: &Line| kept(line, &section);
        lines = lines.iter().filter_map(kept).collect();
    }
    if let Some(ndc) = ndc {
        let drawn = |line: &Line| {
            let [from, to] = ndc.drawn_segment([line.from, line.to])?;
            Some(Line { from, to, ..*line })
        };
        lines = lines.iter().filter_map(drawn).collect();
    }
    lines
}

/// What a section keeps of a line.
fn kept(line: &Line, section: &Section) -> Option<Line> {
    match clip_points(&[line.from, line.to], |p| section.side(p))[..] {
        [from, to, ..] => Some(Line { from, to, ..*line }),
        _ => None,
    }
}

/// A line from the middle of each face, outwards.
fn normals(object: &Object) -> Box<dyn Iterator<Item = Line> + '_> {
    let placement = &object.placement;
    let line = move |point: DVec3, normal: DVec3, length_world: f64| {
        let from = placement.point_to_world(point);
        let to = from + length_world * placement.normal_to_world(normal);
        Line::new(from, to, look::NORMALS)
    };
    let size = object.bounds_world().radius();
    match &object.shape {
        Shape::Sphere => {
            let side = || [-1.0, 0.0, 1.0].into_iter();
            let outward = side().flat_map(move |x| side().map(move |y| (x, y)));
            let outward = outward.flat_map(move |(x, y)| side().map(move |z| DVec3::new(x, y, z)));
            let outward = outward.filter(|v| *v != DVec3::ZERO).map(DVec3::normalize);
            Box::new(outward.map(move |normal| line(0.5 * normal, normal, 0.2 * size)))
        }
        Shape::Cube => {
            let face = move |normal| line(Cuboid::HALF_SIDE * normal, normal, 0.2 * size);
            Box::new(Cuboid::NORMALS.into_iter().map(face))
        }
        Shape::Square => Box::new(std::iter::once(line(DVec3::ZERO, DVec3::Z, 0.2 * size))),
        Shape::Mesh { mesh, .. } => {
            let triangles = object.shape.triangles().unwrap_or_default();
            Box::new(triangles.map(move |triangle| {
                let [a, b, c] = mesh.corners(triangle);
                let world = [a, b, c].map(|corner| placement.point_to_world(corner));
                let area = 0.5 * (world[1] - world[0]).cross(world[2] - world[0]).length();
                // About as long as its face is wide.
                line((a + b + c) / 3.0, (b - a).cross(c - a), 0.7 * area.sqrt())
            }))
        }
    }
}
