//! Of many objects, only those in view are drawn, grouped by kind. The picture is the same as if each were drawn in
//! turn.

use super::*;
use common::Random;
use glam::{DAffine3, DMat3};
use scenes::object;
use sightline::{
    camera::{Camera, Viewport},
    geometry::Placement,
    render::MeshStore,
    scene::{Object, Shape},
    verify,
};
use std::sync::Arc;

/// More than are processed at once.
const MANY: usize = 1500;

/// A square of side 1 in the xy plane, of two triangles.
fn plate() -> Shape {
    let corners = vec![
        [-0.5, -0.5, 0.0],
        [0.5, -0.5, 0.0],
        [0.5, 0.5, 0.0],
        [-0.5, 0.5, 0.0],
    ];
    let mesh = scenes::mesh(DVec3::ZERO, corners, &[&[[0, 1, 2], [0, 2, 3]]]);
    Shape::Mesh {
        mesh: Arc::new(mesh),
        part: 0,
    }
}

/// One of four shapes in turn.
fn shape(i: usize, plate: &Shape) -> Shape {
    match i % 4 {
        0 => Shape::Cube,
        1 => Shape::Sphere,
        2 => Shape::Square,
        _ => plate.clone(),
    }
}

/// Anywhere within 20 of the origin along each axis, rotated, stretched and sometimes mirrored.
fn model(random: &mut Random) -> DAffine3 {
    let turned = DMat3::from_axis_angle(random.direction(), random.within(0.0, 6.0));
    let mut scale = DVec3::new(1.0, 0.6, 1.4) * random.within(0.5, 2.0);
    if random.unit() < 0.3 {
        scale.x = -scale.x;
    }
    DAffine3 {
        matrix3: turned * DMat3::from_diagonal(scale),
        translation: random.point(20.0),
    }
}

/// Shapes anywhere; every ninth is in the place of the one four before it.
fn scattered(random: &mut Random) -> Scene {
    let plate = plate();
    let mut models: Vec<DAffine3> = Vec::new();
    for i in 0..MANY {
        let model = if i % 9 == 8 {
            models[i - 4]
        } else {
            model(random)
        };
        models.push(model);
    }
    let objects = models.into_iter().enumerate();
    let objects =
        objects.map(|(i, model)| object("one", shape(i, &plate), model, Some([90, 90, 90])));
    Scene::new(objects.collect())
}

fn ids(gpu: &Gpu, buffers: &SceneBuffers, view: &View) -> Image<Id> {
    let targets = Targets::new(gpu, view.viewport, 1).expect("fits");
    Renderer::new(gpu, 1)
        .draw((buffers, &targets, view), &[])
        .expect("draws");
    targets.read_ids(gpu).expect("ids")
}

#[test]
fn of_what_is_in_view_nothing_is_left_out() {
    let gpu = gpu();
    let mut random = Random::new(5);
    let scene = scattered(&mut random);
    let buffers = SceneBuffers::upload(&gpu, &scene).expect("fits");
    let mut seen = 0;
    for i in 0..24 {
        let eye = random.point(18.0);
        let lens = if i % 3 == 0 {
            orthographic(random.within(2.0, 12.0), 0.5, random.within(5.0, 30.0))
        } else {
            perspective(random.within(10.0, 100.0), 0.5, random.within(5.0, 40.0))
        };
        let view = View {
            camera: Camera::looking(eye, random.direction(), DVec3::Y, lens).expect("a camera"),
            viewport: Viewport::new(160, 100).expect("a size"),
            sides: if i % 2 == 0 {
                Sides::Both
            } else {
                Sides::Front
            },
            section: None,
        };
        let picked = pick::ids(&scene, &view);
        let report = verify::compare(
            &scene,
            &view,
            gpu.rasteriser(),
            &ids(&gpu, &buffers, &view),
            &picked,
        );
        assert_eq!(report.count(verify::Class::Unexplained), 0, "{view:?}");
        seen += picked.pixels().iter().filter(|id| id.object > 0).count();
    }
    assert!(seen > 24 * 160 * 100 / 4, "{seen}");
}

/// Faces of all flat kinds lie in one plane before the eye, with borders between pixels. Their depths are all equal and
/// exact in `f32`.
#[test]
fn of_surfaces_in_one_place_the_lower_object_is_drawn_whatever_its_kind() {
    let gpu = gpu();
    let mut random = Random::new(6);
    let plate = plate();
    let objects = (0..MANY).map(|i| {
        let side = 16.0;
        let shape = match shape(i, &plate) {
            Shape::Sphere => Shape::Cube,
            shape => shape,
        };
        let z = if matches!(shape, Shape::Cube) {
            -0.5 * side
        } else {
            0.0
        };
        let mut corner = || (random.within(-10.0, 10.0)).round() * 16.0;
        let model = DAffine3 {
            matrix3: DMat3::from_diagonal(DVec3::splat(side)),
            translation: DVec3::new(corner(), corner(), z),
        };
        object("one", shape, model, None)
    });
    let scene = Scene::new(objects.collect());
    let view = view(
        [0.0, 0.0, 64.0],
        [0.0, 0.0, 0.0],
        orthographic(256.0, 1.0, 129.0),
        [320, 256],
    );
    let buffers = SceneBuffers::upload(&gpu, &scene).expect("fits");
    let (drawn, picked) = (ids(&gpu, &buffers, &view), pick::ids(&scene, &view));
    let objects =
        |ids: &Image<Id>| -> Vec<u32> { ids.pixels().iter().map(|id| id.object).collect() };
    assert!(objects(&drawn) == objects(&picked));
    let mut shown = objects(&drawn);
    shown.sort_unstable();
    shown.dedup();
    assert!(shown.len() > 150, "{}", shown.len());
}

/// One change after another.
#[test]
fn what_changes_among_many_is_drawn_as_if_it_had_always_been_so() {
    let gpu = gpu();
    let mut random = Random::new(7);
    let mut scene = scattered(&mut random);
    let view = view(
        [22.0, 3.0, 6.0],
        [4.0, 0.0, 0.0],
        perspective(60.0, 0.5, 60.0),
        [160, 100],
    );
    let mut buffers = SceneBuffers::upload(&gpu, &scene).expect("fits");
    let mut before = ids(&gpu, &buffers, &view);
    let (mut changed, mut meshes) = (0, MeshStore::default());
    for i in 0..60 {
        // A seen object, or any, is shown, hidden, or placed before the eye or anywhere.
        let at = (random.below(160), random.below(100));
        let seen = before.at(
            u32::try_from(at.0).expect("few"),
            u32::try_from(at.1).expect("few"),
        );
        let index = match (seen.object, i % 4) {
            (0, _) | (_, 0) => random.below(MANY),
            (id, _) => id as usize - 1,
        };
        let Object { visible, .. } = scene.objects()[index];
        match i % 5 {
            0 | 1 => scene.set_visible(index, !visible),
            _ => {
                let mut to = model(&mut random);
                if i % 5 != 2 {
                    to.translation =
                        view.camera.eye() + view.offset_from_eye(glam::DVec2::new(80.0, 50.0), 5.0);
                }
                scene.place(index, Placement::new(to).expect("invertible"));
            }
        }
        (buffers.update(&gpu, &scene, &mut meshes)).expect("fits");
        let now = ids(&gpu, &buffers, &view);
        let fresh = SceneBuffers::upload(&gpu, &scene).expect("fits");
        assert_eq!(
            differing(&now, &ids(&gpu, &fresh, &view)),
            0,
            "{i}: {index}"
        );
        changed += usize::from(differing(&now, &before) > 0);
        before = now;
    }
    assert!(changed > 30, "{changed}");
}

#[test]
fn objects_that_move_are_drawn_where_they_are() {
    let gpu = gpu();
    let mut scene = shapes(DVec3::ZERO);
    let view = overview([320, 200]);
    let mut kept = Kept::new(&gpu, &scene, view);
    let mut before = draw(&gpu, &scene, &view, &[], &Marks::default(), 1).0;
    let mirror = DAffine3::from_scale(DVec3::new(-1.0, 1.0, 1.0));
    let up = DAffine3::from_translation(DVec3::new(0.1, 0.3, 0.0));
    for by in [up, mirror] {
        for object in [0, 1, 6, 9] {
            let model = by * scene.objects()[object].placement.model();
            scene.place(object, Placement::new(model).expect("invertible"));
        }
        scene.set_visible(2, by == mirror);
        let drawn = kept.ids(&scene);
        let fresh = draw(&gpu, &scene, &view, &[], &Marks::default(), 1).0;
        assert_eq!(differing(&drawn, &fresh), 0);
        assert!(differing(&drawn, &before) > 300, "they moved");
        before = drawn;
    }
}

/// A software adapter takes more than 2^18 triangles of a mesh in several calls. They are numbered through, in each of
/// two objects.
#[test]
fn a_mesh_of_several_calls_is_numbered_through() {
    const SIDE: u16 = 400;
    let gpu = gpu();
    let side = f32::from(SIDE);
    let at = |i: u16| f32::from(i) / side - 0.5;
    let corners = (0..=SIDE).flat_map(|y| (0..=SIDE).map(move |x| [at(x), at(y), 0.0]));
    let cells = (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (u32::from(x), u32::from(y))));
    let triangles: Vec<_> = cells
        .flat_map(|(x, y)| {
            let a = y * (u32::from(SIDE) + 1) + x;
            let above = a + u32::from(SIDE) + 1;
            [[a, a + 1, above + 1], [a, above + 1, above]]
        })
        .collect();
    let mesh = scenes::mesh(DVec3::ZERO, corners.collect(), &[&triangles]);
    let shape = Shape::Mesh {
        mesh: Arc::new(mesh),
        part: 0,
    };
    let beside = |x: f64| DAffine3::from_translation(DVec3::new(x, 0.0, 0.0));
    let objects = [-0.6, 0.6].map(|x| object("sheet", shape.clone(), beside(x), None));
    let scene = Scene::new(objects.into());
    scene.build_trees();
    let view = view(
        [0.0, 0.0, 3.0],
        [0.0; 3],
        perspective(30.0, 0.1, 10.0),
        [640, 320],
    );
    let buffers = SceneBuffers::upload(&gpu, &scene).expect("fits");
    let (drawn, picked) = (ids(&gpu, &buffers, &view), pick::ids(&scene, &view));
    let report = verify::compare(&scene, &view, gpu.rasteriser(), &drawn, &picked);
    assert_eq!(report.count(verify::Class::Unexplained), 0);
    for object in [1, 2] {
        let of_object = drawn.pixels().iter().filter(|id| id.object == object);
        let beyond = of_object.filter(|id| id.triangle > 1 << 18);
        assert!(beyond.count() > 5000, "{object}");
    }
}
