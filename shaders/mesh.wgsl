// Triangles: meshes, cubes and squares. Entry points that need triangle numbers are in mesh_by_corner and
// mesh_by_primitive.

// An instance's numbers. They are vertex attributes because software rasterisers load each number of a storage buffer
// by itself.
struct Batch {
    @location(4) pivot_and_view_depth: vec4<f32>,
    @location(5) linear_x: vec3<f32>,
    @location(6) linear_y: vec3<f32>,
    @location(7) linear_z: vec3<f32>,
    @location(8) translation: vec3<f32>,
    @location(9) normal_x: vec3<f32>,
    @location(10) normal_y: vec3<f32>,
    @location(11) normal_z: vec3<f32>,
    // Object of part 0, first triangle, flags.
    @location(12) numbers: vec3<u32>,
}

const NUMBERS_TRIANGLES = 1u;
const MIRRORS = 2u;

struct Vertex {
    @location(0) position: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) part: u32,
    // The last number holds how far apart the edges are: see spacing.
    @location(3) colour: vec4<f32>,
}

struct Corner {
    @invariant @builtin(position) clip: vec4<f32>,
    @location(0) normal_view: vec3<f32>,
    @location(1) albedo: vec3<f32>,
    // Object; the triangle's id minus the primitive index (where there is one); flags. In one vector, because software
    // rasterisers pay for each inter-stage variable.
    @location(2) @interpolate(flat) own: vec3<u32>,
}

// A vertex in view space: x, y, buffer depth and view depth.
fn in_view(in: Vertex, batch: Batch) -> vec4<f32> {
    // Subtracting the pivot first is exact near it, where the digits are needed.
    let linear = mat3x3<f32>(batch.linear_x, batch.linear_y, batch.linear_z);
    let from_pivot = linear * (in.position - batch.pivot_and_view_depth.xyz);
    return vec4<f32>(from_pivot + batch.translation, from_pivot.z + batch.pivot_and_view_depth.w);
}

// A corner of the draw's triangle with this number; 0 where only the fragment shader knows it.
fn corner(in: Vertex, batch: Batch, triangle: u32) -> Corner {
    let object = in.part + batch.numbers.x;
    let state = objects[object];
    var out: Corner;
    let view = in_view(in, batch);
    out.clip = project(view.xyz, view.w);
    if state.visible == 0u {
        // All corners at one point outside the picture: nothing is drawn.
        out.clip = vec4<f32>(2.0, 2.0, 2.0, 1.0);
    }
    out.normal_view = mat3x3<f32>(batch.normal_x, batch.normal_y, batch.normal_z) * in.normal;
    out.albedo = select(in.colour.rgb, state.colour, state.has_colour == 1u);
    let triangle_base = triangle + batch.numbers.y - state.first_triangle + 1u;
    out.own = vec3<u32>(object, triangle_base, batch.numbers.z);
    return out;
}

// The same in the camera's NDC, as an observer sees it there. A normal is that of a plane, n . x + d = 0.
fn corner_in_ndc(in: Vertex, batch: Batch, triangle: u32) -> Corner {
    var out = corner(in, batch, triangle);
    let at = in_view(in, batch).xyw;
    if objects[out.own.x].visible == 1u {
        out.clip = frame.ndc_clip * vec4<f32>(at, 1.0);
    }
    let normal = out.normal_view;
    out.normal_view = (frame.ndc_normal * vec4<f32>(normal, -dot(normal, at))).xyz;
    return out;
}

// What colours alone need. The normal of a mirrored object is negated, so that its sign tells the side.
struct ColourCorner {
    @invariant @builtin(position) clip: vec4<f32>,
    @location(0) normal_view: vec3<f32>,
    @location(1) albedo: vec3<f32>,
}

@vertex
fn colour_vertex(in: Vertex, batch: Batch) -> ColourCorner {
    let all = corner(in, batch, 0u);
    let mirrors = (batch.numbers.z & MIRRORS) != 0u;
    return ColourCorner(all.clip, select(all.normal_view, -all.normal_view, mirrors), all.albedo);
}

// The shaded colour. Where a section cuts, back faces get the colour of a solid's inside.
fn shaded(in: Corner, winding_front: bool, is_cut: bool) -> vec4<f32> {
    let front = winding_front != ((in.own.z & MIRRORS) != 0u);
    let albedo = select(in.albedo, frame.inside, is_cut && !front);
    return vec4<f32>(shade(albedo, select(-in.normal_view, in.normal_view, front)), 1.0);
}

fn id_of(in: Corner, primitive: u32) -> vec2<u32> {
    return vec2<u32>(in.own.x + 1u, select(0u, primitive + in.own.y, (in.own.z & NUMBERS_TRIANGLES) != 0u));
}

@fragment
fn colour(in: ColourCorner, @builtin(front_facing) front: bool) -> @location(0) vec4<f32> {
    return vec4<f32>(shade(in.albedo, select(-in.normal_view, in.normal_view, front)), 1.0);
}

// Edges of triangles are thin, dark on bright faces and light on dark ones. They fade where they are dense, so that the
// faces are seen between them.
const EDGE_ON_BRIGHT = vec3<f32>(0.005, 0.005, 0.008);
const EDGE_ON_DARK = vec3<f32>(0.33, 0.34, 0.37);
// A face whose luminance is below this is dark. There both lines stand out as much.
const DARK_FACE = 0.1;
// An edge of two triangles is drawn by both, and so covers 0.84 of what is behind it.
const MOST_OPAQUE = 0.6;
// Edges this many pixels apart have faded, and have not begun to.
const DENSE_PX = 1.5;
const SPARSE_PX = 14.0;

struct EdgeCorner {
    @invariant @builtin(position) clip: vec4<f32>,
    // As in Corner.
    @location(0) normal_view: vec3<f32>,
    @location(1) albedo: vec3<f32>,
    @location(2) @interpolate(flat) own: vec3<u32>,
    @location(3) opacity: f32,
}

// How far apart the edges about a vertex look, in view units. The vertex holds the upper half of the bits of that length
// in its own space. A model matrix may stretch it by three factors, of which the middle one counts. Seen at a slant,
// edges look closer together.
fn spacing(in: Vertex, batch: Batch, normal_view: vec3<f32>, sight: vec3<f32>) -> f32 {
    let in_vertex_space = bitcast<f32>(u32(round(in.colour.a * 65535.0)) << 16u);
    let scale = vec3<f32>(length(batch.linear_x), length(batch.linear_y), length(batch.linear_z));
    let least_of_two = min(scale.x, scale.y);
    let middle = max(least_of_two, min(max(scale.x, scale.y), scale.z));
    let slant = abs(dot(unit(normal_view), unit(sight)));
    return in_vertex_space * middle * slant;
}

// `beside` is as far from `clip` as edges are from each other, both in clip space.
fn edge_opacity(clip: vec4<f32>, beside: vec4<f32>) -> f32 {
    if clip.w <= 0.0 || beside.w <= 0.0 {
        return MOST_OPAQUE;
    }
    let apart = 0.5 * frame.viewport_px * (beside.xy / beside.w - clip.xy / clip.w);
    return MOST_OPAQUE * smoothstep(DENSE_PX, SPARSE_PX, length(apart));
}

@vertex
fn edge_vertex(in: Vertex, batch: Batch) -> EdgeCorner {
    let all = corner(in, batch, 0u);
    let view = in_view(in, batch);
    let sight = select(vec3<f32>(0.0, 0.0, 1.0), view.xyw, frame.perspective == 1u);
    let aside = spacing(in, batch, all.normal_view, sight);
    let beside = project(view.xyz + vec3<f32>(aside, 0.0, 0.0), view.w);
    return EdgeCorner(all.clip, all.normal_view, all.albedo, all.own, edge_opacity(all.clip, beside));
}

@vertex
fn edge_vertex_in_ndc(in: Vertex, batch: Batch) -> EdgeCorner {
    let all = corner_in_ndc(in, batch, 0u);
    let at = in_view(in, batch).xyw;
    // As the camera sees it, which is what its NDC shows from the front.
    let aside = spacing(in, batch, corner(in, batch, 0u).normal_view, at);
    let beside = frame.ndc_clip * vec4<f32>(at + vec3<f32>(aside, 0.0, 0.0), 1.0);
    return EdgeCorner(all.clip, all.normal_view, all.albedo, all.own, edge_opacity(all.clip, beside));
}

// Times the opacity.
fn edge_colour(in: EdgeCorner, winding_front: bool, is_cut: bool) -> vec4<f32> {
    let face = shaded(Corner(in.clip, in.normal_view, in.albedo, in.own), winding_front, is_cut);
    let is_dark = luminance(face.rgb) < DARK_FACE;
    return vec4<f32>(select(EDGE_ON_BRIGHT, EDGE_ON_DARK, is_dark) * in.opacity, in.opacity);
}

@fragment
fn edge(in: EdgeCorner, @builtin(front_facing) front: bool) -> @location(0) vec4<f32> {
    return edge_colour(in, front, false);
}

// The same entry points for a world that a section cuts, and for NDC, which ends at the near plane.

fn cut(clip: vec4<f32>) {
    let q = q_of(clip);
    if !kept(clip.xy, q, frame.section_corner_slack) || !past_near(clip.xy, q) {
        discard;
    }
}

// At the pixel's centre, so the cut has hard steps. Per sample, lavapipe gives clip.xy at the sample but clip.w at the
// centre, and an NVIDIA H100 lost a face in the plane.
@fragment
fn colour_cut(in: Corner, @builtin(front_facing) front: bool) -> @location(0) vec4<f32> {
    cut(in.clip);
    return shaded(in, front, frame.shows_inside == 1u);
}

@fragment
fn edge_cut(in: EdgeCorner, @builtin(front_facing) front: bool) -> @location(0) vec4<f32> {
    cut(in.clip);
    return edge_colour(in, front, frame.shows_inside == 1u);
}
