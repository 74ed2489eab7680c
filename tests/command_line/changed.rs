//! When a file changes while positions are picked from it, each line of output says so.

use super::Folder;
use serde_json::Value;
use std::{
    io::{BufRead, BufReader, Write},
    path::Path,
    process::{Child, ChildStdin, Command, Stdio},
    sync::mpsc::{Receiver, channel},
    thread,
    time::Duration,
};

/// Far longer than a pick takes. A pick that waits for a pipe never comes.
const PATIENCE: Duration = Duration::from_mins(1);

/// A quad, 100 pixels wide in the middle of the picture: its diagonal runs through the middle from the lower left.
const QUAD: &str = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n";
const LOOK: &str = "--size 200x200 --eye 0,0,10 --target 0,0,0 --ortho 4";

/// `pick --at -` on the quad, which it has loaded.
struct Asking {
    child: Child,
    input: ChildStdin,
    answers: Receiver<String>,
}

impl Asking {
    fn new(folder: &Folder, flags: &str) -> Self {
        std::fs::write(folder.path("quad.obj"), QUAD).unwrap();
        let mut command = folder.command(&format!("pick quad.obj {LOOK} {flags} --stored --at -"));
        command.stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut child = command.spawn().unwrap();
        let input = child.stdin.take().unwrap();
        let output = BufReader::new(child.stdout.take().unwrap());
        let (sender, answers) = channel();
        thread::spawn(move || {
            for line in output.lines().map_while(Result::ok) {
                let _ = sender.send(line);
            }
        });
        let asking = Self {
            child,
            input,
            answers,
        };
        // What is stored is printed once it is loaded.
        assert!(asking.answer().get("stored").is_some());
        asking
    }

    fn answer(&self) -> Value {
        let line = self.answers.recv_timeout(PATIENCE).expect("an answer");
        serde_json::from_str(&line).expect("a line of JSON")
    }

    fn at(&mut self, px: &str) -> Value {
        writeln!(self.input, "{px}").unwrap();
        self.answer()
    }
}

impl Drop for Asking {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

#[track_caller]
fn says(record: &Value, why: &str) {
    let said = record["file_error"].as_str().unwrap_or_default();
    assert!(said.contains(why), "{record}");
    assert_eq!(
        (&record["line"], &record["vertices"]),
        (&Value::Null, &Value::Null)
    );
}

#[test]
fn each_line_says_whether_its_file_has_changed() {
    let folder = Folder::new();
    let file = folder.path("quad.obj");
    let mut asking = Asking::new(&folder, "");
    let hit = asking.at("90,90")["hit"].take();
    assert_eq!(
        (&hit["line"], &hit["file_error"]),
        (&5.into(), &Value::Null)
    );
    std::fs::write(&file, format!("# mine\n{QUAD}")).unwrap();
    says(&asking.at("90,90")["hit"], "has changed");
    std::fs::remove_file(&file).unwrap();
    says(&asking.at("90,90")["hit"], "cannot be read again");
}

#[cfg(unix)]
#[test]
fn a_pipe_in_a_files_place_is_not_waited_for() {
    let make = |path: &Path| {
        std::fs::remove_file(path).unwrap();
        let made = Command::new("mkfifo").arg(path).status().unwrap();
        assert!(made.success());
    };
    for flags in ["", "--all-hits", "--snap 3"] {
        let folder = Folder::new();
        let mut asking = Asking::new(&folder, flags);
        make(&folder.path("quad.obj"));
        let line = asking.at("90,90");
        let record = [&line["hit"], &line["hits"][0], &line["snap"]];
        let record = record.into_iter().find(|record| record.is_object());
        says(record.expect("the quad"), "is not a file");
    }
}

/// The polygon's own edges are no longer known: no position snaps to an edge, and the line says why.
#[test]
fn a_changed_file_leads_to_no_edge() {
    let folder = Folder::new();
    let mut asking = Asking::new(&folder, "--snap 3");
    // Beside the diagonal, inside the lower edge, at a corner, and outside the lower edge.
    let [diagonal, edge, corner, beside] = ["90.5,110", "100,149", "149,149", "100,152"];
    let to = |line: &Value| line["snap"]["to"].as_str().map(str::to_owned);
    assert_eq!(to(&asking.at(diagonal)).as_deref(), Some("face"));
    assert_eq!(to(&asking.at(edge)).as_deref(), Some("edge"));
    assert_eq!(to(&asking.at(beside)).as_deref(), Some("edge"));
    std::fs::write(folder.path("quad.obj"), format!("# mine\n{QUAD}")).unwrap();
    for (px, expected) in [(diagonal, "face"), (edge, "face"), (corner, "vertex")] {
        let line = asking.at(px);
        assert_eq!(to(&line).as_deref(), Some(expected), "{line}");
        says(&line["snap"], "has changed");
    }
    // The position snaps to nothing: a changed file gives no edge.
    let line = asking.at(beside);
    assert_eq!(line["snap"], Value::Null);
    says(&line, "has changed");
    assert_eq!(asking.at("5,5")["file_error"], Value::Null);
}
