//! What `sightline pick --at -` reads: each run ends with an exit code, whatever the lines say.

#![no_main]

use libfuzzer_sys::fuzz_target;
use std::{
    fs::{File, OpenOptions},
    io::{Read, Seek, Write, stdin},
    sync::LazyLock,
};

/// Standard input from now on. Standard output is thrown away.
static INPUT: LazyLock<File> = LazyLock::new(|| {
    let path = std::env::temp_dir().join(format!("sightline-fuzz-{}.txt", std::process::id()));
    let mut options = OpenOptions::new();
    let file = options
        .read(true)
        .write(true)
        .create(true)
        .truncate(true)
        .open(path);
    let file = file.expect("a file");
    let nowhere = options
        .create(false)
        .truncate(false)
        .open("/dev/null")
        .expect("nowhere");
    rustix::stdio::dup2_stdin(&file).expect("an input");
    rustix::stdio::dup2_stdout(&nowhere).expect("an output");
    file
});

fuzz_target!(|bytes: &[u8]| {
    let mut input = &*INPUT;
    input.set_len(0).expect("an empty file");
    input.rewind().expect("a file");
    input.write_all(bytes).expect("a file");
    input.rewind().expect("a file");
    let words = ["sightline", "pick", "--size", "64x48", "--at", "-"];
    let _ = sightline::cli::run(words.map(Into::into));
    // After an error lines may be left over.
    stdin()
        .lock()
        .read_to_end(&mut Vec::new())
        .expect("the rest");
});
