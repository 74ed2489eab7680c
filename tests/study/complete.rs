//! The other methods have the properties known of them: which always decide right, which leak and which lose digits.

use super::{report, row, rows};
use sightline::study::{
    methods::{closed::ClosedCase, triangles::RayTriangle},
    random::Random,
    step::{
        Case,
        Precision::{Exact, F32, F64},
    },
};

/// Methods with enough digits decide every triangle case right, far rays, slivers and ties included.
#[test]
fn long_arithmetic_decides_right() {
    for (method, precision) in [
        ("double-double volumes", F64),
        ("Shewchuk's orient3d", Exact),
        ("exact everywhere", Exact),
    ] {
        let own = report().rows.iter().filter(|row| {
            (row.info.step.key, row.info.name, row.info.precision)
                == ("triangle", method, precision)
        });
        let wrong: Vec<_> = own.clone().filter(|row| row.wrong() > 0).collect();
        assert!(wrong.is_empty(), "{wrong:?}");
        assert!(own.map(|row| row.cases).sum::<usize>() > 10_000, "{method}");
    }
}

/// Every triangle test except the one by unsigned areas is right for almost all ordinary rays.
#[test]
fn every_triangle_test_does_what_is_ordinary() {
    let ordinary = report().rows.iter().filter(|row| {
        (row.info.step.key, row.family) == ("triangle", "ordinary")
            && !row.info.name.starts_with("areas")
    });
    let mut methods = 0;
    for row in ordinary {
        assert!(row.wrong_percent() < 1.0, "{row:?}");
        let most = if row.info.precision == F32 {
            1e-4
        } else {
            1e-12
        };
        assert!(row.worst_error < most, "{row:?}");
        assert!(row.median_error < row.p999_error, "{row:?}");
        methods += 1;
    }
    assert!(methods > 18, "{methods}");
}

#[test]
fn watertight_tests_close_a_mesh_and_others_leak() {
    let through = ["exactly through edges", "exactly through vertices"];
    let families = ["ordinary", "vertices", "far from the origin"];
    for (method, precision) in [
        ("Woop watertight", F32),
        ("Woop watertight", F64),
        ("pbrt-v4, bounded t", F32),
        ("Embree robust", F32),
        ("Shewchuk's orient3d", Exact),
        ("Sightline's", Exact),
    ] {
        for family in families.into_iter().chain(through) {
            for row in rows("closed-mesh", method, precision, family) {
                assert_eq!(row.wrong(), 0, "{row:?}");
                assert!(row.cases >= 2500, "{row:?}");
            }
        }
    }
    for method in ["Moeller-Trumbore", "Baldwin-Weber", "Havel-Herout"] {
        let leaks = through
            .into_iter()
            .flat_map(|family| rows("closed-mesh", method, F32, family));
        let leaks: usize = leaks.map(|row| row.missed).sum();
        assert!(leaks > 100, "{method}: {leaks}");
    }
}

/// The closed-mesh step takes for truth that every ray enters the body. Exact arithmetic agrees.
#[test]
fn rays_that_surely_enter_a_body_do() {
    for family in ClosedCase::FAMILIES {
        for &value in family.values {
            let mut random = Random::named(5, &[family.name]);
            for _ in 0..20 {
                let case = (family.make)(&mut random, value);
                let hits = case
                    .wide
                    .triangles()
                    .filter_map(|triangle: RayTriangle<f64>| triangle.truth());
                let first = hits.reduce(f64::min).expect("a hit");
                assert!(
                    (0.0..0.95).contains(&first),
                    "{} {value}: {first}",
                    family.name
                );
            }
        }
    }
}

/// three.js subtracts the eye and loses digits. Bevy subtracts a near from an almost infinitely far point: the eye
/// cancels.
#[test]
fn unprojection_loses_digits_to_the_eye() {
    let worst = |method: &str, precision, family: &str, value: f64| {
        row("ray", method, precision, family, value).worst_error
    };
    let [three, bevy] = ["unproject, as three.js", "unproject, as Bevy"];
    let far_out = |method: &str| worst(method, F32, "eye far from the origin", 1e5);
    assert!(far_out(three) > 1.0, "{}", far_out(three));
    assert!(far_out(bevy) < 0.1, "{}", far_out(bevy));
    for method in [three, bevy] {
        let error = worst(method, F64, "ordinary", 1.0);
        assert!(error < 1e-6, "{method}: {error}");
    }
}

#[test]
fn a_logarithm_spreads_depth_over_any_range() {
    let standard = row("depth", "standard, 24-bit integer", F32, "far plane", 1e8);
    let logarithmic = row(
        "depth",
        "logarithmic, 24-bit integer",
        F32,
        "far plane",
        1e8,
    );
    assert!(
        logarithmic.worst_error < 1e-4 * standard.worst_error,
        "{logarithmic:?} {standard:?}"
    );
}

#[test]
fn ties_are_no_distance() {
    let ties = row(
        "triangle",
        "Moeller-Trumbore",
        F64,
        "exactly through edges",
        22.0,
    );
    assert!(ties.wrong() > 0 && ties.ties == ties.wrong(), "{ties:?}");
    let off = row("triangle", "Moeller-Trumbore", F32, "grazing", 1e-6);
    assert!(off.ties < off.wrong() && off.worst_wrong > 0.0, "{off:?}");
    let [low, high] = off.wrong_percent_within();
    assert!(
        low < off.wrong_percent() && off.wrong_percent() < high,
        "{off:?}"
    );
}
