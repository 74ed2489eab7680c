//! What the numbers of a worked pick are, in the picture and in the four views: faint, and bright while the cursor is
//! on the number or on its mark.

use super::prelude::*;
use crate::{
    camera::View,
    look,
    viewer::{
        model::{Stage, WorkedMark, WorkedNumber, WorkedRow},
        ui::theme::rimmed,
    },
};
use egui::{Painter, Pos2, Shape};

/// How near the cursor must be to a dot or a line, in points.
const REACH: f32 = 7.0;
/// How opaque marks are that the cursor is not on.
const FAINT: f32 = 0.5;

/// Where a line of the world shows, as positions in the window.
type Seen<'a> = &'a dyn Fn([DVec3; 2]) -> Option<[Pos2; 2]>;

/// In the camera's picture. From where the click was made, the way to the pixel is seen end-on: there only what the
/// cursor is on shows.
pub(super) fn in_picture(
    ui: &mut Ui,
    rect: Rect,
    place: SceneRect,
    state: &State,
    commands: &mut Vec<Command>,
) {
    let view = state.view();
    let seen = |ends: [DVec3; 2]| {
        let ends = view.project_segment(ends[0], ends[1])?;
        Some(ends.map(|end| place.to_position(end)))
    };
    show(ui, rect, state, state.frozen().is_some(), &seen, commands);
}

/// In one of the four views, which is drawn through `seen`.
pub(super) fn in_pane(
    ui: &mut Ui,
    stage: Stage,
    rect: Rect,
    place: SceneRect,
    state: &State,
    seen: &View,
    commands: &mut Vec<Command>,
) {
    if stage == Stage::Object && state.pane_object() != state.selected() {
        return;
    }
    let at = |ends: [DVec3; 2]| {
        let [from, to] = match stage {
            Stage::Ndc => state.ndc().drawn_segment(ends)?,
            Stage::Object => {
                let object = &state.scene().objects()[state.pane_object()?];
                ends.map(|end| object.placement.point_to_object(end))
            }
            Stage::World | Stage::View => ends,
        };
        let ends = seen.project_segment(from, to)?;
        let ends = ends.map(|end| place.to_position(end));
        ends.iter().all(|end| end.is_finite()).then_some(ends)
    };
    show(ui, rect, state, true, &at, commands);
}

fn show(
    ui: &mut Ui,
    rect: Rect,
    state: &State,
    faint: bool,
    seen: Seen,
    commands: &mut Vec<Command>,
) {
    let steps = state.worked_steps();
    // What is found last lies over what it was found from.
    let rows: Vec<&WorkedRow> = steps.iter().flat_map(|step| &step.rows).rev().collect();
    let painter = ui.painter().with_clip_rect(rect);
    let lit = state.worked_number();
    let is_free = ui.rect_contains_pointer(rect) && !ui.ctx().egui_is_using_pointer();
    let cursor = ui.ctx().pointer_hover_pos().filter(|_| is_free);
    let mut nearest: Option<(f32, WorkedNumber)> = None;
    for row in &rows {
        for mark in &row.marks {
            let mark = Mark { mark, seen };
            if faint && row.number.is_drawn() {
                mark.draw(&painter, color32(look::HIT).gamma_multiply(FAINT), 1.0);
            }
            let away = cursor.and_then(|at| mark.away(at, row.number));
            if let Some(away) = away
                && nearest.is_none_or(|(least, _)| away < least)
            {
                nearest = Some((away, row.number));
            }
        }
    }
    if let Some((_, number)) = nearest {
        commands.push(Command::Act(Action::LightNumber(number)));
    }
    if let Some(row) = rows.iter().find(|row| Some(row.number) == lit) {
        for mark in &row.marks {
            Mark { mark, seen }.draw(&painter, Color32::WHITE, 3.0);
        }
        let mark = row.marks.first();
        let at = mark.and_then(|mark| Mark { mark, seen }.label());
        if let Some(at) = at.filter(|at| rect.contains(*at)) {
            name(&painter, at, row.formula);
        }
    }
}

impl WorkedNumber {
    /// Whether it shows without the cursor on it: the few by which a picture of the working is read.
    fn is_drawn(self) -> bool {
        matches!(
            self,
            Self::Middle
                | Self::Upward
                | Self::Rightward
                | Self::PlanePoint
                | Self::Root(_)
                | Self::Through(_)
                | Self::Share(_)
                | Self::Normal
                | Self::T
        )
    }
}

/// What a number is, and where it shows.
struct Mark<'a> {
    mark: &'a WorkedMark,
    seen: Seen<'a>,
}

impl Mark<'_> {
    fn at(&self, point: DVec3) -> Option<Pos2> {
        (self.seen)([point; 2]).map(|[at, _]| at)
    }

    /// The sides of an area that show.
    fn sides(&self, corners: &[DVec3]) -> Vec<[Pos2; 2]> {
        let next = corners.iter().cycle().skip(1);
        let sides = corners.iter().zip(next);
        sides
            .filter_map(|(from, to)| (self.seen)([*from, *to]))
            .collect()
    }

    fn draw(&self, painter: &Painter, colour: Color32, width: f32) {
        let line = |ends: [Pos2; 2]| {
            for (colour, more) in rimmed(colour) {
                painter.line_segment(ends, Stroke::new(width + more, colour));
            }
        };
        match self.mark {
            WorkedMark::Dot(at) => {
                if let Some(at) = self.at(*at) {
                    let edge = Stroke::new(1.0, Color32::from_black_alpha(200));
                    painter.circle(at, 2.0 + width, colour, edge);
                }
            }
            WorkedMark::Line(ends) => {
                if let Some(ends) = (self.seen)(*ends) {
                    line(ends);
                }
            }
            WorkedMark::Arrow(ends) => {
                if let Some([from, to]) = (self.seen)(*ends) {
                    line([from, to]);
                    let along = (to - from).normalized();
                    let back = to - (6.0 + width) * along;
                    let aside = (3.0 + width) * along.rot90();
                    let head = vec![to, back + aside, back - aside];
                    painter.add(Shape::convex_polygon(head, colour, Stroke::NONE));
                }
            }
            WorkedMark::Area(corners) => {
                let sides = self.sides(corners);
                if sides.len() == corners.len() && width > 1.0 {
                    let fill = colour.gamma_multiply(0.28);
                    let corners = sides.iter().map(|[from, _]| *from).collect();
                    painter.add(Shape::convex_polygon(corners, fill, Stroke::NONE));
                }
                for side in sides {
                    painter.line_segment(side, Stroke::new(width.min(2.0), colour));
                }
            }
        }
    }

    /// How far the cursor is from it, in points: dots come before lines, and lines before the areas of a triangle. `None`
    /// beyond reach. Other areas are larger than what one points at.
    fn away(&self, cursor: Pos2, number: WorkedNumber) -> Option<f32> {
        let within = |away: f32| (away <= REACH).then_some(away);
        match self.mark {
            WorkedMark::Dot(at) => within(self.at(*at)?.distance(cursor)),
            WorkedMark::Line(ends) | WorkedMark::Arrow(ends) => {
                let ends = (self.seen)(*ends)?;
                let away = nearest_on(ends, cursor).distance(cursor);
                within(away).map(|away| REACH + away)
            }
            WorkedMark::Area(corners) => {
                let sides = self.sides(corners);
                let is_one = matches!(number, WorkedNumber::Share(_));
                let is_in = is_one && sides.len() == corners.len() && contains(&sides, cursor);
                is_in.then_some(3.0 * REACH)
            }
        }
    }

    /// Where its name begins.
    fn label(&self) -> Option<Pos2> {
        match self.mark {
            WorkedMark::Dot(at) => self.at(*at),
            WorkedMark::Line(ends) | WorkedMark::Arrow(ends) => {
                (self.seen)(*ends).map(|[from, to]| from + 0.5 * (to - from))
            }
            WorkedMark::Area(corners) => {
                let sides = self.sides(corners);
                let points: Vec<Pos2> = sides.into_iter().map(|[from, _]| from).collect();
                (!points.is_empty()).then(|| Rect::from_points(&points).center())
            }
        }
    }
}

/// The point of a line that is nearest to another.
fn nearest_on([from, to]: [Pos2; 2], at: Pos2) -> Pos2 {
    let along = to - from;
    let share = (at - from).dot(along) / along.length_sq();
    let share = if share.is_finite() {
        share.clamp(0.0, 1.0)
    } else {
        0.0
    };
    from + share * along
}

/// Whether a point lies within a convex area, by its sides one after the other.
fn contains(sides: &[[Pos2; 2]], at: Pos2) -> bool {
    let turns = sides.iter().map(|[from, to]| {
        let (along, off) = (*to - *from, at - *from);
        along.x * off.y - along.y * off.x
    });
    let turns: Vec<f32> = turns.collect();
    turns.iter().all(|turn| *turn >= 0.0) || turns.iter().all(|turn| *turn <= 0.0)
}

/// Writes a number's formula beside its mark.
fn name(painter: &Painter, at: Pos2, text: &str) {
    let font = FontId::proportional(13.0);
    let colour = of_words(painter.ctx(), Color32::WHITE);
    let galley = painter.layout_no_wrap(text.to_owned(), font, colour);
    let size = galley.size() + vec2(8.0, 2.0);
    let clip = painter.clip_rect();
    // Beside the mark, within the view.
    let corner = at + vec2(12.0, -size.y - 6.0);
    let most = clip.right_bottom() - size;
    let corner = pos2(
        corner.x.min(most.x).max(clip.left()),
        corner.y.min(most.y).max(clip.top()),
    );
    painter.rect_filled(
        Rect::from_min_size(corner, size),
        3.0,
        backing(painter.ctx(), 210),
    );
    painter.galley(corner + vec2(4.0, 1.0), galley, colour);
}
