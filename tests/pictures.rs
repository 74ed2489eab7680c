//! What is drawn looks as it should: like the ray caster's picture, with its marks, lines and culling.

mod common;
#[path = "common/scenes.rs"]
mod scenes;

use common::{orthographic, perspective, view};
use glam::{DVec3, dvec3};
use scenes::{gpu, shapes};
use sightline::{
    camera::{View, Viewport},
    geometry::Sides,
    image::{Id, Image, Rgb},
    pick,
    render::{Gpu, GpuError, Line, Marks, Renderer, SceneBuffers, Targets},
    scene::Scene,
};

fn overview(size: [u32; 2]) -> View {
    view(
        [3.2, 2.6, 6.0],
        [0.0, -0.1, 0.0],
        perspective(40.0, 0.1, 100.0),
        size,
    )
}

/// Ids, colours and the finished picture at `samples` a pixel.
fn draw(
    gpu: &Gpu,
    scene: &Scene,
    view: &View,
    lines: &[Line],
    marks: &Marks,
    samples: u32,
) -> (Image<Id>, Image<Rgb>, Image<Rgb>) {
    let mut renderer = Renderer::new(gpu, samples);
    let buffers = SceneBuffers::upload(gpu, scene).expect("fits");
    let targets = Targets::new(gpu, view.viewport, samples).expect("fits");
    renderer
        .draw(gpu, &buffers, &targets, view, lines)
        .expect("draws");
    if let Some(object) = marks.selection {
        renderer.draw_selection(gpu, &buffers, &targets, view, object);
    }
    let picture = renderer.composite_to_image(gpu, &buffers, &targets, view, marks);
    (
        targets.read_ids(gpu).expect("ids"),
        targets.read_colours(gpu).expect("colours"),
        picture.expect("a picture"),
    )
}

fn far_apart(a: Rgb, b: Rgb, by: u8) -> bool {
    a.iter().zip(b).any(|(&a, b)| a.abs_diff(b) > by)
}

/// Writes a picture where `SIGHTLINE_PICTURES` says, for people to look at.
fn show(name: &str, picture: &Image<Rgb>) {
    if let Some(folder) = std::env::var_os("SIGHTLINE_PICTURES") {
        let path = std::path::Path::new(&folder)
            .join(name)
            .with_extension("png");
        picture.write_png(&path).expect("a writable folder");
    }
}

#[test]
fn drawn_colours_equal_cast_colours() {
    let gpu = gpu();
    let scene = shapes(DVec3::ZERO);
    let perspective_view = overview([640, 400]);
    let camera = perspective_view
        .camera
        .with_lens(orthographic(5.0, 0.1, 100.0))
        .expect("a lens");
    for view in [
        perspective_view,
        View {
            camera,
            ..perspective_view
        },
    ] {
        let (ids, colours, picture) = draw(&gpu, &scene, &view, &[], &Marks::default(), 1);
        assert_eq!(colours, picture, "a picture without marks is a copy");
        let (cast_ids, cast) = pick::raycast(&scene, &view);
        show("drawn", &colours);
        show("cast", &cast);
        let mut compared = 0;
        for (x, y) in ids
            .positions()
            .filter(|&(x, y)| ids.at(x, y) == cast_ids.at(x, y))
        {
            let (drawn, cast) = (colours.at(x, y), cast.at(x, y));
            assert!(
                !far_apart(drawn, cast, 1),
                "({x}, {y}): drawn {drawn:?}, cast {cast:?}"
            );
            compared += 1;
        }
        assert!(
            compared > 640 * 400 * 99 / 100,
            "only {compared} pixels agree"
        );
    }
}
