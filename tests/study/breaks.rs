//! Each method errs where it is known to err.

use super::{row, rows};
use sightline::study::step::Precision::{F32, F64};

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
        "plain, for unit directions",
        F64,
        "direction of another length",
        1e-2,
    );
    assert!(row.wrong_percent() > 30.0, "{row:?}");
}

/// Only exact arithmetic is right for a ray that touches exactly.
#[test]
fn rays_that_touch_need_exact_arithmetic() {
    for (step, method, family, bits) in [
        ("sphere", "Hearn & Baker", "exactly touching", 16.0),
        ("square", "N . (S - o)", "exactly through the rim", 16.0),
    ] {
        let bad = row(step, method, F64, family, bits);
        assert!(bad.wrong() * 20 > bad.cases, "{bad:?}");
        assert!(bad.worst_wrong < 1e-9, "{bad:?}");
    }
}

#[test]
fn the_distance_form_of_a_plane_is_lost_far_from_the_origin() {
    let bad = row("square", "D - N . o", F32, "far from the origin", 1e6);
    assert!(bad.wrong() > 0 && bad.worst_error > 1e-2, "{bad:?}");
    let good = row("square", "N . (S - o)", F64, "far from the origin", 1e6);
    assert!(good.worst_wrong < 1e-6, "{good:?}");
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

/// In the world's coordinates, `f32` is lost far from the origin; about the mesh or the eye it is not.
#[test]
fn f32_in_the_world_is_lost_far_from_the_origin() {
    let wrong = |name| {
        let row = row("pick", name, F32, "a ball of 5120 triangles", 5e6);
        row.wrong_percent()
    };
    assert!(wrong("f32 in the world") > 30.0);
    assert!(wrong("f32 about each file's origin") < 5.0 && wrong("f32 about the eye") < 5.0);
}
