//! The tour's step, in a strip below picture and panels, and the offer of the tour to a new user.

use super::hints::{Hint, named};
use crate::viewer::{
    model::State,
    ui::{
        command::{Command, TourMove},
        tour::{Step, Tour},
    },
};
use egui::{
    Align, Align2, Area, Button, Color32, Frame, Id, Layout, Panel, Rect, RichText, ScrollArea,
    TextStyle, Ui, Vec2, vec2,
};

/// The gaps between the offer and the picture's corner, in points. The grid's step stands below the offer.
const MARGIN: Vec2 = vec2(12.0, 28.0);
/// The gap between two paragraphs, in points.
const GAP: f32 = 3.0;
/// The strip takes no more than this share of the window's height: what is longer scrolls. More would leave no room for
/// panels in a small window, of which the picture keeps half.
const MOST: f32 = 0.2;
/// Marks a step that is done.
const TICK: &str = "\u{2714}";

/// Shows the present step. The strip has the height of the longest step, so that the picture keeps its size.
pub(super) fn strip(ui: &mut Ui, tour: Tour, state: &State, commands: &mut Vec<Command>) {
    let window = ui.ctx().content_rect().size();
    let style = ui.style();
    let frame = Frame::side_top_panel(style);
    let buttons = style.spacing.interact_size.y + style.spacing.item_spacing.y;
    let width = window.x - frame.total_margin().sum().x - style.spacing.scroll.bar_width;
    let steps = Tour::steps().map(|step| height(ui, step, state, width));
    let margin = frame.total_margin().sum().y;
    let wanted = margin + buttons + steps.fold(0.0, f32::max);
    Panel::bottom("tour")
        .exact_size(wanted.min(MOST * window.y))
        .resizable(false)
        .frame(frame)
        .show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = GAP;
            ui.horizontal(|ui| bar(ui, tour, state, commands));
            let (_, _, step) = tour.step();
            ScrollArea::vertical()
                .id_salt(step.task)
                .min_scrolled_height(0.0)
                .auto_shrink(false)
                .show(ui, |ui| text(ui, step, state));
        });
}

/// How high a step's text is, in points.
fn height(ui: &Ui, step: &Step, state: &State, width: f32) -> f32 {
    let font = TextStyle::Body.resolve(ui.style());
    let now = step.now(state).unwrap_or_default();
    let paragraphs = [step.task, step.why, &now].into_iter();
    let heights = paragraphs.filter(|text| !text.is_empty()).map(|text| {
        let painter = ui.painter();
        let galley = painter.layout(text.to_owned(), font.clone(), Color32::WHITE, width);
        galley.size().y + GAP
    });
    heights.sum()
}

fn text(ui: &mut Ui, step: &Step, state: &State) {
    ui.label(RichText::new(step.task).strong())
        .hint("what to do now: the window notices when it is done");
    if let Some(now) = step.now(state) {
        ui.label(RichText::new(now).strong().italics())
            .hint("with the view in this window now");
    }
    ui.label(step.why).hint("why");
}

/// Chapter and number of the step, and where to go from it.
fn bar(ui: &mut Ui, tour: Tour, state: &State, commands: &mut Vec<Command>) {
    let (number, chapter, _) = tour.step();
    let (count, behind) = tour.progress();
    let mut asked = None;
    let mut go = |ui: &mut Ui, enabled: bool, text: RichText, hint: &str, to| {
        let button = ui.add_enabled(enabled, Button::new(text)).hint(hint);
        if button.clicked() {
            asked = Some(to);
        }
        button
    };
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        let end = go(
            ui,
            true,
            "\u{d7}".into(),
            "end the tour: Help begins it again",
            TourMove::End,
        );
        named(&end, "end the tour");
        let next = match (tour.is_done, behind + 1 == count) {
            (false, _) => RichText::new("skip"),
            (true, false) => RichText::new("next").strong(),
            (true, true) => RichText::new("finish").strong(),
        };
        go(ui, true, next, "to the next step", TourMove::Next);
        let (back, hint) = ("back".into(), "to the step before");
        go(ui, behind > 0, back, hint, TourMove::Back);
        if tour.is_done {
            let done = RichText::new(TICK).color(ui.visuals().hyperlink_color);
            named(&ui.label(done.size(18.0)).hint("done"), "step done");
        }
        if !state.is_demo() && state.showing().is_none() {
            let demo = ui.button("open the demo");
            if demo.hint("the tour's steps are about the demo").clicked() {
                commands.push(Command::Open(Vec::new()));
            }
        }
        ui.weak(format!("step {} of {count}", behind + 1))
            .hint("counted over all chapters");
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            let title = RichText::new(format!("{number}  {}", chapter.title)).strong();
            ui.add(egui::Label::new(title).truncate())
                .hint("the tour's chapter");
        });
    });
    commands.extend(asked.map(Command::Tour));
}

/// Offers the tour, in the lower right corner of the picture.
pub(super) fn offer(ui: &Ui, rect: Rect, commands: &mut Vec<Command>) {
    Area::new(Id::unique("tour offer"))
        .fixed_pos(rect.right_bottom() - MARGIN)
        .pivot(Align2::RIGHT_BOTTOM)
        .show(ui.ctx(), |ui| {
            Frame::popup(ui.style()).show(ui, |ui| {
                ui.horizontal(|ui| {
                    ui.label("New here?")
                        .hint("this is shown until you have answered");
                    if ui.button("Take the tour").hint(ABOUT).clicked() {
                        commands.push(Command::Tour(TourMove::Begin));
                    }
                    let no = ui.button("\u{d7}").hint("no: Help offers it again");
                    named(&no, "no tour");
                    if no.clicked() {
                        commands.push(Command::Tour(TourMove::End));
                    }
                });
            });
        });
}

/// What the tour is.
pub(super) const ABOUT: &str =
    "cameras and raycasting in this window, step by step: about ten minutes";
