//! An opened scene is in view, or a control brings it there. A scene that cannot be drawn is reported.

use super::*;
use glam::DVec3;
use sightline::render::{Gpu, Restraint};

const NONE: Modifiers = Modifiers::NONE;

fn is_whole(window: &Window) -> bool {
    let view = window.state().view();
    let corners = window.state().scene().visible_bounds().corners();
    let is_in = |corner| {
        view.project(corner)
            .is_some_and(|at| view.viewport.contains(at.px))
    };
    corners.into_iter().all(is_in)
}

/// A wide scene of towers far apart. A narrow picture crops it first.
fn wide(folder: &Path) -> PathBuf {
    let path = folder.join("wide.obj");
    let tower = |i: u32| {
        let x = 3 * i;
        format!(
            "v {x} 0 0\nv {} 0 1\nv {x} 2 0\no T{i}\nf -3 -2 -1\n",
            x + 1
        )
    };
    let text: String = (0..40).map(tower).collect();
    std::fs::write(&path, text).expect("writable");
    path
}

#[test]
fn files_open_whole_in_view_whatever_the_window_s_size() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = wide(folder.path());
    for size in [[1280, 720], [800, 600], [1000, 1400], [2560, 1440]] {
        let options = Options {
            paths: vec![path.clone()],
            ..Options::default()
        };
        let mut window = Window::open(options, px(size, 1.0), 1.0);
        assert!(is_whole(&window), "{size:?}");
        // It stays whole when the window is resized, until the view is moved.
        window.resize(px([700, 720], 1.0));
        assert!(is_whole(&window), "{size:?}");
        press_key(&mut window, NONE, Key::Num3);
        let camera = window.state().view().camera.eye();
        window.resize(px([900, 720], 1.0));
        assert_eq!(
            window.state().view().camera.eye(),
            camera,
            "it is the user's now"
        );
    }
}

#[test]
fn nothing_in_view_always_offers_a_way_that_helps() {
    let [nothing, fit] = BETWEEN;
    let planes = [("near", "50", ("far", "100")), ("far", "2", ("near", "1"))];
    for (plane, typed, other) in planes {
        for way in [fit, "A", "Home"] {
            let (mut window, _folder) = row(1.0);
            assert!(!has_control(&window, nothing));
            // The other plane is set first, because near must stay before far.
            for (plane, number) in [other, (plane, typed)] {
                type_into(&mut window, plane, number);
                press_key(&mut window, NONE, Key::Enter);
            }
            assert!(has_control(&window, nothing), "{plane}");
            match way {
                "A" => press_key(&mut window, NONE, Key::A),
                "Home" => press_key(&mut window, NONE, Key::Home),
                button => click_on(&mut window, button),
            }
            assert!(!has_control(&window, nothing), "{plane}: {way} helps");
        }
    }
    let (mut window, _folder) = row(1.0);
    press_key(&mut window, NONE, Key::U);
    click(&mut window, MIDDLE);
    press_key(&mut window, NONE, Key::I);
    press_key(&mut window, Modifiers::SHIFT, Key::H);
    click_on(&mut window, "Show all (U)");
    assert!(
        window
            .state()
            .scene()
            .objects()
            .iter()
            .all(|object| object.visible)
    );
}

/// Two cubes, one before near and one beyond far.
const AROUND: &str = "
[camera]
eye = [0, 0, 10]
target = [0, 0, 0]
near = 20
far = 60

[[object]]
shape = \"cube\"

[[object]]
shape = \"cube\"
position = [0, 0, -100]
";

/// The section of this scene keeps none of its cubes.
const CUT: &str = "
[camera]
eye = [0, 0, 10]
target = [0, 0, 0]
section = \"x:100\"

[[object]]
shape = \"cube\"
";

const BETWEEN: [&str; 2] = [
    "Nothing in view: no object is between near and far",
    "Fit near and far",
];
const SECTION: [&str; 2] = [
    "Nothing in view: the section cuts everything away",
    "Section off (Z)",
];

/// Picks in the picture's middle, whether or not anything is there.
fn sees_something(window: &mut Window) -> bool {
    window.wait_s(1.0);
    click(window, MIDDLE);
    selected(window).is_some()
}

/// The box about all objects may reach into the view where none of them does.
#[test]
fn objects_around_the_view_leave_it_empty() {
    let ways: [fn(&mut Window); 3] = [
        |window| click_on(window, BETWEEN[1]),
        |window| press_key(window, NONE, Key::A),
        |window| click_on(window, "fit near"),
    ];
    for (at, way) in ways.into_iter().enumerate() {
        let (mut window, _folder) = row_as(AROUND, 1.0);
        assert!(has_control(&window, BETWEEN[0]));
        way(&mut window);
        assert!(!has_control(&window, BETWEEN[0]), "{at}");
        assert!(sees_something(&mut window), "{at}");
    }
}

#[test]
fn a_section_may_cut_everything_away() {
    let (mut window, _folder) = row_as(CUT, 1.0);
    assert!(has_control(&window, SECTION[0]));
    click_on(&mut window, SECTION[1]);
    assert!(!has_control(&window, SECTION[0]));
    assert!(sees_something(&mut window));
    press_key(&mut window, CTRL, Key::Z);
    assert!(has_control(&window, SECTION[0]), "undone");
    press_key(&mut window, NONE, Key::Z);
    assert!(!has_control(&window, SECTION[0]));
    // The camera looks away as well: one button brings the scene back.
    press_key(&mut window, CTRL, Key::Z);
    click_on(&mut window, "Pose");
    type_into(&mut window, "target z", "20");
    press_key(&mut window, NONE, Key::Enter);
    click_on(&mut window, SECTION[1]);
    assert!(sees_something(&mut window));
    assert_eq!(window.state().view().section, None);
}

/// In one scene the section keeps one cube, near and far another. In the other the section keeps none, and none is
/// between near and far.
#[test]
fn section_near_and_far_may_leave_nothing_together() {
    let between = "[[object]]\nshape = \"cube\"\nposition = [0, 0, -30]\n";
    for (section, more) in [("z:-5", between), ("x:100", "")] {
        let section = format!("[camera]\nsection = \"{section}\"");
        let text = AROUND.replace("[camera]", &section) + more;
        let (mut window, _folder) = row_as(&text, 1.0);
        assert!(has_control(&window, SECTION[0]));
        click_on(&mut window, SECTION[1]);
        assert!(!has_control(&window, SECTION[0]) && !has_control(&window, BETWEEN[0]));
        assert!(sees_something(&mut window));
    }
}

/// A cube is lost where a speck is all that is left of it.
#[test]
fn a_scene_of_two_pixels_offers_to_come_nearer() {
    const SPECK: &str = "The scene is smaller than two pixels here";
    let at = |z: u32| {
        row_as(
            &format!(
                "[camera]\neye = [0, 0, {z}]\ntarget = [0, 0, 0]\n[[object]]\nshape = \"cube\"\n"
            ),
            1.0,
        )
    };
    let tells_a_step = |window: &Window| {
        (window.controls().iter()).any(|control| control.name.starts_with("grid step"))
    };
    assert!(tells_a_step(&at(5).0));
    let (near, _folder) = at(400);
    assert!(!has_control(&near, SPECK));
    let (mut window, _folder) = at(2000);
    assert!(has_control(&window, SPECK));
    assert!(!tells_a_step(&window), "lines lie closer than pixels");
    // The wheel acts below the hint.
    let eye_z = |window: &Window| window.state().view().camera.eye().z;
    let before = eye_z(&window);
    let farther = events::wheel(egui::vec2(0.0, -50.0), NONE);
    window.send([Event::PointerMoved(MIDDLE), farther]);
    assert!(eye_z(&window) > 1.1 * before, "{}", eye_z(&window));
    assert!(has_control(&window, SPECK));
    click_on(&mut window, "Frame all (A)");
    assert!(!has_control(&window, SPECK));
    assert!(sees_something(&mut window));
}

/// Alt+F is another program's "open the menu", and no F.
#[test]
fn keys_with_alt_do_nothing() {
    let (mut window, _folder) = row(1.0);
    click(&mut window, MIDDLE);
    let before = *window.state().view();
    for key in [Key::F, Key::A, Key::Num3] {
        press_key(&mut window, Modifiers::ALT, key);
        assert_eq!(*window.state().view(), before, "{key:?}");
    }
    press_key(&mut window, NONE, Key::Num3);
    assert_ne!(*window.state().view(), before);
}

#[test]
fn a_scene_too_large_for_the_adapter_is_said_and_the_old_one_stays() {
    use std::fmt::Write;
    let (mut window, folder) = row(1.0);
    let gpu = Gpu::headless().unwrap_or_else(|error| panic!("{error}"));
    window.restrain(Restraint {
        limits: Some(wgpu::Limits {
            max_storage_buffer_binding_size: 1 << 20,
            ..gpu.adapter.limits()
        }),
        ..Restraint::default()
    });
    click(&mut window, MIDDLE);
    press_key(&mut window, NONE, Key::Num9);
    window.draw([]).expect("a frame");
    let before = *window.state().view();
    let mut text = String::new();
    for i in 0..40_000 {
        let _ = writeln!(
            text,
            "[[object]]\nshape = \"sphere\"\nposition = [{i}, 0, 0]"
        );
    }
    let large = folder.path().join("large.toml");
    std::fs::write(&large, text).expect("writable");
    window.drop_file(large);
    window.draw([]).expect_err("it does not fit");
    let picture = window.picture().expect("the old one");
    assert!(window.messages().any(|text| text.contains("the scene's")));
    assert_eq!(window.state().name(), "row.toml");
    assert_eq!(
        (*window.state().view(), selected(&window)),
        (before, Some("front"))
    );
    let lit = picture
        .pixels()
        .iter()
        .filter(|pixel| pixel[0] > 150)
        .count();
    assert!(lit > 5_000, "{lit}: scene and panels are drawn");
    assert!(window.is_at_rest());
    // Its file is still watched.
    std::fs::write(folder.path().join("row.toml"), "").expect("writable");
    remembering::wait_until(&mut window, |window| {
        window.state().scene().objects().is_empty()
    });
}

/// The picture is wider than the texture limit that egui assumes by default.
#[test]
fn a_wide_picture_is_compared() {
    let (mut window, _folder) = row(1.0);
    window.resize(px([2900, 400], 1.0));
    press_key(&mut window, NONE, Key::V);
    // The card of results stands in its place as soon as the window rests. No later frame moves it.
    let mut frames = 0..5_000;
    while !(window.is_at_rest() && has_control(&window, "V closes this")) {
        assert!(frames.next().is_some(), "the check does not end");
        window.draw([]).expect("a frame");
    }
    assert!(window.state().view().viewport.width() > 2048);
    let card = control(&window, "V closes this").rect;
    assert!(
        card.max.y < 400.0 && card.max.x < 2900.0 - 330.0,
        "{card:?}"
    );
    assert_eq!(eye_z(&window), 10.0_f64.to_bits());
}

/// Until a picture is drawn, the comparison waits.
#[test]
fn esc_ends_a_comparison_that_waits_and_nothing_else() {
    let (mut window, _folder) = row(1.0);
    press_key(&mut window, NONE, Key::ArrowDown);
    let before = selected(&window).map(str::to_owned);
    assert!(before.is_some());
    press_key(&mut window, NONE, Key::V);
    press_key(&mut window, NONE, Key::Escape);
    assert_eq!(selected(&window), before.as_deref());
    window.picture().expect("a picture");
    assert!(!has_control(&window, "V closes this"));
    press_key(&mut window, NONE, Key::Escape);
    assert_eq!(selected(&window), None);
}

/// In standard depth `f32` cannot hold such near planes. V says what follows from that, and what to do.
#[test]
fn a_view_beyond_f32_says_what_to_do() {
    let (mut window, _folder) = row(1.0);
    click_under(&mut window, "Depth buffer", "standard");
    let views = [
        ("1", None),
        ("1e-6", Some("f32 is too coarse to draw this view.")),
        ("1e-33", Some("Nothing is drawn where picks hit.")),
    ];
    for (near, said) in views {
        type_into(&mut window, "near", near);
        press_key(&mut window, NONE, Key::Enter);
        press_key(&mut window, NONE, Key::V);
        window.picture().expect("a picture");
        assert!(has_control(&window, "V closes this"), "near {near}");
        let lines = window.controls().iter().map(|control| &control.name);
        let advice: Vec<_> = lines
            .filter(|name| name.contains("sightline render --by raycast"))
            .collect();
        assert_eq!(
            advice.len(),
            usize::from(said.is_some()),
            "near {near}: {advice:?}"
        );
        let says = |text: &&String| said.is_some_and(|said| text.starts_with(said));
        assert!(advice.iter().all(says), "near {near}: {advice:?}");
    }
}

fn eye_z(window: &Window) -> u64 {
    let DVec3 { z, .. } = window.state().view().camera.eye();
    z.to_bits()
}

/// The sliders of near and far run over the depths of the scene: wherever they are let go, something may be in view.
/// One drag is one step of undo.
#[test]
fn near_and_far_slide_over_the_scene() {
    for (name, plane) in [("near, slid", 0), ("far, slid", 1)] {
        let (mut window, _folder) = row(1.0);
        let planes = |window: &Window| {
            let lens = window.state().view().camera.lens();
            [lens.near, lens.far]
        };
        let before = planes(&window);
        let slider = control(&window, name).rect;
        let ends = [slider.left_center(), slider.right_center()];
        let [from, to] = if plane == 0 { ends } else { [ends[1], ends[0]] };
        let along = |share: f32| from + share * (to - from);
        for (share, least, most) in [(0.5, 0.4, 0.6), (0.98, 0.9, 1.0)] {
            drag(
                &mut window,
                PointerButton::Primary,
                along(0.05),
                along(share),
            );
            let slid = (planes(&window)[plane] - before[plane]).abs() / (before[1] - before[0]);
            assert!((least..=most).contains(&slid), "{name} at {share}: {slid}");
            press_key(&mut window, CTRL, Key::Z);
            assert_eq!(
                planes(&window).map(f64::to_bits),
                before.map(f64::to_bits),
                "{name}"
            );
        }
    }
}
