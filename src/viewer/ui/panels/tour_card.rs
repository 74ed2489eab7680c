//! The tour's step, in a strip below picture and panels, and the offer of the tour to a new user.

use super::{messages::plate, prelude::*};
use crate::viewer::ui::{
    command::TourMove,
    tour::{Step, Tour},
};
use egui::{Frame, Panel, ScrollArea, TextStyle};

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
        let galley = ui
            .painter()
            .layout(text.to_owned(), font.clone(), Color32::WHITE, width);
        galley.size().y + GAP
    });
    heights.sum()
}

fn text(ui: &mut Ui, step: &Step, state: &State) {
    let hint = "what to do now: the window notices when it is done";
    ui.strong(step.task).hint(hint);
    if let Some(now) = step.now(state) {
        let now = RichText::new(now).strong().italics();
        ui.label(now).hint("with the view in this window now");
    }
    ui.label(step.why).hint("why");
}

/// Chapter and number of the step, and where to go from it.
fn bar(ui: &mut Ui, tour: Tour, state: &State, commands: &mut Vec<Command>) {
    let (number, chapter, _) = tour.step();
    let (count, behind) = tour.progress();
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        let end = ui.button("\u{d7}").named("end the tour");
        let hint = "end the tour: Help begins it again";
        end.asks(hint, Command::Tour(TourMove::End), commands);
        let next = match (tour.is_done, behind + 1 == count) {
            (false, _) => RichText::new("skip"),
            (true, false) => RichText::new("next").strong(),
            (true, true) => RichText::new("finish").strong(),
        };
        let (next, hint) = (ui.button(next), "to the next step");
        next.asks(hint, Command::Tour(TourMove::Next), commands);
        let back = ui.add_enabled(behind > 0, Button::new("back"));
        let hint = "to the step before";
        back.asks(hint, Command::Tour(TourMove::Back), commands);
        if tour.is_done {
            let done = RichText::new(TICK).color(ui.visuals().hyperlink_color);
            ui.label(done.size(18.0)).named("step done").hint("done");
        }
        if !state.is_demo() && state.showing().is_none() {
            let hint = "the tour's steps are about the demo";
            ui.button("open the demo")
                .asks(hint, Command::Open(Vec::new()), commands);
        }
        ui.weak(format!("step {} of {count}", behind + 1))
            .hint("counted over all chapters");
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            let title = RichText::new(format!("{number}  {}", chapter.title)).strong();
            ui.add(Label::new(title).truncate())
                .hint("the tour's chapter");
        });
    });
}

/// Offers what to begin with, in the lower right corner of the picture.
pub(super) fn offer(ui: &Ui, rect: Rect, commands: &mut Vec<Command>) {
    let at = rect.right_bottom() - MARGIN;
    plate(ui.ctx(), "tour offer", at, Align2::RIGHT_BOTTOM, |ui| {
        ui.set_max_width(rect.width() - 4.0 * MARGIN.x);
        ui.horizontal_wrapped(|ui| {
            let hint = "this is shown until you have taken the tour or said no";
            ui.label("New here?").hint(hint);
            let open = ui.button("Open a file...");
            open.asks(OPENS, Command::OpenDialog, commands);
            let tour = ui.button("Take the tour");
            tour.asks(ABOUT, Command::Tour(TourMove::Begin), commands);
            let pick = ui.button("One pick in four spaces");
            pick.asks(ONE_PICK, Command::ShowOnePick, commands);
            let (no, hint) = (ui.button("\u{d7}"), "no: Learn offers both again");
            (no.named("no tour")).asks(hint, Command::Tour(TourMove::End), commands);
        });
    });
}

/// What opening does.
const OPENS: &str = "OBJ files, or a scene (TOML); or drop them on the window";
/// What the pick in four spaces is.
const ONE_PICK: &str =
    "half a minute: how this pixel's pick is computed, in object, world, view and NDC";
/// What the tour is.
pub(super) const ABOUT: &str =
    "cameras and raycasting in this window, step by step: about ten minutes";
