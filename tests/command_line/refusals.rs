//! What is refused gets one line that says why, and an exit code.

use crate::{Folder, error};
use std::process::{Command, Output};

#[test]
fn a_wrong_use_is_exit_code_2() {
    let folder = Folder::new();
    for (args, word) in [
        ("pick scene.toml", "--at"),
        ("pick scene.toml --at 5", "X,Y"),
        ("pick --at 5,5 scene.toml", "before --at"),
        ("pick scene.toml --at 5,nan", "X,Y"),
        ("pick scene.toml --at 1280,5", "outside"),
        ("pick scene.toml --at 5,720", "outside"),
        ("pick scene.toml --at=-0.5,5", "outside"),
        ("pick scene.toml --at -1,5", "cannot be negative"),
        ("pick scene.toml --at 5,5 --size 5", "WxH"),
        ("pick scene.toml --at 5,5 --size 0x5", "WxH"),
        ("pick scene.toml --at 5,5 --size -5x5", "WxH"),
        ("pick scene.toml --at 5,5 --size 99999x99999", "WxH"),
        ("pick scene.toml --at 5,5 --eye 1,2", "x,y,z"),
        ("pick scene.toml --at 5,5 --eye --cull", "x,y,z"),
        ("pick scene.toml --at 5,5 --fov 0", "180"),
        ("pick scene.toml --at 5,5 --fov inf", "1.29e33"),
        ("pick scene.toml --at 5,5 --near 5 --far 4", "near"),
        ("pick scene.toml --at 5,5 --near 0", "near"),
        ("pick scene.toml --at 5,5 --far -1", "far must"),
        ("pick scene.toml --at 5,5 --ortho -3", "height"),
        (
            "pick scene.toml --at 5,5 --ortho 3 --fov 40",
            "cannot be used with",
        ),
        (
            "pick scene.toml --at 5,5 --look 0,0,1 --target 1,1,1",
            "cannot be used with",
        ),
        ("pick scene.toml --at 5,5 --up 0,0,1", "line of sight"),
        ("pick scene.toml --at 5,5 --target 0,0,10", "same point"),
        ("pick scene.toml --at 5,5 --depth upside", "reversed"),
        ("pick scene.toml --at 5,5 --up-axis x", "up-axis"),
        ("pick scene.toml --at 5,5 --hide 4", "1 to 3"),
        ("pick scene.toml --at 5,5 --hide 0", "1 to 3"),
        ("pick scene.toml --at 5,5 --hide Front", "3,5"),
        ("pick scene.toml --at 5,5 --hide -1", "3,5"),
        ("pick scene.toml --at 5,5 --look 0,0,0", "zero"),
        ("pick scene.toml --at 5,5 --section 1,2", "NX,NY,NZ,C"),
        ("pick scene.toml --at 5,5 --section w:3", "x:0.5"),
        (
            "pick scene.toml --at 5,5 --section 0,0,0,1",
            "must not be 0,0,0",
        ),
        ("pick scene.toml --at 5,5 --section x:nan", "1.29e33"),
        (
            "pick scene.toml --at 5,5 --section points:0,0,0/1,1,1/2,2,2",
            "one line",
        ),
        ("pick scene.toml --at 5,5 --section face:4", "1 to 3"),
        ("pick scene.toml --at 5,5 --hide 1,4", "'sightline list'"),
        ("pick scene.toml --at 5,5 --show 4", "--show: "),
        (
            "pick scene.toml --at 5,5 --section face:4,0",
            "'sightline list'",
        ),
        ("pick scene.toml --at 5,5 --section face:1", "face:ID,FACE"),
        (
            "pick scene.toml --at 5,5 --section face:1,6",
            "face:ID,FACE",
        ),
        ("study scene.toml", "--budget"),
        ("study --budget 1 --section x:0", "no section"),
        ("study --budget -1", "above 0"),
        ("study --budget 1 --out a", "cannot be used with"),
        ("study --budget 1 --quick", "cannot be used with"),
        ("study --seed -1", "whole number"),
        ("study --fov 30", "--budget"),
        ("pick scene.toml --at 5,5 --frobnicate", "--frobnicate"),
        ("pick scene.toml --at 5,5 --sise 5x5", "'--size'"),
        ("render scene.toml -o a.jpg", "PNG"),
        ("render scene.toml -o a", "PNG"),
        ("render scene.toml -o - --ids -", "one file"),
        ("verify scene.toml --image -", "PNG"),
        ("render scene.toml -o a.png --ids a.tif", "PNG"),
        ("render scene.toml -o a.png --ids ./a.png", "one file"),
        ("verify scene.toml --image a.jpg", "PNG"),
        ("render scene.toml", "--output"),
        ("render scene.toml -o a.png --by magic", "raycast"),
        (
            "render scene.toml -o a.png --by raycast --pick 1280,0",
            "outside",
        ),
    ] {
        let error = folder.error(args, 2);
        assert!(error.contains(word), "{args}: {error} does not say {word}");
    }
    assert!(!folder.path("a.png").exists());
}

#[test]
fn a_bad_file_is_exit_code_3_and_named() {
    let folder = Folder::new();
    std::fs::write(folder.path("bad.toml"), "[[object]]\nshape = \"ball\"\n").unwrap();
    let crossed = "[camera]\nnear = 5\nfar = 4\n[[object]]\nshape = \"cube\"\n";
    std::fs::write(folder.path("camera.toml"), crossed).unwrap();
    std::fs::write(
        folder.path("odd.toml"),
        "[[object]]\nshape = \"cu\\nbe\\u0007\"\n",
    )
    .unwrap();
    for (name, section) in [("no_plane", "0,0,0,1"), ("no_face", "face:3")] {
        let text = format!("[camera]\nsection = \"{section}\"\n[[object]]\nshape = \"cube\"\n");
        std::fs::write(folder.path(&format!("{name}.toml")), text).unwrap();
    }
    for (args, word) in [
        (
            "pick no_plane.toml --at 1,1",
            "no_plane.toml:2:11: a section's normal",
        ),
        (
            "pick no_face.toml --at 1,1",
            "no_face.toml:1: section: there is no object 3",
        ),
        ("pick missing.toml --at 1,1", "missing.toml"),
        ("missing.obj", "missing.obj"),
        ("rendr scene.toml", "commands are render, pick, "),
        ("--size 10x10 rendr", "come before scenes and flags"),
        ("--size 10x10 list", "come before scenes and flags"),
        ("list scene.toml bad.toml", "bad.toml:2"),
        ("pick camera.toml --at 1,1", "camera.toml"),
        ("list odd.toml", "odd.toml:2"),
        ("render scene.toml --by raycast -o nowhere/a.png", "nowhere"),
    ] {
        let error = folder.error(args, 3);
        assert!(error.contains(word), "{args}: {error} does not say {word}");
        assert!(!error.trim_end().contains(char::is_control), "{error:?}");
    }
}

/// Runs with only so many kilobytes of memory.
fn run_within(folder: &Folder, kilobytes: u32, args: &str) -> Output {
    let program = env!("CARGO_BIN_EXE_sightline");
    Command::new("sh")
        .args([
            "-c",
            &format!("ulimit -v {kilobytes}; exec {program} {args}"),
        ])
        .current_dir(folder.path("."))
        .env("RUST_LOG", "off")
        .output()
        .unwrap()
}

/// The graphics adapter refuses: the picture fits into its memory, but not its ids as numbers beside it.
#[test]
fn a_drawn_picture_too_large_for_memory_is_refused() {
    let folder = Folder::new();
    for args in [
        "render --size 5120x5120 scene.toml -o out.png --ids ids.png",
        "verify --size 5120x5120 scene.toml",
    ] {
        let output = run_within(&folder, 2_500_000, args);
        let said = crate::error(&output, 4, args);
        assert!(said.contains("is out of memory: draw a smaller"), "{said}");
    }
    assert!(!folder.path("out.png").exists() && !folder.path("ids.png").exists());
}

#[test]
fn a_picture_too_large_for_memory_is_refused() {
    let folder = Folder::new();
    let args = "render --by raycast --size 16384x16384 scene.toml -o out.png";
    let said = crate::error(&run_within(&folder, 3_000_000, args), 2, args);
    assert!(said.contains("16384x16384 needs 6174 MB"), "{said}");
    assert!(!folder.path("out.png").exists());
}

/// The parser of scene files takes many bytes for each byte of text.
#[test]
fn a_scene_file_too_large_for_memory_is_refused() {
    let folder = Folder::new();
    std::fs::write(folder.path("long.toml"), "\n".repeat(20_000_000)).unwrap();
    let said = crate::error(&run_within(&folder, 1_000_000, "list long.toml"), 3, "list");
    assert!(said.contains("long.toml: cannot be read: "), "{said}");
    std::fs::write(folder.path("short.toml"), "\n".repeat(2_000_000)).unwrap();
    assert!(
        run_within(&folder, 1_000_000, "list short.toml")
            .status
            .success()
    );
}

/// Its text is not read at all: it is a hole.
#[test]
fn an_obj_file_too_large_for_memory_is_refused() {
    let folder = Folder::new();
    let file = std::fs::File::create(folder.path("long.obj")).unwrap();
    file.set_len(1_000_000_000).unwrap();
    let said = crate::error(&run_within(&folder, 1_000_000, "list long.obj"), 3, "list");
    assert!(
        said.contains("long.obj: cannot be read: out of memory"),
        "{said}"
    );
}

/// A camera that cannot be is refused by the line where the file has it, also far down in a long file.
#[test]
fn a_camera_that_cannot_be_is_named_by_file_and_line() {
    let folder = Folder::new();
    let object = "[[object]]\nshape = \"cube\"\n";
    for (camera, what) in [
        ("fov = 200", "field of view"),
        ("near = 0", "near"),
        ("eye = [1, 1, 1]\ntarget = [1, 1, 1]", "eye"),
        ("section = \"face:1,99\"", "section"),
    ] {
        for count in [1, 3000] {
            let text = format!("{}[camera]\n{camera}\n", object.repeat(count));
            std::fs::write(folder.path("bad.toml"), text).unwrap();
            let line = folder.error("pick bad.toml --at 5,5", 3);
            let place = format!("bad.toml:{}: ", 2 * count + 1);
            assert!(line.contains(&place) && line.contains(what), "{line}");
        }
    }
}

/// Exit code 0 would say that the help was printed.
#[cfg(target_os = "linux")]
#[test]
fn help_that_cannot_be_written_is_an_error() {
    let folder = Folder::new();
    for args in ["--help", "--version", "help pick"] {
        let full = std::fs::File::create("/dev/full").unwrap();
        let output = folder.command(args).stdout(full).output().unwrap();
        assert!(error(&output, 3, args).contains("standard output"));
    }
}
