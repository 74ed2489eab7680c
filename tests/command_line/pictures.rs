//! Pictures that `render` writes show what `pick` finds. Every kind of view is drawn, and files are replaced only if
//! all can be written.

use crate::{Folder, json};

/// Colour type, bit depth, size and bytes of a PNG.
fn read_png(path: &std::path::Path) -> (png::ColorType, png::BitDepth, [u32; 2], Vec<u8>) {
    let file = std::io::BufReader::new(std::fs::File::open(path).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    (
        info.color_type,
        info.bit_depth,
        [info.width, info.height],
        bytes,
    )
}

#[test]
fn a_picture_by_raycast_shows_what_is_picked() {
    let folder = Folder::new();
    let args = "render scene.toml --by raycast --size 64x48 --eye 3,2,9";
    let output = folder.run(&format!("{args} -o a.png --ids ids.png"));
    assert!(output.status.success() && output.stdout.is_empty() && output.stderr.is_empty());
    let (colour, depth, size, plain) = read_png(&folder.path("a.png"));
    assert_eq!(
        (colour, depth, size),
        (png::ColorType::Rgb, png::BitDepth::Eight, [64, 48])
    );
    let (colour, depth, size, ids) = read_png(&folder.path("ids.png"));
    assert_eq!(
        (colour, depth, size),
        (png::ColorType::Grayscale, png::BitDepth::Sixteen, [64, 48])
    );
    let ids: Vec<u64> = ids
        .chunks(2)
        .map(|id| u64::from(id[0]) << 8 | u64::from(id[1]))
        .collect();

    let centres: String = (0..48)
        .flat_map(|y| (0..64).map(move |x| format!("{x}.5,{y}.5\n")))
        .collect();
    let picks = folder.run_with("pick scene.toml --size 64x48 --eye 3,2,9 --at -", &centres);
    let picked: Vec<u64> = json(&picks)
        .iter()
        .map(|line| line["hit"]["id"].as_u64().unwrap_or(0))
        .collect();
    assert_eq!(ids, picked);
    for id in 0..=3 {
        assert!(
            ids.iter().filter(|&&found| found == id).count() > 20,
            "object {id} shows"
        );
    }

    // Selecting tints the selected object's pixels, and draws an outline a few pixels wide around them.
    let ball = ids.iter().rposition(|&id| id == 3).unwrap();
    let at = format!("{}.5,{}.5", ball % 64, ball / 64);
    assert!(
        folder
            .run(&format!("{args} -o b.png --pick {at}"))
            .status
            .success()
    );
    let (.., selected) = read_png(&folder.path("b.png"));
    let changed: Vec<bool> = plain
        .chunks(3)
        .zip(selected.chunks(3))
        .map(|(a, b)| a != b)
        .collect();
    let count = |id: u64| {
        ids.iter()
            .zip(&changed)
            .filter(|(found, changed)| **found == id && **changed)
            .count()
    };
    assert_eq!(
        count(3),
        ids.iter().filter(|&&id| id == 3).count(),
        "all of it is tinted"
    );
    assert!(count(0) > 5, "the outline lies around it");
    assert!(
        count(1) + count(2) > 5,
        "also where something stands before it"
    );
    assert!(
        ids.iter()
            .zip(&changed)
            .any(|(id, changed)| *id == 1 && !changed)
    );
    // Where nothing is, nothing is selected.
    assert!(
        folder
            .run(&format!("{args} -o c.png --pick 0,0"))
            .status
            .success()
    );
    assert_eq!(read_png(&folder.path("c.png")).3, plain);
}

#[test]
fn views_are_drawn_by_the_words_that_the_window_has() {
    let folder = Folder::new();
    let draw = |views: &str, more: &str| {
        let args =
            format!("render scene.toml --views {views} --size 320x240 -o {views}.png {more}");
        folder.run(&args)
    };
    let mut pictures = Vec::new();
    for views in ["picture", "four", "object", "world", "view", "ndc"] {
        let output = draw(views, "--pick 160,120");
        assert!(
            output.status.success() && output.stdout.is_empty(),
            "{views}: {output:?}"
        );
        let (_, _, size, bytes) = read_png(&folder.path(&format!("{views}.png")));
        assert_eq!(size, [320, 240]);
        assert!(!pictures.contains(&bytes), "{views} is none of the others");
        pictures.push(bytes);
    }
    for (views, more) in [
        ("five", ""),
        ("four", "--ids ids.png"),
        ("four", "--by raycast"),
    ] {
        assert_eq!(draw(views, more).status.code(), Some(2), "{views} {more}");
    }
}

/// The background that is chosen is behind the scene, whoever draws it, and the ids say the same as ever.
#[test]
fn a_picture_is_on_the_background_that_is_chosen() {
    let folder = Folder::new();
    let args = "render scene.toml --size 64x48 --eye 3,2,9 --ids ids.png";
    for by in ["--by raycast", "--by raster --pick 32,24", "--by raster"] {
        let corners = ["dark", "light", "white", "transparent"].map(|name| {
            let output = folder.run(&format!("{args} {by} --background {name} -o {name}.png"));
            assert!(output.status.success(), "{by}: {output:?}");
            let (colour, _, _, bytes) = read_png(&folder.path(&format!("{name}.png")));
            let (.., ids) = read_png(&folder.path("ids.png"));
            if colour == png::ColorType::Rgba {
                let opaque = |id: &[u8], pixel: &[u8]| id[1] > 0 && pixel[3] == 255;
                let pairs = ids.chunks(2).zip(bytes.chunks(4));
                let opaque = pairs.filter(|(id, pixel)| opaque(id, pixel)).count();
                assert!(opaque > 150, "{by}: {opaque}");
                return bytes[3];
            }
            bytes[0]
        });
        let [dark, light, white, alpha] = corners;
        assert!(
            dark < 60 && (200..240).contains(&light),
            "{by}: {corners:?}"
        );
        assert_eq!((white, alpha), (255, 0), "{by}");
    }
    let output = folder.run("render scene.toml --background red -o red.png");
    assert_eq!(output.status.code(), Some(2));
}

/// Neither file is replaced unless both can be written, and one file is not taken for two.
#[test]
fn a_picture_stays_where_its_ids_cannot_be_written() {
    let folder = Folder::new();
    std::fs::write(folder.path("old.png"), "old").unwrap();
    let args = "render scene.toml --by raycast --size 4x4 -o old.png";
    for ids in ["none/ids.png", "folder.png"] {
        std::fs::create_dir_all(folder.path("folder.png")).unwrap();
        folder.error(&format!("{args} --ids {ids}"), 3);
        assert_eq!(std::fs::read(folder.path("old.png")).unwrap(), b"old");
    }
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("old.png", folder.path("link.png")).unwrap();
        let line = folder.error(&format!("{args} --ids link.png"), 2);
        assert!(line.contains("one file"), "{line}");
        assert_eq!(std::fs::read(folder.path("old.png")).unwrap(), b"old");
    }
    // Nothing is left beside the scene and the files that were there.
    let left = std::fs::read_dir(folder.path("")).unwrap().count();
    assert_eq!(left, if cfg!(unix) { 4 } else { 3 });
    let output = folder.run(&format!("{args} --ids ids.png"));
    assert!(output.status.success());
    assert_eq!(read_png(&folder.path("old.png")).0, png::ColorType::Rgb);
    assert_eq!(
        read_png(&folder.path("ids.png")).0,
        png::ColorType::Grayscale
    );
}

/// `-o -` writes the file's bytes to standard output.
#[test]
fn a_picture_goes_to_standard_output() {
    let folder = Folder::new();
    let args = "render scene.toml --by raycast --size 64x48 -o";
    assert!(folder.run(&format!("{args} a.png")).status.success());
    let output = folder.run(&format!("{args} -"));
    assert!(output.status.success());
    assert_eq!(output.stdout, std::fs::read(folder.path("a.png")).unwrap());
    assert!(!folder.path("-").exists());
    let ids = folder.run(&format!("{args} b.png --ids -"));
    assert!(ids.stdout.starts_with(b"\x89PNG") && folder.path("b.png").exists());
}

/// A signal ends the program while it writes a picture, and no part of it stays.
#[cfg(target_os = "linux")]
#[test]
fn a_signal_leaves_no_part_of_a_picture() {
    let parts = |folder: &Folder| {
        let entries = std::fs::read_dir(folder.path("")).unwrap();
        let names = entries.map(|entry| entry.unwrap().file_name());
        names
            .filter(|name| name.to_string_lossy().ends_with(".part"))
            .count()
    };
    let args = "render scene.toml --by raycast --size 3000x3000 -o a.png";
    for signal in ["HUP", "INT", "TERM"] {
        let folder = Folder::new();
        let mut child = folder.command(args).spawn().unwrap();
        while parts(&folder) == 0 {
            assert!(child.try_wait().unwrap().is_none(), "it writes a part");
            std::thread::sleep(std::time::Duration::from_millis(1));
        }
        let kill = format!("kill -{signal} {}", child.id());
        let killed = std::process::Command::new("sh")
            .args(["-c", &kill])
            .status();
        assert!(killed.unwrap().success());
        let status = child.wait().unwrap();
        assert_eq!(
            status.code(),
            None,
            "{signal}: the signal ended it: {status}"
        );
        assert_eq!(parts(&folder), 0, "{signal}");
        assert!(!folder.path("a.png").exists());
    }
}
