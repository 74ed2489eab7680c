//! **Sightline** shows 3D scenes, and what you see is what you pick, to the pixel.
//!
//! A rasteriser draws the scene with Projection * View * Model; a click casts one ray on the CPU through *the same
//! camera* and selects what that pixel shows. [`pick`] defines a pick to the last bit. This page is the map.
//!
//! # A core to build on
//!
//! With `default-features = false` the crate is the picking core: [`geometry`], [`camera`], [`scene`] and [`pick`] (and
//! [`colour`], [`image`], [`look`] for pictures by rays). It needs no GPU and no window. Features add the rest:
//!
//! | feature | adds |
//! |---|---|
//! | `files` | OBJ and scene files, read and written; the demo and the gallery; PNG files |
//! | `render` | drawing by wgpu, and `verify`, which compares drawings with picks |
//! | `study` | ray methods measured against exact arithmetic; brings `files` and `render` |
//! | `window`, on by default | window, command line and the program; brings all of the above |
//! | `screen-readers` | the window's controls for screen readers; brings `window` |
//!
//! The core's types are `Send` and `Sync`, except [`pick::snap::Faces`]. A pick changes nothing: many threads may query
//! one scene at the same time. Impossible input gives a miss (`None`) or an error. Only a caller's mistake panics, as a
//! slice does: an index that names nothing, a hit on another scene, an image of another size. Functions that may do so
//! say it under `Panics`. Vectors and matrices are those of [`glam`], which is re-exported.
//!
//! **Picks in a scene of your own.** The camera takes the numbers that a renderer already has:
//!
//! ```
//! use sightline::{
//!     camera::{Camera, DepthMapping, Lens, Projection, View, Viewport},
//!     geometry::{Placement, Trs},
//!     glam::{DVec2, DVec3},
//!     pick,
//!     scene::{Object, Scene, Shape},
//! };
//!
//! let beside = Trs {
//!     translation: DVec3::new(2.0, 0.0, 0.0),
//!     rotation_deg: DVec3::new(0.0, 30.0, 0.0),
//!     scale: DVec3::ONE,
//! };
//! let scene = Scene::new(vec![
//!     Object::new("ball", Shape::Sphere, Placement::IDENTITY),
//!     Object::new("box", Shape::Cube, Placement::new(beside.to_model())?),
//! ]);
//! let lens = Lens {
//!     projection: Projection::Perspective { fov_y: 45_f64.to_radians() },
//!     near: 0.1,
//!     far: 100.0,
//!     depth: DepthMapping::default(),
//! };
//! let camera = Camera::new(DVec3::new(0.0, 0.0, 5.0), DVec3::ZERO, DVec3::Y, lens)?;
//! let view = View::new(camera, Viewport::new(640, 480)?);
//!
//! let picked = pick::pick(&scene, &view, DVec2::new(320.0, 240.0)).expect("the ball is in the middle");
//! assert_eq!((picked.object.as_str(), picked.depth), ("ball", 4.5));
//! let of_box = camera.project(view.viewport, beside.translation).expect("it lies before the eye");
//! assert_eq!(pick::pick(&scene, &view, of_box.px).map(|picked| picked.id), Some(2));
//! assert!(pick::pick(&scene, &view, DVec2::new(5.0, 5.0)).is_none());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Triangle meshes of your own.** One mesh may stand in many places; vertices are `f32` about an `f64` origin:
//!
//! ```
//! use sightline::{
//!     geometry::{Mesh, MeshData, Placement, Ray, Sides},
//!     glam::{DAffine3, DVec3},
//!     pick,
//!     scene::{Object, Scene, Shape},
//! };
//! use std::sync::Arc;
//!
//! let roof = MeshData {
//!     origin: DVec3::new(3_500_000.0, 0.0, 5_400_000.0), // as maps have them: nothing is lost there
//!     ..MeshData::of_triangles(
//!         "roof",
//!         vec![[0.0, 0.0, 0.0], [0.0, 0.0, 4.0], [4.0, 2.0, 0.0], [4.0, 2.0, 4.0]],
//!         vec![[0, 1, 2], [2, 1, 3]],
//!     )
//! };
//! let middle = roof.origin + DVec3::new(2.0, 0.0, 2.0);
//! let mesh = Arc::new(Mesh::new(roof)?);
//! let houses = (0..100).map(|i| {
//!     let model = DAffine3::from_translation(10.0 * f64::from(i) * DVec3::X);
//!     let shape = Shape::Mesh { mesh: Arc::clone(&mesh), part: 0 };
//!     Ok(Object::new(format!("house {i}"), shape, Placement::new(model)?))
//! });
//! let scene: Scene = houses.collect::<Result<_, sightline::geometry::PlacementError>>()?;
//!
//! let down = Ray {
//!     origin: middle + DVec3::new(420.0, 50.0, 0.0),
//!     direction: DVec3::NEG_Y,
//!     t_min: 0.0,
//!     t_max: f64::INFINITY,
//! };
//! let hit = pick::closest(&scene, down, Sides::Front).expect("a roof is below");
//! assert_eq!(scene.objects()[hit.object].name, "house 42");
//! assert_eq!(hit.hit.t, 49.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Many rays.** Build the trees first, then pick on all threads; [`pick::ids`] does so for a whole picture:
//!
//! ```
//! use sightline::{
//!     geometry::{Mesh, MeshData, Placement, Ray, Sides},
//!     glam::DVec3,
//!     pick,
//!     scene::{Object, Scene, Shape},
//! };
//! use std::{sync::Arc, thread};
//!
//! let side = 100_u16; // a hilly field of 20,000 triangles
//! let at = |i: u16| f32::from(i) / f32::from(side);
//! let height = |x: f32, z: f32| 0.1 * (9.0 * x).sin() * (7.0 * z).cos();
//! let point = |i, j| [at(i), height(at(i), at(j)), at(j)];
//! let positions = (0..=side).flat_map(|j| (0..=side).map(move |i| point(i, j)));
//! let width = u32::from(side) + 1;
//! let cells = (0..width - 1).flat_map(|j| (0..width - 1).map(move |i| j * width + i));
//! let triangles = cells.flat_map(|a| [[a, a + width, a + 1], [a + 1, a + width, a + width + 1]]);
//! let data = MeshData::of_triangles("field", positions.collect(), triangles.collect());
//! let shape = Shape::Mesh { mesh: Arc::new(Mesh::new(data)?), part: 0 };
//! let scene = Scene::new(vec![Object::new("field", shape, Placement::IDENTITY)]);
//! scene.build_trees();
//!
//! let depth = |i: u32| {
//!     let origin = DVec3::new(f64::from(i % 97) / 97.0, 1.0, f64::from(i % 89) / 89.0);
//!     let down = Ray { origin, direction: DVec3::NEG_Y, t_min: 0.0, t_max: 10.0 };
//!     pick::closest(&scene, down, Sides::Both).map(|hit| hit.hit.t)
//! };
//! let depths: Vec<_> = thread::scope(|threads| {
//!     let quarters = (0..4).map(|n| threads.spawn(move || (n..8000).step_by(4).filter_map(depth).count()));
//!     let quarters: Vec<_> = quarters.collect();
//!     quarters.into_iter().map(|quarter| quarter.join().expect("no panic")).collect()
//! });
//! assert_eq!(depths, [2000; 4]); // not one slips through between two triangles
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What flows where
//!
//! ```text
//! a file:   path -> scene::load -> Scene -> render::SceneBuffers -> picture
//! a save:   State -> viewer::jobs::save -> scene::save -> scene file, meshes beside it
//! a click:  event -> viewer::ui -> Action -> viewer::model::State -> pick::pick_all -> Pick -> panel, JSON;
//!           in the view of the picture that is shown: viewer/model/seeing.rs; in one of the four views, on the
//!           camera's ray through the point there: viewer/model/pane_mouse.rs
//! a frame:  viewer::app -> State -> View -> render::Renderer -> colour, ids, selection -> window, picture
//! a pixel:  View::ray -> WorldRay -> Scene::visit_batches -> Placement::local_ray -> PlacedRay, LocalRay -> shape or Mesh (Bvh)
//!           -> Hit -> Pick; what f64 leaves open: WorldRay, Placement -> geometry::exact -> Hit
//! a picture by rays: View::rays -> pick::Beam, one a tile -> as a pixel's, from the batches and tree nodes that the tile may meet
//! a check:  Scene, View -> render::render, pick::ids -> verify::compare -> Report -> text, JSON, picture
//!           Scene, View, pixel -> pick::all -> verify::Places -> pick::InOnePlace -> panel, JSON; a check's tint
//! ```
//!
//! Imports point one way: `geometry` <- `camera` <- `scene` <- `pick`, `render` <- `verify`, `study` <- `viewer` <-
//! `cli`; modules of one step do not import each other. Only `render` and `viewer` know wgpu; only `viewer` knows winit
//! and egui. The core (above) uses nothing of the other modules, and `scene` nothing of `scene/files`. `colour`,
//! `image`, `plain` (names on one line), `json`, `look` (light, and what each colour means) and `replace` (writes a file
//! whole or not at all) stand beside these and import none of them, except that an image has a `camera::Viewport` and may
//! stand on a `look::Background`. `tests/imports` checks all of this.
//!
//! # Where to look
//!
//! Folders and files are named for what they hold. These places are hard to guess:
//!
//! | what | where |
//! |---|---|
//! | whether a hit lies between near and far | `geometry/interval.rs`, exactly `geometry/exact` |
//! | which of two hits comes first, ties included | `pick/order.rs` |
//! | which of two touching surfaces is drawn | `render/draw_order.rs` |
//! | how far `f32` moves what is drawn | `render/transform.rs`, `render/sphere.rs`; in pixels `verify/projection.rs`, `verify/polygon.rs`, `verify/sphere.rs` |
//! | a camera from flags or from a scene file | `camera/choice.rs` |
//! | work on all cores | `geometry/shares.rs` |
//! | a scene without most of its triangles, for one pick | `scene/narrowed.rs`, `pick/narrowed.rs` |
//! | how fine a picture is, and whether rays find it | `viewer/screen/scene_picture.rs` |
//! | what can be asked for, with its key, hint and place in the menus | `viewer/ui/menus.rs` |
//! | whether back faces are hit and drawn | `Sides` in `geometry/hit.rs` |
//! | which class `verify` gives a pixel | `verify/surface.rs`, by the bounds in `verify/bound.rs` |
//! | what a section cuts from a pick | `geometry/section.rs`; the hits it keeps `pick/order.rs` |
//! | a camera that is pasted | `viewer/app/commands.rs` |
//! | a picture without a background | `image/matte.rs` |
//! | when edges become smooth | `viewer/screen/scene_picture.rs`, at rest `viewer/app/rest.rs` |
//! | the window's title and its dot | `viewer/app/program.rs` |
//! | files that are dropped on the window | `viewer/app/frame.rs`, then `viewer/app/files.rs` |
//!
//! # Spaces
//!
//! | space | axes | where |
//! |---|---|---|
//! | object | the shape's own: sphere radius 0.5, cube and square side 1, about the origin; a mesh's file coordinates | [`scene::Shape`], [`geometry::Mesh`], [`geometry::LocalRay`] |
//! | world | right-handed | [`scene::Scene`], [`geometry::WorldRay`] |
//! | view | x = R right, y = U up, z = F forward: left-handed, det(View) = -1 | [`camera::Camera::view`] |
//! | clip, NDC | x, y in \[-1, 1\], y up; z in \[0, 1\], by default reversed: near is 1 | [`camera::Camera::projection`] |
//! | pixel | physical pixels from the top left corner, y down; pixel (i, j) has its centre at (i + 0.5, j + 0.5) | [`camera::Viewport`] |
//!
//! Coordinates on the CPU are `f64`. Vertices are `f32` about one `f64` origin per file. A mesh's tree tests in `f32`,
//! and only rejects. Matrices for the GPU are composed in `f64` (in double-double where `f64` is too coarse) about a
//! point near what the camera looks at, so large coordinates and close views stay sharp.
//!
//! # Words
//!
//! * **in one place**: surfaces are in one place where they lie closer together than drawing can resolve
//!   ([`verify::Places`]).
//! * **placement**: an object's model matrix and its inverse.
//! * **view**: camera, viewport, whether back faces show, and the section: with the scene, they decide what a pixel
//!   shows ([`camera::View`]). *View space* is the camera's.
//! * **stored numbers**: those of camera, placements and vertices, which picks take as exact ([`pick`]).
//! * **t**: the ray parameter; rays keep it when they change spaces. The direction of a pixel's ray is not normalised,
//!   so its t is view depth. **distance** is from the eye; **depth** is along F; **buffer depth** is from the plane
//!   where the depth buffer stores 0: far if reversed, near if standard ([`render::view_units::depth_origin`]).
//! * **near, far**: planes at a *depth*. They clip the picture and, as `t_min` and `t_max`, the ray.
//! * **section**: a plane that cuts the world. What lies behind it is neither drawn nor hit ([`geometry::Section`]). It
//!   bounds the ray exactly, as near and far do.
//! * **bound**: the most by which a rounded number may differ from the exact one. Rays carry theirs
//!   ([`geometry::RayError`]). **In doubt**: said of a decision that a bound leaves open; exact arithmetic makes it.
//!   **Filter**: a cheap test that may decide before the exact one.
//! * **part**: one object of a file; its triangles are a range of the file's mesh.
//! * **batch**: objects that are drawn and tested for hits together: parts of one mesh under one placement, or a single
//!   object.
//! * **front**: the ray runs against the outward normal. Normals are never flipped.
//! * **pivot**: the world point that the mouse turns the view about; in `render`, the point that is subtracted from
//!   vertices or pixels before they become `f32`.
//! * **at rest**: the window's picture when nothing has moved for a moment; its edges are then smooth. Until then it is
//!   *rough*. Ids are the same in both. *Coarse*: a moving picture whose rays stand for nine pixels each, on a software
//!   adapter.
//! * **stage**: one of the spaces along M, V, P: object, world, view, NDC (`viewer::model::Stage`). Each of the *four
//!   views* shows one stage, seen by its own *observer*. The *picture* is the camera's and none of these four.
//! * **followed**: the point that is shown at every stage. It is the pick's, or the one under the cursor.
//! * **step**: one part of a pick, for which the study compares methods ([`study::step`]). Elsewhere it is named in
//!   full: a step of the tour, of undo (`viewer::model::State::next_step`).
//! * **exhibit**: a scene of the failure gallery ([`scene::gallery::Exhibit`]).
//!
//! # To add
//!
//! **A shape.** Give it a file in `geometry` with its box and its hits with a [`geometry::LocalRay`]: a filter in `f64`
//! with error bounds. `geometry/exact` decides what the filter leaves open. Test it against a closed form in
//! `tests/shapes` and against the oracle in `tests/exact_picks`. Add the variant to [`scene::Shape`] and its word to
//! `scene/files/entry.rs`; the compiler then names every place that needs a case for it: its bounds, hits, edges, how
//! it is drawn, what its outline explains in `verify`, the study's truth. Name the word in README's scene file and in
//! [`scene::description`], and what counts as a hit on it in [`pick`] and in `pick --help`. A shape of flat faces is
//! drawn by its faces, as the cube is ([`geometry::Cuboid::face`]); a curved one needs an impostor, as in
//! [`render::sphere`]. Put one into `tests/common/scenes.rs`: then every pixel of it is compared.
//!
//! **A ray method.** Write it as one function, generic over [`study::real::Real`], in its step's file under
//! [`study::methods`], and give it a line in that step's list with its author or paper. Tests, table, charts and the
//! gallery's menu read the list.
//!
//! **An overlay.** Add a variant to `viewer::model::Overlay` and to its list of all, an item to the table in
//! `viewer/ui/menus.rs`, and its lines in world space to `viewer/screen/overlay_lines.rs`. Nearer surfaces hide lines.
//!
//! **A command.** A file in `cli` with its arguments and `run`, a variant of `cli::Command` and a row in README's
//! table, without which `tests/readme.rs` fails. Results go to stdout; everything else goes through `log` or is an
//! error of one line.

// Without the upper modules, what only they use is dead code.
#![cfg_attr(not(feature = "window"), allow(dead_code, unused_imports))]

pub mod camera;
#[cfg(feature = "window")]
#[doc(hidden)] // the program: public for its binary, tests and benches
pub mod cli;
pub mod colour;
pub mod geometry;
pub mod image;
#[cfg(feature = "window")]
mod json;
pub mod look;
pub mod pick;
#[cfg(feature = "files")]
mod plain;
#[cfg(feature = "render")]
pub mod render;
#[cfg(feature = "files")]
mod replace;
pub mod scene;
#[cfg(feature = "study")]
pub mod study;
#[cfg(feature = "render")]
pub mod verify;
#[cfg(feature = "window")]
#[doc(hidden)] // the program: public for tests and benches
pub mod viewer;

pub use glam;
