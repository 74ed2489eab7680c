//! What `--budget` says holds. Where it calls a chain within the budget, picks by it beside borders, where they are
//! worst, are found by an exact pick within as many pixels; so are picks of this file's own, in which every number is
//! rounded to `f32`. A chain holds as far as is said, and no further.

use super::{gallery::view_of, real_files::real_files};
use sightline::{
    camera::View,
    geometry::{Mesh, MeshData, Placement, Ray, WorldRay},
    glam::{DVec2, DVec3, dvec2},
    pick,
    scene::{self, Loaded, Progress, Scene, Shape},
    study::{
        Budget, Growth, Reach,
        chains::{Chain, Held},
    },
};
use std::{collections::BTreeMap, fmt::Write, fs, path::PathBuf, process::Command, sync::Arc};

/// The object and triangle at a position, or nothing.
type Found = Option<(usize, Option<u32>)>;

fn narrow(v: DVec3) -> DVec3 {
    v.as_vec3().as_dvec3()
}

/// The scene with every number rounded to `f32` in the world's coordinates.
fn scene_rounded(scene: &Scene) -> Scene {
    let mesh = |mesh: &Arc<Mesh>| {
        let data = mesh.data();
        let in_file = |p: &[f32; 3]| {
            let sum = data.origin + DVec3::from(p.map(f64::from));
            sum.as_vec3().to_array()
        };
        let positions = data.positions.iter().map(in_file).collect();
        let origin = DVec3::ZERO;
        let data = MeshData {
            positions,
            origin,
            ..data.clone()
        };
        Arc::new(Mesh::new(data).expect("a mesh"))
    };
    let objects = scene.objects().iter().map(|object| {
        let mut object = object.clone();
        if let Shape::Mesh { mesh: of, .. } = &mut object.shape {
            *of = mesh(of);
        }
        let mut model = object.placement.model();
        model.translation = narrow(model.translation);
        model.matrix3 = model.matrix3.as_mat3().as_dmat3();
        object.placement = Placement::new(model).expect("a matrix");
        object
    });
    let scene = Scene::new(objects.collect());
    scene.build_trees();
    scene
}

/// A position's ray from an eye, along axes and through a picture that are rounded to `f32`.
fn ray_rounded(view: &View, px: DVec2) -> Ray {
    let camera = &view.camera;
    let [right, up, forward] = [camera.right(), camera.up(), camera.forward()].map(narrow);
    let half = camera.lens().half_extent(view.viewport.aspect());
    let at = view.viewport.px_to_ndc(px) * half.as_vec2().as_dvec2();
    let aside = at.x * right + at.y * up;
    let (origin, direction) = if camera.lens().is_orthographic() {
        (camera.eye() + aside, forward)
    } else {
        (camera.eye(), forward + aside)
    };
    Ray {
        origin: narrow(origin),
        direction,
        ..*view.ray(px)
    }
}

fn found<'a>(scene: &Scene, view: &View, ray: impl Into<WorldRay<'a>>) -> Found {
    let hit = pick::closest(scene, ray, view.sides)?;
    Some((hit.object, hit.triangle_of_object(scene)))
}

/// Positions beside borders between two answers, on either side, at distances from a millionth of `far_px` to three
/// times as much.
fn beside_borders(scene: &Scene, view: &View, far_px: f64) -> Vec<DVec2> {
    let at = |px: DVec2| found(scene, view, view.ray(px));
    let mut positions = Vec::new();
    for i in 0..400_u32 {
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

/// Whether two picks are of one object and, on a mesh, of triangles that share a corner. At an outline one triangle
/// hides the other, wherever the click is moved.
fn is_same(scene: &Scene, a: Found, b: Found) -> bool {
    let (Some((object, a)), Some((other, b))) = (a, b) else {
        return a == b;
    };
    let shape = &scene.objects()[object].shape;
    object == other
        && match (shape, a, b) {
            (Shape::Mesh { mesh, .. }, Some(a), Some(b)) => {
                let first = shape.first_triangle();
                let [a, b] = [a, b].map(|triangle| mesh.corners(first + triangle));
                a.iter().any(|corner| b.contains(corner))
            }
            _ => true,
        }
}

/// Whether an exact pick at a position, or at most `px` from it, is the one.
fn is_within(
    scene: &Scene,
    view: &View,
    at: DVec2,
    px: f64,
    is_it: impl Fn(Found) -> bool,
) -> bool {
    let mut around = (0..=8).flat_map(|ring| {
        (0..64).map(move |i| {
            let turn = DVec2::from_angle(f64::from(i) / 64.0 * std::f64::consts::TAU);
            at + px * f64::from(ring) / 8.0 * turn
        })
    });
    around.any(|px| is_it(found(scene, view, view.ray(px))))
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

/// Scenes seen through a lens so long that a rounding error of `f32` is many pixels. The targets lie on outlines.
fn long_lenses(folder: &tempfile::TempDir) -> Vec<PathBuf> {
    let needles = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/gallery/needles.obj");
    std::fs::copy(needles, folder.path().join("needles.obj")).expect("a mesh");
    let scenes = [
        ("sphere", "", "[0.28767, -0.40897, 0]"),
        ("cube", "", "[0.5, -0.5, 0.1]"),
        ("square", "", "[0.5, 0.1, 0]"),
        ("mesh", "file = \"needles.obj\"", "[0.9, 0, 0]"),
    ];
    let scene = |(shape, file, target): (&str, &str, &str)| {
        let text = format!(
            "[camera]\neye = [612.3, 430.7, 730.1]\ntarget = {target}\nfov = 1e-5\n[[object]]\nshape = \"{shape}\"\n{file}\n"
        );
        let path = folder.path().join(shape).with_extension("toml");
        std::fs::write(&path, text).expect("a file");
        path
    };
    scenes.map(scene).to_vec()
}

fn load(path: impl Into<PathBuf>) -> Loaded {
    scene::load(&[path.into()], &Progress::default()).expect("a scene")
}

fn budget_of(path: impl Into<PathBuf>, px: f64) -> Budget {
    let loaded = load(path);
    Budget::new(&loaded.scene, &view_of(&loaded, 1600, 1200), px, 1).expect("something is hit")
}

fn worst_px(budget: &Budget, chain: Chain) -> f64 {
    let mut tried = budget.tried.iter();
    let tried = tried.find(|tried| tried.chain == chain);
    tried.expect("a row").worst_px
}

/// Scenes about the origin, far from it, in map coordinates, through long lenses, tiny and huge.
fn scenes() -> Vec<(tempfile::TempDir, PathBuf)> {
    let lenses = ["fov = 50", "ortho = 14", "ortho = 14\nnear = -60\nfar = 60"];
    let far = [(30.0, 20.0), (9_200.3, 7_100.7), (447_100.2, 5_350_160.9)];
    let mut scenes = Vec::new();
    for ((x, z), lens) in far.into_iter().flat_map(|at| lenses.map(|lens| (at, lens))) {
        for make in [hills, blocks] {
            let folder = tempfile::tempdir().expect("a folder");
            let path = make(&folder, x, z, lens);
            scenes.push((folder, path));
        }
    }
    let folder = tempfile::tempdir().expect("a folder");
    for path in long_lenses(&folder) {
        scenes.push((tempfile::tempdir().expect("a folder"), path));
    }
    scenes.push((folder, PathBuf::from("gallery:needles")));
    let models = real_files().map(|folder| folder.join("models"));
    for name in [
        "spot_far.obj",
        "teapot_tiny.obj",
        "teapot_huge.obj",
        "spot.obj",
    ] {
        if let Some(models) = &models {
            scenes.push((tempfile::tempdir().expect("a folder"), models.join(name)));
        }
    }
    scenes
}

/// A chain that is within the budget is so beside borders too, where a pick is worst.
#[test]
fn no_chain_is_within_that_a_repeated_pick_exceeds() {
    let mut changed: BTreeMap<&str, usize> = BTreeMap::new();
    for (_folder, path) in &scenes() {
        let loaded = load(path);
        let (scene, view) = (&loaded.scene, view_of(&loaded, 1600, 1200));
        scene.build_trees();
        for px in [1e-3, 1e-1] {
            let budget = Budget::new(scene, &view, px, 1).expect("something is hit");
            let within = budget.tried.iter().filter(|tried| tried.is_within(px));
            let within: Vec<Chain> = within.map(|tried| tried.chain).collect();
            let positions = beside_borders(scene, &view, px);
            let check = |name: &'static str, px_there: DVec2, what: Found| {
                let exact = found(scene, &view, view.ray(px_there));
                assert!(
                    what == exact
                        || is_within(scene, &view, px_there, px, |found| is_same(
                            scene, found, what
                        )),
                    "{}: {name} at {px_there}: {what:?}, not within {px} px of {exact:?}",
                    path.display()
                );
                usize::from(what != exact)
            };
            for chain in within {
                let held = Held::new(chain, scene, &view);
                for at in &positions {
                    let what = held.pick(*at).map(|found| found.hit);
                    let what = what.map(|hit| (hit.object, hit.triangle_of_object(scene)));
                    *changed.entry(chain.name()).or_default() += check(chain.name(), *at, what);
                }
                if chain == Chain::World {
                    let rounded = scene_rounded(scene);
                    for at in &positions {
                        let what = found(&rounded, &view, ray_rounded(&view, *at));
                        *changed.entry("own").or_default() += check("own", *at, what);
                    }
                }
            }
        }
    }
    for chain in [Chain::World, Chain::Mesh, Chain::Eye] {
        assert!(changed[chain.name()] > 20, "{changed:?}");
    }
    assert!(changed["own"] > 20, "{changed:?}");
    assert_eq!(changed[Chain::Sightline.name()], 0);
}

/// In map coordinates `f32` is wrong by many pixels, whether they are in the file or in a model matrix; about the eye it
/// is not.
#[test]
fn map_coordinates_need_more_than_f32_in_the_world() {
    let folder = tempfile::tempdir().expect("a folder");
    for make in [hills, blocks] {
        let path = make(&folder, 447_100.2, 5_350_160.9, "fov = 50");
        let budget = budget_of(path, 0.05);
        assert!(worst_px(&budget, Chain::World) > 10.0, "{budget:?}");
        assert!(worst_px(&budget, Chain::Eye) < 0.01, "{budget:?}");
        let simplest = budget.simplest().expect("one").chain;
        assert_eq!(simplest, Chain::Mesh, "{budget:?}");
    }
    let Some(files) = real_files() else {
        return;
    };
    for name in ["spot_far.obj", "linz_x0410_utm33n.obj"] {
        let budget = budget_of(files.join("models").join(name), 0.05);
        assert!(worst_px(&budget, Chain::World) > 0.05, "{name}: {budget:?}");
        assert_eq!(budget.simplest().expect("one").chain, Chain::Mesh, "{name}");
    }
}

/// Through a lens so long that `f32` about the eye is too coarse, `f64` is called for; for an error that no `f64` keeps,
/// exact decisions.
#[test]
fn a_long_lens_needs_f64() {
    let folder = tempfile::tempdir().expect("a folder");
    for path in long_lenses(&folder) {
        let budget = budget_of(path.clone(), 0.05);
        assert!(worst_px(&budget, Chain::Eye) > 1.0, "{budget:?}");
        let simplest = budget.simplest().expect("one").chain;
        assert_eq!(simplest, Chain::Double, "{}: {budget:?}", path.display());
        let none = budget_of(path, 1e-15);
        assert_eq!(none.simplest().expect("one").chain, Chain::Sightline);
        assert!(none.breaks.is_empty());
    }
}

/// A scene that is moved as far as the chain is said to hold is within the budget, and where it is said to break it is
/// not. So is one that is seen from further away.
#[test]
fn a_chain_holds_as_far_as_is_said() {
    let folder = tempfile::tempdir().expect("a folder");
    let ball = |eye: [f64; 3], at: [f64; 3], fov_deg: f64| {
        let file = folder.path().join("ball.toml");
        let text = format!(
            "[camera]\neye = {eye:?}\ntarget = {at:?}\nfov = {fov_deg:?}\n[[object]]\nshape = \"sphere\"\nposition = {at:?}\n"
        );
        fs::write(&file, text).expect("a file");
        budget_of(file, 0.005)
    };
    let is_world = |budget: &Budget| budget.simplest().expect("one").chain == Chain::World;
    let near = ball([0.5, 1.0, 2.0], [0.0; 3], 30.0);
    assert!(is_world(&near), "{near:?}");
    let reach = |of: Growth| -> Reach {
        let mut breaks = near.breaks.iter();
        *breaks.find(|reach| reach.of == of).expect("it was tried")
    };
    let offset = reach(Growth::Offset);
    let [held, broke] = [offset.held, offset.broke].map(|at| at.expect("found"));
    assert!(broke / held > 9.9 && broke / held < 10.1, "{offset:?}");
    let moved = |by: f64| {
        let at = [0.3 * by, 0.5 * by, 0.8 * by];
        ball([at[0] + 0.5123, at[1] + 1.01, at[2] + 2.003], at, 30.0)
    };
    assert!(is_world(&moved(0.5 * held)), "{offset:?}");
    assert!(!is_world(&moved(2.0 * broke)), "{offset:?}");
    let lens = reach(Growth::Lens);
    let [held, broke] = [lens.held, lens.broke].map(|at| at.expect("found"));
    let back = |times: f64| {
        let fov = 2.0 * ((15.0_f64.to_radians().tan()) / times).atan();
        ball(
            [0.5 * times, times, 2.0 * times],
            [0.0; 3],
            fov.to_degrees(),
        )
    };
    assert!(is_world(&back(held)), "{lens:?}");
    assert!(!is_world(&back(2.0 * broke)), "{lens:?}");
}

/// Two squares so close together that standard depth stores one number for both.
#[test]
fn depth_buffers_that_tell_two_surfaces_apart_are_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let squares = |gap: f64| {
        let file = folder.path().join("squares.toml");
        let text = format!(
            "[camera]\neye = [0, 0, 200]\ntarget = [0, 0, 0]\nfov = 1\nnear = 0.1\nfar = 1000\n\
             [[object]]\nshape = \"square\"\nscale = [3, 3, 1]\n\
             [[object]]\nshape = \"square\"\nscale = [3, 3, 1]\nposition = [0, 0, -{gap:?}]\n"
        );
        fs::write(&file, text).expect("a file");
        budget_of(file, 0.05)
    };
    // Standard depth has steps of 0.01 to 0.05 there, reversed ones of 0.00002.
    let alike = |gap: f64| squares(gap).depth.alike.into_iter().map(|(_, alike)| alike);
    let far: Vec<usize> = alike(1.0).collect();
    assert_eq!(far, [0; 3]);
    let near: Vec<usize> = alike(0.002).collect();
    assert!(near[0] > 100 && near[1] > 100 && near[2] == 0, "{near:?}");
    let page = squares(0.002).page();
    assert!(page.contains("reversed, 32-bit floats suffice"), "{page}");
    // In one place, no buffer can tell.
    assert_eq!(squares(0.0).depth.pixels, 0);
}

fn study(arguments: &[&str]) -> std::process::Output {
    let program = Command::new(env!("CARGO_BIN_EXE_sightline"))
        .args(["study", "--budget", "0.05"])
        .args(arguments)
        .output();
    program.expect("the program")
}

#[test]
fn the_command_prints_a_line_for_each_chain() {
    let run = study(&["gallery:needles"]);
    assert!(run.status.success());
    let page = String::from_utf8(run.stdout).expect("text");
    for chain in Chain::ALL {
        let line = page.lines().find(|line| line.contains(chain.name()));
        let line = line.unwrap_or_else(|| panic!("{chain:?}: {page}"));
        let is_simplest = line.ends_with("the simplest that suffices");
        assert_eq!(is_simplest, chain == Chain::World, "{page}");
    }
    assert!(
        page.starts_with("2000 of 2000 random pixels show something"),
        "{page}"
    );
    for words in [
        "The simplest holds with the scene",
        "Depth buffer: ",
        "fewer than 3 in 2000",
    ] {
        assert!(page.contains(words), "{words}: {page}");
    }
}

#[test]
fn without_hits_there_is_no_budget() {
    let run = study(&["gallery:needles", "--look=0,0,1"]);
    let said = String::from_utf8(run.stderr).expect("text");
    assert_eq!(run.status.code(), Some(2), "{said}");
    assert!(run.stdout.is_empty() && said.lines().count() == 1, "{said}");
    assert!(said.contains("none of 2000 rays hits anything"), "{said}");
}
