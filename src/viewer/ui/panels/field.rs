//! A field for a number, which is typed, dragged or stepped. Text that is no valid value stays, in a red frame, and a
//! tooltip says why; the last valid value stays in force. Nothing beside the field moves.

use super::{hints::described, prelude::*, slide::Slide};
use crate::geometry::range;
use egui::{
    Context, Direction, DragValue, Id, InputState, Key, Modifiers, StrokeKind, UiBuilder,
    util::IdTypeMap,
};
use std::cell::RefCell;

/// Text that was refused. It is forgotten when its field is about something else, or is gone.
#[derive(Clone, Default)]
struct Refused {
    text: String,
    /// The last pass in which the field showed.
    shown: u64,
}

/// The last pass in which a field showed refused text.
#[derive(Clone, Copy)]
struct Last(u64);

/// What a field showed when it began to be edited.
#[derive(Clone)]
struct Began(String);

/// A drag: the number at its start, how far it went, and its last pass.
#[derive(Clone, Copy, Default)]
struct Drag {
    value: f64,
    px: f64,
    shown: u64,
}

/// The pass in which Esc gave up what was typed.
#[derive(Clone, Copy)]
struct GivenUp(u64);

/// Gives up every refused text. Returns whether there was one.
pub(in crate::viewer::ui) fn give_up_refused(ctx: &Context) -> bool {
    let pass = ctx.cumulative_pass_nr();
    let last = ctx.data(|data| data.get_temp(Id::unique("refused")));
    let was = last.is_some_and(|Last(at)| at == pass);
    if was {
        ctx.data_mut(IdTypeMap::remove_by_type::<Refused>);
        ctx.request_repaint();
    }
    was
}

/// Between a field's frame and its text, in points.
const MARGIN: f32 = 3.0;

/// Names of axes.
pub(super) const AXES: [&str; 3] = ["x", "y", "z"];

/// A field and how it is shown.
pub(super) struct Field<'a> {
    name: &'a str,
    hint: &'a str,
    of: u64,
    width: f32,
    value: f64,
    by_factors: bool,
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
            by_factors: false,
        }
    }

    /// Drags multiply the number in place of adding to it.
    pub fn by_factors(mut self, by_factors: bool) -> Self {
        self.by_factors = by_factors;
        self
    }

    /// Shows the field. Each point of a drag adds `step`, or a hundredth of the number; the upper arrow key adds `step`;
    /// with Shift, ten times as much. Returns the new number if `check` accepts it: as it is dragged or stepped, or once
    /// Enter or leaving the field confirms what is typed. Esc gives up what is typed.
    pub fn show<E: ToString>(
        &self,
        ui: &mut Ui,
        step: f64,
        slide: &mut Slide,
        check: impl Fn(f64) -> Result<(), E>,
    ) -> Option<f64> {
        let (value, pass) = (self.value, ui.ctx().cumulative_pass_nr());
        let shown = self.written(ui, value);
        let key = ui.scope_id().with((self.name, self.of));
        let refused = ui.data(|data| data.get_temp::<Refused>(key));
        let refused = refused.filter(|refused| refused.shown + 1 >= pass);
        // The number may be shown shorter by now than where it began to be edited.
        let began = ui.data(|data| data.get_temp::<Began>(key));
        let began = began.map_or_else(|| shown.clone(), |Began(text)| text);
        let judge = |text: &str| {
            let number = parse(text, value, &began)?;
            check(number).map_err(|error| error.to_string())?;
            Ok::<_, String>(number)
        };
        // Refused text may be valid by now: it is dropped, and its number is not used.
        let reason = refused
            .as_ref()
            .and_then(|refused| judge(&refused.text).err());
        let refused = refused.map(|refused| refused.text);
        let refused = refused.filter(|_| reason.is_some());

        // egui tells of the lost focus in two passes, and of Esc in the first of them alone.
        let given_up = ui.data(|data| data.get_temp::<GivenUp>(key));
        let was_given_up = given_up.is_some_and(|GivenUp(at)| at + 1 == pass);
        let typed = RefCell::new(None);
        let text = refused.as_deref().unwrap_or(&shown);
        let mut number = value;
        let drag = DragValue::new(&mut number)
            // Its own steps are rounded to decimal places, which tiny scenes do not have.
            .speed(0.0)
            .update_while_editing(false)
            .clip_text(true)
            .custom_formatter(|_, _| text.to_owned())
            .custom_parser(|text| {
                let judged = judge(text);
                let number = judged.as_ref().ok().copied();
                typed.replace(Some((text.to_owned(), judged.is_err())));
                number.filter(|_| !was_given_up)
            });
        // Text that is too long is cut, and moves nothing.
        let size = vec2(self.width, ui.spacing().interact_size.y);
        let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
        let inside = UiBuilder::new()
            .id_salt((self.name, self.of))
            .layout(Layout::centered_and_justified(Direction::LeftToRight))
            .max_rect(rect);
        let mut inside = ui.new_child(inside);
        inside.shrink_clip_rect(rect);
        inside.spacing_mut().button_padding.x = MARGIN;
        if reason.is_some() {
            let red = ui.visuals().error_fg_color;
            inside.visuals_mut().override_text_color = Some(red);
        }
        let id = inside.next_auto_id();
        let had_focus = ui.memory(|memory| memory.has_focus(id));
        let steps = if had_focus { steps(ui) } else { 0.0 };
        if steps != 0.0 {
            // What is typed counts first, and the field then has the focus again.
            ui.memory_mut(|memory| memory.surrender_focus(id));
        }
        let response = inside.add(drag.min_size(size));
        if steps != 0.0 {
            ui.memory_mut(|memory| memory.request_focus(id));
        }
        slide.note(&response);
        if !had_focus {
            ui.data_mut(|data| data.insert_temp(key, Began(shown.clone())));
        }

        let dragged = self.dragged(ui, key, &response, step);
        let left = typed.into_inner().filter(|_| !was_given_up);
        let next = match &left {
            _ if steps != 0.0 || dragged.is_some() => None,
            Some((text, true)) => Some(text.clone()),
            Some((_, false)) => None,
            None => refused,
        };
        let given_up = ui.input(|input| input.key_pressed(Key::Escape))
            && (response.has_focus() || response.lost_focus());
        if given_up {
            ui.data_mut(|data| data.insert_temp(key, GivenUp(pass)));
        }
        match next.filter(|_| !given_up) {
            Some(text) => ui.data_mut(|data| {
                data.insert_temp(key, Refused { text, shown: pass });
                data.insert_temp(Id::unique("refused"), Last(pass));
            }),
            None => ui.data_mut(|data| drop(data.remove_temp::<Refused>(key))),
        }
        self.tell(ui, (&response, rect), reason.as_deref(), &shown);

        let wanted = [dragged.unwrap_or(number + steps * step), number].into_iter();
        let mut wanted = wanted.filter(|number| number.to_bits() != value.to_bits());
        wanted.find(|number| check(*number).is_ok())
    }

    /// Where a drag has led: it counts from where it began, so that it leads back.
    fn dragged(&self, ui: &Ui, key: Id, response: &Response, step: f64) -> Option<f64> {
        let pass = ui.ctx().cumulative_pass_nr();
        let (dragged, by_px) = (response.dragged(), f64::from(response.drag_delta().x));
        let known = ui.data(|data| data.get_temp::<Drag>(key));
        let mut drag = known.filter(|drag| !response.drag_started() && drag.shown + 1 >= pass);
        if dragged && drag.is_none() {
            drag = Some(Drag {
                value: self.value,
                px: 0.0,
                shown: pass,
            });
        }
        let mut drag = drag?;
        // Esc, at which egui ends a drag, leads back to the start, and does nothing else.
        let esc = |input: &mut InputState| input.consume_key(Modifiers::NONE, Key::Escape);
        if ui.input_mut(esc) {
            ui.data_mut(|data| data.remove_temp::<Drag>(key));
            return Some(drag.value);
        }
        if !dragged {
            return None;
        }
        drag.shown = pass;
        let has_shift = ui.input(|input| input.modifiers.shift);
        drag.px += if has_shift { 10.0 * by_px } else { by_px };
        ui.data_mut(|data| data.insert_temp(key, drag));
        if by_px == 0.0 {
            return None;
        }
        Some(if self.by_factors {
            drag.value * libm::exp(0.01 * drag.px)
        } else {
            drag.value + drag.px * step
        })
    }

    /// The field's name and what it is; where its text is refused, why.
    fn tell(
        &self,
        ui: &Ui,
        (response, rect): (&Response, Rect),
        reason: Option<&str>,
        shown: &str,
    ) {
        let response = Response {
            rect,
            ..response.clone()
        };
        let response = response.named(self.name).bounded();
        let Some(reason) = reason else {
            if !response.dragged() {
                response.hint(format!("{}; exactly {}", self.hint, self.value));
            }
            return;
        };
        let red = ui.visuals().error_fg_color;
        let frame = Stroke::new(1.5, red);
        ui.painter()
            .rect_stroke(rect, 2.0, frame, StrokeKind::Inside);
        let text = format!("{reason}; {shown} stays in force");
        described(&response, &text);
        response.on_hover_text(RichText::new(text).color(red));
    }

    /// A number as the field has room for it: one that is cut off would read as another.
    fn written(&self, ui: &Ui, value: f64) -> String {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a few characters"
        )]
        let room = ((self.width - 2.0 * MARGIN) / char_width(ui)).max(0.0) as usize;
        short_in(value, room.clamp(LEAST, DIGITS))
    }
}

/// How many steps up the arrow keys ask for.
fn steps(ui: &Ui) -> f64 {
    let count = |modifiers, key| {
        let times = ui.input_mut(|input| input.count_and_consume_key(modifiers, key));
        u32::try_from(times).map_or(0.0, f64::from)
    };
    let steps = |modifiers| count(modifiers, Key::ArrowUp) - count(modifiers, Key::ArrowDown);
    10.0 * steps(Modifiers::SHIFT) + steps(Modifiers::NONE)
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

/// How many there are of something, by its name: 1 object, 2 objects.
pub(super) fn count_of(count: usize, name: &str) -> String {
    match count {
        1 => format!("1 {name}"),
        _ => format!("{count} {name}s"),
    }
}

/// A point, in few digits.
pub(super) fn point(DVec3 { x, y, z }: DVec3) -> String {
    format!("({}, {}, {})", short(x), short(y), short(z))
}

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
