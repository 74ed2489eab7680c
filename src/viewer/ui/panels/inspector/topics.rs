//! The inspector from top to bottom: which topics there are, and what unfolds them.

use super::{
    arrangement::{Arrangement, Topic},
    camera, depth_steps, details, measure, model_matrix,
    picked::{self, Sums},
    pipeline,
    prelude::*,
    section, working,
};

/// What is picked has a fixed height. A topic that unfolds moves only what is below it.
pub(in crate::viewer::ui::panels) fn show(
    ui: &mut Ui,
    state: &State,
    (arrangement, sums): (&mut Arrangement, &mut Sums),
    commands: &mut Vec<Command>,
) {
    picked::show(ui, state, sums, commands);
    for topic in Topic::ALL
        .into_iter()
        .filter(|topic| is_there(*topic, state))
    {
        ui.separator();
        let from = ui.cursor().top();
        heading(ui, topic, arrangement, commands);
        if arrangement.unfolded.contains(&topic) {
            ui.push_id(topic.name(), |ui| match topic {
                Topic::Camera => camera::show(ui, state, commands),
                Topic::Placement => model_matrix::show(ui, state, commands),
                Topic::Details => details::show(ui, state, commands),
                Topic::WorkedOut => working::show(ui, state, commands),
                Topic::Matrices => pipeline::show(ui, state, commands),
                Topic::Measure => measure::show(ui, state, commands),
                Topic::Section => section::show(ui, state, commands),
                Topic::DepthBuffer => depth_steps::show(ui, state, commands),
            });
        }
        if arrangement.revealed == Some(topic) {
            arrangement.revealed = None;
            let (content, seen) = (ui.min_rect(), ui.clip_rect());
            // The heading stays in view.
            let below = (content.bottom() - seen.bottom()).min(from - seen.top());
            let by = below.max(0.0) - (seen.top() - from).max(0.0);
            if by != 0.0 {
                arrangement.scroll_to = Some(seen.top() - content.top() + by);
                ui.ctx().request_discard("a topic comes into view");
            }
        }
    }
}

/// Scenes of the gallery stay as they are: nothing is measured or cut there.
fn is_there(topic: Topic, state: &State) -> bool {
    !matches!(topic, Topic::Measure | Topic::Section) || state.showing().is_none()
}

/// A topic's heading, which folds it and unfolds it.
fn heading(ui: &mut Ui, topic: Topic, arrangement: &mut Arrangement, commands: &mut Vec<Command>) {
    let is_unfolded = arrangement.unfolded.contains(&topic);
    ui.horizontal(|ui| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if topic == Topic::Camera {
                camera::copy(ui, commands);
            }
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                let mark = if is_unfolded { "\u{23f7}" } else { "\u{23f5}" };
                let text = RichText::new(format!("{mark} {}", topic.name())).heading();
                let heading = ui.add(Button::new(text).frame(false).truncate());
                if heading.named(topic.name()).hint(topic.about()).clicked() {
                    arrangement.toggle(topic);
                }
            });
        });
    });
}
