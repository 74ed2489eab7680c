//! **Sightline** shows 3D scenes, and what you see is what you pick, to the pixel.
//!
//! A rasteriser draws the scene with Projection * View * Model; a click casts one ray on the CPU through *the same
//! camera* and selects what that pixel shows. This page is the map.
//!
//! # What flows where
//!
//! ```text
//! a file:   path -> scene::load -> Scene -> render::SceneBuffers -> picture
//! a click:  event -> viewer::input -> Action -> viewer::State -> pick::pick -> Pick -> panel, JSON
//! a frame:  State -> View -> render::Renderer -> colour, ids, selection -> window
//! a pixel:  View::ray -> Scene::visit_batches -> Placement::ray_to_object -> shape or Mesh (Bvh) -> Hit -> Pick
//! a check:  Scene, View -> render::render, pick::ids -> verify::compare -> Report -> text, JSON, picture
//! ```
//!
//! Imports point one way: `camera`, `geometry` <- `scene` <- `pick`, `render` <- `verify`, `study` <- `viewer` <-
//! `cli`. Only `render` and `viewer` know wgpu; only `viewer` knows winit and egui. `colour`, `image` and `look` (what
//! both renderers make pictures look like) stand beside them and know none of these.
//!
//! # Spaces
//!
//! | space | axes | where |
//! |---|---|---|
//! | object | the shape's own: sphere radius 0.5, cube and square side 1, about the origin; a mesh's file coordinates | [`scene::Shape`], [`geometry::Mesh`] |
//! | world | right-handed | [`scene::Scene`], [`geometry::Ray`] |
//! | view | x = R right, y = U up, z = F forward: left-handed, det(View) = -1 | [`camera::Camera::view`] |
//! | clip, NDC | x, y in \[-1, 1\], y up; z in \[0, 1\], by default reversed: near is 1 | [`camera::Camera::projection`] |
//! | pixel | physical pixels from the top left corner, y down; pixel (i, j) has its centre at (i + 0.5, j + 0.5) | [`camera::Viewport`] |
//!
//! Everything on the CPU is `f64`; vertices are `f32` about one `f64` origin a file. The GPU gets matrices that were
//! composed in `f64` about a point near what the camera looks at, so that large coordinates and close views stay sharp.
//!
//! # Words
//!
//! * **placement**: an object's model matrix and its inverse.
//! * **view**: camera, viewport and whether back faces show: all that decides, with the scene, what a pixel shows.
//! * **t**: the ray parameter; rays keep it when they change spaces. **distance** is from the eye; **depth** is along F.
//! * **near, far**: planes at a *depth*. They clip the picture and, as `t_min` and `t_max`, the ray.
//! * **part**: one object of a file; its triangles are a range of the file's mesh.
//! * **front**: the ray runs against the outward normal. Normals are never flipped.

pub mod camera;
pub mod cli;
pub mod colour;
pub mod geometry;
pub mod image;
pub mod look;
pub mod pick;
pub mod render;
pub mod scene;
pub mod study;
pub mod verify;
pub mod viewer;
