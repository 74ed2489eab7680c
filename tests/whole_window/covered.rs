//! No tooltip lies over Help, no group of the toolbar with names stands before one without, nothing lies over the
//! grid's step, and the grid lies over no object.

use super::*;
use sightline::{look::Background, pick};
use std::collections::BTreeSet;

fn demo(points: [u32; 2]) -> Window {
    Window::open(Options::default(), px(points, 1.0), 1.0)
}

/// A tooltip goes when Help covers what it explains.
#[test]
fn no_tooltip_lies_over_help() {
    let (mut window, _folder) = row(1.0);
    let at = control(&window, "front").rect.center();
    window.send([Event::PointerMoved(at)]);
    window.wait_s(1.0);
    let explains = |window: &Window| {
        let mut all = window.controls().iter();
        all.any(|control| control.role == Role::Label && control.name.starts_with("1 front: cube"))
    };
    assert!(explains(&window));
    press_key(&mut window, Modifiers::NONE, Key::H);
    assert!(has_control(&window, "Take the tour") && !explains(&window));
}

/// Groups of tools lose their names from the first to the last.
#[test]
fn the_bar_names_no_group_before_one_without_names() {
    let mut named = 0;
    for width in [640, 800, 1000, 1280, 1600, 2560] {
        let mut window = demo(SIZE);
        window.resize(px([width, 720], 1.0));
        // One of each group. An icon alone is narrower than this.
        let tools = ["Reload", "Undo", "Frame all", "Freeze"];
        let shown = tools.into_iter().filter(|tool| has_control(&window, tool));
        let names: Vec<_> = shown
            .map(|tool| control(&window, tool).rect.width() > 40.0)
            .collect();
        assert!(names.is_sorted(), "{width}: {names:?}");
        named += names.iter().filter(|has| **has).count();
    }
    assert!(named > 5, "{named}");
}

/// Each tool that a narrow row has no room for is in the menu at its end, and no tool lies under the last buttons.
#[test]
fn the_bar_hands_every_tool_out() {
    let tools = [
        "Open\u{2026}",
        "Save\u{2026}",
        "Reload",
        "Screenshot\u{2026}",
        "Undo",
        "Redo",
        "Frame all",
        "Views",
        "Orthographic",
        "Section",
        "Overlays",
        "Freeze",
        "Measure",
    ];
    let mut moved = BTreeSet::new();
    for width in [500, 640, 700, 800, 1000, 1280] {
        let mut window = demo(SIZE);
        window.resize(px([width, 400], 1.0));
        // Menus are laid out once they are open: what is there now is in the row.
        let in_row = tools.map(|tool| has_control(&window, tool));
        let end = control(&window, "left side").rect;
        for (tool, _) in tools.iter().zip(in_row).filter(|(_, in_row)| *in_row) {
            let rect = control(&window, tool).rect;
            assert!(rect.right() < end.left(), "{width}: {tool} {rect} {end}");
        }
        assert_eq!(has_control(&window, "more tools"), in_row.contains(&false));
        if in_row.contains(&false) {
            // The widest tool does not fit there.
            let gap = end.left() - control(&window, "more tools").rect.right();
            assert!((0.0..70.0).contains(&gap), "{width}: {gap} points are free");
            click_on(&mut window, "more tools");
        }
        for tool in tools {
            assert!(has_control(&window, tool), "{width}: {tool}");
        }
        let rest = in_row.iter().filter(|in_row| !**in_row).count();
        moved.insert(rest);
    }
    assert!(moved.len() > 2, "{moved:?}");
}

/// The grid's step is told where a line of the grid is in the picture, and nothing lies over it.
#[test]
fn the_step_of_a_grid_in_view_is_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let step = |window: &Window| {
        let mut all = window.controls().iter();
        let step = all.find(|control| control.name.starts_with("grid step"));
        step.map(|control| control.rect)
    };
    for points in [[640, 400], [800, 600], SIZE] {
        // A window that keeps a memory offers the tour.
        let options = Options {
            memory: Some(folder.path().join("window.toml")),
            ..Options::default()
        };
        let window = Window::open(options, px(points, 1.0), 1.0);
        let told = step(&window).expect("a grid");
        for name in ["New here?", "no tour"] {
            let offer = control(&window, name).rect.expand(8.0);
            assert!(
                !offer.intersects(told),
                "{name} at {points:?}: {offer} {told}"
            );
        }
    }
    // The camera looks up: no line of the grid is in its picture.
    let up = ROW.replace("eye = [0, 0, 10]", "eye = [0, 5, 10]");
    let up = up.replace("target = [0, 0, 0]", "target = [0, 50, 9]");
    let (window, _folder) = row_as(&up, 1.0);
    assert_eq!(step(&window), None);
}

/// Seen from low, the demo's ground goes on before the fitted near plane, down to the picture's lower edge, and beyond
/// the far plane. It lies over no object.
#[test]
fn the_ground_goes_on_before_near_and_beyond_far_and_covers_no_object() {
    let mut window = demo(SIZE);
    press_key(&mut window, Modifiers::NONE, Key::Num1);
    window.send([Event::PointerGone]);
    let with_ground = window.picture().expect("a picture");
    press_key(&mut window, Modifiers::NONE, Key::G);
    let bare = window.picture().expect("a picture");
    let (scene, view) = (window.state().scene(), window.state().view());
    let (ids, _) = pick::raycast(scene, view, Background::DARK);
    let (lens, eye, lowest) = (view.camera.lens(), view.camera.eye(), scene.bounds().min.y);
    let [width, height] = [ids.size().width(), ids.size().height()];
    let [left, top] = motion::corner(&window);
    let [mut before, mut beyond, mut last_row] = [0; 3];
    // Right of what is written in the corner.
    for (x, y) in ids.positions().filter(|(x, _)| *x > 200) {
        let [now, then] = [&with_ground, &bare].map(|all| all.at(left + x, top + y));
        if !images::apart(now, then, 3) {
            continue;
        }
        if ids.at(x, y).object > 0 {
            // A smooth outline shows what is beside the object.
            let mut around = (0..9).map(|i| [x + i % 3, y + i / 3].map(|at| at.max(1) - 1));
            let is_outline =
                around.any(|[x, y]| ids.at(x.min(width - 1), y.min(height - 1)).object == 0);
            assert!(is_outline, "({x}, {y})");
            continue;
        }
        let px = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
        let depth = (lowest - eye.y) / view.offset_from_eye(px, 1.0).y;
        before += u32::from(depth < lens.near);
        beyond += u32::from(depth > lens.far);
        last_row = last_row.max(y);
    }
    assert!(before > 1000 && beyond > 100, "{before}, {beyond}");
    // A panel's border may lie over the last row.
    assert!(last_row + 2 >= height, "{last_row} of {height}");
}
