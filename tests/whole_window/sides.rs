//! What the sides hold can be reached, nothing in it is cut off, and what unfolds moves only what is below it.

use super::*;

fn sides(window: &Window) -> [bool; 2] {
    ["left side", "right side"].map(|side| control(window, side).is_on)
}

fn demo(points: [u32; 2]) -> Window {
    Window::open(Options::default(), px(points, 1.0), 1.0)
}

/// What is picked is said first, and in the same place whatever is picked.
#[test]
fn what_is_picked_is_said_first_and_moves_nothing() {
    let (mut window, _folder) = row(1.0);
    let places = |window: &Window| {
        let names = [
            "position",
            "nearest edge",
            "Copy the pick",
            "Camera",
            "fov",
            "Depth buffer",
        ];
        names.map(|name| control(window, name).rect)
    };
    let before = places(&window);
    assert!(before.map(|rect| rect.top()).is_sorted());
    let nothing = pos2(MIDDLE.x - 250.0, MIDDLE.y - 200.0);
    for at in [MIDDLE, nothing, control(&window, "back").rect.center()] {
        click(&mut window, at);
        assert_eq!(places(&window), before);
    }
    press_key(&mut window, Modifiers::NONE, Key::Num7);
    assert_eq!(places(&window), before, "in another view");
    control(&window, "object 3");
    control(&window, "3 x 3 x 0");
    // The remark that the view has changed is longer than this panel is wide.
    window.resize(px([560, 420], 1.0));
    let copy = |window: &Window| control(window, "Copy the pick").rect;
    let long = copy(&window);
    press_key(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(copy(&window), long);
}

/// A topic that unfolds moves only what is below it, and comes into view.
#[test]
fn what_unfolds_moves_only_what_is_below() {
    let topics = [
        "Placement",
        "Details",
        "Matrices",
        "Measure",
        "Section",
        "Depth buffer",
    ];
    for (at, topic) in topics.into_iter().enumerate() {
        let (mut window, _folder) = row(1.0);
        window.resize(px([1280, 1400], 1.0));
        let heading = |window: &Window, name: &str| {
            let mut all = window.controls().iter();
            let is_there =
                |control: &Control| control.rect.left() > 970.0 && is_below_the_bar(control);
            let here = all.find(|control| control.name == name && is_there(control));
            here.expect("a heading").rect
        };
        let above = |window: &Window| {
            let names = ["Copy the pick", "fov", "Pose"]
                .into_iter()
                .chain(topics[..=at].iter().copied());
            names.map(|name| heading(window, name)).collect::<Vec<_>>()
        };
        let before = above(&window);
        let to = heading(&window, topic).center();
        click(&mut window, to);
        assert_eq!(above(&window), before, "{topic}");
        if let Some(next) = topics.get(at + 1) {
            assert!(
                heading(&window, next).top() > before[3 + at].bottom() + 20.0,
                "{topic}"
            );
        }
        let (mut window, _folder) = row(1.0);
        let to = heading(&window, topic).center();
        click(&mut window, to);
        let rect = heading(&window, topic);
        assert!(
            rect.top() > 20.0 && rect.bottom() < 690.0,
            "{topic}: {rect}"
        );
    }
}

/// In a window that the matrices make narrow, controls end within their side, and the numbers of a vector stand in a
/// line.
#[test]
fn nothing_is_cut_off_beside_the_matrices() {
    let mut window = demo(SIZE);
    click(&mut window, MIDDLE);
    let number = window.state().selected().expect("an object") + 1;
    for heading in ["Pose", "Details"] {
        click_on(&mut window, heading);
    }
    for key in [Key::P, Key::Num4] {
        press_key(&mut window, Modifiers::NONE, key);
        for name in ["up z", &format!("object {number}")] {
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
    let edge = control(&window, "edge of the right side").rect.center().x;
    let numbers = window.controls().iter().filter(|control| {
        control.role == Role::Label
            && control.name.trim().parse::<f64>().is_ok()
            && control.rect.left() > edge
    });
    let rights: Vec<_> = numbers.map(|number| number.rect.right()).collect();
    assert!(rights.len() >= 48, "{}", rights.len());
    assert!(
        rights.iter().all(|right| *right <= 640.0 - 8.0),
        "{rights:?}"
    );
    let tabs = ["show picture", "show NDC"].map(|tab| control(&window, tab).rect.center().y);
    assert!((tabs[0] - tabs[1]).abs() < 1.0, "{tabs:?}");
}

/// The key of the matrices shows them and folds them again; the four views fold them only if they unfolded them.
#[test]
fn matrices_are_shown_and_folded() {
    let has = |window: &Window| has_control(window, "P, row z");
    for points in [[640, 400], [800, 600], SIZE] {
        let mut window = demo(points);
        let mut press = |key, shows| {
            press_key(&mut window, Modifiers::NONE, key);
            assert_eq!(has(&window), shows, "{points:?}: {key:?}");
        };
        for (key, shows) in [
            (Key::P, true),
            (Key::Num4, true),
            (Key::Num4, true),
            (Key::P, false),
            (Key::Num4, true),
            (Key::Num4, false),
        ] {
            press(key, shows);
        }
        // In a side that is closed they are not seen: the key opens it.
        press(Key::P, true);
        if sides(&window)[1] {
            click_on(&mut window, "right side");
        }
        assert!(!has(&window));
        press_key(&mut window, Modifiers::NONE, Key::P);
        assert!(has(&window) && sides(&window)[1], "{points:?}");
    }
}

/// What the matrices and the gallery took the place of comes back as they go, unless the user has opened or closed a
/// side meanwhile.
#[test]
fn what_took_the_room_of_a_side_gives_it_back() {
    for points in [[640, 400], [800, 600], SIZE] {
        for closes in [None, Some("left side"), Some("right side")] {
            for keys in [
                vec![Key::P, Key::P],
                vec![Key::Num4, Key::Num4],
                vec![Key::E, Key::E, Key::Escape],
                vec![Key::E, Key::P, Key::P, Key::Escape],
            ] {
                let mut window = demo(points);
                if let Some(side) = closes.filter(|side| control(&window, side).is_on) {
                    click_on(&mut window, side);
                }
                let before = sides(&window);
                for key in &keys {
                    press_key(&mut window, Modifiers::NONE, *key);
                }
                assert_eq!(
                    sides(&window),
                    before,
                    "{points:?} {closes:?} after {keys:?}"
                );
            }
        }
    }
    let mut window = demo([640, 400]);
    click_on(&mut window, "left side");
    press_key(&mut window, Modifiers::NONE, Key::P);
    assert_eq!(sides(&window), [false, true]);
    click_on(&mut window, "left side");
    click_on(&mut window, "right side");
    press_key(&mut window, Modifiers::NONE, Key::P);
    assert_eq!(sides(&window), [false, true], "as the user left them");
}

/// The gallery shows its panel in every window.
#[test]
fn the_gallery_shows_its_panel() {
    const METHOD: &str = "Sightline's own, the default";
    for points in [[640, 400], [800, 600], SIZE] {
        let mut window = demo(points);
        if sides(&window)[0] {
            click_on(&mut window, "left side");
        }
        for key in [Key::E, Key::E, Key::Escape] {
            press_key(&mut window, Modifiers::NONE, key);
            let in_gallery = window.state().showing().is_some();
            assert_eq!(
                has_control(&window, METHOD),
                in_gallery,
                "{points:?}, {key:?}"
            );
        }
        let options = Options {
            paths: vec!["gallery:needles".into()],
            ..Options::default()
        };
        let window = Window::open(options, px(points, 1.0), 1.0);
        assert!(has_control(&window, METHOD), "{points:?}");
    }
}

/// Opens the side on which this control is, and clicks it.
fn reach(window: &mut Window, name: &str) {
    for side in ["left side", "right side"] {
        if !has_control(window, name) && control(window, side).is_enabled {
            click_on(window, side);
        }
    }
    click_on(window, name);
}

/// No panel is wider than its side, at the left or the right: so none scrolls sideways, and nothing is cut off.
#[test]
fn no_panel_scrolls_sideways() {
    let windows = [640, 660, 680, 700].map(|width| [width, 400]);
    for (points, side) in windows
        .into_iter()
        .chain([[800, 600], SIZE])
        .flat_map(|points| [(points, "left"), (points, "right")])
    {
        let mut window = demo(points);
        let width = f32::from(u16::try_from(points[0]).expect("small"));
        reach(&mut window, "Measure");
        press_key(&mut window, Modifiers::NONE, Key::P);
        let name = format!("{side} side");
        if !control(&window, &name).is_on {
            click_on(&mut window, &name);
        }
        let edge = control(&window, &format!("edge of the {side} side")).rect;
        let [from, to] = match side {
            "left" => [0.0, edge.right()],
            _ => [edge.left(), width],
        };
        let [left, right] = ["left", "right"].map(|side| {
            let name = format!("edge of the {side} side");
            has_control(&window, &name).then(|| control(&window, &name).rect.center().x)
        });
        let middle = 0.5 * (left.unwrap_or(0.0) + right.unwrap_or(width));
        click(&mut window, pos2(middle, edge.center().y));
        assert!(picked_px(&window).is_some());
        let here = window.controls().iter().filter(|control| {
            let at = control.rect.center();
            (from + 4.0..to - 4.0).contains(&at.x) && edge.y_range().contains(at.y)
        });
        let (bars, others): (Vec<_>, Vec<_>) =
            here.partition(|control| control.role == Role::ScrollBar);
        let (lying, standing): (Vec<&Control>, Vec<&Control>) =
            (bars.into_iter()).partition(|bar| bar.rect.width() > bar.rect.height());
        let right = standing.iter().map(|bar| bar.rect.left());
        let right = right.fold(to - 4.0, f32::min);
        let is_wide =
            |control: &&&Control| control.rect.left() < from + 4.0 || control.rect.right() > right;
        let wide = others.iter().filter(is_wide);
        let wide: Vec<_> = wide.map(|control| (&control.name, control.rect)).collect();
        assert!(
            wide.is_empty() && lying.is_empty(),
            "{points:?} {side}, {from} to {right}: {wide:?} {lying:?}"
        );
    }
}

/// The smallest window has room for all fields of the selected object's matrix.
#[test]
fn a_small_window_shows_the_fields_of_a_matrix() {
    let mut window = demo([640, 400]);
    click(&mut window, pos2(200.0, 180.0));
    assert!(picked_px(&window).is_some());
    click_on(&mut window, "Camera");
    click_on(&mut window, "Placement");
    for part in ["position", "rotation", "scale"] {
        let mut before = control(&window, part).rect;
        for axis in ["x", "y", "z"] {
            let field = control(&window, &format!("{part} {axis}")).rect;
            assert!(
                field.left() > before.right() && field.width() > 45.0,
                "{part} {axis}: {field}"
            );
            before = field;
        }
        assert!(before.right() < 640.0 - 15.0, "{part}: {before}");
    }
}

/// The letters of the axes stand above the fields of the camera's place, which are in columns.
#[test]
fn fields_of_the_camera_stand_in_columns() {
    for points in [[640, 400], SIZE] {
        let mut window = demo(points);
        click_on(&mut window, "Pose");
        for axis in ["x", "y", "z"] {
            let left = |name: &str| control(&window, &format!("{name} {axis}")).rect.left();
            let eye = left("eye");
            let below = [left("target"), left("up")];
            let in_column = below.iter().all(|left| (left - eye).abs() < 0.1);
            assert!(in_column, "{axis} at {points:?}: {below:?}");
            let mut texts = window.controls().iter();
            let letter = texts.find(|text| {
                text.name == axis
                    && text.role == Role::Label
                    && text.rect.bottom() <= control(&window, "eye x").rect.top()
                    && (text.rect.left() - eye).abs() < 1.0
            });
            assert!(letter.is_some(), "{axis} at {points:?}");
        }
    }
}

/// A name that is too long is cut: it covers nothing, and moves nothing out of its side.
#[test]
fn a_long_name_is_cut() {
    let name = "front ".repeat(100);
    let name = name.trim_end();
    let (mut window, _folder) = row_as(&ROW.replace("front", name), 1.0);
    click(&mut window, MIDDLE);
    assert_eq!(selected(&window), Some(name));
    let [left, right] = ["left", "right"].map(|side| {
        let edge = format!("edge of the {side} side");
        control(&window, &edge).rect.center().x
    });
    let number = control(&window, "object 1").rect;
    assert!(number.right() <= 1280.0 - 8.0, "{number}");
    let texts = window.controls().iter();
    let texts = texts.filter(|text| text.role == Role::Label && text.name == name);
    let rects: Vec<_> = texts.map(|text| text.rect).collect();
    let is_cut = |rect: &Rect| rect.left() > right && rect.right() < number.left();
    let of_status = |rect: &Rect| rect.top() > 690.0 && rect.width() < 640.0;
    assert!(rects.iter().any(is_cut), "{rects:?}");
    assert!(
        rects.iter().all(|rect| is_cut(rect) || of_status(rect)),
        "{rects:?}"
    );
    // The list's row is as wide as any.
    let rows = [name, "middle"].map(|name| control(&window, name).rect.right());
    assert!(
        rows[0] <= left && (rows[0] - rows[1]).abs() < 0.1,
        "{rows:?}"
    );
}
