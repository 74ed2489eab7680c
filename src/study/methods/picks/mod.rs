//! Whole picks: from a pixel to the visible object and triangle, all steps together.

mod ball;
mod truth;

pub(super) use ball::icosahedron;
pub use ball::{ball_scene, gpu};

use super::{
    rays::{PixelCase, PixelRay, course, far_less_near},
    triangles::{RayTriangle, areas, moeller_trumbore},
};
use crate::{
    camera::View,
    geometry::{Mesh, Sides},
    image::{Id, Image},
    look::Background,
    pick,
    render::{self, Renderer, SceneBuffers, Targets},
    scene::{Object, Scene, Shape},
    study::prelude::*,
};
use glam::DVec2;
use num_traits::ToPrimitive;
use std::{
    sync::{Arc, OnceLock},
    time::Instant,
};

/// A scene as each kind of method picks from it. What only whole picks need is made once one of them asks for it: the
/// other steps take their cases from the same scene.
#[derive(Debug)]
pub struct PickWorld {
    /// With trees over all meshes that are worth one.
    pub scene: Scene,
    /// The view.
    pub view: View,
    treeless: OnceLock<Scene>,
    ids: OnceLock<Option<Image<Id>>>,
    flat: OnceLock<Vec<(usize, Flat)>>,
}

/// An object as a program in `f32` world coordinates holds it.
#[derive(Debug)]
enum Flat {
    /// A mesh: its triangles in the world, counter-clockwise from outside.
    Triangles(Vec<[V3<f32>; 3]>),
    /// Another shape alone in a scene, which Sightline tests.
    Shape(Scene),
}

impl Flat {
    fn new(object: &Object) -> Self {
        let Shape::Mesh { mesh, part } = &object.shape else {
            return Self::Shape(Scene::new(vec![object.clone()]));
        };
        let corners = |triangle: u32| {
            let mut corners = mesh.corners(triangle);
            if object.placement.mirrors() {
                corners.swap(1, 2);
            }
            corners.map(|corner| V3::of(object.placement.point_to_world(corner).into()))
        };
        let triangles = mesh.part_triangles(*part);
        Self::Triangles(triangles.map(corners).collect())
    }
}

impl PickWorld {
    /// Builds the trees of the scene's meshes.
    pub(in crate::study) fn new(scene: &Scene, view: View) -> Self {
        scene.build_trees();
        Self {
            scene: scene.clone(),
            view,
            treeless: OnceLock::new(),
            ids: OnceLock::new(),
            flat: OnceLock::new(),
        }
    }

    /// The scene without any tree.
    fn treeless(&self) -> &Scene {
        self.treeless.get_or_init(|| copy(&self.scene))
    }

    /// The ids that a graphics adapter draws; `None` where there is no adapter.
    fn ids(&self) -> Option<&Image<Id>> {
        let draw = || {
            let (ids, _) =
                render::render(gpu()?, &self.scene, &self.view, None, Background::DARK).ok()?;
            Some(ids)
        };
        self.ids.get_or_init(draw).as_ref()
    }

    /// The visible objects in `f32`, with their indices.
    fn flat(&self) -> &[(usize, Flat)] {
        self.flat.get_or_init(|| {
            let visible = (0..).zip(self.scene.objects());
            let visible = visible.filter(|(_, object)| object.visible);
            let flat = visible.map(|(index, object)| (index, Flat::new(object)));
            flat.collect()
        })
    }
}

/// The same objects over meshes of their own, which have no trees yet.
fn copy(scene: &Scene) -> Scene {
    let mut meshes: Vec<(Arc<Mesh>, Arc<Mesh>)> = Vec::new();
    let mut own = |mesh: &Arc<Mesh>| {
        if let Some((_, copy)) = meshes.iter().find(|(known, _)| Arc::ptr_eq(known, mesh)) {
            return Arc::clone(copy);
        }
        // A valid mesh's copy is valid.
        let copy = Mesh::new(mesh.data().clone()).map_or_else(|_| Arc::clone(mesh), Arc::new);
        meshes.push((Arc::clone(mesh), Arc::clone(&copy)));
        copy
    };
    let objects = scene.objects().iter().cloned().map(|mut object| {
        if let Shape::Mesh { mesh, .. } = &mut object.shape {
            *mesh = own(mesh);
        }
        object
    });
    objects.collect()
}

/// A click.
#[derive(Clone, Debug)]
pub struct PickCase {
    /// The scene.
    pub world: Arc<PickWorld>,
    /// The centre of a pixel.
    pub px: DVec2,
    /// The pixel as methods of the first step take it.
    pixel: PixelCase,
}

/// Object index and, on a mesh, the triangle within that object.
pub type Picked = Option<(usize, Option<u32>)>;

const COURSE: &str = "courses: every step as they teach it, over all triangles";
const USUAL: &str = "most viewers and tutorials: through the inverse of P * V, then Moeller & Trumbore over all triangles";
const IDS: &str = "picking by colour: draw ids for the click, read the picture back";
const ID: &str = "picking by colour: ids are drawn with each frame; one pixel is read back";

const OURS: &str = "pick::closest, over trees";

impl Case for PickCase {
    type Answer = Picked;
    type Truth = Picked;
    const ABOUT: About = about!(
        "Whole pick" "pick", off by "", wrong by "";
        "a click on a scene that is ready to be picked from: object and triangle"
    );
    const TIMED: usize = 24;
    const MOST_ROUNDS: usize = 11;

    fn count(effort: Effort) -> usize {
        effort.picks
    }

    const METHODS: Methods<Self> = &[&[
        Method::new("the course's", F32, COURSE, |c| {
            c.cast_f32(course(&c.pixel.narrow), areas)
        }),
        Method::new("unproject, Moeller-Trumbore", F32, USUAL, |c| {
            let ray = far_less_near(&c.pixel.narrow);
            c.cast_f32(ray, |case| moeller_trumbore(case, 0.0))
        }),
        Method::new(GPU_IDS, F32, IDS, PickCase::drawn),
        Method::new(GPU_ID, F32, ID, PickCase::drawn),
        Method::new(
            "Sightline's without its tree",
            Precision::Exact,
            "pick::closest",
            |c| sightlines(c.world.treeless(), c),
        ),
        Method::ours(Precision::Exact, OURS, |c| sightlines(&c.world.scene, c)),
    ]];
    const FAMILIES: &'static [Family<Self>] = ball::FAMILIES;

    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        // Methods without a tree are slow, and so is truth.
        const MOST: usize = 256;
        let case = |px: &DVec2| Self::new(&scene.world, *px);
        scene.at.iter().take(MOST).map(case).collect()
    }

    fn can_run(&self, method: &Method<Self>) -> bool {
        ![GPU_IDS, GPU_ID].contains(&method.info.name) || self.world.ids().is_some()
    }

    fn whole_picture(cases: &[Self], method: &Method<Self>) -> Option<f64> {
        let case = cases.first()?;
        match method.info.name {
            GPU_IDS => ids_latency(case, true),
            GPU_ID => ids_latency(case, false),
            _ => None,
        }
    }

    fn truth(&self) -> Picked {
        truth::truth(&self.world.scene, &self.world.view, self.px)
    }

    fn judge(&self, truth: &Picked, answer: &Picked) -> Verdict {
        match (truth, answer) {
            (truth, answer) if truth == answer => Verdict::Agreed,
            (Some(_), None) => Verdict::Missed(0.0),
            (None, Some(_)) => Verdict::Phantom(0.0),
            _ => Verdict::Other,
        }
    }
}

/// The median time, in nanoseconds, to draw all ids and read them back, or only to read back one that is drawn. The
/// scene's buffers and all else are set up beforehand.
fn ids_latency(case: &PickCase, draws: bool) -> Option<f64> {
    const TIMES: usize = 9;
    let (gpu, world) = (gpu()?, &case.world);
    let targets = Targets::new(gpu, world.view.viewport, 1).ok()?;
    let buffers = SceneBuffers::upload(gpu, &world.scene).ok()?;
    let mut renderer = Renderer::new(gpu, 1);
    let mut draw = || renderer.draw((&buffers, &targets, &world.view), &[]);
    // The first drawing compiles shaders.
    draw().and_then(|()| targets.read_ids(gpu)).ok()?;
    let mut once = || {
        let start = Instant::now();
        if draws {
            draw().and_then(|()| targets.read_ids(gpu)).ok()?;
        } else {
            targets.read_id(gpu, case.pixel_at()).ok()??;
        }
        Some(1e9 * start.elapsed().as_secs_f64())
    };
    let mut times: Vec<f64> = (0..TIMES).filter_map(|_| once()).collect();
    times.sort_by(f64::total_cmp);
    times.get(times.len() / 2).copied()
}

/// The names of the methods that the graphics adapter runs.
const GPU_IDS: &str = "the GPU's ids, drawn and read back";
const GPU_ID: &str = "the GPU's ids, one pixel read back";

impl PickCase {
    /// A click on the centre of a pixel.
    pub(in crate::study) fn new(world: &Arc<PickWorld>, px: DVec2) -> Self {
        Self {
            world: Arc::clone(world),
            px,
            pixel: PixelCase::of_view(&world.view, px),
        }
    }

    /// The adapter's id at the pixel.
    fn drawn(&self) -> Picked {
        let [x, y] = self.pixel_at();
        let id = self.world.ids()?.at(x, y);
        let object = usize::try_from(id.object).ok()?.checked_sub(1)?;
        Some((object, id.triangle.checked_sub(1)))
    }

    fn pixel_at(&self) -> [u32; 2] {
        self.px.to_array().map(|at| at.to_u32().unwrap_or(0))
    }

    /// The nearest hit of a ray in `f32` world coordinates by a triangle test in `f32`, over all triangles.
    fn cast_f32(&self, pixel_ray: PixelRay, test: fn(&RayTriangle<f32>) -> Option<f64>) -> Picked {
        let sides = self.world.view.sides;
        let (origin, direction) = (V3::<f32>::of(pixel_ray.from), V3::of(pixel_ray.along));
        let world = pixel_ray.ray(&self.world.view)?;
        let mut best: Option<(f64, usize, Option<u32>)> = None;
        for (index, object) in self.world.flat() {
            let triangles = match object {
                Flat::Triangles(triangles) => triangles,
                Flat::Shape(scene) => {
                    if let Some(hit) = pick::closest(scene, world, sides)
                        && best.is_none_or(|best| hit.hit.t < best.0)
                    {
                        best = Some((hit.hit.t, *index, None));
                    }
                    continue;
                }
            };
            for (triangle, &corners) in (0..).zip(triangles) {
                let case = RayTriangle::new(origin, direction, corners);
                let [a, b, c] = corners;
                let is_front = || direction.dot((b - a).cross(c - a)) < 0.0;
                if let Some(t) = test(&case)
                    && world.contains(t)
                    && (sides == Sides::Both || is_front())
                    && best.is_none_or(|best| t < best.0)
                {
                    best = Some((t, *index, Some(triangle)));
                }
            }
        }
        best.map(|(_, object, triangle)| (object, triangle))
    }
}

fn sightlines(scene: &Scene, case: &PickCase) -> Picked {
    let view = &case.world.view;
    let hit = pick::closest(scene, view.ray(case.px), view.sides)?;
    Some((hit.object, hit.triangle_of_object(scene)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::run::family;

    /// Cases of one triangle are taken from a scene that nobody draws or copies.
    #[test]
    fn only_whole_picks_draw_the_scene_and_copy_it() {
        let (scene, view) = ball_scene(0.0);
        let rays = SceneRays::new(&scene, view, 20, 1);
        let world = &rays.world;
        let copied = || (world.treeless.get().is_some(), world.flat.get().is_some());
        let rows = family::<TriangleCase>(SCENE, Effort::QUICK, Some(&rays), &|| true);
        assert!(rows.is_some_and(|rows| !rows.is_empty()));
        assert_eq!((copied(), world.ids.get()), ((false, false), None));
        let rows = family::<PickCase>(SCENE, Effort::QUICK, Some(&rays), &|| true);
        assert!(rows.is_some_and(|rows| !rows.is_empty()));
        assert!(copied() == (true, true) && world.ids.get().is_some());
    }
}
