//! What is behind a scene, and pictures without anything behind them.

use super::*;
use sightline::{colour::Srgb, image::Picture, look::Backdrop, render::SMOOTH_SAMPLES};

/// Each background shows where nothing is drawn, by the adapter and by rays, and nowhere else.
#[test]
fn each_background_is_drawn_and_cast_alike() {
    let (scene, view) = (shapes(DVec3::ZERO), overview([160, 120]));
    let gpu = gpu();
    let both = |background| {
        let drawn = sightline::render::picture(&gpu, &scene, &view, background);
        let (ids, cast) = pick::raycast(&scene, &view, background);
        (ids, drawn.expect("a picture"), cast)
    };
    let (ids, drawn_on_black, cast_on_black) = both(Background::BLACK);
    let is_within = |(x, y): (u32, u32)| {
        let columns = move |y| (x.max(1) - 1..=(x + 1).min(159)).map(move |x| (x, y));
        let mut around = (y.max(1) - 1..=(y + 1).min(119)).flat_map(columns);
        around.all(|(i, j)| (ids.at(i, j).object == 0) == (ids.at(x, y).object == 0))
    };
    let mut corners = Vec::new();
    for background in [Background::DARK, Background::LIGHT, Background::WHITE] {
        let (_, drawn, cast) = both(background);
        let [mut behind, mut before] = [0, 0];
        for (x, y) in ids.positions().filter(|at| is_within(*at)) {
            if ids.at(x, y).object == 0 {
                assert!(!apart(drawn.at(x, y), cast.at(x, y), 1), "{x}, {y}");
                behind += 1;
            } else {
                assert_eq!(drawn.at(x, y), drawn_on_black.at(x, y), "{x}, {y}");
                assert_eq!(cast.at(x, y), cast_on_black.at(x, y), "{x}, {y}");
                before += 1;
            }
        }
        assert!(behind > 2000 && before > 2000, "{behind}, {before}");
        corners.push([drawn.at(0, 0), drawn.at(0, 119)].map(|[r, ..]| r));
    }
    let [[dark, darker], [light, less_light], white] = corners[..] else {
        panic!("{corners:?}");
    };
    assert!(darker < dark && dark < 60 && 180 < less_light && less_light < light);
    assert_eq!(white, [255; 2]);
}

/// A picture without background, laid over one, is the picture on it, edges, outline and half transparent lines
/// included. Over a light one, lines of the picture on it are darker.
#[test]
fn a_transparent_picture_can_be_laid_over_any_background() {
    let (scene, view) = (shapes(DVec3::ZERO), overview([200, 150]));
    let gpu = gpu();
    let [from, to] = [DVec3::new(-9.0, 2.0, 0.0), DVec3::new(9.0, 2.0, 1.0)];
    let line = Line {
        opacity: [0.2, 0.9],
        ..Line::new(from, to, Srgb([20, 200, 90]))
    };
    let draw = |background| {
        let targets = Targets::new(&gpu, view.viewport, SMOOTH_SAMPLES)?;
        let buffers = SceneBuffers::upload(&gpu, &scene)?;
        let mut renderer = Renderer::new(&gpu, SMOOTH_SAMPLES);
        renderer.background = background;
        let onto = (&buffers, &targets, &view);
        renderer.draw(onto, &[line])?;
        renderer.draw_outline(onto, &[2]);
        let marks = Marks {
            selection: vec![2],
            hover: None,
        };
        renderer.read_marked(onto, &marks)
    };
    let picture = Picture::on(Backdrop::Transparent, draw).expect("a picture");
    let pixels = picture.to_rgba();
    let count = |holds: fn(u8) -> bool| pixels.iter().filter(|pixel| holds(pixel[3])).count();
    let counts = [
        count(|alpha| alpha == 0),
        count(|alpha| alpha == 255),
        count(|alpha| (1..255).contains(&alpha)),
    ];
    assert!(
        counts[0] > 3000 && counts[1] > 3000 && counts[2] > 300,
        "{counts:?}"
    );
    let mut changed = 0;
    let blue = Background([Srgb([120, 140, 180]), Srgb([20, 30, 170])]);
    for background in [Background::DARK, blue, Background::GREY] {
        let drawn = draw(background).expect("a picture");
        for ((x, y), &[r, g, b, alpha]) in drawn.positions().zip(&pixels) {
            #[expect(clippy::cast_precision_loss, reason = "few pixels")]
            let behind = background.at((y as f32 + 0.5) / 150.0);
            let opacity = f32::from(alpha) / 255.0;
            let colour = Srgb([r, g, b]).to_linear();
            let over = std::array::from_fn(|i| colour[i] * opacity + behind[i] * (1.0 - opacity));
            // A step of opacity is up to five levels of a dark colour.
            let most = if alpha == 0 || alpha == 255 { 1 } else { 6 };
            let apart = images::apart(Srgb::from_linear(over).0, drawn.at(x, y), most);
            assert!(!apart, "{x}, {y}: {over:?} {:?} at {alpha}", drawn.at(x, y));
            changed += usize::from((1..255).contains(&alpha));
        }
    }
    assert_eq!(changed, 3 * counts[2]);
}
