//! The panels of a side can all be reached, nothing in them is cut off, and the matrices give back the room that they took.

use super::*;

fn sides(window: &Offscreen) -> [bool; 2] {
    ["left side", "right side"].map(|side| control(window, side).is_on)
}

fn demo(points: [u32; 2]) -> Offscreen {
    Offscreen::open(Options::default(), px(points, 1.0), 1.0)
}

/// With all panels at one side, every heading is in view, and what is selected can be read beside the matrices.
#[test]
fn the_pick_can_be_read_beside_the_matrices() {
    let (mut window, _folder) = row(1.0);
    click_on(&mut window, "move Pick to the left");
    click(&mut window, MIDDLE);
    press_key(&mut window, Modifiers::NONE, Key::P);
    let headings = ["Matrices", "Pick", "Measure", "Objects"];
    let tops = headings.map(|name| control(&window, name).rect.top());
    assert!(tops.is_sorted(), "{tops:?}");
    for name in ["front", "object 1"] {
        let row = control(&window, name).rect;
        assert!(
            row.top() > tops[1] && row.bottom() < tops[2],
            "{name}: {row}"
        );
    }
    // The matrices keep enough to read, and the list as well.
    let z = control(&window, "P, row z").rect;
    assert!(z.top() > tops[0] && z.bottom() < tops[1], "{z}");
    assert!(tops[3] < 690.0 - 100.0, "{tops:?}");
}

/// In a window that the matrices make narrow, controls end within their side, and the numbers of a vector stand in a line.
#[test]
fn nothing_is_cut_off_beside_the_matrices() {
    let mut window = demo(SIZE);
    click(&mut window, MIDDLE);
    let number = window.state().selected().expect("an object") + 1;
    for key in [Key::P, Key::Num4] {
        press_key(&mut window, Modifiers::NONE, key);
        for name in ["up z", "move Pick to the left", &format!("object {number}")] {
            let rect = control(&window, name).rect;
            assert!(rect.right() <= 1280.0 - 8.0, "{name}: {rect}");
        }
        let vectors = window.controls().iter().filter(|control| {
            let words: Vec<_> = control.name.split_whitespace().collect();
            control.rect.left() > MIDDLE.x
                && words.len() == 3
                && words.iter().all(|word| word.parse::<f64>().is_ok())
        });
        let heights: Vec<_> = vectors.map(|control| control.rect.height()).collect();
        assert!(heights.len() >= 2, "{heights:?}");
        assert!(heights.iter().all(|height| *height < 20.0), "{heights:?}");
    }
}

/// The smallest window shows matrices whole.
#[test]
fn matrices_have_all_their_columns_in_a_small_window() {
    let mut window = demo([640, 400]);
    press_key(&mut window, Modifiers::NONE, Key::P);
    let edge = control(&window, "edge of the left side").rect.center().x;
    let numbers = window.controls().iter().filter(|control| {
        control.role == Role::Label
            && control.name.trim().parse::<f64>().is_ok()
            && control.rect.left() < edge
    });
    let rights: Vec<_> = numbers.map(|number| number.rect.right()).collect();
    assert!(rights.len() >= 48, "{}", rights.len());
    assert!(
        rights.iter().all(|right| *right <= edge - 8.0),
        "{edge}: {rights:?}"
    );
    let tabs = ["show picture", "show NDC"].map(|tab| control(&window, tab).rect.center().y);
    assert!((tabs[0] - tabs[1]).abs() < 1.0, "{tabs:?}");
}

/// What the matrices took the place of comes back as they go.
#[test]
fn matrices_give_back_the_room_that_they_took() {
    for points in [[640, 400], [800, 600], SIZE] {
        for keys in [vec![Key::P, Key::P], vec![Key::Num4, Key::P, Key::Num4]] {
            let mut window = demo(points);
            let before = sides(&window);
            for key in &keys {
                press_key(&mut window, Modifiers::NONE, *key);
            }
            assert_eq!(sides(&window), before, "{points:?} after {keys:?}");
        }
    }
    // A side that the user opened meanwhile stays.
    let mut window = demo([640, 400]);
    press_key(&mut window, Modifiers::NONE, Key::P);
    click_on(&mut window, "right side");
    click_on(&mut window, "left side");
    press_key(&mut window, Modifiers::NONE, Key::P);
    assert_eq!(sides(&window), [true, false]);
}

/// A tooltip goes when Help covers what it explains.
#[test]
fn no_tooltip_lies_over_help() {
    let (mut window, _folder) = row(1.0);
    let at = control(&window, "front").rect.center();
    window.send([Event::PointerMoved(at)]);
    window.wait_s(1.0);
    let explains = |window: &Offscreen| {
        let mut all = window.controls().iter();
        all.any(|control| control.role == Role::Label && control.name.starts_with("1 front: cube"))
    };
    assert!(explains(&window));
    press_key(&mut window, Modifiers::NONE, Key::H);
    assert!(has_control(&window, "Take the tour") && !explains(&window));
}

/// Groups lose their names from the first to the last. Undo has none where those after it have none.
#[test]
fn the_toolbar_names_no_group_before_one_without_names() {
    let mut named = 0;
    for width in [640, 800, 1000, 1280, 1600, 2560] {
        let mut window = demo(SIZE);
        window.resize(px([width, 720], 1.0));
        // One of each group. An icon alone is narrower than this.
        let tools = ["Reload", "Undo", "Reset", "Grid", "Look"];
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
    let step = |window: &Offscreen| {
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
        let window = Offscreen::open(options, px(points, 1.0), 1.0);
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
