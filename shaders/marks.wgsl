// Marks a picture: draws the selection's outline, and what is selected or lit.

struct Marking {
    selection_colour: vec3<f32>,
    tint: f32,
    lit: vec2<f32>,
    // Its id; NONE or SEVERAL.
    selection: u32,
    hover: u32,
    outline_px: f32,
}

@group(0) @binding(0) var<uniform> marking: Marking;
@group(0) @binding(1) var picture: texture_2d<f32>;
@group(0) @binding(2) var ids: texture_2d<u32>;
// How much of each pixel is outline; `outline` itself writes it.
@group(0) @binding(3) var outlined: texture_2d<f32>;
// Where several objects are selected: a bit for each id.
@group(0) @binding(4) var<storage, read> several: array<u32>;

const SEVERAL: u32 = 0xfffffffeu;

fn is_selected(object: u32) -> bool {
    if (marking.selection != SEVERAL) {
        return object == marking.selection;
    }
    let word = object >> 5u;
    return word < arrayLength(&several) && ((several[word] >> (object & 31u)) & 1u) == 1u;
}

fn inside(px: vec2<f32>, by: vec2<f32>) -> f32 {
    // Beyond the picture's border its last pixel continues, so that no outline runs along the border.
    let last = vec2<i32>(textureDimensions(ids)) - 1;
    let at = vec2<i32>(floor(px + marking.outline_px * by));
    let object = textureLoad(ids, clamp(at, vec2<i32>(0), last), 0).r;
    return select(0.0, 1.0, is_selected(object));
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

// A pixel with its marks, without the outline: look::tinted where it is selected, brighter where it is hovered.
fn marked(px: vec2<i32>) -> vec3<f32> {
    let colour = textureLoad(picture, px, 0).rgb;
    let object = textureLoad(ids, px, 0).r;
    let tint = marking.selection_colour * (luminance(colour) / luminance(marking.selection_colour));
    let tinted = mix(colour, tint, select(0.0, marking.tint, is_selected(object)));
    let lit = tinted * (1.0 + marking.lit.x) + marking.lit.y;
    return select(tinted, lit, object == marking.hover);
}

// Drawn over a copy of the picture, where the hovered object may be.
@fragment
fn hover(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    return vec4<f32>(marked(vec2<i32>(position.xy)), 1.0);
}

// Drawn last, where the selected object may be, with its outline.
@fragment
fn selection(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let px = vec2<i32>(position.xy);
    let outline = textureLoad(outlined, px, 0).r;
    return vec4<f32>(mix(marked(px), marking.selection_colour, outline), 1.0);
}
