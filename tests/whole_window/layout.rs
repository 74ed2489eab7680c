//! Panels fold, sides are dragged, and the picture keeps half of the window. Numbers move no control.

use super::*;
use egui::vec2;

/// The picture's share of the window's area.
fn share(window: &Window, size: [u32; 2]) -> f64 {
    let picture = window.state().view().viewport;
    f64::from(picture.width()) * f64::from(picture.height())
        / (f64::from(size[0]) * f64::from(size[1]))
}

fn shows(window: &Window) -> [bool; 2] {
    ["left side", "right side"].map(|side| control(window, side).is_on)
}

#[test]
fn the_picture_keeps_half_of_the_window() {
    let mut both = 0;
    for (points, scale) in [
        ([640, 400], 1.0),
        ([800, 600], 1.0),
        ([1280, 720], 1.0),
        ([1280, 720], 2.0),
        ([1920, 1080], 1.5),
        ([700, 2000], 1.0),
    ] {
        for path in ["", "gallery:needles"] {
            let paths = Some(path).filter(|path| !path.is_empty());
            let options = Options {
                paths: paths.into_iter().map(PathBuf::from).collect(),
                ..Options::default()
            };
            let size = px(points, scale);
            let mut window = Window::open(options, size, scale);
            let size = [size.width(), size.height()];
            for _ in 0..2 {
                for side in ["left side", "right side"] {
                    if !control(&window, side).is_on {
                        click_on(&mut window, side);
                    }
                    assert!(control(&window, side).is_on, "{side} opens at {points:?}");
                    let share = share(&window, size);
                    assert!(
                        share >= 0.5,
                        "{share} at {points:?} times {scale}, {path:?}"
                    );
                    both += usize::from(shows(&window) == [true; 2]);
                }
                press_key(&mut window, Modifiers::NONE, Key::P);
            }
        }
    }
    assert!(both > 12, "{both}");
}

#[test]
fn a_side_is_dragged_folded_and_opened() {
    let (mut window, _folder) = row(1.0);
    let width = |window: &Window| window.state().view().viewport.width();
    let before = width(&window);
    for (edge, outwards, side) in [
        ("edge of the left side", 1.0, "left side"),
        ("edge of the right side", -1.0, "right side"),
    ] {
        let at = control(&window, edge).rect.center();
        let to = at + vec2(30.0 * outwards, 0.0);
        drag(&mut window, PointerButton::Primary, at, to);
        assert_eq!(width(&window), before - 30, "{edge}");
        let now = control(&window, edge).rect.center();
        assert!((now.x - to.x).abs() < 1.0, "{now} {to}");
        drag(&mut window, PointerButton::Primary, now, at);
        assert_eq!(width(&window), before, "{edge}");
        // A side that is dragged all the way folds. It opens as wide as before.
        let far = at - vec2(outwards * at.x.min(1280.0 - at.x), 0.0);
        drag(&mut window, PointerButton::Primary, at, far);
        assert!(!control(&window, side).is_on && width(&window) > before + 100);
        click_on(&mut window, side);
        assert!(control(&window, side).is_on);
        let home = before_edge(&window, edge, before);
        let now = control(&window, edge).rect.center();
        drag(&mut window, PointerButton::Primary, now, pos2(home, now.y));
        assert_eq!(width(&window), before);
    }
}

/// Where an edge is if the picture has this width and the other edge stays.
fn before_edge(window: &Window, edge: &str, width: u32) -> f32 {
    #[expect(clippy::cast_precision_loss, reason = "a window's width")]
    let width = width as f32;
    let half = 0.5 * control(window, edge).rect.width();
    if edge.contains("left") {
        control(window, "edge of the right side").rect.left() - width - half
    } else {
        control(window, "edge of the left side").rect.right() + width + half
    }
}

/// The strips that are dragged are no part of the picture.
#[test]
fn every_column_of_the_picture_can_be_clicked() {
    let wall = "[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n\n[[object]]\nshape = \"square\"\nscale = 100\n";
    let (mut window, _folder) = row_as(wall, 1.0);
    window.picture().expect("a picture");
    let left = control(&window, "edge of the left side").rect.right();
    let right = control(&window, "edge of the right side").rect.left();
    for from_border in [0.5, 1.5, 3.5, 4.5, 5.5, 7.5] {
        for x in [left + from_border, right - from_border] {
            click(&mut window, pos2(x, MIDDLE.y));
            let picked = picked_px(&window).unwrap_or_else(|| panic!("nothing at {x}"));
            assert!(
                (picked.x - f64::from(x - left)).abs() < 1e-3,
                "{picked} {x}"
            );
            press_key(&mut window, Modifiers::NONE, Key::Escape);
        }
    }
}

#[test]
fn a_panel_folds() {
    let (mut window, _folder) = row(1.0);
    assert!(has_control(&window, "fov"));
    click_on(&mut window, "Camera");
    assert!(!has_control(&window, "fov"), "folded");
    click_on(&mut window, "Camera");
    assert!(control(&window, "fov").rect.left() > MIDDLE.x);
}

/// The menus have all that can be asked for, at any width. Tools are in the row where there is room for them.
#[test]
fn all_of_the_menus_can_be_reached_at_any_width() {
    let menus = ["File", "Edit", "View", "Tools", "Learn"];
    let mut tools = Vec::new();
    for width in [480, 640, 800, 1280, 2560] {
        let (mut window, _folder) = row(1.0);
        window.resize(px([width, 400], 1.0));
        #[expect(clippy::cast_precision_loss, reason = "a window's width")]
        let is_inside = |name: &str, window: &Window| {
            let at = control(window, name).rect;
            assert!(
                at.left() >= 0.0 && at.right() <= width as f32,
                "{name} at {width}: {at}"
            );
            at
        };
        let ends = is_inside("left side", &window);
        let row: Vec<_> = (window.controls().iter())
            .filter(|control| control.rect.bottom() < 25.0 && !control.name.ends_with("side"))
            .collect();
        assert!(
            row.iter().all(|control| control.rect.right() < ends.left()),
            "{width}"
        );
        tools.push(row.len() - menus.len());
        for (menu, item) in menus.into_iter().zip([
            "Quit",
            "Copy the camera",
            "Full screen",
            "Freeze",
            "Four views",
        ]) {
            is_inside(menu, &window);
            click_on(&mut window, menu);
            is_inside(item, &window);
            press_key(&mut window, Modifiers::NONE, Key::Escape);
        }
        // A menu in a menu.
        click_on(&mut window, "View");
        click_on(&mut window, "Overlays");
        is_inside("Wireframe", &window);
        press_key(&mut window, Modifiers::NONE, Key::Escape);
    }
    assert!(tools.is_sorted() && tools[0] < 6, "{tools:?}");
    assert_eq!(tools[3..], [13, 13], "all of them");
    // What is in a menu works.
    let (mut window, _folder) = row(1.0);
    window.resize(px([640, 400], 1.0));
    let before = window.state().overlays();
    click_on(&mut window, "View");
    click_on(&mut window, "Overlays");
    click_on(&mut window, "Grid");
    assert_ne!(window.state().overlays(), before);
}

/// The controls of the panels, and where each is.
fn places(window: &Window) -> Vec<(String, egui::Rect)> {
    let controls = window.controls().iter();
    // The cross turns with the camera.
    let of_use = controls
        .filter(|control| control.role != Role::Label && !control.name.starts_with("look from"));
    of_use
        .map(|control| (control.name.clone(), control.rect))
        .collect()
}

/// No control of the panels moves, whatever the view.
#[test]
fn numbers_move_nothing() {
    let (mut window, _folder) = row(1.0);
    click(&mut window, MIDDLE);
    press_key(&mut window, Modifiers::NONE, Key::P);
    let before = places(&window);
    assert!(before.len() > 60, "{}", before.len());
    for (x, y) in [(70.0, -31.0), (-333.0, 200.0), (211.0, -640.0)] {
        let to = MIDDLE + vec2(x, y) * 0.4;
        drag(&mut window, PointerButton::Primary, MIDDLE, to);
        window.send([Event::PointerGone]);
        for (now, before) in places(&window).iter().zip(&before) {
            assert_eq!(now, before);
        }
        assert_eq!(places(&window).len(), before.len());
    }
}

/// A long number moves no control, neither while it is typed nor after. The field shows it shortened, the tooltip in
/// full.
#[test]
fn a_long_number_moves_nothing_and_is_told_whole() {
    let (mut window, _folder) = row(1.0);
    click_on(&mut window, "Pose");
    window.wait_s(1.0);
    let before = places(&window);
    for (field, typed, shown, value) in [
        (
            "up x",
            "-0.000952597",
            "-0.000953",
            // The vector stays as typed; the camera's is of unit length.
            (|_| -0.000_952_597) as fn(&Window) -> f64,
        ),
        ("far", "99999999999999999999", "1e20", |window| {
            window.state().view().camera.lens().far
        }),
    ] {
        type_into(&mut window, field, typed);
        window.send([Event::PointerGone]);
        assert_eq!(places(&window), before, "{typed} is typed");
        press_key(&mut window, Modifiers::NONE, Key::Enter);
        assert_eq!(places(&window), before, "{typed} is in force");
        let Control {
            value: text,
            description,
            ..
        } = control(&window, field);
        assert_eq!(text, shown);
        let exactly = format!("exactly {}", value(&window));
        assert!(description.ends_with(&exactly), "{description}: {exactly}");
    }
}

/// The left and right ends of each number of the matrices and of three steps of a point's way through them.
fn columns(window: &Window) -> Vec<[f32; 2]> {
    let of_matrix = |matrix: &str| ["x", "y", "z", "w"].map(|row| format!("{matrix}, row {row}"));
    let rows = ["P", "V", "M"].into_iter().flat_map(of_matrix);
    let way = ["object", "clip", "ray along"].map(|step| format!("{step:<9}"));
    let edge = control(window, "edge of the right side").rect.center().x;
    let mut all = Vec::new();
    for name in rows.chain(way) {
        let row = control(window, &name).rect.y_range();
        let beside = window.controls().iter().filter(|number| {
            number.role == Role::Label
                && number.name.trim().parse::<f64>().is_ok()
                && number.rect.left() > edge
                && row.contains(number.rect.center().y)
        });
        let mut beside: Vec<_> = beside
            .map(|number| [number.rect.left() - edge, number.rect.right() - edge])
            .collect();
        beside.sort_by(|a, b| a[0].total_cmp(&b[0]));
        all.extend(beside);
    }
    all
}

/// The numbers of matrices stand in columns that neither other numbers nor a wider panel move.
#[test]
fn the_columns_of_matrices_stay_where_they_are() {
    let (mut window, folder) = row(1.0);
    click(&mut window, MIDDLE);
    click_on(&mut window, "Pose");
    press_key(&mut window, Modifiers::NONE, Key::P);
    let before = columns(&window);
    assert_eq!(before.len(), 3 * 4 * 4 + 3 + 4 + 3);
    for (field, number) in [("eye x", "-0.000952597"), ("far", "99999999999999999999")] {
        type_into(&mut window, field, number);
        press_key(&mut window, Modifiers::NONE, Key::Enter);
        assert_eq!(columns(&window), before, "{field}");
    }
    // This scene's coordinates have seven digits.
    let large = folder.path().join("large.toml");
    let text = "[camera]\neye = [0, 0, 4e6]\ntarget = [0, 0, 0]\n\
                [[object]]\nshape = \"cube\"\nscale = 1e6\n";
    std::fs::write(&large, text).expect("writable");
    window.drop_file(large);
    click(&mut window, MIDDLE);
    assert!(picked_px(&window).is_some());
    assert_eq!(columns(&window), before, "large");
    // Closing the other side makes room for a wider panel.
    click_on(&mut window, "left side");
    let edge = control(&window, "edge of the right side").rect.center();
    let to = edge - vec2(60.0, 0.0);
    drag(&mut window, PointerButton::Primary, edge, to);
    let now = control(&window, "edge of the right side").rect.center();
    assert!((now.x - to.x).abs() < 1.0, "{now} {to}");
    assert_eq!(columns(&window), before, "wider");
}

#[test]
fn panels_are_dark_or_light_as_the_desktop_is() {
    let (mut window, _folder) = row(1.0);
    let panel = |window: &mut Window| {
        let picture = window.picture().expect("a picture");
        picture.at(1270, 690).map(u32::from).iter().sum::<u32>()
    };
    let unknown = panel(&mut window);
    window.set_theme(egui::Theme::Light);
    let light = panel(&mut window);
    window.set_theme(egui::Theme::Dark);
    assert!(light > 600 && unknown < 150, "{light} {unknown}");
    assert_eq!(panel(&mut window), unknown);
    // The user's choice overrides the desktop's.
    let next = |window: &mut Window| {
        click_on(window, "View");
        click_on(window, "Theme");
    };
    next(&mut window);
    assert_eq!(panel(&mut window), light);
    next(&mut window);
    window.set_theme(egui::Theme::Light);
    assert_eq!(panel(&mut window), unknown);
    next(&mut window);
    assert_eq!(panel(&mut window), light);
}

/// In small windows no field, and no key or text of Help, is cut off at the left or the right.
#[test]
fn small_windows_cut_nothing_off_at_their_sides() {
    for points in [[640, 400], [800, 600], [1000, 650], [1280, 720]] {
        let mut window = Window::open(Options::default(), px(points, 1.0), 1.0);
        let right = f32::from(u16::try_from(points[0]).expect("small"));
        if !control(&window, "right side").is_on {
            click_on(&mut window, "right side");
        }
        click_on(&mut window, "Pose");
        let is_within = |window: &Window, name: &str| {
            let rect = control(window, name).rect;
            assert!(
                rect.left() >= 0.0 && rect.right() <= right,
                "{name} at {points:?}: {rect}"
            );
        };
        for name in ["fov", "near", "eye z", "target z", "up z"] {
            is_within(&window, name);
        }
        press_key(&mut window, Modifiers::NONE, Key::H);
        for name in [
            "left drag",
            "orbit about the point under the cursor",
            "right, middle, Shift+left drag",
        ] {
            is_within(&window, name);
        }
    }
}

/// A panel that scrolls vertically does not scroll sideways, because a horizontal bar would cover its last row.
#[test]
fn nothing_is_wider_than_its_panel() {
    let (mut window, _folder) = row(1.0);
    press_key(&mut window, Modifiers::NONE, Key::P);
    click(&mut window, MIDDLE);
    window.wait_s(1.0);
    let right = 1280.0 - 8.0;
    let controls = window.controls().iter();
    let wide: Vec<_> = controls
        .filter(|control| control.rect.left() > 1010.0 && control.rect.right() > right)
        .map(|control| (&control.name, control.rect))
        .collect();
    assert!(
        has_control(&window, "Depth buffer") && wide.is_empty(),
        "{wide:?}"
    );
    // Scroll bars have no names. Only the vertical one is there.
    let controls = window.controls().iter();
    let bars = controls.filter(|control| control.name.is_empty() && control.rect.left() > 1010.0);
    let lying = bars
        .filter(|bar| bar.rect.width() > bar.rect.height())
        .count();
    assert_eq!(lying, 0);
}
