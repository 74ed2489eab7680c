//! The measured libraries behind two traits: how to build a tree, and how to find nearest hits with it.

use crate::{
    embree,
    memory::{Cost, cost_of},
    meshes::Sample,
};
use glam::{DVec3, Vec3A};
use obvhs::{
    BvhBuildParams,
    bvh2::{self, Bvh2},
    cwbvh::{self, CwBvh},
    ray::RayHit,
    rt_triangle::RtTriangle,
    triangle::Triangle,
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

/// A way to build a tree.
pub trait Rival {
    fn name(&self) -> &'static str;
    fn build(&self, sample: &Sample) -> (Box<dyn Built>, Cost);
}

/// A tree.
pub trait Built {
    /// One answer a ray.
    fn closest(&self, rays: &[Ray], answers: &mut [Answer]);
}

/// All rivals; Embree, where it is installed, comes right after Sightline.
pub fn all() -> Vec<Box<dyn Rival>> {
    let mut all: Vec<Box<dyn Rival>> = vec![Box::new(Sightline)];
    for embree in embree::installed() {
        all.push(Box::new(embree));
    }
    all.extend([
        Box::new(Obvhs::Eight) as _,
        Box::new(Obvhs::Two) as _,
        Box::new(Parry) as _,
    ]);
    #[cfg(all(feature = "tinybvh", target_feature = "avx2"))]
    all.push(Box::new(TinyBvh));
    all
}

struct Sightline;

impl Rival for Sightline {
    fn name(&self) -> &'static str {
        "Sightline"
    }

    fn build(&self, sample: &Sample) -> (Box<dyn Built>, Cost) {
        let mesh = Mesh::new(sample.data()).expect("a mesh");
        let ((), cost) = cost_of(|| mesh.build_tree());
        (Box::new(mesh), cost)
    }
}

impl Built for Mesh {
    fn closest(&self, rays: &[Ray], answers: &mut [Answer]) {
        for (ray, answer) in rays.iter().zip(answers) {
            let hit = Mesh::closest(self, ray, Sides::Both, |_| true);
            *answer = hit.and_then(|hit| Some((hit.t, hit.on_triangle?.triangle)));
        }
    }
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

/// obvhs, with nodes of eight or of two.
#[derive(Clone, Copy)]
enum Obvhs {
    Eight,
    Two,
}

enum ObvhsTree {
    Eight(CwBvh),
    Two(Bvh2),
}

impl ObvhsTree {
    /// The index of the triangle in each place of the tree's order.
    fn order(&self) -> &[u32] {
        match self {
            Self::Eight(tree) => &tree.primitive_indices,
            Self::Two(tree) => &tree.primitive_indices,
        }
    }
}

/// A tree, and the triangles in the tree's order.
struct ObvhsBuilt(ObvhsTree, Vec<RtTriangle>);

impl Rival for Obvhs {
    fn name(&self) -> &'static str {
        match self {
            Self::Eight => "obvhs CWBVH",
            Self::Two => "obvhs BVH2",
        }
    }

    fn build(&self, sample: &Sample) -> (Box<dyn Built>, Cost) {
        use {bvh2::builder::build_bvh2_from_tris, cwbvh::builder::build_cwbvh_from_tris};
        let triangles = obvhs_triangles(sample);
        let (built, cost) = cost_of(|| {
            let (params, mut spent) = (BvhBuildParams::medium_build(), Duration::default());
            let tree = match self {
                Self::Eight => {
                    ObvhsTree::Eight(build_cwbvh_from_tris(&triangles, params, &mut spent))
                }
                Self::Two => ObvhsTree::Two(build_bvh2_from_tris(&triangles, params, &mut spent)),
            };
            let in_order = tree.order().iter().map(|&i| &triangles[i as usize]);
            let in_order = in_order.map(RtTriangle::from).collect();
            ObvhsBuilt(tree, in_order)
        });
        (Box::new(built), cost)
    }
}

impl Built for ObvhsBuilt {
    fn closest(&self, rays: &[Ray], answers: &mut [Answer]) {
        let Self(tree, triangles) = self;
        for (ray, answer) in rays.iter().zip(answers) {
            let mut hit = RayHit::none();
            let test = |ray: &obvhs::ray::Ray, id: usize| triangles[id].intersect(ray);
            let found = match tree {
                ObvhsTree::Eight(tree) => tree.ray_traverse(obvhs_ray(ray), &mut hit, test),
                ObvhsTree::Two(tree) => tree.ray_traverse(obvhs_ray(ray), &mut hit, test),
            };
            let triangle = |id: u32| tree.order()[id as usize];
            *answer = found.then(|| (f64::from(hit.t), triangle(hit.primitive_id)));
        }
    }
}

/// tinybvh's tree of eight for CPUs, which its crate has only where the whole program is compiled for AVX2.
#[cfg(all(feature = "tinybvh", target_feature = "avx2"))]
struct TinyBvh;

#[cfg(all(feature = "tinybvh", target_feature = "avx2"))]
impl Rival for TinyBvh {
    fn name(&self) -> &'static str {
        "tinybvh BVH8"
    }

    fn build(&self, sample: &Sample) -> (Box<dyn Built>, Cost) {
        let corner = |i: u32| {
            let [x, y, z] = sample.positions[i as usize];
            [x, y, z, 0.0]
        };
        let corners: Vec<_> = sample
            .triangles
            .iter()
            .flat_map(|t| t.map(corner))
            .collect();
        let (built, cost) = cost_of(|| {
            let mut two = tinybvh_rs::bvh::BVH::new(corners.as_slice().into()).expect("triangles");
            two.split_leaves(4);
            let wide = tinybvh_rs::mbvh::BVH::new(&two);
            tinybvh_rs::bvh8_cpu::BVH::new(&wide).expect("leaves of four")
        });
        // Its C++ allocations are not counted.
        let cost = Cost {
            memory: None,
            ..cost
        };
        (Box::new(built), cost)
    }
}

#[cfg(all(feature = "tinybvh", target_feature = "avx2"))]
impl Built for tinybvh_rs::bvh8_cpu::BVH {
    fn closest(&self, rays: &[Ray], answers: &mut [Answer]) {
        use tinybvh_rs::Intersector;
        let narrow = |v: DVec3| v.as_vec3().to_array();
        for (ray, answer) in rays.iter().zip(answers) {
            let mut asked = tinybvh_rs::Ray::new(narrow(ray.origin), narrow(ray.direction));
            self.intersect(&mut asked);
            let hit = asked.hit;
            *answer = (hit.t < tinybvh_rs::INFINITE).then(|| (f64::from(hit.t), hit.prim));
        }
    }
}

struct Parry;

impl Rival for Parry {
    fn name(&self) -> &'static str {
        "parry3d"
    }

    fn build(&self, sample: &Sample) -> (Box<dyn Built>, Cost) {
        let vertices = sample.positions.iter().map(|&p| Vector::from(p));
        let (vertices, triangles): (Vec<_>, _) = (vertices.collect(), sample.triangles.clone());
        let (mesh, cost) = cost_of(|| TriMesh::new(vertices, triangles).expect("a mesh"));
        (Box::new(mesh), cost)
    }
}

impl Built for TriMesh {
    fn closest(&self, rays: &[Ray], answers: &mut [Answer]) {
        let narrow = |v: DVec3| Vector::from(v.as_vec3().to_array());
        let count = u32::try_from(self.indices().len()).expect("fits");
        for (ray, answer) in rays.iter().zip(answers) {
            let asked = parry3d::query::Ray::new(narrow(ray.origin), narrow(ray.direction));
            let hit = self.cast_local_ray_and_get_normal(&asked, f32::INFINITY, false);
            *answer = hit.and_then(|hit| match hit.feature {
                // Indices of back faces come after those of front faces.
                FeatureId::Face(face) => Some((f64::from(hit.time_of_impact), face % count)),
                _ => None,
            });
        }
    }
}
