//! The measured libraries: each builds a tree and finds nearest hits with it.

use crate::{
    allocations::{Cost, cost_of},
    embree,
    meshes::Sample,
};
use glam::{DVec3, Vec3A};
use obvhs::{
    BvhBuildParams, bvh2::builder::build_bvh2_from_tris, cwbvh::builder::build_cwbvh_from_tris,
    ray::RayHit, rt_triangle::RtTriangle, triangle::Triangle,
};
use parry3d::{
    math::Vector,
    query::RayCast,
    shape::{FeatureId, TriMesh},
};
use sightline::geometry::{Mesh, Ray, Sides};
use std::time::Duration;

/// Ray parameter and triangle of the nearest hit.
pub type Answer = Option<(f64, u32)>;

/// Finds one answer a ray.
pub type Closest = Box<dyn Fn(&[Ray], &mut [Answer])>;

/// The search in a built tree, and the cost of the build.
pub type Built = (Closest, Cost);

/// A library: its name, and how it builds a tree.
pub struct Rival {
    pub name: &'static str,
    pub build: Box<dyn Fn(&Sample) -> Built>,
}

impl Rival {
    pub fn new(name: &'static str, build: impl Fn(&Sample) -> Built + 'static) -> Self {
        let build = Box::new(build);
        Self { name, build }
    }
}

/// obvhs, by one of its builders.
macro_rules! obvhs {
    ($name:literal, $build:ident) => {
        Rival::new($name, |sample| {
            let triangles = obvhs_triangles(sample);
            let ((tree, in_order), cost) = cost_of(|| {
                let (params, mut spent) = (BvhBuildParams::medium_build(), Duration::default());
                let tree = $build(&triangles, params, &mut spent);
                let in_order = tree.primitive_indices.iter();
                let in_order = in_order.map(|&i| RtTriangle::from(&triangles[i as usize]));
                let in_order: Vec<_> = in_order.collect();
                (tree, in_order)
            });
            let closest = one_by_one(move |ray| {
                let mut hit = RayHit::none();
                let test = |ray: &obvhs::ray::Ray, id: usize| in_order[id].intersect(ray);
                let found = tree.ray_traverse(obvhs_ray(ray), &mut hit, test);
                let triangle = |id: u32| tree.primitive_indices[id as usize];
                found.then(|| (f64::from(hit.t), triangle(hit.primitive_id)))
            });
            (closest, cost)
        })
    };
}

/// All rivals; Embree, where it is installed, comes right after Sightline.
pub fn all() -> Vec<Rival> {
    let mut all = vec![Rival::new("Sightline", sightline)];
    all.extend(embree::installed());
    all.extend([
        obvhs!("obvhs CWBVH", build_cwbvh_from_tris),
        obvhs!("obvhs BVH2", build_bvh2_from_tris),
        Rival::new("parry3d", parry),
    ]);
    #[cfg(all(feature = "tinybvh", target_feature = "avx2"))]
    all.push(Rival::new("tinybvh BVH8", tinybvh));
    all
}

/// One ray after the other.
fn one_by_one(closest: impl Fn(&Ray) -> Answer + 'static) -> Closest {
    Box::new(move |rays, answers| {
        for (ray, answer) in rays.iter().zip(answers) {
            *answer = closest(ray);
        }
    })
}

fn sightline(sample: &Sample) -> Built {
    let mesh = Mesh::new(sample.data()).expect("a mesh");
    let ((), cost) = cost_of(|| mesh.build_tree());
    let closest = one_by_one(move |ray| {
        let hit = mesh.closest(ray, Sides::Both, |_| true)?;
        Some((hit.t, hit.on_triangle?.triangle))
    });
    (closest, cost)
}

fn obvhs_triangles(sample: &Sample) -> Vec<Triangle> {
    let corner = |i: u32| Vec3A::from(sample.positions[i as usize]);
    let triangles = sample.triangles.iter().map(|t| t.map(corner));
    let triangles = triangles.map(|[v0, v1, v2]| Triangle { v0, v1, v2 });
    triangles.collect()
}

fn obvhs_ray(ray: &Ray) -> obvhs::ray::Ray {
    #[expect(clippy::cast_possible_truncation, reason = "f32 holds it")]
    obvhs::ray::Ray::new(
        ray.origin.as_vec3a(),
        ray.direction.as_vec3a(),
        ray.t_min as f32,
        ray.t_max as f32,
    )
}

/// tinybvh's tree of eight for CPUs, which its crate has only where the whole program is compiled for AVX2.
#[cfg(all(feature = "tinybvh", target_feature = "avx2"))]
fn tinybvh(sample: &Sample) -> Built {
    use tinybvh_rs::Intersector;
    let corner = |i: u32| {
        let [x, y, z] = sample.positions[i as usize];
        [x, y, z, 0.0]
    };
    let corners = sample.triangles.iter().flat_map(|t| t.map(corner));
    let corners: Vec<_> = corners.collect();
    let (tree, cost) = cost_of(|| {
        let mut two = tinybvh_rs::bvh::BVH::new(corners.as_slice().into()).expect("triangles");
        two.split_leaves(4);
        let wide = tinybvh_rs::mbvh::BVH::new(&two);
        tinybvh_rs::bvh8_cpu::BVH::new(&wide).expect("leaves of four")
    });
    // Its C++ allocations are not counted.
    let memory = None;
    let narrow = |v: DVec3| v.as_vec3().to_array();
    let closest = one_by_one(move |ray| {
        let mut asked = tinybvh_rs::Ray::new(narrow(ray.origin), narrow(ray.direction));
        tree.intersect(&mut asked);
        let hit = asked.hit;
        (hit.t < tinybvh_rs::INFINITE).then(|| (f64::from(hit.t), hit.prim))
    });
    (closest, Cost { memory, ..cost })
}

fn parry(sample: &Sample) -> Built {
    let vertices = sample.positions.iter().map(|&p| Vector::from(p));
    let (vertices, triangles): (Vec<_>, _) = (vertices.collect(), sample.triangles.clone());
    let (mesh, cost) = cost_of(|| TriMesh::new(vertices, triangles).expect("a mesh"));
    let narrow = |v: DVec3| Vector::from(v.as_vec3().to_array());
    let count = u32::try_from(mesh.indices().len()).expect("fits");
    let closest = one_by_one(move |ray| {
        let asked = parry3d::query::Ray::new(narrow(ray.origin), narrow(ray.direction));
        let hit = mesh.cast_local_ray_and_get_normal(&asked, f32::INFINITY, false)?;
        match hit.feature {
            // Indices of back faces come after those of front faces.
            FeatureId::Face(face) => Some((f64::from(hit.time_of_impact), face % count)),
            _ => None,
        }
    });
    (closest, cost)
}
