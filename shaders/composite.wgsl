// The selection's outline, and the picture with its marks on any target.

struct Composite {
    origin_px: vec2<i32>,
    selection: u32,
    hover: u32,
    selection_colour: vec3<f32>,
    selection_tint: f32,
    hover_colour: vec3<f32>,
    hover_tint: f32,
    outline_px: f32,
    padding_0: f32,
    padding_1: f32,
    padding_2: f32,
}

@group(0) @binding(0) var<uniform> composite: Composite;
@group(0) @binding(1) var picture: texture_2d<f32>;
@group(0) @binding(2) var ids: texture_2d<u32>;
// The selected object, seen through everything, when the outline is drawn; then the outline.
@group(0) @binding(3) var marks: texture_2d<f32>;

@vertex
fn vertex(@builtin(vertex_index) corner: u32) -> @builtin(position) vec4<f32> {
    let x = select(-1.0, 3.0, corner == 1u);
    let y = select(-1.0, 3.0, corner == 2u);
    return vec4<f32>(x, y, 0.5, 1.0);
}

fn inside(px: vec2<f32>, by: vec2<f32>) -> f32 {
    // Past the picture's border its last pixel goes on, so that no outline runs along the border.
    let last = vec2<i32>(textureDimensions(marks)) - 1;
    let at = vec2<i32>(floor(px + composite.outline_px * by));
    return textureLoad(marks, clamp(at, vec2<i32>(0), last), 0).r;
}

// How much of a pixel is outline: most where half of a disc about it is inside the object. Unrolled: loops are slow
// on software adapters.
@fragment
fn outline(@builtin(position) position: vec4<f32>) -> @location(0) f32 {
    let px = position.xy;
    var sum = inside(px, vec2<f32>(0.0));
    sum += inside(px, vec2<f32>(1.0, 0.0)) + inside(px, vec2<f32>(-1.0, 0.0));
    sum += inside(px, vec2<f32>(0.0, 1.0)) + inside(px, vec2<f32>(0.0, -1.0));
    sum += inside(px, vec2<f32>(0.7, 0.7)) + inside(px, vec2<f32>(-0.7, 0.7));
    sum += inside(px, vec2<f32>(0.7, -0.7)) + inside(px, vec2<f32>(-0.7, -0.7));
    sum += inside(px, vec2<f32>(0.5, 0.0)) + inside(px, vec2<f32>(-0.5, 0.0));
    sum += inside(px, vec2<f32>(0.0, 0.5)) + inside(px, vec2<f32>(0.0, -0.5));
    let share = sum / 13.0;
    return smoothstep(0.0, 0.35, min(share, 1.0 - share));
}

fn pixel(position: vec4<f32>) -> vec2<i32> {
    return vec2<i32>(position.xy) - composite.origin_px;
}

@fragment
fn copy(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    return textureLoad(picture, pixel(position), 0);
}

// Blended over the copy: tint where the object is in front, outline everywhere.
@fragment
fn selection(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let at = pixel(position);
    let shown = textureLoad(ids, at, 0).r == composite.selection;
    let tint = select(0.0, composite.selection_tint, shown);
    let edge = textureLoad(marks, at, 0).r;
    return vec4<f32>(composite.selection_colour, 1.0 - (1.0 - tint) * (1.0 - edge));
}

@fragment
fn hover(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let shown = textureLoad(ids, pixel(position), 0).r == composite.hover;
    return vec4<f32>(composite.hover_colour, select(0.0, composite.hover_tint, shown));
}
