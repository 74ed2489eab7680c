//! The study is right in views where the first surface on a ray may be invisible: back faces are culled, the near plane
//! cuts shapes, or parallel rays start behind the eye.

use super::gallery::{rows_on, view_of};
use glam::{DAffine3, DQuat, DVec2, DVec3, dvec3};
use sightline::{
    camera::{CameraChoice, View, Viewport},
    geometry::{Mesh, MeshData, Placement, Sides},
    scene::{self, Object, Progress, Scene, Shape, gallery::GALLERY},
    study::{
        Row, SCENE, SceneRays,
        breaks::BREAKS,
        chains::Chain,
        methods::picks::ball_scene,
        step::{MethodInfo, Precision::F64},
        swap::{AnyStep, Found, Swap},
    },
};
use std::sync::Arc;

const WIDTH: u32 = 161;
const HEIGHT: u32 = 91;

/// A mesh of two squares in planes of constant z, 2 wide: the nearer one faces away from +z, the other one towards it.
fn two_sheets() -> Shape {
    let square = |z: f32| {
        [
            [-1.0, -1.0, z],
            [1.0, -1.0, z],
            [1.0, 1.0, z],
            [-1.0, 1.0, z],
        ]
    };
    let mesh = Mesh::new(MeshData::of_triangles(
        "sheets",
        [square(1.0), square(-1.0)].concat(),
        vec![[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7]],
    ));
    Shape::Mesh {
        mesh: Arc::new(mesh.expect("a mesh")),
        part: 0,
    }
}

/// A row of every shape, each about 1.5 wide with its middle at z = 0: a mesh whose back comes first, a mirrored mesh,
/// an ellipsoid, a turned box, and a square seen from behind. A part that its mesh lacks adds nothing.
fn row_of_shapes() -> Scene {
    let ball = ball_scene(0.0).0.objects()[0].shape.clone();
    let object = |shape: Shape, scale: DVec3, turn_y: f64, x: f64| {
        let model = DAffine3::from_scale_rotation_translation(
            scale,
            DQuat::from_rotation_y(turn_y),
            dvec3(x, 0.0, 0.0),
        );
        let name = shape.kind();
        Object::new(name, shape, Placement::new(model).expect("a placement"))
    };
    let Shape::Mesh { mesh, .. } = two_sheets() else {
        panic!("the sheets are a mesh");
    };
    let lacking = Shape::Mesh { mesh, part: 7 };
    let scene = Scene::new(vec![
        object(two_sheets(), DVec3::splat(0.75), 0.0, -4.0),
        object(ball, dvec3(-0.75, 0.75, 0.75), 0.0, -2.0),
        object(Shape::Sphere, dvec3(1.5, 1.25, 1.75), 0.3, 0.0),
        object(Shape::Cube, DVec3::splat(1.25), 0.5, 2.0),
        object(Shape::Square, DVec3::splat(1.5), 3.0, 4.0),
        object(lacking, DVec3::splat(0.75), 0.5, -4.0),
    ]);
    scene.build_trees();
    scene
}

/// Views of all shapes, with back faces and without: whole, cut by the near plane (less on the left), and by parallel
/// rays that start behind an eye among the shapes.
fn views(scene: &Scene) -> Vec<View> {
    let viewport = Viewport::new(WIDTH, HEIGHT).expect("a picture");
    let view = |near: Option<f64>, ortho: Option<f64>, z: f64, sides: Sides| {
        let choice = CameraChoice {
            eye: Some(dvec3(0.3 * z, 0.5, z)),
            look: Some(dvec3(-0.3, -0.05, -1.0)),
            near,
            fov: ortho.is_none().then_some(30.0),
            ortho,
            ..CameraChoice::default()
        };
        let camera = choice.resolve(&scene.bounds(), viewport);
        View {
            camera: camera.expect("a camera"),
            viewport,
            sides,
            section: None,
        }
    };
    vec![
        view(None, None, 10.0, Sides::Front),
        view(Some(10.0), None, 10.0, Sides::Both),
        view(Some(10.0), None, 10.0, Sides::Front),
        view(None, Some(5.0), 0.0, Sides::Both),
        view(Some(0.1), Some(5.0), 0.0, Sides::Both),
        view(None, Some(5.0), 0.0, Sides::Front),
    ]
}

/// Sightline's methods decide right, and the other ways to pick hit no culled or clipped face.
#[test]
fn what_is_cut_and_culled_is_studied_right() {
    let scene = row_of_shapes();
    for view in views(&scene) {
        let rays = SceneRays::new(&scene, view, 1500, 1);
        let all = rows_on(&rays);
        let ours: Vec<&Row> = all.iter().filter(|row| row.info.ours).collect();
        assert!(
            ours.len() >= 9,
            "the culled square is all that may be missing"
        );
        for row in &ours {
            assert_eq!(row.wrong_percent(), 0.0, "{view:?} {row:?}");
            assert!(row.of_bound.is_some_and(|share| share <= 1.0), "{row:?}");
        }
        let pick = |method: &str| {
            let mut rows = all.iter();
            rows.find(|row| {
                (row.info.step.key, row.family, row.info.name) == ("pick", SCENE, method)
            })
            .expect("a row")
        };
        for chain in [Chain::World, Chain::Mesh, Chain::Eye, Chain::Double] {
            let row = pick(chain.name());
            assert!(row.wrong_percent() < 2.0, "{view:?} {row:?}");
        }
    }
}

/// A swap changes only its step: with Sightline's own method or one as good swapped in, the pick equals Sightline's.
#[test]
fn a_good_method_swapped_in_changes_nothing() {
    let mut steps: Vec<AnyStep> = BREAKS.map(|broken| broken.step).to_vec();
    steps.sort_by_key(|step| step.about.key);
    steps.dedup();
    let scene = row_of_shapes();
    // One is Sightline's in each step; one more is as good.
    let methods = steps.len() + 1;
    for view in views(&scene) {
        let swapped = (steps.iter()).map(|step| changes_nothing(&scene, &view, *step, [5, 2]));
        assert_eq!(swapped.sum::<usize>(), methods);
    }
    for exhibit in &GALLERY {
        let loaded = scene::load(&[exhibit.path()], &Progress::default()).expect("a scene");
        let view = view_of(&loaded, WIDTH, HEIGHT);
        let scene = &loaded.scene;
        let swapped = (steps.iter()).map(|step| changes_nothing(scene, &view, *step, [5, 1]));
        assert_eq!(swapped.sum::<usize>(), methods);
    }
}

/// Compares picks at every so many columns and rows. Returns how many methods were swapped in.
fn changes_nothing(scene: &Scene, view: &View, step: AnyStep, every: [usize; 2]) -> usize {
    let good = |info: &MethodInfo| {
        info.ours || (info.name, info.precision) == ("inverse(M), normalised", F64)
    };
    let methods = step.methods();
    let mut swapped = 0;
    for method in (0..methods.len()).filter(|i| good(&methods[*i])) {
        swapped += 1;
        let swap = Swap { step, method };
        let mut hits = 0;
        let columns = (0..WIDTH).step_by(every[0]);
        for (x, y) in columns.flat_map(|x| (0..HEIGHT).step_by(every[1]).map(move |y| (x, y))) {
            let px = DVec2::new(f64::from(x), f64::from(y)) + 0.5;
            let theirs = swap.pick(scene, view, px);
            let ours = Found::sightlines(scene, view, px);
            let what = |found: &Option<Found>| {
                found.map(|f| (f.hit.object, f.hit.hit.on_triangle.map(|at| at.triangle)))
            };
            assert_eq!(what(&theirs), what(&ours), "{view:?} {swap:?} {px}");
            let (Some(theirs), Some(ours)) = (theirs, ours) else {
                continue;
            };
            hits += 1;
            let far = ours.point_world.distance(view.camera.eye());
            let apart = theirs.point_world.distance(ours.point_world) / far;
            let tolerance = if step.about.key == "depth" {
                1e-6
            } else {
                1e-9
            };
            assert!(apart < tolerance, "{view:?} {swap:?} {px}: {apart}");
            let turn = theirs.normal_world.angle_between(ours.normal_world);
            assert!(turn < 1e-6, "{view:?} {swap:?} {px}: {turn}");
        }
        assert!(hits * every[1] > 100, "{view:?} {hits}");
    }
    swapped
}
