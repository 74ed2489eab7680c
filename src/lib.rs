//! **Sightline** shows 3D scenes, and what you see is what you pick, to the pixel.
//!
//! A rasteriser draws the scene with Projection * View * Model; a click casts one ray on the CPU through *the same
//! camera* and selects what that pixel shows. What a pick is, to the last bit, stands in [`pick`]. This page is the map.
//!
//! # What flows where
//!
//! ```text
//! a file:   path -> scene::load -> Scene -> render::SceneBuffers -> picture
//! a save:   State -> Snapshot -> scene::save -> scene file, meshes beside it
//! a click:  event -> viewer::ui -> Action -> viewer::model::State -> pick::pick_all -> Pick -> panel, JSON
//! a frame:  viewer::app -> State -> View -> render::Renderer -> colour, ids, selection -> window, picture
//! a pixel:  View::ray -> WorldRay -> Scene::visit_batches -> Placement::local_ray -> PlacedRay, LocalRay -> shape or Mesh (Bvh)
//!           -> Hit -> Pick; what f64 leaves open: WorldRay, Placement -> geometry::exact -> Hit
//! a picture by rays: View::rays -> pick::Beam, one a tile -> as a pixel's, from the batches and tree nodes that the tile may meet
//! a check:  Scene, View -> render::render, pick::ids -> verify::compare -> Report -> text, JSON, picture
//!           Scene, View, pixel -> pick::all -> verify::Places -> pick::InOnePlace -> panel, JSON; a check's tint
//! ```
//!
//! Imports point one way: `geometry` <- `camera` <- `scene` <- `pick`, `render` <- `verify`, `study` <- `viewer` <-
//! `cli`; those of one step do not know each other. Only `render` and `viewer` know wgpu; only `viewer` knows winit and
//! egui. `colour`, `image`, `json`, `look` (light, and what each colour means) and `replace` (files
//! that are written whole or not at all) stand beside them and know none of these, but that an image has a `camera::Viewport`. `tests/imports` holds all of that.
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
//! Everything on the CPU is `f64`; vertices are `f32` about one `f64` origin a file. The GPU gets matrices that were
//! composed in `f64` (in pairs of them where that is too coarse) about a point near what the camera looks at, so that large
//! coordinates and close views stay sharp.
//!
//! # Words
//!
//! * **in one place**: of surfaces, closer together at a position than drawing can tell ([`verify::Places`]).
//! * **placement**: an object's model matrix and its inverse.
//! * **view**: camera, viewport, whether back faces show, and the section: all that decides, with the scene, what a pixel shows
//!   ([`camera::View`]); *view space* is the camera's.
//! * **stored numbers**: those of camera, placements and vertices, which picks take as exact ([`pick`]).
//! * **t**: the ray parameter; rays keep it when they change spaces. The direction of a pixel's ray is not normalised, so
//!   its t is view depth. **distance** is from the eye; **depth** is along F; **measured depth** is what the GPU counts in
//!   place of it, from where it keeps most digits ([`render::transform::depth_origin`]).
//! * **near, far**: planes at a *depth*. They clip the picture and, as `t_min` and `t_max`, the ray.
//! * **section**: a plane that cuts the world: what lies behind it is neither drawn nor hit ([`geometry::Section`]). It bounds
//!   the ray as near and far do, exactly.
//! * **bound**: how far a rounded number may be from the exact one, at most. Rays carry theirs
//!   ([`geometry::RayError`]). **In doubt**: a decision that a bound leaves open, and that exact arithmetic makes.
//! * **part**: one object of a file; its triangles are a range of the file's mesh.
//! * **batch**: objects that are drawn, and asked for hits, as one: parts of one mesh in one place, or a single object.
//! * **front**: the ray runs against the outward normal. Normals are never flipped.
//! * **pivot**: the world point that the mouse turns the view about; in `render`, the point that is subtracted from
//!   vertices or pixels before they become `f32`.
//! * **at rest**: of the window's picture, that nothing has moved in it for a moment: its edges are made smooth. *Rough*:
//!   that they are not yet. Ids are the same in both. *Coarse*: that its pixels are larger than the window's, as those of
//!   a picture that moves are in software.
//! * **stage**: how far along M, V, P something is shown: object, world, view, NDC ([`viewer::model::Stage`]). The *four
//!   views* show them, each seen by an *observer* of its own; what is in none of them is the *picture*, the camera's.
//! * **followed**: of a point, that it is shown at each stage: the pick's, or what is under the cursor.
//! * **step**: what takes a change of the window's state back ([`viewer::model::State::next_step`]).
//! * **exhibit**: a scene of the failure gallery ([`scene::gallery::Exhibit`]).
//!
//! # To add
//!
//! **A shape.** Give it a file in `geometry` with its box and its hits, a [`geometry::LocalRay`] in: a filter in `f64` with
//! bounds, and in `geometry/exact` what decides the rest. Hold it to a closed form in `tests/shapes` and to the oracle in
//! `tests/exact_picks`. Add the variant to [`scene::Shape`] and its word to `scene/entry.rs`; the compiler then
//! names every place that has to know it: its bounds, who asks it for hits, its edges, how it is drawn, what `verify`
//! may put down to its outline, the study's truth. Name the word in README's scene file and in [`scene::description`], and
//! what counts as a hit on it in [`pick`] and in `pick --help`. A shape of flat faces is drawn as those
//! ([`geometry::Cuboid::face`] is how the cube does it); a curved one needs an impostor as [`render::sphere`] is. Put one
//! into `tests/common/scenes.rs`, and every pixel of it is compared.
//!
//! **A ray method.** Write it as one function, generic over [`study::real::Real`], in its step's file under
//! [`study::methods`], and give it a line in that step's list with its author or paper. Tests, table, charts and the
//! gallery's menu read the list.
//!
//! **An overlay.** Add a variant to [`viewer::model::Overlay`] and to its list of all, a key to the table in
//! `viewer/ui/keys.rs` and to README's, and the lines in world space that it stands for to
//! `viewer/screen/overlay_lines.rs`. Lines are hidden by what lies before them.
//!
//! **A command.** A file in [`cli`] with its arguments and `run`, a variant of [`cli::Command`] and a row in README's
//! table, without which `tests/readme.rs` fails. Results go to stdout; everything else is said through `log` or is an
//! error of one line.

pub mod camera;
pub mod cli;
pub mod colour;
pub mod geometry;
pub mod image;
mod json;
pub mod look;
pub mod pick;
pub mod render;
mod replace;
pub mod scene;
pub mod study;
pub mod verify;
pub mod viewer;
