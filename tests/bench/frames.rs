//! The cost of the whole window's passes:
//! `cargo bench --bench frames [-- --triangles N,... --objects N,... | FILE...]`. Without arguments: the demo, terrains
//! of 100,000, a million and ten million triangles, 50,000 and 200,000 objects.
//!
//! Prints for each gesture: the window thread's processor time for each pass, without waiting; the time from an event
//! until a picture shows its result, and until no work is left except smooth edges; and the processor time of all
//! threads meanwhile. The window is offscreen, so presentation is not included. "load" is from the drop of a file onto
//! the demo until the file's scene is drawn and at rest. Where `f3d`, `Xvfb` and GNU
//! `time` are installed, a frame of F3D's turn of the same file is measured too, as a difference of two runs.

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
const EVENTS: u16 = 40;
/// Scenes with more triangles get a fifth of the events: each picture takes seconds.
const MANY: usize = 2_000_000;
/// The most passes after one event.
const MOST_PASSES: usize = 20_000;
/// The longest wait for a frame that the panels ask for.
const LONGEST: Duration = Duration::from_hours(1);

/// A cursor over the scene.
const MIDDLE: Pos2 = pos2(590.0, 360.0);
/// A cursor over the world's view among the four.
const PANE: Pos2 = pos2(760.0, 200.0);
/// A cursor over the list of objects.
const PANEL: Pos2 = pos2(100.0, 200.0);

fn main() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut triangles = vec![100_000, 1_000_000, 10_000_000];
    let mut objects = vec![50_000, 200_000];
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

    fn wait_s(&mut self, seconds: f64) {
        self.time_s += seconds;
        self.settle();
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

/// A window, and what its gestures cost.
struct Bench {
    window: Window,
    /// Events of each gesture.
    events: u16,
    /// The thread's time of each pass so far, in milliseconds.
    cpu: Vec<f64>,
}

/// All gestures on a file's scene, which is opened over the demo, or on the demo.
fn scene(file: Option<PathBuf>) {
    let mut bench = Bench {
        window: Window::open(),
        events: EVENTS,
        cpu: Vec::new(),
    };
    if let Some(file) = file {
        bench.window.begin_to_drop(file);
    }
    let mut costs = Costs::default();
    costs.of(&mut bench.window, Event::PointerMoved(MIDDLE));
    let scene = bench.window.program.state().scene();
    let (objects, triangles) = (scene.objects().len(), scene.triangle_count());
    println!("{objects} objects, {triangles} triangles, 1280x720");
    if triangles > MANY {
        bench.events /= 5;
    }
    // The first pictures still showed the demo.
    costs.shown.clone_from(&costs.done);
    bench.report("load", costs);

    let step = |i: u16| f32::from(i % 20);
    let at = |i: u16| MIDDLE + vec2(6.0 * step(i), 3.0 * step(i));
    bench.moves("panel", |i| PANEL + vec2(0.0, step(i)));
    bench.moves("hover", at);
    (bench.window).send([Event::PointerMoved(MIDDLE), button(MIDDLE, true)]);
    bench.moves("turn", |i| at(i + 1));
    bench.window.send([button(at(bench.events), false)]);

    let mut costs = Costs::default();
    for i in 0..bench.events / 4 {
        bench.window.wait_s(1.0);
        let at = at(i);
        bench
            .window
            .send([Event::PointerMoved(at), button(at, true)]);
        costs.of(&mut bench.window, button(at, false));
    }
    bench.report("click", costs);

    bench.press(Key::F);
    if bench.window.program.state().selection().is_some() {
        bench.place();
        bench.keyed(
            "hide",
            [(Modifiers::SHIFT, Key::H), (Modifiers::NONE, Key::U)],
        );
        bench
            .window
            .send([button(MIDDLE, true), button(MIDDLE, false)]);
        bench.keyed(
            "isolate",
            [Key::I, Key::U].map(|key| (Modifiers::NONE, key)),
        );
    }
    bench.press(Key::P);
    for stage in ["object", "world", "view", "NDC", "four", "picture"] {
        let mut costs = Costs::default();
        let at = bench.window.named(&format!("show {stage}")).center();
        (bench.window).send([Event::PointerMoved(at), button(at, true)]);
        costs.of(&mut bench.window, button(at, false));
        bench.report(stage, costs);
        if stage == "four" {
            bench
                .window
                .send([Event::PointerMoved(PANE), button(PANE, true)]);
            bench.moves("turn one", |i| PANE + vec2(step(i + 1), step(i + 1)));
            bench.window.send([button(PANE, false)]);
        }
    }
    bench.cpu.sort_unstable_by(f64::total_cmp);
    let [most, worst] = [0.99, 1.0].map(|share| at_share(&bench.cpu, share));
    let passes = bench.cpu.len();
    println!("all gestures: {passes} passes, 99 % {most:.2} ms, worst {worst:.2}");
    println!("on {}\n", bench.window.program.adapter_name());
}

impl Bench {
    /// Moves of the mouse.
    fn moves(&mut self, name: &str, at: impl Fn(u16) -> Pos2) {
        let mut costs = Costs::default();
        for i in 0..self.events {
            costs.of(&mut self.window, Event::PointerMoved(at(i)));
        }
        self.report(name, costs);
    }

    /// Drags at a letter of the selected object's matrix.
    fn place(&mut self) {
        let header = self.window.named("Model matrix").center();
        self.window.send([
            Event::PointerMoved(header),
            button(header, true),
            button(header, false),
        ]);
        // The letter is to the left of its field.
        let field = self.window.named("position x");
        let letter = field.left_center() - vec2(6.0, 0.0);
        (self.window).send([Event::PointerMoved(letter), button(letter, true)]);
        self.moves("matrix", |i| letter + vec2(f32::from(i + 4), 0.0));
        self.window.send([button(letter, false)]);
    }

    fn keyed(&mut self, name: &str, keys: [(Modifiers, Key); 2]) {
        let mut costs = Costs::default();
        for _ in 0..self.events / 8 {
            for (modifiers, key) in keys {
                costs.of(&mut self.window, pressed(modifiers, key));
            }
        }
        self.report(name, costs);
    }

    fn press(&mut self, key: Key) {
        self.window.send([pressed(Modifiers::NONE, key)]);
    }

    fn report(&mut self, name: &str, costs: Costs) {
        self.cpu.extend(&costs.cpu);
        costs.report(name);
    }
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

/// Times of passes, in milliseconds.
#[derive(Default)]
struct Costs {
    /// The thread's processor time of each pass.
    cpu: Vec<f64>,
    /// From each event until a picture showed it.
    shown: Vec<f64>,
    /// From each event until nothing was left to do.
    done: Vec<f64>,
    /// The processor time of all threads meanwhile.
    all: Vec<f64>,
}

impl Costs {
    /// Runs an event's pass and those that follow from it.
    fn of(&mut self, window: &mut Window, event: Event) {
        let (start, worked) = (Instant::now(), worked_ms(ClockId::ProcessCPUTime));
        let (mut event, mut shown) = (Some(event), None);
        for _ in 0..MOST_PASSES {
            let before = worked_ms(ClockId::ThreadCPUTime);
            window.draw(event.take().into_iter().collect());
            self.cpu.push(worked_ms(ClockId::ThreadCPUTime) - before);
            if shown.is_none() && window.program.shows_scene() {
                shown = Some(1e3 * start.elapsed().as_secs_f64());
            }
            if window.program.is_settled() {
                break;
            }
            window.wait();
        }
        self.shown.extend(shown);
        self.done.push(1e3 * start.elapsed().as_secs_f64());
        self.all.push(worked_ms(ClockId::ProcessCPUTime) - worked);
    }

    fn report(mut self, name: &str) {
        for times in [
            &mut self.cpu,
            &mut self.shown,
            &mut self.done,
            &mut self.all,
        ] {
            times.sort_unstable_by(f64::total_cmp);
        }
        let [median, most, worst] = [0.5, 0.99, 1.0].map(|share| at_share(&self.cpu, share));
        let [shown, late, done, last] = [
            at_share(&self.shown, 0.5),
            at_share(&self.shown, 1.0),
            at_share(&self.done, 0.5),
            at_share(&self.done, 1.0),
        ];
        println!(
            "{name:9} {:4} passes of {median:5.2} ms, 99 % {most:5.2}, worst {worst:5.2}; shown after {shown:6.1}, at worst {late:6.1}; done {done:6.1}, {last:6.1}; all threads {:6.1}",
            self.cpu.len(),
            at_share(&self.all, 0.5)
        );
    }
}

/// The time that a share of the sorted times does not exceed.
fn at_share(times: &[f64], share: f64) -> f64 {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "an index"
    )]
    let index = (share * (times.len() - 1) as f64).ceil() as usize;
    times[index]
}

/// Processor time of this thread, or of all.
fn worked_ms(of: ClockId) -> f64 {
    let time = clock_gettime(of);
    #[expect(clippy::cast_precision_loss, reason = "milliseconds")]
    let [s, ns] = [time.tv_sec as f64, time.tv_nsec as f64];
    1e3 * s + 1e-6 * ns
}
