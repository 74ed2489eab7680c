//! Lesser adapters draw the same pictures: without a primitive index, within the smallest limits. They are simulated by
//! not using what this adapter has.

use super::*;
use sightline::{
    geometry::{Mesh, Placement},
    render::{Numbers, Rasteriser, Restraint, SMOOTH_SAMPLES, Wireframe},
    scene::{Object, Shape},
};
use std::sync::Arc;

fn lesser(restraint: &Restraint) -> Gpu {
    Gpu::headless_within(restraint).unwrap_or_else(|error| panic!("{error}"))
}

fn by_corners() -> Gpu {
    let gpu = lesser(&Restraint {
        by_corners: true,
        ..Restraint::default()
    });
    assert_eq!(gpu.numbers, Numbers::Corners);
    gpu
}

/// A view with a section, one without, and one that culls.
fn views() -> [View; 3] {
    let whole = overview([320, 200]);
    let section = sightline::geometry::Section::new(DVec3::new(0.3, -0.2, -1.0), 0.1);
    [
        whole,
        View {
            section: Some(section.expect("a plane")),
            ..whole
        },
        View {
            sides: Sides::Front,
            ..whole
        },
    ]
}

/// Every picture of a view: ids, colours without and with edges of triangles, and marks, each at one sample and smooth.
fn all_of(gpu: &Gpu, scene: &Scene, view: &View) -> (Vec<Image<Id>>, Vec<Image<Rgb>>) {
    let mut ids = Vec::new();
    let mut colours = Vec::new();
    for samples in [1, SMOOTH_SAMPLES] {
        let mut renderer = Renderer::new(gpu, samples);
        let buffers = SceneBuffers::upload(gpu, scene).expect("fits");
        let targets = Targets::new(gpu, view.viewport, samples).expect("fits");
        for edges in [None, Some(Wireframe::OfAll), Some(Wireframe::Of(1))] {
            renderer.wireframe = edges;
            let drawn = renderer.draw((&buffers, &targets, view), &[]);
            drawn.expect("drawn");
            colours.push(targets.read_colours(gpu).expect("colours"));
        }
        renderer.draw_outline((&buffers, &targets, view), &[1]);
        let marks = Marks {
            selection: vec![1],
            hover: Some(2),
        };
        let picture = renderer.read_marked((&buffers, &targets, view), &marks);
        colours.push(picture.expect("a picture"));
        ids.push(targets.read_ids(gpu).expect("ids"));
    }
    (ids, colours)
}

/// Asserts that both lists hold the same pictures, to the bit.
#[track_caller]
fn assert_same<T: Copy + PartialEq>(some: &[Image<T>], others: &[Image<T>]) {
    assert_eq!(some.len(), others.len());
    let mut pairs = some.iter().zip(others);
    assert!(pairs.all(|(a, b)| a.pixels() == b.pixels()));
}

#[test]
fn without_a_primitive_index_all_is_the_same() {
    let scene = shapes(DVec3::ZERO);
    let gpus = [gpu(), by_corners()];
    for view in views() {
        let [(ids, colours), (by_corner, coloured)] =
            gpus.each_ref().map(|gpu| all_of(gpu, &scene, &view));
        let triangles = ids[0].pixels().iter().filter(|id| id.triangle > 100);
        assert!(triangles.count() > 1000, "many triangles are named");
        assert_same(&ids, &by_corner);
        assert_same(&colours, &coloured);
    }
}

/// A device whose rasteriser nobody measured draws the same colours.
#[test]
fn colours_alone_need_no_measured_rasteriser() {
    let unmeasured = Gpu::headless_for_colours().unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(unmeasured.rasteriser(), Rasteriser::COMMON);
    let scene = shapes(DVec3::ZERO);
    for view in views() {
        let (_, colours) = sightline::render::render(&gpu(), &scene, &view, None, Background::DARK)
            .expect("drawn");
        let alone = sightline::render::picture(&unmeasured, &scene, &view, Background::DARK)
            .expect("drawn");
        assert!(
            alone.pixels() == colours.pixels(),
            "the same to the last bit"
        );
    }
}

/// The limits that WebGPU guarantees.
fn smallest() -> wgpu::Limits {
    wgpu::Limits::default()
}

#[test]
fn the_smallest_limits_draw_the_same_and_refuse_in_a_line() {
    for samples in [1, SMOOTH_SAMPLES] {
        let small = lesser(&Restraint {
            limits: Some(smallest()),
            ..Restraint::default()
        });
        let scene = shapes(DVec3::ZERO);
        for view in views() {
            let whole = draw(&gpu(), &scene, &view, &[], &Marks::default(), samples);
            let drawn = draw(&small, &scene, &view, &[], &Marks::default(), samples);
            assert_eq!(differing(&whole.0, &drawn.0), 0);
            assert_eq!(differing(&whole.1, &drawn.1), 0);
        }
        let view = overview([8193, 3]);
        let error = sightline::render::render(&small, &scene, &view, None, Background::DARK)
            .expect_err("too large");
        assert!(matches!(error, GpuError::PictureTooLarge { .. }), "{error}");
        let line = error.to_string();
        assert_eq!(line.lines().count(), 1, "{line}");
        assert!(line.ends_with("at most 8192 pixels each way"), "{line}");
    }
}

/// Two instances of a mesh in two parts, with buffers so small that the mesh needs many.
#[test]
fn meshes_larger_than_a_buffer_are_split() {
    let (positions, triangles) = common::icosphere(4);
    let positions: Vec<_> = positions.iter().map(|p| p.as_vec3().to_array()).collect();
    let half = triangles.len() / 2 + 7;
    let mesh: Arc<Mesh> = two_parts(positions, triangles, half);
    let objects = [-1.2, 1.2].into_iter().flat_map(|x| {
        let placement = Placement::new(glam::DAffine3::from_translation(DVec3::new(x, 0.0, 0.0)));
        let placement = placement.expect("a matrix");
        [0, 1].map(|part| {
            let mesh = Arc::clone(&mesh);
            Object::new("half", Shape::Mesh { mesh, part }, placement)
        })
    });
    let scene = Scene::new(objects.collect());
    let limits = wgpu::Limits {
        max_buffer_size: 100_000,
        max_storage_buffer_binding_size: 100_000,
        ..smallest()
    };
    for by_corners in [false, true] {
        let small = lesser(&Restraint {
            by_corners,
            limits: Some(limits.clone()),
        });
        for view in views() {
            let (ids, colours) = all_of(&gpu(), &scene, &view);
            let (split, coloured) = all_of(&small, &scene, &view);
            let last = ids[0].pixels().iter().map(|id| id.triangle).max();
            assert!(last > Some(2000), "{last:?}: beyond the first buffers");
            assert_same(&ids, &split);
            assert_same(&colours, &coloured);
        }
    }
}

fn two_parts(positions: Vec<[f32; 3]>, triangles: Vec<[u32; 3]>, first: usize) -> Arc<Mesh> {
    use sightline::geometry::{ColourRun, MeshData, Part};
    let [first, all] = [first, triangles.len()].map(|n| u32::try_from(n).expect("few"));
    let part = |name: &str, triangles| Part {
        name: name.to_owned(),
        triangles,
    };
    let data = MeshData {
        positions,
        triangles,
        parts: vec![part("first", 0..first), part("second", first..all)],
        colours: vec![ColourRun {
            triangles: 0..all,
            colour: None,
            material: None,
        }],
        ..MeshData::default()
    };
    Arc::new(Mesh::new(data).expect("a mesh"))
}
