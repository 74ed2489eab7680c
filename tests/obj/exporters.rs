//! Files as exporters write them, and their like: each has the colours and the form that its author saw.

use super::Folder;
use sightline::colour::Srgb;

const RED: Srgb = Srgb([255, 0, 0]);
const GREEN: Srgb = Srgb([0, 255, 0]);
const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

/// The colours of the triangles of `some.obj` with this text, which follows three vertices, and the warnings.
fn read(text: &str, files: &[(&str, &str)]) -> (Vec<Option<Srgb>>, Vec<String>) {
    let text = format!("{TRIANGLE}{text}");
    let files = files.iter().map(|(name, text)| (*name, text.as_bytes()));
    let files: Vec<_> = files.chain([("some.obj", text.as_bytes())]).collect();
    let folder = Folder::new(&files);
    let file = folder.load("some.obj").expect("it loads");
    let count = u32::try_from(file.mesh.data().triangles.len()).expect("few");
    let colours = (0..count).map(|triangle| file.mesh.triangle_colour(triangle));
    (colours.collect(), folder.warnings(&file))
}

/// The colour of a triangle of a material, with these libraries.
fn used(material: &str, library: &str) -> (Option<Srgb>, Vec<String>) {
    let text = format!("mtllib a.mtl\nusemtl {material}\nf 1 2 3\n");
    let (colours, warnings) = read(&text, &[("a.mtl", library)]);
    (colours[0], warnings)
}

const TWO: &str = "newmtl Plastic\nKd 1 0 0\nnewmtl Plastic #1\nKd 0 1 0\n";

#[test]
fn names_are_the_rest_of_their_lines() {
    let none = Vec::<String>::new();
    for (name, library, colour) in [
        ("Plastic", TWO, RED),
        ("Plastic #1", TWO, GREEN),
        ("Plastic\t#1", TWO, GREEN),
        ("Plastic  #1 ", TWO, GREEN),
        ("Plastic # the lid", TWO, RED),
        ("Plastic #1 # the lid", TWO, GREEN),
        (
            "Grey # 1",
            "newmtl Grey # 1\nKd 1 0 0\nnewmtl Grey # 2\nKd 0 1 0\n",
            RED,
        ),
        (
            "Grey # 2",
            "newmtl Grey # 1\nKd 1 0 0\nnewmtl Grey # 2\nKd 0 1 0\n",
            GREEN,
        ),
        ("red", "newmtl\tred  # the lid\nKd 1 0 0\n", RED),
        ("a  b", "newmtl a b\nKd 0 1 0\nnewmtl a  b\nKd 1 0 0\n", RED),
        ("a b", "newmtl a\tb\nKd 1 0 0\n", RED),
        ("\"a b\"", "newmtl a b\nKd 1 0 0\n", RED),
        ("Wall, 3/4\" : 1", "newmtl Wall, 3/4\" : 1\nKd 1 0 0\n", RED),
        (
            "twice",
            "newmtl twice\nKd 1 0 0\nnewmtl twice\nKd 0 1 0\n",
            RED,
        ),
    ] {
        assert_eq!(used(name, library), (Some(colour), none.clone()), "{name}");
    }
}

#[test]
fn no_material_is_silently_another() {
    let told = |name: &str, library: &str, message: &str| {
        let (colour, warnings) = used(name, library);
        assert_eq!(warnings, [format!("some.obj:5: {message}")], "{name}");
        colour
    };
    let message = "no material file defines Plastic #2";
    let library = "newmtl Plastic #1\nKd 1 0 0\n";
    assert_eq!(told("Plastic #2", library, message), None);
    let message = format!("{message} (Plastic is used)");
    assert_eq!(told("Plastic #2", TWO, &message), Some(RED));
    let message = "no material file defines plastic (Plastic is used)";
    assert_eq!(told("plastic", TWO, message), Some(RED));
}

/// Latin-1 names differ in bytes that are no UTF-8.
#[test]
fn names_in_latin_1_stay_apart() {
    let name = |last: u8| [b"Caf".as_slice(), &[last]].concat();
    let line = |keyword: &str, last: u8| [keyword.as_bytes(), &name(last), b"\n"].concat();
    let library = [
        line("newmtl ", 0xe9),
        b"Kd 1 0 0\n".to_vec(),
        line("newmtl ", 0xe8),
        b"Kd 0 1 0\n".to_vec(),
    ]
    .concat();
    let text = [
        b"mtllib a.mtl\n".to_vec(),
        TRIANGLE.into(),
        line("usemtl ", 0xe8),
        b"f 1 2 3\n".to_vec(),
    ]
    .concat();
    let folder = Folder::new(&[("some.obj", &text), ("a.mtl", &library)]);
    let file = folder.load("some.obj").expect("it loads");
    assert_eq!(file.mesh.triangle_colour(0), Some(GREEN));
    assert_eq!(file.mesh.triangle_material(0), Some("Caf\u{e8}"));
}

#[test]
fn a_bare_usemtl_ends_a_material() {
    for bare in [
        "usemtl",
        "usemtl ",
        "usemtl\t",
        "usemtl # none",
        "usemtl #",
        "usemtl (null)",
    ] {
        let text = format!("mtllib a.mtl\nusemtl Plastic\nf 1 2 3\n{bare}\nf 1 3 2\n");
        let (colours, warnings) = read(&text, &[("a.mtl", TWO)]);
        assert_eq!(
            (colours, warnings),
            (vec![Some(RED), None], vec![]),
            "{bare}"
        );
    }
}

const RED_LIBRARY: &str = "newmtl paint\nKd 1 0 0\n";

#[test]
fn libraries_are_found_however_they_are_named() {
    for (line, file) in [
        ("mtllib a b.mtl", "a b.mtl"),
        ("mtllib \"a b.mtl\"", "a b.mtl"),
        ("mtllib 'a b.mtl'", "a b.mtl"),
        ("mtllib   \"a b.mtl\"  ", "a b.mtl"),
        ("mtllib \"no.mtl\" \"a b.mtl\"", "a b.mtl"),
        ("mtllib no.mtl a b.mtl", "a b.mtl"),
        ("mtllib a b.mtl no.mtl", "a b.mtl"),
        ("mtllib\ta.mtl", "a.mtl"),
        ("mtllib a.mtl # of the house", "a.mtl"),
        ("mtllib a b.mtl #1", "a b.mtl"),
        ("mtllib \"\"", "some.mtl"),
        ("mtllib .\\sub\\a.mtl", "sub/a.mtl"),
        ("mtllib sub\\a b.mtl", "sub/a b.mtl"),
        ("mtllib C:\\Users\\someone\\export\\a.mtl", "a.mtl"),
        ("mtllib \"C:\\Users\\some one\\a b.mtl\"", "a b.mtl"),
        ("mtllib C:/Users/some one/a b.mtl", "a b.mtl"),
        ("mtllib \\\\server\\share\\a.mtl", "a.mtl"),
        ("mtllib /home/someone/sub/a.mtl", "sub/a.mtl"),
        ("mtllib file:///C:/export/a.mtl", "a.mtl"),
        ("mtllib export/a.mtl", "a.mtl"),
        ("mtllib A.MTL", "a.mtl"),
        ("mtllib a.mtl", "A.MTL"),
        ("mtllib Sub\\A.mtl", "sub/a.mtl"),
        ("mtllib C:\\Export\\A.Mtl", "a.mtl"),
        ("# no library", "some.mtl"),
        ("mtllib", "some.mtl"),
        ("# no library", "Some.MTL"),
    ] {
        let text = format!("{line}\nusemtl paint\nf 1 2 3\n");
        let (colours, warnings) = read(&text, &[(file, RED_LIBRARY)]);
        assert_eq!(colours, [Some(RED)], "{line}: {warnings:?}");
        let told = usize::from(line.contains("no.mtl"));
        assert_eq!(warnings.len(), told, "{line}: {warnings:?}");
    }
}

#[test]
fn as_written_comes_first_and_the_first_library_wins() {
    let green = "newmtl paint\nKd 0 1 0\n";
    for (line, files) in [
        ("mtllib a.mtl b.mtl", ["a.mtl", "b.mtl"]),
        ("mtllib a.mtl\nmtllib b.mtl", ["a.mtl", "b.mtl"]),
        ("mtllib a b.mtl", ["a b.mtl", "b.mtl"]),
        ("mtllib 'a.mtl'", ["'a.mtl'", "a.mtl"]),
        ("mtllib a.mtl", ["a.mtl", "A.mtl"]),
        ("mtllib sub/a.mtl", ["sub/a.mtl", "a.mtl"]),
        ("mtllib a.mtl", ["a.mtl", "some.mtl"]),
    ] {
        let text = format!("{line}\nusemtl paint\nf 1 2 3\n");
        let found = read(&text, &[(files[0], RED_LIBRARY), (files[1], green)]);
        assert_eq!(found, (vec![Some(RED)], vec![]), "{line}");
    }
}

/// A file that nobody names is read only where a material is used.
#[test]
fn a_missing_library_is_told_with_what_was_tried() {
    let told = |line: &str| read(&format!("{line}\nusemtl paint\nf 1 2 3\n"), &[]).1;
    assert_eq!(
        told("mtllib C:\\export\\a.mtl"),
        [
            "some.obj:4: the material file C:\\export\\a.mtl does not exist; tried, too: C:/export/a.mtl, a.mtl"
        ]
    );
    assert_eq!(
        told("mtllib a.mtl"),
        ["some.obj:4: the material file a.mtl does not exist"]
    );
    assert_eq!(told("# none"), [""; 0]);
    let unused = read("f 1 2 3\n", &[("some.mtl", "newmtl a\nKd what\n")]);
    assert_eq!(unused, (vec![None], vec![]));
}

#[test]
fn keywords_of_materials_are_read_in_any_case() {
    for library in [
        "NEWMTL a\nKD 1 0 0\n",
        "newmtl a\n\tkd 1 0 0\n",
        "Newmtl a\nKd 1 0 0 # red\n",
        "newmtl a\nKd 1 0 0# red\n",
        "newmtl a\nKd 1 0 0# red\n",
    ] {
        assert_eq!(used("a", library), (Some(RED), vec![]), "{library}");
    }
    let transparent = "some.obj: transparency is not shown: 1 material is drawn opaque";
    for (lines, is_told) in [
        ("Tr 0.8", true),
        ("tr 0.2", true),
        ("Tr 0", false),
        ("d 1\nTr 0.8", false),
        ("Tr 0\nd 0.5", true),
        ("D 0.5", true),
        ("d -halo 0.5 # glass", true),
        // So VTK writes an opaque one.
        ("Tr 0 illum 3", false),
    ] {
        let (colour, warnings) = used("a", &format!("newmtl a\nKd 1 0 0\n{lines}\n"));
        let told: &[&str] = if is_told { &[transparent] } else { &[] };
        assert_eq!(
            (colour, warnings),
            (
                Some(RED),
                told.iter().map(|told| (*told).to_owned()).collect()
            ),
            "{lines}"
        );
    }
}

#[test]
fn colours_from_0_to_255_are_scaled() {
    let told = |line: usize| {
        vec![format!(
            "a.mtl:{line}: Kd goes up to 255: it is read as Kd / 255"
        )]
    };
    let bytes = "newmtl b\nKd 0 0 1\nnewmtl a\nKd 128 64 32\n";
    assert_eq!(used("a", bytes), (Some(Srgb([128, 64, 32])), told(4)));
    assert_eq!(used("b", bytes), (Some(Srgb([0, 0, 1])), told(4)));
    let bright = "newmtl a\nKd 2.5 0.3 0\n";
    let above = vec!["a.mtl:2: Kd is above 1: it is drawn as 1".to_owned()];
    assert_eq!(used("a", bright), (Some(Srgb([255, 77, 0])), above));
    let lamp = "newmtl w\nKd 1 1 1\nnewmtl a\nKd 5 5 0\n";
    assert_eq!(used("a", lamp).0, Some(Srgb([255, 255, 0])));
    assert_eq!(used("w", lamp).0, Some(Srgb::WHITE));
    // A lamp, also beside pure colours; and bytes with a 1 among them.
    let lamp = "newmtl w\nKd 1 1 1\nnewmtl r\nKd 1 0 0\nnewmtl a\nKd 17 12 4\n";
    assert_eq!(used("w", lamp).0, Some(Srgb::WHITE));
    assert_eq!(used("a", "newmtl a\nKd 2 2 2\n").0, Some(Srgb::WHITE));
    let dark = "newmtl a\nKd 10 20 30\nnewmtl b\nKd 0 0 0\n";
    assert_eq!(used("a", dark).0, Some(Srgb([10, 20, 30])));
    let rounded = "newmtl a\nKd 1.00000012 0 0\nd 0.9999999\n";
    assert_eq!(used("a", rounded), (Some(RED), vec![]));
    let large = "newmtl a\nKd 300 0 0\n";
    assert_eq!(used("a", large).0, Some(RED));

    let vertices = |colours: [&str; 3]| {
        let mut corners = ["0 0 0", "1 0 0", "0 1 0"].iter();
        let lines = colours.map(|colour| format!("v {} {colour}\n", corners.next().expect("one")));
        let folder = Folder::new(&[(
            "some.obj",
            format!("{}f 1 2 3\n", lines.concat()).as_bytes(),
        )]);
        let file = folder.load("some.obj").expect("it loads");
        let colours = file.mesh.data().vertex_colours.clone();
        (colours, folder.warnings(&file))
    };
    let (colours, warnings) = vertices(["255 0 0", "0 128 1", ""]);
    assert_eq!(colours, [RED, Srgb([0, 128, 1]), Srgb::WHITE]);
    assert_eq!(
        warnings,
        ["some.obj: colours of vertices go up to 255: they are read as colour / 255"; 1]
    );
    // Averages are no whole numbers, and a small one is no share.
    let (colours, _) = vertices(["255.00002 0 0", "255 0.5 0", "127.5 128 255"]);
    assert_eq!(colours, [RED, Srgb([255, 1, 0]), Srgb([128, 128, 255])]);
    let above = ["some.obj: colours of vertices are above 1: they are drawn as 1"; 1];
    for colours in [
        ["-1 -1 -1", "255 0 0", "0 0 0"],
        ["65535 0 0", "0 0 0", "0 0 0"],
        ["3 2 1", "0.5 0 0", "0 0 0"],
    ] {
        assert_eq!(vertices(colours).1, above, "{colours:?}");
    }
    let (colours, warnings) = vertices(["1 0 0", "0 0.5 0", "1 1 1"]);
    assert_eq!(colours, [RED, Srgb([0, 128, 0]), Srgb::WHITE]);
    assert_eq!(warnings, [""; 0]);
}

#[test]
fn painted_vertices_have_the_colours_of_mrgb_lines() {
    let colours = |lines: &str| {
        let text = format!("{TRIANGLE}v 1 1 0\n{lines}f 1 2 4 3\n");
        let folder = Folder::new(&[("some.obj", text.as_bytes())]);
        let file = folder.load("some.obj").expect("it loads");
        (
            file.mesh.data().vertex_colours.clone(),
            folder.warnings(&file),
        )
    };
    let all = [RED, GREEN, Srgb([0, 0, 255]), Srgb([18, 171, 205])];
    for lines in [
        "#MRGB ffff0000ff00ff00ff0000ff0012abcd\n",
        "#MRGB ffff0000ff00ff00\n#MRGB ff0000ff0012ABCD\n# End of MRGB block\n",
        "#mrgb\tffff0000 ff00ff00 ff0000ff 0012abcd\r\n",
        "#MRGB ffff0000ff00ff00ff0000ff0012abcdffffffff\n",
    ] {
        assert_eq!(colours(lines), (all.to_vec(), vec![]), "{lines}");
    }
    let (few, _) = colours("#MRGB ffff0000\n");
    assert_eq!(few, [Srgb::WHITE, Srgb::WHITE, Srgb::WHITE, RED]);
    let second = "#MRGB ff00ff00ff00ff00ff00ff00ff00ff00\nf 1 2 4 3\nv 2 0 0\nv 3 0 0\n#MRGB ffff0000ffff0000\nf 2 5 6\n";
    assert_eq!(colours(second).0, [GREEN, GREEN, GREEN, GREEN, RED, RED]);
    let third = "f 1 2 4 3\nv 2 0 0\nv 3 0 0\n#MRGB ffff0000ffff0000\nf 2 5 6\n";
    let white = Srgb::WHITE;
    assert_eq!(colours(third).0, [white, white, white, white, RED, RED]);
    let told = "some.obj:5: an #MRGB line has eight hexadecimal digits for each vertex; its rest is not shown";
    assert_eq!(colours("#MRGB ffff00\n"), (vec![], vec![told.to_owned()]));
    let (cut, warnings) = colours("#MRGB ffff0000ff00ffxx\n#MRGB ff0000ff\n");
    assert_eq!(cut, [Srgb::WHITE, Srgb::WHITE, RED, Srgb([0, 0, 255])]);
    assert_eq!(warnings, [told]);
}

/// A backslash at the end of a name belongs to it, and joined files have byte order marks inside.
#[test]
fn names_may_end_in_a_backslash_and_lines_begin_with_a_mark() {
    let folders = "newmtl a\nKd 1 0 0\nmap_Kd C:\\tex\\\nnewmtl b\nKd 0 1 0\n";
    assert_eq!(used("a", folders).0, Some(RED));
    assert_eq!(used("b", folders), (Some(GREEN), vec![]));
    let text = "g Rooms\\\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nf 1 2 3\n";
    let rooms = super::mesh(text);
    assert_eq!(super::parts(&rooms), [("Rooms\\", 1)]);
    assert_eq!(super::bounds(&rooms).max, glam::DVec3::new(1.0, 1.0, 0.0));
    let marks = "\u{feff}newmtl red\nKd 1 0 0\n\u{feff}newmtl a\nKd 0 1 0\n";
    assert_eq!(used("red", marks), (Some(RED), vec![]));
    assert_eq!(used("a", marks), (Some(GREEN), vec![]));
    let (colour, warnings) = used("a", "newmtl a\nKd 1.#IND 1.#IND 1.#IND\n");
    assert_eq!((colour, warnings.len()), (None, 1));
}

/// A black surface shows no form, and where a texture has the colours, black is not meant.
#[test]
fn black_under_a_texture_is_neutral() {
    for (lines, colour) in [
        ("Kd 0 0 0\nmap_Kd skin.png", None),
        ("map_kd \"skin one.png\"\nKd 0.00 0.00 0.00", None),
        ("Kd 0\nmap_Ka -s 1 1 1 skin.png", None),
        ("Kd 0 0 0", Some(Srgb([0; 3]))),
        ("Kd 0 0 0\nmap_Kd", Some(Srgb([0; 3]))),
        ("Kd 0 0 0\nmap_Bump bumps.png", Some(Srgb([0; 3]))),
        ("Kd 1 0 0\nmap_Kd skin.png", Some(RED)),
    ] {
        let (found, _) = used("a", &format!("newmtl a\n{lines}\n"));
        assert_eq!(found, colour, "{lines}");
    }
}

/// A smoothing group without normals is shaded smoothly, but at right angles, and sharply against other groups.
#[test]
fn smoothing_groups_are_smooth_within_and_sharp_between() {
    // A column of six sides, which meet at 60 degrees, with a floor and a roof.
    let corner = |i: u8, y: u8| {
        let (sin, cos) = (f64::from(i) * std::f64::consts::FRAC_PI_3).sin_cos();
        format!("v {cos} {y} {sin}\n")
    };
    let vertices: String = (0..6).flat_map(|i| [corner(i, 0), corner(i, 1)]).collect();
    let side = |i: u8| {
        let [a, b] = [2 * i + 1, 2 * ((i + 1) % 6) + 1];
        format!("f {a} {} {} {b}\n", a + 1, b + 1)
    };
    let sides: Vec<String> = (0..6).map(side).collect();
    let ends = "f 1 3 5 7 9 11\nf 12 10 8 6 4 2\n";
    let normals = |faces: &str| {
        let folder = Folder::new(&[("some.obj", format!("{vertices}{faces}").as_bytes())]);
        let file = folder.load("some.obj").expect("it loads");
        file.mesh.normals().normals.len()
    };
    let all = sides.concat() + ends;
    // Each vertex has a normal of the sides and one of floor or roof; where the sides are sharp, one more.
    let (smooth, sharp) = (24, 36);
    assert_eq!(normals(&all), sharp, "60 degrees is a crease");
    for (group, wanted) in [
        ("s 1", smooth),
        ("s 17", smooth),
        ("s\t1", smooth),
        ("s on", smooth),
        ("S ON", smooth),
        ("s off", sharp),
        ("s 0", sharp),
        ("s", sharp),
    ] {
        assert_eq!(normals(&format!("{group}\n{all}")), wanted, "{group}");
    }
    let apart = (sides.iter().zip(1..)).map(|(side, group)| format!("s {group}\n{side}"));
    assert_eq!(normals(&(apart.collect::<String>() + ends)), sharp);
    // One side is of no group, and the other five are smooth among themselves.
    let off = format!("s off\n{}s 1\n{}{ends}", sides[0], sides[1..].concat());
    assert_eq!(normals(&off), smooth + 4);
}

#[test]
fn what_has_no_faces_is_refused_and_counted() {
    for (text, counts) in [
        (
            format!("{TRIANGLE}l 1 2 3\nl 2 3\n"),
            "vertices: 3, points and lines: 2",
        ),
        (
            format!("{TRIANGLE}p 1 2 3\n"),
            "vertices: 3, points and lines: 3",
        ),
        (TRIANGLE.to_owned(), "vertices: 3"),
    ] {
        let folder = Folder::new(&[("some.obj", text.as_bytes())]);
        let refused = folder.load("some.obj").expect_err("nothing to pick");
        assert_eq!(
            folder.relative(&refused),
            format!("some.obj: no faces to show ({counts})")
        );
    }
}

#[test]
fn textures_are_named_without_options_and_comments() {
    for (line, name) in [
        ("map_Kd tex.png", "tex.png"),
        ("map_Kd my tex.png", "my tex.png"),
        ("map_Kd tex.png # diffuse", "tex.png"),
        ("map_Bump -bm 0.3 b.png", "b.png"),
        ("map_Bump b.png -bm 0.3", "b.png"),
        ("map_Kd -s 1 1 1 -clamp on my tex.png", "my tex.png"),
        ("bump -imfchan r b-1.png", "b-1.png"),
    ] {
        let (_, warnings) = used("a", &format!("newmtl a\nKd 1 0 0\n{line}\n"));
        let told = format!("some.obj: textures are not shown (1 file: {name})");
        assert_eq!(warnings, [told], "{line}");
    }
    for line in ["map_Kd # none", "map_Kd", "map_aat on"] {
        let black = used("a", &format!("newmtl a\nKd 0 0 0\n{line}\n"));
        assert_eq!(black, (Some(Srgb([0; 3])), vec![]), "{line}");
    }
}

#[test]
fn what_differs_is_not_one() {
    // A blank that does not break is no blank between words.
    let (colour, warnings) = used("a\u{a0}b", "newmtl a b\nKd 1 0 0\n");
    assert_eq!((colour, warnings.len()), (None, 1));
    // Long names that are alike where they are cut.
    let groups = [1, 2].map(|i| format!("g {}{i}\nf 1 2 3\n", "a".repeat(300)));
    let (colours, _) = read(&groups.concat(), &[]);
    assert_eq!(colours.len(), 2);
}

#[test]
fn a_library_without_materials_is_told_where_one_is_used() {
    let header = [("a.mtl", "# Blender 4.2.0 MTL File: 'None'\n")];
    assert_eq!(read("mtllib a.mtl\nf 1 2 3\n", &header).1, [""; 0]);
    let used = read("mtllib a.mtl\nusemtl a\nf 1 2 3\n", &header).1;
    assert_eq!(
        used,
        ["some.obj:4: the material file a.mtl has no materials in it"]
    );
}
