//! Messages and progress over the picture.

use super::{prelude::*, shown::Shown};
use crate::viewer::{
    model::EmptiedBy,
    ui::{
        menus::item_of,
        notice::{Kind, Notices},
    },
};
use egui::{Area, Context, Frame, Id, LayerId, Pos2, ProgressBar};

/// The plate of the hint where there is nothing to see.
const HINT: &str = "hint";

/// Whether a layer is that plate.
pub(in crate::viewer::ui) fn is_hint(layer: LayerId) -> bool {
    layer.id == Id::unique(HINT)
}

/// A plate over the picture, whose corner or middle is at a point of the window.
pub(super) fn plate(ctx: &Context, name: &str, at: Pos2, of: Align2, inside: impl FnOnce(&mut Ui)) {
    let area = Area::new(Id::unique(name)).fixed_pos(at).pivot(of);
    area.show(ctx, |ui| Frame::popup(ui.style()).show(ui, inside));
}

/// Messages at the top, `below` points down, progress at the bottom, and a hint where there is nothing to see.
pub(super) fn show(
    ui: &mut Ui,
    rect: Rect,
    below: f32,
    shown: &mut Shown,
    commands: &mut Vec<Command>,
) {
    let ctx = ui.ctx().clone();
    Area::new(Id::unique("notices"))
        .fixed_pos(rect.left_top() + vec2(10.0, 10.0 + below))
        .show(&ctx, |ui| {
            ui.set_max_width((rect.width() - 20.0).max(100.0));
            notices(ui, shown.notices);
        });
    if let Some((what, fraction)) = shown.underway {
        let at = rect.center_bottom() - vec2(0.0, 40.0);
        plate(&ctx, "progress", at, Align2::CENTER_BOTTOM, |ui| {
            ui.horizontal(|ui| {
                let bar = ProgressBar::new(fraction.unwrap_or(1.0));
                let bar = bar.animate(fraction.is_none());
                ui.add(bar.desired_width(220.0).text(what));
                if fraction.is_some() {
                    ui.button("Cancel").asks("(Esc)", Command::Escape, commands);
                }
            });
        });
    } else if let Some((text, [button, does], asked)) = hint(shown.state) {
        plate(&ctx, HINT, rect.center(), Align2::CENTER_CENTER, |ui| {
            ui.vertical_centered(|ui| {
                ui.label(text).hint("why the picture is empty");
                let button = ui.button(button).hint(does);
                if button.clicked() {
                    commands.extend(asked);
                }
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
        let text = format!("Dismiss all ({earlier} earlier)");
        if ui.button(text).hint("remove every message").clicked() {
            return notices.clear();
        }
    }
    let mut dismissed = None;
    for (index, notice) in notices.iter().enumerate().skip(earlier) {
        Frame::popup(ui.style()).show(ui, |ui| {
            ui.horizontal(|ui| {
                let dismiss = ui.button("\u{d7}").named("dismiss");
                if dismiss.hint("dismiss").clicked() {
                    dismissed = Some(index);
                }
                let visuals = ui.visuals();
                let (colour, what) = match notice.kind {
                    Kind::Done { .. } => (visuals.text_color(), "done"),
                    Kind::Warning => (visuals.warn_fg_color, "a warning"),
                    Kind::Error(_) => (visuals.error_fg_color, "an error"),
                };
                let goes = if notice.stays() {
                    "the cross dismisses it, and so does Esc"
                } else {
                    "this message goes away by itself"
                };
                let text = RichText::new(&notice.text).color(colour);
                ui.add(Label::new(text).wrap())
                    .hint(format!("{what}: {goes}"));
            });
        });
    }
    if let Some(index) = dismissed {
        notices.remove(index);
    }
}

/// Why the picture is empty, the name and the hint of a button that helps, and what that does.
fn hint(state: &State) -> Option<(&'static str, [String; 2], Vec<Command>)> {
    if state.scene().objects().is_empty() {
        let open = Command::OpenDialog;
        return Some(("Open an OBJ or scene file", as_in_menus(&open), vec![open]));
    }
    if state.scene().visible_bounds().is_empty() {
        let show = Command::Act(Action::ShowAll);
        return Some(("Everything is hidden", as_in_menus(&show), vec![show]));
    }
    // The four views show what the camera does not see.
    if !state.stages().is_empty() {
        return None;
    }
    let (by, actions) = state.emptied()?;
    let by_section = "Nothing in view: the section cuts everything away";
    let by_planes = "Nothing in view: no object is between near and far";
    let frame_all = as_in_menus(&Action::FrameAll.into());
    let own = |name: &str, hint: &str| [name, hint].map(str::to_owned);
    let (text, button) = match by {
        EmptiedBy::Section => {
            let button = own("Section off (Z)", "show what the section cuts away, too");
            (by_section, button)
        }
        EmptiedBy::Planes => {
            let hint = "move the planes so that they hold all that shows";
            (by_planes, own("Fit near and far", hint))
        }
        EmptiedBy::Pose => ("Nothing in view", frame_all),
        EmptiedBy::Distance => ("The scene is smaller than two pixels here", frame_all),
    };
    let actions = actions.into_iter().chain([Action::Release]);
    Some((text, button, actions.map(Command::Act).collect()))
}

/// The name, with its key, and the hint of a command's item in the menus.
fn as_in_menus(command: &Command) -> [String; 2] {
    item_of(command).map_or_else(Default::default, |item| {
        let name = format!("{} ({})", item.name, item.first_keys());
        [name, item.hint.to_owned()]
    })
}
