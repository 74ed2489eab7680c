//! While a large file is added or read again, the window answers, and no frame draws more than its share.

use super::*;
use egui::vec2;
use sightline::pick;

/// Cells along each side of a ground of 1,280,000 triangles. Its load takes longer than a few frames, and it is drawn in
/// several pieces, even after pieces have grown.
const SIDE: u32 = 800;
/// A point of the picture that shows no object.
const NOTHING: Pos2 = pos2(480.0, 80.0);

/// Counts over the frames until the new scene was there.
#[derive(Debug, Default)]
struct Seen {
    /// Frames that showed the old scene.
    before: usize,
    /// Frames that drew a part of the new scene.
    pieces: usize,
    /// The most that one frame drew.
    most: u64,
    drawn: u64,
}

/// The middle of the scene's picture on screen.
fn middle(window: &Window) -> Vec<[u8; 3]> {
    let picture = window.drawn().expect("a picture");
    let inner = (200..520).flat_map(|y| (450..730).map(move |x| (x, y)));
    inner.map(|(x, y)| picture.at(x, y)).collect()
}

/// Draws frames with a moving mouse until a new scene is loaded and drawn. Until then the old picture must show.
fn watch(window: &mut Window, old: &[[u8; 3]]) -> Seen {
    let revision = window.state().scene_revision();
    let mut seen = Seen::default();
    let mut cursor = None;
    for i in 0..100_000_u32 {
        let at = NOTHING + vec2(f32::from((i % 2) as u8), 0.0);
        window.draw([Event::PointerMoved(at)]).expect("a frame");
        let moved = window.state().cursor().map(|cursor| cursor.px);
        assert!(moved.is_some() && moved != cursor, "the mouse is followed");
        cursor = moved;
        let is_there = window.state().scene_revision() != revision;
        if is_there {
            seen.pieces += usize::from(window.drawn_work() > 0);
            seen.most = seen.most.max(window.drawn_work());
            seen.drawn += window.drawn_work();
            if window.shows_scene() {
                return seen;
            }
        } else {
            seen.before += 1;
            std::thread::sleep(std::time::Duration::from_millis(2));
        }
        if is_there || i % 64 == 0 {
            assert!(middle(window) == old, "the old picture stays: {seen:?}");
        }
    }
    panic!("it comes to an end: {seen:?}");
}

/// Fails unless the work was spread over frames.
fn check(window: &Window, seen: &Seen, objects: usize) {
    let whole = 2 * u64::from(SIDE * SIDE);
    assert!(seen.before > 1 && seen.drawn >= whole, "{seen:?}");
    if window.is_software() {
        assert!(seen.pieces > 1 && seen.most <= 3 * whole / 4, "{seen:?}");
    }
    assert_eq!(window.state().scene().objects().len(), objects);
    assert_eq!(window.messages().count(), 0);
}

#[test]
fn what_is_large_is_added_in_shares() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = stalls::ground(folder.path(), SIDE);
    let (mut window, _row) = row(1.0);
    window.picture().expect("a picture");
    let old = middle(&window);
    window.send([Event::ModifiersChanged(Modifiers::SHIFT)]);
    window.begin_to_drop(path);
    let released = Event::ModifiersChanged(Modifiers::NONE);
    window.draw([released]).expect("a frame");
    let seen = watch(&mut window, &old);
    check(&window, &seen, 4);
}

#[test]
fn what_is_large_is_read_again_in_shares() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = stalls::ground(folder.path(), SIDE);
    let mut window = open(vec![path.clone()], 1.0);
    window.picture().expect("a picture");
    let old = middle(&window);
    // One more triangle, since an object that has not changed stays as it is.
    let text = std::fs::read_to_string(&path).expect("a file");
    std::fs::write(&path, text + &format!("f 1 2 {}\n", SIDE + 2)).expect("writable");
    window.draw([press(Key::R)]).expect("a frame");
    let seen = watch(&mut window, &old);
    check(&window, &seen, 1);
}

#[test]
fn a_large_stage_is_shown() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = open(vec![stalls::many(folder.path(), stalls::MANY)], 1.0);
    press_key(&mut window, Modifiers::NONE, Key::P);
    window.picture().expect("a picture");
    for stage in ["view", "NDC", "picture"] {
        let before = window.drawn().expect("a picture");
        click_on(&mut window, &format!("show {stage}"));
        let is_shown = (0..100_000).any(|_| {
            window.draw([]).expect("a frame");
            window.shows_scene()
        });
        assert!(is_shown, "{stage}");
        let picture = egui::Rect::from_center_size(MIDDLE, vec2(300.0, 300.0));
        let differ = differing_in(&before, &window.drawn().expect("a picture"), picture);
        assert!(differ > 3000, "{stage}: {differ}");
    }
}

/// What is seen is what is picked: until the new scene is drawn, a click on its place in the old picture picks nothing.
#[test]
fn what_is_not_drawn_yet_is_not_picked() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = stalls::ground(folder.path(), SIDE);
    let (mut window, _row) = row(1.0);
    window.picture().expect("a picture");
    window.begin_to_drop(path);
    let is_there = |window: &Window| window.state().scene().objects().len() == 1;
    for _ in 0..100_000 {
        if is_there(&window) {
            break;
        }
        window.draw([]).expect("a frame");
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    assert!(is_there(&window));
    if window.shows_scene() {
        assert!(!window.is_software(), "software takes longer");
        return;
    }
    let says_so = |window: &Window| window.controls().iter().any(|is| is.name == "drawing");
    assert!(!says_so(&window), "it is not late yet");
    click(&mut window, MIDDLE);
    let state = window.state();
    assert_eq!(state.selection(), None);
    let cursor = state.cursor().expect("over the picture");
    assert_eq!(cursor.hit, None);
    let under_it = pick::pick(state.scene(), state.view(), cursor.px);
    assert!(under_it.is_some(), "the new scene has something there");
    window.wait_s(0.6);
    assert!(says_so(&window), "it is late");
    window.picture().expect("a picture");
    assert!(!says_so(&window));
    click(&mut window, MIDDLE);
    assert_eq!(window.state().selected(), Some(0));
}
