//! Drawn pictures look right: like the ray caster's, with marks, lines and culling.
#![cfg(feature = "window")]

mod backgrounds;
#[path = "../common/mod.rs"]
mod common;
#[path = "../common/images.rs"]
mod images;
mod lesser;
mod looks;
mod many;
mod marks;
mod ndc;
mod rays;
#[path = "../common/scenes.rs"]
mod scenes;
mod z_fighting;

use common::{orthographic, perspective, view};
use glam::DVec3;
use images::{apart, differing};
use scenes::{gpu, shapes};
use sightline::{
    camera::View,
    geometry::Sides,
    image::{Id, Image, Rgb},
    look::Background,
    pick,
    render::{Gpu, GpuError, Line, Marks, MeshStore, Renderer, SceneBuffers, Targets},
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

/// Ids, colours and the finished picture with `samples` per pixel.
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
        .draw((&buffers, &targets, view), lines)
        .expect("draws");
    if !marks.selection.is_empty() {
        renderer.draw_outline((&buffers, &targets, view), &marks.selection);
    }
    let picture = renderer.read_marked((&buffers, &targets, view), marks);
    (
        targets.read_ids(gpu).expect("ids"),
        targets.read_colours(gpu).expect("colours"),
        picture.expect("a picture"),
    )
}

/// What is kept of a scene from one drawing to the next.
struct Kept<'a> {
    gpu: &'a Gpu,
    view: View,
    renderer: Renderer,
    meshes: MeshStore,
    buffers: SceneBuffers,
    targets: Targets,
}

impl<'a> Kept<'a> {
    fn new(gpu: &'a Gpu, scene: &Scene, view: View) -> Self {
        Self {
            gpu,
            view,
            renderer: Renderer::new(gpu, 1),
            meshes: MeshStore::default(),
            buffers: SceneBuffers::upload(gpu, scene).expect("fits"),
            targets: Targets::new(gpu, view.viewport, 1).expect("fits"),
        }
    }

    /// The ids of the scene, which may have changed since it was drawn last.
    fn ids(&mut self, scene: &Scene) -> Image<Id> {
        let (gpu, buffers, targets) = (self.gpu, &mut self.buffers, &self.targets);
        let updated = buffers.update(gpu, scene, &mut self.meshes);
        updated.expect("fits");
        let drawn = self.renderer.draw((buffers, targets, &self.view), &[]);
        drawn.expect("draws");
        targets.read_ids(gpu).expect("ids")
    }
}

/// Writes a picture to the folder `SIGHTLINE_PICTURES`, for people to look at.
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
    let orthographic_view = View {
        camera,
        ..perspective_view
    };
    // Near and far cut objects open. Insides show, lit like outsides.
    let lens = perspective(40.0, 6.9, 8.0);
    let camera = perspective_view.camera.with_lens(lens).expect("a lens");
    let cut = View {
        camera,
        ..perspective_view
    };
    for view in [perspective_view, orthographic_view, cut] {
        let (ids, colours, picture) = draw(&gpu, &scene, &view, &[], &Marks::default(), 1);
        assert_eq!(
            differing(&colours, &picture),
            0,
            "a picture without marks is a copy"
        );
        let (cast_ids, cast) = pick::raycast(&scene, &view, Background::DARK);
        show("drawn", &colours);
        show("cast", &cast);
        let mut compared = 0;
        for (x, y) in ids
            .positions()
            .filter(|&(x, y)| ids.at(x, y) == cast_ids.at(x, y))
        {
            let (drawn, cast) = (colours.at(x, y), cast.at(x, y));
            assert!(
                !apart(drawn, cast, 1),
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

#[test]
fn hidden_objects_are_absent() {
    let gpu = gpu();
    let mut scene = shapes(DVec3::ZERO);
    let mut kept = Kept::new(&gpu, &scene, overview([320, 200]));
    let all = kept.ids(&scene);
    // A mesh, a sphere, a cube, a square, and the first part of a batch of two.
    for hidden in [1, 2, 7, 9, 10] {
        let id = u32::try_from(hidden + 1).expect("small");
        assert!(
            all.pixels().iter().any(|pixel| pixel.object == id),
            "object {id} is seen"
        );
        scene.set_visible(hidden, false);
    }
    let left = kept.ids(&scene);
    assert!(
        differing(
            &left,
            &pick::raycast(&scene, &kept.view, Background::DARK).0
        ) < 20,
        "hidden for both"
    );
    for hidden in [2, 3, 8, 10, 11] {
        assert!(
            left.pixels().iter().all(|pixel| pixel.object != hidden),
            "object {hidden} is gone"
        );
    }
    for hidden in [1, 2, 7, 9, 10] {
        scene.set_visible(hidden, true);
    }
    assert_eq!(differing(&kept.ids(&scene), &all), 0, "shown again");
}

#[test]
fn culling_hides_what_faces_away() {
    let gpu = gpu();
    let scene = shapes(DVec3::ZERO);
    let behind = view(
        [-3.0, -2.6, -6.0],
        [0.0, 0.0, 0.0],
        perspective(40.0, 0.1, 100.0),
        [320, 200],
    );
    let cut = view(
        [3.2, 2.6, 6.0],
        [0.0, -0.1, 0.0],
        perspective(40.0, 6.9, 8.0),
        [320, 200],
    );
    for view in [behind, cut] {
        let both = draw(&gpu, &scene, &view, &[], &Marks::default(), 1).0;
        let view = View {
            sides: Sides::Front,
            ..view
        };
        let (front, colours, _) = draw(&gpu, &scene, &view, &[], &Marks::default(), 1);
        let (picked, cast) = pick::raycast(&scene, &view, Background::DARK);
        assert_ne!(front, both, "something faces away");
        let same = |(x, y): &(u32, u32)| front.at(*x, *y) == picked.at(*x, *y);
        let agree: Vec<_> = front.positions().filter(same).collect();
        assert!(agree.len() > 320 * 200 - 40, "{} pixels agree", agree.len());
        for (x, y) in agree {
            let (drawn, cast) = (colours.at(x, y), cast.at(x, y));
            assert!(
                !apart(drawn, cast, 1),
                "({x}, {y}): drawn {drawn:?}, cast {cast:?}, {:?}",
                front.at(x, y)
            );
        }
    }
}

#[test]
fn several_samples_smooth_every_outline() {
    let gpu = gpu();
    let scene = shapes(DVec3::ZERO);
    let view = overview([640, 400]);
    let (ids, hard, _) = draw(&gpu, &scene, &view, &[], &Marks::default(), 1);
    let (smooth_ids, smooth, _) = draw(&gpu, &scene, &view, &[], &Marks::default(), 4);
    show("smooth", &smooth);
    assert_eq!(differing(&ids, &smooth_ids), 0, "ids have one sample");
    // Mesh, sphere, cube, square: more than a fifth of each one's border pixels are blended.
    for object in [2, 3, 8, 10] {
        let own = || {
            ids.positions().filter(|&(x, y)| {
                ids.at(x, y).object == object && x > 0 && y > 0 && x < 639 && y < 399
            })
        };
        let at_rim = |x: u32, y: u32| {
            [(x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)]
                .iter()
                .any(|&(x, y)| ids.at(x, y).object != object)
        };
        let mixed = |&(x, y): &(u32, u32)| apart(hard.at(x, y), smooth.at(x, y), 4);
        let rim: Vec<_> = own().filter(|&(x, y)| at_rim(x, y)).collect();
        let share = rim.iter().filter(|px| mixed(px)).count() * 100 / rim.len();
        assert!(
            share > 20,
            "object {object}: {share} % of its rim is smooth"
        );
    }
}

#[test]
fn pictures_of_any_shape_are_drawn_or_refused_in_a_line() {
    let gpu = gpu();
    let scene = shapes(DVec3::ZERO);
    for size in [[1, 1], [4097, 3], [3, 1025]] {
        let view = overview(size);
        let ids = sightline::render::render(&gpu, &scene, &view, Some(1), Background::DARK)
            .expect("fits")
            .0;
        assert!(
            differing(&ids, &pick::raycast(&scene, &view, Background::DARK).0) < 20,
            "{size:?}"
        );
    }
    let limit = gpu.device.limits().max_texture_dimension_2d;
    let view = overview([97, 61]);
    let (_, colours) =
        sightline::render::render(&gpu, &scene, &view, None, Background::DARK).expect("fits");
    let alone = sightline::render::picture(&gpu, &scene, &view, Background::DARK).expect("fits");
    assert!(
        alone.pixels() == colours.pixels(),
        "the same without ids to the last bit"
    );
    let view = overview([limit + 1, 3]);
    let error = sightline::render::render(&gpu, &scene, &view, None, Background::DARK)
        .expect_err("too large");
    assert!(matches!(error, GpuError::PictureTooLarge { .. }), "{error}");
    assert!(
        !error.to_string().contains('\n') && error.to_string().contains(&format!("{limit}")),
        "{error}"
    );
}

#[test]
fn an_empty_scene_is_all_background() {
    let gpu = gpu();
    let view = overview([64, 48]);
    let (ids, colours) =
        sightline::render::render(&gpu, &Scene::default(), &view, None, Background::DARK)
            .expect("draws");
    let (cast_ids, cast) = pick::raycast(&Scene::default(), &view, Background::DARK);
    assert_eq!(differing(&ids, &cast_ids), 0);
    let pairs = colours.pixels().iter().zip(cast.pixels());
    assert!(pairs.into_iter().all(|(&a, &b)| !apart(a, b, 1)));
}
