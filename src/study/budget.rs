//! Finds the simplest way to pick that stays within an error in pixels on a scene.
//!
//! Each [chain](super::chains) picks at the same random pixels of the scene's own view. Its error at a pixel is the
//! larger of two: how far from the pixel the point that it finds is seen, and, where it finds another object or
//! triangle than Sightline, how far the click would have to move until Sightline found that. At an outline, where one
//! triangle hides the next, a triangle that shares a corner with it will do.

use super::{
    chains::{Chain, Held, Picked},
    methods::depth::{DepthCase, Mapping},
    random::Random,
    statistics::quantile,
};
use crate::{
    camera::{Camera, Lens, Projection, View},
    geometry::Placement,
    pick,
    scene::Scene,
};
use glam::{DAffine3, DVec2, DVec3};
use std::{hint::black_box, iter, time::Instant};

/// A chain suffices if its largest error, times this, is within the budget: pixels that were not tried may be worse.
const MARGIN: f64 = 2.0;
/// How many pixels are tried, and how many where the scene or the eye was moved.
const PIXELS: usize = 2000;
const PIXELS_MOVED: usize = 200;
/// How often each chain is timed.
const ROUNDS: usize = 9;
/// How far a click is moved at most, in pixels.
pub(super) const FARTHEST_PX: f64 = 64.0;

/// No pixel shows anything.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(
    "--budget: none of {0} rays hits anything: turn to the scene, come nearer, or hide less of it"
)]
pub struct NothingHit(usize);

/// What a chain did at the pixels of a view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tried {
    /// The chain.
    pub chain: Chain,
    /// At how many pixels it finds another object or triangle than Sightline.
    pub differ: usize,
    /// Its largest error in pixels; infinite where no click nearby finds what it found.
    pub worst_px: f64,
    /// The median time of a pick in nanoseconds.
    pub ns: f64,
}

/// What was found about a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Budget {
    /// The error that is allowed, in pixels.
    pub px: f64,
    /// How many pixels were tried, and how many show something.
    pub pixels: [usize; 2],
    /// The chains, the simplest first.
    pub tried: Vec<Tried>,
    /// The time of Sightline's pick by the walk of the others, in nanoseconds.
    pub one_by_one_ns: f64,
    /// Where the simplest chain that suffices breaks.
    pub breaks: Vec<Reach>,
    /// Which buffers can tell the nearest surface from the one behind it.
    pub depth: Depths,
}

/// How far something can grow before a chain breaks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach {
    /// What grows.
    pub of: Growth,
    /// Where the chain still held; `None` where it breaks at the first step.
    pub held: Option<f64>,
    /// Where it broke; `None` where it held as far as was tried.
    pub broke: Option<f64>,
}

/// What grows until a chain breaks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Growth {
    /// The distance of scene and eye from the world's origin, in world units.
    Offset,
    /// The distance of the eye from the scene, in multiples of the present one, through a lens as much longer.
    Lens,
}

/// Which depth buffers suffice.
#[derive(Clone, Debug, PartialEq)]
pub struct Depths {
    /// How many pixels show a surface with another one behind it that is not at the same depth.
    pub pixels: usize,
    /// At how many of these each format stores one number for both; the simplest format first.
    pub alike: Vec<(&'static str, usize)>,
}

impl Budget {
    /// Tries all chains on a scene, whose section is ignored.
    ///
    /// # Errors
    /// Where no pixel shows anything.
    pub fn new(scene: &Scene, view: &View, px: f64, seed: u64) -> Result<Self, NothingHit> {
        let view = view.uncut();
        let held = Chain::ALL.map(|chain| Held::new(chain, scene, &view));
        let sample = Sample::new(&held[Chain::Sightline as usize], &view, PIXELS, seed);
        let hits = sample.hits();
        if hits == 0 {
            return Err(NothingHit(PIXELS));
        }
        let (times, one_by_one_ns) = times(&held, &sample);
        let tried = held.iter().zip(times).map(|(held, ns)| {
            let (differ, worst_px) = sample.judge(held);
            let chain = held.chain();
            Tried {
                chain,
                differ,
                worst_px,
                ns,
            }
        });
        let mut budget = Self {
            px,
            pixels: [PIXELS, hits],
            tried: tried.collect(),
            one_by_one_ns,
            breaks: Vec::new(),
            depth: depths(scene, &view, &sample),
        };
        let simplest = budget.simplest().map(|tried| tried.chain);
        if let Some(chain) = simplest.filter(|chain| *chain != Chain::Sightline) {
            let growths = [Growth::Offset, Growth::Lens].into_iter();
            let growths = growths.filter(|of| of.applies(&view));
            budget.breaks = growths
                .map(|of| reach(chain, of, scene, &view, px, seed))
                .collect();
        }
        Ok(budget)
    }

    /// The simplest chain that stays within the budget.
    pub fn simplest(&self) -> Option<&Tried> {
        self.tried.iter().find(|tried| tried.is_within(self.px))
    }
}

impl Tried {
    /// Whether the chain stays within a budget in pixels, with a margin.
    pub fn is_within(&self, px: f64) -> bool {
        self.chain == Chain::Sightline || MARGIN * self.worst_px <= px
    }
}

/// Pixels of a view, with what Sightline finds there.
struct Sample<'a> {
    truth: &'a Held,
    view: View,
    at: Vec<(DVec2, Option<Picked>)>,
}

impl<'a> Sample<'a> {
    fn new(truth: &'a Held, view: &View, count: usize, seed: u64) -> Self {
        let mut random = Random::named(seed, &["scene"]);
        let pixels = iter::repeat_with(|| random.pixel(view.viewport.size_px()));
        let at = pixels.take(count).map(|px| (px, truth.pick(px)));
        Self {
            truth,
            view: *view,
            at: at.collect(),
        }
    }

    fn hits(&self) -> usize {
        self.at.iter().filter(|(_, found)| found.is_some()).count()
    }

    /// At how many pixels a chain differs from Sightline, and its largest error in pixels.
    fn judge(&self, held: &Held) -> (usize, f64) {
        let errors = self.at.iter().map(|(px, truth)| {
            let found = held.pick(*px);
            let differs = name(truth.as_ref()) != name(found.as_ref());
            let moved = if differs {
                self.moved_px(*px, found.as_ref())
            } else {
                0.0
            };
            let seen = found.map_or(0.0, |found| {
                let seen = self.view.project(found.point_world);
                seen.map_or(f64::INFINITY, |seen| seen.px.distance(*px))
            });
            (usize::from(differs), moved.max(seen))
        });
        errors.fold((0, 0.0), |(count, worst), (differs, error)| {
            (count + differs, if error > worst { error } else { worst })
        })
    }

    /// How far a click must move until Sightline finds what a chain found, or a triangle that shares a corner with it,
    /// in pixels; infinite beyond [`FARTHEST_PX`]. It is at most a few per cent too large.
    fn moved_px(&self, px: DVec2, found: Option<&Picked>) -> f64 {
        const DIRECTIONS: u32 = 16;
        let is_found = |at: DVec2| {
            self.truth
                .is_same_place(found, self.truth.pick(at).as_ref())
        };
        let mut radius_px = FARTHEST_PX * 0.5_f64.powi(50);
        while radius_px <= FARTHEST_PX {
            let turns = (0..DIRECTIONS).map(|i| f64::from(i) / f64::from(DIRECTIONS));
            let mut directions = turns.map(|turn| {
                let (sin, cos) = libm::sincos(turn * std::f64::consts::TAU);
                DVec2::new(cos, sin)
            });
            if let Some(along) = directions.find(|along| is_found(px + radius_px * *along)) {
                let (mut short, mut long) = (0.5 * radius_px, radius_px);
                for _ in 0..6 {
                    let middle = 0.5 * (short + long);
                    if is_found(px + middle * along) {
                        long = middle;
                    } else {
                        short = middle;
                    }
                }
                return long;
            }
            radius_px *= 2.0;
        }
        f64::INFINITY
    }
}

/// Object and triangle.
fn name(found: Option<&Picked>) -> Option<(usize, Option<u32>)> {
    let hit = &found?.hit;
    Some((hit.object, hit.hit.on_triangle.map(|on| on.triangle)))
}

/// The median time of a pick by each chain, and by Sightline one triangle at a time, in nanoseconds. They take turns.
fn times(held: &[Held], sample: &Sample<'_>) -> (Vec<f64>, f64) {
    let mut taken = vec![Vec::new(); held.len() + 1];
    #[expect(clippy::cast_precision_loss, reason = "thousands")]
    let each_ns = |start: Instant| 1e9 * start.elapsed().as_secs_f64() / sample.at.len() as f64;
    // The first round warms up caches and clocks.
    for round in 0..=ROUNDS {
        for (index, times) in taken.iter_mut().enumerate() {
            let start = Instant::now();
            for (px, _) in &sample.at {
                match held.get(index) {
                    Some(held) => drop(black_box(held.pick(*px))),
                    None => drop(black_box(sample.truth.pick_one_by_one(*px))),
                }
            }
            if round > 0 {
                times.push(each_ns(start));
            }
        }
    }
    let medians = taken.iter_mut().map(|times| {
        times.sort_by(f64::total_cmp);
        quantile(times, 0.5)
    });
    let mut medians: Vec<f64> = medians.collect();
    let one_by_one = medians.pop().unwrap_or_default();
    (medians, one_by_one)
}

impl Growth {
    fn applies(self, view: &View) -> bool {
        self == Self::Offset || !view.camera.lens().is_orthographic()
    }

    /// The scene and the view once it has grown so many times, and how far; `None` beyond what a camera can do.
    fn at(self, times: f64, scene: &Scene, view: &View) -> Option<(Scene, View, f64)> {
        let camera = &view.camera;
        let (eye, target, up) = (camera.eye(), camera.target(), camera.up());
        let lens = *camera.lens();
        let view_of = |eye, target, lens| {
            let camera = Camera::new(eye, target, up, lens).ok()?;
            Some(View { camera, ..*view })
        };
        match self {
            Self::Offset => {
                let offset = times * eye.distance(target);
                // A direction whose coordinates have digits that `f32` has no room for.
                let by = DVec3::new(1.0, 2.0, 3.0).normalize() * offset;
                let mut moved = scene.clone();
                for (index, object) in scene.objects().iter().enumerate() {
                    let model = object.placement.model();
                    let translation = model.translation + by;
                    let model = DAffine3 {
                        translation,
                        ..model
                    };
                    moved.place(index, Placement::new(model).ok()?);
                }
                // Round coordinates would all be rounded alike, and eye and scene still fit.
                let eye = target + (eye - target) * 1.000_123_456_789;
                let view = view_of(eye + by, target + by, lens)?;
                Some((moved, view, offset))
            }
            Self::Lens => {
                let Projection::Perspective { fov_y } = lens.projection else {
                    return None;
                };
                let back = (times - 1.0) * eye.distance(target);
                let fov_y = 2.0 * libm::atan(libm::tan(0.5 * fov_y) / times);
                let lens = Lens {
                    projection: Projection::Perspective { fov_y },
                    near: lens.near + back,
                    far: lens.far + back,
                    ..lens
                };
                let eye = target + (eye - target) * times;
                Some((scene.clone(), view_of(eye, target, lens)?, times))
            }
        }
    }
}

/// How far something can grow, by powers of ten, before a chain that holds now breaks.
fn reach(chain: Chain, of: Growth, scene: &Scene, view: &View, px: f64, seed: u64) -> Reach {
    /// The first power of ten that is out of reach.
    const END: i32 = 13;
    /// One distance may happen to suit the numbers.
    const SHARES: [f64; 4] = [1.0, 0.93, 0.87, 0.81];
    let times = |step: i32| 10_f64.powi(step);
    // `Some(true)` where the chain holds; `None` where there is nothing to try.
    let holds = |step: i32| {
        let each = SHARES.map(|share| {
            let (scene, view, _) = of.at(share * times(step), scene, view)?;
            let truth = Held::new(Chain::Sightline, &scene, &view);
            let sample = Sample::new(&truth, &view, PIXELS_MOVED, seed);
            let (_, worst_px) = sample.judge(&Held::new(chain, &scene, &view));
            (sample.hits() > 0).then_some(MARGIN * worst_px <= px)
        });
        let each: Option<Vec<bool>> = each.into_iter().collect();
        Some(each?.into_iter().all(|holds| holds))
    };
    let (mut low, mut high, mut broke) = (0, END, false);
    while high - low > 1 {
        let middle = i32::midpoint(low, high);
        match holds(middle) {
            Some(true) => low = middle,
            Some(false) => (high, broke) = (middle, true),
            None => (high, broke) = (middle, false),
        }
    }
    let grown = |step: i32| of.at(times(step), scene, view).map(|(.., grown)| grown);
    Reach {
        of,
        held: (low > 0).then(|| grown(low)).flatten(),
        broke: broke.then(|| grown(high)).flatten(),
    }
}

/// Which depth buffers tell the nearest surface from the next.
fn depths(scene: &Scene, view: &View, sample: &Sample<'_>) -> Depths {
    const FORMATS: [(&str, Mapping); 3] = [
        ("standard, 24-bit integers", Mapping::STANDARD_24),
        ("standard, 32-bit floats", Mapping::STANDARD),
        ("reversed, 32-bit floats", Mapping::REVERSED),
    ];
    let pairs = sample.at.iter().filter(|(_, found)| found.is_some());
    let pairs = pairs.filter_map(|(px, _)| {
        let hits = pick::all(scene, view.ray(*px), view.sides);
        let mut depths = hits.iter().map(|hit| hit.hit.t);
        let first = depths.next()?;
        Some([first, depths.find(|next| *next > first)?])
    });
    let pairs: Vec<[f64; 2]> = pairs.collect();
    let stored = |mapping: Mapping, depth: f64| {
        let case = DepthCase::between(depth, *view.camera.lens());
        mapping.stored(&case).to_bits()
    };
    let alike = FORMATS.map(|(name, mapping)| {
        let alike = pairs.iter().filter(|pair| {
            let [near, next] = pair.map(|depth| stored(mapping, depth));
            near == next
        });
        (name, alike.count())
    });
    Depths {
        pixels: pairs.len(),
        alike: alike.to_vec(),
    }
}
