//! Triangles that join count as one surface, and overlapping ones as several. Each surface is named, up to a limit.

use super::*;

/// Both triangles of a quad are hit on its diagonal.
#[test]
fn an_edge_that_two_triangles_share_is_one_surface() {
    let once = Scene::new(vec![object("once", halves(), DAffine3::IDENTITY)]);
    let twice = Scene::new(vec![
        object("A", halves(), DAffine3::IDENTITY),
        object("B", halves(), DAffine3::IDENTITY),
    ]);
    let view = view(
        [0.0, 0.0, 3.0],
        [0.0; 3],
        perspective(45.0, 0.1, 10.0),
        [64, 48],
    );
    let hits = |scene: &Scene, px| pick::all(scene, view.ray(px), view.sides).len();
    for i in -9..=9 {
        let px = dvec2(32.0 + f64::from(i), 24.0 - f64::from(i));
        assert_eq!([hits(&once, px), hits(&twice, px)], [2, 4], "{px}");
        assert_eq!(places(&once, &view).at(px), [], "{px}");
        let found = places(&twice, &view).at(px);
        let found: Vec<_> = found.iter().map(|hit| hit.object).collect();
        assert_eq!(found, [0, 1], "{px}");
    }
}

/// A shared edge begins behind the eye and passes the near plane, whichever of its ends comes first. A near plane just
/// before the eye cuts it far outside the picture.
#[test]
fn an_edge_through_the_near_plane_is_one_surface() {
    let positions = vec![
        [0.0, 0.0, 5.0],
        [0.0, 0.0, -5.0],
        [-3.0, -0.5, 0.0],
        [3.0, -0.5, 0.0],
    ];
    for near in [0.5, 1e-9, 1e-12, 1e-15] {
        let view = view(
            [0.0, 1.0, 2.0],
            [0.3, 0.0, -3.0],
            perspective(45.0, near, 20.0),
            [64, 48],
        );
        for triangles in [[[0, 1, 2], [1, 0, 3]], [[1, 0, 2], [0, 1, 3]]] {
            let mesh = one_mesh(positions.clone(), triangles.to_vec(), DVec3::ZERO);
            let scene = Scene::new(vec![object("roof", mesh, DAffine3::IDENTITY)]);
            let mut met = 0;
            for z in [-4.5, -4.0, -3.0, -2.0, -1.0, -0.5] {
                let on_edge = view.project(dvec3(0.0, 0.0, z)).expect("before the eye");
                let px = on_edge.px;
                met += pick::all(&scene, view.ray(px), view.sides).len();
                assert_eq!(
                    places(&scene, &view).at(px),
                    [],
                    "{triangles:?} {px} {near}"
                );
            }
            assert!(met >= 6, "{met}");
        }
    }
}

/// A face that meets a doubled one at an edge goes on in one of the two. The other is a second surface, whatever their
/// order in the file.
#[test]
fn a_face_that_meets_a_doubled_one_is_one_of_two_surfaces() {
    let positions = vec![
        [0.0, 0.0, 0.0],
        [0.0, 2.0, 0.0],
        [-1.0, 1.0, 0.0],
        [1.0, 1.0, 0.0],
    ];
    let (a, b) = ([0, 1, 2], [1, 0, 3]);
    let view = view(
        [0.0, 1.0, 3.0],
        [0.0, 1.0, 0.0],
        orthographic(4.0, 1.0, 10.0),
        [64, 64],
    );
    for (triangles, count) in [
        (vec![a, b], 0),
        (vec![a, b, b], 2),
        (vec![b, a, b], 2),
        (vec![b, b, a], 2),
        (vec![a, a, b, b], 2),
        (vec![a, b, a, b], 2),
        (vec![b, a, b, b, a], 3),
    ] {
        let mesh = one_mesh(positions.clone(), triangles.clone(), DVec3::ZERO);
        let scene = Scene::new(vec![object("fold", mesh, DAffine3::IDENTITY)]);
        let px = dvec2(32.0, 32.0);
        let hits = pick::all(&scene, view.ray(px), view.sides).len();
        assert_eq!(hits, triangles.len());
        assert_eq!(places(&scene, &view).at(px).len(), count, "{triangles:?}");
    }
}

/// A shared corner may lie before the near plane by less than drawing can tell: here by 4e-16.
#[test]
fn a_corner_in_the_near_plane_joins_its_faces() {
    let positions = vec![
        [-0.465_458_3, 0.807_706_1, -0.917_860_2],
        [-1.515_575_9, 1.936_890_4, -0.924_312_6],
        [-2.057_510_6, 2.105_796_3, -0.996_426_5],
        [-0.740_674_14, 1.357_709_8, -0.935_404_4],
        [-1.431_08, 1.127_110_2, -1.961_223_1],
    ];
    let mesh = one_mesh(positions, vec![[0, 1, 2], [0, 3, 4]], DVec3::ZERO);
    let scene = Scene::new(vec![object("fold", mesh, DAffine3::IDENTITY)]);
    let eye = dvec3(
        2.140_443_836_292_02,
        -2.918_331_313_112_825_7,
        0.867_556_254_618_633_7,
    );
    let to = dvec3(
        -2.489_373_660_134_218_5,
        3.486_848_386_958_327,
        -1.668_641_411_569_155_5,
    );
    let up = dvec3(
        -0.809_729_614_582_882_3,
        0.057_165_698_178_625_934,
        -0.814_756_246_029_759_7,
    );
    let px = dvec2(6.526_098_394_556_752, 46.993_838_864_447_56);
    for near in [4.88, 4.884_635_064_010_97] {
        let lens = Lens {
            depth: DepthMapping::Standard,
            ..orthographic(0.1, near, 54.884_635_064_010_97)
        };
        let view = View {
            camera: Camera::new(eye, eye + to, up, lens).expect("a camera"),
            ..view([0.0; 3], [0.0, 0.0, 1.0], lens, [64, 64])
        };
        assert!(pick::closest(&scene, view.ray(px), view.sides).is_some());
        assert_eq!(places(&scene, &view).at(px), [], "{near}");
    }
}

/// Two pairs of triangles of one mesh fill the same square with different diagonals. On the square's edge they overlap.
#[test]
fn an_edge_that_two_overlapping_triangles_share_is_of_two() {
    let positions = vec![
        [-1.0, -1.0, 0.0],
        [1.0, -1.0, 0.0],
        [1.0, 1.0, 0.0],
        [-1.0, 1.0, 0.0],
    ];
    let triangles = vec![[0, 1, 2], [0, 2, 3], [0, 1, 3], [1, 2, 3]];
    let mesh = one_mesh(positions, triangles, DVec3::ZERO);
    let scene = Scene::new(vec![object("both", mesh, DAffine3::IDENTITY)]);
    let view = view(
        [0.0, 0.0, 4.0],
        [0.0; 3],
        orthographic(4.0, 0.1, 10.0),
        [64, 64],
    );
    for y in [20.0, 31.0, 40.0] {
        for x in [16.0, 16.001, 16.3, 30.0] {
            let said = in_one_place(&scene, &view, dvec2(x, y)).expect("two");
            assert_eq!(said.count, 2, "{x} {y} {said}");
        }
    }
}

/// Two coplanar triangles that share a corner are two surfaces if they overlap there, and one if they lie side by side.
#[test]
fn overlapping_triangles_that_share_a_corner_are_two() {
    let corners = [[0.0, 0.0], [-1.0, 2.0], [2.0, 2.2], [1.0, 1.3], [0.5, 2.0]];
    let positions = corners.map(|[x, y]| [x, y, 0.0]).to_vec();
    let view = view(
        [0.0, 0.0, 5.0],
        [0.0; 3],
        orthographic(8.0, 0.1, 10.0),
        [64, 64],
    );
    for (triangles, count) in [
        (vec![[0, 2, 1], [0, 3, 4]], Some(2)),
        (vec![[0, 2, 1], [0, 4, 3]], Some(2)),
        (vec![[0, 2, 4], [0, 4, 1]], None),
        (vec![[0, 2, 3], [0, 4, 1]], None),
    ] {
        let mesh = one_mesh(positions.clone(), triangles, DVec3::ZERO);
        let scene = Scene::new(vec![object("fan", mesh, DAffine3::IDENTITY)]);
        // On the corner, beside it by far less than the grid's step, and farther off.
        for px in [[32.0, 32.0], [32.0005, 31.999], [32.0025, 31.995]] {
            let said = in_one_place(&scene, &view, px.into());
            assert_eq!(said.map(|said| said.count), count, "{px:?}");
        }
    }
}

/// T-junctions: a large triangle, on whose long edge lie corners of others, in a plane that no axis follows. Exactly on
/// the common part of the edges, both triangles are hit.
#[test]
fn triangles_that_touch_at_a_t_junction_are_one_surface_unless_they_overlap() {
    // Whole numbers, so that corners lie on the edge exactly.
    let along = dvec3(3.0, 1.0, 1.0);
    let aside = dvec3(-2.0, 5.0, 1.0);
    let at = |x: f64, y: f64| (x * along + y * aside).as_vec3().to_array();
    let large = [at(-4.0, 0.0), at(0.0, -8.0), at(4.0, 0.0)];
    // The ray is the z axis, to the last bit.
    let px = dvec2(32.0, 32.0);
    let view = view(
        [0.0, 0.0, 60.0],
        [0.0; 3],
        orthographic(64.0, 0.1, 200.0),
        [64, 64],
    );
    let lifted = |[x, y, z]: [f32; 3]| [x, y, z + 5.0];
    for (other, count, what) in [
        (
            [at(-2.0, 0.0), at(2.0, 0.0), at(0.0, 4.0)],
            None,
            "two of its corners",
        ),
        (
            [at(0.0, 0.0), at(6.0, 0.0), at(3.0, 4.0)],
            None,
            "one of its corners, and one of the large one's on it",
        ),
        (
            [at(0.0, 0.0), at(1.0, 4.0), at(-1.0, 4.0)],
            None,
            "one corner, in a point",
        ),
        (
            [at(-2.0, 0.0), at(2.0, 0.0), lifted(at(0.0, 4.0))],
            None,
            "folded",
        ),
        (
            [at(-2.0, 0.0), at(2.0, 0.0), at(0.0, -3.0)],
            Some(2),
            "over the large one",
        ),
        (
            [at(0.0, 0.0), at(1.0, -1.0), at(-1.0, -2.0)],
            Some(2),
            "over it, with one corner",
        ),
        (
            [at(0.0, 0.0), at(2.0, -1.0), at(1.0, 3.0)],
            Some(2),
            "partly over it",
        ),
    ] {
        // Either may be the first, and run either way around.
        let [a, b, c] = other;
        for other in [[a, b, c], [c, b, a]] {
            for order in [[0, 1, 2, 3, 4, 5], [3, 4, 5, 0, 1, 2]] {
                let corners = [large, other].concat();
                let [p, q, r, s, t, u] = order;
                let mesh = one_mesh(corners, vec![[p, q, r], [s, t, u]], DVec3::ZERO);
                let scene = Scene::new(vec![object("T", mesh, DAffine3::IDENTITY)]);
                let hits = pick::all(&scene, view.ray(px), view.sides).len();
                assert_eq!(hits, 2, "{what}: both are hit");
                let said = in_one_place(&scene, &view, px);
                assert_eq!(said.map(|said| said.count), count, "{what}, {order:?}");
            }
        }
    }
}

#[test]
fn identical_triangles_are_as_many_surfaces() {
    for count in [2, 10_000] {
        let scene = Scene::new(vec![object(
            "faces",
            quad(vec![[0, 1, 2]; count]),
            DAffine3::IDENTITY,
        )]);
        scene.build_trees();
        let view = view(
            [0.0, 0.0, 3.0],
            [0.0; 3],
            perspective(45.0, 0.1, 10.0),
            [64, 48],
        );
        // Within, on an edge, on a corner.
        for px in [dvec2(40.5, 30.5), dvec2(35.0, 21.0), dvec2(32.0, 24.0)] {
            let said = in_one_place(&scene, &view, px).expect("identical ones");
            assert_eq!(said.count, count);
            let named: Vec<_> = said.named.iter().map(|at| at.triangle).collect();
            let expected: Vec<_> = (0..8).take(count).map(Some).collect();
            assert_eq!(named, expected);
            let start = "in one place: faces triangle 0";
            let text = if count == 2 {
                format!("two {start} and faces triangle 1")
            } else {
                let rest = [1, 2, 3, 4, 5, 6, 7].map(|i| format!(", faces triangle {i}"));
                format!("10000 {start}{} and 9992 more", rest.concat())
            };
            assert_eq!(said.to_string(), text);
        }
    }
}

/// A ray is tangent to a ball at a point on a board.
#[test]
fn a_touched_rim_and_a_board_are_two() {
    let scaled = |scale| DAffine3::from_scale(DVec3::splat(scale));
    let scene = Scene::new(vec![
        object("ball", Shape::Sphere, scaled(2.0)),
        object("board", Shape::Square, scaled(4.0)),
    ]);
    let view = view(
        [0.0, 0.0, 5.0],
        [0.0; 3],
        orthographic(4.0625, 0.1, 10.0),
        [65, 65],
    );
    for px in [[48.5, 32.5], [16.5, 32.5], [32.5, 48.5], [32.5, 16.5]] {
        let hits = pick::all(&scene, view.ray(px.into()), view.sides);
        let places: Vec<_> = hits.iter().map(|at| (at.object, at.hit.t)).collect();
        assert_eq!(places, [(0, 5.0), (1, 5.0)], "{px:?}");
        let said = in_one_place(&scene, &view, px.into()).expect("two");
        assert_eq!(said.to_string(), "two in one place: ball and board");
    }
}

/// A solid's front and back meet at its rim and are one surface there. The front and back of a thin mesh are two.
#[test]
fn a_rim_is_one_surface_and_a_thin_sheet_two() {
    let (positions, triangles) = box_triangles(1.0);
    let mesh = one_mesh(positions, triangles, DVec3::ZERO);
    let turn = DMat3::from_rotation_y(0.5) * DMat3::from_rotation_x(0.4);
    let lenses = [perspective(45.0, 0.1, 10.0), orthographic(2.0, 0.1, 10.0)];
    let mut both_hit = 0;
    for shape in [Shape::Cube, mesh, Shape::Sphere] {
        for lens in lenses {
            let view = view([0.2, 0.1, 3.0], [0.0; 3], lens, [64, 48]);
            let solid = |thick: f64| {
                let linear = turn * DMat3::from_diagonal(dvec3(1.0, 1.0, thick));
                Scene::new(vec![object(
                    "it",
                    shape.clone(),
                    DAffine3::from_mat3(linear),
                )])
            };
            let scene = solid(1.0);
            let places = places(&scene, &view);
            // Bisection between inside and outside finds the rim as closely as f64 allows.
            for i in 0..60 {
                let (sin, cos) = (0.1 * f64::from(i)).sin_cos();
                let ray = |s: f64| dvec2(32.0, 24.0) + s * dvec2(cos, sin);
                let hit = |s: f64| pick::closest(&scene, view.ray(ray(s)), view.sides).is_some();
                let (mut inside, mut outside) = (0.0, 30.0);
                while 0.5 * (inside + outside) > inside && 0.5 * (inside + outside) < outside {
                    let middle = 0.5 * (inside + outside);
                    *(if hit(middle) {
                        &mut inside
                    } else {
                        &mut outside
                    }) = middle;
                }
                for back in [
                    0.0, 1e-12, 1e-9, 1e-6, 1e-4, 1e-3, 3e-3, 4e-3, 5e-3, 1e-2, 0.1, 1.0,
                ] {
                    let px = ray(inside - back);
                    both_hit += pick::all(&scene, view.ray(px), view.sides).len() / 2;
                    let found = places.at(px);
                    assert_eq!(found, [], "{} {back} from the rim at {px}", shape.kind());
                }
            }
            let said = in_one_place(&solid(1e-9), &view, dvec2(33.0, 22.0));
            let fronts = said.map(|said| said.named.iter().map(|at| at.front).collect::<Vec<_>>());
            let is_mesh = shape.triangles().is_some();
            assert_eq!(fronts, is_mesh.then(|| vec![true, false]));
        }
    }
    assert!(both_hit > 4000, "{both_hit}");
}

#[test]
fn what_is_named_is_capped_and_counted() {
    let scene = Scene::new(
        (0..20)
            .map(|i| object(&format!("S{i}"), Shape::Square, turned(f64::from(i), 1.0)))
            .collect(),
    );
    let view = view(
        [0.0, 0.0, 3.0],
        [0.0; 3],
        perspective(45.0, 0.1, 10.0),
        [64, 48],
    );
    let said = in_one_place(&scene, &view, dvec2(32.5, 24.5)).expect("all of them");
    let InOnePlace { count, named } = &said;
    assert_eq!((*count, named.len()), (20, MOST_NAMED));
    assert_eq!(
        said.to_string(),
        "20 in one place: S0, S1, S2, S3, S4, S5, S6, S7 and 12 more"
    );
}
