//! With a C library that computes sine and the like wrong, every answer is the same. (`fma` is not among them: on this
//! system Rust has one of its own, and [`super::sources`] finds whoever calls it.)
#![cfg(all(target_os = "linux", target_env = "gnu"))]

use super::results;
use std::{fmt::Write, fs, hint::black_box, path::PathBuf, process::Command};

/// A name, how many arguments it takes, and how Rust calls it.
type Function = (&'static str, usize, fn(f64) -> f64);

/// Functions of a C library whose last digits it chooses.
const FUNCTIONS: [Function; 17] = [
    ("hypot", 2, |x| x.hypot(x)),
    ("pow", 2, |x| x.powf(x)),
    ("atan2", 2, |x| x.atan2(x)),
    ("sin", 1, f64::sin),
    ("cos", 1, f64::cos),
    ("tan", 1, f64::tan),
    ("asin", 1, f64::asin),
    ("acos", 1, f64::acos),
    ("atan", 1, f64::atan),
    ("sinh", 1, f64::sinh),
    ("cosh", 1, f64::cosh),
    ("tanh", 1, f64::tanh),
    ("exp", 1, f64::exp),
    ("exp2", 1, f64::exp2),
    ("log", 1, f64::ln),
    ("log2", 1, f64::log2),
    ("log10", 1, f64::log10),
];

/// What each of the functions gives for every argument in the wrong library.
const WRONG: f64 = 0.75;

/// A library in front of the system's, in which each of the functions is wrong.
fn wrong_library(folder: &tempfile::TempDir) -> PathBuf {
    let mut code = String::new();
    let mut define = |name: &str, arguments: usize| {
        for (kind, end) in [("double", ""), ("float", "f")] {
            let list = ["a", "b"].map(|argument| format!("{kind} {argument}"));
            let list = list[..arguments].join(", ");
            writeln!(code, "{kind} {name}{end}({list}) {{ return {WRONG}; }}").expect("text");
        }
    };
    for (name, arguments, _) in FUNCTIONS {
        define(name, arguments);
    }
    for (kind, end) in [("double", ""), ("float", "f")] {
        let list = format!("{kind} a, {kind} *s, {kind} *c");
        writeln!(code, "void sincos{end}({list}) {{ *s = *c = {WRONG}; }}").expect("text");
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
    // Rust's own functions are wrong with it.
    let mut this = Command::new(std::env::current_exe().expect("this test"));
    preload(this.args(["--exact", "c_library::functions_are_the_library_s"]));
    assert!(this.status().expect("this test").success());
    let results = [results(|_| {}), results(preload)];
    for (right, wrong) in results[0].lines().zip(results[1].lines()) {
        assert_eq!(right, wrong);
    }
    assert_eq!(results[0].len(), results[1].len());
}

/// Each function is the wrong one where the wrong library is loaded, and none elsewhere.
#[test]
fn functions_are_the_library_s() {
    let is_loaded = std::env::var_os("LD_PRELOAD").is_some();
    for (name, _, function) in FUNCTIONS {
        let value = function(black_box(0.5));
        assert_eq!(value.to_bits() == WRONG.to_bits(), is_loaded, "{name}");
    }
}
