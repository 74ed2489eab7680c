//! The sources call no function whose last digits are the C library's.

use std::{
    fs,
    path::{Path, PathBuf},
};

/// Methods of `f32`, `f64` and glam's types that end in the C library.
const METHODS: [&str; 41] = [
    "mul_add",
    "hypot",
    "sin",
    "cos",
    "tan",
    "sin_cos",
    "asin",
    "acos",
    "atan",
    "atan2",
    "sinh",
    "cosh",
    "tanh",
    "asinh",
    "acosh",
    "atanh",
    "powf",
    "exp",
    "exp2",
    "exp_m1",
    "ln",
    "ln_1p",
    "log",
    "log2",
    "log10",
    "cbrt",
    "angle_between",
    "angle_to",
    "from_rotation_x",
    "from_rotation_y",
    "from_rotation_z",
    "from_axis_angle",
    "from_euler",
    "slerp",
    "from_angle",
    "rotate_towards",
    "to_euler",
    "to_axis_angle",
    "perspective_lh",
    "perspective_rh",
    "perspective_infinite_rh",
];

/// Where they may stand, and why no stored or printed number of ours depends on it.
const ALLOWED: [(&str, &str, &str); 3] = [
    (
        "geometry/double_double.rs",
        "mul_add",
        "where the processor's instruction is compiled in",
    ),
    (
        "geometry/bvh/walk.rs",
        "mul_add",
        "lanes of f32, which only reject; by instructions, never by a library",
    ),
    (
        "study/real.rs",
        "mul_add",
        "pbrt's and Embree's methods, as they are published; C's fma rounds once, as the instruction does",
    ),
];

/// Every source file, by its path within `src`, without unit tests and comments.
fn sources() -> Vec<(String, String)> {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut folders = vec![src.clone()];
    let mut sources = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder") {
            let path: PathBuf = entry.expect("an entry").path();
            if path.ends_with("tests") || path.ends_with("tests.rs") {
                continue;
            }
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let text = fs::read_to_string(&path).expect("a source file");
            let text = text.replace("\r\n", "\n");
            let text = text
                .split("#[cfg(test)]\nmod tests {")
                .next()
                .unwrap_or_default();
            let code = text
                .lines()
                .map(|line| line.split("//").next().unwrap_or_default());
            let name = path.strip_prefix(&src).expect("within");
            let name = name.display().to_string().replace('\\', "/");
            sources.push((name, code.collect::<Vec<_>>().join("\n")));
        }
    }
    sources
}

/// Whether a method is called or named, `x.sin()` or `f64::sin`, but for the functions of the `libm` crate.
fn names(code: &str, method: &str) -> bool {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    code.match_indices(method).any(|(at, _)| {
        let (before, rest) = (&code[..at], &code[at + method.len()..]);
        let is_called = before.ends_with('.') && rest.starts_with('(');
        let is_named = before.ends_with("::") && !before.ends_with("libm::");
        (is_called || is_named) && !rest.starts_with(is_word)
    })
}

#[test]
fn no_source_asks_a_c_library() {
    let sources = sources();
    assert!(sources.len() > 200, "{}", sources.len());
    let mut allowed = Vec::new();
    for (file, code) in &sources {
        for method in METHODS.iter().filter(|method| names(code, method)) {
            let place = ALLOWED
                .iter()
                .position(|(path, name, _)| path == file && name == method);
            allowed.push(place.unwrap_or_else(|| panic!("src/{file} calls {method}: take libm's")));
        }
    }
    assert_eq!(
        allowed.len(),
        ALLOWED.len(),
        "each allowed place is there: {allowed:?}"
    );
}
