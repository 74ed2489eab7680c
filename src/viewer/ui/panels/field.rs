//! A number that can be typed: red with the reason while it cannot be, and then the last good value stays.

use egui::{Color32, Id, Key, Response, RichText, TextEdit, Ui};

/// What is typed but not, or not yet, in force.
#[derive(Clone, Default)]
struct Typed(String);

/// Shows `value` and returns what was typed instead, once Enter or leaving the field confirms it and `check` has
/// nothing against it. Esc gives up. `salt` tells fields apart.
pub(super) fn number(
    ui: &mut Ui,
    salt: &str,
    value: f64,
    width: f32,
    check: impl Fn(f64) -> Result<(), String>,
) -> (Response, Option<f64>) {
    let id = ui.scope_id().with(salt);
    let shown = short(value);
    let typed = ui.data(|data| data.get_temp::<Typed>(id));
    let mut text = typed.clone().map_or_else(|| shown.clone(), |typed| typed.0);
    let parsed = parse(&text, value, &shown).and_then(|number| check(number).map(|()| number));
    let mut edit = TextEdit::singleline(&mut text).id(id).clip_text(false);
    if parsed.is_err() {
        edit = edit.text_color(ui.visuals().error_fg_color);
    }
    let height = ui.spacing().interact_size.y;
    let mut response = ui.add_sized([width, height], edit);
    if response.changed() {
        ui.data_mut(|data| data.insert_temp(id, Typed(text.clone())));
    }
    if let Err(reason) = &parsed {
        response = response.on_hover_text(RichText::new(reason).color(Color32::LIGHT_RED));
        if !response.has_focus() {
            ui.colored_label(ui.visuals().error_fg_color, "!")
                .on_hover_text(reason);
        }
    } else {
        response = response.on_hover_text(value.to_string());
    }
    let given_up = ui.input(|input| input.key_pressed(Key::Escape))
        && (response.has_focus() || response.lost_focus());
    let mut result = None;
    if given_up {
        forget(ui, id);
    } else if response.lost_focus()
        && typed.is_some()
        && let Ok(number) = parsed
    {
        forget(ui, id);
        result = Some(number);
    }
    (response, result)
}

fn forget(ui: &Ui, id: Id) {
    ui.data_mut(|data| data.remove_temp::<Typed>(id));
}

/// What stands in the field; the value itself, with all its digits, when it is still what was shown.
fn parse(text: &str, value: f64, shown: &str) -> Result<f64, String> {
    if text == shown {
        return Ok(value);
    }
    let number = text
        .trim()
        .parse::<f64>()
        .map_err(|_| format!("\u{201c}{}\u{201d} is not a number", text.trim()))?;
    if number.is_finite() {
        Ok(number)
    } else {
        Err("it must be a finite number".into())
    }
}

/// Width of a field in points that shows as many digits as [`short`] gives.
pub(super) const WIDTH: f32 = 74.0;

/// A value as panels show it: digits one under the other, a point with all of them in a line.
pub(super) fn value_text(text: impl Into<String>) -> RichText {
    RichText::new(text).monospace().size(11.0)
}

/// Six significant digits: enough to read; the field holds on to all of them.
pub(super) fn short(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    if !value.is_finite() {
        return value.to_string();
    }
    let exponent = value.abs().log10().floor();
    if !(-4.0..9.0).contains(&exponent) {
        let text = format!("{value:.5e}");
        let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        return format!("{}e{exponent}", trimmed(mantissa));
    }
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "clamped"
    )]
    let decimals = (5.0 - exponent).clamp(0.0, 10.0) as usize;
    trimmed(&format!("{value:.decimals$}")).to_owned()
}

fn trimmed(text: &str) -> &str {
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        text
    }
}
