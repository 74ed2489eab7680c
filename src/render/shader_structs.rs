//! Lays out what the shaders read. Each struct has the numbers of the struct with the same name in `shaders/`, in the
//! same order, and tests compare most of them. Floating-point numbers are `f32`; `padding` keeps WGSL's alignment.

use bytemuck::{Pod, Zeroable};

/// What all of a frame shares: projection, light, background, section, and the camera whose NDC is drawn, if any.
///
/// Lengths of view space are in *view units* ([`super::view_units::view_unit`]). Depth is two numbers, each precise
/// where the other is not: *view depth*, from the eye, and *buffer depth*, from the plane where the depth buffer
/// stores 0. Buffer depth makes clip z a single product.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct Frame {
    /// NDC per view unit at view depth 1 (perspective) or anywhere (orthographic).
    pub ndc_per_view: [f32; 2],
    /// Size of the picture in pixels.
    pub viewport_px: [f32; 2],
    /// Clip z per buffer depth: above 0 in standard, below in reversed mapping.
    pub clip_per_depth: f32,
    /// 1 in perspective, 0 in orthographic projection.
    pub perspective: u32,
    /// 1 when only front sides show.
    pub front_only: u32,
    /// The section's slack for triangles, whose corners the rasteriser moves to its grid: in units of the test's value.
    pub section_corner_slack: f32,
    /// Towards the key light, in view space.
    pub key_direction: [f32; 3],
    /// See `near_per_px`.
    pub near_start: f32,
    /// Towards the fill light, in view space.
    pub fill_direction: [f32; 3],
    /// See `near_per_px`.
    pub near_per_q: f32,
    /// Linear light from the key light.
    pub key: [f32; 3],
    /// The section test's value in the picture's middle, for q = 0.
    pub section_start: f32,
    /// Linear light from the fill light.
    pub fill: [f32; 3],
    /// How the section test's value changes per unit of q: the fragment's w in perspective, the stored depth in
    /// orthographic projection.
    pub section_per_q: f32,
    /// Linear light on what faces up.
    pub sky: [f32; 3],
    /// The section test's slack, relative to its terms: how far beyond the plane fragments are still drawn.
    pub section_slack: f32,
    /// Linear light on what faces down.
    pub ground: [f32; 3],
    /// 1 where q is the stored depth.
    pub q_is_depth: u32,
    /// Linear colour of back faces where a section opens solids.
    pub inside: [f32; 3],
    /// 1 where back faces that a section or the near plane may open get the colour of a solid's inside.
    pub shows_inside: u32,
    /// Linear colour of the background at the top edge.
    pub background_top: [f32; 3],
    /// Half the width of lines in pixels.
    pub line_half_px: f32,
    /// Linear colour of the background at the bottom edge.
    pub background_bottom: [f32; 3],
    /// Padding.
    pub padding_bottom: u32,
    /// How the value of the section's test changes per pixel right and down.
    pub section_per_px: [f32; 2],
    /// The same numbers as the section's, of the test for what lies behind the near plane of a camera whose NDC is
    /// drawn. Elsewhere the test always holds.
    pub near_per_px: [f32; 2],
    /// Columns of the matrix from that camera's view space to clip space; unused elsewhere.
    pub ndc_clip: [[f32; 4]; 4],
    /// Columns of the matrix from planes in that camera's view space to planes, and so normals, in view space; unused
    /// elsewhere.
    pub ndc_normal: [[f32; 4]; 4],
}

/// One model matrix under this frame's view, for the triangles of a batch: attributes of an instance.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct Batch {
    /// Vertex-space point near what the camera sees of the batch. It is subtracted first, which is exact near it.
    pub pivot: [f32; 3],
    /// View depth of the pivot, in view units.
    pub view_depth: f32,
    /// Columns of the linear part from vertex to view space.
    pub linear: [[f32; 3]; 3],
    /// View-space position of the pivot, its z as buffer depth; in view units.
    pub translation: [f32; 3],
    /// Columns of the matrix from object to view normals, of any scale.
    pub normal: [[f32; 3]; 3],
    /// Index of the object that shows the mesh's part 0, or would show it if the batch began there; wraps below 0.
    pub object_of_part_0: u32,
    /// The mesh's triangle that the draw begins with.
    pub first_triangle: u32,
    /// [`Batch::NUMBERS_TRIANGLES`] and [`Batch::MIRRORS`].
    pub flags: u32,
}

impl Batch {
    /// Flag: ids name triangles.
    pub const NUMBERS_TRIANGLES: u32 = 1;
    /// Flag: the model matrix turns counter-clockwise into clockwise.
    pub const MIRRORS: u32 = 2;
}

/// What an object looks like, apart from where it stands.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct ObjectState {
    /// Linear colour; counts when `has_colour` is 1.
    pub colour: [f32; 3],
    /// 1 when the object's colour replaces that of its vertices.
    pub has_colour: u32,
    /// Number of its first triangle in the mesh.
    pub first_triangle: u32,
    /// 0 when hidden.
    pub visible: u32,
    /// Padding.
    pub padding: [u32; 2],
}

/// A vertex of a mesh.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Vertex {
    /// Vertex space.
    pub position: [f32; 3],
    /// Shading normal in object space.
    pub normal: [f32; 3],
    /// Part of the mesh.
    pub part: u32,
    /// Linear colour in 65535ths. The last number is the upper half of the bits of an `f32`: how far apart the edges of
    /// triangles are there, in vertex space.
    pub colour: [u16; 4],
}

/// An end of a line.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct LineEnd {
    /// x, y, buffer depth and view depth, in view units.
    pub position: [f32; 4],
    /// Linear colour, times the opacity.
    pub colour: [f32; 3],
    /// How much of what is behind it is covered.
    pub opacity: f32,
}

/// A polynomial in a pixel offset (x right, y down): `linear . (1, x, y) + square . (x^2, x y, y^2)`.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Quadratic {
    /// Coefficients of 1, x, y.
    pub linear: [f32; 3],
    /// Padding.
    pub padding_linear: f32,
    /// Coefficients of x^2, x y, y^2.
    pub square: [f32; 3],
    /// Padding.
    pub padding_square: f32,
}

/// A sphere under this frame's view: the quadratic equation whose roots are the hits of the ray through each pixel. Its
/// coefficients are polynomials in the pixel's offset from `pivot_px`. A root `s` is counted from a point of the ray
/// near the surface, in object units.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Sphere {
    /// Pixels that may show it: left, top, right, bottom; all equal when none may.
    pub rect_px: [f32; 4],
    /// The pixel centre from which offsets count.
    pub pivot_px: [f32; 2],
    /// Measured depth at `s = 0`, in view units.
    pub depth: f32,
    /// Depth for one unit of `s`, in view units.
    pub depth_per_root: f32,
    /// Direction squared: a of `a s^2 - 2 b s + c = 0`.
    pub a: Quadratic,
    /// Minus origin times direction.
    pub b: Quadratic,
    /// Origin squared less radius squared.
    pub c: Quadratic,
    /// `b^2 - a c`, apart from the others because its zeros are the outline.
    pub discriminant: Quadratic,
    /// View-space normal at offset 0, `s = 0`.
    pub normal: [f32; 3],
    /// How much of a pixel's step the ray's origin takes.
    pub origin_step: f32,
    /// Change of the normal for one unit of `s` at offset 0.
    pub normal_per_root: [f32; 3],
    /// How much of a pixel's step the ray's direction takes.
    pub direction_step: f32,
    /// Change of the view-space normal for a step of one pixel right.
    pub normal_right: [f32; 3],
    /// Index of the object.
    pub object: u32,
    /// Change of the view-space normal for a step of one pixel down.
    pub normal_down: [f32; 3],
    /// View depth at `s = 0`, in view units.
    pub view_depth: f32,
}

/// What marks a picture.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct Marking {
    /// Linear colour of the selection.
    pub selection_colour: [f32; 3],
    /// How much of a selected pixel is tint.
    pub tint: f32,
    /// Extra light on the object under the cursor: a multiple of its colour, and an amount of white.
    pub lit: [f32; 2],
    /// Id of the selected object; `u32::MAX` for none, one less for several.
    pub selection: u32,
    /// Id of the object under the cursor; `u32::MAX` for none.
    pub hover: u32,
    /// Half the outline's width in pixels.
    pub outline_px: f32,
    /// Padding.
    pub padding: [u32; 3],
}
