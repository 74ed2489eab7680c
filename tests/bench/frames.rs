//! What the whole window's frames take:
//! `cargo bench --bench frames [-- --triangles N,... --objects N,... | FILE...]`. Without arguments: the demo, terrains
//! of 100,000, a million and ten million triangles, 200,000 objects.
//!
//! Prints for each gesture the frame of an event, from the event until its picture is whole: median and worst, and the
//! processor time of the window's thread in it. Below them stands what must hold. "load" is from the drop of a file onto
//! the demo until its picture is shown, "rest" the picture once the scene has stopped moving. The window is offscreen,
//! so presentation is not included. Where `f3d`, `Xvfb` and GNU `time` are installed, a frame of F3D's turn of the same
//! file is measured too, as a difference of two runs.

#[path = "../common/dropped.rs"]
mod dropped;
#[expect(dead_code, reason = "another benchmark asks more of it")]
mod f3d;
mod terrain;

use dropped::Dropped;
use egui::{Context, Event, Key, Modifiers, PointerButton, Pos2, RawInput, Rect, pos2, vec2};
use f3d::F3d;
use rustix::time::{ClockId, clock_gettime};
use sightline::{
    camera::Viewport,
    viewer::{Frame, Offscreen, Options},
};
use std::{
    fmt::Write,
    fs,
    path::{Path, PathBuf},
    sync::{Arc, Mutex, MutexGuard, PoisonError},
    time::{Duration, Instant},
};

/// Size of the window.
const SIZE: Viewport = Viewport::DEFAULT;
/// Events of each gesture.
const EVENTS: u16 = 20;
/// The longest wait for a frame that the panels ask for.
const LONGEST: Duration = Duration::from_hours(1);

/// A cursor over the scene.
const MIDDLE: Pos2 = pos2(590.0, 360.0);

fn main() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut triangles = vec![100_000, 1_000_000, 10_000_000];
    let mut objects = vec![200_000];
    let mut files: Vec<PathBuf> = Vec::new();
    let mut args = std::env::args().skip(1).filter(|arg| arg != "--bench");
    let numbers = |text: Option<String>| -> Vec<u32> {
        let text = text.expect("numbers");
        let words = text.split(',').filter(|word| !word.is_empty());
        words.map(|word| word.parse().expect("a number")).collect()
    };
    while let Some(arg) = args.next() {
        match arg.as_str() {
            "--triangles" => triangles = numbers(args.next()),
            "--objects" => objects = numbers(args.next()),
            _ => files.push(arg.into()),
        }
    }
    if !files.is_empty() {
        return files.into_iter().for_each(|file| scene(Some(file)));
    }
    scene(None);
    for triangles in triangles {
        let side = (f64::from(triangles) / 2.0).sqrt().round();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "below 2^16"
        )]
        let side = side as u32;
        let file = terrain::write(folder.path(), side).expect("a writable folder");
        scene(Some(file.clone()));
        turn_by_f3d(&file);
    }
    for objects in objects {
        scene(Some(grid(folder.path(), objects)));
    }
}

/// Prints what a frame of a turn takes another viewer.
fn turn_by_f3d(file: &Path) {
    let size = [SIZE.width(), SIZE.height()];
    let turned = F3d::find(size).and_then(|f3d| f3d.map(|f3d| f3d.turn_ms(file)).transpose());
    match turned {
        Ok(Some(ms)) => println!("F3D's turn: {ms:.1} ms a frame\n"),
        Ok(None) => println!("F3D: absent\n"),
        Err(error) => println!("F3D: {error}\n"),
    }
}

/// Cubes and balls in turn on a square, as a scene file.
fn grid(folder: &Path, objects: u32) -> PathBuf {
    let side = f64::from(objects).sqrt().ceil();
    let mut text = String::new();
    for i in 0..objects {
        let (x, z) = (f64::from(i) % side, (f64::from(i) / side).floor());
        let shape = if i % 2 == 0 { "cube" } else { "sphere" };
        let _ = writeln!(
            text,
            "[[object]]\nshape = \"{shape}\"\nposition = [{x}, 0, {z}]\nscale = 0.8"
        );
    }
    let file = folder.join("grid.toml");
    fs::write(&file, text).expect("a writable folder");
    file
}

/// The program, run as a window runs it, with a clock of its own.
struct Window {
    program: Offscreen,
    context: Context,
    time_s: f64,
    /// When the panels want their next frame.
    due: Arc<Mutex<Option<Instant>>>,
}

impl Window {
    /// It shows the demo, and all its pipelines are made: a window does this in its first seconds.
    fn open() -> Self {
        let (context, due) = (Context::default(), Arc::new(Mutex::new(None)));
        let asked = Arc::clone(&due);
        context.set_request_repaint_callback(move |info| {
            let at = Instant::now() + info.delay.min(LONGEST);
            let mut due = asked.lock().unwrap_or_else(PoisonError::into_inner);
            *due = Some(due.map_or(at, |due: Instant| due.min(at)));
        });
        let mut window = Self {
            program: Offscreen::open(Options::default(), context.clone()),
            context,
            time_s: 0.0,
            due,
        };
        window.settle();
        window.program.prepare_all();
        window
    }

    /// The frame after these events.
    fn draw(&mut self, events: Vec<Event>) -> Frame {
        self.draw_after(|input| input.events = events)
    }

    /// The frame after an input that `tell` fills.
    fn draw_after(&mut self, tell: impl FnOnce(&mut RawInput)) -> Frame {
        *self.due() = None;
        self.time_s += 1.0 / 60.0;
        let mut input = Offscreen::input_at(self.time_s, SIZE);
        tell(&mut input);
        let frame = self.program.frame(input, SIZE);
        if let Err(error) = &frame.drawn {
            panic!("{error}");
        }
        frame
    }

    fn due(&self) -> MutexGuard<'_, Option<Instant>> {
        self.due.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Waits until the next frame is due, or a job has a result.
    fn wait(&mut self) {
        while self.due().is_none_or(|due| Instant::now() < due) {
            if self.program.wait_for_jobs() {
                return;
            }
        }
    }

    /// Draws a frame after each event, and then until nothing is left to do except smooth edges.
    fn send(&mut self, events: impl IntoIterator<Item = Event>) {
        for event in events {
            self.draw(vec![event]);
        }
        self.settle();
    }

    fn settle(&mut self) {
        loop {
            self.program.finish_jobs();
            self.draw(Vec::new());
            if self.program.is_settled() {
                return;
            }
        }
    }

    /// Lets the scene rest, until its picture is as good as it gets.
    fn rest(&mut self) {
        self.time_s += 1.0;
        self.draw(Vec::new());
        while self.program.is_rough() {
            self.draw(Vec::new());
        }
    }

    /// Moves of the mouse.
    fn moves(&mut self, at: impl Fn(u16) -> Pos2) -> Frames {
        let mut frames = Frames::default();
        for i in 0..EVENTS {
            let moved = vec![Event::PointerMoved(at(i))];
            frames.add(self, |window| {
                drop(window.draw(moved));
            });
        }
        frames
    }

    /// Presses at a letter of the selected object's matrix. Returns where that is.
    fn begin_to_place(&mut self) -> Pos2 {
        let header = self.named("Model matrix").center();
        self.send([
            Event::PointerMoved(header),
            button(header, true),
            button(header, false),
        ]);
        // The letter is to the left of its field.
        let letter = self.named("position x").left_center() - vec2(6.0, 0.0);
        self.send([Event::PointerMoved(letter), button(letter, true)]);
        letter
    }

    /// Drops a file on the window, and waits for nothing.
    fn begin_to_drop(&mut self, path: PathBuf) {
        self.draw_after(|input| input.dropped_files = vec![Arc::new(Dropped(path))]);
    }

    /// Where a control is. No assistive program asks for the controls at other times.
    fn named(&mut self, name: &str) -> Rect {
        self.context.enable_accesskit();
        let tree = self.draw(Vec::new()).platform.accesskit_update;
        self.context.disable_accesskit();
        let nodes = tree.expect("a tree").nodes;
        let node = nodes.iter().find(|(_, node)| node.label() == Some(name));
        let bounds = node.and_then(|(_, node)| node.bounds());
        let bounds = bounds.unwrap_or_else(|| panic!("no {name}"));
        #[expect(clippy::cast_possible_truncation, reason = "egui made them of f32")]
        let [left, top, right, bottom] =
            [bounds.x0, bounds.y0, bounds.x1, bounds.y1].map(|at| at as f32);
        Rect::from_min_max(pos2(left, top), pos2(right, bottom))
    }
}

/// All gestures on a file's scene, which is opened over the demo, or on the demo.
fn scene(file: Option<PathBuf>) {
    let mut window = Window::open();
    let mut load = Frames::default();
    if let Some(file) = file {
        let before = window.program.state().scene().objects().len();
        let began = Instant::now();
        window.begin_to_drop(file);
        while window.program.state().scene().objects().len() == before {
            window.wait();
            window.draw(Vec::new());
        }
        load.wall_ms.push(1e3 * began.elapsed().as_secs_f64());
        load.cpu_ms.push(0.0);
        window.settle();
    }
    let scene = window.program.state().scene();
    let (objects, triangles) = (scene.objects().len(), scene.triangle_count());
    println!("{objects} objects, {triangles} triangles, 1280x720");
    load.report("load");
    let floor = Floor::of(window.program.is_software(), objects, triangles);
    let step = |i: u16| f32::from(i % 20);
    let at = |i: u16| MIDDLE + vec2(6.0 * step(i), 3.0 * step(i));
    window.send([Event::PointerMoved(MIDDLE)]);
    window.rest();
    let mut rests = Frames::default();

    window.moves(at).report("hover");

    window.send([Event::PointerMoved(MIDDLE), button(MIDDLE, true)]);
    let turn = window.moves(|i| at(i + 1));
    window.send([button(at(EVENTS), false)]);
    rests.add(&mut window, Window::rest);
    turn.report("turn");
    floor.check(&turn, floor.turn_ms);

    let mut click = Frames::default();
    for i in 0..EVENTS / 2 {
        let at = at(i);
        window.send([Event::PointerMoved(at), button(at, true)]);
        window.rest();
        click.add(&mut window, |window| {
            drop(window.draw(vec![button(at, false)]));
        });
    }
    click.report("click");
    floor.check(&click, floor.click_ms);

    window.send([pressed(Modifiers::NONE, Key::F)]);
    window.rest();
    if window.program.state().selection().is_some() {
        let letter = window.begin_to_place();
        window
            .moves(|i| letter + vec2(f32::from(i + 4), 0.0))
            .report("matrix");
        window.send([button(letter, false)]);
        rests.add(&mut window, Window::rest);
        let mut hide = Frames::default();
        for _ in 0..EVENTS / 4 {
            for (modifiers, key) in [(Modifiers::SHIFT, Key::H), (Modifiers::NONE, Key::U)] {
                hide.add(&mut window, |window| {
                    drop(window.draw(vec![pressed(modifiers, key)]));
                });
                rests.add(&mut window, Window::rest);
            }
        }
        hide.report("hide");
    }
    rests.report("rest");
    println!("on {}\n", window.program.adapter_name());
}

/// What frames must hold.
struct Floor {
    is_software: bool,
    turn_ms: f64,
    click_ms: f64,
}

impl Floor {
    /// On a card the window's thread works for at most 8 ms, 33 with 200,000 objects. A software adapter shows turns and
    /// clicks within 50 ms; clicks on ten million triangles within 80.
    fn of(is_software: bool, objects: usize, triangles: usize) -> Self {
        let card_ms = if objects < 100_000 { 8.0 } else { 33.0 };
        let [turn_ms, click_ms] = match (is_software, triangles > 5_000_000) {
            (false, _) => [card_ms; 2],
            (true, false) => [50.0; 2],
            (true, true) => [50.0, 80.0],
        };
        Self {
            is_software,
            turn_ms,
            click_ms,
        }
    }

    /// Prints whether the median of some frames holds.
    fn check(&self, frames: &Frames, most_ms: f64) {
        let (what, took) = if self.is_software {
            ("shown within", &frames.wall_ms)
        } else {
            ("at most of the thread:", &frames.cpu_ms)
        };
        let holds = if median(took) <= most_ms {
            "holds"
        } else {
            "MISSED"
        };
        println!("          {what} {most_ms} ms: {holds}");
    }
}

/// What frames took, in milliseconds: from event to picture, and of the window's thread.
#[derive(Default)]
struct Frames {
    wall_ms: Vec<f64>,
    cpu_ms: Vec<f64>,
}

impl Frames {
    /// Does something to a window, and notes what that took.
    fn add(&mut self, window: &mut Window, something: impl FnOnce(&mut Window)) {
        let (began, worked) = (Instant::now(), thread_ms());
        something(window);
        self.wall_ms.push(1e3 * began.elapsed().as_secs_f64());
        self.cpu_ms.push(thread_ms() - worked);
    }

    fn report(&self, name: &str) {
        if self.wall_ms.is_empty() {
            return;
        }
        let [[wall, late], [cpu, most]] = [&self.wall_ms, &self.cpu_ms]
            .map(|took| [median(took), took.iter().copied().fold(0.0, f64::max)]);
        println!(
            "{name:8} {:3} frames of {wall:7.1} ms, worst {late:7.1}; thread {cpu:6.1}, {most:6.1}",
            self.wall_ms.len()
        );
    }
}

fn median(took: &[f64]) -> f64 {
    let mut sorted = took.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    sorted[sorted.len() / 2]
}

fn pressed(modifiers: Modifiers, key: Key) -> Event {
    Event::Key {
        key,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers,
    }
}

fn button(pos: Pos2, pressed: bool) -> Event {
    Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    }
}

/// Processor time of this thread so far.
fn thread_ms() -> f64 {
    let time = clock_gettime(ClockId::ThreadCPUTime);
    #[expect(clippy::cast_precision_loss, reason = "milliseconds")]
    let [s, ns] = [time.tv_sec as f64, time.tv_nsec as f64];
    1e3 * s + 1e-6 * ns
}
