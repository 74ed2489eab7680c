// A corner of one triangle that covers the target.
fn covering(corner: u32) -> vec2<f32> {
    return vec2<f32>(select(-1.0, 3.0, corner == 1u), select(-1.0, 3.0, corner == 2u));
}

@vertex
fn cover(@builtin(vertex_index) corner: u32) -> @builtin(position) vec4<f32> {
    return vec4<f32>(covering(corner), 0.5, 1.0);
}
