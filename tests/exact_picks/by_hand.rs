//! The oracle itself is right, on cases whose answers are known without it.

use crate::common::{Random, mesh, orthographic, perspective, view};
use crate::exact::{
    line::Line,
    number::{Dyadic, vector},
    root::Parameter,
    truth::{Hit, World},
};
use glam::{DAffine3, DMat3, DVec3, dvec2, dvec3};
use sightline::{
    geometry::{Placement, Sides},
    scene::{Object, Scene, Shape},
};

fn line(origin: DVec3, direction: DVec3) -> Line {
    Line {
        origin: vector(origin),
        direction: vector(direction),
        scale: Dyadic::whole(1),
        near: Dyadic::of(-100.0),
        far: Dyadic::of(100.0),
        section: None,
    }
}

fn object(shape: Shape, model: DAffine3) -> Object {
    Object::new("it", shape, Placement::new(model).unwrap())
}

fn at_origin(shape: Shape) -> World {
    World::of(&Scene::new(vec![object(shape, DAffine3::IDENTITY)]))
}

/// `t` and `front` of each hit.
fn in_short(hits: &[Hit]) -> Vec<(f64, bool)> {
    hits.iter()
        .map(|hit| (hit.t.rounded(), hit.front))
        .collect()
}

/// A number of any size, from the smallest to the largest.
fn any_number(random: &mut Random) -> f64 {
    let exponent = random.within(-1074.0, 1023.0).floor();
    let scale = (0.5 * exponent).floor().exp2();
    (random.unit() - 0.5) * scale * (exponent - (0.5 * exponent).floor()).exp2()
}

#[test]
fn quotients_and_roots_round_as_processors_do() {
    let mut random = Random::new(1);
    let mut kinds = [0; 3];
    for _ in 0..20_000 {
        let (a, b) = (any_number(&mut random), any_number(&mut random));
        if b == 0.0 {
            continue;
        }
        let quotient = Parameter::fraction(&Dyadic::of(a), &Dyadic::of(b)).rounded();
        assert_eq!(
            quotient.abs().to_bits(),
            (a / b).abs().to_bits(),
            "{a:e} / {b:e}"
        );
        assert!(quotient == 0.0 || quotient.signum() == (a / b).signum());
        let kind = if quotient.is_infinite() {
            2
        } else {
            usize::from(quotient.is_normal())
        };
        kinds[kind] += 1;
        let root = Parameter::root(Dyadic::ZERO, 1, Dyadic::of(a.abs()), Dyadic::whole(1));
        assert_eq!(
            root.rounded().to_bits(),
            a.abs().sqrt().to_bits(),
            "root of {a:e}"
        );
    }
    println!("below normal numbers, normal, beyond: {kinds:?}");
    assert!(kinds.iter().all(|count| *count > 1000), "{kinds:?}");
}

#[test]
fn numbers_with_roots_are_compared_and_subtracted_exactly() {
    // (p + sign sqrt(r)) / q
    let number = |p: i64, sign, r: i64, q: i64| {
        let [p, r, q] = [p, r, q].map(Dyadic::whole);
        Parameter::root(p, sign, r, q)
    };
    // sqrt(8) / 2 is sqrt(2), and sqrt(9) is 3.
    for (a, b) in [
        (number(0, 1, 8, 2), number(0, 1, 2, 1)),
        (number(1, -1, 9, 2), number(-1, 0, 0, 1)),
        (number(3, 1, 50, 5), number(6, 1, 200, 10)),
    ] {
        assert!(a.compare(&b).is_eq() && b.compare(&a).is_eq());
        assert_eq!(a.rounded_minus(&b).to_bits(), 0.0_f64.to_bits());
    }
    // Convergents of sqrt(2) alternate about it: 7/5 < 41/29 < sqrt(2) < 99/70 < 17/12.
    let rising = [
        number(7, 0, 0, 5),
        number(41, 0, 0, 29),
        number(0, 1, 2, 1),
        number(99, 0, 0, 70),
        number(17, 0, 0, 12),
    ];
    for (i, a) in rising.iter().enumerate() {
        for (j, b) in rising.iter().enumerate() {
            assert_eq!(a.compare(b), i.cmp(&j), "{i} {j}");
        }
    }
    // sqrt(10) - sqrt(3) = 1.43022685..., sqrt(5) + 1 > sqrt(10), -sqrt(3) < -sqrt(2).
    let difference = number(0, 1, 10, 1).rounded_minus(&number(0, 1, 3, 1));
    assert!(
        (difference - 1.430_226_852_599_502).abs() < 1e-15,
        "{difference}"
    );
    assert!(number(1, 1, 5, 1).compare(&number(0, 1, 10, 1)).is_gt());
    assert!(number(0, -1, 3, 1).compare(&number(0, -1, 2, 1)).is_lt());
    // sqrt(n^2 + 1) - n is nearly 1 / (2 n): all digits of the roots cancel.
    let n = 1 << 30;
    let difference = number(0, 1, n * n + 1, 1).rounded_minus(&number(n, 0, 0, 1));
    assert_eq!(difference.to_bits(), 2_f64.powi(-31).to_bits());
}

#[test]
fn the_ray_of_a_position_is_the_contracts() {
    let px = dvec2(150.0, 25.0);
    let at = view(
        [1.0, 2.0, 3.0],
        [1.0, 2.0, 0.0],
        orthographic(2.0, -1.0, 5.0),
        [200, 100],
    );
    let there = Line::of(&at, px);
    // (1 / 100) ((300 - 200) R + (100 - 50) U) is R + U / 2; all of it is times 100.
    assert_eq!(there.origin, vector(dvec3(200.0, 250.0, 300.0)));
    assert_eq!(there.direction, vector(dvec3(0.0, 0.0, -100.0)));
    let at = view(
        [1.0, 2.0, 3.0],
        [1.0, 2.0, 0.0],
        perspective(70.0, 1.0, 5.0),
        [200, 100],
    );
    let h = Dyadic::of(at.camera.half_height());
    let there = Line::of(&at, px);
    assert_eq!(there.origin, vector(dvec3(100.0, 200.0, 300.0)));
    assert_eq!(
        there.direction,
        [
            &Dyadic::whole(100) * &h,
            &Dyadic::whole(50) * &h,
            Dyadic::whole(-100)
        ]
    );
    assert_eq!((there.near, there.far), (Dyadic::of(1.0), Dyadic::of(5.0)));
}

#[test]
fn a_ray_meets_a_cubes_corner_edge_and_face() {
    let cube = at_origin(Shape::Cube);
    let hits = |origin, direction| cube.hits(&line(origin, direction), Sides::Both);
    // Through two opposite corners, where three faces meet: the first axis names the face.
    let through = hits(DVec3::splat(-1.5), DVec3::ONE);
    assert_eq!(in_short(&through), [(1.0, true), (2.0, false)]);
    assert_eq!(
        [through[0].face, through[1].face],
        [Some([-1, 0, 0]), Some([1, 0, 0])]
    );
    assert!(through.iter().all(|hit| hit.on_border));
    // This ray runs within the plane z = 1/2 and touches a corner. It enters by y = 1/2.
    let touching = hits(dvec3(-1.5, 2.5, 0.5), dvec3(1.0, -1.0, 0.0));
    assert_eq!(in_short(&touching), [(2.0, true)]);
    assert_eq!(touching[0].face, Some([0, 1, 0]));
    // Along an edge: in and out by the faces across.
    let along = hits(dvec3(0.5, 0.5, 3.0), DVec3::NEG_Z);
    assert_eq!(in_short(&along), [(2.5, true), (3.5, false)]);
    assert_eq!(
        [along[0].face, along[1].face],
        [Some([0, 0, 1]), Some([0, 0, -1])]
    );
    assert!(hits(dvec3(0.5_f64.next_up(), 0.5, 3.0), DVec3::NEG_Z).is_empty());
    // Mirrored it has the same faces.
    let mirrored = DAffine3::from_scale(dvec3(-2.0, 2.0, 2.0));
    let cube = World::of(&Scene::new(vec![object(Shape::Cube, mirrored)]));
    let hits = cube.hits(&line(dvec3(3.0, 0.25, 0.25), DVec3::NEG_X), Sides::Both);
    assert_eq!(in_short(&hits), [(2.0, true), (4.0, false)]);
    assert_eq!(
        [hits[0].face, hits[1].face],
        [Some([-1, 0, 0]), Some([1, 0, 0])]
    );
}

#[test]
fn a_tangent_to_a_sphere_is_one_hit_and_not_a_front_one() {
    let sphere = at_origin(Shape::Sphere);
    let along_x = |y| sphere.hits(&line(dvec3(-3.0, y, 0.0), DVec3::X), Sides::Both);
    assert_eq!(in_short(&along_x(0.5)), [(3.0, false)]);
    assert_eq!(in_short(&along_x(0.0)), [(2.5, true), (3.5, false)]);
    assert_eq!(along_x(0.5_f64.next_up()).len(), 0);
    let almost = along_x(0.5_f64.next_down());
    assert_eq!(almost.len(), 2);
    // Half the chord is sqrt(r^2 - y^2), with y one step of 2^-54 below r = 1/2: nearly 2^-27.
    let gap = almost[1].t.rounded_minus(&almost[0].t);
    assert!((gap / 2.0_f64.powi(-26) - 1.0).abs() < 1e-15, "{gap:e}");
    assert!(
        sphere
            .hits(&line(dvec3(-3.0, 0.5, 0.0), DVec3::X), Sides::Front)
            .is_empty()
    );
    // A ball of radius 3 at a distance of 5 is seen up to a slope of 3/4. It is touched 4 away, at a depth of 16 / 5.
    let model = DAffine3::from_mat3_translation(
        DMat3::from_diagonal(DVec3::splat(6.0)),
        dvec3(0.0, 0.0, -5.0),
    );
    let sphere = World::of(&Scene::new(vec![object(Shape::Sphere, model)]));
    let hits = sphere.hits(&line(DVec3::ZERO, dvec3(0.75, 0.0, -1.0)), Sides::Both);
    assert_eq!(in_short(&hits), [(3.2, false)]);
}

#[test]
fn coincident_faces_come_in_the_order_of_objects_and_triangles() {
    let corners = [
        [-0.5, -0.5, 0.0],
        [0.5, -0.5, 0.0],
        [0.5, 0.5, 0.0],
        [-0.5, 0.5, 0.0_f32],
    ];
    let quad = Shape::Mesh {
        mesh: mesh(
            corners.to_vec(),
            vec![[0, 1, 2], [0, 2, 3], [0, 2, 2]],
            DVec3::ZERO,
        ),
        part: 0,
    };
    let nearer = DAffine3::from_translation(dvec3(0.0, 0.0, 1e-17));
    let mut hidden = object(Shape::Square, DAffine3::IDENTITY);
    hidden.visible = false;
    let cube = object(
        Shape::Cube,
        DAffine3::from_translation(dvec3(0.0, 0.0, -0.5)),
    );
    let scene = Scene::new(vec![
        object(Shape::Square, DAffine3::IDENTITY),
        hidden,
        object(quad, DAffine3::IDENTITY),
        cube,
        object(Shape::Square, nearer),
    ]);
    let world = World::of(&scene);
    let mut down = line(dvec3(0.25, 0.25, 2.0), DVec3::NEG_Z);
    let order = |line: &Line| -> Vec<_> {
        let hits = world.hits(line, Sides::Both).into_iter();
        hits.map(|hit| (hit.object, hit.triangle)).collect()
    };
    // On the diagonal the ray hits both triangles. The third has no area.
    let all = [
        (4, None),
        (0, None),
        (2, Some(0)),
        (2, Some(1)),
        (3, None),
        (3, None),
    ];
    assert_eq!(order(&down), all);
    let hits = world.hits(&down, Sides::Both);
    assert_eq!(
        hits[1].t.rounded_minus(&hits[0].t).to_bits(),
        1e-17_f64.to_bits()
    );
    assert_eq!(hits[2].barycentric, Some([0.25, 0.0, 0.75]));
    // A hit at near counts, a hit at far does not.
    down.near = Dyadic::of(2.0);
    assert_eq!(order(&down), all[1..]);
    down.far = Dyadic::of(3.0);
    assert_eq!(order(&down), all[1..5]);
    down.near = Dyadic::of(2.0_f64.next_up());
    assert_eq!(order(&down), []);
    // In its plane no flat shape is hit; the cube's rim is.
    let within = line(dvec3(-2.0, 0.25, 0.0), DVec3::X);
    assert_eq!(order(&within), [(3, None), (3, None)]);
}
