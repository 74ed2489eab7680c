// Draws what has no id: the background and lines. Also writes depths that were computed without drawing.

// x, y, buffer depth and view depth of both ends. Colours are times the opacity, which is their last number.
struct Line {
    @location(0) from_position: vec4<f32>,
    @location(1) from_colour: vec4<f32>,
    @location(2) to_position: vec4<f32>,
    @location(3) to_colour: vec4<f32>,
}

struct Point {
    @builtin(position) clip: vec4<f32>,
    @location(0) colour: vec4<f32>,
}

// What lies this much nearer to the eye than a line's farther end, or behind the eye, is far outside the picture.
const BESIDE_THE_EYE = 1e-6;

fn line_end(position: vec4<f32>, colour: vec4<f32>) -> Point {
    return Point(project(position.xyz, position.w), colour);
}

// The end, or the line's point before the eye that is nearest to it.
fn before_the_eye(end: Point, other: Point) -> Point {
    let least = BESIDE_THE_EYE * other.clip.w;
    if end.clip.w >= least || other.clip.w <= 0.0 {
        return end;
    }
    let share = (other.clip.w - least) / (other.clip.w - end.clip.w);
    return Point(mix(other.clip, end.clip, share), mix(other.colour, end.colour, share));
}

// A corner of the strip of two triangles that is as wide in the picture as the line. The first two are at one end.
@vertex
fn line_vertex(in: Line, @builtin(vertex_index) corner: u32) -> Point {
    let first = line_end(in.from_position, in.from_colour);
    let last = line_end(in.to_position, in.to_colour);
    var ends = array(before_the_eye(first, last), before_the_eye(last, first));
    let along = ends[1].clip.xy / ends[1].clip.w - ends[0].clip.xy / ends[0].clip.w;
    let along_px = unit(vec3<f32>(along * frame.viewport_px, 0.0));
    let side = select(frame.line_half_px, -frame.line_half_px, corner % 2u == 0u);
    let beside = 2.0 * side * vec2<f32>(-along_px.y, along_px.x) / frame.viewport_px;
    var out = ends[corner / 2u];
    out.clip = vec4<f32>(out.clip.xy + beside * out.clip.w, out.clip.zw);
    return out;
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
