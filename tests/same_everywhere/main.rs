//! Answers are the same bytes on every system: they come from +, -, x, /, square roots and integers, which IEEE 754 and
//! Rust define, and from one crate's sine, tangent and the like. No C library has a say.
#![cfg(feature = "window")]

mod c_library;
mod recorded;
mod sources;

use std::{
    fs,
    io::Write,
    process::{Command, Stdio},
};

/// 16 pixels a unit: positions on edges and rims, and two surfaces in one plane, which `f64` leaves to exact arithmetic.
const EDGES: &str = r#"
[camera]
eye = [0, 0, 5]
target = [0, 0, 0]
ortho = 4
[[object]]
shape = "cube"
[[object]]
shape = "square"
position = [0, 0, 0.5]
scale = 0.5
[[object]]
shape = "sphere"
scale = 0.5
position = [1.25, -1.25, 0]
"#;

/// Commands whose results are numbers, each with lines of positions to pick at.
fn commands() -> Vec<(String, String)> {
    // Over the middle of the picture.
    let grid = |across: u32, down: u32| {
        let share = |i, n| (f64::from(i) + 0.37) / f64::from(n);
        let row = move |j| (0..across).map(move |i| (share(i, across), share(j, down)));
        let cells = (0..down).flat_map(row);
        let lines = cells.map(|(x, y)| format!("{},{}\n", 300.0 + 700.0 * x, 150.0 + 470.0 * y));
        lines.collect::<String>()
    };
    let on_edges = "24,32\n40,40\n32,24\n24,24\n28.5,24\n48,52\n52,56\n56,52\n32.5,33.5\n";
    let mut commands = vec![
        ("list --json".to_owned(), String::new()),
        ("pick --stored --at 640.5,360.5".into(), String::new()),
        ("pick --at -".into(), grid(5, 4)),
        ("pick --ortho 6 --all-hits --at -".into(), grid(3, 2)),
        ("pick --section=-x:0.3 --at -".into(), grid(3, 2)),
        (
            "pick --eye 60000,48000,100000 --target 0,0.7,0 --fov 0.002 --at -".into(),
            grid(3, 2),
        ),
    ];
    commands.push((
        "pick edges.toml --size 64x64 --all-hits --at -".into(),
        on_edges.into(),
    ));
    for exhibit in &sightline::scene::gallery::GALLERY {
        let name = exhibit.name;
        commands.push((
            format!("pick gallery:{name} --at -"),
            grid(2, 2) + "640.5,360.5\n",
        ));
    }
    commands
}

/// What the commands print, each result below its command.
fn results(run: impl Fn(&mut Command)) -> String {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("edges.toml"), EDGES).expect("a writable folder");
    let result = |(args, lines): (String, String)| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_sightline"));
        command.args(args.split(' ')).current_dir(folder.path());
        command.stdin(Stdio::piped()).stdout(Stdio::piped());
        run(&mut command);
        let mut child = command.spawn().expect("the program");
        let mut input = child.stdin.take().expect("a pipe");
        input.write_all(lines.as_bytes()).expect("positions");
        drop(input);
        let output = child.wait_with_output().expect("an end");
        assert!(output.status.success(), "{args}");
        let printed = String::from_utf8(output.stdout).expect("text");
        assert!(
            printed.contains("\"object\":") || args.starts_with("list"),
            "{args} hits nothing"
        );
        assert!(
            printed.lines().count() >= lines.lines().count().max(1),
            "{args}"
        );
        format!("$ sightline {args}\n{printed}")
    };
    commands().into_iter().map(result).collect()
}
