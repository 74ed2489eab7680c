//! F3D, another viewer: what it takes for a picture of a file, and for a frame of a turn. It draws in software, as
//! Sightline does here, on a display of its own. Needs `f3d`, `Xvfb` and GNU `time`.

use std::{
    error::Error,
    fmt::Write,
    fs,
    io::{self, BufRead, BufReader},
    path::Path,
    process::{Child, Command, Stdio},
    time::Instant,
};

/// Moves of the mouse in a turn.
const MOVES: u32 = 40;

/// What a picture costs, as a whole process.
#[derive(Clone, Copy)]
pub struct Cost {
    pub ms: f64,
    pub peak_mb: f64,
}

/// F3D and the display that it draws on, which ends with this.
pub struct F3d {
    server: Child,
    display: String,
    size: [u32; 2],
}

impl F3d {
    /// F3D for pictures of this size; `None` where it, or what it needs, is not installed.
    ///
    /// # Errors
    /// When the display does not start.
    pub fn find(size: [u32; 2]) -> Result<Option<Self>, Box<dyn Error>> {
        for (program, asks) in [("f3d", "--version"), ("time", "--version")] {
            match Command::new(program).arg(asks).output() {
                Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
                found => found?,
            };
        }
        let [width, height] = size;
        let server = Command::new("Xvfb")
            .args(["-displayfd", "1", "-screen", "0"])
            .arg(format!("{width}x{height}x24"))
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn();
        let mut server = match server {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            server => server?,
        };
        let mut number = String::new();
        let says = server.stdout.take().ok_or("Xvfb says nothing")?;
        BufReader::new(says).read_line(&mut number)?;
        Ok(Some(Self {
            server,
            display: format!(":{}", number.trim()),
            size,
        }))
    }

    /// A picture of a file.
    ///
    /// # Errors
    /// When F3D draws none.
    pub fn picture(&self, file: &Path) -> Result<Cost, Box<dyn Error>> {
        self.run(file, None)
    }

    /// How long each frame of a turn by mouse takes, in milliseconds.
    ///
    /// # Errors
    /// When F3D draws no picture.
    pub fn turn_ms(&self, file: &Path) -> Result<f64, Box<dyn Error>> {
        let [one, many] = [1, 1 + MOVES].map(|moves| self.run(file, Some(moves)));
        Ok((many?.ms - one?.ms) / f64::from(MOVES))
    }

    /// Draws a picture of a file, after a turn by this many moves of the mouse.
    fn run(&self, file: &Path, moves: Option<u32>) -> Result<Cost, Box<dyn Error>> {
        let folder = tempfile::tempdir()?;
        let picture = folder.path().join("picture.png");
        let [width, height] = self.size;
        let mut command = Command::new("time");
        command
            .env("DISPLAY", &self.display)
            .env("LIBGL_ALWAYS_SOFTWARE", "1")
            .args(["--format", "%M", "f3d"])
            .args([file.as_os_str(), "--output".as_ref(), picture.as_os_str()])
            .args(["--resolution", &format!("{width},{height}")]);
        if let Some(moves) = moves {
            let events = folder.path().join("events");
            fs::write(&events, turn(moves)?)?;
            command.arg("--interaction-test-play").arg(events);
        }
        let start = Instant::now();
        let run = command.output()?;
        let ms = start.elapsed().as_secs_f64() * 1e3;
        fs::metadata(picture)?;
        let said = String::from_utf8(run.stderr)?;
        let peak_kb: f64 = said.lines().last().ok_or("no peak")?.parse()?;
        Ok(Cost {
            ms,
            peak_mb: peak_kb / 1024.0,
        })
    }
}

impl Drop for F3d {
    fn drop(&mut self) {
        // It may have ended by itself.
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}

/// A drag by the left button, in the form in which VTK records events.
fn turn(moves: u32) -> Result<String, std::fmt::Error> {
    let mut events = "# StreamVersion 1.1\n".to_owned();
    for event in ["EnterEvent", "MouseMoveEvent", "LeftButtonPressEvent"] {
        writeln!(events, "{event} 600 360 0 0 0 0")?;
    }
    for i in 0..moves {
        writeln!(events, "MouseMoveEvent {} 360 0 0 0 0", 605 + 5 * (i % 20))?;
    }
    writeln!(events, "LeftButtonReleaseEvent 600 360 0 0 0 0")?;
    Ok(events)
}
