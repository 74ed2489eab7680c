//! Marks over the picture: the point that the pick's ray hits, the triangle there with its corners and barycentrics,
//! the distance from the previous pick, and snapped points.

use super::{
    field::{point, short},
    prelude::*,
};
use crate::{
    camera::View,
    geometry::clip,
    look,
    pick::Pick,
    viewer::{
        model::{Overlay, PickView, triangle},
        ui::theme::rimmed,
    },
};
use egui::{Painter, Pos2, Shape};
use glam::DVec2;

/// How opaque the marks of a pick are that another surface hides.
const HIDDEN: f32 = 0.45;
/// How opaque the mark is of what a click would snap to.
const AHEAD: f32 = 0.6;
/// Radius of the mark at a hit, in points.
const MARK: f32 = 6.0;
/// A triangle that is smaller than this in the picture, in points, has no names at its corners: they would hide it.
const LEGIBLE: f32 = 36.0;

/// The dark rim of a triangle's edges and of a distance's line.
const SHADE: (f32, Color32) = (4.0, Color32::from_black_alpha(160));

/// Lines end this far outside the picture, in pixels, so that their ends do not show.
const MARGIN_PX: f64 = 16.0;

/// Shown over the scene's rectangle.
pub(super) fn show(ui: &Ui, rect: Rect, place: SceneRect, state: &State) {
    let mut page = Page {
        painter: ui.painter().with_clip_rect(rect),
        place,
        view: state.view(),
        colour: color32(look::HIT),
        labels: Vec::new(),
    };
    let pick = state.picked();
    let of_measures = page.colour;
    let of_pick = if state.pick_is_hidden() {
        of_measures.gamma_multiply(HIDDEN)
    } else {
        of_measures
    };
    page.colour = of_pick;
    let is_in = state.pick_view() != Some(PickView::LeftOut);
    if let Some(pick) = pick.filter(|_| is_in && state.overlays().shows(Overlay::Triangle)) {
        page.triangle(state, pick);
    }
    page.colour = of_measures;
    let measuring = state.measuring();
    if let (Some([from, to]), true) = (
        measuring.last_two(),
        measuring.is_on || state.overlays().shows(Overlay::Distance),
    ) {
        page.distance(from.point_world, to.point_world);
    }
    if let Some(pick) = pick {
        page.colour = of_pick;
        page.hit(pick);
        page.colour = of_measures;
    }
    for point in measuring.points.iter().filter(|_| measuring.is_on) {
        page.diamond(point.point_world);
    }
    if let Some(snap) = &measuring.ahead {
        page.colour = of_measures.gamma_multiply(AHEAD);
        page.diamond(snap.point_world);
    }
    if let Some(example) = state.example() {
        page.colour = Color32::WHITE;
        page.named(example.world, point(example.view));
    }
}

struct Page<'a> {
    painter: Painter,
    place: SceneRect,
    view: &'a View,
    colour: Color32,
    /// Where labels stand already.
    labels: Vec<Rect>,
}

/// Lines shorter than this, in points, have their length written above both ends.
const SHORT: f32 = 90.0;

impl Page<'_> {
    fn at(&self, point_world: DVec3) -> Option<Pos2> {
        self.segment(point_world, point_world).map(|[at, _]| at)
    }

    fn segment(&self, a: DVec3, b: DVec3) -> Option<[Pos2; 2]> {
        let ends = self.view.project_segment(a, b)?;
        Some(ends.map(|end| self.place.to_position(end)))
    }

    /// What the picture shows of a segment.
    fn line(&self, a: DVec3, b: DVec3) -> Option<[Pos2; 2]> {
        let ends = self.view.project_segment(a, b)?;
        let ends = in_picture(ends, self.view.viewport.size_px())?;
        Some(ends.map(|end| self.place.to_position(end)))
    }

    /// A ring around the point that the ray hits, with a dot in it on a front face and a cross on a back face.
    fn hit(&self, pick: &Pick) {
        let Some(at) = self.at(pick.point_world) else {
            return;
        };
        for (colour, more) in rimmed(self.colour) {
            let stroke = Stroke::new(1.5 + more, colour);
            self.painter.circle_stroke(at, MARK, stroke);
            if pick.front {
                self.painter.circle_filled(at, 1.5 + 0.5 * more, colour);
            } else {
                let (down, up) = (vec2(MARK, MARK) * 0.7, vec2(MARK, -MARK) * 0.7);
                for to in [down, up] {
                    self.painter.line_segment([at - to, at + to], stroke);
                }
            }
        }
    }

    /// A point with its name, also in front of the near plane.
    fn named(&mut self, point_world: DVec3, name: String) {
        let seen = self.view.project(point_world);
        let Some(at) = seen.map(|seen| self.place.to_position(seen.px)) else {
            return;
        };
        for (colour, more) in rimmed(self.colour) {
            self.painter.circle_filled(at, 4.0 + 0.5 * more, colour);
        }
        self.text(at + vec2(0.0, -16.0), name);
    }

    /// Marks a point that a click snapped to.
    fn diamond(&self, point_world: DVec3) {
        let Some(at) = self.at(point_world) else {
            return;
        };
        let corners = [(9.0, 0.0), (0.0, 9.0), (-9.0, 0.0), (0.0, -9.0)];
        let corners = corners.map(|(x, y)| at + vec2(x, y)).to_vec();
        for (colour, more) in rimmed(self.colour) {
            let stroke = Stroke::new(1.5 + more, colour);
            let diamond = Shape::closed_line(corners.clone(), stroke);
            self.painter.add(diamond);
        }
    }

    fn triangle(&mut self, state: &State, pick: &Pick) {
        let (Some(corners), Some(weights)) = (triangle(state.scene(), pick), pick.barycentric)
        else {
            return;
        };
        let [a, b, c] = corners;
        let middle = (a + b + c) / 3.0;
        for (from, to) in [(a, b), (b, c), (c, a)] {
            if let Some(ends) = self.line(from, to) {
                self.painter.line_segment(ends, SHADE);
                let edge = Stroke::new(2.0, self.colour);
                self.painter.line_segment(ends, edge);
            }
        }
        // From each corner to the picked point, which is a weighted mean of the corners.
        for corner in corners {
            if let Some(ends) = self.line(corner, pick.point_world) {
                let dashes = Shape::dashed_line(&ends, Stroke::new(1.0, self.colour), 4.0, 4.0);
                self.painter.extend(dashes);
            }
        }
        let seen = corners.map(|corner| self.at(corner));
        if let [Some(a), Some(b), Some(c)] = seen
            && Rect::from_points(&[a, b, c]).size().max_elem() < LEGIBLE
        {
            return;
        }
        let middle = self.at(middle);
        let seen = seen.into_iter().zip(weights);
        for (name, (at, weight)) in ["v1", "v2", "v3"].into_iter().zip(seen) {
            // A name at the picture's edge would seem to belong to what is there.
            let Some(at) = at.filter(|at| self.painter.clip_rect().contains(*at)) else {
                continue;
            };
            self.painter.circle_filled(at, 4.0, self.colour);
            let outwards = middle.map_or(vec2(0.0, -1.0), |middle| (at - middle).normalized());
            self.text(at + 26.0 * outwards, format!("{name} {weight:.3}"));
        }
    }

    fn distance(&mut self, from: DVec3, to: DVec3) {
        let Some(ends) = self.segment(from, to) else {
            return;
        };
        if let Some(line) = self.line(from, to) {
            self.painter.line_segment(line, SHADE);
            let dashes = Shape::dashed_line(&line, Stroke::new(2.0, self.colour), 8.0, 4.0);
            self.painter.extend(dashes);
        }
        let edge = Stroke::new(1.5, Color32::BLACK);
        for end in ends {
            self.painter.circle(end, 4.0, self.colour, edge);
        }
        let mut above = ends[0].lerp(ends[1], 0.5) - vec2(0.0, 16.0);
        // Beside a short line there is no room between the marks at its ends.
        if ends[0].distance(ends[1]) < SHORT {
            above.y = ends[0].y.min(ends[1].y) - 20.0;
        }
        self.text(above, short(from.distance(to)));
    }

    fn text(&mut self, at: Pos2, text: String) {
        let context = self.painter.ctx();
        let (font, colour) = (FontId::proportional(15.0), of_words(context, self.colour));
        let backing = backing(context, 200);
        let galley = self.painter.layout_no_wrap(text, font, colour);
        let rect = Align2::CENTER_CENTER.anchor_size(at, galley.size());
        // Moved sideways into the picture, if it fits there.
        let bounds = self.painter.clip_rect().shrink(4.0);
        let over = (rect.right() - bounds.right()).max(0.0);
        let mut rect = rect.translate(vec2((bounds.left() - rect.left()).max(-over), 0.0));
        let around = vec2(4.0, 1.0);
        // Moved below the labels that it would cover. The list is sorted by height, so it covers none afterwards.
        for label in &self.labels {
            if label.intersects(rect.expand2(around)) {
                rect = rect.translate(vec2(0.0, label.bottom() + 2.0 - rect.top()));
            }
        }
        let plate = rect.expand2(around);
        self.labels.push(plate);
        self.labels.sort_by(|a, b| a.top().total_cmp(&b.top()));
        (self.painter).rect_filled(plate, 3.0, backing);
        self.painter.galley(rect.min, galley, colour);
    }
}

/// The part of a segment, in pixels, that lies in a picture of this size or within [`MARGIN_PX`] of it. A close-up
/// makes a segment billions of pixels long, and its dashes would fill the memory.
fn in_picture(mut ends: [DVec2; 2], size_px: DVec2) -> Option<[DVec2; 2]> {
    let middle = size_px / 2.0;
    for (axis, sign) in [(0, 1.0), (0, -1.0), (1, 1.0), (1, -1.0)] {
        let within = |at: &DVec2| middle[axis] + MARGIN_PX + sign * (at[axis] - middle[axis]);
        let [a, b, ..] = clip(&ends, within, |a, b, share| a.lerp(*b, share))[..] else {
            return None;
        };
        ends = [a, b];
    }
    Some(ends)
}

#[cfg(test)]
mod tests {
    use super::{MARGIN_PX, in_picture};
    use glam::{DVec2, dvec2};

    #[test]
    fn what_is_dashed_lies_in_the_picture() {
        let size = dvec2(640.0, 400.0);
        let inside = [dvec2(3.0, 5.0), dvec2(600.0, 390.0)];
        assert_eq!(in_picture(inside, size), Some(inside));
        let long = in_picture([dvec2(-1e12, 50.0), dvec2(1e12, 50.0)], size);
        let [a, b] = long.expect("it crosses the picture");
        assert!((a - dvec2(-MARGIN_PX, 50.0)).length() < 1e-3, "{a}");
        assert!((b - dvec2(size.x + MARGIN_PX, 50.0)).length() < 1e-3, "{b}");
        let steep = in_picture([dvec2(320.0, 200.0), dvec2(320.0, -1e300)], size);
        let [a, b] = steep.expect("it begins in the picture");
        assert_eq!(a, dvec2(320.0, 200.0));
        assert!((b.y + MARGIN_PX).abs() < 1e-3, "{b}");
        for beside in [
            [dvec2(-1e9, -50.0), dvec2(1e9, -50.0)],
            [DVec2::NAN, DVec2::NAN],
        ] {
            assert_eq!(in_picture(beside, size), None);
        }
    }
}
