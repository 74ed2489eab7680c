//! The list of objects: which are visible, and which are selected.

use super::{arrangement::GUTTER, field::count_of, inspector::swatch, menu, prelude::*};
use egui::{
    Key, Modifiers, Role, ScrollArea, StrokeKind, TextStyle, UiBuilder, WidgetInfo,
    text::{LayoutJob, TextWrapping},
};

/// What is typed to narrow the list, and the rows that are left.
#[derive(Default)]
pub(in crate::viewer) struct Filter {
    text: String,
    /// The scene's revision and the text that the rows are for.
    of: Option<(u64, String)>,
    /// Indices of the objects whose name holds the text, whatever its case; `None` for all of them.
    rows: Option<Vec<usize>>,
}

impl Filter {
    /// Finds the rows. Returns whether they are of another scene or text than before.
    fn apply(&mut self, state: &State) -> bool {
        let of = Some((state.scene_revision(), self.text.to_lowercase()));
        if self.of == of {
            return false;
        }
        let wanted = self.text.to_lowercase();
        let objects = state.scene().objects().iter().enumerate();
        let fits = objects.filter(|(_, object)| object.name.to_lowercase().contains(&wanted));
        self.rows = (!wanted.is_empty()).then(|| fits.map(|(index, _)| index).collect());
        self.of = of;
        true
    }

    /// How many rows are left.
    fn count(&self, state: &State) -> usize {
        let rows = self.rows.as_ref().map(Vec::len);
        rows.unwrap_or_else(|| state.scene().objects().len())
    }

    /// The object of a row.
    fn object(&self, row: usize) -> usize {
        self.rows.as_ref().map_or(row, |rows| rows[row])
    }

    /// The row of an object; `None` where it is left out.
    fn row(&self, object: usize) -> Option<usize> {
        match &self.rows {
            Some(rows) => rows.binary_search(&object).ok(),
            None => Some(object),
        }
    }

    /// The object in the row below `from`'s, or above it. If `from` has no row: the first object on the way down, the
    /// last on the way up.
    pub fn next(&mut self, state: &State, from: Option<usize>, down: bool) -> Option<usize> {
        self.apply(state);
        let last = self.count(state).checked_sub(1)?;
        let row = match (from.and_then(|object| self.row(object)), down) {
            (None, true) => 0,
            (None, false) => last,
            (Some(row), true) => (row + 1).min(last),
            (Some(row), false) => row.saturating_sub(1),
        };
        Some(self.object(row))
    }
}

pub(super) fn show(
    ui: &mut Ui,
    state: &State,
    filter: &mut Filter,
    reveal_selection: bool,
    commands: &mut Vec<Command>,
) {
    let is_entered = ui.scope(|ui| {
        ui.set_max_width(ui.available_width() - GUTTER);
        above(ui, state, filter, commands);
        let is_entered = search(ui, &mut filter.text);
        ui.separator();
        is_entered
    });
    let is_another = filter.apply(state);
    if is_entered.inner && filter.rows.as_ref().is_some_and(|found| !found.is_empty()) {
        commands.push(Action::Select(Some(filter.object(0))).into());
    }
    let objects = state.scene().objects();
    let height = (ui.text_style_height(&TextStyle::Body)).max(ui.spacing().interact_size.y);
    let mut area = ScrollArea::vertical().id_salt("list").auto_shrink(false);
    if is_another {
        area = area.vertical_scroll_offset(0.0);
    }
    let revealed = state.selected().filter(|_| reveal_selection || is_another);
    if let Some(row) = revealed.and_then(|object| filter.row(object)) {
        #[expect(clippy::cast_precision_loss, reason = "a place in a list")]
        let row = row as f32;
        let step = height + ui.spacing().item_spacing.y;
        area = area.vertical_scroll_offset((row * step - 0.4 * ui.available_height()).max(0.0));
    }
    let count = filter.count(state);
    if count == 0 && !objects.is_empty() {
        let text = format!("No name contains \u{201c}{}\u{201d}.", filter.text);
        ui.weak(text).hint("clear the search to see all objects");
    }
    area.show_rows(ui, height, count, |ui, rows| {
        for index in rows.map(|row| filter.object(row)) {
            if let Some(how) = row(ui, state, index, commands) {
                commands.push(selecting(state, filter, index, how));
            }
        }
    });
}

/// What a click on an object's row asks for. With Ctrl the object is added to what is selected, or taken out; with Shift
/// all rows are selected from the one that was selected first to this one. Without, it alone is selected or deselected.
fn selecting(state: &State, filter: &Filter, index: usize, how: Modifiers) -> Command {
    let first = state.selected().and_then(|first| filter.row(first));
    if let (true, Some(from), Some(to)) = (how.shift, first, filter.row(index)) {
        let rows = from.min(to)..=from.max(to);
        return Command::SelectObjects(rows.map(|row| filter.object(row)).collect());
    }
    if how.command {
        return Action::ToggleSelected(index).into();
    }
    let is_alone = state.all_selected().eq([index]);
    Action::Select((!is_alone).then_some(index)).into()
}

/// The field for what is searched. Esc clears it, or leaves it if it is empty. Returns whether Enter left it.
fn search(ui: &mut Ui, text: &mut String) -> bool {
    let field = egui::TextEdit::singleline(text).hint_text("search");
    let field = ui.add(field.desired_width(f32::INFINITY)).named("search");
    // egui takes the focus from a field at Esc and at Enter.
    let left_by = |key| field.lost_focus() && ui.input(|input| input.key_pressed(key));
    if left_by(Key::Escape) && !text.is_empty() {
        text.clear();
        field.request_focus();
    }
    let is_entered = left_by(Key::Enter);
    let hint = "list only objects whose name contains this; Enter selects the first, Esc clears it";
    field.hint(hint);
    is_entered
}

/// How many objects the search finds, or else how many objects and triangles there are; and buttons that hide and show.
fn above(ui: &mut Ui, state: &State, filter: &Filter, commands: &mut Vec<Command>) {
    let scene = state.scene();
    let (objects, triangles) = (
        count_of(scene.objects().len(), "object"),
        scene.triangle_count(),
    );
    if let Some(found) = &filter.rows {
        ui.horizontal(|ui| {
            let hint =
                "whose name contains what is searched for; clear the search to see all objects";
            ui.weak(format!("{} of {objects}", found.len())).hint(hint);
            let all = ui.add_enabled(!found.is_empty(), Button::new("select found").small());
            let hint = "select all objects that the search finds";
            if all.hint(hint).clicked() {
                commands.push(Command::SelectObjects(found.iter().copied().collect()));
            }
        });
    } else {
        let hint = "of all objects, hidden ones too; spheres have no triangles";
        ui.horizontal(|ui| {
            ui.weak(format!("{objects}, {triangles} triangles"))
                .hint(hint);
        });
    }
    ui.horizontal_wrapped(|ui| {
        let mut button = |enabled, name: &str, hint: &str, action: Action| {
            let button = ui.add_enabled(enabled, Button::new(name).small());
            button.asks(hint, action, commands);
        };
        let selected = state.selected().is_some();
        let hint = "hide all that is selected (Shift+H)";
        button(selected, "hide", hint, Action::HideSelection);
        let hint = "hide all but what is selected (I)";
        button(selected, "isolate", hint, Action::Isolate);
        let (hides, hint) = (scene.hidden_count() > 0, "show what is hidden (U)");
        button(hides, "show all", hint, Action::ShowAll);
    });
}

/// A row of the list. Returns which keys were held if it was clicked beside the tick. The object lights up while the
/// cursor rests on the row.
fn row(ui: &mut Ui, state: &State, index: usize, commands: &mut Vec<Command>) -> Option<Modifiers> {
    let object = &state.scene().objects()[index];
    let is_selected = state.is_selected(index);
    let width = ui.available_width() - GUTTER;
    let size = vec2(width, ui.spacing().interact_size.y);
    let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
    let is_lit = ui.rect_contains_pointer(rect);
    let visuals = ui.visuals();
    let (selection, hovered) = (visuals.selection, visuals.widgets.hovered);
    let back = Some(selection.bg_fill).filter(|_| is_selected);
    if let Some(back) = back.or(is_lit.then_some(hovered.weak_bg_fill)) {
        ui.painter().rect_filled(rect, 3.0, back);
    }
    let inside = UiBuilder::new()
        .max_rect(rect)
        .layout(Layout::left_to_right(Align::Center));
    let tick = ui.scope_builder(inside, |ui| {
        let mut visible = object.visible;
        let tick = ui.checkbox(&mut visible, "");
        let tick = tick.named(&format!("show {}", object.name));
        if tick.changed() {
            commands.push(Command::Act(Action::SetVisible(index, visible)));
        }
        let tick = tick.hint("visible; hidden objects are not picked").rect;
        if let Some((_, colour)) = object.one_material() {
            swatch(ui, colour);
        } else {
            ui.allocate_space(vec2(10.0, 10.0));
        }
        (tick, ui.min_rect())
    });
    let (tick, before) = tick.inner;
    let rest = rect.with_min_x(tick.right());
    let name = ui.interact(rest, ui.scope_id().with(("row", index)), Sense::click());
    name.widget_info(|| WidgetInfo::selected(Role::Button, true, is_selected, &object.name));
    let colour = match (is_selected, object.visible) {
        (true, _) => selection.stroke.color,
        (false, true) => ui.visuals().text_color(),
        (false, false) => ui.visuals().weak_text_color(),
    };
    let font = TextStyle::Body.resolve(ui.style());
    let left = before.right() + ui.spacing().item_spacing.x;
    let mut text = LayoutJob::simple_singleline(object.name.clone(), font, colour);
    text.wrap = TextWrapping::truncate_at_width(rest.right() - left - 4.0);
    let painter = ui.painter();
    let text = painter.layout_job(text);
    let at = pos2(left, rect.center().y - 0.5 * text.size().y);
    painter.galley(at, text, colour);
    if name.has_focus() {
        painter.rect_stroke(rest, 3.0, selection.stroke, StrokeKind::Inside);
    }
    if is_lit {
        commands.push(Command::Act(Action::Light(Some(index))));
    }
    let triangles = object.shape.triangles();
    let triangles = triangles.map(|range| format!(", {} triangles", range.len()));
    let (kind, triangles) = (object.shape.kind(), triangles.unwrap_or_default());
    let (number, called) = (index + 1, &object.name);
    let name = name.hint(format!("{number} {called}: {kind}{triangles}"));
    menu::of_object(&name, state, index, None, commands);
    name.clicked().then(|| ui.input(|input| input.modifiers))
}
