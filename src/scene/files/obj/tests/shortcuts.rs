//! Tests that what is read by a fast path is the same as what is read without it.

use super::{
    super::{
        pieces::{Piece, Pieces},
        wash::Washed,
    },
    Dice, any_file, assert_same, outcome, terrain,
};
use crate::{geometry::random::Random, scene::Progress};
use std::{
    fmt::Write as _,
    io::{BufRead, Cursor, Read},
    path::Path,
};

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

/// Far more vertices and normals of other pieces than there are stand-ins, in any order.
#[test]
fn a_few_stand_ins_stand_for_many() {
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

/// `tobj` asks for lines. Readers of bytes get the same.
#[test]
fn the_lines_for_tobj_are_the_same_as_bytes() {
    let progress = Progress::default();
    let texts = (0..20).map(any_file).chain([terrain(20)]);
    let mut bytes = 0;
    for text in texts {
        let input = Box::new(Cursor::new(text.clone()));
        for piece in Pieces::new(input, 500, &progress) {
            let Ok(piece) = piece else {
                panic!("memory is read");
            };
            let piece: Piece = piece;
            let washed = || Washed::new(&piece, None, true, true);
            let mut expected = String::new();
            let mut lines = washed();
            while lines.read_line(&mut expected).expect("text") > 0 {}
            let mut all = String::new();
            washed().read_to_string(&mut all).expect("text");
            assert_eq!(all, expected);
            let (mut start, mut rest) = ([0; 5], String::new());
            let mut mixed = washed();
            mixed.read_exact(&mut start).expect("text");
            while mixed.read_line(&mut rest).expect("text") > 0 {}
            assert_eq!([&start, rest.as_bytes()].concat(), expected.as_bytes());
            bytes += expected.len();
        }
    }
    assert!(bytes > 10_000, "{bytes}");
}
