//! For a click, the real window picks what `sightline pick` prints for the same view. The window runs under Xvfb and
//! gets real pointer events.
#![cfg(feature = "window")]

mod clipboard;
#[cfg(target_os = "linux")]
mod display_gone;
#[path = "../common/images.rs"]
mod images;
mod refusals;

use std::{
    io::{BufRead, BufReader, Read},
    path::{Path, PathBuf},
    process::{Child, Command, Stdio},
    sync::mpsc::{Receiver, channel},
    thread,
    time::Duration,
};

/// The longest wait for the window to answer. It allows for a first frame on a busy machine.
const PATIENCE: Duration = Duration::from_mins(1);
/// Longer than a double click takes.
const APART: Duration = Duration::from_millis(600);
const SIGHTLINE: &str = env!("CARGO_BIN_EXE_sightline");

/// A virtual screen, which ends when dropped.
struct Screen {
    server: Child,
    display: String,
}

impl Screen {
    fn new(width: u32, height: u32) -> Self {
        let mut server = Command::new("Xvfb")
            .args([
                "-displayfd",
                "1",
                "-nolisten",
                "tcp",
                "-screen",
                "0",
                &format!("{width}x{height}x24"),
            ])
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("Xvfb runs (Debian, Ubuntu: apt-get install xvfb)");
        let mut number = String::new();
        let out = server.stdout.take().expect("piped");
        BufReader::new(out)
            .read_line(&mut number)
            .expect("Xvfb says its number");
        Self {
            server,
            display: format!(":{}", number.trim()),
        }
    }

    fn xdotool(&self, arguments: &str) {
        let status = Command::new("xdotool")
            .args(arguments.split_whitespace())
            .env("DISPLAY", &self.display)
            .status()
            .expect("xdotool runs (Debian, Ubuntu: apt-get install xdotool)");
        assert!(status.success(), "xdotool {arguments}");
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}

/// A running window and the lines it writes.
struct Viewer {
    process: Child,
    log: Receiver<String>,
}

impl Viewer {
    fn open(screen: &Screen, scale: &str, folder: &Path, arguments: &[&str]) -> Self {
        let mut process = Command::new(SIGHTLINE)
            .arg("-v")
            .args(arguments)
            .current_dir(folder)
            .env("DISPLAY", &screen.display)
            // Tests put their own desktop there.
            .env("PATH", folder)
            // The test must not touch what the user's window remembers.
            .env("XDG_STATE_HOME", folder)
            .env("WINIT_X11_SCALE_FACTOR", scale)
            .env_remove("WAYLAND_DISPLAY")
            .env_remove("WAYLAND_SOCKET")
            .stderr(Stdio::piped())
            .spawn()
            .expect("the binary runs");
        let log = lines(process.stderr.take().expect("piped"));
        let viewer = Self { process, log };
        viewer.wait_for("scene shown");
        viewer
    }

    /// The next log line that contains `what`.
    fn wait_for(&self, what: &str) -> String {
        loop {
            let line = self.log.recv_timeout(PATIENCE);
            let line = line.unwrap_or_else(|_| panic!("the window never said {what:?}"));
            if line.contains(what) {
                return line;
            }
        }
    }

    /// The pick that the window logs, and the command that it logs for the same pick.
    fn picked(&self) -> (String, String) {
        let from = |what: &str| {
            let line = self.wait_for(what);
            line[line.find(what).expect("found")..].to_owned()
        };
        let command = from("sightline pick");
        (from("{\"px\":"), command)
    }
}

impl Drop for Viewer {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

fn lines(from: impl Read + Send + 'static) -> Receiver<String> {
    let (sender, receiver) = channel();
    thread::spawn(move || {
        for line in BufReader::new(from).lines().map_while(Result::ok) {
            eprintln!("{line}");
            if sender.send(line).is_err() {
                return;
            }
        }
    });
    receiver
}

/// What a shell prints for one of our commands.
fn shell(command: &str) -> String {
    let command = command.replacen("sightline", SIGHTLINE, 1);
    let output = Command::new("sh")
        .args(["-c", &command])
        .output()
        .expect("sh runs");
    assert!(
        output.status.success(),
        "{command}: {}",
        String::from_utf8_lossy(&output.stderr)
    );
    String::from_utf8(output.stdout)
        .expect("UTF-8")
        .trim_end()
        .to_owned()
}

fn value<'a>(command: &'a str, flag: &str) -> &'a str {
    let mut words = command.split(' ').skip_while(|word| *word != flag);
    words
        .nth(1)
        .unwrap_or_else(|| panic!("{flag} in {command}"))
}

fn scene(folder: &Path) -> PathBuf {
    let path = folder.join("three things.toml");
    let text = r#"
        [camera]
        eye = [2, 3, 7]
        target = [0, 0.5, 0]
        fov = 40

        [[object]]
        name = "ground"
        shape = "square"
        rotation = [-90, 0, 0]
        scale = 8

        [[object]]
        name = "ball"
        shape = "sphere"
        position = [0, 1, 0]
        scale = 2

        [[object]]
        name = "box"
        shape = "cube"
        position = [-2.2, 0.5, 0.5]
    "#;
    std::fs::write(&path, text).expect("written");
    path
}

fn clicks_pick_what_the_command_prints(scale: &str) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = scene(folder.path());
    let factor: f64 = scale.parse().expect("a number");
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "small"
    )]
    let physical = |points: f64| (points * factor).round() as u32;
    let (width, height) = (physical(1280.0), physical(720.0));
    let screen = Screen::new(width, height);
    let viewer = Viewer::open(
        &screen,
        scale,
        folder.path(),
        &[&path.display().to_string()],
    );
    let click = |x: u32, y: u32| {
        screen.xdotool(&format!("mousemove {x} {y}"));
        screen.xdotool("click 1");
        viewer.picked()
    };
    let (middle_x, middle_y) = (width / 2, height / 2);
    let mut hits = 0;
    for (dx, dy) in [(0, 0), (37, 11), (-90, 41), (13, -160), (150, 77)] {
        let at = |middle: u32, by: i32| middle.saturating_add_signed(by);
        let (picked, command) = click(at(middle_x, dx), at(middle_y, dy));
        assert_eq!(picked, shell(&command), "{command}");
        hits += usize::from(!picked.contains("\"hit\":null"));
    }
    assert!(hits >= 3, "only {hits} clicks hit something");

    let (_, before) = click(middle_x, middle_y);
    screen.xdotool("mousedown 1");
    for _ in 0..6 {
        screen.xdotool("mousemove_relative -- 21 -8");
    }
    screen.xdotool("mouseup 1");
    // Until the turned view is drawn, clicks pick in the one before. No two of them make a double click.
    let turned =
        |(_, command): &(String, String)| value(&before, "--eye") != value(command, "--eye");
    let mut clicks = (5..55).map(|aside| {
        thread::sleep(APART);
        click(middle_x + aside, middle_y + 9)
    });
    let (picked, command) = clicks.find(turned).expect("the drag turned the view");
    assert_eq!(picked, shell(&command), "{command}");
    let mut rest = viewer.log.try_iter();
    let more = rest.find(|line| line.contains("sightline pick"));
    assert_eq!(more, None, "a drag picks nothing");
}

#[test]
fn clicks_pick_what_the_command_prints_at_scale_1() {
    clicks_pick_what_the_command_prints("1");
}

#[test]
fn clicks_pick_what_the_command_prints_at_scale_1_5() {
    clicks_pick_what_the_command_prints("1.5");
}

#[test]
fn clicks_pick_what_the_command_prints_at_scale_2() {
    clicks_pick_what_the_command_prints("2");
}

/// Each time it is pressed, the key V finds what `sightline verify` finds for the same view.
#[test]
fn the_key_v_compares_what_is_on_screen() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = scene(folder.path());
    let screen = Screen::new(1280, 720);
    let viewer = Viewer::open(&screen, "1", folder.path(), &[&path.display().to_string()]);
    screen.xdotool("mousemove 640 360");
    screen.xdotool("search --sync --onlyvisible --name Sightline windowfocus --sync");
    // F12 writes into the folder that the program runs in.
    screen.xdotool("key F12");
    screen.xdotool("key Return");
    viewer.wait_for("saved");
    assert!(folder.path().join("sightline-1.png").exists());
    for turn in [false, true] {
        if turn {
            // A new view closes the comparison.
            screen.xdotool("key 9");
        }
        screen.xdotool("key v");
        let log = viewer.wait_for(" pixels differ: ");
        let (said, command) = log.split_once(" pixels differ: ").expect("found");
        let said: usize = (said.rsplit(' ').next())
            .and_then(|number| number.parse().ok())
            .expect("a number");
        let line = shell(&format!("{command} --json"));
        let line: serde_json::Value = serde_json::from_str(&line).expect("JSON");
        let count = |name: &str| line[name].as_u64().expect("a count");
        for side in ["drawn", "picked"] {
            assert!(count(side) > 10_000, "{line}");
        }
        assert_eq!(said as u64, count("pixels") - count("same"), "{line}");
    }
}

/// On Linux winit is not told of the desktop's theme, so Sightline asks the portal whenever the window gets the focus.
#[test]
#[cfg(unix)]
fn panels_follow_the_desktop() {
    use std::{fs, os::unix::fs::PermissionsExt};
    let folder = tempfile::tempdir().expect("a folder");
    let path = scene(folder.path());
    let is_now = |scheme: u32| {
        let asked = folder.path().join("busctl");
        fs::write(&asked, format!("#!/bin/sh\necho v v u {scheme}\n")).expect("written");
        fs::set_permissions(&asked, fs::Permissions::from_mode(0o755)).expect("runs");
    };
    let screen = Screen::new(1280, 720);
    is_now(2);
    let viewer = Viewer::open(&screen, "1", folder.path(), &[&path.display().to_string()]);
    let focus = "search --sync --onlyvisible --name Sightline windowfocus --sync";
    screen.xdotool(focus);
    viewer.wait_for("the desktop is Light");
    let mut number = 0;
    // The first clicks may come before the card does. What is chosen in it once, stays chosen.
    let mut shot = || loop {
        number += 1;
        assert!(number < 20, "the card's choice is not at its place");
        screen.xdotool("key F12");
        // "whole window"
        screen.xdotool("mousemove 626 99 click 1");
        screen.xdotool("key Return");
        viewer.wait_for("saved");
        let file = folder.path().join(format!("sightline-{number}.png"));
        let picture = images::read(&file);
        if picture.size().width() < 1280 {
            continue;
        }
        // A pixel of the panel at the right, and one of what is behind the scene.
        break [[1270, 500], [930, 60]].map(|[x, y]| {
            let channels = picture.at(x, y);
            channels.into_iter().max().expect("three")
        });
    };
    let light = shot();
    assert!(
        light.iter().all(|light| *light > 180) && light[0] > 200,
        "{light:?}"
    );
    is_now(1);
    // The window loses the focus and gets it back.
    screen.xdotool("search --maxdepth 0 .* windowfocus");
    screen.xdotool(focus);
    viewer.wait_for("the desktop is Dark");
    let dark = shot();
    assert!(dark.iter().all(|dark| *dark < 60), "{dark:?}");
}
