//! Panels as they were when somebody last looked at them: `goldens/*.png`. After a wanted change, run with
//! `SIGHTLINE_GOLDENS=write` and look at each.

use super::{MIDDLE, click, here, open, press_key, px, row};
use egui::{Key, Modifiers, pos2};
use sightline::image::{Image, Rgb};
use sightline::viewer::offscreen::Offscreen;

/// The window in the state that is pictured, and where: left, top, width, height in points.
fn shown(name: &str) -> (Offscreen, [u32; 4]) {
    let (mut window, _folder) = row(1.0);
    click(&mut window, MIDDLE);
    // Off the picture, so that nothing is hovered.
    window.send([egui::Event::PointerGone]);
    match name {
        "panels" => (window, [940, 0, 340, 720]),
        "gallery" => {
            let mut window = open(vec!["gallery:stretched".into()], 1.0);
            press_key(&mut window, Modifiers::NONE, Key::M);
            click(&mut window, pos2(735.0, 330.0));
            window.send([egui::Event::PointerGone]);
            (window, [0, 0, 950, 690])
        }
        "pipeline" => {
            press_key(&mut window, Modifiers::NONE, Key::P);
            (window, [215, 50, 620, 560])
        }
        _ => {
            press_key(&mut window, Modifiers::NONE, Key::H);
            (window, [150, 0, 980, 720])
        }
    }
}

fn crop(picture: &Image<Rgb>, [left, top, width, height]: [u32; 4]) -> Image<Rgb> {
    let pixels = (0..width * height).map(|i| picture.at(left + i % width, top + i / width));
    Image::new(px([width, height], 1.0), pixels.collect())
}

pub fn read(path: &std::path::Path) -> Image<Rgb> {
    let file = std::fs::File::open(path).unwrap_or_else(|error| {
        panic!(
            "{}: {error}; SIGHTLINE_GOLDENS=write makes it",
            path.display()
        )
    });
    let mut reader = png::Decoder::new(std::io::BufReader::new(file))
        .read_info()
        .expect("a PNG");
    let mut bytes = vec![0; reader.output_buffer_size().expect("a small picture")];
    let info = reader.next_frame(&mut bytes).expect("pixels");
    let pixels = bytes.as_chunks().0.to_vec();
    Image::new(px([info.width, info.height], 1.0), pixels)
}

#[test]
fn panels_look_as_they_did() {
    for name in ["panels", "pipeline", "help", "gallery"] {
        let (mut window, at) = shown(name);
        let picture = crop(&window.picture().expect("a picture"), at);
        let path = here("goldens").join(name).with_extension("png");
        if std::env::var_os("SIGHTLINE_GOLDENS").is_some_and(|what| what == "write") {
            picture.write_png(&path).expect("a writable folder");
            continue;
        }
        let golden = read(&path);
        assert_eq!(picture.size(), golden.size(), "{name}");
        // Drivers blend a level apart; another digit is dozens.
        let apart = |(a, b): (&Rgb, &Rgb)| a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > 8);
        let differ = picture
            .pixels()
            .iter()
            .zip(golden.pixels())
            .filter(|&pair| apart(pair))
            .count();
        if differ > 0 {
            let seen = std::env::temp_dir().join(format!("{name}.png"));
            picture.write_png(&seen).expect("a writable folder");
            panic!(
                "{name}: {differ} pixels are not as they were; now: {}",
                seen.display()
            );
        }
    }
}
