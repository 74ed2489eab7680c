//! The picking core, with or without the other features: threads may share it, invalid meshes are refused, and numbers
//! that are not finite are missed without a panic.

use sightline::{
    camera::{
        Camera, CameraChoice, CameraError, DepthMapping, Lens, Orbit, Projection, SectionWordError,
        View, Viewport,
    },
    geometry::{
        Aabb, Bvh, Mesh, MeshData, MeshError, PixelRays, PlacedPoint, Placement, PlacementError,
        Ray, Section, SectionError, Sides, TriangleTest, VertexRay, WorldRay, hit_exact,
        hit_guarded,
    },
    glam::{DVec2, DVec3},
    image::{Id, Image},
    pick::{self, Pick, SceneHit, snap::Snap},
    scene::{NoSection, NoSuchObject, Object, Scene, SceneKey, Shape},
};
use std::{error::Error, fmt::Debug, sync::Arc};

/// Can be shared between threads.
const fn is_shared<T: Debug + Send + Sync + 'static>() {}

/// Can be returned by `?` from any thread.
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
    is_shared::<WorldRay>();
    is_shared::<PixelRays>();
    is_shared::<Camera>();
    is_shared::<CameraChoice>();
    is_shared::<Orbit>();
    is_shared::<View>();
    is_shared::<Pick>();
    is_shared::<SceneHit>();
    is_shared::<Snap>();
    is_shared::<Image<Id>>();
    is_error::<CameraError>();
    is_error::<MeshError>();
    is_error::<PlacementError>();
    is_error::<SectionError>();
    is_error::<SectionWordError>();
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

/// Picks from several threads at once equal sequential ones.
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

/// A part that its mesh does not have is never hit.
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

/// Functions count objects from 0, ids run from 1; an index that names no object hides nothing.
#[test]
fn ids_are_numbers_for_people_and_functions_take_indices() {
    let ball = Object::new("ball", Shape::Sphere, Placement::IDENTITY);
    let mut scene = Scene::new(vec![ball; 3]);
    let shown = |scene: &Scene| [0, 1, 2].map(|object| scene.objects()[object].visible);
    scene.show(&[2, 0, 2], false);
    assert_eq!(shown(&scene), [false, true, false]);
    assert_eq!(scene.hidden_count(), 2);
    assert_eq!(scene.index_of(3), Ok(2));
    for id in [0, 4, usize::MAX] {
        assert_eq!(scene.index_of(id), Err(NoSuchObject { id, objects: 3 }));
    }
    let refused =
        std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| scene.show(&[1, 3], false)));
    assert!(refused.is_err());
    assert_eq!(shown(&scene), [false, true, false]);
}

/// Values that hold the same are equal, whatever was computed from them; only a scene's own clone has its key.
#[test]
fn what_holds_the_same_is_equal() {
    let object = |mesh| {
        let shape = Shape::Mesh { mesh, part: 0 };
        Object::new("roof", shape, Placement::default())
    };
    let (one, same) = (object(roof()), object(roof()));
    assert_eq!(one, same);
    let scene: Scene = [one.clone()].into_iter().collect();
    scene.build_trees();
    assert_eq!(one, same);
    let other = Object {
        visible: false,
        ..same.clone()
    };
    assert_ne!(one, other);
    assert_eq!(scene.key(), scene.clone().key());
    assert_ne!(scene.key(), Scene::new(vec![same]).key());
}

/// Invalid mesh data is refused.
#[test]
fn triangles_of_ones_own_are_checked() {
    let of = |position, corner| {
        let data = MeshData::of_triangles("one", vec![position; 3], vec![[0, 1, corner]]);
        Mesh::new(data).err()
    };
    assert_eq!(of([0.0; 3], 2), None);
    assert_eq!(of([0.0; 3], 3), Some(MeshError::NoSuchVertex(0)));
    for bad in [f32::NAN, f32::INFINITY, -1.3e33] {
        assert_eq!(of([bad; 3], 2), Some(MeshError::OutOfRange(0)));
    }
    // Small coordinates are stored as 0.
    let data = MeshData::of_triangles("one", vec![[1.2e33, -7e-34, 8e-34]; 3], vec![[0, 1, 2]]);
    let mesh = Mesh::new(data).expect("a mesh");
    let stored = DVec3::new(1.2e33, 0.0, 8e-34).as_vec3().to_array();
    assert_eq!(
        mesh.data().positions[0].map(f32::to_bits),
        stored.map(f32::to_bits)
    );
}

/// A triangle across the z axis, and a ray that meets it: origin, direction, interval.
const TRIANGLE: [[f64; 3]; 3] = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, 0.0]];
const RAY: [f64; 8] = [0.0, 0.0, 3.0, 0.0, 0.0, -1.0, 0.0, 9.0];

fn t_of(test: TriangleTest, ray: [f64; 8], corners: [[f64; 3]; 3]) -> Option<f64> {
    let [x, y, z, dx, dy, dz, t_min, t_max] = ray;
    let ray = VertexRay::exact(Ray {
        origin: DVec3::new(x, y, z),
        direction: DVec3::new(dx, dy, dz),
        t_min,
        t_max,
    });
    test(&ray, corners.map(DVec3::from)).map(|hit| hit.t)
}

/// A number that is not finite makes a ray or triangle a miss, not a panic. Only the interval's ends may be infinite.
#[test]
fn what_is_not_finite_is_missed() {
    for test in [hit_guarded, hit_exact] {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for i in 0..8 {
                let mut ray = RAY;
                ray[i] = bad;
                let is_open = (i == 6 && bad < 0.0) || (i == 7 && bad > 0.0);
                let expected = is_open.then_some(3.0);
                assert_eq!(t_of(test, ray, TRIANGLE), expected, "{bad} as {i}");
            }
            for i in 0..9 {
                let mut corners = TRIANGLE;
                corners.as_flattened_mut()[i] = bad;
                assert_eq!(t_of(test, RAY, corners), None, "{bad} as corner {i}");
            }
        }
        // Nor is a ray hit whose numbers are beyond the range; small ones are stored as 0.
        for (beyond, stored) in [(1.3e33, None), (-1.3e33, None), (1e-34, Some(3.0))] {
            let mut ray = RAY;
            ray[0] = beyond;
            assert_eq!(t_of(test, ray, TRIANGLE), None, "{beyond}");
            let [x, y, z, dx, dy, dz, t_min, t_max] = ray;
            let ray = Ray {
                origin: DVec3::new(x, y, z),
                direction: DVec3::new(dx, dy, dz),
                t_min,
                t_max,
            };
            let ray = ray.stored().map(VertexRay::exact);
            let hit = ray.and_then(|ray| test(&ray, TRIANGLE.map(DVec3::from)));
            assert_eq!(hit.map(|hit| hit.t), stored, "{beyond}");
        }
    }
}

/// A point with a number that is not finite is nowhere.
#[test]
fn a_point_that_is_not_finite_is_not_seen() {
    let shape = Shape::Mesh {
        mesh: roof(),
        part: 0,
    };
    let scene = Scene::new(vec![Object::new("roof", shape, Placement::IDENTITY)]);
    let sight = |vertex| {
        let point = PlacedPoint::vertex(&Placement::IDENTITY, DVec3::ZERO, vertex);
        pick::sight(&scene, &view(), &point)
    };
    assert!(matches!(sight(DVec3::ZERO), pick::Sight::Seen(_)));
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for axis in 0..3 {
            let mut vertex = DVec3::ZERO;
            vertex[axis] = bad;
            assert_eq!(sight(vertex), pick::Sight::NotShown);
        }
    }
}

#[test]
fn every_triangle_test_tells_a_hit_from_a_miss() {
    for test in [hit_guarded, hit_exact] {
        for turn in 0..3 {
            let mut corners = TRIANGLE;
            corners.rotate_left(turn);
            for (x, y, expected) in [
                (0.0, 0.0, Some(3.0)),
                (0.25, -0.5, Some(3.0)),
                (3.0, 0.0, None),
                (-3.0, 0.0, None),
                (0.0, 3.0, None),
                (0.0, -3.0, None),
            ] {
                let mut ray = RAY;
                (ray[0], ray[1]) = (x, y);
                assert_eq!(t_of(test, ray, corners), expected, "{x} {y}");
                // The next ray meets the opposite winding.
                corners.swap(0, 1);
            }
        }
    }
}

#[test]
fn boxes_say_how_large_they_are() {
    let about = |half: DVec3| Aabb::around([DVec3::ONE - half, DVec3::ONE + half]);
    let size = |half: DVec3| (about(half).radius(), about(half).decimal_places());
    assert_eq!(about(DVec3::X).center(), DVec3::ONE);
    // A millionth of the radius, rounded up to a power of ten: 3, 300, 0.03 and 1.
    assert_eq!(size(DVec3::new(1.0, 2.0, 2.0)), (3.0, 6));
    assert_eq!(size(DVec3::new(100.0, 200.0, 200.0)), (300.0, 4));
    assert_eq!(about(DVec3::splat(0.03125)).decimal_places(), 8);
    assert_eq!(size(DVec3::X), (1.0, 6));
    assert_eq!(size(DVec3::ZERO), (0.0, 6));
    assert_eq!(Aabb::default().decimal_places(), 6);
    assert_eq!([DVec3::X, -DVec3::X].into_iter().collect::<Aabb>(), {
        Aabb::around([-DVec3::X, DVec3::X])
    });
}
