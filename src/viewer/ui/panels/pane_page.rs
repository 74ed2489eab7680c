//! What is drawn over one of the four views: points of its scene, lines between them, and names where there is room.

use super::prelude::*;
use crate::{camera::View, viewer::model::Stage};
use egui::{Painter, Pos2, Shape};

/// Views smaller than this, in points, show only the most important names.
const SMALL: f32 = 230.0;
/// Size of names in points: in the smallest views, and in large ones.
const TEXT: [f32; 2] = [11.0, 14.0];
/// Distances of a name from its point, in points of the window. The first one with room is used.
const BESIDE: [f32; 3] = [10.0, 24.0, 40.0];

/// A text to be written beside a point, and what it means.
pub(super) struct Name {
    at: Pos2,
    text: String,
    colour: Color32,
    hint: &'static str,
}

/// What is drawn over a view's rectangle.
pub(super) struct Page<'a> {
    pub ui: &'a mut Ui,
    pub rect: Rect,
    pub place: SceneRect,
    /// The view that the picture at that place is drawn through.
    pub seen: &'a View,
    pub stage: Stage,
    pub state: &'a State,
    /// The most important first.
    pub names: Vec<Name>,
}

impl Page<'_> {
    /// A world point in the scene that the stage shows; `None` in NDC in front of the near plane.
    pub fn at_stage(&self, world: DVec3) -> Option<DVec3> {
        match self.stage {
            Stage::Object => {
                let object = &self.state.scene().objects()[self.state.pane_object()?];
                Some(object.placement.point_to_object(world))
            }
            Stage::World | Stage::View => Some(world),
            Stage::Ndc => self.state.ndc().drawn(world),
        }
    }

    fn position(&self, at: DVec3) -> Option<Pos2> {
        self.segment(at, at).map(|[at, _]| at)
    }

    /// That one of some points which is farthest from the middle of them all in this view: a name there is beside
    /// whatever lies between them.
    pub fn outermost(&self, some: &[DVec3], all: &[DVec3]) -> DVec3 {
        let all: Vec<Pos2> = all.iter().filter_map(|at| self.position(*at)).collect();
        let middle = Rect::from_points(&all).center();
        let off = |at: &DVec3| (self.position(*at)).map_or(0.0, |at| at.distance_sq(middle));
        let farthest = some.iter().max_by(|a, b| off(a).total_cmp(&off(b)));
        farthest.copied().unwrap_or_default()
    }

    fn segment(&self, from: DVec3, to: DVec3) -> Option<[Pos2; 2]> {
        let ends = self.seen.project_segment(from, to)?;
        let ends = ends.map(|end| self.place.to_position(end));
        ends.iter().all(|end| end.is_finite()).then_some(ends)
    }

    fn painter(&self) -> Painter {
        self.ui.painter().with_clip_rect(self.rect)
    }

    /// A line with a dark rim, so that it shows on any picture.
    pub fn line(&self, from: DVec3, to: DVec3, width: f32, colour: Color32) {
        let Some(ends) = self.segment(from, to) else {
            return;
        };
        for (more, colour) in [(2.0, Color32::from_black_alpha(140)), (0.0, colour)] {
            (self.painter()).line_segment(ends, Stroke::new(width + more, colour));
        }
    }

    /// A line with an arrowhead at its end.
    pub fn arrow(&self, from: DVec3, to: DVec3, colour: Color32) {
        self.line(from, to, 2.0, colour);
        let Some([from, to]) = self.segment(from, to) else {
            return;
        };
        let along = (to - from).normalized();
        if along != Vec2::ZERO {
            let back = to - 8.0 * along;
            let head = vec![to, back + 4.0 * along.rot90(), back - 4.0 * along.rot90()];
            (self.painter()).add(Shape::convex_polygon(head, colour, Stroke::NONE));
        }
    }

    /// An area of a plane, by its corners.
    pub fn area(&self, corners: &[DVec3], colour: Color32) {
        let kept = self.seen.past_near(corners).into_iter();
        let kept: Option<Vec<Pos2>> = kept.map(|at| self.position(at)).collect();
        if let Some(kept) = kept.filter(|kept| kept.len() > 2) {
            let edge = Stroke::new(2.0, colour);
            let fill = colour.gamma_multiply(0.28);
            self.painter().add(Shape::convex_polygon(kept, fill, edge));
        }
    }

    pub fn dot(&self, at: DVec3, radius: f32, colour: Color32) {
        if let Some(at) = self.position(at) {
            let edge = Stroke::new(1.0, Color32::from_black_alpha(200));
            self.painter().circle(at, radius, colour, edge);
        }
    }

    /// A name beside a point; `hint` says what it means.
    pub fn name(
        &mut self,
        at: DVec3,
        text: impl Into<String>,
        colour: Color32,
        hint: &'static str,
    ) {
        if let Some(at) = self.position(at).filter(|at| self.rect.contains(*at)) {
            self.names.push(Name {
                at,
                text: text.into(),
                colour,
                hint,
            });
        }
    }

    /// Writes the names over all lines, each clear of `taken` and of the other names.
    pub fn write(self, mut taken: Vec<Rect>) {
        // Names do not cover named points either.
        let named: Vec<Pos2> = self.names.iter().map(|name| name.at).collect();
        let around = |at: &Pos2| Rect::from_center_size(*at, Vec2::splat(9.0));
        taken.extend(named.iter().map(around));
        let middle = Rect::from_points(&named).center();
        let painter = self.painter();
        let size_of_text = (self.rect.size().min_elem() / 32.0).clamp(TEXT[0], TEXT[1]);
        for Name {
            at,
            text,
            colour,
            hint,
        } in self.names
        {
            let font = FontId::proportional(size_of_text);
            let colour = of_words(self.ui.ctx(), colour);
            let galley = painter.layout_no_wrap(text.clone(), font, colour);
            let size = galley.size() + vec2(6.0, 2.0);
            let mut sides = [
                (Align2::LEFT_BOTTOM, vec2(0.7, -0.5)),
                (Align2::LEFT_TOP, vec2(0.7, 0.5)),
                (Align2::RIGHT_BOTTOM, vec2(-0.7, -0.5)),
                (Align2::RIGHT_TOP, vec2(-0.7, 0.5)),
                (Align2::CENTER_BOTTOM, vec2(0.0, -1.0)),
                (Align2::CENTER_TOP, vec2(0.0, 1.0)),
            ];
            // Outwards first: objects are in the middle.
            sides.sort_by(|(_, a), (_, b)| b.dot(at - middle).total_cmp(&a.dot(at - middle)));
            let mut rects = BESIDE
                .into_iter()
                .flat_map(|away| sides.map(|(align, by)| align.anchor_size(at + away * by, size)));
            let is_free = |rect: &Rect| {
                self.rect.contains_rect(*rect) && !taken.iter().any(|taken| taken.intersects(*rect))
            };
            let Some(rect) = rects.find(is_free) else {
                continue;
            };
            taken.push(rect);
            painter.rect_filled(rect, 3.0, backing(self.ui.ctx(), 190));
            let text = RichText::new(text).size(size_of_text).color(colour);
            let label = Label::new(text).selectable(false).extend();
            let inside = Rect::from_center_size(rect.center(), galley.size());
            self.ui.put(inside, label).hint(hint);
        }
    }

    /// Whether there is room only for the most important names.
    pub fn is_small(&self) -> bool {
        self.rect.size().min_elem() < SMALL
    }
}
