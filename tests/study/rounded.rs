//! What `--budget` says of `f32` holds: picks are repeated with each quantity in turn rounded to `f32`, and all of them
//! at once. Whatever they then find is found by an exact pick within as many pixels as was said. Where the budget
//! cannot say so it refuses.

use super::{gallery::view_of, real_files::real_files};
use sightline::{
    camera::View,
    geometry::{Mesh, MeshData, Placement, Ray},
    glam::{DMat3, DVec2, DVec3, dvec2},
    pick,
    scene::{self, Progress, Scene, Shape},
    study::{self, Effort, NoBudget, SceneRays, has_budget},
};
use std::{collections::BTreeMap, fmt::Write, fs, path::PathBuf, sync::Arc};

/// The object and triangle at a position, or nothing.
type Found = Option<(usize, Option<u32>)>;

fn narrow(v: DVec3) -> DVec3 {
    v.as_vec3().as_dvec3()
}

/// A quantity that a program keeps in `f32`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Quantity {
    Eye,
    Axes,
    HalfExtent,
    Translation,
    Linear,
    FileCoordinates,
}

use Quantity::{Axes, Eye, FileCoordinates, HalfExtent, Linear, Translation};

const EACH: [Quantity; 6] = [Eye, Axes, HalfExtent, Translation, Linear, FileCoordinates];

/// The scene with these quantities rounded.
fn scene_rounded(scene: &Scene, rounded: &[Quantity]) -> Scene {
    let mesh = |mesh: &Arc<Mesh>| {
        let data = mesh.data();
        let in_file = |p: &[f32; 3]| {
            let sum = data.origin + DVec3::from(p.map(f64::from));
            sum.as_vec3().to_array()
        };
        let positions = data.positions.iter().map(in_file).collect();
        let origin = DVec3::ZERO;
        Arc::new(
            Mesh::new(MeshData {
                positions,
                origin,
                ..data.clone()
            })
            .expect("a mesh"),
        )
    };
    let objects = scene.objects().iter().map(|object| {
        let mut object = object.clone();
        if let (Shape::Mesh { mesh: of, .. }, true) =
            (&mut object.shape, rounded.contains(&FileCoordinates))
        {
            *of = mesh(of);
        }
        let mut model = object.placement.model();
        if rounded.contains(&Translation) {
            model.translation = narrow(model.translation);
        }
        if rounded.contains(&Linear) {
            let columns = [
                model.matrix3.x_axis,
                model.matrix3.y_axis,
                model.matrix3.z_axis,
            ];
            let [x, y, z] = columns.map(narrow);
            model.matrix3 = DMat3::from_cols(x, y, z);
        }
        object.placement = Placement::new(model).expect("a matrix");
        object
    });
    let scene = Scene::new(objects.collect());
    scene.build_trees();
    scene
}

/// A position's ray with these quantities rounded.
fn ray_rounded(view: &View, px: DVec2, rounded: &[Quantity]) -> Ray {
    let camera = &view.camera;
    let mut axes = [camera.right(), camera.up(), camera.forward()];
    if rounded.contains(&Axes) {
        axes = axes.map(narrow);
    }
    let mut half = camera.lens().half_extent(view.viewport.aspect());
    if rounded.contains(&HalfExtent) {
        half = half.as_vec2().as_dvec2();
    }
    let at = view.viewport.px_to_ndc(px) * half;
    let [right, up, forward] = axes;
    let aside = at.x * right + at.y * up;
    let (mut origin, direction) = if camera.lens().is_orthographic() {
        (camera.eye() + aside, forward)
    } else {
        (camera.eye(), forward + aside)
    };
    if rounded.contains(&Eye) {
        origin = narrow(origin);
    }
    let exact = *view.ray(px);
    Ray {
        origin,
        direction,
        ..exact
    }
}

fn found(scene: &Scene, view: &View, ray: Ray) -> Found {
    let hit = pick::closest(scene, ray, view.sides)?;
    Some((hit.object, hit.triangle_of_object(scene)))
}

/// Positions beside borders between two answers, on either side, at distances from a millionth of `far_px` to three
/// times as much.
fn beside_borders(scene: &Scene, view: &View, far_px: f64) -> Vec<DVec2> {
    let at = |px: DVec2| found(scene, view, *view.ray(px));
    let mut positions = Vec::new();
    for i in 0..3000_u32 {
        let turn = |step: f64| (f64::from(i) * step).fract();
        let along = DVec2::from_angle(turn(0.569_840) * std::f64::consts::TAU);
        let start = dvec2(
            30.0 + 1540.0 * turn(0.618_034),
            30.0 + 1140.0 * turn(0.754_878),
        );
        let first = at(start);
        let (mut here, mut beyond) = (0.0, 20.0);
        if at(start + beyond * along) == first {
            continue;
        }
        while beyond - here > 1e-9 {
            let middle = 0.5 * (here + beyond);
            if at(start + middle * along) == first {
                here = middle;
            } else {
                beyond = middle;
            }
        }
        let off = far_px * 10_f64.powf(6.5 * turn(0.437_016) - 6.0);
        positions.extend([here - off, beyond + off].map(|distance| start + distance * along));
    }
    positions
}

/// Whether an exact pick at a position, or at most `px` from it, finds the same.
fn is_within(scene: &Scene, view: &View, at: DVec2, px: f64, what: Found) -> bool {
    let mut around = (0..=8).flat_map(|ring| {
        (0..64).map(move |i| {
            let turn = DVec2::from_angle(f64::from(i) / 64.0 * std::f64::consts::TAU);
            at + px * f64::from(ring) / 8.0 * turn
        })
    });
    around.any(|px| found(scene, view, *view.ray(px)) == what)
}

/// A camera of a scene file that looks down at a point of the plane y = 0: from before it, or with parallel rays from
/// beyond it.
fn camera(x: f64, z: f64, lens: &str) -> String {
    let from = if lens.contains("near") { -1.0 } else { 1.0 };
    let along = |by: f64| [x + 3.1 * by, 15.3 * by, z + 7.7 * by];
    let (eye, target) = (along(from), along(from - 1.0));
    format!("[camera]\neye = {eye:?}\ntarget = {target:?}\n{lens}\n")
}

/// Hills of 2 x 128 x 128 triangles, 20 units wide, about a point of the file's coordinates.
fn hills(folder: &tempfile::TempDir, x: f64, z: f64, lens: &str) -> PathBuf {
    const SIDE: u32 = 128;
    let mut text = String::new();
    for (i, j) in (0..=SIDE).flat_map(|j| (0..=SIDE).map(move |i| (i, j))) {
        let [u, v] = [i, j].map(|k| 20.0 * f64::from(k) / f64::from(SIDE) - 10.0);
        let height = (0.9 * u).sin() * (0.7 * v).cos();
        writeln!(text, "v {} {height} {}", x + u, z + v).expect("text");
    }
    for (i, j) in (0..SIDE).flat_map(|j| (0..SIDE).map(move |i| (i, j))) {
        let a = j * (SIDE + 1) + i + 1;
        let [b, c, d] = [a + 1, a + SIDE + 2, a + SIDE + 1];
        writeln!(text, "f {a} {d} {c}\nf {a} {c} {b}").expect("text");
    }
    fs::write(folder.path().join("hills.obj"), text).expect("a file");
    let object = "[[object]]\nshape = \"mesh\"\nfile = \"hills.obj\"\n";
    let text = camera(x, z, lens) + object;
    let file = folder.path().join("hills.toml");
    fs::write(&file, text).expect("a file");
    file
}

/// Blocks, balls and signs, turned, stretched and some of them sheared, about a point of the world.
fn blocks(folder: &tempfile::TempDir, x: f64, z: f64, lens: &str) -> PathBuf {
    let mut text = camera(x, z, lens);
    for i in 0..120_u32 {
        let shape = ["cube", "sphere", "square"][i as usize % 3];
        let at = |step: f64| f64::from(i) * step % 16.0 - 8.0;
        let position = [x + at(3.713), at(1.31) / 4.0, z + at(8.371)];
        let size = 0.47 + f64::from(i % 7) * 0.11;
        let scale = [0.6 * size, size, 1.3 * size];
        let rotation = [i * 13 % 90, 20, i * 29 % 360];
        let [x, y, z] = position;
        let place = if i % 5 == 0 {
            format!("matrix = [[0.6, 0.4, 0.1, {x}], [0.1, 0.5, 0.2, {y}], [0.0, 0.3, 0.7, {z}]]")
        } else {
            format!("position = {position:?}\nscale = {scale:?}\nrotation = {rotation:?}")
        };
        writeln!(text, "[[object]]\nshape = \"{shape}\"\n{place}").expect("text");
    }
    let file = folder.path().join("blocks.toml");
    fs::write(&file, text).expect("a file");
    file
}

/// What the budget says that all in `f32` adds up to, in pixels.
fn said_px(rays: &SceneRays, view: &View) -> f64 {
    let effort = Effort {
        rounds: 0,
        ..Effort::SCENE_ONLY
    };
    let report = study::run(effort, Some(rays), &|_, _| {});
    let page = study::budget(rays, view, &report, 0.05);
    let (_, rest) = page.split_once("All in f32: ").expect("a sum");
    let (px, _) = rest.split_once(" px").expect("pixels");
    px.parse().expect("a number")
}

#[test]
fn picks_with_rounded_numbers_stay_within_what_is_said() {
    let mut changed: BTreeMap<Quantity, usize> = BTreeMap::new();
    let lenses = ["fov = 50", "ortho = 14", "ortho = 14\nnear = -60\nfar = 60"];
    let far = [(30.0, 20.0), (9_200.3, 7_100.7)];
    for ((x, z), lens) in far.into_iter().flat_map(|at| lenses.map(|lens| (at, lens))) {
        for make in [hills, blocks] {
            let folder = tempfile::tempdir().expect("a folder");
            let path = make(&folder, x, z, lens);
            let loaded = scene::load(&[path], &Progress::default()).expect("a scene");
            let (scene, view) = (&loaded.scene, view_of(&loaded, 1600, 1200));
            scene.build_trees();
            let rays = SceneRays::new(scene, view, 2000, 1);
            has_budget(&rays).expect("it is near enough");
            let said = said_px(&rays, &view);
            assert!(said < 5.0, "{lens}: {said} px");
            let positions = beside_borders(scene, &view, said);
            let all = [EACH.to_vec()].into_iter();
            for rounded in EACH.map(|one| vec![one]).into_iter().chain(all) {
                let other = scene_rounded(scene, &rounded);
                for &px in &positions {
                    let exact = found(scene, &view, *view.ray(px));
                    let with_rounded = found(&other, &view, ray_rounded(&view, px, &rounded));
                    if with_rounded == exact {
                        continue;
                    }
                    assert!(
                        is_within(scene, &view, px, said, with_rounded),
                        "{x} {lens} {rounded:?} at {px}: {with_rounded:?}, not within {said} px of {exact:?}"
                    );
                    if let [one] = rounded[..] {
                        *changed.entry(one).or_default() += 1;
                    }
                }
            }
        }
    }
    for quantity in EACH {
        assert!(
            changed.get(&quantity) > Some(&3),
            "{quantity:?}: {changed:?}"
        );
    }
}

/// Far from the origin, and where nothing is hit, nothing is said.
#[test]
fn what_cannot_be_told_is_refused() {
    let refusal = |path: PathBuf| {
        let loaded = scene::load(&[path], &Progress::default()).expect("a scene");
        let rays = SceneRays::new(&loaded.scene, view_of(&loaded, 1600, 1200), 2000, 1);
        has_budget(&rays)
    };
    let folder = tempfile::tempdir().expect("a folder");
    for (make, camera) in [hills, blocks]
        .into_iter()
        .flat_map(|make| ["fov = 50", "ortho = 14"].map(|lens| (make, lens)))
    {
        let at_map = refusal(make(&folder, 447_100.2, 5_350_160.9, camera));
        assert!(
            matches!(at_map, Err(NoBudget::FarFromOrigin(times)) if times > 1e5),
            "{at_map:?}"
        );
    }
    let cube = |camera: &str, object: &str| {
        let file = folder.path().join("cube.toml");
        let text = format!(
            "[camera]\neye = [3, 2, 4]\n{camera}\n[[object]]\nname = \"box\"\nshape = \"cube\"\n{object}\n"
        );
        fs::write(&file, text).expect("a file");
        refusal(file)
    };
    assert_eq!(
        cube(
            "target = [0, 0, 0]",
            "scale = [1, 2, 3]\nrotation = [10, 20, 30]"
        ),
        Ok(())
    );
    assert_eq!(
        cube("look = [3, 2, 4]", ""),
        Err(NoBudget::NothingHit(2000))
    );
    for name in ["spot_far.obj", "linz_x0410_utm33n.obj"] {
        let Some(folder) = real_files() else {
            return;
        };
        let far = refusal(folder.join("models").join(name));
        assert!(
            matches!(far, Err(NoBudget::FarFromOrigin(_))),
            "{name}: {far:?}"
        );
    }
}
