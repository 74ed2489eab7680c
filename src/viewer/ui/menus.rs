//! All that can be asked for by name: one table, which the menu bar, the toolbar, the shortcuts, the menus of the right
//! button, the help and the tests read.

use super::{
    command::{Command, TourMove},
    icons::{self, Icon},
    panels::{Shown, Topic},
};
use crate::{
    geometry::Sides,
    viewer::{
        jobs::Checking,
        model::{Action, MeasureAction, Overlay},
    },
};
use egui::{Key, Modifiers};
use glam::DVec3;
use std::sync::LazyLock;

/// A menu of the bar.
pub(in crate::viewer) struct Menu {
    pub name: &'static str,
    /// What it is about.
    pub hint: &'static str,
    /// What it holds, in groups.
    pub groups: Vec<Group>,
    /// What else it holds.
    pub more: Option<More>,
}

/// Items of a menu that belong together.
pub(in crate::viewer) struct Group {
    pub items: Vec<Item>,
    /// Their name, and the icon of the tool that opens all of them: in the menu, they are a menu of their own. `None`
    /// where they stand in the menu itself, and the toolbar has those with icons.
    pub name: Option<(&'static str, Icon)>,
}

/// What a menu holds that changes.
#[derive(Clone, Copy)]
pub(in crate::viewer) enum More {
    /// The scenes that were opened before.
    Recent,
    /// The scenes of the gallery.
    Exhibits,
}

/// Something that can be asked for.
pub(in crate::viewer) struct Item {
    pub name: &'static str,
    /// What it does, in a few words.
    pub hint: &'static str,
    /// The keys that ask for it.
    pub shortcuts: Vec<Shortcut>,
    /// `None` where the toolbar does not have it.
    pub icon: Option<Icon>,
    pub command: Command,
    /// Whether what it switches is on; `None` if it switches nothing.
    pub is_on: Option<Asks<bool>>,
    /// Whether it would do anything now.
    pub is_of_use: Asks<bool>,
    /// What it is about now; empty where there is nothing to say.
    pub now: Asks<String>,
}

/// What an item asks of what is shown.
type Asks<T> = Box<dyn Fn(&Shown) -> T + Send + Sync>;

/// A key, with the keys that are held.
pub(in crate::viewer) type Shortcut = (Modifiers, Key);

const NONE: Modifiers = Modifiers::NONE;
const SHIFT: Modifiers = Modifiers::SHIFT;
const CTRL: Modifiers = Modifiers::COMMAND;
const CTRL_SHIFT: Modifiers = CTRL.plus(SHIFT);

/// The table.
pub(in crate::viewer) static MENUS: LazyLock<[Menu; 5]> =
    LazyLock::new(|| [file(), edit(), view(), tools(), learn()]);

/// Every shortcut with its command. One with more keys held stands before one with fewer, which would match both.
pub(in crate::viewer) static SHORTCUTS: LazyLock<Vec<(Shortcut, &Command)>> = LazyLock::new(|| {
    let of_item = |item: &'static Item| {
        let shortcuts = item.shortcuts.iter();
        shortcuts.map(move |shortcut| (*shortcut, &item.command))
    };
    let mut all: Vec<_> = items().flat_map(of_item).collect();
    let held = |held: Modifiers| u8::from(held.shift) + u8::from(held.command);
    all.sort_by_key(|((modifiers, _), _)| std::cmp::Reverse(held(*modifiers)));
    all
});

/// All items, in order.
pub(in crate::viewer) fn items() -> impl Iterator<Item = &'static Item> {
    let groups = MENUS.iter().flat_map(|menu| &menu.groups);
    groups.flat_map(|group| &group.items)
}

/// The item that asks for a command.
pub(in crate::viewer) fn item_of(command: &Command) -> Option<&'static Item> {
    items().find(|item| item.command == *command)
}

/// The first shortcut for a command, as a text; empty where it has none.
pub(in crate::viewer) fn keys_of(command: impl Into<Command>) -> String {
    item_of(&command.into()).map_or(String::new(), Item::first_keys)
}

/// A shortcut as a text.
pub(in crate::viewer) fn keys((modifiers, key): Shortcut) -> String {
    let ctrl = if modifiers.command { "Ctrl+" } else { "" };
    // A question mark tells by itself that Shift is held.
    let shift = if modifiers.shift && key != Key::Questionmark {
        "Shift+"
    } else {
        ""
    };
    let key = match key {
        Key::Escape => "Esc",
        Key::Questionmark => "?",
        key => key.name(),
    };
    format!("{ctrl}{shift}{key}")
}

impl Item {
    /// All of its keys, as a text.
    pub fn all_keys(&self) -> String {
        let mut all: Vec<_> = self.shortcuts.iter().copied().map(keys).collect();
        all.dedup();
        all.join(", ")
    }

    /// The first of its keys, as a text.
    pub fn first_keys(&self) -> String {
        self.shortcuts.first().copied().map_or(String::new(), keys)
    }

    /// What it does, and what it is about now.
    pub fn tells(&self, shown: &Shown) -> String {
        let now = (self.now)(shown);
        if now.is_empty() {
            self.hint.to_owned()
        } else {
            format!("{}; now: {now}", self.hint)
        }
    }

    fn icon(mut self, icon: Icon) -> Self {
        self.icon = Some(icon);
        self
    }

    fn on_if(mut self, is_on: impl Fn(&Shown) -> bool + Send + Sync + 'static) -> Self {
        self.is_on = Some(Box::new(is_on));
        self
    }

    fn of_use_if(mut self, is_of_use: impl Fn(&Shown) -> bool + Send + Sync + 'static) -> Self {
        self.is_of_use = Box::new(is_of_use);
        self
    }

    fn now(mut self, now: impl Fn(&Shown) -> String + Send + Sync + 'static) -> Self {
        self.now = Box::new(now);
        self
    }

    /// The item is about the next step of undo, if `back`, or of redo.
    fn about_step(self, back: bool) -> Self {
        self.now(move |shown| shown.state.next_step(back).unwrap_or("nothing").to_owned())
            .of_use_if(move |shown| shown.state.next_step(back).is_some())
    }
}

impl From<Vec<Item>> for Group {
    fn from(items: Vec<Item>) -> Self {
        Self { items, name: None }
    }
}

fn item<const N: usize>(
    name: &'static str,
    shortcuts: [Shortcut; N],
    command: impl Into<Command>,
    hint: &'static str,
) -> Item {
    Item {
        name,
        hint,
        shortcuts: shortcuts.into(),
        icon: None,
        command: command.into(),
        is_on: None,
        is_of_use: Box::new(|_| true),
        now: Box::new(|_| String::new()),
    }
}

fn file() -> Menu {
    let files = vec![
        item(
            "Open\u{2026}",
            [(CTRL, Key::O)],
            Command::OpenDialog,
            "OBJ and scene files; they can be dropped on the window, too, but not on Wayland",
        )
        .icon(icons::OPEN),
        item(
            "Save\u{2026}",
            [(CTRL, Key::S)],
            Command::SaveDialog,
            "as a scene file",
        )
        .icon(icons::SAVE),
        item(
            "Reload",
            [(NONE, Key::R)],
            Command::Reload,
            "read the files again",
        )
        .icon(icons::RELOAD),
        item(
            "Next file",
            [(NONE, Key::PageDown)],
            Command::NextFile { forward: true },
            "open the OBJ or scene file after this one in its folder",
        )
        .of_use_if(has_file),
        item(
            "Previous file",
            [(NONE, Key::PageUp)],
            Command::NextFile { forward: false },
            "open the one before it",
        )
        .of_use_if(has_file),
    ];
    let pictures = vec![
        item(
            "Screenshot\u{2026}",
            [(NONE, Key::F12)],
            Command::ToggleScreenshot,
            "of the picture or the window, on any background, to a file or the clipboard",
        )
        .icon(icons::SCREENSHOT)
        .on_if(|shown| shown.shot.is_some()),
    ];
    let quit = item(
        "Quit",
        [(CTRL, Key::Q)],
        Command::Quit,
        "asks first where edits or measures would be lost",
    );
    Menu {
        name: "File",
        hint: "open and save scenes and pictures",
        groups: vec![files.into(), pictures.into(), vec![quit].into()],
        more: Some(More::Recent),
    }
}

fn has_file(shown: &Shown) -> bool {
    !shown.state.source().paths.is_empty()
}

fn edit() -> Menu {
    let steps = vec![
        item(
            "Undo",
            [(CTRL, Key::Z)],
            Action::Undo,
            "take the last change back",
        )
        .icon(icons::UNDO)
        .about_step(true),
        item(
            "Redo",
            [(CTRL_SHIFT, Key::Z), (CTRL, Key::Y)],
            Action::Redo,
            "make it again",
        )
        .icon(icons::REDO)
        .about_step(false),
    ];
    let hiding = vec![
        item(
            "Hide",
            [(SHIFT, Key::H)],
            Action::HideSelection,
            "what is selected is neither drawn nor picked",
        )
        .of_use_if(has_selection),
        item(
            "Isolate",
            [(NONE, Key::I)],
            Action::Isolate,
            "only what is selected is drawn and picked",
        )
        .of_use_if(has_selection),
        item(
            "Show all",
            [(NONE, Key::U)],
            Action::ShowAll,
            "what is hidden, too",
        )
        .of_use_if(|shown| shown.state.scene().hidden_count() > 0),
    ];
    let selecting = vec![
        item(
            "Next object",
            [(NONE, Key::ArrowDown)],
            Command::SelectRow { down: true },
            "select the next in the list of objects",
        ),
        item(
            "Previous object",
            [(NONE, Key::ArrowUp)],
            Command::SelectRow { down: false },
            "select the one before in the list of objects",
        ),
        item(
            "Cancel",
            [(NONE, Key::Escape)],
            Command::Escape,
            "cancel, close, deselect, or leave the gallery: the first that applies",
        ),
    ];
    Menu {
        name: "Edit",
        hint: "changes, what is hidden, what is selected, copies",
        groups: [steps, hiding, selecting, surfaces(), copies()]
            .map(Group::from)
            .into(),
        more: None,
    }
}

fn surfaces() -> Vec<Item> {
    vec![
        item(
            "Next surface",
            [(NONE, Key::N)],
            Action::Step { forward: true },
            "pick the next surface on the pick's ray",
        )
        .of_use_if(has_pick),
        item(
            "Previous surface",
            [(SHIFT, Key::N)],
            Action::Step { forward: false },
            "pick the one before it on the pick's ray",
        )
        .of_use_if(has_pick),
    ]
}

fn copies() -> Vec<Item> {
    vec![
        item(
            "Copy as a command",
            [(NONE, Key::C)],
            Command::CopyCommandLine,
            "a command line that repeats the pick; no pick: the view",
        ),
        item(
            "Copy the pick",
            [(NONE, Key::J)],
            Command::CopyPick,
            "its full record, as JSON",
        )
        .of_use_if(|shown| shown.state.pick_ray().is_some()),
        item(
            "Copy the camera",
            [(SHIFT, Key::C)],
            Command::CopyCamera,
            "as a scene file writes it; Ctrl+V pastes a copied one",
        ),
    ]
}

fn has_pick(shown: &Shown) -> bool {
    shown.state.picked().is_some()
}

fn has_selection(shown: &Shown) -> bool {
    shown.state.selected().is_some()
}

fn view() -> Menu {
    let framing = vec![
        item(
            "Frame all",
            [(NONE, Key::A)],
            Action::FrameAll,
            "move the camera until all of the scene is in view",
        )
        .icon(icons::FRAME),
        item(
            "Frame selection",
            [(NONE, Key::F)],
            Action::FrameSelection,
            "move the camera until what is selected fills the view",
        ),
        item(
            "Reset",
            [(NONE, Key::Enter), (NONE, Key::Home)],
            Action::ResetView,
            "the view that the scene opened with",
        ),
    ];
    let look = |(name, modifiers, key, to_eye)| {
        let hint = "look at the scene from there";
        item(name, [(modifiers, key)], Action::LookFrom(to_eye), hint)
    };
    let looking = [
        ("Front", NONE, Key::Num1, DVec3::Z),
        ("Back", CTRL, Key::Num1, DVec3::NEG_Z),
        ("Right", NONE, Key::Num3, DVec3::X),
        ("Left", CTRL, Key::Num3, DVec3::NEG_X),
        ("Top", NONE, Key::Num7, DVec3::Y),
        ("Bottom", CTRL, Key::Num7, DVec3::NEG_Y),
        ("Corner", NONE, Key::Num9, DVec3::ONE),
    ];
    let switches = vec![
        item(
            "Orthographic",
            [(NONE, Key::Num5)],
            Action::ToggleProjection,
            "in place of perspective",
        )
        .icon(icons::ORTHOGRAPHIC)
        .on_if(|shown| shown.state.controls().orthographic),
        item(
            "Cull back faces",
            [(NONE, Key::B)],
            Action::ToggleSides,
            "they are neither drawn nor picked",
        )
        .on_if(|shown| shown.state.view().sides == Sides::Front),
    ];
    let window = vec![
        item(
            "Full screen",
            [(NONE, Key::F11)],
            Command::ToggleFullScreen,
            "and back",
        ),
        item("Theme", [], Command::NextLook, "dark or light panels")
            .now(|shown| shown.look.about().to_owned()),
    ];
    Menu {
        name: "View",
        hint: "where the camera looks from, what it leaves out, and what is drawn over the scene",
        groups: vec![
            framing.into(),
            Group {
                items: looking.map(look).into(),
                name: Some(("Views", icons::VIEWS)),
            },
            overlays(),
            switches.into(),
            window.into(),
        ],
        more: None,
    }
}

/// What one works with.
fn tools() -> Menu {
    let tools = vec![
        item(
            "Section",
            [(NONE, Key::Z)],
            Action::ToggleSection,
            "a plane cuts the scene open",
        )
        .icon(icons::SECTION)
        .of_use_if(|shown| !is_in_gallery(shown))
        .on_if(|shown| shown.state.view().section.is_some()),
        item(
            "Move",
            [(NONE, Key::O)],
            Command::ToggleMoving,
            "the selected object, by arrows in the picture or by numbers",
        )
        .on_if(|shown| shown.arrangement.shows(Topic::Placement)),
        item(
            "Freeze",
            [(NONE, Key::T)],
            Action::ToggleFreeze,
            "leave a copy of this camera in the scene, with the pick's ray, and step back to see it; then look through it again",
        )
        .icon(icons::FREEZE)
        .on_if(|shown| shown.state.frozen().is_some()),
        item(
            "Measure",
            [(NONE, Key::Q)],
            Action::Measure(MeasureAction::Toggle),
            "clicks snap to vertices and edges; distances, angles, areas",
        )
        .icon(icons::MEASURE)
        .of_use_if(|shown| !is_in_gallery(shown))
        .on_if(|shown| shown.state.measuring().is_on),
    ];
    Menu {
        name: "Tools",
        hint: "cut the scene open, move what is selected, leave the camera in it, measure",
        groups: vec![tools.into()],
        more: None,
    }
}

/// Lines around the scene and over it.
fn overlays() -> Group {
    let overlay = |(name, key, which, hint)| {
        let shows = move |shown: &Shown| shown.state.overlays().shows(which);
        item(name, [(NONE, key)], Action::Toggle(which), hint).on_if(shows)
    };
    let overlays = [
        (
            "Grid",
            Key::G,
            Overlay::Grid,
            "on the ground, with axes: x red, y green, z blue",
        ),
        (
            "Picked triangle",
            Key::Y,
            Overlay::Triangle,
            "with its corners and barycentrics",
        ),
        (
            "Last distance",
            Key::D,
            Overlay::Distance,
            "between the last two picks, in world units",
        ),
        (
            "Wireframe",
            Key::W,
            Overlay::Wireframe,
            "of the selection, or of everything; spheres have none",
        ),
        (
            "Normals",
            Key::L,
            Overlay::Normals,
            "outward, of the selection's faces, or of all",
        ),
        (
            "Bounding boxes",
            Key::X,
            Overlay::Boxes,
            "along the world's axes, of the selection, or of everything",
        ),
    ];
    let level = |shown: &Shown| {
        let level = shown.state.overlays().tree_level;
        level.map_or("none shows".to_owned(), |level| {
            format!("level {level} shows")
        })
    };
    let trees = vec![
        item(
            "Search tree boxes, a level down",
            [(NONE, Key::K)],
            Action::TreeLevel { deeper: true },
            "of the search trees (BVH) of the selection's mesh, or of all; small meshes have none",
        )
        .now(level),
        item(
            "Search tree boxes, a level up",
            [(SHIFT, Key::K)],
            Action::TreeLevel { deeper: false },
            "level 0 is the box around a mesh",
        )
        .now(level),
    ];
    Group {
        items: overlays.into_iter().map(overlay).chain(trees).collect(),
        name: Some(("Overlays", icons::OVERLAYS)),
    }
}

fn learn() -> Menu {
    let views = vec![
        item(
            "Four views",
            [(NONE, Key::Num4)],
            Command::ToggleFour,
            "object, world, view and NDC side by side, all live",
        )
        .on_if(|shown| !shown.state.stages().is_empty()),
        item(
            "Matrices",
            [(NONE, Key::P)],
            Command::TogglePipeline,
            "the matrices P, V and M, and the pick on its way through them",
        )
        .on_if(|shown| shown.arrangement.shows(Topic::Matrices)),
        item(
            "Compare",
            [(NONE, Key::V)],
            Command::ToggleCheck,
            "each pixel as drawn with what a click there picks",
        )
        .on_if(|shown| !matches!(shown.checking, Checking::Off)),
    ];
    let help = vec![
        item(
            "Tour",
            [],
            Command::Tour(TourMove::Begin),
            "what a pick is, step by step",
        ),
        item(
            "One pick in four spaces",
            [],
            Command::ShowOnePick,
            "the demo's egg, picked: object, world, view and NDC, and the pick worked out",
        ),
        item(
            "Help",
            [
                (NONE, Key::H),
                (NONE, Key::F1),
                (SHIFT, Key::Questionmark),
                (NONE, Key::Questionmark),
            ],
            Command::ToggleHelp,
            "keys and mouse",
        )
        .on_if(|shown| shown.helps),
    ];
    let gallery = vec![
        item(
            "Next scene of the gallery",
            [(NONE, Key::E)],
            Command::NextExhibit { forward: true },
            "scenes on which known methods break",
        ),
        item(
            "Previous scene",
            [(SHIFT, Key::E)],
            Command::NextExhibit { forward: false },
            "the gallery's scene before this one",
        ),
        item(
            "Next method",
            [(NONE, Key::M)],
            Action::NextMethod { forward: true },
            "in the gallery: pick by the next method",
        )
        .of_use_if(is_in_gallery),
        item(
            "Previous method",
            [(SHIFT, Key::M)],
            Action::NextMethod { forward: false },
            "in the gallery: pick by the method before",
        )
        .of_use_if(is_in_gallery),
    ];
    Menu {
        name: "Learn",
        hint: "how a pick works, and where others break",
        groups: [help, views, gallery].map(Group::from).into(),
        more: Some(More::Exhibits),
    }
}

fn is_in_gallery(shown: &Shown) -> bool {
    shown.state.showing().is_some()
}
