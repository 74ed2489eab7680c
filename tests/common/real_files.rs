//! Real files, which this repository does not hold. Tests over them do nothing where there are none, and say so.

use std::{io::Write, path::PathBuf};

/// The folder of real `models` and `hostile` files, which `SIGHTLINE_SHARED` names. Where there is none, this says so
/// past the test runner, which keeps what a passing test prints to itself.
pub fn real_files() -> Option<PathBuf> {
    let Some(folder) = std::env::var_os("SIGHTLINE_SHARED").map(PathBuf::from) else {
        let test = std::thread::current();
        let name = test.name().unwrap_or("a test").to_owned();
        // A test does not fail because nobody reads this.
        let _ = writeln!(std::io::stderr(), "{name}: real files: absent");
        return None;
    };
    for name in ["models", "hostile"] {
        assert!(
            folder.join(name).is_dir(),
            "SIGHTLINE_SHARED is set but holds no {name}"
        );
    }
    Some(folder)
}
