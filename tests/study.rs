//! The study: truth is right on cases that hands can do, methods break where they are known to, what this program does
//! stays within its derived bounds, and the same seed says the same.
#![allow(clippy::float_cmp, reason = "what is exact is compared exactly")]

use glam::DVec3;
use sightline::study::{
    self, COLUMNS, Effort, Report, Row,
    exact::{Exact, Exact3, angle},
    methods::{
        boxes::RayBox,
        clipping::Clip,
        object_space::Placed,
        planes::RayPlane,
        rays::PixelCase,
        registry,
        spheres::RaySphere,
        triangles::{RayTriangle, SIGHTLINES_PRECISION, TriangleCase},
    },
    random::Random,
    real::{M3, V3},
    step::{Case, Precision},
    truth,
};
use std::{cmp::Ordering, collections::HashSet, sync::OnceLock};

/// One run that many tests read.
fn report() -> &'static Report {
    static REPORT: OnceLock<Report> = OnceLock::new();
    REPORT.get_or_init(|| {
        let effort = Effort {
            cases: 250,
            picks: 40,
            rounds: 0,
            seed: 1,
        };
        study::run(effort, None, &|_, _| {})
    })
}

/// A method's rows in a family, by the parameter's value.
fn rows(step: &str, method: &str, precision: Precision, family: &str) -> Vec<&'static Row> {
    let wanted = |row: &&Row| {
        (row.step.key, row.method, row.precision) == (step, method, precision)
            && row.family == family
    };
    let rows: Vec<_> = report().rows.iter().filter(wanted).collect();
    assert!(!rows.is_empty(), "{method} {precision} has no {family}");
    rows
}

fn row(step: &str, method: &str, precision: Precision, family: &str, value: f64) -> &'static Row {
    let rows = rows(step, method, precision, family);
    rows.into_iter()
        .find(|row| row.value == value)
        .expect("a row of that value")
}

const fn v(x: f64, y: f64, z: f64) -> V3<f64> {
    V3::new(x, y, z)
}

#[test]
fn registry_names_each_method_once_and_where_it_is_from() {
    let methods = registry();
    let names: HashSet<_> = methods
        .iter()
        .map(|m| (m.step.key, m.name, m.precision))
        .collect();
    assert_eq!(names.len(), methods.len(), "two methods of one name");
    assert!(
        methods.iter().all(|method| method.source.len() > 10),
        "a source for each"
    );
    let steps: HashSet<_> = methods.iter().map(|method| method.step.key).collect();
    for step in steps {
        let ours = methods
            .iter()
            .filter(|method| method.step.key == step && method.ours)
            .count();
        assert_eq!(ours, 1, "{step} has one method of ours");
    }
}

#[test]
fn exact_numbers_keep_every_bit() {
    let [large, small] = [1e300, 1e-300].map(Exact::new);
    assert_eq!((&(&large + &small) - &large), small, "600 decimals apart");
    let third = &Exact::int(1) / &Exact::int(3);
    let off = (&(&third * &Exact::int(3)) - &Exact::int(1)).abs();
    assert!(
        off.to_f64() < 1e-90 && !off.is_zero(),
        "320 bits, not more: {off:?}"
    );
    let two = Exact::int(2).sqrt();
    assert!((&(&two * &two) - &Exact::int(2)).abs().to_f64() < 1e-90);
    assert_eq!((-Exact::new(0.1)).sign(), Ordering::Less);
    assert_eq!(Exact::new(0.1).to_f64(), 0.1);
    let x = Exact3::new(v(1.0, 0.0, 0.0));
    assert_eq!(angle(&x, [1.0, 1e-20, 0.0]), 1e-20, "where f64 would say 0");
    assert_eq!(angle(&x, [-1.0, 0.0, 0.0]), std::f64::consts::PI);
    assert_eq!(angle(&x, [f64::NAN, 0.0, 0.0]), f64::INFINITY);
}

#[test]
fn truth_agrees_with_hand_cases() {
    let corners = [v(0.0, 0.0, 5.0), v(1.0, 0.0, 5.0), v(0.0, 1.0, 5.0)];
    let triangle = |x: f64, y: f64| {
        let ray = RayTriangle {
            origin: v(x, y, 0.0),
            direction: v(0.0, 0.0, 2.0),
            corners,
        };
        truth::triangles::truth(&ray)
    };
    assert_eq!(triangle(0.25, 0.25).t, Some(2.5));
    assert_eq!(triangle(0.5, 0.5).t, Some(2.5), "an edge belongs to it");
    assert_eq!(triangle(0.0, 0.0).t, Some(2.5), "a corner, too");
    let outside = triangle(0.25, -1e-12);
    assert_eq!(outside.t, None);
    assert!(
        (outside.edge_angle / 2e-13 - 1.0).abs() < 1e-9,
        "{outside:?}"
    );

    let sphere = |y: f64| {
        let ray = RaySphere {
            origin: v(0.0, y, -4.0),
            direction: v(0.0, 0.0, 1.0),
            center: v(0.0, 0.0, 0.0),
            radius: 1.0,
        };
        truth::spheres::truth(&ray)
    };
    assert_eq!(sphere(0.0).t, Some(3.0));
    assert_eq!(sphere(1.0).t, Some(4.0), "a touch is a hit");
    assert_eq!(sphere(1.0_f64.next_up()).t, None);

    let cube = |origin: V3<f64>, direction: V3<f64>| {
        let ray = RayBox {
            origin,
            direction,
            min: v(-1.0, -1.0, -1.0),
            max: v(1.0, 1.0, 1.0),
        };
        truth::boxes::truth(&ray).t
    };
    assert_eq!(cube(v(-3.0, 0.0, 0.0), v(2.0, 0.0, 0.0)), Some(1.0));
    assert_eq!(
        cube(v(0.0, 0.0, 0.0), v(2.0, 0.0, 0.0)),
        Some(0.5),
        "from inside: the exit"
    );
    assert_eq!(
        cube(v(1.0, -3.0, 0.0), v(0.0, 1.0, 0.0)),
        Some(2.0),
        "within a face"
    );
    assert_eq!(
        cube(v(1.0_f64.next_up(), -3.0, 0.0), v(0.0, 1.0, 0.0)),
        None
    );
    assert_eq!(
        cube(v(-3.0, -1.0, 0.0), v(1.0, 1.0, 0.0)),
        Some(2.0),
        "from below onto a face"
    );
    assert_eq!(cube(v(-3.0, 1.0, 0.0), v(1.0, 1.0, 0.0)), None);

    let plane = RayPlane {
        origin: v(0.0, 0.0, 0.0),
        direction: v(0.0, 1.0, 1.0),
        point: v(7.0, 3.0, 0.0),
        normal: v(0.0, 2.0, 0.0),
        distance: 6.0,
    };
    assert_eq!(truth::planes::truth(&plane), 3.0);

    let clip = |t: f64| {
        let hit = Clip {
            t,
            direction: v(0.6, 0.0, 0.8),
            forward: v(0.0, 0.0, 1.0),
            near: 0.8,
            far: 8.0,
        };
        truth::clipping::truth(&hit).inside
    };
    assert_eq!(
        [1.0, 1.0_f64.next_down(), 10.0, 10.0_f64.next_down()].map(clip),
        [true, false, false, true]
    );

    // An object moved by (0, 0, 5) and doubled: its ray comes back onto the world's, or one unit of space beside it.
    let twice = M3([v(2.0, 0.0, 0.0), v(0.0, 2.0, 0.0), v(0.0, 0.0, 2.0)]);
    let placed = Placed {
        linear: twice,
        translation: v(0.0, 0.0, 5.0),
        origin: v(0.0, 0.0, 0.0),
        direction: v(0.0, 0.0, 1.0),
    };
    let aside = |x: f64| truth::object_space::aside(&placed, &[v(x, 0.0, -2.5), v(0.0, 0.0, 0.5)]);
    assert_eq!([aside(0.0), aside(0.5)], [0.0, 0.2]);
}

#[test]
fn same_seed_gives_the_same_verdicts() {
    let effort = Effort {
        cases: 12,
        picks: 4,
        rounds: 0,
        seed: 9,
    };
    let csv = |seed| study::csv(&study::run(Effort { seed, ..effort }, None, &|_, _| {}));
    let first = csv(9);
    assert_eq!(first, csv(9));
    assert_ne!(first, csv(10));
}

#[test]
fn random_numbers_are_the_same_everywhere() {
    // Known by heart: a change of the generator changes every workload.
    let mut random = Random::named(1, &["triangle", "ordinary"]);
    let numbers: [i32; 4] = std::array::from_fn(|_| random.integer(0, 999));
    assert_eq!(numbers, [51, 621, 584, 805]);
}

#[test]
fn what_this_program_does_stays_within_its_bounds() {
    for row in report().rows.iter().filter(|row| row.ours) {
        let share = row.of_bound.expect("a bound");
        assert!(
            share <= 1.0,
            "{} {} {}: {share} of the bound",
            row.step.key,
            row.family,
            row.value
        );
    }
}

#[test]
fn what_this_program_does_decides_right() {
    for row in report().rows.iter().filter(|row| row.ours) {
        // Only exact arithmetic tells where a ray that runs exactly through an edge belongs; by any distance, however
        // small, nothing may be wrong.
        let ties = match row.step.key {
            "box" => true,
            "triangle" => {
                SIGHTLINES_PRECISION != Precision::Exact && row.family == "exactly through edges"
            }
            _ => false,
        };
        assert_eq!(
            row.worst_wrong, 0.0,
            "{} {} {}",
            row.step.key, row.family, row.value
        );
        if !ties {
            assert_eq!(
                row.wrong_percent(),
                0.0,
                "{} {} {}",
                row.step.key,
                row.family,
                row.value
            );
        }
    }
}

mod known_break_points {
    use super::*;
    use Precision::{F32, F64};

    #[test]
    fn unsigned_areas_lose_ordinary_hits() {
        for precision in [F32, F64] {
            let row = row("triangle", "areas, sum == 1", precision, "ordinary", 1.0);
            // An eighth of the rays hit.
            assert!(row.missed * 50 > row.cases, "{row:?}");
        }
    }

    #[test]
    fn moeller_trumbore_in_f32_errs_on_grazing_rays_and_slivers() {
        for (family, value) in [("grazing", 1e-6), ("slivers", 1e-7)] {
            let bad = row("triangle", "Moeller-Trumbore", F32, family, value);
            assert!(bad.wrong_percent() > 2.0, "{bad:?}");
            let good = row("triangle", "Moeller-Trumbore", F64, family, value);
            assert_eq!(good.wrong_percent(), 0.0, "{good:?}");
        }
    }

    #[test]
    fn an_epsilon_loses_small_triangles() {
        let row = row(
            "triangle",
            "Moeller-Trumbore, eps 1e-6",
            F64,
            "tiny and huge",
            1e-6,
        );
        assert!(row.missed * 4 > row.cases, "{row:?}");
    }

    #[test]
    fn only_exact_arithmetic_decides_lattice_ties() {
        let row = row(
            "triangle",
            "Moeller-Trumbore",
            F64,
            "exactly through edges",
            22.0,
        );
        assert!(row.wrong_percent() > 5.0, "{row:?}");
        assert_eq!(row.worst_wrong, 0.0, "{row:?}");
    }

    #[test]
    fn baldwin_weber_in_f32_errs_far_from_the_origin() {
        let bad = row("triangle", "Baldwin-Weber", F32, "far from the origin", 1e6);
        assert!(bad.worst_wrong > 0.5, "{bad:?}");
        let woop = rows("triangle", "Woop watertight", F32, "far from the origin");
        assert!(woop.iter().all(|row| row.worst_wrong < 1e-3), "{woop:?}");
    }

    #[test]
    fn plain_spheres_in_f32_err_far_away() {
        let bad = row("sphere", "plain quadratic", F32, "far away", 1e3);
        assert!(
            bad.wrong_percent() > 0.5 && bad.worst_wrong > 1e-3,
            "{bad:?}"
        );
        let good = row("sphere", "Hearn & Baker", F32, "far away", 1e3);
        assert!(good.worst_wrong < 1e-3, "{good:?}");
    }

    #[test]
    fn spheres_with_the_direction_taken_as_1_long_need_it_so() {
        let row = row(
            "sphere",
            "plain, direction taken as 1 long",
            F64,
            "direction of another length",
            1e-2,
        );
        assert!(row.wrong_percent() > 30.0, "{row:?}");
    }

    #[test]
    fn min_and_max_lose_boxes_from_a_slab() {
        for precision in [F32, F64] {
            let bad = row(
                "box",
                "slabs by min and max",
                precision,
                "starts on a slab",
                1.0,
            );
            assert!(bad.wrong_percent() > 20.0, "{bad:?}");
            let good = row(
                "box",
                "slabs with a branch",
                precision,
                "starts on a slab",
                1.0,
            );
            assert_eq!(good.wrong_percent(), 0.0, "{good:?}");
        }
    }

    #[test]
    fn padded_boxes_lose_nothing() {
        for (method, precision) in [("padded, to cull", F32), ("Sightline's tree, to cull", F64)] {
            let found = report()
                .rows
                .iter()
                .filter(|row| (row.method, row.precision) == (method, precision));
            assert_eq!(found.map(|row| row.missed).sum::<usize>(), 0, "{method}");
        }
    }

    #[test]
    fn unprojecting_in_f32_fails_at_large_far_over_near() {
        let bad = row("ray", "inverse(P V), far - near", F32, "far plane", 1e9);
        assert_eq!(bad.worst_error, f64::INFINITY, "{bad:?}");
        let far_out = row(
            "ray",
            "inverse(P V), near - eye",
            F32,
            "eye far from the origin",
            1e4,
        );
        assert!(far_out.worst_error > 10.0, "{far_out:?}");
        let basis = rows("ray", "eye basis", F32, "eye far from the origin");
        assert!(basis.iter().all(|row| row.worst_error < 1e-2), "{basis:?}");
    }

    #[test]
    fn the_courses_ray_loses_digits_to_the_eye() {
        let bad = row(
            "ray",
            "target + sx H + sy V - eye",
            F32,
            "eye far from the origin",
            1e6,
        );
        assert!(bad.worst_error > 1.0, "{bad:?}");
    }

    #[test]
    fn a_normal_is_no_direction() {
        let bad = row("normal", "M n", F64, "stretched", 10.0);
        assert!(bad.worst_error > 30.0, "{bad:?}");
        let turned = row("normal", "cofactors", F64, "mirrored", 2.0);
        assert!(turned.worst_error > 179.0, "{turned:?}");
        let good = row("normal", "inverse transpose", F64, "mirrored", 2.0);
        assert!(good.worst_error < 1e-10, "{good:?}");
    }

    #[test]
    fn inverse_matrices_in_f32_forget_where_objects_stand() {
        let bad = row(
            "object-space",
            "inverse(M)",
            F32,
            "far from the origin",
            1e5,
        );
        assert!(bad.worst_error > 1.0, "{bad:?}");
        let good = row(
            "object-space",
            "inverse(A) (o - T)",
            F32,
            "far from the origin",
            1e5,
        );
        assert!(good.worst_error < 1e-2, "{good:?}");
    }

    #[test]
    fn clipping_by_distance_loses_corners() {
        let bad = row("clip", "by distance", F64, "field of view", 1.0);
        assert!(
            bad.wrong_percent() > 5.0 && bad.worst_wrong > 0.1,
            "{bad:?}"
        );
    }

    #[test]
    fn standard_depth_is_used_up_at_once() {
        let bad = row("depth", "standard, 32-bit float", F32, "far plane", 1e6);
        assert!(bad.worst_error > 1e-2, "{bad:?}");
        let good = rows(
            "depth",
            "reversed, 32-bit float: Sightline's",
            F32,
            "far plane",
        );
        assert!(good.iter().all(|row| row.worst_error < 1e-6), "{good:?}");
    }

    #[test]
    fn the_courses_pick_is_lost_far_from_the_origin() {
        let bad = row("pick", "the course's", F32, "a ball of 5120 triangles", 1e5);
        assert!(bad.wrong_percent() > 5.0, "{bad:?}");
    }
}

#[test]
fn csv_parses_back() {
    let text = study::csv(report());
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some(COLUMNS.join(",").as_str()));
    let mut count = 0;
    for (line, row) in lines.zip(&report().rows) {
        let cells = cells(line);
        assert_eq!(cells.len(), COLUMNS.len(), "{line}");
        assert_eq!(
            (cells[0].as_str(), cells[1].as_str()),
            (row.step.key, row.method)
        );
        assert_eq!(cells[6].parse(), Ok(row.value), "{line}");
        assert_eq!(cells[8].parse(), Ok(row.missed), "{line}");
        let error: f64 = cells[15].parse().expect("a number");
        assert!(
            error == row.worst_error || (error / row.worst_error - 1.0).abs() < 0.06,
            "{line}"
        );
        count += 1;
    }
    assert_eq!(count, report().rows.len());
}

/// RFC 4180.
fn cells(line: &str) -> Vec<String> {
    let mut cells = vec![String::new()];
    let mut quoted = false;
    for c in line.chars() {
        match c {
            '"' => quoted = !quoted,
            ',' if !quoted => cells.push(String::new()),
            c => cells.last_mut().expect("one at least").push(c),
        }
    }
    cells
}

#[test]
fn table_names_every_method() {
    let table = study::table(report());
    for method in registry() {
        assert!(
            table.contains(method.name),
            "{} is not in\n{table}",
            method.name
        );
    }
}

#[test]
fn cases_are_the_same_numbers_for_both_precisions() {
    fn check<C: Case>(narrow: impl Fn(&C) -> V3<f64>, wide: impl Fn(&C) -> V3<f64>) {
        for family in C::families() {
            for &value in family.values {
                let mut random = Random::named(3, &[family.name]);
                let case = (family.make)(&mut random, value);
                assert_eq!(
                    DVec3::from(narrow(&case)),
                    DVec3::from(wide(&case)),
                    "{} {value}",
                    family.name
                );
            }
        }
    }
    check::<TriangleCase>(|c| c.narrow.corners[0].wide(), |c| c.wide.corners[0]);
    check::<TriangleCase>(|c| c.narrow.direction.wide(), |c| c.wide.direction);
    check::<PixelCase>(|c| c.narrow.eye.wide(), |c| c.wide.eye);
}

mod gallery {
    use super::*;
    use sightline::{
        camera::{View, Viewport},
        geometry::Sides,
        scene::{self, Progress},
        study::{SCENE, SceneRays},
    };
    use std::path::{Path, PathBuf};

    /// Which method breaks on which scene: the step, the method, its precision, and the least that goes wrong, in per
    /// cent of decisions for steps that make them and in the step's unit for those that give values.
    const BREAKS: [(&str, &str, &str, Precision, f64); 12] = [
        (
            "far_from_the_origin",
            "ray",
            "target + sx H + sy V - eye",
            Precision::F32,
            1.0,
        ),
        (
            "far_from_the_origin",
            "ray",
            "inverse(P V), near - eye",
            Precision::F32,
            10.0,
        ),
        (
            "far_from_the_origin",
            "object-space",
            "inverse(M)",
            Precision::F32,
            1.0,
        ),
        (
            "far_over_near",
            "ray",
            "inverse(P V), far - near",
            Precision::F32,
            f64::INFINITY,
        ),
        (
            "far_over_near",
            "depth",
            "standard, 32-bit float",
            Precision::F32,
            1e-4,
        ),
        (
            "small_and_far",
            "sphere",
            "plain quadratic",
            Precision::F32,
            0.2,
        ),
        ("stretched", "normal", "M n", Precision::F64, 60.0),
        ("mirrored", "normal", "cofactors", Precision::F64, 179.0),
        ("wide_lens", "clip", "by distance", Precision::F64, 50.0),
        (
            "along_a_face",
            "box",
            "slabs by min and max",
            Precision::F64,
            0.1,
        ),
        ("edge_on", "plane", "N . (S - o)", Precision::F32, 1e-4),
        (
            "needles",
            "triangle",
            "areas, sum == 1",
            Precision::F32,
            5.0,
        ),
    ];

    fn folder() -> PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/gallery")
    }

    fn study_of(scene: &str) -> Report {
        let path = folder().join(scene).with_extension("toml");
        let loaded = scene::load(&[path], &Progress::default()).expect("a scene");
        let viewport = Viewport::new(321, 180).expect("a picture");
        let camera = loaded
            .camera
            .resolve(&loaded.scene.visible_bounds(), viewport)
            .expect("a camera");
        let view = View {
            camera,
            viewport,
            sides: Sides::Both,
        };
        let rays = SceneRays::new(&loaded.scene, view, 1500, 1);
        study::run(
            Effort {
                rounds: 0,
                ..Effort::SCENE_ONLY
            },
            Some(&rays),
            &|_, _| {},
        )
    }

    #[test]
    fn each_scene_breaks_its_method_and_not_ours() {
        let mut failed: Vec<String> = Vec::new();
        for (scene, step, method, precision, least) in BREAKS {
            let report = study_of(scene);
            let row = |wanted: &dyn Fn(&Row) -> bool| {
                let mut rows = report
                    .rows
                    .iter()
                    .filter(|row| row.step.key == step && row.family == SCENE);
                *rows.find(|row| wanted(row)).expect("a row")
            };
            let bad = row(&|row| (row.method, row.precision) == (method, precision));
            let decides = !bad.step.wrong_unit.is_empty();
            let broken = if decides {
                bad.wrong_percent()
            } else {
                bad.worst_error
            };
            if broken < least {
                failed.push(format!("{scene}: {bad:?}"));
            }
            let ours = row(&|row| row.ours);
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
    fn every_scene_is_tested() {
        for entry in std::fs::read_dir(folder()).expect("the gallery") {
            let path = entry.expect("an entry").path();
            let name = path
                .file_stem()
                .expect("a name")
                .to_string_lossy()
                .into_owned();
            let toml = path
                .extension()
                .is_some_and(|extension| extension == "toml");
            assert!(
                !toml || BREAKS.iter().any(|(scene, ..)| *scene == name),
                "{name} is in no test"
            );
        }
    }

    #[test]
    fn a_budget_names_each_step_and_its_bounds() {
        let path = folder().join("far_from_the_origin.toml");
        let run = std::process::Command::new(env!("CARGO_BIN_EXE_sightline"))
            .args(["study", "--budget", "0.05"])
            .arg(path)
            .output()
            .expect("the program");
        assert!(run.status.success());
        let page = String::from_utf8(run.stdout).expect("text");
        for words in [
            "Ray from pixel: f32 would do, by eye basis",
            "Ray into object space: ",
            "Ray against sphere: ",
            "Near and far: ",
            "Normal into the world: ",
            "Depth buffer: ",
            "Whole pick: ",
        ] {
            assert!(page.contains(words), "no {words:?} in\n{page}");
        }
        let course = page
            .lines()
            .find(|line| line.contains("estimate") && line.contains("target + sx H"));
        assert!(
            course.is_some_and(|line| line.contains("too much")),
            "{page}"
        );
        assert!(
            page.lines().any(|line| line.starts_with("  bound ")),
            "{page}"
        );
    }
}

mod charts {
    use super::*;
    use study::chart::{
        charts,
        picture::{Anchor, Mark},
    };

    /// With times, since speed is half of a chart.
    fn timed() -> Report {
        study::run(
            Effort {
                cases: 30,
                picks: 8,
                rounds: 1,
                seed: 1,
            },
            None,
            &|_, _| {},
        )
    }

    #[test]
    fn are_written_and_say_something() {
        let folder = tempfile::tempdir().expect("a folder");
        let charts = charts(&timed());
        assert_eq!(charts.len(), 4);
        for (stem, picture) in charts {
            no_words_overlap(stem, &picture);
            study::chart::write(folder.path(), stem, &picture).expect("written");
            let svg = std::fs::read_to_string(folder.path().join(stem).with_extension("svg"));
            let svg = svg.expect("an SVG file");
            assert!(
                svg.trim_end().ends_with("</svg>") && svg.matches("<text").count() > 4,
                "{stem}"
            );
            let pixels = picture.pixels().expect("pixels");
            let colours: HashSet<_> = pixels.iter().collect();
            assert!(colours.len() > 100, "{stem} has {} colours", colours.len());
            let png = std::fs::metadata(folder.path().join(stem).with_extension("png"));
            assert!(png.expect("a PNG file").len() > 10_000, "{stem}");
        }
    }

    /// Boxes about the words, by the typeface's mean width.
    fn no_words_overlap(stem: &str, picture: &study::chart::picture::Picture) {
        let mut boxes: Vec<([f64; 4], &str)> = Vec::new();
        for mark in &picture.marks {
            let Mark::Text {
                at: [x, y],
                anchor,
                size,
                upwards,
                text,
                ..
            } = mark
            else {
                continue;
            };
            let length =
                0.46 * size * f64::from(u32::try_from(text.chars().count()).expect("short"));
            let start = match anchor {
                Anchor::Left => 0.0,
                Anchor::Middle => -0.5 * length,
                Anchor::Right => -length,
            };
            let half = 0.36 * size;
            let area = if *upwards {
                [x - half, y - 0.5 * length, x + half, y + 0.5 * length]
            } else {
                [x + start, y - half, x + start + length, y + half]
            };
            let [left, top, right, bottom] = area;
            let inside = left >= 0.0
                && top >= 0.0
                && right <= f64::from(picture.width)
                && bottom <= f64::from(picture.height);
            assert!(
                inside || text.is_empty(),
                "{stem}: {text:?} leaves the picture"
            );
            for (other, words) in &boxes {
                let apart = area[0] >= other[2]
                    || other[0] >= area[2]
                    || area[1] >= other[3]
                    || other[1] >= area[3];
                assert!(
                    apart || text.is_empty(),
                    "{stem}: {text:?} lies over {words:?}"
                );
            }
            boxes.push((area, text));
        }
    }
}
