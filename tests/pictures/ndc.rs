//! A camera's NDC, drawn from the same buffers as the world, is what the camera sees: cut at its near plane and by the
//! section, seen by an observer beside it.

use crate::{
    common::{orthographic, perspective, view},
    images::apart,
    overview,
    rays::views,
    scenes::{gpu, shapes},
    show,
};
use glam::{DVec3, dvec3};
use sightline::{
    camera::{Camera, DepthMapping, Lens, NdcSpace, Projection, View, Viewport},
    geometry::Sides,
    image::{Id, Image, Pixel, Rgb},
    look::Background,
    pick,
    render::{Gpu, Marks, MeshStore, Renderer, SceneBuffers, Targets},
    scene::Scene,
};
use std::time::{Duration, Instant};

/// A camera's view and its name: those of ordinary pictures, one whose near plane cuts objects, and one from within.
fn cameras() -> Vec<(&'static str, View)> {
    let near = Lens {
        near: 5.6,
        ..*overview([1, 1]).camera.lens()
    };
    let size = Viewport::new(400, 400).expect("a size");
    let (name, plain) = views()[0];
    assert_eq!(name, "reversed");
    let near = View {
        camera: plain.camera.with_lens(near).expect("a camera"),
        ..plain
    };
    let within = view(
        [-0.4, 0.4, 1.6],
        [0.3, -0.4, -2.0],
        perspective(80.0, 0.05, 30.0),
        [400, 400],
    );
    let parallel_within = view(
        [-0.4, 0.4, 1.6],
        [0.3, -0.4, -2.0],
        orthographic(4.0, -1.5, 30.0),
        [400, 400],
    );
    let others = [
        ("near", near),
        ("within", within),
        ("parallel within", parallel_within),
    ];
    let all = views().into_iter().chain(others);
    all.map(|(name, view)| {
        let viewport = size;
        (name, View { viewport, ..view })
    })
    .collect()
}

/// An observer of NDC.
fn observer(eye: DVec3, target: DVec3, lens: Lens, sides: Sides) -> View {
    let camera = Camera::new(eye, target, DVec3::Y, lens).expect("a camera");
    View {
        sides,
        ..View::new(camera, Viewport::new(400, 400).expect("a size"))
    }
}

fn draw(gpu: &Gpu, scene: &Scene, ndc: NdcSpace, observer: &View) -> (Image<Id>, Image<Rgb>) {
    let meshes = &mut MeshStore::default();
    let buffers = SceneBuffers::upload_beside(gpu, scene, meshes, Some(ndc)).expect("fits");
    let targets = Targets::new(gpu, observer.viewport, 1).expect("fits");
    let drawn = Renderer::new(gpu, 1).draw((&buffers, &targets, observer), &[]);
    drawn.expect("draws");
    let colours = targets.read_colours(gpu).expect("colours");
    (targets.read_ids(gpu).expect("ids"), colours)
}

fn cast(scene: &Scene, ndc: NdcSpace, observer: &View) -> Image<Pixel> {
    let deadline = Instant::now() + Duration::from_mins(10);
    pick::raycast_ndc_until(scene, &ndc, observer, Background::DARK, deadline).expect("in time")
}

/// How many pixels of two pictures show different triangles or objects. Near outlines they may: spheres are meshes in
/// NDC.
fn differing(a: &Image<Id>, b: &Image<Id>) -> usize {
    let pairs = a.pixels().iter().zip(b.pixels());
    pairs.filter(|(a, b)| a != b).count()
}

/// The observer's rays are parallel, along NDC's z, and the box fills the picture.
#[test]
fn from_straight_in_front_ndc_shows_what_the_camera_sees() {
    let (gpu, scene) = (gpu(), shapes(DVec3::ZERO));
    scene.build_trees();
    for (name, camera) in cameras() {
        let lens = Lens {
            projection: Projection::Orthographic { height: 2.0 },
            near: 1.0,
            far: 4.0,
            depth: DepthMapping::Reversed,
        };
        let observer = observer(DVec3::Z * 3.0, DVec3::ZERO, lens, camera.sides);
        let ndc = NdcSpace { of: camera };
        let seen = pick::ids(&scene, &camera);
        let objects = seen.pixels().iter().filter(|id| id.object > 0).count();
        assert!(objects > 20_000, "{name}: {objects}");
        let (drawn, colours) = draw(&gpu, &scene, ndc, &observer);
        show(&format!("ndc-front-{name}"), &colours);
        let differ = differing(&drawn, &seen);
        assert!(differ < 500, "{name}: {differ} pixels of the drawing");
        let cast = cast(&scene, ndc, &observer);
        let cast = Image::new(cast.size(), cast.pixels().iter().map(|at| at.id).collect());
        let differ = differing(&cast, &seen);
        assert!(differ < 100, "{name}: {differ} rays");
    }
}

/// Wherever an object is in NDC, what is selected or lit shows it.
#[test]
fn what_is_selected_or_lit_in_ndc_is_marked() {
    let (gpu, scene) = (gpu(), shapes(DVec3::ZERO));
    let lens = perspective(34.0, 0.05, 2000.0);
    let (_, camera) = cameras()[0];
    let observer = observer(dvec3(2.4, 1.8, 4.0), -0.4 * DVec3::Z, lens, camera.sides);
    let ndc = NdcSpace { of: camera };
    let meshes = &mut MeshStore::default();
    let buffers = SceneBuffers::upload_beside(&gpu, &scene, meshes, Some(ndc)).expect("fits");
    let targets = Targets::new(&gpu, observer.viewport, 1).expect("fits");
    let onto = (&buffers, &targets, &observer);
    let mut renderer = Renderer::new(&gpu, 1);
    renderer.draw(onto, &[]).expect("draws");
    let bare = targets.read_colours(&gpu).expect("colours");
    let ids = targets.read_ids(&gpu).expect("ids");
    for object in 0..scene.objects().len() {
        let selected = Marks {
            selection: vec![object],
            hover: None,
        };
        let lit = Marks {
            selection: Vec::new(),
            hover: Some(object),
        };
        for marks in [selected, lit] {
            renderer.draw_outline(onto, &marks.selection);
            let marked = renderer.read_marked(onto, &marks).expect("a picture");
            let of_it =
                (ids.positions()).filter(|&(x, y)| ids.at(x, y).object as usize == object + 1);
            let plain = of_it.filter(|&(x, y)| marked.at(x, y) == bare.at(x, y));
            assert_eq!(plain.count(), 0, "{object}: {marks:?}");
        }
    }
}

/// From beside, rays and drawing agree: objects, triangles and colours. Both show what lies beside the frustum and
/// beyond far, and nothing in front of near or behind the eye.
#[test]
fn from_beside_ndc_looks_alike_by_rays_and_as_drawn() {
    let (gpu, scene) = (gpu(), shapes(DVec3::ZERO));
    scene.build_trees();
    for (name, camera) in cameras() {
        let lens = perspective(34.0, 0.05, 2000.0);
        let observer = observer(dvec3(2.4, 1.8, 4.0), -0.4 * DVec3::Z, lens, camera.sides);
        let ndc = NdcSpace { of: camera };
        let (drawn, colours) = draw(&gpu, &scene, ndc, &observer);
        show(&format!("ndc-{name}"), &colours);
        let cast = cast(&scene, ndc, &observer);
        let mut differ = [0; 2];
        for (x, y) in drawn.positions() {
            let pixel = cast.at(x, y);
            let is_same = drawn.at(x, y) == pixel.id;
            differ[0] += u32::from(!is_same);
            differ[1] += u32::from(is_same && apart(colours.at(x, y), pixel.colour, 8));
        }
        let objects = drawn.pixels().iter().filter(|id| id.object > 0).count();
        assert!(objects > 10_000, "{name}: {objects}");
        assert!(differ[0] < 700 && differ[1] < 100, "{name}: {differ:?}");
    }
}
