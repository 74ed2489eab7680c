//! Whole picks: from a pixel to the visible object and triangle, all steps together.

mod ball;
mod truth;

pub(super) use ball::icosahedron;
pub use ball::{ball_scene, gpu};

use crate::{
    camera::View,
    image::{Id, Image},
    look::Background,
    render::{self, Renderer, SceneBuffers, Targets},
    scene::Scene,
    study::{
        chains::{Chain, Held},
        prelude::*,
    },
};
use glam::DVec2;
use num_traits::ToPrimitive;
use std::{
    sync::{Arc, OnceLock},
    time::Instant,
};

/// A scene as each kind of method picks from it, made once one of them asks for it.
#[derive(Debug)]
pub struct PickWorld {
    /// With trees over all meshes that are worth one.
    pub scene: Scene,
    /// The view.
    pub view: View,
    /// The scene as each chain holds it.
    held: [OnceLock<Held>; Chain::COUNT],
    ids: OnceLock<Option<Image<Id>>>,
}

impl PickWorld {
    /// Builds the trees of the scene's meshes.
    pub(in crate::study) fn new(scene: &Scene, view: View) -> Self {
        scene.build_trees();
        Self {
            scene: scene.clone(),
            view,
            held: [const { OnceLock::new() }; Chain::COUNT],
            ids: OnceLock::new(),
        }
    }

    /// The scene as a chain holds it.
    fn held(&self, chain: Chain) -> &Held {
        self.held[chain as usize].get_or_init(|| Held::new(chain, &self.scene, &self.view))
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
}

/// A click.
#[derive(Clone, Debug)]
pub struct PickCase {
    /// The scene.
    pub world: Arc<PickWorld>,
    /// The centre of a pixel.
    pub px: DVec2,
}

/// Object index and, on a mesh, the triangle within that object.
pub type Picked = Option<(usize, Option<u32>)>;

const IDS: &str = "picking by colour: draw ids for the click, read the picture back";
const ID: &str = "picking by colour: ids are drawn with each frame; one pixel is read back";
const OURS: &str = Chain::Sightline.source();

/// A chain of rounded numbers as a method.
macro_rules! chain {
    ($chain:ident) => {
        Method::new(
            Chain::$chain.name(),
            Chain::$chain.precision(),
            Chain::$chain.source(),
            |c| c.by(Chain::$chain),
        )
    };
}

impl Case for PickCase {
    type Answer = Picked;
    type Truth = Picked;
    const ABOUT: About = about!(
        "Whole pick" "pick", off by "", wrong by "";
        "a click on a scene that is ready to be picked from, with trees: object and triangle"
    );
    const TIMED: usize = 256;
    const MOST_ROUNDS: usize = 21;

    fn count(effort: Effort) -> usize {
        effort.picks
    }

    const METHODS: Methods<Self> = &[&[
        chain!(World),
        chain!(Mesh),
        chain!(Eye),
        chain!(Double),
        chain!(Three),
        chain!(Bevy),
        chain!(Vtk),
        Method::new(ADAPTER_IDS, F32, IDS, PickCase::drawn),
        Method::new(ADAPTER_ID, F32, ID, PickCase::drawn),
        Method::new(
            "Sightline's, a triangle at a time",
            Precision::Exact,
            OURS,
            |c| {
                let world = &c.world;
                let hit = world.held(Chain::Sightline).pick_one_by_one(c.px)?;
                Some((hit.object, hit.triangle_of_object(&world.scene)))
            },
        ),
        Method::ours(Precision::Exact, OURS, |c| c.by(Chain::Sightline)),
    ]];
    const FAMILIES: &'static [Family<Self>] = ball::FAMILIES;

    fn of_scene(scene: &SceneRays) -> Vec<Self> {
        // Methods without a tree are slow, and so is truth.
        const MOST: usize = 256;
        let world = Arc::new(PickWorld::new(&scene.scene, scene.view));
        let case = |px: &DVec2| Self::new(&world, *px);
        scene.at.iter().take(MOST).map(case).collect()
    }

    fn can_run(&self, method: &Method<Self>) -> bool {
        ![ADAPTER_IDS, ADAPTER_ID].contains(&method.info.name) || self.world.ids().is_some()
    }

    fn whole_picture(cases: &[Self], method: &Method<Self>) -> Option<f64> {
        let case = cases.first()?;
        match method.info.name {
            ADAPTER_IDS => ids_latency(case, true),
            ADAPTER_ID => ids_latency(case, false),
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
const ADAPTER_IDS: &str = "ids, drawn and read back";
const ADAPTER_ID: &str = "ids, one pixel read back";

impl PickCase {
    /// A click on the centre of a pixel.
    pub(in crate::study) fn new(world: &Arc<PickWorld>, px: DVec2) -> Self {
        Self {
            world: Arc::clone(world),
            px,
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

    /// What a chain finds. A pick ignores the view's section.
    fn by(&self, chain: Chain) -> Picked {
        let hit = self.world.held(chain).pick(self.px)?.hit;
        Some((hit.object, hit.triangle_of_object(&self.world.scene)))
    }
}
