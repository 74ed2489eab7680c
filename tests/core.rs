//! What the picking core promises to who builds on it, with or without the other features.

use sightline::{
    camera::{Camera, CameraError, DepthMapping, Lens, Projection, View, Viewport},
    geometry::{
        Bvh, Mesh, MeshData, MeshError, Placement, PlacementError, Ray, Section, SectionError,
        Sides,
    },
    glam::{DVec2, DVec3},
    image::{Id, Image},
    pick::{self, Pick, SceneHit},
    scene::{NoSection, NoSuchObject, Object, Scene, SceneKey, Shape},
};
use std::{error::Error, fmt::Debug, sync::Arc};

/// What threads share.
const fn is_shared<T: Debug + Send + Sync + 'static>() {}

/// And what `?` hands up, from whichever thread.
const fn is_error<T: Error + Clone + Send + Sync + 'static>() {}

const _: () = {
    is_shared::<Scene>();
    is_shared::<SceneKey>();
    is_shared::<Object>();
    is_shared::<Shape>();
    is_shared::<Mesh>();
    is_shared::<MeshData>();
    is_shared::<Bvh>();
    is_shared::<Placement>();
    is_shared::<Section>();
    is_shared::<Ray>();
    is_shared::<Camera>();
    is_shared::<View>();
    is_shared::<Pick>();
    is_shared::<SceneHit>();
    is_shared::<Image<Id>>();
    is_error::<CameraError>();
    is_error::<MeshError>();
    is_error::<PlacementError>();
    is_error::<SectionError>();
    is_error::<NoSection>();
    is_error::<NoSuchObject>();
};

fn roof() -> Arc<Mesh> {
    let corners = vec![
        [-1.0, -1.0, 0.0],
        [1.0, -1.0, 0.0],
        [1.0, 1.0, 0.0],
        [-1.0, 1.0, 0.0],
    ];
    let data = MeshData::of_triangles("roof", corners, vec![[0, 1, 2], [0, 2, 3]]);
    Arc::new(Mesh::new(data).expect("a mesh"))
}

fn view() -> View {
    let lens = Lens {
        projection: Projection::Perspective { fov_y: 1.0 },
        near: 0.1,
        far: 100.0,
        depth: DepthMapping::Reversed,
    };
    let camera = Camera::new(DVec3::new(0.0, 0.0, 3.0), DVec3::ZERO, DVec3::Y, lens);
    View::new(
        camera.expect("a camera"),
        Viewport::new(64, 48).expect("a viewport"),
    )
}

/// Picks, from several threads at a time, are those of one after the other.
#[test]
fn threads_pick_in_one_scene() {
    let mesh = roof();
    let shape = Shape::Mesh { mesh, part: 0 };
    let scene = Scene::new(vec![Object::new("roof", shape, Placement::IDENTITY)]);
    let view = view();
    let ids = pick::ids(&scene, &view);
    let rows = std::thread::scope(|threads| {
        let row = |y: u32| {
            let (scene, view) = (&scene, &view);
            threads.spawn(move || {
                let px = |x: u32| DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
                let picks = (0..64).map(|x| pick::pick(scene, view, px(x)));
                picks.collect::<Vec<_>>()
            })
        };
        let rows: Vec<_> = (0..48).map(row).collect();
        let rows = rows.into_iter().map(|row| row.join().expect("no panic"));
        rows.collect::<Vec<_>>()
    });
    let mut hits = [0; 2];
    for ((x, y), id) in ids.positions().zip(ids.pixels()) {
        let picked = &rows[y as usize][x as usize];
        let triangle = picked.as_ref().and_then(|picked| picked.triangle);
        assert_eq!(id.triangle, triangle.map_or(0, |triangle| triangle + 1));
        assert_eq!(id.object, u32::from(picked.is_some()));
        if let Some(triangle) = triangle {
            hits[triangle as usize] += 1;
        }
    }
    // From its middle to its edge the roof has 24 / (3 tan 0.5) = 14.6 pixels: 15 centres.
    assert_eq!(hits.iter().sum::<u32>(), 30 * 30, "{hits:?}");
}

/// A part that is not there is nowhere, and nobody meets it.
#[test]
fn a_part_that_is_not_there_is_no_panic() {
    let mesh = roof();
    for part in [1, usize::MAX] {
        let shape = Shape::Mesh {
            mesh: Arc::clone(&mesh),
            part,
        };
        let scene = Scene::new(vec![
            Object::new("none", shape.clone(), Placement::IDENTITY),
            Object::new("none", shape, Placement::IDENTITY),
        ]);
        assert!(scene.bounds().is_empty());
        assert_eq!(scene.triangle_count(), 0);
        let centre = DVec2::new(32.0, 24.0);
        assert!(pick::pick(&scene, &view(), centre).is_none());
        let ray = view().ray(centre);
        assert!(pick::closest(&scene, ray, Sides::Both).is_none());
    }
}

/// What is no mesh is refused.
#[test]
fn triangles_of_ones_own_are_checked() {
    let of = |position, corner| {
        let data = MeshData::of_triangles("one", vec![position; 3], vec![[0, 1, corner]]);
        Mesh::new(data).err()
    };
    assert_eq!(of([0.0; 3], 2), None);
    assert_eq!(of([0.0; 3], 3), Some(MeshError::NoSuchVertex(0)));
    assert_eq!(of([f32::NAN; 3], 2), Some(MeshError::NotFinite(0)));
}
