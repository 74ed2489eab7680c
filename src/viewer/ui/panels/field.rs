//! A field for a number. Text that is no valid value is red and says why; the last valid value stays in force.

use super::{hints::described, prelude::*};
use crate::geometry::range;
use egui::{
    Context, Id, Key, Modifiers, TextEdit, text::CCursorRange, text_edit::TextEditState,
    util::IdTypeMap,
};

/// Typed text whose number is not in force: it is refused, or not confirmed yet. It is forgotten when its field is
/// about something else, or is gone.
#[derive(Clone, Default)]
struct Typed {
    text: String,
    /// The last pass in which the field showed.
    shown: u64,
}

/// The last pass in which a field without the focus showed red text.
#[derive(Clone, Copy)]
struct Refused(u64);

/// Gives up every red text. Returns whether there was one.
pub(in crate::viewer::ui) fn give_up_refused(ctx: &Context) -> bool {
    let pass = ctx.cumulative_pass_nr();
    let last = ctx.data(|data| data.get_temp(refused_id()));
    let was = last.is_some_and(|Refused(at)| at == pass);
    if was {
        ctx.data_mut(IdTypeMap::remove_by_type::<Typed>);
        ctx.request_repaint();
    }
    was
}

fn refused_id() -> Id {
    Id::unique("refused")
}

/// Between a field's frame and its text, in points.
const MARGIN: Vec2 = vec2(3.0, 2.0);

/// Height in points of the line that says what stays in force.
const STILL: f32 = 16.0;

/// Names of axes.
pub(super) const AXES: [&str; 3] = ["x", "y", "z"];

/// A field and how it is shown.
pub(super) struct Field<'a> {
    name: &'a str,
    hint: &'a str,
    of: u64,
    width: f32,
    value: f64,
}

impl<'a> Field<'a> {
    /// A field with its name, what its number is in a few words, its width in points, and the number in force. `of`
    /// identifies what the number belongs to: text that was typed for one thing does not show for another.
    pub fn new(name: &'a str, hint: &'a str, of: u64, width: f32, value: f64) -> Self {
        Self {
            name,
            hint,
            of,
            width,
            value,
        }
    }

    /// Shows the field. An arrow key adds or subtracts `step`; with Shift, ten times as much. Returns the typed number
    /// once Enter or leaving the field confirms it and `check` accepts it, or the number that the arrow keys step to.
    /// Esc gives up. Invalid text is red, with the reason and with what stays in force.
    pub fn show<E: ToString>(
        &self,
        ui: &mut Ui,
        step: f64,
        check: impl Fn(f64) -> Result<(), E>,
    ) -> Option<f64> {
        let (id, value) = (ui.scope_id().with((self.name, self.of)), self.value);
        let shown = self.written(ui, value);
        let pass = ui.ctx().cumulative_pass_nr();
        let typed = ui.data(|data| data.get_temp::<Typed>(id));
        let typed = typed.filter(|typed| typed.shown + 1 >= pass);
        let mut text = (typed.as_ref()).map_or_else(|| shown.clone(), |typed| typed.text.clone());
        let parse = |text: &str| {
            let number = parse(text, value, &shown)?;
            check(number).map_err(|error| error.to_string())?;
            Ok::<_, String>(number)
        };
        if ui.memory(|memory| memory.has_focus(id))
            && let Ok(from) = parse(&text)
            && let Some(steps) = steps(ui)
            && check(from + steps * step).is_ok()
        {
            let stepped = from + steps * step;
            forget(ui, id);
            self.edit(ui, id, &mut self.written(ui, stepped), None);
            return Some(stepped);
        }
        let parsed = parse(&text);
        let wrong = parsed.as_ref().err();
        let wrong = wrong.map(|reason| format!("{reason}; {shown} stays in force"));
        let was_typed = typed.is_some();
        // Only below a field without the focus, so that nothing moves while the user types.
        let still = (wrong.as_ref()).filter(|_| !ui.memory(|memory| memory.has_focus(id)));
        let reason = parsed.as_ref().err();
        let height = ui.spacing().interact_size.y + if still.is_some() { STILL } else { 0.0 };
        let below = Layout::top_down(Align::Min);
        let response = ui.allocate_ui_with_layout(vec2(self.width, height), below, |ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            let response = self.edit(ui, id, &mut text, wrong.as_deref());
            if let Some(wrong) = still {
                ui.data_mut(|data| data.insert_temp(refused_id(), Refused(pass)));
                let red = ui.visuals().error_fg_color;
                let reason = RichText::new(reason.map_or("", String::as_str));
                ui.add(Label::new(reason.size(11.0).color(red)).wrap());
                let still = RichText::new(format!("still {shown}")).size(11.0);
                ui.add(Label::new(still).truncate()).on_hover_text(wrong);
            }
            response
        });
        let response = response.inner;
        if was_typed || response.changed() {
            ui.data_mut(|data| data.insert_temp(id, Typed { text, shown: pass }));
        }
        let given_up = ui.input(|input| input.key_pressed(Key::Escape))
            && (response.has_focus() || response.lost_focus());
        // Refused text may be valid by now: it is dropped, and its number is not used.
        let is_left = was_typed && !response.has_focus() && parsed.is_ok();
        if given_up || is_left {
            forget(ui, id);
        }
        let is_entered = is_left && response.lost_focus() && !given_up;
        parsed.ok().filter(|_| is_entered)
    }

    /// A number as the field has room for it: one that is cut off would read as another.
    fn written(&self, ui: &Ui, value: f64) -> String {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a few characters"
        )]
        let room = ((self.width - 2.0 * MARGIN.x) / char_width(ui)).max(0.0) as usize;
        short_in(value, room.clamp(LEAST, DIGITS))
    }

    fn edit(&self, ui: &mut Ui, id: Id, text: &mut String, wrong: Option<&str>) -> Response {
        let red = ui.visuals().error_fg_color;
        let mut edit = TextEdit::singleline(text)
            .id(id)
            .font(FontId::monospace(11.0))
            .align(Align2::LEFT_CENTER)
            .margin(MARGIN);
        if wrong.is_some() {
            edit = edit.text_color(red);
        }
        let height = ui.spacing().interact_size.y;
        let response = ui.add_sized([self.width, height], edit);
        let is_tabbed = response.gained_focus() && !response.is_pointer_button_down_on();
        if is_tabbed || response.double_clicked() {
            select_all(ui, id, text);
        }
        let response = response.named(self.name);
        let Some(wrong) = wrong else {
            return response.hint(format!("{}; exactly {}", self.hint, self.value));
        };
        described(&response, wrong);
        let text = RichText::new(wrong).color(red);
        if response.has_focus() {
            response.show_tooltip_text(text);
            return response;
        }
        response.on_hover_text(text)
    }
}

/// How many steps up the arrow keys ask for.
fn steps(ui: &Ui) -> Option<f64> {
    let count = |modifiers, key| {
        let times = ui.input_mut(|input| input.count_and_consume_key(modifiers, key));
        u32::try_from(times).map_or(0.0, f64::from)
    };
    let steps = |modifiers| count(modifiers, Key::ArrowUp) - count(modifiers, Key::ArrowDown);
    let by = 10.0 * steps(Modifiers::SHIFT) + steps(Modifiers::NONE);
    (by != 0.0).then_some(by)
}

/// What is typed next replaces the text.
fn select_all(ui: &Ui, id: Id, text: &str) {
    let mut edit = TextEditState::load(ui.ctx(), id).unwrap_or_default();
    let all = CCursorRange::select_all_str(text);
    edit.cursor.set_char_range(Some(all));
    edit.store(ui.ctx(), id);
}

fn forget(ui: &Ui, id: Id) {
    ui.data_mut(|data| data.remove_temp::<Typed>(id));
}

/// The number in the field; `value` itself, with all its digits, while the text is unchanged.
fn parse(text: &str, value: f64, shown: &str) -> Result<f64, String> {
    if text == shown {
        return Ok(value);
    }
    let text = text.trim();
    let number = text.parse::<f64>();
    let number = number.map_err(|_| format!("\u{201c}{text}\u{201d} is not a number"))?;
    let is_in_range = range::stored(number).is_some();
    is_in_range
        .then_some(number)
        .ok_or_else(|| "it must be a number up to 1.29e33".into())
}

/// Width of a field in points that shows as many digits as [`short`] gives.
pub(super) const WIDTH: f32 = 72.0;

/// A value as panels show it: digits align in columns, and a point with all its digits fits on a line.
pub(super) fn value_text(text: impl Into<String>) -> RichText {
    RichText::new(text).monospace().size(11.0)
}

/// How wide a text is on one line, in points.
pub(super) fn text_width(ui: &Ui, text: &str, font: &FontId) -> f32 {
    let galley = (ui.painter()).layout_no_wrap(text.to_owned(), font.clone(), Color32::WHITE);
    galley.size().x
}

/// Width in points of each character of a [`value_text`].
pub(super) fn char_width(ui: &Ui) -> f32 {
    ui.fonts_mut(|fonts| fonts.glyph_width(&FontId::monospace(11.0), '0'))
}

/// The fewest characters that show a number's size and sign.
pub(super) const LEAST: usize = 6;

/// The most characters of a number as [`short`] writes it.
pub(super) const DIGITS: usize = 9;

/// Up to six significant digits, as many as fit in [`DIGITS`] characters: enough to read, and a changing number moves
/// nothing. The field keeps all digits.
pub(super) fn short(value: f64) -> String {
    short_in(value, DIGITS)
}

/// The same, but in this many characters: at least [`LEAST`].
pub(super) fn short_in(value: f64, most: usize) -> String {
    let mut tries = (1..=6).rev().map(|digits| rounded(value, digits, most));
    let fits = tries.find(|text| text.len() <= most);
    fits.unwrap_or_else(|| match value.abs() {
        // Too small to fit: its exponent has three digits.
        ..1.0 => "0".into(),
        _ => format!("{value:.0e}"),
    })
}

/// The number, rounded to this many significant digits; as a power of ten if it would be longer than `most` otherwise.
fn rounded(value: f64, digits: usize, most: usize) -> String {
    if value == 0.0 {
        return "0".into();
    }
    if !value.is_finite() {
        return value.to_string();
    }
    let exponent = libm::log10(value.abs()).floor();
    let room = u8::try_from(most).map_or(f64::INFINITY, f64::from);
    let plain = (3.0 - room).max(-4.0)..room.min(9.0) - 1.0;
    if !plain.contains(&exponent) {
        let text = format!("{value:.*e}", digits - 1);
        let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        return format!("{}e{exponent}", trimmed(mantissa));
    }
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "clamped"
    )]
    let decimals = (digits as f64 - 1.0 - exponent).clamp(0.0, 10.0) as usize;
    trimmed(&format!("{value:.decimals$}")).to_owned()
}

fn trimmed(text: &str) -> &str {
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        text
    }
}
