//! Under a section, what is drawn is what is picked, except nearer to the plane than drawing can tell. Hundreds of
//! sections run along faces, through vertices and the eye, along rays, across axes and anywhere.

use crate::{
    cameras::few_shots,
    common::{self, Random},
    compare,
    cuts::some_section,
    drawn,
    extremes::{self, Counts},
    scenes::{gpu, shapes},
};
use glam::DVec3;
use sightline::{
    camera::View,
    geometry::{Section, Sides},
    image::{Id, Image},
    pick,
    render::{Renderer, SceneBuffers},
    scene::{self, Progress, Scene, gallery::GALLERY},
    verify::{Class, Verdict},
};
use std::path::PathBuf;

/// Cuts per view of a scene (it has four) in an ordinary run.
const CUTS: usize = 8;

pub fn wanted() -> usize {
    common::wanted("SIGHTLINE_CUTS", CUTS)
}

/// Counts over many cuts.
#[derive(Default)]
struct Tally {
    cuts: usize,
    /// Pixels that the cut changes.
    changed: usize,
    /// Pixels that still show something.
    shown: usize,
    /// Pixels of each class.
    classes: [usize; 6],
    defects: Vec<String>,
}

impl Tally {
    fn check(&mut self, name: &str, scene: &Scene, cuts: usize, random: &mut Random) {
        let gpu = gpu();
        let mut renderer = Renderer::new(&gpu, 1);
        scene.build_trees();
        let buffers = SceneBuffers::upload(&gpu, scene).expect("fits");
        for shot in few_shots(scene, "cut", true) {
            let whole = pick::ids(scene, &shot.view);
            for _ in 0..cuts {
                let section = Some(some_section(random, scene, &shot.view));
                let view = View {
                    section,
                    ..shot.view
                };
                let picked = pick::ids(scene, &view);
                let drawn = drawn(&gpu, &mut renderer, &buffers, &view);
                self.compare(name, scene, &view, [&whole, &picked, &drawn]);
            }
        }
    }

    fn compare(
        &mut self,
        name: &str,
        scene: &Scene,
        view: &View,
        [whole, picked, drawn]: [&Image<Id>; 3],
    ) {
        let report = compare(scene, view, drawn, picked);
        self.cuts += 1;
        let pixels = whole.pixels().iter().zip(picked.pixels());
        self.changed += pixels.filter(|(whole, picked)| whole != picked).count();
        self.shown += report.drawn.min(report.picked);
        for (count, class) in self.classes.iter_mut().zip(Class::ALL) {
            *count += report.count(class);
        }
        if report.verdict() != Verdict::Agrees {
            let (verdict, worst) = (report.verdict(), report.worst());
            (self.defects).push(format!("{name}: {verdict:?}, {worst:?}, {view:?}"));
        }
    }

    fn finish(&self, [changed, shown]: [usize; 2]) {
        let [edge, depth, section, limit, beyond, unexplained] = self.classes;
        println!(
            "{} cuts: {} pixels changed, {} shown; {edge} edge, {depth} depth, {section} section, {limit} f32 limit, \
             {beyond} beyond, {unexplained} unexplained",
            self.cuts, self.changed, self.shown
        );
        assert!(
            self.changed / self.cuts >= changed && self.shown / self.cuts >= shown,
            "little was cut, or little left"
        );
        assert!(
            self.defects.is_empty(),
            "{} defects:\n{}",
            self.defects.len(),
            self.defects[..self.defects.len().min(5)].join("\n")
        );
    }
}

fn load(path: &str) -> Scene {
    let paths: Vec<PathBuf> = (!path.is_empty())
        .then(|| path.into())
        .into_iter()
        .collect();
    let loaded = scene::load(&paths, &Progress::default());
    loaded.expect("a scene").scene
}

#[test]
fn of_own_scenes() {
    let mut tally = Tally::default();
    let mut random = Random::new(31);
    tally.check("shapes", &shapes(DVec3::ZERO), 3 * wanted(), &mut random);
    tally.check("demo", &load(""), 3 * wanted(), &mut random);
    for exhibit in &GALLERY {
        let path = exhibit.path();
        let scene = load(&path.to_string_lossy());
        tally.check(exhibit.name, &scene, wanted() / 4, &mut random);
    }
    tally.finish([500, 500]);
}

#[test]
fn of_real_files() {
    let Some(folder) = common::real_files() else {
        return;
    };
    let mut tally = Tally::default();
    let mut random = Random::new(32);
    for name in [
        "stanford-bunny",
        "spot",
        "cornell_box",
        "teapot",
        "linz_x0410_utm33n",
        "hundred_cubes",
    ] {
        let path = folder.join("models").join(name).with_extension("obj");
        let scene = load(&path.to_string_lossy());
        tally.check(name, &scene, wanted(), &mut random);
    }
    tally.finish([500, 300]);
}

/// A face in the section's plane is drawn and picked whole, from both sides; the rest of the cube is cut away.
#[test]
fn a_face_in_the_plane_shows_as_a_whole() {
    let cube = sightline::scene::Object::new(
        "cube",
        sightline::scene::Shape::Cube,
        sightline::geometry::Placement::IDENTITY,
    );
    let scene = Scene::new(vec![cube]);
    let gpu = gpu();
    let mut renderer = Renderer::new(&gpu, 1);
    let buffers = SceneBuffers::upload(&gpu, &scene).expect("fits");
    let mut shown = 0;
    for shot in few_shots(&scene, "a face in the plane", true) {
        for axis in DVec3::AXES {
            for sign in [1.0, -1.0] {
                // The section keeps the half space beyond the cube, so only the face is left.
                let section = Section::new(sign * axis, -0.5).expect("a section");
                let view = View {
                    section: Some(section),
                    sides: Sides::Both,
                    ..shot.view
                };
                let picked = pick::ids(&scene, &view);
                let drawn = drawn(&gpu, &mut renderer, &buffers, &view);
                let report = compare(&scene, &view, &drawn, &picked);
                assert_eq!(report.verdict(), Verdict::Agrees, "{:?}", report.worst());
                // Wrong clipping would scatter specks over the whole face.
                assert!(report.count(Class::Section) < 4);
                shown += report.picked;
            }
        }
    }
    assert!(shown > 20_000, "{shown} pixels");
}

/// The test's numbers have the size of the scene in orthographic projection, and of the distance in perspective.
#[test]
fn in_scenes_of_any_size() {
    for exponent in [-24, -15, -8, 15, 22, 29] {
        let text = format!("[[object]]\nshape = \"cube\"\nscale = 1e{exponent}\n");
        let (_folder, file) = extremes::scene(&text);
        for projection in ["--fov 40".to_owned(), format!("--ortho 2e{exponent}")] {
            let view = format!("{projection} --section=0.3,0.5,0.2,0");
            let [whole, cut] = [&projection, &view].map(|view| {
                let counts =
                    Counts::of(extremes::run(Some(&file), &format!("--size 128x96 {view}")));
                assert_eq!(counts.code, Some(0), "1e{exponent} {view}: {}", counts.line);
                counts.get("picked")
            });
            assert!(
                500 < cut && cut + 50 < whole,
                "1e{exponent}: {cut} of {whole}"
            );
        }
    }
}

/// The plane lies so much farther away than what is drawn that their ratio leaves the range of `f32`.
#[test]
fn by_a_plane_beyond_everything() {
    for (exponent, plane) in [(-24, 15), (-22, 17), (-20, 19), (-9, 31)] {
        let text = format!("[[object]]\nshape = \"square\"\nscale = 1e{exponent}\n");
        let (_folder, file) = extremes::scene(&text);
        let near = exponent - 1;
        let view = format!(
            "--size 64x48 --eye 0,0,1e{exponent} --target 0,0,0 --near 5e{near} --far 1 --section=0,0"
        );
        // It cuts away the square, or keeps it.
        for (plane, shown) in [
            (format!("1,-1e{plane}"), 0..=0),
            (format!("-1,1e{plane}"), 2000..=64 * 48),
        ] {
            let view = format!("{view},{plane}");
            let counts = Counts::of(extremes::run(Some(&file), &view));
            assert_eq!(counts.code, Some(0), "{view}: {}", counts.line);
            let [drawn, picked] = ["drawn", "picked"].map(|name| counts.get(name));
            assert_eq!(drawn, picked, "{view}");
            assert!(shown.contains(&drawn), "{view}: {drawn}");
        }
    }
}

/// Planes that fit a thin plate lie close together, and its front lies within the rounding of the section's plane. The
/// bound on that rounding does not depend on the planes.
#[test]
fn a_thin_plate_cut_in_its_own_face() {
    let square = |z: &str| format!("[[object]]\nshape = \"square\"\nposition = [0, 0, {z}]\n");
    let toml = ["0.10000001", "0.101"].map(square).concat();
    let (_folder, file) = extremes::scene(&toml);
    for projection in ["--fov 45", "--ortho 2"] {
        let view =
            format!("--size 128x96 --eye 0,0,2 --target 0,0,0 {projection} --section=-z:0.1");
        let counts = Counts::of(extremes::run(Some(&file), &view));
        assert_eq!(counts.code, Some(0), "{projection}: {}", counts.line);
        let found = counts.get("section");
        assert!(found > 2000, "{projection}: {}", counts.line);
    }
}
