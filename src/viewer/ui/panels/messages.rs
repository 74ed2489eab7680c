//! Messages and progress over the picture.

use super::{
    banner,
    hints::{Hint, named},
    shown::{Shown, Underway},
};
use crate::viewer::{
    model::{Action, EmptiedBy, State},
    ui::{
        command::Command,
        notice::{Kind, Notices},
    },
};
use egui::{Align2, Area, Frame, Id, ProgressBar, Rect, RichText, Ui, vec2};

/// Messages at the top, progress at the bottom, and a hint where there is nothing to see.
pub(super) fn show(ui: &mut Ui, rect: Rect, shown: &mut Shown, commands: &mut Vec<Command>) {
    let ctx = ui.ctx().clone();
    let below = shown.state.method().map_or(0.0, |_| banner::HEIGHT);
    Area::new(Id::unique("notices"))
        .fixed_pos(rect.left_top() + vec2(10.0, 10.0 + below))
        .show(&ctx, |ui| {
            ui.set_max_width((rect.width() - 20.0).max(100.0));
            notices(ui, shown.notices);
        });
    if let Some(Underway {
        what,
        fraction,
        can_stop,
    }) = &shown.underway
    {
        let at = rect.center_bottom() - vec2(0.0, 40.0);
        Area::new(Id::unique("progress"))
            .fixed_pos(at)
            .pivot(Align2::CENTER_BOTTOM)
            .show(&ctx, |ui| {
                Frame::popup(ui.style()).show(ui, |ui| {
                    ui.horizontal(|ui| {
                        let bar = ProgressBar::new(fraction.unwrap_or(1.0));
                        let bar = bar.animate(fraction.is_none());
                        ui.add(bar.desired_width(220.0).text(*what));
                        if *can_stop && ui.button("cancel").hint("(Esc)").clicked() {
                            commands.push(Command::Escape);
                        }
                    });
                });
            });
    } else if let Some((text, button, asked)) = hint(shown.state) {
        Area::new(Id::unique("hint"))
            .fixed_pos(rect.center())
            .pivot(Align2::CENTER_CENTER)
            .show(&ctx, |ui| {
                Frame::popup(ui.style()).show(ui, |ui| {
                    ui.vertical_centered(|ui| {
                        ui.label(text).hint("why the picture is empty");
                        let button = ui.button(button).hint("a way to see something");
                        if button.clicked() {
                            commands.extend(asked);
                        }
                    });
                });
            });
    }
}

/// The newest messages. Reports of what was done go away by themselves; warnings and errors stay until they are
/// dismissed.
fn notices(ui: &mut Ui, notices: &mut Notices) {
    const SHOWN: usize = 5;
    let earlier = notices.len().saturating_sub(SHOWN);
    if earlier > 0 {
        let text = format!("dismiss all ({earlier} earlier)");
        let dismiss = ui.button(text).hint("remove every message");
        if dismiss.clicked() {
            return notices.clear();
        }
    }
    let mut dismissed = None;
    for (index, notice) in notices.iter().enumerate().skip(earlier) {
        Frame::popup(ui.style()).show(ui, |ui| {
            ui.horizontal(|ui| {
                let colour = match notice.kind {
                    Kind::Done { .. } => ui.visuals().text_color(),
                    Kind::Warning => ui.visuals().warn_fg_color,
                    Kind::Error(_) => ui.visuals().error_fg_color,
                };
                let dismiss = ui.button("\u{d7}").hint("dismiss");
                named(&dismiss, "dismiss");
                if dismiss.clicked() {
                    dismissed = Some(index);
                }
                let text = RichText::new(&notice.text).color(colour);
                let hint = match notice.kind {
                    Kind::Done { .. } => "done: this message goes away by itself",
                    Kind::Warning => "a warning: the cross dismisses it, and so does Esc",
                    Kind::Error(_) => "an error: the cross dismisses it, and so does Esc",
                };
                ui.add(egui::Label::new(text).wrap()).hint(hint);
            });
        });
    }
    if let Some(index) = dismissed {
        notices.remove(index);
    }
}

/// Why the picture is empty, the name of a button that helps, and what that does.
fn hint(state: &State) -> Option<(&'static str, &'static str, Vec<Command>)> {
    if state.scene().objects().is_empty() {
        let text = "Drop an OBJ or scene file here";
        return Some((text, "Open\u{2026} (Ctrl+O)", vec![Command::OpenDialog]));
    }
    if state.scene().visible_bounds().is_empty() {
        let show = Command::Act(Action::ShowAll);
        return Some(("Everything is hidden", "Show all (U)", vec![show]));
    }
    // The four views show what the camera does not see.
    if !state.stages().is_empty() {
        return None;
    }
    let (by, actions) = state.emptied()?;
    let (text, button) = match by {
        EmptiedBy::Section => (
            "Nothing in view: the section cuts everything away",
            "Section off (Z)",
        ),
        EmptiedBy::Planes => (
            "Nothing in view: no object is between near and far",
            "Fit near and far",
        ),
        EmptiedBy::Pose => ("Nothing in view", "Frame all (A)"),
    };
    let actions = actions.into_iter().chain([Action::Release]);
    Some((text, button, actions.map(Command::Act).collect()))
}
