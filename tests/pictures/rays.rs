//! A picture that rays found looks like a drawn one, so that it can take its place.

use crate::{
    draw,
    images::{apart, differing_where},
    overview,
    scenes::{gpu, shapes},
    show,
};
use glam::{DVec3, dvec3};
use sightline::{
    camera::{DepthMapping, Lens, Projection, View},
    colour::Srgb,
    geometry::{Placement, Section, Sides},
    image::{Image, Pixel, Rgb},
    look::Background,
    pick,
    render::{Gpu, Line, Marks, Renderer, SMOOTH_SAMPLES, SceneBuffers, Targets, picture},
    scene::{Object, Scene, Shape},
};
use std::time::{Duration, Instant};

/// A line's colour.
const LINE: Srgb = Srgb([255, 0, 255]);

/// Lines across the scene, before, within and behind its objects.
fn lines() -> Vec<Line> {
    let across = |i: i32| {
        let y = f64::from(i) * 0.1;
        [(-4.0, 1.5), (1.5, -4.0), (-1.0, -1.0)]
            .map(|(z, other)| Line::new(dvec3(-3.0, y, z), dvec3(3.0, y, other), LINE))
    };
    (-12..=12).flat_map(across).collect()
}

/// What rays find, the targets with so many samples that take it, and the finished picture with an object selected.
fn by_rays(
    gpu: &Gpu,
    scene: &Scene,
    view: &View,
    lines: &[Line],
    object: usize,
    samples: u32,
) -> (Image<Pixel>, Targets, Image<Rgb>) {
    let marks = Marks {
        selection: vec![object],
        hover: None,
    };
    let deadline = Instant::now() + Duration::from_mins(10);
    let pixels = pick::raycast_until(scene, view, Background::DARK, deadline).expect("in time");
    let buffers = SceneBuffers::upload(gpu, scene).expect("fits");
    let targets = Targets::new(gpu, view.viewport, samples).expect("fits");
    let mut renderer = Renderer::new(gpu, samples);
    let onto = (&buffers, &targets, view);
    let taken = renderer.take_pixels(onto, &pixels, lines);
    taken.expect("fits");
    renderer.draw_outline(onto, &[object]);
    let picture = renderer.read_marked(onto, &marks);
    (pixels, targets, picture.expect("a picture"))
}

/// A view through each kind of lens, one with a section, and one of front sides alone.
pub(crate) fn views() -> [(&'static str, View); 5] {
    let plain = overview([640, 400]);
    let lens = *plain.camera.lens();
    let of = |lens: Lens| View {
        camera: plain.camera.with_lens(lens).expect("a camera"),
        ..plain
    };
    let standard = of(Lens {
        depth: DepthMapping::Standard,
        ..lens
    });
    let parallel = of(Lens {
        projection: Projection::Orthographic { height: 5.0 },
        ..lens
    });
    let cut = View {
        section: Some(Section::new(dvec3(0.3, -0.2, -1.0), 0.1).expect("a plane")),
        ..plain
    };
    let front = View {
        sides: Sides::Front,
        ..plain
    };
    [
        ("reversed", plain),
        ("standard", standard),
        ("parallel", parallel),
        ("cut", cut),
        ("front", front),
    ]
}

/// Colours, ids, lines behind objects, tint and outline are as drawn, except for some pixels at outlines, where drawing
/// and picking may differ.
#[test]
fn pixels_that_rays_found_look_as_if_drawn() {
    let (gpu, scene, lines) = (gpu(), shapes(DVec3::ZERO), lines());
    scene.build_trees();
    let with_samples = [1, SMOOTH_SAMPLES];
    assert!(with_samples[1] > 1);
    for ((name, view), object) in views().into_iter().flat_map(|view| [(view, 3), (view, 7)]) {
        let marks = Marks {
            selection: vec![object],
            hover: None,
        };
        let (ids, _, drawn) = draw(&gpu, &scene, &view, &lines, &marks, 1);
        for samples in with_samples {
            let (pixels, targets, picture) = by_rays(&gpu, &scene, &view, &lines, object, samples);
            show(&format!("rays-{name}-{object}-{samples}"), &picture);
            let taken = targets.read_ids(&gpu).expect("ids");
            let [mut on_lines, mut differ] = [0; 2];
            for (x, y) in drawn.positions() {
                assert_eq!(taken.at(x, y), pixels.at(x, y).id, "{x}, {y}");
                on_lines += u32::from(!apart(picture.at(x, y), LINE.0, 2));
                let is_alike = !apart(picture.at(x, y), drawn.at(x, y), 2);
                differ += u32::from(!is_alike || taken.at(x, y) != ids.at(x, y));
            }
            assert!(on_lines > 2000, "{name}: {on_lines} pixels of lines");
            // 0.2 % of the picture.
            assert!(differ < 512, "{name}, {object}: {differ} pixels differ");
        }
    }
}

#[test]
fn a_picture_that_is_not_done_in_time_is_none() {
    let scene = shapes(DVec3::ZERO);
    let view = overview([64, 40]);
    assert!(pick::raycast_until(&scene, &view, Background::DARK, Instant::now()).is_none());
}

/// A face in the section's plane hides what lies behind it, in smooth colours too.
#[test]
fn a_face_in_the_plane_is_drawn_as_a_whole() {
    let cube = Object::new("cube", Shape::Cube, Placement::IDENTITY);
    let scene = Scene::new(vec![cube]);
    let top = View {
        section: Some(Section::new(DVec3::NEG_Y, 0.5).expect("a plane")),
        ..overview([320, 240])
    };
    let parallel = Lens {
        projection: Projection::Orthographic { height: 3.0 },
        ..*top.camera.lens()
    };
    let camera = top.camera.with_lens(parallel).expect("a camera");
    for view in [top, View { camera, ..top }] {
        let drawn = picture(&gpu(), &scene, &view, Background::DARK).expect("a picture");
        let (ids, by_rays) = pick::raycast(&scene, &view, Background::DARK);
        let shown = ids.pixels().iter().filter(|id| id.object == 1).count();
        let differ = differing_where(&drawn, &by_rays, |a, b, _| apart(a, b, 20));
        assert!(shown > 2000, "{shown}");
        // Outlines are smooth in one of them.
        assert!(differ < shown / 10, "{differ} of {shown}");
    }
}

/// A picture by rays alone has the tint and the outline that drawing gives, as wide and as smooth.
#[test]
fn rays_mark_the_selection_as_drawing_does() {
    let (gpu, scene, view) = (gpu(), shapes(DVec3::ZERO), overview([640, 400]));
    for object in [3, 7] {
        let marks = Marks {
            selection: vec![object],
            hover: None,
        };
        let (drawn_ids, plain, drawn) = draw(&gpu, &scene, &view, &[], &marks, 1);
        let (ids, mut by_rays) = pick::raycast(&scene, &view, Background::DARK);
        pick::mark(object, &ids, &mut by_rays, Background::DARK);
        let [mut outline, mut differ] = [0; 2];
        for (x, y) in drawn.positions() {
            let is_selected = ids.at(x, y).object as usize == object + 1;
            outline += u32::from(!is_selected && apart(drawn.at(x, y), plain.at(x, y), 2));
            let is_alike = !apart(by_rays.at(x, y), drawn.at(x, y), 2);
            differ += u32::from(!is_alike || ids.at(x, y) != drawn_ids.at(x, y));
        }
        assert!(outline > 100, "{object}: {outline} pixels of outline");
        assert!(
            differ < outline / 4,
            "{object}: {differ} pixels differ, {outline} are outline"
        );
    }
}
