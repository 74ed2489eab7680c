// Triangles: meshes, cubes and squares. Entry points that need triangle numbers are in mesh_by_corner and
// mesh_by_primitive.

struct Batch {
    pivot: vec3<f32>,
    object_of_part_0: u32,
    linear: mat3x3<f32>,
    translation: vec3<f32>,
    first_triangle: u32,
    normal: mat3x3<f32>,
    flags: u32,
    view_depth: f32,
    padding_0: u32,
    padding_1: u32,
}

const NUMBERS_TRIANGLES = 1u;
const MIRRORS = 2u;

@group(0) @binding(2) var<storage, read> batches: array<Batch>;

struct Vertex {
    @location(0) position: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) part: u32,
    @location(3) colour: vec4<f32>,
}

struct Corner {
    @invariant @builtin(position) clip: vec4<f32>,
    @location(0) normal_view: vec3<f32>,
    @location(1) albedo: vec3<f32>,
    // Object; the triangle's id minus the primitive index (where there is one); flags. In one vector: software
    // rasterisers pay for each that a triangle carries.
    @location(2) @interpolate(flat) own: vec3<u32>,
}

// A corner of the draw's triangle with this number; 0 where only the fragment shader knows it.
fn corner(in: Vertex, instance: u32, triangle: u32) -> Corner {
    let batch = &batches[instance];
    let object = in.part + (*batch).object_of_part_0;
    let state = objects[object];
    var out: Corner;
    // Subtracting the pivot first is exact near it, where the digits are needed.
    let from_pivot = (*batch).linear * (in.position - (*batch).pivot);
    out.clip = project(from_pivot + (*batch).translation, from_pivot.z + (*batch).view_depth);
    if state.visible == 0u {
        // All corners at one point outside the picture: nothing is drawn.
        out.clip = vec4<f32>(2.0, 2.0, 2.0, 1.0);
    }
    out.normal_view = (*batch).normal * in.normal;
    out.albedo = select(in.colour.rgb, state.colour, state.has_colour == 1u);
    let triangle_base = triangle + (*batch).first_triangle - state.first_triangle + 1u;
    out.own = vec3<u32>(object, triangle_base, (*batch).flags);
    return out;
}

// The shaded colour; back faces get that of a solid's inside where a section cuts.
fn lit(in: Corner, winding_front: bool, is_cut: bool) -> vec4<f32> {
    let front = winding_front != ((in.own.z & MIRRORS) != 0u);
    let albedo = select(in.albedo, frame.inside, is_cut && !front);
    return vec4<f32>(shade(albedo, select(-in.normal_view, in.normal_view, front)), 1.0);
}

fn id_of(in: Corner, primitive: u32) -> vec2<u32> {
    return vec2<u32>(in.own.x + 1u, select(0u, primitive + in.own.y, (in.own.z & NUMBERS_TRIANGLES) != 0u));
}

@fragment
fn colour(in: Corner, @builtin(front_facing) front: bool) -> @location(0) vec4<f32> {
    return lit(in, front, false);
}

// Dark, since lines are thin.
const EDGE = vec4<f32>(0.005, 0.005, 0.008, 1.0);

@fragment
fn edge() -> @location(0) vec4<f32> {
    return EDGE;
}

@fragment
fn mask() -> @location(0) f32 {
    return 1.0;
}

// The same where a section cuts the world.

fn cut(in: Corner) {
    if !kept(in.clip.xy, q_of(in.clip)) {
        discard;
    }
}

// Naming the sample index makes the shader run per sample: the cut is antialiased like edges.
@fragment
fn colour_cut(in: Corner, @builtin(front_facing) front: bool, @builtin(sample_index) sample: u32) -> @location(0) vec4<f32> {
    cut(in);
    return lit(in, front, true);
}

@fragment
fn edge_cut(in: Corner) -> @location(0) vec4<f32> {
    cut(in);
    return EDGE;
}

@fragment
fn mask_cut(in: Corner) -> @location(0) f32 {
    cut(in);
    return 1.0;
}
