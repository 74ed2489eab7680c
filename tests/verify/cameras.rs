//! Views under every condition of the camera, for the tests of `conditions`.

use crate::common::{self, orthographic, perspective};
use glam::{DVec2, DVec3, dvec3};
use sightline::{
    camera::{Camera, CameraChoice, DepthMapping, Lens, View, Viewport},
    geometry::Sides,
    pick::{self, SceneHit},
    scene::{Scene, Shape},
};

/// Small pictures: there are many.
pub const SIZE: [u32; 2] = [128, 96];

/// The direction from a scene's middle to the eye.
const WAY: DVec3 = dvec3(1.0, 0.8, 1.6);

/// The condition under which some meshes are beyond `f32`.
pub const NARROWEST: &str = "narrowed down to 1e-4 degrees";

/// A view under a named condition. In an ordinary one, few outline pixels may differ.
pub struct Shot {
    pub condition: &'static str,
    pub view: View,
    pub ordinary: bool,
}

impl Shot {
    pub fn new(condition: &'static str, view: View, ordinary: bool) -> Self {
        Self {
            condition,
            view,
            ordinary,
        }
    }
}

/// The measures of a scene by which cameras are placed.
struct Stage {
    /// The view that the program frames.
    base: View,
    center: DVec3,
    /// Half the diagonal of the visible objects' box.
    r: f64,
    /// Something that the framed view shows.
    aim: DVec3,
    /// From the middle towards the framed view's eye.
    way: DVec3,
}

impl Stage {
    fn new(scene: &Scene) -> Self {
        let bounds = scene.visible_bounds();
        let base = framed(scene, CameraChoice::default());
        Self {
            base,
            center: bounds.center(),
            r: bounds.radius(),
            aim: detail(scene, &base),
            way: WAY.normalize(),
        }
    }

    /// A view of what the framed view shows, from this far away.
    fn look_from(&self, distance: f64, lens: Lens) -> View {
        look(self.aim + distance * self.way, self.aim, lens)
    }
}

/// A view with reversed depth and with standard depth, each under its condition.
fn with_both_depths(
    [reversed, standard_depth]: [&'static str; 2],
    view: &View,
    ordinary: bool,
) -> [Shot; 2] {
    [
        Shot::new(reversed, *view, ordinary),
        Shot::new(standard_depth, standard(view), false),
    ]
}

/// Views of a scene under every condition of the camera.
pub fn shots(scene: &Scene) -> Vec<Shot> {
    let stage = Stage::new(scene);
    [
        near_and_far(&stage),
        lenses(scene, &stage),
        orthographic_lenses(&stage),
        cuts(&stage),
        zooms(&stage),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// The framed view, and views with near and far planes far apart.
fn near_and_far(stage: &Stage) -> Vec<Shot> {
    let Stage {
        base, r, center, ..
    } = stage;
    let distance = base.camera.eye().distance(*center);
    let mut shots = vec![
        Shot::new("framed", *base, true),
        Shot::new("framed, standard depth", standard(base), false),
        Shot::new("framed, culled", culled(base), true),
    ];
    for ratio in [1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9] {
        let far = distance + 2.0 * r;
        let view = between(base, far / ratio, far);
        let standard_depth = if ratio < 1e8 {
            "near/far 1e2 to 1e7, standard depth"
        } else {
            "near/far 1e8 and 1e9, standard depth"
        };
        let names = ["near/far 1e2 to 1e9", standard_depth];
        shots.extend(with_both_depths(names, &view, true));
        let near = (distance - r).max(1e-3 * distance);
        shots.push(Shot::new(
            "a distant far plane",
            between(base, near, near * ratio),
            true,
        ));
    }
    shots
}

/// Views with many fields of view, and long lenses aimed at a rim.
fn lenses(scene: &Scene, stage: &Stage) -> Vec<Shot> {
    let Stage { base, r, .. } = *stage;
    let mut shots = Vec::new();
    let rim = rim(scene, &base);
    for fov in [1.0, 1e-2] {
        let eye = base.camera.eye();
        let lens = perspective(fov, 0.3 * r, 10.0 * r);
        shots.push(Shot::new(
            "a long lens at a rim",
            look(eye, rim, lens),
            false,
        ));
    }
    for fov in [0.5, 1.0, 5.0, 20.0, 60.0, 90.0, 120.0] {
        let choice = CameraChoice {
            fov: Some(fov),
            ..CameraChoice::default()
        };
        let view = framed(scene, choice);
        let names = ["fov 0.5 to 120", "fov 0.5 to 120, standard depth"];
        shots.extend(with_both_depths(names, &view, fov >= 1.0));
    }
    for fov in [120.0, 150.0, 170.0, 175.0, 178.0] {
        let lens = perspective(fov, 1e-4 * r, 10.0 * r);
        let distance = 0.35 * r / (0.5 * fov).to_radians().tan();
        let view = stage.look_from(distance, lens);
        shots.push(Shot::new("fov 120 to 178, close", view, fov <= 170.0));
    }
    shots
}

fn orthographic_lenses(stage: &Stage) -> Vec<Shot> {
    let Stage {
        base, center, r, ..
    } = *stage;
    let mut shots = Vec::new();
    for height in [1.4, 0.1, 1e-3] {
        let lens = orthographic(height * r, 0.01 * r, 10.0 * r);
        let view = stage.look_from(3.0 * r, lens);
        let names = ["orthographic", "orthographic, standard depth"];
        shots.extend(with_both_depths(names, &view, height > 1.0));
    }
    for axis in DVec3::AXES {
        let lens = orthographic(1.5 * r, -3.0 * r, 3.0 * r);
        let up = if axis == DVec3::Y { DVec3::Z } else { DVec3::Y };
        let camera = Camera::new(center + axis * r, center, up, lens).expect("a camera");
        let view = View { camera, ..base };
        shots.push(Shot::new(
            "orthographic along an axis, near behind the eye",
            view,
            false,
        ));
    }
    shots
}

/// Near and far planes through visible objects, and the eye in the middle of the scene.
fn cuts(stage: &Stage) -> Vec<Shot> {
    let Stage {
        base,
        center,
        r,
        aim,
        way,
    } = *stage;
    let depth = base.camera.to_view(aim).z;
    let mut shots = Vec::new();
    for (near, far) in [(0.999, 10.0), (0.1, 1.001), (0.9, 1.1), (0.99, 1.01)] {
        let view = between(&base, near * depth, far * depth);
        let names = ["planes that cut", "planes that cut, standard depth"];
        shots.extend(with_both_depths(names, &view, false));
        shots.push(Shot::new("planes that cut, culled", culled(&view), false));
    }
    for towards in [DVec3::X, DVec3::NEG_Y + 0.1 * DVec3::X, way] {
        let lens = perspective(80.0, 1e-4 * r, 10.0 * r);
        let view = look(center + 0.01 * r * way, aim + 0.1 * r * towards, lens);
        shots.push(Shot::new("from the middle", view, false));
    }
    shots
}

/// Views from ever nearer, and through ever narrower lenses.
fn zooms(stage: &Stage) -> Vec<Shot> {
    let r = stage.r;
    let mut shots = Vec::new();
    for zoom in [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6] {
        let lens = perspective(45.0, 0.01 * zoom * r, 10.0 * r);
        let view = stage.look_from(zoom * r, lens);
        shots.push(Shot::new("zoomed in to 1e-6", view, false));
        let fov = (45.0 * zoom).max(1e-4);
        let view = stage.look_from(r, perspective(fov, 0.1 * r, 10.0 * r));
        let narrowed = if fov > 0.01 {
            "narrowed down to 0.01 degrees"
        } else {
            NARROWEST
        };
        shots.push(Shot::new(narrowed, view, false));
        let lens = orthographic(zoom * r, -10.0 * r, 10.0 * r);
        let view = stage.look_from(r, lens);
        shots.push(Shot::new("orthographic, zoomed in to 1e-6", view, false));
    }
    shots
}

/// A few cameras, for scenes that are tested under many model matrices.
pub fn few_shots(scene: &Scene, condition: &'static str, ordinary: bool) -> Vec<Shot> {
    let stage = Stage::new(scene);
    let r = stage.r;
    let close = stage.look_from(0.3 * r, perspective(60.0, 1e-3 * r, 10.0 * r));
    let flat = stage.look_from(r, orthographic(0.7 * r, -9.0 * r, 9.0 * r));
    [stage.base, close, culled(&close), flat]
        .map(|view| Shot::new(condition, view, ordinary))
        .into()
}

pub fn culled(view: &View) -> View {
    View {
        sides: Sides::Front,
        ..*view
    }
}

fn standard(view: &View) -> View {
    with_lens(view, |lens| Lens {
        depth: DepthMapping::Standard,
        ..lens
    })
}

fn between(view: &View, near: f64, far: f64) -> View {
    with_lens(view, |lens| Lens { near, far, ..lens })
}

fn look(eye: DVec3, target: DVec3, lens: Lens) -> View {
    common::view(eye.to_array(), target.to_array(), lens, SIZE)
}

/// The scene framed as the program frames it, with these choices.
fn framed(scene: &Scene, choice: CameraChoice) -> View {
    let viewport = Viewport::new(SIZE[0], SIZE[1]).expect("a viewport");
    View {
        camera: choice
            .resolve(&scene.visible_bounds(), viewport)
            .expect("a camera"),
        viewport,
        sides: Sides::Both,
        section: None,
    }
}

fn with_lens(view: &View, change: impl Fn(Lens) -> Lens) -> View {
    let lens = change(*view.camera.lens());
    View {
        camera: view.camera.with_lens(lens).expect("a lens"),
        ..*view
    }
}

/// A point to zoom in on: a corner of the triangle shown nearest to the picture's middle, or the hit point of a shape
/// without triangles. A corner keeps outlines in view.
fn detail(scene: &Scene, view: &View) -> DVec3 {
    let (px, hit) = shown(scene, view);
    let object = &scene.objects()[hit.object];
    match (&object.shape, hit.hit.on_triangle) {
        (Shape::Mesh { mesh, .. }, Some(at)) => object
            .placement
            .point_to_world(mesh.corners(at.triangle)[0]),
        _ => view.ray(px).at(hit.hit.t),
    }
}

/// A point on the outline of the object shown nearest to the picture's middle, by bisection towards the left border.
fn rim(scene: &Scene, view: &View) -> DVec3 {
    let (px, shown) = shown(scene, view);
    let at = |x: f64| {
        let ray = view.ray(DVec2::new(x, px.y));
        let hit = pick::closest(scene, ray, Sides::Both);
        hit.filter(|hit| hit.object == shown.object)
            .map(|hit| ray.at(hit.hit.t))
    };
    let (mut outside, mut inside) = (0.0, px.x);
    for _ in 0..40 {
        let middle = 0.5 * (outside + inside);
        if at(middle).is_some() {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    at(inside).expect("a hit")
}

/// The place in the picture nearest to its middle that shows something.
fn shown(scene: &Scene, view: &View) -> (DVec2, SceneHit) {
    let middle = DVec2::new(f64::from(SIZE[0]), f64::from(SIZE[1])) / 2.0;
    let mut cells: Vec<DVec2> = (0..SIZE[0] / 2)
        .flat_map(|x| {
            (0..SIZE[1] / 2).map(move |y| DVec2::new(f64::from(x), f64::from(y)) * 2.0 + 0.5)
        })
        .collect();
    cells.sort_by(|a, b| a.distance(middle).total_cmp(&b.distance(middle)));
    let hit = cells
        .into_iter()
        .find_map(|px| Some((px, pick::closest(scene, view.ray(px), Sides::Both)?)));
    hit.expect("something is shown")
}
