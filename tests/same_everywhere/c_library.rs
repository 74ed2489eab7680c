//! With a C library that computes sine, `fma` and the like wrong, every answer is the same.
#![cfg(all(target_os = "linux", target_env = "gnu"))]

use super::results;
use std::{ffi::c_double, fmt::Write, fs, path::PathBuf, process::Command};

/// Functions of a C library that are not defined to the last bit, or that some library gets wrong, by the number of
/// their arguments.
const FUNCTIONS: [(&str, usize); 21] = [
    ("fma", 3),
    ("hypot", 2),
    ("pow", 2),
    ("atan2", 2),
    ("sin", 1),
    ("cos", 1),
    ("tan", 1),
    ("asin", 1),
    ("acos", 1),
    ("atan", 1),
    ("sinh", 1),
    ("cosh", 1),
    ("tanh", 1),
    ("exp", 1),
    ("exp2", 1),
    ("expm1", 1),
    ("log", 1),
    ("log2", 1),
    ("log10", 1),
    ("log1p", 1),
    ("cbrt", 1),
];

/// A library in front of the system's, in which each of the functions is wrong.
fn wrong_library(folder: &tempfile::TempDir) -> PathBuf {
    let mut code = String::new();
    for (name, arguments) in FUNCTIONS {
        for (kind, end) in [("double", ""), ("float", "f")] {
            let list = ["a", "b", "c"].map(|name| format!("{kind} {name}"));
            let list = list[..arguments].join(", ");
            writeln!(code, "{kind} {name}{end}({list}) {{ return 0.75 + a; }}").expect("text");
        }
    }
    for (kind, end) in [("double", ""), ("float", "f")] {
        let list = format!("{kind} a, {kind} *s, {kind} *c");
        writeln!(code, "void sincos{end}({list}) {{ *s = *c = 0.75 + a; }}").expect("text");
    }
    let [source, library] = ["wrong.c", "libwrong.so"].map(|name| folder.path().join(name));
    fs::write(&source, code).expect("a writable folder");
    let mut compiler = Command::new("cc");
    compiler.args(["-shared", "-fPIC", "-fno-builtin", "-o"]);
    let done = compiler.arg(&library).arg(&source).status();
    let done = done.expect("a C compiler: apt-get install build-essential");
    assert!(done.success());
    library
}

#[test]
fn a_wrong_c_library_changes_no_answer() {
    let folder = tempfile::tempdir().expect("a folder");
    let library = wrong_library(&folder);
    let preload = |command: &mut Command| {
        command.env("LD_PRELOAD", &library);
    };
    // The library is wrong: the standard library's sine in a program of its own says so.
    let mut test = Command::new(std::env::current_exe().expect("this test"));
    test.args(["--exact", "c_library::sine_is_right"]);
    assert!(test.status().expect("this test").success());
    preload(&mut test);
    assert!(!test.status().expect("this test").success());
    let results = [results(|_| {}), results(preload)];
    for (right, wrong) in results[0].lines().zip(results[1].lines()) {
        assert_eq!(right, wrong);
    }
    assert_eq!(results[0].len(), results[1].len());
}

/// Fails where the C library is wrong.
#[test]
fn sine_is_right() {
    let angle: c_double = std::hint::black_box(0.5);
    assert!((angle.sin() - 0.479_425_538_604_203).abs() < 1e-12);
}
