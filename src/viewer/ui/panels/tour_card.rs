//! The tour's card, and what offers the tour to somebody new.

use super::names::{Hint, named};
use crate::viewer::{
    model::State,
    ui::{
        command::{Command, TourMove},
        tour::Tour,
    },
};
use egui::{Align2, Area, Context, Frame, Id, Rect, RichText, Ui, Window, vec2};

/// The card's width in points, where there is room for it.
const WIDTH: f32 = 380.0;
/// Between it and the picture's edge.
const MARGIN: f32 = 12.0;
/// As wide as the cross of axes in the corner, in points.
const CROSS: f32 = 104.0;
/// What is done, in dark and light looks.
const TICK: &str = "\u{2714}";

/// The present step, beside the cross of axes until it is dragged elsewhere.
pub(super) fn card(
    ctx: &Context,
    rect: Rect,
    tour: Tour,
    state: &State,
    commands: &mut Vec<Command>,
) {
    let (number, chapter, _) = tour.step();
    let mut open = true;
    Window::new(RichText::new(format!("{number}  {}", chapter.title)).strong())
        .id(Id::unique("tour"))
        .open(&mut open)
        .resizable(false)
        .pivot(Align2::LEFT_BOTTOM)
        .default_pos(rect.left_bottom() + vec2(CROSS, -MARGIN))
        .constrain_to(rect)
        .show(ctx, |ui| {
            ui.set_width(WIDTH.min(rect.width() - 4.0 * MARGIN).max(100.0));
            contents(ui, tour, state, commands);
        });
    if !open {
        commands.push(Command::Tour(TourMove::End));
    }
}

fn contents(ui: &mut Ui, tour: Tour, state: &State, commands: &mut Vec<Command>) {
    let (_, _, step) = tour.step();
    ui.label(RichText::new(step.task).strong())
        .hint("what to do now: the window notices");
    ui.label(step.why).hint("why");
    if let Some(example) = step.example(state) {
        ui.label(RichText::new(example).strong().italics())
            .hint("the same point through the matrix that is in use now");
    }
    let is_elsewhere = !state.is_demo() && state.showing().is_none();
    if is_elsewhere {
        let demo = ui.button("open the demo");
        if demo.hint("the tour speaks of what is in it").clicked() {
            commands.push(Command::Open(Vec::new()));
        }
    }
    ui.add_space(4.0);
    let (count, behind) = tour.progress();
    ui.horizontal(|ui| {
        let mut go = |ui: &mut Ui, enabled: bool, text: RichText, hint: &str, to| {
            if ui
                .add_enabled(enabled, egui::Button::new(text))
                .hint(hint)
                .clicked()
            {
                commands.push(Command::Tour(to));
            }
        };
        go(
            ui,
            behind > 0,
            "back".into(),
            "to the step before",
            TourMove::Back,
        );
        let is_last = behind + 1 == count;
        let next = match (tour.is_done, is_last) {
            (false, _) => RichText::new("skip"),
            (true, false) => RichText::new("next").strong(),
            (true, true) => RichText::new("finish").strong(),
        };
        go(ui, true, next, "to the next step", TourMove::Next);
        if tour.is_done {
            let done = RichText::new(TICK).color(ui.visuals().hyperlink_color);
            named(&ui.label(done.size(18.0)).hint("done"), "step done");
        }
        ui.weak(format!("step {} of {count}", behind + 1))
            .hint("in all chapters");
    });
}

/// Offers the tour, at the lower edge of the picture.
pub(super) fn offer(ctx: &Context, rect: Rect, commands: &mut Vec<Command>) {
    Area::new(Id::unique("tour offer"))
        .fixed_pos(rect.center_bottom() - vec2(0.0, MARGIN))
        .pivot(Align2::CENTER_BOTTOM)
        .show(ctx, |ui| {
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
