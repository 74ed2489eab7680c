//! Positions come by standard input and picks go to standard output, each as soon as it is asked for.

use super::{Folder, SCENE, error, json};
use std::{
    io::{BufRead, BufReader, Write},
    process::{ExitCode, Stdio},
    sync::mpsc,
    thread,
    time::Duration,
};

/// Far longer than a pick takes. A pick that is held back never comes.
const PATIENCE: Duration = Duration::from_mins(1);

#[test]
fn standard_input_gives_positions() {
    let folder = Folder::new();
    let args = "pick scene.toml --size 200x100 --at -";
    // Enough for trees to be built; blanks and empty lines do not matter.
    let input = (0..100)
        .map(|i| format!(" {i}.5, 50\r\n"))
        .collect::<Vec<_>>()
        .join("\n");
    let lines = json(&folder.run_with(args, &input));
    assert_eq!(lines.len(), 100);
    assert_eq!(lines[99]["hit"]["object"], "Front");
    assert_eq!(lines[7]["px"], serde_json::json!([7.5, 50.0]));
    // The same as on the command line, to the bit.
    assert_eq!(
        folder.json("pick scene.toml --size 200x100 --at 99.5,50")[0],
        lines[99]
    );

    for (input, line, word) in [
        ("1,2\nhere\n", 2, "X,Y"),
        ("1,2,3\n", 1, "X,Y"),
        ("1,2\n\n1\n", 3, "X,Y"),
        ("nan,2\n", 1, "X,Y"),
        ("200,2\n", 1, "outside"),
    ] {
        let error = error(&folder.run_with(args, input), 2, input);
        assert!(
            error.contains(&format!("line {line}:")) && error.contains(word),
            "{error}"
        );
    }
    let error = error(&folder.run_with(args, b"1,2\n1,\xff\n"), 2, "no UTF-8");
    assert!(
        error.contains("line 2:") && error.contains("X,Y"),
        "{error}"
    );
}

/// Each run ends with its own exit code, whatever the runs before it said.
#[test]
fn a_process_may_run_several_commands() {
    for (scene, code) in [
        ("nowhere.obj", 3),
        ("gallery:needles", 0),
        ("nowhere.obj", 3),
        ("gallery:needles", 0),
    ] {
        let ended = sightline::cli::run(["sightline", "list", scene].map(Into::into));
        assert_eq!(ended, ExitCode::from(code), "{scene}");
    }
}

/// A caller that waits for each answer before the next request.
#[test]
fn each_position_is_answered_before_the_next_is_there() {
    let folder = Folder::new();
    let mut command = folder.command("pick scene.toml --size 200x100 --at -");
    command.stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut child = command.spawn().unwrap();
    let mut input = child.stdin.take().unwrap();
    let output = BufReader::new(child.stdout.take().unwrap());
    let (sender, lines) = mpsc::channel();
    let reader = thread::spawn(move || {
        for line in output.lines() {
            sender.send(line.unwrap()).unwrap();
        }
    });
    for x in 0..40 {
        // Some at once, some in two pieces.
        let text = format!("{x}.5,50\n");
        let (first, rest) = text.split_at(if x % 3 == 0 { 2 } else { 0 });
        for piece in [first, rest] {
            input.write_all(piece.as_bytes()).unwrap();
            input.flush().unwrap();
        }
        let line = lines.recv_timeout(PATIENCE).expect("an answer");
        let start = format!("{{\"px\":[{x}.5,50.0]");
        assert!(line.starts_with(&start), "{line}");
    }
    drop(input);
    assert!(child.wait().unwrap().success());
    reader.join().unwrap();
    assert!(lines.recv().is_err(), "no more lines than positions");
}

/// A line without an end does not fill the memory: reading stops after its first bytes.
#[test]
fn a_line_without_an_end_is_refused() {
    let folder = Folder::new();
    let args = "pick scene.toml --size 20x10 --at -";
    let mut child = folder
        .command(args)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut input = child.stdin.take().unwrap();
    let mut written = 0;
    while input.write_all(&[b'1'; 4096]).is_ok() {
        written += 4096;
        assert!(written < 1 << 24, "it goes on reading");
    }
    let error = error(&child.wait_with_output().unwrap(), 2, args);
    assert!(error.contains("line 1: longer than 1024 bytes"), "{error}");
}

/// The end of a line does not count.
#[test]
fn a_line_of_the_most_bytes_is_taken() {
    let folder = Folder::new();
    let args = "pick scene.toml --size 20x10 --at -";
    let line = format!("{:<1024}", "1,2");
    for input in [line.clone(), format!("{line}\n"), format!("{line}\n3,4\n")] {
        let lines = json(&folder.run_with(args, &input));
        assert_eq!(lines.len(), input.lines().count());
    }
    let error = error(&folder.run_with(args, format!("{line} \n")), 2, args);
    assert!(error.contains("line 1: longer than 1024 bytes"), "{error}");
}

/// The exit code says what `verify` found, even if nobody reads the report.
#[test]
fn a_defect_is_told_to_a_reader_that_has_left() {
    let folder = Folder::new();
    let view =
        "--size 120x90 --eye 60000,48000,100000 --target 0,0.7,0 --fov 0.002 --near 1 --far 200000";
    let mut command = folder.command(&format!("verify {view} --picker usual"));
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    command.stdout(writer).stderr(Stdio::piped());
    let output = command.spawn().unwrap().wait_with_output().unwrap();
    let line = error(&output, 1, "verify");
    assert!(
        line.contains("drawn as one thing and picked as another"),
        "{line}"
    );
}

#[test]
fn a_reader_that_leaves_is_no_error() {
    let folder = Folder::new();
    let mut command = folder.command("pick scene.toml --at -");
    command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    drop(child.stdout.take());
    let mut input = child.stdin.take().unwrap();
    while input.write_all(b"640,360\n").is_ok() {}
    drop(input);
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success(), "{:?}", output.status);
    assert!(
        output.stderr.is_empty(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
}

/// Names of objects and files may hold marks that turn, clear or colour a terminal. Neither stream prints such a mark.
#[test]
fn no_name_does_anything_to_a_terminal() {
    let folder = Folder::new();
    let mark = |c: char| (c.is_control() && c != '\n') || "\u{202e}\u{2066}\u{200f}".contains(c);
    let name = "a\u{9b}31mb\u{202e}c\u{85}d\u{2066}";
    let scene = SCENE.replace("Front", name);
    std::fs::write(folder.path("marks.toml"), scene).unwrap();
    for (args, shows) in [
        ("list marks.toml", true),
        ("list --json marks.toml", true),
        ("pick marks.toml --at 640.5,360.5", true),
        ("pick marks.toml --at 640.5,360.5 --all-hits --stored", true),
        ("list no\u{202e}thing.obj", false),
    ] {
        let output = folder.run(args);
        assert_eq!(output.status.success(), shows, "{args}");
        let said = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
        assert!(said.contains("202e"), "{args}: {said}");
        assert!(!said.contains(mark), "{args}: {said:?}");
    }
}
