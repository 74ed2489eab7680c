// Draws what has no id: the background and lines. Also writes depths that were computed without drawing.

struct LineVertex {
    @location(0) position: vec4<f32>,
    // Times the opacity, which is the last number.
    @location(1) colour: vec4<f32>,
}

struct Point {
    @builtin(position) clip: vec4<f32>,
    @location(0) colour: vec4<f32>,
}

@vertex
fn line_vertex(in: LineVertex) -> Point {
    return Point(project(in.position.xyz, in.position.w), in.colour);
}

@fragment
fn line_colour(in: Point) -> @location(0) vec4<f32> {
    return in.colour;
}

// Covers the target at the depth that the buffer is cleared to.
@vertex
fn behind(@builtin(vertex_index) corner: u32) -> @builtin(position) vec4<f32> {
    let is_standard = frame.clip_per_depth > 0.0;
    return vec4<f32>(covering(corner), select(0.0, 1.0, is_standard), 1.0);
}

// The same as look::Background::at.
@fragment
fn background_colour(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let down = position.y / frame.viewport_px.y;
    return vec4<f32>(mix(frame.background_top, frame.background_bottom, down), 1.0);
}

// The depth of each pixel, row by row, at the binding that sphere.wgsl uses for its spheres.
@group(0) @binding(2) var<storage, read> depths: array<f32>;

@fragment
fn given_depth(@builtin(position) position: vec4<f32>) -> @builtin(frag_depth) f32 {
    let px = vec2<u32>(position.xy);
    return depths[px.y * u32(frame.viewport_px.x) + px.x];
}
