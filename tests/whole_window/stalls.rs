//! Work that takes long is done in the background, and the window answers meanwhile.

use super::*;
use std::{
    fmt::Write,
    time::{Duration, Instant},
};

/// Cells along each side of a ground.
const SIDE: u32 = 250;

/// Far longer than any load here takes.
const LONGEST_LOAD: Duration = Duration::from_mins(5);

/// Rolling ground of two triangles a cell.
pub(super) fn ground(folder: &Path, side: u32) -> PathBuf {
    let mut text = String::new();
    for (z, x) in (0..=side).flat_map(|z| (0..=side).map(move |x| (z, x))) {
        let y = (f64::from(x) * 0.1).sin() * 4.0;
        let _ = writeln!(text, "v {x} {y:.4} {z}");
    }
    for a in (0..side).flat_map(|z| (1..=side).map(move |x| z * (side + 1) + x)) {
        let (b, c, d) = (a + 1, a + side + 1, a + side + 2);
        let _ = writeln!(text, "f {a} {c} {b}\nf {b} {c} {d}");
    }
    let path = folder.join("ground.obj");
    std::fs::write(&path, text).expect("writable");
    path
}

/// A window that shows such a ground, and its file.
pub(super) fn opened(side: u32) -> (Window, TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = ground(folder.path(), side);
    let mut window = open(vec![path.clone()], 1.0);
    window.picture().expect("a picture");
    (window, folder, path)
}

/// Many objects.
pub(super) const MANY: usize = 20_000;

/// A scene file of `count` cubes and spheres.
pub(super) fn many(folder: &Path, count: usize) -> PathBuf {
    let mut text = String::new();
    for i in 0..count {
        let shape = if i % 100 == 0 { "sphere" } else { "cube" };
        let (x, z) = (i % 150, i / 150);
        let _ = writeln!(
            text,
            "[[object]]\nshape = \"{shape}\"\nposition = [{x}, 0, {z}]"
        );
    }
    let path = folder.join("many.toml");
    std::fs::write(&path, text).expect("writable");
    path
}

#[test]
fn ndc_of_many_objects_follows_the_camera_at_once() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = open(vec![many(folder.path(), MANY)], 1.0);
    window.picture().expect("a picture");
    press_key(&mut window, Modifiers::NONE, Key::Num4);
    // Each frame of a camera that does not stop shows NDC anew.
    let [first, second] = [Key::Num7, Key::Num1].map(|key| {
        window.draw([press(key)]).expect("a frame");
        window.drawn().expect("a picture")
    });
    let differ = differing_in(&first, &second, control(&window, "stage NDC").rect);
    assert!(differ > 3000, "{differ}");
    assert_eq!(window.messages().count(), 0);
}

/// The stages share one mesh in graphics memory with the picture.
#[test]
fn a_stage_uploads_no_triangle_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = open(vec![ground(folder.path(), SIDE)], 1.0);
    // The matrices are open from the start, so the picture keeps its size.
    press_key(&mut window, Modifiers::NONE, Key::P);
    window.picture().expect("a picture");
    let whole = window.state().scene().triangle_count() as u64;
    assert_eq!(window.uploaded_triangles(), whole);
    for stage in ["NDC", "object", "world", "view", "four"] {
        click_on(&mut window, &format!("show {stage}"));
        window.picture().expect("a picture");
        assert_eq!(window.uploaded_triangles(), whole, "{stage}");
    }
}

#[test]
fn a_large_file_is_shown_once_the_adapter_has_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = ground(folder.path(), SIDE);
    let (mut window, _row) = row(1.0);
    window.picture().expect("a picture");
    window.drop_file(path.clone());
    assert_eq!(window.state().name(), "ground.obj");
    let dropped = window.picture().expect("a picture");
    let fresh = open(vec![path], 1.0).picture().expect("a picture");
    assert_eq!(dropped.pixels(), fresh.pixels());
}

/// How much of a load is done by its bar, in per cent; `None` while there is no bar.
fn loaded_percent(window: &Window) -> Option<f64> {
    let mut all = window.controls().iter();
    let bar = all.find(|control| control.name == "loading")?;
    bar.value.parse().ok()
}

/// Draws frames until the bar of a load has passed this share, in per cent. Returns whether it ever had: the load may
/// have ended before a frame could show that.
fn is_loaded_beyond(window: &mut Window, share: f64) -> bool {
    let begun = Instant::now();
    loop {
        window.draw([Event::PointerGone]).expect("a frame");
        // What cannot be loaded is told.
        let said: Vec<_> = window.messages().collect();
        assert!(said.is_empty(), "{said:?}");
        if window.state().name() != "row.toml" {
            return false;
        }
        let percent = loaded_percent(window);
        if percent >= Some(share) {
            return true;
        }
        assert!(begun.elapsed() < LONGEST_LOAD, "{percent:?} per cent");
    }
}

/// While a scene file of many objects is read, the window shows how much is done. The load can be cancelled, and then
/// the old scene stays.
#[test]
fn a_scene_of_many_objects_tells_its_progress_and_can_be_cancelled() {
    type Way = fn(&Window) -> Vec<Event>;
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("very_many.toml");
    let object = "[[object]]\nshape = \"cube\"\nposition = [1, 2, 3]\n";
    let ways: [(&str, Way); 2] = [
        ("Esc", |_| vec![press(Key::Escape)]),
        ("the button", |window| {
            let at = control(window, "Cancel").rect.center();
            let press = |pressed| button(at, PointerButton::Primary, pressed);
            vec![Event::PointerMoved(at), press(true), press(false)]
        }),
    ];
    // The load goes on while the window draws. If it ends before it is cancelled, a longer one is tried.
    let is_cancelled = |events: Way, count: usize| {
        std::fs::write(&path, object.repeat(count)).expect("writable");
        let (mut window, _row) = row(1.0);
        window.picture().expect("a picture");
        window.begin_to_drop(path.clone());
        // Parsing the text comes first and is half of the work.
        if !is_loaded_beyond(&mut window, 55.0) {
            return false;
        }
        for event in events(&window) {
            window.draw([event]).expect("a frame");
        }
        window.send([Event::PointerGone]);
        assert_eq!(loaded_percent(&window), None);
        assert_eq!(window.messages().count(), 0);
        let (name, objects) = (window.state().name(), window.state().scene().objects());
        let is_old = (name, objects.len()) == ("row.toml", 3);
        assert!(
            is_old || (name, objects.len()) == ("very_many.toml", count),
            "{name}"
        );
        is_old
    };
    for (way, events) in ways {
        let is_ever = [200_000, 400_000, 800_000]
            .into_iter()
            .any(|count| is_cancelled(events, count));
        assert!(
            is_ever,
            "{way}: each load ended as if nothing had been done"
        );
    }
}

/// Draws frames until Esc has ended opening a file, at a share of it that its bar shows. Returns false if the file was
/// there before that.
fn is_ended(window: &mut Window) -> bool {
    let begun = Instant::now();
    loop {
        window.draw([Event::PointerGone]).expect("a frame");
        if window.state().name() != "row.toml" {
            return false;
        }
        let share = loaded_percent(window);
        if share.is_some_and(|share| 0.0 < share && share < 100.0) {
            window.draw([press(Key::Escape)]).expect("a frame");
            window.draw([Event::PointerGone]).expect("a frame");
            return window.state().name() == "row.toml";
        }
        assert!(begun.elapsed() < LONGEST_LOAD, "{share:?}");
    }
}

/// Esc ends reading a mesh file. The old scene stays, and what was given up is not uploaded later.
#[test]
fn esc_ends_reading_a_mesh() {
    let folder = tempfile::tempdir().expect("a folder");
    // The work goes on while the window draws. If it is done before Esc, a larger file is tried.
    let is_ever = [450, 900, 1800].into_iter().any(|side| {
        let large = ground(folder.path(), side);
        let (mut window, _row) = row(1.0);
        window.picture().expect("a picture");
        window.begin_to_drop(large.clone());
        if !is_ended(&mut window) {
            return false;
        }
        assert_eq!(
            (loaded_percent(&window), window.messages().count()),
            (None, 0)
        );
        assert_eq!(window.uploaded_triangles(), 0);
        window.send([]);
        assert_eq!(window.state().name(), "row.toml");
        // To open it takes longer than what is left of a load that goes on.
        window.drop_file(large);
        window.picture().expect("a picture");
        let whole = window.state().scene().triangle_count() as u64;
        assert_eq!(whole, 2 * u64::from(side * side));
        assert_eq!(window.uploaded_triangles(), whole);
        true
    });
    assert!(is_ever, "it was always too late");
}

/// A pass lays out only the rows in view, however many objects there are. A frame without a change draws no scene.
#[test]
fn a_pass_over_many_objects_lays_out_what_one_over_few_does() {
    let folder = tempfile::tempdir().expect("a folder");
    let controls = |count| {
        let mut window = open(vec![many(folder.path(), count)], 1.0);
        press_key(&mut window, Modifiers::NONE, Key::ArrowDown);
        assert_eq!(window.state().scene().objects().len(), count);
        window.picture().expect("a picture");
        assert!(!window.draw([]).expect("a frame"), "nothing had changed");
        window.controls().len()
    };
    assert_eq!(controls(MANY), controls(200));
}
