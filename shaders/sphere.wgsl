// Spheres and ellipsoids as impostors: a rectangle around the outline, and the ray's quadratic solved at each pixel.

struct Quadratic {
    linear: vec3<f32>,
    padding_linear: f32,
    square: vec3<f32>,
    padding_square: f32,
}

struct Sphere {
    rect_px: vec4<f32>,
    pivot_px: vec2<f32>,
    depth: f32,
    depth_per_root: f32,
    a: Quadratic,
    b: Quadratic,
    c: Quadratic,
    discriminant: Quadratic,
    normal: vec3<f32>,
    origin_step: f32,
    normal_per_root: vec3<f32>,
    direction_step: f32,
    normal_right: vec3<f32>,
    object: u32,
    normal_down: vec3<f32>,
    view_depth: f32,
}

@group(0) @binding(2) var<storage, read> spheres: array<Sphere>;

struct Corner {
    @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat) sphere: u32,
}

// A strip of two triangles over the rectangle.
@vertex
fn vertex(@builtin(vertex_index) corner: u32, @builtin(instance_index) sphere: u32) -> Corner {
    let rect = spheres[sphere].rect_px;
    let px = select(rect.xy, rect.zw, vec2<bool>((corner & 1u) != 0u, (corner & 2u) != 0u));
    let down = 2.0 * px / frame.viewport_px - 1.0;
    return Corner(vec4<f32>(down.x, -down.y, 0.5, 1.0), sphere);
}

fn evaluate(q: Quadratic, at: vec2<f32>) -> f32 {
    let square = vec3<f32>(at.x * at.x, at.x * at.y, at.y * at.y);
    return dot(q.linear, vec3<f32>(1.0, at)) + dot(q.square, square);
}

struct Surface {
    // As the depth buffer stores it.
    depth: f32,
    // The normal of the side that is seen.
    normal_view: vec3<f32>,
    front: bool,
}

// Clip z and w of a root.
fn clip(index: u32, s: f32) -> vec2<f32> {
    let ahead = s * spheres[index].depth_per_root;
    let w = select(1.0, spheres[index].view_depth + ahead, frame.perspective == 1u);
    return vec2<f32>(frame.clip_per_depth * (spheres[index].depth + ahead), w);
}

// The near plane belongs to the picture, the far plane does not.
fn in_range(clip: vec2<f32>) -> bool {
    let standard = 0.0 <= clip.x && clip.x < clip.y;
    let reversed = 0.0 < clip.x && clip.x <= clip.y;
    return select(reversed, standard, frame.clip_per_depth > 0.0);
}

// Whether a root with this clip z and w is shown: between near and far, and kept by the section if one cuts.
fn shows(px: vec2<f32>, clip: vec2<f32>, is_cut: bool) -> bool {
    let q = select(clip.x, 1.0 / clip.y, frame.perspective == 1u);
    // No corners, so no grid moves it.
    return in_range(clip) && (!is_cut || kept(px, q, 0.0));
}

// The first surface that is shown at a pixel position; discards the fragment where there is none.
fn surface(index: u32, px: vec2<f32>, is_cut: bool) -> Surface {
    let sphere = &spheres[index];
    let at = px - (*sphere).pivot_px;
    let discriminant = evaluate((*sphere).discriminant, at);
    let b = evaluate((*sphere).b, at);
    // Roots by the sum that does not cancel (Press et al., Numerical Recipes 5.6).
    let root = sqrt(max(discriminant, 0.0));
    let q = b + select(-root, root, b >= 0.0);
    let r1 = evaluate((*sphere).c, at) / q;
    let r2 = q / evaluate((*sphere).a, at);
    let entry = min(r1, r2);
    let exit = max(r1, r2);
    let enters = shows(px, clip(index, entry), is_cut);
    let s = select(exit, entry, enters);
    let shown = clip(index, s);
    if !(discriminant >= 0.0) || !shows(px, shown, is_cut) || (!enters && frame.front_only == 1u) {
        discard;
    }
    let step = at.x * (*sphere).normal_right + at.y * (*sphere).normal_down;
    let normal = (*sphere).normal + s * (*sphere).normal_per_root
        + ((*sphere).origin_step + s * (*sphere).direction_step) * step;
    return Surface(shown.x / shown.y, select(-normal, normal, enters), enters);
}

struct Colour {
    @location(0) colour: vec4<f32>,
    @builtin(frag_depth) depth: f32,
}

struct ColourIdDepth {
    @location(0) colour: vec4<f32>,
    @location(1) id: vec2<u32>,
    @builtin(frag_depth) depth: f32,
}

struct IdDepth {
    @location(0) id: vec2<u32>,
    @builtin(frag_depth) depth: f32,
}

// The shaded colour. Where a section cuts, the back gets the colour of a solid's inside.
fn shaded(index: u32, seen: Surface, is_cut: bool) -> vec4<f32> {
    let albedo = select(objects[spheres[index].object].colour, frame.inside, is_cut && !seen.front);
    return vec4<f32>(shade(albedo, seen.normal_view), 1.0);
}

fn id_of(index: u32) -> vec2<u32> {
    return vec2<u32>(spheres[index].object + 1u, 0u);
}

// Naming the sample index makes the shader run per sample: the outline is antialiased like that of triangles.
@fragment
fn colour(in: Corner, @builtin(sample_index) sample: u32) -> Colour {
    let seen = surface(in.sphere, in.position.xy, false);
    return Colour(shaded(in.sphere, seen, false), seen.depth);
}

@fragment
fn id(in: Corner) -> IdDepth {
    let seen = surface(in.sphere, in.position.xy, false);
    return IdDepth(id_of(in.sphere), seen.depth);
}

@fragment
fn colour_and_id(in: Corner) -> ColourIdDepth {
    let seen = surface(in.sphere, in.position.xy, false);
    return ColourIdDepth(shaded(in.sphere, seen, false), id_of(in.sphere), seen.depth);
}

// The same entry points for a world that a section cuts.

@fragment
fn colour_cut(in: Corner, @builtin(sample_index) sample: u32) -> Colour {
    let seen = surface(in.sphere, in.position.xy, true);
    return Colour(shaded(in.sphere, seen, true), seen.depth);
}

@fragment
fn id_cut(in: Corner) -> IdDepth {
    let seen = surface(in.sphere, in.position.xy, true);
    return IdDepth(id_of(in.sphere), seen.depth);
}

@fragment
fn colour_and_id_cut(in: Corner) -> ColourIdDepth {
    let seen = surface(in.sphere, in.position.xy, true);
    return ColourIdDepth(shaded(in.sphere, seen, true), id_of(in.sphere), seen.depth);
}
