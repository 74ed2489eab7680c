//! Tests that what is read by a fast path is the same as what is read without it.

use super::{Dice, any_file, assert_same, outcome};
use crate::geometry::random::Random;
use std::{fmt::Write as _, path::Path};

/// A text with a plus before each number in lines with this keyword. No fast path takes a number with a plus.
fn with_pluses(text: &str, keyword: &str) -> String {
    let lines = text.split_inclusive(['\n', '\r']);
    let signed = lines.map(|line| {
        if !line.starts_with(keyword) {
            return line.to_owned();
        }
        let mut before = ' ';
        let mut signed = String::new();
        for c in line.chars() {
            if c.is_ascii_digit() && [' ', '/'].contains(&before) {
                signed.push('+');
            }
            signed.push(c);
            before = c;
        }
        signed
    });
    signed.collect()
}

/// Asserts that files are the same when they are written in another way.
fn assert_read_the_same(otherwise: impl Fn(&str) -> String) {
    let path = Path::new("any.obj");
    let mut different = 0;
    for seed in 0..200 {
        // What continues a name must not change.
        let text = any_file(seed).replace('\\', "");
        let other = otherwise(&text);
        different += usize::from(other != text);
        for piece in [97, other.len() + 1] {
            let [read, expected] =
                [&text, &other].map(|text| outcome(piece, path, text.as_bytes()));
            // A refused number is quoted with its sign.
            assert_eq!(read, expected.replace('+', ""), "{text}");
        }
    }
    assert!(different > 150, "{different}");
}

#[test]
fn corners_with_a_sign_are_read_the_same() {
    assert_read_the_same(|text| with_pluses(text, "f "));
}

#[test]
fn coordinates_with_a_sign_are_read_the_same() {
    assert_read_the_same(|text| with_pluses(text, "v "));
}

#[test]
fn indented_lines_are_read_the_same() {
    assert_read_the_same(|text| {
        let lines = text.split_inclusive('\n');
        lines.flat_map(|line| [" ", line]).collect()
    });
}

/// Faces name vertices and normals of all other pieces, in any order.
#[test]
fn faces_name_what_is_in_other_pieces() {
    const COUNT: usize = 3_000;
    let mut dice = Dice(Random(5));
    let mut text = String::new();
    for _ in 0..COUNT {
        let [p, n] = [dice.0.point(), dice.0.point()];
        writeln!(text, "v {} {} {}", p.x, p.y, p.z).expect("text");
        writeln!(text, "vn {} {} {}", n.x, n.y, n.z).expect("text");
    }
    for _ in 0..COUNT {
        let corners = [(); 3].map(|()| [(); 2].map(|()| 1 + dice.below(COUNT)));
        let corners = match dice.below(3) {
            0 => corners.map(|[vertex, _]| format!("{vertex}")),
            _ => corners.map(|[vertex, normal]| format!("{vertex}//{normal}")),
        };
        writeln!(text, "f {}", corners.join(" ")).expect("text");
    }
    let count = assert_same(Path::new("any.obj"), text.as_bytes(), [1 << 12, 1 << 15]);
    assert_eq!(count, 2);
}
