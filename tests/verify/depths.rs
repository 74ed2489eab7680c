//! Verify never excuses a drawing that shows a hidden surface in front of the one that hides it, however coarse the
//! depth buffer. Each case is the command that found it.

use crate::{
    compare, drawn_once,
    extremes::{Counts, run, scene},
};
use clap::Parser;
use sightline::{
    camera::View,
    cli::{Cli, Command},
    glam::{DVec2, dvec2},
    image::Id,
    pick::{self, SceneHit},
    scene::{self, Progress, Scene, Shape},
    verify::{Class, DEPTH_CEILING, Verdict},
};
use std::f64::consts::FRAC_PI_8;

/// Asserts that verify says that `f32` cannot hold the view, and excuses as *depth* no pixel whose two surfaces lie
/// farther apart there than the ceilings ([`DEPTH_CEILING`]). How many pixels a driver gets wrong is up to its last
/// bits. Returns how many were excused so, with faces of both surfaces at their centres.
#[track_caller]
fn cannot_be_held(toml: Option<&str>, view: &str) -> usize {
    let file = toml.map(scene);
    let path = file.as_ref().map(|(_, path)| path);
    let counts = Counts::of(run(path, view));
    assert_eq!(counts.get("unexplained"), 0, "{view}: {}", counts.line);
    assert_eq!(counts.code, Some(1), "{view}: {}", counts.line);

    let words = ["sightline", "verify"].into_iter();
    let cli = Cli::try_parse_from(words.chain(view.split_whitespace())).expect("flags");
    let Some(Command::Verify(flags)) = cli.command else {
        panic!("verify");
    };
    let paths: Vec<_> = path.cloned().into_iter().collect();
    let mut loaded = scene::load(&paths, &Progress::default()).expect("a scene");
    let at = flags.view.apply(&mut loaded).expect("a view");
    let scene = &loaded.scene;
    scene.build_trees();
    let report = compare(scene, &at, &drawn_once(scene, &at), &pick::ids(scene, &at));
    assert!(matches!(report.verdict(), Verdict::BeyondF32(_)), "{view}");
    let mut seen = 0;
    for pixel in report.disagreements {
        if pixel.class != Class::Depth {
            continue;
        }
        let px = dvec2(pixel.pixel[0].into(), pixel.pixel[1].into()) + 0.5;
        let [drawn, picked] = [pixel.drawn, pixel.picked].map(|id| around(scene, &at, px, id));
        if drawn.is_empty() || picked.is_empty() {
            continue;
        }
        let is_within =
            |[a, may_a]: &[f64; 2], [b, may_b]: &[f64; 2]| (a - b).abs() <= may_a + may_b;
        let close = drawn.iter().any(|a| picked.iter().any(|b| is_within(a, b)));
        assert!(close, "{view}: {pixel:?}");
        seen += 1;
    }
    seen
}

/// The depths of an object's flat faces at a position, and how far off drawing may be there: by the ceiling, and by the
/// change of the face's depth over half a pixel, both for being moved aside and for its rounding.
fn around(scene: &Scene, view: &View, px: DVec2, id: Id) -> Vec<[f64; 2]> {
    let lens = view.camera.lens();
    let height = 2.0 * view.camera.half_height() / f64::from(view.viewport.height());
    let hits = pick::all(scene, view.ray(px), view.sides);
    let of_id = hits.iter().filter(|hit| {
        let triangle = hit.triangle_of_object(scene);
        let is_it = triangle.map_or(0, |triangle| triangle + 1) == id.triangle;
        hit.object + 1 == id.object as usize && is_it
    });
    let flat = of_id.filter(|hit| !matches!(scene.objects()[hit.object].shape, Shape::Sphere));
    let face = |hit: &SceneHit| {
        let depth = hit.hit.t;
        let point = view.ray(px).at(depth);
        let placement = &scene.objects()[hit.object].placement;
        let normal = placement.normal_to_world(hit.hit.normal);
        let slope = (0..16).map(|i| {
            let aside = DVec2::from_angle(f64::from(i) * FRAC_PI_8);
            let ray = view.ray(px + 0.5 * aside);
            let there = (point - ray.origin).dot(normal) / ray.direction.dot(normal);
            (there - depth).abs()
        });
        let [pixel, known] = if lens.is_orthographic() {
            [height, lens.far - lens.near]
        } else {
            [height * depth, depth.min(lens.far - lens.near)]
        };
        let ceiling = (0.5 * pixel).min(DEPTH_CEILING * known);
        [depth, ceiling + 2.0 * slope.fold(0.0, f64::max)]
    };
    flat.map(face).collect()
}

const BEFORE_A_WALL: &str = r#"
[[object]]
shape = "square"
scale = 30
position = [0, 0, -11]
[[object]]
shape = "square"
scale = 2
position = [3, 0, -9.4]
[[object]]
shape = "square"
scale = 2
position = [-3, 0, -7.9]
"#;

#[test]
fn standard_depth_with_near_at_the_eye() {
    let view = "--size 320x240 --depth standard --near 1e-5 --far 100";
    cannot_be_held(None, view);
    let view =
        "--size 320x240 --eye 0,0,0 --look 0,0,-1 --fov 60 --depth standard --near 5e-7 --far 100";
    cannot_be_held(Some(BEFORE_A_WALL), view);
    let view = "--size 320x240 --eye 3000,2400,5000 --target 0,0.7,0 --fov 0.04 --depth standard --near 0.001 --far 1e6";
    cannot_be_held(None, view);
}

#[test]
fn orthographic_planes_far_apart() {
    let mut seen = 0;
    for planes in [
        "--near=-1e7 --far 1e7",
        "--near 0 --far 1e7",
        "--near 0 --far 1e8",
        "--near=-1e9 --far 1e9",
        "--near=-1e20 --far 1e20",
    ] {
        seen += cannot_be_held(None, &format!("--size 320x240 --ortho 6 {planes}"));
    }
    assert!(seen > 0, "no pixel is of class depth");
}

#[test]
fn a_telescope_with_planes_from_the_eye_on() {
    let view = "--size 320x240 --eye 60000000,48000000,100000000 --target 0,0.7,0 --fov 0.000002 --near 1 --far 200000000";
    cannot_be_held(None, view);
}

/// A rug lies in the plane of a floor. From any height, even at a grazing angle, drawing may show either.
#[test]
fn a_rug_on_a_floor_at_a_glance() {
    let objects = [("floor", 4, 0), ("rug", 2, 30)].map(|(name, scale, turn)| {
        format!("[[object]]\nname = \"{name}\"\nshape = \"square\"\nscale = {scale}\nrotation = [-90, {turn}, 0]\n")
    });
    let [floor, rug] = &objects;
    for toml in [format!("{floor}{rug}"), format!("{rug}{floor}")] {
        let (_folder, file) = scene(&toml);
        for height in ["0.02", "0.05", "0.1", "0.5"] {
            let view = format!("--size 320x240 --eye 0.5,{height},3 --target 0,0,0");
            let counts = Counts::of(run(Some(&file), &view));
            assert_eq!(counts.code, Some(0), "{height}: {}", counts.line);
            assert!(
                counts.get("in_one_place") > 100,
                "{height}: {}",
                counts.line
            );
        }
    }
}

/// Nothing is unexplained where no usable bound exists: a square that `f64` cannot tell from the near plane, a face too
/// large, a sphere too flat.
#[test]
fn numbers_that_no_bound_holds() {
    let hair = r#"
[[object]]
shape = "square"
position = [0, 0, 5.551115123125783e-17]
[[object]]
shape = "cube"
position = [2, 0, -1]
"#;
    let huge = r#"
[[object]]
shape = "square"
scale = SCALE
rotation = [70, 20, 10]
position = [0.1, 0.2, 0.3]
[[object]]
shape = "cube"
"#;
    let flat = r#"
[[object]]
shape = "square"
position = [0, 0, -0.25]
[[object]]
shape = "sphere"
scale = [1, 1, SCALE]
"#;
    let cases = [
        (
            hair,
            "1",
            "--eye 0,0,1 --look 0,0,-1 --fov 60 --near 1 --far 2 --size 40x30",
        ),
        (
            hair,
            "1",
            "--eye 0,0,1 --look 0,0,-1 --fov 60 --near 1 --far 5 --size 40x30",
        ),
        (
            hair,
            "1",
            "--eye 0,0,0 --look 0,0,-1 --ortho 2 --near 0 --far 1 --size 40x30",
        ),
        (
            huge,
            "1e16",
            "--eye 1,2,3 --target 0,0,0 --fov 40 --near 0.1 --far 100 --size 64x48",
        ),
        (
            huge,
            "1e20",
            "--eye 1,2,3 --target 0,0,0 --fov 40 --near 0.1 --far 100 --size 64x48",
        ),
        (
            huge,
            "1e30",
            "--eye 1,2,3 --target 0,0,0 --fov 40 --near 0.1 --far 100 --size 64x48",
        ),
        (
            flat,
            "1e-30",
            "--eye 0.1,0.3,3 --target 0,0,0 --fov 40 --size 64x48",
        ),
        (
            flat,
            "1e-32",
            "--eye 0.1,0.3,3 --target 0,0,0 --fov 40 --size 64x48",
        ),
        (
            flat,
            "1e-33",
            "--eye 0.1,0.3,3 --target 0,0,0 --fov 40 --size 64x48",
        ),
    ];
    for (toml, scale, view) in cases {
        let (_folder, file) = scene(&toml.replace("SCALE", scale));
        let counts = Counts::of(run(Some(&file), view));
        assert_eq!(
            counts.get("unexplained"),
            0,
            "{scale} {view}: {}",
            counts.line
        );
        let shown = counts.get("picked") + counts.get("drawn");
        assert!(shown > 100, "{scale} {view}: {}", counts.line);
    }
}

/// The eye is as near to a sphere as `f32` can tell, so drawing may find a point behind the eye.
#[test]
fn an_eye_at_a_sphere() {
    let (_folder, file) = scene("[[object]]\nshape = \"sphere\"\n");
    for view in [
        "--eye=0,0,0.4999999907223457 --look=-0.3277,-0.9447,0 --up=0.6653,0.3142,-0.6772 \
         --fov 90 --cull",
        "--eye=0,0,0.5000000008798282 --look=-0.997523766847411,0.07033018252892506,1 \
         --up=0.6191185368453906,0.7634907927806005,0.1837771658114057 --fov 90",
        "--eye=0,0,0.5000000000036953 --look=-0.2126052844296056,0.977138164761057,1 \
         --up=0.6573975317088843,0.7528656431097823,0.0319657430378217 --fov 90 \
         --near 1.1120454778045945e-12 --far 1.4486109947380254",
    ] {
        for depth in ["reversed", "standard"] {
            let counts = Counts::of(run(
                Some(&file),
                &format!("--size 64x48 --depth {depth} {view}"),
            ));
            assert_eq!(counts.get("unexplained"), 0, "{view}: {}", counts.line);
            let shown = counts.get("drawn") + counts.get("picked");
            assert!(shown > 0, "{view}: {}", counts.line);
        }
    }
}

/// The poster and its wall are zero apart, so however far off standard depth is, the view is not beyond `f32`.
#[test]
fn a_poster_in_the_plane_of_its_wall() {
    let toml = "[[object]]\nshape = \"square\"\nscale = 6\n[[object]]\nshape = \"square\"\nposition = [0.5, 0.2, 0]\nrotation = [0, 0, 20]\n";
    let (_folder, file) = scene(toml);
    for depth in ["reversed", "standard"] {
        let view = format!(
            "--eye 0.1,0.2,3 --target 0,0,0 --fov 60 --near 0.01 --far 100 --size 160x120 --depth {depth}"
        );
        let counts = Counts::of(run(Some(&file), &view));
        assert_eq!(counts.code, Some(0), "{depth}: {}", counts.line);
        assert!(counts.get("in_one_place") > 100, "{depth}: {}", counts.line);
    }
}
