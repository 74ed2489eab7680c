//! Finds where one frame's panels look different from the last frame's.

use super::place::PixelRect;
use egui::{
    ClippedPrimitive, Rect,
    epaint::{Mesh, Primitive, Vertex},
};

/// Rectangles in points that hold every difference between two frames. They may overlap. There is none if nothing
/// differs, and one that holds everything if the differences are not worth finding.
///
/// A primitive's triangles are compared in order, one by one if there are as many as before. If not, the triangles that
/// both lists begin and end with are left out, so that text of another length damages only itself.
pub(super) fn damage(before: &[ClippedPrimitive], now: &[ClippedPrimitive]) -> Vec<Rect> {
    if before.len() != now.len() {
        return vec![Rect::EVERYTHING];
    }
    let pairs = before.iter().zip(now);
    let each = pairs.map(|(before, now)| of_primitive(before, now));
    each.filter(|rect| !rect.is_negative()).collect()
}

/// Merges rectangles of pixels until none of them overlap.
pub(super) fn disjoint(rects: impl IntoIterator<Item = PixelRect>) -> Vec<PixelRect> {
    let mut all: Vec<PixelRect> = Vec::new();
    for mut rect in rects {
        // As the rectangle grows, it may overlap further ones.
        while let Some(at) = all.iter().position(|other| overlap(other, &rect)) {
            let other = all.swap_remove(at);
            for axis in 0..2 {
                rect[0][axis] = rect[0][axis].min(other[0][axis]);
                rect[1][axis] = rect[1][axis].max(other[1][axis]);
            }
        }
        all.push(rect);
    }
    all
}

fn overlap([a_min, a_max]: &PixelRect, [b_min, b_max]: &PixelRect) -> bool {
    (0..2).all(|axis| a_min[axis] < b_max[axis] && b_min[axis] < a_max[axis])
}

fn of_primitive(before: &ClippedPrimitive, now: &ClippedPrimitive) -> Rect {
    let (Primitive::Mesh(was), Primitive::Mesh(is)) = (&before.primitive, &now.primitive) else {
        return Rect::EVERYTHING;
    };
    if before.clip_rect != now.clip_rect || was.texture_id != is.texture_id {
        let [was, is] = [(before, was), (now, is)]
            .map(|(primitive, mesh)| primitive.clip_rect.intersect(mesh.calc_bounds()));
        return was.union(is);
    }
    if was == is {
        return Rect::NOTHING;
    }
    let [was, is] = [was, is].map(|mesh| mesh.indices.chunks_exact(3).map(|t| triangle(mesh, t)));
    let differs = if was.len() == is.len() {
        let pairs = was.zip(is).filter(|(was, is)| was != is);
        bounds(pairs.flat_map(|(was, is)| [was, is]))
    } else {
        let begins = was.clone().zip(is.clone());
        let begin = begins.take_while(|(was, is)| was == is).count();
        let rest = was.len().min(is.len()) - begin;
        let ends = was.clone().rev().zip(is.clone().rev()).take(rest);
        let end = ends.take_while(|(was, is)| was == is).count();
        let [was, is] = [was, is].map(|all| {
            let len = all.len() - begin - end;
            all.skip(begin).take(len)
        });
        bounds(was.chain(is))
    };
    differs.intersect(now.clip_rect)
}

fn triangle(mesh: &Mesh, indices: &[u32]) -> [Vertex; 3] {
    [0, 1, 2].map(|i| mesh.vertices[indices[i] as usize])
}

fn bounds(triangles: impl Iterator<Item = [Vertex; 3]>) -> Rect {
    let corners = triangles.flatten().map(|vertex| vertex.pos);
    corners.fold(Rect::NOTHING, |mut all, corner| {
        all.extend_with(corner);
        all
    })
}

#[cfg(test)]
mod tests {
    use super::{damage, disjoint};
    use egui::{ClippedPrimitive, Color32, Mesh, Rect, epaint::Primitive, pos2, vec2};

    const CLIP: Rect = Rect {
        min: pos2(0.0, 0.0),
        max: pos2(100.0, 100.0),
    };

    fn at(x: f32) -> Rect {
        Rect::from_min_size(pos2(x, 10.0), vec2(5.0, 5.0))
    }

    fn primitive(squares: &[(Rect, Color32)]) -> ClippedPrimitive {
        let mut mesh = Mesh::default();
        for &(rect, colour) in squares {
            mesh.add_colored_rect(rect, colour);
        }
        ClippedPrimitive {
            clip_rect: CLIP,
            primitive: Primitive::Mesh(mesh),
        }
    }

    fn of(before: &[(Rect, Color32)], now: &[(Rect, Color32)]) -> Rect {
        let all = damage(&[primitive(before)], &[primitive(now)]);
        all.into_iter().fold(Rect::NOTHING, Rect::union)
    }

    const RED: Color32 = Color32::RED;

    #[test]
    fn nothing_differs() {
        let all = [(at(0.0), RED), (at(20.0), RED)];
        assert_eq!(of(&all, &all), Rect::NOTHING);
    }

    #[test]
    fn another_colour_and_another_place() {
        let before = [(at(0.0), RED), (at(20.0), RED), (at(40.0), RED)];
        let now = [(at(0.0), RED), (at(20.0), Color32::BLUE), (at(40.0), RED)];
        assert_eq!(of(&before, &now), at(20.0));
        let now = [(at(0.0), RED), (at(26.0), RED), (at(40.0), RED)];
        assert_eq!(of(&before, &now), at(20.0).union(at(26.0)));
    }

    #[test]
    fn one_more_and_one_less_in_the_middle() {
        let few = [(at(0.0), RED), (at(40.0), RED)];
        let more = [(at(0.0), RED), (at(20.0), RED), (at(40.0), RED)];
        assert_eq!(of(&few, &more), at(20.0));
        assert_eq!(of(&more, &few), at(20.0));
        // Of two equal squares, either may be the new one.
        let twice = [(at(0.0), RED), (at(0.0), RED)];
        assert_eq!(of(&twice[..1], &twice), at(0.0));
    }

    #[test]
    fn what_is_clipped_away_is_not_damaged() {
        let before = [(at(98.0), RED)];
        let shown = at(98.0).intersect(CLIP);
        assert_eq!(of(&before, &[(at(98.0), Color32::BLUE)]), shown);
        assert!(shown.is_positive());
        let beyond = [(at(200.0), RED)];
        assert!(of(&beyond, &[(at(210.0), RED)]).is_negative());
    }

    #[test]
    fn another_clip_damages_both() {
        let all = [(at(0.0), RED), (at(20.0), RED)];
        let mut other = primitive(&all);
        other.clip_rect.max.x = 22.0;
        let both = Rect::from_min_max(pos2(0.0, 10.0), pos2(25.0, 15.0));
        assert_eq!(damage(&[primitive(&all)], &[other]), [both]);
    }

    #[test]
    fn another_count_damages_everything() {
        assert_eq!(damage(&[], &[primitive(&[])]), [Rect::EVERYTHING]);
    }
    #[test]
    fn what_is_far_apart_stays_so() {
        let [before, now] = [Color32::RED, Color32::BLUE].map(|colour| {
            let far = primitive(&[(at(80.0), colour)]);
            vec![primitive(&[(at(0.0), colour)]), primitive(&[]), far]
        });
        assert_eq!(damage(&before, &now), [at(0.0), at(80.0)]);
    }

    #[test]
    fn what_overlaps_becomes_one() {
        let [a, b] = [[[0, 0], [2, 2]], [[4, 0], [6, 2]]];
        assert_eq!(disjoint([a, b]), [a, b]);
        // Rectangles that only touch do not overlap.
        assert_eq!(disjoint([a, [[2, 0], [4, 2]]]).len(), 2);
        assert_eq!(disjoint([a, b, [[1, 1], [5, 3]]]), [[[0, 0], [6, 3]]]);
        let (c, d) = ([[3, 3], [4, 4]], [[1, 1], [4, 4]]);
        assert_eq!(disjoint([a, c, d]), [[[0, 0], [4, 4]]]);
    }
}
