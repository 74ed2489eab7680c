// Draws the selection's outline, and copies the picture with its marks to a target.

struct Composite {
    origin_px: vec2<f32>,
    selection: u32,
    hover: u32,
    selection_colour: vec3<f32>,
    tint: f32,
    lit: vec2<f32>,
    outline_px: f32,
    coarseness: f32,
}

@group(0) @binding(0) var<uniform> composite: Composite;
@group(0) @binding(1) var picture: texture_2d<f32>;
@group(0) @binding(2) var ids: texture_2d<u32>;
// How much of each pixel is outline; `outline` itself writes it.
@group(0) @binding(3) var outlined: texture_2d<f32>;

fn inside(px: vec2<f32>, by: vec2<f32>) -> f32 {
    // Beyond the picture's border its last pixel continues, so that no outline runs along the border.
    let last = vec2<i32>(textureDimensions(ids)) - 1;
    let at = vec2<i32>(floor(px + composite.outline_px * by));
    let object = textureLoad(ids, clamp(at, vec2<i32>(0), last), 0).r;
    return select(0.0, 1.0, object == composite.selection);
}

// How much of a pixel is outline: most where half of a disc about it shows the selected object. Unrolled, since loops
// are slow on software adapters.
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

// The picture's pixel that is shown at a position of the destination.
fn pixel(position: vec4<f32>) -> vec2<i32> {
    return vec2<i32>((position.xy - composite.origin_px) / composite.coarseness);
}

// Values are copied as they are: neither side converts sRGB.
@fragment
fn copy(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    return textureLoad(picture, pixel(position), 0);
}

// The same as look::luminance.
fn luminance(colour: vec3<f32>) -> f32 {
    return dot(colour, vec3<f32>(0.2126, 0.7152, 0.0722));
}

// A pixel with its marks, without the outline: look::tinted where it is selected, brighter where it is hovered.
fn marked(px: vec2<i32>) -> vec3<f32> {
    let colour = textureLoad(picture, px, 0).rgb;
    let object = textureLoad(ids, px, 0).r;
    let tint = composite.selection_colour * (luminance(colour) / luminance(composite.selection_colour));
    let tinted = mix(colour, tint, select(0.0, composite.tint, object == composite.selection));
    let lit = tinted * (1.0 + composite.lit.x) + composite.lit.y;
    return select(tinted, lit, object == composite.hover);
}

// Drawn over the copy, where the hovered object may be.
@fragment
fn hover(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    return vec4<f32>(marked(pixel(position)), 1.0);
}

// Drawn last, where the selected object may be, with its outline.
@fragment
fn selection(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let px = pixel(position);
    let outline = textureLoad(outlined, px, 0).r;
    return vec4<f32>(mix(marked(px), composite.selection_colour, outline), 1.0);
}
