//! A pick is worked out by the very methods that are charted, and its numbers are those of the pick, up to rounding.

use super::gallery::view_of;
use glam::{DVec3, dvec2};
use sightline::{
    camera::{Camera, Lens, Projection, View},
    geometry::Placement,
    pick::{Pick, pick_all},
    scene::{self, Loaded, Progress, Scene, Shape},
    study::{
        methods::{
            ObjectRay, boxes,
            object_space::{self, Placed},
            rays::{self, PixelCase},
            spheres, squares,
            squares::RaySquare,
            triangles::{self, TriangleCase},
        },
        swap::Found,
        worked::{WorkedPick, WorkedShape, through_all},
    },
};

fn open(path: &str) -> Loaded {
    let paths = match path {
        "" => vec![],
        path => vec![path.into()],
    };
    scene::load(&paths, &Progress::default()).expect("a scene")
}

/// Every surface under a lattice of positions, with its working.
fn each(scene: &Scene, view: &View, check: &mut impl FnMut(&Pick, &WorkedPick, [f64; 2])) {
    let [width, height] = view.viewport.size_px().to_array();
    for row in 0..60 {
        for column in 0..60 {
            let px = [
                (f64::from(column) + 0.5) * width / 60.0,
                (f64::from(row) + 0.5) * height / 60.0,
            ];
            for pick in pick_all(scene, view, px.into()) {
                let worked = WorkedPick::of(scene, view, px.into(), &pick);
                check(&pick, &worked.expect("a working"), px);
            }
        }
    }
}

fn parallel(view: &View) -> View {
    let camera = &view.camera;
    let lens = Lens {
        projection: Projection::Orthographic { height: 12.0 },
        ..*camera.lens()
    };
    let camera = Camera::new(camera.eye(), camera.target(), camera.up(), lens).expect("a camera");
    View { camera, ..*view }
}

#[test]
fn the_demos_picks_are_worked_out_as_they_are_picked() {
    let loaded = open("");
    let view = view_of(&loaded, 800, 600);
    for view in [view, parallel(&view)] {
        let mut seen = [[0; 2]; 4];
        each(&loaded.scene, &view, &mut |pick, worked, _| {
            let shape = match worked.shape {
                WorkedShape::Sphere(_) => 0,
                WorkedShape::Cube(_) => 1,
                WorkedShape::Square(_) => 2,
                WorkedShape::Triangle(areas) => {
                    let weights = pick.barycentric.expect("weights");
                    for (share, weight) in areas.shares.into_iter().zip(weights) {
                        assert!((share - weight).abs() < 1e-9, "{share} is not {weight}");
                    }
                    assert!((areas.sum - 1.0).abs() < 1e-9);
                    3
                }
            };
            seen[shape][usize::from(pick.front)] += 1;
            let hit = worked.hit.expect("the course finds it too");
            let near = |ours: DVec3, theirs: DVec3, what: &str| {
                let size = ours.length().max(1.0);
                assert!(
                    ours.distance(theirs) < 1e-8 * size,
                    "{what} of {}: {ours} is not {theirs}",
                    pick.object
                );
            };
            near(pick.point_world, hit.point_world, "point");
            near(pick.point_object, hit.point_object, "point in object space");
            near(pick.normal_world, hit.normal_world, "normal");
            near(
                pick.normal_object,
                hit.normal_object,
                "normal in object space",
            );
            let from_start = pick.point_world.distance(worked.origin_world);
            assert!((hit.t_world - from_start).abs() < 1e-8 * from_start);
        });
        for (shape, [back, front]) in seen.into_iter().enumerate() {
            // The ground is seen from above.
            let is_square = shape == 2;
            assert!(front > 20 && (is_square || back > 20), "{seen:?}");
        }
    }
}

#[test]
fn the_numbers_are_those_of_the_methods_that_are_charted() {
    let loaded = open("");
    let view = view_of(&loaded, 800, 600);
    let mut seen = [0; 4];
    each(&loaded.scene, &view, &mut |pick, worked, px| {
        let pixel = PixelCase::of_view(&view, px.into()).wide;
        let ray = rays::course(&pixel);
        assert_eq!(DVec3::from(ray.from), worked.origin_world);
        assert_eq!(worked.plane.point - ray.from, ray.along);
        let object = &loaded.scene.objects()[pick.id - 1];
        let mut world = *view.ray(px.into());
        (world.origin, world.direction) = (worked.origin_world, worked.direction_world);
        let placed = Placed::<f64>::from((&object.placement, &world));
        let local = object_space::by_inverse(&placed, true).map(DVec3::from);
        assert_eq!(local, [worked.origin_object, worked.direction_object]);
        let case: ObjectRay<f64> = ObjectRay {
            origin: worked.origin_object.into(),
            direction: worked.direction_object.into(),
        };
        (world.origin, world.direction) = (worked.origin_object, worked.direction_object);
        let (shape, charted) = match (&object.shape, worked.shape) {
            (Shape::Sphere, _) => (0, spheres::plain(&case)),
            (Shape::Cube, WorkedShape::Cube(slabs)) => {
                let [enter, leave] = through_all(&slabs);
                assert!(enter <= leave);
                (1, boxes::branch(&case))
            }
            (Shape::Square, _) => {
                let case = RaySquare::<f64>::from((&Placement::IDENTITY, &world));
                (2, squares::point(&case))
            }
            (Shape::Mesh { mesh, .. }, WorkedShape::Triangle(areas)) => {
                let start = object.shape.triangles().expect("a mesh").start;
                let triangle = start + pick.triangle.expect("a triangle");
                let case = TriangleCase::of_mesh(mesh, triangle, &world, 1.0).wide;
                let hit = triangles::areas(&case);
                assert_eq!(hit.is_some(), areas.sum == 1.0, "its test for equality");
                (3, hit.or(Some(areas.t)))
            }
            (_, other) => panic!("{other:?}"),
        };
        if pick.front || shape == 2 {
            assert_eq!(
                charted,
                worked.hit.map(|hit| hit.t_object),
                "{}",
                pick.object
            );
            seen[shape] += 1;
        }
    });
    assert!(seen.iter().all(|seen| *seen > 30), "{seen:?}");
}

#[test]
fn where_a_course_fails_its_working_says_so() {
    // Three areas that should add up to a fourth.
    let loaded = open("gallery:needles");
    let view = view_of(&loaded, 801, 600);
    let (mut all, mut unequal) = (0, 0);
    each(&loaded.scene, &view, &mut |_, worked, _| {
        let WorkedShape::Triangle(areas) = worked.shape else {
            panic!("{worked:?}");
        };
        all += 1;
        unequal += i32::from(areas.sum != 1.0);
        assert!(worked.hit.is_some(), "the plane's t is there all the same");
    });
    assert!(all > 50 && unequal > all / 6, "{unequal} of {all}");
    // The quadratic cancels in f64 too, a hundred million radii away: it loses a ball that is there.
    let ball = loaded_ball();
    let view = view_of(&ball, 400, 400);
    let mut lost = 0;
    each(&ball.scene, &view, &mut |_, worked, px| {
        lost += i32::from(worked.hit.is_none());
        let found = Found::sightlines(&ball.scene, &view, dvec2(px[0], px[1]));
        assert!(found.is_some());
    });
    assert!(lost > 0, "{lost} lost");
}

/// A ball of radius 1/2, far away through a long lens.
fn loaded_ball() -> Loaded {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("ball.toml");
    let text = "[camera]\neye = [6.1e7, 5.3e7, 5.9e7]\ntarget = [0, 0, 0]\nfov = 7e-7\n\n[[object]]\nshape = \"sphere\"\n";
    std::fs::write(&path, text).expect("a file");
    open(path.to_str().expect("a plain path"))
}
