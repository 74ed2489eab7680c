//! The panel names the surfaces that lie in one place, and V marks their pixels.

use super::*;
use sightline::image::{Image, Rgb};

/// A small square in the plane of a large one, and a cube behind both.
const PLANE: &str = r#"
[camera]
eye = [0, 0, 4]
target = [0, 0, 0]
[[object]]
name = "wall"
shape = "square"
scale = 2
[[object]]
name = "poster"
shape = "square"
rotation = [0, 0, 20]
[[object]]
name = "behind"
shape = "cube"
position = [0, 0, -2]
"#;

/// How many pixels have this colour, within a few levels.
fn count_of(picture: &Image<Rgb>, colour: Rgb) -> usize {
    let is_it = |pixel: &&Rgb| (0..3).all(|i| pixel[i].abs_diff(colour[i]) <= 3);
    picture.pixels().iter().filter(is_it).count()
}

/// Writes a picture where `SIGHTLINE_PICTURES` says, for people to look at.
fn show(name: &str, picture: &Image<Rgb>) {
    if let Some(folder) = std::env::var_os("SIGHTLINE_PICTURES") {
        let file = PathBuf::from(folder).join(format!("one-place-{name}.png"));
        picture.write_png(&file).expect("writable");
    }
}

#[test]
fn the_panel_names_them_and_the_check_marks_them() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("plane.toml");
    std::fs::write(&path, PLANE).expect("writable");
    let mut window = open(vec![path], 1.0);
    let named = "two in one place: wall and poster";
    let beside = MIDDLE + egui::vec2(150.0, 0.0);
    click(&mut window, beside);
    assert_eq!(selected(&window), Some("wall"));
    assert!(
        !has_control(&window, named),
        "the poster does not reach there"
    );
    click(&mut window, MIDDLE);
    assert_eq!(selected(&window), Some("wall"));
    assert!(has_control(&window, named));
    show("named", &window.picture().expect("a picture"));
    press_key(&mut window, Modifiers::NONE, Key::J);
    let line = window.copied().expect("the pick").to_owned();
    assert!(
        line.contains(r#""in_one_place":{"count":2,"named":[{"object":"wall""#),
        "{line}"
    );
    // The next hits: the poster is in the same place, the cube is not.
    press_key(&mut window, Modifiers::NONE, Key::N);
    assert_eq!(selected(&window), Some("poster"));
    assert!(has_control(&window, named));
    press_key(&mut window, Modifiers::NONE, Key::N);
    assert_eq!(selected(&window), Some("behind"));
    assert!(!has_control(&window, named));
    press_key(&mut window, Modifiers::NONE, Key::Escape);

    let plain = window.picture().expect("a picture");
    press_key(&mut window, Modifiers::NONE, Key::V);
    let checked = window.picture().expect("a picture");
    assert!(has_control(&window, "V closes this"));
    assert!(has_control(&window, "surfaces in one place"));
    show("marked", &checked);
    // Beside the poster the wall keeps its colour. At the poster the colour is mixed half and half with the tint.
    let at = |picture: &Image<Rgb>, at: Pos2| {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "positive"
        )]
        let [x, y] = [at.x as u32, at.y as u32];
        picture.at(x, y)
    };
    assert_eq!(at(&plain, beside), at(&checked, beside), "the wall alone");
    let tinted = at(&checked, MIDDLE);
    let expected: Rgb = std::array::from_fn(|i| at(&plain, MIDDLE)[i].midpoint([0, 114, 178][i]));
    assert!(
        (0..3).all(|i| tinted[i].abs_diff(expected[i]) <= 8),
        "{tinted:?} for {expected:?}"
    );
    let pixels = count_of(&checked, tinted);
    assert!(pixels > 10_000, "{pixels}");
    assert_eq!(count_of(&plain, tinted), 0);
}
