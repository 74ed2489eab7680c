//! The whole window does what its users see and rely on. The tests need no window system: they send egui's events, and
//! read state, clipboard, messages and pictures.
#![cfg(feature = "window")]

mod corner;
mod covered;
mod device;
#[path = "../common/dropped.rs"]
mod dropped;
mod earlier_view;
mod events;
mod files;
mod four;
mod four_picks;
mod gallery;
mod harness;
#[path = "../common/images.rs"]
mod images;
mod in_view;
mod inspect;
mod keys;
mod large;
mod layout;
mod looks;
mod measures;
mod menus;
mod motion;
mod moving;
mod narrow;
mod nothing_lost;
mod numbers;
mod object_list;
mod one_place;
mod overlays;
mod pictures;
mod red_fields;
mod remembering;
mod rest;
mod saving;
mod section;
mod selecting;
mod shots;
mod sides;
mod stalls;
mod tour;
mod typed;
mod watching;
mod while_loading;
mod worked_out;

use egui::{Event, Key, Modifiers, PointerButton, Pos2, Rect, Role, pos2};
use glam::DVec2;
use harness::{Control, Window};
use sightline::{
    camera::Viewport,
    image::{Image, Rgb},
    viewer::{
        Options,
        model::{Stage, Views},
    },
};
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// The window's size in points.
const SIZE: [u32; 2] = [1280, 720];
/// The point at the middle of the scene's rectangle, at any scale.
const MIDDLE: Pos2 = pos2(590.0, 361.0);

/// A scene file of three objects in a row along z, with the camera in front of them.
const ROW: &str = "
[camera]
eye = [0, 0, 10]
target = [0, 0, 0]

[[object]]
name = \"front\"
shape = \"cube\"
position = [0, 0, 2]

[[object]]
name = \"middle\"
shape = \"sphere\"
colour = \"#d1495b\"

[[object]]
name = \"back\"
shape = \"square\"
scale = [3, 3, 1]
position = [0, 0, -2]
";

/// A window that shows [`ROW`], and the folder of its file.
fn row(scale: f32) -> (Window, TempDir) {
    row_as(ROW, scale)
}

/// A window that shows this text, and the folder of its file.
fn row_as(text: &str, scale: f32) -> (Window, TempDir) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("row.toml");
    std::fs::write(&path, text).expect("a writable folder");
    (open(vec![path], scale), folder)
}

fn open(paths: Vec<PathBuf>, scale: f32) -> Window {
    let options = Options {
        paths,
        ..Options::default()
    };
    Window::open(options, px(SIZE, scale), scale)
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    reason = "small and positive"
)]
fn px(points: [u32; 2], scale: f32) -> Viewport {
    let [width, height] = points.map(|side| (side as f32 * scale).round() as u32);
    Viewport::new(width, height).expect("a viewport")
}

fn button(at: Pos2, button: PointerButton, pressed: bool) -> Event {
    Event::PointerButton {
        pos: at,
        button,
        pressed,
        modifiers: Modifiers::NONE,
    }
}

fn click(window: &mut Window, at: Pos2) {
    drag(window, PointerButton::Primary, at, at);
}

/// Two clicks that follow each other quickly.
fn double_click(window: &mut Window, at: Pos2) {
    // An earlier click must not count as one of them.
    window.wait_s(1.0);
    let press = |pressed| button(at, PointerButton::Primary, pressed);
    let clicks = [true, false, true, false].map(press);
    window.send([Event::PointerMoved(at)].into_iter().chain(clicks));
}

/// Presses at one point, moves in ten steps and releases at another.
fn drag(window: &mut Window, with: PointerButton, from: Pos2, to: Pos2) {
    let moves = (0..=10_u8).map(|i| Event::PointerMoved(from.lerp(to, f32::from(i) / 10.0)));
    let press = [Event::PointerMoved(from), button(from, with, true)];
    window.send(press.into_iter().chain(moves));
    window.send([button(to, with, false)]);
}

/// The control of this name, or else the text of this name. Of a heading and a tool, it is the heading.
#[track_caller]
fn control<'a>(window: &'a Window, name: &str) -> &'a Control {
    let named = || {
        window
            .controls()
            .iter()
            .filter(|control| control.name == name)
    };
    let of_use = || named().filter(|control| control.role != Role::Label);
    let below_the_bar = of_use().find(|control| is_below_the_bar(control));
    let of_use = below_the_bar.or_else(|| of_use().next());
    of_use.or_else(|| named().next()).unwrap_or_else(|| {
        let all = window.controls().iter();
        let names: Vec<_> = all.map(|control| &control.name).collect();
        panic!("no {name:?} among {names:?}")
    })
}

/// Whether a control is none of the menus and tools at the top.
fn is_below_the_bar(control: &Control) -> bool {
    control.rect.top() > 25.0
}

fn has_control(window: &Window, name: &str) -> bool {
    window.controls().iter().any(|control| control.name == name)
}

/// Clicks a control.
#[track_caller]
fn click_on(window: &mut Window, name: &str) {
    let found = control(window, name);
    assert!(found.is_enabled, "{name} can be used");
    let at = found.rect.center();
    click(window, at);
}

/// Clicks a control under a heading of the inspector, which it unfolds first if the control is not there.
#[track_caller]
fn click_under(window: &mut Window, heading: &str, name: &str) {
    if !has_control(window, name) {
        scroll_to(window, heading);
        click_on(window, heading);
    }
    scroll_to(window, name);
    click_on(window, name);
}

/// Turns the wheel over the inspector until a control in it is in view.
#[track_caller]
fn scroll_to(window: &mut Window, name: &str) {
    let seen = control(window, "edge of the right side").rect.y_range();
    for _ in 0..50 {
        let at = control(window, name).rect;
        let by = (seen.min - at.top()).max(0.0) - (at.bottom() - seen.max).max(0.0);
        if by == 0.0 {
            return;
        }
        window.send([
            Event::PointerMoved(pos2(1120.0, seen.center())),
            Event::MouseWheel {
                unit: egui::MouseWheelUnit::Point,
                source: egui::MouseWheelSource::Unknown,
                delta: egui::vec2(0.0, by),
                phase: egui::TouchPhase::Move,
                modifiers: Modifiers::NONE,
            },
        ]);
        window.wait_s(0.5);
    }
    panic!("{name} stays out of view");
}

/// Ctrl as winit reports it on systems where Ctrl is the command key.
const CTRL: Modifiers = Modifiers::CTRL.plus(Modifiers::COMMAND);

/// Types into a field as a user does: replaces its text.
fn type_into(window: &mut Window, name: &str, text: &str) {
    click_on(window, name);
    press_key(window, CTRL, Key::A);
    window.send([Event::Text(text.into())]);
}

fn key_event(modifiers: Modifiers, key: Key, pressed: bool) -> Event {
    Event::Key {
        key,
        physical_key: None,
        pressed,
        repeat: false,
        modifiers,
    }
}

/// A key goes down.
fn press(key: Key) -> Event {
    key_event(Modifiers::NONE, key, true)
}

fn press_key(window: &mut Window, modifiers: Modifiers, key: Key) {
    window.send([true, false].map(|pressed| key_event(modifiers, key, pressed)));
}

/// Takes a screenshot to a file by Enter, after clicking these controls of its card, if any.
#[track_caller]
fn shoot(window: &mut Window, choices: &[&str]) {
    press_key(window, Modifiers::NONE, Key::F12);
    for choice in choices {
        click_on(window, choice);
    }
    press_key(window, Modifiers::NONE, Key::Enter);
}

/// The pixel whose top left corner is nearest to a point of the window, at scale 1.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a place in the window"
)]
fn whole(at: Pos2) -> [u32; 2] {
    [at.x.round() as u32, at.y.round() as u32]
}

/// How many pixels of a rectangle of the window, at scale 1, two pictures of it show differently.
fn differing_in(a: &Image<Rgb>, b: &Image<Rgb>, rect: Rect) -> usize {
    #[expect(clippy::cast_precision_loss, reason = "windows are small")]
    let is_in = |[x, y]: [u32; 2]| rect.contains(pos2(x as f32 + 0.5, y as f32 + 0.5));
    images::differing_where(a, b, |a, b, at| a != b && is_in(at))
}

fn selected(window: &Window) -> Option<&str> {
    let selection = window.state().selection()?;
    Some(&window.state().scene().objects()[selection.object].name)
}

/// The pixel position at which the selection was picked.
fn picked_px(window: &Window) -> Option<DVec2> {
    let hits = window.state().hits()?;
    hits.pick().map(|_| hits.px)
}

fn here(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/whole_window")
        .join(path)
}
