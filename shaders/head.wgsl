// Shared by all passes that draw the scene. Structs equal those of src/render/shader_structs.rs.

struct Frame {
    ndc_per_view: vec2<f32>,
    viewport_px: vec2<f32>,
    clip_per_depth: f32,
    perspective: u32,
    front_only: u32,
    section_corner_slack: f32,
    key_direction: vec3<f32>,
    near_start: f32,
    fill_direction: vec3<f32>,
    near_per_q: f32,
    key: vec3<f32>,
    section_start: f32,
    fill: vec3<f32>,
    section_per_q: f32,
    sky: vec3<f32>,
    section_slack: f32,
    ground: vec3<f32>,
    q_is_depth: u32,
    inside: vec3<f32>,
    shows_inside: u32,
    background_top: vec3<f32>,
    line_half_px: f32,
    background_bottom: vec3<f32>,
    padding_bottom: u32,
    section_per_px: vec2<f32>,
    near_per_px: vec2<f32>,
    ndc_clip: mat4x4<f32>,
    ndc_normal: mat4x4<f32>,
}

struct ObjectState {
    colour: vec3<f32>,
    has_colour: u32,
    first_triangle: u32,
    visible: u32,
    padding: vec2<u32>,
}

@group(0) @binding(0) var<uniform> frame: Frame;
@group(0) @binding(1) var<storage, read> objects: array<ObjectState>;

// Clip-space position. `view` holds x, y and buffer depth.
fn project(view: vec3<f32>, view_depth: f32) -> vec4<f32> {
    let w = select(1.0, view_depth, frame.perspective == 1u);
    return vec4<f32>(view.xy * frame.ndc_per_view, frame.clip_per_depth * view.z, w);
}

// The unit vector along v; 0 for 0.
fn unit(v: vec3<f32>) -> vec3<f32> {
    let size = length(v);
    return select(vec3<f32>(0.0), v / size, size > 0.0);
}

// The same as look::shade: key, fill, sky and ground about the camera, for the normal of the seen side.
fn shade(albedo: vec3<f32>, normal_view: vec3<f32>) -> vec3<f32> {
    let normal = unit(normal_view);
    let facing = max(-normal.z, 0.0);
    let key = max(dot(normal, frame.key_direction), 0.0);
    let fill = max(dot(normal, frame.fill_direction), 0.0);
    let around = mix(frame.ground, frame.sky, 0.5 + 0.5 * normal.y);
    return albedo * (facing * (frame.key * (key * key) + frame.fill * fill) + around);
}

struct ColourAndId {
    @location(0) colour: vec4<f32>,
    @location(1) id: vec2<u32>,
}

// Whether the section keeps a fragment. In perspective q = 1 / clip w, which WGSL gives as position.w; else, and in
// NDC, it is the stored depth. `slack` is for what moves q.
fn kept(px: vec2<f32>, q: f32, slack: f32) -> bool {
    let at = px - 0.5 * frame.viewport_px;
    let aside = frame.section_per_px * at;
    let ahead = frame.section_per_q * q;
    let terms = abs(frame.section_start) + abs(aside.x) + abs(aside.y) + abs(ahead);
    return frame.section_start + aside.x + aside.y + ahead >= -(frame.section_slack * terms + slack);
}

// Whether a fragment of NDC lies behind the camera's near plane. Elsewhere, all do.
fn past_near(px: vec2<f32>, q: f32) -> bool {
    return dot(frame.near_per_px, px - 0.5 * frame.viewport_px) + frame.near_start + frame.near_per_q * q >= 0.0;
}

// The q of a fragment.
fn q_of(position: vec4<f32>) -> f32 {
    return select(position.w, position.z, frame.q_is_depth == 1u);
}
