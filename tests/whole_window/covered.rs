//! No tooltip lies over Help, no group of the toolbar with names stands before one without, and nothing lies over the
//! grid's step.

use super::*;
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
