//! Verify measures the properties of any driver and leaves nothing unexplained on it. `.ci/run` runs these tests on two
//! drivers that share no code.

use crate::{
    compare, drawn_once,
    models::slivers,
    scenes::{gpu, shapes},
};
use glam::DVec3;
use sightline::{
    camera::{CameraChoice, DepthMapping, Lens, View, Viewport},
    geometry::Sides,
    pick,
    render::{Numbers, Rasteriser},
    scene::{self, Progress, Scene, gallery::GALLERY},
    verify::{self, Class},
};

/// Known drivers: a part of the adapter's name, its sub-pixel bits, and how it numbers triangles.
const KNOWN: [(&str, u32, Numbers); 2] = [
    ("llvmpipe", 8, Numbers::Primitives),
    ("SwiftShader", 4, Numbers::Corners),
];

#[test]
fn what_known_drivers_do_is_measured() {
    let gpu = gpu();
    let name = gpu.adapter_name();
    let bits = gpu.rasteriser().sub_pixel_bits();
    assert!((4..=8).contains(&bits), "{name}: {bits} sub-pixel bits");
    let known = KNOWN.iter().find(|(words, ..)| name.contains(words));
    if let Some((words, known_bits, numbers)) = known {
        assert_eq!((bits, gpu.numbers), (*known_bits, *numbers), "{words}");
    } else {
        println!("{name}: {bits} sub-pixel bits, {:?}", gpu.numbers);
    }
}

/// The framed view, with reversed and with standard depth.
fn views(scene: &Scene) -> [View; 2] {
    let viewport = Viewport::new(320, 240).expect("a size");
    let camera = CameraChoice::default().resolve(&scene.visible_bounds(), viewport);
    let camera = camera.expect("a camera");
    let lens = Lens {
        depth: DepthMapping::Standard,
        ..*camera.lens()
    };
    [camera, camera.with_lens(lens).expect("a lens")].map(|camera| View {
        camera,
        viewport,
        sides: Sides::Both,
        section: None,
    })
}

#[test]
fn nothing_is_unexplained_in_the_demo_the_gallery_and_two_scenes() {
    let open = |paths: &[_]| {
        scene::load(paths, &Progress::default())
            .expect("a scene")
            .scene
    };
    let mut scenes = vec![
        ("demo".to_owned(), open(&[])),
        ("shapes".to_owned(), shapes(DVec3::ZERO)),
        ("slivers".to_owned(), slivers()),
    ];
    scenes.extend((GALLERY.iter()).map(|exhibit| (exhibit.title(), open(&[exhibit.path()]))));
    let mut shown = 0;
    for (name, scene) in &scenes {
        scene.build_trees();
        for view in views(scene) {
            let report = compare(
                scene,
                &view,
                &drawn_once(scene, &view),
                &pick::ids(scene, &view),
            );
            let unexplained = report.count(Class::Unexplained);
            assert_eq!(unexplained, 0, "{name}: {:?}, {view:?}", report.worst());
            shown += report.drawn.min(report.picked);
        }
    }
    assert!(shown > 200_000, "{shown}: the scenes are seen");
}

/// Bounds need the driver's own grid: with the common, finer grid, verify calls pixels of a coarser driver unexplained.
#[test]
fn a_coarser_grid_is_what_its_edges_need() {
    let own = gpu().rasteriser();
    let scene = shapes(DVec3::ZERO);
    scene.build_trees();
    let (mut by_common, mut by_own) = (0, 0);
    for view in views(&scene) {
        let (drawn, picked) = (drawn_once(&scene, &view), pick::ids(&scene, &view));
        let count = |rasteriser| {
            let report = verify::compare(&scene, &view, rasteriser, &drawn, &picked);
            report.count(Class::Unexplained)
        };
        by_common += count(Rasteriser::COMMON);
        by_own += count(own);
    }
    assert_eq!(by_own, 0);
    assert_eq!(by_common > 0, own.sub_pixel_bits() < 8, "{by_common}");
}
