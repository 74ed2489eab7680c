//! The fields of a record agree with each other, with the picture and with exact arithmetic, wherever eye and scene
//! are.

use super::{
    common::{Random, assert_close, assert_near, perspective, scene_of, view},
    exact::{line::Line, truth::World},
    mixed, positions, views_of,
};
use glam::{DAffine3, DVec2, DVec3, dvec2, dvec3};
use sightline::{
    camera::{Camera, Lens, Projection, View},
    pick::{self, Pick, PickLine, PickLines},
    scene::{Scene, Shape},
    verify,
};

#[test]
fn a_records_fields_agree() {
    let mut kinds = std::collections::HashMap::new();
    let scene = mixed(DVec3::ZERO);
    for view in views_of(DVec3::ZERO) {
        for px in positions(&view, 400) {
            let picks = pick::pick_all(&scene, &view, px);
            assert_eq!(pick::pick(&scene, &view, px).as_ref(), picks.first());
            for (i, pick) in picks.iter().enumerate() {
                consistent(&scene, &view, px, pick);
                let next = picks.get(i + 1);
                if let (Some(gap), Some(next)) = (pick.gap, next) {
                    let rounded = 2.0 * f64::EPSILON * next.t;
                    assert!((gap - (next.t - pick.t)).abs() <= rounded, "{gap}");
                }
                assert_eq!(pick.gap.is_some(), next.is_some());
                assert!(pick.gap.is_none_or(|gap| gap >= 0.0));
                *kinds.entry(pick.id).or_insert(0) += 1;
            }
        }
    }
    assert!(
        kinds.len() >= 7,
        "every object but the tiny one is hit: {kinds:?}"
    );
}

fn consistent(scene: &Scene, view: &View, px: DVec2, pick: &Pick) {
    let object = &scene.objects()[pick.id - 1];
    assert_eq!(pick.object, object.name);
    let eye = view.camera.eye();
    let ray = view.ray(px);
    assert!(ray.contains(pick.t));
    assert!(ray.at(pick.t).distance(pick.point_world) <= 1e-14 * (pick.distance + eye.length()));

    let shown = view.project(pick.point_world).unwrap();
    assert!(shown.px.distance(px) <= 1e-9, "{} is not {px}", shown.px);
    assert!((shown.ndc - pick.ndc).abs().max_element() <= 1e-11);
    assert!((shown.depth - pick.depth).abs() <= 1e-12 * pick.distance);
    let Lens { near, far, .. } = *view.camera.lens();
    assert!((near..far).contains(&pick.depth) && (0.0..=1.0).contains(&pick.ndc.z));

    let size = pick.distance + eye.length();
    let there = object.placement.point_to_world(pick.point_object);
    assert!(there.distance(pick.point_world) <= 1e-13 * size);
    assert_close(pick.normal_world.length(), 1.0, 1e-15);
    assert_close(pick.normal_object.length(), 1.0, 1e-15);
    assert_near(
        object.placement.normal_to_world(pick.normal_object),
        pick.normal_world,
        1e-14,
    );
    assert_eq!(pick.front, ray.direction.dot(pick.normal_world) < 0.0);

    // The point satisfies the shape's own equation.
    let p = pick.point_object;
    let inverse = object.placement.inverse_linear();
    let slack = 1e-14
        * size
        * inverse
            .to_cols_array()
            .iter()
            .fold(1.0, |a: f64, b| a.max(b.abs()));
    let off = match &object.shape {
        Shape::Sphere => p.length() - 0.5,
        Shape::Cube => p.abs().max_element() - 0.5,
        Shape::Square => p.z.abs() + (p.abs().max_element() - 0.5).max(0.0),
        Shape::Mesh { mesh, part } => {
            let first = mesh.data().parts[*part].triangles.start;
            let corners = mesh.corners(first + pick.triangle.unwrap());
            let s = pick.barycentric.unwrap();
            assert!(s.iter().all(|s| (0.0..=1.0).contains(s)));
            p.distance(s[0] * corners[0] + s[1] * corners[1] + s[2] * corners[2])
        }
    };
    assert!(off.abs() <= slack, "{off} off the {}", object.shape.kind());
    let analytic = !matches!(object.shape, Shape::Mesh { .. });
    assert_eq!(pick.triangle.is_none(), analytic);
    assert_eq!(pick.barycentric.is_none(), analytic);
    assert!(pick.edge_px.is_none_or(|px| px >= 0.0 && px.is_finite()));
}

#[test]
fn distances_are_those_of_exact_arithmetic() {
    let mut hits = 0;
    for center in [DVec3::ZERO, dvec3(1e6, -3e6, 2e6)] {
        let scene = mixed(center);
        let world = World::of(&scene);
        for view in views_of(center) {
            for px in positions(&view, 200) {
                let line = Line::of(&view, px);
                let truth = world.hits(&line, view.sides);
                for (pick, hit) in pick::pick_all(&scene, &view, px).iter().zip(&truth) {
                    // A coordinate of 1e6 rounds; the distance from the eye must not depend on that.
                    let distance = line.distance(view.camera.eye(), &hit.t);
                    let t_off = ((pick.depth - hit.t.rounded()) / pick.depth).abs();
                    assert_close(pick.distance, distance, 1e-14 + 2.0 * t_off);
                    hits += 1;
                }
            }
        }
    }
    assert!(hits > 1500, "only {hits} hits");
}

#[test]
fn nothing_changes_far_from_the_origin() {
    let offset = dvec3(1e6, -3e6, 2e6);
    let (here, there) = (mixed(DVec3::ZERO), mixed(offset));
    let mut hits = 0;
    for (view_here, view_there) in views_of(DVec3::ZERO).iter().zip(&views_of(offset)) {
        for px in positions(view_here, 400) {
            let a = pick::pick(&here, view_here, px);
            let b = pick::pick(&there, view_there, px);
            let (Some(a), Some(b)) = (&a, &b) else {
                assert_eq!(a.is_some(), b.is_some(), "at {px}");
                continue;
            };
            if a.edge_px.is_some_and(|px| px < 1e-4) {
                continue; // So near an edge, the rounding of coordinates decides.
            }
            assert_eq!(
                (a.id, a.triangle, a.front),
                (b.id, b.triangle, b.front),
                "at {px}"
            );
            // Coordinates of 1e6 are stored to 1e-10. A slanted surface multiplies that error.
            let cos = view_here.ray(px).direction.dot(a.normal_world).abs();
            assert!((a.t - b.t).abs() <= 1e-8 / cos);
            assert!((b.point_world - offset).distance(a.point_world) <= 1e-8 / cos);
            hits += 1;
        }
    }
    assert!(hits > 500, "only {hits} hits");
}

#[test]
fn json_has_the_documented_fields_in_order_and_no_nan() {
    let scene = scene_of(Shape::Square, DAffine3::IDENTITY);
    let view = view(
        [0.0, 0.0, 2.0],
        [0.0; 3],
        perspective(90.0, 1.0, 3.0),
        [8, 8],
    );
    let px = dvec2(4.0, 4.0);
    let line = PickLine {
        px,
        hit: pick::pick(&scene, &view, px),
        in_one_place: verify::in_one_place(&scene, &view, px),
    };
    // For 90 degrees the camera stores a half height of 0.999..., so the square appears that much wider.
    assert_eq!(
        serde_json::to_string(&line).unwrap(),
        r##"{"px":[4.0,4.0],"hit":{"object":"it","id":1,"triangle":null,"material":null,"colour":"#e8e8ec","front":true,"t":2.0,"distance":2.0,"depth":2.0,"ndc":[0.0,0.0,0.25],"point_world":[0.0,0.0,0.0],"normal_world":[0.0,0.0,1.0],"point_object":[0.0,0.0,0.0],"normal_object":[0.0,0.0,1.0],"barycentric":null,"edge_px":1.0000000000000002,"gap":null,"exact":false,"file":null,"line":null,"face":null,"vertices":null,"corners":null,"file_error":null},"in_one_place":null}"##
    );
    let miss = PickLine {
        px,
        hit: None,
        in_one_place: None,
    };
    assert_eq!(
        serde_json::to_string(&miss).unwrap(),
        r#"{"px":[4.0,4.0],"hit":null,"in_one_place":null}"#
    );
    let twice = Scene::new(
        [&scene, &scene]
            .map(|scene| scene.objects()[0].clone())
            .into(),
    );
    let none = PickLines {
        px,
        hits: Vec::new(),
        in_one_place: verify::in_one_place(&twice, &view, px),
    };
    assert_eq!(
        serde_json::to_string(&none).unwrap(),
        r#"{"px":[4.0,4.0],"hits":[],"in_one_place":{"count":2,"named":[{"object":"it","id":1,"triangle":null,"front":true},{"object":"it","id":2,"triangle":null,"front":true}]}}"#
    );
}

#[test]
fn records_are_finite_from_any_eye() {
    // Eyes are inside objects, just before them, and far away.
    let scene = mixed(DVec3::ZERO);
    let mut random = Random::new(44);
    let mut hits = 0;
    for i in 0..300 {
        let eye = 10_f64.powi(i % 9 - 4) * random.direction();
        for projection in [
            Projection::Perspective {
                fov_y: random.within(0.001, 3.1),
            },
            Projection::Orthographic {
                height: 10_f64.powf(random.within(-4.0, 4.0)),
            },
        ] {
            let lens = Lens {
                projection,
                ..perspective(45.0, 1e-6, 1e6)
            };
            let camera = Camera::new(eye, random.point(0.5), DVec3::Y, lens).unwrap();
            let view = View {
                camera,
                ..view([1.0; 3], [0.0; 3], lens, [64, 48])
            };
            for px in positions(&view, 20) {
                for pick in pick::pick_all(&scene, &view, px) {
                    let numbers = [
                        pick.t,
                        pick.distance,
                        pick.depth,
                        pick.edge_px.unwrap_or(0.0),
                        pick.gap.unwrap_or(0.0),
                    ];
                    let vectors = [
                        pick.ndc,
                        pick.point_world,
                        pick.normal_world,
                        pick.point_object,
                        pick.normal_object,
                    ];
                    assert!(
                        numbers.iter().all(|n| n.is_finite())
                            && vectors.iter().all(|v| v.is_finite()),
                        "{pick:?}"
                    );
                    hits += 1;
                }
            }
        }
    }
    assert!(hits > 3000, "only {hits} hits");
}
