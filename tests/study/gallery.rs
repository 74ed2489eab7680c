//! Each scene of the gallery breaks the methods that it is listed for, and never Sightline's.

use sightline::{
    camera::{View, Viewport},
    geometry::Sides,
    scene::{self, Loaded, Progress, gallery::GALLERY},
    study::{
        self, Effort, Row, SCENE, SceneRays,
        breaks::{self, BREAKS, Break, breaks_on},
        methods::{Visitor, each_step},
        step::{
            Case,
            Precision::{F32, F64},
        },
    },
};
use std::{
    cell::Cell,
    path::{Path, PathBuf},
};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/gallery")
}

/// The view of a scene through its own camera.
pub fn view_of(loaded: &Loaded, width: u32, height: u32) -> View {
    let viewport = Viewport::new(width, height).expect("a picture");
    let camera = loaded
        .camera
        .resolve(&loaded.scene.visible_bounds(), viewport)
        .expect("a camera");
    View {
        camera,
        viewport,
        sides: Sides::Both,
        section: None,
    }
}

/// What the window charts beside a scene.
fn rows_of(broken: &Break, loaded: &Loaded) -> Vec<Row> {
    let view = view_of(loaded, 801, 600);
    breaks::rows(broken, &loaded.scene, view, &|| true).expect("nobody stops it")
}

/// Every method of every step on a scene's own rays.
pub fn rows_on(rays: &SceneRays) -> Vec<Row> {
    struct OnScene<'a>(&'a SceneRays, Vec<Row>);
    impl Visitor for OnScene<'_> {
        fn visit<C: Case>(&mut self) {
            let rows = study::family::<C>(SCENE, Effort::QUICK, Some(self.0), &|| true);
            self.1.extend(rows.expect("nobody stops it"));
        }
    }
    let mut on = OnScene(rays, Vec::new());
    each_step(&mut on);
    on.1
}

fn study_of(scene: &str) -> Vec<Row> {
    let path = format!("gallery:{scene}").into();
    let loaded = scene::load(&[path], &Progress::default()).expect("a scene");
    let view = view_of(&loaded, 321, 180);
    let rays = SceneRays::new(&loaded.scene, view, 1500, 1);
    rows_on(&rays)
}

#[test]
fn each_scene_breaks_its_method_and_not_ours() {
    let mut failed: Vec<String> = Vec::new();
    for broken in &BREAKS {
        let rows = study_of(broken.exhibit);
        let row = |wanted: &dyn Fn(&Row) -> bool| {
            let mut rows = rows
                .iter()
                .filter(|row| row.info.step == broken.step.about && row.family == SCENE);
            *rows.find(|row| wanted(row)).expect("a row")
        };
        let scene = broken.exhibit;
        let bad = row(&|row| row.info.key() == (broken.method, broken.precision));
        let wrong = if bad.wrong() > 0 {
            bad.wrong_percent()
        } else {
            bad.worst_error
        };
        if wrong < broken.least {
            failed.push(format!("{scene}: {bad:?}"));
        }
        let ours = row(&|row| row.info.ours);
        if ours.wrong_percent() > 0.0 {
            failed.push(format!("{scene}: {ours:?}"));
        }
        assert!(
            ours.of_bound.is_some_and(|share| share <= 1.0),
            "{scene}: {ours:?}"
        );
    }
    assert!(failed.is_empty(), "{failed:#?}");
}

#[test]
fn every_scene_of_the_folder_is_in_the_gallery_and_breaks_something() {
    let mut files: Vec<String> = std::fs::read_dir(folder())
        .expect("the gallery")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| {
            path.extension()
                .is_some_and(|extension| extension == "toml")
        })
        .map(|path| {
            path.file_stem()
                .expect("a name")
                .to_string_lossy()
                .into_owned()
        })
        .collect();
    files.sort();
    let mut names: Vec<&str> = GALLERY.iter().map(|exhibit| exhibit.name).collect();
    names.sort_unstable();
    assert_eq!(files, names);
    for name in names {
        assert!(breaks_on(name).count() > 0, "{name} breaks nothing");
    }
    for broken in &BREAKS {
        assert!(broken.swap().is_some(), "no such method: {broken:?}");
        let effort = Effort {
            cases: 1,
            ..Effort::QUICK
        };
        let families = (broken.step.rows)(broken.family, effort, None, &|| true);
        let families = families.expect("nobody stops it");
        assert!(families.len() > 1, "no such family: {broken:?}");
        assert!(names_contain(broken.exhibit), "no such scene: {broken:?}");
    }
}

fn names_contain(name: &str) -> bool {
    GALLERY.iter().any(|exhibit| exhibit.name == name)
}

/// The scenes built into the program equal the files.
#[test]
fn the_gallery_opens_as_its_files_do() {
    for exhibit in &GALLERY {
        let load = |path| scene::load(&[path], &Progress::default()).expect("a scene");
        let file = folder().join(exhibit.name).with_extension("toml");
        let (own, file) = (load(exhibit.path()), load(file));
        assert_eq!(own.camera, file.camera);
        let objects = |loaded: &scene::Loaded| {
            let objects = loaded.scene.objects().iter();
            let known = objects.map(|o| (o.name.clone(), o.placement.model(), o.bounds_world()));
            known.collect::<Vec<_>>()
        };
        assert_eq!(objects(&own), objects(&file), "{}", exhibit.name);
        assert_eq!(own.exhibit, Some(exhibit));
        assert_eq!(file.exhibit, None);
    }
    let error = scene::load(&["gallery:nothing".into()], &Progress::default());
    let said = error.expect_err("no such scene").to_string();
    assert!(said.contains("needles"), "{said}");
}

/// Who leaves a scene of the gallery waits for no more of its chart than what is under way.
#[test]
fn a_chart_that_nobody_wants_any_more_ends() {
    let broken = &BREAKS[0];
    let path = format!("gallery:{}", broken.exhibit).into();
    let loaded = scene::load(&[path], &Progress::default()).expect("a scene");
    let asked = Cell::new(0);
    let go_on = || asked.replace(asked.get() + 1) < 1;
    let rows = breaks::rows(broken, &loaded.scene, view_of(&loaded, 801, 600), &go_on);
    assert!(rows.is_none() && asked.get() == 2, "{asked:?}");
}

/// The chart beside a scene fits it: the curve, in the view's pixels, passes near the figure of the scene's own rays.
#[test]
fn the_chart_matches_the_picture() {
    let mut failed = Vec::new();
    for broken in &BREAKS {
        let path = format!("gallery:{}", broken.exhibit).into();
        let loaded = scene::load(&[path], &Progress::default()).expect("a scene");
        let rows = rows_of(broken, &loaded);
        let own = rows
            .iter()
            .filter(|row| row.info.key() == (broken.method, broken.precision));
        let (here, family): (Vec<&Row>, Vec<&Row>) = own.partition(|row| row.family == SCENE);
        // The family's figures just before and after the scene's value bound it, with slack because a worst case
        // varies.
        let figure = |row: &Row| {
            if row.wrong() > 0 {
                row.worst_wrong
            } else {
                row.worst_error
            }
        };
        let side = |before: bool| {
            let rows = family
                .iter()
                .filter(|row| (row.value <= broken.value) == before);
            rows.min_by(|a, b| {
                (a.value / broken.value)
                    .ln()
                    .abs()
                    .total_cmp(&(b.value / broken.value).ln().abs())
            })
        };
        let near: Vec<f64> = [true, false]
            .into_iter()
            .filter_map(side)
            .map(|row| figure(row))
            .collect();
        assert!(!near.is_empty(), "{broken:?}");
        let [low, high] =
            [f64::min, f64::max].map(|of| near.iter().copied().reduce(of).expect("one"));
        // A method that fails completely in the family need not fail on the scene. In the depth step, the family's
        // depths reach the far plane; the scene's do not reach half of it.
        let low = if broken.step.about.key == "depth" {
            0.0
        } else {
            low.min(100.0)
        };
        let found = figure(here[0]);
        if !(low / 30.0 <= found && found <= 30.0 * high) {
            failed.push(format!("{}: {found} and {near:?}", broken.exhibit));
        }
        // The scene's own rays show an error, too.
        assert!(here[0].wrong() > 0 || found > 0.0, "{broken:?}");
    }
    assert!(failed.is_empty(), "{failed:#?}");
}

/// The plain quadratic in `f64` is among the methods as good as Sightline's; the broken method is not.
#[test]
fn others_that_are_as_good_are_named() {
    let mut named = 0;
    for broken in &BREAKS {
        let path = format!("gallery:{}", broken.exhibit).into();
        let loaded = scene::load(&[path], &Progress::default()).expect("a scene");
        let rows = rows_of(broken, &loaded);
        let good: Vec<_> = breaks::as_good(&rows).map(|row| row.info.key()).collect();
        assert!(
            !good.contains(&(broken.method, broken.precision)),
            "{broken:?}: {good:?}"
        );
        if broken.exhibit == "small_and_far" {
            assert!(
                good.contains(&("plain quadratic", F64)) && good.contains(&("Hearn & Baker", F32)),
                "{good:?}"
            );
            named += 1;
        }
    }
    assert_eq!(named, 1, "the scene is among them");
}

/// With an orthographic lens, steps still have cases, methods break as they do in perspective, and bounds hold.
#[test]
fn parallel_rays_are_studied_too() {
    for (name, far) in [
        ("far_from_the_origin", true),
        ("far_over_near", false),
        ("stretched", false),
    ] {
        let path = format!("gallery:{name}").into();
        let mut loaded = scene::load(&[path], &Progress::default()).expect("a scene");
        let height = loaded.scene.visible_bounds().radius();
        (loaded.camera.fov, loaded.camera.ortho) = (None, Some(height));
        let rays = SceneRays::new(&loaded.scene, view_of(&loaded, 321, 180), 600, 1);
        let all = rows_on(&rays);
        let rows = |step: &str| {
            let rows = all.iter().filter(|row| row.info.step.key == step);
            rows.copied().collect::<Vec<Row>>()
        };
        for step in ["ray", "depth", "pick", "clip", "normal", "object-space"] {
            let ours: Vec<Row> = rows(step).into_iter().filter(|row| row.info.ours).collect();
            let [ours] = ours.as_slice() else {
                panic!("{name}: {step}")
            };
            assert!(ours.cases > 100, "{name}: {ours:?}");
            assert_eq!(ours.wrong_percent(), 0.0, "{name}: {ours:?}");
            assert!(
                ours.of_bound.is_some_and(|share| share <= 1.0),
                "{name}: {ours:?}"
            );
            assert!(ours.worst_error < 1e-3, "{name}: {ours:?}");
        }
        let worst = |method: &str, precision| {
            let mut rays = rows("ray").into_iter();
            let row = rays.find(|row| row.info.key() == (method, precision));
            row.expect("a row").worst_error
        };
        // Far from the origin, methods that hold a world point in f32 lose it; in f64 they do not.
        for method in [
            "eye basis",
            "target + sx H + sy V - eye",
            "inverse(P V), near - eye",
        ] {
            assert_eq!(
                worst(method, F32) > 1.0,
                far,
                "{name}: {method}: {}",
                worst(method, F32)
            );
            assert!(
                worst(method, F64) < 1e-3,
                "{name}: {method}: {}",
                worst(method, F64)
            );
        }
    }
}
