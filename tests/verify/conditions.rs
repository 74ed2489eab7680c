//! Verify leaves no pixel unexplained, under every condition that a user can bring about and over every scene.

use crate::{
    cameras::{NARROWEST, SIZE, Shot, culled, few_shots, shots},
    common, compare, drawn,
    models::{coplanar, inside, matrices, slivers, under},
    scenes::{gpu, shapes},
};
use glam::DVec3;
use sightline::{
    pick,
    render::{Gpu, Renderer, SceneBuffers},
    scene::{self, Progress, Scene},
    verify::{Class, Report, Verdict},
};
use std::{collections::BTreeMap, time::Instant};

/// The fewest pixels that a view must show, because agreement on an empty picture proves nothing. A view that is cut or
/// culled may be empty, but not all views of a condition.
const LEAST_SHOWN: usize = 10;

/// The most `f32 limit` pixels of a view.
const MOST_AT_F32_LIMIT: usize = 20;

/// The words in a condition's name under which the depth buffer cannot tell many surfaces from nothing.
const COARSE: &str = "1e7, standard";

/// The words in a condition's name under which it cannot tell most surfaces from nothing, and on an NVIDIA H100 none.
const LOST: &str = "1e9, standard";

/// Whether a mesh takes long to draw. Only a third of the cameras look at such a mesh.
fn takes_long(triangles: usize) -> bool {
    triangles > 50_000
}

/// Counts over all scenes and views of one condition.
#[derive(Default)]
struct Tally {
    views: usize,
    shown: usize,
    outline: usize,
    outline_differ: usize,
    classes: [usize; 6],
}

impl Tally {
    fn add(&mut self, report: &Report) {
        self.views += 1;
        self.shown += shown(report);
        self.outline += report.outline;
        self.outline_differ += report.outline_differ;
        for (count, class) in self.classes.iter_mut().zip(Class::ALL) {
            *count += report.count(class);
        }
    }
}

/// The smaller of the counts of pixels drawn and picked: in a blank picture nothing shows, whatever is picked.
fn shown(report: &Report) -> usize {
    report.drawn.min(report.picked)
}

/// The kind of scenes in a sweep; demands depend on it.
#[derive(Clone, Copy, PartialEq)]
enum Over {
    /// Scenes made for the test.
    Own,
    /// Models from the wild.
    Files,
    /// Blades less than a pixel wide, and faces in one plane.
    Hardest,
}

/// Draws, picks and compares; collects failures.
struct Sweep {
    gpu: Gpu,
    renderer: Renderer,
    tallies: BTreeMap<&'static str, Tally>,
    ordinary: Tally,
    over: Over,
    defects: Vec<String>,
}

impl Sweep {
    fn new(over: Over) -> Self {
        let gpu = gpu();
        Self {
            renderer: Renderer::new(&gpu, 1),
            gpu,
            tallies: BTreeMap::new(),
            ordinary: Tally::default(),
            over,
            defects: Vec::new(),
        }
    }

    fn check(&mut self, name: &str, scene: &Scene, shots: Vec<Shot>) {
        scene.build_trees();
        let buffers = SceneBuffers::upload(&self.gpu, scene).expect("fits");
        for shot in shots {
            let drawn = drawn(&self.gpu, &mut self.renderer, &buffers, &shot.view);
            let report = compare(scene, &shot.view, &drawn, &pick::ids(scene, &shot.view));
            self.tallies.entry(shot.condition).or_default().add(&report);
            let place = format!("{name}, {}", shot.condition);
            if shot.ordinary {
                self.ordinary.add(&report);
            }
            let limit = report.count(Class::F32Limit);
            if limit > self.most_at_f32_limit(shot.condition) {
                self.defects
                    .push(format!("{place}: {limit} at the limit of f32"));
            }
            let verdict = report.verdict();
            let allowed = match verdict {
                Verdict::Agrees => true,
                Verdict::BeyondF32(_) => self.may_be_beyond_f32(shot.condition),
                Verdict::NothingDrawn(_) => shot.condition.contains(LOST),
                _ => false,
            };
            if !allowed {
                let (worst, view) = (report.worst(), shot.view);
                (self.defects).push(format!("{place}: {verdict:?}, {worst:?}, {view:?}"));
            }
            let shown = shown(&report);
            if shown < self.least_shown(shot.condition) {
                (self.defects).push(format!("{place}: only {shown} pixels show anything"));
            }
        }
    }

    fn most_at_f32_limit(&self, condition: &str) -> usize {
        match self.over {
            Over::Own => MOST_AT_F32_LIMIT,
            Over::Files if condition != NARROWEST => MOST_AT_F32_LIMIT,
            Over::Files | Over::Hardest => usize::MAX,
        }
    }

    /// Whether a view under such a condition may be beyond `f32`. Standard depth stores 1 for nearly everything between
    /// planes far apart. Other reasons are triangles that are a million pictures wide, that run under the eye into the
    /// distance, or that are slimmer than the grid.
    fn may_be_beyond_f32(&self, condition: &str) -> bool {
        let is_any = |words: &[&str]| words.iter().any(|word| condition.contains(word));
        match self.over {
            _ if is_any(&[COARSE, LOST]) => true,
            Over::Own => false,
            Over::Files => is_any(&["zoomed", NARROWEST, "from the middle", "178", "thin"]),
            Over::Hardest => true,
        }
    }

    /// The fewest pixels that a view must show.
    fn least_shown(&self, condition: &str) -> usize {
        let is_any = |words: &[&str]| words.iter().any(|word| condition.contains(word));
        if is_any(&["cut", "culled", "from the middle", "along an axis", LOST]) {
            0
        } else if is_any(&[COARSE]) {
            1
        } else if is_any(&["zoomed", "narrowed"]) {
            // The detail fills 30 or 10 percent of the picture.
            let tenths = if self.over == Over::Own { 3 } else { 1 };
            tenths * (SIZE[0] * SIZE[1]) as usize / 10
        } else {
            LEAST_SHOWN
        }
    }

    fn finish(mut self) {
        for (name, tally) in &self.tallies {
            if tally.shown < 4 * LEAST_SHOWN * tally.views {
                (self.defects).push(format!("{name}: only {} pixels show anything", tally.shown));
            }
        }
        println!(
            "{:<44}{:>6}{:>10}{:>9}{:>6}{:>7}{:>6}{:>7}{:>6}{:>8}",
            "condition",
            "views",
            "shown",
            "outline",
            "edge",
            "depth",
            "f32",
            "beyond",
            "un",
            "share"
        );
        let rows = self.tallies.iter().map(|(name, tally)| (*name, tally));
        for (name, tally) in rows.chain([("ordinary, together", &self.ordinary)]) {
            let [edge, depth, _, limit, beyond, unexplained] = tally.classes;
            println!(
                "{name:<44}{:>6}{:>10}{:>9}{edge:>6}{depth:>7}{limit:>6}{beyond:>7}{unexplained:>6}{:>7.2}%",
                tally.views,
                tally.shown,
                tally.outline,
                share(tally)
            );
        }
        assert!(self.defects.is_empty(), "{}", self.defects.join("\n"));
        let share = share(&self.ordinary);
        assert!(share <= 0.3, "{share} % of ordinary outline pixels differ");
    }
}

/// Percentage of outline pixels that differ.
fn share(tally: &Tally) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "few pixels")]
    let share = 100.0 * tally.outline_differ as f64 / tally.outline.max(1) as f64;
    share
}

fn under_matrices(sweep: &mut Sweep, name: &str, scene: &Scene) {
    let bounds = scene.visible_bounds();
    let flat = (bounds.max - bounds.min).min_element() == 0.0;
    for (condition, matrix, ordinary) in matrices() {
        // Flattening would turn a flat scene into a line.
        if flat && condition == "thin as paper" {
            continue;
        }
        let scene = under(scene, matrix);
        let shots = few_shots(&scene, condition, ordinary);
        sweep.check(&format!("{name}, {condition}"), &scene, shots);
    }
}

#[test]
fn own_scenes() {
    let mut sweep = Sweep::new(Over::Own);
    let scene = shapes(DVec3::ZERO);
    sweep.check("shapes", &scene, shots(&scene));
    under_matrices(&mut sweep, "shapes", &scene);
    let demo = scene::load(&[], &Progress::default())
        .expect("the demo")
        .scene;
    sweep.check("demo", &demo, shots(&demo));
    under_matrices(&mut sweep, "demo", &demo);
    for (condition, scene, view) in inside() {
        // Only a mesh around the eye shows nothing when culled.
        let views = if scene.objects().len() > 1 {
            vec![view, culled(&view)]
        } else {
            vec![view]
        };
        let shots = views
            .into_iter()
            .map(|view| Shot::new(condition, view, false));
        sweep.check(condition, &scene, shots.collect());
    }
    sweep.finish();
}

#[test]
fn slivers_and_coplanar_faces() {
    let mut sweep = Sweep::new(Over::Hardest);
    for (name, scene) in [("slivers", slivers()), ("coplanar", coplanar())] {
        let all = shots(&scene).into_iter().map(|shot| Shot {
            ordinary: false,
            ..shot
        });
        sweep.check(name, &scene, all.collect());
        under_matrices(&mut sweep, name, &scene);
    }
    sweep.ordinary = Tally::default();
    sweep.finish();
}

#[test]
fn real_files() {
    let Some(folder) = common::real_files() else {
        return;
    };
    let mut paths: Vec<_> = std::fs::read_dir(folder.join("models"))
        .expect("a folder")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "obj"))
        .collect();
    paths.sort();
    assert!(!paths.is_empty(), "no models");
    let mut sweep = Sweep::new(Over::Files);
    for path in paths {
        let name = path
            .file_stem()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        let scene = scene::load(&[path], &Progress::default())
            .expect("a scene")
            .scene;
        scene.build_trees();
        let start = Instant::now();
        let every = if takes_long(scene.triangle_count()) {
            3
        } else {
            1
        };
        sweep.check(
            &name,
            &scene,
            shots(&scene).into_iter().step_by(every).collect(),
        );
        under_matrices(&mut sweep, &name, &scene);
        println!("{name}: {:.1?}", start.elapsed());
    }
    sweep.finish();
}
