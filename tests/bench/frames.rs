//! How long frames of the whole window take: `cargo bench --bench frames [-- FILE...]`. Without files it shows a
//! terrain of 100,000 triangles. The window is unseen; what a screen adds is its presentation.

mod terrain;

use egui::{Event, PointerButton, pos2};
use sightline::{
    camera::Viewport,
    viewer::{Offscreen, Options},
};
use std::{
    path::PathBuf,
    time::{Duration, Instant},
};

const FRAMES: u16 = 60;
const SIDE: u32 = 224;

/// Over the scene.
const MIDDLE: egui::Pos2 = pos2(580.0, 362.0);
/// Over the list of objects.
const PANEL: egui::Pos2 = pos2(100.0, 140.0);

fn main() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut paths: Vec<PathBuf> = std::env::args_os()
        .skip(1)
        .filter(|argument| argument != "--bench")
        .map(PathBuf::from)
        .collect();
    if paths.is_empty() {
        paths.push(terrain::write(folder.path(), SIDE).expect("a writable folder"));
    }
    let options = Options {
        paths,
        ..Options::default()
    };
    let size = Viewport::new(1280, 720).expect("a viewport");
    let mut window = Offscreen::open(options, size, 1.0);
    let drawn = window.draw().unwrap_or_else(|error| panic!("{error}"));
    assert!(drawn, "the scene is drawn");
    let scene = window.state().scene();
    let (objects, triangles) = (scene.objects().len(), scene.triangle_count());
    println!(
        "{objects} objects, {triangles} triangles, 1280x720, on {}",
        window.adapter_name()
    );

    let step = |i: u16| f32::from(i % 20);
    let at = |i: u16| MIDDLE + egui::vec2(6.0 * step(i), 3.0 * step(i));
    report("panel", false, &mut window, |i| {
        Event::PointerMoved(PANEL + egui::vec2(0.0, step(i)))
    });
    report("hover", false, &mut window, |i| Event::PointerMoved(at(i)));
    window.send([button(true)]);
    report("orbit", true, &mut window, |i| {
        Event::PointerMoved(at(i + 1))
    });
    window.send([button(false)]);
}

fn button(pressed: bool) -> Event {
    Event::PointerButton {
        pos: MIDDLE,
        button: PointerButton::Primary,
        pressed,
        modifiers: egui::Modifiers::NONE,
    }
}

/// Frames after one event each, some of which may need a second pass over the panels.
fn report(name: &str, redraws: bool, window: &mut Offscreen, event: impl Fn(u16) -> Event) {
    let mut times: Vec<Duration> = (0..FRAMES)
        .map(|i| {
            let event = event(i);
            let start = Instant::now();
            let anew = window
                .frame(event)
                .unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(anew, redraws, "{name}: whether the scene is drawn anew");
            start.elapsed()
        })
        .collect();
    times.sort_unstable();
    let ms = |part: f64| {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "an index"
        )]
        let index = (part * f64::from(FRAMES - 1)).round() as usize;
        1e3 * times[index].as_secs_f64()
    };
    println!(
        "{name:6} median {:5.1} ms, 95 of 100 under {:5.1} ms",
        ms(0.5),
        ms(0.95)
    );
}
