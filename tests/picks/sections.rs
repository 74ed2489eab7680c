//! Pick records under a section: only kept edges and outlines count, and solids that it opens show their backs.

use crate::common::{Random, mesh, orthographic, perspective, placements, view};
use glam::{DAffine3, DVec2, DVec3};
use sightline::{
    camera::{SectionChoice, View},
    geometry::{Cuboid, Placement, Section, Sides, Square},
    pick::{self, Pick},
    scene::{Object, Scene, Shape},
};
use std::f64::consts::TAU;

/// Corners of a triangle.
const CORNERS: [[f32; 3]; 3] = [[-0.5, -0.5, 0.1], [0.6, -0.4, 0.0], [-0.3, 0.5, -0.2]];

struct Case {
    object: Object,
    view: View,
    px: DVec2,
}

/// An ordinary view of a shape that a section cuts; all of it lies before the eye.
fn case(random: &mut Random, shape: &Shape) -> Case {
    loop {
        let case = some_case(random, shape);
        let is_before = |corner| case.view.camera.to_view(corner).z > 0.1;
        if case
            .object
            .bounds_world()
            .corners()
            .into_iter()
            .all(is_before)
        {
            return case;
        }
    }
}

fn some_case(random: &mut Random, shape: &Shape) -> Case {
    let eye = random.within(2.0, 6.0) * random.direction();
    let lens = if random.below(3) == 0 {
        orthographic(3.0, 0.01, 1e3)
    } else {
        perspective(random.within(20.0, 60.0), 0.01, 1e3)
    };
    let whole = view(eye.into(), random.point(0.3).into(), lens, [640, 480]);
    let (_, model) = placements()[random.below(7)];
    let model = DAffine3 {
        translation: random.point(0.3),
        ..model
    };
    let placement = Placement::new(model).expect("invertible");
    let through = placement.point_to_world(random.point(0.4));
    let section = Section::through(through, random.direction()).expect("a section");
    let px = whole.project(placement.point_to_world(random.point(0.5)));
    let px = px.map_or(DVec2::ZERO, |shown| shown.px);
    Case {
        object: Object::new("it", shape.clone(), placement),
        view: View {
            section: Some(section),
            ..whole
        },
        px,
    }
}

/// Pixels from the position to a world point's picture.
fn offset(case: &Case, point: DVec3) -> DVec2 {
    case.view.project(point).expect("before the eye").px - case.px
}

/// Distance to the kept parts of a polygon's sides, and whether an end made by the section is nearest.
fn polygon_px(case: &Case, corners: &[DVec3]) -> Option<(f64, bool)> {
    let section = case.view.section.expect("a section");
    let sides = (0..corners.len()).filter_map(|i| {
        let (mut a, mut b) = (corners[i], corners[(i + 1) % corners.len()]);
        let [of_a, of_b] = [a, b].map(|p| section.side(p));
        if of_a < 0.0 && of_b < 0.0 {
            return None;
        }
        let cut = a.lerp(b, of_a / (of_a - of_b));
        if of_a < 0.0 {
            a = cut;
        } else if of_b < 0.0 {
            b = cut;
        }
        let [p, q] = [a, b].map(|end| offset(case, end));
        let along = q - p;
        let s = (-p.dot(along) / along.length_squared()).clamp(0.0, 1.0);
        let is_end = |at: f64, of: f64| (s - at).abs() < 1e-12 && of < 0.0;
        let at_cut = is_end(0.0, of_a) || is_end(1.0, of_b);
        Some(((p + s * along).length(), at_cut))
    });
    sides.min_by(|a, b| a.0.total_cmp(&b.0))
}

/// The same for a sphere's outline: by bisection to each end that the section makes, and by a search for the minimum
/// between neighbouring samples.
fn outline_px(case: &Case) -> Option<(f64, bool)> {
    const STEPS: u32 = 4000;
    let camera = &case.view.camera;
    let placement = &case.object.placement;
    let to_object = placement.model().inverse();
    // Where rays are tangent: y . eye = 1/4, or y . direction = 0.
    let (axis, centre, radius) = if camera.lens().is_orthographic() {
        let axis = to_object.transform_vector3(camera.forward());
        (axis, DVec3::ZERO, 0.5)
    } else {
        let eye = to_object.transform_point3(camera.eye());
        let share = 0.25 / eye.length_squared();
        (eye, share * eye, (0.25 - 0.25 * share).sqrt())
    };
    let [first, second] = <[DVec3; 2]>::from(axis.normalize().any_orthonormal_pair());
    let at = |angle: f64| {
        let aside = angle.cos() * first + angle.sin() * second;
        placement.point_to_world(centre + radius * aside)
    };
    let section = case.view.section.expect("a section");
    let side = |angle: f64| section.side(at(angle));
    let px = |angle: f64| offset(case, at(angle)).length();
    let step = TAU / f64::from(STEPS);
    let mut best: Option<(f64, bool)> = None;
    let mut found = |px: f64, at_cut: bool| {
        if best.is_none_or(|(least, _)| px < least) {
            best = Some((px, at_cut));
        }
    };
    let angles = (0..=STEPS).map(|i| f64::from(i) * step);
    let samples: Vec<_> = angles.map(|at| (at, side(at) >= 0.0, px(at))).collect();
    let kept = samples.iter().filter(|(_, is_kept, _)| *is_kept);
    let least = kept.map(|(.., px)| *px).fold(f64::INFINITY, f64::min);
    let steps = || samples.windows(2).map(|pair| [pair[0], pair[1]]);
    let changes = steps().map(|[(.., a), (.., b)]| (a - b).abs());
    let most = changes.fold(0.0, f64::max);
    for [(mut from, at_from, px_from), (mut to, at_to, px_to)] in steps() {
        if at_from != at_to {
            let (mut kept, mut gone) = if at_from { (from, to) } else { (to, from) };
            for _ in 0..60 {
                let middle = 0.5 * (kept + gone);
                if side(middle) >= 0.0 {
                    kept = middle;
                } else {
                    gone = middle;
                }
            }
            found(px(kept), true);
            (from, to) = if at_from { (from, kept) } else { (kept, to) };
        } else if !at_from {
            continue;
        }
        // Between samples the distance changes by about as much as from one to the next.
        if px_from.min(px_to) > least + 2.0 * most {
            continue;
        }
        // Distances have one minimum in an interval this short.
        for _ in 0..80 {
            let [a, b] = [from + (to - from) / 3.0, to - (to - from) / 3.0];
            if px(a) < px(b) {
                to = b;
            } else {
                from = a;
            }
        }
        // The small extra makes an end itself count where the minimum is at the end.
        found(px(0.5 * (from + to)) + 1e-12, false);
    }
    best
}

fn truth(case: &Case, pick: &Pick) -> Option<(f64, bool)> {
    let to_world = |corner| case.object.placement.point_to_world(corner);
    match &case.object.shape {
        Shape::Sphere => outline_px(case),
        Shape::Square => polygon_px(case, &Square::corners().map(to_world)),
        Shape::Cube => {
            let is_it = |n: &&DVec3| n.dot(pick.normal_object) > 0.5;
            let face = Cuboid::NORMALS.iter().find(is_it).expect("a face");
            polygon_px(case, &Cuboid::face(*face).map(to_world))
        }
        Shape::Mesh { .. } => {
            let corners = CORNERS.map(|p| DVec3::from(p.map(f64::from)));
            polygon_px(case, &corners.map(to_world))
        }
    }
}

/// Checks a record's distance to the next edge or outline for a shape under 4000 cameras, matrices and sections.
#[track_caller]
fn edges_count_as_far_as_a_section_keeps_them(shape: &Shape, seed: u64) {
    let mut random = Random::new(seed);
    let [mut picked, mut at_cut, mut none] = [0; 3];
    for _ in 0..4000 {
        let case = case(&mut random, shape);
        let scene = Scene::new(vec![case.object.clone()]);
        let Some(pick) = pick::pick(&scene, &case.view, case.px) else {
            continue;
        };
        let truth = truth(&case, &pick);
        picked += 1;
        at_cut += u32::from(truth.is_some_and(|(_, cut)| cut));
        none += u32::from(truth.is_none());
        let right = match (pick.edge_px, truth) {
            (Some(px), Some((truth, _))) => (px - truth).abs() <= 1e-6,
            (px, truth) => px.is_none() && truth.is_none(),
        };
        assert!(
            right,
            "{:?} but {truth:?}: {:?} {:?} at {}",
            pick.edge_px,
            case.object.placement.model(),
            case.view,
            case.px
        );
    }
    println!("{picked} picked, {at_cut} at a cut, {none} none");
    assert!(picked > 400 && at_cut > 20, "{picked} {at_cut}");
}

#[test]
fn edges_of_triangles_count_as_far_as_a_section_keeps_them() {
    let triangle = Shape::Mesh {
        mesh: mesh(CORNERS.to_vec(), vec![[0, 1, 2]], DVec3::ZERO),
        part: 0,
    };
    edges_count_as_far_as_a_section_keeps_them(&triangle, 41);
}

#[test]
fn edges_of_squares_count_as_far_as_a_section_keeps_them() {
    edges_count_as_far_as_a_section_keeps_them(&Shape::Square, 42);
}

#[test]
fn edges_of_cubes_count_as_far_as_a_section_keeps_them() {
    edges_count_as_far_as_a_section_keeps_them(&Shape::Cube, 43);
}

#[test]
fn outlines_of_spheres_count_as_far_as_a_section_keeps_them() {
    edges_count_as_far_as_a_section_keeps_them(&Shape::Sphere, 44);
}

/// A ball whose front is cut away shows its back if both sides show. Points in the plane itself are kept.
#[test]
fn a_solid_that_is_opened_shows_its_back() {
    let ball = Object::new("ball", Shape::Sphere, Placement::IDENTITY);
    let scene = Scene::new(vec![ball]);
    let lens = perspective(40.0, 0.1, 10.0);
    let whole = view([0.0, 0.0, 3.0], [0.0; 3], lens, [65, 65]);
    let middle = DVec2::splat(32.5);
    for (offset, sides, front) in [
        (1.0, Sides::Both, Some(true)),
        // The entry lies in the plane.
        (0.5, Sides::Both, Some(true)),
        (0.5_f64.next_down(), Sides::Both, Some(false)),
        (0.0, Sides::Both, Some(false)),
        (0.0, Sides::Front, None),
        // The exit lies in the plane.
        (-0.5, Sides::Both, Some(false)),
        ((-0.5_f64).next_down(), Sides::Both, None),
    ] {
        let section = Section::new(DVec3::NEG_Z, offset).expect("a section");
        let view = View {
            sides,
            section: Some(section),
            ..whole
        };
        let found = pick::pick(&scene, &view, middle).map(|pick| pick.front);
        assert_eq!(found, front, "{offset} {sides:?}");
        let all = pick::pick_all(&scene, &view, middle);
        let fronts: Vec<_> = all.iter().map(|pick| pick.front).collect();
        assert_eq!(fronts.first().copied(), front);
        let picture = pick::ids(&scene, &view).at(32, 32).object;
        assert_eq!(picture, u32::from(front.is_some()));
    }
}

/// Whether three points span a plane is decided exactly, however close to a line they lie.
#[test]
fn three_points_span_a_plane_or_lie_on_a_line_exactly() {
    let of = |text: &str| text.parse::<SectionChoice>();
    for (points, normal) in [
        ("points:0,0,0/1,0,0/2,1e-33,0", DVec3::Z),
        ("points:0,0,0/1e-33,0,0/0,1e-33,0", DVec3::Z),
        ("points:0,0,0/8e-34,0,0/0,0,8e-34", DVec3::NEG_Y),
        ("points:1e9,0,0/1e9,1,0/1e9,3,8e-34", DVec3::X),
        ("points:-1e33,0,0/1e33,0,0/0,1,0", DVec3::Z),
    ] {
        let Ok(SectionChoice::Plane(section)) = of(points) else {
            panic!("{points}: {:?}", of(points));
        };
        assert!((section.normal() - normal).length() < 1e-15, "{points}");
    }
    for points in [
        "points:0,0,0/1,1,1/2,2,2",
        "points:0.1,0.1,0.1/0.2,0.2,0.2/0.7,0.7,0.7",
        "points:1e-33,0,0/3e-33,0,0/1e-33,0,0",
        "points:0,0,0/1,0,0/2,7e-34,0",
        "points:5,6,7/5,6,7/8,9,1",
    ] {
        let error = of(points).expect_err(points).to_string();
        assert!(error.contains("one line"), "{points}: {error}");
    }
}

/// A ball cut in half across the line of sight has its outline exactly in the section's plane, which is kept.
#[test]
fn an_outline_in_the_sections_plane_counts() {
    let ball = Object::new("ball", Shape::Sphere, Placement::IDENTITY);
    let scene = Scene::new(vec![ball]);
    let lens = orthographic(2.0, 0.01, 10.0);
    let whole = view([0.0, 0.0, 5.0], [0.0; 3], lens, [64, 64]);
    for kept in [DVec3::Z, DVec3::NEG_Z] {
        let section = Section::through(DVec3::ZERO, kept).expect("a section");
        let view = View {
            section: Some(section),
            ..whole
        };
        let pick = pick::pick(&scene, &view, DVec2::new(40.0, 32.0)).expect("half a ball");
        // Its radius is 16 pixels.
        assert_eq!(pick.edge_px, Some(8.0), "{kept}");
    }
}
