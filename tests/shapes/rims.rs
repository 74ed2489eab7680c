//! Rays exactly or nearly through rims, edges and silhouettes hit as exact arithmetic says.

use crate::{
    common::{Random, placements, scene_of},
    exact::{line::Line, truth::World},
};
use glam::{DAffine3, DVec3, dvec3};
use sightline::{
    geometry::{Ray, Sides},
    pick,
    scene::{Scene, Shape},
};

/// Fails unless a ray's hits are those of exact arithmetic. Returns their count, and the count of those on a border.
#[track_caller]
pub fn as_exact(scene: &Scene, ray: &Ray) -> [usize; 2] {
    let ray = &Ray {
        t_min: ray.t_min.max(-1e9),
        t_max: ray.t_max.min(1e9),
        ..*ray
    };
    let truth = World::of(scene).hits(&Line::given(ray), Sides::Both);
    let found = pick::all(scene, ray, Sides::Both);
    let said: Vec<_> = found
        .iter()
        .map(|hit| {
            let triangle = hit.hit.on_triangle.map(|at| at.triangle);
            (triangle, hit.hit.front)
        })
        .collect();
    let exact: Vec<_> = truth.iter().map(|hit| (hit.triangle, hit.front)).collect();
    assert_eq!(said, exact, "{:?} {ray:?}", scene.objects()[0]);
    let closest = pick::closest(scene, ray, Sides::Both);
    assert_eq!(closest.as_ref(), found.first(), "{ray:?}");
    [
        truth.len(),
        truth.iter().filter(|hit| hit.on_border).count(),
    ]
}

/// A point on a rim, an edge, a corner or a silhouette; for a sphere also a direction that grazes it there.
fn on_border(random: &mut Random, shape: &Shape) -> (DVec3, Option<DVec3>) {
    let mut p = DVec3::from_array(std::array::from_fn(|_| {
        [-0.5, 0.5, 0.0, 0.25, random.within(-0.5, 0.5)][random.below(5)]
    }));
    match shape {
        Shape::Sphere => {
            let normal = [random.direction(), DVec3::AXES[random.below(3)]][random.below(2)];
            (0.5 * normal, Some(normal.cross(random.direction())))
        }
        Shape::Square => {
            p[random.below(2)] = 0.5;
            (p.with_z(0.0), None)
        }
        _ => {
            let first = random.below(3);
            (p[first], p[(first + 1) % 3]) = (0.5, -0.5);
            (p, None)
        }
    }
}

#[test]
fn rims_edges_and_silhouettes_belong_to_shapes() {
    let mut random = Random::new(25);
    let mut counts = [[0; 2]; 3];
    let identity = [("identity", DAffine3::IDENTITY); 5];
    for (_, model) in placements().into_iter().chain(identity) {
        for (i, shape) in [Shape::Sphere, Shape::Cube, Shape::Square]
            .into_iter()
            .enumerate()
        {
            let scene = scene_of(shape.clone(), model);
            for _ in 0..300 {
                let (point, along) = on_border(&mut random, &shape);
                let whole = dvec3(0.0, 1.0, 2.0).map(|c| (random.within(-3.0, 3.0) + c).round());
                let direction = along.unwrap_or([random.direction(), whole][random.below(2)]);
                let back = [2.0, random.within(1.0, 3.0)][random.below(2)];
                let origin = model.transform_point3(point - back * direction);
                let direction = model.transform_vector3(direction);
                if direction == DVec3::ZERO {
                    continue;
                }
                let ray = Ray {
                    origin,
                    direction,
                    t_min: 0.0,
                    t_max: 1e9,
                };
                let [hits, borders] = as_exact(&scene, &ray);
                counts[i][0] += usize::from(hits > 0);
                counts[i][1] += usize::from(borders > 0);
            }
        }
    }
    println!("spheres, cubes, squares: rays that hit, and of these on a border {counts:?}");
    assert!(
        counts
            .iter()
            .all(|[hits, borders]| *hits > 1500 && *borders > 50),
        "{counts:?}"
    );
}
