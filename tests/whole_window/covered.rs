//! No tooltip lies over Help, no group of the toolbar with names stands before one without, and nothing lies over the
//! grid's step.

use super::*;

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
